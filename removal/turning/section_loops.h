// Loops of integer points (nanometres), and the part of them in a window. Only for the .cpp files of
// sections: pulls in Clipper.
#pragma once

#include <cstddef>
#include <polyclipping/clipper.hpp>
#include <vector>

#include "core/path/toolpath.h"

namespace proveout::section_detail {

using ClipperLib::cInt;
using ClipperLib::IntPoint;

inline constexpr double kNear = 1.5;  ///< units: rounding of a point that lies on an edge

/// A closed polygon; motion[i] made the edge from points[i] to the next.
struct Loop {
  ClipperLib::Path points;
  std::vector<MotionId> motion;

  std::size_t after(std::size_t i) const { return i + 1 < points.size() ? i + 1 : 0; }
};

/// Squared distance of (x, y) to the segment from a to b, units.
double distance2(double x, double y, const IntPoint& a, const IntPoint& b);

/// Takes out points that say nothing: doubles, and points on a straight edge of one motion.
void clean(Loop& loop);

/// A box whose border no loop touches but where it crosses it.
struct Window {
  IntPoint low, high;
  bool contains(double x, double y) const {
    return x > static_cast<double>(low.X) && x < static_cast<double>(high.X) &&
           y > static_cast<double>(low.Y) && y < static_cast<double>(high.Y);
  }
  /// Whether an edge runs along the border.
  bool along(const IntPoint& a, const IntPoint& b) const {
    return (a.X == b.X && (a.X == low.X || a.X == high.X)) || (a.Y == b.Y && (a.Y == low.Y || a.Y == high.Y));
  }
};

/// Changes loops in a window without looking at the rest of them again.
class WindowCut {
 public:
  /// About the box from `low` to `high`, a little larger.
  WindowCut(const std::vector<Loop>& loops, const IntPoint& low, const IntPoint& high);

  /// The area in the window, closed along its border.
  const std::vector<Loop>& inside() const { return inside_; }
  /// The loops with what is in the window replaced by `changed`: inside() less something that stays off the
  /// border. False where they cannot be joined (edges that cross the border in one point).
  bool join(const std::vector<Loop>& changed, std::vector<Loop>& out) const;

 private:
  /// Consecutive points of a loop on one side of the border, both ends on it.
  struct Chain {
    ClipperLib::Path points;
    std::vector<MotionId> motion;  ///< one less than points
  };
  void settle(const std::vector<Loop>& loops);
  Loop withCrossings(const Loop& loop) const;
  void clip(Loop loop);
  template <typename Belongs>
  static void chainsOf(const Loop& loop, const Belongs& belongs, std::vector<Chain>& chains,
                       std::vector<Loop>& whole);

  Window window_;
  std::vector<Loop> inside_;
  std::vector<Loop> untouched_;  ///< loops outside of the window
  std::vector<Chain> outside_;
};

}  // namespace proveout::section_detail
