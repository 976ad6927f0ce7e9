// G76: a thread in all its passes, in two lines and in one (sections 16 and 18).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/lathe/lathe_data.h"
#include "core/nc/fanuc/lathe/lathe_moves.h"
#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/fanuc/lathe/run_out.h"
#include "core/nc/fanuc/lathe/thread_depths.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"

namespace proveout::nc {
namespace {

constexpr double kMostThreadAngle = 120.0;

/// The first of two lines: no end and no height of the thread.
bool isThreadSetting(const IsoContext& c) { return (c.block.present & AddressSet("XZUWKDFIA")).empty(); }

/// P mmrraa: finish passes, run-out in tenths of the lead, angle.
struct ThreadDigits {
  int passes = 0, run_out = 0, angle = 0;
};

bool takeThreadDigits(IsoContext& c, const Word& p, ThreadDigits& digits) {
  std::int64_t value = 0;
  if (!integerWord(c, p, 0, 999999, value)) return false;
  digits = {static_cast<int>(value / 10000), static_cast<int>(value / 100 % 100),
            static_cast<int>(value % 100)};
  return true;
}

bool planThreadLine(IsoContext& c, BlockPlan& plan) {
  ThreadDigits digits;
  const Word* p = c.ownWord(plan, 'P');
  if (p != nullptr && !takeThreadDigits(c, *p, digits)) return false;
  constexpr std::array<int, 6> kAngles{80, 60, 55, 30, 29, 0};
  if (p != nullptr && std::find(kAngles.begin(), kAngles.end(), digits.angle) == kAngles.end()) {
    c.warnOnce(fmt::format("thread angle {}", digits.angle), "thread-angle",
               fmt::format("G76: an angle of {} degrees; many controls take 80, 60, 55, 30, 29 and 0 only",
                           digits.angle),
               p->columns, Severity::kNote);
  }
  if (const Word* q = c.ownWord(plan, 'Q'); q != nullptr && q->value < 0.0)
    return c.failWord("062", "G76: the least depth Q must not be negative", *q);
  if (lengthWord(c, plan, 'R') < 0.0) return c.fail("062", "G76: the allowance R must not be negative");
  plan.motion.target = plan.start;
  plan.perform = [](IsoContext& context, BlockPlan& planned) {
    IsoParameters& parameters = context.parameters;
    ThreadDigits told;
    if (const Word* w = context.ownWord(planned, 'P'); w != nullptr && takeThreadDigits(context, *w, told)) {
      parameters.put(FanucParam::kG76Repeat, told.passes);
      parameters.put(FanucParam::kThreadChamfer, 0.1 * told.run_out);
      parameters.put(FanucParam::kG76Angle, told.angle);
    }
    if (const Word* w = context.ownWord(planned, 'Q'))
      parameters.put(FanucParam::kG76Min, stepWord(context, planned, *w));
    if (context.ownWord(planned, 'R') != nullptr)
      parameters.put(FanucParam::kG76Finish, lengthWord(context, planned, 'R'));
    return true;
  };
  return true;
}

/// How the passes go into the depth: straight, along one flank, along both in turn.
struct ThreadWords {
  ThreadInfeed infeed;
  double taper = 0.0, angle = 0.0, start_deg = 0.0;  ///< mm, degrees
  bool both_flanks = false;
};

/// Settings that the job or the first line gives; Haas has other defaults.
double threadSetting(const IsoContext& c, FanucParam p, double of_haas) {
  return isHaas(c) && !c.parameters.given(p) ? of_haas : c.parameters[p];
}

/// K height, D first depth, A angle, I taper, P method.
bool takeOneLine(IsoContext& c, BlockPlan& plan, ThreadWords& words) {
  words.infeed.height = lengthWord(c, plan, 'K');
  const Word* d = c.ownWord(plan, 'D');
  words.infeed.first = d == nullptr ? 0.0 : depthWord(c, plan, *d);
  words.taper = lengthWord(c, plan, 'I');
  const Word* a = c.ownWord(plan, 'A');
  words.angle = a == nullptr ? 0.0 : countsIncrements(c, *a) ? 1000.0 * a->value : a->value;
  std::int64_t method = a == nullptr ? 0 : 1;
  if (const Word* p = c.ownWord(plan, 'P'); p != nullptr && !integerWord(c, *p, 1, 4, method)) return false;
  words.both_flanks = method == 2 || method == 4;
  words.infeed.equal = method >= 3;
  if (const Word* q = c.ownWord(plan, 'Q'))
    words.start_deg = isHaas(c) && q->value <= 360.0 ? q->value : 0.001 * q->value;
  return true;
}

/// R taper, P height, Q first depth, behind a first line.
void takeSecondLine(IsoContext& c, BlockPlan& plan, ThreadWords& words) {
  if (const Word* p = c.ownWord(plan, 'P')) words.infeed.height = stepWord(c, plan, *p);
  if (const Word* q = c.ownWord(plan, 'Q')) words.infeed.first = stepWord(c, plan, *q);
  words.taper = lengthWord(c, plan, 'R');
  words.angle = c.parameters[FanucParam::kG76Angle];
  if (!c.parameters.given(FanucParam::kG76Angle))
    noteSetting(
        c, FanucParam::kG76Angle,
        fmt::format("G76 goes in along a flank of {:g} degrees", c.parameters[FanucParam::kG76Angle]));
}

bool takeThreadWords(IsoContext& c, BlockPlan& plan, ThreadWords& words) {
  const bool one_line = c.block.present.has('K') || c.block.present.has('D');
  if (!one_line) takeSecondLine(c, plan, words);
  if (one_line && !takeOneLine(c, plan, words)) return false;
  words.infeed.least = threadSetting(c, FanucParam::kG76Min, 0.0);
  words.infeed.finish = threadSetting(c, FanucParam::kG76Finish, 0.0);
  words.infeed.repeats = static_cast<int>(threadSetting(c, FanucParam::kG76Repeat, 0.0));
  const ThreadInfeed& infeed = words.infeed;
  if (!(infeed.height > 0.0) || !(infeed.first > 0.0))
    return c.fail("062",
                  "G76: the height of the thread (P, in one line K) and the depth of the first pass (Q, "
                  "in one line D) must be above 0");
  if (infeed.finish >= infeed.height)
    return c.fail("062", "G76: the allowance for the finish is no less than the height of the thread");
  if (!(words.angle >= 0.0 && words.angle <= kMostThreadAngle))
    return c.fail("062", fmt::format("G76: an angle of {:g} degrees", words.angle));
  return true;
}

bool performThreadCycle(IsoContext& c, BlockPlan& plan) {
  ThreadWords words;
  AxisPoint programmed;
  if (!takeThreadWords(c, plan, words)) return false;
  plan.motion.named.reset();
  if (!axisTarget(c, plan, programmed)) return false;
  const std::vector<double> depths = threadDepths(words.infeed);
  if (depths.empty()) return c.fail("062", fmt::format("G76: more than {} passes", kMostThreadPasses));
  LatheMoves moves(c, plan);
  const Vec2 start = moves.at(), root = moves.pointOf(programmed);
  const double lead = plan.next.feed * plan.next.unitScale();
  const double side = start.y() < root.y() ? -1.0 : 1.0, way = root.x() < start.x() ? -1.0 : 1.0;
  const double flank = std::tan(degToRad(0.5 * words.angle));
  const RunOut run_out = runOutOf(c, lead);
  double n = 0.0;
  for (const double depth : depths) {
    const double turn = words.both_flanks && std::fmod(n, 2.0) == 1.0 ? -1.0 : 1.0;
    n += 1.0;
    const double z = start.x() + way * turn * depth * flank;
    const double x = root.y() + side * (words.infeed.height - depth);
    moves.startThread(words.start_deg);
    if (!moves.rapid({z, start.y()}) || !moves.rapid({z, x + words.taper}) ||
        !cutThreadTo(moves, {root.x(), x}, start.y(), lead, run_out) ||
        !moves.rapid({moves.at().x(), start.y()}) || !moves.rapid(start)) {
      return false;
    }
    if (c.watch.workOver(c.calls.place())) return false;
  }
  moves.finish();
  return true;
}

}  // namespace

bool planThreadCycle(IsoContext& c, BlockPlan& plan) {
  if (!turningPlane(c, plan)) return false;
  if (isThreadSetting(c)) return planThreadLine(c, plan);
  if (plan.next.compOn())
    return c.fail("thread-comp", "threads cannot run with nose compensation: program G40 first");
  ThreadWords words;
  AxisPoint end;
  if (!takeThreadWords(c, plan, words) || !axisTarget(c, plan, end)) return false;
  const bool ends = plan.motion.named[0] && plan.motion.named[2];
  plan.motion.named.reset();
  plan.motion.target = plan.start;
  if (!ends || std::abs(end[2] - plan.start[2]) < 1e-9)
    return c.alarm(SharedAlarm::kMissingData, "", "G76 needs X and Z of the end of the thread's root");
  plan.perform = performThreadCycle;
  return feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
