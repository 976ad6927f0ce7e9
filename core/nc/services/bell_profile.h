// Bell-shaped speed: the plan of constant accelerations, its way averaged over the time in which the
// acceleration comes up. The path stays the same; from stand to stand it takes that much longer. Where the
// axes stand in between, the plan has to stand for that time as well, or the average would go through.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/assert.h"
#include "core/nc/services/speed_plan.h"

namespace proveout::nc {

class BellProfile {
 public:
  /// `rise_s` > 0.
  explicit BellProfile(double rise_s = 1.0) : rise_s_(rise_s) {}

  /// Forgets everything; the axes stand.
  void reset();
  /// The next element of the plan with its speeds at both ends, mm/s.
  void add(const SpeedElement& element, double from, double to);
  /// The axes stand for a while, s.
  void stand(double duration) { addStep(duration, 0.0, 0.0); }
  /// Elements so far; cut() goes back to fewer of them.
  std::size_t size() const { return steps_.size(); }
  void cut(std::size_t size) {
    PROVEOUT_ASSERT(size <= steps_.size());
    steps_.resize(size);
  }
  /// End of what was added so far, in the plan: mm and s.
  double way() const { return steps_.empty() ? 0.0 : steps_.back().endWay(); }
  double time() const { return steps_.empty() ? 0.0 : steps_.back().end(); }
  /// When the averaged way reaches `way`, which the plan reaches at `time`, s. What is behind the last
  /// element counts as a stand.
  double arrival(double way, double time) const;
  /// Drops what no later arrival() needs; times and ways go on counting as before.
  void forgetBefore(double time);

 private:
  /// Constant acceleration.
  struct Step {
    double begin, duration, way, speed, acceleration;
    double integral;  ///< of the way over time, up to the step's begin
    double end() const { return begin + duration; }
    double wayAt(double t) const { return way + t * (speed + 0.5 * acceleration * t); }
    double endWay() const { return wayAt(duration); }
    double integralAt(double t) const {
      return integral + t * (way + t * (0.5 * speed + t * acceleration / 6.0));
    }
  };
  void addStep(double duration, double speed, double acceleration);
  double integral(double time) const;

  double rise_s_;
  std::vector<Step> steps_;
};

}  // namespace proveout::nc
