// Bodies that the kernels do not know: they answer one column after the other.
//
// A body that may cover several intervals of a column is as many bodies, pieces of one volume, and each
// answers with the interval of its own number, counted from below.
#pragma once

#include <array>
#include <cstdint>

#include "removal/sweep/kinds/body_defaults.h"

namespace proveout {

/// An open interval of z, mm; empty where lo > hi.
struct ColumnSpan {
  double lo = std::numeric_limits<double>::infinity();
  double hi = -std::numeric_limits<double>::infinity();
};

/// What a kind of body needs for questions about columns. `Kind` derives from this and has
///   ColumnSpan column(double x, double y) const: what it covers of a column, to within 1e-10 mm.
template <typename Kind>
struct ScalarBody : BodyDefaults {
  void columns(const double* x, const double* y, int count, double* lo, double* hi) const {
    for (int i = 0; i < count; ++i) {
      const ColumnSpan span = kind().column(x[i], y[i]);
      lo[i] = span.lo, hi[i] = span.hi;
    }
  }
  void leafColumns(LeafColumns& leaf, unsigned quarters) const { columnsOfQuarters(kind(), leaf, quarters); }

 private:
  const Kind& kind() const { return static_cast<const Kind&>(*this); }
};

/// A number of no other piece of this process.
std::uint64_t nextPieceId();

/// What `piece` covers of a column, all intervals, as `piece.columnSpans(x, y)` finds them. Its bodies of all
/// numbers ask for the same columns, in the same order: each thread keeps the last ones, as many as a leaf
/// has.
template <typename Piece>
const typename Piece::Spans& keptSpans(const Piece& piece, std::uint64_t id, double x, double y) {
  constexpr std::size_t kKept = 64;
  struct Kept {
    std::uint64_t id = 0;
    double x, y;
    typename Piece::Spans spans;
  };
  thread_local std::array<Kept, kKept> kept;
  thread_local std::size_t next = 0;
  for (std::size_t i = 0; i < kKept; ++i) {
    const std::size_t at = (next + i) % kKept;
    if (kept[at].id != id || kept[at].x != x || kept[at].y != y) continue;
    next = (at + 1) % kKept;
    return kept[at].spans;
  }
  Kept& fresh = kept[next];
  next = (next + 1) % kKept;
  fresh = {id, x, y, piece.columnSpans(x, y)};
  return fresh.spans;
}

}  // namespace proveout
