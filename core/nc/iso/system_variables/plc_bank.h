// #1000 to #1035 and #1100 to #1135: inputs and outputs of the PLC (manual 23.1.7).
#pragma once

#include <array>
#include <cstdint>

#include "core/nc/control/control_host.h"
#include "core/nc/macro/variables.h"

namespace proveout::nc {

/// Inputs are those of the person at the machine and never change in a run. Outputs are kept and read back.
class PlcBank : public VariableBank {
 public:
  /// `person` must outlive the bank.
  explicit PlcBank(const Operator& person);
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;

 private:
  struct Port {
    std::uint32_t bits = 0;
    std::array<double, 3> numbers{};
  };
  Port in_, out_;
};

/// What a bit variable becomes: 1 for values above 0 up to 1, 0 for 0 and vacant. False: beyond (2092).
bool bitValue(const Value& value, bool& bit);

}  // namespace proveout::nc
