// Where grid edges enter what a turn of a helix sweeps, many at once; only for column_kernel_body.h, whose
// rules hold here. The same is asked of one edge after the other in column_curve.cpp (curveSide) and
// swept_body_cut.cpp, which have what is left: columns to be searched alone, and edges on which Newton's
// method does not lead straight to the end.
#pragma once

/// Rounds of Newton's method; an edge that needs more is asked alone.
constexpr int kCutRounds = 8;
/// As in swept_body_cut.cpp and column_curve.cpp.
constexpr double kWorth = 0.5, kLastStepMm = 1e-7, kNearMm = 1e-6, kZeroMm = 1e-10, kAtEdgeMm = 1e-7;

/// Points as a turn sees them: see CurveSide.
struct TurnPoints {
  double x[kArray], y[kArray], value[kArray], slope[kArray], place[kArray];
  double known[kArray];  ///< 1: what is told of it holds
};

/// One end of the columns: its height over the tip, and the place that has it.
struct TurnEnd {
  double height[kArray], u[kArray];
};

inline void findEnd(const ColumnBoundary& boundary, double steep, int n, TurnColumns& c, TurnSide& side,
                    TurnEnd& end) {
  double r[kArray], rise[kArray];
  findOnTurn(boundary, steep, n, c, side);
  seeOnTurn(boundary.piece[boundary.count - 1].rb, n, c, side, r, rise);
  addBoundary(boundary, n, r, rise, end.height);
  for (int i = 0; i < n; ++i) end.u[i] = side.way[i] * root(side.at2[i]);
}

/// out = slope of the boundary at r; at_edge = 1 where r is at an end of a piece.
inline void boundarySlopes(const ColumnBoundary& boundary, const double* __restrict r, int n,
                           double* __restrict out, double* __restrict at_edge) {
  for (int p = 0; p < boundary.count; ++p) {
    const ColumnBoundary::Piece& piece = boundary.piece[p];
    const bool arc = piece.kind == ColumnBoundary::Kind::kArc, first = p == 0;
    const double ra = piece.ra, rb = piece.rb, rc = piece.rc, radius2 = piece.radius * piece.radius;
    const double straight = piece.slope;
    for (int i = 0; i < n; ++i) {
      const double d = r[i] - rc, round = d / root(radius2 - d * d);
      const double slope = arc ? (d == 0.0 ? 0.0 : round) : straight;
      const bool here = first || r[i] >= ra;
      const bool edge = r[i] > rb - kAtEdgeMm || (!first && r[i] < ra + kAtEdgeMm);
      out[i] = here ? slope : out[i];
      at_edge[i] = here ? (edge ? 1.0 : 0.0) : at_edge[i];
    }
  }
}

/// Which of three decides a point: the lower end of its column, the upper, or the rim.
struct TurnDecides {
  double lower[kArray], upper[kArray], u[kArray];
};

inline void decideOnTurn(double radius, const proveout::EdgeCuts& cuts, int n, const TurnColumns& c,
                         const TurnEnd& lo, const TurnEnd& hi, TurnPoints& p, TurnDecides& by) {
  for (int i = 0; i < n; ++i) {
    const double nearest = most(c.from[i], least(0.0, c.to[i]));
    const double beyond = root(c.p2[i] + c.k2[i] * nearest * nearest) - radius;
    const double low = c.base[i] + lo.height[i] - cuts.z[i], high = cuts.z[i] - (c.base[i] - hi.height[i]);
    const bool level = cuts.end[i] == 0.0, above = level ? low >= high : cuts.end[i] > 0.0;
    const bool rim = level && most(low, high) < beyond;
    p.value[i] = most(most(low, high), beyond);
    p.known[i] = c.over[i] > 0.0 && c.alone[i] == 0.0 ? 1.0 : 0.0;
    by.lower[i] = !rim && above ? 1.0 : 0.0;
    by.upper[i] = !rim && !above ? 1.0 : 0.0;
    by.u[i] = rim ? nearest : (above ? lo.u[i] : hi.u[i]);
  }
}

/// Slopes along the edges, and places, from what decides the points.
inline void leadOnTurn(const TurnSweep& s, const proveout::EdgeCuts& cuts, int n, const TurnColumns& c,
                       const TurnDecides& by, TurnPoints& p) {
  const double cx = s.x, cy = s.y, arc = s.arc_radius, turn = s.turn, rise = s.slope;
  double r[kArray], across[kArray], leaves[kArray];
  double lower[kArray], upper[kArray], low_edge[kArray], high_edge[kArray];
  for (int i = 0; i < n; ++i) {
    const double qx = p.x[i] - cx, qy = p.y[i] - cy, d = most(root(qx * qx + qy * qy), 1e-12), k = arc / d;
    const double u = by.u[i], v = u < 0.0 ? -u : u, half = proveout::arcSine(least(v, 1.0));
    const double along = 1.0 - 2.0 * u * u, w = 2.0 * u * root(1.0 - u * u) * turn;
    const double ax = k * (along * qx - w * qy), ay = k * (w * qx + along * qy);
    const double ox = qx - ax, oy = qy - ay;
    r[i] = root(ox * ox + oy * oy);
    across[i] = ox * cuts.dx[i] + oy * cuts.dy[i];
    leaves[i] = turn * (ax * oy - ay * ox);
    p.place[i] = c.nearest[i] + (u < 0.0 ? -2.0 * half : 2.0 * half);
  }
  boundarySlopes(s.solid->lower, r, n, lower, low_edge);
  boundarySlopes(s.solid->upper, r, n, upper, high_edge);
  for (int i = 0; i < n; ++i) {
    const bool low = by.lower[i] > 0.0, high = by.upper[i] > 0.0;
    const double at_edge = low ? low_edge[i] : high_edge[i], steep = low ? lower[i] : upper[i];
    const double moves = leaves[i] == 0.0 ? 0.0 : (low ? rise : -rise) * across[i] / leaves[i];
    const double smooth = (low || high ? steep : 1.0) * across[i] / r[i];
    p.slope[i] = (low || high) && at_edge > 0.0 ? moves : smooth;
    p.known[i] = r[i] < kAtEdgeMm ? 0.0 : p.known[i];
  }
}

inline void lookAtTurn(const TurnSweep& s, const proveout::EdgeCuts& cuts, int n, TurnPoints& p) {
  const proveout::ColumnSolid& tool = *s.solid;
  TurnColumns c;
  TurnSide side;
  TurnEnd lo, hi;
  TurnDecides by;
  placeTurn(s, p.x, p.y, n, c);
  findEnd(tool.lower, 2.0 * s.slope, n, c, side, lo);
  if (tool.even && isEvenTurn(n, c)) {
    const double up = tool.upper.piece[0].za - tool.lower.piece[0].za;
    for (int i = 0; i < n; ++i) hi.height[i] = lo.height[i] + up, hi.u[i] = -lo.u[i];
  } else {
    findEnd(tool.upper, -2.0 * s.slope, n, c, side, hi);
  }
  decideOnTurn(tool.radius, cuts, n, c, lo, hi, p, by);
  leadOnTurn(s, cuts, n, c, by, p);
}

/// An edge while its end is searched: t of [from, to], value and slope at t.
struct CutSearch {
  double t[kArray], from[kArray], to[kArray], value[kArray], slope[kArray], place[kArray];
  double open[kArray];   ///< 1: not found yet
  double worth[kArray];  ///< 1: the last step was worth it
};

/// Takes one step of Newton's method from what is known; edges that are found or lost close.
inline void stepCuts(int n, CutSearch& c, proveout::EdgeCuts& cuts, TurnPoints& p) {
  for (int i = 0; i < n; ++i) {
    const bool open = c.open[i] > 0.0;
    const double value = c.value[i], size = value < 0.0 ? -value : value, slope = c.slope[i], t = c.t[i];
    const double next = t - value / slope, step = next < t ? t - next : next - t;
    const bool steep = slope < 0.0 || slope > 0.0;
    const bool last = open && steep && step < kLastStepMm && size < kNearMm;
    const bool good = open && steep && c.worth[i] > 0.0 && next > c.from[i] && next < c.to[i];
    const double clipped = most(0.0, least(next, cuts.inside[i]));
    cuts.at[i] = last ? clipped : cuts.at[i];
    cuts.place[i] = last ? c.place[i] : cuts.place[i];
    cuts.found[i] = last ? 1.0 : cuts.found[i];
    c.open[i] = good && !last ? 1.0 : 0.0;
    c.t[i] = good && !last ? next : t;
    p.x[i] = cuts.x[i] + c.t[i] * cuts.dx[i];
    p.y[i] = cuts.y[i] + c.t[i] * cuts.dy[i];
  }
}

/// Takes over what was seen at t.
inline void takeCuts(int n, const TurnPoints& p, CutSearch& c, proveout::EdgeCuts& cuts) {
  for (int i = 0; i < n; ++i) {
    const bool open = c.open[i] > 0.0 && p.known[i] > 0.0;
    const double value = p.value[i], size = value < 0.0 ? -value : value, t = c.t[i];
    const double before = c.value[i] < 0.0 ? -c.value[i] : c.value[i];
    const bool zero = open && size < kZeroMm;
    cuts.at[i] = zero ? t : cuts.at[i];
    cuts.place[i] = zero ? p.place[i] : cuts.place[i];
    cuts.found[i] = zero ? 1.0 : cuts.found[i];
    c.open[i] = open && !zero ? 1.0 : 0.0;
    c.worth[i] = size < kWorth * before ? 1.0 : 0.0;
    c.from[i] = value >= 0.0 ? t : c.from[i];
    c.to[i] = value >= 0.0 ? c.to[i] : t;
    c.value[i] = value;
    c.slope[i] = p.slope[i];
    c.place[i] = p.place[i];
  }
}

/// What the ends inside tell: vertical edges are done, and level ones whose ends are on the surface.
inline void startCuts(int n, const TurnPoints& p, CutSearch& c, proveout::EdgeCuts& cuts) {
  for (int i = 0; i < n; ++i) {
    const bool known = p.known[i] > 0.0, level = cuts.end[i] == 0.0, done = !level || p.value[i] >= 0.0;
    cuts.at[i] = cuts.inside[i];
    cuts.place[i] = p.place[i];
    cuts.found[i] = known && done ? 1.0 : 0.0;
    c.open[i] = known && !done ? 1.0 : 0.0;
    c.t[i] = c.to[i] = cuts.inside[i];
    c.from[i] = 0.0;
    c.worth[i] = 1.0;
    c.value[i] = p.value[i];
    c.slope[i] = p.slope[i];
    c.place[i] = p.place[i];
  }
}

void edgeCuts(const TurnSweep& sweep, proveout::EdgeCuts& cuts) {
  const int n = (cuts.count + 7) & ~7;
  for (int i = cuts.count; i < n; ++i) {
    cuts.x[i] = cuts.x[0], cuts.y[i] = cuts.y[0], cuts.z[i] = cuts.z[0];
    cuts.dx[i] = cuts.dx[0], cuts.dy[i] = cuts.dy[0], cuts.inside[i] = cuts.inside[0];
    cuts.end[i] = cuts.end[0];
  }
  for (int i = 0; i < n; ++i) cuts.found[i] = 0.0;
  TurnPoints p;
  CutSearch c;
  for (int i = 0; i < n; ++i) {
    p.x[i] = cuts.x[i] + cuts.inside[i] * cuts.dx[i];
    p.y[i] = cuts.y[i] + cuts.inside[i] * cuts.dy[i];
  }
  lookAtTurn(sweep, cuts, n, p);
  startCuts(n, p, c, cuts);
  for (int round = 0; round < kCutRounds; ++round) {
    stepCuts(n, c, cuts, p);
    double left = 0.0;
    for (int i = 0; i < n; ++i) left = most(left, c.open[i]);
    if (left == 0.0) return;
    lookAtTurn(sweep, cuts, n, p);
    takeCuts(n, p, c, cuts);
  }
}
