#include "removal/cut/own_track.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

/// Places that rounding tells apart are one, mm.
constexpr double kOnePlaceMm = 1e-9;

}  // namespace

bool OwnTrack::isHere(const Vec3& p) const {
  return std::abs(p.x() - at_.x()) < kOnePlaceMm && std::abs(p.y() - at_.y()) < kOnePlaceMm;
}

bool OwnTrack::holds(const MotionWay& way, const ToolParts& tool, const ToolParts::Part& part,
                     double top) const {
  const Motion& next = way.motion;
  if (way.leans() || way.turns()) return false;
  if (next.tool != tool_ || next.arc >= 0 || !isHere(next.from) || !isHere(next.to)) return false;
  if (std::min(next.from.z(), next.to.z()) < low_ - kOnePlaceMm) return false;
  // A cutter that is nowhere wider than at its level top covers what it has below it on its way up.
  if (tool.solid.cutter.size() != 1 || !hasLevelTop(tool.parts.front().columns)) return false;
  const ConvexProfile& cutter = tool.solid.cutter.front();
  return low_ + cutter.zMax() >= top && part.profile->maxRadius() <= cutter.maxRadius();
}

void OwnTrack::add(const MotionWay& way) {
  const Motion& motion = way.motion;
  // Measuring cuts nothing, and what leans no upright way.
  if (motion.kind == MotionKind::kProbe || way.leans() || way.turns()) {
    tool_ = -1;
    return;
  }
  const bool stays = motion.tool == tool_ && motion.arc < 0 && isHere(motion.from) && isHere(motion.to);
  low_ = stays ? std::min({low_, motion.from.z(), motion.to.z()}) : motion.to.z();
  tool_ = motion.tool;
  at_ = motion.to.head<2>();
}

}  // namespace proveout
