// What formulas ask of the nct control.
#pragma once

#include "core/nc/iso/parameters/parameters.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/macro/expression.h"

namespace proveout::nc {

struct IsoContext;

class IsoMacroEnvironment : public MacroEnvironment {
 public:
  /// All must outlive the environment; the context may still be in the making.
  IsoMacroEnvironment(const AxisTable& axes, const IsoParameters& parameters, const IsoContext& context)
      : axes_(axes), parameters_(parameters), context_(context) {}
  int axisNumber(std::string_view name) const override;
  ParameterAnswer parameter(int number, int bit, int index) const override;
  double stepsPerUnit(Address address) const override;

 private:
  const AxisTable& axes_;
  const IsoParameters& parameters_;
  const IsoContext& context_;
};

}  // namespace proveout::nc
