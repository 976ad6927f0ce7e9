// Steps lower than a cell: two nearly parallel faces that a cell has crossings of, and a wall between them
// that it has none of.
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

/// The step, at the middle of its run through a cell, if the body that made the lower face also made the
/// wall and both edges are found on the bodies. `points`: crossings of the cell's only sheet; `exact`: set
/// to the cell. None where there is no step or it is uncertain.
std::optional<LowStep> findLowStep(std::span<const SheetPoint> points, ExactFaces& exact);

}  // namespace proveout
