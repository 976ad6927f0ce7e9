// Drilling cycles.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

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

}  // namespace proveout::nc
