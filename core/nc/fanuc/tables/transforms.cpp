// Rotation, scaling, mirroring.
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucTransformsTableG = std::to_array<GCode>({
    modal(500, kGroupScaling, kSim, "fan-9-G50", "scaling off"),
    action(501, kGroupMirror, kSim, kAxes, planMirrorOff, false, "fan-9-G50.1", "mirroring off"),
    action(510, kGroupScaling, kSim, "XYZUVWIJKP", planScaling, false, "fan-9-G51", "scaling"),
    action(511, kGroupMirror, kSim, kAxes, planMirror, false, "fan-9-G51.1", "mirroring"),
    action(680, kGroupRotation, kSim, "XYZUVWR", planRotation, false, "fan-9-G68", "rotation in the plane"),
    modal(690, kGroupRotation, kSim, "fan-9-G69", "rotation off"),
});

}  // namespace

CodeTable fanucTransformsTable() { return {kFanucTransformsTableG, {}, {}}; }

}  // namespace proveout::nc
