// The cause of a deviation: which word, or which datum of the operator, would explain it.
#pragma once

#include <vector>

#include "app/session/run/run_result.h"
#include "removal/compare/exact_part.h"

namespace proveout {

/// A finding and the patch that it tells of.
struct PatchFinding {
  std::size_t finding;  ///< index into RunResult::findings
  const DeviationPatch* patch;
};

/// The motion to blame for a patch: that with the largest share of it where it is deep.
SurfaceMaker mainMaker(const DeviationPatch& patch);

/// Fills `blocks` and `causes` of findings of the comparison. A word or datum that is wrong shifts every cut
/// that depends on it by the same amount: the deviations all over the part are held against that, those that
/// are there and those that should be there and are not. `part`: null where there is none, see makeExactPart.
void diagnoseDeviations(const RunSources& sources, const ExactPart* part,
                        const std::vector<PatchFinding>& patches, RunResult& run);

/// The words and data behind a motion, all of them.
std::vector<Cause> behindMotion(const SetupRun& setup, const RecordingSource& texts, MotionId motion);

/// Fills `causes` of findings about a motion (contacts): the words that it is made with.
void tellWordsInForce(const RunSources& sources, RunResult& run);

}  // namespace proveout
