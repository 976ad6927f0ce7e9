// Functions of the machine: groups of M codes, auxiliary functions.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

inline constexpr int kAuxiliaryCount = 3;  ///< addresses of auxiliary functions
inline constexpr int kMGroups = 16;        ///< groups of M codes

enum class FunctionParam : std::uint16_t {
  kAuxiliary1,
  kAuxiliary2,
  kAuxiliary3,
  kGroupLow1,
  kGroupHigh1 = kGroupLow1 + kMGroups,
  kCount = kGroupHigh1 + kMGroups
};
constexpr ParamId paramId(FunctionParam p) {
  return {ParamChapter::kFunctions, static_cast<std::uint16_t>(p)};
}
/// The row `k` behind `p`.
constexpr FunctionParam operator+(FunctionParam p, int k) {
  return static_cast<FunctionParam>(static_cast<int>(p) + k);
}

}  // namespace proveout::nc
