// Five axes (manual 25.1).
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class FiveAxisParam : std::uint16_t {
  kMechanicalType,
  kToolAxis,
  kFirstAxis,
  kFirstDirection,
  kFirstInclination,
  kSecondAxis,
  kSecondDirection,
  kSecondInclination,
  kFirstReversed,
  kSecondReversed,
  kByTransformation,
  kTableX,
  kTableY,
  kTableZ,
  kTableOffsetX,
  kTableOffsetY,
  kTableOffsetZ,
  kHeadX,
  kHeadY,
  kHeadZ,
  kHeadOffsetX,
  kHeadOffsetY,
  kHeadOffsetZ,
  kCount
};
constexpr ParamId paramId(FiveAxisParam p) {
  return {ParamChapter::kFiveAxis, static_cast<std::uint16_t>(p)};
}

}  // namespace proveout::nc
