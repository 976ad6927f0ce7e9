// G01 of lathes: chamfers and corners by I, K, C and R without a comma, between two blocks at right angles.
#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr double kStandsStillMm = 1e-9;

/// The word that makes a corner; null: there is none. `more`: a second one.
const Word* cornerWord(IsoContext& c, const BlockPlan& plan, const Word*& more) {
  const Word* found = nullptr;
  for (const Address a : {'I', 'K', 'C', 'R'}) {
    const Word* const w = c.ownWord(plan, a);
    if (w == nullptr || w->axis >= 0) continue;
    (found == nullptr ? found : more) = w;
  }
  return found;
}

/// I turns from Z to X, K from X to Z; C and R do both.
bool fits(IsoContext& c, const Word& w, bool along_z) {
  if (w.address == (along_z ? 'K' : 'I'))
    return c.alarm(
        SharedAlarm::kIllegalAddress, w,
        along_z ? "a block along Z has I: the way on along X" : "a block along X has K: the way on along Z");
  return true;
}

bool takeCorner(IsoContext& c, BlockPlan& plan, const Word& w) {
  const double dx = plan.motion.target[0] - plan.start[0], dz = plan.motion.target[2] - plan.start[2];
  const bool x = std::abs(dx) > kStandsStillMm, z = std::abs(dz) > kStandsStillMm;
  if (x && z) {
    return c.failWord("054",
                      fmt::format("no taper allowed with a chamfer or corner by {0}: write ,C or ,R",
                                  addressText(w.address)),
                      w);
  }
  if (!x && !z) return c.alarm(SharedAlarm::kCornerTooLarge, "", "the block does not move", w.columns);
  if (!fits(c, w, z)) return false;
  plan.motion.join = w.address == 'R' ? PathItem::Join::kRound : PathItem::Join::kChamfer;
  plan.motion.join_size = std::abs(lengthOf(plan, w));
  plan.motion.join_turn = w.value < 0.0 ? -1 : 1;
  return plan.motion.join_size > 0.0 ||
         c.alarm(SharedAlarm::kCornerTooLarge, "", "its length is 0", w.columns);
}

}  // namespace

bool planLatheLine(IsoContext& c, BlockPlan& plan) {
  if (!planLine(c, plan)) return false;
  const Word* more = nullptr;
  const Word* const word = cornerWord(c, plan, more);
  if (word == nullptr) return true;
  const bool comma = c.block.present.has(kCommaChamfer) || c.block.present.has(kCommaRounding);
  if (more != nullptr || comma)
    return c.alarm(SharedAlarm::kChamferAndRounding, "", "one of I, K, C, R, ,C and ,R makes the corner",
                   (more != nullptr ? more : word)->columns);
  return takeCorner(c, plan, *word);
}

}  // namespace proveout::nc
