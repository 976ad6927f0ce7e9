// G33, and what threads of mills and lathes refuse (section 3).
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {

bool refuseCorners(IsoContext& c) {
  for (const Address a : {kCommaChamfer, kCommaRounding}) {
    if (const Word* w = c.word(a))
      return c.failWord(
          "050", "chamfer or corner not allowed in a thread block: put it into a block of its own", *w);
  }
  return true;
}

bool checkStartAngle(IsoContext& c, const BlockPlan& plan) {
  constexpr double kTurnDeg = 360.0;
  const Word* q = c.ownWord(plan, 'Q');
  return q == nullptr || (q->value >= 0.0 && q->value <= kTurnDeg) ||
         c.alarm(SharedAlarm::kOutOfRange, *q, "the start angle counts in 0.001 degrees, from 0 to 360000");
}

bool planFanucThread(IsoContext& c, BlockPlan& plan) {
  return refuseCorners(c) && checkStartAngle(c, plan) && planThread(c, plan);
}

bool planFanucSkip(IsoContext& c, BlockPlan& plan) {
  std::int64_t signal = 0;
  const Word* p = c.ownWord(plan, 'P');
  return (p == nullptr || integerWord(c, *p, 1, 4, signal)) && planSkip(c, plan);
}

}  // namespace proveout::nc
