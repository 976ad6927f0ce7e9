#include "core/nc/linuxcnc/stages/comp_stage.h"

#include <utility>

namespace proveout::nc {
namespace {

const char* lcnDescribe(ArcCornerFault fault) {
  switch (fault) {
    case ArcCornerFault::kEntryTooShort:
      return "Length of cutter compensation entry move is not greater than the tool radius";
    case ArcCornerFault::kArcTooSmall:
      return "Tool radius not less than arc radius with cutter radius compensation";
    case ArcCornerFault::kLineGouges:
      return "Straight feed in concave corner cannot be reached by the tool without gouging";
    case ArcCornerFault::kArcGouges:
      return "Arc move in concave corner cannot be reached by the tool without gouging";
    case ArcCornerFault::kNoMeeting:
      return "the moves make a corner that the compensated tool cannot fit in without gouging";
    default:
      return "cutter compensation: data out of range";
  }
}

}  // namespace

Vec2 linuxCncTipShift(int orientation) {
  Vec2 shift = Vec2::Zero();
  if (orientation == 1 || orientation == 2 || orientation == 6) shift.y() = -1.0;
  if (orientation == 3 || orientation == 4 || orientation == 8) shift.y() = 1.0;
  if (orientation == 2 || orientation == 3 || orientation == 7) shift.x() = -1.0;
  if (orientation == 1 || orientation == 4 || orientation == 5) shift.x() = 1.0;
  return shift;
}

void LinuxCncCompStage::engage(const Vec3& start) {
  filter_.reset(start);
  waiting_.clear();
  pipe_.link(*this);
}

bool LinuxCncCompStage::end() {
  if (!flush(FlushReason::kEnd)) return false;
  clear();
  return true;
}

bool LinuxCncCompStage::push(PathItem& item) {
  if (item.space == PathItem::Space::kMachine) return flush(FlushReason::kBuffer) && pass(item);
  if (!item.function() && !item.comp_on) return flush(FlushReason::kBuffer) && pass(item);
  const bool function = item.function();
  ArcCornerMove move;
  move.tag = item.tag = next_tag_++;
  move.to = item.plane.of(item.to);
  move.arc = item.kind == PathItem::Kind::kArc;
  move.offset = item.offset;
  if (move.arc) {
    move.center = item.center.head<2>();
    move.sweep = item.sweep;
  }
  waiting_.push_back(std::move(item));
  pieces_.clear();
  if (!function) return drain(filter_.push(move, pieces_));
  filter_.follow(move.tag, filter_.center().z(), pieces_);
  return drain(ArcCornerFault::kNone);
}

bool LinuxCncCompStage::flush(FlushReason reason) {
  if (reason == FlushReason::kTransform) return true;
  pieces_.clear();
  const ArcCornerFault fault = filter_.flush(pieces_);
  return drain(fault);
}

void LinuxCncCompStage::rebase(const AxisPoint& work, const WorkPlane& plane) {
  filter_.reset(plane.of(work));
}

void LinuxCncCompStage::clear() {
  waiting_.clear();
  pipe_.unlink(*this);
}

bool LinuxCncCompStage::drain(ArcCornerFault fault) {
  for (const ArcCornerPiece& piece : pieces_) {
    while (!waiting_.empty() && waiting_.front().tag < piece.tag) waiting_.pop_front();
    if (waiting_.empty() || waiting_.front().tag != piece.tag) continue;
    if (!sendPiece(piece)) return false;
  }
  if (fault == ArcCornerFault::kNone) return true;
  alarms_.fail("comp", lcnDescribe(fault));
  recovery_.recover();
  return false;
}

bool LinuxCncCompStage::sendPiece(const ArcCornerPiece& piece) {
  PathItem& item = waiting_.front();
  if (item.function()) return pass(item);
  PathItem out = item.copyMotion();
  const Vec2 shift = std::abs(item.offset) * linuxCncTipShift(item.tip);
  // Around a corner in front of a rapid the tool goes straight, by rapid.
  const bool arc = piece.arc && !(piece.kind == ArcCornerPiece::Kind::kCorner && item.rapid);
  out.kind = arc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
  const Vec2 to = piece.to.head<2>() + shift;
  out.to[item.plane.u] = to.x();
  out.to[item.plane.v] = to.y();
  out.to[item.plane.w] = piece.to.z();
  if (arc) {
    const Vec2 center = piece.center + shift;
    out.center = {center.x(), center.y(), piece.from.z()};
    out.start = piece.from.head<2>() + shift;
    out.sweep = piece.sweep;
  }
  return pass(out);
}

}  // namespace proveout::nc
