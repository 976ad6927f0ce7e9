// What the WL4 control supports: from the codes that execute, and the rows of the manual in the order of the
// rows' list.
#include <fmt/core.h>

#include <array>
#include <string>

#include "core/nc/wl4/wl4_codes.h"

namespace proveout::nc {

namespace {

// clang-format off: one row a line
constexpr auto kRows = std::to_array<CoverageIdRow>({
    {"wl4-1-limits", "STATE", "done", "tests/unit/nc/wl4_test.cpp"},
    {"wl4-4-pct", "SIM", "done", "wl4/good/wl4_subprograms.nc"},
    {"wl4-4-names", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-4.1-charset", "HOST", "done", "tests/unit/nc/wl4_test.cpp"},
    {"wl4-4.2-num", "SIM", "done", "wl4/bad/wl4_syntax.nc"},
    {"wl4-4.2-N", "STATE", "done", "wl4/good/wl4_conditions.nc"},
    {"wl4-4.2-XYZ", "SIM", "done", "wl4/good/wl4_arc_lathe.nc"},
    {"wl4-4.2-ABC", "SIM", "done", "tests/unit/nc/wl4_test.cpp"},
    {"wl4-4.2-UVW", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-4.2-IJK", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-4.2-R", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-4.2-L", "SIM", "done", "wl4/bad/wl4_missing_subprogram.nc"},
    {"wl4-4.2-F", "TIME", "done", "wl4/bad/wl4_feed_and_speed.nc"},
    {"wl4-4.2-D", "SIM", "done", "wl4/good/wl4_comp.nc"},
    {"wl4-4.2-H", "SIM", "done", "wl4/good/wl4_length.nc"},
    {"wl4-4.2-E", "SIM", "done", "wl4/good/wl4_times.nc"},
    {"wl4-4.2-P", "SIM", "done", "wl4/good/wl4_g77_linear.nc"},
    {"wl4-4.2-Q", "SIM", "done", "wl4/bad/wl4_contours.nc"},
    {"wl4-4.2-S", "TIME", "done", "wl4/good/wl4_times.nc"},
    {"wl4-4.2-T", "SIM", "done", "wl4/good/wl4_g77_equidistant.nc"},
    {"wl4-4.2-M", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-4.2-var", "SIM", "done", "wl4/bad/wl4_system_variable.nc"},
    {"wl4-4.3-last", "SIM", "done", "wl4/good/wl4_conditions.nc"},
    {"wl4-4.3-len", "HOST", "done", "tests/unit/nc/wl4_test.cpp"},
    {"wl4-4.4-cmt", "HOST", "done", "wl4/good/wl4_conditions.nc"},
    {"wl4-4.4-dot", "HOST", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-4.5-slash", "SIM", "done", "wl4/good/wl4_conditional_blocks.nc"},
    {"wl4-5-reset", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-5-order", "SIM", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-5.1.1-G0", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.1.2-G1", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.1.3-G2", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.1.3-G3", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.1.3-full", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.1.3-R", "SIM", "done", "wl4/bad/wl4_arcs.nc"},
    {"wl4-5.1.4-G12", "SIM", "done", "wl4/bad/wl4_arcs.nc"},
    {"wl4-5.1.4-G13", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.1.5-G32", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-5.1.6-G33", "SIM", "done", "wl4/good/wl4_threads.nc"},
    {"wl4-5.2-G36", "SIM", "done", "wl4/good/wl4_reference.nc"},
    {"wl4-5.3-G38", "SIM", "done", "wl4/good/wl4_g38_touch.nc"},
    {"wl4-5.4-G4", "TIME", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-5.5-G9", "TIME", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-5.6-G60", "TIME", "done", "wl4/good/wl4_times.nc"},
    {"wl4-5.6-G63", "TIME", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-5.6-G64", "TIME", "done", "wl4/good/wl4_times.nc"},
    {"wl4-5.7-G17", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.7-G18", "SIM", "done", "wl4/good/wl4_arc_lathe.nc"},
    {"wl4-5.7-G19", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.8-G90", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.8-G91", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.9-G92", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.10-G53", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.10-G54", "SIM", "done", "wl4/good/wl4_arcs_mill.nc"},
    {"wl4-5.10-G55", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.10-G56", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.10-G57", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.10-G58", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.10-G59", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.11-G50", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.11-G51", "SIM", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-5.12-G51S", "TIME", "done", "wl4/good/wl4_surface_speed_limit.nc"},
    {"wl4-5.13-G94", "TIME", "done", "wl4/good/wl4_times.nc"},
    {"wl4-5.13-G95", "TIME", "done", "wl4/good/wl4_arc_lathe.nc"},
    {"wl4-5.14-G96", "TIME", "done", "wl4/bad/wl4_feed_and_speed.nc"},
    {"wl4-5.14-G97", "TIME", "done", "wl4/good/wl4_times.nc"},
    {"wl4-6.1-wp", "SIM", "done", "wl4/good/wl4_working_point.nc"},
    {"wl4-6.1-Rt", "SIM", "done", "wl4/good/wl4_nose_radius.nc"},
    {"wl4-6.2-G40", "SIM", "done", "wl4/good/wl4_comp.nc"},
    {"wl4-6.2-G41", "SIM", "done", "wl4/good/wl4_comp.nc"},
    {"wl4-6.2-G42", "SIM", "done", "wl4/good/wl4_comp.nc"},
    {"wl4-6.2-DeltL", "SIM", "done", "wl4/good/wl4_comp_threshold.nc"},
    {"wl4-6.2.1-gouge", "SIM", "done", "wl4/good/wl4_comp_threshold.nc"},
    {"wl4-6.2.1-negr", "SIM", "done", "wl4/bad/wl4_negative_radius.nc"},
    {"wl4-6.3-G43", "SIM", "done", "wl4/good/wl4_length.nc"},
    {"wl4-6.3-G44", "SIM", "done", "wl4/good/wl4_length.nc"},
    {"wl4-6.3-G49", "SIM", "done", "wl4/good/wl4_length.nc"},
    {"wl4-7.1-F", "TIME", "done", "wl4/good/wl4_times.nc"},
    {"wl4-7.2-S", "TIME", "done", "wl4/good/wl4_times.nc"},
    {"wl4-7.3-T", "SIM", "done", "wl4/good/wl4_nose_radius.nc"},
    {"wl4-7.3-TM6", "SIM", "done", "wl4/good/wl4_g77_equidistant.nc"},
    {"wl4-7.3-T0", "SIM", "done", "wl4/good/wl4_nose_radius.nc"},
    {"wl4-7.4-M0", "HOST", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M1", "HOST", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M2", "STATE", "done", "wl4/good/wl4_boring_cycles.nc"},
    {"wl4-7.4-M3", "STATE", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-7.4-M4", "STATE", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-7.4-M5", "STATE", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-7.4-M6", "SIM", "done", "wl4/good/wl4_g77_equidistant.nc"},
    {"wl4-7.4-M7", "HOST", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M8", "HOST", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M9", "HOST", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M19", "STATE", "done", "wl4/good/wl4_oriented_and_empty_call.nc"},
    {"wl4-7.4-M10", "HOST", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M30", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M31", "HOST", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-7.4-M40", "STATE", "done", "wl4/good/wl4_boring_cycles.nc"},
    {"wl4-7.4-M99", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-7.4-max", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-8.1-B", "SIM", "done", "wl4/good/wl4_chamfer.nc"},
    {"wl4-9.1-loc", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-9.1-glob", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.1-ind", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.2-101", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-102", "STATE", "done", "wl4/good/wl4_comp.nc"},
    {"wl4-9.2-103", "STATE", "done", "wl4/good/wl4_frames.nc"},
    {"wl4-9.2-104", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-105", "STATE", "done", "wl4/good/wl4_times.nc"},
    {"wl4-9.2-106", "STATE", "done", "wl4/good/wl4_times.nc"},
    {"wl4-9.2-107", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-108", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-112", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-114", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-117", "STATE", "done", "wl4/good/wl4_boring_cycles.nc"},
    {"wl4-9.2-120", "STATE", "done", "wl4/good/wl4_times.nc"},
    {"wl4-9.2-121", "STATE", "done", "wl4/good/wl4_nose_radius.nc"},
    {"wl4-9.2-130", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-131", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-132", "SIM", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-133", "SIM", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-134", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-135", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-136", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-137", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-138", "STATE", "done", "wl4/good/wl4_functions_of_the_machine.nc"},
    {"wl4-9.2-139", "SIM", "done", "wl4/good/wl4_g77_g78_open.nc"},
    {"wl4-9.2-140", "STATE", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-9.2-141", "STATE", "done", "wl4/good/wl4_comp.nc"},
    {"wl4-9.2-200", "STATE", "done", "wl4/good/wl4_g77_equidistant.nc"},
    {"wl4-5.3-1000", "SIM", "done", "wl4/good/wl4_g38_without_stock.nc"},
    {"wl4-5.3-1010", "SIM", "done", "wl4/good/wl4_g38_touch.nc"},
    {"wl4-5.3-1020", "SIM", "done", "wl4/good/wl4_g38_without_stock.nc"},
    {"wl4-9.3.1-ABS", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.1-COS", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-ACOS", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-SIN", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-ASIN", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-TAN", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-ATAN", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-EXP", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-FIX", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-FUP", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-LN", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-ROUND", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.1-SQRT", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-pow", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-mul", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.2-div", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.2-mod", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-add", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.2-sub", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.2-asg", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.2-AND", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-OR", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-XOR", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-eq", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-ne", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-lt", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.2-le", "SIM", "done", "wl4/good/wl4_functions.nc"},
    {"wl4-9.3.2-gt", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.3.2-ge", "SIM", "done", "wl4/good/wl4_conditions.nc"},
    {"wl4-9.3.3-prio", "SIM", "done", "wl4/good/wl4_expressions.nc"},
    {"wl4-9.4.1-lbl", "SIM", "done", "wl4/bad/wl4_labels.nc"},
    {"wl4-9.4.1-jmp", "SIM", "done", "wl4/bad/wl4_endless.nc"},
    {"wl4-9.4.2-IF", "SIM", "done", "wl4/good/wl4_conditions.nc"},
    {"wl4-9.4.2-IFp", "SIM", "done", "wl4/good/wl4_conditions.nc"},
    {"wl4-10.1-L", "SIM", "done", "wl4/good/wl4_subprograms.nc"},
    {"wl4-10.1-nest", "SIM", "done", "wl4/bad/wl4_sixth_level.nc"},
    {"wl4-10.2-G80", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-10.3.1-G81", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-10.3.2-G82", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-10.3.3-G83", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-10.3.4-G84", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-10.3.5-G85", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-10.3.6-G86", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-10.3.7-G87", "SIM", "done", "wl4/good/wl4_boring_cycles.nc"},
    {"wl4-10.3.8-G88", "SIM", "done", "wl4/good/wl4_boring_cycles.nc"},
    {"wl4-10.3.9-G89", "SIM", "done", "wl4/good/wl4_fixed_cycles.nc"},
    {"wl4-11-open", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-11.1-G31", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-11.2-G70", "SIM", "done", "wl4/good/wl4_g70_g71.nc"},
    {"wl4-11.3-G71", "SIM", "done", "wl4/good/wl4_g70_g71.nc"},
    {"wl4-11.4-G72", "SIM", "done", "wl4/good/wl4_g72_g73.nc"},
    {"wl4-11.5-G73", "SIM", "done", "wl4/good/wl4_g72_g73.nc"},
    {"wl4-11.6-G74", "SIM", "done", "wl4/good/wl4_g74_g75.nc"},
    {"wl4-11.7-G75", "SIM", "done", "wl4/good/wl4_g74_g75.nc"},
    {"wl4-11.8.1-G76", "SIM", "done", "wl4/good/wl4_g76.nc"},
    {"wl4-11.8.2-G76", "SIM", "done", "wl4/good/wl4_g76.nc"},
    {"wl4-11.8.3-G76", "SIM", "done", "wl4/good/wl4_g76.nc"},
    {"wl4-11.9.1-G77", "SIM", "done", "wl4/bad/wl4_contours.nc"},
    {"wl4-11.9.2-G77", "SIM", "done", "wl4/good/wl4_g77_equidistant.nc"},
    {"wl4-11.9.3-G77", "SIM", "done", "wl4/good/wl4_g77_equidistant.nc"},
    {"wl4-11.10-G77", "SIM", "done", "wl4/good/wl4_g77_g78_open.nc"},
    {"wl4-11.11.1-G78", "SIM", "done", "wl4/good/wl4_g78_linear.nc"},
    {"wl4-11.11.2-G78", "SIM", "done", "wl4/good/wl4_g78_roughing.nc"},
    {"wl4-11.11.3-G78", "SIM", "done", "wl4/good/wl4_g78.nc"},
    {"wl4-11.12-G78", "SIM", "done", "wl4/good/wl4_g77_g78_open.nc"},
    {"wl4-11-G79", "REJECT", "done", "wl4/bad/wl4_own_error.nc"},
    {"wl4-11.13-pgm", "SIM", "done", "wl4/good/wl4_g31_example_1.nc"},
    {"wl4-11-ts", "STATE", "done", "wl4/good/wl4_g77_linear.nc"},
    {"wl4-7.1-ovr", "HOST", "done", "wl4/good/wl4_threads.nc"},
    {"wl4-5-other", "REJECT", "done", "wl4/bad/wl4_other_codes.nc"},
});
// clang-format on

/// A code that does nothing is refused, whatever its class.
std::string statusOf(std::string_view cls, bool served) {
  if (!served) return "refused";
  return cls == "SIM"     ? "simulated"
         : cls == "TIME"  ? "timed"
         : cls == "STATE" ? "tracked"
         : cls == "HOST"  ? "noted"
                          : "refused";
}

bool isServed(const Wl4GCode& g) {
  return g.mode != nullptr || g.flag != nullptr || g.perform != nullptr || !g.program.empty();
}

bool isServed(const Wl4MCode& m) { return m.perform != nullptr || m.flow != Wl4Flow::kOn; }

std::string nameOf(const Wl4MCode& m) {
  return m.first == m.last ? fmt::format("M{}", m.first) : fmt::format("M{}-M{}", m.first, m.last);
}

}  // namespace

std::vector<CoverageRow> wl4Coverage() {
  std::vector<CoverageRow> rows;
  for (const Wl4GCode& g : wl4GCodes()) {
    rows.push_back({fmt::format("G{}", g.code), static_cast<int>(g.group), std::string(g.cls),
                    statusOf(g.cls, isServed(g)), std::string(g.ids), std::string(g.meaning)});
  }
  for (const Wl4MCode& m : wl4MCodes()) {
    rows.push_back({nameOf(m), -1, std::string(m.cls), statusOf(m.cls, isServed(m)), std::string(m.ids),
                    std::string(m.meaning)});
  }
  for (const Wl4Feature& f : wl4Features()) {
    rows.push_back({std::string(f.code), -1, std::string(f.cls), statusOf(f.cls, true), std::string(f.ids),
                    std::string(f.meaning)});
  }
  return rows;
}

std::vector<CoverageIdRow> wl4CoverageIds() { return {kRows.begin(), kRows.end()}; }

}  // namespace proveout::nc
