#include "core/nc/fanuc/coverage/rows.h"

#include "core/nc/iso/model/code_coverage.h"

namespace proveout::nc {

std::vector<CoverageIdRow> fanucRows() {
  return joinRows({fanucTextRows(), fanucCycleRows(), fanucMacroRows(), fanucLatheRows(), haasRows()});
}

std::map<std::string, std::string_view> fanucOpenReasons() { return notBuiltYet(fanucRows()); }

}  // namespace proveout::nc
