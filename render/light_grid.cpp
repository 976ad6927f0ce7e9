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
constexpr int kRefinedReach = 1;     ///< points of the grid
constexpr int kRefinedPattern = 2 * kRefinedReach + 1;  ///< after which their points of the light repeat
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
    : band_(band), rays_(rays), lights_(lights), near_(near) {
  columns_ = (band.width + kStep - 1) / kStep;
  row0_ = (band.first + kStep - 1) / kStep;
  rows_ = (band.first + band.rows - 1) / kStep - row0_ + 1;
  raw_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(std::max(0, rows_)));
  smooth_.resize(raw_.size());
  parallelFor(row0_, row0_ + rows_, [&](int j) { traceRow(j); });
  parallelFor(row0_, row0_ + rows_, [&](int j) {
    for (int i = 0; i < columns_; ++i) smooth_[index(i, j)] = averageAround(raw_, i, j, kPattern / 2);
  });
  refineShadows();
  smoothSky();
}

/// In half shadows one point of the light says little of its neighbours: more are asked, and fewer
/// neighbours.
void LightGrid::refineShadows() {
  const auto half = [&](int i, int j) {
    const float key = smooth_[index(i, j)].key;
    return seenAt(i, j).what != What::kNothing && key > kShadow && key < 1.0F - kShadow;
  };
  parallelFor(row0_, row0_ + rows_, [&](int j) {
    for (int i = 0; i < columns_; ++i) {
      if (half(i, j)) raw_[index(i, j)].key = keyShare(seenAt(i, j), packNumber(i, j));
    }
  });
  // Once for the packs, and once more since the shadow has changed from one to the next.
  std::vector<Lit> refined = smooth_;
  parallelFor(row0_, row0_ + rows_, [&](int j) {
    for (int i = 0; i < columns_; ++i) {
      if (half(i, j)) refined[index(i, j)].key = averageAround(raw_, i, j, kRefinedReach).key;
    }
  });
  raw_ = refined;
  parallelFor(row0_, row0_ + rows_, [&](int j) {
    for (int i = 0; i < columns_; ++i) {
      if (half(i, j)) refined[index(i, j)].key = averageAround(raw_, i, j, kRefinedReach).key;
    }
  });
  smooth_ = std::move(refined);
}

/// On curved surfaces and beside edges some points of the pattern count more than others: what that leaves is
/// averaged once more.
void LightGrid::smoothSky() {
  std::vector<Lit> smoother = smooth_;
  parallelFor(row0_, row0_ + rows_, [&](int j) {
    for (int i = 0; i < columns_; ++i) {
      if (smooth_[index(i, j)].sky < 1.0F)
        smoother[index(i, j)].sky = averageAround(smooth_, i, j, kSmootherReach).sky;
    }
  });
  smooth_ = std::move(smoother);
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
      raw_[index(column[static_cast<std::size_t>(n)], j)] = lit[static_cast<std::size_t>(n)];
    count = 0;
  };
  for (int i = 0; i < columns_; ++i) {
    const Seen& s = seenAt(i, j);
    if (s.what == What::kNothing) continue;
    const auto n = static_cast<std::size_t>(count);
    seen[n] = &s;
    xi[n] = latticePoint(patternNumber(i, j));
    column[n] = i;
    if (++count == RayPack::kRays) flush();
  }
  flush();
}

Lit LightGrid::averageAround(const std::vector<Lit>& shares, int i, int j, int reach) const {
  const Seen& own = seenAt(i, j);
  if (own.what == What::kNothing) return {};
  const int i0 = std::max(0, i - reach), i1 = std::min(columns_ - 1, i + reach);
  const int j0 = std::max(row0_, j - reach), j1 = std::min(row0_ + rows_ - 1, j + reach);
  float weights = 0.0F;
  Lit sum{0.0F, 0.0F};
  for (int v = j0; v <= j1; ++v) {
    for (int u = i0; u <= i1; ++u) {
      const float weight = likeness(own, seenAt(u, v), near_);
      const Lit& other = shares[index(u, v)];
      weights += weight;
      sum.key += weight * other.key;
      sum.sky += weight * other.sky;
    }
  }
  return {sum.key / weights, sum.sky / weights};  // its own weight is 1
}

Lit LightGrid::at(int x, int y, const Seen& seen) const {
  const int i = x / kStep, j = y / kStep;
  float weights = 0.0F;
  Lit sum{0.0F, 0.0F};
  for (int v = std::max(row0_, j - 1); v <= std::min(row0_ + rows_ - 1, j + 1); ++v) {
    for (int u = std::max(0, i - 1); u <= std::min(columns_ - 1, i + 1); ++u) {
      const auto away = [](int a, int b) { return static_cast<float>(std::abs(a - kStep * b)); };
      const float near = (1.0F - away(x, u) / (2 * kStep)) * (1.0F - away(y, v) / (2 * kStep));
      if (near <= 0.0F) continue;
      const float weight = near * likeness(seen, seenAt(u, v), near_);
      const Lit& other = smooth_[index(u, v)];
      weights += weight;
      sum.key += weight * other.key;
      sum.sky += weight * other.sky;
    }
  }
  constexpr float kEnough = 0.02F;
  if (weights < kEnough) return askAlone(seen);
  return {sum.key / weights, sum.sky / weights};
}

/// For what the grid has missed, as narrow as it is.
Lit LightGrid::askAlone(const Seen& seen) const {
  std::array<const Seen*, RayPack::kRays> same;
  same.fill(&seen);
  std::array<Eigen::Vector2f, RayPack::kRays> xi;
  for (std::uint32_t n = 0; n < RayPack::kRays; ++n) xi[n] = evenPoint(n);
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
