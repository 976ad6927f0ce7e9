// Rows of lathes, of five axes and mill-turn, and of errors.
#include "core/nc/fanuc/coverage/rows.h"

namespace proveout::nc {
namespace {

// One row a line.
// clang-format off
constexpr auto kFanucLatheRowsList = std::to_array<CoverageIdRow>({
    {"fan-15-systems", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-diameter", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-uw", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-T", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-G50", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-G50S", "TIME", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-G96", "TIME", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-G98", "TIME", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-nose", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-drawing", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-G54", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-15-live", "STATE", "done", "tests/unit/nc/fanuc/fanuc_live_tools_test.cpp"},
    {"fan-16-G32", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G34", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G36", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-16-G37", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-16-G70", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"fan-16-G71", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"fan-16-G71II", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"fan-16-G71one", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"fan-16-G72", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"fan-16-G73", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"fan-16-G74", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G75", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G76", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G76one", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G90", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G92", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G94", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G83", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G84", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G85", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G87", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G88", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-G89", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"fan-16-errors", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"fan-17-G43.4", "SIM", "done", "tests/unit/nc/fanuc/fanuc_five_axis_test.cpp"},
    {"fan-17-G43.5", "SIM", "done", "tests/unit/nc/fanuc/fanuc_five_axis_test.cpp"},
    {"fan-17-G68.2", "SIM", "done", "tests/unit/nc/fanuc/fanuc_five_axis_test.cpp"},
    {"fan-17-G53.1", "SIM", "done", "tests/unit/nc/fanuc/fanuc_five_axis_test.cpp"},
    {"fan-17-G54.2", "SIM", "done", "tests/unit/nc/fanuc/fanuc_five_axis_test.cpp"},
    {"fan-17-abc", "SIM", "done", "tests/unit/nc/fanuc/fanuc_five_axis_test.cpp"},
    {"fan-17-nokin", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_five_axis_test.cpp"},
    {"fan-19-place", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_basic_test.cpp"},
    {"fan-20-rs274", "HOST", "done", "tests/unit/nc/fanuc/fanuc_rs274_test.cpp"},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> fanucLatheRows() { return kFanucLatheRowsList; }

}  // namespace proveout::nc
