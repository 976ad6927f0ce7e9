// Loops of a section as polygons that a mesh can hold: none meets another or itself.
#pragma once

#include <optional>
#include <vector>

#include "removal/wire/section/plane_region.h"

namespace proveout {

struct ChordRing {
  std::vector<Vec2> points;                 ///< as floats
  std::vector<MotionId> motion;             ///< of the edge to the next
  std::vector<std::optional<Vec2>> center;  ///< of the arc that it is a chord of
};

/// Chords leave the arcs by no more than `tolerance` mm; those beside something that they would meet are
/// shorter. Corners in which loops touch stand back by some steps of a mesh. One ring a loop; fewer than
/// three points: there is nothing of it.
std::vector<ChordRing> chordRings(const std::vector<const PlaneLoop*>& loops, double tolerance);

}  // namespace proveout
