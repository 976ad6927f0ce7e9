// Measuring and working areas.
#include "core/nc/nct/nct_plans.h"
#include "core/nc/nct/tables/rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kG = std::to_array<GCode>({
    refused(220, kGroupZones, kSim, "nct-3-G22", "programmed working-area limit"),
    modal(230, kGroupZones, kSim, "nct-3-G23", "programmed working-area limit off"),
    action(310, kOneShot, kSim, kAxes | AddressSet("PQ"), planSkip, true,
           "nct-3-G31 nct-21.1-G31 nct-21.2-G31P98", "measuring move, ends at the first contact"),
    action(370, kOneShot, kSim, kAxes, planToolLength, true, "nct-3-G37 nct-21.3-G37",
           "tool length measurement"),
});

}  // namespace

CodeTable measuringTable() { return {kG, {}, {}}; }

}  // namespace proveout::nc
