// Rotation, scaling, mirroring.
#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucTransformsTableG = std::to_array<GCode>({
    modal(500, kGroupScaling, kSim, "fan-9-G50", "scaling off"),
    action(501, kGroupMirror, kSim, kAxes, planFanucMirrorOff, false, "fan-9-G50.1", "mirroring off"),
    action(510, kGroupScaling, kSim, "XYZUVWIJKP", planFanucScaling, false, "fan-9-G51 fan-9-G51arc",
           "scaling"),
    action(511, kGroupMirror, kSim, kAxes, planFanucMirror, false, "fan-9-G51.1 fan-9-order fan-9-mirrorcomp",
           "mirroring"),
    action(680, kGroupRotation, kSim, "XYZUVWR", planFanucRotation, false, "fan-9-G68 fan-9-G68inc",
           "rotation in the plane"),
    modal(690, kGroupRotation, kSim, "fan-9-G69", "rotation off"),
});

}  // namespace

CodeTable fanucTransformsTable() { return {kFanucTransformsTableG, {}, {}}; }

}  // namespace proveout::nc
