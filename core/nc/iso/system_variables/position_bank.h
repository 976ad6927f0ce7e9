// #5001 to #5200 and #100001 ... #151150: positions, skip positions, length offsets (manual 23.1.15-23.1.17).
#pragma once

#include "core/machine/axis_point.h"
#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

/// How a control shows positions.
struct PositionRules {
  bool probe_tip = false;   ///< skip positions are those of the tool's tip, without the length offset
  bool nct_numbers = true;  ///< those that only nct has: #100651, #151001 and their like
};

/// Read-only; by axis number, in the unit in force. Programs read them when the block before has ended. While
/// cutter compensation is on, positions with compensation are those that the tool has surely reached: the end
/// of the last motion that look-ahead has let go.
class PositionBank : public VariableBank {
 public:
  explicit PositionBank(IsoContext& context, const PositionRules& rules = {}) : c_(context), rules_(rules) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int, const Value&) override { return VariableStatus::kReadOnly; }

 private:
  IsoContext& c_;
  PositionRules rules_;
};

/// Where a measuring move stopped, for #5061 and its like: `machine` is the point in machine coordinates.
void recordSkip(IsoContext& c, const AxisPoint& machine);

}  // namespace proveout::nc
