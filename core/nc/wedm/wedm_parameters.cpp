#include "core/nc/wedm/wedm_parameters.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace proveout::nc {

namespace {

constexpr double kHighest = 10'000.0;    ///< mm
constexpr double kGuideDistance = 20.0;  ///< mm, guides from the workpiece

constexpr auto kWedmParameterRows = std::to_array<ParameterInfo>({
    {"T", 20, 0.001, 2000, "mm, thickness of the workpiece"},
    {"ZB", 0, -kHighest, kHighest, "mm, height of the workpiece's bottom above the table"},
    {"ZM", 0, -kHighest, kHighest, "mm, height of the main plane: X Y I J; default ZB"},
    {"ZS", 20, -kHighest, kHighest, "mm, height of the secondary plane: taper, upper shape; default ZB + T"},
    {"ZL", -20, -kHighest, kHighest, "mm, height of the lower guide; default ZB - 20"},
    {"ZU", 40, -kHighest, kHighest, "mm, height of the upper guide; default ZB + T + 20"},
    {"H0", 0, -99999.999, 99999.999, "mm, value of H000 at the start"},
    {"H", 0, -99999.999, 99999.999, "mm, value of Hn at the start", 99},
    {"FEED", 3, 1e-6, 1e6, "mm/min, speed of condition Cn along the path", kWedmConditions},
    {"AREA", 0, 0, 1e6, "mm2/min, speed of condition Cn through the thickness T; 0: FEED counts",
     kWedmConditions},
    {"ABSENT", 0, 0, 1, "1: the machine has no condition Cn", kWedmConditions},
    {"SLOW", 0.5, 0.001, 1, "part of the speed that G34 leaves in the last 3 mm"},
    {"ARC_TOL", 0.01, 0, 1, "mm, allowed difference of the radii at both ends of an arc"},
    {"TAN_TOL", 0.002, 1e-6, 0.1, "mm, ends of offset elements that are nearer than this are joined"},
    {"MAX_TILT", 0, 0, 80, "degrees, largest lean of the wire; 0: 45"},
    {"U_TRAVEL", 0, 0, 1000, "mm, travel of U to each side; 0: no limit"},
    {"V_TRAVEL", 0, 0, 1000, "mm, travel of V to each side; 0: no limit"},
    {"UV_UPPER", 0, 0, 1, "1: U V of G74 are told at the upper guide; 0: in the secondary plane"},
    {"G29_TANGENT", 0, 0, 1, "1: the straight corners of G29 are tangent to the arc of G28"},
    {"TAPER_ARC", 0, 0, 1, "1: outer corners of two lines get an arc in the secondary plane; 0: a point"},
});

}  // namespace

std::vector<ParameterInfo> wedmParameterTable() {
  return {kWedmParameterRows.begin(), kWedmParameterRows.end()};
}

Status WedmParameters::set(const std::map<std::string, double>& given) {
  for (const auto& [name, value] : given) {
    if (Status good = put(name, value); !good.ok()) return good;
  }
  return finish();
}

Status WedmParameters::put(const std::string& name, double value) {
  const std::size_t dot = name.find('.');
  const std::string base = name.substr(0, dot);
  const auto info = std::find_if(kWedmParameterRows.begin(), kWedmParameterRows.end(),
                                 [&](const ParameterInfo& p) { return p.name == base; });
  int number = 0;
  if (dot != std::string::npos) std::from_chars(name.data() + dot + 1, name.data() + name.size(), number);
  if (info == kWedmParameterRows.end() || (dot != std::string::npos && (number < 1 || number > info->count)))
    return inputError(fmt::format("the control has no parameter {}", name));
  if (!(value >= info->min && value <= info->max))
    return inputError(
        fmt::format("parameter {}: {} is out of the range {} to {}", name, value, info->min, info->max));
  // A name alone is for all numbers.
  const std::size_t first = number > 0 ? static_cast<std::size_t>(number) : info->count == 99 ? 1 : 0;
  const auto last = number > 0 ? first : static_cast<std::size_t>(info->count);
  for (std::size_t k = first; k <= last; ++k) {
    if (base == "H") offsets_[k] = value;
    if (base == "FEED") conditions_[k].feed = value;
    if (base == "AREA") conditions_[k].area = value;
    if (base == "ABSENT") conditions_[k].absent = k > 0 && value != 0.0;
  }
  if (base == "H0") offsets_[0] = value;
  if (base == "T") thickness = value, thickness_given = true;
  if (base == "ZB") bottom = value;
  if (base == "ZM") z_main_ = value;
  if (base == "ZS") z_second_ = value;
  if (base == "ZL") z_lower_ = value;
  if (base == "ZU") z_upper_ = value;
  if (base == "SLOW") slow_share = value;
  if (base == "ARC_TOL") arc_tolerance = value;
  if (base == "TAN_TOL") tangent = value;
  if (base == "MAX_TILT") max_tilt_deg = value;
  if (base == "U_TRAVEL") u_travel = value;
  if (base == "V_TRAVEL") v_travel = value;
  if (base == "UV_UPPER") uv_upper = value != 0.0;
  if (base == "G29_TANGENT" && value != 0.0) straight_join = OuterJoin::kTangent;
  if (base == "TAPER_ARC") taper_arcs = value != 0.0;
  return Done{};
}

Status WedmParameters::finish() {
  z_main = z_main_.value_or(bottom);
  z_second = z_second_.value_or(bottom + thickness);
  z_lower = z_lower_.value_or(bottom - kGuideDistance);
  z_upper = z_upper_.value_or(bottom + thickness + kGuideDistance);
  if (z_main == z_second) return inputError("ZM and ZS must differ: give the heights of both planes");
  if (!(z_lower < std::min(z_main, z_second) && z_upper > std::max(z_main, z_second)))
    return inputError(
        fmt::format("the planes ZM = {} and ZS = {} must lie between the guides ZL = {} and ZU = {}", z_main,
                    z_second, z_lower, z_upper));
  return Done{};
}

double WedmParameters::feedOf(int condition) const {
  const Condition& c = conditions_[static_cast<std::size_t>(condition)];
  if (c.absent) return 0.0;
  return c.area > 0.0 ? c.area / thickness : c.feed;
}

}  // namespace proveout::nc
