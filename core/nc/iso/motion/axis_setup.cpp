#include "core/nc/iso/motion/axis_setup.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "core/nc/iso/parameters/axis.h"

namespace proveout::nc {
namespace {

std::optional<double> valueOf(const ControlSettings& settings, std::string_view name, int number) {
  if (name.empty()) return std::nullopt;
  const auto found = settings.parameters.find(fmt::format("{}.{}", name, number));
  if (found == settings.parameters.end() || !(found->second > 0.0 && found->second < 128.0))
    return std::nullopt;
  return found->second;
}

/// The axis of that number, X Y Z by their usual numbers included; made if there is none.
AxisSettings& axisOf(ControlSettings& settings, int number) {
  const auto found = std::find_if(settings.axes.begin(), settings.axes.end(),
                                  [&](const AxisSettings& axis) { return axis.number == number; });
  if (found != settings.axes.end()) return *found;
  AxisSettings axis;
  axis.number = number;
  axis.kind = AxisKind::kLinear;
  if (number <= 3) axis.name = std::string(1, static_cast<char>('X' + number - 1));
  settings.axes.push_back(axis);
  return settings.axes.back();
}

}  // namespace

ControlSettings withAxisParameters(const ParameterTable& table, const ControlSettings& settings) {
  ControlSettings out = settings;
  const auto parameter = [&](AxisParam p, int number) {
    return valueOf(settings, table.row(p).name, number);
  };
  for (int number = 1; number <= 32 && !settings.parameters.empty(); ++number) {
    std::string name;
    for (const AxisParam digit : {AxisParam::kName1, AxisParam::kName2, AxisParam::kName3}) {
      if (const auto code = parameter(digit, number)) name += static_cast<char>(*code);
    }
    const auto rotary = parameter(AxisParam::kRotary, number);
    const auto plane = parameter(AxisParam::kPlane, number);
    if (name.empty() && !rotary && !plane) continue;
    AxisSettings& axis = axisOf(out, number);
    if (!name.empty()) axis.name = name;
    if (rotary) axis.kind = AxisKind::kRotary;
    const bool main = axis.name == "X" || axis.name == "Y" || axis.name == "Z";
    const std::string base =
        plane ? std::string(1, static_cast<char>('X' + static_cast<int>(*plane) - 1)) : "";
    // X, Y and Z are the axes of the planes: what else has their number is parallel to them.
    if (plane && !(main && axis.name == base)) axis.parallel = base;
  }
  return out;
}

}  // namespace proveout::nc
