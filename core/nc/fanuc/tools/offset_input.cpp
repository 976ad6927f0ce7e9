// G10 L1, L10 to L13 (iso-fanuc, section 6).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/tools/offsets.h"
#include "core/nc/iso/tools/tools.h"

namespace proveout::nc {
namespace {

constexpr double kLargestOffsetMm = 9999.999;

bool performFanucOffset(IsoContext& c, BlockPlan& plan) {
  if (!performOffset(c, plan)) return false;
  const OffsetChange& change = std::get<OffsetChange>(plan.payload);
  OffsetTables& offsets = c.registers.offsets;
  // One value a number: what the job may have given as its wear is part of it.
  for (std::size_t k = 0; fanucOffsetMemory(c) == FanucMemory::kA && k < change.count; ++k) {
    const OffsetColumn column = change.cells[k].column;
    offsets.set(column, change.row, true, 0.0, offsets.setBy(column, change.row).geometry);
  }
  // Compensation takes the new value with its next vector.
  if (plan.next.d == change.row) plan.next.d_radius = offsets.effective(OffsetColumn::kRadius, change.row);
  return true;
}

}  // namespace

bool planFanucToolOffset(IsoContext& c, BlockPlan& plan) {
  const Word *l = c.word('L'), *r = c.word('R');
  const int form = l == nullptr ? 1 : static_cast<int>(l->value);
  for (const Word& w : c.block.words) {
    if (w.axis >= 0 || AddressSet("UVWIJKQ").has(w.address))
      return c.alarm(SharedAlarm::kIllegalAddress, w, fmt::format("in G10 L{}", form));
  }
  std::int64_t row = 0;
  const auto rows = static_cast<std::int64_t>(c.parameters[CompParam::kToolOffsets]);
  if (!fanucDataRow(c, plan, "030", 1, rows, row)) return false;
  if (r == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "the value of the offset");
  const FanucMemory memory = fanucOffsetMemory(c);
  const bool of_d = form == 12 || form == 13;
  if (memory == FanucMemory::kA && form != 1 && form != 11)
    return c.failWord("029", "memory A has one value a number: G10 L1 or L11 sets it (offset_memory)", *l);
  if (memory == FanucMemory::kB && of_d)
    return c.failWord("029",
                      "memory B has no values for D alone: G10 L10 and L11 set a number (offset_memory)", *l);
  OffsetChange& change = plan.payload.emplace<OffsetChange>();
  change.row = static_cast<int>(row);
  change.wear = memory != FanucMemory::kA && (form == 1 || form == 11 || form == 13);
  const OffsetTables& table = c.registers.offsets;
  const double factor = fanucRadiusFactor(c);
  const auto add = [&](OffsetColumn column, double of_table) {
    const OffsetValue& old = table.value(column, change.row);
    const double before = memory == FanucMemory::kA ? old.geometry + old.wear
                          : change.wear             ? old.wear
                                                    : old.geometry;
    const double value = lengthOf(plan, *r) / of_table + (plan.next.incremental() ? before : 0.0);
    change.cells[change.count++] = {column, value, 'R'};
    return std::abs(value * of_table) <= kLargestOffsetMm;
  };
  bool in_range = true;
  if (!of_d) in_range = add(OffsetColumn::kLength, 1.0);
  if (of_d || memory != FanucMemory::kC) in_range = add(OffsetColumn::kRadius, factor) && in_range;
  if (!in_range)
    return c.failWord("029", fmt::format("illegal offset value: more than {:g} mm", kLargestOffsetMm), *r);
  plan.perform = performFanucOffset;
  return true;
}

}  // namespace proveout::nc
