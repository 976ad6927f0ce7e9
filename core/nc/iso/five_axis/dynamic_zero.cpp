// The table of dynamic zeros: G10 L21 (manual 25.4.1).
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"

namespace proveout::nc {

namespace {

bool performDynamicOffset(IsoContext& c, BlockPlan& plan) {
  const FrameChange& change = std::get<FrameChange>(plan.payload);
  c.registers.dynamic_zeros[static_cast<std::size_t>(change.id)] = change.system.offset;
  c.chain = c.chainOf(plan.next);
  c.position = c.chain.programOf(c.machine);
  return true;
}

}  // namespace

bool planDynamicOffset(IsoContext& c, BlockPlan& plan) {
  const Word* p = c.ownWord(plan, 'P');
  std::int64_t row = 0;
  if (p == nullptr) return c.alarm(SharedAlarm::kMissingData, "P", "G10 needs P");
  for (const Address a : {'R', 'Q', 'I', 'J', 'K'}) {
    if (const Word* w = c.word(a)) return c.alarm(SharedAlarm::kIllegalAddress, *w, "in G10 L21");
  }
  if (!integerWord(c, *p, 1, static_cast<std::int64_t>(c.registers.dynamic_zeros.size()), row)) return false;
  FrameChange& change = plan.payload.emplace<FrameChange>();
  change.id = static_cast<int>(row) - 1;
  change.system.offset = c.registers.dynamic_zeros[static_cast<std::size_t>(change.id)];
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    // Values are rectangular, whatever the axis words of motions are.
    const bool rotary = word.axis >= kMainAxes && c.axes.at(word.axis).rotary();
    const double value = rotary ? w.value : lengthOf(plan, w);
    double& cell = change.system.offset[word.axis];
    cell = (word.step ? cell : 0.0) + value;
  }
  plan.perform = performDynamicOffset;
  plan.rebases = plan.flush = true;
  return true;
}

}  // namespace proveout::nc
