// Cutter compensation: blocks go into the look-ahead, pieces come out and become motions.
#include <fmt/core.h>

#include "core/nc/nct/nct_control.h"

namespace proveout::nc {

Vec3 NctControl::workPlanePosition() const {
  return PlaneFrame(state_.plane()).toPlane(chain_.toWork(position_));
}

bool NctControl::engageComp(const BlockPlan& plan) {
  CutterCompPolicy policy;
  policy.interference_check = parameters_.flag(NctParam::kInterferenceCheck);
  policy.interference_alarm = parameters_.flag(NctParam::kInterferenceAlarm);
  policy.extra_look_ahead = static_cast<int>(parameters_[NctParam::kExtraLookAhead]);
  policy.min_step = parameters_[NctParam::kMinCompStep];
  comp_ = CutterComp(policy);
  comp_.reset(PlaneFrame(plan.next.plane()).toPlane(chain_.toWork(position_)));
  comp_engaged_ = true;
  waiting_.clear();
  return true;
}

bool NctControl::pushComp(const CompBlock& block, Action action) {
  CompBlock tagged = block;
  tagged.tag = action.tag = next_tag_++;
  waiting_.push_back(std::move(action));
  comp_out_.clear();
  const CompStatus status = comp_.push(tagged, comp_out_);
  if (!drainComp(status)) return false;
  if (!comp_.active() && !comp_.pending()) {
    comp_engaged_ = false;
    waiting_.clear();
  }
  return true;
}

bool NctControl::flushComp() {
  comp_out_.clear();
  const CompStatus status = comp_.flush(comp_out_);
  return drainComp(status);
}

void NctControl::rebaseComp() { comp_.rebase(workPlanePosition()); }

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
      return "cutter compensation cannot be continued: too many blocks without motion in the plane";
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

}  // namespace

bool NctControl::drainComp(const CompStatus& status) {
  const auto source_of = [&](std::uint64_t tag) {
    for (const Action& a : waiting_) {
      if (a.tag == tag) return a.source;
    }
    return here();
  };
  for (const CompNote& note : comp_out_.notes) {
    emitter_.diagnostic(
        diagnosticAt(Severity::kWarning, "nct-cutter-comp", describe(note.warning), source_of(note.tag), {}));
  }
  for (const CompPiece& piece : comp_out_.pieces) {
    // Pieces come in program order: what lies before is done with, except a block whose corner pieces follow.
    while (!waiting_.empty() && waiting_.front().tag < piece.tag) waiting_.pop_front();
    if (waiting_.empty() || waiting_.front().tag != piece.tag) continue;
    runPiece(piece, waiting_.front());
  }
  if (status.ok()) return true;
  emitter_.diagnostic(diagnosticAt(Severity::kError, codeOf(status.error), describe(status.error),
                                   source_of(status.tag), {}));
  comp_engaged_ = false;
  waiting_.clear();
  settle(emitter_.machine());  // a run that goes on behind errors goes on from where the tool is
  return false;
}

void NctControl::runPiece(const CompPiece& piece, Action& action) {
  if (action.kind != Action::Kind::kMove) {
    run(action);
    return;
  }
  const PlaneFrame frame(state_.plane());
  const Vec3 to = chain_.workToMachine(frame.fromPlane(piece.to));
  if (!piece.is_arc) {
    emitMove(action, to, nullptr, chain_);
    return;
  }
  MachineArc arc;
  arc.center = chain_.workToMachine(frame.fromPlane({piece.center.x(), piece.center.y(), piece.from.z()}));
  arc.normal = chain_.directionToMachine(frame.normal());
  arc.sweep_rad = piece.sweep_rad;
  emitter_.arcTo(to, arc, action.feed, action.source);
}

}  // namespace proveout::nc
