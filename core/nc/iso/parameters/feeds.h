// Feeds, accelerations, corners.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class FeedParam : std::uint16_t {
  kMaxFeed,
  kCornerByJump,
  kCornerAngle,
  kCornerFeed,
  kFeedJump,
  kLeastArcFeed,
  kNormalAcceleration,
  kAccelerationJump,
  kAccelerationJumpArc,
  kRapidOverlap,
  kRapidOverlapRatio,
  kInPosition,
  kPositionCheck,
  kPositionTimeout,
  kInsideArcLeast,
  kInsideCornerBefore,
  kInsideCornerAfter,
  kInsideCornerAngle,
  kInsideCornerFactor,
  kCount
};
constexpr ParamId paramId(FeedParam p) { return {ParamChapter::kFeeds, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
