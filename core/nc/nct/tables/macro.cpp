// Program format and flow, subprograms, macro language.
#include "core/nc/nct/nct_plans.h"
#include "core/nc/nct/tables/rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kG = std::to_array<GCode>({
    refused(650, kOneShot, kSim, "nct-3-G65", "macro call"),
    refused(660, kGroupMacro, kSim, "nct-3-G66", "modal macro call after each move"),
    refused(661, kGroupMacro, kSim, "nct-3-G66.1", "modal macro call from each block"),
    modal(670, kGroupMacro, kSim, "nct-3-G67", "modal macro call off"),
});

constexpr auto kM = std::to_array<MCode>({
    {0, MPhase::kStop, kFlowCodes, kHost, {}, "nct-13.1-M0", "programmed stop"},
    {1, MPhase::kStop, kFlowCodes, kHost, {}, "nct-13.1-M1", "optional stop"},
    {2, MPhase::kEnd, kFlowCodes, kState, {}, "nct-13.1-M2", "end of program"},
    {30, MPhase::kEnd, kFlowCodes, kState, {}, "nct-13.1-M30", "end of program"},
    {98, MPhase::kCall, kFlowCodes, kSim, "PL", "nct-14.4.2-M98P nct-14.4.2-M98file nct-14.4.2-nesting",
     "subprogram call"},
    {99, MPhase::kCall, kFlowCodes, kSim, "PL",
     "nct-14.4.3-M99 nct-14.4.3-M99P nct-14.4.3-M99L nct-14.4.4-main",
     "return from a subprogram, jump in the main program"},
});

constexpr auto kFeatures = std::to_array<FeatureRow>({
    {"word", kState, "nct-1.1-word nct-1.1-block nct-3-zero nct-5.5-decimals",
     "address and number, decimal point optional"},
    {"N", kState, "nct-1.1-N nct-14.1-N", "block number, jump label"},
    {"O", kState, "nct-1.1-O nct-14.4.1-O", "program number at the head of the text"},
    {"/n", kSim, "nct-1.1-skip nct-14.2-skip", "optional block skip 1 to 9"},
    {"( )", kState, "nct-14.3-comment", "comment, over several lines"},
    {"#", kState, "nct-23.1.1-ref", "macro variables and expressions", false},
    {"M other", kHost, "nct-13.1-Mother", "functions of the machine builder"},
});

}  // namespace

CodeTable macroTable() { return {kG, kM, kFeatures}; }

}  // namespace proveout::nc
