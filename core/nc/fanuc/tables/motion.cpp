// Motion, feed, planes and units.
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucMotionTableG = std::to_array<GCode>({
    action(0, kGroupMotion, kSim, "XYZUVWa", planRapid, false, "fan-3-G00", "rapid positioning"),
    action(10, kGroupMotion, kSim, "XYZUVWacr", planLine, false, "fan-3-G01", "linear interpolation"),
    action(20, kGroupMotion, kSim, "XYZUVWIJKRcr", planArc, false, "fan-3-G02", "circle, helix, clockwise"),
    action(30, kGroupMotion, kSim, "XYZUVWIJKRcr", planArc, false, "fan-3-G03",
           "circle, helix, counter-clockwise"),
    action(40, kOneShot, kTime, "PXU", planDwell, false, "fan-4-G04", "dwell"),
    action(71, kOneShot, kSim, kAxes, planCylinder, false, "fan-3-G07.1", "cylindrical interpolation"),
    modal(90, kOneShot, kTime, "fan-3-G09", "exact stop in this block"),
    action(121, kGroupPolarInterpolation, kSim, {}, planPolarOn, false, "fan-3-G12.1", "polar interpolation"),
    action(131, kGroupPolarInterpolation, kSim, {}, planPolarOff, false, "fan-3-G13.1",
           "polar interpolation off"),
    modal(150, kGroupPolarData, kSim, "fan-9-G15", "polar data off"),
    modal(160, kGroupPolarData, kSim, "fan-9-G16", "polar data"),
    modal(170, kGroupPlane, kSim, "fan-5-G17", "plane XY"),
    modal(180, kGroupPlane, kSim, "fan-5-G18", "plane ZX"),
    modal(190, kGroupPlane, kSim, "fan-5-G19", "plane YZ"),
    modal(200, kGroupUnits, kSim, "fan-5-G20", "inch data"),
    modal(210, kGroupUnits, kSim, "fan-5-G21", "metric data"),
    action(280, kOneShot, kSim, kAxes, planReference, true, "fan-5-G28",
           "to reference point 1 by way of an intermediate point"),
    action(300, kOneShot, kSim, "XYZUVWP", planReference, true, "fan-5-G30",
           "to reference point 2 to 4 by way of an intermediate point"),
    action(330, kGroupMotion, kSim, "XYZUVWQ", planThread, false, "fan-3-G33", "thread of constant lead"),
    modal(610, kGroupCutting, kTime, "fan-3-G61", "exact stop mode"),
    modal(620, kGroupCutting, kTime, "fan-3-G62", "feed reduction at inside corners"),
    modal(630, kGroupCutting, kTime, "fan-3-G63", "overrides off"),
    modal(640, kGroupCutting, kTime, "fan-3-G64", "continuous cutting"),
    modal(900, kGroupDistance, kSim, "fan-5-G90", "absolute data"),
    modal(910, kGroupDistance, kSim, "fan-5-G91", "incremental data"),
    modal(940, kGroupFeedMode, kTime, "fan-4-G94", "feed per minute"),
    modal(950, kGroupFeedMode, kTime, "fan-4-G95", "feed per turn"),
    modal(960, kGroupSurfaceSpeed, kTime, "fan-4-G96", "constant surface speed"),
    modal(970, kGroupSurfaceSpeed, kTime, "fan-4-G97", "constant surface speed off"),
});

constexpr auto kFanucMotionTableFeatures = std::to_array<FeatureRow>({
    {"arc tolerance", kReject, "fan-3-arctol", "end off the circle by more than arc_radius_tolerance"},
});

}  // namespace

CodeTable fanucMotionTable() { return {kFanucMotionTableG, {}, kFanucMotionTableFeatures}; }

}  // namespace proveout::nc
