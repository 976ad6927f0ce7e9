#include "core/nc/nct/macro/environment.h"

namespace proveout::nc {

int NctMacroEnvironment::axisNumber(std::string_view name) const {
  const int axis = axes_.find(name);
  return axis < 0 ? -1 : axes_.at(axis).number;
}

MacroEnvironment::ParameterAnswer NctMacroEnvironment::parameter(int number, int bit, int index) const {
  ParameterAnswer answer;
  switch (parameters_.read(number, bit < 0 ? kWholeParam : bit, index, answer.value)) {
    case ParamStatus::kOk:
    case ParamStatus::kRestart:
      break;
    case ParamStatus::kUnknown:
    case ParamStatus::kOutOfRange:
      return {2002, "N", 0.0};
    case ParamStatus::kNeedsBit:
      return {2194, "2.", 0.0};
    case ParamStatus::kBadIndex:
      return {2002, "PRM", 0.0};
    case ParamStatus::kNeedsIndex:
      return {2194, "3.", 0.0};
  }
  return answer;
}

}  // namespace proveout::nc
