// Cutter compensation: blocks go into the look-ahead, pieces come out and become motions.
#include "core/nc/nct/comp_stage.h"

#include <algorithm>

#include "core/nc/nct/nct_feed.h"
#include "core/nc/nct/nct_perform.h"

namespace proveout::nc {
namespace {

std::string describe(CompError error) {
  switch (error) {
    case CompError::kStartInArc:
      return "G41, G42 cannot be switched on in a G2 or G3 block";
    case CompError::kCancelInArc:
      return "G40 in circular interpolation";
    case CompError::kNoIntersection:
      return "no intersection point G41, G42: the tool does not fit into the inner corner";
    case CompError::kInterference:
      return "interference error: the compensated path runs against the programmed one";
    case CompError::kBufferFull:
      return "cutter compensation cannot be continued, buffer full: too many blocks without motion in the "
             "plane";
    case CompError::kSideChange:
      return "the change of side G41, G42 has no solution here";
    case CompError::kCornerArcInside:
      return "G39 on an inner corner";
    case CompError::kNotActive:
      return "G38 and G39 need G41 or G42";
    case CompError::kNotFinite:
    case CompError::kNone:
      break;
  }
  return "cutter compensation: data out of range";
}

const char* codeOf(CompError error) {
  switch (error) {
    case CompError::kCancelInArc:
      return "nct-2043";
    case CompError::kNoIntersection:
      return "nct-2047";
    case CompError::kInterference:
      return "nct-2049";
    case CompError::kBufferFull:
      return "nct-2090";
    default:
      return "nct-cutter-comp";
  }
}

std::string describe(CompWarning warning) {
  switch (warning) {
    case CompWarning::kRepaired:
      return "interference in cutter compensation: this block is left out of the path";
    case CompWarning::kNearTangent:
      return "nearly tangent inner corner without intersection: joined by a short line";
    case CompWarning::kManyPassThrough:
      return "more blocks without motion in the plane than the control promises to look over";
  }
  return {};
}

/// Arcs about one point have the same centre but for rounding, mm; those about corners have others.
constexpr double kSameCentre = 1e-6;

CompBlock blockOf(const PathItem& item) {
  CompBlock block;
  block.to = item.plane.of(item.to);
  block.active = item.comp_on;
  block.offset = item.offset;
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

void CompStage::engage(const Vec3& start) {
  CutterCompPolicy policy;
  policy.interference_check = c_.parameters.flag(CompParam::kInterferenceCheck);
  policy.interference_alarm = c_.parameters.flag(CompParam::kInterferenceAlarm);
  policy.extra_look_ahead = static_cast<int>(c_.parameters[CompParam::kExtraLookAhead]);
  policy.min_step = c_.parameters[CompParam::kMinCompStep];
  filter_ = CutterComp(policy);
  filter_.reset(start);
  waiting_.clear();
  c_.pipe.link(*this);
}

bool CompStage::push(PathItem& item) {
  if (item.space == PathItem::Space::kMachine) return pass(item);
  item.tag = next_tag_++;
  const CompBlock block = blockOf(item);
  waiting_.push_back(std::move(item));
  out_.clear();
  const CompStatus status = filter_.push(block, out_);
  if (!drain(status)) return false;
  if (!filter_.active() && !filter_.pending()) clear();
  return true;
}

bool CompStage::flush(FlushReason reason) {
  if (reason == FlushReason::kTransform) return true;
  out_.clear();
  const CompStatus status = filter_.flush(out_);
  return drain(status);
}

void CompStage::rebase(const AxisPoint& work, const WorkPlane& plane) { filter_.rebase(plane.of(work)); }

void CompStage::clear() {
  waiting_.clear();
  c_.pipe.unlink(*this);
}

void CompStage::report(Severity severity, const char* code, const std::string& message, std::uint64_t tag) {
  const auto item = std::find_if(waiting_.begin(), waiting_.end(),
                                 [&](const PathItem& waiting) { return waiting.tag == tag; });
  if (item != waiting_.end()) return c_.alarms.sendLate(severity, code, message, item->source, item->record);
  if (severity == Severity::kError) {
    c_.fail(code, message);
  } else {
    c_.warn(code, message);
  }
}

bool CompStage::drain(const CompStatus& status) {
  for (const CompNote& note : out_.notes) {
    report(Severity::kWarning, "nct-cutter-comp", describe(note.warning), note.tag);
  }
  for (const CompPiece& piece : out_.pieces) {
    // Pieces come in program order: what lies before is done with, except a block whose corner pieces follow.
    while (!waiting_.empty() && waiting_.front().tag < piece.tag) waiting_.pop_front();
    if (waiting_.empty() || waiting_.front().tag != piece.tag) continue;
    if (!sendPiece(piece, waiting_.front())) return false;
  }
  if (status.ok()) return true;
  report(Severity::kError, codeOf(status.error), describe(status.error), status.tag);
  recover(c_);
  return false;
}

bool CompStage::sendPiece(const CompPiece& piece, PathItem& item) {
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
    const bool concentric = (out.center - item.center).head<2>().norm() < kSameCentre;
    if (item.kind == PathItem::Kind::kArc && concentric) {
      const Vec3 programmed = item.plane.of(item.to) - item.center;
      const Vec3 corrected = piece.to - out.center;
      out.feed.feed *=
          insideArcFactor(c_.parameters, programmed.head<2>().norm(), corrected.head<2>().norm());
    }
  }
  if (out.feed.join.inside != 0) out.feed.join.inside = item.offset < 0.0 ? -1 : 1;
  return pass(out);
}

}  // namespace proveout::nc
