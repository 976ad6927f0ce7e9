// Variables that Haas controls have beside those of Fanuc-like ones (section 18 of the rows): #10000 to
// #10999 and #8500 to #8599.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "core/nc/iso/model/dialect.h"
#include "core/nc/macro/variables.h"

namespace proveout::nc {

/// #10100 to #10199 and #10500 to #10999 are #100 to #199 and #500 to #999 by another number; the other ones
/// of that range are storage. Tool data are 0 until the program writes them, which a note says.
class HaasBank final : public VariableBank {
 public:
  explicit HaasBank(IsoContext& context) : c_(context) {}
  void addTo(VariableStore& store);
  /// Adds what programs have stored here, by number.
  void addTo(std::map<int, double>& kept) const;
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;

 private:
  static bool common(int number);

  IsoContext& c_;
  std::map<int, Value> stored_;
};

/// See IsoDialect::system_variables.
std::unique_ptr<SystemVariables> haasMillBanks(IsoContext& context);
std::unique_ptr<SystemVariables> haasLatheBanks(IsoContext& context);

}  // namespace proveout::nc
