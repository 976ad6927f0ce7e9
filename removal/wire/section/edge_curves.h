// From polygons of integer points back to the lines and arcs that they were cut from.
#pragma once

#include <optional>
#include <vector>

#include "removal/wire/section/plane_region.h"
#include "removal/wire/section/stretch_index.h"

namespace proveout::wire_detail {

/// The line or circle on which an edge of a section lies.
struct EdgeCurve {
  bool circle = false;
  Vec2 at = Vec2::Zero();     ///< center of the circle, or a point of the line
  Vec2 along = Vec2::Zero();  ///< unit, of the line
  double radius = 0.0;        ///< of the circle, mm
  std::uint64_t name = 0;     ///< the same for edges that may be joined
  MotionId motion = kNoMotion;

  double distance(const Vec2& p) const;
  /// The point of the curve that is nearest to p.
  Vec2 nearest(const Vec2& p) const;
};

/// The edges of loops, without a kerf.
std::vector<WireStretch> sidesOf(const std::vector<PlaneLoop>& loops);

/// Knows the curves of a blank and of what a wire has cut.
class CurveFinder {
 public:
  /// Both must outlive it.
  CurveFinder(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& stretches);
  /// The curve on which the middle of an edge lies.
  EdgeCurve of(const Vec2& middle) const;

 private:
  std::optional<EdgeCurve> ofBlank(const Vec2& p, double reach) const;
  std::optional<EdgeCurve> ofKerf(const Vec2& p, double reach) const;

  const std::vector<WireStretch>& stretches_;
  StretchIndex kerf_;
  std::vector<WireStretch> sides_;  ///< of the blank: lines and arcs, without a kerf
  StretchIndex blank_;
};

/// The loop of a polygon whose edges lie on the curves, `curves[i]` for that from points[i] to the next. Runs
/// of edges on one curve become one; corners lie where the curves meet.
PlaneLoop curvedLoop(const std::vector<Vec2>& points, const std::vector<EdgeCurve>& curves);

}  // namespace proveout::wire_detail
