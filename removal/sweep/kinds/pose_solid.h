// Solids of revolution as the kernels of leaning tools take them.
#pragma once

#include "core/geometry/types.h"
#include "core/tool/profile.h"
#include "removal/sweep/column_types.h"

namespace proveout {

/// A tool whose axis rises less leaves rims that the kernels do not follow.
inline constexpr double kLeastAxisRise = 0.25;

/// What lies between two poses of a run and is covered by neither, mm: faces that bend by the least radius
/// leave no more where no point goes farther from one to the next than posesApart.
inline constexpr double kPosesMm = 5e-5;
double posesApart(const ConvexProfile& profile);

/// What the kernels know of a profile.
PoseSolid poseSolid(const ConvexProfile& profile);

inline PoseAt poseAt(const Vec3& tip, const Vec3& axis) {
  return {tip.x(), tip.y(), tip.z(), axis.x(), axis.y(), axis.z()};
}

/// Least radius at which faces of the profile bend around its axis, mm; 0: it has a point.
double leastRadius(const ConvexProfile& profile);

/// Least radius of the profile between its ends, mm: 0 where one of them is no disc.
double thinnestPart(const ConvexProfile& profile);

/// The view from a place on; `way`: of the tip, mm, workpiece frame.
AxialView axialView(const PoseAt& from, const Vec3& way);

}  // namespace proveout
