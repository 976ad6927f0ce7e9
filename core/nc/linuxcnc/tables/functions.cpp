// M codes, and rows for what is neither a G nor an M code.
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/linuxcnc/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

// Those that the language carries out before the block is planned (program/lcn_functions.cpp) stand here for
// the list of codes.
constexpr auto kLinuxCncFunctionTable = std::to_array<MCode>({
    {0, MPhase::kStop, kFlowCodes, kState, {}, "lcn-5-M0", "stop"},
    {1, MPhase::kStop, kFlowCodes, kState, {}, "lcn-5-M0", "optional stop"},
    {2, MPhase::kEnd, kFlowCodes, kSim, {}, "lcn-5-M2", "end of program"},
    {3, MPhase::kBefore, kSpindleCodes, kState, {}, "lcn-5-M3", "spindle clockwise"},
    {4, MPhase::kBefore, kSpindleCodes, kState, {}, "lcn-5-M3", "spindle counter-clockwise"},
    {5, MPhase::kBefore, kSpindleCodes, kState, {}, "lcn-5-M3", "spindle stop"},
    {6, MPhase::kBefore, 0, kSim, {}, "lcn-5-M6", "tool change"},
    {7, MPhase::kBefore, kCoolantCodes, kState, {}, "lcn-5-M7", "mist on"},
    {8, MPhase::kBefore, kCoolantCodes, kState, {}, "lcn-5-M7", "coolant on"},
    {9, MPhase::kBefore, kCoolantCodes, kState, {}, "lcn-5-M7", "coolant off"},
    {19, MPhase::kBefore, 0, kState, "RPQ", "lcn-5-M19", "orient the spindle"},
    {30, MPhase::kEnd, kFlowCodes, kSim, {}, "lcn-5-M2", "end of program, pallets"},
    {47, MPhase::kEnd, kFlowCodes, kSim, {}, "lcn-6-mach3", "start again, of Mach3"},
    {48, MPhase::kBefore, 0, kHost, {}, "lcn-5-M48", "overrides on"},
    {49, MPhase::kBefore, 0, kHost, {}, "lcn-5-M48", "overrides off"},
    {50, MPhase::kBefore, 0, kHost, "P", "lcn-5-M48", "feed override"},
    {51, MPhase::kBefore, 0, kHost, "P", "lcn-5-M48", "spindle override"},
    {52, MPhase::kBefore, 0, kHost, "P", "lcn-5-M48", "adaptive feed"},
    {53, MPhase::kBefore, 0, kHost, "P", "lcn-5-M48", "feed stop"},
    {60, MPhase::kStop, kFlowCodes, kState, {}, "lcn-5-M0", "pallets and stop"},
    {61, MPhase::kBefore, 0, kState, "Q", "lcn-5-M61", "number of the tool"},
    {62, MPhase::kBefore, 0, kHost, "P", "lcn-5-M62", "output on with the motion"},
    {63, MPhase::kBefore, 0, kHost, "P", "lcn-5-M62", "output off with the motion"},
    {64, MPhase::kBefore, 0, kHost, "P", "lcn-5-M62", "output on"},
    {65, MPhase::kBefore, 0, kHost, "P", "lcn-5-M62", "output off"},
    {66, MPhase::kBefore, 0, kState, "PELQ", "lcn-5-M66", "wait for an input"},
    {67, MPhase::kBefore, 0, kHost, "EQ", "lcn-5-M62", "analog output with the motion"},
    {68, MPhase::kBefore, 0, kHost, "EQ", "lcn-5-M62", "analog output"},
    {70, MPhase::kBefore, 0, kSim, {}, "lcn-5-M70", "save the modal state"},
    {71, MPhase::kBefore, 0, kSim, {}, "lcn-5-M70", "forget the saved state"},
    {72, MPhase::kBefore, 0, kSim, {}, "lcn-5-M70", "restore the modal state"},
    {73, MPhase::kBefore, 0, kSim, {}, "lcn-5-M70", "save, and restore at the end of the sub"},
    {98, MPhase::kCall, kFlowCodes, kSim, "PL", "lcn-2-M98", "call of a numbered program"},
    {99, MPhase::kEnd, kFlowCodes, kSim, {}, "lcn-2-M98", "return"},
    {100, MPhase::kBefore, 0, kHost, "PQ", "lcn-5-M100", "M100 to M199: programs of the machine"},
});

constexpr auto kLinuxCncFeatureTable = std::to_array<FeatureRow>({
    {"start", kState, "lcn-1-start", "modal codes at the start"},
    {"units", kState, "lcn-1-units", "units of the machine"},
    {"remap", kSim, "lcn-1-remap", "codes as subroutines"},
    {"remap py", kReject, "lcn-1-python", "codes as Python"},
    {"ini", kState, "lcn-1-ini", "INI file"},
    {"line", kSim, "lcn-2-line", "length, blanks, case, %"},
    {"N", kState, "lcn-2-n", "line number"},
    {"/", kSim, "lcn-2-skip", "block delete"},
    {"( ) ;", kHost, "lcn-2-comment", "comments"},
    {"MSG", kHost, "lcn-2-msg", "message"},
    {"PRINT", kHost, "lcn-2-print", "print"},
    {"DEBUG", kHost, "lcn-2-debug", "message with values"},
    {"LOG", kHost, "lcn-2-log", "log files"},
    {"PROBEOPEN", kHost, "lcn-2-probeopen", "log of probing"},
    {"words", kSim, "lcn-2-words", "one value a letter"},
    {"groups", kReject, "lcn-2-groups", "one code of a modal group"},
    {"order", kSim, "lcn-2-order", "order of execution in a line"},
    {"numbers", kSim, "lcn-2-numbers", "numbers"},
    {"operators", kSim, "lcn-2-expr", "operators"},
    {"functions", kSim, "lcn-2-func", "functions"},
    {"errors", kReject, "lcn-2-experr", "errors of expressions"},
    {"#n #<name>", kSim, "lcn-2-params", "parameters"},
    {"#<_name>", kSim, "lcn-2-predefined", "predefined names"},
    {"#5161-#5390", kSim, "lcn-2-persist", "kept parameters"},
    {"#5061-#5428", kSim, "lcn-2-sysparams", "parameters of the control"},
    {"#5400 #<_x>", kReject, "lcn-2-readonly", "read-only parameters"},
    {"#<name>", kReject, "lcn-2-uninit", "unknown names"},
    {"#<_ini> #<_hal>", kState, "lcn-2-inihal", "values of the machine"},
    {"o sub", kSim, "lcn-2-o", "subs and calls"},
    {"o if", kSim, "lcn-2-oflow", "branches and loops"},
    {"o-word errors", kReject, "lcn-2-oerr", "missing ends, labels, levels"},
    {"name.ngc", kSim, "lcn-2-ofile", "subs in files"},
});

}  // namespace

CodeTable linuxCncFunctionTable() { return {{}, kLinuxCncFunctionTable, kLinuxCncFeatureTable}; }

}  // namespace proveout::nc
