// Makers of rows for the parameter table of a control.
#pragma once

#include <string_view>

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc::param_rows {

constexpr ParamScope kGlobal = ParamScope::kGlobal;
constexpr ParamScope kChannel = ParamScope::kChannel;
constexpr ParamScope kAxis = ParamScope::kAxis;
constexpr ParamScope kSpindle = ParamScope::kSpindle;

constexpr ParamInfo number(std::string_view name, int no, ParamScope scope, double default_value, double min,
                           double max, std::string_view meaning) {
  return {name, no, kWholeParam, scope, default_value, min, max, meaning};
}
constexpr ParamInfo bit(std::string_view name, int no, int position, ParamScope scope, double default_value,
                        std::string_view meaning) {
  return {name, no, position, scope, default_value, 0, 1, meaning};
}
/// A row whose values have names: "calculator increment" are 0 and 1.
constexpr ParamInfo choice(std::string_view name, int no, double default_value, std::string_view words,
                           std::string_view meaning) {
  ParamInfo row{name, no, kWholeParam, kChannel, default_value, 0, 0, meaning};
  for (const char c : words) row.max += c == ' ' ? 1 : 0;
  row.choices = words;
  return row;
}
/// A choice of two that is one bit of its number, from 0.
constexpr ParamInfo atBit(ParamInfo row, int position) {
  row.bit = position;
  return row;
}
/// A row that programs cannot change.
constexpr ParamInfo atPowerOn(ParamInfo row) {
  row.restart = true;
  return row;
}

/// A row without effect in the simulation: the rule for what only the machine or the person at it can do.
constexpr ParamInfo noted(ParamInfo row) {
  row.noted = true;
  return row;
}

}  // namespace proveout::nc::param_rows
