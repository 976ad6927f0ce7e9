// Rows of settings, text, expressions, O-words and M codes.
#include "core/nc/linuxcnc/coverage/rows.h"

namespace proveout::nc {
namespace {

// clang-format off: one row a line
constexpr auto kLinuxCncTextRowsList = std::to_array<CoverageIdRow>({
    {"lcn-1-start", "STATE", "missing", ""},    {"lcn-1-units", "STATE", "missing", ""},
    {"lcn-1-remap", "SIM", "missing", ""},      {"lcn-1-python", "REJECT", "missing", ""},
    {"lcn-1-ini", "STATE", "missing", ""},      {"lcn-2-line", "SIM", "missing", ""},
    {"lcn-2-n", "STATE", "missing", ""},        {"lcn-2-skip", "SIM", "missing", ""},
    {"lcn-2-comment", "HOST", "missing", ""},   {"lcn-2-msg", "HOST", "missing", ""},
    {"lcn-2-print", "HOST", "missing", ""},     {"lcn-2-debug", "HOST", "missing", ""},
    {"lcn-2-log", "HOST", "missing", ""},       {"lcn-2-probeopen", "HOST", "missing", ""},
    {"lcn-2-words", "SIM", "missing", ""},      {"lcn-2-groups", "REJECT", "missing", ""},
    {"lcn-2-order", "SIM", "missing", ""},      {"lcn-2-numbers", "SIM", "missing", ""},
    {"lcn-2-expr", "SIM", "missing", ""},       {"lcn-2-func", "SIM", "missing", ""},
    {"lcn-2-experr", "REJECT", "missing", ""},  {"lcn-2-params", "SIM", "missing", ""},
    {"lcn-2-predefined", "SIM", "missing", ""}, {"lcn-2-persist", "SIM", "missing", ""},
    {"lcn-2-sysparams", "SIM", "missing", ""},  {"lcn-2-readonly", "REJECT", "missing", ""},
    {"lcn-2-uninit", "REJECT", "missing", ""},  {"lcn-2-inihal", "STATE", "missing", ""},
    {"lcn-2-o", "SIM", "missing", ""},          {"lcn-2-oflow", "SIM", "missing", ""},
    {"lcn-2-oerr", "REJECT", "missing", ""},    {"lcn-2-ofile", "SIM", "missing", ""},
    {"lcn-2-M98", "SIM", "missing", ""},        {"lcn-5-M0", "STATE", "missing", ""},
    {"lcn-5-M2", "SIM", "missing", ""},         {"lcn-5-M3", "STATE", "missing", ""},
    {"lcn-5-M6", "SIM", "missing", ""},         {"lcn-5-M61", "STATE", "missing", ""},
    {"lcn-5-M7", "STATE", "missing", ""},       {"lcn-5-M19", "STATE", "missing", ""},
    {"lcn-5-M48", "HOST", "missing", ""},       {"lcn-5-M62", "HOST", "missing", ""},
    {"lcn-5-M66", "STATE", "missing", ""},      {"lcn-5-M70", "SIM", "missing", ""},
    {"lcn-5-M100", "HOST", "missing", ""},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> linuxCncTextRows() { return kLinuxCncTextRowsList; }

}  // namespace proveout::nc
