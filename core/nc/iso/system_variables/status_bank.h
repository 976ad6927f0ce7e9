// Clocks, counters, bits that steer automatic mode, state of the machine, pallets (manual 23.1.9-23.1.12,
// 23.1.21).
#pragma once

#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

/// How a control counts and what it has.
struct StatusRules {
  double cutting_unit_ms = 1.0;  ///< of #3002
  bool pallets = true;           ///< #8500 and its like
  bool waits_for_m = false;      ///< bit 1 of #3003: the end of M functions is not waited for
};

class StatusBank : public VariableBank {
 public:
  explicit StatusBank(IsoContext& context, const StatusRules& rules = {}) : c_(context), rules_(rules) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;

 private:
  double timeOfDay() const;
  double mirrorMask() const;
  VariableStatus writeBits(int number, const Value& value);
  VariableStatus writeCount(double& count, const Value& value);
  void tellPallets();

  IsoContext& c_;
  StatusRules rules_;
  bool no_wait_ = false;           ///< bit 1 of #3003
  double clock_start_ms_ = 0.0;    ///< of #3001, in time of the run
  double cutting_start_ms_ = 0.0;  ///< of #3002
  int pallet_place_ = 10;          ///< 10 work place, 11 mounting place
};

/// A part is made: M2, M30 or the M function of N2305 has run.
void countPart(IsoContext& c, int m);

}  // namespace proveout::nc
