// The tool offset tables of the nct control.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/assert.h"
#include "core/nc/control/control_settings.h"

namespace proveout::nc {

/// Columns of the tables; each has a geometry and a wear value, mm. What counts is their sum.
enum class OffsetColumn : std::uint8_t {
  kLength,  ///< H; the Z of turning offsets is the same cell
  kRadius,  ///< D: radius of the cutter, never a diameter
  kCorner,  ///< corner radius of the cutter
  kX,       ///< turning lengths
  kY,
  kCount
};

/// Rows 1 to 999 of a channel (manual 15.1). Some first rows may be those of another channel. Row 0 is not
/// there and counts as 0 everywhere.
class OffsetTables {
 public:
  static constexpr int kRows = 999;

  OffsetTables();
  /// Length and radius rows of the settings.
  explicit OffsetTables(const ControlSettings& settings);

  /// Rows 1 to `count` are those of `common` from here on (N1401). `common` must outlive this.
  void share(OffsetTables& common, int count);

  /// Geometry and wear of a row, 0 to 999.
  const OffsetValue& value(OffsetColumn column, int row) const {
    return rowAt(row).values[static_cast<std::size_t>(column)];
  }
  double effective(OffsetColumn column, int row) const {
    const OffsetValue& v = value(column, row);
    return v.geometry + v.wear;
  }
  /// Has the cell ever got a value?
  bool given(OffsetColumn column, int row) const {
    return (rowAt(row).given >> static_cast<unsigned>(column) & 1u) != 0;
  }
  /// `row` 1 to 999. `by`: number of the word that sets it (see OriginWords); 0: the job.
  void set(OffsetColumn column, int row, bool wear, double mm, std::uint32_t by = 0);
  struct SetBy {
    std::uint32_t geometry = 0, wear = 0;
  };
  const SetBy& setBy(OffsetColumn column, int row) const {
    return rowAt(row).by[static_cast<std::size_t>(column)];
  }

  /// Code of the tip of turning tools, 0 to 9.
  int tip(int row) const { return rowAt(row).tip; }
  void setTip(int row, int code) {
    PROVEOUT_ASSERT(row >= 1 && row <= kRows && code >= 0 && code <= 9);
    at(row).tip = static_cast<std::uint8_t>(code);
  }

 private:
  struct Row {
    std::array<OffsetValue, static_cast<std::size_t>(OffsetColumn::kCount)> values{};
    std::array<SetBy, static_cast<std::size_t>(OffsetColumn::kCount)> by{};
    std::uint8_t given = 0;  ///< a bit a column
    std::uint8_t tip = 0;
  };
  const Row& rowAt(int row) const {
    const OffsetTables& owner = row <= common_rows_ ? *common_ : *this;
    return owner.rows_[static_cast<std::size_t>(row)];
  }
  Row& at(int row) {
    OffsetTables& owner = row <= common_rows_ ? *common_ : *this;
    return owner.rows_[static_cast<std::size_t>(row)];
  }

  std::vector<Row> rows_;  ///< by row, 0 included
  OffsetTables* common_ = nullptr;
  int common_rows_ = -1;
};

}  // namespace proveout::nc
