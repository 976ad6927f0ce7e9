#include "removal/process/wire_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/plane.h"

namespace proveout {
namespace {

/// So many bodies are named where a point is in none.
constexpr std::size_t kMostNamed = 3;

Error inNoBody(const WireStock& stock, const Vec3& p) {
  const PrismBlank& blank = stock.blank();
  const bool beside = p.z() < blank.z_low || p.z() > blank.z_high;
  const std::vector<PlanePolygons> outlines = stock.outlinesAt(std::clamp(p.z(), blank.z_low, blank.z_high));
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const bool inside = holds(outlines[k], p.head<2>());
    near.emplace_back(inside ? 0.0 : borderDistance(outlines[k], p.head<2>()), k);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), kMostNamed));
  std::string text = pointInNoBody(p);
  if (beside) text += fmt::format(": the stock is between Z{:g} and Z{:g}", blank.z_low, blank.z_high);
  for (std::size_t i = 0; i < near.size(); ++i) {
    const WireBody& body = stock.bodies()[near[i].second];
    text += fmt::format("{} a body of {:.6g} mm3, X{:.3f} Y{:.3f} to X{:.3f} Y{:.3f}, {}",
                        i == 0 ? "; the nearest:" : ";", body.volume_mm3, body.bounds.min.x(),
                        body.bounds.min.y(), body.bounds.max.x(), body.bounds.max.y(),
                        near[i].first > 0.0 ? fmt::format("{:.3g} mm away", near[i].first)
                                            : std::string("above or below the point"));
  }
  return inputError(text);
}

Result<PartChoice> bodyOfPoint(const WireStock& stock, const Vec3& p) {
  const std::vector<PlanePolygons> outlines = stock.outlinesAt(p.z());
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    if (holds(outlines[k], p.head<2>())) return PartChoice{k, {}};
  }
  return inNoBody(stock, p);
}

/// The largest that a fixture touches at the bottom, half way or at the top.
std::optional<std::size_t> firstHeld(const WireStock& stock, const PlanePolygons& fixtures) {
  const PrismBlank& blank = stock.blank();
  std::size_t best = stock.bodies().size();
  for (const double z : {blank.z_low, 0.5 * (blank.z_low + blank.z_high), blank.z_high}) {
    const std::vector<PlanePolygons> outlines = stock.outlinesAt(z);
    for (std::size_t k = 0; k < best; ++k) {
      if (anyTouches(fixtures, outlines[k])) best = k;
    }
  }
  return best < stock.bodies().size() ? std::optional(best) : std::nullopt;
}

}  // namespace

std::size_t bodyLike(const std::vector<Box3>& bounds, const Box3& wanted) {
  PROVEOUT_ASSERT(!bounds.empty());
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const double off = (bounds[k].min - wanted.min).head<2>().cwiseAbs().sum() +
                       (bounds[k].max - wanted.max).head<2>().cwiseAbs().sum();
    if (off >= least) continue;
    least = off;
    best = k;
  }
  return best;
}

Result<PartChoice> partAmong(const WireStock& stock, const PieceOptions& options) {
  if (options.part_point) return bodyOfPoint(stock, *options.part_point);
  std::vector<Box3> bounds;
  std::vector<double> volumes;
  for (const WireBody& body : stock.bodies()) {
    bounds.push_back(body.bounds);
    volumes.push_back(body.volume_mm3);
  }
  const PartChoice largest = largestOf(volumes);
  const auto chosen = options.part ? std::optional(bodyLike(bounds, *options.part))
                                   : firstHeld(stock, options.held_at);
  if (!chosen) return largest;
  if (volumes[*chosen] < kNotableShare * volumes[largest.body]) return doubted(*chosen, volumes);
  return PartChoice{*chosen, {}};
}

}  // namespace proveout
