// A motion of a block that stands for many: pockets, engraving.
#pragma once

#include <cstdint>

#include "core/geometry/types.h"

namespace proveout::nc {

/// In program coordinates, mm: (u, v, w) of the plane in force. The motion begins where the last one ended.
struct PathStep {
  enum class Kind : std::uint8_t { kRapid, kFeed, kArc };
  Kind kind = Kind::kFeed;
  Vec3 to = Vec3::Zero();
  Vec2 center = Vec2::Zero();  ///< kArc
  double sweep_rad = 0.0;      ///< kArc: > 0 from u to v
  double feed_factor = 1.0;    ///< of the feed of the block
};

}  // namespace proveout::nc
