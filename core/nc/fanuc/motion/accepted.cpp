#include <fmt/core.h>

#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
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

/// Values that the codes of look-ahead have.
bool knownValue(const IsoContext& c, const BlockPlan& plan, const Word& w) {
  constexpr double kOff = 0.0, kHighSpeed = 10000.0, kMostMode = 3.0;
  const std::int32_t code10 = plan.governor->code10;
  if (code10 == 80) return w.address != 'P' || w.value <= 1.0;
  if (code10 == 50 && w.address == 'P')
    return w.value == kOff || w.value <= kMostMode || w.value == kHighSpeed;
  return code10 != 51 || w.address != 'Q' || w.value <= kMostMode || c.parameters.flag(FanucParam::kFlavour);
}

bool performTold(IsoContext& c, BlockPlan& plan) {
  return sendEvent(c, event::Function{textOf(c, plan), {}});
}

}  // namespace

bool planLookAhead(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  for (const Address a : {'P', 'Q'}) {
    std::int64_t value = 0;
    const Word* w = c.word(a);
    if (w != nullptr && !integerWord(c, *w, 0, 99999999, value)) return false;
    if (w == nullptr || knownValue(c, plan, *w)) continue;
    return c.alarm(SharedAlarm::kOutOfRange, *w,
                   fmt::format("{} has no such mode here; G05 P10001 and on run data that are no program",
                               gName(plan.governor->code10)));
  }
  plan.perform = performTold;
  return true;
}

bool planNoted(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  c.asked = c.asked | plan.governor->words;  // the note is for all of them
  const std::string name = gName(plan.governor->code10);
  if (c.firstTime("noted " + name)) {
    c.warn("noted", fmt::format("{} ({}) has no effect in the simulation", name, plan.governor->meaning), {},
           Severity::kNote);
  }
  plan.perform = performTold;
  return true;
}

}  // namespace proveout::nc
