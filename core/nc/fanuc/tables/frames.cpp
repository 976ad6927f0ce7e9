// Work frames, machine moves, measuring, stored stroke check.
#include "core/nc/fanuc/frames/frames.h"

#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucFramesTableG = std::to_array<GCode>({
    action(100, kOneShot, kSim, "LPXYZUVWIJKRQ", planFanucDataInput, false,
           "fan-6-G10L2 fan-6-EXT fan-6-G10L20 fan-6-G10L10 fan-6-G10L11 fan-6-G10L12 fan-6-G10L13 "
           "fan-6-G10L50 fan-6-G10L3",
           "data input"),
    action(110, kOneShot, kState, {}, planEndOfData, false, "", "end of data input"),
    action(220, kGroupZones, kSim, "XYZIJK", planZoneOn, true, "fan-5-G22", "stored stroke check"),
    action(230, kGroupZones, kSim, {}, planZoneOff, true, "fan-5-G23", "stored stroke check off"),
    action(310, kOneShot, kSim, "XYZUVWP", planFanucSkip, true, "fan-3-G31 fan-3-G31P",
           "skip: ends at the first contact"),
    action(520, kOneShot, kSim, kAxes, planLocalShift, true, "fan-6-G52", "local coordinate system"),
    action(530, kOneShot, kSim, kAxes, planFanucMachineMove, true, "fan-5-G53",
           "one block in machine coordinates"),
    modal(540, kGroupWorkSystem, kSim, "fan-6-G54", "work system 1", {}, true),
    modal(541, kGroupWorkSystem, kSim, "fan-6-G54.1", "additional work systems", "P", true),
    modal(550, kGroupWorkSystem, kSim, "fan-6-G54", "work system 2", {}, true),
    modal(560, kGroupWorkSystem, kSim, "fan-6-G54", "work system 3", {}, true),
    modal(570, kGroupWorkSystem, kSim, "fan-6-G54", "work system 4", {}, true),
    modal(580, kGroupWorkSystem, kSim, "fan-6-G54", "work system 5", {}, true),
    modal(590, kGroupWorkSystem, kSim, "fan-6-G54", "work system 6", {}, true),
    action(920, kOneShot, kSim, kAxes, planSetPosition, true, "fan-6-G92",
           "coordinates of the present position"),
    action(921, kOneShot, kSim, kAxes, planShiftsOff, true, "fan-6-G92.1", "shifts of G52 and G92 end"),
});

}  // namespace

CodeTable fanucFramesTable() { return {kFanucFramesTableG, {}, {}}; }

}  // namespace proveout::nc
