// Measuring moves and areas that the axes must not enter (manual chapters 21 and 22).
#pragma once

#include <map>
#include <string>

#include "core/nc/nct/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in safety.cpp.
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
std::span<const ParamInfo> safetyParams();

/// Whether values by name, as jobs give them, have an end of the stroke of an axis: "N1002", "N1003.2".
bool givesStroke(const std::map<std::string, double>& values);

}  // namespace proveout::nc
