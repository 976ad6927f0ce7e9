#include "render/light_points.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout::render_detail {
namespace {

using Pack = Eigen::Array<float, LightPoints::kBlock, 1>;
constexpr float kBeside = -2.0F;  ///< kind of what lies beside the picture
/// Surfaces that turn by a twelfth of a cosine say nothing of each other.
constexpr float kTurn = 12.0F;

Eigen::Map<const Pack> pack(const std::vector<float>& values, std::size_t k) {
  return Eigen::Map<const Pack>(values.data() + k);
}

float kindOf(const Seen& seen) { return static_cast<float>(static_cast<int>(seen.what)); }

/// Written out: called for every ray, and Eigen's products are not inlined.
float likenessOf(const float* n, const float* p, const float* other_n, const float* other_p, float near) {
  const float turn = n[0] * other_n[0] + n[1] * other_n[1] + n[2] * other_n[2];
  const float across = n[0] * (other_p[0] - p[0]) + n[1] * (other_p[1] - p[1]) + n[2] * (other_p[2] - p[2]);
  return std::max(0.0F, 1.0F - kTurn * (1.0F - turn)) * std::max(0.0F, 1.0F - std::abs(across) / near);
}

/// Columns that are read: whole blocks, and what is in reach of them.
std::size_t pitchOf(int columns) {
  const int blocks = (columns + LightPoints::kBlock - 1) / LightPoints::kBlock;
  return static_cast<std::size_t>(LightPoints::kBlock * blocks + 2 * LightPoints::kMostReach);
}

}  // namespace

float likeness(const Seen& a, const Seen& b, float near) {
  return a.what == b.what ? likenessOf(a.normal.data(), a.point.data(), b.normal.data(), b.point.data(), near)
                          : 0.0F;
}

LightPoints::LightPoints(int columns, int row0, int rows, float near)
    : columns_(columns), row0_(row0), rows_(std::max(0, rows)), pitch_(pitchOf(columns)), near_(near) {
  const std::size_t count = pitch_ * static_cast<std::size_t>(rows_);
  kind_.assign(count, kBeside);
  for (auto* part : {&normal_[0], &normal_[1], &point_[0], &point_[1], &point_[2]}) part->assign(count, 0.0F);
  normal_[2].assign(count, 1.0F);
}

LitPoints LightPoints::fullLight() const {
  const std::vector<float> ones(kind_.size(), 1.0F);
  return {ones, ones, ones};
}

void LightPoints::set(int i, int j, const Seen& seen) {
  const std::size_t k = index(i, j);
  kind_[k] = kindOf(seen);
  if (seen.what == Seen::What::kNothing) return;
  for (int c = 0; c < 3; ++c) {
    normal_[c][k] = seen.normal[c];
    point_[c][k] = seen.point[c];
  }
}

float LightPoints::likenessTo(const Seen& seen, int i, int j) const {
  const std::size_t k = index(i, j);
  if (kind_[k] != kindOf(seen)) return 0.0F;
  const float normal[3] = {normal_[0][k], normal_[1][k], normal_[2][k]};
  const float point[3] = {point_[0][k], point_[1][k], point_[2][k]};
  return likenessOf(seen.normal.data(), seen.point.data(), normal, point, near_);
}

void LightPoints::average(const LitPoints& in, int i, int j, int reach, LitPoints& out) const {
  PROVEOUT_ASSERT(reach <= kMostReach);
  const std::size_t own = index(i, j);
  const Pack kind = pack(kind_, own), nx = pack(normal_[0], own), ny = pack(normal_[1], own),
             nz = pack(normal_[2], own), px = pack(point_[0], own), py = pack(point_[1], own),
             pz = pack(point_[2], own);
  Pack weights = Pack::Zero(), key = Pack::Zero(), sky = Pack::Zero();
  const float per_near = 1.0F / near_;
  for (int v = std::max(row0_, j - reach); v <= std::min(endRow() - 1, j + reach); ++v) {
    for (std::size_t k = index(i - reach, v), end = index(i + reach, v); k <= end; ++k) {
      const Pack turn = nx * pack(normal_[0], k) + ny * pack(normal_[1], k) + nz * pack(normal_[2], k);
      const Pack across =
          nx * (pack(point_[0], k) - px) + ny * (pack(point_[1], k) - py) + nz * (pack(point_[2], k) - pz);
      const Pack weight = (1.0F - kTurn * (1.0F - turn)).max(0.0F) *
                          (1.0F - across.abs() * per_near).max(0.0F) *
                          (1.0F - (pack(kind_, k) - kind).abs()).max(0.0F);  // kinds are whole numbers
      weights += weight;
      key += weight * pack(in.key, k);
      sky += weight * pack(in.sky, k);
    }
  }
  // The own weight is 1.
  Eigen::Map<Pack>(out.key.data() + own) = key / weights;
  Eigen::Map<Pack>(out.sky.data() + own) = sky / weights;
  Eigen::Map<Pack>(out.alike.data() + own) = weights;
}

}  // namespace proveout::render_detail
