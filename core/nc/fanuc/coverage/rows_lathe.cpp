// Rows of lathes, of five axes and mill-turn, and of errors.
#include "core/nc/fanuc/coverage/rows.h"

namespace proveout::nc {
namespace {

// clang-format off: one row a line
constexpr auto kFanucLatheRowsList = std::to_array<CoverageIdRow>({
    {"fan-15-systems", "SIM", "missing", ""},  {"fan-15-diameter", "SIM", "missing", ""},
    {"fan-15-uw", "SIM", "missing", ""},       {"fan-15-T", "SIM", "missing", ""},
    {"fan-15-G50", "SIM", "missing", ""},      {"fan-15-G50S", "TIME", "missing", ""},
    {"fan-15-G96", "TIME", "missing", ""},     {"fan-15-G98", "TIME", "missing", ""},
    {"fan-15-nose", "SIM", "missing", ""},     {"fan-15-drawing", "SIM", "missing", ""},
    {"fan-15-G54", "SIM", "missing", ""},      {"fan-15-live", "STATE", "missing", ""},
    {"fan-16-G32", "SIM", "missing", ""},      {"fan-16-G34", "SIM", "missing", ""},
    {"fan-16-G36", "REJECT", "missing", ""},   {"fan-16-G37", "REJECT", "missing", ""},
    {"fan-16-G70", "SIM", "missing", ""},      {"fan-16-G71", "SIM", "missing", ""},
    {"fan-16-G71II", "SIM", "missing", ""},    {"fan-16-G71one", "SIM", "missing", ""},
    {"fan-16-G72", "SIM", "missing", ""},      {"fan-16-G73", "SIM", "missing", ""},
    {"fan-16-G74", "SIM", "missing", ""},      {"fan-16-G75", "SIM", "missing", ""},
    {"fan-16-G76", "SIM", "missing", ""},      {"fan-16-G76one", "SIM", "missing", ""},
    {"fan-16-G90", "SIM", "missing", ""},      {"fan-16-G92", "SIM", "missing", ""},
    {"fan-16-G94", "SIM", "missing", ""},      {"fan-16-G83", "SIM", "missing", ""},
    {"fan-16-G84", "SIM", "missing", ""},      {"fan-16-G85", "SIM", "missing", ""},
    {"fan-16-G87", "SIM", "missing", ""},      {"fan-16-G88", "SIM", "missing", ""},
    {"fan-16-G89", "SIM", "missing", ""},      {"fan-16-errors", "REJECT", "missing", ""},
    {"fan-17-G43.4", "SIM", "missing", ""},    {"fan-17-G43.5", "SIM", "missing", ""},
    {"fan-17-G68.2", "SIM", "missing", ""},    {"fan-17-G53.1", "SIM", "missing", ""},
    {"fan-17-G54.2", "SIM", "missing", ""},    {"fan-17-abc", "SIM", "missing", ""},
    {"fan-17-nokin", "REJECT", "missing", ""}, {"fan-19-place", "REJECT", "missing", ""},
    {"fan-20-rs274", "HOST", "missing", ""},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> fanucLatheRows() { return kFanucLatheRowsList; }

}  // namespace proveout::nc
