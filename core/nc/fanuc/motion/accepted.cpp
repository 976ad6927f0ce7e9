#include <fmt/core.h>

#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

/// What the code is written as, with its P and Q: "G5 P10000".
std::string textOf(const IsoContext& c, const BlockPlan& plan) {
  std::string text = gName(plan.governor->code10);
  for (const Address a : {'P', 'Q', 'R'}) {
    if (const Word* w = c.word(a)) text += fmt::format(" {}{:g}", a, w->value);
  }
  return text;
}

bool performTold(IsoContext& c, BlockPlan& plan) {
  return sendEvent(c, event::Function{textOf(c, plan), {}});
}

}  // namespace

bool planLookAhead(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  for (const Address a : {'P', 'Q'}) {
    std::int64_t value = 0;
    if (const Word* w = c.word(a); w != nullptr && !integerWord(c, *w, 0, 99999999, value)) return false;
  }
  plan.perform = performTold;
  return true;
}

bool planNoted(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  const std::string name = gName(plan.governor->code10);
  if (c.firstTime("noted " + name)) {
    c.warn("noted", fmt::format("{} ({}) has no effect in the simulation", name, plan.governor->meaning), {},
           Severity::kNote);
  }
  plan.perform = performTold;
  return true;
}

}  // namespace proveout::nc
