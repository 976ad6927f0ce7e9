// What the FlexNC control supports: from the codes that execute, and the rows of the manual.
#include <fmt/core.h>

#include <array>

#include "core/nc/flexnc/flexnc_codes.h"

namespace proveout::nc {

namespace {

// clang-format off: one row a line
constexpr auto kFlexRows = std::to_array<CoverageIdRow>({
    {"fnc-0-coord", "SIM", "done", "flexnc/good/diameter.nc"},
    {"fnc-0-decimal", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.1-G00", "SIM", "done", "flexnc/good/motion.nc"},
    {"fnc-1.2-G01", "SIM", "done", "flexnc/good/motion.nc"},
    {"fnc-1.3-G02", "SIM", "done", "flexnc/good/arcs.nc"},
    {"fnc-1.3-G03", "SIM", "done", "flexnc/good/arcs.nc"},
    {"fnc-1.3-G17", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.3-G18", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.3-G19", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.4-G04", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.5-G52", "SIM", "done", "flexnc/good/local.nc"},
    {"fnc-1.5b-G40", "SIM", "done", "flexnc/good/comp_right.nc"},
    {"fnc-1.5b-G41", "SIM", "done", "flexnc/good/comp_left.nc"},
    {"fnc-1.5b-G42", "SIM", "done", "flexnc/good/comp_right.nc"},
    {"fnc-1.5b-intro", "SIM", "done", "flexnc/good/comp_right.nc"},
    {"fnc-1.5b-inner", "SIM", "done", "flexnc/good/chain_shaft.nc"},
    {"fnc-1.5b-outer", "SIM", "done", "flexnc/good/comp_right.nc"},
    {"fnc-1.5b-feed", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.6-G86", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.6-G87", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.7-G90", "SIM", "done", "flexnc/good/motion.nc"},
    {"fnc-1.7-G91", "SIM", "done", "flexnc/good/motion.nc"},
    {"fnc-1.8-G98", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.8-G99", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-1.x-persist", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-F", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-S", "TIME", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-D", "SIM", "done", "flexnc/good/motion.nc"},
    {"fnc-2-T", "SIM", "done", "flexnc/good/motion.nc"},
    {"fnc-2-M01", "HOST", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-M02", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-M03", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-M04", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-M05", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-M06", "SIM", "done", "flexnc/good/motion.nc"},
    {"fnc-2-M08", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-M09", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-2-M19", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-3.1-P", "SIM", "done", "flexnc/good/rough_hole_G12.1.nc"},
    {"fnc-3.1-C", "SIM", "done", "flexnc/good/rough_hole_G12.1.nc"},
    {"fnc-3.1-B", "SIM", "done", "flexnc/good/rough_hole_G12.1.nc"},
    {"fnc-3.1-V", "SIM", "done", "flexnc/good/rough_hole_G12.1.nc"},
    {"fnc-3.1-K", "SIM", "done", "flexnc/good/chain_shaft.nc"},
    {"fnc-3.1-C5", "SIM", "done", "flexnc/good/rough_hole_G12.1.nc"},
    {"fnc-3.1-rough", "SIM", "done", "flexnc/good/rough_hole_G12.1.nc"},
    {"fnc-3.1-contour", "SIM", "done", "flexnc/good/chain_shaft.nc"},
    {"fnc-3.2-G3.1", "SIM", "done", "flexnc/good/rough_shaft_G3.1.nc"},
    {"fnc-3.2-G12", "SIM", "done", "flexnc/good/rough_shaft_G12.nc"},
    {"fnc-3.2-G13", "SIM", "done", "flexnc/good/rough_shaft_G13.nc"},
    {"fnc-3.2-G77", "SIM", "done", "flexnc/good/rough_shaft_G77.nc"},
    {"fnc-3.2-G77.1", "SIM", "done", "flexnc/good/rough_shaft_G77.1.nc"},
    {"fnc-3.2-G77.2", "SIM", "done", "flexnc/good/rough_shaft_G77.2.nc"},
    {"fnc-3.2-G77.3", "SIM", "done", "flexnc/good/rough_shaft_G77.3.nc"},
    {"fnc-3.2-G13.1", "SIM", "done", "flexnc/good/rough_shaft_G13.1.nc"},
    {"fnc-3.2-G13.2", "SIM", "done", "flexnc/good/rough_shaft_G13.2.nc"},
    {"fnc-3.2-G13.5", "SIM", "done", "flexnc/good/rough_shaft_G13.5.nc"},
    {"fnc-3.2-G12.1", "SIM", "done", "flexnc/good/rough_shaft_G12.1.nc"},
    {"fnc-3.2-G12.2", "SIM", "done", "flexnc/good/rough_shaft_G12.2.nc"},
    {"fnc-3.2-G12.3", "SIM", "done", "flexnc/good/rough_shaft_G12.3.nc"},
    {"fnc-3.2-G12.5", "SIM", "done", "flexnc/good/rough_shaft_G12.5.nc"},
    {"fnc-3.2-G22.1", "SIM", "done", "flexnc/good/rough_shaft_G22.1.nc"},
    {"fnc-3.2-G22.2", "SIM", "done", "flexnc/good/rough_shaft_G22.2.nc"},
    {"fnc-3.2-G22.3", "SIM", "done", "flexnc/good/rough_shaft_G22.3.nc"},
    {"fnc-3.2-G23.1", "SIM", "done", "flexnc/good/rough_shaft_G23.1.nc"},
    {"fnc-3.2-G23.2", "SIM", "done", "flexnc/good/rough_shaft_G23.2.nc"},
    {"fnc-3.2-G23.3", "SIM", "done", "flexnc/good/rough_shaft_G23.3.nc"},
    {"fnc-3.2-G23.4", "SIM", "done", "flexnc/good/rough_shaft_G23.4.nc"},
    {"fnc-3.2-G8.1", "SIM", "done", "flexnc/good/rough_shaft_G8.1.nc"},
    {"fnc-3.3-G12", "SIM", "done", "flexnc/good/rough_hole_G12.nc"},
    {"fnc-3.3-G13", "SIM", "done", "flexnc/good/rough_hole_G13.nc"},
    {"fnc-3.3-G77", "SIM", "done", "flexnc/good/rough_hole_G77.nc"},
    {"fnc-3.3-G77.1", "SIM", "done", "flexnc/good/rough_hole_G77.1.nc"},
    {"fnc-3.3-G77.2", "SIM", "done", "flexnc/good/rough_hole_G77.2.nc"},
    {"fnc-3.3-G77.3", "SIM", "done", "flexnc/good/rough_hole_G77.3.nc"},
    {"fnc-3.3-G13.1", "SIM", "done", "flexnc/good/rough_hole_G13.1.nc"},
    {"fnc-3.3-G13.2", "SIM", "done", "flexnc/good/rough_hole_G13.2.nc"},
    {"fnc-3.3-G12.1", "SIM", "done", "flexnc/good/rough_hole_G12.1.nc"},
    {"fnc-3.3-G12.2", "SIM", "done", "flexnc/good/rough_hole_G12.2.nc"},
    {"fnc-3.3-G12.3", "SIM", "done", "flexnc/good/rough_hole_G12.3.nc"},
    {"fnc-3.3-G12.5", "SIM", "done", "flexnc/good/rough_hole_G12.5.nc"},
    {"fnc-3.3-G22.1", "SIM", "done", "flexnc/good/rough_hole_G22.1.nc"},
    {"fnc-3.3-G22.2", "SIM", "done", "flexnc/good/rough_hole_G22.2.nc"},
    {"fnc-3.3-G22.3", "SIM", "done", "flexnc/good/rough_hole_G22.3.nc"},
    {"fnc-3.3-G23.1", "SIM", "done", "flexnc/good/rough_hole_G23.1.nc"},
    {"fnc-3.3-G23.2", "SIM", "done", "flexnc/good/rough_hole_G23.2.nc"},
    {"fnc-3.3-G23.3", "SIM", "done", "flexnc/good/rough_hole_G23.3.nc"},
    {"fnc-3.3-G23.4", "SIM", "done", "flexnc/good/rough_hole_G23.4.nc"},
    {"fnc-3.4-G3.1", "SIM", "done", "flexnc/good/contour_shaft_G3.1.nc"},
    {"fnc-3.4-G12", "SIM", "done", "flexnc/good/contour_shaft_G12.nc"},
    {"fnc-3.4-G13", "SIM", "done", "flexnc/good/contour_shaft_G13.nc"},
    {"fnc-3.4-G77", "SIM", "done", "flexnc/good/contour_shaft_G77.nc"},
    {"fnc-3.4-G77.1", "SIM", "done", "flexnc/good/contour_shaft_G77.1.nc"},
    {"fnc-3.4-G77.2", "SIM", "done", "flexnc/good/contour_shaft_G77.2.nc"},
    {"fnc-3.4-G77.3", "SIM", "done", "flexnc/good/contour_shaft_G77.3.nc"},
    {"fnc-3.4-G13.1", "SIM", "done", "flexnc/good/contour_shaft_G13.1.nc"},
    {"fnc-3.4-G13.2", "SIM", "done", "flexnc/good/contour_shaft_G13.2.nc"},
    {"fnc-3.4-G13.5", "SIM", "done", "flexnc/good/contour_shaft_G13.5.nc"},
    {"fnc-3.4-G12.1", "SIM", "done", "flexnc/good/contour_shaft_G12.1.nc"},
    {"fnc-3.4-G12.2", "SIM", "done", "flexnc/good/contour_shaft_G12.2.nc"},
    {"fnc-3.4-G12.3", "SIM", "done", "flexnc/good/contour_shaft_G12.3.nc"},
    {"fnc-3.4-G12.5", "SIM", "done", "flexnc/good/contour_shaft_G12.5.nc"},
    {"fnc-3.4-G22.1", "SIM", "done", "flexnc/good/contour_shaft_G22.1.nc"},
    {"fnc-3.4-G22.2", "SIM", "done", "flexnc/good/contour_shaft_G22.2.nc"},
    {"fnc-3.4-G22.3", "SIM", "done", "flexnc/good/contour_shaft_G22.3.nc"},
    {"fnc-3.4-G23.1", "SIM", "done", "flexnc/good/contour_shaft_G23.1.nc"},
    {"fnc-3.4-G23.2", "SIM", "done", "flexnc/good/contour_shaft_G23.2.nc"},
    {"fnc-3.4-G23.3", "SIM", "done", "flexnc/good/contour_shaft_G23.3.nc"},
    {"fnc-3.4-G23.4", "SIM", "done", "flexnc/good/contour_shaft_G23.4.nc"},
    {"fnc-3.4-G8.1", "SIM", "done", "flexnc/good/contour_shaft_G8.1.nc"},
    {"fnc-3.5-G12", "SIM", "done", "flexnc/good/contour_hole_G12.nc"},
    {"fnc-3.5-G13", "SIM", "done", "flexnc/good/contour_hole_G13.nc"},
    {"fnc-3.5-G77", "SIM", "done", "flexnc/good/contour_hole_G77.nc"},
    {"fnc-3.5-G77.1", "SIM", "done", "flexnc/good/contour_hole_G77.1.nc"},
    {"fnc-3.5-G77.2", "SIM", "done", "flexnc/good/contour_hole_G77.2.nc"},
    {"fnc-3.5-G77.3", "SIM", "done", "flexnc/good/contour_hole_G77.3.nc"},
    {"fnc-3.5-G13.1", "SIM", "done", "flexnc/good/contour_hole_G13.1.nc"},
    {"fnc-3.5-G13.2", "SIM", "done", "flexnc/good/contour_hole_G13.2.nc"},
    {"fnc-3.5-G12.1", "SIM", "done", "flexnc/good/contour_hole_G12.1.nc"},
    {"fnc-3.5-G12.2", "SIM", "done", "flexnc/good/contour_hole_G12.2.nc"},
    {"fnc-3.5-G12.3", "SIM", "done", "flexnc/good/contour_hole_G12.3.nc"},
    {"fnc-3.5-G12.5", "SIM", "done", "flexnc/good/contour_hole_G12.5.nc"},
    {"fnc-3.5-G22.1", "SIM", "done", "flexnc/good/contour_hole_G22.1.nc"},
    {"fnc-3.5-G22.2", "SIM", "done", "flexnc/good/contour_hole_G22.2.nc"},
    {"fnc-3.5-G22.3", "SIM", "done", "flexnc/good/contour_hole_G22.3.nc"},
    {"fnc-3.5-G23.1", "SIM", "done", "flexnc/good/contour_hole_G23.1.nc"},
    {"fnc-3.5-G23.2", "SIM", "done", "flexnc/good/contour_hole_G23.2.nc"},
    {"fnc-3.5-G23.3", "SIM", "done", "flexnc/good/contour_hole_G23.3.nc"},
    {"fnc-3.5-G23.4", "SIM", "done", "flexnc/good/contour_hole_G23.4.nc"},
    {"fnc-3.5-none", "REJECT", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-3.6-G79", "SIM", "done", "flexnc/good/facing.nc"},
    {"fnc-3.6-G5", "SIM", "done", "flexnc/good/drilling.nc"},
    {"fnc-3.6-start", "SIM", "done", "flexnc/good/chain_shaft.nc"},
    {"fnc-3.6-G81", "SIM", "done", "flexnc/good/chain_shaft.nc"},
    {"fnc-3.6-G81.1", "SIM", "done", "flexnc/good/chain_shaft.nc"},
    {"fnc-3.6-G81.3", "SIM", "done", "flexnc/good/chain_twin.nc"},
    {"fnc-3.6-G81.2", "SIM", "done", "flexnc/good/chain_hole.nc"},
    {"fnc-3.6-REPEAT", "SIM", "done", "flexnc/good/repeat.nc"},
    {"fnc-3.6-N", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-3.6-GOSUB", "SIM", "done", "flexnc/good/subprogram.nc"},
    {"fnc-3.6-RET", "SIM", "done", "flexnc/good/subprogram.nc"},
    {"fnc-3.6-G80", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-3.6-Yaxis", "REJECT", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-3.6-G79.2", "SIM", "done", "flexnc/good/groove_face.nc"},
    {"fnc-3.6-G79.1", "SIM", "done", "flexnc/good/groove_radial.nc"},
    {"fnc-3.6-G76a", "SIM", "done", "flexnc/good/thread.nc"},
    {"fnc-3.6-G76b", "SIM", "done", "flexnc/good/thread.nc"},
    {"fnc-3.6-G30", "SIM", "done", "flexnc/good/worm.nc"},
    {"fnc-4.2-tmpl", "REJECT", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.2-arith", "SIM", "done", "flexnc/good/expressions.nc"},
    {"fnc-4.2-trig", "SIM", "done", "flexnc/good/expressions.nc"},
    {"fnc-4.2-pvar", "SIM", "done", "flexnc/good/expressions.nc"},
    {"fnc-4.2-comment", "HOST", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.2-add", "HOST", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.2-need", "STATE", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.2-help", "HOST", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.2-ui", "HOST", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.2-G92", "REJECT", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.3-quick", "HOST", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.4-order", "STATE", "done", "flexnc/good/roughing_program.nc"},
    {"fnc-4.5-tmps", "REJECT", "done", "tests/unit/nc/flexnc_test.cpp"},
    {"fnc-4.5-pmc", "SIM", "done", "flexnc/good/template_text.nc"},
    {"fnc-4.5-ui", "HOST", "done", "tests/unit/nc/flexnc_test.cpp"},
});
// clang-format on

CoverageRow flexRowOf(std::string code, std::string_view cls, std::string_view ids,
                      std::string_view meaning) {
  return {std::move(code),     -1, std::string(cls), std::string(coverageStatus(cls)), std::string(ids),
          std::string(meaning)};
}

}  // namespace

std::vector<CoverageRow> flexncCoverage() {
  std::vector<CoverageRow> rows;
  for (const FlexGCode& g : flexGCodes())
    rows.push_back(flexRowOf(
        g.tenths % 10 == 0 ? fmt::format("G{:02}", g.tenths / 10) : fmt::format("G{:g}", g.tenths / 10.0),
        g.cls, g.ids, g.meaning));
  for (const FlexMCode& m : flexMCodes())
    rows.push_back(flexRowOf(fmt::format("M{:02}", m.code), m.cls, m.ids, m.meaning));
  for (const FlexCycleRow& cycle : flexCycleRows())
    rows.push_back(flexRowOf(cycleName(cycle.code), "SIM", cycle.ids, cycle.meaning));
  for (const FlexFeature& f : flexFeatures())
    rows.push_back(flexRowOf(std::string(f.code), f.cls, f.ids, f.meaning));
  return rows;
}

std::vector<CoverageIdRow> flexncCoverageIds() { return {kFlexRows.begin(), kFlexRows.end()}; }

std::map<std::string, std::string_view> flexncOpenReasons() {
  return {{"fnc-4.2-param",
           "[name] is refused: texts of templates get their values before the control reads them"}};
}

}  // namespace proveout::nc
