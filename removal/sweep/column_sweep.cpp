#include "removal/sweep/column_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace proveout {

namespace {

using Piece = ColumnBoundary::Piece;
using Kind = ColumnBoundary::Kind;

Piece straight(double ra, double za, double rb, double zb) {
  const double slope = (zb - za) / (rb - ra);
  return {slope == 0.0 ? Kind::kLevel : Kind::kCone, ra, rb, za, slope, 0.0, 0.0, 0.0};
}

/// Splits the boundary, which runs outwards below and inwards above, into lower and mirrored upper pieces.
/// Vertical walls bound no column.
void split(const ConvexProfile& profile, ColumnBoundary& lower, ColumnBoundary& upper) {
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (!e.arc) {
      if (e.br > e.ar) lower.piece[lower.count++] = straight(e.ar, e.az, e.br, e.bz);
      if (e.br < e.ar) upper.piece[upper.count++] = straight(e.br, -e.bz, e.ar, -e.az);
      continue;
    }
    const double widest = e.cr + e.radius;
    const bool below = e.az<e.cz, above = e.bz> e.cz;
    if (below) {
      lower.piece[lower.count++] = {Kind::kArc, e.ar, above ? widest : e.br, 0, 0, e.cr, e.cz, e.radius};
    }
    if (above) {
      upper.piece[upper.count++] = {Kind::kArc, e.br, below ? widest : e.ar, 0, 0, e.cr, -e.cz, e.radius};
    }
  }
  std::reverse(upper.piece, upper.piece + upper.count);
}

}  // namespace

double ColumnBoundary::height(double r) const {
  int i = count - 1;
  while (i > 0 && r < piece[i].ra) --i;
  const Piece& p = piece[i];
  if (p.kind != Kind::kArc) return p.za + p.slope * (r - p.ra);
  const double d = r - p.rc;
  return p.zc - std::sqrt(std::max(0.0, p.radius * p.radius - d * d));
}

ColumnSolid columnSolid(const ConvexProfile& profile) {
  ColumnSolid solid;
  solid.radius = profile.maxRadius();
  solid.z_min = profile.zMin();
  solid.z_max = profile.zMax();
  split(profile, solid.lower, solid.upper);
  const auto disc = [&](const ColumnBoundary& b) { return b.count == 1 && b.piece[0].kind == Kind::kLevel; };
  solid.round_top = !disc(solid.upper);
  solid.flat = disc(solid.lower) && !solid.round_top;
  const Piece& first = solid.lower.piece[0];
  solid.ball = solid.lower.count == 1 && first.kind == Kind::kArc && first.rc == 0.0 &&
               first.radius == solid.radius && first.zc == solid.radius;
  return solid;
}

ColumnSweep columnLine(const ColumnSolid& solid, const Vec3& from, const Vec3& to) {
  ColumnSweep s;
  s.solid = &solid;
  s.x = from.x();
  s.y = from.y();
  s.z = from.z();
  s.rise = to.z() - from.z();
  s.length = std::hypot(to.x() - from.x(), to.y() - from.y());
  // Below this the level part cannot be told from rounding and moves the wall by less.
  constexpr double kVerticalMm = 1e-9;
  if (s.length < kVerticalMm) {
    s.length = 0.0;
    return s;
  }
  s.kind = ColumnSweep::Kind::kLine;
  s.ux = (to.x() - from.x()) / s.length;
  s.uy = (to.y() - from.y()) / s.length;
  s.slope = s.rise / s.length;
  s.lean = -s.slope / std::sqrt(1.0 + s.slope * s.slope);
  return s;
}

ColumnSweep columnArc(const ColumnSolid& solid, const Vec3& from, const Vec3& to, const ArcGeometry& arc) {
  ColumnSweep s;
  s.kind = ColumnSweep::Kind::kArc;
  s.solid = &solid;
  s.x = arc.center.x();
  s.y = arc.center.y();
  s.z = from.z();
  s.start_x = from.x();
  s.start_y = from.y();
  s.end_x = to.x();
  s.end_y = to.y();
  s.arc_radius = std::hypot(from.x() - s.x, from.y() - s.y);
  const double sweep = std::abs(arc.sweep_rad);
  s.turn = (arc.sweep_rad < 0.0) == (arc.normal.z() < 0.0) ? 1.0 : -1.0;
  s.cos_sweep = std::cos(sweep);
  s.sin_sweep = std::sin(sweep);
  s.wide = sweep > kPi;
  s.full = sweep >= 2.0 * kPi;
  return s;
}

namespace {

ColumnKernels pickLevel() {
  const char* wish = std::getenv("PROVEOUT_SIMD");
  const std::string_view level = wish != nullptr ? wish : "";
#if defined(__x86_64__)
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  if (avx512 && (level.empty() || level == "avx512")) return avx512Kernels();
  if (__builtin_cpu_supports("avx2") && level != "baseline") return avx2Kernels();
#endif
  return baselineKernels();
}

}  // namespace

const ColumnKernels& columnKernels() {
  static const ColumnKernels picked = pickLevel();
  return picked;
}

}  // namespace proveout
