// Columns of a solid at many poses: a part of the column kernels' body.
//
// At one pose a vertical line meets each zone of the solid between the planes of the zone's ends and the
// roots of a quadratic. Where the line comes onto an end face over its rim, or leaves it, lies between two
// poses: it is found on the chord between what both say.
#pragma once

namespace {

using proveout::PoseRun;
using proveout::PoseSolid;

/// A tool that lies flatter than this lies so, and a quadratic that is no more than this is linear.
constexpr double kLeastRise = 1e-9, kLeastSquare = 1e-24;

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

void poseColumns(const PoseRun& run, const double* x, const double* y, int count, double* lo, double* hi) {
  const int n = (count + 7) & ~7;
  const PoseSolid& solid = *run.solid;
  double u[kArray], w2[kArray], beyond[PoseSolid::kMost][kArray], height[PoseSolid::kMost][kArray];
  for (int i = 0; i < n; ++i) lo[i] = kNoHeight, hi[i] = -kNoHeight;
  for (int p = 0; p < run.count; ++p) {
    const proveout::PoseAt& pose = run.poses[p];
    const double steep = pose.az < 0.0 ? -pose.az : pose.az;
    const double az = steep > kLeastRise ? pose.az : kLeastRise, inverse = 1.0 / az;
    for (int i = 0; i < n; ++i) {
      const double qx = x[i] - pose.x, qy = y[i] - pose.y;
      u[i] = qx * pose.ax + qy * pose.ay;
      w2[i] = qx * qx + qy * qy;
    }
    for (int k = 0; k < solid.zones; ++k) poseZone(solid.zone[k], az, pose.z, u, w2, n, lo, hi);
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
}

}  // namespace
