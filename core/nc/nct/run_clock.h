// The clock that programs read.
#pragma once

#include "core/nc/interpreter.h"

namespace proveout::nc {

/// Simulated time of the run so far: what was sent to the sink, in seconds from power-on.
class RunClock {
 public:
  explicit RunClock(const InterpretSummary& summary) : summary_(summary) {}
  double now_s() const { return summary_.cycle_s; }
  double cutting_s() const { return summary_.cutting_s; }  ///< feed motions

 private:
  const InterpretSummary& summary_;
};

}  // namespace proveout::nc
