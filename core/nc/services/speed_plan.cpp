#include "core/nc/services/speed_plan.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout::nc {

void planSpeeds(std::span<const SpeedElement> elements, double entry, std::vector<double>& speeds) {
  const std::size_t n = elements.size();
  speeds.resize(n + 1);
  speeds[n] = 0.0;
  for (std::size_t i = n; i-- > 0;) {
    const SpeedElement& e = elements[i];
    const double before = i > 0 ? elements[i - 1].speed : e.speed;
    const double stops = std::sqrt(speeds[i + 1] * speeds[i + 1] + 2.0 * e.acceleration * e.length);
    speeds[i] = std::min({e.entry, before, e.speed, stops});
  }
  if (n == 0) return;
  speeds[0] = entry;
  for (std::size_t i = 0; i < n; ++i) {
    const SpeedElement& e = elements[i];
    speeds[i + 1] =
        std::min(speeds[i + 1], std::sqrt(speeds[i] * speeds[i] + 2.0 * e.acceleration * e.length));
  }
  PROVEOUT_ASSERT_DEAR(std::all_of(speeds.begin(), speeds.end(), [](double speed) { return speed >= 0.0; }));
}

double elementTime(const SpeedElement& e, double from, double to) {
  if (std::isinf(e.acceleration)) return e.length / e.speed;
  const double reachable = std::sqrt(0.5 * (from * from + to * to) + e.acceleration * e.length);
  const double top = std::max({std::min(e.speed, reachable), from, to});
  const double ramps = (top * top - 0.5 * (from * from + to * to)) / e.acceleration;  // their length
  return (2.0 * top - from - to) / e.acceleration + std::max(0.0, e.length - ramps) / top;
}

}  // namespace proveout::nc
