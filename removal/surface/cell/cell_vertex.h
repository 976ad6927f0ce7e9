// Places the surface's vertex in a cell, from the exact crossings and normals of one sheet.
#pragma once

#include <span>

#include "removal/surface/cell/cell_faces.h"
#include "removal/surface/cell/exact_faces.h"

namespace proveout {

/// A vertex in units of the cell.
struct CellVertex {
  Vec3 p = Vec3::Zero();       ///< on the surface; up to kVertexReach outside the cell
  Vec3 inside = Vec3::Zero();  ///< inside the cell, as near to the surface as can be; p where p is inside
  /// How far off the crossings' surface p is where several faces seem to be one: the height of a ridge or
  /// groove between the crossings, of which none is told otherwise.
  double lifted = 0.0;
  bool smooth = false;        ///< one smooth surface runs through the cell
  bool outside = false;       ///< p is outside the cell
  Vec3 along = Vec3::Zero();  ///< direction of the feature edge that p is on, unit, either way; 0 where it is
                              ///< not known
};

/// How far feature edges and corners are followed out of the cell (in cells), as long as that does not fold
/// the surface: ridges of 37 degrees end this far beside the samples.
inline constexpr double kVertexReach = 1.5;

/// On one smooth face: the mean of the crossings, put onto the surface by the rule that the chord between
/// two points of a sphere or cylinder is at right angles to the sum of their normals (third order on other
/// surfaces). Where faces meet: the point nearest to the mean at which the faces meet, taken as quadratic
/// surfaces with the curvature that their normals show; so edges and corners stay sharp. A feature edge or
/// corner may clip the cell's edges and yet lie outside it. Where the tangent planes of one face lean widely
/// and meet in a point, that is its apex. `exact`, if given and active, is set to the cell: the vertex is
/// then put onto the swept volumes themselves, to their faces, edges and points, wherever the rules above
/// are not exact.
CellVertex placeVertex(std::span<const SheetPoint> points, ExactFaces* exact = nullptr);

}  // namespace proveout
