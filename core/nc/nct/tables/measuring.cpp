// Measuring and working areas.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kMeasuringGCodes = std::to_array<GCode>({
    action(220, kGroupZones, kSim, "XYZIJKP", planZoneOn, true, "nct-3-G22 nct-22.2-G22",
           "working-area limit of the program"),
    action(230, kGroupZones, kSim, {}, planZoneOff, true, "nct-3-G23 nct-22.2-G23",
           "working-area limit of the program off"),
    action(310, kOneShot, kSim, kAxes | AddressSet("PQ"), planSkip, true,
           "nct-3-G31 nct-21.1-G31 nct-21.2-G31P98", "measuring move, ends at the first contact"),
    action(370, kOneShot, kSim, kAxes, planToolLength, true, "nct-3-G37 nct-21.3-G37",
           "tool length measurement"),
});

constexpr auto kMeasuringFeatures = std::to_array<FeatureRow>({
    {"stroke limits", kSim, "nct-22.1-stroke", "ranges A and B of the parameters N1002 to N1005: 3010, 3011"},
    {"zone 2", kSim, "nct-22.2-param", "working-area limit of the parameters N1006, N1007: 3040 to 3042"},
    {"zone 3", kSim, "nct-22.3-zone3", "inner forbidden area of the parameters N1008, N1009: 3043"},
    {"N1001.CBM", kSim, "nct-22.4-CBM", "areas are looked at before a motion starts: 2056 to 2063"},
});

}  // namespace

CodeTable measuringTable() { return {kMeasuringGCodes, {}, kMeasuringFeatures}; }

}  // namespace proveout::nc
