// Plans of the codes that move: G0 G1 G2 G3 G4 G28 G30 G53.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/five_axis/tip_control.h"
#include "core/nc/iso/motion/contour.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/motion/held_way.h"
#include "core/nc/iso/motion/machine_moves.h"
#include "core/nc/iso/motion/planes.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/perform/unused_words.h"
#include "core/nc/stages/tool_change.h"

namespace proveout::nc {

namespace {

/// A block that switches cutter compensation on or off and names an axis of the plane, without a way in it:
/// the tool goes onto its offset, or off it, by feed even under G0 (manual 15.5.1; 15.5.3 does not say it of
/// the end).
bool stepsAside(const IsoContext& c, const BlockPlan& plan) {
  if (plan.next.compOn() == c.state.compOn()) return false;
  const WorkPlane plane = plan.next.workPlane();
  const AxisPoint &from = plan.start, &to = plan.motion.target;
  const bool named = plan.motion.named[static_cast<std::size_t>(plane.u)] ||
                     plan.motion.named[static_cast<std::size_t>(plane.v)];
  return named && from[plane.u] == to[plane.u] && from[plane.v] == to[plane.v];
}

}  // namespace

bool planRapid(IsoContext& c, BlockPlan& plan) {
  if (!axisTarget(c, plan, plan.motion.target) || !planDirection(c, plan)) return false;
  if (!namesMotion(c, plan)) return true;
  plan.perform = performMove;
  if (stepsAside(c, plan) && (plan.next.compOffset() != 0.0 || c.state.compOffset() != 0.0)) {
    plan.motion.rapid = plan.next.feed <= 0.0;
    if (!plan.motion.rapid) return feedStyle(c, plan, plan.motion.feed);
    c.warn("feed", "onto the offset or off it the tool goes by feed here, and there is no F: rapid is taken");
  }
  plan.motion.rapid = true;
  plan.motion.feed.join.stops = joinOf(plan).stops;
  return true;
}

bool planLine(IsoContext& c, BlockPlan& plan) {
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  if (hasContourWords(c.block) ? !planLineContour(c, plan) : !refuseChoice(c, plan)) return false;
  if (!namesMotion(c, plan) && plan.motion.meet == PathItem::Meet::kNo) return true;
  plan.perform = performMove;
  plan.motion.rapid = false;
  return feedStyle(c, plan, plan.motion.feed);
}

namespace {

struct ArcFailure {
  SharedAlarm code;
  const char *subject, *detail;
};

ArcFailure describe(ArcError error) {
  switch (error) {
    case ArcError::kNoDefinition:
      return {SharedAlarm::kCircle, "", "neither R nor I, J, K is given"};
    case ArcError::kCenterOutsidePlane:
      return {SharedAlarm::kCircleCentre, "", "a centre word does not belong to the selected plane"};
    case ArcError::kRadiusWithoutEnd:
      return {SharedAlarm::kCircle, "", "R needs an end point in the plane"};
    case ArcError::kZeroRadius:
      return {SharedAlarm::kCircle, "", "the radius is 0"};
    case ArcError::kRadiusDifference:
      return {SharedAlarm::kCircleRadius, "", ""};
    case ArcError::kBadTurns:
      return {SharedAlarm::kOutOfRange, "L", "the number of turns is an integer from 1"};
    case ArcError::kNotFinite:
    case ArcError::kNone:
      break;
  }
  return {SharedAlarm::kOutOfRange, "circle", ""};
}

}  // namespace

namespace {

/// A difference of radii that controls usually let through, mm: beyond it a job that does not give N1339 is
/// told.
constexpr double kUsualDifferenceMm = 0.01;
/// An arc whose radius does not fit and that leads farther away from its start has a slip in its centre, mm.
constexpr double kFarthestMm = 1e4;

bool arcRequest(IsoContext& c, const BlockPlan& plan, ArcRequest& request) {
  const PlaneFrame frame(plan.next.plane());  // of the letters I, J, K
  const WorkPlane plane = plan.next.workPlane();
  request.start = plane.of(plan.start);
  request.end = plane.of(plan.motion.target);
  AxisSet others = plan.motion.named;
  request.has_plane_end =
      others[static_cast<std::size_t>(plane.u)] || others[static_cast<std::size_t>(plane.v)];
  others.reset(static_cast<std::size_t>(plane.u)).reset(static_cast<std::size_t>(plane.v));
  request.has_other_axis = others.any();
  request.counter_clockwise = plan.next.active[kGroupMotion] == gcode::kArcCounterClockwise;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    if (plan.next.axes.mode == VirtualMode::kCylinder) {
      return c.alarm(SharedAlarm::kIllegalAddress, *w, "arcs during G7.1 are given by R");
    }
    double value = lengthOf(plan, *w);
    if (value == 0.0 && axis == frame.w() && c.dialect.rules.loose_arcs) continue;
    if (c.parameters.flag(MotionParam::kAbsoluteCentre)) {
      value -= plan.start[axis == frame.u() ? plane.u : axis == frame.v() ? plane.v : axis];
    }
    if (axis == frame.w()) request.center_word_outside_plane = true;
    if (axis == frame.u()) request.center_u = value;
    if (axis == frame.v()) request.center_v = value;
  }
  if (const Word* r = c.ownWord(plan, 'R')) request.radius = lengthOf(plan, *r);
  if (const Word* l = c.ownWord(plan, 'L')) {
    std::int64_t turns = 0;
    if (!integerWord(c, *l, 1, 99999999, turns)) return false;
    request.turns = turns;
  }
  return true;
}

bool failArc(IsoContext& c, const ArcResolution& resolved) {
  const ArcFailure failure = describe(resolved.error);
  std::string detail = failure.detail;
  if (resolved.error == ArcError::kRadiusDifference) {
    detail = fmt::format("{:.6g} mm between start and end radius, {:.6g} allowed", resolved.radius_difference,
                         c.parameters[MotionParam::kRadiusDifference]);
  }
  return c.alarm(failure.code, failure.subject, detail);
}

/// G16: an angle beyond a turn makes so many turns where the pole is the centre (manual 5.4).
void takePolarTurns(BlockPlan& plan, const ArcRequest& request) {
  constexpr double kSamePoleMm = 1e-3;
  const double turn = plan.motion.polar_turn_deg;
  PlaneArc& arc = plan.motion.arc;
  const bool agrees = request.counter_clockwise ? turn > 360.0 : turn < -360.0;
  const bool bounded = std::abs(turn) <= 3.6e8;
  if (agrees && bounded && !request.turns && arc.center.norm() <= kSamePoleMm) arc.sweep_rad = degToRad(turn);
}

/// Arcs that are no helices in the part go along chords: so many turns would not fit any memory.
bool checkTurns(IsoContext& c, const BlockPlan& plan) {
  constexpr double kMostRad = 200.0 * kPi;
  constexpr double kMostTurns = 10000.0, kMostOfSpirals = 1000.0, kSameRadiusMm = 1e-6;
  const PlaneArc& arc = plan.motion.arc;
  if (std::abs(arc.sweep_rad) <= kMostRad) return true;
  const bool spiral = std::abs(arc.startRadius() - arc.endRadius()) > kSameRadiusMm;
  const double most = spiral ? kMostOfSpirals : kMostTurns;
  if (std::abs(arc.sweep_rad) > most * 2.0 * kPi + 1e-6) {
    return c.alarm(SharedAlarm::kOutOfRange, c.ownWord(plan, 'L') != nullptr ? "L" : "",
                   fmt::format("more than {:g} turns of a {} in one block are not simulated", most,
                               spiral ? "spiral" : "circle"));
  }
  const WorkPlane plane = plan.next.workPlane();
  bool odd = plane.u >= kMainAxes || plane.v >= kMainAxes;
  for (int axis = kMainAxes; axis < c.axes.count(); ++axis) {
    odd = odd || plan.motion.named[static_cast<std::size_t>(axis)];
  }
  return !odd || c.alarm(SharedAlarm::kOutOfRange, "L",
                         "more than 100 turns with parallel or rotary axes are not simulated");
}

}  // namespace

bool planArc(IsoContext& c, BlockPlan& plan) {
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  const bool arc_word = !(c.block.present & AddressSet("IJKR")).without(plan.claimed).empty();
  if (!c.anyAxisWord() && !arc_word) return refuseChoice(c, plan) && planJoin(c, plan);  // F, M or nothing
  if (!planeOfLines(c, plan, SharedAlarm::kCircle, "circles need linear axes")) return false;
  if (overdeterminedArc(c, plan)) {
    plan.perform = performMove;
    return planOverdeterminedArc(c, plan) && planJoin(c, plan) && feedStyle(c, plan, plan.motion.feed);
  }
  ArcRequest request;
  if (!refuseChoice(c, plan) || !arcRequest(c, plan, request)) return false;
  ArcPolicy policy;
  policy.radius_tolerance = c.parameters[MotionParam::kRadiusDifference];
  if (c.dialect.rules.loose_arcs && policy.radius_tolerance == 0.0)
    policy.radius_tolerance = std::numeric_limits<double>::infinity();
  policy.short_radius_is_half = c.dialect.rules.short_radius_is_half;
  const ArcResolution resolved = resolveArc(request, policy);
  if (!resolved.ok()) return failArc(c, resolved);
  const bool open = !c.parameters.given(MotionParam::kRadiusDifference);
  const bool differs = !request.turns && open && resolved.radius_difference > kUsualDifferenceMm;
  if (const double away = farthestFromStart(resolved.arc); differs && away > kFarthestMm) {
    return c.alarm(
        SharedAlarm::kCircleRadius, "",
        fmt::format("{:.6g} mm between start and end radius, and the arc leads {:.0f} m away from its start",
                    resolved.radius_difference, 1e-3 * away));
  }
  if (differs) {
    c.warn(SharedAlarm::kCircleRadius,
           fmt::format(
               "start and end radius differ by {0:.6g} mm: run as a spiral, because the job does not give "
               "{1}; a control with a smaller {1} stops here with alarm {2}",
               resolved.radius_difference, c.parameters.name(MotionParam::kRadiusDifference),
               c.alarms.table().number(SharedAlarm::kCircleRadius)));
  }
  if (resolved.center_ignored) c.warn("arc-both", "R and I, J, K in one block: R counts");
  if (resolved.no_motion) {
    plan.motion.target = plan.start;
    if (const Word* r = c.ownWord(plan, 'R')) {
      tellUnused(c, *r, gName(plan.next.active[kGroupMotion]),
                 "the arc ends where it starts; a full circle needs I, J or K");
    }
    return planJoin(c, plan);
  }
  plan.perform = performMove;
  plan.motion.is_arc = true;
  plan.motion.arc = resolved.arc;
  plan.motion.by_radius = request.radius.has_value();
  takePolarTurns(plan, request);
  if (!checkTurns(c, plan) || !carryArc(c, plan)) return false;
  if (!planJoin(c, plan) || !feedStyle(c, plan, plan.motion.feed)) return false;
  if (plan.next.active[kGroupFeedMode] == gcode::kInverseTime) return true;
  const bool spiral = resolved.radius_difference > 1e-9;
  plan.motion.feed.along = c.parameters.flag(MotionParam::kHelixFeedSpace) ? FeedStyle::Along::kSpace
                           : spiral && !request.turns                      ? FeedStyle::Along::kStartRadius
                                                                           : FeedStyle::Along::kPlane;
  return true;
}

bool performDwell(IsoContext& c, BlockPlan& plan) {
  PathItem item = functionItem(c, PathItem::Kind::kDwell, plan.next);
  item.value = std::get<Dwell>(plan.payload).seconds;
  return c.pipe.push(item);
}

bool planDwell(IsoContext& c, BlockPlan& plan) {
  plan.perform = performDwell;
  Dwell& dwell = plan.payload.emplace<Dwell>();
  plan.motion.target = plan.start;
  const Word* p = c.ownWord(plan, 'P');
  if (p == nullptr) {
    c.warn(SharedAlarm::kMissingData, "G4 without P: no dwell");
    return true;
  }
  if (p->value < 0.0) return c.alarm(SharedAlarm::kOutOfRange, *p, "a dwell is not negative");
  const bool turns = plan.next.perTurn() && !c.parameters.flag(MotionParam::kDwellSeconds);
  dwell.seconds = turns ? p->value * 60.0 / turnsPerMinute(c, plan) : p->value;
  return true;
}

bool performMachineMove(IsoContext& c, BlockPlan& plan) {
  const MachineMove& move = std::get<MachineMove>(plan.payload);
  if (move.has_via && !sendMachineRapid(c, move.via)) return false;
  if (!sendMachineRapid(c, move.to)) return false;
  endHeldWay(c, plan, move.to);
  c.settle(move.to);
  return true;
}

Vec3 homeOf(const IsoContext& c) {
  Vec3 home = c.emitter.home();
  const auto way = toolChangeWay(c.settings, AxisPoint(home), c.stages.zone.ceiling(2));
  if (!way.empty()) home.z() = way.front()[2];
  return home;
}

bool machineZeroKnown(const IsoContext& c) {
  const ControlSettings& s = c.settings;
  const auto given = [](bool one) { return one; };
  const auto moved = [](const Vec3& offset) { return offset != Vec3::Zero(); };
  return s.reference_points[0] || s.placement.origin || moved(s.common_offset) ||
         !s.extended_offsets.empty() || std::any_of(s.work_given.begin(), s.work_given.end(), given) ||
         std::any_of(s.work_offsets.begin(), s.work_offsets.end(), moved) ||
         moved(c.registers.frames.system(c.state.work_system).offset.xyz);
}

namespace {

void warnOfMachineZero(IsoContext& c, bool known) {
  if (c.settings.reference_points[0]) return;
  c.warnOnce(
      "machine-zero", "machine-zero",
      known
          ? "G53: the job gives no reference point ([machine] reference_points), so machine zero is only as "
            "good as its work offsets ([offsets.work])"
          : "G53: nothing says where machine zero lies: Z goes to the top of travel, where the tool starts "
            "above the stock; a job file tells machine zero by G54 under [offsets.work], which is the "
            "workpiece's zero seen from it");
}

}  // namespace

bool planMachineMove(IsoContext& c, BlockPlan& plan) {
  MachineMove& move = plan.payload.emplace<MachineMove>();
  move.to = c.machine;
  if (!c.anyAxisWord()) return true;  // G53 alone only empties the buffer
  const bool known = machineZeroKnown(c);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (word.own_step) return c.alarm(SharedAlarm::kIncremental, w, "G53 is always absolute");
    if (!mayMove(c, w, word.axis)) return false;
    const double value = axisValue(c, plan, word, w);
    double& to = move.to[word.axis];
    const bool rotary = word.axis >= kMainAxes && c.axes.at(word.axis).rotary();
    to = rotary ? to + rotaryTravel(c, word.axis, to, value, false) : value;
    if (!known && c.axisMap().axisOf(word.axis) == 2) to = std::max(to, homeOf(c).z());
  }
  warnOfMachineZero(c, known);
  plan.perform = performMachineMove;
  plan.rebases = true;
  return true;
}

bool planReference(IsoContext& c, BlockPlan& plan) {
  std::int64_t point = 1;
  if (plan.by_group[kOneShot]->code10 == gcode::kNumberedReference) {
    const Word* p = c.ownWord(plan, 'P');
    if (p == nullptr)
      return c.alarm(SharedAlarm::kMissingData, "P", "G30 needs the number of the reference point");
    if (!integerWord(c, *p, 1, 4, point)) return false;
  }
  AxisPoint via = plan.start;
  if (!axisTarget(c, plan, via, WordsAre::kReference)) return false;
  if (!c.anyAxisWord()) {
    c.warn(SharedAlarm::kMissingData, "no axis is named: no motion");
    return true;
  }
  const auto& given = c.settings.reference_points[static_cast<std::size_t>(point - 1)];
  AxisPoint reference(given.value_or(homeOf(c)));
  for (const AxisSettings& axis : c.settings.axes) {
    if (const int k = c.axes.find(axis.name); k >= kMainAxes) reference[k] = axis.reference;
  }
  if (!given) {
    c.warnOnce(
        fmt::format("reference{}", point), "reference",
        fmt::format(
            "the job does not give reference point {}: the start position is taken; a job file tells it "
            "by reference_points under [machine]",
            point));
  }
  reference = c.axisMap().namesAt(reference);
  // Machine position after the intermediate point, then the named axes at the reference point.
  MachineMove& move = plan.payload.emplace<MachineMove>();
  move.has_via = true;
  move.via = plan.chain->machineOf(via);
  move.to = move.via;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (plan.motion.named[static_cast<std::size_t>(axis)]) move.to[axis] = reference[axis];
  }
  plan.perform = performMachineMove;
  plan.rebases = true;
  return true;
}

}  // namespace proveout::nc
