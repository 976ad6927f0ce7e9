#include "core/nc/services/bell_profile.h"

#include <algorithm>
#include <cmath>

namespace proveout::nc {

void BellProfile::reset() { steps_.clear(); }

void BellProfile::addStep(double duration, double speed, double acceleration) {
  if (!(duration > 0.0)) return;
  Step step{time(), duration, way(), speed, acceleration, 0.0};
  if (!steps_.empty()) step.integral = steps_.back().integralAt(steps_.back().duration);
  steps_.push_back(step);
}

void BellProfile::add(const SpeedElement& e, double from, double to) {
  if (std::isinf(e.acceleration)) return addStep(e.length / e.speed, e.speed, 0.0);
  const double reachable = std::sqrt(0.5 * (from * from + to * to) + e.acceleration * e.length);
  const double top = std::max({std::min(e.speed, reachable), from, to});
  const double ramps = (top * top - 0.5 * (from * from + to * to)) / e.acceleration;
  addStep((top - from) / e.acceleration, from, e.acceleration);
  addStep((e.length - ramps) / top, top, 0.0);
  addStep((top - to) / e.acceleration, top, -e.acceleration);
}

double BellProfile::integral(double time) const {
  if (steps_.empty()) return 0.0;
  const Step& first = steps_.front();
  if (time <= first.begin) return first.integral + (time - first.begin) * first.way;
  const auto next = std::upper_bound(steps_.begin(), steps_.end(), time,
                                     [](double t, const Step& step) { return t < step.begin; });
  const Step& step = *(next - 1);
  const double inside = std::min(time - step.begin, step.duration);
  return step.integralAt(inside) + (time - step.begin - inside) * step.endWay();
}

double BellProfile::arrival(double way, double time) const {
  // The average lags behind the plan by the whole rise at most. 60 halvings leave nothing of it.
  double low = time, high = time + rise_s_;
  for (int k = 0; k < 60 && high - low > 1e-12; ++k) {
    const double middle = 0.5 * (low + high);
    const double mean = (integral(middle) - integral(middle - rise_s_)) / rise_s_;
    (mean < way ? low : high) = middle;
  }
  return high;
}

void BellProfile::forgetBefore(double time) {
  std::size_t gone = 0;
  while (gone + 1 < steps_.size() && steps_[gone].end() < time) ++gone;
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(gone));
}

}  // namespace proveout::nc
