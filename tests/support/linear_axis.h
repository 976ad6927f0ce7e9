// Axes beside X, Y and Z as settings give them.
#pragma once

#include <string>

#include "core/nc/control/control_settings.h"

namespace proveout::test {

/// A linear axis; `parallel`: the main axis that it carries the tool along, empty: none.
inline AxisSettings linearAxisOf(const std::string& name, int number, const std::string& parallel = "") {
  AxisSettings axis;
  axis.name = name;
  axis.number = number;
  axis.kind = AxisKind::kLinear;
  axis.parallel = parallel;
  return axis;
}

}  // namespace proveout::test
