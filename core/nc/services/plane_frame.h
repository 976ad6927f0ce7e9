// Working plane as an axis permutation: every planar service computes in (u, v, w) and knows no axis letters.
#pragma once

#include "core/geometry/types.h"

namespace proveout {

/// The three main planes; G17, G18, G19 of most controls.
enum class Plane { kXY, kZX, kYZ };

/// First axis u, second axis v, drill axis w. The permutation is cyclic, so (u, v, w) is right-handed in
/// every plane and "counter-clockwise" always turns from +u to +v.
class PlaneFrame {
 public:
  constexpr explicit PlaneFrame(Plane plane = Plane::kXY)
      : plane_(plane),
        u_(plane == Plane::kXY   ? 0
           : plane == Plane::kZX ? 2
                                 : 1) {}

  constexpr Plane plane() const { return plane_; }
  /// Index (0 X, 1 Y, 2 Z) of the axis that is u, v, w.
  constexpr int u() const { return u_; }
  constexpr int v() const { return (u_ + 1) % 3; }
  constexpr int w() const { return (u_ + 2) % 3; }

  /// (x, y, z) to (u, v, w); same units. Works for points and for vectors.
  Vec3 toPlane(const Vec3& xyz) const { return {xyz[u()], xyz[v()], xyz[w()]}; }
  /// (u, v, w) to (x, y, z).
  Vec3 fromPlane(const Vec3& uvw) const {
    Vec3 xyz;
    xyz[u()] = uvw[0];
    xyz[v()] = uvw[1];
    xyz[w()] = uvw[2];
    return xyz;
  }
  /// Unit vector of w in (x, y, z).
  Vec3 normal() const { return Vec3::Unit(w()); }

 private:
  Plane plane_;
  int u_;
};

}  // namespace proveout
