#include "core/nc/fanuc/tools/kept_tables.h"

namespace proveout::nc {
namespace {

constexpr int kOffsetColumns = static_cast<int>(OffsetColumn::kCount);

bool keepsFrame(const IsoContext& c, WorkSystemId id) {
  if (id <= 1) return false;
  if (id >= kFirstExtended) {
    const int number = id - kFirstExtended + 1;
    return number <= c.dialect.rules.extended_systems && !c.settings.extended_offsets.contains(number);
  }
  return !c.settings.work_given[static_cast<std::size_t>(id - 1)];
}

void putOffset(OffsetTables& table, const KeptOffset& cell) {
  if (cell.row < 1 || cell.row > OffsetTables::kRows) return;
  if (cell.column == KeptOffset::kTipColumn) {
    if (table.tip(cell.row) == cell.found) table.setTip(cell.row, static_cast<int>(cell.value));
    return;
  }
  const auto column = static_cast<OffsetColumn>(cell.column);
  const OffsetValue& now = table.value(column, cell.row);
  if ((cell.wear ? now.wear : now.geometry) == cell.found) table.set(column, cell.row, cell.wear, cell.value);
}

}  // namespace

KeptTables::KeptTables(IsoContext& c) : given_(c.registers.offsets) {
  for (const KeptOffset& cell : c.host.person.kept.offsets) putOffset(c.registers.offsets, cell);
  for (const KeptFrame& frame : c.host.person.kept.frames) {
    if (keepsFrame(c, frame.system)) c.registers.frames.system(frame.system).offset = frame.offset;
  }
}

void KeptTables::keep(IsoContext& c) const {
  const OffsetTables& table = c.registers.offsets;
  std::vector<KeptOffset>& out = c.summary.kept.offsets;
  for (int row = 1; row <= OffsetTables::kRows; ++row) {
    for (int column = 0; column < kOffsetColumns; ++column) {
      const OffsetValue& now = table.value(static_cast<OffsetColumn>(column), row);
      const OffsetValue& before = given_.value(static_cast<OffsetColumn>(column), row);
      if (now.geometry != before.geometry) out.push_back({column, row, false, now.geometry, before.geometry});
      if (now.wear != before.wear) out.push_back({column, row, true, now.wear, before.wear});
    }
    const auto code = [](int tip) { return static_cast<double>(tip); };
    if (table.tip(row) != given_.tip(row))
      out.push_back({KeptOffset::kTipColumn, row, false, code(table.tip(row)), code(given_.tip(row))});
  }
  const WorkFrames& frames = c.registers.frames;
  const auto take = [&](WorkSystemId id) {
    const AxisPoint& offset = frames.system(id).offset;
    if (keepsFrame(c, id) && !(offset == AxisPoint())) c.summary.kept.frames.push_back({id, offset});
  };
  for (WorkSystemId id = 2; id <= static_cast<int>(frames.basic.size()); ++id) take(id);
  for (const auto& entry : frames.extended) take(kFirstExtended + entry.first - 1);
}

}  // namespace proveout::nc
