// Loops of integer points (nanometres). Only for the .cpp files of
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

}  // namespace proveout::section_detail
