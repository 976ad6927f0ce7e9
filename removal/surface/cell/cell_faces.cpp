#include "removal/surface/cell/cell_faces.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace proveout {

namespace {

/// Directions in which the tangent planes determine a point worse than this (relative eigenvalue) are left
/// free.
constexpr double kRankTolerance = 1e-3;
/// The same for two planes alone: they meet from 1.8 degrees on; faces that lean less are one smooth surface
/// anyhow. With the value above they would meet from 3.6 degrees on only, and a vertex between two cones lay
/// half way between them, 3 micrometres off both.
constexpr double kPairTolerance = 2.5e-4;
/// A face whose normals differ by less than this counts as flat: 0.2 degrees over a cell bend it by less
/// than 1e-3 cells.
constexpr double kFlatSpread = 3.5e-3;
/// Weight that keeps curvatures at zero where the crossings leave them open, relative to what they
/// determine.
constexpr double kOpenCurvature = 1e-3;
/// Crossings show how a face bends across their line only if they are off it by a seventh of their
/// distances.
constexpr double kSpreadAcross = 0.02;

bool belongs(const SheetPoint& s, const CellFace& f) {
  return s.face == f.id && f.first.dot(s.n) >= f.same_cos;
}

}  // namespace

double heightAbove(std::span<const SheetPoint> points, const Vec3& m, const Vec3& n, const CellFace* face) {
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

int collectFaces(std::span<const SheetPoint> points, double same_cos, Faces& faces) {
  int count = 0;
  for (const SheetPoint& s : points) {
    int i = 0;
    while (i < count && !belongs(s, faces[i])) ++i;
    CellFace& f = faces[i];
    if (i == count) {
      ++count;
      f.id = s.face;
      f.first = f.normal = s.n;
      f.point = s.p;
      f.count = 1;
      f.spread = 0.0;
      f.curved = f.bend_seen = false;
      f.same_cos = same_cos;
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

void findCurvature(std::span<const SheetPoint> points, CellFace& f) {
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
  const double around = m(0, 0) + m(2, 2);
  f.bend_seen = m(0, 0) * m(2, 2) - m(0, 1) * m(0, 1) > kSpreadAcross * around * around;
  m(1, 0) = m(1, 2) = m(2, 1) = m(0, 1);
  m.diagonal().array() += kOpenCurvature * m.trace() + 1e-12;
  f.bend = m.inverse() * right;
}

Plane planeAt(const CellFace& f, const Vec3& x) {
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

Vec3 meetAny(std::span<const Plane> planes) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  for (const Plane& p : planes) {
    a += p.n * p.n.transpose();
    b += p.n * p.d;
  }
  // The least eigenvalue times the square of half the trace is no less than the determinant.
  const double trace = a.trace(), determinant = a.determinant();
  if (determinant > 0.25 * kRankTolerance * trace * trace * trace) return a.inverse() * b;
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
    // Along the sum of the normals and along their difference.
    const Vec3 sum = planes[0].n + planes[1].n, difference = planes[0].n - planes[1].n;
    const double s2 = sum.squaredNorm(), d2 = difference.squaredNorm(),
                 least = kPairTolerance * std::max(s2, d2);
    Vec3 x = Vec3::Zero();
    if (s2 > least) x += sum * ((planes[0].d + planes[1].d) / s2);
    if (d2 > least) x += difference * ((planes[0].d - planes[1].d) / d2);
    return x;
  }
  if (planes.size() == 3) {
    const Vec3 yz = planes[1].n.cross(planes[2].n), zx = planes[2].n.cross(planes[0].n),
               xy = planes[0].n.cross(planes[1].n);
    const double volume = planes[0].n.dot(yz);
    if (std::abs(volume) > 0.1) return (yz * planes[0].d + zx * planes[1].d + xy * planes[2].d) / volume;
  }
  return meetAny(planes);
}

}  // namespace proveout
