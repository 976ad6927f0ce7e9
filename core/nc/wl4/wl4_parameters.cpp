#include "core/nc/wl4/wl4_parameters.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace proveout::nc {

namespace {

constexpr auto kParameters = std::to_array<ParameterInfo>({
    {"G18_ZX", 0, 0, 1,
     "1: in G18 clockwise and left are seen with Z to the right and X up; 0: X right, Z up"},
    {"CONDITIONAL", 0, 0, 1, "1: blocks that begin with / are executed"},
    {"DELT_L", 0, 0, 10, "mm; outside corners whose compensated ends are nearer to each other get no arc"},
    {"MAX_FEED", 65000, 0.001, 65000, "mm/min, highest speed along the contour"},
    {"MAX_SPEED", 0, 0, 65535, "1/min, highest speed of the spindle; 0: no limit"},
});
constexpr double kMostShift = 1e5;
constexpr auto kToolParameters = std::to_array<ParameterInfo>({
    {"RT", 0, 0, 100, "mm, nose radius of tool n", Wl4Parameters::kTools},
    {"POINT_S", 0, 0, 1, "1: the working point of tool n is the nose centre; 0: the touch-off point",
     Wl4Parameters::kTools},
    {"TIP", 0, 0, 9,
     "where the touch-off point of tool n lies seen from the nose centre, 1 to 8; 0, 9: on it",
     Wl4Parameters::kTools},
    {"DXW", 0, -kMostShift, kMostShift, "mm of radius, shift of tool n along X", Wl4Parameters::kTools},
    {"DZW", 0, -kMostShift, kMostShift, "mm, shift of tool n along Z", Wl4Parameters::kTools},
});

}  // namespace

std::vector<ParameterInfo> wl4ParameterTable(bool lathe) {
  std::vector<ParameterInfo> table(kParameters.begin(), kParameters.end());
  if (lathe) table.insert(table.end(), kToolParameters.begin(), kToolParameters.end());
  return table;
}

const Wl4Parameters::Tool& Wl4Parameters::tool(int number) const {
  static const Tool kNone;
  const auto found = tools_.find(number);
  return found == tools_.end() ? kNone : found->second;
}

Status Wl4Parameters::set(const std::map<std::string, double>& given, bool lathe) {
  for (const auto& [name, value] : given) {
    const std::size_t dot = name.find('.');
    const std::string base = name.substr(0, dot);
    const auto table = wl4ParameterTable(lathe);
    const auto info =
        std::find_if(table.begin(), table.end(), [&](const ParameterInfo& p) { return p.name == base; });
    int number = 0;
    if (dot != std::string::npos) {
      std::from_chars(name.data() + dot + 1, name.data() + name.size(), number);
    }
    const bool known = info != table.end() &&
                       (info->count > 0 ? number >= 1 && number <= info->count : dot == std::string::npos);
    if (!known) return inputError(fmt::format("the control has no parameter {}", name));
    if (!(value >= info->min && value <= info->max)) {
      return inputError(
          fmt::format("parameter {}: {} is out of the range {} to {}", name, value, info->min, info->max));
    }
    if (base == "G18_ZX") g18_zx = value != 0.0;
    if (base == "CONDITIONAL") conditional = value != 0.0;
    if (base == "DELT_L") arc_threshold = value;
    if (base == "MAX_FEED") max_feed = value;
    if (base == "MAX_SPEED") max_speed = value;
    if (base == "RT") tools_[number].nose_radius = value;
    if (base == "POINT_S") tools_[number].at_center = value != 0.0;
    if (base == "TIP") tools_[number].tip = static_cast<int>(value);
    if (base == "DXW") tools_[number].dx = value;
    if (base == "DZW") tools_[number].dz = value;
  }
  return Done{};
}

}  // namespace proveout::nc
