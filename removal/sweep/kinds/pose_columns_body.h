// Columns of a solid at many poses: a part of the column kernels' body.
//
// At one pose a vertical line meets each zone of the solid between the planes of the zone's ends and the
// roots of a quadratic. Where the line comes onto an end face over its rim, or leaves it, lies between two
// poses: it is found on the chord between what both say.
#pragma once

namespace {

using proveout::PoseRun;
using proveout::PoseSolid;

/// A quadratic that is no more than this is linear.
constexpr double kLeastSquare = 1e-24;

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
    for (int i = 0; i < n; ++i) {
      const double qx = x[i] - a.x, qy = y[i] - a.y;
      const double s0 = (h - qx * a.ax - qy * a.ay) * inverse;
      const double c = qx * qx + qy * qy + s0 * s0 - within;
      const double half = s0 * (rise - dz) - qx * dx - qy * dy;
      const double root2 = half * half - square * c, r = root(root2);
      const double q = half < 0.0 ? r - half : -(r + half);
      const double t1 = q / square, t2 = q != 0.0 ? c / q : 0.0;
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
    for (int k = 0; k < solid.zones; ++k) poseZone(solid.zone[k], pose.az, pose.z, u, w2, n, lo, hi);
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

}  // namespace
