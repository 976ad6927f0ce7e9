// Program organisation: reset of modal codes, functions that end look-ahead, waiting points of channels.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

inline constexpr int kResetGroups =
    34;  ///< groups that the tables CLR G Table1 to 5 have a bit for, from 1 on
inline constexpr int kBufferCodes = 10;  ///< single M codes that end look-ahead
inline constexpr int kBufferGroups = 8;  ///< ranges of such codes

enum class ProgramParam : std::uint16_t {
  kWaitLow,
  kWaitHigh,
  kKeepModal,  ///< N1301.CLR
  kKeep1,      ///< C01: group 1
  kBufferCode1 = kKeep1 + kResetGroups,
  kBufferLow1 = kBufferCode1 + kBufferCodes,
  kBufferHigh1 = kBufferLow1 + kBufferGroups,
  kBufferAuxiliary1 = kBufferHigh1 + kBufferGroups,
  kBufferS = kBufferAuxiliary1 + 3,
  kBufferT,
  kCount
};
constexpr ParamId paramId(ProgramParam p) { return {ParamChapter::kProgram, static_cast<std::uint16_t>(p)}; }
/// The row `k` behind `p`.
constexpr ProgramParam operator+(ProgramParam p, int k) {
  return static_cast<ProgramParam>(static_cast<int>(p) + k);
}

}  // namespace proveout::nc
