// Makes the finished mesh of a blank follow feature edges and corners that run between the vertices of its
// cells.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/tri_mesh.h"
#include "removal/grid/blank_field.h"

namespace proveout {

/// A cell has one vertex a sheet; where a part's feature edges come nearer to each other than the cells are
/// wide, some triangles cut across. This snaps vertices to such feature edges, and splits and flips mesh
/// edges along them, as long as that brings the mesh nearer to the blank: wherever a vertex, the middle of a
/// mesh edge or of a triangle is off it by more than `tolerance_mm` and 0.03 cells. `mesh` must be closed
/// and 2-manifold, and stays so; a change that would make triangles run through each other is not made.
/// `cell_mm` > 0: the grid spacing. Triangles that change carry the motion of the blank's face. The same
/// input always gives the same result. Stops early when cancelled.
void sharpenMesh(TriMesh& mesh, const BlankField& field, double cell_mm, double tolerance_mm,
                 Progress& progress);

}  // namespace proveout
