// Tool offsets: G10 L10 to L13, L110, L111, L200 to L203, and G43.7 (manual 15.1, 15.2, 15.4).
#include <array>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/tools/tools.h"

namespace proveout::nc {
bool performOffset(IsoContext& c, BlockPlan& plan) {
  const OffsetChange& change = std::get<OffsetChange>(plan.payload);
  OffsetTables& offsets = c.registers.offsets;
  for (std::size_t k = 0; k < change.count; ++k) {
    const OffsetChange::Cell& cell = change.cells[k];
    const std::uint32_t by = numberOf(c, *c.word(cell.word), OriginKind::kData);
    offsets.set(cell.column, change.row, change.wear, cell.value, by);
  }
  if (change.tip >= 0) offsets.setTip(change.row, change.tip);
  return true;
}

namespace {

/// The row of P, and that no word stands there but `allowed`. Null: reported.
OffsetChange* beginChange(IsoContext& c, BlockPlan& plan, AddressSet allowed) {
  for (const Word& w : c.block.words) {
    if (AddressSet("XYZUVWIJKRQ").without(allowed).has(w.address) || (w.axis > 2)) {
      c.alarm(SharedAlarm::kIllegalAddress, w, "in this form of G10");
      return nullptr;
    }
  }
  const Word* p = c.ownWord(plan, 'P');
  std::int64_t row = 0;
  if (p == nullptr) {
    c.alarm(SharedAlarm::kMissingData, "P", "G10 needs P");
    return nullptr;
  }
  if (!integerWord(c, *p, 1, static_cast<std::int64_t>(c.parameters[CompParam::kToolOffsets]), row)) {
    return nullptr;
  }
  OffsetChange& change = plan.payload.emplace<OffsetChange>();
  change.row = static_cast<int>(row);
  plan.perform = performOffset;
  return &change;
}

/// One cell from a word: stored, or with G91 or the operator I added.
void addCell(const IsoContext& c, const BlockPlan& plan, OffsetChange& change, OffsetColumn column,
             const Word& w) {
  const OffsetValue& old = c.registers.offsets.value(column, change.row);
  const bool add = w.incremental || plan.next.incremental();
  const double base = !add ? 0.0 : change.wear ? old.wear : old.geometry;
  change.cells[change.count++] = {column, base + lengthOf(plan, w), w.address};
}

bool planOneCell(IsoContext& c, BlockPlan& plan, OffsetColumn column, bool wear) {
  OffsetChange* change = beginChange(c, plan, "R");
  if (change == nullptr) return false;
  const Word* r = c.word('R');
  if (r == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "the value of the offset");
  change->wear = wear;
  addCell(c, plan, *change, column, *r);
  return true;
}

}  // namespace

bool planMillingOffset(IsoContext& c, BlockPlan& plan) {
  const int l = static_cast<int>(c.word('L')->value);
  const OffsetColumn column = l >= 110  ? OffsetColumn::kCorner
                              : l >= 12 ? OffsetColumn::kRadius
                                        : OffsetColumn::kLength;
  return planOneCell(c, plan, column, l % 2 == 1);
}

bool planTurningOffset(IsoContext& c, BlockPlan& plan) {
  const Word* l = c.word('L');
  if (!c.parameters.flag(DataParam::kTurningOffsets)) {
    return c.alarm(SharedAlarm::kNotImplemented, {},
                   fmt::format("G10 L200 to L203 need turning columns ({})",
                               c.parameters.name(DataParam::kTurningOffsets)),
                   l->columns);
  }
  const int form = static_cast<int>(l->value) - 200;
  const bool wear = form % 2 == 0;
  if (form >= 2) return planOneCell(c, plan, OffsetColumn::kCorner, wear);
  OffsetChange* change = beginChange(c, plan, "XYZRQ");
  if (change == nullptr) return false;
  change->wear = wear;
  constexpr std::array<std::pair<Address, OffsetColumn>, 4> kCells{{{'X', OffsetColumn::kX},
                                                                    {'Y', OffsetColumn::kY},
                                                                    {'Z', OffsetColumn::kLength},
                                                                    {'R', OffsetColumn::kRadius}}};
  for (const auto& [address, column] : kCells) {
    if (const Word* w = c.word(address)) addCell(c, plan, *change, column, *w);
  }
  std::int64_t tip = 0;
  if (const Word* q = c.word('Q')) {
    if (!integerWord(c, *q, 0, 9, tip)) return false;
    change->tip = static_cast<int>(tip);
  }
  if (change->count == 0 && change->tip < 0)
    return c.alarm(SharedAlarm::kMissingData, "", "G10 L200, L201 need X, Y, Z, R or Q");
  return true;
}

bool planTurningLength(IsoContext& c, BlockPlan& plan) {
  if (!c.parameters.flag(DataParam::kTurningOffsets)) {
    return c.alarm(
        SharedAlarm::kNotImplemented, "G43.7",
        fmt::format("there are no turning columns ({})", c.parameters.name(DataParam::kTurningOffsets)));
  }
  IsoState& next = plan.next;
  next.length = AxisPoint(next.h_turning[0], next.h_turning[1], next.h_value);
  for (int axis = 0; axis < kMainAxes; ++axis) {  // lengths of an axis in diameter are diameters (manual 5.3)
    if (next.axes.diameter[static_cast<std::size_t>(axis)]) next.length[axis] *= 0.5;
  }
  plan.frames_changed = true;
  plan.flush = true;
  return true;
}

}  // namespace proveout::nc
