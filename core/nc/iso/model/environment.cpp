#include "core/nc/iso/model/environment.h"

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

int IsoMacroEnvironment::axisNumber(std::string_view name) const {
  const int axis = axes_.find(name);
  return axis < 0 ? -1 : axes_.at(axis).number;
}

double IsoMacroEnvironment::stepsPerUnit(Address address) const {
  const auto steps = context_.dialect.steps_per_unit;
  return steps != nullptr ? steps(context_, address) : 1.0;
}

MacroEnvironment::ParameterAnswer IsoMacroEnvironment::parameter(int number, int bit, int index) const {
  ParameterAnswer answer;
  switch (parameters_.read(number, bit < 0 ? kWholeParam : bit, index, answer.value)) {
    case ParamStatus::kOk:
    case ParamStatus::kRestart:
      break;
    case ParamStatus::kUnknown:
    case ParamStatus::kOutOfRange:
      return {SharedAlarm::kOutOfRange, "N", 0.0};
    case ParamStatus::kNeedsBit:
      return {SharedAlarm::kParameterMissing, "2.", 0.0};
    case ParamStatus::kBadIndex:
      return {SharedAlarm::kOutOfRange, "PRM", 0.0};
    case ParamStatus::kNeedsIndex:
      return {SharedAlarm::kParameterMissing, "3.", 0.0};
  }
  return answer;
}

}  // namespace proveout::nc
