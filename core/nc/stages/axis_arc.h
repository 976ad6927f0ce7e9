// An arc in the planes of any axes, as axes and feeds see it.
#pragma once

#include "core/machine/axis_point.h"
#include "core/nc/stages/path_emitter.h"

namespace proveout::nc {

/// Axes outside of the plane go linearly with the angle. Machine frame, mm and deg.
class AxisArc {
 public:
  AxisArc(const AxisPoint& from, const AxisPoint& to, const MachineArc& arc);

  /// Is it of X, Y and Z alone, in space?
  bool isMain() const { return main_; }
  /// At a share of the angle, 0 to 1.
  AxisPoint at(double share) const;
  /// The length that the feed is the speed of, mm, with the first `axes` axes outside the circle but those of
  /// `apart`.
  double pacedLength(const FeedStyle& style, int axes, const AxisSet& apart) const;

 private:
  AxisPoint from_, to_;
  MachineArc arc_;
  bool main_;
  ArcGeometry space_;  ///< isMain()
  ArcFrame frame_{};
  Vec2 from_uv_, to_uv_;  ///< in the plane
};

}  // namespace proveout::nc
