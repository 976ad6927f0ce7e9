#include "core/nc/iso/system_variables/tool_offset_bank.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {
namespace {

/// Names that only the table with turning columns has stand behind numbers that no program can write.
constexpr int kTurningName = 1'100'000'000;

struct Column {
  int base;  ///< number of row 0
  OffsetColumn column;
  bool wear;
  bool turning;  ///< only with N1416.TOL
  const char* name;
  const char* turning_name;  ///< second name with N1416.TOL, or null
};
constexpr int kTipBase = 23000;
constexpr auto kColumns = std::to_array<Column>({
    {10000, OffsetColumn::kLength, false, false, "OFSHG", "OFSZG"},
    {11000, OffsetColumn::kLength, true, false, "OFSHW", "OFSZW"},
    {12000, OffsetColumn::kRadius, false, false, "OFSDG", "OFSRG"},
    {13000, OffsetColumn::kRadius, true, false, "OFSDW", "OFSRW"},
    {21000, OffsetColumn::kCorner, false, false, "CORR_G", nullptr},
    {22000, OffsetColumn::kCorner, true, false, "CORR_W", nullptr},
    {kTipBase, OffsetColumn::kCorner, false, true, "OFST", nullptr},
    {135000, OffsetColumn::kX, true, true, "OFSXW", nullptr},
    {136000, OffsetColumn::kY, true, true, "OFSYW", nullptr},
    {137000, OffsetColumn::kX, false, true, "OFSXG", nullptr},
    {138000, OffsetColumn::kY, false, true, "OFSYG", nullptr},
});

}  // namespace

void ToolOffsetBank::addTo(VariableStore& store) {
  constexpr int kRows = OffsetTables::kRows;
  for (const Column& column : kColumns) {
    store.addBank(column.base + 1, column.base + kRows, *this);
    store.addSymbol({column.name, column.base + 1, 1, kRows});
    if (column.turning_name == nullptr) continue;
    store.addBank(kTurningName + column.base + 1, kTurningName + column.base + kRows, *this);
    store.addSymbol({column.turning_name, kTurningName + column.base + 1, 1, kRows});
  }
}

bool ToolOffsetBank::find(int number, Cell& cell) const {
  const bool turning_name = number > kTurningName;
  if (turning_name) number -= kTurningName;
  const int base = number / 1000 * 1000;
  const auto column =
      std::find_if(kColumns.begin(), kColumns.end(), [&](const Column& c) { return c.base == base; });
  if (column == kColumns.end()) return false;
  if ((turning_name || column->turning) && !c_.parameters.flag(DataParam::kTurningOffsets)) return false;
  cell = {column->column, column->wear, base == kTipBase, number - base};
  return cell.row <= static_cast<int>(c_.parameters[CompParam::kToolOffsets]);
}

VariableStatus ToolOffsetBank::read(int number, Value& out) {
  Cell cell;
  if (!find(number, cell)) return VariableStatus::kUnknown;
  const OffsetTables& offsets = c_.registers.offsets;
  const OffsetValue& value = offsets.value(cell.column, cell.row);
  out = {cell.tip ? offsets.tip(cell.row) : (cell.wear ? value.wear : value.geometry) / c_.state.unitScale()};
  const OffsetTables::SetBy& by = offsets.setBy(cell.column, cell.row);
  if (!cell.tip) out.origin = cell.wear ? by.wear : by.geometry;
  return VariableStatus::kDone;
}

VariableStatus ToolOffsetBank::write(int number, const Value& value) {
  Cell cell;
  if (!find(number, cell)) return VariableStatus::kUnknown;
  const double amount = value.vacant ? 0.0 : value.number;
  if (!(std::abs(amount) <= kMaxValue)) return VariableStatus::kLimit;
  if (!cell.tip) {
    c_.registers.offsets.set(cell.column, cell.row, cell.wear, amount * c_.state.unitScale(), value.origin);
    return VariableStatus::kDone;
  }
  const double code = std::round(amount);
  if (code < 0.0 || code > 9.0) return VariableStatus::kLimit;
  c_.registers.offsets.setTip(cell.row, static_cast<int>(code));
  return VariableStatus::kDone;
}

}  // namespace proveout::nc
