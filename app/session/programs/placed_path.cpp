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

std::shared_ptr<const PoseSweep> movedPose(const RigidTransform& move, const PoseSweep& pose,
                                           MovedChain& chains) {
  PoseSweep out = pose;
  out.tip_at_zero = move(pose.tip_at_zero);
  if (pose.chain != nullptr) {
    const bool same = chains.of == pose.chain && chains.move.rotation == move.rotation &&
                      chains.move.translation == move.translation;
    if (!same) chains = {pose.chain, move, std::make_shared<const MachineChain>(pose.chain->moved(move))};
    out.chain = chains.chain;
  }
  return std::make_shared<const PoseSweep>(std::move(out));
}

/// A piece of a path, moved.
class Moved {
 public:
  /// `chains` keeps what chains become, which many motions share.
  Moved(const RigidTransform& move, const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis,
        MovedChain& chains)
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
      if (axis->pose != nullptr) axis_->pose = movedPose(move, *axis->pose, chains);
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
  const Moved moved(moveOf(placements_, motion.channel), motion, arc, axis, chain_);
  next_.motion(moved.motion(), moved.arc(), moved.axis());
}

void PlacedSink::wireMotion(const Motion& motion, const WireSweep& wire) {
  const RigidTransform& move = moveOf(placements_, motion.channel);
  const Moved moved(move, motion, nullptr, nullptr, chain_);
  WireSweep there = wire;
  there.z_low += move.translation.z();
  there.z_high += move.translation.z();
  moveTrack(move, there.lower);
  moveTrack(move, there.upper);
  next_.wireMotion(moved.motion(), there);
}

Result<std::optional<double>> PlacedProbe::firstContact(const Motion& move, const ArcGeometry* arc,
                                                        const AxisSweep* axis) {
  MovedChain chain;
  const Moved moved(move_, move, arc, axis, chain);
  return inner_.firstContact(moved.motion(), moved.arc(), moved.axis());
}

}  // namespace proveout
