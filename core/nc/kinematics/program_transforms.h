// Mirroring, scaling and rotation of programmed points.
#pragma once

#include <array>
#include <cstdint>

#include "core/machine/axis_point.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/services/plane_frame.h"

namespace proveout::nc {

using Mat3 = Eigen::Matrix3d;

/// What a program has switched on. Mirroring is always outermost; of rotation and scaling the one that came
/// later is inside: its centre is a point of what the other one transforms. Lengths mm.
struct Transforms {
  AxisSet mirrored;
  AxisPoint mirror;  ///< of each mirrored axis the value that stays

  bool rotates = false;
  std::int8_t rotation_u = 0, rotation_v = 1;  ///< axes of the plane that is rotated
  Vec2 pivot = Vec2::Zero();                   ///< (u, v) of that plane
  double angle_deg = 0.0;                      ///< > 0 from u to v
  bool pivot_is_scaled = false;  ///< the pivot is a programmed point: scaling takes it along, and comes first

  bool scales = false;
  bool scales_further = false;    ///< linear axes besides X Y Z take the factor of X
  std::int8_t virtual_axis = -1;  ///< a rotary axis that counts in mm takes it too; -1: none
  AxisPoint scale_center;
  Vec3 factors = Vec3::Ones();  ///< of X Y Z; negative ones mirror, none is 0
  bool mirrors_last = false;    ///< negative factors mirror about the centre outside of the rotation

  bool rotation_inside = false;  ///< where both are on
  /// For controls that tell who ends them out of turn: what is on, in the order in which it came.
  enum class Kind : std::int8_t { kNone, kMirror, kScaling, kRotation };
  std::array<Kind, 3> nested{};

  bool any() const { return rotates || scales || mirrored.any(); }
};

/// The transforms as an affine map: X Y Z by a matrix, further axes each by a factor.
struct ProgramMap {
  bool identity = true;
  Mat3 linear = Mat3::Identity();
  Vec3 offset = Vec3::Zero();
  std::array<double, kMaxAxes - kMainAxes> factor{}, shift{};
  Vec3 factors = Vec3::Ones();  ///< those of scaling, as Transforms has them

  /// A rotation of a plane with an axis besides X Y Z takes the plane's two axes together: for them this
  /// holds and what is said above does not. u < 0: there is none.
  struct Pair {
    int u = -1, v = -1;
    Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
    Vec2 offset = Vec2::Zero();
    Vec2 of(const AxisPoint& p) const { return {p[u], p[v]}; }
  };
  Pair pair;

  /// Where the map takes a point, and a difference of points.
  AxisPoint image(const AxisPoint& p) const;
  AxisPoint turned(const AxisPoint& d) const;
  /// -1 if the map turns the sense of rotation in the plane, else 1.
  double sense(const WorkPlane& plane) const;
  /// Factor of radii that the map itself leaves circles: that of the first axis of the plane.
  double radiusFactor(const WorkPlane& plane) const;
  /// The larger of the factors of the plane's axes.
  double largestFactor(const WorkPlane& plane) const;
  /// Factor of chamfers and roundings: the mean of the plane's axes.
  double joinFactor(const WorkPlane& plane) const;
  /// Circles of the plane become ellipses: arcs have to be made anew.
  bool unequal(const WorkPlane& plane) const;
};
/// `axes` tells which further axes are linear.
ProgramMap programMap(const Transforms& transforms, const AxisTable& axes);

}  // namespace proveout::nc
