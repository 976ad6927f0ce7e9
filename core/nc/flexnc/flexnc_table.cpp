// The tables of codes.
#include <algorithm>
#include <array>

#include "core/nc/flexnc/cycles/flexnc_cycles.h"
#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_functions.h"
#include "core/nc/flexnc/flexnc_words.h"

namespace proveout::nc {

namespace {

using FS = FlexState;
using K = OriginKind;

// clang-format off: one row a line
constexpr auto kFlexG = std::to_array<FlexGCode>({
    {0, &FS::motion, performFlexMotionCode, K::kMotionCode, "SIM", "fnc-1.1-G00",
     "rapid, each axis at its own speed"},
    {10, &FS::motion, performFlexMotionCode, K::kMotionCode, "SIM", "fnc-1.2-G01", "line at feed"},
    {20, &FS::motion, performFlexMotionCode, K::kMotionCode, "SIM", "fnc-1.3-G02",
     "arc, clockwise as arc_view sees it"},
    {30, &FS::motion, performFlexMotionCode, K::kMotionCode, "SIM", "fnc-1.3-G03", "arc, counter-clockwise"},
    {40, nullptr, performFlexDwell, {}, "TIME", "fnc-1.4-G04", "dwell X seconds"},
    {170, &FS::plane, performFlexPlane, K::kPlane, "STATE", "fnc-1.3-G17",
     "plane XY: no arcs, no compensation"},
    {180, &FS::plane, performFlexPlane, K::kPlane, "STATE", "fnc-1.3-G18", "plane XZ"},
    {190, &FS::plane, performFlexPlane, K::kPlane, "STATE", "fnc-1.3-G19",
     "plane YZ: no arcs, no compensation"},
    {400, &FS::comp, nullptr, K::kCompensation, "SIM", "fnc-1.5b-G40 fnc-1.5b-intro", "compensation off"},
    {410, &FS::comp, nullptr, K::kCompensation, "SIM", "fnc-1.5b-G41",
     "compensation, tool left of the contour"},
    {420, &FS::comp, nullptr, K::kCompensation, "SIM", "fnc-1.5b-G42 fnc-1.5b-inner fnc-1.5b-outer",
     "compensation, tool right of the contour"},
    {520, nullptr, performFlexShift, K::kShift, "SIM", "fnc-1.5-G52", "local system; X0Z0 ends it"},
    {800, nullptr, performFlexNothing, {}, "STATE", "fnc-3.6-G80", "not described: does nothing"},
    {810, nullptr, performFlexEndBlock, {}, "SIM", "fnc-3.6-G81", "end block: compensation off, to X Z"},
    {811, nullptr, performFlexApproach, {}, "SIM", "fnc-3.6-G81.1", "to the equidistant of a shaft"},
    {812, nullptr, performFlexApproach, {}, "SIM", "fnc-3.6-G81.2", "to the equidistant of a hole"},
    {813,
     nullptr,
     performFlexApproach,
     {},
     "SIM",
     "fnc-3.6-G81.3",
     "to the equidistant of a shaft, as G81.1"},
    {860, &FS::css, performFlexSurfaceSpeed, K::kSpindleMode, "TIME", "fnc-1.6-G86",
     "constant cutting speed"},
    {870, &FS::css, performFlexSurfaceSpeed, K::kSpindleMode, "TIME", "fnc-1.6-G87",
     "constant spindle speed"},
    {900, &FS::distance, nullptr, K::kDistance, "SIM", "fnc-1.7-G90", "absolute"},
    {910, &FS::distance, nullptr, K::kDistance, "SIM", "fnc-1.7-G91", "incremental"},
    {980, &FS::feed_mode, nullptr, K::kFeedMode, "TIME", "fnc-1.8-G98", "feed in mm/min"},
    {990, &FS::feed_mode, nullptr, K::kFeedMode, "TIME", "fnc-1.8-G99", "feed in mm/rev"},
});

constexpr auto kFlexM = std::to_array<FlexMCode>({
    {1, performFlexOptionalStop, "HOST", "fnc-2-M01", "technological stop"},
    {2, performFlexEnd, "STATE", "fnc-2-M02", "end, spindle off"},
    {3, performFlexSpindle, "STATE", "fnc-2-M03", "spindle clockwise"},
    {4, performFlexSpindle, "STATE", "fnc-2-M04", "spindle counter-clockwise"},
    {5, performFlexSpindle, "STATE", "fnc-2-M05", "spindle off"},
    {6, performFlexToolChange, "SIM", "fnc-2-M06", "tool change"},
    {8, performFlexCoolant, "STATE", "fnc-2-M08", "coolant on"},
    {9, performFlexCoolant, "STATE", "fnc-2-M09", "coolant off"},
    {19, performFlexSpindle, "STATE", "fnc-2-M19", "spindle stopped at an angle"},
});

constexpr auto kFlexCycles = std::to_array<FlexCycleRow>({
    {CycleCode::kG3_1, "fnc-3.2-G3.1 fnc-3.4-G3.1", "part of a circle"},
    {CycleCode::kG5, "fnc-3.6-G5", "deep drilling"},
    {CycleCode::kG8_1, "fnc-3.2-G8.1 fnc-3.4-G8.1", "convex and concave radius"},
    {CycleCode::kG12, "fnc-3.2-G12 fnc-3.3-G12 fnc-3.4-G12 fnc-3.5-G12", "quarter of a circle"},
    {CycleCode::kG12_1, "fnc-3.2-G12.1 fnc-3.3-G12.1 fnc-3.4-G12.1 fnc-3.5-G12.1",
     "convex radius, cone: X, Y"},
    {CycleCode::kG12_2, "fnc-3.2-G12.2 fnc-3.3-G12.2 fnc-3.4-G12.2 fnc-3.5-G12.2",
     "convex radius, cone: A, Y"},
    {CycleCode::kG12_3, "fnc-3.2-G12.3 fnc-3.3-G12.3 fnc-3.4-G12.3 fnc-3.5-G12.3",
     "convex radius, cone: A of the cone at the face"},
    {CycleCode::kG12_5, "fnc-3.2-G12.5 fnc-3.3-G12.5 fnc-3.4-G12.5 fnc-3.5-G12.5",
     "convex radius, cone: X, A"},
    {CycleCode::kG13, "fnc-3.2-G13 fnc-3.3-G13 fnc-3.4-G13 fnc-3.5-G13",
     "quarter of a circle, the other way"},
    {CycleCode::kG13_1, "fnc-3.2-G13.1 fnc-3.3-G13.1 fnc-3.4-G13.1 fnc-3.5-G13.1",
     "concave radius, cone: X, Y"},
    {CycleCode::kG13_2, "fnc-3.2-G13.2 fnc-3.3-G13.2 fnc-3.4-G13.2 fnc-3.5-G13.2",
     "concave radius, cone: A, Y"},
    {CycleCode::kG13_5, "fnc-3.2-G13.5 fnc-3.4-G13.5", "concave radius, cone: X, A"},
    {CycleCode::kG22_1, "fnc-3.2-G22.1 fnc-3.3-G22.1 fnc-3.4-G22.1 fnc-3.5-G22.1", "convex, cone, convex: X"},
    {CycleCode::kG22_2, "fnc-3.2-G22.2 fnc-3.3-G22.2 fnc-3.4-G22.2 fnc-3.5-G22.2", "convex, cone, convex: A"},
    {CycleCode::kG22_3, "fnc-3.2-G22.3 fnc-3.3-G22.3 fnc-3.4-G22.3 fnc-3.5-G22.3",
     "convex, cone, convex: A of the cone at the face"},
    {CycleCode::kG23_1, "fnc-3.2-G23.1 fnc-3.3-G23.1 fnc-3.4-G23.1 fnc-3.5-G23.1",
     "convex, cone, concave: X of the cone at its end"},
    {CycleCode::kG23_2, "fnc-3.2-G23.2 fnc-3.3-G23.2 fnc-3.4-G23.2 fnc-3.5-G23.2",
     "convex, cone, concave: A of the cone at the face"},
    {CycleCode::kG23_3, "fnc-3.2-G23.3 fnc-3.3-G23.3 fnc-3.4-G23.3 fnc-3.5-G23.3",
     "convex, cone, concave: X"},
    {CycleCode::kG23_4, "fnc-3.2-G23.4 fnc-3.3-G23.4 fnc-3.4-G23.4 fnc-3.5-G23.4",
     "convex, cone, concave: A"},
    {CycleCode::kG30, "fnc-3.6-G30", "worm of several starts"},
    {CycleCode::kG76, "fnc-3.6-G76a fnc-3.6-G76b", "thread: data, cut"},
    {CycleCode::kG77, "fnc-3.2-G77 fnc-3.3-G77 fnc-3.4-G77 fnc-3.5-G77", "cone: X, A, Y"},
    {CycleCode::kG77_1, "fnc-3.2-G77.1 fnc-3.3-G77.1 fnc-3.4-G77.1 fnc-3.5-G77.1", "cone: X, Y, angle"},
    {CycleCode::kG77_2, "fnc-3.2-G77.2 fnc-3.3-G77.2 fnc-3.4-G77.2 fnc-3.5-G77.2", "cone: A, Y, angle"},
    {CycleCode::kG77_3, "fnc-3.2-G77.3 fnc-3.3-G77.3 fnc-3.4-G77.3 fnc-3.5-G77.3", "cone: A, X, angle"},
    {CycleCode::kG79, "fnc-3.6-G79", "facing"},
    {CycleCode::kG79_1, "fnc-3.6-G79.1", "groove into a shaft"},
    {CycleCode::kG79_2, "fnc-3.6-G79.2", "ring groove into a face"},
});

constexpr auto kFlexFeatures = std::to_array<FlexFeature>({
    {"X Z", "SIM", "fnc-0-coord", "axes; zero on the spindle's axis at the face"},
    {"numbers", "STATE", "fnc-0-decimal", "decimal point, no comma"},
    {"feed under compensation", "TIME", "fnc-1.5b-feed", "the nose centre goes at F"},
    {"modes", "STATE", "fnc-1.x-persist", "power-on modes at the start of each run"},
    {"F", "TIME", "fnc-2-F", "feed"},
    {"S", "TIME", "fnc-2-S", "speed of the spindle or of the cut"},
    {"D", "SIM", "fnc-2-D", "corrector: nose radius, tip, shift"},
    {"T", "SIM", "fnc-2-T", "tool that M06 changes to"},
    {"template arguments", "SIM", "fnc-3.1-P fnc-3.1-C fnc-3.1-B fnc-3.1-V fnc-3.1-K fnc-3.1-C5",
     "P C B V K, retracts of C/5"},
    {"templates", "SIM", "fnc-3.1-rough fnc-3.1-contour", "roughing by P, contours by K"},
    {"G3.1 G8.1 G13.5 in holes", "REJECT", "fnc-3.5-none", "no form for holes"},
    {"start block", "SIM", "fnc-3.6-start", "T M06 D, S M03, G98 or G99 F"},
    {"REPEAT", "SIM", "fnc-3.6-REPEAT", "REPEATn(Pv)FROMlabel"},
    {"N", "STATE", "fnc-3.6-N", "label"},
    {"GOSUB", "SIM", "fnc-3.6-GOSUB", "call of a subprogram"},
    {"RET", "SIM", "fnc-3.6-RET", "return"},
    {"Y", "REJECT", "fnc-3.6-Yaxis", "no Y axis"},
    {"+ - * / ( )", "SIM", "fnc-4.2-arith", "expressions"},
    {"SIN COS TAN", "SIM", "fnc-4.2-trig", "of degrees"},
    {"P", "SIM", "fnc-4.2-pvar", "variables P1100 to P8100"},
    {"//", "HOST", "fnc-4.2-comment", "comment"},
    {"[name]", "SIM", "fnc-4.2-param", "parameter of a template, filled in before the control reads it"},
    {".tmpl container", "REJECT", "fnc-4.2-tmpl", "the shell's own format"},
    {".tmps container", "REJECT", "fnc-4.5-tmps", "the shell's own format"},
    {"need fill", "STATE", "fnc-4.2-need", "all parameters need a value"},
    {".pmc", "SIM", "fnc-4.5-pmc", "plain program text"},
    {"shell", "HOST", "fnc-4.2-add fnc-4.2-help fnc-4.2-ui fnc-4.3-quick fnc-4.5-ui",
     "windows of the editor"},
    {"program order", "STATE", "fnc-4.4-order", "start, roughing, end, approach, contours, end"},
    {"G92", "REJECT", "fnc-4.2-G92", "not described"},
});
// clang-format on

}  // namespace

std::span<const FlexGCode> flexGCodes() { return kFlexG; }
std::span<const FlexMCode> flexMCodes() { return kFlexM; }
std::span<const FlexCycleRow> flexCycleRows() { return kFlexCycles; }
std::span<const FlexFeature> flexFeatures() { return kFlexFeatures; }

const FlexGCode* flexGCode(int tenths) {
  const auto found =
      std::find_if(kFlexG.begin(), kFlexG.end(), [&](const FlexGCode& g) { return g.tenths == tenths; });
  return found == kFlexG.end() ? nullptr : &*found;
}

const FlexMCode* flexMCode(int tenths) {
  const auto found =
      std::find_if(kFlexM.begin(), kFlexM.end(), [&](const FlexMCode& m) { return 10 * m.code == tenths; });
  return found == kFlexM.end() ? nullptr : &*found;
}

}  // namespace proveout::nc
