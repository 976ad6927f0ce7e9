// Feeds, accelerations, corners.
#pragma once

#include "core/nc/nct/parameters/parameter_types.h"

namespace proveout::nc {

/// Order of the rows in feeds.cpp.
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
std::span<const ParamInfo> feedParams();

}  // namespace proveout::nc
