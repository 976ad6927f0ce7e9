// G0 G1 G4 G33 G33.1 G53.
#include <fmt/core.h>

#include "core/nc/iso/motion/feed.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"

namespace proveout::nc {
namespace {

bool lcnMachineWords(IsoContext& c, const BlockPlan& plan) {
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot == nullptr || one_shot->code10 != gcode::kMachineMove) return true;
  const int motion = plan.next.active[kGroupMotion];
  if (motion != gcode::kRapid && motion != gcode::kLine)
    return lcnFail(c, "machine-move", "Must use g0 or g1 with g53");
  if (lcnCompOn(c, plan)) return lcnFail(c, "comp", "Cannot use g53 with cutter radius compensation on");
  if (plan.next.incremental() && !isPlainGrbl(c))
    return lcnFail(c, "machine-move", "Cannot use g53 incremental");
  return true;
}

/// The spindle's way in a synchronous motion: `lead` mm a turn along the path.
bool lcnSynchronous(IsoContext& c, BlockPlan& plan, const char* code, double& lead) {
  const Word* k = c.ownWord(plan, 'K');
  if (k == nullptr) return lcnFail(c, "thread", fmt::format("K word missing with {}", code));
  if (plan.next.compOn())
    return lcnFail(c, "comp", fmt::format("Cannot use {} with cutter radius compensation on", code));
  lead = lengthOf(plan, *k);
  if (!(lead > 0.0)) return lcnFail(c, "thread", fmt::format("K of {} must be above 0", code), k);
  return true;
}

/// Turns a minute of a synchronous motion; without S the simulator's own, told once.
double lcnThreadRpm(IsoContext& c, const BlockPlan& plan) { return turnsPerMinute(c, plan); }

}  // namespace

bool planLcnNothing(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  plan.perform = performLinuxCncSteps;
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot != nullptr && one_shot->code10 == gcode::kMachineMove && !isPlainGrbl(c))
    return lcnFail(c, "machine-move", "Must use g0 or g1 with g53");
  return true;
}

bool planLcnRapid(IsoContext& c, BlockPlan& plan) {
  plan.perform = performLinuxCncSteps;
  if (!lcnMachineWords(c, plan) || !lcnTarget(c, plan, plan.motion.target)) return false;
  plan.motion.rapid = true;
  plan.motion.feed.join.stops = joinOf(plan).stops;
  if (!lcnAnyAxis(c)) return true;
  LinuxCncChannel& own = linuxCncChannel(c);
  lcnRapid(own, plan.motion.target);
  own.next.arc_after_comp = true;
  return true;
}

bool planLcnLine(IsoContext& c, BlockPlan& plan) {
  plan.perform = performLinuxCncSteps;
  if (!lcnMachineWords(c, plan) || !lcnTarget(c, plan, plan.motion.target)) return false;
  if (!lcnLineFeed(c, plan, plan.motion.target, "g1", plan.motion.feed)) return false;
  if (!lcnAnyAxis(c)) return true;
  LinuxCncChannel& own = linuxCncChannel(c);
  lcnFeedTo(own, plan.motion.target);
  own.next.arc_after_comp = true;
  return true;
}

bool planLcnDwell(IsoContext& c, BlockPlan& plan) {
  const Word* p = c.word('P');
  if (p == nullptr) return lcnFail(c, "dwell", "Dwell time P word missing with g4");
  if (p->value < 0.0) return lcnFail(c, "dwell", "Negative P word used", p);
  const bool mach3 = linuxCncFlavour(c) == LinuxCncFlavour::kMach3;
  if (mach3)
    c.warnOnce("dwell unit", "setting",
               "whether P of G4 is seconds or milliseconds is a setting of Mach3: dwell_unit of the job", {});
  const double scale = mach3 && c.parameters.flag(LinuxCncParam::kDwellUnit) ? 1e-3 : 1.0;
  linuxCncChannel(c).steps.push_back(
      {.kind = LinuxCncStep::Kind::kDwell, .to = {}, .value = p->value * scale});
  plan.perform = performLinuxCncSteps;
  return true;
}

bool planLcnThread(IsoContext& c, BlockPlan& plan) {
  double lead = 0.0;
  if (!lcnSynchronous(c, plan, "g33", lead) || !lcnTarget(c, plan, plan.motion.target)) return false;
  plan.perform = performLinuxCncSteps;
  plan.motion.feed.join = joinOf(plan);
  if (!lcnSpindleTurns(c, plan)) return lcnFail(c, "spindle-stopped", "Spindle not turning in G33");
  linuxCncChannel(c).steps.push_back(
      {.kind = LinuxCncStep::Kind::kThread, .to = plan.motion.target, .value = lead * lcnThreadRpm(c, plan)});
  plan.next.axes.thread_lead = lead;
  return true;
}

bool planLcnTap(IsoContext& c, BlockPlan& plan) {
  double lead = 0.0;
  if (!lcnSynchronous(c, plan, "g33.1", lead) || !lcnTarget(c, plan, plan.motion.target)) return false;
  if (!lcnSpindleTurns(c, plan) || !(lcnRpm(c, plan) > 0.0))
    return lcnFail(c, "spindle-stopped", "Spindle not turning in G33.1");
  const Word* i = c.ownWord(plan, 'I');
  const double back = i == nullptr ? 1.0 : i->value;
  if (!(back > 0.0)) return lcnFail(c, "thread", "I of G33.1 must be above 0", i);
  plan.perform = performLinuxCncSteps;
  const double feed = lead * lcnRpm(c, plan);
  using Kind = LinuxCncStep::Kind;
  auto& steps = linuxCncChannel(c).steps;
  const double direction = c.state.spindle_direction < 0 ? -1.0 : 1.0;
  steps.push_back({.kind = Kind::kThread, .to = plan.motion.target, .value = feed});
  steps.push_back({.kind = Kind::kSpindle, .to = {}, .value = -direction});
  steps.push_back({.kind = Kind::kThread, .to = plan.start, .value = feed * back});
  steps.push_back({.kind = Kind::kSpindle, .to = {}, .value = direction});
  plan.motion.target = plan.start;
  return true;
}

}  // namespace proveout::nc
