#include "core/nc/stages/compensation_stage.h"

#include <algorithm>
#include <utility>

namespace proveout::nc {

namespace {

CompBlock blockOf(const PathItem& item) {
  CompBlock block;
  block.to = item.plane.of(item.to);
  block.active = item.comp_on;
  block.offset = item.offset;
  block.decimal = item.decimal;
  block.direction = item.direction;
  block.keep_vector = item.keep_vector;
  block.tag = item.tag;
  if (item.kind == PathItem::Kind::kArc) {
    block.shape = CompBlock::Shape::kArc;
    block.center = item.center.head<2>();
    block.sweep_rad = item.sweep;
  } else if (item.kind == PathItem::Kind::kLine && item.in_plane) {
    block.shape = CompBlock::Shape::kLine;
  } else if (item.kind == PathItem::Kind::kCornerArc) {
    block.shape = CompBlock::Shape::kCornerArc;
  }
  return block;
}

}  // namespace

void CompensationStage::begin(const CutterCompPolicy& policy, const Vec3& start) {
  filter_ = CutterComp(policy);
  filter_.reset(start);
  waiting_.clear();
  pipe_.link(*this);
}

const PathItem* CompensationStage::waiting(std::uint64_t tag) const {
  const auto item = std::find_if(waiting_.begin(), waiting_.end(),
                                 [&](const PathItem& waiting) { return waiting.tag == tag; });
  return item == waiting_.end() ? nullptr : &*item;
}

bool CompensationStage::push(PathItem& item) {
  if (item.space == PathItem::Space::kMachine) return pass(item);
  if (item.idle) {
    filter_.idle();
    return true;
  }
  if (!accepts(item)) return false;
  const bool on = item.comp_on;
  item.tag = next_tag_++;
  const CompBlock block = blockOf(item);
  waiting_.push_back(std::move(item));
  out_.clear();
  const CompStatus status = filter_.push(block, out_);
  if (!drain(status)) return false;
  if (!filter_.active() && !filter_.pending() && !filter_.displaced() && !on) clear();
  return true;
}

bool CompensationStage::flush(FlushReason reason) {
  if (reason == FlushReason::kTransform) return true;
  out_.clear();
  const CompStatus status = filter_.flush(out_);
  return drain(status);
}

bool CompensationStage::sendBefore(const PathItem& refused) {
  out_.clear();
  const CompStatus status = filter_.halt(blockOf(refused), out_);
  return drain(status);
}

void CompensationStage::rebase(const AxisPoint& work, const WorkPlane& plane) {
  filter_.rebase(plane.of(work));
}

void CompensationStage::clear() {
  waiting_.clear();
  pipe_.unlink(*this);
}

bool CompensationStage::drain(const CompStatus& status) {
  for (const CompNote& told : out_.notes) note(told);
  for (const CompPiece& piece : out_.pieces) {
    // Pieces come in program order: what lies before is done with, except a block whose corner pieces follow.
    while (!waiting_.empty() && waiting_.front().tag < piece.tag) waiting_.pop_front();
    if (waiting_.empty() || waiting_.front().tag != piece.tag) continue;
    if (!sendPiece(piece, waiting_.front())) return false;
  }
  if (status.ok()) return true;
  failed(status);
  return false;
}

bool CompensationStage::sendPiece(const CompPiece& piece, PathItem& item) {
  if (item.function()) return pass(item);
  PathItem out = item.copyMotion();
  out.kind = piece.is_arc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
  out.to[item.plane.u] = piece.to.x();
  out.to[item.plane.v] = piece.to.y();
  out.to[item.plane.w] = piece.to.z();
  if (piece.is_arc) {
    out.center = {piece.center.x(), piece.center.y(), piece.from.z()};
    out.start = piece.from.head<2>();
    out.sweep = piece.sweep_rad;
  }
  return send(piece, item, out);
}

}  // namespace proveout::nc
