// Tools and coolant.
#include "core/nc/nct/nct_plans.h"
#include "core/nc/nct/tables/rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kM = std::to_array<MCode>({
    {6, MPhase::kAfter, 0, kSim, {}, "nct-12.2-M6 nct-12.1-T", "tool change"},
    {8, MPhase::kBefore, kCoolantCodes, kState, {}, "nct-13.1-M8", "coolant on"},
    {9, MPhase::kAfter, kCoolantCodes, kState, {}, "nct-13.1-M9", "coolant off"},
});

constexpr auto kFeatures = std::to_array<FeatureRow>({
    {"T", kSim, "nct-1.1-T nct-12.1-T", "tool number"},
});

}  // namespace

CodeTable toolsTable() { return {{}, kM, kFeatures}; }

}  // namespace proveout::nc
