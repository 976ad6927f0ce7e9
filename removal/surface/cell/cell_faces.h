// The faces of the surface in one cell, from the crossings of one sheet. All in units of the cell.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/geometry/types.h"

namespace proveout {

/// One crossing, in units of the cell (0..1 in every coordinate).
struct SheetPoint {
  Vec3 p;
  Vec3 n;              ///< unit, out of the material
  std::uint64_t face;  ///< equal for crossings of one smooth surface (motion and element)
};

/// Crossings of one swept face that look the same way.
struct CellFace {
  std::uint64_t id;  ///< SheetPoint::face
  Vec3 first;        ///< normal of its first crossing
  Vec3 point, normal;
  int count;          ///< of its crossings
  double same_cos;    ///< see collectFaces
  double spread;      ///< largest difference between its normals and the first
  Vec3 e1, e2, bend;  ///< curvature (11, 12, 22) in the tangent directions e1, e2; only if it is `curved`
  bool curved;
  bool bend_seen;  ///< its crossings are spread in both directions, so that `bend` is all of it
};
using Faces = std::array<CellFace, 12>;

/// A plane near a point m.
struct Plane {
  Vec3 n;
  double d;  ///< n * (x - m) = d on it
};

/// Sorts the crossings into faces; returns how many. Crossings of one SheetPoint::face whose normals differ
/// by more than the angle of `same_cos` belong to different ones. Does not find curvatures.
int collectFaces(std::span<const SheetPoint> points, double same_cos, Faces& faces);
/// Normals of one face differ by less than 60 degrees (cosine).
inline constexpr double kSameFaceCos = 0.5;
/// Sets the face's curvature from the differences of its normals, by least squares.
void findCurvature(std::span<const SheetPoint> points, CellFace& face);
/// Height of `m` along `n` above the surface through the points of one face, or of all (null).
double heightAbove(std::span<const SheetPoint> points, const Vec3& m, const Vec3& n, const CellFace* face);
/// The plane that touches the face's quadratic surface above `x`, near `x`.
Plane planeAt(const CellFace& face, const Vec3& x);

/// The smallest step that minimises the distances to planes near one point, only in directions in which the
/// planes determine it.
Vec3 meetAny(std::span<const Plane> planes);
/// The same, in closed form where two or three planes meet at a sufficient angle.
Vec3 meetPlanes(std::span<const Plane> planes);

/// Vertices stay this far inside their cell, so that those of neighbours never coincide, also as floats.
inline constexpr double kWallGap = 1e-3;
inline double outsideBy(const Vec3& p) { return std::max(-p.minCoeff(), p.maxCoeff() - 1.0); }
inline Vec3 clampToCell(const Vec3& p) {
  return p.cwiseMax(Vec3::Constant(kWallGap)).cwiseMin(Vec3::Constant(1.0 - kWallGap));
}

}  // namespace proveout
