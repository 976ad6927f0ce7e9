#include "core/nc/coverage.h"

#include "core/nc/nct/nct_rows.h"
#include "core/nc/wl4/wl4_codes.h"

namespace proveout {

Result<std::vector<CoverageIdRow>> coverageIds(ControlId control) {
  if (control == ControlId::kWl4Mill || control == ControlId::kWl4Lathe) return nc::wl4CoverageIds();
  if (control != ControlId::kNct)
    return inputError("this control is known but this version cannot run it yet");
  std::vector<CoverageIdRow> rows;
  for (const nc::CoverageId& row : nc::nctRows()) {
    rows.push_back({row.id, codeClassName(row.cls), rowStatusName(row.status), row.proof});
  }
  return rows;
}

}  // namespace proveout
