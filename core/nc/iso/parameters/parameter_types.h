// What a parameter of a control is: its place in the table, and what it belongs to.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace proveout::nc {

/// What a parameter belongs to. Axis and spindle parameters have a value for each number.
enum class ParamScope : std::uint8_t { kGlobal, kChannel, kAxis, kSpindle };
inline constexpr int kParamAxes = 32;      ///< axis numbers 1..32
inline constexpr int kParamSpindles = 16;  ///< spindle numbers 1..16

inline constexpr int kWholeParam = -1;  ///< ParamInfo::bit: the parameter is a number
inline constexpr int kNamedBit = -2;    ///< ParamInfo::bit: a bit whose number the manual does not print

inline constexpr int kNoNumber = -1;  ///< ParamInfo::number: the manual names it without one

struct ParamInfo {
  std::string_view name;   ///< "N1339", "N1337.SEC"; empty: the control has no such parameter
  int number = kNoNumber;  ///< 1339
  int bit = kWholeParam;   ///< 0..7, kWholeParam or kNamedBit
  ParamScope scope = ParamScope::kChannel;
  double default_value = 0.0, min = 0.0, max = 0.0;  ///< lengths mm
  std::string_view meaning;
  bool restart = false;           ///< takes effect at power-on only: programs cannot change it
  bool noted = false;             ///< accepted, without effect in the simulation; a note says so
  std::string_view choices = {};  ///< words that a job gives in place of 0, 1, ..., separated by blanks
};

/// The chapters of the parameter table. Each has a header with an enumeration in the order of its rows and a
/// function paramId() for it.
enum class ParamChapter : std::uint8_t {
  kMotion,
  kMachine,
  kComp,
  kCycles,
  kMacro,
  kFeeds,
  kData,
  kAxis,
  kTools,
  kSpindle,
  kFunctions,
  kProgram,
  kSafety,
  kFiveAxis,
  kOwn,  ///< what only this control has; its enumeration is the control's
  kCount
};
/// A row of the table.
struct ParamId {
  ParamChapter chapter;
  std::uint16_t row;
};
/// Slots that a parameter of the scope takes.
constexpr int scopeCount(ParamScope scope) {
  return scope == ParamScope::kAxis ? kParamAxes : scope == ParamScope::kSpindle ? kParamSpindles : 1;
}

}  // namespace proveout::nc
