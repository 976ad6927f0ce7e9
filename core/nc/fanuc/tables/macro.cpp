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
    {7, MPhase::kBefore, kCoolantCodes, kState, {}, "fan-14-coolant", "second coolant on"},
    {8, MPhase::kBefore, kCoolantCodes, kState, {}, "fan-14-coolant", "coolant on"},
    {9, MPhase::kAfter, kCoolantCodes, kState, {}, "fan-14-coolant", "coolant off"},
    {10, MPhase::kBefore, 0, kHost, {}, "fan-14-clamp", "clamp"},
    {11, MPhase::kBefore, 0, kHost, {}, "fan-14-clamp", "unclamp"},
    {19, MPhase::kBefore, kSpindleCodes, kState, {}, "fan-14-spindle", "spindle orientation"},
    {30, MPhase::kEnd, kFlowCodes, kSim, {}, "fan-11-M30", "end of program"},
    {31, MPhase::kBefore, 0, kHost, {}, "fan-14-clamp", "chip conveyor on"},
    {33, MPhase::kBefore, 0, kHost, {}, "fan-14-clamp", "chip conveyor off"},
    {60, MPhase::kAfter, 0, kHost, {}, "fan-14-clamp", "pallet change"},
    {98, MPhase::kCall, kFlowCodes, kSim, "PLQ",
     "fan-11-M98 fan-11-M98Q fan-11-M98name fan-11-search fan-11-nest", "subprogram call"},
    {99, MPhase::kCall, kFlowCodes, kSim, "PL", "fan-11-M99 fan-11-M99P fan-11-M99main",
     "return from a subprogram"},
    {198, MPhase::kCall, kFlowCodes, kSim, "PLQ", "fan-11-M198", "subprogram call, folders first"},
});

constexpr auto kFanucMacroFeatures = std::to_array<FeatureRow>({
    {"#", kSim, "fan-12-vars fan-12-large fan-12-nullrules fan-13-const",
     "variables: local, common, kept; null; constants"},
    {"#=", kSim, "fan-12-expr fan-12-func fan-12-atan fan-12-logic", "assignment and formulas"},
    {"arguments", kSim, "fan-12-args1 fan-12-args2 fan-12-argdecimal", "arguments I and II"},
    {"argument errors", kReject, "fan-12-argerr", "G, L, N, O, P are no arguments"},
    {"calls by code", kSim, "fan-12-callG fan-12-callM fan-12-callT", "codes that settings turn into calls"},
    {"EQ NE GT GE LT LE", kSim, "fan-12-cond", "conditions, joined by AND and OR"},
    {"GOTO IF THEN", kSim, "fan-12-IF fan-12-THEN fan-12-GOTO", "jumps and conditional statements"},
    {"WHILE DO END", kSim, "fan-12-WHILE", "loops"},
    {"#3000 #3006", kState, "fan-12-alarm fan-12-3006", "alarm, stop with a text"},
    {"POPEN DPRNT", kHost, "fan-12-out", "macro output file"},
    {"SETVN", kState, "fan-12-SETVN fan-12-named", "names of variables"},
    {"macro errors", kReject, "fan-12-errors fan-13-protect fan-13-other", "111 to 128"},
    {"macro order", kState, "fan-12-lookahead", "statements act in program order"},
    {"#2001 #10001", kSim, "fan-13-offsets fan-13-lathe fan-13-v15", "offsets of tools"},
    {"#5201", kSim, "fan-13-frames fan-13-frames2 fan-13-frames3", "work frames"},
    {"#5001", kSim, "fan-13-position fan-13-5021 fan-13-5041 fan-13-5061 fan-13-5081 fan-13-100001",
     "positions"},
    {"#3001 #4001 #5101", kState, "fan-13-5101 fan-13-modal fan-13-time fan-13-3003 fan-13-parts fan-13-dio",
     "modal codes, times, counters, inputs and outputs"},
});

}  // namespace

CodeTable fanucMacroTable() { return {kFanucMacroTableG, kFanucMacroTableM, kFanucMacroFeatures}; }

}  // namespace proveout::nc
