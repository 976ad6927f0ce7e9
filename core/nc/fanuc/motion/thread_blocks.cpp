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

bool planFanucThread(IsoContext& c, BlockPlan& plan) { return refuseCorners(c) && planThread(c, plan); }

}  // namespace proveout::nc
