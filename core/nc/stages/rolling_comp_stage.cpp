#include "core/nc/stages/rolling_comp_stage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"

namespace proveout::nc {

namespace {

constexpr double kChordError = 1e-3;  ///< mm, of arcs at rapid
constexpr double kBackwards = 1e-4;   ///< mm; less is rounding of corners that just fit

std::string describe(CompError error) {
  switch (error) {
    case CompError::kStartInArc:
      return "compensation cannot be switched on in an arc: the first motion has to be G0 or G1";
    case CompError::kCancelInArc:
      return "compensation cannot be switched off in an arc: the motion has to be G0 or G1";
    case CompError::kNoIntersection:
      return "the compensated paths of this corner do not meet: the tool does not fit into it";
    case CompError::kBufferFull:
      return "too many blocks without motion in the plane while compensation is on";
    case CompError::kSideChange:
      return "the change between G41 and G42 has no solution here";
    default:
      return "compensation: data out of range";
  }
}

/// Errors of the block that comes: those before it have a path. Of the others the path of the first block
/// that waits is not known to its end.
bool refusesBlock(CompError error) {
  return error != CompError::kNoIntersection && error != CompError::kSideChange;
}

/// Arcs inside whose radius is smaller than the tool's.
bool negativeRadius(const PathItem& item) {
  if (item.kind != PathItem::Kind::kArc || !item.comp_on) return false;
  const double radius = (item.plane.of(item.to) - item.center).head<2>().norm();
  return (item.sweep > 0.0 ? item.offset : -item.offset) >= radius;
}

/// Against the programmed direction.
bool runsBackwards(const CompPiece& piece, const PathItem& item) {
  const bool arc = item.kind == PathItem::Kind::kArc;
  if (piece.role != CompPiece::Role::kOwn || !item.comp_on || piece.is_arc != arc) return false;
  if (arc) {
    const double length = std::abs(piece.sweep_rad) * (piece.from.head<2>() - piece.center).norm();
    return piece.sweep_rad * item.sweep < 0.0 && length > kBackwards;
  }
  if (item.kind != PathItem::Kind::kLine) return false;
  const Vec2 programmed = item.plane.of(item.to).head<2>() - item.start;
  return programmed.dot((piece.to - piece.from).head<2>()) < -kBackwards * programmed.norm();
}

}  // namespace

void RollingCompStage::engage(const Vec3& start, const RollingCompStyle& style) {
  style_ = style;
  tips_ = {Vec3(tips_.back())};
  CutterCompPolicy policy;
  policy.start_ramp = policy.cancel_ramp = style.around_at_ends ? CompRamp::kB : CompRamp::kA;
  policy.outer_corner = CompOuterCorner::kArc;
  policy.interference_check = false;
  policy.arc_threshold = style.arc_threshold;
  policy.arc_least_turn_rad = style.arc_least_turn_rad;
  policy.switch_in_arc = style.switches_in_arcs;
  begin(policy, start);
}

bool RollingCompStage::push(PathItem& item) {
  PROVEOUT_ASSERT(!tips_.empty());
  item.record = static_cast<std::uint32_t>(tips_.size() - 1);
  return CompensationStage::push(item);
}

bool RollingCompStage::accepts(const PathItem& item) {
  if (!negativeRadius(item)) return true;
  const char* const message = "negative radius under compensation: the arc is smaller than the tool";
  if (style_.negative_radius_runs) {
    report_.compWarning(CompFault::kNegativeRadius, message, item.source);
    return true;
  }
  // The centre stops at the end of the block before (digest wl4, 5.3).
  if (!sendBefore(item)) return false;
  report_.compError(CompFault::kNegativeRadius, message, item.source);
  return false;
}

void RollingCompStage::failed(const CompStatus& status) {
  const PathItem* item = waiting(status.tag);
  const SourceRef at = item != nullptr ? item->source : SourceRef{};
  if (refusesBlock(status.error) && !sendBefore(newest())) return;
  const bool switches = status.error == CompError::kStartInArc || status.error == CompError::kCancelInArc;
  report_.compError(switches ? CompFault::kSwitch : CompFault::kNoPath, describe(status.error), at);
}

bool RollingCompStage::send(const CompPiece& piece, const PathItem& item, PathItem& out) {
  if (runsBackwards(piece, item)) {
    report_.compWarning(
        CompFault::kTooShort,
        "the motion is shorter than the tool's radius needs: the tool runs backwards along it", item.source);
  }
  const Vec3 tip = item.comp_on ? item.plane.of(tips_[item.record]) : Vec3(Vec3::Zero());
  if (piece.is_arc && item.rapid) return sendRapidArc(piece, tip, out);
  out.to[item.plane.u] += tip.x();
  out.to[item.plane.v] += tip.y();
  out.to[item.plane.w] += tip.z();
  if (piece.is_arc) {
    out.center += tip;
    out.start += tip.head<2>();
  }
  return pass(out);
}

/// Rapids are straight: an arc about a corner becomes chords.
bool RollingCompStage::sendRapidArc(const CompPiece& piece, const Vec3& tip, PathItem& item) {
  const Vec2 arm = piece.from.head<2>() - piece.center;
  const double radius = std::max(arm.norm(), kChordError);
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(piece.sweep_rad) /
                                                           (2.0 * std::acos(1.0 - kChordError / radius)))));
  item.kind = PathItem::Kind::kLine;
  for (int k = 1; k <= count; ++k) {
    const double part = static_cast<double>(k) / count;
    const Vec2 at = piece.center + Eigen::Rotation2Dd(part * piece.sweep_rad) * arm;
    const Vec3 to = (k < count ? Vec3(at.x(), at.y(), piece.from.z() + part * (piece.to.z() - piece.from.z()))
                               : piece.to) +
                    tip;
    PathItem chord = item.copyMotion();
    chord.to[item.plane.u] = to.x();
    chord.to[item.plane.v] = to.y();
    chord.to[item.plane.w] = to.z();
    if (!pass(chord)) return false;
  }
  return true;
}

}  // namespace proveout::nc
