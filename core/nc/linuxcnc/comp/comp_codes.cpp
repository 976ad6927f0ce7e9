// G40 G41 G42 G41.1 G42.1.
#include <fmt/core.h>

#include "core/nc/linuxcnc/frames/frames.h"

namespace proveout::nc {
namespace {

/// Radius and orientation from the table. False: reported.
bool lcnTableRadius(IsoContext& c, BlockPlan& plan) {
  int tool = linuxCncToolOf(c, plan);
  if (const Word* d = c.word('D')) {
    std::int64_t number = 0;
    if (!lcnInteger(c, *d, number)) return false;
    if (number < 0) return lcnFail(c, "tool", "Negative D word used", d);
    if (number > OffsetTables::kRows || !linuxCncHasTool(c, static_cast<int>(number)))
      return lcnFail(c, "tool", fmt::format("Requested tool {} not found in the tool table", number), d);
    tool = static_cast<int>(number);
  }
  plan.next.d = tool;
  plan.next.d_radius = tool > 0 ? c.registers.offsets.effective(OffsetColumn::kRadius, tool) : 0.0;
  plan.next.d_tip = tool > 0 ? c.registers.offsets.tip(tool) : 0;
  if (tool > 0 && !c.registers.offsets.given(OffsetColumn::kRadius, tool))
    c.warnOnce(
        fmt::format("radius {}", tool), "offset-missing",
        fmt::format("the tool table has no diameter of tool {0}: 0 is taken (--offset D{0}=RADIUS)", tool));
  return true;
}

bool lcnWordRadius(IsoContext& c, BlockPlan& plan, const char* code) {
  const Word* d = c.word('D');
  if (d == nullptr) return lcnFail(c, "comp", fmt::format("{} without D: it needs the diameter", code));
  plan.next.d_radius = 0.5 * lengthOf(plan, *d);
  plan.next.d_tip = 0;
  if (const Word* l = c.word('L')) {
    std::int64_t tip = 0;
    if (!lcnInteger(c, *l, tip)) return false;
    if (tip < 0 || tip > 9) return lcnFail(c, "comp", "Invalid tool orientation: L is 0 to 9", l);
    if (tip != 0 && plan.next.active[kGroupPlane] != gcode::kPlaneZX)
      return lcnFail(c, "comp", "G41.1, G42.1 with L: the orientation is of lathes, in G18", l);
    plan.next.d_tip = static_cast<int>(tip);
  }
  return true;
}

}  // namespace

bool planLcnComp(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupRadiusComp];
  if (code == nullptr) return true;
  IsoState& next = plan.next;
  LinuxCncChannel& own = linuxCncChannel(c);
  plan.claimed = plan.claimed | code->words;
  if (code->code10 == gcode::kCompOff) {
    next.active[kGroupRadiusComp] = gcode::kCompOff;
    if (c.state.compOn()) own.next.arc_after_comp = own.comp.idle();
    next.d_tip = 0;
    return true;
  }
  if (next.active[kGroupPlane] == gcode::kPlaneYZ)
    return lcnFail(c, "comp", "Cannot turn cutter radius compensation on out of the XY or XZ plane");
  if (c.state.compOn())
    return lcnFail(c, "comp", "Cannot turn cutter radius compensation on when on already");
  const bool by_word = code->code10 == lcn::kCompLeftD || code->code10 == lcn::kCompRightD;
  const std::string name = gName(code->code10);
  if (by_word ? !lcnWordRadius(c, plan, name.c_str()) : !lcnTableRadius(c, plan)) return false;
  const bool left = code->code10 == gcode::kCompLeft || code->code10 == lcn::kCompLeftD;
  next.active[kGroupRadiusComp] = left ? gcode::kCompLeft : gcode::kCompRight;
  own.next.dynamic_radius = by_word;
  return true;
}

}  // namespace proveout::nc
