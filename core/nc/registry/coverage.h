// What of its manual a control serves, row by row.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"

namespace proveout {

/// Error: the control is not built.
Result<std::vector<CoverageIdRow>> coverageIds(ControlId control);

/// One row of the specification: of everything that the control's manual asks for.
struct SpecificationRow {
  std::string id;          ///< "nct-4.3-G2"
  std::string chapter;     ///< "4.3"
  std::string cls;         ///< what the specification asks: as in CoverageRow
  std::string status;      ///< "done" (a test proves it), "open", or "unlisted": the control says neither
  std::string_view proof;  ///< the test that names it; empty: none
  std::string reason;      ///< why it is open, or why the code that serves it has another class; else empty
};
/// All rows in the manual's order, for controls that are not built too. Empty: the control has no manual.
std::vector<SpecificationRow> specificationRows(ControlId control);

}  // namespace proveout
