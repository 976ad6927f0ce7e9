// G45 to G48: the way of the block becomes longer or shorter by the offset of D (iso-fanuc, section 7).
#include <cmath>

#include "core/nc/fanuc/tools/offsets.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

/// Lengths of the offset by which ways grow: 1 G45, -1 G46, 2 G47, -2 G48.
double growthOf(int code10) {
  const double size = code10 >= 470 ? 2.0 : 1.0;
  return code10 == 450 || code10 == 470 ? size : -size;
}

/// +1 or -1: a way of nothing grows along the sign that it is written with.
double signOf(double way, const Word& w) {
  if (way != 0.0) return way < 0.0 ? -1.0 : 1.0;
  return w.minus ? -1.0 : 1.0;
}

bool onArc(const BlockPlan& plan) {
  const int motion = plan.next.active[kGroupMotion];
  return motion == gcode::kArcClockwise || motion == gcode::kArcCounterClockwise;
}

}  // namespace

bool planFanucPositionOffset(IsoContext& c, BlockPlan& plan) {
  const int code10 = plan.by_group[kOneShot]->code10;
  if (c.state.compOn() || plan.next.compOn())
    return c.fail("042", gName(code10) + " is not allowed in cutter compensation: program G40 first");
  if (plan.next.inCycle())
    return c.fail("position-offset", gName(code10) + " cannot stand in a drilling cycle: program G80 first");
  if (!c.anyAxisWord())
    c.warn("position-offset", gName(code10) + " without an axis does nothing", {}, Severity::kNote);
  if (plan.next.d == 0)
    c.warnOnce("G45 without D", "no-d", gName(code10) + " without a D in force: ways grow by 0");
  const double grows = growthOf(code10) * plan.next.d_radius / plan.next.unitScale();
  const PlaneFrame plane(plan.next.plane());
  for (Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word)) {
      if (word.axis >= kMainAxes && c.axes.at(word.axis).rotary()) continue;
      const double way = word.step ? w.value : axisValue(c, plan, word, w) - plan.start[word.axis];
      w.value += signOf(way, w) * grows;
    } else if (onArc(plan) && w.address >= 'I' && w.address <= 'K' && w.value != 0.0) {
      w.value += signOf(w.value, w) * grows;
    } else if (onArc(plan) && w.address == 'R') {
      w.value += signOf(w.value, w) * grows;
    } else {
      continue;
    }
    w.is_integer = std::floor(w.value) == w.value;
  }
  c.block.plain = false;  // its text does not show its words any more
  plan.governor = c.codes.inForce(plan.next.active[kGroupMotion]);
  return plan.governor->plan(c, plan);
}

}  // namespace proveout::nc
