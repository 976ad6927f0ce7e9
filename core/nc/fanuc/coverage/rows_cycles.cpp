// Rows of cutter compensation, transformations and drilling cycles.
#include "core/nc/fanuc/coverage/rows.h"

namespace proveout::nc {
namespace {

// One row a line.
// clang-format off
constexpr auto kFanucCycleRowsList = std::to_array<CoverageIdRow>({
    {"fan-8-G40", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-G41", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-G42", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-startA", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-startB", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-cancel", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-corner", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-inner", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-nomove", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-dchange", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-sidechange", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-G39", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-041", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-034", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-inside", "SIM", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-dmissing", "STATE", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-feed", "TIME", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-8-G41.1", "STATE", "done", "tests/unit/nc/fanuc/fanuc_comp_test.cpp"},
    {"fan-9-G68", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G68inc", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G69", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G68.1", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-9-doubleturret", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
    {"fan-9-G51", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G50", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G51arc", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G51.1", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G50.1", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-order", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-mirrorcomp", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G15", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-9-G16", "SIM", "done", "tests/unit/nc/fanuc/fanuc_transforms_test.cpp"},
    {"fan-10-G73", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G74", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G76", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G80", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G81", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G82", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G83", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G84", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G85", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G86", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G87", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G88", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G89", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-rigid", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-rigidpeck", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-rigiderr", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-return", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-K", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-inc", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-nomove", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-group1", "SIM", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-missing", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
    {"fan-10-G81.1", "REJECT", "done", "tests/unit/nc/fanuc/fanuc_cycles_test.cpp"},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> fanucCycleRows() { return kFanucCycleRowsList; }

}  // namespace proveout::nc
