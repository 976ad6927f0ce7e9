// What formulas ask of the nct control.
#pragma once

#include "core/nc/iso/parameters/parameters.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/macro/expression.h"

namespace proveout::nc {

class IsoMacroEnvironment : public MacroEnvironment {
 public:
  IsoMacroEnvironment(const AxisTable& axes, const IsoParameters& parameters)
      : axes_(axes), parameters_(parameters) {}
  int axisNumber(std::string_view name) const override;
  ParameterAnswer parameter(int number, int bit, int index) const override;

 private:
  const AxisTable& axes_;
  const IsoParameters& parameters_;
};

}  // namespace proveout::nc
