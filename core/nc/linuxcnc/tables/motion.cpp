// Motion, feed, planes and units.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/linuxcnc/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kLinuxCncMotionTableG = std::to_array<GCode>({
    action(0, kGroupMotion, kSim, kAxes, planRapid, false, "lcn-3-G0", "rapid"),
    action(10, kGroupMotion, kSim, kAxes, planLine, false, "lcn-3-G1", "line"),
    action(20, kGroupMotion, kSim, "XYZUVWIJKRP", planArc, false, "lcn-3-G2", "arc clockwise"),
    action(30, kGroupMotion, kSim, "XYZUVWIJKRP", planArc, false, "lcn-3-G3", "arc counter-clockwise"),
    action(40, kOneShot, kTime, "P", planDwell, false, "lcn-3-G4", "dwell"),
    modal(170, kGroupPlane, kSim, "lcn-4-G17", "plane XY"),
    modal(180, kGroupPlane, kSim, "lcn-4-G18", "plane XZ"),
    modal(190, kGroupPlane, kSim, "lcn-4-G19", "plane YZ"),
    modal(200, kGroupUnits, kSim, "lcn-4-G20", "inch"),
    modal(210, kGroupUnits, kSim, "lcn-4-G21", "millimetres"),
    modal(900, kGroupDistance, kSim, "lcn-4-G90", "absolute"),
    modal(910, kGroupDistance, kSim, "lcn-4-G91", "incremental"),
    modal(940, kGroupFeedMode, kTime, "lcn-4-G94", "feed per minute"),
    modal(950, kGroupFeedMode, kTime, "lcn-4-G95", "feed per turn"),
    modal(610, kGroupCutting, kTime, "lcn-4-G61", "exact path"),
    modal(640, kGroupCutting, kTime, "lcn-4-G64", "blending", "PQ"),
    modal(400, kGroupRadiusComp, kSim, "lcn-4-G40", "compensation off"),
    modal(490, kGroupLengthComp, kSim, "lcn-4-G49", "length offset off", {}, true),
    modal(430, kGroupLengthComp, kSim, "lcn-4-G43", "length offset of the tool table", {}, true),
    modal(540, kGroupWorkSystem, kSim, "lcn-4-G54", "work system 1", {}, true),
    modal(800, kGroupCycle, kSim, "lcn-3-G80", "motion mode off"),
    modal(980, kGroupReturn, kSim, "lcn-3-G98", "cycles return to the old Z"),
    modal(990, kGroupReturn, kSim, "lcn-3-G99", "cycles return to R"),
});

constexpr auto kLinuxCncMotionTableM = std::to_array<MCode>({
    {0, MPhase::kStop, kFlowCodes, kState, {}, "lcn-5-M0", "stop"},
    {1, MPhase::kStop, kFlowCodes, kState, {}, "lcn-5-M0", "optional stop"},
    {2, MPhase::kEnd, kFlowCodes, kSim, {}, "lcn-5-M2", "end of program"},
    {3, MPhase::kBefore, kSpindleCodes, kState, {}, "lcn-5-M3", "spindle clockwise"},
    {4, MPhase::kBefore, kSpindleCodes, kState, {}, "lcn-5-M3", "spindle counter-clockwise"},
    {5, MPhase::kBefore, kSpindleCodes, kState, {}, "lcn-5-M3", "spindle stop"},
    {6, MPhase::kBefore, 0, kSim, {}, "lcn-5-M6", "tool change"},
    {8, MPhase::kBefore, kCoolantCodes, kState, {}, "lcn-5-M7", "coolant on"},
    {9, MPhase::kBefore, kCoolantCodes, kState, {}, "lcn-5-M7", "coolant off"},
    {30, MPhase::kEnd, kFlowCodes, kSim, {}, "lcn-5-M2", "end of program"},
});

}  // namespace

CodeTable linuxCncMotionTable() { return {kLinuxCncMotionTableG, kLinuxCncMotionTableM, {}}; }

}  // namespace proveout::nc
