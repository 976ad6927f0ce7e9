// Rows of the flavour of Haas.
#include "core/nc/fanuc/coverage/rows.h"

namespace proveout::nc {
namespace {

// One row a line.
// clang-format off
constexpr auto kHaasRowsList = std::to_array<CoverageIdRow>({
    {"haas-18-dec", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-group", "REJECT", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G28", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G53", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-M97", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-M98L", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-M96", "REJECT", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-M", "HOST", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G04", "TIME", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G52", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G92", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G154", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G110", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G47", "SIM", "done", "tests/unit/nc/fanuc/haas_pockets_test.cpp"},
    {"haas-18-G12", "SIM", "done", "tests/unit/nc/fanuc/haas_pockets_test.cpp"},
    {"haas-18-G13", "SIM", "done", "tests/unit/nc/fanuc/haas_pockets_test.cpp"},
    {"haas-18-G150", "SIM", "done", "tests/unit/nc/fanuc/haas_pockets_test.cpp"},
    {"haas-18-G70", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G71", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G72", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G73", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G84", "TIME", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-L", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-Ropt", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G77", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G100", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G101", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G02", "REJECT", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G103", "HOST", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G187", "TIME", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G141", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G143", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G136", "REJECT", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-G107", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-offsets", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-vars", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-macro", "SIM", "done", "tests/unit/nc/fanuc/haas_test.cpp"},
    {"haas-18-latheG71", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"haas-18-latheG72", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"haas-18-latheG73", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_contours_test.cpp"},
    {"haas-18-latheG74", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"haas-18-latheG76", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_cycles_test.cpp"},
    {"haas-18-T", "SIM", "done", "tests/unit/nc/fanuc/fanuc_lathe_test.cpp"},
});
// clang-format on

}  // namespace

std::span<const CoverageIdRow> haasRows() { return kHaasRowsList; }

}  // namespace proveout::nc
