// Motion, cycles, feed, planes, units, frames and compensation.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr AddressSet kLcnAxes = "XYZABCUVW@^";

constexpr GCode lcnMotion(int code10, AddressSet words, PlanFunction plan, std::string_view ids,
                          std::string_view meaning) {
  return action(code10, kGroupMotion, kSim, kLcnAxes | words, plan, false, ids, meaning);
}
constexpr GCode lcnFrame(int code10, std::string_view ids, std::string_view meaning) {
  return modal(code10, kGroupWorkSystem, kSim, ids, meaning, {}, true);
}

constexpr auto kLinuxCncMotionTableG = std::to_array<GCode>({
    lcnMotion(0, {}, planLcnRapid, "lcn-3-G0 lcn-3-modalmotion lcn-3-polar lcn-3-A", "rapid"),
    lcnMotion(10, {}, planLcnLine, "lcn-3-G1 lcn-3-modalmotion", "line"),
    lcnMotion(20, "IJKRP", planLcnArc, "lcn-3-G2 lcn-3-arctol lcn-3-arcP", "arc clockwise"),
    lcnMotion(30, "IJKRP", planLcnArc, "lcn-3-G3", "arc counter-clockwise"),
    action(40, kOneShot, kTime, "P", planLcnDwell, false, "lcn-3-G4", "dwell"),
    lcnMotion(50, "IJPQ", planLcnCubic, "lcn-3-G5", "cubic spline"),
    lcnMotion(51, "IJ", planLcnQuadratic, "lcn-3-G5.1", "quadratic spline"),
    lcnMotion(52, "PL", planLcnNurbs, "lcn-3-G5.2", "points of a NURBS"),
    lcnMotion(53, {}, planLcnNurbsEnd, "lcn-3-G5.3", "end of a NURBS"),
    lcnMotion(62, "RKPQ", planLcnKnots, "lcn-3-G6.2", "NURBS with knots"),
    modal(70, kGroupLathe, kSim, "lcn-4-G7", "X words are diameters"),
    modal(80, kGroupLathe, kSim, "lcn-4-G8", "X words are radii"),
    action(100, kOneShot, kSim, "XYZABCUVWLPRIJQ", planLcnData, true,
           "lcn-4-G10L0 lcn-4-G10L1 lcn-4-G10L2 lcn-4-G10L10 lcn-4-G10L20", "data of frames and tools"),
    action(120, kOneShot, kSim, "I", planMach3Circle, false, "lcn-6-mach3",
           "circle about the place, clockwise"),
    action(130, kOneShot, kSim, "I", planMach3Circle, false, "lcn-6-mach3", "circle, counter-clockwise"),
    modal(150, kGroupPolarData, kSim, "lcn-6-mach3", "polar words off"),
    modal(160, kGroupPolarData, kSim, "lcn-6-mach3", "polar words"),
    modal(170, kGroupPlane, kSim, "lcn-4-G17", "plane XY"),
    modal(180, kGroupPlane, kSim, "lcn-4-G18", "plane XZ"),
    modal(190, kGroupPlane, kSim, "lcn-4-G19", "plane YZ"),
    refused(171, kGroupPlane, kReject, "lcn-4-G17.1", "plane UV"),
    refused(181, kGroupPlane, kReject, "lcn-4-G17.1", "plane WU"),
    refused(191, kGroupPlane, kReject, "lcn-4-G17.1", "plane VW"),
    modal(200, kGroupUnits, kSim, "lcn-4-G20", "inch"),
    modal(210, kGroupUnits, kSim, "lcn-4-G21", "millimetres"),
    action(280, kOneShot, kSim, kLcnAxes, planLcnHome, true, "lcn-4-G28", "to the stored point of G28.1"),
    action(281, kOneShot, kState, {}, planLcnStoreHome, true, "lcn-4-G28.1", "store the point of G28"),
    action(300, kOneShot, kSim, kLcnAxes, planLcnHome, true, "lcn-4-G30", "to the stored point of G30.1"),
    action(301, kOneShot, kState, {}, planLcnStoreHome, true, "lcn-4-G30.1", "store the point of G30"),
    lcnMotion(310, {}, planLcnProbe, "lcn-6-mach3", "probe"),
    lcnMotion(330, "K", planLcnThread, "lcn-3-G33", "synchronous line"),
    lcnMotion(331, "KI", planLcnTap, "lcn-3-G33.1", "rigid tap"),
    refused(370, kOneShot, kReject, "lcn-6-other", "measuring of a tool, of PathPilot"),
    lcnMotion(382, {}, planLcnProbe, "lcn-3-G38.2", "probe towards, contact needed"),
    lcnMotion(383, {}, planLcnProbe, "lcn-3-G38.2", "probe towards"),
    lcnMotion(384, {}, planLcnProbe, "lcn-3-G38.5", "probe away, loss of contact needed"),
    lcnMotion(385, {}, planLcnProbe, "lcn-3-G38.5", "probe away"),
    modal(400, kGroupRadiusComp, kSim, "lcn-4-G40", "compensation off"),
    modal(410, kGroupRadiusComp, kSim,
          "lcn-4-G41 lcn-4-entry lcn-4-corner lcn-4-gouge lcn-4-comperr lcn-4-orient",
          "compensation left, by the tool table", "D"),
    modal(420, kGroupRadiusComp, kSim, "lcn-4-G42", "compensation right, by the tool table", "D"),
    modal(411, kGroupRadiusComp, kSim, "lcn-4-G41.1", "compensation left, by a diameter", "DL"),
    modal(421, kGroupRadiusComp, kSim, "lcn-4-G42.1", "compensation right, by a diameter", "DL"),
    modal(430, kGroupLengthComp, kSim, "lcn-4-G43 lcn-4-G43keep", "offset of the tool table", "H", true),
    modal(431, kGroupLengthComp, kSim, "lcn-4-G43.1", "offset by words", "XYZABCUVW", true),
    modal(432, kGroupLengthComp, kSim, "lcn-4-G43.2", "another offset on top", "XYZABCUVWH", true),
    refused(470, kOneShot, kReject, "lcn-6-other", "engraving of PathPilot"),
    modal(490, kGroupLengthComp, kSim, "lcn-4-G49", "offset off", {}, true),
    modal(500, kGroupScaling, kSim, "lcn-6-mach3", "factors off"),
    modal(510, kGroupScaling, kSim, "lcn-6-mach3", "factors of X Y Z", "XYZ"),
    action(520, kOneShot, kSim, kLcnAxes, planLcnSetPosition, true, "lcn-4-G52", "shift of all frames"),
    action(530, kOneShot, kSim, {}, nullptr, false, "lcn-4-G53", "machine coordinates in this line"),
    lcnFrame(540, "lcn-4-G54", "frame 1"),
    lcnFrame(550, "lcn-4-G54", "frame 2"),
    lcnFrame(560, "lcn-4-G54", "frame 3"),
    lcnFrame(570, "lcn-4-G54", "frame 4"),
    lcnFrame(580, "lcn-4-G54", "frame 5"),
    lcnFrame(590, "lcn-4-G54", "frame 6"),
    lcnFrame(591, "lcn-4-G59.3", "frame 7"),
    lcnFrame(592, "lcn-4-G59.3", "frame 8"),
    lcnFrame(593, "lcn-4-G59.3", "frame 9"),
    modal(610, kGroupCutting, kTime, "lcn-4-G61", "exact path"),
    modal(611, kGroupCutting, kTime, "lcn-4-G61.1", "exact stop"),
    modal(640, kGroupCutting, kTime, "lcn-4-G64", "blending", "PQR"),
    modal(680, kGroupRotation, kSim, "lcn-6-mach3", "rotation", "ABRI"),
    modal(690, kGroupRotation, kSim, "lcn-6-mach3", "rotation off"),
    lcnMotion(700, "QDEP", planLcnRough, "lcn-4-G70", "finish along a contour"),
    lcnMotion(710, "QDIR", planLcnRough, "lcn-4-G71", "rough along Z with the pockets"),
    lcnMotion(711, "QDIR", planLcnRough, "lcn-4-G71", "rough along Z, pockets left"),
    lcnMotion(712, "QDIR", planLcnRough, "lcn-4-G71", "rough along Z, the pockets alone"),
    lcnMotion(720, "QDIR", planLcnRough, "lcn-4-G72", "rough along X with the pockets"),
    lcnMotion(721, "QDIR", planLcnRough, "lcn-4-G72", "rough along X, pockets left"),
    lcnMotion(722, "QDIR", planLcnRough, "lcn-4-G72", "rough along X, the pockets alone"),
    lcnMotion(730, "RQL", planLcnCycle, "lcn-3-G73 lcn-3-sticky lcn-3-L lcn-3-cycleerr", "drill, chip break"),
    lcnMotion(740, "RP", planLcnCycle, "lcn-3-G74", "left tapping"),
    lcnMotion(760, "PIJKRQHEL", planLcnThreadCycle, "lcn-3-G76", "thread in several passes"),
    lcnMotion(800, {}, planLcnNothing, "lcn-3-G80", "no motion"),
    lcnMotion(810, "RL", planLcnCycle, "lcn-3-G81", "drill"),
    lcnMotion(820, "RPL", planLcnCycle, "lcn-3-G82", "drill, dwell"),
    lcnMotion(830, "RQL", planLcnCycle, "lcn-3-G83", "drill, full retract"),
    lcnMotion(840, "RPL", planLcnCycle, "lcn-3-G84", "tapping"),
    lcnMotion(850, "RL", planLcnCycle, "lcn-3-G85", "bore, feed out"),
    lcnMotion(860, "RPL", planLcnCycle, "lcn-3-G86", "bore, spindle stop"),
    lcnMotion(870, "RIJKL", planLcnCycle, "lcn-3-G87", "back bore"),
    lcnMotion(880, "RPL", planLcnCycle, "lcn-3-G88", "bore, out by hand"),
    lcnMotion(890, "RPL", planLcnCycle, "lcn-3-G89", "bore, dwell, feed out"),
    modal(900, kGroupDistance, kSim, "lcn-4-G90", "absolute"),
    modal(910, kGroupDistance, kSim, "lcn-4-G91", "incremental"),
    modal(901, kGroupArcCentre, kSim, "lcn-4-G90.1", "centres of arcs absolute"),
    modal(911, kGroupArcCentre, kSim, "lcn-4-G91.1", "centres of arcs from the start"),
    action(920, kOneShot, kSim, kLcnAxes, planLcnSetPosition, true, "lcn-4-G92", "the place reads the words"),
    action(921, kOneShot, kSim, {}, planLcnShiftOff, true, "lcn-4-G92.1", "shift off and 0"),
    action(922, kOneShot, kSim, {}, planLcnShiftOff, true, "lcn-4-G92.2", "shift off"),
    action(923, kOneShot, kSim, {}, planLcnShiftOff, true, "lcn-4-G92.2", "shift on again"),
    modal(930, kGroupFeedMode, kTime, "lcn-4-G93", "inverse time"),
    modal(940, kGroupFeedMode, kTime, "lcn-4-G94", "feed per minute"),
    modal(950, kGroupFeedMode, kTime, "lcn-4-G95", "feed per turn"),
    modal(960, kGroupSurfaceSpeed, kTime, "lcn-4-G96", "constant surface speed", "D"),
    modal(970, kGroupSurfaceSpeed, kTime, "lcn-4-G97", "turns a minute"),
    modal(980, kGroupReturn, kSim, "lcn-3-G98", "cycles return to the old Z"),
    modal(990, kGroupReturn, kSim, "lcn-3-G99", "cycles return to R"),
});

constexpr auto kLinuxCncFlavourTable = std::to_array<FeatureRow>({
    {"grbl", kSim, "lcn-6-grbl", "what GRBL 1.1 takes"},
    {"$ ? ! ~", kReject, "lcn-6-grbldollar", "commands of the sender"},
    {"grbl arcs", kReject, "lcn-6-grblarc", "errors 26, 33, 34, 35 of GRBL"},
    {"E", kReject, "lcn-6-E", "extruder words"},
});

}  // namespace

CodeTable linuxCncMotionTable() { return {kLinuxCncMotionTableG, {}, kLinuxCncFlavourTable}; }

}  // namespace proveout::nc
