#include "removal/compare/features/dimensions.h"

#include <Eigen/Geometry>
#include <cmath>

namespace proveout {
namespace dimension_detail {

/// An axis that runs along a plane does not meet it.
constexpr double kParallel = 1e-3;

/// Where a line meets a plane, from `p`, mm.
std::optional<double> toPlane(const CadFace& plane, const Vec3& p, const Vec3& direction) {
  const double slope = plane.axis.dot(direction);
  if (std::abs(slope) < kParallel) return std::nullopt;
  return (plane.origin - p).dot(plane.axis) / slope;
}

/// Where on its axis a hole of the radius ends at a face, from `p`: on the plane, where it becomes the cone
/// of a drill's tip, at the middle of a round end.
std::optional<double> levelAt(const CadFace& end, const Vec3& p, const Vec3& direction, double radius) {
  switch (end.kind) {
    case SurfaceKind::kPlane:
      return toPlane(end, p, direction);
    case SurfaceKind::kCone: {
      const double slope = std::tan(end.half_angle_rad);
      if (slope < kParallel) return std::nullopt;
      const Vec3 at = end.origin + (radius - end.radius) / slope * end.axis;
      return (at - p).dot(direction);
    }
    case SurfaceKind::kSphere:
    case SurfaceKind::kTorus:
      return (end.origin - p).dot(direction);
    default:
      return std::nullopt;
  }
}

/// The axis of a round at the height of `at`.
Vec3 axisAt(const CadFace& round, const Vec3& at) {
  if (round.kind == SurfaceKind::kSphere || round.kind == SurfaceKind::kTorus) return round.origin;
  return round.origin + (at - round.origin).dot(round.axis) * round.axis;
}

/// Place of planes along a direction through `at`, the mean of two; of rounds the axis. mm from `at`.
std::optional<double> placeAlong(const Characteristic& c, const FaceAt& face, const Vec3& direction) {
  const CadFace& first = face(c.faces[0]);
  if (first.kind != SurfaceKind::kPlane) return (axisAt(first, c.at) - c.at).dot(direction);
  double sum = 0.0;
  for (const std::uint32_t f : c.faces) {
    const auto t = toPlane(face(f), c.at, direction);
    if (!t) return std::nullopt;
    sum += *t;
  }
  return sum / static_cast<double>(c.faces.size());
}

std::optional<double> depthOf(const Characteristic& c, const FaceAt& face) {
  const CadFace& axis = face(c.faces[0]);
  const Vec3 p = axisAt(axis, c.at);
  const auto from = levelAt(face(c.faces[1]), p, axis.axis, axis.radius),
             to = levelAt(face(c.faces[2]), p, axis.axis, axis.radius);
  if (!from || !to) return std::nullopt;
  return std::abs(*to - *from);
}

std::optional<double> betweenPlanes(const Characteristic& c, const FaceAt& face) {
  const Vec3 direction = (c.to - c.from).normalized();
  const auto from = toPlane(face(c.faces[0]), c.at, direction),
             to = toPlane(face(c.faces[1]), c.at, direction);
  if (!from || !to) return std::nullopt;
  return std::abs(*to - *from);
}

std::optional<double> coneDiameter(const CadFace& cone, const CadFace& plane) {
  const auto t = toPlane(plane, cone.origin, cone.axis);
  if (!t) return std::nullopt;
  return 2.0 * (cone.radius + *t * std::tan(cone.half_angle_rad));
}

double angleOf(const CadFace& face) {
  if (face.kind == SurfaceKind::kCone) return radToDeg(2.0 * face.half_angle_rad);
  return radToDeg(std::atan2(face.axis.head<2>().norm(), std::abs(face.axis.z())));
}

}  // namespace dimension_detail

std::optional<double> valueOf(const Characteristic& c, const FaceAt& face) {
  using namespace dimension_detail;
  const CadFace& first = face(c.faces[0]);
  switch (c.quantity) {
    case Quantity::kDiameter:
      return 2.0 * first.radius;
    case Quantity::kConeDiameter:
      return coneDiameter(first, face(c.faces[1]));
    case Quantity::kRadius:
      return first.kind == SurfaceKind::kTorus ? first.tube_radius : first.radius;
    case Quantity::kX:
    case Quantity::kY:
    case Quantity::kZ: {
      const int k = static_cast<int>(c.quantity) - static_cast<int>(Quantity::kX);
      const auto place = placeAlong(c, face, Vec3::Unit(k));
      return place ? std::optional(c.at[k] + *place) : std::nullopt;
    }
    case Quantity::kOffset:
      return placeAlong(c, face, (c.to - c.from).normalized());
    case Quantity::kDepth:
      return c.faces.size() == 2 ? betweenPlanes(c, face) : depthOf(c, face);
    case Quantity::kHeight:
    case Quantity::kWidth:
    case Quantity::kLength:
      return betweenPlanes(c, face);
    case Quantity::kAngle:
      return angleOf(first);
    case Quantity::kPerpendicularity:
      return (c.to - c.from).norm() * first.axis.cross(face(c.faces[1]).axis).norm();
    default:
      return 0.0;
  }
}

double positionOf(const Characteristic& c, const CadFace& model, const CadFace& fitted) {
  using namespace dimension_detail;
  double most = 0.0;
  for (const Vec3& end : {c.from, c.to})
    most = std::max(most, (axisAt(fitted, end) - axisAt(model, end)).norm());
  return 2.0 * most;
}

}  // namespace proveout
