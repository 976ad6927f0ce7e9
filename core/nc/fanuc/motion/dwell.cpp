#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {
bool planFanucDwell(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  const Word* time = nullptr;
  for (const Word& w : c.block.words) {
    const bool axis = w.axis >= 0 || (w.address >= 'U' && w.address <= 'W');
    const bool own = w.address == 'X' || w.address == 'U' || w.address == 'P';
    if (axis && !own) return c.alarm(SharedAlarm::kIllegalAddress, w, "G04 takes X, U or P");
    if (!own || plan.claimed.has(w.address)) continue;
    if (time != nullptr) return c.alarm(SharedAlarm::kIllegalAddress, w, "G04 takes one of X, U and P");
    time = c.word(w.address);
  }
  if (time == nullptr) {
    plan.exact_stop = true;
    return true;
  }
  if (time->value < 0.0) return c.alarm(SharedAlarm::kSign, *time, "a dwell is not negative");
  const bool seconds = time->address != 'P' || time->point;
  plan.payload.emplace<Dwell>().seconds = seconds ? time->value : 1e-3 * time->value;
  plan.perform = performDwell;
  return true;
}

}  // namespace proveout::nc
