// What of its manual a control serves, row by row.
#pragma once

#include <string_view>
#include <vector>

#include "core/nc/interpreter.h"

namespace proveout {

/// One row of the control's manual that is asked for.
struct CoverageIdRow {
  std::string_view id;      ///< "nct-4.3-G2"
  std::string_view cls;     ///< as in CoverageRow
  std::string_view status;  ///< "done", "partly", "missing", "deferred"
  std::string_view proof;   ///< the test that names it; empty: none
};
/// Error: the control is not built.
Result<std::vector<CoverageIdRow>> coverageIds(ControlId control);

}  // namespace proveout
