// Five axes (iso-fanuc, section 17).
#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucRotaryTableG = std::to_array<GCode>({
    modal(434, kGroupLengthComp, kSim, "fan-17-G43.4", "tool centre point control by angles", "P", true),
    modal(435, kGroupLengthComp, kSim, "fan-17-G43.5", "tool centre point control by a vector", "PIJK", true),
    action(531, kOneShot, kSim, {}, planToolDirection, true, "fan-17-G53.1",
           "rotary axes to the normal of the plane"),
    modal(542, kGroupWorkSystem, kSim, "fan-17-G54.2", "dynamic fixture offset", "P", true),
    action(682, kGroupTilt, kSim, "XYZUVWIJKRPQ", planFanucTiltedPlane, true, "fan-17-G68.2", "tilted plane"),
});

constexpr auto kFanucRotaryTableFeatures = std::to_array<FeatureRow>({
    {"A B C", kSim, "fan-17-abc", "rotary words"},
    {"kinematics", kReject, "fan-17-nokin", "five-axis codes in a job without heads and tables"},
});

}  // namespace

CodeTable fanucRotaryTable() { return {kFanucRotaryTableG, {}, kFanucRotaryTableFeatures}; }

}  // namespace proveout::nc
