// How deep a tool goes into the stock where it must not: the deepest point of what its parts sweep.
#pragma once

#include <vector>

#include "removal/contact/stock_depth.h"

namespace proveout {

/// A point of a swept volume, and how deep it lies in the stock.
struct DeepPoint {
  double depth = 0.0;  ///< mm
  Vec3 where = Vec3::Zero();
};

/// The deepest point of one part of a tool on one motion.
class DeepestPoint {
 public:
  /// The stock is as the motions below `before` left it. `pass`: any of the part on its motion. `h`: spacing
  /// of the grid, mm. All must outlive this.
  DeepestPoint(const StockDepth& stock, const Pass& pass, MotionId before, double h);

  /// The point of the swept volume that lies deepest, to within kWithinMm: where the stock is convex and has
  /// not been cut always, else the best of searches that set out from `starts` (points of the swept volume)
  /// and from wherever boxes of it may hold a better one. None deeper than `known`: depth 0. `effort`: points
  /// at which the depth may be asked for; becomes what is left. With too little the best so far is told, at
  /// least the first start.
  DeepPoint find(const std::vector<Vec3>& starts, double known, int& effort);
  static constexpr double kWithinMm = 1e-4;

 private:
  struct Start {
    double depth;
    Vec3 at;
  };
  StockDepth::Sample depthAt(const Vec3& p);
  bool tired() const { return effort_ <= 0; }
  void consider(const Vec3& p, double outside, const Vec3& away, DeepPoint& best);
  bool search(const Vec3& middle, double radius, DeepPoint& best);
  bool searchOn(const Vec3& from, double radius, DeepPoint& best);
  std::vector<Start> ordered(const std::vector<Vec3>& points);
  void searchFrom(const std::vector<Vec3>& starts, DeepPoint& best);
  void searchBoxes(DeepPoint& best);

  const StockDepth& stock_;
  MotionId before_;
  const SweptCutter* hint_ = nullptr;
  SweptField sweep_;
  double h_;
  int effort_ = 0;
};

}  // namespace proveout
