// `--offset`: what the operator has entered, given on the command line.
#pragma once

#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "io/job/job.h"

namespace proveout {

/// Puts "G55=10,0,-5", "D1=5" in the place of what the job says, in all its clampings or channels; with the
/// name of a clamping, or the number of a channel, before it ("top:G54=0,0,0") in that one. Errors go to
/// `diagnostics`: a name that the control of a clamping does not have, no number, the same offset twice.
void applyOffsets(const std::vector<std::string>& offsets, Job& job, Diagnostics& diagnostics);

}  // namespace proveout
