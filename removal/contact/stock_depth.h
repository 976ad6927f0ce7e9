// How deep a point lies in the stock at any time of a path: the distance to the stock's surface as it was
// when a motion began.
#pragma once

#include <memory>

#include "removal/cut/body_index.h"
#include "removal/grid/blank_field.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

class StockDepth {
 public:
  /// `stock` as it is before the path whose passes are in `table` and `cutters`, at the least those of the
  /// motions that are asked for. `blank`: its shape where nothing has been cut from it and there is a closed
  /// form, else null: then faces are those of the crossings, exact where they are flat. All must outlive
  /// this.
  StockDepth(const Stock::Impl& stock, const BlankField* blank, const PassTable& table,
             const CutterIndex& cutters);

  /// Below 0 outside of the stock: a bound that never tells more than the distance to it. mm.
  struct Sample {
    double value;
    Vec3 gradient;  ///< unit, to where it is deeper
  };
  /// The stock as the motions below `motion` left it. `hint`: see CutterIndex::nearest; becomes the nearest
  /// cutter where one is nearest.
  Sample at(const Vec3& p, MotionId motion, const SweptCutter*& hint) const;
  /// No point of a box lies deeper, mm: by the sides of the blank's bounds.
  double mostIn(const Vec3& middle, const Vec3& half) const;
  /// Of the blank, mm.
  const Box3& bounds() const { return stock_.blank; }

 private:
  Sample ofBlank(const Vec3& p) const;
  Sample ofBounds(const Vec3& p) const;
  Sample ofCrossings(const Vec3& p, Sample best) const;
  void lookAt(const StockLeaf& leaf, const Vec3& p, Sample& best, double& nearest) const;

  const Stock::Impl& stock_;
  const BlankField* blank_;
  const PassTable& table_;
  const CutterIndex& cutters_;
};

}  // namespace proveout
