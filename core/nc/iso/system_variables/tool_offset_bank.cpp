#include "core/nc/iso/system_variables/tool_offset_bank.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {
namespace {

/// Names that only the table with turning columns has stand behind numbers that no program can write.
constexpr int kTurningName = 1'100'000'000;

std::vector<OffsetNumbers> nctColumns() {
  constexpr int kRows = OffsetTables::kRows;
  struct Names {
    OffsetNumbers numbers;
    const char* turning_name;  ///< second name with N1416.TOL, or null
  };
  const auto list = std::to_array<Names>({
      {{10000, kRows, OffsetColumn::kLength, false, false, false, false, 1.0, "OFSHG"}, "OFSZG"},
      {{11000, kRows, OffsetColumn::kLength, true, false, false, false, 1.0, "OFSHW"}, "OFSZW"},
      {{12000, kRows, OffsetColumn::kRadius, false, false, false, false, 1.0, "OFSDG"}, "OFSRG"},
      {{13000, kRows, OffsetColumn::kRadius, true, false, false, false, 1.0, "OFSDW"}, "OFSRW"},
      {{21000, kRows, OffsetColumn::kCorner, false, false, false, false, 1.0, "CORR_G"}, nullptr},
      {{22000, kRows, OffsetColumn::kCorner, true, false, false, false, 1.0, "CORR_W"}, nullptr},
      {{23000, kRows, OffsetColumn::kCorner, false, true, true, false, 1.0, "OFST"}, nullptr},
      {{135000, kRows, OffsetColumn::kX, true, false, true, false, 1.0, "OFSXW"}, nullptr},
      {{136000, kRows, OffsetColumn::kY, true, false, true, false, 1.0, "OFSYW"}, nullptr},
      {{137000, kRows, OffsetColumn::kX, false, false, true, false, 1.0, "OFSXG"}, nullptr},
      {{138000, kRows, OffsetColumn::kY, false, false, true, false, 1.0, "OFSYG"}, nullptr},
  });
  std::vector<OffsetNumbers> columns;
  for (const Names& row : list) {
    columns.push_back(row.numbers);
    if (row.turning_name == nullptr) continue;
    columns.push_back(row.numbers);
    columns.back().base += kTurningName;
    columns.back().turning = true;
    columns.back().name = row.turning_name;
  }
  return columns;
}

}  // namespace

ToolOffsetBank::ToolOffsetBank(IsoContext& context) : ToolOffsetBank(context, nctColumns()) {}

void ToolOffsetBank::addTo(VariableStore& store) {
  for (const OffsetNumbers& column : columns_) {
    store.addBank(column.base + 1, column.base + column.rows, *this);
    if (column.name != nullptr) store.addSymbol({column.name, column.base + 1, 1, column.rows});
  }
}

/// Null: the control has no such row.
const OffsetNumbers* ToolOffsetBank::find(int number, int& row) const {
  const auto column = std::find_if(columns_.begin(), columns_.end(), [&](const OffsetNumbers& c) {
    return number > c.base && number <= c.base + c.rows;
  });
  if (column == columns_.end()) return nullptr;
  if (column->turning && !c_.parameters.flag(DataParam::kTurningOffsets)) return nullptr;
  row = number - column->base;
  return row <= static_cast<int>(c_.parameters[CompParam::kToolOffsets]) ? &*column : nullptr;
}

VariableStatus ToolOffsetBank::read(int number, Value& out) {
  int row = 0;
  const OffsetNumbers* const column = find(number, row);
  if (column == nullptr) return VariableStatus::kUnknown;
  const OffsetTables& offsets = c_.registers.offsets;
  const OffsetValue& value = offsets.value(column->column, row);
  const double unit =
      c_.state.unitScale() * (column->column == OffsetColumn::kRadius ? column->radius_of_value : 1.0);
  out = {column->tip ? offsets.tip(row) : (column->wear ? value.wear : value.geometry) / unit};
  const OffsetTables::SetBy& by = offsets.setBy(column->column, row);
  if (!column->tip) out.origin = column->wear ? by.wear : by.geometry;
  return VariableStatus::kDone;
}

VariableStatus ToolOffsetBank::write(int number, const Value& value) {
  int row = 0;
  const OffsetNumbers* const column = find(number, row);
  if (column == nullptr) return VariableStatus::kUnknown;
  const double amount = value.vacant ? 0.0 : value.number;
  if (!(std::abs(amount) <= kMaxValue)) return VariableStatus::kLimit;
  if (!column->tip) {
    const double mm = amount * c_.state.unitScale();
    const bool radius = column->column == OffsetColumn::kRadius;
    OffsetTables& offsets = c_.registers.offsets;
    offsets.set(column->column, row, column->wear, radius ? mm * column->radius_of_value : mm, value.origin);
    if (column->both)
      offsets.set(OffsetColumn::kRadius, row, column->wear, mm * column->radius_of_value, value.origin);
    return VariableStatus::kDone;
  }
  const double code = std::round(amount);
  if (code < 0.0 || code > 9.0) return VariableStatus::kLimit;
  c_.registers.offsets.setTip(row, static_cast<int>(code));
  return VariableStatus::kDone;
}

}  // namespace proveout::nc
