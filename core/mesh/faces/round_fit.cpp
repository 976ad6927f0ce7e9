#include "core/mesh/faces/round_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace proveout {
namespace round_detail {

/// The direction in which a symmetric matrix is least, and by how much less than the next one.
struct LeastDirection {
  Vec3 along = Vec3::UnitZ();
  double least = 0.0, next = 0.0;
};
LeastDirection leastOf(const Eigen::Matrix3d& m) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(m);
  return {solver.eigenvectors().col(0), solver.eigenvalues()[0], solver.eigenvalues()[1]};
}

std::vector<Eigen::Vector2d> flattened(std::span<const Vec3> points, const Vec3& from, const Vec3& u,
                                       const Vec3& v) {
  std::vector<Eigen::Vector2d> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.emplace_back((p - from).dot(u), (p - from).dot(v));
  return out;
}

Vec3 meanOf(std::span<const Vec3> points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// The normals of a cylinder's facets lie in the plane across its axis.
std::optional<CadFace> guessCylinder(const FlatFacets& facets, std::span<const std::uint32_t> of,
                                     std::span<const Vec3> points) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (const std::uint32_t f : of) m += facets[f].normal * facets[f].normal.transpose();
  const LeastDirection axis = leastOf(m);
  if (!(axis.next > 1e-6)) return std::nullopt;
  CadFace out;
  out.kind = SurfaceKind::kCylinder;
  out.axis = axis.along;
  const Vec3 u = out.axis.unitOrthogonal(), v = out.axis.cross(u), mean = meanOf(points);
  const auto circle = circleNear(flattened(points, mean, u, v));
  if (!circle) return std::nullopt;
  out.origin = mean + circle->centre.x() * u + circle->centre.y() * v;
  out.radius = circle->radius;
  return out;
}

/// Those of a cone's facets lean to the axis alike, and their planes meet in its tip.
std::optional<CadFace> guessCone(const FlatFacets& facets, std::span<const std::uint32_t> of,
                                 std::span<const Vec3> points) {
  Vec3 mean_normal = Vec3::Zero(), b = Vec3::Zero();
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero(), planes = Eigen::Matrix3d::Zero();
  const Vec3 from = meanOf(points);
  for (const std::uint32_t f : of) {
    const Vec3& n = facets[f].normal;
    mean_normal += n / static_cast<double>(of.size());
    planes += n * n.transpose();
    b += n.dot(facets[f].middle - from) * n;
  }
  for (const std::uint32_t f : of) {
    const Vec3 off = facets[f].normal - mean_normal;
    m += off * off.transpose();
  }
  const LeastDirection axis = leastOf(m);
  constexpr double kClear = 1e-7;  // else it is a cylinder's, as far as these few say
  if (!(axis.next > kClear) || !(leastOf(planes).least > 1e-9)) return std::nullopt;
  const Vec3 tip = from + planes.ldlt().solve(b);
  CadFace out;
  out.kind = SurfaceKind::kCone;
  const Vec3 to = from - tip;
  out.axis = axis.along.dot(to) < 0.0 ? Vec3(-axis.along) : axis.along;
  double sum = 0.0;
  for (const Vec3& p : points) {
    const double along = (p - tip).dot(out.axis);
    sum += std::atan2((p - tip - along * out.axis).norm(), along) / static_cast<double>(points.size());
  }
  if (!(sum > 1e-4 && sum < 0.5 * kPi - 1e-4)) return std::nullopt;
  out.half_angle_rad = sum;
  const double height = to.dot(out.axis);
  out.origin = tip + height * out.axis;
  out.radius = height * std::tan(sum);
  return out;
}

std::optional<CadFace> guessSphere(std::span<const Vec3> points) {
  const Vec3 mean = meanOf(points);
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    const Eigen::Vector4d row(2.0 * d.x(), 2.0 * d.y(), 2.0 * d.z(), 1.0);
    m += row * row.transpose();
    b += d.squaredNorm() * row;
  }
  const Eigen::Vector4d x = m.ldlt().solve(b);
  const double square = x[3] + x.head<3>().squaredNorm();
  if (!x.allFinite() || !(square > 0.0)) return std::nullopt;
  CadFace out;
  out.kind = SurfaceKind::kSphere;
  out.origin = mean + x.head<3>();
  out.radius = std::sqrt(square);
  return out;
}

/// Normals of a face of revolution all meet its axis: the line whose moment about them is least.
std::optional<CadFace> guessTorus(const FlatFacets& facets, std::span<const std::uint32_t> of,
                                  std::span<const Vec3> points) {
  const Vec3 from = meanOf(points);
  Eigen::Matrix3d aa = Eigen::Matrix3d::Zero(), ab = aa, bb = aa;
  for (const std::uint32_t f : of) {
    const Vec3& n = facets[f].normal;
    const Vec3 moment = (facets[f].middle - from).cross(n);
    aa += moment * moment.transpose();
    ab += moment * n.transpose();
    bb += n * n.transpose();
  }
  if (!(leastOf(bb).least > 1e-9)) return std::nullopt;
  const Eigen::Matrix3d by = bb.ldlt().solve(ab.transpose());
  CadFace out;
  out.kind = SurfaceKind::kTorus;
  out.axis = leastOf(aa - ab * by).along;
  const Vec3 speed = -by * out.axis;
  const Vec3 on_axis = from + out.axis.cross(speed);
  std::vector<Eigen::Vector2d> profile;
  for (const Vec3& p : points) {
    const double along = (p - on_axis).dot(out.axis);
    profile.emplace_back((p - on_axis - along * out.axis).norm(), along);
  }
  const auto circle = circleNear(profile);
  if (!circle) return std::nullopt;
  out.origin = on_axis + circle->centre.y() * out.axis;
  out.radius = circle->centre.x();
  out.tube_radius = circle->radius;
  return out;
}

constexpr int kMostFree = 7;
using Row = Eigen::Matrix<double, kMostFree, 1>;
using Square = Eigen::Matrix<double, kMostFree, kMostFree>;

/// A face and the directions that it can be moved in; lengths in units of the points' spread.
struct Movable {
  CadFace face;
  Vec3 u, v, middle;
  bool turns = false;
  int size = 0;

  Movable(const CadFace& of, const Vec3& about, bool may_turn) : face(of), middle(about) {
    const bool sphere = of.kind == SurfaceKind::kSphere;
    turns = may_turn && !sphere;
    size = 3 + (turns ? 2 : 0) + (of.kind == SurfaceKind::kCone ? 1 : 0) +
           (of.kind == SurfaceKind::kTorus ? 2 : 0) + (sphere ? 1 : 0);
    u = of.axis.unitOrthogonal();
    v = of.axis.cross(u);
  }

  /// How the distance of a point goes with what is free; returns the distance.
  double row(const Vec3& p, Row& out) const {
    const Vec3 n = face.normalAt(p);
    int k = 0;
    out[k++] = -n.dot(u);
    out[k++] = -n.dot(v);
    if (face.kind == SurfaceKind::kSphere || face.kind == SurfaceKind::kTorus) out[k++] = -n.dot(face.axis);
    const Vec3 from = p - face.origin;
    const double along = from.dot(face.axis);
    switch (face.kind) {
      case SurfaceKind::kCone: {
        const double across = (from - along * face.axis).norm();
        out[k++] = -std::cos(face.half_angle_rad);
        out[k++] =
            -(across - face.radius) * std::sin(face.half_angle_rad) - along * std::cos(face.half_angle_rad);
        break;
      }
      case SurfaceKind::kTorus: {
        const Vec3 radial = from - along * face.axis;
        out[k++] = radial.norm() > 0.0 ? -n.dot(radial.normalized()) : 0.0;
        out[k++] = -1.0;
        break;
      }
      default:
        out[k++] = -1.0;
        break;
    }
    if (turns) {
      const Vec3 moment = (p - middle).cross(n);
      out[k++] = -moment.dot(u);
      out[k++] = -moment.dot(v);
    }
    return face.distance(p);
  }

  CadFace moved(const Row& by) const {
    CadFace out = face;
    int k = 0;
    out.origin += by[0] * u + by[1] * v;
    k = 2;
    if (face.kind == SurfaceKind::kSphere || face.kind == SurfaceKind::kTorus)
      out.origin += by[k++] * face.axis;
    out.radius += by[k++];
    if (face.kind == SurfaceKind::kCone) out.half_angle_rad += by[k++];
    if (face.kind == SurfaceKind::kTorus) out.tube_radius += by[k++];
    if (turns) {
      const Vec3 turn = by[k] * u + by[k + 1] * v;
      const double angle = turn.norm();
      if (angle > 0.0) {
        const Eigen::AngleAxisd rotation(angle, turn / angle);
        out.origin = middle + rotation * (out.origin - middle);
        out.axis = (rotation * out.axis).normalized();
      }
    }
    return out;
  }
};

double squaresOf(std::span<const Vec3> points, const CadFace& face) {
  double sum = 0.0;
  for (const Vec3& p : points) {
    const double d = face.distance(p);
    sum += d * d;
  }
  return sum;
}

bool isSound(const CadFace& face) {
  constexpr double kMostRadius = 1e5;
  const bool finite = face.origin.allFinite() && face.axis.allFinite() && std::isfinite(face.radius);
  const bool torus = face.kind == SurfaceKind::kTorus;
  if (!finite || std::abs(face.radius) > kMostRadius) return false;
  if (torus) return face.tube_radius > 0.0 && face.tube_radius < kMostRadius && face.radius > 0.0;
  if (face.kind == SurfaceKind::kCone) return std::abs(face.half_angle_rad) < 0.5 * kPi - 1e-4;
  return face.radius > 0.0;
}

}  // namespace round_detail

std::size_t freedomOf(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::kCylinder:
      return 5;
    case SurfaceKind::kCone:
      return 6;
    case SurfaceKind::kSphere:
      return 4;
    case SurfaceKind::kTorus:
      return 7;
    default:
      return 3;
  }
}

std::optional<FlatCircle> circleNear(std::span<const Eigen::Vector2d> points) {
  if (points.size() < 3) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - mean;
    const Vec3 row(2.0 * d.x(), 2.0 * d.y(), 1.0);
    m += row * row.transpose();
    b += d.squaredNorm() * row;
  }
  const Vec3 x = m.ldlt().solve(b);
  const double square = x[2] + x.head<2>().squaredNorm();
  if (!x.allFinite() || !(square > 0.0)) return std::nullopt;
  return FlatCircle{mean + x.head<2>(), std::sqrt(square)};
}

std::optional<CadFace> guessRound(SurfaceKind kind, const FlatFacets& facets,
                                  std::span<const std::uint32_t> of, std::span<const Vec3> points) {
  using namespace round_detail;
  switch (kind) {
    case SurfaceKind::kCylinder:
      return guessCylinder(facets, of, points);
    case SurfaceKind::kCone:
      return guessCone(facets, of, points);
    case SurfaceKind::kSphere:
      return guessSphere(points);
    case SurfaceKind::kTorus:
      return guessTorus(facets, of, points);
    default:
      return std::nullopt;
  }
}

namespace round_detail {

bool fit(std::span<const Vec3> points, bool turns, CadFace& face) {
  constexpr int kSteps = 12;
  constexpr double kSettled = 1e-11, kMostDamping = 1e8;
  const Vec3 middle = meanOf(points);
  double size = 0.0;
  for (const Vec3& p : points) size = std::max(size, (p - middle).norm());
  // The axis is told where the points are: turning it does not move it away from them.
  if (face.kind == SurfaceKind::kCylinder || face.kind == SurfaceKind::kCone) {
    const double along = (middle - face.origin).dot(face.axis);
    face.origin += along * face.axis;
    if (face.kind == SurfaceKind::kCone) face.radius += along * std::tan(face.half_angle_rad);
  }
  if (!isSound(face) || !(size > 0.0)) return false;
  double squares = squaresOf(points, face), damping = 1e-6;
  const double at_rest = squares;
  for (int step = 0; step < kSteps; ++step) {
    const Movable movable(face, middle, turns);
    Square a = Square::Zero();
    Row b = Row::Zero(), row = Row::Zero();
    for (const Vec3& p : points) {
      const double d = movable.row(p, row);
      a.noalias() += row * row.transpose();
      b.noalias() -= d * row;
    }
    // Angles count by what they move at the points' rim.
    Row scale = Row::Ones();
    for (int k = 0; k < movable.size; ++k) scale[k] = a(k, k) > 0.0 ? 1.0 / std::sqrt(a(k, k)) : 1.0;
    const int n = movable.size;
    Square scaled = Square::Identity();
    Row by = Row::Zero();
    bool better = false;
    while (!better && damping < kMostDamping) {
      scaled = Square::Identity();
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) scaled(i, j) = a(i, j) * scale[i] * scale[j] + (i == j ? damping : 0.0);
      Row right = Row::Zero();
      for (int i = 0; i < n; ++i) right[i] = b[i] * scale[i];
      by = scaled.ldlt().solve(right);
      by = by.cwiseProduct(scale);
      const CadFace moved = movable.moved(by);
      const double now = by.allFinite() && isSound(moved) ? squaresOf(points, moved) : 1e300;
      better = now <= squares * (1.0 + 1e-12);
      if (better) {
        face = moved;
        const double before = squares;
        squares = now;
        damping = std::max(1e-15, 0.1 * damping);
        if (by.cwiseAbs().maxCoeff() <= kSettled * size || before - now <= 1e-14 * before + 1e-26)
          return true;
      } else {
        damping = std::max(1e-12, 10.0 * damping);
      }
    }
    if (!better) break;
  }
  return squares < at_rest || squares < 1e-20;
}

}  // namespace round_detail

bool fitRound(std::span<const Vec3> points, bool turns, CadFace& face) {
  const bool hollow = face.hollow;
  face.hollow = false;
  const bool good = round_detail::fit(points, turns, face);
  face.hollow = hollow;
  if (face.half_angle_rad < 0.0) {
    face.half_angle_rad = -face.half_angle_rad;
    face.axis = -face.axis;
  }
  return good;
}

}  // namespace proveout
