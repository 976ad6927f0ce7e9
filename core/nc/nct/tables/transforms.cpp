// Rotation, scaling, mirroring, contour aids.
#include "core/nc/nct/nct_plans.h"
#include "core/nc/nct/tables/rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kG = std::to_array<GCode>({
    modal(500, kGroupScaling, kSim, "nct-16.2-G50", "scaling off"),
    modal(501, kGroupMirror, kSim, "nct-16.3-G50.1", "mirroring off", "XYZ"),
    refused(510, kGroupScaling, kSim, "nct-16.2-G51-P nct-16.2-G51-IJK", "scaling"),
    refused(511, kGroupMirror, kSim, "nct-16.3-G51.1", "mirroring"),
    refused(680, kGroupRotation, kSim, "nct-16.1-G68", "rotation in the plane"),
    modal(690, kGroupRotation, kSim, "nct-16.1-G69", "rotation off"),
});

constexpr auto kFeatures = std::to_array<FeatureRow>({
    {",C", kSim, "nct-1.1-commaC nct-17.1-C", "chamfer between two blocks", false},
    {",R", kSim, "nct-1.1-commaR nct-17.1-R", "rounding between two blocks", false},
    {",A", kSim, "nct-1.1-commaA nct-17.2-A", "direction angle of a line", false},
});

}  // namespace

CodeTable transformsTable() { return {kG, {}, kFeatures}; }

}  // namespace proveout::nc
