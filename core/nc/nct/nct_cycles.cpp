// Drilling cycles G73 to G89: modal data, holes, steps (manual chapter 18).
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "core/nc/nct/nct_control.h"

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

}  // namespace

bool NctControl::planCycle(BlockPlan& plan) {
  CycleWords& words = plan.next.cycle;
  const PlaneFrame frame(plan.next.plane());
  const int drill = frame.w();
  const bool entry = !state_.inCycle() || words.drill_axis != drill;
  if (!axisTarget(plan, plan.target)) return false;
  if (entry) {
    if (state_.inCycle() && !block_.present.has('R')) {
      return fail("nct-2053", "no bottom point or R point: a new drill axis needs R");
    }
    words.bottom.reset();
    words.r.reset();
    words.initial = plan.start[drill];
    words.drill_axis = drill;
  }
  if (!anyAxisWord()) {
    plan.target = plan.start;  // F, S, M alone: nothing is drilled, cycle words are not kept
    return true;
  }
  for (const Word& w : block_.words) {
    const bool secondary = w.address >= 'U' && w.address <= 'W';
    if (secondary || (w.address >= 'X' && w.address <= 'Z')) {
      const int axis = w.address - (secondary ? 'U' : 'X');
      const bool step = secondary || w.incremental || plan.next.incremental();
      if (axis == drill) {
        words.bottom = lengthOf(plan, w);
        words.bottom_incremental = step;
      } else {
        plan.cycle_step[axis] = lengthOf(plan, w);
        plan.cycle_incremental[static_cast<std::size_t>(axis)] = step;
      }
    }
  }
  if (const Word* r = ownWord(plan, 'R')) {
    words.r = lengthOf(plan, *r);
    words.r_incremental = r->incremental || plan.next.incremental();
  }
  if (!words.bottom || !words.r) return fail("nct-2053", "no bottom point or R point: the cycle needs both");
  return planCycleWords(plan);
}

bool NctControl::planCycleWords(BlockPlan& plan) {
  CycleWords& words = plan.next.cycle;
  const int code10 = plan.next.active[kGroupCycle];
  const DrillCode code = drillCode(code10);
  const auto positive = [&](const Word& w, double& out, double scale) {
    if (w.value < 0.0)
      return failWord("nct-2002",
                      fmt::format("{} data out of range: must not be negative", addressText(w.address)), w);
    out = w.value * scale;
    return true;
  };
  if (const Word* q = ownWord(plan, 'Q'); q && !positive(*q, words.peck, plan.next.unitScale())) return false;
  if (const Word* e = ownWord(plan, 'E')) {
    double value = 0.0;
    if (!positive(*e, value, plan.next.unitScale())) return false;
    words.clearance = value;
  }
  if (const Word* p = ownWord(plan, 'P'); p && !positive(*p, words.dwell, 1.0)) return false;
  if (const Word* l = ownWord(plan, 'L'); l && !integerWord(*l, 0, 99999999, plan.repeat)) return false;
  if (!planCycleVectors(plan, code) || !checkCycle(plan, code)) return false;
  if (plan.repeat == 0) return true;
  plan.deed = BlockPlan::Deed::kCycle;
  return feedStyle(plan, plan.feed) && expandCycle(plan);
}

bool NctControl::planCycleVectors(BlockPlan& plan, DrillCode code) {
  CycleWords& words = plan.next.cycle;
  const bool percent =
      code == DrillCode::kBoreFeedOut || code == DrillCode::kBoreDwellFeedOut || isRigid(code);
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    if (percent && axis == 0) {
      if (w->value <= 0.0) return failWord("nct-2002", "I data out of range: a percentage above 0", *w);
      words.retract_percent = w->value;
    } else {
      words.shift[static_cast<std::size_t>(axis)] = lengthOf(plan, *w);
    }
  }
  return true;
}

bool NctControl::checkCycle(const BlockPlan& plan, DrillCode code) {
  if (code == DrillCode::kFineBore && !parameters_.flag(NctParam::kSpindleOrients)) {
    return fail("nct-2137", "G76, G87: the spindle cannot be oriented (N0607.ORI = 0)");
  }
  if (isRigid(code) && !parameters_.flag(NctParam::kSpindleIndexes)) {
    return fail("nct-2138", "the spindle cannot be indexed (N0607.INX = 0)");
  }
  if ((code == DrillCode::kPeck || code == DrillCode::kChipBreak) && plan.next.cycle.peck <= 0.0) {
    return fail("nct-2004", "missing data Q: G73 and G83 need the peck depth");
  }
  return true;
}

bool NctControl::expandCycle(BlockPlan& plan) {
  const CycleWords& words = plan.next.cycle;
  const PlaneFrame frame(plan.next.plane());
  DrillCycle cycle;
  cycle.code = drillCode(plan.next.active[kGroupCycle]);
  if (cycle.code == DrillCode::kBackBore && !parameters_.flag(NctParam::kSpindleOrients)) {
    cycle.code = DrillCode::kBackBoreManual;
  }
  cycle.initial = words.initial;
  cycle.r = words.r_incremental ? words.initial + *words.r : *words.r;
  cycle.bottom = words.bottom_incremental ? cycle.r + *words.bottom : *words.bottom;
  cycle.return_to_r = plan.next.active[kGroupReturn] == 990;
  cycle.peck = words.peck;
  const bool rigid = isRigid(cycle.code);
  cycle.tap_returns_to_r = rigid && parameters_.flag(NctParam::kTapReturnsToR);
  const NctParam clearance =
      rigid ? (cycle.tap_returns_to_r ? NctParam::kRigidPeckClearance : NctParam::kRigidChipBreakReturn)
      : cycle.code == DrillCode::kPeck ? NctParam::kPeckClearance
                                       : NctParam::kChipBreakReturn;
  cycle.clearance = words.clearance.value_or(parameters_[clearance]);
  const bool turns = plan.next.perTurn() && !parameters_.flag(NctParam::kDwellSeconds);
  cycle.dwell = turns && words.dwell > 0.0 ? words.dwell * 60.0 / turnsPerMinute(plan) : words.dwell;
  cycle.shift = {words.shift[static_cast<std::size_t>(frame.u())],
                 words.shift[static_cast<std::size_t>(frame.v())]};
  const NctParam retract = rigid ? NctParam::kTapRetract : NctParam::kBoreRetract;
  if (!rigid || parameters_.flag(NctParam::kTapExtraction)) {
    cycle.retract_factor = words.retract_percent.value_or(parameters_[retract]) / 100.0;
  }
  cycle.orient_before_rigid_tap = parameters_.flag(NctParam::kTapOrient);
  switch (expandDrillCycle(cycle, steps_)) {
    case DrillError::kNone:
      return true;
    case DrillError::kBadPeck:
      return fail("nct-2002", "Q or E data out of range");
    case DrillError::kBadRetract:
      return fail("nct-2002", "I data out of range");
    case DrillError::kTooManySteps:
      return fail("nct-2002", "Q data out of range: the peck is too small for this depth");
    case DrillError::kNotFinite:
      break;
  }
  return fail("nct-2002", "drilling data out of range");
}

bool NctControl::performCycle(BlockPlan& plan) {
  const PlaneFrame frame(plan.next.plane());
  Vec3 hole = position_;
  for (std::int64_t k = 0; k < plan.repeat; ++k) {
    for (const int axis : {frame.u(), frame.v()}) {
      if (!plan.named[static_cast<std::size_t>(axis)]) continue;
      const bool step = plan.cycle_incremental[static_cast<std::size_t>(axis)];
      hole[axis] = step ? hole[axis] + plan.cycle_step[axis] : plan.cycle_step[axis];
    }
    if (k > 0 && overLimit()) return false;
    if (!cycleHole(plan, hole, k == 0)) return false;
  }
  return true;
}

bool NctControl::cycleHole(BlockPlan& plan, Vec3 hole, bool first) {
  const int drill = PlaneFrame(plan.next.plane()).w();
  Vec3 at = hole;
  at[drill] = position_[drill];
  emitter_.rapidTo(chain_.toMachine(at), here());
  if (first && !performFunctions(plan, MPhase::kBefore)) return false;
  for (const DrillStep& step : steps_) {
    if (!cycleStep(plan, step, at)) return false;
  }
  position_ = at;
  machine_ = chain_.toMachine(at);
  return true;
}

bool NctControl::cycleStep(BlockPlan& plan, const DrillStep& step, Vec3& at) {
  const PlaneFrame frame(plan.next.plane());
  if (step.kind == DrillStepKind::kShift) {
    at[frame.u()] += step.shift.x();
    at[frame.v()] += step.shift.y();
    emitter_.rapidTo(chain_.toMachine(at), here());
  } else if (step.kind == DrillStepKind::kRapid) {
    at[frame.w()] = step.position;
    emitter_.rapidTo(chain_.toMachine(at), here());
  } else if (step.kind == DrillStepKind::kFeed) {
    at[frame.w()] = step.position;
    FeedStyle style = plan.feed;
    style.feed *= step.feed_factor;
    style.kind = step.thread ? MotionKind::kThread : MotionKind::kFeed;
    emitter_.lineTo(chain_.toMachine(at), style, here());
  } else {
    cycleEvent(plan, step);
  }
  return true;
}

void NctControl::cycleEvent(BlockPlan& plan, const DrillStep& step) {
  const auto spindle = [&](int direction) {
    state_.spindle_direction = direction;
    Action action;
    action.source = here();
    setSpindleAction(action, plan.next.spindle_rpm);
    run(action);
  };
  const auto event = [&](const char* name, PathEmitter::EventData data, double time_s = 0.0) {
    emitter_.event(name, std::move(data), time_s, here());
  };
  switch (step.kind) {
    case DrillStepKind::kRapid:
    case DrillStepKind::kFeed:
    case DrillStepKind::kShift:
      break;
    case DrillStepKind::kDwell:
      event("dwell", {{"seconds", jsonNumber(step.dwell)}}, step.dwell);
      break;
    case DrillStepKind::kSpindleForward:
      spindle(1);
      break;
    case DrillStepKind::kSpindleReverse:
      spindle(-1);
      break;
    case DrillStepKind::kSpindleStop:
      spindle(0);
      break;
    case DrillStepKind::kSpindleOrient:
      emitter_.setSpindle(0.0);
      state_.spindle_direction = 0;
      event("spindle", {{"rpm", "0"}, {"direction", jsonString("oriented")}});
      break;
    case DrillStepKind::kCloseLoop:
      event("spindle",
            {{"rpm", jsonNumber(plan.next.spindle_rpm)}, {"direction", jsonString("position loop")}});
      break;
    case DrillStepKind::kProgramStop:
      event("stop", {{"code", jsonString("M0")}, {"reason", jsonString("manual intervention in the cycle")}});
      break;
  }
}

}  // namespace proveout::nc
