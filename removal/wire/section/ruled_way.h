// A motion of a wire, upright or leaning, as places of its middle line at heights.
#pragma once

#include "core/geometry/types.h"
#include "core/path/toolpath.h"

namespace proveout {

class RuledWay {
 public:
  /// `wire` must outlive it.
  explicit RuledWay(const WireSweep& wire) : wire_(wire) {}

  /// Of the middle line at a share 0 <= t <= 1 of the motion; the line goes on straight beyond its planes.
  Vec3 at(double t, double z) const;
  /// No point between two heights goes farther than this per share of the motion, mm.
  double speed(double z_low, double z_high) const;
  /// Of all places between two heights.
  Box3 bounds(double z_low, double z_high) const;

 private:
  double shareOf(double z) const { return (z - wire_.z_low) / (wire_.z_high - wire_.z_low); }

  const WireSweep& wire_;
};

}  // namespace proveout
