// Points in all axes of a machine, as one channel moves it.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>

#include "core/geometry/types.h"

namespace proveout {

/// Axes that a channel may have: X, Y, Z are 0, 1, 2. As many as there are letters for axes; points of all
/// axes are copied in every block, so that each one more costs time.
inline constexpr int kMaxAxes = 9;
inline constexpr int kMainAxes = 3;

/// "Axes with a word", mirrored axes and the like, by index.
using AxisSet = std::bitset<kMaxAxes>;

/// A point in all axes of a channel: mm, rotary axes degrees.
struct AxisPoint {
  Vec3 xyz = Vec3::Zero();
  std::array<double, kMaxAxes - kMainAxes> more{};

  AxisPoint() = default;
  AxisPoint(double x, double y, double z) : xyz(x, y, z) {}
  template <class Derived>
  AxisPoint(const Eigen::MatrixBase<Derived>& point) : xyz(point) {}  // NOLINT: most points have three axes
  double& operator[](int axis) {
    return axis < kMainAxes ? xyz[axis] : more[static_cast<std::size_t>(axis - kMainAxes)];
  }
  double operator[](int axis) const {
    return axis < kMainAxes ? xyz[axis] : more[static_cast<std::size_t>(axis - kMainAxes)];
  }
};
inline bool operator==(const AxisPoint& a, const AxisPoint& b) { return a.xyz == b.xyz && a.more == b.more; }
template <class Derived>
bool operator==(const AxisPoint& a, const Eigen::MatrixBase<Derived>& b) {
  return a == AxisPoint(b);
}

/// All axes at a share of the straight way from `a` to `b`; `b` itself from 1 on.
inline AxisPoint between(const AxisPoint& a, const AxisPoint& b, double share) {
  if (share >= 1.0) return b;
  AxisPoint p;
  for (int k = 0; k < kMaxAxes; ++k) p[k] = a[k] + (b[k] - a[k]) * share;
  return p;
}

}  // namespace proveout
