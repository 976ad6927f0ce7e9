// Motion, feed, planes and units.
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucMotionTableG = std::to_array<GCode>({
    action(0, kGroupMotion, kSim, "XYZUVWa", planRapid, false, "fan-3-G00", "rapid positioning"),
    action(10, kGroupMotion, kSim, "XYZUVWacr", planLine, false, "fan-3-G01", "linear interpolation"),
    action(20, kGroupMotion, kSim, "XYZUVWIJKRQLcr", planFanucArc, false,
           "fan-3-G02 fan-3-arcR fan-3-fullcircle fan-3-helix fan-3-spiral", "circle, helix, clockwise"),
    action(30, kGroupMotion, kSim, "XYZUVWIJKRQLcr", planFanucArc, false,
           "fan-3-G03 fan-3-arcR fan-3-fullcircle fan-3-helix fan-3-spiral",
           "circle, helix, counter-clockwise"),
    action(22, kGroupMotion, kSim, "XYZUVWIJKR", planInvolute, false, "fan-3-G02.2", "involute, clockwise"),
    action(32, kGroupMotion, kSim, "XYZUVWIJKR", planInvolute, false, "fan-3-G02.2",
           "involute, counter-clockwise"),
    refused(23, kGroupMotion, kReject, "fan-3-G02.3", "exponential interpolation"),
    refused(33, kGroupMotion, kReject, "fan-3-G02.3", "exponential interpolation"),
    action(24, kGroupMotion, kSim, "XYZUVW", planSpaceArc, false, "fan-3-G02.4", "arc in space"),
    action(34, kGroupMotion, kSim, "XYZUVW", planSpaceArc, false, "fan-3-G02.4", "arc in space"),
    action(40, kOneShot, kTime, "PXU", planFanucDwell, false, "fan-4-G04 fan-3-G09",
           "dwell; alone an exact stop"),
    action(50, kOneShot, kTime, "PQR", planLookAhead, false, "fan-3-G05P", "high-speed modes"),
    action(51, kOneShot, kTime, "XYZUVWPQR", planLookAhead, false, "fan-3-G05.1", "look-ahead modes"),
    action(62, kGroupMotion, kSim, "XYZUVWKRP", planNurbs, false, "fan-3-G06.2", "NURBS interpolation"),
    action(71, kOneShot, kSim, kAxes, planFanucCylinder, false, "fan-3-G07.1", "cylindrical interpolation"),
    action(80, kOneShot, kTime, "P", planLookAhead, false, "fan-3-G08", "advanced preview"),
    modal(90, kOneShot, kTime, "fan-3-G09", "exact stop in this block"),
    action(106, kOneShot, kHost, "XYZUVWPR", planNoted, false, "fan-3-G10.6", "tool retract and recover"),
    action(121, kGroupPolarInterpolation, kSim, {}, planFanucPolarOn, false, "fan-3-G12.1",
           "polar interpolation"),
    action(131, kGroupPolarInterpolation, kSim, {}, planFanucPolarOff, false, "fan-3-G13.1",
           "polar interpolation off"),
    writtenAs(1070, action(71, kOneShot, kSim, kAxes, planFanucCylinder, false, "fan-3-G07.1",
                           "cylindrical interpolation")),
    writtenAs(1120, action(121, kGroupPolarInterpolation, kSim, {}, planFanucPolarOn, false, "fan-3-G12.1",
                           "polar interpolation")),
    writtenAs(1130, action(131, kGroupPolarInterpolation, kSim, {}, planFanucPolarOff, false, "fan-3-G13.1",
                           "polar interpolation off")),
    modal(150, kGroupPolarData, kSim, "fan-9-G15", "polar data off"),
    modal(160, kGroupPolarData, kSim, "fan-9-G16", "polar data"),
    modal(170, kGroupPlane, kSim, "fan-5-G17", "plane XY"),
    modal(180, kGroupPlane, kSim, "fan-5-G18", "plane ZX"),
    modal(190, kGroupPlane, kSim, "fan-5-G19", "plane YZ"),
    modal(200, kGroupUnits, kSim, "fan-5-G20", "inch data"),
    modal(210, kGroupUnits, kSim, "fan-5-G21", "metric data"),
    action(270, kOneShot, kSim, "XYZUVWP", planReferenceCheck, true, "fan-5-G27", "reference point check"),
    action(280, kOneShot, kSim, kAxes, planFanucReference, true, "fan-5-G28 fan-5-G28none",
           "to reference point 1 by way of an intermediate point"),
    action(290, kOneShot, kSim, kAxes, planFromReference, true, "fan-5-G29",
           "from the reference point by way of the intermediate point"),
    action(300, kOneShot, kSim, "XYZUVWP", planFanucReference, true, "fan-5-G30",
           "to reference point 2 to 4 by way of an intermediate point"),
    action(330, kGroupMotion, kSim, "XYZUVWQcr", planFanucThread, false, "fan-3-G33",
           "thread of constant lead"),
    action(600, kOneShot, kSim, kAxes, planOneDirection, false, "fan-3-G60", "single direction positioning"),
    modal(610, kGroupCutting, kTime, "fan-3-G61", "exact stop mode"),
    modal(620, kGroupCutting, kTime, "fan-3-G62", "feed reduction at inside corners"),
    modal(630, kGroupCutting, kTime, "fan-3-G63", "overrides off"),
    modal(640, kGroupCutting, kTime, "fan-3-G64", "continuous cutting"),
    modal(900, kGroupDistance, kSim, "fan-5-G90", "absolute data"),
    modal(910, kGroupDistance, kSim, "fan-5-G91", "incremental data"),
    modal(930, kGroupFeedMode, kTime, "fan-4-G93", "inverse time feed"),
    modal(940, kGroupFeedMode, kTime, "fan-4-G94", "feed per minute"),
    modal(950, kGroupFeedMode, kTime, "fan-4-G95", "feed per turn"),
    modal(960, kGroupSurfaceSpeed, kTime, "fan-4-G96", "constant surface speed", "P"),
    modal(970, kGroupSurfaceSpeed, kTime, "fan-4-G97", "constant surface speed off"),
});

constexpr auto kFanucMotionTableM = std::to_array<MCode>({
    {48, MPhase::kBefore, 0, kHost, {}, "fan-4-override", "overrides on"},
    {49, MPhase::kBefore, 0, kHost, {}, "fan-4-override", "overrides off"},
});

constexpr auto kFanucMotionTableFeatures = std::to_array<FeatureRow>({
    {"arc tolerance", kReject, "fan-3-arctol", "end off the circle by more than arc_radius_tolerance"},
    {"arc words", kReject, "fan-3-arcmissing", "an arc without a centre, or with one across the plane"},
    {",C", kSim, "fan-3-chamfer", "chamfer between two blocks"},
    {",R", kSim, "fan-3-corner", "corner between two blocks"},
    {",C ,R errors", kReject, "fan-3-cornererr", "chamfers and corners that do not fit"},
    {"F0", kReject, "fan-4-F0", "a motion by feed without F"},
    {"S", kState, "fan-4-S", "spindle speed"},
    {"G92 S", kTime, "fan-4-G92S", "limit of the spindle's speed"},
    {"G17 U", kSim, "fan-5-parallel", "planes with parallel axes"},
    {"machine.zero", kSim, "fan-5-nomachine", "reference moves without a machine zero in the job"},
    {"length at G28 G53", kSim, "fan-5-lengthsuspend", "length offset that a reference move ends"},
});

}  // namespace

CodeTable fanucMotionTable() { return {kFanucMotionTableG, kFanucMotionTableM, kFanucMotionTableFeatures}; }

}  // namespace proveout::nc
