// Shank control (P1 of G43.4 and G43.5): the tool's direction turns in the plane of its ends, or with the
// arc, and the rotary axes follow it (manual 25.16).
#pragma once

#include <array>

#include "core/nc/iso/context/context.h"
#include "core/path/posed_way.h"

namespace proveout::nc {

/// The rotary axes on such a way: never by the choice of 25.11, but by the pair that goes on without a jump.
class ShankTrack {
 public:
  ShankTrack(const FiveAxisModel& model, const PosedWay& way) : model_(model), way_(way) {}

  /// Follows the direction from angles at one end to the other. False: a direction that no pair has.
  bool followFromStart(const RotaryAngles& start);
  bool followFromEnd(const RotaryAngles& end);
  /// Whether the axes come from `start`, where they matter.
  bool startsAt(const RotaryAngles& start);
  /// Machine positions of the rotary axes at a share of the way, 0 to 1.
  RotaryAngles at(double share) const;
  /// The direction at a share of it, workpiece frame with the tables at 0.
  Vec3 directionAt(double share) const { return way_.at(share).axis; }

 private:
  static constexpr std::size_t kNodes = 64;
  std::optional<RotaryAngles> nearest(double share, const RotaryAngles& to) const;

  const FiveAxisModel& model_;
  PosedWay way_;
  std::array<RotaryAngles, kNodes + 1> angles_;
};

/// The track of a block that holds the tip and whose target is known. None: an error was reported.
std::optional<ShankTrack> trackShank(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
