// Where the surface's vertex lies in a cell, from the exact crossings and normals of one sheet.
#pragma once

#include <span>

#include "removal/surface/cell/cell_faces.h"
#include "removal/surface/cell/exact_faces.h"

namespace proveout {

/// A vertex in units of the cell.
struct CellVertex {
  Vec3 p = Vec3::Zero();       ///< on the surface; up to kVertexReach outside the cell
  Vec3 inside = Vec3::Zero();  ///< inside the cell, as near to the surface as can be; p where p is inside
  bool smooth = false;         ///< one smooth surface runs through the cell
  bool outside = false;        ///< p is outside the cell
  Vec3 along = Vec3::Zero();   ///< of the crease that p is on, either way; 0 where it is not known
};

/// How far creases and corners are followed out of the cell (in cells), where no fold comes of it: ridges of
/// 37 degrees end so far beside the samples.
inline constexpr double kVertexReach = 1.5;

/// On one smooth face: the mean of the crossings, put onto the surface by the rule that the chord between two
/// points of a sphere or cylinder is at right angles to the sum of their normals (third order on other
/// surfaces). Where faces meet: the point nearest to the mean where the faces, taken as quadratic surfaces
/// with the curvature that their normals show, meet (edges and corners stay sharp). A crease or corner may
/// clip the cell's edges and yet lie outside it.
/// Where the tangent planes of one face lean widely and meet in a point, that is its apex.
/// `exact`, if given and active, is set to the cell: the vertex is then put onto the swept volumes
/// themselves, to their faces, edges and points, wherever the rules above are not exact.
CellVertex placeVertex(std::span<const SheetPoint> points, ExactFaces* exact = nullptr);

}  // namespace proveout
