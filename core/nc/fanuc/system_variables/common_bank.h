// Variables that only keep what programs write: the larger common memory, settings.
#pragma once

#include <map>
#include <unordered_map>

#include "core/nc/macro/variables.h"

namespace proveout::nc {

/// #98000 to #98499 and #900000 to #999999: vacant until written. #3005: 0 until written.
class CommonBank : public VariableBank {
 public:
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;
  /// Values that are not vacant.
  void addTo(std::map<int, double>& kept) const;

 private:
  std::unordered_map<int, Value> values_;
};

}  // namespace proveout::nc
