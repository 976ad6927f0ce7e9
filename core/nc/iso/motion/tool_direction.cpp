#include "core/nc/iso/motion/tool_direction.h"

#include <fmt/core.h>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/five_axis/tip_control.h"
#include "core/nc/iso/five_axis/tip_way.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/parameters/five_axis.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {

namespace {

/// Whether G53.1 or G53.6 may run here. False: reported.
bool mayTurn(IsoContext& c, const BlockPlan& plan, const char* name) {
  const FiveAxisState& five = plan.next.five;
  if (!five.tilted)
    return c.alarm(SharedAlarm::kNoTilt, "",
                   fmt::format("{} needs a tilted plane: program G68.2 first", name));
  if (c.state.compOn())
    return c.fail("tilt-in-comp",
                  fmt::format("{} cannot turn the tool while cutter compensation (G41, G42) is on", name));
  if (five.dynamic_zero > 0)
    return c.fail("tilt", fmt::format("{} while G54.2 is in force: its zero is that of G54 to G59", name));
  return true;
}

/// The rotary axes with the tool along Z of the tilted plane. None: reported.
std::optional<RotaryAngles> anglesOfPlane(IsoContext& c, const BlockPlan& plan) {
  const Mat3 basic = basicRotation(c.registers.frames.system(plan.next.work_system).angles_deg);
  return chooseAngles(c, basic * plan.next.five.tilt.linear.col(2));
}

/// Programmed coordinates from here on: start, end with the axes turned, and the chains of both.
void turnTo(const IsoContext& c, BlockPlan& plan, const RotaryAngles& angles) {
  AxisPoint end = c.machine;
  setAngles(c.five_axes, angles, end);
  plan.start = c.chainOf(plan.next).programOf(c.machine);
  plan.new_chain = c.chainOf(plan.next, end);
  plan.chain = &*plan.new_chain;
  plan.motion.target = plan.chain->programOf(end);
  plan.frames_changed = plan.flush = true;
  plan.motion.rapid = plan.next.active[kGroupMotion] == gcode::kRapid;
}

}  // namespace

bool planToolDirection(IsoContext& c, BlockPlan& plan) {
  if (!hasFiveAxes(c, "G53.1") || !ownBlock(c, "G53.1")) return false;
  if (c.anyAxisWord())
    return c.alarm(SharedAlarm::kIllegalAddress, c.block.words.back(), "G53.1 stands alone in its block");
  if (!mayTurn(c, plan, "G53.1")) return false;
  const std::optional<RotaryAngles> chosen = anglesOfPlane(c, plan);
  if (!chosen) return false;
  FiveAxisState& five = plan.next.five;
  const bool length = plan.next.active[kGroupLengthComp] != gcode::kLengthOff;
  five.on_table = true;
  five.along_tool = five.along_tool || (length && c.five_axes.hasHead());
  if (five.along_tool) plan.next.length = AxisPoint();
  // The tip stays at its place on the workpiece: the same coordinates with the axes as they are and as they
  // will be.
  turnTo(c, plan, *chosen);
  if (!c.parameters.flag(FiveAxisParam::kByTransformation)) plan.motion.target.xyz = plan.start.xyz;
  plan.perform = performMove;
  return plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

namespace {

/// Whether G53.6 stands with its own words alone. False: reported.
bool aboutTipAlone(IsoContext& c) {
  for (const Word& w : c.block.words) {
    if (w.axis >= kMainAxes) return c.alarm(SharedAlarm::kIllegalAddress, w, "G53.6 takes X, Y, Z, R and H");
  }
  return ownBlockOf(c, "G53.6", "XYZUVWRH");
}

/// The words of G53.6 beside H. False: reported.
bool targetAboutTip(IsoContext& c, BlockPlan& plan) {
  bool positions = false;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const double value = axisValue(c, plan, word, w);
    plan.motion.target[word.axis] = word.step ? plan.start[word.axis] + value : value;
    positions = true;
  }
  const Word* r = c.word('R');
  if (r == nullptr) return true;
  if (positions) return c.alarm(SharedAlarm::kTipAndTarget, "");
  // The point beyond the tip that stays: the tip is R on from it, along the tool.
  plan.motion.pivot_mm = lengthOf(plan, *r);
  return true;
}

bool performAboutTip(IsoContext& c, BlockPlan& plan) {
  if (plan.motion.pivot_mm != 0.0) plan.motion.target.xyz = TipWay(c, plan).pivoted(plan.motion.target);
  if (!performMove(c, plan)) return false;
  FiveAxisState& five = plan.next.five;
  const bool length = plan.next.active[kGroupLengthComp] != gcode::kLengthOff;
  // G43 on tables lies along Z as before; what has lain along the tool does on.
  five.along_tool = length && (c.five_axes.hasHead() || c.state.five.along_tool);
  c.chain = c.chainOf(plan.next);
  c.position = c.chain.programOf(c.machine);
  return true;
}

}  // namespace

bool planToolDirectionAboutTip(IsoContext& c, BlockPlan& plan) {
  if (!hasFiveAxes(c, "G53.6") || !aboutTipAlone(c) || !mayTurn(c, plan, "G53.6")) return false;
  if (plan.next.h == 0) return c.alarm(SharedAlarm::kNoLength, "", "G53.6 needs the length of the tool");
  const std::optional<RotaryAngles> chosen = anglesOfPlane(c, plan);
  if (!chosen) return false;
  plan.next.five.on_table = plan.next.five.along_tool = true;
  turnTo(c, plan, *chosen);
  plan.motion.target.xyz = plan.start.xyz;
  plan.motion.about_tip = true;
  if (!targetAboutTip(c, plan)) return false;
  plan.perform = performAboutTip;
  plan.rebases = true;
  return plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

namespace {

bool callsDynamicZero(const BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupWorkSystem];
  return code != nullptr && code->code10 == gcode::kDynamicZero;
}

}  // namespace

bool callsInRapid(const BlockPlan& plan) {
  const int motion = plan.next.active[kGroupMotion];
  return callsDynamicZero(plan) && motion != gcode::kRapid && motion != gcode::kLine;
}

bool followZero(IsoContext& c, BlockPlan& plan) {
  if (!callsDynamicZero(plan) || c.anyAxisWord() || plan.perform != nullptr ||
      c.parameters.flag(FiveAxisParam::kByTransformation))
    return true;
  plan.motion.target = plan.start;
  plan.perform = performMove;
  plan.motion.rapid = plan.next.active[kGroupMotion] != gcode::kLine;
  return plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
