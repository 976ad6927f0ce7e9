// #10001 to #13999, #21001 to #23999, #135001 to #138999: the offset tables (manual 23.1.18).
#pragma once

#include "core/nc/iso/model/offset_tables.h"
#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

/// Rows up to N1400, in the unit in force. Without N1416.TOL the turning columns are not there. What H and D
/// have brought into force stays as it is.
class ToolOffsetBank : public VariableBank {
 public:
  explicit ToolOffsetBank(IsoContext& context) : c_(context) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;

 private:
  struct Cell {
    OffsetColumn column = OffsetColumn::kLength;
    bool wear = false;
    bool tip = false;  ///< the code of the tip
    int row = 0;
  };
  bool find(int number, Cell& cell) const;

  IsoContext& c_;
};

}  // namespace proveout::nc
