// Which work offset says where the workpiece lies, where the job does not say so itself.
#pragma once

#include "app/session/programs/interpretation.h"

namespace proveout {

/// Of a job without a placement that gives several work offsets: G54, or, where the program cuts nothing
/// under G54, the first one that it cuts under. That becomes the origin of the job's placement, and
/// `diagnostics` gets a note. `blank`: bounds, workpiece frame. Reads the program up to its first cut under
/// G54.
void placeByFirstOffset(Job& job, const RecordingSource& source, const Box3& blank, Diagnostics& diagnostics,
                        Progress& progress);

}  // namespace proveout
