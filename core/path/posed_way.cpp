#include "core/path/posed_way.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout {

namespace {

/// Below this angle between axis and normal the azimuth has no meaning, rad.
constexpr double kNoAzimuth = 1e-9;

/// Azimuth of `v` about `n`, seen from `u` (unit, across n), rad.
double azimuthOf(const Vec3& v, const Vec3& n, const Vec3& u) {
  return std::atan2(n.cross(u).dot(v), u.dot(v));
}

double angleBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// From one azimuth to another while the path turns by `sweep`: the turn nearest to it, so that an axis that
/// follows the arc goes round with it.
double azimuthChange(double from, double to, double sweep) {
  return sweep + std::remainder(to - from - sweep, 2 * kPi);
}

}  // namespace

PosedWay::PosedWay(const Motion& motion, const ArcGeometry* arc, const AxisSweep& axis)
    : law_(axis.law),
      from_(motion.from),
      to_(motion.to),
      axis_from_(axis.from.normalized()),
      axis_to_(axis.to.normalized()),
      pose_(axis.pose) {
  PROVEOUT_ASSERT(pose_ != nullptr || law_ == PoseLaw::kVector || law_ == PoseLaw::kCone);
  if (pose_ != nullptr) {
    from_ -= pose_->beyond * axis_from_;
    to_ -= pose_->beyond * axis_to_;
  }
  if (arc != nullptr) {
    is_arc_ = true;
    arc_ = *arc;
    arc_.center += arc_.normal * arc_.normal.dot(from_ - arc_.center);
    frame_ = arcFrame(from_, to_, arc_);
  }
  const Vec3 cross = axis_from_.cross(axis_to_);
  angle_ = angleBetween(axis_from_, axis_to_);
  about_ = cross.norm() > 0.0 ? Vec3(cross.normalized()) : axis_from_.unitOrthogonal();
  if (law_ != PoseLaw::kCone) return;
  const Vec3& n = arc_.normal;
  tilt_from_ = angleBetween(n, axis_from_);
  tilt_to_ = angleBetween(n, axis_to_);
  const bool steep_from = std::sin(tilt_from_) < kNoAzimuth, steep_to = std::sin(tilt_to_) < kNoAzimuth;
  azimuth_ = arc_.sweep_rad;
  if (steep_from && steep_to) azimuth_at_ = n.unitOrthogonal();
  if (!steep_from) azimuth_at_ = (axis_from_ - n * n.dot(axis_from_)).normalized();
  if (!steep_from && !steep_to) {
    azimuth_ = azimuthChange(0.0, azimuthOf(axis_to_, n, azimuth_at_), arc_.sweep_rad);
  } else if (!steep_to) {
    // Upright at the start: the azimuth that the end has, an arc before it.
    azimuth_at_ = Eigen::AngleAxisd(-azimuth_, n) * Vec3((axis_to_ - n * n.dot(axis_to_)).normalized());
  }
}

/// The point that the law holds on the line or arc.
MachineChain::PointMotion PosedWay::pointAt(double share) const {
  if (!is_arc_) return {share >= 1.0 ? to_ : Vec3(from_ + share * (to_ - from_)), to_ - from_};
  const double angle = share * arc_.sweep_rad, change = frame_.radius_end - frame_.radius_start,
               radius = frame_.radius_start + share * change;
  const Vec3 out = frame_.u * std::cos(angle) + frame_.v * std::sin(angle);
  const Vec3 along = frame_.v * std::cos(angle) - frame_.u * std::sin(angle);
  return {arcPoint(frame_, arc_, share),
          change * out + radius * arc_.sweep_rad * along + frame_.rise * frame_.n};
}

MachineChain::MotionBounds PosedWay::pointBounds() const {
  if (!is_arc_) return {(to_ - from_).norm(), 0.0};
  const double turn = std::abs(arc_.sweep_rad), change = std::abs(frame_.radius_end - frame_.radius_start),
               radius = std::max(frame_.radius_start, frame_.radius_end);
  return {std::hypot(radius * turn, std::hypot(change, frame_.rise)),
          radius * turn * turn + 2.0 * change * turn};
}

MachineChain::PointMotion PosedWay::axisAt(double share) const {
  switch (law_) {
    case PoseLaw::kVector: {
      if (angle_ == 0.0) return {axis_from_, Vec3::Zero()};
      const Vec3 a = share >= 1.0 ? axis_to_ : Vec3(Eigen::AngleAxisd(share * angle_, about_) * axis_from_);
      return {a, angle_ * about_.cross(a)};
    }
    case PoseLaw::kCone: {
      const Vec3& n = arc_.normal;
      const double tilt = tilt_from_ + share * (tilt_to_ - tilt_from_), turned = share * azimuth_;
      const Vec3 v = n.cross(azimuth_at_), out = std::cos(turned) * azimuth_at_ + std::sin(turned) * v,
                 along = std::cos(turned) * v - std::sin(turned) * azimuth_at_;
      return {std::cos(tilt) * n + std::sin(tilt) * out,
              (tilt_to_ - tilt_from_) * (std::cos(tilt) * out - std::sin(tilt) * n) +
                  azimuth_ * std::sin(tilt) * along};
    }
    case PoseLaw::kTip:
    case PoseLaw::kAxes:
      break;
  }
  const MachineChain& chain = *pose_->chain;
  return chain.followDirection(pose_->axes_from, pose_->axes_to, share, chain.toolAtZero());
}

PosedWay::Moving PosedWay::movingAt(double share) const {
  const MachineChain::PointMotion axis = axisAt(share);
  if (law_ == PoseLaw::kAxes) {
    const MachineChain::PointMotion tip =
        pose_->chain->follow(pose_->axes_from, pose_->axes_to, share, pose_->tip_at_zero);
    return {{tip.at, axis.at}, {tip.velocity, axis.velocity}};
  }
  const MachineChain::PointMotion point = pointAt(share);
  const double beyond = pose_ != nullptr ? pose_->beyond : 0.0;
  return {{point.at + beyond * axis.at, axis.at}, {point.velocity + beyond * axis.velocity, axis.velocity}};
}

ToolPose PosedWay::at(double share) const { return movingAt(share).pose; }

PosedWay::Bounds PosedWay::boundsOn(double low, double high) const {
  Bounds b;
  if (law_ == PoseLaw::kTip || law_ == PoseLaw::kAxes) {
    const double turn = pose_->chain->turned(pose_->axes_from, pose_->axes_to);
    b.axis = {turn, turn * turn};
  } else if (law_ == PoseLaw::kVector) {
    b.axis = {angle_, angle_ * angle_};
  } else {
    const double turn = std::abs(azimuth_) + std::abs(tilt_to_ - tilt_from_);
    b.axis = {turn, turn * turn};
  }
  if (law_ == PoseLaw::kAxes) {
    b.tip = pose_->chain->pointBounds(pose_->axes_from, pose_->axes_to, low, high, pose_->tip_at_zero);
    return b;
  }
  b.tip = pointBounds();
  const double beyond = pose_ != nullptr ? std::abs(pose_->beyond) : 0.0;
  b.tip.velocity += beyond * b.axis.velocity;
  b.tip.acceleration += beyond * b.axis.acceleration;
  return b;
}

Box3 PosedWay::tipBounds(double low, double high) const {
  constexpr int kPieces = 8;
  Box3 box;
  for (int k = 0; k < kPieces; ++k) {
    const double a = low + (high - low) * k / kPieces, b = low + (high - low) * (k + 1) / kPieces;
    const Vec3 p = at(a).tip, q = at(b).tip;
    // A curve leaves its chord by an eighth of its second derivative at most.
    const double bulge = boundsOn(a, b).tip.acceleration * (b - a) * (b - a) / 8.0;
    Box3 piece;
    piece.extend(p);
    piece.extend(q);
    box.extend(piece.inflated(bulge).min);
    box.extend(piece.inflated(bulge).max);
  }
  return box;
}

double PosedWay::length() const {
  constexpr double kRelative = 1e-7, kLeast = 1e-7;
  constexpr int kMostHalvings = 14;
  const auto speed = [&](double share) { return movingAt(share).rates.tip.norm(); };
  // Simpson's rule, halved until it stands twice: a way of several turns may agree with itself by chance.
  int stands = 0;
  double ends = speed(0.0) + speed(1.0), evens = 0.0, last = -1.0;
  for (int halvings = 1, n = 2; halvings <= kMostHalvings; ++halvings, n *= 2) {
    double odds = 0.0;
    for (int k = 1; k < n; k += 2) odds += speed(static_cast<double>(k) / n);
    const double now = (ends + 4.0 * odds + 2.0 * evens) / (3.0 * n);
    stands = halvings > 3 && std::abs(now - last) <= kRelative * now + kLeast ? stands + 1 : 0;
    if (stands == 2) return now;
    last = now;
    evens += odds;
  }
  return last;
}

PosedWay posedWayOf(const Toolpath& path, const Motion& motion) {
  PROVEOUT_ASSERT(motion.axis >= 0);
  return {motion, motion.arc < 0 ? nullptr : &path.arcs[static_cast<std::size_t>(motion.arc)],
          path.axes[static_cast<std::size_t>(motion.axis)]};
}

}  // namespace proveout
