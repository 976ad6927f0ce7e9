// Rigid motions of space: a turn, then a shift.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/geometry/degrees.h"
#include "core/geometry/types.h"

namespace proveout {

/// Takes a point p to rotation * p + translation, mm.
struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< orthogonal, determinant 1
  Vec3 translation = Vec3::Zero();                         ///< mm

  Vec3 operator()(const Vec3& p) const { return rotation * p + translation; }
  RigidTransform inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
  /// `first`, then this one.
  RigidTransform operator*(const RigidTransform& first) const {
    return {rotation * first.rotation, (*this)(first.translation)};
  }
  /// Bounds of a moved box.
  Box3 operator()(const Box3& box) const {
    const Vec3 center = (*this)(box.center()), half = rotation.cwiseAbs() * (0.5 * box.size());
    return {center - half, center + half};
  }
};

/// Cosine and sine of an angle in degrees; exact at multiples of 90.
inline Vec2 cosSinDeg(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  if (turn == 0.0) return {1, 0};
  if (turn == 90.0) return {0, 1};
  if (turn == -90.0) return {0, -1};
  if (std::abs(turn) == 180.0) return {-1, 0};
  return {std::cos(degToRad(turn)), std::sin(degToRad(turn))};
}

/// Turn about an axis through the origin (any length above 0), right-hand rule. Entries that are 0 or 1 in
/// exact arithmetic are so here for the coordinate axes and multiples of 90 degrees.
inline Eigen::Matrix3d rotationAbout(const Vec3& axis, double degrees) {
  const Vec3 a = axis.normalized();
  const Vec2 cs = cosSinDeg(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return cs.x() * Eigen::Matrix3d::Identity() + cs.y() * cross + (1.0 - cs.x()) * (a * a.transpose());
}

/// Turn about a unit axis through the origin, right-hand rule; as exact as sinCosDegrees().
inline Eigen::Matrix3d turnAbout(const Vec3& unit, double degrees) {
  const auto [s, c] = sinCosDegrees(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -unit.z(), unit.y(), unit.z(), 0, -unit.x(), -unit.y(), unit.x(), 0;
  return Eigen::Matrix3d::Identity() * c + cross * s + unit * unit.transpose() * (1.0 - c);
}

/// Turns about the fixed X axis, then the fixed Y axis, then the fixed Z axis, degrees.
inline Eigen::Matrix3d rotationXyzDeg(const Vec3& degrees) {
  return rotationAbout(Vec3::UnitZ(), degrees.z()) * rotationAbout(Vec3::UnitY(), degrees.y()) *
         rotationAbout(Vec3::UnitX(), degrees.x());
}

}  // namespace proveout
