// #10001 to #13999, #21001 to #23999, #135001 to #138999: the offset tables (manual 23.1.18).
#pragma once

#include <utility>
#include <vector>

#include "core/nc/iso/model/offset_tables.h"
#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

/// Numbers of a column of the tables: row n is #(base + n).
struct OffsetNumbers {
  int base = 0;
  int rows = 0;
  OffsetColumn column = OffsetColumn::kLength;
  bool wear = false;
  bool tip = false;              ///< the code of the tip
  bool turning = false;          ///< only with N1416.TOL
  bool both = false;             ///< one table for H and D: lengths and radii are the same cells
  double radius_of_value = 1.0;  ///< of radii: 0.5 where the table holds diameters
  const char* name = nullptr;    ///< or null
};

/// Rows up to N1400, in the unit in force. Without N1416.TOL the turning columns are not there. What H and D
/// have brought into force stays as it is.
class ToolOffsetBank : public VariableBank {
 public:
  /// The columns of nct.
  explicit ToolOffsetBank(IsoContext& context);
  ToolOffsetBank(IsoContext& context, std::vector<OffsetNumbers> columns)
      : c_(context), columns_(std::move(columns)) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;

 private:
  const OffsetNumbers* find(int number, int& row) const;

  IsoContext& c_;
  std::vector<OffsetNumbers> columns_;
};

}  // namespace proveout::nc
