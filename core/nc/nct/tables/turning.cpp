// Turning cycles: refused.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kTurningGCodes = std::to_array<GCode>({
    refused(707, kOneShot, kSim, "nct-3-G70.7", "turning: finishing cycle"),
    refused(717, kOneShot, kSim, "nct-3-G71.7", "turning: roughing cycle"),
    refused(727, kOneShot, kSim, "nct-3-G72.7", "turning: face roughing cycle"),
    refused(737, kOneShot, kSim, "nct-3-G73.7", "turning: pattern repeating cycle"),
    refused(747, kOneShot, kSim, "nct-3-G74.7", "turning: face grooving cycle"),
    refused(757, kOneShot, kSim, "nct-3-G75.7", "turning: grooving cycle"),
    refused(767, kOneShot, kSim, "nct-3-G76.7", "turning: threading cycle"),
    refused(777, kGroupMotion, kSim, "nct-3-G77.7", "turning: longitudinal cycle"),
    refused(787, kGroupMotion, kSim, "nct-3-G78.7", "turning: simple threading cycle"),
    refused(797, kGroupMotion, kSim, "nct-3-G79.7", "turning: face cycle"),
});

}  // namespace

CodeTable turningTable() { return {kTurningGCodes, {}, {}}; }

}  // namespace proveout::nc
