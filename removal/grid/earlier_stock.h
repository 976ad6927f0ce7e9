// What earlier clampings cut a stock from: its faces as they were made, where its mesh shows chords of them.
#pragma once

#include <memory>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/types.h"

namespace proveout {

struct CutRecord;
class BlankField;
class TriangleTree;

/// A stock as it was when it was clamped again.
struct EarlierStock {
  RigidTransform back;  ///< from the frame of the next clamping into that of this one
  /// What it was before the last path: the first of these that there is.
  std::shared_ptr<const BlankField> blank;
  std::shared_ptr<const EarlierStock> earlier;
  std::shared_ptr<const TriangleTree> mesh;
  std::shared_ptr<const CutRecord> cut;  ///< the path; null: it took nothing
  std::vector<Box3> dropped;             ///< where pieces fell off afterwards
};

}  // namespace proveout
