// The part of a section in a window, to be changed without looking at the rest. Only for the .cpp files of
// sections: pulls in Clipper.
#pragma once

#include <vector>

#include "removal/turning/section/section_chains.h"

namespace proveout::section_detail {

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

/// Changes loops in a window; what that costs depends on the pieces near it, and hardly on the others.
class WindowCut {
 public:
  /// About the box from `low` to `high`, a little larger. `loops` must outlive the cut.
  WindowCut(const std::vector<ChainLoop>& loops, const IntPoint& low, const IntPoint& high);

  /// The area in the window, closed along its border.
  const std::vector<Loop>& inside() const { return inside_; }
  /// The loops with what is in the window replaced by `changed`: inside() less something that stays off the
  /// border. False where they cannot be joined (edges that cross the border in one point).
  bool join(const std::vector<Loop>& changed, std::vector<ChainLoop>& out) const;

 private:
  /// Edges in order; one stands for all of a piece that lies beyond a side of the window. Closed, or with a
  /// point more than edges.
  struct Strand {
    ClipperLib::Path points;
    std::vector<MotionId> motion;
    std::vector<const Piece*> far;  ///< null: the edge itself

    void add(const IntPoint& p, MotionId made_by, const Piece* piece) {
      points.push_back(p);
      motion.push_back(made_by);
      far.push_back(piece);
    }
  };
  void settle(const std::vector<ChainLoop>& loops);
  /// With points where it crosses the border; returns whether it does.
  bool divide(const ChainLoop& loop, Strand& out) const;
  void addCrossings(const IntPoint& a, const IntPoint& b, MotionId motion, Strand& out) const;
  void clip(Loop loop);
  template <typename Belongs>
  static bool strandsOf(const Strand& loop, const Belongs& belongs, std::vector<Strand>& strands);
  static ChainLoop closed(Strand&& joined);

  Window window_;
  std::vector<Loop> inside_;
  std::vector<const ChainLoop*> untouched_;  ///< loops outside of the window
  std::vector<Strand> outside_;
};

}  // namespace proveout::section_detail
