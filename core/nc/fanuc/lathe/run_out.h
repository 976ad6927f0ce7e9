// Threads that end in a run-out (section 16).
#pragma once

#include "core/nc/fanuc/lathe/lathe_moves.h"

namespace proveout::nc {

/// The end of a thread: `length` mm before it the tool leaves, rising by `slope` of that way.
struct RunOut {
  double length = 0.0, slope = 1.0;
};
/// By the settings thread_chamfer (leads) and thread_chamfer_angle.
RunOut runOutOf(IsoContext& c, double lead);
RunOut runOutOf(IsoContext& c, double lead, double leads);

/// A thread from where the tool is to `end`, with its run-out towards the height `level` (X as a radius),
/// which the tool does not pass.
bool cutThreadTo(LatheMoves& moves, const Vec2& end, double level, double lead, const RunOut& run_out);

}  // namespace proveout::nc
