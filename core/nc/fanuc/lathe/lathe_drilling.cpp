// G83 to G85 on the face, G87 to G89 on the side (section 16).
#include <fmt/core.h>

#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/cycles/holes.h"
#include "core/nc/iso/motion/feed.h"

namespace proveout::nc {
namespace {

constexpr std::int32_t kDrillCode = 830, kTapCode = 840, kBoreCode = 850;

/// The axis of the drill: Z of the face codes, X of those that programs write as G87 to G89.
int drillAxis(const BlockPlan& plan) {
  const GCode* const code = plan.by_group[kGroupCycle];
  return code == nullptr ? plan.next.cycle.drill_axis : code->number10() >= 870 ? 0 : 2;
}

/// The peck Q, mm. Without a point it counts in thousandths on the control: a number that is no depth says
/// so.
double peckOf(IsoContext& c, const BlockPlan& plan, const Word& q) {
  constexpr double kNoPeck = 100.0;
  if (pointed(c, q) || countsIncrements(c, q) || q.value < kNoPeck) return lengthOf(plan, q);
  const double increment = plan.next.active[kGroupUnits] == gcode::kInch ? 1e-4 : 1e-3;
  const double peck = increment * lengthOf(plan, q);
  c.warnOnce("peck without a point", "point",
             fmt::format("Q{:g} without a point counts in least increments: {:g} mm", q.value, peck),
             q.columns, Severity::kNote);
  return peck;
}

/// Heights count from the start level in system A; in B and C as G90 and G91 say.
bool takeDrillWords(IsoContext& c, BlockPlan& plan) {
  CycleWords& words = plan.next.cycle;
  Holes& holes = plan.payload.emplace<Holes>();
  const bool system_a = c.parameters[FanucParam::kGcodeSystem] == 0.0;
  takeHoleWords(c, plan, holes);
  if (c.ownWord(plan, 'R') != nullptr) {
    words.r = lengthWord(c, plan, 'R');
    words.r_incremental = system_a || plan.next.incremental();
  }
  if (const Word* q = c.ownWord(plan, 'Q')) {
    if (q->value < 0.0) return c.failWord("045", "the peck Q must not be negative", *q);
    words.peck = peckOf(c, plan, *q);
  }
  if (const Word* p = c.ownWord(plan, 'P')) {
    if (p->value < 0.0) return c.alarm(SharedAlarm::kOutOfRange, *p, "a dwell is not negative");
    words.dwell = 0.001 * p->value;
  }
  if (const Word* k = c.ownWord(plan, 'K'); k != nullptr && !integerWord(c, *k, 0, 9999, holes.repeat))
    return false;
  return words.bottom.has_value() ||
         c.alarm(SharedAlarm::kNoBottom, "", fmt::format("the cycle needs {}", "XYZ"[words.drill_axis]));
}

bool expandHoles(IsoContext& c, BlockPlan& plan) {
  const CycleWords& words = plan.next.cycle;
  Holes& holes = std::get<Holes>(plan.payload);
  DrillCycle cycle;
  const std::int32_t code = plan.next.active[kGroupCycle];
  const bool fast = !c.parameters.flag(FanucParam::kPeckToR);
  cycle.code = code == kTapCode ? DrillCode::kTap
               : code == kBoreCode
                   ? (words.dwell > 0.0 ? DrillCode::kBoreDwellFeedOut : DrillCode::kBoreFeedOut)
               : words.peck > 0.0 ? (fast ? DrillCode::kChipBreak : DrillCode::kPeck)
                                  : DrillCode::kDrillDwell;
  if (code == kDrillCode && words.peck > 0.0)
    noteSetting(c, FanucParam::kPeckToR,
                "between pecks G83 and G87 return a little (\"short\") or to level R (\"full\", 5101#2 RTR)");
  holes.code = cycle.code;
  takeLevels(plan, holes, cycle);
  const bool system_a = c.parameters[FanucParam::kGcodeSystem] == 0.0;
  cycle.return_to_r = !system_a && plan.next.active[kGroupReturn] == gcode::kReturnToR;
  cycle.peck = words.peck;
  cycle.clearance = c.parameters[fast ? CycleParam::kChipBreakReturn : CycleParam::kPeckClearance];
  cycle.dwell = words.dwell;
  switch (expandDrillCycle(cycle, c.drill_steps)) {
    case DrillError::kNone:
      return true;
    case DrillError::kTooManySteps:
      return c.fail("045", "the peck Q is too small for this depth");
    default:
      return c.fail(SharedAlarm::kOutOfRange, "the words of the drilling cycle are out of range");
  }
}

}  // namespace

bool planLatheDrilling(IsoContext& c, BlockPlan& plan) {
  CycleWords& words = plan.next.cycle;
  const int axis = drillAxis(plan);
  const bool entry = !c.state.inCycle() || words.drill_axis != axis;
  if (entry) {
    words = CycleWords();
    words.initial = plan.start[axis];
    words.drill_axis = axis;
  }
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  plan.motion.target = plan.start;
  if (!plan.motion.named.any()) return true;
  if (!takeDrillWords(c, plan)) return false;
  if (std::get<Holes>(plan.payload).repeat == 0) return true;
  plan.perform = performHoles;
  plan.runs_functions = true;
  return feedStyle(c, plan, plan.motion.feed) && expandHoles(c, plan);
}

}  // namespace proveout::nc
