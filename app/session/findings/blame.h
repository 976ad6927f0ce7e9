// Which block a finding names: what the user wrote, and the block that moved because of it.
#pragma once

#include <optional>

#include "app/session/programs/interpretation.h"
#include "io/report.h"

namespace proveout {

/// The block that a word stands in.
BlockRef blockRef(const Toolpath& path, const ResolvedOrigin& word, const RecordingSource& texts);

/// The block of the user's program that a motion was made for.
struct WrittenBlock {
  BlockRef block;
  /// The block that moved, where that is another one: a line of the control's own cycle, or the call of a
  /// cycle whose pass follows `block`, one of its contour.
  std::optional<BlockRef> inside;
};
WrittenBlock writtenBlock(const Toolpath& path, MotionId motion, const RecordingSource& texts);

/// Names the block and the tool behind a motion; leaves both away for kNoMotion.
void blame(Finding& finding, MotionId motion, const Toolpath& path, const RecordingSource& texts);

}  // namespace proveout
