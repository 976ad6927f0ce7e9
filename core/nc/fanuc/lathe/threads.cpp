// G32, G34: threads block by block (section 16).
#include <fmt/core.h>

#include <cmath>

#include "core/geometry/to_float.h"
#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/fanuc/lathe/lathe_data.h"
#include "core/nc/fanuc/lathe/lathe_moves.h"
#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {
namespace {

bool isThread(std::int32_t code) { return code == gcode::kThread || code == lathe_code::kVaryingThread; }

/// F of the block, the lead of the thread before, or the feed in force.
bool takeLead(IsoContext& c, BlockPlan& plan) {
  AxisModal& modal = plan.next.axes;
  if (const Word* f = c.word('F')) {
    if (!(f->value > 0.0)) return c.alarm(SharedAlarm::kThread, *f, "the lead must be above 0");
    modal.thread_lead = lengthOf(plan, *f);
    plan.next.feed = f->value;
  } else if (plan.next.feed > 0.0) {
    modal.thread_lead = plan.next.feed * plan.next.unitScale();
  }
  return modal.thread_lead > 0.0 || c.alarm(SharedAlarm::kThread, "", "a thread needs its lead F");
}

bool cutThreadBlock(IsoContext& c, BlockPlan& plan) {
  LatheData& data = latheData(c);
  FeedStyle& feed = plan.motion.feed;
  double largest = 0.0, sum2 = 0.0;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const double d = std::abs(plan.motion.target[axis] - c.position[axis]);
    largest = std::max(largest, d);
    sum2 += d * d;
  }
  const double change = feed.thread_pitch_change;
  const auto turns = threadTurnsOf(largest, plan.next.axes.thread_lead, change);
  if (!turns) return c.fail("thread", "the lead falls to zero before the end of the thread");
  const Word* q = c.ownWord(plan, 'Q');
  const bool chained = c.state.axes.threading && q == nullptr;
  double angle = chained ? data.thread_angle : q != nullptr ? q->value : 0.0;
  angle -= 360.0 * std::floor(angle / 360.0);
  feed.kind = MotionKind::kThread;
  feed.feed = std::sqrt(sum2) / *turns * turnsPerMinute(c, plan);
  feed.join.stops = false;
  feed.join.unbroken = true;
  feed.thread_start_deg = toFloat(angle) < 360.0F ? toFloat(angle) : 0.0F;
  data.thread_angle = std::fmod(angle + 360.0 * *turns, 360.0);
  return performMove(c, plan);
}

}  // namespace

bool planLatheThread(IsoContext& c, BlockPlan& plan) {
  if (!refuseCorners(c) || !checkStartAngle(c, plan)) return false;
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  if (!c.anyAxisWord() && !plan.motion.named.any()) return true;
  if (!takeLead(c, plan)) return false;
  if (plan.next.compOn())
    return c.fail("thread-comp", "threads cannot run with nose compensation: program G40 first");
  double largest = 0.0;
  for (int axis = 0; axis < c.axes.count(); ++axis)
    largest = std::max(largest, std::abs(plan.motion.target[axis] - plan.start[axis]));
  if (!(largest > 0.0)) return true;
  if (!feedStyle(c, plan, plan.motion.feed)) return false;
  const bool varying = plan.next.active[kGroupMotion] == lathe_code::kVaryingThread;
  if (varying) {
    if (c.ownWord(plan, 'K') == nullptr)
      return c.alarm(SharedAlarm::kMissingData, "K", "the change of the lead a turn");
    plan.motion.feed.thread_pitch_change = toFloat(lengthWord(c, plan, 'K'));
  }
  plan.perform = cutThreadBlock;
  plan.next.axes.threading = isThread(plan.next.active[kGroupMotion]);
  return true;
}

}  // namespace proveout::nc
