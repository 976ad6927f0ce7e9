// The clock that programs read.
#pragma once

#include "core/nc/time_stage.h"

namespace proveout::nc {

/// Simulated time of the run so far, in seconds from power-on. What still waits for its final time counts as
/// if the axes came to a stand.
class RunClock {
 public:
  explicit RunClock(const TimeStage& time) : time_(time) {}
  double now_s() const { return time_.elapsed().cycle_s; }
  double cutting_s() const { return time_.elapsed().cutting_s; }  ///< feed motions

 private:
  const TimeStage& time_;
};

}  // namespace proveout::nc
