#include "core/nc/services/surface_speed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace proveout::nc {

double surfaceRpm(double product, double place, const SpindleBounds& bounds) {
  const double distance = std::abs(place);
  return distance * bounds.high <= product ? bounds.high
                                           : std::clamp(product / distance, bounds.low, bounds.high);
}

double meanSurfaceRpm(double product, double from, double to, const SpindleBounds& bounds) {
  // Time per length goes with 1 / rpm, which is linear in the radius between the bounds: the mean over the
  // axis' way, exact on lines, in pieces between the points where a bound begins or the axis crosses 0.
  if (from == to) return surfaceRpm(product, from, bounds);
  std::array<double, 7> cuts{};  // the first is 0
  std::size_t count = 1;
  const double inner = product / bounds.high;
  const double outer = bounds.low > 0.0 ? product / bounds.low : inner;
  const double ahead = to > from ? 1.0 : -1.0;  // the places in the order in which the axis passes them
  for (const double x : {-outer, -inner, 0.0, inner, outer}) {
    const double u = (ahead * x - from) / (to - from);
    if (u > 0.0 && u < 1.0) cuts[count++] = u;
  }
  cuts[count++] = 1.0;
  const auto slowness = [&](double u) { return 1.0 / surfaceRpm(product, from + u * (to - from), bounds); };
  double mean = 0.0;
  for (std::size_t k = 1; k < count; ++k)
    mean += 0.5 * (slowness(cuts[k - 1]) + slowness(cuts[k])) * (cuts[k] - cuts[k - 1]);
  return 1.0 / mean;
}

}  // namespace proveout::nc
