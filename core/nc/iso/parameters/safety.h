// Measuring moves and areas that the axes must not enter (manual chapters 21 and 22).
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class SafetyParam : std::uint16_t {
  kSkipFeedFixed,
  kSkipFeed,
  kLengthFeedFixed,
  kLengthWear,
  kLengthAdd,
  kLengthFeed,
  kRapidDistance,
  kAlarmDistance,
  kTorqueServoLimit,
  kZone2Axis,
  kZone3Axis,
  kZone2Outside,
  kZone2On,
  kCheckBefore,
  kStrokeAHigh,
  kStrokeALow,
  kStrokeBHigh,
  kStrokeBLow,
  kZone2High,
  kZone2Low,
  kZone3High,
  kZone3Low,
  kCount
};
constexpr ParamId paramId(SafetyParam p) { return {ParamChapter::kSafety, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
