// Drilling cycles.
#pragma once

#include "core/nc/nct/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in cycles.cpp.
enum class CycleParam : std::uint16_t {
  kChipBreakReturn,
  kPeckClearance,
  kBoreRetract,
  kTapOrient,
  kTapReturnsToR,
  kTapExtraction,
  kTapReturnOverride,
  kTapExtractAcceleration,
  kTapReturn,
  kSpecialCodes,
  kRigidChipBreakReturn,
  kRigidPeckClearance,
  kTapRetract,
  kCount
};
constexpr ParamId paramId(CycleParam p) { return {ParamChapter::kCycles, static_cast<std::uint16_t>(p)}; }
std::span<const ParamInfo> cyclesParams();

}  // namespace proveout::nc
