// Columns of turns of helices and of upright arcs, as far as they have closed forms; only for
// column_kernel_body.h, whose rules hold here. What the sums are is told in column_curve.cpp.
//
// A turn: where the boundary is a cone or a sphere, its slope is that of the height at the roots of a
// quadratic in u^2; the sum falls up to the first root, and again behind the second. On corners of a torus
// Newton's method finds the place, where the difference of the slopes is known to grow. Columns that may have
// more than one such place are left to the search for one column.
#pragma once

/// Rounds of Newton's method on a corner; columns that need more are searched alone.
constexpr int kCornerRounds = 24;
constexpr double kHalfTurn = 3.14159265358979323846;

/// Columns of a turn. Where the tool is over none of it `over` is 0 and the stretch is empty.
struct TurnColumns {
  double p2[kArray], k2[kArray];      ///< the level distance is sqrt(p2 + k2 u^2), mm
  double per_k2[kArray];              ///< 1 / k2
  double from[kArray], to[kArray];    ///< of u
  double base[kArray], over[kArray];  ///< height of the tip at u = 0, mm
  double nearest[kArray];             ///< angle of the way at u = 0
  double alone[kArray];               ///< 1: to be searched alone
};

/// The stretch of q = u^2 to the side where the way falls, what is found on it, and a piece of the boundary.
/// Squares need no roots.
struct TurnSide {
  double from2[kArray], to2[kArray];
  double steep[kArray];  ///< slope of the height is -steep / sqrt(1 - q)
  double sign[kArray];   ///< the height is sign asin(sqrt(q))
  double way[kArray];    ///< u = way sqrt(q)
  double at2[kArray];    ///< the sum falls up to there
  double falls[kArray];  ///< 1: and does not rise anywhere before the piece
  double a2[kArray], b2[kArray];
};

/// Ends of the stretches of columns that see an end of the way.
inline void cutTurnEnds(int n, const double* __restrict first, const double* __restrict last,
                        TurnColumns& c) {
  for (int i = 0; i < n; ++i) {
    const double reach = c.to[i];
    if (c.over[i] == 0.0) continue;
    // The sine of half an angle of the half circle is no less than the angle by pi.
    if (-first[i] < kHalfTurn * reach) c.from[i] = most(-reach, __builtin_sin(0.5 * first[i]));
    if (last[i] < kHalfTurn * reach) c.to[i] = least(reach, __builtin_sin(0.5 * last[i]));
    if (c.from[i] < c.to[i]) continue;
    c.over[i] = c.from[i] = c.to[i] = 0.0;
  }
}

inline void placeTurn(const TurnSweep& s, const double* __restrict x, const double* __restrict y, int n,
                      TurnColumns& c) {
  const double cx = s.x, cy = s.y, ux = s.ux, uy = s.uy, turn = s.turn, arc = s.arc_radius;
  const double radius = s.solid->radius, cut = s.cut_rad, turn_rad = s.turn_rad, way = s.way_rad;
  const double start_z = s.start_z, slope = s.slope;
  double first[kArray], last[kArray], ends[8] = {0, 0, 0, 0, 0, 0, 0, 0};
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - cx, qy = y[i] - cy;
    const double d = root(qx * qx + qy * qy), far = d - arc, gap = far < 0.0 ? -far : far;
    const double angle = proveout::turnAngle(qx * ux + qy * uy, turn * (ux * qy - uy * qx), d, cut);
    const double nearest = angle + turn_rad;
    first[i] = most(-kHalfTurn, -nearest);
    last[i] = least(kHalfTurn, way - nearest);
    const bool over = gap < radius && first[i] < last[i];
    const double p2 = gap * gap, k2 = most(4.0 * arc * d, proveout::kLeastAcross), per_k2 = 1.0 / k2;
    const double reach = over ? least(1.0, root((radius * radius - p2) * per_k2)) : 0.0;
    c.p2[i] = over ? p2 : 0.0;
    c.k2[i] = over ? k2 : 1.0;
    c.per_k2[i] = over ? per_k2 : 1.0;
    c.base[i] = start_z + slope * nearest;
    c.nearest[i] = nearest;
    c.from[i] = -reach;
    c.to[i] = reach;
    c.over[i] = over ? 1.0 : 0.0;
    c.alone[i] = 0.0;
  }
  for (int i = 0; i < n; i += 8) {
    for (int k = 0; k < 8; ++k) {
      const double seen = kHalfTurn * c.to[i + k];
      ends[k] = most(ends[k], most(seen + first[i + k], seen - last[i + k]));
    }
  }
  double any = 0.0;
  for (int k = 0; k < 8; ++k) any = most(any, ends[k]);
  if (any > 0.0) cutTurnEnds(n, first, last, c);
}

/// Takes the places up to which the sum falls; columns on which it falls again on the piece, `again`, are
/// left to the search. No column depends on another.
inline void takeRoots(int n, const double* __restrict rises2, const double* __restrict again, TurnColumns& c,
                      TurnSide& side) {
  for (int i = 0; i < n; ++i) {
    const double a2 = side.a2[i], b2 = side.b2[i];
    const bool in = a2 <= b2, falls = in && side.falls[i] > 0.0;
    side.at2[i] = falls ? most(a2, least(rises2[i], b2)) : side.at2[i];
    side.falls[i] = falls && rises2[i] < b2 ? 0.0 : side.falls[i];
    c.alone[i] = in && a2 < b2 && again[i] > 0.0 ? 1.0 : c.alone[i];
  }
}

/// On a level piece the sum falls to its end.
inline void levelRoots(int n, TurnSide& side) {
  for (int i = 0; i < n; ++i) {
    const bool falls = side.a2[i] <= side.b2[i] && side.falls[i] > 0.0;
    side.at2[i] = falls ? side.b2[i] : side.at2[i];
  }
}

inline void straightRoots(double rise, int n, TurnColumns& c, TurnSide& side) {
  double rises2[kArray], again[kArray];
  for (int i = 0; i < n; ++i) {
    const double steep2 = side.steep[i] * side.steep[i], rise_k = rise * rise * c.k2[i];
    // rise_k k2 q^2 - (rise_k - steep2) k2 q + steep2 p2 = 0
    const double most_q = (rise_k - steep2) * c.k2[i], last_q = steep2 * c.p2[i], first_q = rise_k * c.k2[i];
    const double inner = most_q * most_q - 4.0 * first_q * last_q;
    const bool any = most_q > 0.0 && inner >= 0.0;
    const double sum = most_q + root(inner);
    rises2[i] = any ? 2.0 * last_q / sum : kNoHeight;
    again[i] = any && sum < 2.0 * first_q * side.b2[i] ? 1.0 : 0.0;
  }
  takeRoots(n, rises2, again, c, side);
}

inline void sphereRoots(double radius, int n, TurnColumns& c, TurnSide& side) {
  double rises2[kArray], again[kArray];
  for (int i = 0; i < n; ++i) {
    const double steep2 = side.steep[i] * side.steep[i], k2 = c.k2[i];
    // k2 q^2 - (k2 + steep2) q + steep2 w2 / k2 = 0
    const double most_q = k2 + steep2, w2 = radius * radius - c.p2[i], last_q = steep2 * w2 * c.per_k2[i];
    const double inner = most_q * most_q - 4.0 * k2 * last_q;
    const double sum = most_q + root(inner);
    rises2[i] = inner >= 0.0 ? 2.0 * last_q / sum : kNoHeight;
    again[i] = inner >= 0.0 && sum < 2.0 * k2 * side.b2[i] ? 1.0 : 0.0;
  }
  takeRoots(n, rises2, again, c, side);
}

/// Newton's method for d k2 v c - steep r q = 0 with v = |u|, c = sqrt(1 - v^2), which has the sign of the
/// slope.
inline void cornerNewton(const ColumnBoundary::Piece& piece, int n, const TurnColumns& c,
                         const TurnSide& side, double* __restrict low, double* __restrict high,
                         double* __restrict open) {
  const double rc = piece.rc, radius2 = piece.radius * piece.radius;
  double v[kArray];
  for (int i = 0; i < n; ++i) v[i] = 0.5 * (low[i] + high[i]);
  for (int round = 0; round < kCornerRounds; ++round) {
    double left = 0.0;
    for (int i = 0; i < n; ++i) {
      const double t = v[i], k2 = c.k2[i], steep = side.steep[i];
      const double r = root(c.p2[i] + k2 * t * t), d = r - rc, q = root(radius2 - d * d),
                   w = root(1.0 - t * t);
      const double value = d * k2 * t * w - steep * r * q, step_r = k2 * t / r;
      const double slope = k2 * (step_r * t * w + d * w - d * t * t / w) - steep * step_r * (q - d * r / q);
      const double from = value < 0.0 ? t : low[i], to = value < 0.0 ? high[i] : t;
      const double newton = t - value / slope, step = newton < t ? t - newton : newton - t;
      const bool in = newton > from && newton<to, going = open[i]> 0.0;
      const double next = in ? newton : 0.5 * (from + to), near = in ? step : to - from;
      low[i] = going ? from : low[i];
      high[i] = going ? to : high[i];
      v[i] = going ? next : t;
      open[i] = going && near * near * k2 > kStationaryMm * kStationaryMm ? 1.0 : 0.0;
    }
    for (int i = 0; i < n; ++i) left = most(left, open[i]);
    if (left == 0.0) break;
  }
  for (int i = 0; i < n; ++i) low[i] = v[i];
}

/// A corner of a torus. Its slope along the way grows at least as its ends tell.
inline void cornerRoots(const ColumnBoundary::Piece& piece, int n, TurnColumns& c, TurnSide& side) {
  const double rc = piece.rc, ra = piece.ra, rb = piece.rb, radius2 = piece.radius * piece.radius;
  double low[kArray], high[kArray], open[kArray], again[kArray];
  for (int i = 0; i < n; ++i) {
    const double a = root(side.a2[i]), b = most(a, root(side.b2[i])), k2 = c.k2[i], p2 = c.p2[i],
                 steep = side.steep[i];
    const double r_a = least(most(root(p2 + k2 * a * a), ra), rb),
                 r_b = least(most(root(p2 + k2 * b * b), ra), rb);
    const double d_a = r_a - rc, d_b = r_b - rc, q_a = root(radius2 - d_a * d_a),
                 q_b = root(radius2 - d_b * d_b);
    const double w_a = root(1.0 - a * a), w_b = root(1.0 - b * b), step_a = k2 * a / r_a;
    const double falls_a = d_a * k2 * a * w_a - steep * r_a * q_a,
                 falls_b = d_b * k2 * b * w_b - steep * r_b * q_b;
    const double grows =
        radius2 / (q_a * q_a * q_a) * step_a * step_a + d_a / q_a * k2 * p2 / (r_b * r_b * r_b);
    const bool convex = grows >= steep * b / (w_b * w_b * w_b);
    const bool within = falls_a < 0.0 && falls_b > 0.0;
    low[i] = falls_a < 0.0 ? (within ? a : kNoHeight) : a;
    high[i] = within ? b : low[i];
    open[i] = convex && within && a < b && side.falls[i] > 0.0 ? 1.0 : 0.0;
    again[i] = convex ? 0.0 : 1.0;
  }
  cornerNewton(piece, n, c, side, low, high, open);
  for (int i = 0; i < n; ++i) again[i] = open[i] > 0.0 ? 1.0 : again[i];
  for (int i = 0; i < n; ++i) low[i] *= low[i];
  takeRoots(n, low, again, c, side);
}

/// Whether the piece has a place under the stretch of any column; finds where.
inline bool turnPiece(const ColumnBoundary& boundary, int p, int n, const TurnColumns& c, TurnSide& side) {
  const ColumnBoundary::Piece& piece = boundary.piece[p];
  const double ra2 = piece.ra * piece.ra, rb2 = piece.rb * piece.rb;
  double widest[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
  for (int i = 0; i < n; ++i) side.a2[i] = side.from2[i], side.b2[i] = side.to2[i];
  if (p > 0) {
    for (int i = 0; i < n; ++i) side.a2[i] = most(side.a2[i], (ra2 - c.p2[i]) * c.per_k2[i]);
  }
  if (p + 1 < boundary.count) {
    for (int i = 0; i < n; ++i) {
      const double outer = least(side.b2[i], (rb2 - c.p2[i]) * c.per_k2[i]);
      side.b2[i] = c.p2[i] < rb2 ? outer : -1.0;
    }
  }
  for (int i = 0; i < n; i += 8) {
    for (int k = 0; k < 8; ++k) widest[k] = most(widest[k], side.b2[i + k] - side.a2[i + k]);
  }
  double any = -1.0;
  for (int k = 0; k < 8; ++k) any = most(any, widest[k]);
  return any >= 0.0;
}

/// The places at which boundary + steep * asin(u) is least over the stretch of u.
inline void findOnTurn(const ColumnBoundary& boundary, double steep, int n, TurnColumns& c, TurnSide& side) {
  const double size = steep < 0.0 ? -steep : steep;
  const bool back = steep > 0.0;
  for (int i = 0; i < n; ++i) {
    const double from = back ? -c.to[i] : c.from[i], to = back ? -c.from[i] : c.to[i];
    const bool climbs = to <= 0.0;  // the whole stretch lies on the other side
    const double start = climbs ? to : most(from, 0.0);
    side.from2[i] = start * start;
    side.to2[i] = to * to;
    side.steep[i] = climbs ? 0.0 : size;
    side.sign[i] = climbs ? size : -size;
    side.way[i] = climbs == back ? 1.0 : -1.0;
    side.at2[i] = side.from2[i];
    side.falls[i] = 1.0;
  }
  for (int p = 0; p < boundary.count; ++p) {
    const ColumnBoundary::Piece& piece = boundary.piece[p];
    if (!turnPiece(boundary, p, n, c, side)) continue;
    if (piece.kind == ColumnBoundary::Kind::kLevel) {
      levelRoots(n, side);
    } else if (piece.kind == ColumnBoundary::Kind::kCone) {
      straightRoots(piece.slope, n, c, side);
    } else if (piece.rc == 0.0) {
      sphereRoots(piece.radius, n, c, side);
    } else {
      cornerRoots(piece, n, c, side);
    }
  }
}

/// Level distance and height of the way at the places found.
inline void seeOnTurn(double radius, int n, const TurnColumns& c, const TurnSide& side, double* __restrict r,
                      double* __restrict rise) {
  for (int i = 0; i < n; ++i) {
    r[i] = least(root(c.p2[i] + c.k2[i] * side.at2[i]), radius);
    rise[i] = side.sign[i] * proveout::arcSine(root(side.at2[i]));
  }
}

/// Whether the stretch of every column reaches as far to both sides.
inline bool isEvenTurn(int n, const TurnColumns& c) {
  double uneven[8] = {0, 0, 0, 0, 0, 0, 0, 0}, any = 0.0;
  for (int i = 0; i < n; i += 8) {
    for (int k = 0; k < 8; ++k) uneven[k] = c.from[i + k] + c.to[i + k] == 0.0 ? uneven[k] : 1.0;
  }
  for (int k = 0; k < 8; ++k) any = most(any, uneven[k]);
  return any == 0.0;
}

/// out: the least of boundary + steep * asin(u).
inline void addBoundary(const ColumnBoundary& boundary, int n, const double* __restrict r,
                        const double* __restrict rise, double* __restrict out) {
  boundaryHeight(boundary, r, n, out);
  for (int i = 0; i < n; ++i) out[i] += rise[i];
}

inline void turnColumns(const TurnSweep& sweep, const double* __restrict x, const double* __restrict y, int n,
                        double* __restrict lo, double* __restrict hi) {
  const proveout::ColumnSolid& tool = *sweep.solid;
  TurnColumns c;
  placeTurn(sweep, x, y, n, c);
  double any = 0.0;
  for (int i = 0; i < n; ++i) any = most(any, c.over[i]);
  if (any > 0.0) {
    TurnSide side;
    double r[kArray], rise[kArray];
    findOnTurn(tool.lower, 2.0 * sweep.slope, n, c, side);
    seeOnTurn(tool.radius, n, c, side, r, rise);
    addBoundary(tool.lower, n, r, rise, lo);
    // The upper places of a solid that is the same from below are the lower ones seen in a mirror.
    if (!tool.even || !isEvenTurn(n, c)) {
      findOnTurn(tool.upper, -2.0 * sweep.slope, n, c, side);
      seeOnTurn(tool.radius, n, c, side, r, rise);
    }
    addBoundary(tool.upper, n, r, rise, hi);
  }
  for (int i = 0; i < n; ++i) {
    const bool over = c.over[i] > 0.0;
    lo[i] = over ? c.base[i] + lo[i] : kNoHeight;
    hi[i] = over ? c.base[i] - hi[i] : -kNoHeight;
  }
  for (int i = 0; i < n; ++i) {
    if (c.over[i] > 0.0 && c.alone[i] > 0.0) proveout::curveColumn(sweep, x[i], y[i], lo + i, hi + i);
  }
}

/// Columns of an upright arc. Where the tool is over none of it `over` is 0 and the stretch is empty.
struct UprightColumns {
  double along[kArray], p2[kArray];  ///< of the column from the center; the level distance is sqrt(p2 + u^2)
  double from[kArray], to[kArray], over[kArray];
};

inline void placeUpright(const UprightSweep& s, const double* __restrict x, const double* __restrict y, int n,
                         UprightColumns& c) {
  const double cx = s.x, cy = s.y, ux = s.ux, uy = s.uy, first = s.first_mm, last = s.last_mm;
  const double radius2 = s.solid->radius * s.solid->radius;
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - cx, qy = y[i] - cy;
    const double along = qx * ux + qy * uy, across = qx * uy - qy * ux, p2 = across * across;
    const double reach = root(radius2 - p2);
    const double from = most(first - along, -reach), to = least(last - along, reach);
    const bool over = from < to;
    c.along[i] = along;
    c.p2[i] = over ? p2 : 0.0;
    c.from[i] = over ? from : 0.0;
    c.to[i] = over ? to : 0.0;
    c.over[i] = over ? 1.0 : 0.0;
  }
}

/// out = least of a level disc or of a half sphere + side * height of the arc over the stretch of u. Their
/// slopes are alike at one place, or the sum has its least value at an end.
inline void leastOnUpright(const ColumnBoundary::Piece& piece, double side, double arc, int n,
                           const UprightColumns& c, double* __restrict out) {
  const bool level = piece.kind == ColumnBoundary::Kind::kLevel, lower = side < 0.0;
  const double radius2 = level ? 0.0 : piece.radius * piece.radius, bottom = level ? piece.za : piece.zc;
  for (int i = 0; i < n; ++i) {
    const double along = c.along[i], from = c.from[i], to = c.to[i];
    const double w2 = level ? 0.0 : radius2 - c.p2[i], w = root(w2), size = along < 0.0 ? -along : along;
    const double inner = lower ? -along * w / (arc + w) : along * w / (arc - w);
    const double still = level ? -along : inner;
    const bool one = lower || (!level && size < arc - w);
    const double place = most(from, least(still, to)), u0 = one ? place : from, u1 = one ? place : to;
    const double x0 = along + u0, x1 = along + u1;
    const double z0 = side * root((arc - x0) * (arc + x0)) - root(w2 - u0 * u0);
    const double z1 = side * root((arc - x1) * (arc + x1)) - root(w2 - u1 * u1);
    out[i] = bottom + least(z0, z1);
  }
}

inline bool isDiscOrBall(const ColumnBoundary& boundary) {
  const ColumnBoundary::Piece& piece = boundary.piece[0];
  if (boundary.count != 1) return false;
  return piece.kind == ColumnBoundary::Kind::kLevel ||
         (piece.kind == ColumnBoundary::Kind::kArc && piece.rc == 0.0);
}

inline void uprightColumns(const UprightSweep& sweep, const double* __restrict x, const double* __restrict y,
                           int n, double* __restrict lo, double* __restrict hi) {
  const proveout::ColumnSolid& tool = *sweep.solid;
  if (!isDiscOrBall(tool.lower) || !isDiscOrBall(tool.upper)) {
    for (int i = 0; i < n; ++i) proveout::curveColumn(sweep, x[i], y[i], lo + i, hi + i);
    return;
  }
  UprightColumns c;
  placeUpright(sweep, x, y, n, c);
  leastOnUpright(tool.lower.piece[0], sweep.side, sweep.arc_radius, n, c, lo);
  leastOnUpright(tool.upper.piece[0], -sweep.side, sweep.arc_radius, n, c, hi);
  const double middle = sweep.start_z;
  for (int i = 0; i < n; ++i) {
    const bool over = c.over[i] > 0.0;
    lo[i] = over ? middle + lo[i] : kNoHeight;
    hi[i] = over ? middle - hi[i] : -kNoHeight;
  }
}
