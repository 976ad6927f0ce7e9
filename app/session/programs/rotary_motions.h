// Motions along which a rotary axis turns the tool or the part.
#pragma once

#include "app/session/run/blank.h"
#include "app/session/run/recording_source.h"
#include "core/path/toolpath.h"
#include "io/job/job.h"

namespace proveout {

/// What a turning tool must stay clear of. Null blank: nothing is known of it.
struct Surroundings {
  const Job& job;  ///< of the clamping: tools, fixtures
  const Blank* blank = nullptr;
  std::size_t setup = 0;  ///< in later ones the blank is the box around it
};

/// The engine cuts while the tool's direction stands still; it turns in the air only. False, with an error in
/// the path's diagnostics (posed-motion, rotary-motion): a motion turns it and is not shown to be clear of
/// blank and fixtures; or an axis is not at 0 that the job does not place in the machine.
bool checkRotaryMotions(Toolpath& path, const RecordingSource& source, const Surroundings& around);

}  // namespace proveout
