#include "core/nc/flexnc/flexnc_parameters.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace proveout::nc {

namespace {

constexpr double kMostShift = 1e5;  ///< mm
constexpr int kMany = FlexParameters::kCorrectors;

constexpr auto kFlexParameters = std::to_array<ParameterInfo>({
    {"arc_view", 0, 0, 1, "how the machine draws X where clockwise is told: G02, G03, G12, G13, G3.1", 0,
     "x_down x_up"},
    {"comp_view", 0, 0, 1, "how the machine draws X where left is told, G41: iso X up, x_down X down", 0,
     "iso x_down"},
    {"raw_x", 0, 0, 1, "what X and I outside of templates are", 0, "radius diameter"},
    {"g52_mode", 0, 0, 1, "G52 names the point where the tool stands (preset) or moves the origin", 0,
     "preset shift"},
    {"ring_edge", 0, 0, 1, "edge of the ring groove's tool (G79.2) that is its point", 0, "inner outer"},
    {"MAX_SPEED", 0, 0, 65535, "1/min, highest speed of the spindle; 0: no limit"},
    {"RT", 0, 0, 100, "mm, nose radius of corrector n", kMany},
    {"TIP", 0, 0, 9, "where the touch-off point lies seen from the nose centre, 1 to 8; 0, 9: on it", kMany},
    {"DXW", 0, -kMostShift, kMostShift, "mm of radius, shift of corrector n along X", kMany},
    {"DZW", 0, -kMostShift, kMostShift, "mm, shift of corrector n along Z", kMany},
});

/// Where a parameter's name has its number, or 0.
int numberIn(const std::string& name) {
  const std::size_t dot = name.find('.');
  int number = 0;
  if (dot != std::string::npos) std::from_chars(name.data() + dot + 1, name.data() + name.size(), number);
  return number;
}

}  // namespace

std::vector<ParameterInfo> flexncParameterTable() { return {kFlexParameters.begin(), kFlexParameters.end()}; }

const FlexParameters::Corrector& FlexParameters::corrector(int number) const {
  static const Corrector kNone;
  const auto found = correctors_.find(number);
  return found == correctors_.end() ? kNone : found->second;
}

Status FlexParameters::set(const std::map<std::string, double>& given) {
  for (const auto& [name, value] : given) {
    if (Status good = put(name, value); !good.ok()) return good;
  }
  return Done{};
}

Status FlexParameters::put(const std::string& name, double value) {
  const std::size_t dot = name.find('.');
  const std::string base = name.substr(0, dot);
  const auto* const info = std::find_if(kFlexParameters.begin(), kFlexParameters.end(),
                                        [&](const ParameterInfo& p) { return p.name == base; });
  const int number = numberIn(name);
  const bool known = info != kFlexParameters.end() &&
                     (info->count > 0 ? number >= 1 && number <= info->count : dot == std::string::npos);
  if (!known) return inputError(fmt::format("the control has no parameter {}", name));
  if (!(value >= info->min && value <= info->max))
    return inputError(
        fmt::format("parameter {}: {} is out of the range {} to {}", name, value, info->min, info->max));
  if (base == "arc_view") arcs_seen_x_up = value != 0.0;
  if (base == "comp_view") sides_seen_x_down = value != 0.0;
  if (base == "raw_x") diameters = value != 0.0;
  if (base == "g52_mode") g52_shifts = value != 0.0;
  if (base == "ring_edge") ring_outer_edge = value != 0.0;
  if (base == "MAX_SPEED") max_speed = value;
  if (base == "RT") correctors_[number].nose_radius = value;
  if (base == "TIP") correctors_[number].tip = static_cast<int>(value);
  if (base == "DXW") correctors_[number].dx = value;
  if (base == "DZW") correctors_[number].dz = value;
  return Done{};
}

}  // namespace proveout::nc
