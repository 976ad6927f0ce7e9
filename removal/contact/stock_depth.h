// How deep a point lies in the stock at any time of a path: the distance to the stock's surface as it was
// when a motion began.
#pragma once

#include <memory>

#include "removal/contact/stock_faces.h"
#include "removal/cut/cut_record.h"
#include "removal/grid/blank_field.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

/// A part meets the stock as the motions below this one left it: a cutter goes into what earlier motions
/// left; its shank follows it through what it cuts itself.
inline MotionId metBefore(const Pass& pass) { return pass.motion + (pass.cuts() ? 0 : 1); }

class StockDepth {
 public:
  /// `stock` as it is before the path that `record` holds. `blank`: its shape where nothing has been cut from
  /// it and there is a closed form, else null: see StockFaces. All must outlive this.
  StockDepth(const Stock::Impl& stock, const BlankField* blank, const CutRecord& record);

  /// Below 0 outside of the stock: a bound that never tells more than the distance to it. mm.
  struct Sample {
    double value;
    Vec3 gradient;  ///< unit, to where it is deeper
  };
  /// The stock as the motions below `motion` left it. `enough`, 0 or above: of depths below it any will do.
  /// `hint`: see CutterIndex::nearest; becomes the nearest cutter where one is nearest.
  Sample at(const Vec3& p, MotionId motion, const SweptCutter*& hint, double enough = 0.0) const;
  /// No point of a box lies deeper, mm: by the sides of the blank's bounds.
  double mostIn(const Vec3& middle, const Vec3& half) const;
  /// Of the blank, mm.
  const Box3& bounds() const { return stock_.blank; }

 private:
  Sample ofBlank(const Vec3& p) const;
  Sample ofBounds(const Vec3& p) const;

  const Stock::Impl& stock_;
  const BlankField* blank_;
  StockFaces faces_;  ///< where there is no closed form
  const CutRecord& record_;
};

}  // namespace proveout
