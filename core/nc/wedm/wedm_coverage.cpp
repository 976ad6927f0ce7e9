// What the wire EDM control supports: from the codes that execute, and the rows of the manual.
#include <fmt/core.h>

#include <array>

#include "core/nc/wedm/wedm_codes.h"

namespace proveout::nc {

namespace {

// clang-format off: one row a line
constexpr auto kWedmRows = std::to_array<CoverageIdRow>({
    {"wedm-1.1-charset", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-1.2-Z", "REJECT", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-1.4-units", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-1.4-ranges", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-1.5-abs-inc", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-1.6-comment", "HOST", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-2.1-block", "STATE", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-2.2-axes", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-2.2-onemotion", "REJECT", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-2.2-dupaxis", "REJECT", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-3-N", "STATE", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-4-skip", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.1-G00", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.1-space", "REJECT", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.2-G01", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.3-G02", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.3-G03", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.3-IJ", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5-G04", "TIME", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.4-G05", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.4-G06", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.4-G08", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.4-G09", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.5-G11", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5-G12", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5.1-G20", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.5.1-G21", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.5.2-G28", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5.2-G29", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5.3-G30", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5.3-G31", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5.3-G31X0", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.5.4-G34", "TIME", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.5.4-G35", "TIME", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.5.5-G36", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5.5-G37", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.5.5-G37T", "TIME", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.6-G40", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.6-G41", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.6-G42", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.6.1-H", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.6.2-startup", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.6.3-joins", "SIM", "done", "tests/unit/nc/wedm_constructed_test.cpp"},
    {"wedm-5.6.4-cancel", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.6.4-H0", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.6.5-change", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.6.6-G92", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.6.7-overcut", "REJECT", "done", "tests/unit/nc/wedm_constructed_test.cpp"},
    {"wedm-5.7-G50", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.7-G51", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.7-G52", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.7-A", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.8-G54", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.8-G55", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.8-G56", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.8-G57", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.8-G58", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.8-G59", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.9-G60", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.9-G61", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.9-colon", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.9-excl", "REJECT", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.9.1-G74", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.9.1-G75", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.9.1-excl", "REJECT", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-5.10-G90", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.10-G91", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-5.11-G92", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-6-XY", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-6-UV", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-7.2-start", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-7.3-joins", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-7.4-RR", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-7.5-variable", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-7.5-error", "REJECT", "done", "tests/unit/nc/wedm_constructed_test.cpp"},
    {"wedm-8.1-M00", "STATE", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-8.2-M02", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-8.3-M98", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-8.4-M99", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-8.5-M50", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-8.6-M60", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-9-C", "TIME", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-10-P", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-10-nest", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-10-L", "SIM", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-11-expr", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-12-H", "SIM", "done", "tests/unit/nc/wedm_test.cpp"},
    {"wedm-13-init", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-14-R", "SIM", "done", "tests/unit/nc/wedm_constructed_test.cpp"},
    {"wedm-15-T84", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-15-T85", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-15-T86", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-15-T87", "STATE", "done", "tests/unit/nc/wedm_language_test.cpp"},
    {"wedm-x-kerf", "SIM", "done", "tests/unit/wire/kerf_reference_test.cpp"},
    {"wedm-x-slug", "SIM", "done", "tests/unit/app/test_wire_runs.cpp"},
});
// clang-format on

}  // namespace

std::vector<CoverageRow> wedmCoverage() {
  std::vector<CoverageRow> rows;
  for (const WedmGCode& g : wedmGCodes())
    rows.push_back(
        coverageRow(fmt::format("G{:02}", g.code), static_cast<int>(g.group), g.cls, g.ids, g.meaning));
  for (const WedmFunction& f : wedmFunctions())
    rows.push_back(coverageRow(fmt::format("{}{:02}", f.address, f.code), -1, f.cls, f.ids, f.meaning));
  for (const WedmFeature& f : wedmFeatures())
    rows.push_back(coverageRow(std::string(f.code), -1, f.cls, f.ids, f.meaning));
  return rows;
}

std::vector<CoverageIdRow> wedmCoverageIds() { return {kWedmRows.begin(), kWedmRows.end()}; }

std::map<std::string, std::string_view> wedmOpenReasons() { return {}; }

}  // namespace proveout::nc
