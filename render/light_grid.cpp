#include "render/light_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/parallel_for.h"

namespace proveout::render_detail {
namespace {

using Vec3f = Eigen::Vector3f;
using What = Seen::What;

constexpr float kRayOffset = 1e-4F;  ///< units; float positions and hits are good to about 1e-6
constexpr float kShadow = 0.002F;    ///< shares this near to none or all are no half shadows
constexpr int kRefinedPattern =
    2 * LightGrid::kRefinedReach + 1;  ///< after which their points of the light repeat
constexpr float kFewAlike = 20.0F;     ///< points of the grid on a narrow face
constexpr float kEnough = 0.02F;       ///< weight of what is alike around a pixel
constexpr float kShadedWithin = 3.0F;  ///< units from the part's middle: the ground beyond is never shaded

/// Number of the lights' points that a point of the grid asks: they repeat. Rows, columns and small squares
/// of the grid ask points that lie well apart.
std::uint32_t patternNumber(int i, int j) {
  constexpr int kPattern = LightGrid::kPattern, kAlong = 25;
  return static_cast<std::uint32_t>((kAlong * i + kPattern * j) % (kPattern * kPattern));
}

/// The k-th point of a lattice of as many points as the pattern has.
Eigen::Vector2f latticePoint(std::uint32_t k) {
  constexpr std::uint32_t kPoints = LightGrid::kPattern * LightGrid::kPattern, kGenerator = 11;
  const auto part = [](std::uint32_t n) { return (static_cast<float>(n % kPoints) + 0.5F) / kPoints; };
  return {part(k), part(kGenerator * k)};
}

/// The same of packs of the light's points: those of any square of a refined reach are all different.
std::uint32_t packNumber(int i, int j) {
  return static_cast<std::uint32_t>(kRefinedPattern * (j % kRefinedPattern) + i % kRefinedPattern);
}

}  // namespace

LightGrid::LightGrid(const SeenBand& band, const RayScene& rays, const Lights& lights, float near)
    : band_(band),
      rays_(rays),
      lights_(lights),
      points_((band.width + kStep - 1) / kStep, (band.first + kStep - 1) / kStep,
              (band.first + band.rows - 1) / kStep - (band.first + kStep - 1) / kStep + 1, near),
      raw_(points_.fullLight()),
      smooth_(raw_) {
  parallelFor(points_.firstRow(), points_.endRow(), [&](int j) { traceRow(j); });
  parallelFor(points_.firstRow(), points_.endRow(), [&](int j) {
    for (int i = 0; i < points_.columns(); i += LightPoints::kBlock)
      points_.average(raw_, i, j, kPattern / 2, smooth_);
  });
  refineNarrow();
  refineShadows();
  smoothSky();
}

template <typename Chosen>
void LightGrid::averageWhere(const LitPoints& in, int reach, const Chosen& chosen, LitPoints& out) const {
  parallelFor(points_.firstRow(), points_.endRow(), [&](int j) {
    for (int first = 0; first < points_.columns(); first += LightPoints::kBlock) {
      const int end = std::min(points_.columns(), first + LightPoints::kBlock);
      for (int i = first; i < end; ++i) {
        if (!chosen(points_.index(i, j))) continue;
        points_.average(in, first, j, reach, out);
        break;
      }
    }
  });
}

/// Flanks of threads, narrow grooves and lands have few points, each of which has asked for one point of the
/// light: they ask for more.
void LightGrid::refineNarrow() {
  const auto narrow = [&](std::size_t k) { return smooth_.alike[k] < kFewAlike; };
  parallelFor(points_.firstRow(), points_.endRow(), [&](int j) {
    for (int i = 0; i < points_.columns(); ++i) {
      const std::size_t k = points_.index(i, j);
      if (narrow(k) && seenAt(i, j).what != What::kNothing)
        raw_.set(k, askAlone(seenAt(i, j), packNumber(i, j)));
    }
  });
  LitPoints averaged = smooth_;
  averageWhere(raw_, kRefinedReach, narrow, averaged);
  for (std::size_t k = 0; k < smooth_.alike.size(); ++k) {
    if (narrow(k)) smooth_.set(k, averaged.at(k));
  }
}

/// In half shadows one point of the light says little of its neighbours: more are asked, and fewer
/// neighbours.
void LightGrid::refineShadows() {
  const auto half = [&](std::size_t k) {
    return smooth_.key[k] > kShadow && smooth_.key[k] < 1.0F - kShadow;
  };
  parallelFor(points_.firstRow(), points_.endRow(), [&](int j) {
    for (int i = 0; i < points_.columns(); ++i) {
      const std::size_t k = points_.index(i, j);
      if (half(k) && seenAt(i, j).what != What::kNothing)
        raw_.key[k] = keyShare(seenAt(i, j), packNumber(i, j));
    }
  });
  // Once for the packs, and once more since the shadow has changed from one to the next.
  LitPoints averaged = smooth_;
  for (int time = 0; time < 2; ++time) {
    averageWhere(raw_, kRefinedReach, half, averaged);
    raw_.key = smooth_.key;
    for (std::size_t k = 0; k < raw_.key.size(); ++k) {
      if (half(k)) raw_.key[k] = averaged.key[k];
    }
  }
  smooth_.key = raw_.key;
}

/// On curved surfaces and beside edges some points of the pattern count more than others: what that leaves is
/// averaged once more.
void LightGrid::smoothSky() {
  const auto dimmed = [&](std::size_t k) { return smooth_.sky[k] < 1.0F; };
  LitPoints smoother = smooth_;
  averageWhere(smooth_, kSmootherReach, dimmed, smoother);
  for (std::size_t k = 0; k < smooth_.sky.size(); ++k) {
    if (dimmed(k)) smooth_.sky[k] = smoother.sky[k];
  }
}

/// Share of the key light from a pack of its points.
float LightGrid::keyShare(const Seen& seen, std::uint32_t pack) const {
  if (!lights_.aboveFace(seen.face)) return 0.0F;
  RayPack rays;
  for (std::uint32_t n = 0; n < RayPack::kRays; ++n) {
    rays.set(static_cast<int>(n), seen.point + seen.face * kRayOffset,
             lights_.towardsKey(evenPoint(RayPack::kRays * pack + n)));
  }
  return 1.0F - static_cast<float>(std::popcount(rays_.occluded(rays, Lights::kKeyReach))) / RayPack::kRays;
}

void LightGrid::ask(const Seen* const* seen, const Eigen::Vector2f* xi, int count, Lit* out) const {
  RayPack key, sky;
  for (int n = 0; n < count; ++n) {
    const Seen& s = *seen[n];
    out[n] = {};
    if (s.what == What::kGround && s.point.squaredNorm() > kShadedWithin * kShadedWithin) continue;
    const Vec3f origin = s.point + s.face * kRayOffset;
    sky.set(n, origin, Lights::towardsSky(s.normal, s.face, xi[n]));
    if (lights_.aboveFace(s.face)) {
      key.set(n, origin, lights_.towardsKey(xi[n]));
    } else {
      out[n].key = 0.0F;
    }
  }
  const std::uint32_t shadowed = rays_.occluded(key, Lights::kKeyReach);
  const std::uint32_t dark = rays_.occluded(sky, Lights::kSkyReach);
  for (int n = 0; n < count; ++n) {
    if (shadowed >> n & 1U) out[n].key = 0.0F;
    if (dark >> n & 1U) out[n].sky = 0.0F;
  }
}

void LightGrid::traceRow(int j) {
  std::array<const Seen*, RayPack::kRays> seen{};
  std::array<Eigen::Vector2f, RayPack::kRays> xi;
  std::array<int, RayPack::kRays> column{};
  std::array<Lit, RayPack::kRays> lit;
  int count = 0;
  const auto flush = [&] {
    if (count > 0) ask(seen.data(), xi.data(), count, lit.data());
    for (int n = 0; n < count; ++n)
      raw_.set(points_.index(column[static_cast<std::size_t>(n)], j), lit[static_cast<std::size_t>(n)]);
    count = 0;
  };
  for (int i = 0; i < points_.columns(); ++i) {
    const Seen& s = seenAt(i, j);
    points_.set(i, j, s);
    if (s.what == What::kNothing) continue;
    const auto n = static_cast<std::size_t>(count);
    seen[n] = &s;
    xi[n] = latticePoint(patternNumber(i, j));
    column[n] = i;
    if (++count == RayPack::kRays) flush();
  }
  flush();
}

Lit LightGrid::at(int x, int y, const Seen& seen) const {
  // Of the points beside the pixel, or at it; of more where these show something else.
  const Mean near = meanAround(x, y, kStep, seen);
  if (near.weights >= kEnough) return near.lit();
  const Mean wide = meanAround(x, y, 2 * kStep, seen);
  return wide.weights >= kEnough ? wide.lit() : askAlone(seen, 0);
}

/// Of the points within `width` pixels, less the farther away they are.
LightGrid::Mean LightGrid::meanAround(int x, int y, int width, const Seen& seen) const {
  const auto first = [&](int a, int least) { return std::max(least, (a - width + kStep) / kStep); };
  const auto end = [&](int a, int most) { return std::min(most, (a + width + kStep - 1) / kStep); };
  const float per_width = 1.0F / static_cast<float>(width);
  Mean mean;
  for (int v = first(y, points_.firstRow()); v < end(y, points_.endRow()); ++v) {
    const float row = 1.0F - static_cast<float>(std::abs(y - kStep * v)) * per_width;
    for (int u = first(x, 0); u < end(x, points_.columns()); ++u) {
      const float beside = 1.0F - static_cast<float>(std::abs(x - kStep * u)) * per_width;
      mean.add(row * beside * points_.likenessTo(seen, u, v), smooth_.at(points_.index(u, v)));
    }
  }
  return mean;
}

/// For what the grid has missed, as narrow as it is.
Lit LightGrid::askAlone(const Seen& seen, std::uint32_t pack) const {
  std::array<const Seen*, RayPack::kRays> same;
  same.fill(&seen);
  std::array<Eigen::Vector2f, RayPack::kRays> xi;
  for (std::uint32_t n = 0; n < RayPack::kRays; ++n) xi[n] = evenPoint(RayPack::kRays * pack + n);
  std::array<Lit, RayPack::kRays> lit;
  ask(same.data(), xi.data(), RayPack::kRays, lit.data());
  Lit sum{0.0F, 0.0F};
  for (const Lit& one : lit) {
    sum.key += one.key / RayPack::kRays;
    sum.sky += one.sky / RayPack::kRays;
  }
  return sum;
}

}  // namespace proveout::render_detail
