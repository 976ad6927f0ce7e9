// Makes the finished mesh of a blank follow edges and corners that run between the vertices of its cells.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"
#include "removal/grid/blank_field.h"

namespace proveout {

/// A cell has one vertex a sheet; where a part's edges come nearer to each other than the cells are wide,
/// some triangles cut across. Here vertices are moved onto such edges, mesh edges split at them and turned
/// along them, as long as that brings the mesh nearer to the blank: wherever a vertex, the middle of a mesh
/// edge or of a triangle is off it by more than `tolerance_mm` and 0.03 cells. `mesh` must be closed and
/// 2-manifold, and stays so; what would make triangles run through each other is not done. `cell_mm` > 0: the
/// grid spacing. Triangles that change carry the motion of the blank's face. The same result for the same
/// input always. Stops early when cancelled.
void sharpenMesh(TriMesh& mesh, const BlankField& field, double cell_mm, double tolerance_mm,
                 Progress& progress);

}  // namespace proveout
