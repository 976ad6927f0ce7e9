// Measuring and working areas.
#include "core/nc/nct/nct_plans.h"
#include "core/nc/nct/tables/rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kG = std::to_array<GCode>({
    refused(220, kGroupZones, kSim, "nct-3-G22", "programmed working-area limit"),
    modal(230, kGroupZones, kSim, "nct-3-G23", "programmed working-area limit off", {}, true),
    refused(310, kOneShot, kSim, "nct-3-G31", "skip measuring move"),
    refused(370, kOneShot, kHost, "nct-3-G37", "tool length measurement"),
});

}  // namespace

CodeTable measuringTable() { return {kG, {}, {}}; }

}  // namespace proveout::nc
