#include "core/nc/stages/contour_stage.h"

#include <cmath>

#include "core/nc/services/contour/contour_crossing.h"

namespace proveout::nc {
namespace {

using Kind = PathItem::Kind;
using Meet = PathItem::Meet;

/// mm; a calculated circle and its programmed end may differ by so much.
constexpr double kOnCircle = 0.01;

Vec2 planeEnd(const PathItem& item) { return {item.to[item.plane.u], item.to[item.plane.v]}; }

/// Whether `next` goes at a right angle to `block`, to the side that this one's join asks for.
bool turnsAsAsked(const PathItem& block, const PathItem& next) {
  constexpr double kStraightMm = 1e-6;
  if (next.kind != Kind::kLine) return false;
  const Vec2 first = planeEnd(block) - block.start, way = planeEnd(next) - planeEnd(block);
  const int along = std::abs(first.x()) > kStraightMm ? 0 : 1;
  return std::abs(way[along]) <= kStraightMm && way[1 - along] * block.join_turn > 0.0;
}

void setPlaneEnd(PathItem& item, const Vec2& p) {
  item.to[item.plane.u] = p.x();
  item.to[item.plane.v] = p.y();
}

bool feedsInPlane(const PathItem& item) {
  return item.kind == Kind::kArc || (item.kind == Kind::kLine && item.in_plane && !item.rapid);
}

ContourElement elementOf(const PathItem& item) {
  ContourElement element{item.kind == Kind::kArc, item.start, planeEnd(item), Vec2::Zero(), 0.0};
  if (!element.arc) return element;
  element.center = item.center.head<2>();
  element.sweep = item.sweep;
  return element;
}

bool crosses(const PathItem& item) { return item.meet == Meet::kFirst || item.meet == Meet::kSecond; }

/// The line or circle of a block. Directions of lines that only have two points may be undefined: not finite.
PlaneCurve curveOf(const PathItem& item) {
  if (item.kind == Kind::kArc) {
    const Vec2 center = item.center.head<2>();
    return {true, center, Vec2::UnitX(), crosses(item) ? item.radius : (item.start - center).norm()};
  }
  if (item.meet == Meet::kNo) {
    const Vec2 way = planeEnd(item) - item.start;
    return {false, item.start, way / way.norm(), 0.0};
  }
  const Vec2 direction(std::cos(item.angle), std::sin(item.angle));
  return {false, crosses(item) ? planeEnd(item) : item.start, direction, 0.0};
}

/// Takes an angle off an arc. What is left of one that is cut away whole is a line without length.
void shorten(PathItem& item, double cut) {
  constexpr double kTinyAngle = 1e-9;
  if (cut > 2.0 * kPi - kTinyAngle) cut = 0.0;  // rounding: nothing is cut
  item.sweep -= item.sweep < 0.0 ? -cut : cut;
  if (std::abs(item.sweep) < kTinyAngle) item.kind = Kind::kLine;
}

/// The arc ends at `end`, which is on its circle.
void endArc(PathItem& item, const Vec2& end) {
  const double turn = sweepUntil(elementOf(item), end);
  item.sweep = item.sweep < 0.0 ? -turn : turn;
  setPlaneEnd(item, end);
}

}  // namespace

void HoldingStage::clear() {
  holds_ = false;
  functions_.clear();
  pipe_.unlink(*this);
}

void HoldingStage::hold(PathItem& item) {
  held_ = std::move(item);
  holds_ = true;
}

bool HoldingStage::passFunctions() {
  while (!functions_.empty()) {
    PathItem item = std::move(functions_.front());
    functions_.pop_front();
    if (!pass(item)) return false;
  }
  return true;
}

bool CrossingStage::push(PathItem& item) {
  if (item.function()) {
    if (!holds_) return pass(item);
    functions_.push_back(std::move(item));
    return functions_.size() < kMaxWaiting || release();
  }
  if (crosses(item) && !cross(item)) return false;
  if (!release()) return false;
  const bool open = item.comp_on || item.meet == Meet::kOpen;
  if (item.space == PathItem::Space::kProgram && open && feedsInPlane(item)) {
    hold(item);
    return true;
  }
  if (!item.comp_on && item.space == PathItem::Space::kProgram) pipe_.unlink(*this);
  return pass(item);
}

bool CrossingStage::flush(FlushReason) { return release(); }

bool CrossingStage::release() {
  if (!holds_) return true;
  holds_ = false;
  PathItem item = std::move(held_);
  if (item.meet == Meet::kOpen) {
    return report_.contourError(
        SharedAlarm::kOpenLine,
        "a line given by ,A alone needs a block behind it whose line or circle meets it", {}, item);
  }
  if (crosses(item) && item.kind == Kind::kArc) {
    const Vec2 end = planeEnd(item);
    if (std::abs((end - item.center.head<2>()).norm() - item.radius) > kOnCircle) {
      return report_.contourError(SharedAlarm::kCircleRadius, {},
                                  "the end is not on the circle of I, J, K and R", item);
    }
    endArc(item, end);
  }
  return pass(item) && passFunctions();
}

bool CrossingStage::cross(PathItem& item) {
  if (!holds_) {
    return report_.contourError(
        SharedAlarm::kContour, "an over-determined block needs a G1, G2 or G3 block before it, in G41 or G42",
        {}, item);
  }
  const PlaneCurve first = curveOf(held_), second = curveOf(item);
  const auto choice = item.meet == Meet::kSecond ? CrossingChoice::kSecond : CrossingChoice::kFirst;
  std::optional<Vec2> corner;
  if (first.direction.allFinite()) corner = crossingPoint(first, second, held_.start, choice);
  if (!corner || !corner->allFinite()) {
    return report_.contourError(SharedAlarm::kContour, "the block and the one before it have no common point",
                                {}, item);
  }
  if (held_.kind == Kind::kArc) {
    endArc(held_, *corner);
  } else {
    setPlaneEnd(held_, *corner);
  }
  held_.meet = Meet::kNo;
  item.start = *corner;
  return true;
}

bool CornerStage::push(PathItem& item) {
  if (item.function()) {
    if (!holds_) return pass(item);
    functions_.push_back(std::move(item));
    return functions_.size() < kMaxWaiting || flush(FlushReason::kBuffer);
  }
  if (holds_ && !join(item)) return false;
  if (item.join != PathItem::Join::kSharp) {
    --announced_;
    hold(item);
    return true;
  }
  if (announced_ == 0) pipe_.unlink(*this);
  return pass(item);
}

void CornerStage::announce() {
  ++announced_;
  if (!linked()) pipe_.link(*this);
}

void CornerStage::clear() {
  announced_ = 0;
  HoldingStage::clear();
}

bool CornerStage::flush(FlushReason reason) {
  if (!holds_ || reason == FlushReason::kTransform) return true;
  holds_ = false;
  return report_.contourError(SharedAlarm::kNothingBehind, {}, "no G1, G2 or G3 block in the plane follows",
                              held_);
}

Vec3 CornerStage::sentUntil(const Vec3& otherwise) const {
  return holds_ ? Vec3(held_.start.x(), held_.start.y(), held_.to[held_.plane.w]) : otherwise;
}

bool CornerStage::join(PathItem& item) {
  const auto refuse = [&](SharedAlarm alarm, const char* why) {
    return report_.contourError(alarm, {}, why, held_);
  };
  holds_ = false;
  if (item.space != PathItem::Space::kWork || !feedsInPlane(item)) {
    return refuse(SharedAlarm::kCorner, "no G1, G2 or G3 block in the plane follows");
  }
  if (!held_.level || !item.level || held_.plane.u != item.plane.u || held_.plane.v != item.plane.v) {
    return refuse(SharedAlarm::kCorner, "both blocks have to lie in the selected plane");
  }
  if (held_.join_turn != 0 && !turnsAsAsked(held_, item)) {
    return refuse(SharedAlarm::kCorner,
                  "by I, K, C or R the next block goes along the other axis, to the side of the sign");
  }
  item.start = planeEnd(held_);
  CornerJoin join;
  const ContourElement first = elementOf(held_), second = elementOf(item);
  const CornerError error = held_.join == PathItem::Join::kChamfer
                                ? chamferCorner(first, second, held_.join_size, join)
                                : roundCorner(first, second, held_.join_size, join);
  if (error == CornerError::kNoDirection) {
    return refuse(SharedAlarm::kCorner, "a block does not move in the plane");
  }
  if (error == CornerError::kTooLarge) {
    return refuse(SharedAlarm::kCornerTooLarge, "it does not fit the two blocks");
  }
  return sendJoined(item, join);
}

bool CornerStage::sendJoined(PathItem& item, const CornerJoin& join) {
  PathItem first = std::move(held_);
  if (join.none) return pass(first) && passFunctions();
  PathItem inserted = first.copyMotion();
  inserted.keep_vector = false;
  inserted.direction.reset();
  inserted.kind = join.arc ? Kind::kArc : Kind::kLine;
  inserted.start = join.leave;
  inserted.center = {join.center.x(), join.center.y(), first.to[first.plane.w]};
  inserted.sweep = join.sweep;
  setPlaneEnd(inserted, join.enter);
  if (first.kind == Kind::kArc) shorten(first, sweepFrom(elementOf(first), join.leave));
  setPlaneEnd(first, join.leave);
  if (item.kind == Kind::kArc) shorten(item, sweepUntil(elementOf(item), join.enter));
  item.start = join.enter;
  return pass(first) && pass(inserted) && passFunctions();
}

}  // namespace proveout::nc
