// What formulas ask of the nct control.
#pragma once

#include "core/nc/kinematics/axes.h"
#include "core/nc/macro/expression.h"
#include "core/nc/nct/parameters/parameters.h"

namespace proveout::nc {

class NctMacroEnvironment : public MacroEnvironment {
 public:
  NctMacroEnvironment(const AxisTable& axes, const NctParameters& parameters)
      : axes_(axes), parameters_(parameters) {}
  int axisNumber(std::string_view name) const override;
  ParameterAnswer parameter(int number, int bit, int index) const override;

 private:
  const AxisTable& axes_;
  const NctParameters& parameters_;
};

}  // namespace proveout::nc
