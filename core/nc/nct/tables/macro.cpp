// Program format and flow, subprograms, macro language.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kMacroGCodes = std::to_array<GCode>({
    modal(650, kOneShot, kSim, "nct-3-G65 nct-23.3.1-G65", "macro call"),
    modal(660, kGroupMacro, kSim, "nct-3-G66 nct-23.3.2-G66", "modal macro call after each motion"),
    modal(661, kGroupMacro, kSim, "nct-3-G66.1 nct-23.3.3-G66.1", "modal macro call from each block"),
    modal(670, kGroupMacro, kSim, "nct-3-G67 nct-23.3.2-G67", "modal macro call off"),
});

constexpr auto kMacroMCodes = std::to_array<MCode>({
    {0, MPhase::kStop, kFlowCodes, kHost, {}, "nct-13.1-M0", "programmed stop"},
    {1, MPhase::kStop, kFlowCodes, kHost, {}, "nct-13.1-M1", "optional stop"},
    {2, MPhase::kEnd, kFlowCodes, kState, {}, "nct-13.1-M2", "end of program"},
    {30, MPhase::kEnd, kFlowCodes, kState, {}, "nct-13.1-M30", "end of program"},
    {96, MPhase::kAfter, 0, kHost, "P",
     "nct-13.1-M96 nct-23.4-M96 nct-23.4-N1758 nct-23.4-M99 nct-23.4-modals", "interrupt macro on"},
    {97, MPhase::kAfter, 0, kHost, {}, "nct-13.1-M97 nct-23.4-M97", "interrupt macro off"},
    {98, MPhase::kCall, kFlowCodes, kSim, "PL",
     "nct-1.1-subprog nct-14.4.2-M98P nct-14.4.2-M98file nct-14.4.2-nesting", "subprogram call"},
    {99, MPhase::kCall, kFlowCodes, kSim, "PL",
     "nct-14.4.3-M99 nct-14.4.3-M99P nct-14.4.3-M99L nct-14.4.4-main",
     "return from a subprogram, jump in the main program"},
});

constexpr auto kMacroFeatures = std::to_array<FeatureRow>({
    {"word", kState, "nct-1.1-word nct-1.1-block nct-3-zero nct-5.5-decimals",
     "address and number, decimal point optional"},
    {"N", kState, "nct-1.1-N nct-14.1-N", "block number, jump label"},
    {"O", kState, "nct-1.1-O nct-14.4.1-O", "program number at the head of the text"},
    {"/n", kSim, "nct-1.1-skip nct-14.2-skip", "optional block skip 1 to 9"},
    {"( )", kState, "nct-14.3-comment", "comment, over several lines"},
    {"#", kSim,
     "nct-23.1.1-ref nct-23.1.2-num nct-23.1.3-local nct-23.1.4-global nct-23.1.6-empty nct-23.1.6-const",
     "macro variables, by number, formula or name"},
    {"#=", kSim, "nct-23.2-formula nct-23.2.1-assign nct-23.2.6-precedence nct-23.2.6-brackets",
     "assignment and formulas, at every address"},
    {"+ - * / MOD", kSim,
     "nct-23.2.2-neg nct-23.2.2-add nct-23.2.2-sub nct-23.2.2-mul nct-23.2.2-div nct-23.2.2-MOD",
     "arithmetic"},
    {"NOT OR XOR AND", kSim, "nct-23.2.3-range nct-23.2.3-NOT nct-23.2.3-OR nct-23.2.3-XOR nct-23.2.3-AND",
     "operations on 32 bits"},
    {"SIN ...", kSim,
     "nct-23.2.4-SQRT nct-23.2.4-SIN nct-23.2.4-COS nct-23.2.4-TAN nct-23.2.4-ASIN nct-23.2.4-ACOS "
     "nct-23.2.4-ATAN "
     "nct-23.2.4-EXP nct-23.2.4-LN nct-23.2.5-ABS nct-23.2.5-FIX nct-23.2.5-FUP",
     "functions; angles in degrees"},
    {"EQ NE GT LT GE LE", kSim,
     "nct-23.2.7-EQ nct-23.2.7-NE nct-23.2.7-GT nct-23.2.7-LT nct-23.2.7-GE nct-23.2.7-LE", "conditions"},
    {"GOTO", kSim, "nct-23.2.8-GOTO", "jump to a block number"},
    {"IF", kSim, "nct-23.2.9-IF-GOTO nct-23.2.10-IF-THEN", "conditional jump or command"},
    {"WHILE DO END", kSim, "nct-23.2.11-WHILE nct-23.2.11-DO nct-23.2.11-nesting", "loops"},
    {"AX AXNUM", kSim, "nct-23.2.12-AXNUM nct-23.2.12-AX", "axes by number"},
    {"arguments", kSim,
     "nct-23.3-args-I nct-23.3-args-II nct-23.3-args-mixed nct-23.3-args-N nct-23.3-levels nct-23.3-depth "
     "nct-23.3-lookup",
     "arguments and local levels of macros"},
    {"system G", kSim,
     "nct-23.3.4-Gmacro nct-23.3.4-Gblock nct-23.3.4-Gdec nct-23.3.4-Gmodal nct-23.3.4-Gself nct-23.3.4-ENC",
     "G codes that call macros"},
    {"system M", kSim, "nct-23.3.5-Mmacro nct-23.3.6-Msub", "M codes that call macros and subprograms"},
    {"system letters", kSim, "nct-23.3.7-ABCST nct-23.3.8-ASCII", "letters that call subprograms"},
    {"N1756", kHost, "nct-23.3.9-list",
     "single block inside system programs: there is none in the simulation"},
    {"P9999", kSim, "nct-23.6-P9999 nct-23.6-feed nct-23.6-MST nct-23.6-special nct-23.6-errors",
     "pocket milling"},
    {"macro blocks", kState, "nct-23.5-blocks nct-23.5-MBM nct-23.5-SBM nct-23.5-G53",
     "run in the order of the text, whatever the control reads ahead"},
    {"M other", kHost, "nct-1.1-M nct-13.1-Mother nct-13.1-M90 nct-13.1-M400",
     "functions of the machine builder"},
});

}  // namespace

CodeTable macroTable() { return {kMacroGCodes, kMacroMCodes, kMacroFeatures}; }

}  // namespace proveout::nc
