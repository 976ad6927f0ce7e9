#include "core/nc/services/cutter_comp.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/nc/services/cutter_comp_corner.h"

namespace proveout {

using namespace comp_detail;
using Shape = CompBlock::Shape;
using Role = CompPiece::Role;

void CutterComp::reset(const Vec3& position) {
  const CutterCompPolicy policy = policy_;
  *this = CutterComp(policy);
  programmed_ = center_ = position;
}

void CutterComp::rebase(const Vec3& position) {
  center_ = policy_.keeps_vector ? Vec3(position + center_ - programmed_) : position;
  programmed_ = position;
}

void CutterComp::forgetVector() {
  if (!policy_.keeps_vector) return;
  center_ = programmed_;
  starts_anew_ = active_;
}

void CutterComp::idle() {
  if (policy_.most_idle <= 0 || !active_ || elements_.empty()) return;
  Element& last = elements_.back();
  if (++idle_run_ > policy_.most_idle && !last.corner) last.square_end = true;
}

bool CutterComp::displaced() const {
  return policy_.cancel_waits && !active_ && (planar(center_) - planar(programmed_)).norm() > kTinyLength;
}

CompStatus CutterComp::checkBlock(const CompBlock& block) const {
  const auto fail = [&](CompError error) { return CompStatus{error, block.tag, block.tag}; };
  const bool finite = block.to.allFinite() && block.center.allFinite() && std::isfinite(block.sweep_rad) &&
                      std::isfinite(block.offset) && (!block.direction || block.direction->allFinite());
  if (!finite) return fail(CompError::kNotFinite);
  if (block.shape == Shape::kArc) {
    const bool starts = (!active_ || starts_anew_) && block.active;
    if (starts && !policy_.switch_in_arc) return fail(CompError::kStartInArc);
    if (!block.active && displaced()) return fail(CompError::kCancelInArc);
    if (active_ && !block.active && !policy_.switch_in_arc) return fail(CompError::kCancelInArc);
    const double smallest =
        std::min((planar(programmed_) - block.center).norm(), (planar(block.to) - block.center).norm());
    if (block.sweep_rad == 0.0 || smallest < kTinyLength) return fail(CompError::kNotFinite);
  }
  const bool needs_mode = block.shape == Shape::kCornerArc || block.keep_vector;
  if (needs_mode && !(active_ && block.active)) return fail(CompError::kNotActive);
  if (block.shape == Shape::kCornerArc && elements_.empty()) return fail(CompError::kCornerArcInside);
  return {};
}

CompStatus CutterComp::push(const CompBlock& block, CompOutput& out) {
  if (const CompStatus status = checkBlock(block); !status.ok()) return status;
  if (!active_ && (!block.active || startWaits(block))) return uncompensated(block, out);
  if (!block.active && block.shape == Shape::kNone && policy_.cancel_waits) return leave(block, out);
  if (block.active && (block.shape == Shape::kNone || standsStill(block))) return passThrough(block, out);
  elements_.push_back(makeElement(block));
  if (block.shape == Shape::kNone) elements_.back().after.push_back({block.to.z(), block.tag});
  const bool cancel = !block.active;
  active_ = block.active;
  start_pending_ = starts_anew_ = false;
  idle_run_ = 0;
  last_offset_ = block.offset;
  last_motion_tag_ = block.tag;
  pass_through_run_ = 0;
  programmed_ = elements_.back().p1;
  if (block.shape == Shape::kNone) programmed_.z() = block.to.z();
  return process(cancel, out);
}

/// Plane words without a way are no motion where blocks without one count.
bool CutterComp::standsStill(const CompBlock& block) const {
  return policy_.most_idle > 0 && active_ && block.shape == Shape::kLine &&
         (planar(block.to) - planar(programmed_)).norm() <= kTinyLength;
}

/// Compensation that is switched on without a motion may wait for the next one.
bool CutterComp::startWaits(const CompBlock& block) const {
  if (!policy_.start_waits || block.shape == Shape::kArc) return false;
  return block.shape == Shape::kNone || (planar(block.to) - planar(programmed_)).norm() <= kTinyLength;
}

/// Compensation ends without a motion: the tool stays on the offset of the last element.
CompStatus CutterComp::leave(const CompBlock& block, CompOutput& out) {
  if (!elements_.empty() && !elements_.back().corner) elements_.back().square_end = true;
  if (const CompStatus status = process(true, out); !status.ok()) return status;
  active_ = start_pending_ = starts_anew_ = false;
  pass_through_run_ = idle_run_ = 0;
  emitPassThrough({block.to.z(), block.tag}, out);
  programmed_.z() = block.to.z();
  return {};
}

CompStatus CutterComp::uncompensated(const CompBlock& block, CompOutput& out) {
  if (block.shape == Shape::kNone) {
    emitPassThrough({block.to.z(), block.tag}, out);
    programmed_.z() = block.to.z();
    return {};
  }
  if (block.shape == Shape::kArc) {
    emitArc(block.to, block.center, block.sweep_rad, Role::kOwn, block.tag, out);
  } else {
    emitLine(block.to, Role::kOwn, block.tag, out);
  }
  programmed_ = block.to;
  return {};
}

CompStatus CutterComp::passThrough(const CompBlock& block, CompOutput& out) {
  if (!active_) {
    active_ = true;
    start_pending_ = true;
  }
  programmed_.z() = block.to.z();
  if (elements_.empty()) {
    emitPassThrough({block.to.z(), block.tag}, out);
    return {};
  }
  ++pass_through_run_;
  if (pass_through_run_ > policy_.max_pass_through) {
    return {CompError::kBufferFull, last_motion_tag_, last_motion_tag_};
  }
  if (policy_.most_idle == 0 && pass_through_run_ == policy_.extra_look_ahead + 3) {
    out.notes.push_back({CompWarning::kManyPassThrough, last_motion_tag_});
  }
  elements_.back().after.push_back({block.to.z(), block.tag});
  return {};
}

CutterComp::Element CutterComp::makeElement(const CompBlock& block) const {
  Element e;
  e.p0 = programmed_;
  e.p1 = block.shape == Shape::kLine || block.shape == Shape::kArc ? block.to : programmed_;
  e.center = block.center;
  e.sweep = block.sweep_rad;
  e.decimal = block.decimal;
  e.direction = block.direction;
  e.keep_vector = block.keep_vector;
  e.tag = block.tag;
  const bool moves = (planar(e.p1) - planar(e.p0)).norm() > kTinyLength;
  if (block.shape == Shape::kArc) {
    e.kind = ElementKind::kArc;
  } else if (block.shape == Shape::kCornerArc) {
    e.kind = ElementKind::kCornerArc;
  } else {
    e.kind = block.shape == Shape::kLine && moves ? ElementKind::kLine : ElementKind::kZero;
  }
  // A start without displacement leaves the start to the next block (3.5, cases 1 and 2).
  const bool start_left_over = !elements_.empty() && elements_.back().phase == ElementPhase::kStartUp &&
                               elements_.back().kind == ElementKind::kZero;
  const bool zero = e.kind == ElementKind::kZero;
  e.rho_end = block.offset;
  if (!block.active) {
    e.phase = ElementPhase::kCancel;
  } else if (!active_ || starts_anew_ || (zero && (start_pending_ || start_left_over))) {
    e.phase = ElementPhase::kStartUp;
  }
  e.perpendicular_start = start_pending_ && block.active && !zero;
  const bool fresh = e.phase == ElementPhase::kStartUp || start_pending_;
  e.rho_start = fresh || last_offset_ * block.offset < 0.0 ? block.offset : last_offset_;
  if (e.kind == ElementKind::kArc && e.phase == ElementPhase::kStartUp) e.rho_start = 0.0;  // a spiral
  return e;
}

CompStatus CutterComp::flush(CompOutput& out) {
  pass_through_run_ = idle_run_ = 0;
  if (policy_.flush_square && !elements_.empty() && !elements_.back().corner)
    elements_.back().square_end = true;
  return process(true, out);
}

CompStatus CutterComp::halt(const CompBlock& refused, CompOutput& out) {
  if (elements_.empty()) return {};
  Element stop = makeElement(refused);
  Element& last = elements_.back();
  const bool leads = (stop.kind == ElementKind::kLine || stop.kind == ElementKind::kArc) &&
                     stop.phase == ElementPhase::kInside &&
                     checkBlock(refused).error != CompError::kNotFinite;
  if (last.phase != ElementPhase::kStartUp || !leads) {
    stop.kind = ElementKind::kZero;
    stop.phase = ElementPhase::kInside;
  }
  last.corner = makeCorner(last, &stop, startOf(elements_.size() - 1), policy_);
  return flush(out);
}

CompStatus CutterComp::process(bool drain, CompOutput& out) {
  while (!elements_.empty() && (drain || (elements_.size() >= lookAhead() && !waitsForContour()))) {
    if (const CompStatus status = finishFront(out); !status.ok()) return status;
  }
  return {};
}

Vec2 CutterComp::frontStart() const {
  const Element& front = elements_.front();
  if (!front.perpendicular_start) return planar(center_);
  return planar(front.p0) + front.rho_start * leftOf(startTangent(front));
}

/// Where the compensated path of an element starts.
Vec2 CutterComp::startOf(std::size_t index) {
  if (index == 0) return frontStart();
  const Corner& before = cornerAfter(index - 1);
  return before.points.empty() ? planar(elements_[index].p0) : before.points.back();
}

const CutterComp::Corner& CutterComp::cornerAfter(std::size_t index) {
  PROVEOUT_ASSERT(index < elements_.size());
  Element& e = elements_[index];
  if (!e.corner) {
    const Element* next = index + 1 < elements_.size() ? &elements_[index + 1] : nullptr;
    e.corner = makeCorner(e, next, startOf(index), policy_);
    PROVEOUT_ASSERT(e.corner->error != CompError::kNone || !e.corner->points.empty());
  }
  return *e.corner;
}

/// Carries out the first element and takes it out of the buffer.
CompStatus CutterComp::finishFront(CompOutput& out) {
  if (elements_.front().phase != ElementPhase::kCancel) {
    if (const CompStatus status = checkFront(out); !status.ok()) return status;
    const Element& front = elements_.front();
    const std::uint64_t tag = front.tag;
    if (cornerAfter(0).near_tangent) out.notes.push_back({CompWarning::kNearTangent, tag});
    if (front.kind == ElementKind::kCornerArc) {
      const Vec2 p = planar(front.p0), from = planar(center_) - p, to = front.corner->points.front() - p;
      const double turn = std::atan2(cross2(from, to), from.dot(to));
      // From outside the corner the arc turns against the side: clockwise with the tool on the left.
      if (turn * front.rho_end > kTinyLength) return {CompError::kCornerArcInside, tag, tag};
    }
  }
  emitFront(out);
  elements_.pop_front();
  return {};
}

void CutterComp::emitFront(CompOutput& out) {
  const Element& front = elements_.front();
  if (front.phase == ElementPhase::kCancel && front.kind == ElementKind::kArc) {
    emitOwn(front, Corner{.points = {planar(front.p1)}}, out);
  } else if (front.phase == ElementPhase::kCancel) {
    emitLine(front.p1, Role::kOwn, front.tag, out);
  } else {
    PROVEOUT_ASSERT(front.corner && !front.corner->points.empty());
    const Corner& corner = *front.corner;
    if (front.perpendicular_start) {
      const Vec2 start = frontStart();
      emitLine({start.x(), start.y(), center_.z()}, Role::kCorner, front.tag, out);
    }
    emitOwn(front, corner, out);
    emitCorner(front, corner, out);
  }
  for (const PassThrough& pass : front.after) emitPassThrough(pass, out);
}

void CutterComp::emitOwn(const Element& e, const Corner& corner, CompOutput& out) {
  PROVEOUT_ASSERT(!corner.points.empty());
  const Vec2 end = corner.points.front();
  const Vec3 to(end.x(), end.y(), e.p1.z());
  if (e.kind == ElementKind::kLine || e.kind == ElementKind::kZero || e.pivot) {
    const bool inserted = e.kind == ElementKind::kZero && to.z() == center_.z();
    emitLine(to, inserted ? Role::kCorner : Role::kOwn, e.tag, out);
    return;
  }
  const Vec2 from = planar(center_);
  if (e.kind == ElementKind::kCornerArc) {
    const Vec2 p = planar(e.p0), a = from - p, b = end - p;
    const double turn = std::abs(std::atan2(cross2(a, b), a.dot(b)));
    if (turn > kTinyLength) emitArc(to, p, e.rho_end > 0.0 ? -turn : turn, Role::kCorner, e.tag, out);
    return;
  }
  Vec2 center = e.center;
  double sweep = offsetSweep(e, from, end) * (e.sweep >= 0.0 ? 1.0 : -1.0);
  if (corner.chord_arc) chordArc(e, from, end, center, sweep);
  // An arc of which nothing is left (cutter as large as the fillet) is at most a short line.
  const double radius = std::max((from - center).norm(), (end - center).norm());
  if (std::abs(sweep) * radius < kReverseTolerance) {
    emitLine(to, Role::kOwn, e.tag, out);
  } else {
    emitArc(to, center, sweep, Role::kOwn, e.tag, out);
  }
}

void CutterComp::emitCorner(const Element& e, const Corner& corner, CompOutput& out) {
  const double w = center_.z();
  if (corner.arc_join) {
    const Vec2 p = planar(e.p1), a = planar(center_) - p, b = corner.points.back() - p;
    double turn = std::atan2(cross2(a, b), a.dot(b));
    if (turn * e.rho_end > 0.0) turn += e.rho_end > 0.0 ? -2.0 * kPi : 2.0 * kPi;  // exact reversal
    emitArc({corner.points.back().x(), corner.points.back().y(), w}, p, turn, Role::kCorner, e.tag, out);
    return;
  }
  for (std::size_t i = 1; i < corner.points.size(); ++i) {
    emitLine({corner.points[i].x(), corner.points[i].y(), w}, Role::kCorner, e.tag, out);
  }
}

void CutterComp::emitLine(const Vec3& to, Role role, std::uint64_t tag, CompOutput& out) {
  if ((to - center_).norm() > kTinyLength) {
    CompPiece piece;
    piece.role = role;
    piece.from = center_;
    piece.to = to;
    piece.tag = tag;
    out.pieces.push_back(piece);
    center_ = to;
  }
}

void CutterComp::emitArc(const Vec3& to, const Vec2& center, double sweep, Role role, std::uint64_t tag,
                         CompOutput& out) {
  CompPiece piece;
  piece.role = role;
  piece.is_arc = true;
  piece.from = center_;
  piece.to = to;
  piece.center = center;
  piece.sweep_rad = sweep;
  piece.tag = tag;
  out.pieces.push_back(piece);
  center_ = to;
}

void CutterComp::emitPassThrough(const PassThrough& pass, CompOutput& out) {
  CompPiece piece;
  piece.role = Role::kPassThrough;
  piece.from = center_;
  center_.z() = pass.w;
  piece.to = center_;
  piece.tag = pass.tag;
  out.pieces.push_back(piece);
}

}  // namespace proveout
