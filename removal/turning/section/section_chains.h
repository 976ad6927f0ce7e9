// Long loops kept as chains of edges with their bounds and sums: a change looks at the chains that it touches
// and shares the others. Only for the .cpp files of sections: pulls in Clipper.
#pragma once

#include <memory>
#include <vector>

#include "removal/turning/section/section_loops.h"

namespace proveout::section_detail {

inline constexpr double kUnit = 1e-6;  ///< mm: a nanometre

/// Consecutive edges of a loop; never changed once made, so that copies of a section share them.
struct Chain {
  ClipperLib::Path points;       ///< two or more
  std::vector<MotionId> motion;  ///< of the edges: one less
};

/// A chain with what is asked about it most.
struct Piece {
  explicit Piece(Chain&& edges);

  std::shared_ptr<const Chain> chain;
  IntPoint low, high;       ///< bounds, units
  double volume_mm3 = 0.0;  ///< its share in Pappus' sum
  double area = 0.0;        ///< its share in the area, square units

  const IntPoint& front() const { return chain->points.front(); }
  const IntPoint& back() const { return chain->points.back(); }
  std::size_t edges() const { return chain->motion.size(); }
  /// False where all of it lies beyond one side of the box.
  bool near(const IntPoint& box_low, const IntPoint& box_high) const {
    return high.X >= box_low.X && low.X <= box_high.X && high.Y >= box_low.Y && low.Y <= box_high.Y;
  }
};

/// A closed polygon: each piece ends where the next one begins, the last where the first one does.
using ChainLoop = std::vector<Piece>;

/// Requires three points or more.
ChainLoop chained(const Loop& loop);
/// Cuts an open run of edges into pieces, at the end of `loop`; a short one is joined with the last piece.
void append(Chain&& run, ChainLoop& loop);
Loop flat(const ChainLoop& loop);
/// Whether each piece ends where the next one begins.
bool isClosed(const ChainLoop& loop);

/// Sum over the pieces: above 0 for outer borders, square units.
double areaOf(const ChainLoop& loop);
/// Whether a point that lies on none of the edges is inside of the loop.
bool surrounds(const ChainLoop& loop, const IntPoint& p);
/// Squared distance of (x, y) to the nearest edge off the axis, no more than `most`; units.
double nearestEdge2(const ChainLoop& loop, double x, double y, double most);

}  // namespace proveout::section_detail
