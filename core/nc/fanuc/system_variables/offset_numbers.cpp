#include "core/nc/fanuc/system_variables/offset_numbers.h"

#include <array>

namespace proveout::nc {
namespace {

constexpr int kFewRows = 200, kManyRows = 999;  // from #2001 and from #10001 on
constexpr int kLatheRows = 64, kLatheYRows = 49;

constexpr OffsetColumn kHColumn = OffsetColumn::kLength, kDColumn = OffsetColumn::kRadius;

}  // namespace

std::vector<OffsetNumbers> millOffsetNumbers(const OffsetNumbering& numbering) {
  std::vector<OffsetNumbers> all;
  const double radius = numbering.diameters ? 0.5 : 1.0;
  // Number `place` of the columns from #2001 on (200 apart) and from #10001 on (1000 apart).
  const auto add = [&](int low, int high, OffsetColumn column, bool wear, bool both) {
    OffsetNumbers row{low, kFewRows, column, wear, false, false, both, radius};
    if (low >= 0) all.push_back(row);
    row.base = high;
    row.rows = kManyRows;
    if (high >= 0 && !numbering.haas) all.push_back(row);
  };
  if (numbering.memory == 0) {
    add(2000, 10000, kHColumn, false, true);
    return all;
  }
  const bool wear_first = !numbering.v15;
  const bool both = numbering.memory == 1;
  add(2000, 10000, kHColumn, wear_first, both);
  add(2200, 11000, kHColumn, !wear_first, both);
  if (both) return all;
  add(numbering.v15 ? 2400 : -1, 12000, kDColumn, wear_first, false);
  add(numbering.v15 ? 2600 : -1, 13000, kDColumn, !wear_first, false);
  return all;
}

std::vector<OffsetNumbers> latheOffsetNumbers(const OffsetNumbering& numbering) {
  struct Column {
    int low, high;  ///< -1: none
    OffsetColumn column;
    bool wear, tip;
    int rows = kLatheRows;
  };
  constexpr auto kColumns = std::to_array<Column>({
      {2000, 10000, OffsetColumn::kX, true, false},
      {2100, 11000, OffsetColumn::kLength, true, false},
      {2200, 12000, OffsetColumn::kRadius, true, false},
      {2300, 13000, OffsetColumn::kCorner, false, true},
      {2400, 14000, OffsetColumn::kY, true, false, kLatheYRows},
      {2700, 15000, OffsetColumn::kX, false, false},
      {2800, 16000, OffsetColumn::kLength, false, false},
      {2900, 17000, OffsetColumn::kRadius, false, false},
      {2450, 19000, OffsetColumn::kY, false, false, kLatheYRows},
  });
  std::vector<OffsetNumbers> all;
  const bool whole = numbering.memory == 0;
  for (const Column& column : kColumns) {
    if (whole && column.low > 2300) continue;
    OffsetNumbers row{column.low, column.rows, column.column, column.wear && !whole, column.tip};
    all.push_back(row);
    row.base = column.high;
    row.rows = kManyRows;
    if (!numbering.haas && !whole) all.push_back(row);
  }
  return all;
}

}  // namespace proveout::nc
