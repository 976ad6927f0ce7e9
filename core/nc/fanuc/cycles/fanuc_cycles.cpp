#include "core/nc/fanuc/cycles/fanuc_cycles.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr int kFanucTapLeft = 740, kFanucTap = 840, kFanucDeep = 830;
/// Setting 22 of Haas where the job does not say more: 0.1 inch.
constexpr double kHaasClearanceMm = 2.54;
/// The spindle's position: 4096 pulses a turn, at most 32767 in the 8 ms of a period.
constexpr double kFastestTapRpm = 59999.0;
/// Steps of Z that a G84 J of Haas may be faster on its way out.
constexpr double kHaasFastestOut = 9.0;

bool tapsThread(const BlockPlan& plan) {
  const int code10 = plan.next.active[kGroupCycle];
  return code10 == kFanucTap || code10 == kFanucTapLeft;
}

bool isRigidTap(const IsoContext& c, const BlockPlan& plan) {
  return tapsThread(plan) && (plan.next.rigid_tap != RigidTap::kOff || isHaas(c) ||
                              c.parameters[FanucParam::kRigidAlways] != 0.0);
}

DrillCode fanucDrillCode(const IsoContext& c, const BlockPlan& plan) {
  struct Row {
    int code10;
    DrillCode drill;
  };
  constexpr std::array<Row, 13> kRows{{{730, DrillCode::kChipBreak},
                                       {740, DrillCode::kTapLeft},
                                       {760, DrillCode::kFineBore},
                                       {770, DrillCode::kBackBore},
                                       {810, DrillCode::kDrill},
                                       {820, DrillCode::kDrillDwell},
                                       {830, DrillCode::kPeck},
                                       {840, DrillCode::kTap},
                                       {850, DrillCode::kBoreFeedOut},
                                       {860, DrillCode::kBoreStop},
                                       {870, DrillCode::kBackBore},
                                       {880, DrillCode::kBoreManual},
                                       {890, DrillCode::kBoreDwellFeedOut}}};
  const int code10 = plan.next.active[kGroupCycle];
  if (isRigidTap(c, plan)) return code10 == kFanucTap ? DrillCode::kRigidTap : DrillCode::kRigidTapLeft;
  for (const Row& row : kRows) {
    if (row.code10 == code10) return row.drill;
  }
  return DrillCode::kDrill;
}

bool isPecking(DrillCode code) { return code == DrillCode::kChipBreak || code == DrillCode::kPeck; }
bool isRigidCode(DrillCode code) { return code == DrillCode::kRigidTap || code == DrillCode::kRigidTapLeft; }

/// Haas: pecks I, I - J, I - 2 J and so on, none below K.
bool hasFallingPecks(const IsoContext& c, const BlockPlan& plan) {
  return isHaas(c) && plan.next.cycle.shift[0] != 0.0;
}

/// The words that this cycle of the mode reads; the shared rules know the others.
AddressSet fanucWordsOf(const IsoContext& c, const BlockPlan& plan, DrillCode code) {
  AddressSet words;
  if (code == DrillCode::kFineBore || code == DrillCode::kBackBore) words = words | AddressSet("QP");
  if (isPecking(code) && isHaas(c)) words = words | AddressSet("IJKP");
  if (tapsThread(plan) && isHaas(c)) words.add('J');
  return words;
}

bool checkFanucCycle(IsoContext& c, const BlockPlan& plan, DrillCode code) {
  const double q = plan.next.cycle.peck;
  if (isPecking(code) && !hasFallingPecks(c, plan) && !(q > 0.0)) {
    const Word* word = c.word('Q');
    return c.fail("045",
                  fmt::format("address Q not found or not above 0: {} needs the depth of a peck",
                              gName(plan.next.active[kGroupCycle])),
                  word != nullptr ? word->columns : Columns{});
  }
  if (!isRigidCode(code)) return true;
  if (!(plan.next.spindle_rpm > 0.0))
    return c.fail("200", "illegal S code command: rigid tapping needs a speed of the spindle (S)");
  if (plan.next.spindle_rpm > kFastestTapRpm) {
    return c.fail(
        "202", fmt::format("position LSI overflow: rigid tapping turns at most {:g} 1/min", kFastestTapRpm));
  }
  if (!(plan.next.feed > 0.0))
    return c.fail("201", "feedrate not found in rigid tapping: program F with the cycle");
  return true;
}

/// Q of fine and back boring, in the direction that the machine's maker has chosen, unless I and J say more.
bool takeShift(IsoContext& c, const BlockPlan& plan, DrillCycle& cycle) {
  if (plan.next.compOn() && (cycle.shift != Vec2::Zero() || plan.next.cycle.peck != 0.0)) {
    return c.fail("cycle-in-comp",
                  fmt::format("the shift of {} in the hole cannot run in cutter compensation: "
                              "program G40 first",
                              gName(plan.next.active[kGroupCycle])));
  }
  if (cycle.shift != Vec2::Zero()) return true;
  const double q = std::abs(plan.next.cycle.peck);
  if (q == 0.0) return true;
  constexpr std::array<std::array<double, 2>, 4> kDirections{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto chosen = static_cast<std::size_t>(c.parameters[FanucParam::kBoreShift]);
  const auto& direction = kDirections[chosen < kDirections.size() ? chosen : 0];
  cycle.shift = {q * direction[0], q * direction[1]};
  noteSetting(c, FanucParam::kBoreShift,
              "Q of G76 and G87 shifts along the first axis of the plane, +X in G17");
  return true;
}

void takePecks(IsoContext& c, const BlockPlan& plan, DrillCycle& cycle) {
  const CycleWords& words = plan.next.cycle;
  const bool deep = plan.next.active[kGroupCycle] == kFanucDeep;
  const CycleParam clearance = deep ? CycleParam::kPeckClearance : CycleParam::kChipBreakReturn;
  if (isHaas(c) && !c.parameters.given(clearance)) cycle.clearance = kHaasClearanceMm;
  noteSetting(
      c, clearance,
      fmt::format("{:g} mm {}", cycle.clearance,
                  deep ? "above the last depth the rapid of G83 ends" : "back between the pecks of G73"));
  if (!isHaas(c)) return;
  cycle.dwell_of_pecks = true;
  if (hasFallingPecks(c, plan)) {
    cycle.peck = std::abs(words.shift[0]);
    cycle.peck_less = std::abs(words.shift[1]);
    cycle.peck_least = std::abs(words.shift[2]);
  } else if (!deep) {
    cycle.to_r_every = std::abs(words.shift[2]);
  }
}

bool takeRigid(IsoContext& c, const BlockPlan& plan, DrillCycle& cycle) {
  if (cycle.peck > 0.0) {
    const bool full = c.parameters[FanucParam::kRigidPeck] != 0.0;
    noteSetting(c, FanucParam::kRigidPeck,
                full ? "pecks of rigid taps go out to R"
                     : "between the pecks of rigid taps the tool goes back a little");
    cycle.tap_returns_to_r = full;
    // Out to R the way back down is by feed all along.
    cycle.clearance =
        full ? std::abs(cycle.bottom - cycle.r) : c.parameters[CycleParam::kRigidChipBreakReturn];
    if (!full)
      noteSetting(c, CycleParam::kRigidChipBreakReturn, fmt::format("{:g} mm back", cycle.clearance));
  }
  if (!isHaas(c)) return true;
  const double faster = plan.next.cycle.shift[1];
  if (faster == 0.0) return true;
  if (!(faster >= 1.0 && faster <= kHaasFastestOut)) {
    const Word* j = c.word('J');
    return c.fail("cycle-data", "J of G84 is how many times faster the tap goes out, 1 to 9",
                  j != nullptr ? j->columns : Columns{});
  }
  cycle.retract_factor = faster;
  return true;
}

bool finishFanucCycle(IsoContext& c, const BlockPlan& plan, DrillCycle& cycle) {
  cycle.peck = std::abs(cycle.peck);
  cycle.dwell_of_back = cycle.dwell_at_r = cycle.stops_at_r = true;
  c.asked = c.asked | fanucWordsOf(c, plan, cycle.code);
  switch (cycle.code) {
    case DrillCode::kFineBore:
    case DrillCode::kBackBore:
      return takeShift(c, plan, cycle);
    case DrillCode::kChipBreak:
    case DrillCode::kPeck:
      takePecks(c, plan, cycle);
      return true;
    case DrillCode::kRigidTap:
    case DrillCode::kRigidTapLeft:
      return takeRigid(c, plan, cycle);
    case DrillCode::kBoreManual:
      c.warnOnce("g88", "cycle-manual",
                 "G88: the operator brings the tool out of the hole by hand; here it goes to R by rapid");
      return true;
    default:
      return true;
  }
}

CycleRules makeFanucRules(bool haas) {
  CycleRules rules;
  rules.repeats = haas ? AddressSet("L") : AddressSet("KL");
  rules.r_names_hole = true;
  rules.signed_peck = true;
  rules.percent_by_i = false;
  rules.functions_first = true;
  rules.no_level = haas ? CycleRules::NoLevel::kTaken : CycleRules::NoLevel::kTold;
  rules.no_bottom = "cycle-no-z";
  rules.code = fanucDrillCode;
  rules.dwell = fanucDwellSeconds;
  rules.check = checkFanucCycle;
  rules.finish = finishFanucCycle;
  return rules;
}

}  // namespace

bool isHaas(const IsoContext& c) { return c.parameters[FanucParam::kFlavour] == kHaasFlavour; }

bool fanucDwellSeconds(IsoContext& c, const Word& p, double& seconds) {
  const auto begin = static_cast<std::size_t>(p.columns.begin - 1);
  const auto length = static_cast<std::size_t>(p.columns.end - p.columns.begin);
  const bool computed = p.from_expression;
  const bool point = !computed && c.block.text.substr(begin, length).find('.') != std::string_view::npos;
  if (p.value < 0.0) return c.alarm(SharedAlarm::kOutOfRange, p, "a dwell is not negative");
  if (isHaas(c)) {
    seconds = point || (computed && !p.is_integer) ? p.value : 1e-3 * p.value;
    return true;
  }
  if (point) return c.fail("007", "decimal point misplaced: P of a dwell counts milliseconds", p.columns);
  seconds = 1e-3 * (computed ? std::round(p.value) : p.value);
  return true;
}

const CycleRules& fanucCycleRulesOf(bool haas) {
  static const CycleRules kFanucRules = makeFanucRules(false);
  static const CycleRules kHaasRules = makeFanucRules(true);
  return haas ? kHaasRules : kFanucRules;
}

bool planFanucCycle(IsoContext& c, BlockPlan& plan) {
  if (plan.next.active[kGroupRadiusComp] == gcode::kCompInSpace)
    return c.fail("space-comp", "no drilling cycles under G141: program G40 before");
  if (tapsThread(plan) && plan.next.rigid_tap == RigidTap::kAsked) plan.next.rigid_tap = RigidTap::kOn;
  return planCycleBy(c, plan, fanucCycleRulesOf(isHaas(c)));
}

bool planRigidTapMode(IsoContext& c, BlockPlan& plan) {
  const Word* s = c.word('S');
  const double speed = s != nullptr ? s->value : c.state.spindle_rpm;
  if (!(speed > 0.0)) {
    return c.fail("200", "illegal S code command: M29 needs the speed of the spindle (S)",
                  s != nullptr ? s->columns : Columns{});
  }
  plan.next.rigid_tap = RigidTap::kAsked;
  return true;
}

bool followRigidTap(IsoContext& c, BlockPlan& plan) {
  RigidTap& rigid = plan.next.rigid_tap;
  const bool waits = rigid == RigidTap::kAsked || (plan.next.inCycle() && tapsThread(plan));
  if (rigid != RigidTap::kOff && waits && !(plan.next.workPlane() == c.state.workPlane()))
    return c.fail("206", "the plane cannot change in rigid tapping: choose it in front of M29");
  if (rigid == RigidTap::kOff || (plan.next.inCycle() && tapsThread(plan))) return true;
  if (rigid == RigidTap::kOn) {  // the cycle has ended
    rigid = RigidTap::kOff;
    return true;
  }
  const GCode* code = plan.governor;
  const bool motion = code != nullptr && (code->group == kGroupMotion || code->group == kGroupCycle);
  const bool moves = plan.perform != nullptr && (motion || std::holds_alternative<MachineMove>(plan.payload));
  return !moves ||
         c.fail("203", "program miss at rigid tapping: nothing may move between M29 and G84 or G74");
}

}  // namespace proveout::nc
