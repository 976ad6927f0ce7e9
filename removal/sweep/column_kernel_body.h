// Body of the column kernels; compiled once for each SIMD level inside a namespace of its own.
// Plain loops over arrays that the compiler vectorises. No function with external linkage is used, so that
// code for one level can never be taken for another; no operation may be contracted or reassociated.
#pragma once

#include "removal/sweep/column_angle.h"
#include "removal/sweep/column_curve.h"

namespace {

using proveout::ArcSweep;
using proveout::ColumnBoundary;
using proveout::kQuarter;
using proveout::LineSweep;
using proveout::TurnSweep;
using proveout::UprightSweep;
using proveout::WaySweep;

constexpr int kArray = proveout::kMaxColumns;
constexpr double kNoHeight = __builtin_inf();
/// Newton's method for a stationary point halves its bracket where it would leave it, and every third time
/// behind so many rounds. Of 1.6 million random columns none took more than 10 rounds on slopes up to 3, nor
/// more than 27 on steeper ones. It stops behind a step this small, mm: the error of what follows is its
/// square, and that of the value the square of that.
constexpr int kNewtonRounds = 16, kMostRounds = 150;
constexpr double kStationaryMm = 1e-6;

inline double least(double a, double b) { return a < b ? a : b; }
inline double most(double a, double b) { return a > b ? a : b; }
inline double root(double a) { return __builtin_sqrt(a > 0.0 ? a : 0.0); }

/// out = L(r), for r in range.
inline void boundaryHeight(const ColumnBoundary& boundary, const double* __restrict r, int n,
                           double* __restrict out) {
  for (int p = 0; p < boundary.count; ++p) {
    const ColumnBoundary::Piece& piece = boundary.piece[p];
    const double ra = piece.ra, za = piece.za, slope = piece.slope;
    const double rc = piece.rc, zc = piece.zc, radius2 = piece.radius * piece.radius;
    const bool first = p == 0;
    if (piece.kind == ColumnBoundary::Kind::kArc) {
      for (int i = 0; i < n; ++i) {
        const double d = r[i] - rc;
        const double z = zc - root(radius2 - d * d);
        out[i] = first || r[i] >= ra ? z : out[i];
      }
    } else {
      for (int i = 0; i < n; ++i) {
        const double z = za + slope * (r[i] - ra);
        out[i] = first || r[i] >= ra ? z : out[i];
      }
    }
  }
}

/// The |s| in [sa, sb] at which L(sqrt(p2 + s^2)) - steep * |s| is least on an arc piece. Columns do not
/// depend on each other.
inline void arcStationary(const ColumnBoundary::Piece& piece, double steep, const double* __restrict p2,
                          int n, const double* __restrict sa, const double* __restrict sb,
                          double* __restrict s) {
  const double rc = piece.rc, radius2 = piece.radius * piece.radius;
  if (rc == 0.0) {  // of a sphere about the axis: L is convex in s as well
    const double lean = steep / __builtin_sqrt(1.0 + steep * steep);
    for (int i = 0; i < n; ++i) s[i] = least(most(lean * root(radius2 - p2[i]), sa[i]), sb[i]);
    return;
  }
  double low[kArray], high[kArray], open[kArray];
  const double steep_rc = steep * rc;
  for (int i = 0; i < n; ++i) {
    // With the normal that belongs to the piece's inner end, or, beyond it, with that at s = 0.
    const double lean = steep_rc / root(sa[i] * sa[i] + steep_rc * steep_rc);
    const double r = rc + piece.radius * lean, p = root(p2[i]), d = p - rc;
    const double across = root(r * r - p2[i]), beyond = steep * p * root(radius2 - d * d) / d;
    const double guess = sa[i] > 0.0 ? across : beyond;
    low[i] = sa[i], high[i] = sb[i], open[i] = 1.0;
    s[i] = guess > sa[i] && guess < sb[i] ? guess : 0.5 * (sa[i] + sb[i]);
  }
  for (int round = 0; round < kMostRounds; ++round) {
    const bool halve = round >= kNewtonRounds && round % 3 == 0;
    double left = 0.0;
    for (int i = 0; i < n; ++i) {
      const double t = s[i], r = root(p2[i] + t * t), d = r - rc, q = root(radius2 - d * d);
      // L' t / r - steep, times r q: no division near the rim
      const double value = d * t - steep * r * q;
      const double slope = d + t * t / r - steep * t * (q / r - d / q);
      const double from = value < 0.0 ? t : low[i], to = value < 0.0 ? high[i] : t;
      const double newton = t - value / slope, step = newton < t ? t - newton : newton - t;
      const bool in = newton > from && newton < to && !halve;
      const double next = in ? newton : 0.5 * (from + to);
      const double near = in ? step : to - from;
      // What is done stays, whatever the columns beside it need.
      const bool going = open[i] > 0.0;
      low[i] = going ? from : low[i];
      high[i] = going ? to : high[i];
      s[i] = going ? next : t;
      open[i] = going && near > kStationaryMm ? 1.0 : 0.0;
    }
    for (int i = 0; i < n; ++i) left = most(left, open[i]);
    if (left == 0.0) return;
  }
}

/// out = least of slope * (s + along) + L(sqrt(p2 + s^2)) for s in [a0, a1]; along shifts the value only.
inline void leastOnLine(const ColumnBoundary& boundary, double slope, const double* __restrict along,
                        const double* __restrict p2, const double* __restrict a0, const double* __restrict a1,
                        int n, double* __restrict out) {
  const double steep = slope < 0.0 ? -slope : slope, side = slope > 0.0 ? -1.0 : 1.0;
  double best[kArray], at[kArray], sa[kArray], sb[kArray], s[kArray], r[kArray], z[kArray];
  for (int i = 0; i < n; ++i) best[i] = kNoHeight, at[i] = 0.0;
  for (int p = 0; p < boundary.count; ++p) {
    const ColumnBoundary::Piece& piece = boundary.piece[p];
    const double ra2 = piece.ra * piece.ra, rb2 = piece.rb * piece.rb;
    for (int i = 0; i < n; ++i) sa[i] = root(ra2 - p2[i]), sb[i] = root(rb2 - p2[i]);
    if (piece.kind == ColumnBoundary::Kind::kArc) {
      arcStationary(piece, steep, p2, n, sa, sb, s);
    } else if (steep >= piece.slope && steep > 0.0) {
      for (int i = 0; i < n; ++i) s[i] = sb[i];
    } else {
      const double k = piece.slope > 0.0 ? steep / root(piece.slope * piece.slope - steep * steep) : 0.0;
      for (int i = 0; i < n; ++i) s[i] = least(most(k * root(p2[i]), sa[i]), sb[i]);
    }
    const double ra = piece.ra, za = piece.za, rise = piece.slope;
    const double rc = piece.rc, zc = piece.zc, radius2 = piece.radius * piece.radius;
    const bool arc = piece.kind == ColumnBoundary::Kind::kArc;
    for (int i = 0; i < n; ++i) {
      const double radial = root(p2[i] + s[i] * s[i]), d = radial - rc;
      const double height = arc ? zc - root(radius2 - d * d) : za + rise * (radial - ra);
      const double value = height - steep * s[i];
      const bool better = p2[i] <= rb2 && value < best[i];
      best[i] = better ? value : best[i];
      at[i] = better ? side * s[i] : at[i];
    }
  }
  const double radius = boundary.piece[boundary.count - 1].rb;
  for (int i = 0; i < n; ++i) {
    s[i] = least(most(at[i], a0[i]), a1[i]);
    r[i] = least(root(p2[i] + s[i] * s[i]), radius);
  }
  boundaryHeight(boundary, r, n, z);
  for (int i = 0; i < n; ++i) out[i] = slope * (s[i] + along[i]) + z[i];
}

/// Level moves of cylinders: no root is needed.
inline void levelFlatColumns(const LineSweep& sweep, const double* __restrict x, const double* __restrict y,
                             int n, double* __restrict lo, double* __restrict hi) {
  const double fx = sweep.x, fy = sweep.y, ux = sweep.ux, uy = sweep.uy, length = sweep.length;
  const double radius2 = sweep.solid->radius * sweep.solid->radius;
  const double low = sweep.z + sweep.solid->z_min, high = sweep.z + sweep.solid->z_max;
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - fx, qy = y[i] - fy;
    const double along = qx * ux + qy * uy;
    const double across = qx * uy - qy * ux;
    const double beyond = along - least(most(along, 0.0), length);
    const bool over = across * across + beyond * beyond < radius2;
    lo[i] = over ? low : kNoHeight;
    hi[i] = over ? high : -kNoHeight;
  }
}

enum class PlainEnd { kFlat, kBall, kSphere };

/// Cylinders, ball ends with a level top, and whole balls.
template <PlainEnd kEnd>
inline void plainColumns(const LineSweep& sweep, const double* __restrict x, const double* __restrict y,
                         int n, double* __restrict lo, double* __restrict hi) {
  const double fx = sweep.x, fy = sweep.y, fz = sweep.z, ux = sweep.ux, uy = sweep.uy;
  const double length = sweep.length, slope = sweep.slope, lean = sweep.lean;
  const proveout::ColumnSolid& tool = *sweep.solid;
  const double radius2 = tool.radius * tool.radius, lift = fz + tool.radius, z_min = tool.z_min,
               z_max = tool.z_max;
  const bool rises = slope > 0.0;
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - fx, qy = y[i] - fy;
    const double along = qx * ux + qy * uy;
    const double across = qx * uy - qy * ux;
    const double w2 = radius2 - across * across, w = root(w2);
    const double a0 = most(-along, -w), a1 = least(length - along, w);
    const double s = least(most(lean * w, a0), a1);
    const double low = kEnd == PlainEnd::kFlat ? fz + slope * ((rises ? a0 : a1) + along) + z_min
                                               : lift + slope * (s + along) - root(w2 - s * s);
    const double over_s = least(most(-lean * w, a0), a1);
    const double high = kEnd == PlainEnd::kSphere
                            ? lift + slope * (over_s + along) + root(w2 - over_s * over_s)
                            : fz + slope * ((rises ? a1 : a0) + along) + z_max;
    const bool over = w2 > 0.0 && a0 <= a1;
    lo[i] = over ? low : kNoHeight;
    hi[i] = over ? high : -kNoHeight;
  }
}

inline void lineColumns(const LineSweep& sweep, const double* __restrict x, const double* __restrict y, int n,
                        double* __restrict lo, double* __restrict hi) {
  if (sweep.solid->flat && sweep.slope == 0.0) return levelFlatColumns(sweep, x, y, n, lo, hi);
  if (sweep.solid->flat) return plainColumns<PlainEnd::kFlat>(sweep, x, y, n, lo, hi);
  if (sweep.solid->ball && !sweep.solid->round_top)
    return plainColumns<PlainEnd::kBall>(sweep, x, y, n, lo, hi);
  if (sweep.solid->sphere) return plainColumns<PlainEnd::kSphere>(sweep, x, y, n, lo, hi);
  const double fx = sweep.x, fy = sweep.y, fz = sweep.z;
  const double ux = sweep.ux, uy = sweep.uy, length = sweep.length, slope = sweep.slope;
  const proveout::ColumnSolid& tool = *sweep.solid;
  const double radius2 = tool.radius * tool.radius;
  double along[kArray], p2[kArray], w2[kArray], w[kArray], a0[kArray], a1[kArray];
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - fx, qy = y[i] - fy;
    along[i] = qx * ux + qy * uy;
    const double across = qx * uy - qy * ux;
    p2[i] = across * across;
    w2[i] = radius2 - p2[i];
    w[i] = root(w2[i]);
    a0[i] = most(-along[i], -w[i]);
    a1[i] = least(length - along[i], w[i]);
  }
  if (tool.ball) {
    const double lean = sweep.lean, lift = fz + tool.radius;
    for (int i = 0; i < n; ++i) {
      const double s = least(most(lean * w[i], a0[i]), a1[i]);
      lo[i] = lift + slope * (s + along[i]) - root(w2[i] - s * s);
    }
  } else {
    leastOnLine(tool.lower, slope, along, p2, a0, a1, n, lo);
    for (int i = 0; i < n; ++i) lo[i] += fz;
  }
  if (tool.round_top) {
    leastOnLine(tool.upper, -slope, along, p2, a0, a1, n, hi);
    for (int i = 0; i < n; ++i) hi[i] = fz - hi[i];
  } else {
    for (int i = 0; i < n; ++i) hi[i] = fz + slope * ((slope > 0.0 ? a1[i] : a0[i]) + along[i]) + tool.z_max;
  }
  for (int i = 0; i < n; ++i) {
    const bool over = w2[i] > 0.0 && a0[i] <= a1[i];
    lo[i] = over ? lo[i] : kNoHeight;
    hi[i] = over ? hi[i] : -kNoHeight;
  }
}

/// Level distance from the tool axis at its nearest position on a level arc.
inline void axisDistance(const ArcSweep& s, const double* __restrict x, const double* __restrict y, int n,
                         double* __restrict r) {
  const double cx = s.x, cy = s.y, inverse = 1.0 / s.arc_radius;
  const double ux = (s.start_x - cx) * inverse, uy = (s.start_y - cy) * inverse;
  const double vx = -uy * s.turn, vy = ux * s.turn;
  const double c = s.cos_sweep, sn = s.sin_sweep, arc = s.arc_radius;
  const bool wide = s.wide, full = s.full;
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - cx, qy = y[i] - cy;
    const double pu = qx * ux + qy * uy, pv = qx * vx + qy * vy;
    const double past = pv * c - pu * sn;  // above 0: behind the end
    const bool narrow_in = pv >= 0.0 && past <= 0.0, wide_in = !(pv < 0.0 && past > 0.0);
    const bool in = full || (wide ? wide_in : narrow_in);
    const double d = root(qx * qx + qy * qy) - arc;
    const double ax = x[i] - s.start_x, ay = y[i] - s.start_y, bx = x[i] - s.end_x, by = y[i] - s.end_y;
    const double ends = root(least(ax * ax + ay * ay, bx * bx + by * by));
    r[i] = in ? (d < 0.0 ? -d : d) : ends;
  }
}

/// The same on a line.
inline void axisDistance(const LineSweep& s, const double* __restrict x, const double* __restrict y, int n,
                         double* __restrict r) {
  const double fx = s.x, fy = s.y, ux = s.ux, uy = s.uy, length = s.length;
  if (length == 0.0) {
    for (int i = 0; i < n; ++i) {
      const double qx = x[i] - fx, qy = y[i] - fy;
      r[i] = root(qx * qx + qy * qy);
    }
    return;
  }
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - fx, qy = y[i] - fy;
    const double along = qx * ux + qy * uy, across = qx * uy - qy * ux;
    const double beyond = along - least(most(along, 0.0), length);
    r[i] = root(across * across + beyond * beyond);
  }
}

inline double riseOf(const LineSweep& sweep) { return sweep.rise; }
inline double riseOf(const ArcSweep&) { return 0.0; }

/// Sweeps that cover a column most where the tool's axis is nearest: level ones, and vertical ones.
template <typename Way>
inline void radialColumns(const Way& sweep, const double* __restrict x, const double* __restrict y, int n,
                          double* __restrict lo, double* __restrict hi) {
  const proveout::ColumnSolid& tool = *sweep.solid;
  double r[kArray], inside[kArray];
  axisDistance(sweep, x, y, n, r);
  const double radius = tool.radius;
  for (int i = 0; i < n; ++i) inside[i] = least(r[i], radius);
  boundaryHeight(tool.lower, inside, n, lo);
  boundaryHeight(tool.upper, inside, n, hi);
  const double low = sweep.z + least(riseOf(sweep), 0.0), high = sweep.z + most(riseOf(sweep), 0.0);
  for (int i = 0; i < n; ++i) {
    const bool over = r[i] < radius;
    lo[i] = over ? low + lo[i] : kNoHeight;
    hi[i] = over ? high - hi[i] : -kNoHeight;
  }
}

#include "removal/sweep/column_curve_body.h"
#include "removal/sweep/column_cut_body.h"
#include "removal/sweep/column_way_body.h"
#include "removal/sweep/kinds/pose_columns_body.h"

inline int padded(int count) { return (count + 7) & ~7; }

void columns(const LineSweep& sweep, const double* x, const double* y, int count, double* lo, double* hi) {
  const bool level = sweep.rise == 0.0 && !sweep.solid->flat && !sweep.solid->ball;
  if (sweep.length > 0.0 && !level) {
    lineColumns(sweep, x, y, padded(count), lo, hi);
  } else {
    radialColumns(sweep, x, y, padded(count), lo, hi);
  }
}
void columns(const ArcSweep& sweep, const double* x, const double* y, int count, double* lo, double* hi) {
  radialColumns(sweep, x, y, padded(count), lo, hi);
}
void columns(const TurnSweep& sweep, const double* x, const double* y, int count, double* lo, double* hi) {
  turnColumns(sweep, x, y, padded(count), lo, hi);
}
void columns(const UprightSweep& sweep, const double* x, const double* y, int count, double* lo, double* hi) {
  uprightColumns(sweep, x, y, padded(count), lo, hi);
}
void columns(const WaySweep& sweep, const double* x, const double* y, int count, double* lo, double* hi) {
  wayColumns(sweep, x, y, padded(count), lo, hi);
}

// Loops of fixed length are kept whole for the vectoriser.
void cover(proveout::LeafColumns& leaf, int quarter) {
  const int first = quarter * kQuarter;
  const double* __restrict lo = leaf.lo + first;
  const double* __restrict hi = leaf.hi + first;
  double bits[kQuarter];
#pragma GCC unroll 1
  for (int c = 0; c < kQuarter; ++c) bits[c] = 0.0;
  double bit = 1.0;
  for (int z = 0; z < leaf.layers; ++z, bit *= 2.0) {
    const double at = leaf.z[z];
#pragma GCC unroll 1
    for (int c = 0; c < kQuarter; ++c) {
      const double above = lo[c] < at ? bit : 0.0;
      bits[c] += at < hi[c] ? above : 0.0;
    }
  }
  int whole[kQuarter];
#pragma GCC unroll 1
  for (int c = 0; c < kQuarter; ++c) whole[c] = static_cast<int>(bits[c]);
  for (int c = 0; c < kQuarter; ++c) leaf.covered[first + c] = static_cast<unsigned char>(whole[c]);
}

double lowerTops(proveout::LeafColumns& leaf, int quarter) {
  const int first = quarter * kQuarter;
  const double bottom = leaf.z[0];
  double* __restrict top = leaf.top + first;
  const double* __restrict lo = leaf.lo + first;
  const double* __restrict hi = leaf.hi + first;
  double sunk[kQuarter], below[kQuarter];
#pragma GCC unroll 1
  for (int c = 0; c < kQuarter; ++c) {
    const double low = most(lo[c], bottom), old = top[c];
    const double next = hi[c] >= old ? least(low, old) : old;
    const double buried = hi[c] < old ? 1.0 : 0.0;
    below[c] = lo[c] < hi[c] ? buried : 0.0;
    sunk[c] = old - next;
    top[c] = next;
  }
  double sum[8] = {0, 0, 0, 0, 0, 0, 0, 0}, deep = 0.0;
  for (int c = 0; c < kQuarter; c += 8) {
    for (int i = 0; i < 8; ++i) sum[i] += sunk[c + i];
  }
  for (int c = 0; c < kQuarter; ++c) deep += below[c];
  double total = ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  if (deep > 0.0) {  // cut out below the top: whole voxels
    leaf.undercut = true;
    cover(leaf, quarter);
    for (int c = 0; c < kQuarter; ++c) {
      const unsigned cut = leaf.covered[first + c] & leaf.material[first + c];
      if (below[c] > 0.0) total += leaf.h * __builtin_popcount(cut);
    }
  }
  return total;
}

template <typename Way>
void leafColumns(const Way& sweep, proveout::LeafColumns& leaf, unsigned quarters) {
  for (int q = 0; q < 4; ++q) {
    const int from = q * kQuarter;
    while (q < 4 && (quarters >> q & 1) != 0) ++q;
    const int count = q * kQuarter - from;
    if (count > 0) columns(sweep, leaf.x + from, leaf.y + from, count, leaf.lo + from, leaf.hi + from);
  }
}

/// A hit's squared distance may be off by rounding, mm2; beyond such a slope by more.
constexpr double kHitSlack = 1e-7, kHitSlope = 100.0;

/// A top is below lo just where it lies outside of the capsule that the ball's middle moves along the axis
/// of, and below the middle: that takes no root. Most passes that come near a leaf take nothing from it.
unsigned leafHits(const LineSweep& sweep, const proveout::LeafColumns& leaf, unsigned quarters) {
  const proveout::ColumnSolid& tool = *sweep.solid;
  const double fx = sweep.x, fy = sweep.y, ux = sweep.ux, uy = sweep.uy;
  const double length = sweep.length, slope = sweep.slope, lift = sweep.z + tool.radius;
  if (sweep.length == 0.0 || !tool.ball || slope * slope > kHitSlope * kHitSlope) return quarters;
  const double bottom = leaf.z[0];
  const double toward = -slope / (1.0 + slope * slope), within = tool.radius * tool.radius + kHitSlack;
  unsigned hits = 0;
  for (int q = 0; q < 4; ++q) {
    if ((quarters >> q & 1) == 0) continue;
    const double* __restrict x = leaf.x + q * kQuarter;
    const double* __restrict y = leaf.y + q * kQuarter;
    const double* __restrict top = leaf.top + q * kQuarter;
    double gap2[kQuarter];
#pragma GCC unroll 1
    for (int i = 0; i < kQuarter; ++i) {
      const double qx = x[i] - fx, qy = y[i] - fy;
      const double along = qx * ux + qy * uy, across = qx * uy - qy * ux;
      // Of the middle: from the top's height up, where it is over the column, and where it is nearest to the
      // top.
      const double up = lift + slope * along - top[i], beyond = length - along;
      const double s = least(most(toward * up, -along), beyond), rise = up + slope * s;
      const double level = least(most(0.0, -along), beyond);
      const double near = rise > 0.0 ? s * s + rise * rise : level * level;
      gap2[i] = top[i] > bottom ? near + across * across : kNoHeight;
    }
    double nearest[8];
    for (int i = 0; i < 8; ++i) nearest[i] = least(gap2[i], gap2[i + 8]);
    for (int i = 0; i < 4; ++i) nearest[i] = least(nearest[i], nearest[i + 4]);
    const double all = least(least(nearest[0], nearest[1]), least(nearest[2], nearest[3]));
    hits |= all < within ? 1u << q : 0u;
  }
  return hits;
}

/// Squared level distance of the tool's axis from the middles of the blocks, and the range of the tip's rise
/// while it can be over them.
inline void approach(const LineSweep& sweep, const proveout::FourBlocks& blocks, double reach,
                     double* __restrict gap2, double* __restrict rise_low, double* __restrict rise_high) {
  const double fx = sweep.x, fy = sweep.y, ux = sweep.ux, uy = sweep.uy;
  const double length = sweep.length, slope = sweep.slope, rise = sweep.rise;
  if (length == 0.0) {
    for (int i = 0; i < 4; ++i) {
      const double qx = blocks.x[i] - fx, qy = blocks.y[i] - fy;
      const double gap = root(qx * qx + qy * qy);
      gap2[i] = gap * gap;
      rise_low[i] = least(rise, 0.0);
      rise_high[i] = most(rise, 0.0);
    }
    return;
  }
  for (int i = 0; i < 4; ++i) {
    const double qx = blocks.x[i] - fx, qy = blocks.y[i] - fy;
    const double along = qx * ux + qy * uy, across = qx * uy - qy * ux;
    const double over = along - least(most(along, 0.0), length);
    gap2[i] = over * over + across * across;
    const double first = slope * least(most(along - reach, 0.0), length),
                 last = slope * least(most(along + reach, 0.0), length);
    rise_low[i] = least(first, last);
    rise_high[i] = most(first, last);
  }
}
inline void approach(const ArcSweep& sweep, const proveout::FourBlocks& blocks, double,
                     double* __restrict gap2, double* __restrict rise_low, double* __restrict rise_high) {
  for (int i = 0; i < 4; ++i) {
    const double qx = blocks.x[i] - sweep.x, qy = blocks.y[i] - sweep.y;
    const double gap = root(qx * qx + qy * qy) - sweep.arc_radius;
    gap2[i] = gap * gap;
    rise_low[i] = rise_high[i] = 0.0;
  }
}

/// Lines and level arcs; of curves see curveReach.
template <typename Way>
void reachFour(const Way& sweep, const proveout::FourBlocks& blocks, double* __restrict low,
               double* __restrict high) {
  constexpr double kDiagonal = 1.4142135623730951, kSlack = proveout::kCullSlackMm;
  const proveout::ColumnSolid& tool = *sweep.solid;
  const double corner = kDiagonal * blocks.half_width, radius = tool.radius, reach = corner + radius + kSlack;
  double gap2[4], rise_low[4], rise_high[4], radial[4], edge[4], top[4];
  approach(sweep, blocks, reach, gap2, rise_low, rise_high);
  for (int i = 0; i < 4; ++i) low[i] = kNoHeight, high[i] = -kNoHeight, top[i] = -tool.z_max;
  if (least(least(gap2[0], gap2[1]), least(gap2[2], gap2[3])) > reach * reach) return;
  if (tool.flat) {
    for (int i = 0; i < 4; ++i) edge[i] = tool.z_min;
  } else {
    for (int i = 0; i < 4; ++i) radial[i] = least(most(root(gap2[i]) - corner, 0.0), radius);
    if (tool.ball) {
      for (int i = 0; i < 4; ++i) edge[i] = radius - root(radius * radius - radial[i] * radial[i]);
    } else {
      boundaryHeight(tool.lower, radial, 4, edge);
    }
    if (tool.round_top) boundaryHeight(tool.upper, radial, 4, top);
  }
  for (int i = 0; i < 4; ++i) {
    const double at = sweep.z + rise_low[i], highest = sweep.z + rise_high[i] - top[i] + kSlack;
    const double lowest = at + edge[i] - kSlack;
    const bool in = gap2[i] <= reach * reach && lowest < blocks.z_high[i] && highest > blocks.z_low[i];
    low[i] = in ? lowest : kNoHeight;
    high[i] = in ? highest : -kNoHeight;
  }
}

proveout::ColumnKernels kernels(const char* name) {
  return {{columns, leafColumns<LineSweep>, reachFour<LineSweep>},
          {columns, leafColumns<ArcSweep>, reachFour<ArcSweep>},
          {columns, leafColumns<TurnSweep>, proveout::curveReach},
          {columns, leafColumns<UprightSweep>, proveout::curveReach},
          {columns, leafColumns<WaySweep>, proveout::curveReach},
          poseColumns,
          lowerTops,
          leafHits,
          poseHits,
          poseReach,
          cover,
          edgeCuts,
          name};
}

}  // namespace
