// Rows of the control's manual: five axes. In the order of the rows' list.
#include "core/nc/nct/coverage/rows.h"

namespace proveout::nc {
namespace {

using namespace coverage_rows;

// clang-format off: one row a line
constexpr auto kRows6 = std::to_array<CoverageId>({
    {"nct-25.1-N3200", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3201", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3204", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3205", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3208", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3209", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3212-RD", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3213", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3216", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.2-G43.1", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.2-G49", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.2-FOS", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.3-G68.1", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.3-G69.1", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.4-G54.2", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.4-FOS", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.4-SUSP", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.4-VAR", kState, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.4.1-G10L21", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.6-G68.2", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.6-G69.1", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.7-G68.2P1", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.8-G68.2P2", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.8-G68.2P2Q0", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.9-G68.2P3", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.10-G68.2P4", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.11-G53.1", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.11-FOS", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.11-SEL", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.13-G52", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.13-G68", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.14-G43.4", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.14-G43.5", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.14-G02G03", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.14-F", kTime, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.14-G49", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.14-EX", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.15-G53.6", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.15-BUF", kState, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.16-G43.4P1", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.16-G43.5P1", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.16-P0", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.16-ARC", kSim, kDone, "tests/unit/nc/tip_control_test.cpp"},
    {"nct-25.19-PCS", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.19-TLC", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.19-5041", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3206", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3210", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3219", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.1-N3222", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.13-G92", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.13-G51", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.13-G51.1", kSim, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25-UNREACH", kReject, kDone, "tests/unit/nc/five_axis_test.cpp"},
    {"nct-25.5-EX", kSim, kDone, "tests/acceptance/test_five_axes.cpp"},
    {"nct-25.12-EX", kSim, kDone, "tests/acceptance/test_five_axes.cpp"},
    {"nct-25.1-HH", kSim, kDone, "tests/unit/nc/machine_chain_test.cpp"},
    {"nct-25.1-TT", kSim, kDone, "tests/unit/nc/machine_chain_test.cpp"},
    {"nct-25.1-HT", kSim, kDone, "tests/unit/nc/machine_chain_test.cpp"},
    {"nct-25.1-INCL", kSim, kDone, "tests/unit/nc/machine_chain_test.cpp"},
});
// clang-format on

}  // namespace

std::span<const CoverageId> coverage6() { return kRows6; }

}  // namespace proveout::nc
