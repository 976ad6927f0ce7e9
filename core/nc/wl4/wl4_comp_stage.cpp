#include "core/nc/wl4/wl4_comp_stage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace proveout::nc {

namespace {

constexpr double kChordError = 1e-3;  ///< mm, of arcs at rapid

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

/// Arcs inside whose radius is smaller than the tool's.
bool negativeRadius(const PathItem& item) {
  if (item.kind != PathItem::Kind::kArc || !item.comp_on) return false;
  const double radius = (item.plane.of(item.to) - item.center).head<2>().norm();
  return (item.sweep > 0.0 ? item.offset : -item.offset) >= radius;
}

CompBlock blockOf(const PathItem& item) {
  CompBlock block;
  block.to = item.plane.of(item.to);
  block.active = item.comp_on;
  block.offset = item.offset;
  block.tag = item.tag;
  if (item.kind == PathItem::Kind::kArc) {
    block.shape = CompBlock::Shape::kArc;
    block.center = item.center.head<2>();
    block.sweep_rad = item.sweep;
  } else if (item.kind == PathItem::Kind::kLine && item.in_plane) {
    block.shape = CompBlock::Shape::kLine;
  }
  return block;
}

}  // namespace

void Wl4CompStage::engage(const Vec3& start, double arc_threshold) {
  CutterCompPolicy policy;
  policy.start_ramp = policy.cancel_ramp = CompRamp::kA;
  policy.outer_corner = CompOuterCorner::kArc;
  policy.interference_check = false;
  policy.arc_threshold = arc_threshold;
  filter_ = CutterComp(policy);
  filter_.reset(start);
  waiting_.clear();
  pipe_.link(*this);
}

bool Wl4CompStage::push(PathItem& item) {
  if (negativeRadius(item)) {
    return report_.compError("wl4-negative-radius",
                             "negative radius under compensation: the arc is smaller than the tool",
                             item.source, false);
  }
  item.tag = next_tag_++;
  const CompBlock block = blockOf(item);
  waiting_.push_back(std::move(item));
  out_.clear();
  const CompStatus status = filter_.push(block, out_);
  if (!drain(status)) return false;
  if (!filter_.active() && !filter_.pending()) clear();
  return true;
}

bool Wl4CompStage::flush(FlushReason reason) {
  if (reason == FlushReason::kTransform) return true;
  out_.clear();
  const CompStatus status = filter_.flush(out_);
  return drain(status);
}

void Wl4CompStage::rebase(const AxisPoint& work, const WorkPlane& plane) { filter_.rebase(plane.of(work)); }

void Wl4CompStage::clear() {
  waiting_.clear();
  pipe_.unlink(*this);
}

SourceRef Wl4CompStage::sourceOf(std::uint64_t tag) const {
  for (const PathItem& item : waiting_) {
    if (item.tag == tag) return item.source;
  }
  return waiting_.empty() ? SourceRef{} : waiting_.back().source;
}

bool Wl4CompStage::drain(const CompStatus& status) {
  for (const CompPiece& piece : out_.pieces) {
    while (!waiting_.empty() && waiting_.front().tag < piece.tag) waiting_.pop_front();
    if (waiting_.empty() || waiting_.front().tag != piece.tag) continue;
    if (!sendPiece(piece, waiting_.front())) return false;
  }
  if (status.ok()) return true;
  return report_.compError("wl4-compensation", describe(status.error), sourceOf(status.tag), false);
}

bool Wl4CompStage::sendPiece(const CompPiece& piece, PathItem& item) {
  if (item.function()) return pass(item);
  PathItem out = item.copyMotion();
  out.kind = piece.is_arc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
  const Vec3 tip = item.comp_on ? item.plane.of(tip_) : Vec3(Vec3::Zero());
  if (piece.is_arc && item.rapid) return sendRapidArc(piece, tip, out);
  const Vec3 to = piece.to + tip;
  out.to[item.plane.u] = to.x();
  out.to[item.plane.v] = to.y();
  out.to[item.plane.w] = to.z();
  if (piece.is_arc) {
    out.center = Vec3(piece.center.x(), piece.center.y(), piece.from.z()) + tip;
    out.start = piece.from.head<2>() + tip.head<2>();
    out.sweep = piece.sweep_rad;
  }
  return pass(out);
}

/// Rapids are straight: an arc about a corner becomes chords.
bool Wl4CompStage::sendRapidArc(const CompPiece& piece, const Vec3& tip, PathItem& item) {
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
