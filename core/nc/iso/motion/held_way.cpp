#include "core/nc/iso/motion/held_way.h"

#include <fmt/core.h>

#include <cmath>

namespace proveout::nc {
namespace {

/// Ways shorter than this are rounding, mm.
constexpr double kHeldNothingMm = 1e-9;

bool movesOnArc(const BlockPlan& plan) {
  const int motion = plan.next.active[kGroupMotion];
  return !plan.next.inCycle() && (motion == gcode::kArcClockwise || motion == gcode::kArcCounterClockwise);
}

}  // namespace

void holdLength(IsoContext& c, BlockPlan& plan) {
  if (c.state.length.xyz == plan.next.length.xyz && plan.length_shift.xyz.isZero(0.0)) return;
  AxisPoint old = c.state.length;
  for (int axis = 0; axis < kMainAxes; ++axis) old[axis] += plan.length_shift[axis];
  const AxisPoint& length = plan.next.length;
  if (old.xyz == length.xyz || plan.next.five.any()) return;
  IsoState before = plan.next;
  before.length = old;
  const AxisPoint counted = c.chainOf(before).programOf(c.machine);
  HeldWay& held = plan.next.held;
  for (int axis = 0; axis < kMainAxes; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double way = counted[axis] - plan.start[axis] + (held.in_steps[k] ? held.way[axis] : 0.0);
    if (old[axis] == length[axis]) continue;
    held.way[axis] = way;
    held.axes[k] = held.in_steps[k] = held.of_length[k] = std::abs(way) > kHeldNothingMm;
  }
}

void holdPlane(BlockPlan& plan, const AxisPoint& counted, bool in_steps) {
  HeldWay& held = plan.next.held;
  for (const int axis : {plan.next.axes.plane_u, plan.next.axes.plane_v}) {
    if (axis >= kMainAxes) continue;
    const auto k = static_cast<std::size_t>(axis);
    held.way[axis] = counted[axis] - plan.start[axis];
    held.axes[k] = std::abs(held.way[axis]) > kHeldNothingMm;
    held.in_steps[k] = held.axes[k] && in_steps;
    held.of_length.reset(k);
  }
}

void endHeldWay(IsoContext& c, BlockPlan& plan, const AxisPoint& to) {
  if (c.stages.comp.linked()) c.stages.comp.forgetVector();
  for (int axis = 0; axis < kMainAxes; ++axis) {
    if (to[axis] != c.machine[axis]) plan.next.held.axes.reset(static_cast<std::size_t>(axis));
  }
}

void goHeldWay(IsoContext& c, BlockPlan& plan, AxisPoint& target, WordsAre words) {
  HeldWay& held = plan.next.held;
  const int u = plan.next.axes.plane_u, v = plan.next.axes.plane_v;
  const bool goes = words != WordsAre::kReference;
  const bool polar = words == WordsAre::kModal && plan.next.active[kGroupPolarData] == gcode::kPolarData;
  const auto done = [&](std::size_t k) {
    held.axes.reset(k);
    held.in_steps.reset(k);
    held.of_length.reset(k);
  };
  bool plane_told = false;  // an absolute word of the plane
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word) || word.axis >= kMainAxes) continue;
    const auto k = static_cast<std::size_t>(word.axis);
    const bool in_plane = word.axis == u || word.axis == v;
    plane_told = plane_told || (in_plane && !word.step);
    if (!held.axes[k]) continue;
    const bool by_step = word.step && held.in_steps[k] && !(polar && in_plane);
    if (by_step && goes) {
      target[word.axis] += held.way[word.axis];
      c.warnOnce("held-step", "step-after-frame",
                 fmt::format("this step counts from where the program counted the axis before the length "
                             "offset or the rotation changed: it goes {:.6g} mm farther; an absolute word "
                             "(G90) says where to",
                             held.way[word.axis]),
                 w.columns, Severity::kNote);
    }
    if (!word.step || by_step || !goes) done(k);
  }
  if (!plane_told) return;
  for (const int axis : {u, v}) {
    if (axis >= kMainAxes) continue;
    const auto k = static_cast<std::size_t>(axis);
    if (!held.axes[k] || held.of_length[k]) continue;
    // An arc starts where the machine is.
    const bool wanted = goes && !polar && !movesOnArc(plan);
    if (wanted) target[axis] += held.way[axis];
    done(k);
  }
}

}  // namespace proveout::nc
