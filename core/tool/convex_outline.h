// Convex regions of the plane that holds the spindle axis, bounded by lines and arcs: inserts, drills and
// their holders as a turning workpiece meets them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// What a side of a tool may do.
enum class SideUse : std::uint8_t {
  kCuts,    ///< a cutting edge
  kTrails,  ///< cuts, but has to stay clear where the tool feeds towards its leading edge
  kBack     ///< must touch nothing
};

/// A side of an outline from one point to the next. Points are (r, z), mm, seen from the control point.
struct OutlineSide {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  SideUse use = SideUse::kCuts;
  bool arc = false;  ///< counter-clockwise about `center`, less than a full turn
  Vec2 center = Vec2::Zero();
  double radius = 0.0;
};

/// A closed convex region; its sides go counter-clockwise (r turned towards z), the region on their left.
/// Directions are angles from +r towards +z, radians.
class ConvexOutline {
 public:
  /// Sides in their order, each from where the one before ends (to 1e-9 mm), turning left in all by one turn.
  /// Sides without length are left out.
  explicit ConvexOutline(const std::vector<OutlineSide>& sides);

  const std::vector<OutlineSide>& sides() const { return sides_; }
  Vec2 min() const { return min_; }  ///< of the bounds
  Vec2 max() const { return max_; }

  /// The point farthest in a direction; of a straight side across it the end that the outline reaches last.
  Vec2 support(double direction) const;
  /// Points of the boundary whose outward normals lie between two directions, `from` <= `to` <= `from` + one
  /// turn; of a straight side across one of the two directions the end that lies between them. Arcs as points
  /// on them, so dense that chords stay within `tolerance` mm; the points besides the ends depend on the arc
  /// alone.
  void chain(double from, double to, double tolerance, std::vector<Vec2>& points) const;

  /// Signed distance, negative inside, and its unit gradient.
  struct Sample {
    double value = 0.0;
    Vec2 gradient = Vec2::UnitX();
    int side = 0;  ///< nearest one
  };
  Sample sample(const Vec2& p) const;

 private:
  /// Part of the boundary whose normals go from `begin` to `end`: an arc, or a corner (radius 0).
  struct Turn {
    double begin = 0.0, end = 0.0;
    Vec2 center = Vec2::Zero();
    double radius = 0.0;
  };
  std::size_t turnAt(double direction) const;

  std::vector<OutlineSide> sides_;
  std::vector<Turn> turns_;  ///< from turns_.front().begin on over one full turn
  Vec2 min_ = Vec2::Zero(), max_ = Vec2::Zero();
};

/// Steps of a full turn so that the chords of a circle stay within `tolerance`; a multiple of 4.
int circleSteps(double radius, double tolerance);

/// The outline with r (axis 0) or z (axis 1) the other way round.
ConvexOutline mirrored(const ConvexOutline& outline, int axis);

/// The outline moved by `by`.
ConvexOutline shifted(const ConvexOutline& outline, const Vec2& by);

}  // namespace proveout
