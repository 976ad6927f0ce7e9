// Drilling cycles G73 to G89: modal data, holes, steps (manual chapter 18).
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "core/nc/nct/nct_perform.h"
#include "core/nc/nct/nct_plans.h"
#include "core/nc/nct/nct_spindle.h"
#include "core/nc/nct/nct_words.h"

namespace proveout::nc {
namespace {

struct CycleKind {
  int code10;
  DrillCode drill;
};
constexpr std::array<CycleKind, 14> kCycles{{{730, DrillCode::kChipBreak},
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

bool isRigid(DrillCode code) { return code == DrillCode::kRigidTap || code == DrillCode::kRigidTapLeft; }

/// The holes of a block.
struct Holes {
  AxisPoint step;       ///< position or step per axis, mm
  AxisSet incremental;  ///< axes with a step
  std::int64_t repeat = 1;
};

bool planCycleWords(NctContext& c, BlockPlan& plan);
bool planCycleVectors(NctContext& c, BlockPlan& plan, DrillCode code);
bool checkCycle(NctContext& c, const BlockPlan& plan, DrillCode code);
bool expandCycle(NctContext& c, BlockPlan& plan);
bool performCycle(NctContext& c, BlockPlan& plan);
bool cycleHole(NctContext& c, BlockPlan& plan, const AxisPoint& hole, bool first);
bool cycleStep(NctContext& c, BlockPlan& plan, const DrillStep& step, AxisPoint& at);
bool cycleFunction(NctContext& c, BlockPlan& plan, const DrillStep& step);

}  // namespace

bool planCycle(NctContext& c, BlockPlan& plan) {
  CycleWords& words = plan.next.cycle;
  const PlaneFrame frame(plan.next.plane());
  const int drill = frame.w();
  const bool entry = !c.state.inCycle() || words.drill_axis != drill;
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  if (entry) {
    if (c.state.inCycle() && !c.block.present.has('R')) {
      return c.fail("nct-2053", "no bottom point or R point: a new drill axis needs R");
    }
    words.bottom.reset();
    words.r.reset();
    words.initial = plan.start[drill];
    words.drill_axis = drill;
  }
  if (!c.anyAxisWord()) {
    plan.motion.target = plan.start;  // F, S, M alone: nothing is drilled, cycle words are not kept
    return true;
  }
  Holes& holes = plan.payload.emplace<Holes>();
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (word.axis == drill) {
      words.bottom = axisValue(c, plan, word, w);
      words.bottom_incremental = word.step;
    } else {
      holes.step[word.axis] = axisValue(c, plan, word, w);
      holes.incremental[static_cast<std::size_t>(word.axis)] = word.step;
    }
  }
  if (const Word* r = c.ownWord(plan, 'R')) {
    words.r = lengthOf(plan, *r);
    words.r_incremental = r->incremental || plan.next.incremental();
  }
  if (!words.bottom || !words.r)
    return c.fail("nct-2053", "no bottom point or R point: the cycle needs both");
  return planCycleWords(c, plan);
}

namespace {

bool planCycleWords(NctContext& c, BlockPlan& plan) {
  CycleWords& words = plan.next.cycle;
  Holes& holes = plan.payload.as<Holes>();
  const int code10 = plan.next.active[kGroupCycle];
  const DrillCode code = drillCode(code10);
  const auto positive = [&](const Word& w, double& out, double scale) {
    if (w.value < 0.0)
      return c.failWord("nct-2002",
                        fmt::format("{} data out of range: must not be negative", addressText(w.address)), w);
    out = w.value * scale;
    return true;
  };
  if (const Word* q = c.ownWord(plan, 'Q'); q && !positive(*q, words.peck, plan.next.unitScale()))
    return false;
  if (const Word* e = c.ownWord(plan, 'E')) {
    double value = 0.0;
    if (!positive(*e, value, plan.next.unitScale())) return false;
    words.clearance = value;
  }
  if (const Word* p = c.ownWord(plan, 'P'); p && !positive(*p, words.dwell, 1.0)) return false;
  if (const Word* l = c.ownWord(plan, 'L'); l && !integerWord(c, *l, 0, 99999999, holes.repeat)) return false;
  if (!planCycleVectors(c, plan, code) || !checkCycle(c, plan, code)) return false;
  if (holes.repeat == 0) return true;
  plan.perform = performCycle;
  plan.runs_functions = true;
  return feedStyle(c, plan, plan.motion.feed) && expandCycle(c, plan);
}

bool planCycleVectors(NctContext& c, BlockPlan& plan, DrillCode code) {
  CycleWords& words = plan.next.cycle;
  const bool percent =
      code == DrillCode::kBoreFeedOut || code == DrillCode::kBoreDwellFeedOut || isRigid(code);
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    if (percent && axis == 0) {
      if (w->value <= 0.0) return c.failWord("nct-2002", "I data out of range: a percentage above 0", *w);
      words.retract_percent = w->value;
    } else {
      words.shift[static_cast<std::size_t>(axis)] = lengthOf(plan, *w);
    }
  }
  return true;
}

bool checkCycle(NctContext& c, const BlockPlan& plan, DrillCode code) {
  if (code == DrillCode::kFineBore && !c.parameters.flag(MachineParam::kSpindleOrients)) {
    return c.fail("nct-2137", "G76, G87: the spindle cannot be oriented (N0607.ORI = 0)");
  }
  if (isRigid(code) && !c.parameters.flag(MachineParam::kSpindleIndexes)) {
    return c.fail("nct-2138", "the spindle cannot be indexed (N0607.INX = 0)");
  }
  if ((code == DrillCode::kPeck || code == DrillCode::kChipBreak) && plan.next.cycle.peck <= 0.0) {
    return c.fail("nct-2004", "missing data Q: G73 and G83 need the peck depth");
  }
  return true;
}

bool expandCycle(NctContext& c, BlockPlan& plan) {
  const CycleWords& words = plan.next.cycle;
  const PlaneFrame frame(plan.next.plane());
  DrillCycle cycle;
  cycle.code = drillCode(plan.next.active[kGroupCycle]);
  if (cycle.code == DrillCode::kBackBore && !c.parameters.flag(MachineParam::kSpindleOrients)) {
    cycle.code = DrillCode::kBackBoreManual;
  }
  cycle.initial = words.initial;
  cycle.r = words.r_incremental ? words.initial + *words.r : *words.r;
  cycle.bottom = words.bottom_incremental ? cycle.r + *words.bottom : *words.bottom;
  cycle.return_to_r = plan.next.active[kGroupReturn] == 990;
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
  cycle.shift = {words.shift[static_cast<std::size_t>(frame.u())],
                 words.shift[static_cast<std::size_t>(frame.v())]};
  const CycleParam retract = rigid ? CycleParam::kTapRetract : CycleParam::kBoreRetract;
  if (!rigid || c.parameters.flag(CycleParam::kTapExtraction)) {
    cycle.retract_factor = words.retract_percent.value_or(c.parameters[retract]) / 100.0;
  }
  if (c.parameters.flag(CycleParam::kTapReturnOverride)) {
    cycle.tap_return_factor = c.parameters[CycleParam::kTapReturn] / 100.0;
  }
  cycle.orient_before_rigid_tap = c.parameters.flag(CycleParam::kTapOrient);
  switch (expandDrillCycle(cycle, c.drill_steps)) {
    case DrillError::kNone:
      return true;
    case DrillError::kBadPeck:
      return c.fail("nct-2002", "Q or E data out of range");
    case DrillError::kBadRetract:
      return c.fail("nct-2002", "I data out of range");
    case DrillError::kTooManySteps:
      return c.fail("nct-2002", "Q data out of range: the peck is too small for this depth");
    case DrillError::kNotFinite:
      break;
  }
  return c.fail("nct-2002", "drilling data out of range");
}

bool performCycle(NctContext& c, BlockPlan& plan) {
  const PlaneFrame frame(plan.next.plane());
  AxisPoint hole = c.position;
  const Holes& holes = plan.payload.as<Holes>();
  for (std::int64_t k = 0; k < holes.repeat; ++k) {
    for (const int axis : {frame.u(), frame.v()}) {
      if (!plan.motion.named[static_cast<std::size_t>(axis)]) continue;
      const bool step = holes.incremental[static_cast<std::size_t>(axis)];
      hole[axis] = step ? hole[axis] + holes.step[axis] : holes.step[axis];
    }
    if (k > 0 && c.work.over()) return false;
    if (!cycleHole(c, plan, hole, k == 0)) return false;
  }
  return true;
}

/// A motion of the cycle to `at`, program coordinates; without a feed at rapid.
bool cycleMove(NctContext& c, const AxisPoint& at, const FeedStyle* feed = nullptr) {
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.plane = c.state.workPlane();
  item.in_plane = true;
  item.to = at;
  item.rapid = feed == nullptr;
  if (feed) item.feed = *feed;
  item.source = c.here();
  c.position = at;
  return c.pipe.push(item);
}

bool cycleHole(NctContext& c, BlockPlan& plan, const AxisPoint& hole, bool first) {
  const int drill = PlaneFrame(plan.next.plane()).w();
  AxisPoint at = hole;
  at[drill] = c.position[drill];
  if (!cycleMove(c, at)) return false;
  if (first && !performFunctions(c, plan, MPhase::kBefore)) return false;
  for (const DrillStep& step : c.drill_steps) {
    if (!cycleStep(c, plan, step, at)) return false;
  }
  c.machine = c.chain.machineOf(at);
  return true;
}

bool cycleStep(NctContext& c, BlockPlan& plan, const DrillStep& step, AxisPoint& at) {
  const PlaneFrame frame(plan.next.plane());
  if (step.kind == DrillStepKind::kShift) {
    at[frame.u()] += step.shift.x();
    at[frame.v()] += step.shift.y();
    return cycleMove(c, at);
  }
  if (step.kind == DrillStepKind::kRapid) {
    at[frame.w()] = step.position;
    return cycleMove(c, at);
  }
  if (step.kind == DrillStepKind::kFeed) {
    at[frame.w()] = step.position;
    FeedStyle style = plan.motion.feed;
    style.feed *= step.feed_factor;
    style.kind = step.thread ? MotionKind::kThread : MotionKind::kFeed;
    if (step.thread) {
      style.acceleration = tapAcceleration(c, plan, step.operation == 7);
      style.join.stops = true;  // the spindle turns round, or comes to a stand
    }
    return cycleMove(c, at, &style);
  }
  return cycleFunction(c, plan, step);
}

bool cycleFunction(NctContext& c, BlockPlan& plan, const DrillStep& step) {
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
      return sendSpindle(c, 1, plan.next.spindle_rpm);
    case DrillStepKind::kSpindleReverse:
      return sendSpindle(c, -1, plan.next.spindle_rpm);
    case DrillStepKind::kSpindleStop:
      return sendSpindle(c, 0, plan.next.spindle_rpm);
    case DrillStepKind::kSpindleOrient:
      return sendOriented(c);
    case DrillStepKind::kCloseLoop: {
      PathItem item = functionItem(c, PathItem::Kind::kSpindle, c.state);
      item.value = plan.next.spindle_rpm;
      item.spindle = SpindleState::kPositionLoop;
      return c.pipe.push(item);
    }
    case DrillStepKind::kProgramStop:
      return sendEvent(
          c, "stop",
          {{"code", jsonString("M0")}, {"reason", jsonString("manual intervention in the cycle")}});
  }
  return true;
}

}  // namespace

}  // namespace proveout::nc
