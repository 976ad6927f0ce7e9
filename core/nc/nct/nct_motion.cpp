// Plans of the codes that move: G0 G1 G2 G3 G4 G28 G30 G53.
#include <fmt/core.h>

#include <cmath>

#include "core/nc/nct/nct_control.h"

namespace proveout::nc {

bool NctControl::planRapid(BlockPlan& plan) {
  if (!axisTarget(plan, plan.target)) return false;
  if (!anyAxisWord()) return true;
  plan.deed = BlockPlan::Deed::kMove;
  plan.rapid = true;
  return true;
}

bool NctControl::planLine(BlockPlan& plan) {
  if (!axisTarget(plan, plan.target)) return false;
  if (!anyAxisWord()) return true;
  plan.deed = BlockPlan::Deed::kMove;
  plan.rapid = false;
  return feedStyle(plan, plan.feed);
}

namespace {

struct ArcFailure {
  const char* code;
  const char* message;
};

ArcFailure describe(ArcError error) {
  switch (error) {
    case ArcError::kNoDefinition:
      return {"nct-2015", "circle definition error: neither R nor I, J, K is given"};
    case ArcError::kCenterOutsidePlane:
      return {"nct-2015", "circle definition error: a centre word does not belong to the selected plane"};
    case ArcError::kRadiusWithoutEnd:
      return {"nct-2015", "circle definition error: R needs an end point in the plane"};
    case ArcError::kZeroRadius:
      return {"nct-2015", "circle definition error: the radius is 0"};
    case ArcError::kRadiusDifference:
      return {"nct-2012", "circle radius difference error"};
    case ArcError::kBadTurns:
      return {"nct-2002", "L data out of range: the number of turns is an integer from 1"};
    case ArcError::kNotFinite:
    case ArcError::kNone:
      break;
  }
  return {"nct-2002", "circle data out of range"};
}

}  // namespace

double NctControl::radiusTolerance() const {
  // The machine builder sets N1339. A job that does not give it leaves open whether the real control would
  // alarm: up to this difference the arc then runs as a spiral with a warning. 2 mm lets sloppy but harmless
  // arcs of real programs through and still refuses a wrong centre.
  constexpr double kUnknownMachineMm = 2.0;
  if (parameters_.given(NctParam::kRadiusDifference)) return parameters_[NctParam::kRadiusDifference];
  return kUnknownMachineMm;
}

bool NctControl::arcRequest(const BlockPlan& plan, ArcRequest& request) {
  const PlaneFrame frame(plan.next.plane());
  request.start = frame.toPlane(plan.start);
  request.end = frame.toPlane(plan.target);
  request.has_plane_end =
      plan.named[static_cast<std::size_t>(frame.u())] || plan.named[static_cast<std::size_t>(frame.v())];
  request.has_other_axis = plan.named[static_cast<std::size_t>(frame.w())];
  request.counter_clockwise = plan.next.active[kGroupMotion] == 30;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    double value = lengthOf(plan, *w);
    if (parameters_.flag(NctParam::kAbsoluteCentre)) value -= plan.start[axis];
    if (axis == frame.w()) request.center_word_outside_plane = true;
    if (axis == frame.u()) request.center_u = value;
    if (axis == frame.v()) request.center_v = value;
  }
  if (const Word* r = ownWord(plan, 'R')) request.radius = lengthOf(plan, *r);
  if (const Word* l = ownWord(plan, 'L')) {
    std::int64_t turns = 0;
    if (!integerWord(*l, 1, 99999999, turns)) return false;
    request.turns = turns;
  }
  return true;
}

bool NctControl::failArc(const ArcResolution& resolved) {
  const ArcFailure failure = describe(resolved.error);
  std::string message = failure.message;
  if (resolved.error == ArcError::kRadiusDifference) {
    message += fmt::format(": {:.6g} mm between start and end radius, {:.6g} allowed",
                           resolved.radius_difference, radiusTolerance());
  }
  return fail(failure.code, std::move(message));
}

bool NctControl::planArc(BlockPlan& plan) {
  if (!axisTarget(plan, plan.target)) return false;
  const bool arc_word = !(block_.present & AddressSet("IJKR")).without(plan.claimed).empty();
  if (!anyAxisWord() && !arc_word) return true;  // F, M or nothing: no motion
  ArcRequest request;
  if (!arcRequest(plan, request)) return false;
  ArcPolicy policy;
  policy.radius_tolerance = radiusTolerance();
  const ArcResolution resolved = resolveArc(request, policy);
  if (!resolved.ok()) return failArc(resolved);
  if (!request.turns && resolved.radius_difference > parameters_[NctParam::kRadiusDifference]) {
    warn("nct-2012",
         fmt::format(
             "start and end radius differ by {:.6g} mm: run as a spiral, because the job does not give "
             "N1339; a control with a smaller N1339 stops here with alarm 2012",
             resolved.radius_difference));
  }
  if (resolved.center_ignored) warn("nct-arc-both", "R and I, J, K in one block: R counts");
  if (resolved.no_motion) {
    plan.target = plan.start;
    return true;
  }
  plan.deed = BlockPlan::Deed::kMove;
  plan.is_arc = true;
  plan.arc = resolved.arc;
  if (!feedStyle(plan, plan.feed)) return false;
  const bool spiral = resolved.radius_difference > 1e-9;
  plan.feed.along = parameters_.flag(NctParam::kHelixFeedSpace) ? FeedStyle::Along::kSpace
                    : spiral && !request.turns                  ? FeedStyle::Along::kStartRadius
                                                                : FeedStyle::Along::kPlane;
  return true;
}

bool NctControl::planDwell(BlockPlan& plan) {
  plan.deed = BlockPlan::Deed::kDwell;
  plan.target = plan.start;
  const Word* p = ownWord(plan, 'P');
  if (p == nullptr) {
    warn("nct-2004", "G4 without P: no dwell");
    return true;
  }
  if (p->value < 0.0) return failWord("nct-2002", "P data out of range: a dwell is not negative", *p);
  const bool turns = plan.next.perTurn() && !parameters_.flag(NctParam::kDwellSeconds);
  plan.dwell_s = turns ? p->value * 60.0 / turnsPerMinute(plan) : p->value;
  return true;
}

bool NctControl::planMachineMove(BlockPlan& plan) {
  plan.target = machine_;
  if (!anyAxisWord()) return true;  // G53 alone only empties the buffer
  for (const Word& w : block_.words) {
    const bool secondary = w.address >= 'U' && w.address <= 'W';
    const bool axis_word = w.address >= 'X' && w.address <= 'Z';
    if (secondary || (axis_word && w.incremental)) {
      return failWord("nct-2097",
                      fmt::format("illegal incremental movement on axis {}: G53 is always absolute",
                                  addressText(w.address)),
                      w);
    }
    if (axis_word) plan.target[w.address - 'X'] = lengthOf(plan, w);
  }
  if (!settings_.reference_points[0]) {
    warnOnce("machine-zero", "nct-machine-zero",
             "G53: the job gives no reference point, so machine zero is only as good as its work offsets");
  }
  plan.deed = BlockPlan::Deed::kMachineMove;
  return true;
}

bool NctControl::planReference(BlockPlan& plan) {
  std::int64_t point = 1;
  if (plan.by_group[kOneShot]->code10 == 300) {
    const Word* p = ownWord(plan, 'P');
    if (p == nullptr) return fail("nct-2004", "missing data P: G30 needs the number of the reference point");
    if (!integerWord(*p, 1, 4, point)) return false;
  }
  if (!axisTarget(plan, plan.via)) return false;
  plan.target = machine_;
  if (!anyAxisWord()) {
    warn("nct-2004", "no axis is named: no motion");
    return true;
  }
  const auto& given = settings_.reference_points[static_cast<std::size_t>(point - 1)];
  const Vec3 reference = given.value_or(settings_.start + emitter_.workpieceOrigin());
  if (!given) {
    warnOnce(fmt::format("reference{}", point), "nct-reference",
             fmt::format("the job does not give reference point {}: the start position is taken", point));
  }
  // Machine position after the intermediate point, then the named axes at the reference point.
  plan.target = plan.chain.toMachine(plan.via);
  for (int axis = 0; axis < 3; ++axis) {
    if (plan.named[static_cast<std::size_t>(axis)]) plan.target[axis] = reference[axis];
  }
  plan.deed = BlockPlan::Deed::kReference;
  return true;
}

}  // namespace proveout::nc
