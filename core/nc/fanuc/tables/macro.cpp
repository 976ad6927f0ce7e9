// Program flow, macro calls and M codes.
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucMacroTableG = std::to_array<GCode>({
    modal(650, kOneShot, kSim, "fan-12-G65", "macro call"),
    modal(660, kGroupMacro, kSim, "fan-12-G66", "modal macro call after each motion"),
    modal(661, kGroupMacro, kSim, "fan-12-G66.1", "modal macro call from each block"),
    modal(670, kGroupMacro, kSim, "fan-12-G67", "modal macro call off"),
});

constexpr auto kFanucMacroTableM = std::to_array<MCode>({
    {0, MPhase::kStop, kFlowCodes, kState, {}, "fan-14-M00", "stop"},
    {1, MPhase::kStop, kFlowCodes, kState, {}, "fan-14-M01", "optional stop"},
    {2, MPhase::kEnd, kFlowCodes, kSim, {}, "fan-11-M02", "end of program"},
    {3, MPhase::kBefore, kSpindleCodes, kState, {}, "fan-14-spindle", "spindle clockwise"},
    {4, MPhase::kBefore, kSpindleCodes, kState, {}, "fan-14-spindle", "spindle counter-clockwise"},
    {5, MPhase::kAfter, kSpindleCodes, kState, {}, "fan-14-spindle", "spindle stop"},
    {6, MPhase::kBefore, 0, kSim, {}, "fan-7-M06", "tool change"},
    {8, MPhase::kBefore, kCoolantCodes, kState, {}, "fan-14-coolant", "coolant on"},
    {9, MPhase::kAfter, kCoolantCodes, kState, {}, "fan-14-coolant", "coolant off"},
    {19, MPhase::kBefore, kSpindleCodes, kState, {}, "fan-14-spindle", "spindle orientation"},
    {30, MPhase::kEnd, kFlowCodes, kSim, {}, "fan-11-M30", "end of program"},
    {98, MPhase::kCall, kFlowCodes, kSim, "PL", "fan-11-M98", "subprogram call"},
    {99, MPhase::kCall, kFlowCodes, kSim, "PL", "fan-11-M99 fan-11-M99P", "return from a subprogram"},
});

}  // namespace

CodeTable fanucMacroTable() { return {kFanucMacroTableG, kFanucMacroTableM, {}}; }

}  // namespace proveout::nc
