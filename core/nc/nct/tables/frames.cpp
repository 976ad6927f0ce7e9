// Work systems, shifts, data input.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFramesGCodes = std::to_array<GCode>({
    action(100, kOneShot, kSim, "LPXYZUVWIJKRQ", planDataInput, false,
           "nct-3-G10 nct-10.2.4-G10L2 nct-10.2.5-G10L20 nct-15.2-G10-L10 nct-15.2-G10-L11 nct-15.2-G10-L12 "
           "nct-15.2-G10-L13 nct-15.2-G10-L110 nct-15.2-G10-L111 nct-15.2-G10-L200 nct-15.2-G10-L201 "
           "nct-15.2-G10-L202 nct-15.2-G10-L203 nct-15.2-G90-G91-I nct-24.1-G10L52 nct-24.1-RI nct-24-kinds",
           "data input: L2, L20 work offsets, L10 to L13, L110, L111, L200 to L203 tool offsets, L52 "
           "parameters"),
    action(110, kOneShot, kState, {}, planEndOfData, false, "nct-3-G11 nct-24.1-G11", "end of data input"),
    action(520, kOneShot, kSim, kAxes, planLocalShift, true, "nct-3-G52 nct-10.3-G52",
           "local coordinate system"),
    action(530, kOneShot, kSim, kAxes, planMachineMove, true, "nct-3-G53 nct-10.1.1-G53 nct-10.1.1-G53-sync",
           "rapid to a machine position"),
    modal(540, kGroupWorkSystem, kSim, "nct-3-G54 nct-10.2.1-G54", "work system 1", {}, true),
    modal(541, kGroupWorkSystem, kSim, "nct-3-G54.1 nct-10.2.2-G54.1", "extended work systems P1 to P99", "P",
          true),
    modal(542, kGroupWorkSystem, kSim,
          "nct-3-G54.2 nct-25.4-G54.2 nct-25.4-FOS nct-25.4-LIN nct-25.4-G0 nct-25.4-END nct-25.4-V0 "
          "nct-25.4-MECH",
          "dynamic zero offset", "P", true),
    modal(550, kGroupWorkSystem, kSim, "nct-3-G55 nct-10.2.1-G55", "work system 2", {}, true),
    modal(560, kGroupWorkSystem, kSim, "nct-3-G56 nct-10.2.1-G56", "work system 3", {}, true),
    modal(570, kGroupWorkSystem, kSim, "nct-3-G57 nct-10.2.1-G57", "work system 4", {}, true),
    modal(580, kGroupWorkSystem, kSim, "nct-3-G58 nct-10.2.1-G58", "work system 5", {}, true),
    modal(590, kGroupWorkSystem, kSim, "nct-3-G59 nct-10.2.1-G59", "work system 6", {}, true),
    action(920, kOneShot, kSim, kAxes, planSetPosition, true, "nct-3-G92 nct-10.2.6-G92",
           "coordinates of the present position"),
});

constexpr auto kFramesFeatures = std::to_array<FeatureRow>({
    {"work offsets", kSim, "nct-10.2.1-common nct-10.2.3-rotation nct-1.3-WCS",
     "common offset, basic rotation"},
    {"offset table", kSim,
     "nct-15.1-table-mill nct-15.1-table-turn nct-15.1-Q nct-15.1-N1400 nct-15.1-N1401 nct-15.1-N1416-TOL "
     "nct-15.1-N1415 nct-15.2-N1402-DIA",
     "length, radius, corner radius, turning lengths, geometry and wear"},
});

}  // namespace

CodeTable framesTable() { return {kFramesGCodes, {}, kFramesFeatures}; }

}  // namespace proveout::nc
