// Bodies that the kernels do not know: they answer one column after the other.
//
// A body that may cover several intervals of a column is as many bodies, pieces of one volume, and each
// answers with the interval of its own number, counted from below.
#pragma once

#include "removal/sweep/kinds/body_defaults.h"

namespace proveout {

/// An open interval of z, mm; empty where lo > hi.
struct ColumnSpan {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
};

/// What a kind of body needs for all questions about columns. `Kind` derives from this and has
///   ColumnSpan column(double x, double y) const: what it covers of a column, to within 1e-10 mm;
///   ColumnSpan around(double x, double y, double half_width) const: heights between which it covers anything
///     of the columns in a square, or more; kCullSlackMm wider than that.
template <typename Kind>
struct ScalarBody : BodyDefaults {
  void columns(const double* x, const double* y, int count, double* lo, double* hi) const {
    for (int i = 0; i < count; ++i) {
      const ColumnSpan span = kind().column(x[i], y[i]);
      lo[i] = span.lo, hi[i] = span.hi;
    }
  }
  void leafColumns(LeafColumns& leaf, unsigned quarters) const { columnsOfQuarters(kind(), leaf, quarters); }
  void reach(const FourBlocks& blocks, double* low, double* high) const {
    for (int i = 0; i < 4; ++i) {
      const ColumnSpan span = kind().around(blocks.x[i], blocks.y[i], blocks.half_width);
      const bool in = span.lo < blocks.z_high[i] && span.hi > blocks.z_low[i];
      low[i] = in ? span.lo : ColumnSpan{}.lo;
      high[i] = in ? span.hi : ColumnSpan{}.hi;
    }
  }

 private:
  const Kind& kind() const { return static_cast<const Kind&>(*this); }
};

}  // namespace proveout
