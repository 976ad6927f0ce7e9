#include "app/session/programs/placed_path.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

RigidTransform into(const WorkpiecePlacement& placement, const Vec3& from) {
  RigidTransform out;
  if (placement.rotation_deg != 0.0) out.rotation = rotationAbout(Vec3::UnitZ(), -placement.rotation_deg);
  out.translation = out.rotation * from;
  return out;
}

/// A piece of a path, moved.
class Moved {
 public:
  Moved(const RigidTransform& move, const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis)
      : motion_(motion) {
    motion_.from = move(motion.from);
    motion_.to = move(motion.to);
    if (arc != nullptr) {
      arc_ = *arc;
      arc_->center = move(arc->center);
      arc_->normal = move.rotation * arc->normal;
    }
    if (axis != nullptr) {
      axis_ = *axis;
      axis_->from = move.rotation * axis->from;
      axis_->to = move.rotation * axis->to;
    }
  }
  const Motion& motion() const { return motion_; }
  const ArcGeometry* arc() const { return arc_ ? &*arc_ : nullptr; }
  const AxisSweep* axis() const { return axis_ ? &*axis_ : nullptr; }

 private:
  Motion motion_;
  std::optional<ArcGeometry> arc_;
  std::optional<AxisSweep> axis_;
};

void moveTrack(const RigidTransform& move, WireTrack& track) {
  for (Vec2* p : {&track.from, &track.to, &track.center}) *p = move(Vec3(p->x(), p->y(), 0.0)).head<2>();
}

const RigidTransform& moveOf(const std::vector<ChannelPlacement>& placements, int channel) {
  const auto found = std::find_if(placements.begin(), placements.end(),
                                  [&](const ChannelPlacement& p) { return p.channel == channel; });
  return found == placements.end() ? placements.front().move : found->move;
}

}  // namespace

RigidTransform machineIntoWorkpiece(const ControlSettings& settings) {
  return into(settings.placement, -workpieceZero(settings));
}

RigidTransform pathIntoWorkpiece(const ControlSettings& settings) {
  return into(settings.placement, offsetZero(settings) - workpieceZero(settings));
}

PlacedSink::PlacedSink(MotionSink& next, std::vector<ChannelPlacement> placements)
    : next_(next), placements_(std::move(placements)) {}

void PlacedSink::motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) {
  const Moved moved(moveOf(placements_, motion.channel), motion, arc, axis);
  next_.motion(moved.motion(), moved.arc(), moved.axis());
}

void PlacedSink::wireMotion(const Motion& motion, const WireSweep& wire) {
  const RigidTransform& move = moveOf(placements_, motion.channel);
  const Moved moved(move, motion, nullptr, nullptr);
  WireSweep there = wire;
  there.z_low += move.translation.z();
  there.z_high += move.translation.z();
  moveTrack(move, there.lower);
  moveTrack(move, there.upper);
  next_.wireMotion(moved.motion(), there);
}

Result<std::optional<double>> PlacedProbe::firstContact(const Motion& move, const ArcGeometry* arc,
                                                        const AxisSweep* axis) {
  const Moved moved(move_, move, arc, axis);
  return inner_.firstContact(moved.motion(), moved.arc(), moved.axis());
}

}  // namespace proveout
