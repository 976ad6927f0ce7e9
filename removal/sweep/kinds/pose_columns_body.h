// Columns of a solid at many poses: a part of the column kernels' body.
//
// At one pose a vertical line meets each zone of the solid between the planes of the zone's ends and the
// roots of a quadratic. Where the line comes onto an end face over its rim, or leaves it, lies between two
// poses: it is found on the chord between what both say.
#pragma once

namespace {

using proveout::AxialView;
using proveout::PoseRun;
using proveout::PoseSolid;
using proveout::PoseSpan;

/// A quadratic that is no more than this is linear.
constexpr double kLeastSquare = 1e-24;

/// Cylinders by an axis that leans more than this have a shorter way to their roots: of the square.
constexpr double kLeastLean = 1e-8;

inline bool isCylinder(const PoseSolid::Zone& zone) { return zone.beta == 0.0 && zone.gamma == 0.0; }

/// As poseZone, of a cylinder. `level2`: square of the axis' level part.
inline void poseCylinder(const PoseSolid::Zone& zone, double az, double level2, double z,
                         const double* __restrict u, const double* __restrict w2, int n,
                         double* __restrict lo, double* __restrict hi) {
  const double by_az = 1.0 / az, by_level = 1.0 / level2, radius2 = zone.alpha;
  for (int i = 0; i < n; ++i) {
    const double root2 = u[i] * u[i] + level2 * (radius2 - w2[i]), r = root(root2);
    const double first = (u[i] * az - r) * by_level, second = (u[i] * az + r) * by_level;
    const double end1 = (zone.low - u[i]) * by_az, end2 = (zone.high - u[i]) * by_az;
    const double from = most(least(end1, end2), first), to = least(most(end1, end2), second);
    const bool met = root2 >= 0.0 && from <= to;
    lo[i] = met ? least(lo[i], z + from) : lo[i];
    hi[i] = met ? most(hi[i], z + to) : hi[i];
  }
}

/// What a zone of the solid covers of the columns at one pose. `u`: along the axis from the tip to where a
/// column is at the tip's height; w2: square of the level distance.
inline void poseZone(const PoseSolid::Zone& zone, double az, double z, const double* __restrict u,
                     const double* __restrict w2, int n, double* __restrict lo, double* __restrict hi) {
  const double g = 1.0 + zone.gamma, beta = zone.beta, alpha = zone.alpha, inverse = 1.0 / az;
  double a = 1.0 - g * az * az;
  const bool steep =
      a < 0.0 && zone.gamma > 0.0;  // than the cone: both of its nappes are met, from one end on
  if (!steep) a = most(a, kLeastSquare);
  const bool upper = zone.widens == (az > 0.0);
  for (int i = 0; i < n; ++i) {
    const double b = -(g * u[i] + 0.5 * beta) * az, c = w2[i] - (g * u[i] + beta) * u[i] - alpha;
    const double root2 = b * b - a * c, r = root(root2);
    const double q = b < 0.0 ? r - b : -(r + b);
    const double first = q / a, second = q != 0.0 ? c / q : 0.0;
    const double low = least(first, second), high = most(first, second);
    const double end1 = (zone.low - u[i]) * inverse, end2 = (zone.high - u[i]) * inverse;
    const double end_low = least(end1, end2), end_high = most(end1, end2);
    const double no_low = root2 < 0.0 ? end_low : (upper ? high : end_low);
    const double no_high = root2 < 0.0 ? end_high : (upper ? end_high : low);
    const double from = most(end_low, steep ? no_low : low), to = least(end_high, steep ? no_high : high);
    const bool met = (steep || root2 >= 0.0) && from <= to;
    lo[i] = met ? least(lo[i], z + from) : lo[i];
    hi[i] = met ? most(hi[i], z + to) : hi[i];
  }
}

/// Goes on from places outside of what is nearer than `corner` to a disc, towards it: the distance is convex
/// along the column, so that Newton's method never leaps over where it begins. `near` is below 0 where the
/// column misses it.
inline void enterCorner(const PoseSolid::Zone& zone, double az, double direction, const double* __restrict u,
                        const double* __restrict w2, int n, double* __restrict at, double* __restrict near) {
  constexpr double kEnteredMm = 1e-8;
  constexpr int kMostSteps = 60;
  const double disc = zone.disc, height = zone.height, corner = zone.corner;
  for (int step = 0; step < kMostSteps; ++step) {
    double left = 0.0;
    for (int i = 0; i < n; ++i) {
      const double s = at[i], h = u[i] + s * az, level = root(w2[i] + s * s - h * h);
      const double out = most(level - disc, 0.0), up = h - height, away = root(out * out + up * up);
      const double rate = out * (s - h * az) / most(level, kEnteredMm) + up * az;  // times `away`
      const double beyond = away - corner;
      const bool open = near[i] > 0.0 && beyond > kEnteredMm;
      const bool comes = rate * direction < 0.0;
      near[i] = open && !comes ? -1.0 : near[i];
      at[i] = open && comes ? s - beyond * away / rate : s;
      left = open && comes ? 1.0 : left;
    }
    if (left == 0.0) return;
  }
}

/// As poseZone, of a round corner.
inline void poseCorner(const PoseSolid::Zone& zone, double az, double z, const double* __restrict u,
                       const double* __restrict w2, int n, double* __restrict lo, double* __restrict hi) {
  double first[kArray], last[kArray], near_first[kArray], near_last[kArray];
  // From a sphere around it.
  const double wide = zone.disc + zone.corner, by_az = 1.0 / az;
  double any = 0.0;
  for (int i = 0; i < n; ++i) {
    const double b = zone.height * az, c = w2[i] - 2.0 * zone.height * u[i] + zone.height * zone.height;
    const double root2 = b * b - c + wide * wide, r = root(root2);
    const double end1 = (zone.low - u[i]) * by_az, end2 = (zone.high - u[i]) * by_az;
    // What lies beyond the zone is not asked for: a place inside is an end then.
    first[i] = most(b - r, least(end1, end2)), last[i] = least(b + r, most(end1, end2));
    near_first[i] = root2 > 0.0 && first[i] < last[i] ? 1.0 : -1.0;
    any = most(any, near_first[i]);
  }
  if (any == 0.0) return;
  enterCorner(zone, az, 1.0, u, w2, n, first, near_first);
  for (int i = 0; i < n; ++i) near_last[i] = near_first[i];
  enterCorner(zone, az, -1.0, u, w2, n, last, near_last);
  for (int i = 0; i < n; ++i) {
    const bool met = near_last[i] > 0.0 && first[i] <= last[i];
    lo[i] = met ? least(lo[i], z + first[i]) : lo[i];
    hi[i] = met ? most(hi[i], z + last[i]) : hi[i];
  }
}

/// The flat sides that a cylinder leaves on a straight way that is not along its axis.
inline void cylinderSides(const PoseSolid::Zone& zone, const proveout::PoseAt& a, const proveout::PoseAt& b,
                          const double* __restrict x, const double* __restrict y, int n,
                          double* __restrict lo, double* __restrict hi) {
  constexpr double kParallel = 1e-9, kBeyond = 1e-9;  // of a unit vector; mm
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
  const double along = dx * a.ax + dy * a.ay + dz * a.az;
  // Across the axis: the way's part, and what is at right angles to it.
  const double wx = dx - along * a.ax, wy = dy - along * a.ay, wz = dz - along * a.az;
  const double square = wx * wx + wy * wy + wz * wz, by_length = 1.0 / root(square), per = 1.0 / square;
  const double nx = (a.ay * wz - a.az * wy) * by_length, ny = (a.az * wx - a.ax * wz) * by_length,
               nz = (a.ax * wy - a.ay * wx) * by_length;
  if (nz * nz < kParallel * kParallel) return;  // columns lie along the sides
  const double by_nz = 1.0 / nz, radius = zone.widest, low = zone.low - kBeyond, high = zone.high + kBeyond;
  for (int i = 0; i < n; ++i) {
    const double qx = x[i] - a.x, qy = y[i] - a.y, beside = qx * nx + qy * ny;
    const double s1 = (-radius - beside) * by_nz, s2 = (radius - beside) * by_nz;
    const double foot = (qx * wx + qy * wy) * per, u = qx * a.ax + qy * a.ay;
    const double t1 = foot + s1 * wz * per, t2 = foot + s2 * wz * per;
    const double h1 = u + s1 * a.az - t1 * along, h2 = u + s2 * a.az - t2 * along;
    const bool one = t1 >= 0.0 && t1 <= 1.0 && h1 >= low && h1 <= high;
    const bool two = t2 >= 0.0 && t2 <= 1.0 && h2 >= low && h2 <= high;
    lo[i] = least(least(lo[i], one ? a.z + s1 : kNoHeight), two ? a.z + s2 : kNoHeight);
    hi[i] = most(most(hi[i], one ? a.z + s1 : -kNoHeight), two ? a.z + s2 : -kNoHeight);
  }
}

/// What a tool of one direction leaves between two places: the ways of its rims, and faces where they touch
/// the way's own direction. Both are quadratics in the place along the way, 0 to 1, and the height.
inline void straightColumns(const PoseRun& run, const double* __restrict x, const double* __restrict y, int n,
                            double* __restrict lo, double* __restrict hi) {
  constexpr double kStill = 1e-18, kBeyond = 1e-9;  // mm2, mm
  const PoseSolid& solid = *run.solid;
  const proveout::PoseAt &a = run.poses[0], &b = run.poses[1];
  const double dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z, length2 = dx * dx + dy * dy + dz * dz;
  const double az = a.az, inverse = 1.0 / az, along = dx * a.ax + dy * a.ay + dz * az;
  if (!(length2 > kStill)) return;
  for (int k = 0; k < solid.rims; ++k) {
    const double h = solid.rim[k].z, within = h * h + solid.rim[k].radius2, rise = along * inverse;
    const double square = rise * rise - 2.0 * rise * dz + length2;
    if (!(square > kStill)) continue;
    const double per = 1.0 / square;
    for (int i = 0; i < n; ++i) {
      const double qx = x[i] - a.x, qy = y[i] - a.y;
      const double s0 = (h - qx * a.ax - qy * a.ay) * inverse;
      const double c = qx * qx + qy * qy + s0 * s0 - within;
      const double half = s0 * (rise - dz) - qx * dx - qy * dy;
      const double root2 = half * half - square * c, r = root(root2);
      const double t1 = (-half - r) * per, t2 = (-half + r) * per;
      const bool one = root2 >= 0.0 && t1 >= 0.0 && t1 <= 1.0, two = root2 >= 0.0 && t2 >= 0.0 && t2 <= 1.0;
      const double z1 = a.z + s0 + rise * t1, z2 = a.z + s0 + rise * t2;
      lo[i] = least(least(lo[i], one ? z1 : kNoHeight), two ? z2 : kNoHeight);
      hi[i] = most(most(hi[i], one ? z1 : -kNoHeight), two ? z2 : -kNoHeight);
    }
  }
  for (int k = 0; k < solid.zones; ++k) {
    const PoseSolid::Zone& zone = solid.zone[k];
    const double g = 1.0 + zone.gamma, beta = zone.beta, square = length2 - g * along * along;
    if (!(square > kStill)) continue;
    if (isCylinder(zone)) {
      cylinderSides(zone, a, b, x, y, n, lo, hi);
      continue;
    }
    const double per = 1.0 / square, turn = g * along * az - dz, aa = 1.0 - g * az * az - turn * turn * per;
    for (int i = 0; i < n; ++i) {
      const double qx = x[i] - a.x, qy = y[i] - a.y, u = qx * a.ax + qy * a.ay;
      const double m = (g * u + 0.5 * beta) * along - qx * dx - qy * dy;
      const double bb = -(g * u + 0.5 * beta) * az - m * turn * per;
      const double cc = qx * qx + qy * qy - (g * u + beta) * u - zone.alpha - m * m * per;
      const double root2 = bb * bb - aa * cc, r = root(root2);
      const double q = bb < 0.0 ? r - bb : -(r + bb);
      const double s1 = q / aa, s2 = q != 0.0 ? cc / q : 0.0;
      const double t1 = -(m + turn * s1) * per, t2 = -(m + turn * s2) * per;
      const double h1 = u + s1 * az - t1 * along, h2 = u + s2 * az - t2 * along;
      const bool one =
          root2 >= 0.0 && t1 >= 0.0 && t1 <= 1.0 && h1 >= zone.low - kBeyond && h1 <= zone.high + kBeyond;
      const bool two =
          root2 >= 0.0 && t2 >= 0.0 && t2 <= 1.0 && h2 >= zone.low - kBeyond && h2 <= zone.high + kBeyond;
      lo[i] = least(least(lo[i], one ? a.z + s1 : kNoHeight), two ? a.z + s2 : kNoHeight);
      hi[i] = most(most(hi[i], one ? a.z + s1 : -kNoHeight), two ? a.z + s2 : -kNoHeight);
    }
  }
}

void poseColumns(const PoseRun& run, const double* x, const double* y, int count, double* lo, double* hi) {
  const int n = (count + 7) & ~7;
  const PoseSolid& solid = *run.solid;
  double u[kArray], w2[kArray], beyond[2 * PoseSolid::kMost][kArray], height[2 * PoseSolid::kMost][kArray];
  for (int i = 0; i < n; ++i) lo[i] = kNoHeight, hi[i] = -kNoHeight;
  for (int p = 0; p < run.count; ++p) {
    const proveout::PoseAt& pose = run.poses[p];
    const double inverse = 1.0 / pose.az;
    for (int i = 0; i < n; ++i) {
      const double qx = x[i] - pose.x, qy = y[i] - pose.y;
      u[i] = qx * pose.ax + qy * pose.ay;
      w2[i] = qx * qx + qy * qy;
    }
    const double level2 = pose.ax * pose.ax + pose.ay * pose.ay;
    for (int k = 0; k < solid.zones; ++k) {
      if (solid.zone[k].corner > 0.0) {
        poseCorner(solid.zone[k], pose.az, pose.z, u, w2, n, lo, hi);
      } else if (isCylinder(solid.zone[k]) && level2 > kLeastLean) {
        poseCylinder(solid.zone[k], pose.az, level2, pose.z, u, w2, n, lo, hi);
      } else {
        poseZone(solid.zone[k], pose.az, pose.z, u, w2, n, lo, hi);
      }
    }
    if (run.straight) continue;
    for (int k = 0; k < solid.rims; ++k) {
      const double h = solid.rim[k].z, within = h * h + solid.rim[k].radius2;
      double* __restrict was_beyond = beyond[k];
      double* __restrict was_at = height[k];
      const bool follows = p > 0;
      for (int i = 0; i < n; ++i) {
        const double s = (h - u[i]) * inverse, f = w2[i] + s * s - within, at = pose.z + s;
        const double last = follows ? was_beyond[i] : f, before = follows ? was_at[i] : at;
        const bool over = (last < 0.0) != (f < 0.0);
        const double z = before + (at - before) * (over ? last / (last - f) : 0.0);
        lo[i] = over ? least(lo[i], z) : lo[i];
        hi[i] = over ? most(hi[i], z) : hi[i];
        was_beyond[i] = f;
        was_at[i] = at;
      }
    }
  }
  if (run.straight) straightColumns(run, x, y, n, lo, hi);
}

/// Of a leaf's columns: squares of distances that no point of a column, from its top to the lowest samples,
/// is nearer than to the axis of a solid on its way, and the range of places along the axis.
struct PoseNear {
  double gap2[kQuarter], first[kQuarter], last[kQuarter];
};

inline void poseNear(const AxialView& view, const double* __restrict x, const double* __restrict y,
                     const double* __restrict top, double bottom, PoseNear& near) {
  const proveout::PoseAt& a = view.at;
#pragma GCC unroll 1
  for (int i = 0; i < kQuarter; ++i) {
    const double dx = x[i] - a.x, dy = y[i] - a.y, dz = top[i] - a.z, down = top[i] - bottom;
    const double p = dx * view.px + dy * view.py - dz * view.level, q = dx * view.qx + dy * view.qy;
    const double ahead = p + view.level * down;
    // Apart in a rectangle around the way, and in one along it.
    const double p_gap = most(most(view.low_p - ahead, p - view.high_p), 0.0);
    const double q_gap = most(most(view.low_q - q, q - view.high_q), 0.0);
    const double s1 = p * view.up + q * view.uq, s2 = ahead * view.up + q * view.uq;
    const double n1 = q * view.up - p * view.uq, n2 = q * view.up - ahead * view.uq;
    const double s_gap = most(most(-most(s1, s2), least(s1, s2) - view.length), 0.0);
    const double n_gap = most(most(-most(n1, n2), least(n1, n2)), 0.0);
    const double gap2 = most(p_gap * p_gap + q_gap * q_gap, s_gap * s_gap + n_gap * n_gap);
    near.gap2[i] = down > 0.0 ? gap2 : kNoHeight;
    const double h1 = dx * a.ax + dy * a.ay + dz * a.az, h2 = h1 - down * a.az;
    near.first[i] = least(h1, h2) - view.high_h;
    near.last[i] = most(h1, h2) - view.low_h;
  }
}

/// Most passes that come near a leaf take nothing from it: they miss what is left. A solid is taken as round
/// cylinders, one a zone.
unsigned poseHits(const PoseSpan& span, const proveout::LeafColumns& leaf, unsigned quarters) {
  const double slack = span.between + proveout::kCullSlackMm;
  unsigned hits = 0;
  for (int end = 0; end < span.count; ++end) {
    for (int q = 0; q < 4; ++q) {
      if (((quarters & ~hits) >> q & 1) == 0) continue;
      const int from = q * kQuarter;
      PoseNear near;
      poseNear(span.views[end], leaf.x + from, leaf.y + from, leaf.top + from, leaf.z[0], near);
      for (int k = 0; k < span.solid->zones; ++k) {
        const PoseSolid::Zone& zone = span.solid->zone[k];
        const double low = zone.low - slack, high = zone.high + slack, within = zone.widest + slack;
        double hit[kQuarter];
#pragma GCC unroll 1
        for (int i = 0; i < kQuarter; ++i) {
          const double beside = near.gap2[i] < within * within ? 1.0 : 0.0;
          const double above = near.last[i] > low ? beside : 0.0;
          hit[i] = near.first[i] < high ? above : 0.0;
        }
        for (int i = 0; i < 8; ++i) hit[i] = most(hit[i], hit[i + 8]);
        for (int i = 0; i < 4; ++i) hit[i] = most(hit[i], hit[i + 4]);
        hits |= most(most(hit[0], hit[1]), most(hit[2], hit[3])) > 0.0 ? 1u << q : 0u;
      }
    }
  }
  return hits;
}

inline double magnitude(double a) { return a < 0.0 ? -a : a; }

/// Where the column of each block may lie in the cylinders around the zones: between the ends of the zone, in
/// the strips along p and across the way, each wider by what the square reaches beyond its middle.
inline void poseReachAt(const PoseSolid& solid, const AxialView& view, double slack,
                        const proveout::FourBlocks& blocks, double* __restrict low, double* __restrict high) {
  const double ax = view.at.ax, ay = view.at.ay, tip = view.at.z, half = blocks.half_width;
  const double px = view.px, py = view.py, qx = view.qx, qy = view.qy, nx = view.nx, ny = view.ny;
  const double by_h = view.by_h, by_p = view.by_p, by_n = view.by_n;
  const double low_q = view.low_q, high_q = view.high_q;
  const double p_half = half * (magnitude(px) + magnitude(py)) + slack;
  const double q_half = half * (magnitude(qx) + magnitude(qy)) + slack;
  const double n_half = half * (magnitude(nx) + magnitude(ny)) + slack;
  const double first_h = view.low_h - half * (magnitude(ax) + magnitude(ay)) - slack;
  const double last_h = view.high_h + half * (magnitude(ax) + magnitude(ay)) + slack;
  const double first_p = view.low_p - p_half, last_p = view.high_p + p_half;
  double h[4], p[4], n[4], q_gap[4];
  for (int i = 0; i < 4; ++i) {
    const double dx = blocks.x[i] - view.at.x, dy = blocks.y[i] - view.at.y;
    const double q = dx * qx + dy * qy;
    h[i] = dx * ax + dy * ay, p[i] = dx * px + dy * py, n[i] = dx * nx + dy * ny;
    q_gap[i] = most(most(low_q - q, q - high_q) - q_half, 0.0);
  }
  for (int k = 0; k < solid.zones; ++k) {
    const double first = solid.zone[k].low + first_h, last = solid.zone[k].high + last_h;
    const double radius = solid.zone[k].widest, across = radius + n_half;
    for (int i = 0; i < 4; ++i) {
      const double chord = root(radius * radius - q_gap[i] * q_gap[i]);
      const double h1 = (first - h[i]) * by_h, h2 = (last - h[i]) * by_h;
      const double n1 = (-across - n[i]) * by_n, n2 = (across - n[i]) * by_n;
      const double p1 = (p[i] - last_p - chord) * by_p, p2 = (p[i] - first_p + chord) * by_p;
      const double from = tip + most(most(least(h1, h2), least(n1, n2)), p1);
      const double to = tip + least(least(most(h1, h2), most(n1, n2)), p2);
      const double beside = q_gap[i] <= radius ? from : kNoHeight;
      low[i] = beside <= to ? least(low[i], beside) : low[i];
      high[i] = beside <= to ? most(high[i], to) : high[i];
    }
  }
}

void poseReach(const PoseSpan& span, const proveout::FourBlocks& blocks, double* low, double* high) {
  constexpr double kSlack = proveout::kCullSlackMm;
  const double half = blocks.half_width;
  const double left = span.min[0] - half, front = span.min[1] - half, bottom = span.min[2];
  const double right = span.max[0] + half, back = span.max[1] + half, top = span.max[2];
  double near[4], from[4], to[4];
  for (int i = 0; i < 4; ++i) {
    const double x = blocks.x[i], y = blocks.y[i];
    const double in_x = x >= left && x <= right ? 1.0 : 0.0, in_y = y >= front && y <= back ? in_x : 0.0;
    near[i] = blocks.z_high[i] > bottom && blocks.z_low[i] < top ? in_y : 0.0;
    low[i] = kNoHeight, high[i] = -kNoHeight;
    from[i] = kNoHeight, to[i] = -kNoHeight;
  }
  if (most(most(near[0], near[1]), most(near[2], near[3])) == 0.0) return;
  for (int end = 0; end < span.count; ++end)
    poseReachAt(*span.solid, span.views[end], span.between + kSlack, blocks, from, to);
  for (int i = 0; i < 4; ++i) {
    const double lowest = most(from[i], bottom) - kSlack, highest = least(to[i], top) + kSlack;
    const bool in =
        near[i] > 0.0 && from[i] <= to[i] && lowest < blocks.z_high[i] && highest > blocks.z_low[i];
    low[i] = in ? lowest : kNoHeight;
    high[i] = in ? highest : -kNoHeight;
  }
}

}  // namespace
