#include "removal/process/turned_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {
namespace {

/// A piece that a blade cuts off is no part where it has less than this of what is held.
constexpr double kSplinterShare = 1e-3;
/// In front of what is held, mm.
constexpr double kInFront = 1e-6;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  double radius = 0.0;
};

Extent extentOf(const SectionBody& body) {
  PROVEOUT_ASSERT(!body.loops.empty());
  Extent extent;
  for (const Vec2& p : body.loops.front().points) {
    extent.low = std::min(extent.low, p.y());
    extent.high = std::max(extent.high, p.y());
    extent.radius = std::max(extent.radius, p.x());
  }
  return extent;
}

double offBy(const Extent& extent, const Box3& wanted) {
  return std::abs(extent.low - wanted.min.z()) + std::abs(extent.high - wanted.max.z()) +
         std::abs(2.0 * extent.radius - wanted.size().head<2>().maxCoeff());
}

std::size_t bodyLike(const std::vector<SectionBody>& bodies, const Box3& wanted) {
  const auto more = [&](const SectionBody& a, const SectionBody& b) {
    return offBy(extentOf(a), wanted) < offBy(extentOf(b), wanted);
  };
  return static_cast<std::size_t>(std::min_element(bodies.begin(), bodies.end(), more) - bodies.begin());
}

bool holds(const SectionBody& body, const Vec3& p) {
  const Vec2 at(p.head<2>().norm(), p.z());
  const auto around = [&](const SectionLoop& loop) { return surrounds(loop.points, at); };
  return std::count_if(body.loops.begin(), body.loops.end(), around) % 2 == 1;
}

Error inNoBody(const std::vector<SectionBody>& bodies, const Vec3& p) {
  constexpr std::size_t kMostNamed = 3;
  std::string text = pointInNoBody(p);
  for (std::size_t k = 0; k < std::min(bodies.size(), kMostNamed); ++k) {
    const Extent extent = extentOf(bodies[k]);
    text += fmt::format("{} a body of {:.6g} mm3, Z{:.3f} to Z{:.3f}, radius {:.3f}", k == 0 ? ":" : ";",
                        bodies[k].volume_mm3, extent.low, extent.high, extent.radius);
  }
  return inputError(text);
}

/// The largest piece that a programmed parting left; 0: there is none.
std::size_t partedOff(const std::vector<SectionBody>& bodies) {
  std::size_t best = 0;
  const double held_to = extentOf(bodies.front()).high;
  for (std::size_t k = 1; k < bodies.size(); ++k) {
    if (!bodies[k].by_parting || extentOf(bodies[k]).low < held_to - kInFront) continue;
    if (best == 0 || bodies[k].volume_mm3 > bodies[best].volume_mm3) best = k;
  }
  return best;
}

}  // namespace

Result<PartChoice> partAmong(const std::vector<SectionBody>& bodies, const PieceOptions& options) {
  if (options.part_point) {
    for (std::size_t k = 0; k < bodies.size(); ++k)
      if (holds(bodies[k], *options.part_point)) return PartChoice{k, {}};
    return inNoBody(bodies, *options.part_point);
  }
  if (bodies.size() < 2) return PartChoice{};
  std::vector<double> volumes;
  for (const SectionBody& body : bodies) volumes.push_back(body.volume_mm3);
  const PartChoice largest = largestOf(volumes);
  const auto isNotable = [&](std::size_t k) { return volumes[k] >= kNotableShare * volumes[largest.body]; };
  if (options.part) {
    const std::size_t like = bodyLike(bodies, *options.part);
    return isNotable(like) ? PartChoice{like, {}} : doubted(like, volumes);
  }
  const std::size_t parted = partedOff(bodies);
  if (parted == 0) return largest;
  if (volumes[parted] < kSplinterShare * volumes.front()) return PartChoice{largest.body, parted};
  return isNotable(parted) ? PartChoice{parted, {}} : doubted(parted, volumes);
}

}  // namespace proveout
