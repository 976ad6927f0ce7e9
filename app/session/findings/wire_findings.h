// What a run with a wire finds beside cuts and contacts: threading, supply, pieces that come free.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"

namespace proveout {

/// - Places where the wire cannot be threaded (kThreading).
/// - Cuts while the wire does not run, or without fluid or a cutting condition (kWireSupply): one a stretch
/// of
///   such cuts. What the program never switches on is the operator's: one warning.
/// - Pieces that come free and through whose place the wire goes on without a stop (kFreeSlug), or whose
/// walls keep them from falling (kStuckSlug).
/// - Bridges on which pieces still hang (kBridge).
void addWireFindings(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings);

}  // namespace proveout
