// Cutter compensation: blocks go into the look-ahead, pieces come out and become motions.
#include <fmt/core.h>

#include "core/nc/nct/nct_perform.h"

namespace proveout::nc {

Vec3 workPlanePosition(const NctContext& c) {
  return PlaneFrame(c.state.plane()).toPlane(c.chain.toWork(c.position.xyz));
}

bool engageComp(NctContext& c, const BlockPlan& plan) {
  CutterCompPolicy policy;
  policy.interference_check = c.parameters.flag(CompParam::kInterferenceCheck);
  policy.interference_alarm = c.parameters.flag(CompParam::kInterferenceAlarm);
  policy.extra_look_ahead = static_cast<int>(c.parameters[CompParam::kExtraLookAhead]);
  policy.min_step = c.parameters[CompParam::kMinCompStep];
  c.comp.filter = CutterComp(policy);
  c.comp.filter.reset(PlaneFrame(plan.next.plane()).toPlane(c.chain.toWork(c.position.xyz)));
  c.comp.engaged = true;
  c.comp.waiting.clear();
  return true;
}

namespace {

bool drainComp(NctContext& c, const CompStatus& status);
void runPiece(NctContext& c, const CompPiece& piece, Action& action);

}  // namespace

bool pushComp(NctContext& c, const CompBlock& block, Action action) {
  CompBlock tagged = block;
  tagged.tag = action.tag = c.comp.next_tag++;
  c.comp.waiting.push_back(std::move(action));
  c.comp.out.clear();
  const CompStatus status = c.comp.filter.push(tagged, c.comp.out);
  if (!drainComp(c, status)) return false;
  if (!c.comp.filter.active() && !c.comp.filter.pending()) {
    c.comp.engaged = false;
    c.comp.waiting.clear();
  }
  return true;
}

bool flushComp(NctContext& c) {
  c.comp.out.clear();
  const CompStatus status = c.comp.filter.flush(c.comp.out);
  return drainComp(c, status);
}

void rebaseComp(NctContext& c) { c.comp.filter.rebase(workPlanePosition(c)); }

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

bool drainComp(NctContext& c, const CompStatus& status) {
  const auto source_of = [&](std::uint64_t tag) {
    for (const Action& a : c.comp.waiting) {
      if (a.tag == tag) return a.source;
    }
    return c.here();
  };
  for (const CompNote& note : c.comp.out.notes) {
    c.alarms.send(c.alarms.diagnosticAt(Severity::kWarning, "nct-cutter-comp", describe(note.warning),
                                        source_of(note.tag), {}));
  }
  for (const CompPiece& piece : c.comp.out.pieces) {
    // Pieces come in program order: what lies before is done with, except a block whose corner pieces follow.
    while (!c.comp.waiting.empty() && c.comp.waiting.front().tag < piece.tag) c.comp.waiting.pop_front();
    if (c.comp.waiting.empty() || c.comp.waiting.front().tag != piece.tag) continue;
    runPiece(c, piece, c.comp.waiting.front());
  }
  if (status.ok()) return true;
  c.alarms.send(c.alarms.diagnosticAt(Severity::kError, codeOf(status.error), describe(status.error),
                                      source_of(status.tag), {}));
  c.comp.engaged = false;
  c.comp.waiting.clear();
  settle(c, c.emitter.machine());  // a run that goes on behind errors goes on from where the tool is
  return false;
}

void runPiece(NctContext& c, const CompPiece& piece, Action& action) {
  if (action.kind != Action::Kind::kMove) {
    runAction(c, action);
    return;
  }
  const PlaneFrame frame(c.state.plane());
  AxisPoint to = action.to;  // axes outside the plane arrive with the block's last piece
  to.xyz = c.chain.workToMachine(frame.fromPlane(piece.to));
  if (!piece.is_arc) {
    if (action.rapid) {
      c.emitter.rapidTo(to, action.source);
    } else {
      c.emitter.lineTo(to, action.feed, action.source);
    }
    return;
  }
  MachineArc arc;
  arc.center = c.chain.workToMachine(frame.fromPlane({piece.center.x(), piece.center.y(), piece.from.z()}));
  arc.normal = c.chain.directionToMachine(frame.normal());
  arc.sweep_rad = piece.sweep_rad;
  c.emitter.arcTo(to, arc, action.feed, action.source);
}

}  // namespace

}  // namespace proveout::nc
