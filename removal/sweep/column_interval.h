// What one column sees of a part of a curve, for the searches of columns alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/sweep/column_types.h"

namespace proveout {

inline constexpr double kNoHeight = std::numeric_limits<double>::infinity();

inline double root(double a) { return std::sqrt(std::max(a, 0.0)); }

/// Height of a boundary's piece and its slope, at r or at the nearest place that the piece has.
struct BoundaryPlace {
  double value, slope;
};
inline BoundaryPlace boundaryAt(const ColumnBoundary::Piece& piece, double r) {
  const double at = std::clamp(r, piece.ra, piece.rb);
  if (piece.kind != ColumnBoundary::Kind::kArc)
    return {piece.za + piece.slope * (at - piece.ra), piece.slope};
  const double d = at - piece.rc, q = root(piece.radius * piece.radius - d * d);
  return {piece.zc - q, d == 0.0 ? 0.0 : d / q};
}
/// Its second derivative there.
inline double boundaryBend(const ColumnBoundary::Piece& piece, double r) {
  if (piece.kind != ColumnBoundary::Kind::kArc) return 0.0;
  const double d = std::clamp(r, piece.ra, piece.rb) - piece.rc;
  const double radius2 = piece.radius * piece.radius, q = root(radius2 - d * d);
  return radius2 / (q * q * q);
}

/// A least value and the place that has it.
struct Lowest {
  double value = kNoHeight, u = 0.0;
};

struct Interval {
  bool over = false;          ///< the tool is over the column somewhere
  double beyond = kNoHeight;  ///< least level distance of the tool's axis less the radius, mm
  double lo = kNoHeight, hi = -kNoHeight;
  double middle = 0.0;  ///< turn: angle of the way at u = 0; upright: place of the column, mm; else 0
  double u = 0.0, at_lo = 0.0, at_hi = 0.0;  ///< of the place that is nearest, and of those of lo and hi
};

/// Of a column that the tool only comes near to, at the place u: its rim there, `tip` being its height.
inline Interval beside(const ColumnSolid& solid, double beyond, double tip, double middle, double u) {
  const double r = solid.radius, low = tip + solid.lower.height(r), high = tip - solid.upper.height(r);
  return {false, std::max(beyond, 0.0), low, high, middle, u, u, u};
}

/// What is asked of a column.
struct Asked {
  bool rim = false;  ///< of columns that the tool is nowhere over, too
  bool all = true;   ///< both ends; else only how far the height z is outside
  double z = 0.0;
};

/// Finds the ends of a column that the tool is over; `base`: its height from which they are found, `tip`: its
/// height at the place in.u, where the column holds at least what the tool does. An end stays there if it
/// does not decide what is asked.
template <typename FindLow, typename FindHigh>
void findEnds(const ColumnSolid& solid, const Asked& asked, double base, double tip, Interval& in,
              const FindLow& find_low, const FindHigh& find_high) {
  const double r = std::min(solid.radius + in.beyond, solid.radius), z = asked.z;
  in.over = true;
  in.at_lo = in.at_hi = in.u;
  in.lo = tip + solid.lower.height(r);
  in.hi = tip - solid.upper.height(r);
  // Nothing less can be the answer.
  double known = asked.all ? -kNoHeight : in.beyond;
  const auto low = [&] {
    if (in.lo - z <= known) return;
    const Lowest found = find_low();
    in.lo = base + found.value, in.at_lo = found.u;
    if (!asked.all) known = std::max(known, in.lo - z);
  };
  const auto high = [&] {
    if (z - in.hi <= known) return;
    const Lowest found = find_high();
    in.hi = base - found.value, in.at_hi = found.u;
    if (!asked.all) known = std::max(known, z - in.hi);
  };
  const bool low_first = in.lo - z >= z - in.hi;
  if (low_first) low();
  high();
  if (!low_first) low();
}

}  // namespace proveout
