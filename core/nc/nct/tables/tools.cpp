// Tools and coolant.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kToolsMCodes = std::to_array<MCode>({
    {6, MPhase::kAfter, 0, kSim, {}, "nct-12.2-M6 nct-12.1-T", "tool change"},
    {8, MPhase::kBefore, kCoolantCodes, kState, {}, "nct-13.1-M8", "coolant on"},
    {9, MPhase::kAfter, kCoolantCodes, kState, {}, "nct-13.1-M9", "coolant off"},
});

constexpr auto kToolsFeatures = std::to_array<FeatureRow>({
    {"T", kSim, "nct-1.1-T nct-12.1-T nct-12.2-manual", "tool number"},
    {"tool management", kState,
     "nct-12.3.1-table nct-12.3.1-select nct-12.3.1-warning nct-12.3.2-location nct-12.3.3-shape "
     "nct-12.5.1-H99 "
     "nct-15.1-N2923 nct-12.5.2-M62",
     "tables of tools, places and shapes; life; offsets of the tool in the spindle"},
    {"G10 L75 L76 L77", kState,
     "nct-12.4.1-G10L75P1 nct-12.4.2-G10L75P2 nct-12.4.3-G10L75P3 nct-12.4.4-G10L76P1 nct-12.4.5-G10L77P6 "
     "nct-12.4-G11",
     "tool management filled by programs"},
    {"#8400", kState,
     "nct-12.5.3-8400 nct-23.1.20-#8400 nct-23.1.20-#8401 nct-23.1.20-#8402 nct-23.1.20-#8403 "
     "nct-23.1.20-#8404 "
     "nct-23.1.20-#8405 nct-23.1.20-#8406 nct-23.1.20-#8407 nct-23.1.20-#8408 nct-23.1.20-#8409 "
     "nct-23.1.20-#8410 nct-23.1.20-#8411 nct-23.1.20-#8412 nct-23.1.20-#8413 nct-23.1.20-#8414 "
     "nct-23.1.20-#8431",
     "data of the tool in the spindle"},
});

}  // namespace

CodeTable toolsTable() { return {{}, kToolsMCodes, kToolsFeatures}; }

}  // namespace proveout::nc
