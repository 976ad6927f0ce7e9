// G10 of lathes: offsets of tools and the work shift; G50.3 and G92.1 (sections 6 and 15).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/lathe/lathe_plans.h"
#include "core/nc/fanuc/lathe/lathe_words.h"
#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/perform/unused_words.h"

namespace proveout::nc {
namespace {

constexpr std::int64_t kGeometryRows = 10000;

/// A column by its absolute and its incremental letter.
struct OffsetLetters {
  Address absolute, step;
  int axis;  ///< -1: the nose radius
};
constexpr auto kLetters =
    std::to_array<OffsetLetters>({{'X', 'U', 0}, {'Y', 'V', 1}, {'Z', 'W', 2}, {'R', 'C', -1}});

OffsetColumn columnOf(int axis) {
  return axis == 0   ? OffsetColumn::kX
         : axis == 1 ? OffsetColumn::kY
         : axis == 2 ? OffsetColumn::kLength
                     : OffsetColumn::kRadius;
}

bool writeToolOffset(IsoContext& c, BlockPlan& plan) {
  const auto number = static_cast<std::int64_t>(std::llround(c.word('P')->value));
  const bool wear = number < kGeometryRows;
  const int row = static_cast<int>(wear ? number : number - kGeometryRows);
  OffsetTables& table = c.registers.offsets;
  for (const OffsetLetters& letters : kLetters) {
    const Word* const set = c.word(letters.absolute);
    const Word* const add = set == nullptr ? c.word(letters.step) : nullptr;
    const Word* const w = set != nullptr ? set : add;
    if (w == nullptr) continue;
    const OffsetColumn column = columnOf(letters.axis);
    const OffsetValue& old = table.value(column, row);
    const double base = add == nullptr && !plan.next.incremental() ? 0.0 : wear ? old.wear : old.geometry;
    table.set(column, row, wear, base + lengthOf(plan, *w), numberOf(c, *w, OriginKind::kData));
  }
  if (const Word* q = c.word('Q')) table.setTip(row, static_cast<int>(q->value));
  return true;
}

/// P0: the shift of all work frames.
bool writeWorkShift(IsoContext& c, BlockPlan& plan) {
  WorkFrames& frames = c.registers.frames;
  for (const OffsetLetters& letters : kLetters) {
    if (letters.axis < 0) continue;
    const Word* const set = c.word(letters.absolute);
    const Word* const w = set != nullptr ? set : c.word(letters.step);
    if (w == nullptr) continue;
    const bool add = set == nullptr || plan.next.incremental();
    const bool diameter = plan.next.axes.diameter[static_cast<std::size_t>(letters.axis)];
    double& shift = frames.common.offset[letters.axis];
    shift = (add ? shift : 0.0) + (diameter ? 0.5 : 1.0) * lengthOf(plan, *w);
    frames.common.offset_by[static_cast<std::size_t>(letters.axis)] = numberOf(c, *w, OriginKind::kData);
  }
  c.chain = c.chainOf(plan.next);
  c.position = c.chain.programOf(c.machine);
  recordFrames(c, plan.next);
  return true;
}

}  // namespace

bool planLatheData(IsoContext& c, BlockPlan& plan) {
  if (c.ownWord(plan, 'L') != nullptr) return planDataInput(c, plan);
  plan.motion.target = plan.start;
  const Word* p = c.ownWord(plan, 'P');
  if (p == nullptr) return c.fail("031", "G10 without P: the number of the offset, 0 for the work shift");
  std::int64_t number = 0;
  if (!integerWord(c, *p, 0, kGeometryRows + OffsetTables::kRows, number)) return false;
  const std::int64_t row = number >= kGeometryRows ? number - kGeometryRows : number;
  if (number != 0 && (row < 1 || row > OffsetTables::kRows))
    return c.failWord("031", fmt::format("G10 P{}: there is no such offset", number), *p);
  for (const Word& w : c.block.words) {
    if (AddressSet("GNPXYZUVWRCQ").has(w.address)) {
      c.asked.add(w.address);
      continue;
    }
    return c.alarm(SharedAlarm::kIllegalAddress, w, "in G10 of offsets");
  }
  for (const Address a : {'R', 'C', 'Q'}) {
    if (const Word* w = number == 0 ? c.word(a) : nullptr; w != nullptr && w->axis < 0)
      tellUnused(c, *w, "G10", "P0 is the shift of the work frames, which has no nose");
  }
  std::int64_t tip = 0;
  if (const Word* q = c.ownWord(plan, 'Q'); q != nullptr && !integerWord(c, *q, 0, 9, tip)) return false;
  plan.flush = number == 0;
  plan.rebases = number == 0;
  plan.perform = number == 0 ? writeWorkShift : writeToolOffset;
  return true;
}

bool planLathePreset(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  AxisSet named;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word)) named.set(static_cast<std::size_t>(word.axis));
  }
  if (named.none()) return c.alarm(SharedAlarm::kMissingData, "", "a preset names axes: X0 Z0");
  plan.rebases = true;
  plan.perform = [](IsoContext& context, BlockPlan& planned) {
    for (const Word& w : context.block.words) {
      AxisWord word;
      if (!axisWord(planned, w, word)) continue;
      context.registers.frames.shift52[word.axis] = context.registers.frames.shift92[word.axis] = 0.0;
    }
    context.chain = context.chainOf(planned.next);
    context.position = context.chain.programOf(context.machine);
    recordFrames(context, planned.next);
    return true;
  };
  return true;
}

}  // namespace proveout::nc
