// Interpolation, planes, units, feeds, dwell, reference points.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr AddressSet kArcWords = "XYZUVWIJKRLQcr";

constexpr auto kMotionGCodes = std::to_array<GCode>({
    action(0, kGroupMotion, kSim, "XYZUVWa", planRapid, false, "nct-4.1-G0 nct-6.1-rapid",
           "rapid positioning"),
    action(10, kGroupMotion, kSim, "XYZUVWQacr", planLine, false, "nct-4.2-G1", "linear interpolation"),
    action(20, kGroupMotion, kSim, kArcWords, planArc, false,
           "nct-4.3-G2 nct-4.3-R nct-4.3-IJK nct-4.3-full nct-4.3-vararc nct-4.3-Rsmall nct-4.3.1-spiral "
           "nct-4.3.2-helix nct-4.3.3-cone",
           "circle, helix, spiral, cone, clockwise"),
    action(30, kGroupMotion, kSim, kArcWords, planArc, false, "nct-4.3-G3",
           "circle, helix, spiral, cone, counter-clockwise"),
    action(40, kOneShot, kTime, "P", planDwell, false, "nct-3-G4 nct-8-G4", "dwell"),
    action(51, kOneShot, kState, "QXYZUVW", planSmooth, false,
           "nct-4.7-G5.1Q0 nct-4.7-G5.1Q1 nct-4.7-G5.1Q2 nct-4.7.1-G5.1Q3", "smooth interpolation"),
    action(71, kOneShot, kSim, kAxes, planCylinder, false, "nct-4.6-G7.1", "cylindrical interpolation"),
    modal(90, kOneShot, kTime, "nct-3-G9 nct-6.3.1-G9 nct-4.1.1-G9G61", "exact stop in this block"),
    action(109, kOneShot, kSim, kAxes, planDiameter, false, "nct-5.3.1-G10.9",
           "radius or diameter programming"),
    action(121, kGroupPolarInterpolation, kSim, {}, planPolarOn, false, "nct-4.5-G12.1",
           "polar interpolation"),
    action(131, kGroupPolarInterpolation, kSim, {}, planPolarOff, false, "nct-4.5-G13.1",
           "polar interpolation off"),
    modal(150, kGroupPolarData, kSim, "nct-5.4-G15", "polar data off"),
    modal(160, kGroupPolarData, kSim, "nct-5.4-G16 nct-5.4-multi nct-5.4-excl", "polar data"),
    modal(170, kGroupPlane, kSim, "nct-3-G17 nct-10.4-G17", "plane XY"),
    modal(180, kGroupPlane, kSim, "nct-3-G18 nct-10.4-G18", "plane ZX"),
    modal(190, kGroupPlane, kSim, "nct-3-G19 nct-10.4-G19", "plane YZ"),
    modal(200, kGroupUnits, kSim, "nct-5.2-G20", "inch data"),
    modal(210, kGroupUnits, kSim, "nct-5.2-G21", "metric data"),
    action(280, kOneShot, kSim, kAxes, planReference, true, "nct-3-G28 nct-9.1-G28",
           "to the reference point by way of an intermediate point"),
    action(300, kOneShot, kSim, "XYZUVWP", planReference, true, "nct-3-G30 nct-9.2-G30",
           "to reference point 1 to 4 by way of an intermediate point"),
    action(330, kGroupMotion, kSim, "XYZUVWEQ", planThread, false,
           "nct-1.1-E nct-1.1-Q nct-4.4-G33 nct-4.4-F nct-4.4-E nct-4.4-Q nct-4.4-chain",
           "thread of constant lead"),
    modal(610, kGroupCutting, kTime, "nct-3-G61 nct-6.3.2-G61", "exact stop mode"),
    modal(620, kGroupCutting, kTime, "nct-3-G62 nct-6.3.5-G62", "feed reduction at inside corners"),
    modal(630, kGroupCutting, kTime, "nct-3-G63 nct-6.3.4-G63", "overrides off"),
    modal(640, kGroupCutting, kTime, "nct-3-G64 nct-6.3.3-G64", "continuous cutting"),
    modal(900, kGroupDistance, kSim, "nct-5.1-G90", "absolute data"),
    modal(910, kGroupDistance, kSim, "nct-5.1-G91", "incremental data"),
    modal(940, kGroupFeedMode, kTime, "nct-3-G94 nct-6.2.1-G94", "feed per minute"),
    modal(950, kGroupFeedMode, kTime, "nct-3-G95 nct-6.2.1-G95", "feed per turn"),
});

constexpr auto kMotionFeatures = std::to_array<FeatureRow>({
    {"acceleration", kTime,
     "nct-7-acc nct-7.1-corner nct-7.2-normal nct-7.3-jump nct-4.5-N0305 nct-4.1.2-ROL nct-4.1.2-N0422 "
     "nct-4.1.1-PCH nct-4.1.1-N0516 nct-4.1.1-N1340 nct-6.4-inside-arc",
     "look-ahead of speeds: accelerations, corners, arcs, overlap of rapids"},
    {"operator", kHost, "nct-4.1.1-2501 nct-6.1-override nct-6.2-override",
     "override switches stand at 100 %; axes are always in position"},
    {"X Y Z", kSim, "nct-1.1-XYZUVW nct-2.1-names", "main axes"},
    {"I operator", kSim, "nct-5.1-I", "one word incremental: XI10"},
    {"U V W", kSim, "nct-5.1-UVW", "incremental X, Y, Z"},
    {"F", kTime, "nct-1.1-F nct-4.2-F nct-6.2-F", "feed"},
    {"R", kSim, "nct-1.1-R", "radius, level, angle, value"},
    {"I J K", kSim, "nct-1.1-IJK", "centre, vector, shift, factors"},
    {"L", kSim, "nct-1.1-L", "repeats, turns"},
    {"P", kTime, "nct-1.1-P", "dwell, number, factor"},
    {"groups", kState, "nct-1.1-G nct-3-group nct-3-poweron nct-3-N1300 nct-1.3-modal",
     "modal groups and their power-on codes"},
    {"arc settings", kSim, "nct-4.3-N1339 nct-4.3-CCA nct-4.3.2-HEF",
     "radius tolerance, absolute centre, helix feed"},
    {"thread errors", kReject, "nct-4.4-2021", "2021 thread cutting definition error"},
    {"planes", kSim, "nct-2.1-N0103 nct-4.5-plane nct-4.6-plane",
     "parallel and rotary axes beside G17, G18, G19"},
    {"virtual planes", kSim, "nct-4.5-arc nct-4.5-comp nct-4.5-N0217 nct-4.6-R nct-4.6-comp",
     "arcs and cutter compensation during G12.1 and G7.1"},
    {"polar feed", kTime, "nct-4.5-feed", "highest feed of the rotary axis near the centre of G12.1"},
    {"virtual limits", kReject, "nct-4.5-forbid nct-4.6-forbid", "codes that G12.1 and G7.1 exclude"},
    {"diameter", kSim, "nct-5.3-DIA nct-5.3-N0106-0 nct-5.3.1-N0106-5", "words of an axis as diameters"},
    {"turns", kSim,
     "nct-5.6-basic nct-5.6-short nct-5.6-sign nct-5.6-inc nct-5.6-N0106-1 nct-5.6-N0107 nct-5.6-N0108",
     "rotary axes that count within one turn"},
    {"axis names", kSim, "nct-2.2-N0100 nct-2.1-number nct-2.4-units",
     "names and kinds of axes by parameter"},
    {"smoothing", kState,
     "nct-4.7-N3100 nct-4.7-N3101 nct-4.7-N3102 nct-4.7-N3103 nct-4.7-N3104 nct-4.7-N3105 nct-4.7.1-N3106 "
     "nct-4.7.1-N3107",
     "tolerances of smoothing, told with the mode"},
    {"2188", kReject, "nct-4.7.1-2188", "length compensation changed during fine smoothing"},
    {"axis units", kHost, "nct-2.4-N0104 nct-2.4-N0105",
     "encoder units and decimals of the display: no effect"},
    {"2012", kReject, "nct-4.3-2012", "circle radius difference error"},
    {"2015", kReject, "nct-4.3-2015", "circle definition error"},
    {"A B C", kSim, "nct-1.1-ABC", "words of further axes"},
    {"name=", kSim, "nct-2.2-extname", "axis names of more than one character"},
});

}  // namespace

CodeTable motionTable() { return {kMotionGCodes, {}, kMotionFeatures}; }

}  // namespace proveout::nc
