// A mesh with fewer triangles, nowhere farther from what it was than a tolerance.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

struct Simplification {
  /// Every point of the mesh as it was is at most so far from the simplified one, and the other way round,
  /// mm; at most the tolerance.
  double distance_mm = 0.0;
  /// Pairs of triangles that run through each other and could not be parted; of a mesh that did so before,
  /// maybe not all.
  std::size_t self_intersections = 0;
};

/// Takes vertices out of a closed 2-manifold mesh; those that stay keep their places. Borders between motions
/// keep the vertices where they meet, and move by at most the tolerance between. Same result on any number of
/// threads. None: cancelled, the mesh is as it was. `tolerance_mm` of 0 or less: nothing is done. `off_mm`:
/// by vertex, how far the triangles there are off already, which is part of the distance; empty: none is.
std::optional<Simplification> simplifyMesh(TriMesh& mesh, double tolerance_mm, const Progress& progress,
                                           std::span<const float> off_mm = {});

}  // namespace proveout
