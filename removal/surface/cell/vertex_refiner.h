// Puts a vertex onto the swept volumes behind the faces of its cell. Lengths in units of the cell.
#pragma once

#include <array>
#include <optional>

#include "removal/surface/cell/cell_faces.h"
#include "removal/surface/cell/exact_faces.h"

namespace proveout {

/// For the faces of one cell. Bodies are probed from a point a little inside the material: there the
/// distance to a swept volume is exact, and its nearest point is on an edge where there is one. A seam is
/// the border where two elements of one tool, or a sweep and the round of its end, meet without a break; a
/// trim is where a face ends.
class VertexRefiner {
 public:
  /// `exact` is set to the cell.
  VertexRefiner(ExactFaces& exact, std::span<const CellFace> faces);

  /// Whether crossings and normals alone do not give the surface exactly. `smooth`: the faces are one smooth
  /// surface; otherwise findCurvature must have been called for them.
  bool needed(bool smooth) const;

  /// Whether a straight face of a rounded tool is trimmed before `x`, where the faces seem to meet: the face
  /// that continues it meets the others then.
  bool isBeyondTrim(const Vec3& x);
  /// Whether the bodies of all faces come to `x`, as far as passes made them.
  bool reaches(const Vec3& x);
  /// Whether one of the faces bends, by its body or by its crossings.
  bool bends() const;
  /// Whether a path cut here and the faces, up to `x` where they meet, bend as little as planes. Never true
  /// for faces of the blank alone, which must be read the same before and after a path.
  bool meetAsPlanes(const Vec3& x);
  /// Whether the faces near `x` are one smooth surface although their normals differ.
  bool isSmooth(const Vec3& x);
  /// Moves `x` to the feature edge or corner near it. False, and `x` stays, where the iteration does not
  /// converge nearby.
  bool snapToFeature(Vec3& x);
  /// Direction (unit, either way) of the feature edge between faces of two bodies at `x`, which is on it.
  /// None for other feature edges, where both faces are nearly flat, and where no pass cut.
  std::optional<Vec3> featureEdgeDirection(const Vec3& x);
  /// Moves `x`, in the cell, onto the smooth surface, at most `beyond` out of the cell. `n`: out of the
  /// material. False if `x` is not on the surface afterwards.
  bool snapToSurface(const Vec3& n, double beyond, Vec3& x);
  /// Where neither of the two above succeeds: moves `x` a little, onto the nearest of its faces' bodies.
  /// That may be on a face without a crossing here, which continues another one smoothly. `n`: as above.
  void snapToNearestBody(const Vec3& n, Vec3& x);
  /// Moves `x`, on a smooth surface of two elements of one body, along the surface to the seam between them,
  /// so that each quad around it lies on one element and its curvature is that of the element. `x` stays
  /// where the cell has no such place.
  void snapToSeam(Vec3& x);
  /// The same on a surface of one face: to the seam between what the tool swept in passing and the round
  /// that it left where its motion began or ended. False, and `x` stays, where the cell has no such place.
  bool snapToSweepEnd(std::span<const SheetPoint> points, Vec3& x);
  /// Moves `x`, in the cell, along `n` (out of the material) onto the blank's surface, by `reach` at most
  /// and without leaving a cell wall that it lies on. `x` stays where the surface is not near or is not the
  /// blank's.
  void snapToBlank(const Vec3& n, double reach, Vec3& x) const;
  /// Whether the surface is the blank's and `x` is off it, as where a face between those of the cell crosses
  /// none of its edges.
  bool isOffBlank(const Vec3& x) const;

 private:
  double leastFacing(std::size_t face);
  bool isContinuedBy(std::size_t face, const ExactFaces::Foot& foot);
  bool bendsAreSeen() const;
  bool oneBody() const;
  bool meetAtShallowAngle() const;
  Vec3 meanNormal() const;
  int firstFaceOfBodyEdge() const;
  bool snapToBodyEdge(Vec3& x);
  bool snapToCorner(int first, Vec3& x);
  bool snapToIntersection(Vec3& x);
  bool tangentPlaneNear(int face, const Vec3& x, Vec3& from, Plane& plane, double& off);
  bool tangentPlaneBesideRidge(int face, const Vec3& x, double part, Vec3& from, Plane& plane, double& off);
  bool isBetweenFaces(const Vec3& x);
  bool isSharp(const Vec3& n, const Vec3& across, const Vec3& x);
  /// A point of a surface and its normal there.
  struct Place {
    Vec3 p, n;
  };
  template <typename KindOf>
  bool snapToTransition(const Place& first, const Place& second, const KindOf& kindOf, Vec3& x);
  enum class Seen : std::uint8_t { kKnownFaces, kBlendedFaces };
  bool nearestTangentPlane(const Vec3& n, const Vec3& x, Seen seen, Plane& plane);

  ExactFaces& exact_;
  std::span<const CellFace> faces_;
  std::array<std::int64_t, 12> body_;
  std::array<bool, 12> round_;     ///< it may bend by more than a feature edge may be off
  std::array<double, 12> bend_;    ///< curvature of simple faces, from ExactFaces::Source
  std::array<double, 12> facing_;  ///< result of leastFacing; 0: not asked for yet
  bool cut_ = false;               ///< a pass made one of the faces
  bool exact_already_ = true;      ///< crossings and normals show all faces exactly, each for itself
};

}  // namespace proveout
