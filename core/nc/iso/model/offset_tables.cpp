#include "core/nc/iso/model/offset_tables.h"

#include <algorithm>

#include "core/base/assert.h"

namespace proveout::nc {

OffsetTables::OffsetTables() : rows_(kRows + 1) {}

OffsetTables::OffsetTables(const ControlSettings& settings) : OffsetTables() {
  const auto fill = [&](OffsetColumn column, const std::map<int, OffsetValue>& values) {
    for (const auto& [row, value] : values) {
      if (row < 1 || row > kRows) continue;
      set(column, row, false, value.geometry);
      set(column, row, true, value.wear);
    }
  };
  fill(OffsetColumn::kLength, settings.length_offsets);
  fill(OffsetColumn::kRadius, settings.radius_offsets);
}

void OffsetTables::share(OffsetTables& common, int count) {
  PROVEOUT_ASSERT(&common != this && count <= kRows);
  common_ = &common;
  common_rows_ = std::clamp(count, 0, kRows);
}

void OffsetTables::set(OffsetColumn column, int row, bool wear, double mm, std::uint32_t by) {
  PROVEOUT_ASSERT(row >= 1 && row <= kRows);
  Row& cells = at(row);
  OffsetValue& value = cells.values[static_cast<std::size_t>(column)];
  (wear ? value.wear : value.geometry) = mm;
  SetBy& set_by = cells.by[static_cast<std::size_t>(column)];
  (wear ? set_by.wear : set_by.geometry) = by;
  cells.given = static_cast<std::uint8_t>(cells.given | 1u << static_cast<unsigned>(column));
}

}  // namespace proveout::nc
