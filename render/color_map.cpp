#include "render/color_map.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

/// mm; smaller deviations are rounding.
constexpr double kLeastLimit = 1e-4;
constexpr Rgb kInTolerance{0.90F, 0.90F, 0.88F};
constexpr Rgb kNotMeasured{0.45F, 0.45F, 0.45F};
// Each side: colour just outside the tolerance, in the middle, at the limit.
constexpr Rgb kGougeRamp[3] = {{0.60F, 0.78F, 0.93F}, {0.18F, 0.48F, 0.80F}, {0.03F, 0.14F, 0.42F}};
constexpr Rgb kExcessRamp[3] = {{0.98F, 0.73F, 0.58F}, {0.87F, 0.30F, 0.22F}, {0.45F, 0.02F, 0.10F}};

Rgb mix(const Rgb& a, const Rgb& b, float t) {
  return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

Rgb ramp(const Rgb (&colors)[3], double t) {
  const float u = static_cast<float>(std::clamp(t, 0.0, 1.0)) * 2.0F;
  return u < 1.0F ? mix(colors[0], colors[1], u) : mix(colors[1], colors[2], u - 1.0F);
}

}  // namespace

Rgb deviationColor(const DeviationScale& scale, double deviation_mm) {
  if (!std::isfinite(deviation_mm)) return kNotMeasured;
  if (deviation_mm < -scale.gouge) {
    return ramp(kGougeRamp, (-deviation_mm - scale.gouge) / (scale.limit - scale.gouge));
  }
  if (deviation_mm > scale.excess) {
    return ramp(kExcessRamp, (deviation_mm - scale.excess) / (scale.limit - scale.excess));
  }
  return kInTolerance;
}

std::vector<double> deviationTicks(const DeviationScale& scale) {
  return {-scale.limit, -0.5 * scale.limit, -scale.gouge, 0.0, scale.excess, 0.5 * scale.limit, scale.limit};
}

DeviationScale deviationScaleFor(double gouge_tolerance, double excess_tolerance, double max_abs_deviation) {
  const double least = std::max(kLeastLimit, 3.0 * std::max(gouge_tolerance, excess_tolerance));
  const double wanted = std::isfinite(max_abs_deviation) ? std::max(least, max_abs_deviation) : least;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  double limit = 10.0 * decade;
  for (const double step : {5.0, 2.0, 1.0}) {
    if (wanted <= step * decade * (1.0 + 1e-9)) limit = step * decade;
  }
  return {gouge_tolerance, excess_tolerance, limit};
}

}  // namespace proveout
