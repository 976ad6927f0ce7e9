// Settings of calls and of the macro language.
#include <array>

#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/model/system_calls.h"
#include "core/nc/iso/parameters/data.h"
#include "core/nc/iso/parameters/macro.h"
#include "core/nc/iso/parameters/parameter_rows.h"

namespace proveout::nc {
namespace {

constexpr int kCalls = 10;
constexpr std::array<std::string_view, kCalls> kCallG{
    "macro_call_g.O9010", "macro_call_g.O9011", "macro_call_g.O9012", "macro_call_g.O9013",
    "macro_call_g.O9014", "macro_call_g.O9015", "macro_call_g.O9016", "macro_call_g.O9017",
    "macro_call_g.O9018", "macro_call_g.O9019"};
constexpr std::array<std::string_view, kCalls> kCallM{
    "macro_call_m.O9020", "macro_call_m.O9021", "macro_call_m.O9022", "macro_call_m.O9023",
    "macro_call_m.O9024", "macro_call_m.O9025", "macro_call_m.O9026", "macro_call_m.O9027",
    "macro_call_m.O9028", "macro_call_m.O9029"};
/// O9000 is called by T alone.
constexpr std::array<std::string_view, kCalls> kSubM{"",
                                                     "sub_call_m.O9001",
                                                     "sub_call_m.O9002",
                                                     "sub_call_m.O9003",
                                                     "sub_call_m.O9004",
                                                     "sub_call_m.O9005",
                                                     "sub_call_m.O9006",
                                                     "sub_call_m.O9007",
                                                     "sub_call_m.O9008",
                                                     "sub_call_m.O9009"};

}  // namespace

void addMacroRows(ParameterTable& table) {
  using namespace param_rows;
  constexpr int kNestingLimit = 16, kFirstG = 6050, kFirstM = 6080, kFirstSub = 6070;
  constexpr double kMostCode = 99999;
  for (int k = 0; k < kCalls; ++k) {
    const auto at = static_cast<std::size_t>(k);
    table.add(paramBehind(MacroParam::kG9010, k),
              number(kCallG[at], kFirstG + k, kChannel, 0, -kMostCode, kMostCode,
                     "G code that calls this macro; 0: none, negative: after each motion until G67"));
    table.add(paramBehind(MacroParam::kM9020, k), number(kCallM[at], kFirstM + k, kChannel, 0, 0, kMostCode,
                                                         "M code that calls this macro; 0: none"));
    if (k > 0) {
      table.add(paramBehind(MacroParam::kM9000, k),
                number(kSubM[at], kFirstSub + k, kChannel, 0, 0, kMostCode,
                       "M code that calls this subprogram; 0: none"));
    }
  }
  table
      .add(paramBehind(MacroParam::kLetterA, 4),
           bit("sub_call_t", 6001, 5, kChannel, 0, "T calls subprogram O9000, its value in #149"))
      .add(paramBehind(MacroParam::kLetterA, 3),
           bit("sub_call_s", 6005, 1, kChannel, 0, "S calls subprogram O9029, its value in #147"))
      .add(paramBehind(MacroParam::kLetterA, 1),
           bit("sub_call_b", 6005, 2, kChannel, 0, "B calls subprogram O9028, its value in #146"))
      .fix(MacroParam::kCallsInSystemPrograms, 1)
      .add(MacroParam::kSubNesting, number("sub_nesting", kNoNumber, kChannel, 10, 1, kNestingLimit,
                                           "most subprograms that may be open, old controls 4"))
      .add(MacroParam::kMacroNesting,
           number("macro_nesting", kNoNumber, kChannel, 4, 1, kNestingLimit, "most macros that may be open"))
      .add(MacroParam::kMainPasses, number("repeat_main", kNoNumber, kChannel, 1, 1, 1e6,
                                           "how often a main program that ends with M99 is run"))
      .add(DataParam::kPrintNoSpaces, bit("dprnt_compact", 6001, 1, kChannel, 0,
                                          "DPRNT writes no blanks for plus signs and leading zeros"))
      .add(FanucParam::kSubprogramForm,
           choice("subprogram_form", kNoNumber, 0, "P8 L",
                  "M98 P30012 is O0012 three times, or O30012; with L the whole P is the number"))
      .add(FanucParam::kAtanRange,
           atPowerOn(number("atan_range", 6004, kChannel, 360, 180, 360,
                            "360: ATAN 0 to 360 and ASIN 270 to 90; 180: -180 to 180")))
      .add(FanucParam::kV15,
           atPowerOn(bit("v15", 6000, 3, kChannel, 0, "variables of offsets: geometry comes before wear")))
      .add(FanucParam::kUnknownVariables, choice("unknown_variables", kNoNumber, 0, "error null",
                                                 "variables that the simulation does not know"));
}

}  // namespace proveout::nc
