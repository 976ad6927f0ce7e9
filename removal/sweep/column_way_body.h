// Columns of parts of any way, where their lower ends are level discs, spheres or corners that go on from a
// disc, and their tops level; only for column_kernel_body.h, whose rules hold here.
//
// Seen from above the part bends less than a circle around the column would that holds all of it: so the
// level distance of the tool's axis falls and then grows, and the tool is over the column along one stretch,
// whose ends and nearest place Newton's method finds. By the level way the square of the distance is convex
// on it, and the boundary by the square where it is a sphere or a corner; with a height that is convex, too,
// or bends less, the sum has one least value, where its slope, times what keeps it finite at the rim, is 0.
// Columns of which that is not proven are searched alone.
#pragma once

/// Rounds of Newton's methods on a part; columns that need more are searched alone.
constexpr int kWayRounds = 20;

#include "removal/sweep/column_way_at.h"

/// Columns of a part. Where the tool is over none of it `over` is 0 and the stretch is empty.
struct WayColumns {
  double x[kArray], y[kArray];          ///< from the part's middle
  double near[kArray], square[kArray];  ///< place that is nearest, and its squared distance
  double from[kArray], to[kArray];      ///< of the stretch, rad
  double over[kArray], alone[kArray];   ///< 1: to be searched alone
};

/// Which columns may see the part, and which of them may be nearest to it twice.
inline void boundWay(const proveout::WayPart& w, double radius, int n, WayColumns& c) {
  constexpr double kSure = 0.99;
  const double within = kSure / most(w.curvature, 1e-300) - w.reach, touch = radius + w.reach;
  for (int i = 0; i < n; ++i) {
    const double off = root(c.x[i] * c.x[i] + c.y[i] * c.y[i]);
    c.over[i] = off < touch ? 1.0 : 0.0;
    c.alone[i] = off < touch && !(off < within) ? 1.0 : 0.0;
  }
}

/// Where the way is nearest to the columns.
inline void nearestOnWay(const proveout::WayPart& w, int n, WayColumns& c) {
  double low[kArray], high[kArray], open[kArray];
  const double still = wayStill(w), vx = w.end_vx[1], vy = w.end_vy[1];
  const double speed2 = most(vx * vx + vy * vy, 1e-300);
  for (int i = 0; i < n; ++i) {
    const double px = c.x[i], py = c.y[i];
    const double first = (w.end_x[0] - px) * w.end_vx[0] + (w.end_y[0] - py) * w.end_vy[0];
    const double last = (w.end_x[2] - px) * w.end_vx[2] + (w.end_y[2] - py) * w.end_vy[2];
    const double guess = (px * vx + py * vy) / speed2;
    const bool begins = first >= 0.0, ends = last <= 0.0;
    low[i] = -w.half, high[i] = w.half;
    c.near[i] = begins ? -w.half : ends ? w.half : least(most(guess, -0.99 * w.half), 0.99 * w.half);
    open[i] = begins || ends || c.over[i] == 0.0 || c.alone[i] > 0.0 ? 0.0 : 1.0;
  }
  for (int round = 0; round < kWayRounds; ++round) {
    double left = 0.0;
    for (int i = 0; i < n; ++i) left = most(left, open[i]);
    if (left == 0.0) break;
    for (int i = 0; i < n; ++i) {
      const double t = c.near[i];
      const WayAt at = wayAt(w, c.x[i], c.y[i], t);
      const WayStep s = wayStep(at.toward(), at.sideBend(), t, low[i], high[i]);
      const bool going = open[i] > 0.0;
      low[i] = going ? s.low : low[i];
      high[i] = going ? s.high : high[i];
      c.near[i] = going ? s.next : t;
      open[i] = going && s.moved > still ? 1.0 : 0.0;
    }
  }
  for (int i = 0; i < n; ++i) {
    c.square[i] = wayAt(w, c.x[i], c.y[i], c.near[i]).square();
    c.alone[i] = most(c.alone[i], open[i]);
  }
}

/// Where the rim comes to be over the columns, towards the end at `side` * half.
inline void endOnWay(const proveout::WayPart& w, double radius2, double side, int n, WayColumns& c,
                     double* __restrict end) {
  const int k = side < 0.0 ? 0 : 2;
  const double still = wayStill(w), vx = w.end_vx[1], vy = w.end_vy[1];
  const double speed2 = most(vx * vx + vy * vy, 1e-300);
  double low[kArray], high[kArray], open[kArray];
  for (int i = 0; i < n; ++i) {
    const double qx = w.end_x[k] - c.x[i], qy = w.end_y[k] - c.y[i];
    const bool held = qx * qx + qy * qy <= radius2;
    const double width = side < 0.0 ? c.near[i] + w.half : w.half - c.near[i];
    // As on a line at the middle's speed.
    const double guess = root((radius2 - c.square[i]) / speed2);
    low[i] = 0.0, high[i] = width;
    end[i] = held ? width : guess < width ? guess : 0.5 * width;
    open[i] = held || c.over[i] == 0.0 || c.alone[i] > 0.0 ? 0.0 : 1.0;
  }
  for (int round = 0; round < kWayRounds; ++round) {
    double left = 0.0;
    for (int i = 0; i < n; ++i) left = most(left, open[i]);
    if (left == 0.0) break;
    for (int i = 0; i < n; ++i) {
      const double t = end[i];
      const WayAt at = wayAt(w, c.x[i], c.y[i], c.near[i] + side * t);
      const WayStep s = wayStep(0.5 * (at.square() - radius2), side * at.toward(), t, low[i], high[i]);
      const bool going = open[i] > 0.0;
      low[i] = going ? s.low : low[i];
      high[i] = going ? s.high : high[i];
      end[i] = going ? s.next : t;
      open[i] = going && s.moved > still ? 1.0 : 0.0;
    }
  }
  for (int i = 0; i < n; ++i) {
    end[i] = c.near[i] + side * end[i];
    c.alone[i] = most(c.alone[i], open[i]);
  }
}

/// out = least of side * height over the stretch.
inline void leastHeight(const proveout::WayPart& w, double side, int n, WayColumns& c,
                        double* __restrict out) {
  const double still = wayStill(w), down = side > 0.0 ? w.least_bend : -w.most_bend,
               up = side > 0.0 ? w.most_bend : -w.least_bend, steepest = most(up, -down);
  double low[kArray], high[kArray], at[kArray], open[kArray];
  double inner = 0.0;
  for (int i = 0; i < n; ++i) {
    const WayAt a = wayAt(w, 0.0, 0.0, c.from[i]), b = wayAt(w, 0.0, 0.0, c.to[i]);
    const double sa = side * a.vz, sb = side * b.vz, width = c.to[i] - c.from[i];
    out[i] = least(side * a.z, side * b.z);
    const bool within = sa < 0.0 && sb > 0.0 && c.over[i] > 0.0;
    // Slopes alike at both ends, with a rise or fall between them.
    const double flat = least(sa < 0.0 ? -sa : sa, sb < 0.0 ? -sb : sb);
    const bool hidden = down < 0.0 && up > 0.0 && !within && flat <= steepest * width;
    c.alone[i] = c.over[i] > 0.0 && hidden ? 1.0 : c.alone[i];
    low[i] = c.from[i], high[i] = c.to[i];
    at[i] = within ? c.from[i] - sa * width / (sb - sa) : c.from[i];
    open[i] = within ? 1.0 : 0.0;
    inner = most(inner, open[i]);
  }
  if (inner == 0.0) return;
  for (int round = 0; round < kWayRounds && inner > 0.0; ++round) {
    inner = 0.0;
    for (int i = 0; i < n; ++i) {
      const WayAt a = wayAt(w, 0.0, 0.0, at[i]);
      const WayStep s = wayStep(side * a.vz, side * a.az, at[i], low[i], high[i]);
      const bool going = open[i] > 0.0;
      low[i] = going ? s.low : low[i];
      high[i] = going ? s.high : high[i];
      at[i] = going ? s.next : at[i];
      open[i] = going && s.moved > still ? 1.0 : 0.0;
    }
    for (int i = 0; i < n; ++i) inner = most(inner, open[i]);
  }
  for (int i = 0; i < n; ++i) {
    out[i] = least(out[i], side * wayAt(w, 0.0, 0.0, at[i]).z);
    c.alone[i] = most(c.alone[i], open[i]);
  }
}

/// out = least of a sphere (rc = 0), or of the corner around a disc of radius rc, + height over the stretch.
inline void leastRound(const proveout::WayPart& w, const ColumnBoundary::Piece& piece, int n, WayColumns& c,
                       double* __restrict out) {
  // Half of the least second derivative of the square by the level way.
  const double bends = 1.0 - w.curvature * (piece.rc + piece.radius);
  const double rc = piece.rc, radius2 = piece.radius * piece.radius, zc = piece.zc, still = wayStill(w);
  double low[kArray], high[kArray], at[kArray], open[kArray];
  for (int i = 0; i < n; ++i) {
    const double d = root(c.square[i]), over = most(d - rc, 0.0), q = root(radius2 - over * over);
    const double grows = rc == 0.0 ? bends / q : over > 0.0 ? bends * over / (d * q) : 0.0;
    const bool proven = w.sag >= 0.0 || grows + w.sag >= 0.0;
    c.alone[i] = c.over[i] > 0.0 && !proven ? 1.0 : c.alone[i];
    const double first = wayRound(wayAt(w, c.x[i], c.y[i], c.from[i]), rc, radius2).value;
    const double last = wayRound(wayAt(w, c.x[i], c.y[i], c.to[i]), rc, radius2).value;
    const WayAt near = wayAt(w, c.x[i], c.y[i], c.near[i]);
    const double speed2 = most(near.vx * near.vx + near.vy * near.vy, 1e-300), slope2 = near.vz * near.vz;
    // As on the line that touches the way where it is nearest.
    const double lean = root(slope2 / (slope2 + speed2)), r = rc + piece.radius * lean;
    const double away = rc == 0.0 ? lean * root(radius2 - c.square[i]) : root(r * r - c.square[i]);
    const double step = away / root(speed2), guess = near.vz > 0.0 ? c.near[i] - step : c.near[i] + step;
    const bool begins = first >= 0.0, ends = last <= 0.0;
    const bool in = guess > c.from[i] && guess < c.to[i];
    low[i] = c.from[i], high[i] = c.to[i];
    at[i] = begins ? c.from[i] : ends ? c.to[i] : in ? guess : 0.5 * (c.from[i] + c.to[i]);
    open[i] = begins || ends || c.over[i] == 0.0 || c.alone[i] > 0.0 ? 0.0 : 1.0;
  }
  for (int round = 0; round < kWayRounds; ++round) {
    double left = 0.0;
    for (int i = 0; i < n; ++i) left = most(left, open[i]);
    if (left == 0.0) break;
    for (int i = 0; i < n; ++i) {
      const WayRound f = wayRound(wayAt(w, c.x[i], c.y[i], at[i]), rc, radius2);
      const WayStep s = wayStep(f.value, f.slope, at[i], low[i], high[i]);
      const bool going = open[i] > 0.0;
      low[i] = going ? s.low : low[i];
      high[i] = going ? s.high : high[i];
      at[i] = going ? s.next : at[i];
      open[i] = going && s.moved > still ? 1.0 : 0.0;
    }
  }
  for (int i = 0; i < n; ++i) {
    const WayAt a = wayAt(w, c.x[i], c.y[i], at[i]);
    const double over = most(root(a.square()) - rc, 0.0);
    out[i] = a.z + zc - root(radius2 - over * over);
    c.alone[i] = most(c.alone[i], open[i]);
  }
}

/// A level disc, a sphere, or a disc with a corner around it.
inline bool isPlainEnd(const ColumnBoundary& boundary) {
  const ColumnBoundary::Piece *first = boundary.piece, *last = boundary.piece + boundary.count - 1;
  if (boundary.count == 1)
    return first->kind == ColumnBoundary::Kind::kLevel ||
           (first->kind == ColumnBoundary::Kind::kArc && first->rc == 0.0);
  return boundary.count == 2 && first->kind == ColumnBoundary::Kind::kLevel &&
         last->kind == ColumnBoundary::Kind::kArc && last->rc == last->ra;
}

inline void wayColumns(const WaySweep& sweep, const double* __restrict x, const double* __restrict y, int n,
                       double* __restrict lo, double* __restrict hi) {
  const proveout::ColumnSolid& tool = *sweep.solid;
  if (sweep.twice || tool.round_top || !isPlainEnd(tool.lower)) {
    for (int i = 0; i < n; ++i) proveout::curveColumn(sweep, x[i], y[i], lo + i, hi + i);
    return;
  }
  const proveout::WayPart& w = *sweep.plain;
  const double radius2 = tool.radius * tool.radius;
  WayColumns c;
  for (int i = 0; i < n; ++i) c.x[i] = x[i] - w.x, c.y[i] = y[i] - w.y;
  boundWay(w, tool.radius, n, c);
  nearestOnWay(w, n, c);
  double any = 0.0;
  for (int i = 0; i < n; ++i) {
    c.over[i] = c.alone[i] == 0.0 && c.square[i] < radius2 ? c.over[i] : 0.0;
    any = most(any, c.over[i]);
  }
  if (any > 0.0) {
    const ColumnBoundary::Piece& last = tool.lower.piece[tool.lower.count - 1];
    endOnWay(w, radius2, -1.0, n, c, c.from);
    endOnWay(w, radius2, 1.0, n, c, c.to);
    leastHeight(w, -1.0, n, c, hi);
    if (last.kind == ColumnBoundary::Kind::kLevel) {
      leastHeight(w, 1.0, n, c, lo);
      for (int i = 0; i < n; ++i) lo[i] += last.za;
    } else {
      leastRound(w, last, n, c, lo);
    }
  }
  for (int i = 0; i < n; ++i) {
    const bool over = c.over[i] > 0.0;
    lo[i] = over ? w.z + lo[i] : kNoHeight;
    hi[i] = over ? w.z + tool.z_max - hi[i] : -kNoHeight;
  }
  for (int i = 0; i < n; ++i) {
    if (c.alone[i] > 0.0) proveout::curveColumn(sweep, x[i], y[i], lo + i, hi + i);
  }
}
