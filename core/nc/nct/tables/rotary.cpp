// Five axes and gear functions: refused.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kRotaryGCodes = std::to_array<GCode>({
    refused(431, kGroupLengthComp, kSim, "nct-3-G43.1", "length compensation along the tool axis"),
    refused(434, kGroupLengthComp, kSim, "nct-3-G43.4", "tool centre point control 1"),
    refused(435, kGroupLengthComp, kSim, "nct-3-G43.5", "tool centre point control 2"),
    refused(438, kGroupLengthComp, kSim, "nct-3-G43.8", "cutting point control 1"),
    refused(439, kGroupLengthComp, kSim, "nct-3-G43.9", "cutting point control 2"),
    refused(531, kOneShot, kSim, "nct-3-G53.1", "turn rotary axes to the tool direction"),
    refused(536, kOneShot, kSim, "nct-3-G53.6", "turn rotary axes, tool centre held"),
    refused(681, kGroupTilt, kSim, "nct-3-G68.1", "three-dimensional transformation"),
    refused(682, kGroupTilt, kSim, "nct-3-G68.2", "inclined plane"),
    modal(691, kGroupTilt, kSim, "nct-3-G69.1", "three-dimensional transformation off"),
    refused(808, kGroupGear, kState, "nct-3-G80.8", "electronic gear off", true),
    refused(818, kGroupGear, kReject, "nct-3-G81.8", "electronic gear"),
});

}  // namespace

CodeTable rotaryTable() { return {kRotaryGCodes, {}, {}}; }

}  // namespace proveout::nc
