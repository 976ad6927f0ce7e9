// Five axes; gear functions are refused.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kRotaryGCodes = std::to_array<GCode>({
    modal(431, kGroupLengthComp, kSim,
          "nct-3-G43.1 nct-25.2-G43.1 nct-25.2-G49 nct-25.2-FOS nct-25.2-PATH nct-25.2-V nct-25.2-ALONE",
          "length compensation along the tool axis", {}, true),
    modal(
        434, kGroupLengthComp, kSim,
        "nct-3-G43.4 nct-25.14-G43.4 nct-25.14-F nct-25.14-G49 nct-25.14-LAW nct-25.14-FRAME nct-25.14-G0G1 "
        "nct-25.16-G43.4P1 nct-25.16-P0 nct-25.16-LOAD nct-25.16-2192",
        "tool centre point control 1", "P", true),
    modal(435, kGroupLengthComp, kSim,
          "nct-3-G43.5 nct-25.14-G43.5 nct-25.14-G02G03 nct-25.14-IJK nct-25.14-ROT nct-25.16-G43.5P1 "
          "nct-25.16-ARC nct-25.16-PLANE nct-25.16-PAIR",
          "tool centre point control 2", "PIJK", true),
    refused(438, kGroupLengthComp, kSim, "nct-3-G43.8", "cutting point control 1"),
    refused(439, kGroupLengthComp, kSim, "nct-3-G43.9", "cutting point control 2"),
    action(
        531, kOneShot, kSim, {}, planToolDirection, true,
        "nct-3-G53.1 nct-25.11-G53.1 nct-25.11-FOS nct-25.11-SEL nct-25.11-ALONE nct-25.11-HH nct-25.11-TT "
        "nct-25.11-HT nct-25.11-MID",
        "turn rotary axes to the tool direction"),
    action(536, kOneShot, kSim, "XYZR", planToolDirectionAboutTip, true,
           "nct-3-G53.6 nct-25.15-G53.6 nct-25.15-BUF nct-25.15-R nct-25.15-XYZ nct-25.15-H nct-25.15-2003 "
           "nct-25.15-2019 nct-25.15-2042",
           "turn rotary axes, tool centre held"),
    action(681, kGroupTilt, kSim, "XYZUVWIJKR", planSpaceRotation, true,
           "nct-3-G68.1 nct-25.3-G68.1 nct-25.3-ABS nct-25.3-TWO", "three-dimensional transformation"),
    action(682, kGroupTilt, kSim, "XYZUVWIJKRPQ", planTiltedPlane, true,
           "nct-3-G68.2 nct-25.6-G68.2 nct-25.7-G68.2P1 nct-25.8-G68.2P2 nct-25.8-G68.2P2Q0 nct-25.9-G68.2P3 "
           "nct-25.10-G68.2P4 nct-25.13-ORDER nct-25.7-2039 nct-25.8-2039 nct-25.8-2064 nct-25.8-2088 "
           "nct-25.9-2039 nct-25.9-2064 nct-25.9-2088 nct-25.10-2088",
           "inclined plane"),
    modal(691, kGroupTilt, kSim, "nct-3-G69.1 nct-25.3-G69.1 nct-25.6-G69.1",
          "three-dimensional transformation off", {}, true),
    refused(808, kGroupGear, kState, "nct-3-G80.8", "electronic gear off", true),
    refused(818, kGroupGear, kReject, "nct-3-G81.8", "electronic gear"),
});

constexpr auto kRotaryFeatures = std::to_array<FeatureRow>({
    {"positions", kSim,
     "nct-25.19-PCS nct-25.19-TLC nct-25.19-5041 nct-25.19-5061 nct-25.19-151001 nct-25.19-151101 "
     "nct-25.19-151xxx",
     "#5041, #5061, #151001 and #151101 on tilted planes and with lengths along the tool"},
    {"directions", kReject, "nct-25-UNREACH", "a direction that no position of the rotary axes has"},
});

}  // namespace

CodeTable rotaryTable() { return {kRotaryGCodes, {}, kRotaryFeatures}; }

}  // namespace proveout::nc
