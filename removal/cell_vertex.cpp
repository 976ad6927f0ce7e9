#include "removal/cell_vertex.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
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

/// Faces that meet at less than 40 degrees, as scallops do, are mostly curved: their tangent planes say
/// little outside the cell. Where they meet farther outside than the slack (in cells), only what they agree
/// on counts. Measured on bear.nc at 0.25 mm: followed out of the cell they leave the part 0.02 % below the
/// volume that finer grids tend to.
const double kSoftCos = std::cos(degToRad(40.0));
constexpr double kOutsideSlack = 0.05;
/// The rank tolerance then: only what the planes agree on moves the vertex off the mean.
constexpr double kSoftRankTolerance = 0.1;

/// How far (in cells) the best point inside may be off a face before more room is asked for. Less is left
/// alone: tangent planes of curved faces are that far off their surfaces when they are followed out of the
/// cell.
constexpr double kCramped = 0.05;

/// Vertices stay this far (in cells) inside their cell, so that those of neighbours never coincide, also as
/// floats.
constexpr double kWallGap = 1e-3;
/// Crossings of one sweep whose normals differ by more than 60 degrees belong to different faces of it.
constexpr double kSameFaceCos = 0.5;

struct Face {
  std::uint64_t id = 0;
  Vec3 first = Vec3::Zero();  ///< normal of its first crossing
  Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
  int count = 0;
};

/// Height of `m` along `n` above the surface through the points (of one face, or of all).
template <typename Points>
double heightAbove(const Points& points, const Vec3& m, const Vec3& n, const Face* face) {
  double sum = 0.0;
  int count = 0;
  for (const SheetPoint& s : points) {
    if (face != nullptr && (s.face != face->id || face->first.dot(s.n) < kSameFaceCos)) continue;
    const Vec3 middle = (s.n + n).normalized();
    sum += middle.dot(m - s.p) / std::max(0.2, middle.dot(n));
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

int collectFaces(std::span<const SheetPoint> points, std::array<Face, 12>& faces) {
  int count = 0;
  for (const SheetPoint& s : points) {
    int i = 0;
    while (i < count && (faces[i].id != s.face || faces[i].first.dot(s.n) < kSameFaceCos)) ++i;
    if (i == count) {
      if (count == static_cast<int>(faces.size())) continue;
      faces[count++] = Face{s.face, s.n, Vec3::Zero(), Vec3::Zero(), 0};
    }
    faces[i].point += s.p;
    faces[i].normal += s.n;
    ++faces[i].count;
  }
  for (int i = 0; i < count; ++i) {
    faces[i].point /= faces[i].count;
    const double length = faces[i].normal.norm();
    faces[i].normal = length > 1e-6 ? Vec3(faces[i].normal / length) : points[0].n;
  }
  return count;
}

/// Whether no two faces meet at more than the angle of this cosine.
bool alike(const std::array<Face, 12>& faces, int count, double cosine) {
  for (int i = 1; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      if (faces[i].normal.dot(faces[j].normal) < cosine) return false;
    }
  }
  return true;
}

/// Point nearest to `from` that minimises the distances to the faces' planes, using directions above
/// `tolerance`.
Vec3 meetPlanes(const std::array<Face, 12>& faces, int count, const Vec3& from, double tolerance) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const Vec3& n = faces[i].normal;
    a += n * n.transpose();
    b += n * n.dot(faces[i].point - from);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  const double largest = solver.eigenvalues()[2];
  Vec3 x = from;
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (value <= tolerance * largest) continue;
    const Vec3 v = solver.eigenvectors().col(i);
    x += v * (v.dot(b) / value);
  }
  return x;
}

double outsideBy(const Vec3& p, const Box3& room) {
  return std::max({0.0, (room.min - p).maxCoeff(), (p - room.max).maxCoeff()});
}

Vec3 clampTo(const Vec3& p, const Box3& room) {
  return p.cwiseMax(room.min + Vec3::Constant(kWallGap)).cwiseMin(room.max - Vec3::Constant(kWallGap));
}

/// Point of the room that minimises the distances to the faces' planes; where they leave it free, the one
/// nearest to `from`. A crease that only clips the cell is met inside it. Each coordinate is free or at a
/// wall; the best of the 27 cases that stays inside is the minimum, since the function is convex.
Vec3 meetPlanesInside(const std::array<Face, 12>& faces, int count, const Vec3& from, const Box3& room) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Identity() * kNearness;
  Vec3 b = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const Vec3& n = faces[i].normal;
    a += n * n.transpose();
    b += n * n.dot(faces[i].point - from);
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
      rhs[k] = (at[k] == 1 ? room.min[k] : room.max[k]) - from[k];
    }
    const Vec3 x = m.partialPivLu().solve(rhs);
    const double value = x.dot(a * x) - 2.0 * x.dot(b);
    if (outsideBy(from + x, room) <= 1e-9 && value < least) {
      least = value;
      best = from + x;
    }
  }
  return best;
}

double farthestPlane(const std::array<Face, 12>& faces, int count, const Vec3& p) {
  double farthest = 0.0;
  for (int i = 0; i < count; ++i)
    farthest = std::max(farthest, std::abs(faces[i].normal.dot(p - faces[i].point)));
  return farthest;
}

}  // namespace

const Vec3& CellVertex::normalOf(std::uint64_t id, const Vec3& fallback) const {
  for (int i = 0; i < faces; ++i) {
    if (face[i] == id) return normal[i];
  }
  return fallback;
}

CellVertex placeVertex(std::span<const SheetPoint> points, const Box3& room) {
  CellVertex out;
  Vec3 mean = Vec3::Zero(), mean_normal = Vec3::Zero();
  for (const SheetPoint& s : points) {
    mean += s.p;
    mean_normal += s.n;
  }
  mean /= static_cast<double>(points.size());
  std::array<Face, 12> faces;
  const int count = collectFaces(points, faces);
  out.faces = std::min(count, CellVertex::kMaxFaces);
  for (int i = 0; i < out.faces; ++i) {
    out.face[i] = faces[i].id;
    out.normal[i] = faces[i].normal;
  }
  const double length = mean_normal.norm();
  const auto smooth = [&] {
    if (length < 1e-6 * static_cast<double>(points.size())) return mean;
    const Vec3 n = mean_normal / length;
    return Vec3(mean - n * heightAbove(points, mean, n, nullptr));
  };
  if (count == 1 || alike(faces, count, kSmoothCos)) {
    out.smooth = true;
    out.p = clampTo(smooth(), room);
    return out;
  }
  for (int i = 0; i < count; ++i) {  // tangent planes touch the surface, not the chord
    Face& f = faces[i];
    f.point -= f.normal * heightAbove(points, f.point, f.normal, &f);
  }
  Vec3 x = meetPlanes(faces, count, mean, kRankTolerance);
  if (outsideBy(x, room) > kOutsideSlack && alike(faces, count, kSoftCos)) {
    x = meetPlanes(faces, count, mean, kSoftRankTolerance);
    if (outsideBy(x, room) > kOutsideSlack) x = mean;
  } else if (outsideBy(x, room) > kWallGap) {
    x = meetPlanesInside(faces, count, mean, room);
    out.cramped = farthestPlane(faces, count, x) > kCramped;
  }
  out.p = clampTo(x, room);
  return out;
}

}  // namespace proveout
