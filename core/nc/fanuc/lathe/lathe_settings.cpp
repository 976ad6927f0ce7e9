#include "core/nc/fanuc/lathe/lathe_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "core/nc/fanuc/parameters/fanuc_parameters.h"

namespace proveout::nc {
namespace {

/// A setting with the code that Haas has for it.
struct LiveCode {
  FanucParam name;
  int SpindleSettings::*place;
  int haas;
  bool of_axis;  ///< of the main spindle as an axis
};
constexpr auto kLiveCodes = std::to_array<LiveCode>({
    {FanucParam::kLiveCw, &SpindleSettings::cw_code, 133, false},
    {FanucParam::kLiveCcw, &SpindleSettings::ccw_code, 134, false},
    {FanucParam::kLiveStop, &SpindleSettings::stop_code, 135, false},
    {FanucParam::kAxisOn, &SpindleSettings::axis_code, 154, true},
    {FanucParam::kAxisOff, &SpindleSettings::speed_code, 155, true},
});

int codeOf(const std::map<std::string, double>& settings, const LiveCode& live) {
  const bool haas = fanucSetting(settings, FanucParam::kFlavour) == kHaasFlavour;
  const bool given = settings.contains(std::string(fanucParameters().row(live.name).name));
  return haas && !given ? live.haas : static_cast<int>(fanucSetting(settings, live.name));
}

bool anyCode(const std::map<std::string, double>& settings, bool of_axis) {
  return std::any_of(kLiveCodes.begin(), kLiveCodes.end(), [&](const LiveCode& live) {
    return live.of_axis == of_axis && codeOf(settings, live) > 0;
  });
}

bool hasAxisC(const ControlSettings& settings) {
  return std::any_of(settings.axes.begin(), settings.axes.end(),
                     [](const AxisSettings& axis) { return axis.name == "C"; });
}

/// The smallest number that no spindle has.
int freeNumber(const std::vector<SpindleSettings>& spindles) {
  int number = 1;
  const auto taken = [&](const SpindleSettings& s) { return s.number == number; };
  while (std::any_of(spindles.begin(), spindles.end(), taken)) ++number;
  return number;
}

}  // namespace

ControlSettings withLatheAxes(const ControlSettings& settings) {
  ControlSettings out = settings;
  if (fanucSetting(settings.parameters, FanucParam::kFlavour) == kHaasFlavour || settings.machine) return out;
  const auto has = [&](const auto& which) {
    return std::any_of(settings.axes.begin(), settings.axes.end(), which);
  };
  const auto named = [](const AxisSettings& axis) {
    return axis.name == "X" || axis.name == "Y" || axis.name == "Z";
  };
  constexpr int kZ = 2, kY = 3;
  if (has(named) || has([](const AxisSettings& axis) { return axis.number == kZ; })) return out;
  int y = kY;
  while (has([&](const AxisSettings& axis) { return axis.number == y; })) ++y;
  const auto number = [&](const char* name, int value) {
    AxisSettings& axis = out.axes.emplace_back();
    axis.name = name;
    axis.number = value;
    axis.kind = AxisKind::kLinear;
  };
  number("Z", kZ);
  number("Y", y);
  return out;
}

ControlSettings withLiveTools(const ControlSettings& settings) {
  ControlSettings out = settings;
  const bool live = anyCode(settings.parameters, false);
  const bool axis = anyCode(settings.parameters, true) && hasAxisC(settings);
  if (!live && !axis) return out;
  if (out.spindles.empty()) out.spindles.emplace_back();
  if (live && out.spindles.size() == 1) {
    out.spindles.emplace_back();
    out.spindles.back().number =
        freeNumber(settings.spindles.empty() ? std::vector<SpindleSettings>(1) : settings.spindles);
  }
  for (const LiveCode& code : kLiveCodes) {
    if (code.of_axis ? !axis : !live) continue;
    out.spindles[code.of_axis ? 0 : 1].*code.place = codeOf(settings.parameters, code);
  }
  if (axis) out.spindles[0].axis = "C";
  if (live)
    out.spindles[1].speed_by_p = fanucSetting(settings.parameters, FanucParam::kFlavour) == kHaasFlavour;
  return out;
}

void checkLiveCodes(IsoContext& c) {
  for (const LiveCode& live : kLiveCodes) {
    const int code = codeOf(c.settings.parameters, live);
    if (code <= 0 || c.codes.m(code) == nullptr) continue;
    c.fail("settings",
           fmt::format("{} = {}: M{} is a code of the control", c.parameters.name(live.name), code, code));
  }
}

void tellLiveTool(IsoContext& c, const BlockPlan& plan) {
  for (int k = 0; k < plan.m_count; ++k) {
    if (plan.m[static_cast<std::size_t>(k)]->started() < 0) continue;
    c.warnOnce(
        "live tool", "live-tool",
        "a live tool turns: its speed, S and feeds are followed; what it cuts off the axis of the part "
        "is taken as if the part turned, and told (axis_crossing)",
        {}, Severity::kNote);
  }
}

}  // namespace proveout::nc
