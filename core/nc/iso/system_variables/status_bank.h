// Clocks, counters, bits that steer automatic mode, state of the machine, pallets (manual 23.1.9-23.1.12,
// 23.1.21).
#pragma once

#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

class StatusBank : public VariableBank {
 public:
  explicit StatusBank(IsoContext& context) : c_(context) {}
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
  double clock_start_ms_ = 0.0;    ///< of #3001, in time of the run
  double cutting_start_ms_ = 0.0;  ///< of #3002
  int pallet_place_ = 10;          ///< 10 work place, 11 mounting place
};

/// A part is made: M2, M30 or the M function of N2305 has run.
void countPart(IsoContext& c, int m);

}  // namespace proveout::nc
