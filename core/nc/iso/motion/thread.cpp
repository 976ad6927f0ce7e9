// G33: threads of constant lead (manual 4.4).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {
namespace {

bool performThread(IsoContext& c, BlockPlan& plan) {
  const ThreadStart& start = std::get<ThreadStart>(plan.payload);
  if (start.tell && !sendEvent(c, event::Thread{start.lead, start.angle_deg})) return false;
  return performMove(c, plan);
}

/// F or E of the block, or the lead in force.
bool threadLead(IsoContext& c, BlockPlan& plan) {
  const Word* f = c.word('F');
  const Word* e = c.ownWord(plan, 'E');
  if (f && e) return c.alarm(SharedAlarm::kThread, *e, "F and E in one block");
  if (const Word* w = f ? f : e) {
    if (!(w->value > 0.0)) return c.alarm(SharedAlarm::kThread, *w, "the lead must be above 0");
    plan.next.axes.thread_lead = f ? lengthOf(plan, *f) : 25.4 / e->value;
  }
  if (plan.next.axes.thread_lead > 0.0) return true;
  return c.alarm(SharedAlarm::kThread, "", "G33 needs F or E");
}

}  // namespace

bool planThread(IsoContext& c, BlockPlan& plan) {
  AxisModal& modal = plan.next.axes;
  modal.threading = c.state.axes.threading && c.state.active[kGroupMotion] == gcode::kThread;
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  if ((c.block.present.has('F') || c.block.present.has('E') || c.anyAxisWord()) && !threadLead(c, plan)) {
    return false;
  }
  if (!c.anyAxisWord()) return true;
  if (plan.motion.named.count() > 2)
    return c.alarm(SharedAlarm::kIllegalAddress, "", "G33 moves one axis or two");
  if (plan.next.active[kGroupSurfaceSpeed] == gcode::kSurfaceSpeed) {
    return c.fail("thread-surface-speed", "G33 cannot run with constant surface speed: program G97 first");
  }
  if (plan.next.compOn()) {
    return c.fail("thread-comp", "G33 cannot run with cutter compensation: program G40 first");
  }
  ThreadStart& start = plan.payload.emplace<ThreadStart>();
  start.tell = !modal.threading;
  start.lead = modal.thread_lead;
  if (const Word* q = c.ownWord(plan, 'Q')) start.angle_deg = q->value;
  double largest = 0.0, sum2 = 0.0;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const double d = std::abs(plan.motion.target[axis] - plan.start[axis]);
    largest = std::max(largest, d);
    sum2 += d * d;
  }
  if (!(largest > 0.0)) return true;
  // The lead counts along the axis with the longer way; the path is as much faster as it is longer.
  plan.motion.feed.kind = MotionKind::kThread;
  plan.motion.feed.feed = modal.thread_lead * turnsPerMinute(c, plan) * std::sqrt(sum2) / largest;
  plan.perform = performThread;
  modal.threading = true;
  return true;
}

}  // namespace proveout::nc
