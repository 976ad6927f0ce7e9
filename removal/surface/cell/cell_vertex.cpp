#include "removal/surface/cell/cell_vertex.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "removal/surface/cell/vertex_refiner.h"

namespace proveout {

namespace {

/// Faces whose normals differ by less than this (2 degrees) count as one smooth surface in a cell: such a
/// flat ridge is less than a hundredth of a cell high.
const double kSmoothCos = std::cos(degToRad(2.0));
/// Pull towards the mean where the planes leave a direction free. It biases the vertex by less than 1e-4
/// cells at feature edges of more than 10 degrees.
constexpr double kNearness = 1e-6;

/// Faces that meet at less than 40 degrees, as scallops do, are mostly curved: a feature edge farther
/// outside the cell than the slack (in cells) is uncertain, and cutting the ridge between neighbours costs
/// little.
const double kSoftCos = std::cos(degToRad(40.0));
/// The same for faces known to bend little: cutting the ridge along a shallow groove in every cell would
/// cost 1e-4 of its volume.
const double kSoftCosOfFlat = std::cos(degToRad(10.0));
constexpr double kOutsideSlack = 0.05;

/// How far vertices may be off the blank, in cells: at a wall of the cell, and on a chord below a sharp edge.
constexpr double kNearBy = 0.2, kFarOff = 0.7;

/// Normals of a sphere or round cylinder are within 72 degrees (cosine) of their mean: however small it is,
/// it is smooth.
constexpr double kFacesAlong = 0.3;

/// Normals of one face that differ by more than 25 degrees may be those of two planes.
constexpr double kBentCos = 0.906;
/// How far crossings may be off a body that they are on (in cells), and how near their normals are to its
/// own there (0.8 degrees, cosine).
constexpr double kOnBody = 1e-3, kAsBody = 0.9999;
/// Across a ridge, crossings are farther than this (in cells) behind each other's tangent planes. The inner
/// side of an arc turns less within a cell.
constexpr double kRidge = 0.1;
/// Least spread of the normals about an apex (cosine), and how near its tangent planes must come to it (in
/// cells).
const double kApexCos = std::cos(degToRad(30.0));
constexpr double kApexMiss = 2e-3;
/// Normals within 2.5 degrees (cosine) count as one direction.
constexpr double kOneDirection = 0.999;

/// Whether no two faces meet at more than the angle of this cosine.
bool areAlike(std::span<const CellFace> faces, double cosine) {
  for (std::size_t i = 1; i < faces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (faces[i].normal.dot(faces[j].normal) < cosine) return false;
    }
  }
  return true;
}

/// The point of the cell that minimises the distances to the faces' planes; where they leave it free, the
/// one nearest to `from`. Each coordinate is free or at a wall; since the function is convex, the best of
/// the 27 cases that stay inside is the minimum.
Vec3 meetPlanesInside(std::span<const Plane> planes, const Vec3& from) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Identity() * kNearness;
  Vec3 b = Vec3::Zero();
  for (const Plane& p : planes) {
    a += p.n * p.n.transpose();
    b += p.n * p.d;
  }
  Vec3 best = from;
  double least = std::numeric_limits<double>::infinity();
  for (int state = 0; state < 27; ++state) {
    const std::array<int, 3> at = {state % 3, state / 3 % 3, state / 9};
    Eigen::Matrix3d m = a;
    Vec3 rhs = b;
    for (int k = 0; k < 3; ++k) {
      if (at[k] == 0) continue;
      m.row(k) = Vec3::Unit(k).transpose();
      rhs[k] = at[k] - 1.0 - from[k];
    }
    const Vec3 x = m.inverse() * rhs;
    const double value = x.dot(a * x) - 2.0 * x.dot(b);
    if (outsideBy(from + x) <= 1e-9 && value < least) {
      least = value;
      best = from + x;
    }
  }
  return best;
}

/// The point of the surface above or below `mean`, on the face of two that forms it there: the lower one on
/// a ridge, the higher one in a valley. On the surface, beside the feature edge.
Vec3 besideFeatureEdge(std::span<const CellFace> faces, const Vec3& mean, const Vec3& n) {
  const CellFace &a = faces[0], &b = faces[1];
  const Vec3 between = b.point - a.point;
  const bool ridge = between.dot(a.normal) - between.dot(b.normal) < 0.0;
  std::array<double, 2> up;
  for (int i = 0; i < 2; ++i) {
    const Plane p = planeAt(faces[i], mean);
    const double c = p.n.dot(n);
    if (c < 0.1) return mean;
    up[i] = p.d / c;
  }
  return mean + n * (ridge ? std::min(up[0], up[1]) : std::max(up[0], up[1]));
}

/// In how many directions the normals point.
int directionsOf(std::span<const SheetPoint> points) {
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto isAlike = [&](const SheetPoint& s) { return s.n.dot(points[i].n) > kOneDirection; };
    count += std::none_of(points.begin(), points.begin() + i, isAlike) ? 1 : 0;
  }
  return count;
}

/// The apex: the point where the tangent planes of one face, or at least four of several faces, meet. False
/// unless they lean widely and do meet in one point.
bool findApex(std::span<const SheetPoint> points, const Vec3& mean, Vec3& apex) {
  double least = 1.0;
  std::array<Plane, 12> planes;
  bool one_face = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    one_face = one_face && points[i].face == points[0].face;
    least = std::min(least, points[0].n.dot(points[i].n));
    planes[i] = {points[i].n, points[i].n.dot(points[i].p - mean)};
  }
  if (least > kApexCos || points.size() < 4) return false;
  // Three planes of several faces always meet in a point.
  if (!one_face && directionsOf(points) < 4) return false;
  const std::span<const Plane> used(planes.data(), points.size());
  const Vec3 x = meetAny(used);
  for (const Plane& p : used) {
    if (std::abs(p.n.dot(x) - p.d) > kApexMiss) return false;
  }
  apex = mean + x;
  return outsideBy(apex) <= kVertexReach;
}

CellVertex smoothVertex(std::span<const SheetPoint> points, const Vec3& mean, const Vec3& sum,
                        VertexRefiner* refiner) {
  CellVertex out;
  out.smooth = true;
  const double length = sum.norm();
  if (length < 1e-6 * static_cast<double>(points.size())) {
    out.p = out.inside = clampToCell(mean);
    return out;
  }
  const Vec3 n = sum / length;
  out.p = out.inside = clampToCell(mean - n * heightAbove(points, mean, n, nullptr));
  if (refiner == nullptr || !refiner->needed(true)) return out;
  if (refiner->snapToSurface(n, 0.0, out.p)) {
    refiner->snapToSeam(out.p);
    refiner->snapToSweepEnd(points, out.p);
    out.inside = out.p;
    return out;
  }
  // The surface bulges out of the cell between its crossings.
  out.inside = out.p;
  out.outside = refiner->snapToSurface(n, kOutsideSlack, out.p);
  if (!out.outside) {
    Vec3 onto = out.inside;
    refiner->snapToNearestBody(n, onto);
    if (outsideBy(onto) <= -kWallGap) out.inside = onto;
    out.p = out.inside;
  }
  return out;
}

/// Fits quadratic surfaces to the faces.
void findSurfaces(std::span<const SheetPoint> points, std::span<CellFace> faces) {
  for (CellFace& f : faces) {  // tangent planes touch the surface, not the chord
    if (f.count > 1) f.point -= f.normal * heightAbove(points, f.point, f.normal, &f);
    findCurvature(points, f);
  }
}

/// The feature edge or corner nearest to `start`: where the faces' surfaces meet.
Vec3 featureNear(std::span<const CellFace> faces, const Vec3& start) {
  const bool curved = std::any_of(faces.begin(), faces.end(), [](const CellFace& f) { return f.curved; });
  Vec3 x = start;
  std::array<Plane, 12> planes;
  for (int round = 0; round < (curved ? 3 : 1); ++round) {
    for (std::size_t i = 0; i < faces.size(); ++i) planes[i] = planeAt(faces[i], x);
    x += meetPlanes({planes.data(), faces.size()});
    if (!(outsideBy(x) < 2.0)) break;
  }
  return x;
}

/// The vertex inside a cell whose feature edge or corner lies outside.
Vec3 vertexWithoutFeature(std::span<const CellFace> faces, const Vec3& mean, const Vec3& sum) {
  if (faces.size() == 2) return clampToCell(besideFeatureEdge(faces, mean, sum.normalized()));
  std::array<Plane, 12> planes;
  for (std::size_t i = 0; i < faces.size(); ++i) planes[i] = planeAt(faces[i], mean);
  return clampToCell(meetPlanesInside({planes.data(), faces.size()}, mean));
}

/// The point of the cell nearest to `x`, which is just outside: on the feature edge of two faces through
/// `x`, if that comes into the cell.
Vec3 slideIntoCell(std::span<const CellFace> faces, const Vec3& x) {
  if (faces.size() != 2) return clampToCell(x);
  const Vec3 along = planeAt(faces[0], x).n.cross(planeAt(faces[1], x).n);
  double from = -1.0 / kWallGap, to = 1.0 / kWallGap;
  for (int k = 0; k < 3; ++k) {
    const double low = (kWallGap - x[k]) / along[k], high = (1.0 - kWallGap - x[k]) / along[k];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  return clampToCell(from <= to ? Vec3(x + std::clamp(0.0, from, to) * along) : x);
}

/// Whether no normal of a round face is opposed to their sum, as between the two sides of a narrow cut.
bool hasNoOpposedNormals(std::span<const SheetPoint> points, const Vec3& sum) {
  const double least = kFacesAlong * sum.norm();
  return std::all_of(points.begin(), points.end(), [&](const SheetPoint& s) { return s.n.dot(sum) > least; });
}

/// Whether the normals point in more than two directions of a plane.
bool spanSpace(std::span<const SheetPoint> points) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (const SheetPoint& s : points) m += s.n * s.n.transpose();
  return m.determinant() > 1e-3;
}

/// The vertex at an apex. An apex outside belongs to this cell only if it stands out through a single wall,
/// into a cell that does not see it.
CellVertex apexVertex(std::span<const SheetPoint> points, const Vec3& mean, const Vec3& sum,
                      VertexRefiner* refiner, const Vec3& apex) {
  CellVertex out;
  out.p = apex;
  if (refiner != nullptr && refiner->needed(false)) refiner->snapToFeature(out.p);
  const Vec3 kept = clampToCell(out.p);
  const int walls = static_cast<int>((kept.array() != out.p.array()).count());
  out.outside = walls == 1;
  out.inside = walls == 0 ? out.p : smoothVertex(points, mean, sum, refiner).inside;
  if (walls > 1) out.p = out.inside;
  return out;
}

/// Whether faces meet at such a shallow angle that the place of their feature edge is uncertain.
bool isFeatureUncertain(std::span<const CellFace> faces, VertexRefiner* refiner, const Vec3& x) {
  if (!areAlike(faces, kSoftCos)) return false;
  return areAlike(faces, kSoftCosOfFlat) || refiner == nullptr || !refiner->meetAsPlanes(x);
}

/// The vertex of a cell whose feature edge or corner is at `x`, in the cell or not. `certain`: it was found
/// on the bodies.
CellVertex featureVertex(std::span<const CellFace> faces, const Vec3& mean, const Vec3& sum,
                         VertexRefiner* refiner, const Vec3& x, bool certain) {
  CellVertex out;
  if (refiner != nullptr && refiner->isOffBlank(x)) {
    out.p = clampToCell(mean);
    refiner->snapToBlank(sum.normalized(), kFarOff, out.p);
    out.inside = out.p;
    return out;
  }
  const double beyond = outsideBy(x);
  if (beyond <= -kWallGap) {
    out.p = out.inside = x;
    return out;
  }
  const bool refine = refiner != nullptr && refiner->needed(false);
  out.inside = beyond < kOutsideSlack ? slideIntoCell(faces, x) : vertexWithoutFeature(faces, mean, sum);
  if (refine && beyond > (refiner->bends() ? kWallGap : kOutsideSlack))
    refiner->snapToSurface(sum.normalized(), 0.0, out.inside);
  if (refiner != nullptr) refiner->snapToBlank(sum.normalized(), kNearBy, out.inside);
  const double reach = beyond > kOutsideSlack && !certain && isFeatureUncertain(faces, refiner, x)
                           ? kOutsideSlack
                           : kVertexReach;
  out.outside = beyond <= reach;
  out.p = out.outside ? x : out.inside;
  return out;
}

/// Whether a crossing is on this body as well, with the same normal.
bool isOnBody(const SheetPoint& s, std::int64_t body, ExactFaces& exact) {
  const ExactFaces::Foot foot = exact.foot(body, s.p - ExactFaces::kProbeDepth * s.n);
  return (foot.p - s.p).squaredNorm() < kOnBody * kOnBody && foot.normal.dot(s.n) > kAsBody;
}

/// The same of all crossings of `face`.
bool areAllOnBody(std::span<const SheetPoint> points, std::uint64_t face, std::int64_t body,
                  ExactFaces& exact) {
  return std::ranges::all_of(points,
                             [&](const SheetPoint& s) { return s.face != face || isOnBody(s, body, exact); });
}

/// Whether the material forms a ridge between crossings of two faces, which one convex tool never leaves.
bool meetInRidge(std::span<const SheetPoint> points, std::uint64_t face, std::uint64_t other) {
  const auto isBehind = [&](const SheetPoint& a, const SheetPoint& b) {
    return a.face == face && b.face == other && (b.p - a.p).dot(a.n) < -kRidge &&
           (a.p - b.p).dot(b.n) < -kRidge;
  };
  return std::ranges::any_of(points, [&](const SheetPoint& a) {
    return std::ranges::any_of(points, [&](const SheetPoint& b) { return isBehind(a, b); });
  });
}

/// Whether the crossings of the first face count as those of the second, which shows better what both are
/// part of: tangent neighbours of one body; or what a tool left at its start, which also lies on what it
/// swept from there.
bool isMergedInto(std::span<const SheetPoint> points, std::uint64_t face, std::uint64_t other,
                  ExactFaces& exact) {
  const ExactFaces::Source of = exact.source(face), to = exact.source(other);
  if (to.isShown()) return false;
  if (exact.areTangentNeighbours(face, other)) return !to.simple || (of.simple && to.bend >= of.bend);
  return (exact.areOfOneCone(face, other) || exact.areOfLeaningCylinder(face, other)) &&
         !meetInRidge(points, face, other) && areAllOnBody(points, face, to.body, exact);
}

/// With one body alone its elements stay apart: the volume asks for their curvature, which changes from one
/// to the other.
bool isOfSeveralBodies(std::span<const SheetPoint> points, ExactFaces& exact) {
  const std::int64_t body = exact.source(points[0].face).body;
  return !std::ranges::all_of(points, [&](auto& s) { return exact.source(s.face).body == body; });
}

/// Merges each face that is part of another into that one, by renaming its crossings. False where none is.
bool mergeBlendedFaces(std::span<SheetPoint> points, ExactFaces& exact) {
  bool merged = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i && points[j].face != points[i].face; ++j) {
      const std::uint64_t a = points[i].face, b = points[j].face;
      const bool first = isMergedInto(points, a, b, exact);
      if (!first && !isMergedInto(points, b, a, exact)) continue;
      for (SheetPoint& s : points) {
        if (s.face == (first ? a : b)) s.face = first ? b : a;
      }
      merged = true;
    }
  }
  return merged;
}

/// As placeVertex. `merged`: faces were merged; then none if the merged faces do not meet.
std::optional<CellVertex> placeFromFaces(std::span<const SheetPoint> points, bool merged, ExactFaces* exact) {
  Vec3 mean = Vec3::Zero(), sum = Vec3::Zero();
  for (const SheetPoint& s : points) {
    mean += s.p;
    sum += s.n;
  }
  mean /= static_cast<double>(points.size());
  Faces all;
  const bool one_face =
      std::all_of(points.begin(), points.end(), [&](auto& s) { return s.face == points[0].face; });
  const bool known = exact != nullptr && exact->active();
  // Where its body is known, that says whether one face bends or breaks. Faces of unknown bodies must be
  // read the same before and after a path that does not reach them.
  const bool body_tells = known && one_face && exact->source(points[0].face).body != ExactFaces::kNoBody;
  const bool round =
      !merged && body_tells && exact->source(points[0].face).bend > 0.0 && hasNoOpposedNormals(points, sum);
  const int count = collectFaces(points, round ? -1.0 : body_tells ? kBentCos : kSameFaceCos, all);
  const std::span<CellFace> faces(all.data(), static_cast<std::size_t>(count));
  std::optional<VertexRefiner> exactly;
  if (known) exactly.emplace(*exact, faces);
  VertexRefiner* refiner = exactly ? &*exactly : nullptr;
  Vec3 apex;
  // A tip smaller than the cell may end the cone before its apex.
  if (!round && spanSpace(points) && findApex(points, mean, apex) &&
      (refiner == nullptr || refiner->reaches(apex)))
    return apexVertex(points, mean, sum, refiner, apex);
  if (count == 1) return smoothVertex(points, mean, sum, refiner);
  if (areAlike(faces, kSmoothCos)) {
    CellVertex out = smoothVertex(points, mean, sum, refiner);
    const Vec3 n = sum.normalized();
    out.lifted = std::abs(n.dot(out.p - mean) + heightAbove(points, mean, n, nullptr));
    return out;
  }
  findSurfaces(points, faces);
  Vec3 x = featureNear(faces, mean);
  const bool refine = refiner != nullptr && (refiner->needed(false) || refiner->isBeyondTrim(x));
  if (refine && refiner->isSmooth(x)) return smoothVertex(points, mean, sum, refiner);
  const bool found = refine && outsideBy(x) <= kVertexReach && refiner->snapToFeature(x);
  if (refine && !found && outsideBy(x) <= kVertexReach) {
    // Either beside an apex, where a face turns as if it broke; or faces of several bodies that blend.
    if (merged) return std::nullopt;
    if (one_face) return smoothVertex(points, mean, sum, refiner);
    refiner->snapToNearestBody(sum.normalized(), x);
  }
  CellVertex out = featureVertex(faces, mean, sum, refiner, x, found);
  if (found && out.p == x) out.along = refiner->featureEdgeDirection(x).value_or(Vec3::Zero());
  return out;
}

/// The vertex in an upright wall at the end of a sweep: on the seam between what a body swept in passing and
/// the round where its motion began or ended, where other bodies may go down or come up. None where the cell
/// has no such place.
std::optional<CellVertex> placeAtSweepEnd(std::span<const SheetPoint> points, ExactFaces& exact) {
  const std::uint64_t first = points[0].face;
  if (!std::ranges::all_of(points, [&](auto& s) { return exact.areOfOneCylinder(first, s.face); }))
    return std::nullopt;
  const auto holdsAll = [&](std::uint64_t face) {
    const std::int64_t body = exact.source(face).body;
    return std::ranges::all_of(points, [&](auto& s) { return s.face == face || isOnBody(s, body, exact); });
  };
  std::array<SheetPoint, 12> merged;
  std::copy(points.begin(), points.end(), merged.begin());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i].face == points[i - 1].face) continue;
    if (!holdsAll(points[i].face)) continue;
    for (std::size_t k = 0; k < points.size(); ++k) merged[k].face = points[i].face;
    const std::span<const SheetPoint> all(merged.data(), points.size());
    Faces faces;
    collectFaces(all, -1.0, faces);
    CellVertex out;
    out.smooth = true;
    out.p = faces[0].point;
    if (!VertexRefiner(exact, {faces.data(), 1}).snapToSweepEnd(all, out.p)) continue;
    out.inside = out.p;
    return out;
  }
  return std::nullopt;
}

}  // namespace

CellVertex placeVertex(std::span<const SheetPoint> points, ExactFaces* exact) {
  if (exact != nullptr && exact->active() && isOfSeveralBodies(points, *exact)) {
    if (const std::optional<CellVertex> placed = placeAtSweepEnd(points, *exact)) return *placed;
    std::array<SheetPoint, 12> copied;
    std::copy(points.begin(), points.end(), copied.begin());
    const std::span<SheetPoint> merged(copied.data(), points.size());
    if (mergeBlendedFaces(merged, *exact)) {
      if (const std::optional<CellVertex> placed = placeFromFaces(merged, true, exact)) return *placed;
    }
  }
  return *placeFromFaces(points, false, exact);
}

}  // namespace proveout
