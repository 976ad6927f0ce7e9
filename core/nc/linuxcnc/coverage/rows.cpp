#include "core/nc/linuxcnc/coverage/rows.h"

#include "core/nc/iso/model/code_coverage.h"

namespace proveout::nc {

std::vector<CoverageIdRow> linuxCncRows() { return joinRows({linuxCncTextRows(), linuxCncMotionRows()}); }

std::map<std::string, std::string_view> linuxCncOpenReasons() { return notBuiltYet(linuxCncRows()); }

}  // namespace proveout::nc
