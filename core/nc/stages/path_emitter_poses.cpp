// Motions during which rotary axes turn the tool: by the law of the machine's axes, or with the tip held on
// its way by the control.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/stages/path_emitter.h"
#include "core/path/posed_way.h"

namespace proveout::nc {
namespace {

/// A way this near to its law follows it: rounding noise of the coordinates.
constexpr double kLawMm = 1e-7;
/// Where the control's data are not the machine's, its way goes by pieces that are this near to it. A point
/// of the tool so far from the tip counts as well.
constexpr double kPieceMm = 5e-5, kReachMm = 100.0;
constexpr int kMostHalvings = 12;
/// Axes of a tool that differ less are one.
constexpr double kSameAxis = 1e-12;
/// Tips that move less stay.
constexpr double kStaysMm = 1e-6;
/// Shares of a piece at which it is looked at.
constexpr std::array<double, 2> kPieceProbes{0.5, 0.25};
/// Places at which the speed of the axes is looked at.
constexpr int kSpeedSteps = 16;

bool alike(const ToolPose& a, const ToolPose& b, double most) {
  return (a.tip - b.tip).norm() <= most && kReachMm * (a.axis - b.axis).norm() <= most;
}

}  // namespace

/// From where the machine stands.
PoseSweep PathEmitter::poseTowards(const AxisPoint& to) const {
  PoseSweep pose;
  pose.chain = chain_;
  pose.axes_from = machine_;
  pose.axes_to = to;
  pose.tip_at_zero = to_workpiece_;
  return pose;
}

/// One motion by the law of the axes, which has its own time.
void PathEmitter::sendByAxes(Motion motion, const AxisPoint& to) {
  time_.flush();
  AxisSweep sweep = *sweepTo(to);
  sweep.law = PoseLaw::kAxes;
  sweep.pose = std::make_shared<const PoseSweep>(poseTowards(to));
  const double length = motion.kind == MotionKind::kRapid ? 0.0 : PosedWay(motion, nullptr, sweep).length();
  sendPiece(motion, to, nullptr, length, &sweep);
}

/// Speed and directions of a way that the axes follow.
MotionPace PathEmitter::trackPace(const PoseTrack& track, const FeedStyle* style) const {
  MotionPace pace;
  pace.rapid = style == nullptr;
  pace.length = track.tip_mm > kStaysMm ? track.tip_mm : furtherTravel(track.at(1.0));
  double minutes = style == nullptr ? 0.0 : pace.length / style->feed;
  AxisPoint last = machine_, most;
  for (int i = 1; i <= kSpeedSteps; ++i) {
    const AxisPoint next = track.at(static_cast<double>(i) / kSpeedSteps);
    AxisPoint direction;
    for (int k = 0; k < axes_.count(); ++k) {
      const double way = kSpeedSteps * std::abs(next[k] - last[k]);  // were it so all the time
      const double fastest = style != nullptr ? time_.limits().axes[static_cast<std::size_t>(k)].max_feed
                             : k < kMainAxes  ? settings_.rapid_mm_min[k]
                                              : axes_.at(k).rapid;
      if (fastest > 0.0) minutes = std::max(minutes, way / fastest);
      most[k] = std::max(most[k], way / pace.length);
      direction[k] = kSpeedSteps * (next[k] - last[k]) / pace.length;
    }
    if (i == 1) pace.begin = direction;
    pace.end = direction;
    last = next;
  }
  pace.speed = pace.length / (60.0 * minutes);
  pace.acceleration = lineAcceleration(time_.limits(), most, axes_.count());
  return pace;
}

/// The way as its law says; false: the machine does not follow it, and nothing was sent.
bool PathEmitter::sendHeld(Motion motion, const AxisPoint& to, const PoseTrack& track, const MotionPace* pace,
                           const MotionJoin& join) {
  AxisSweep sweep = *sweepTo(to);
  sweep.law = track.law;
  PoseSweep pose = poseTowards(to);
  const double gauge = (chain_->tipAtZero(0.0) - to_workpiece_).dot(chain_->toolAtZero());
  pose.beyond = track.held_mm + track.length - gauge;
  motion.from = toolPoint(machine_);
  motion.to = toolPoint(to);
  motion.tool = tool_;
  if (motion.spindle == 0.0) motion.spindle = spindle_;
  ArcGeometry arc;
  if (track.arc) {
    const Vec3 center = toolPoint(track.arc->center);
    arc.center = center - pose.beyond * sweep.from;
    arc.normal = (toolPoint(track.arc->above) - center).normalized();
    arc.sweep_rad = track.arc->sweep_rad;
    motion.arc = 0;
  }
  sweep.pose = std::make_shared<const PoseSweep>(pose);
  const ArcGeometry* curve = track.arc ? &arc : nullptr;
  const PosedWay way(motion, curve, sweep);
  bool turns = (sweep.to - sweep.from).norm() > kSameAxis;
  for (const double t : kProbes) {
    const ToolPose there = toolPose(track.at(t));
    if (!alike(way.at(t), there, kLawMm)) return false;
    turns = turns || (there.axis - sweep.from).norm() > kSameAxis;
  }
  if (!turns) {  // a table turns about the tool's own direction
    sweep.pose = nullptr;
    sweep.law = PoseLaw::kVector;
    arc.center += pose.beyond * sweep.from;
  }
  checkSwing(track, 0.0, 1.0, motion.source);
  if (any_limit_) {
    const AxisPoint last = machine_;
    machine_ = to;
    checkMachineTravel(last, motion.source);
  }
  machine_ = to;
  ++summary_.motions;
  if (pace == nullptr) {
    time_.flush();
    time_.pass(motion, curve, &sweep);
  } else {
    time_.motion(motion, curve, &sweep, *pace, join);
  }
  return true;
}

/// From where the machine stands, by one law; with `arc` along its part between the ends.
PathEmitter::PosedPart PathEmitter::partTo(const AxisPoint& to, PoseLaw law, const ArcGeometry* arc) {
  PosedPart part;
  part.motion.from = toolPoint(machine_);
  part.motion.to = toolPoint(to);
  part.sweep = *sweepTo(to);
  part.sweep.law = law;
  part.sweep.pose = std::make_shared<const PoseSweep>(poseTowards(to));
  if (arc == nullptr) return part;
  // The ends are on it but for what the data are off: it is a spiral from one to the other.
  const Vec3 from = part.motion.from - arc->center, end = part.motion.to - arc->center;
  const double about = std::atan2(arc->normal.dot(from.cross(end)),
                                  from.dot(end) - arc->normal.dot(from) * arc->normal.dot(end));
  part.arc = *arc;
  part.arc->sweep_rad += std::remainder(about - arc->sweep_rad, 2.0 * kPi);
  return part;
}

bool PathEmitter::follows(const PosedPart& part, const PoseTrack& track, double low, double high) const {
  const PosedWay way(part.motion, part.arc ? &*part.arc : nullptr, part.sweep);
  // Two places: a way that crosses its chord in the middle is seen at the other.
  return std::all_of(kPieceProbes.begin(), kPieceProbes.end(), [&](double share) {
    return alike(way.at(share), toolPose(track.at(low + share * (high - low))), kPieceMm);
  });
}

/// The way as the machine follows it, in pieces along which its rotary axes go linearly, and the others as
/// well or so that the tip goes along a line or a part of the programmed arc: what the data are off is small
/// beside the way of the linear axes, which swing with the rotary ones.
void PathEmitter::sendFollowed(const Motion& motion, const PoseTrack& track) {
  time_.flush();
  std::optional<ArcGeometry> arc;
  if (track.arc) {
    const Vec3 center = toolPoint(track.arc->center);
    arc = {center, (toolPoint(track.arc->above) - center).normalized(), track.arc->sweep_rad};
  }
  const auto sent = [&](double low, double high, bool any) {
    const AxisPoint to = track.at(high);
    for (const PoseLaw law : {PoseLaw::kAxes, PoseLaw::kTip}) {
      std::optional<ArcGeometry> along;
      if (law == PoseLaw::kTip && arc) along = {arc->center, arc->normal, arc->sweep_rad * (high - low)};
      PosedPart part = partTo(to, law, along ? &*along : nullptr);
      if (!any && !follows(part, track, low, high)) continue;
      Motion& m = part.motion;
      const Motion ends = m;
      m = motion;
      m.from = ends.from, m.to = ends.to;
      m.time_s = motion.time_s * (high - low);
      const ArcGeometry* const curve = part.arc ? &*part.arc : nullptr;
      const double length = m.kind == MotionKind::kRapid ? 0.0 : PosedWay(m, curve, part.sweep).length();
      checkSwing(track, low, high, m.source);
      sendPiece(m, to, curve, length, &part.sweep);
      return true;
    }
    return false;
  };
  const std::function<void(double, double, int)> halve = [&](double low, double high, int left) {
    if (sent(low, high, left == 0)) return;
    const double middle = 0.5 * (low + high);
    halve(low, middle, left - 1);
    halve(middle, high, left - 1);
  };
  halve(0.0, 1.0, kMostHalvings);
}

/// The linear axes may swing beyond both ends of a way whose tip is held.
void PathEmitter::checkSwing(const PoseTrack& track, double low, double high, const SourceRef& source) {
  const AxisPoint start = machine_;
  for (int i = 1; any_limit_ && i < kSpeedSteps; ++i) {
    const AxisPoint last = machine_;
    machine_ = track.at(low + (high - low) * i / kSpeedSteps);
    checkMachineTravel(last, source);
  }
  machine_ = start;
}

void PathEmitter::poseTo(const AxisPoint& to, const PoseTrack& track, const FeedStyle* style,
                         const SourceRef& source) {
  if (track.tip_mm <= kStaysMm && furtherTravel(to) < kStaysMm) return;
  const MotionPace pace = trackPace(track, style);
  Motion m;
  m.kind = style != nullptr ? style->kind : MotionKind::kRapid;
  m.source = source;
  m.time_s = pace.length / pace.speed;
  if (style != nullptr) {
    m.spindle = style->spindle;
    m.feed = 60.0 * pace.speed;
  }
  MotionJoin join = style != nullptr ? style->join : MotionJoin{};
  join.stops = join.stops || style == nullptr;
  const bool wants_pace = time_.wantsPace(join);
  if (!sendHeld(m, to, track, wants_pace ? &pace : nullptr, join)) sendFollowed(m, track);
}

}  // namespace proveout::nc
