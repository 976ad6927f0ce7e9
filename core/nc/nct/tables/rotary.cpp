// Five axes; gear functions are refused.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kRotaryGCodes = std::to_array<GCode>({
    modal(431, kGroupLengthComp, kSim, "nct-3-G43.1 nct-25.2-G43.1 nct-25.2-G49 nct-25.2-FOS",
          "length compensation along the tool axis", {}, true),
    modal(434, kGroupLengthComp, kSim,
          "nct-3-G43.4 nct-25.14-G43.4 nct-25.14-F nct-25.14-G49 nct-25.16-G43.4P1 nct-25.16-P0",
          "tool centre point control 1", "P", true),
    modal(435, kGroupLengthComp, kSim,
          "nct-3-G43.5 nct-25.14-G43.5 nct-25.14-G02G03 nct-25.16-G43.5P1 nct-25.16-ARC",
          "tool centre point control 2", "PIJK", true),
    refused(438, kGroupLengthComp, kSim, "nct-3-G43.8", "cutting point control 1"),
    refused(439, kGroupLengthComp, kSim, "nct-3-G43.9", "cutting point control 2"),
    action(531, kOneShot, kSim, {}, planToolDirection, true,
           "nct-3-G53.1 nct-25.11-G53.1 nct-25.11-FOS nct-25.11-SEL",
           "turn rotary axes to the tool direction"),
    action(536, kOneShot, kSim, "XYZR", planToolDirectionAboutTip, true,
           "nct-3-G53.6 nct-25.15-G53.6 nct-25.15-BUF", "turn rotary axes, tool centre held"),
    action(681, kGroupTilt, kSim, "XYZUVWIJKR", planSpaceRotation, true, "nct-3-G68.1 nct-25.3-G68.1",
           "three-dimensional transformation"),
    action(682, kGroupTilt, kSim, "XYZUVWIJKRPQ", planTiltedPlane, true,
           "nct-3-G68.2 nct-25.6-G68.2 nct-25.7-G68.2P1 nct-25.8-G68.2P2 nct-25.8-G68.2P2Q0 nct-25.9-G68.2P3 "
           "nct-25.10-G68.2P4",
           "inclined plane"),
    modal(691, kGroupTilt, kSim, "nct-3-G69.1 nct-25.3-G69.1 nct-25.6-G69.1",
          "three-dimensional transformation off", {}, true),
    refused(808, kGroupGear, kState, "nct-3-G80.8", "electronic gear off", true),
    refused(818, kGroupGear, kReject, "nct-3-G81.8", "electronic gear"),
});

}  // namespace

CodeTable rotaryTable() { return {kRotaryGCodes, {}, {}}; }

}  // namespace proveout::nc
