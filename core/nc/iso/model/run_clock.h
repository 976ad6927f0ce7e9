// The clock that programs read.
#pragma once

#include "core/nc/stages/rapid_overlap_stage.h"
#include "core/nc/stages/time_stage.h"

namespace proveout::nc {

/// Simulated time of the run so far, in seconds from power-on. What still waits for its final time counts as
/// if the axes came to a stand.
class RunClock {
 public:
  RunClock(const TimeStage& time, const RapidOverlapStage& rapids) : time_(time), rapids_(rapids) {}
  double now_s() const { return time_.elapsed().cycle_s + rapids_.waiting_s(); }
  double cutting_s() const { return time_.elapsed().cutting_s; }  ///< feed motions

 private:
  const TimeStage& time_;
  const RapidOverlapStage& rapids_;
};

}  // namespace proveout::nc
