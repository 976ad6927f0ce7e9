// G68.2 and its end by G69 (iso-fanuc, section 17).
#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/five_axis/five_axis.h"

namespace proveout::nc {

bool planFanucTiltedPlane(IsoContext& c, BlockPlan& plan) {
  if (!hasFiveAxes(c, "G68.2")) return false;
  const Word* p = c.word('P');
  if (p != nullptr && p->value == 1.0 && c.word('Q') == nullptr) {
    c.warnOnce("G68.2 P1 without Q", "rotation-order",
               "G68.2 P1 without Q: roll, pitch and yaw in the order 123", p->columns, Severity::kNote);
    Word order = *p;
    order.address = 'Q';
    order.value = 123.0;
    c.block.words.push_back(order);
    c.block.present.add('Q');
    c.block.plain = false;
  }
  return planTiltedPlane(c, plan);
}

bool fanucTiltOff(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupRotation];
  FiveAxisState& five = plan.next.five;
  if (code == nullptr || code->code10 != gcode::kRotationOff || !five.tilted) return true;
  if (c.state.compOn())
    return c.fail(
        "tilt-in-comp",
        "G69 cannot end the tilted plane while cutter compensation (G41, G42) is on: program G40 first");
  five.tilt = FrameStep();
  five.rotations = 0;
  five.tilted = five.on_table = false;
  plan.next.active[kGroupTilt] = gcode::kTiltOff;
  plan.frames_changed = plan.flush = true;
  return true;
}

}  // namespace proveout::nc
