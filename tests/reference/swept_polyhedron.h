// What a convex part of a cutter sweeps, as a polyhedron with as much volume. All mm.
#pragma once

#include <vector>

#include "core/path/toolpath.h"
#include "tests/reference/cutter_section.h"

namespace proveout::reference {

/// Closed: faces counter-clockwise seen from outside. Without faces: the convex hull of the points.
struct Polyhedron {
  std::vector<Vec3> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// What motion `number` sweeps that the one before it has not, and some of that: where a motion goes on from
/// another, surfaces that are the same in truth must not be there twice, since their facets would not be the
/// same and what is removed would be the more of both. One solid, or several whose union it is, with chords
/// of about `step_rad` (TrueChords). Arcs have vertical axes, one radius and no rise, and are larger than the
/// tool.
std::vector<Polyhedron> sweep(const Section& section, const Toolpath& path, std::size_t number,
                              double step_rad);

}  // namespace proveout::reference
