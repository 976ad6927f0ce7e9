#include "removal/process/wire_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "removal/wire/edge_curves.h"
#include "removal/wire/wire_holding.h"

namespace proveout {
namespace {

/// Chords where it is asked whether a point is in a body, mm.
constexpr double kPartChordMm = 1e-4;
/// So many bodies are named where a point is in none.
constexpr std::size_t kMostNamed = 3;

/// From a point to a body seen from +z, mm; 0 inside.
double distanceTo(const PlaneBody& body, const Vec2& p) {
  if (holds(polygonsOf(body.loops, kPartChordMm), p)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const WireStretch& side : wire_detail::sidesOf(body.loops))
    least = std::min(least, distanceTo(side, p).mm);
  return least;
}

Error inNoBody(const std::vector<PlaneBody>& bodies, const PrismBlank& blank, const Vec3& p) {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t k = 0; k < bodies.size(); ++k) near.emplace_back(distanceTo(bodies[k], p.head<2>()), k);
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), kMostNamed));
  std::string text =
      fmt::format("the point of the part (part_point) X{:g} Y{:g} Z{:g} lies in no body that is left", p.x(),
                  p.y(), p.z());
  if (p.z() < blank.z_low || p.z() > blank.z_high)
    text += fmt::format(": the stock is between Z{:g} and Z{:g}", blank.z_low, blank.z_high);
  for (std::size_t i = 0; i < near.size(); ++i) {
    const PlaneBody& body = bodies[near[i].second];
    const Box3 box = boundsOf(body, blank);
    text += fmt::format("{} a body of {:.6g} mm3, X{:.3f} Y{:.3f} to X{:.3f} Y{:.3f}, {}",
                        i == 0 ? "; the nearest:" : ";", body.area_mm2 * (blank.z_high - blank.z_low),
                        box.min.x(), box.min.y(), box.max.x(), box.max.y(),
                        near[i].first > 0.0 ? fmt::format("{:.3g} mm away", near[i].first)
                                            : std::string("above or below the point"));
  }
  return inputError(text);
}

Result<std::size_t> bodyOfPoint(const std::vector<PlaneBody>& bodies, const PrismBlank& blank,
                                const Vec3& p) {
  for (std::size_t k = 0; k < bodies.size() && p.z() >= blank.z_low && p.z() <= blank.z_high; ++k) {
    if (holds(polygonsOf(bodies[k].loops, kPartChordMm), p.head<2>())) return k;
  }
  return inNoBody(bodies, blank, p);
}

std::size_t mostLike(const Box3& wanted, const std::vector<PlaneBody>& bodies, const PrismBlank& blank) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Box3 bounds = boundsOf(bodies[k], blank);
    const double off = (bounds.min - wanted.min).head<2>().cwiseAbs().sum() +
                       (bounds.max - wanted.max).head<2>().cwiseAbs().sum();
    if (off >= least) continue;
    least = off;
    best = k;
  }
  return best;
}

}  // namespace

Box3 boundsOf(const PlaneBody& body, const PrismBlank& blank) {
  Box3 bounds = boundsOf(body.loops.front());
  bounds.min.z() = blank.z_low;
  bounds.max.z() = blank.z_high;
  return bounds;
}

Result<std::size_t> partAmong(const std::vector<PlaneBody>& bodies, const PrismBlank& blank,
                              const PieceOptions& options) {
  if (options.part_point) return bodyOfPoint(bodies, blank, *options.part_point);
  if (options.part) return mostLike(*options.part, bodies, blank);
  const WireHolding holding(options.held_at, bodies);
  if (!holding.byFixtures()) return std::size_t{0};
  const auto held =
      std::find_if(bodies.begin(), bodies.end(), [&](const PlaneBody& body) { return holding.keeps(body); });
  return held == bodies.end() ? std::size_t{0} : static_cast<std::size_t>(held - bodies.begin());
}

}  // namespace proveout
