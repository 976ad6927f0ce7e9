// Drilling cycles G73 to G89: modal data, holes, steps (manual chapter 18).
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/cycles/cycle_rules.h"
#include "core/nc/iso/cycles/holes.h"
#include "core/nc/iso/cycles/taps.h"
#include "core/nc/iso/motion/contour.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/spindle/spindle.h"

namespace proveout::nc {
namespace {

struct CycleKind {
  int code10;
  DrillCode drill;
};
constexpr std::array<CycleKind, 17> kCycles{{{730, DrillCode::kChipBreak},
                                             {831, DrillCode::kChipBreak},
                                             {841, DrillCode::kTapLeft},
                                             {861, DrillCode::kFineBore},
                                             {740, DrillCode::kTapLeft},
                                             {760, DrillCode::kFineBore},
                                             {810, DrillCode::kDrill},
                                             {820, DrillCode::kDrillDwell},
                                             {830, DrillCode::kPeck},
                                             {840, DrillCode::kTap},
                                             {842, DrillCode::kRigidTap},
                                             {843, DrillCode::kRigidTapLeft},
                                             {850, DrillCode::kBoreFeedOut},
                                             {860, DrillCode::kBoreStop},
                                             {870, DrillCode::kBackBore},
                                             {880, DrillCode::kBoreManual},
                                             {890, DrillCode::kBoreDwellFeedOut}}};

DrillCode drillCode(int code10) {
  for (const CycleKind& kind : kCycles) {
    if (kind.code10 == code10) return kind.drill;
  }
  return DrillCode::kDrill;
}

constexpr CycleRules kNctCycleRules;

DrillCode drillCodeBy(const CycleRules& rules, const IsoContext& c, const BlockPlan& plan) {
  return rules.code != nullptr ? rules.code(c, plan) : drillCode(plan.next.active[kGroupCycle]);
}

/// What a cycle taps.
Tap tapOf(DrillCode code) {
  switch (code) {
    case DrillCode::kTap:
      return {.hand = 1};
    case DrillCode::kTapLeft:
      return {.hand = -1};
    case DrillCode::kRigidTap:
      return {.hand = 1, .rigid = true};
    case DrillCode::kRigidTapLeft:
      return {.hand = -1, .rigid = true};
    default:
      return {};
  }
}

bool isRigid(DrillCode code) { return code == DrillCode::kRigidTap || code == DrillCode::kRigidTapLeft; }

/// How the holes of a block come about.
enum class HolesFrom : std::uint8_t { kWords, kPoints };

bool planHoles(IsoContext& c, BlockPlan& plan, const CycleRules& rules, HolesFrom from);
bool planCycleWords(IsoContext& c, BlockPlan& plan, const CycleRules& rules);
AddressSet wordsOf(const IsoContext& c, const BlockPlan& plan, DrillCode code);
bool planCycleVectors(IsoContext& c, BlockPlan& plan, DrillCode code, const CycleRules& rules);
bool checkCycle(IsoContext& c, const BlockPlan& plan, DrillCode code);
bool expandCycle(IsoContext& c, BlockPlan& plan, const CycleRules& rules);
bool drillHoles(IsoContext& c, BlockPlan& plan);
bool cycleHole(IsoContext& c, BlockPlan& plan, const AxisPoint& hole, bool first);
bool cycleStep(IsoContext& c, BlockPlan& plan, const DrillStep& step, AxisPoint& at);
bool cycleFunction(IsoContext& c, BlockPlan& plan, const DrillStep& step);

}  // namespace

void takeHoleWords(const IsoContext& c, BlockPlan& plan, Holes& holes) {
  CycleWords& words = plan.next.cycle;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (word.axis == words.drill_axis) {
      words.bottom = axisValue(c, plan, word, w);
      words.bottom_incremental = word.step;
    } else {
      holes.step[word.axis] = axisValue(c, plan, word, w);
      holes.incremental[static_cast<std::size_t>(word.axis)] = word.step;
    }
  }
}

void takeLevels(const BlockPlan& plan, Holes& holes, DrillCycle& cycle) {
  const CycleWords& words = plan.next.cycle;
  const auto height = [&](double value) {
    AxisPoint p = plan.start;
    p[words.drill_axis] = value;
    plan.chain->moveToWork(p);
    return p[words.drill_axis];
  };
  holes.initial = words.initial;
  holes.r = !words.r ? words.initial : words.r_incremental ? words.initial + *words.r : *words.r;
  cycle.initial = holes.work_initial = height(holes.initial);
  cycle.r = holes.work_r = height(holes.r);
  cycle.bottom = holes.work_bottom =
      height(words.bottom_incremental ? holes.r + *words.bottom : *words.bottom);
}

namespace {

/// N1503.CSM frees G73, G74 and G76 for turning: drilling then has G83.1, G84.1 and G86.1.
bool checkCoding(IsoContext& c, const BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupCycle];
  if (code == nullptr) return true;
  const bool special = c.parameters.flag(CycleParam::kSpecialCodes);
  const int code10 = code->code10;
  const bool usual_code =
      code10 == gcode::kChipBreak || code10 == gcode::kTapLeft || code10 == gcode::kFineBore;
  const bool special_code = code10 == gcode::kChipBreakBesideTurning ||
                            code10 == gcode::kTapLeftBesideTurning || code10 == gcode::kFineBoreBesideTurning;
  if (!(special ? usual_code : special_code)) return true;
  return c.fail("cycle-coding",
                fmt::format("{} is no drilling cycle with {}", gName(code10),
                            c.parameters.nameWith(CycleParam::kSpecialCodes, special ? 1 : 0)));
}

/// The drill axis of the block: the one that stands across the plane or an axis parallel to it, whichever has
/// a word. False: both have one.
bool chooseDrillAxis(IsoContext& c, const BlockPlan& plan, int& drill) {
  const int main = PlaneFrame(plan.next.plane()).w();
  const auto drills = [&](int axis) {
    return axis == main || (axis >= kMainAxes && c.axes.at(axis).parallel_to == main);
  };
  drill = c.state.inCycle() && drills(plan.next.cycle.drill_axis) ? plan.next.cycle.drill_axis : main;
  const Word* found = nullptr;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word) || !drills(word.axis)) continue;
    if (found != nullptr && drill != word.axis)
      return c.alarm(SharedAlarm::kIllegalAddress, w, "two drill axes in one block");
    found = &w;
    drill = word.axis;
  }
  return true;
}

}  // namespace

namespace {

/// Holes in polar data: axisTarget() has found the first one.
void polarHoles(const IsoContext& c, const BlockPlan& plan, Holes& holes) {
  const WorkPlane plane = planeOf(plan.next);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word) || (word.axis != plane.u && word.axis != plane.v)) continue;
    holes.polar = true;
    if (word.axis == plane.u) {
      holes.from_hole = word.step;
      holes.radius = axisValue(c, plan, word, w);
    } else if (word.step) {
      holes.angle_step = w.value;
    }
  }
  if (!holes.from_hole) holes.radius = plan.next.axes.polar.radius;
}

/// Holes by one coordinate and ,A: planDirection() has found the other one, which steps as its sister does.
void directedHoles(const BlockPlan& plan, Holes& holes) {
  const WorkPlane plane = planeOf(plan.next);
  const bool step = holes.incremental[static_cast<std::size_t>(plane.u)] ||
                    holes.incremental[static_cast<std::size_t>(plane.v)];
  for (const int axis : {plane.u, plane.v}) {
    holes.step[axis] = plan.motion.target[axis] - (step ? plan.start[axis] : 0.0);
    holes.incremental[static_cast<std::size_t>(axis)] = step;
  }
}

}  // namespace

bool planCycle(IsoContext& c, BlockPlan& plan) { return planCycleBy(c, plan, kNctCycleRules); }

bool planCycleBy(IsoContext& c, BlockPlan& plan, const CycleRules& rules) {
  return planHoles(c, plan, rules, HolesFrom::kWords);
}

bool planCycleAtPoints(IsoContext& c, BlockPlan& plan, const CycleRules& rules) {
  return planHoles(c, plan, rules, HolesFrom::kPoints);
}

namespace {

/// The levels that the cycle needs. False: reported.
bool haveLevels(IsoContext& c, CycleWords& words, const CycleRules& rules) {
  if (!words.bottom && rules.no_bottom != nullptr) {
    return c.fail(rules.no_bottom, "the cycle has no bottom: program the word of its drilling axis (Z)");
  }
  if (words.bottom && !words.r && rules.no_level != CycleRules::NoLevel::kAlarm) {
    words.r = words.initial;
    words.r_incremental = false;
    if (rules.no_level == CycleRules::NoLevel::kTold) {
      c.warn("cycle-no-r", "the cycle has no level R: the level where the tool stands is taken", {},
             Severity::kNote);
    }
  }
  return (words.bottom && words.r) || c.alarm(SharedAlarm::kNoBottom, "", "the cycle needs both");
}

bool planHoles(IsoContext& c, BlockPlan& plan, const CycleRules& rules, HolesFrom from) {
  CycleWords& words = plan.next.cycle;
  int drill = 2;
  if (!checkCoding(c, plan) || !chooseDrillAxis(c, plan, drill)) return false;
  const bool entry = !c.state.inCycle() || words.drill_axis != drill;
  if (!axisTarget(c, plan, plan.motion.target) || !planDirection(c, plan)) return false;
  if (entry) {
    const bool needs_r = rules.no_level == CycleRules::NoLevel::kAlarm;
    if (needs_r && c.state.inCycle() && !c.block.present.has('R')) {
      return c.alarm(SharedAlarm::kNoBottom, "", "a new drill axis needs R");
    }
    words.bottom.reset();
    words.r.reset();
    words.initial = plan.start[drill];
    words.drill_axis = drill;
  }
  const bool by_level = rules.r_names_hole && c.ownWord(plan, 'R') != nullptr;
  if (!c.anyAxisWord() && !by_level && from == HolesFrom::kWords) {
    plan.motion.target = plan.start;  // F, S, M alone: nothing is drilled, cycle words are not kept
    return true;
  }
  Holes& holes = plan.payload.emplace<Holes>();
  holes.listed = from == HolesFrom::kPoints;
  takeHoleWords(c, plan, holes);
  if (c.block.present.has(kCommaDirection)) directedHoles(plan, holes);
  if (plan.next.active[kGroupPolarData] == gcode::kPolarData) polarHoles(c, plan, holes);
  if (const Word* r = c.ownWord(plan, 'R')) {
    words.r = lengthOf(plan, *r);
    words.r_incremental = r->incremental || plan.next.incremental();
  }
  return haveLevels(c, words, rules) && planCycleWords(c, plan, rules);
}

bool planCycleWords(IsoContext& c, BlockPlan& plan, const CycleRules& rules) {
  CycleWords& words = plan.next.cycle;
  Holes& holes = std::get<Holes>(plan.payload);
  const DrillCode code = drillCodeBy(rules, c, plan);
  holes.code = code;
  const auto positive = [&](const Word& w, double& out, double scale) {
    if (w.value < 0.0)
      return c.alarm(SharedAlarm::kOutOfRange, addressText(w.address), "must not be negative", w.columns);
    out = w.value * scale;
    return true;
  };
  if (const Word* q = c.ownWord(plan, 'Q')) {
    if (rules.signed_peck) {
      words.peck = lengthOf(plan, *q);
    } else if (!positive(*q, words.peck, plan.next.unitScale())) {
      return false;
    }
  }
  if (const Word* e = c.ownWord(plan, 'E')) {
    double value = 0.0;
    if (!positive(*e, value, plan.next.unitScale())) return false;
    words.clearance = value;
  }
  if (const Word* p = c.ownWord(plan, 'P')) {
    if (!positive(*p, words.dwell, 1.0) || (rules.dwell && !rules.dwell(c, *p, words.dwell))) return false;
  }
  for (const Word& w : c.block.words) {
    if (!rules.repeats.has(w.address) || plan.claimed.has(w.address)) continue;
    if (!integerWord(c, w, 0, 99999999, holes.repeat)) return false;
  }
  if (!planCycleVectors(c, plan, code, rules)) return false;
  if (!(rules.check != nullptr ? rules.check(c, plan, code) : checkCycle(c, plan, code))) return false;
  c.asked = wordsOf(c, plan, code) | rules.repeats | rules.more_words;
  if (holes.repeat == 0) return true;
  plan.perform = performHoles;
  plan.runs_functions = !rules.functions_first;
  return feedStyle(c, plan, plan.motion.feed) && expandCycle(c, plan, rules);
}

/// The words that a cycle reads: 18.1.1 to 18.1.15. The others wait for another cycle of the same mode.
AddressSet wordsOf(const IsoContext& c, const BlockPlan& plan, DrillCode code) {
  AddressSet words = "RLa";
  const bool pecks = code == DrillCode::kChipBreak || code == DrillCode::kPeck || isRigid(code);
  if (pecks) words.add('Q');
  if (pecks && plan.next.cycle.peck > 0.0) words.add('E');
  const bool feeds_out = code == DrillCode::kBoreFeedOut || code == DrillCode::kBoreDwellFeedOut;
  if (feeds_out || (isRigid(code) && c.parameters.flag(CycleParam::kTapExtraction))) words.add('I');
  const bool dwells = tapOf(code).hand != 0 || code == DrillCode::kDrillDwell ||
                      code == DrillCode::kFineBore || code == DrillCode::kBoreManual ||
                      code == DrillCode::kBoreDwellFeedOut;
  if (dwells) words.add('P');
  const bool back = code == DrillCode::kBackBore && c.parameters.flag(MachineParam::kSpindleOrients);
  if (code == DrillCode::kFineBore || back) {
    const PlaneFrame letters(plan.next.plane());
    words.add("IJK"[letters.u()]);
    words.add("IJK"[letters.v()]);
  }
  return words;
}

bool planCycleVectors(IsoContext& c, BlockPlan& plan, DrillCode code, const CycleRules& rules) {
  CycleWords& words = plan.next.cycle;
  const bool percent = rules.percent_by_i && (code == DrillCode::kBoreFeedOut ||
                                              code == DrillCode::kBoreDwellFeedOut || isRigid(code));
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = rules.repeats.has("IJK"[axis]) ? nullptr : c.ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    if (percent && axis == 0) {
      if (w->value <= 0.0) return c.alarm(SharedAlarm::kOutOfRange, *w, "a percentage above 0");
      words.retract_percent = w->value;
    } else {
      words.shift[static_cast<std::size_t>(axis)] = lengthOf(plan, *w);
    }
  }
  return true;
}

bool checkCycle(IsoContext& c, const BlockPlan& plan, DrillCode code) {
  if (code == DrillCode::kFineBore && !c.parameters.flag(MachineParam::kSpindleOrients)) {
    return c.alarm(
        SharedAlarm::kOrientation, "",
        "the spindle cannot be oriented, " + c.parameters.nameWith(MachineParam::kSpindleOrients, 0));
  }
  if (isRigid(code) && !c.parameters.flag(MachineParam::kSpindleIndexes, mainNumber(c))) {
    return c.alarm(SharedAlarm::kIndexing, "", c.parameters.nameWith(MachineParam::kSpindleIndexes, 0));
  }
  if (isRigid(code) && c.parameters.flag(CycleParam::kTapOrient) &&
      !c.parameters.flag(MachineParam::kSpindleOrients, mainNumber(c))) {
    return c.alarm(SharedAlarm::kOrientation, "",
                   fmt::format("{} orients the spindle before the tap, {}",
                               c.parameters.nameWith(CycleParam::kTapOrient, 1),
                               c.parameters.nameWith(MachineParam::kSpindleOrients, 0)));
  }
  if ((code == DrillCode::kPeck || code == DrillCode::kChipBreak) && plan.next.cycle.peck <= 0.0) {
    return c.alarm(SharedAlarm::kMissingData, "Q", "G73 and G83 need the peck depth");
  }
  return true;
}

bool expandCycle(IsoContext& c, BlockPlan& plan, const CycleRules& rules) {
  const CycleWords& words = plan.next.cycle;
  Holes& holes = std::get<Holes>(plan.payload);
  DrillCycle cycle;
  cycle.code = holes.code;
  if (cycle.code == DrillCode::kBackBore && !c.parameters.flag(MachineParam::kSpindleOrients)) {
    cycle.code = DrillCode::kBackBoreManual;
  }
  takeLevels(plan, holes, cycle);
  cycle.return_to_r = plan.next.active[kGroupReturn] == gcode::kReturnToR;
  cycle.peck = words.peck;
  const bool rigid = isRigid(cycle.code);
  cycle.tap_returns_to_r = rigid && c.parameters.flag(CycleParam::kTapReturnsToR);
  const CycleParam clearance =
      rigid ? (cycle.tap_returns_to_r ? CycleParam::kRigidPeckClearance : CycleParam::kRigidChipBreakReturn)
      : cycle.code == DrillCode::kPeck ? CycleParam::kPeckClearance
                                       : CycleParam::kChipBreakReturn;
  cycle.clearance = words.clearance.value_or(c.parameters[clearance]);
  const bool turns = plan.next.perTurn() && !c.parameters.flag(MotionParam::kDwellSeconds);
  cycle.dwell = turns && words.dwell > 0.0 ? words.dwell * 60.0 / turnsPerMinute(c, plan) : words.dwell;
  const PlaneFrame letters(plan.next.plane());
  cycle.shift = {words.shift[static_cast<std::size_t>(letters.u())],
                 words.shift[static_cast<std::size_t>(letters.v())]};
  const CycleParam retract = rigid ? CycleParam::kTapRetract : CycleParam::kBoreRetract;
  if (!rigid || c.parameters.flag(CycleParam::kTapExtraction)) {
    cycle.retract_factor = words.retract_percent.value_or(c.parameters[retract]) / 100.0;
  }
  if (c.parameters.flag(CycleParam::kTapReturnOverride)) {
    cycle.tap_return_factor = c.parameters[CycleParam::kTapReturn] / 100.0;
  }
  cycle.orient_before_rigid_tap = c.parameters.flag(CycleParam::kTapOrient);
  if (rules.finish != nullptr && !rules.finish(c, plan, cycle)) return false;
  switch (expandDrillCycle(cycle, c.drill_steps)) {
    case DrillError::kNone:
      return true;
    case DrillError::kBadPeck:
      return c.fail(SharedAlarm::kOutOfRange, "Q or E data out of range");
    case DrillError::kBadRetract:
      return c.fail(SharedAlarm::kOutOfRange, "I data out of range");
    case DrillError::kTooManySteps:
      return c.fail(SharedAlarm::kOutOfRange, "Q data out of range: the peck is too small for this depth");
    case DrillError::kNotFinite:
      break;
  }
  return c.fail(SharedAlarm::kOutOfRange, "cycle data out of range");
}

/// The next hole in polar data; the angle goes on from the block's own.
void polarHole(BlockPlan& plan, const AxisPoint& last, bool first, AxisPoint& hole) {
  const Holes& holes = std::get<Holes>(plan.payload);
  const WorkPlane plane = planeOf(plan.next);
  PolarData& polar = plan.next.axes.polar;
  if (first) {
    hole[plane.u] = plan.motion.target[plane.u];
    hole[plane.v] = plan.motion.target[plane.v];
    return;
  }
  polar.angle_deg += holes.angle_step;
  const double angle = degToRad(polar.angle_deg);
  hole[plane.u] = (holes.from_hole ? last[plane.u] : 0.0) + holes.radius * std::cos(angle);
  hole[plane.v] = (holes.from_hole ? last[plane.v] : 0.0) + holes.radius * std::sin(angle);
  polar.u = hole[plane.u];
  polar.v = hole[plane.v];
  polar.radius = std::hypot(polar.u, polar.v);
}

/// The holes that the plan has listed.
bool performPoints(IsoContext& c, BlockPlan& plan) {
  const WorkPlane plane = planeOf(plan.next);
  AxisPoint hole = c.position;
  for (std::size_t k = 0; k < c.hole_points.size(); ++k) {
    hole[plane.u] = c.hole_points[k].x();
    hole[plane.v] = c.hole_points[k].y();
    if (k > 0 && c.watch.workOver(c.calls.place())) return false;
    if (!cycleHole(c, plan, hole, k == 0)) return false;
  }
  return true;
}

bool drillHoles(IsoContext& c, BlockPlan& plan) {
  AxisPoint hole = c.position;
  const Holes& holes = std::get<Holes>(plan.payload);
  if (holes.listed) return performPoints(c, plan);
  for (std::int64_t k = 0; k < holes.repeat; ++k) {
    const AxisPoint last = hole;
    for (int axis = 0; axis < c.axes.count(); ++axis) {
      if (axis == plan.next.cycle.drill_axis || !plan.motion.named[static_cast<std::size_t>(axis)]) continue;
      const bool step = holes.incremental[static_cast<std::size_t>(axis)];
      hole[axis] = step ? hole[axis] + holes.step[axis] : holes.step[axis];
    }
    if (holes.polar) polarHole(plan, last, k == 0, hole);
    if (k > 0 && c.watch.workOver(c.calls.place())) return false;
    if (!cycleHole(c, plan, hole, k == 0)) return false;
  }
  return true;
}

/// Cutter compensation of a motion of the cycle. Those in the hole keep the vector that the way to it ends
/// with.
void compensate(const BlockPlan& plan, bool to_hole, PathItem& item) {
  item.comp_on = plan.next.compOn();
  item.offset = plan.next.compOffset();
  item.tip = static_cast<std::uint8_t>(plan.next.d_tip);
  item.in_plane = to_hole;
}

/// A motion of the cycle to `at`, work space; without a feed at rapid.
bool cycleMove(IsoContext& c, const BlockPlan& plan, const AxisPoint& at, const FeedStyle* feed = nullptr,
               bool to_hole = false) {
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.space = PathItem::Space::kWork;
  item.plane = c.state.workPlane();
  item.in_plane = true;
  item.to = at;
  item.rapid = feed == nullptr;
  if (feed) item.feed = *feed;
  item.source = c.here();
  if (c.stages.comp.linked()) compensate(plan, to_hole, item);
  return c.pipe.push(item);
}

bool cycleHole(IsoContext& c, BlockPlan& plan, const AxisPoint& hole, bool first) {
  const Holes& holes = std::get<Holes>(plan.payload);
  const int drill = plan.next.cycle.drill_axis;
  const double height = c.position[drill];
  const WorkPlane plane = planeOf(plan.next);
  const bool moves = hole[plane.u] != c.position[plane.u] || hole[plane.v] != c.position[plane.v];
  if (c.dialect.rules.cycles_in_comp) engageComp(c, plan);
  c.position = hole;
  c.position[drill] = height;
  AxisPoint at = c.chain.workOf(c.position);
  if (!cycleMove(c, plan, at, nullptr, moves)) return false;
  if (first && plan.runs_functions && !performFunctions(c, plan, MPhase::kBefore)) return false;
  if (first) checkTapStart(c, plan, tapOf(holes.code));
  for (const DrillStep& step : c.drill_steps) {
    if (!cycleStep(c, plan, step, at)) return false;
  }
  c.machine = at;
  c.chain.moveToMachine(c.machine);
  c.position[drill] = at[drill] == holes.work_initial ? holes.initial : holes.r;
  return true;
}

/// The word that a level of the drill axis is from.
OriginKind levelOf(const IsoContext& c, BlockPlan& plan, double position) {
  const Holes& holes = std::get<Holes>(plan.payload);
  if (position == holes.work_bottom) return OriginKind::kCycleDepth;
  if (position == holes.work_r) return OriginKind::kCyclePlane;
  if (position == holes.work_initial) return OriginKind::kCycleReturn;
  return c.origins.any(OriginKind::kCycleStep) ? OriginKind::kCycleStep : OriginKind::kCycleDepth;
}

bool cycleStep(IsoContext& c, BlockPlan& plan, const DrillStep& step, AxisPoint& at) {
  const int drill = plan.next.cycle.drill_axis;
  if (step.kind == DrillStepKind::kShift) {
    const WorkPlane plane = planeOf(plan.next);
    at[plane.u] += step.shift.x();
    at[plane.v] += step.shift.y();
    return cycleMove(c, plan, at, nullptr, true);
  }
  const bool along = step.kind == DrillStepKind::kRapid || step.kind == DrillStepKind::kFeed;
  if (along) recordCycleLevel(c, drill, levelOf(c, plan, step.position));
  if (step.kind == DrillStepKind::kRapid) {
    at[drill] = step.position;
    return cycleMove(c, plan, at);
  }
  if (step.kind == DrillStepKind::kFeed) {
    const Holes& holes = std::get<Holes>(plan.payload);
    const bool inwards = (step.position < at[drill]) == (holes.work_bottom < holes.work_r);
    at[drill] = step.position;
    FeedStyle style = plan.motion.feed;
    style.feed *= step.feed_factor;
    style.kind = step.thread ? MotionKind::kThread : MotionKind::kFeed;
    if (step.thread) takeTapSpindle(c, plan, tapOf(holes.code), inwards, step.operation == 7, style);
    return cycleMove(c, plan, at, &style);
  }
  return cycleFunction(c, plan, step);
}

bool cycleFunction(IsoContext& c, BlockPlan& plan, const DrillStep& step) {
  switch (step.kind) {
    case DrillStepKind::kRapid:
    case DrillStepKind::kFeed:
    case DrillStepKind::kShift:
      return true;
    case DrillStepKind::kDwell: {
      PathItem item = functionItem(c, PathItem::Kind::kDwell, c.state);
      item.value = step.dwell;
      return c.pipe.push(item);
    }
    case DrillStepKind::kSpindleForward:
      return turnMain(c, 1, plan.next.spindle_rpm);
    case DrillStepKind::kSpindleReverse:
      return turnMain(c, -1, plan.next.spindle_rpm);
    case DrillStepKind::kSpindleStop:
      return turnMain(c, 0, plan.next.spindle_rpm);
    case DrillStepKind::kSpindleOrient:
      return closeMainLoop(c, true);
    case DrillStepKind::kCloseLoop:
      return closeMainLoop(c, false);
    case DrillStepKind::kProgramStop:
      return sendEvent(c, event::Stop{"M0", "manual intervention in the cycle"});
  }
  return true;
}

}  // namespace

bool performHoles(IsoContext& c, BlockPlan& plan) { return drillHoles(c, plan); }

}  // namespace proveout::nc
