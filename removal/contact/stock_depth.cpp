#include "removal/contact/stock_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {
StockDepth::StockDepth(const Stock::Impl& stock, const BlankField* blank, const CutRecord& record)
    : stock_(stock), blank_(blank), faces_(stock), record_(record) {}

StockDepth::Sample StockDepth::at(const Vec3& p, MotionId motion, const SweptCutter*& hint,
                                  double enough) const {
  const Sample blank = ofBlank(p);
  if (blank.value <= 0.0) return blank;
  const CutterIndex::Near cut = record_.cutters().nearest(p, motion, blank.value, hint, enough);
  if (cut.body == nullptr) return blank;
  hint = cut.body;
  return {cut.distance, cut.body->field(record_.table).sample(p).gradient};
}

StockDepth::Sample StockDepth::ofBlank(const Vec3& p) const {
  if (blank_ != nullptr) {
    const BlankSample s = blank_->sample(p);
    return {-s.value, -s.normal};
  }
  const Sample bounds = ofBounds(p);
  if (bounds.value <= 0.0) return bounds;
  const StockFaces::Sample s = faces_.at(p);
  return {-s.value, -s.gradient};
}

/// The stock is no larger than its blank's bounds.
StockDepth::Sample StockDepth::ofBounds(const Vec3& p) const {
  Sample best{std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = p[axis] - stock_.blank.min[axis], high = stock_.blank.max[axis] - p[axis];
    if (low < best.value) best = {low, Vec3::Unit(axis)};
    if (high < best.value) best = {high, -Vec3::Unit(axis)};
  }
  return best;
}

double StockDepth::mostIn(const Vec3& middle, const Vec3& half) const {
  // Of the whole blank: a window's grid holds a part of it.
  const Box3 sides = blank_ != nullptr ? blank_->bounds() : stock_.blank;
  const Vec3 off = (middle - sides.center()).cwiseAbs() - half;
  return (0.5 * sides.size() - off.cwiseMax(0.0)).minCoeff();
}

}  // namespace proveout
