// What LinuxCNC tells programs of itself: numbered parameters that it works out, and predefined names.
#pragma once

#include <optional>
#include <string_view>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// What is known of the run and stands nowhere in the context.
struct LcnRunState {
  double value = 0.0;           ///< #<_value>
  bool value_returned = false;  ///< #<_value_returned>
  bool mist = false, flood = false;
};

/// A parameter that follows the control: #5220, #5400 to #5428. Nothing: it is a store place.
std::optional<double> lcnSystemValue(const IsoContext& c, int number);
/// May programs write the parameter?
bool lcnReadOnly(int number);
/// A predefined name, in small letters without < >: "_x". Nothing: there is no such name.
std::optional<double> lcnPredefined(const IsoContext& c, const LcnRunState& run, std::string_view name);

}  // namespace proveout::nc
