// Geometric types shared by every library. Lengths in mm, angles in radians unless a name says _deg.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <numbers>

namespace proveout {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

inline constexpr double kPi = std::numbers::pi;
inline constexpr double degToRad(double degrees) { return degrees * (kPi / 180.0); }
inline constexpr double radToDeg(double radians) { return radians * (180.0 / kPi); }

/// Axis-aligned box, mm. Default is empty (min > max).
struct Box3 {
  Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

  bool empty() const { return (min.array() > max.array()).any(); }
  Vec3 size() const { return max - min; }
  Vec3 center() const { return 0.5 * (min + max); }
  void extend(const Vec3& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  void extend(const Box3& b) {
    min = min.cwiseMin(b.min);
    max = max.cwiseMax(b.max);
  }
  Box3 inflated(double by) const { return {min - Vec3::Constant(by), max + Vec3::Constant(by)}; }
  bool overlaps(const Box3& b) const {
    return (min.array() <= b.max.array()).all() && (b.min.array() <= max.array()).all();
  }
};

}  // namespace proveout
