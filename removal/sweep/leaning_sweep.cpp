#include "removal/sweep/leaning_sweep.h"

#include "removal/sweep/convex_cast.h"

namespace proveout {

namespace {

Sweep innerSweep(const ConvexProfile& profile, const ToolFrame& frame, const Vec3& from, const Vec3& to,
                 const ArcGeometry* arc) {
  if (arc == nullptr) {
    const Vec3 start = frame.toTool(from);
    return {profile, start, start + frame.wayToTool(to - from), nullptr};
  }
  const ArcGeometry turned = frame.toTool(*arc);
  return {profile, frame.toTool(from), frame.toTool(to), &turned};
}

/// Of the tip.
Box3 boundsOfWay(const Vec3& from, const Vec3& to, const ArcGeometry* arc) {
  if (arc == nullptr) return {from.cwiseMin(to), from.cwiseMax(to)};
  Toolpath one;
  one.arcs.push_back(*arc);
  Motion motion;
  motion.from = from;
  motion.to = to;
  motion.arc = 0;
  return one.bounds(motion);
}

}  // namespace

double farthestFromTip(const ConvexProfile& profile) {
  return std::hypot(profile.maxRadius(), std::max(std::abs(profile.zMin()), std::abs(profile.zMax())));
}

Box3 leaningBounds(const ConvexProfile& profile, const ToolFrame& frame) {
  Box3 box;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 direction = frame.toTool(Vec3::Unit(axis));
    box.max[axis] = furthestPoint(profile, direction).dot(direction);
    box.min[axis] = furthestPoint(profile, -direction).dot(direction);
  }
  return box;
}

LeaningSweep::LeaningSweep(const ConvexProfile& profile, const ToolFrame& frame, const Vec3& from,
                           const Vec3& to, const ArcGeometry* arc)
    : frame_(frame),
      inner_(innerSweep(profile, frame, from, to, arc)),
      profile_(&profile),
      way_(boundsOfWay(from, to, arc)) {}

Box3 LeaningSweep::bounds() const {
  const Box3 tool = leaningBounds(*profile_, frame_);
  return {way_.min + tool.min, way_.max + tool.max};
}

}  // namespace proveout
