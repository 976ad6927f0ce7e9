// Rotation, scaling, mirroring, contour aids.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kTransformsGCodes = std::to_array<GCode>({
    modal(500, kGroupScaling, kSim, "nct-3-G50 nct-16.2-G50", "scaling off"),
    action(501, kGroupMirror, kSim, kAxes, planMirrorOff, false, "nct-3-G50.1 nct-16.3-G50.1",
           "mirroring off"),
    action(510, kGroupScaling, kSim, "XYZUVWIJKP", planScaling, false,
           "nct-3-G51 nct-16.2-G51-P nct-16.2-G51-IJK", "scaling"),
    action(511, kGroupMirror, kSim, kAxes, planMirror, false, "nct-3-G51.1 nct-16.3-G51.1", "mirroring"),
    action(680, kGroupRotation, kSim, "XYZUVWR", planRotation, false, "nct-3-G68 nct-16.1-G68",
           "rotation in the plane"),
    modal(690, kGroupRotation, kSim, "nct-3-G69 nct-16.1-G69", "rotation off"),
});

constexpr auto kTransformsFeatures = std::to_array<FeatureRow>({
    {"transforms", kSim, "nct-16.4-order", "nesting of mirroring, scaling and rotation"},
    {"2001", kReject, "nct-16.3-2001", "mirroring switched in G51 or G68"},
    {",C", kSim, "nct-1.1-commaC nct-17.1-C", "chamfer between two blocks"},
    {",R", kSim, "nct-1.1-commaR nct-17.1-R", "rounding between two blocks"},
    {",A", kSim, "nct-1.1-commaA nct-17.2-A", "direction angle of a line"},
    {"crossings", kSim,
     "nct-17.3-overdet nct-17.3.1-LL nct-17.3.2-LA nct-17.3.3-AL nct-17.3.4-AA nct-17.3.5-chain",
     "corner of two blocks as the intersection of lines and circles"},
    {"2082", kReject, "nct-17.1-2082", "chamfer and rounding in one block"},
    {"2085", kReject, "nct-17.1-2085", "chamfer or rounding out of the plane"},
    {"too large", kReject, "nct-17.1-large", "chamfer or rounding that does not fit"},
});

}  // namespace

CodeTable transformsTable() { return {kTransformsGCodes, {}, kTransformsFeatures}; }

}  // namespace proveout::nc
