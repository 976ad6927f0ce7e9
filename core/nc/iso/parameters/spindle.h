// Spindles.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class SpindleParam : std::uint16_t {
  kDefault,
  kPhaseShift,
  kSurfaceSpeed,
  kSurfaceAxis,
  kLeastSurfaceRpm,
  kOptionalLow,
  kOptionalHigh,
  kIndexBackwards,
  kIndexFirst,
  kIndexCount,
  kIndexAngle,
  kLoopCode,
  kTapAcceleration,                             ///< of range 1; the other ranges follow
  kExtractAcceleration = kTapAcceleration + 8,  ///< the same
  kCount = kExtractAcceleration + 8
};
/// Parameter of a range, 1 to 8.
constexpr SpindleParam ofRange(SpindleParam first, int range) {
  return static_cast<SpindleParam>(static_cast<int>(first) + range - 1);
}
constexpr ParamId paramId(SpindleParam p) { return {ParamChapter::kSpindle, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
