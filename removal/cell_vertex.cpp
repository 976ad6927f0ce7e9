#include "removal/cell_vertex.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// Faces whose normals differ by less than this are one smooth surface in a cell (2 degrees): a ridge so flat
/// is under a hundredth of a cell high.
const double kSmoothCos = std::cos(degToRad(2.0));
/// Directions in which the tangent planes fix the vertex worse than this (relative) are left to the mean.
constexpr double kRankTolerance = 1e-3;
/// Pull towards the mean where the planes leave a direction free; biases the vertex by less than 1e-4 cells
/// at creases of more than 10 degrees.
constexpr double kNearness = 1e-6;

/// Faces that meet at less than 40 degrees, as scallops do, are mostly curved: where they meet farther
/// outside than the slack (in cells) is uncertain, and cutting the ridge between neighbours costs little.
const double kSoftCos = std::cos(degToRad(40.0));
constexpr double kOutsideSlack = 0.05;

/// Vertices stay this far (in cells) inside their cell, so that those of neighbours never coincide, also as
/// floats.
constexpr double kWallGap = 1e-3;
/// Crossings of one sweep whose normals differ by more than 60 degrees belong to different faces of it.
constexpr double kSameFaceCos = 0.5;
/// Spread of the normals about an apex, and how near its tangent planes come to it (in cells).
const double kApexCos = std::cos(degToRad(30.0));
constexpr double kApexMiss = 2e-3;
/// Normals of a face that differ by less than this leave it flat: 0.2 degrees over a cell bend a plane by
/// less than 1e-3 cells.
constexpr double kFlatSpread = 3.5e-3;
/// Curvatures that the crossings leave open stay at zero; relative to what they fix.
constexpr double kOpenCurvature = 1e-3;

struct Face {
  std::uint64_t id;
  Vec3 first;  ///< normal of its first crossing
  Vec3 point, normal;
  int count;
  double spread;      ///< largest difference between its normals and the first
  Vec3 e1, e2, bend;  ///< curvature (11, 12, 22) in the tangent directions e1, e2; only if it is `curved`
  bool curved;
};
using Faces = std::array<Face, 12>;

struct Plane {
  Vec3 n;
  double d;  ///< n * x = d on it, x from the mean
};

bool belongs(const SheetPoint& s, const Face& f) {
  return s.face == f.id && f.first.dot(s.n) >= kSameFaceCos;
}

/// Height of `m` along `n` above the surface through the points (of one face, or of all).
double heightAbove(std::span<const SheetPoint> points, const Vec3& m, const Vec3& n, const Face* face) {
  double sum = 0.0;
  int count = 0;
  for (const SheetPoint& s : points) {
    if (face != nullptr && !belongs(s, *face)) continue;
    const Vec3 middle = s.n + n;
    sum += middle.dot(m - s.p) / std::max(0.1, middle.dot(n));
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

int collectFaces(std::span<const SheetPoint> points, Faces& faces) {
  int count = 0;
  for (const SheetPoint& s : points) {
    int i = 0;
    while (i < count && !belongs(s, faces[i])) ++i;
    Face& f = faces[i];
    if (i == count) {
      ++count;
      f.id = s.face;
      f.first = f.normal = s.n;
      f.point = s.p;
      f.count = 1;
      f.spread = 0.0;
      f.curved = false;
      continue;
    }
    f.point += s.p;
    f.normal += s.n;
    f.spread = std::max(f.spread, (s.n - f.first).squaredNorm());
    ++f.count;
  }
  for (int i = 0; i < count; ++i) {
    faces[i].point /= faces[i].count;
    faces[i].normal.normalize();
    faces[i].spread = std::sqrt(faces[i].spread);
  }
  return count;
}

/// Whether no two faces meet at more than the angle of this cosine.
bool alike(const Faces& faces, int count, double cosine) {
  for (int i = 1; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      if (faces[i].normal.dot(faces[j].normal) < cosine) return false;
    }
  }
  return true;
}

/// The face's curvature from the differences of its normals, by least squares.
void findCurvature(std::span<const SheetPoint> points, Face& f) {
  if (f.count < 2 || f.spread < kFlatSpread) return;
  f.curved = true;
  f.e1 = f.normal.unitOrthogonal();
  f.e2 = f.normal.cross(f.e1);
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  for (const SheetPoint& s : points) {
    if (!belongs(s, f)) continue;
    const Vec3 d = s.p - f.point, dn = s.n - f.normal;
    const double a1 = f.e1.dot(d), a2 = f.e2.dot(d), b1 = f.e1.dot(dn), b2 = f.e2.dot(dn);
    m(0, 0) += a1 * a1;
    m(0, 1) += a1 * a2;
    m(1, 1) += a1 * a1 + a2 * a2;
    m(2, 2) += a2 * a2;
    right += Vec3(b1 * a1, b1 * a2 + b2 * a1, b2 * a2);
  }
  m(1, 0) = m(1, 2) = m(2, 1) = m(0, 1);
  m.diagonal().array() += kOpenCurvature * m.trace() + 1e-12;
  f.bend = m.inverse() * right;
}

/// The plane that touches the face's quadratic surface above `x`; offsets are from `x`.
Plane planeAt(const Face& f, const Vec3& x) {
  const Vec3 d = x - f.point;
  double height = f.normal.dot(d);
  if (!f.curved) return {f.normal, -height};
  const double a1 = f.e1.dot(d), a2 = f.e2.dot(d);
  const double s1 = f.bend[0] * a1 + f.bend[1] * a2, s2 = f.bend[1] * a1 + f.bend[2] * a2;
  height += 0.5 * (s1 * a1 + s2 * a2);
  const Vec3 n = f.normal + s1 * f.e1 + s2 * f.e2;
  const double length = n.norm();
  return {n / length, -height / length};
}

/// The smallest step that minimises the distances to the planes, using directions in which they fix it.
Vec3 meetAny(std::span<const Plane> planes) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  for (const Plane& p : planes) {
    a += p.n * p.n.transpose();
    b += p.n * p.d;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(a);
  const double largest = solver.eigenvalues()[2];
  Vec3 x = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (value <= kRankTolerance * largest) continue;
    const Vec3 v = solver.eigenvectors().col(i);
    x += v * (v.dot(b) / value);
  }
  return x;
}

Vec3 meetPlanes(std::span<const Plane> planes) {
  if (planes.size() == 2) {
    const double c = planes[0].n.dot(planes[1].n), s2 = 1.0 - c * c;
    if (s2 > 4.0 * kRankTolerance) {
      return planes[0].n * ((planes[0].d - c * planes[1].d) / s2) +
             planes[1].n * ((planes[1].d - c * planes[0].d) / s2);
    }
  } else if (planes.size() == 3) {
    const Vec3 yz = planes[1].n.cross(planes[2].n), zx = planes[2].n.cross(planes[0].n),
               xy = planes[0].n.cross(planes[1].n);
    const double volume = planes[0].n.dot(yz);
    if (std::abs(volume) > 0.1) return (yz * planes[0].d + zx * planes[1].d + xy * planes[2].d) / volume;
  }
  return meetAny(planes);
}

double outsideBy(const Vec3& p) { return std::max(-p.minCoeff(), p.maxCoeff() - 1.0); }
Vec3 clampToCell(const Vec3& p) {
  return p.cwiseMax(Vec3::Constant(kWallGap)).cwiseMin(Vec3::Constant(1.0 - kWallGap));
}

/// Point of the cell that minimises the distances to the faces' planes; where they leave it free, the one
/// nearest to `from`. Each coordinate is free or at a wall; the best of the 27 cases that stays inside is the
/// minimum, since the function is convex.
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

/// The face of two on which the surface lies above or below `mean`: the lower one on a ridge, the higher one
/// in a valley. Always on the surface, off the crease.
Vec3 besideCrease(const Faces& faces, const Vec3& mean, const Vec3& n) {
  const Face &a = faces[0], &b = faces[1];
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

/// The point where the tangent planes of one face meet, if they lean widely and do meet in one.
bool findApex(std::span<const SheetPoint> points, const Vec3& mean, Vec3& apex) {
  double least = 1.0;
  std::array<Plane, 12> planes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].face != points[0].face) return false;
    least = std::min(least, points[0].n.dot(points[i].n));
    planes[i] = {points[i].n, points[i].n.dot(points[i].p - mean)};
  }
  if (least > kApexCos || points.size() < 4) return false;
  const std::span<const Plane> used(planes.data(), points.size());
  const Vec3 x = meetAny(used);
  for (const Plane& p : used) {
    if (std::abs(p.n.dot(x) - p.d) > kApexMiss) return false;
  }
  apex = mean + x;
  return outsideBy(apex) <= kVertexReach;
}

CellVertex smoothVertex(std::span<const SheetPoint> points, const Vec3& mean, const Vec3& sum) {
  CellVertex out;
  out.smooth = true;
  const double length = sum.norm();
  if (length < 1e-6 * static_cast<double>(points.size())) {
    out.p = out.inside = clampToCell(mean);
    return out;
  }
  const Vec3 n = sum / length;
  out.p = out.inside = clampToCell(mean - n * heightAbove(points, mean, n, nullptr));
  return out;
}

}  // namespace

CellVertex placeVertex(std::span<const SheetPoint> points) {
  Vec3 mean = Vec3::Zero(), sum = Vec3::Zero();
  for (const SheetPoint& s : points) {
    mean += s.p;
    sum += s.n;
  }
  mean /= static_cast<double>(points.size());
  CellVertex out;
  if (findApex(points, mean, out.p)) {
    // Outside, it is this cell's only if it pokes through one wall: into a cell that does not see it.
    const Vec3 kept = clampToCell(out.p);
    const int walls = static_cast<int>((kept.array() != out.p.array()).count());
    out.outside = walls == 1;
    out.inside = walls == 0 ? out.p : smoothVertex(points, mean, sum).p;
    if (walls > 1) out.p = out.inside;
    return out;
  }
  Faces faces;
  const int count = collectFaces(points, faces);
  if (count == 1 || alike(faces, count, kSmoothCos)) return smoothVertex(points, mean, sum);
  Vec3 x = mean;
  std::array<Plane, 12> planes;
  bool curved = false;
  for (int i = 0; i < count; ++i) {  // tangent planes touch the surface, not the chord
    Face& f = faces[i];
    if (f.count > 1) f.point -= f.normal * heightAbove(points, f.point, f.normal, &f);
    findCurvature(points, f);
    curved = curved || f.curved;
  }
  const std::span<const Plane> used(planes.data(), static_cast<std::size_t>(count));
  for (int round = 0; round < (curved ? 3 : 1); ++round) {
    for (int i = 0; i < count; ++i) planes[i] = planeAt(faces[i], x);
    x += meetPlanes(used);
    if (!(outsideBy(x) < 2.0)) break;
  }
  const double beyond = outsideBy(x);
  if (beyond <= -kWallGap) {
    out.p = out.inside = x;
    return out;
  }
  if (count == 2) {
    out.inside = besideCrease(faces, mean, sum.normalized());
  } else {
    for (int i = 0; i < count; ++i) planes[i] = planeAt(faces[i], mean);
    out.inside = meetPlanesInside(used, mean);
  }
  out.inside = clampToCell(out.inside);
  const double reach = alike(faces, count, kSoftCos) ? kOutsideSlack : kVertexReach;
  out.outside = beyond <= reach;
  out.p = out.outside ? x : out.inside;
  return out;
}

}  // namespace proveout
