// Rows of settings, text, expressions, O-words and M codes.
#include "core/nc/linuxcnc/coverage/rows.h"

namespace proveout::nc {
namespace {

// One row a line.
// clang-format off
constexpr auto kLinuxCncTextRowsList = std::to_array<CoverageIdRow>({
    {"lcn-1-start", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-1-units", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-1-remap", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-1-python", "REJECT", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-1-ini", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-2-line", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-n", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-skip", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-comment", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-msg", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-print", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-debug", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-log", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-probeopen", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-words", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-groups", "REJECT", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-order", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-2-numbers", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_line_test.cpp"},
    {"lcn-2-expr", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_expression_test.cpp"},
    {"lcn-2-func", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_expression_test.cpp"},
    {"lcn-2-experr", "REJECT", "done", "tests/unit/nc/linuxcnc/linuxcnc_expression_test.cpp"},
    {"lcn-2-params", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_expression_test.cpp"},
    {"lcn-2-predefined", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_expression_test.cpp"},
    {"lcn-2-persist", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-2-sysparams", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-2-readonly", "REJECT", "done", "tests/unit/nc/linuxcnc/linuxcnc_expression_test.cpp"},
    {"lcn-2-uninit", "REJECT", "done", "tests/unit/nc/linuxcnc/linuxcnc_expression_test.cpp"},
    {"lcn-2-inihal", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-2-o", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_o_word_test.cpp"},
    {"lcn-2-oflow", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_o_word_test.cpp"},
    {"lcn-2-oerr", "REJECT", "done", "tests/unit/nc/linuxcnc/linuxcnc_o_word_test.cpp"},
    {"lcn-2-ofile", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_o_word_test.cpp"},
    {"lcn-2-M98", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_o_word_test.cpp"},
    {"lcn-5-M0", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M2", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M3", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M6", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M61", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M7", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M19", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M48", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M62", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M66", "STATE", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M70", "SIM", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
    {"lcn-5-M100", "HOST", "done", "tests/unit/nc/linuxcnc/linuxcnc_function_test.cpp"},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> linuxCncTextRows() { return kLinuxCncTextRowsList; }

}  // namespace proveout::nc
