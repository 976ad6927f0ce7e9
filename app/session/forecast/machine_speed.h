// How fast the machine is on which the program runs.
#pragma once

#include "app/session/forecast/prediction.h"

namespace proveout {

/// The machine as a run finds it.
struct MachineSpeed {
  int threads = 2;        ///< those that TBB may use, and no more than there are cores
  double slowness = 1.0;  ///< time of one thread, over that where the prediction was measured
};

/// Takes some milliseconds, and not much more than a hundredth of the time that the run is expected to take:
/// a small piece of milling is cut on each thread, all at a time.
MachineSpeed measureMachine(double expected_s);

/// What is predicted where the prediction was measured takes this on such a machine: threads share what can
/// be shared.
Prediction predictedOn(const MachineSpeed& machine, const Prediction& predicted);

}  // namespace proveout
