#include "core/nc/iso/motion/tool_direction.h"

#include <fmt/core.h>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/parameters/five_axis.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {

namespace {

/// "A -30 to 120, C endless".
std::string travelText(const IsoContext& c) {
  std::string out;
  for (const int k : {c.five_axes.first, c.five_axes.second}) {
    if (k < 0) continue;
    const AxisInfo& axis = c.axes.at(k);
    out += out.empty() ? "" : ", ";
    out += axis.limit ? fmt::format("{} {:g} to {:g}", axis.name, axis.limit->min, axis.limit->max)
                      : fmt::format("{} endless", axis.name);
  }
  return out;
}

}  // namespace

bool planToolDirection(IsoContext& c, BlockPlan& plan) {
  if (c.five_axes.kind == FiveAxisKind::kNone)
    return c.fail("machine-data",
                  "G53.1 needs a head or a table, and the machine of this job has none ([[machine.axis]])");
  if (!ownBlock(c, "G53.1")) return false;
  if (c.anyAxisWord())
    return c.alarm(SharedAlarm::kIllegalAddress, c.block.words.back(), "G53.1 stands alone in its block");
  FiveAxisState& five = plan.next.five;
  if (!five.tilted)
    return c.alarm(SharedAlarm::kNoTilt, "", "G53.1 needs a tilted plane: program G68.2 first");
  if (c.state.compOn())
    return c.fail("tilt-in-comp", "G53.1 cannot turn the tool while cutter compensation (G41, G42) is on");
  if (five.dynamic_zero > 0)
    return c.fail("tilt", "G53.1 while G54.2 is in force: its zero is that of G54 to G59");
  const Mat3 basic = basicRotation(c.registers.frames.system(plan.next.work_system).angles_deg);
  const Vec3 wanted = basic * five.tilt.linear.col(2);
  const RotaryAngles now = c.five_axes.at(c.machine);
  const FiveAxisModel::Positions positions = c.five_axes.positionsFor(wanted, now);
  const std::optional<RotaryAngles> chosen = choosePosition(c.five_axes, positions, now, c.axes);
  if (!chosen) {
    return c.fail(
        "unreachable",
        fmt::format("the tool cannot be turned into the direction {:.4f}, {:.4f}, {:.4f}: {} ({})",
                    wanted.x(), wanted.y(), wanted.z(),
                    positions.count > 0 ? "the positions for it are out of travel" : "no position has it",
                    travelText(c)));
  }
  const bool length = plan.next.active[kGroupLengthComp] != gcode::kLengthOff;
  five.on_table = true;
  five.along_tool = five.along_tool || (length && c.five_axes.hasHead());
  if (five.along_tool) plan.next.length = AxisPoint();
  // The tip stays at its place on the workpiece: the same coordinates with the axes as they are and as they
  // will be.
  AxisPoint end = c.machine;
  if (c.five_axes.first >= 0) end[c.five_axes.first] = chosen->first;
  if (c.five_axes.second >= 0) end[c.five_axes.second] = chosen->second;
  plan.start = c.chainOf(plan.next).programOf(c.machine);
  plan.new_chain = c.chainOf(plan.next, end);
  plan.chain = &*plan.new_chain;
  plan.motion.target = plan.chain->programOf(end);
  if (!c.parameters.flag(FiveAxisParam::kByTransformation)) plan.motion.target.xyz = plan.start.xyz;
  plan.frames_changed = plan.flush = true;
  plan.perform = performMove;
  plan.motion.rapid = plan.next.active[kGroupMotion] == gcode::kRapid;
  return plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

bool followZero(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupWorkSystem];
  const bool called = code != nullptr && code->code10 == gcode::kDynamicZero;
  if (!called || c.anyAxisWord() || plan.perform != nullptr ||
      c.parameters.flag(FiveAxisParam::kByTransformation))
    return true;
  plan.motion.target = plan.start;
  plan.perform = performMove;
  plan.motion.rapid = plan.next.active[kGroupMotion] != gcode::kLine;
  return plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
