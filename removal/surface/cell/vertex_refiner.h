// Puts a vertex onto the swept volumes behind the faces of its cell. Lengths in units of the cell.
#pragma once

#include <array>
#include <optional>

#include "removal/surface/cell/cell_faces.h"
#include "removal/surface/cell/exact_faces.h"

namespace proveout {

/// For the faces of one cell. A point is looked at from a little inside the material, where the distance to a
/// swept volume is exact and its nearest point on an edge is on the edge.
class VertexRefiner {
 public:
  /// `exact` is set to the cell.
  VertexRefiner(ExactFaces& exact, std::span<const CellFace> faces);

  /// Whether crossings and normals do not show the surface exactly. `smooth`: the faces are one smooth
  /// surface; else findCurvature has seen them.
  bool needed(bool smooth) const;

  /// Whether a straight face of a rounded tool ends before `x`, where the faces seem to meet: what it goes
  /// over into meets the others then.
  bool isPastEnd(const Vec3& x);
  /// Whether one of the faces is known or seen to bend.
  bool bends() const;
  /// Whether a path cut here and the faces bend little up to `x`, where they meet, as planes do. Faces of the
  /// blank alone are read alike before and after a path: never true for them.
  bool meetFlat(const Vec3& x);
  /// Whether the faces near `x` are one smooth surface although their normals differ.
  bool isSmooth(const Vec3& x);
  /// Moves `x`, near a crease or corner, to it. False where that finds no rest nearby: `x` stays then.
  bool toCrease(Vec3& x);
  /// Which way the crease of two bodies' faces runs at `x`, on it. None of other creases, where both faces
  /// are nearly flat, and where no pass cut.
  std::optional<Vec3> alongCrease(const Vec3& x);
  /// Moves `x` in the cell onto the smooth surface, without leaving the cell by more than `beyond`. `n`: out
  /// of the material. False if it is not on the surface then.
  bool toSurface(const Vec3& n, double beyond, Vec3& x);
  /// Moves `x`, where neither of the two above holds, by a little onto the surface of its faces' bodies, also
  /// where it is of a face that no crossing shows: one that another goes over into smoothly. `n`: as above.
  void ontoNearest(const Vec3& n, Vec3& x);
  /// Moves `x`, on a smooth surface of two elements of one body, along it to where the one goes over into the
  /// other: quads around it are of one of them each then, which tells how they bend. `x` stays where there is
  /// no such place in the cell.
  void toBorder(Vec3& x);
  /// The same on a surface of one face, to where what the tool left in passing goes over into what it left
  /// where its way began or ended. False where there is no such place in the cell: `x` stays then.
  bool toEnd(std::span<const SheetPoint> points, Vec3& x);
  /// Moves `x` in the cell onto the blank's surface along `n`, out of the material, by `reach` at most and
  /// without leaving a wall that it lies at. It stays where the surface is not near or the surface is not the
  /// blank's.
  void toBlank(const Vec3& n, double reach, Vec3& x) const;
  /// Whether the surface is the blank's and `x` is off it: a face between those of the cell meets none of its
  /// edges.
  bool isOffBlank(const Vec3& x) const;

 private:
  double leastFacing(std::size_t face);
  bool continues(std::size_t face, const ExactFaces::Foot& foot);
  bool bendsAreSeen() const;
  bool oneBody() const;
  bool meetGently() const;
  Vec3 meanNormal() const;
  int bodyWithEdge() const;
  bool ontoBody(Vec3& x);
  bool ontoEdge(int first, Vec3& x);
  bool ontoFaces(Vec3& x);
  bool planeNear(int face, const Vec3& x, Vec3& from, Plane& plane, double& off);
  bool planeBeside(int face, const Vec3& x, double part, Vec3& from, Plane& plane, double& off);
  bool isBetweenFaces(const Vec3& x);
  bool isSharp(const Vec3& n, const Vec3& across, const Vec3& x);
  /// A place on a surface and the normal that is seen there.
  struct Place {
    Vec3 p, n;
  };
  template <typename KindOf>
  bool toChange(const Place& first, const Place& second, const KindOf& kindOf, Vec3& x);
  enum class Seen : std::uint8_t { kKnownFaces, kSmoothFaces };
  bool nearestPlane(const Vec3& n, const Vec3& x, Seen seen, Plane& plane);

  ExactFaces& exact_;
  std::span<const CellFace> faces_;
  std::array<std::int64_t, 12> body_;
  std::array<bool, 12> round_;     ///< it may bend by more than creases may miss
  std::array<double, 12> bend_;    ///< curvature of simple faces, as ExactFaces tells
  std::array<double, 12> facing_;  ///< as leastFacing tells; 0: not asked for yet
  bool cut_ = false;               ///< a pass made one of the faces
  bool exact_already_ = true;      ///< crossings and normals show all faces exactly, each for itself
};

}  // namespace proveout
