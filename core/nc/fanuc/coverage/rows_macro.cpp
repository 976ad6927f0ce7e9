// Rows of subprograms, the macro language, system variables and M codes.
#include "core/nc/fanuc/coverage/rows.h"

namespace proveout::nc {
namespace {

// One row a line.
// clang-format off
constexpr auto kFanucMacroRowsList = std::to_array<CoverageIdRow>({
    {"fan-11-M98", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M98Q", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M98name", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M99", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M99P", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M99main", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M30", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M02", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-M198", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-search", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-11-nest", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-vars", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-large", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-nullrules", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-args1", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-args2", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-argdecimal", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-argerr", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-G65", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-G66", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-G66.1", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-G67", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-callG", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-callM", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-callT", "SIM", "done", "tests/unit/nc/fanuc/fanuc_calls_test.cpp"},
    {"fan-12-expr", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-func", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-atan", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-logic", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-cond", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-IF", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-THEN", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-GOTO", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-WHILE", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-alarm", "STATE", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-3006", "STATE", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-out", "HOST", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-SETVN", "STATE", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-named", "STATE", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-errors", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-12-lookahead", "STATE", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-13-offsets", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-lathe", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-v15", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-frames", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-frames2", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-frames3", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-position", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-5021", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-5041", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-5061", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-5081", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-5101", "STATE", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-100001", "SIM", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-modal", "STATE", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-time", "STATE", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-3003", "STATE", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-parts", "STATE", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-const", "SIM", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-13-dio", "STATE", "done", "tests/unit/nc/fanuc/fanuc_variables_test.cpp"},
    {"fan-13-protect", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-13-other", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_macro_test.cpp"},
    {"fan-14-M00", "STATE", "done", "tests/unit/nc/fanuc/fanuc_functions_test.cpp"},
    {"fan-14-M01", "STATE", "done", "tests/unit/nc/fanuc/fanuc_functions_test.cpp"},
    {"fan-14-spindle", "STATE", "done", "tests/unit/nc/fanuc/fanuc_functions_test.cpp"},
    {"fan-14-coolant", "STATE", "done", "tests/unit/nc/fanuc/fanuc_functions_test.cpp"},
    {"fan-14-clamp", "HOST", "done", "tests/unit/nc/fanuc/fanuc_functions_test.cpp"},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> fanucMacroRows() { return kFanucMacroRowsList; }

}  // namespace proveout::nc
