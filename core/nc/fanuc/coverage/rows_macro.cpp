// Rows of subprograms, the macro language, system variables and M codes.
#include "core/nc/fanuc/coverage/rows.h"

namespace proveout::nc {
namespace {

// clang-format off: one row a line
constexpr auto kFanucMacroRowsList = std::to_array<CoverageIdRow>({
    {"fan-11-M98", "SIM", "missing", ""},         {"fan-11-M98Q", "SIM", "missing", ""},
    {"fan-11-M98name", "SIM", "missing", ""},     {"fan-11-M99", "SIM", "missing", ""},
    {"fan-11-M99P", "SIM", "missing", ""},        {"fan-11-M99main", "SIM", "missing", ""},
    {"fan-11-M30", "SIM", "missing", ""},         {"fan-11-M02", "SIM", "missing", ""},
    {"fan-11-M198", "SIM", "missing", ""},        {"fan-11-search", "SIM", "missing", ""},
    {"fan-11-nest", "REJECT", "missing", ""},     {"fan-12-vars", "SIM", "missing", ""},
    {"fan-12-large", "SIM", "missing", ""},       {"fan-12-nullrules", "SIM", "missing", ""},
    {"fan-12-args1", "SIM", "missing", ""},       {"fan-12-args2", "SIM", "missing", ""},
    {"fan-12-argdecimal", "SIM", "missing", ""},  {"fan-12-argerr", "REJECT", "missing", ""},
    {"fan-12-G65", "SIM", "missing", ""},         {"fan-12-G66", "SIM", "missing", ""},
    {"fan-12-G66.1", "SIM", "missing", ""},       {"fan-12-G67", "SIM", "missing", ""},
    {"fan-12-callG", "SIM", "missing", ""},       {"fan-12-callM", "SIM", "missing", ""},
    {"fan-12-callT", "SIM", "missing", ""},       {"fan-12-expr", "SIM", "missing", ""},
    {"fan-12-func", "SIM", "missing", ""},        {"fan-12-atan", "SIM", "missing", ""},
    {"fan-12-logic", "SIM", "missing", ""},       {"fan-12-cond", "SIM", "missing", ""},
    {"fan-12-IF", "SIM", "missing", ""},          {"fan-12-THEN", "SIM", "missing", ""},
    {"fan-12-GOTO", "SIM", "missing", ""},        {"fan-12-WHILE", "SIM", "missing", ""},
    {"fan-12-alarm", "STATE", "missing", ""},     {"fan-12-3006", "STATE", "missing", ""},
    {"fan-12-out", "HOST", "missing", ""},        {"fan-12-SETVN", "STATE", "missing", ""},
    {"fan-12-named", "STATE", "missing", ""},     {"fan-12-errors", "REJECT", "missing", ""},
    {"fan-12-lookahead", "STATE", "missing", ""}, {"fan-13-offsets", "SIM", "missing", ""},
    {"fan-13-lathe", "SIM", "missing", ""},       {"fan-13-v15", "SIM", "missing", ""},
    {"fan-13-frames", "SIM", "missing", ""},      {"fan-13-frames2", "SIM", "missing", ""},
    {"fan-13-frames3", "SIM", "missing", ""},     {"fan-13-position", "SIM", "missing", ""},
    {"fan-13-5021", "SIM", "missing", ""},        {"fan-13-5041", "SIM", "missing", ""},
    {"fan-13-5061", "SIM", "missing", ""},        {"fan-13-5081", "SIM", "missing", ""},
    {"fan-13-5101", "STATE", "missing", ""},      {"fan-13-100001", "SIM", "missing", ""},
    {"fan-13-modal", "STATE", "missing", ""},     {"fan-13-time", "STATE", "missing", ""},
    {"fan-13-3003", "STATE", "missing", ""},      {"fan-13-parts", "STATE", "missing", ""},
    {"fan-13-const", "SIM", "missing", ""},       {"fan-13-dio", "STATE", "missing", ""},
    {"fan-13-protect", "REJECT", "missing", ""},  {"fan-13-other", "REJECT", "missing", ""},
    {"fan-14-M00", "STATE", "missing", ""},       {"fan-14-M01", "STATE", "missing", ""},
    {"fan-14-spindle", "STATE", "missing", ""},   {"fan-14-coolant", "STATE", "missing", ""},
    {"fan-14-clamp", "HOST", "missing", ""},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> fanucMacroRows() { return kFanucMacroRowsList; }

}  // namespace proveout::nc
