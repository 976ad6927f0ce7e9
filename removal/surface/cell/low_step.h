// Steps lower than a cell: two nearly parallel faces whose crossings a cell sees, and a wall between them of
// which it sees none.
#pragma once

#include <optional>
#include <span>

#include "core/path/toolpath.h"
#include "removal/surface/cell/cell_faces.h"
#include "removal/surface/cell/exact_faces.h"

namespace proveout {

/// One vertex cannot be on both edges of such a wall.
struct LowStep {
  Vec3 low, high;               ///< on the wall's two edges, above each other; in units of the cell
  MotionId motion = kNoMotion;  ///< that made the wall, and what is below it
};

/// The step in the middle of its way through a cell, where the body that made the lower face also made the
/// wall, and both edges are found on the bodies. `points`: crossings of the cell's only sheet; `exact`: set
/// to the cell. None where there is none, or not for sure.
std::optional<LowStep> findLowStep(std::span<const SheetPoint> points, ExactFaces& exact);

}  // namespace proveout
