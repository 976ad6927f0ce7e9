// G90, G92, G94 of system A: one cut and back (section 16).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/lathe/lathe_codes.h"
#include "core/nc/fanuc/lathe/lathe_data.h"
#include "core/nc/fanuc/lathe/lathe_moves.h"
#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/fanuc/lathe/run_out.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"

namespace proveout::nc {
namespace {

/// End and taper of the block: words that are not there stay from the block before of the same cycle.
bool takeSingleWords(IsoContext& c, BlockPlan& plan, SingleCycleWords& words) {
  if (!turningPlane(c, plan)) return false;
  const int code = plan.next.active[kGroupMotion];
  const bool goes_on = c.state.active[kGroupMotion] == code && !c.state.inCycle();
  words = goes_on ? latheData(c).single : SingleCycleWords();
  const AxisPoint start = plan.start;
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  if (plan.motion.named[0]) words.x = plan.motion.target[0];
  if (plan.motion.named[2]) words.z = plan.motion.target[2];
  // Older controls and Haas write the taper with I, of facing with K.
  for (const Address letter : {'R', code == lathe_code::kFacing ? 'K' : 'I'}) {
    if (c.ownWord(plan, letter) != nullptr) words.taper = lengthWord(c, plan, letter);
  }
  plan.motion.target = start;
  return true;
}

/// Start and end of the block in the plane, work coordinates.
struct SingleCut {
  Vec2 start, end;
  double taper;
};

SingleCut singleCut(const IsoContext& c, const BlockPlan& plan, const LatheMoves& moves,
                    const SingleCycleWords& words) {
  AxisPoint end = c.position;
  end[0] = words.x.value_or(c.position[0]);
  end[2] = words.z.value_or(c.position[2]);
  (void)plan;
  return {moves.at(), moves.pointOf(end), words.taper};
}

bool cutSingle(IsoContext& c, BlockPlan& plan) {
  SingleCycleWords words;
  if (!takeSingleWords(c, plan, words)) return false;
  latheData(c).single = words;
  LatheMoves moves(c, plan, true);
  const SingleCut cut = singleCut(c, plan, moves, words);
  const auto &s = cut.start, &e = cut.end;
  const bool facing = plan.next.active[kGroupMotion] == lathe_code::kFacing;
  const Vec2 first = facing ? Vec2(e.x() + cut.taper, s.y()) : Vec2(s.x(), e.y() + cut.taper);
  const Vec2 back = facing ? Vec2(s.x(), e.y()) : Vec2(e.x(), s.y());
  if (!moves.rapid(first) || !moves.feed(e) || !moves.feed(back) || !moves.rapid(s)) return false;
  moves.finish();
  return true;
}

bool cutSingleThread(IsoContext& c, BlockPlan& plan) {
  SingleCycleWords words;
  if (!takeSingleWords(c, plan, words)) return false;
  latheData(c).single = words;
  LatheMoves moves(c, plan);
  const SingleCut cut = singleCut(c, plan, moves, words);
  const double lead = plan.next.feed * plan.next.unitScale();
  const Word* q = c.ownWord(plan, 'Q');
  moves.startThread(q != nullptr ? q->value : 0.0);
  if (!moves.rapid({cut.start.x(), cut.end.y() + cut.taper}) ||
      !cutThreadTo(moves, cut.end, cut.start.y(), lead, runOutOf(c, lead)) ||
      !moves.rapid({moves.at().x(), cut.start.y()}) || !moves.rapid(cut.start)) {
    return false;
  }
  moves.finish();
  return true;
}

/// Whether the block cuts: it names an axis of the plane.
bool cuts(const IsoContext& c, const BlockPlan& plan) {
  return plan.motion.named[0] || plan.motion.named[2] || c.block.present.has('R');
}

}  // namespace

bool planSingleCycle(IsoContext& c, BlockPlan& plan) {
  SingleCycleWords words;
  if (!takeSingleWords(c, plan, words)) return false;
  if (!cuts(c, plan)) return true;
  plan.motion.named.reset();
  plan.perform = [](IsoContext& context, BlockPlan& planned) { return cutSingle(context, planned); };
  return feedStyle(c, plan, plan.motion.feed);
}

bool planThreadingCycle(IsoContext& c, BlockPlan& plan) {
  if (!refuseCorners(c) || !checkStartAngle(c, plan)) return false;
  SingleCycleWords words;
  if (!takeSingleWords(c, plan, words)) return false;
  if (!cuts(c, plan)) return true;
  plan.motion.named.reset();
  if (plan.next.compOn())
    return c.fail("thread-comp", "threads cannot run with nose compensation: program G40 first");
  if (!words.z) return c.alarm(SharedAlarm::kMissingData, "Z", "the thread has no end");
  plan.perform = [](IsoContext& context, BlockPlan& planned) { return cutSingleThread(context, planned); };
  return feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
