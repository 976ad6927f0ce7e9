// Meshes with so few triangles that a page can carry them.
#pragma once

#include <cstddef>
#include <functional>

#include "core/base/progress.h"
#include "io/report/view/scene_data.h"

namespace proveout {

/// The mesh with about `most` triangles at most, without deviations: simplified, or, where it is no closed
/// manifold or has millions of triangles, its vertices gathered on a grid. Same result on any number of
/// threads. A cancelled `progress` gives more triangles than asked for.
ViewMesh reducedMesh(const TriMesh& mesh, std::size_t most, const Progress& progress);

/// Gives the vertices their deviations, unless they have them, and halves edges along which the deviation does not go evenly, so
/// that a spot on a large triangle shows, while there are at most `most` triangles. `deviation`: of a point
/// of the mesh, mm; thread-safe. `tolerance_mm`: what may be left out, > 0.
void addDeviations(const std::function<float(const Vec3&)>& deviation, double tolerance_mm, std::size_t most,
                   ViewMesh& view);

}  // namespace proveout
