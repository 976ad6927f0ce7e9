#include "removal/sweep/column_sweep.h"

#include <fmt/format.h>

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

/// Whether straight boundaries differ by their heights alone; slopes that rounding tells apart become one.
bool makeEven(const ColumnBoundary& lower, ColumnBoundary& upper) {
  constexpr double kSame = 1e-12;
  if (lower.count != upper.count) return false;
  for (int i = 0; i < lower.count; ++i) {
    const Piece &a = lower.piece[i], &b = upper.piece[i];
    const double rise = (b.za - upper.piece[0].za) - (a.za - lower.piece[0].za);
    if (a.kind == Kind::kArc || a.kind != b.kind || a.ra != b.ra || a.rb != b.rb) return false;
    if (std::abs(rise) > kSame * a.rb || std::abs(b.slope - a.slope) > kSame * a.slope) return false;
  }
  for (int i = 0; i < lower.count; ++i) upper.piece[i].slope = lower.piece[i].slope;
  return true;
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
  solid.even = makeEven(solid.lower, solid.upper);
  solid.flat = disc(solid.lower) && !solid.round_top;
  const Piece& first = solid.lower.piece[0];
  solid.ball = solid.lower.count == 1 && first.kind == Kind::kArc && first.rc == 0.0 &&
               first.radius == solid.radius && first.zc == solid.radius;
  const Piece& last = solid.upper.piece[0];
  solid.sphere = solid.ball && solid.upper.count == 1 && last.kind == Kind::kArc && last.rc == 0.0 &&
                 last.radius == solid.radius && last.zc == -solid.radius;
  return solid;
}

LineSweep columnLine(const ColumnSolid& solid, const Vec3& from, const Vec3& to) {
  LineSweep s;
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
  s.ux = (to.x() - from.x()) / s.length;
  s.uy = (to.y() - from.y()) / s.length;
  s.slope = s.rise / s.length;
  s.lean = -s.slope / std::sqrt(1.0 + s.slope * s.slope);
  return s;
}

ArcSweep columnArc(const ColumnSolid& solid, const Vec3& from, const Vec3& to, const ArcGeometry& arc) {
  ArcSweep s;
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

/// Whether the columns of one turn see a part of a short way from behind, over the axis.
bool reachesBehind(double radius, double arc_radius, double way_rad) {
  const double off = kPi - 0.5 * way_rad;  // least angle between such places
  return off <= 0.0 || radius > arc_radius * (off < 0.5 * kPi ? std::sin(off) : 1.0);
}

}  // namespace

std::vector<TurnSweep> columnTurns(const ColumnSolid& solid, const Vec3& from, const Vec3& to,
                                   const ArcGeometry& arc) {
  TurnSweep s;
  s.solid = &solid;
  s.x = arc.center.x();
  s.y = arc.center.y();
  const Vec2 out = (from - arc.center).head<2>();
  s.ux = out.x() / out.norm();
  s.uy = out.y() / out.norm();
  s.arc_radius = 0.5 * (out.norm() + (to - arc.center).head<2>().norm());
  s.turn = (arc.sweep_rad < 0.0) == (arc.normal.z() < 0.0) ? 1.0 : -1.0;
  s.start_z = from.z();
  s.way_rad = std::abs(arc.sweep_rad);
  s.slope = (to.z() - from.z()) / s.way_rad;
  // Where a way is short no column near it has its angles parted.
  constexpr double kTurn = 2.0 * kPi;
  s.cut_rad = std::min(0.5 * s.way_rad - kPi, 0.0);
  const bool behind = reachesBehind(solid.radius, s.arc_radius, s.way_rad);
  const int last = behind ? static_cast<int>(std::ceil((s.way_rad - s.cut_rad + kPi) / kTurn)) - 1 : 0;
  std::vector<TurnSweep> out_turns;
  for (int k = behind ? -1 : 0; k <= last; ++k) {
    s.turn_rad = k * kTurn;
    const double begin = s.cut_rad + s.turn_rad - kPi;
    const double first = std::max(begin, 0.0), end = std::min(begin + 2.0 * kTurn, s.way_rad);
    if (first >= end) continue;
    s.z = s.start_z + s.slope * first;
    s.rise = s.slope * (end - first);
    out_turns.push_back(s);
  }
  return out_turns;
}

bool isWholeTurn(const TurnSweep& turn) {
  const double begin = turn.cut_rad + turn.turn_rad - kPi;
  return begin >= 0.0 && begin + 4.0 * kPi <= turn.way_rad;
}

std::vector<UprightSweep> columnUprights(const ColumnSolid& solid, const Vec3& from, const Vec3& to,
                                         const ArcGeometry& arc) {
  UprightSweep s;
  s.solid = &solid;
  s.x = arc.center.x();
  s.y = arc.center.y();
  s.start_z = arc.center.z();
  const Vec3 level = Vec3(-arc.normal.y(), arc.normal.x(), 0.0).normalized();
  s.ux = level.x();
  s.uy = level.y();
  const ArcFrame frame = arcFrame(from, to, arc);
  s.arc_radius = 0.5 * (frame.radius_start + frame.radius_end);
  // Angles from the level direction upwards; the way turns back at whole multiples of pi.
  const double start = std::atan2(frame.u.z(), frame.u.dot(level)), end = start + arc.sweep_rad;
  std::vector<UprightSweep> out;
  double a = std::min(start, end);
  for (const double last = std::max(start, end); a < last;) {
    const double half = std::floor(a / kPi + 1e-12), b = std::min(last, (half + 1.0) * kPi);
    s.side = std::fmod(half, 2.0) == 0.0 ? 1.0 : -1.0;
    s.first_mm = s.arc_radius * std::min(std::cos(a), std::cos(b));
    s.last_mm = s.arc_radius * std::max(std::cos(a), std::cos(b));
    const double za = s.arc_radius * std::sin(a), zb = s.arc_radius * std::sin(b);
    const bool over_top = s.first_mm < 0.0 && s.last_mm > 0.0;
    const double far = over_top ? s.side * s.arc_radius : za;
    s.z = s.start_z + std::min({za, zb, far});
    s.rise = s.start_z + std::max({za, zb, far}) - s.z;
    out.push_back(s);
    a = b;
  }
  return out;
}

namespace {

/// A level of the machine, and what makes its kernels.
struct SimdLevel {
  std::string_view name;
  ColumnKernels (*kernels)();
};

/// The levels that this machine has, the widest first.
std::vector<SimdLevel> simdLevels() {
  std::vector<SimdLevel> levels;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    levels.push_back({"avx512", avx512Kernels});
  if (__builtin_cpu_supports("avx2")) levels.push_back({"avx2", avx2Kernels});
#endif
  levels.push_back({"baseline", baselineKernels});
  return levels;
}

std::string_view simdWish() {
  const char* wish = std::getenv("PROVEOUT_SIMD");
  return wish != nullptr ? wish : "";
}

ColumnKernels pickLevel() {
  const std::vector<SimdLevel> levels = simdLevels();
  const auto wanted = std::find_if(levels.begin(), levels.end(),
                                   [](const SimdLevel& level) { return level.name == simdWish(); });
  return wanted != levels.end() ? wanted->kernels() : levels.front().kernels();
}

}  // namespace

Status checkSimdWish() {
  const std::string_view wish = simdWish();
  if (wish.empty()) return Done{};
  std::string names;
  for (const SimdLevel& level : simdLevels()) {
    if (level.name == wish) return Done{};
    names += fmt::format("{}{}", names.empty() ? "" : ", ", level.name);
  }
  constexpr std::size_t kShown = 40;
  const bool known = wish == "avx512" || wish == "avx2";
  return inputError(fmt::format("PROVEOUT_SIMD is '{}', {}: take one of {}, or leave the variable out",
                                wish.substr(0, kShown),
                                known ? "which this machine does not have" : "which is no level", names));
}

const ColumnKernels& pickedKernels() {
  static const ColumnKernels picked = pickLevel();
  return picked;
}

}  // namespace proveout
