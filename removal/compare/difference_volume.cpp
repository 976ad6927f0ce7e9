#include "removal/compare/difference_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/mesh/edge_table.h"

namespace proveout {

namespace {

/// Columns along the longer side; finer for what is thinner than so many of them: where walls stand along the
/// columns the error goes with their number to the power of -1.5.
constexpr int kColumns = 256, kFineColumns = 640;
constexpr double kThin = 16.0;
/// Columns stand at another place in each cell, so that faces along rows of cells are counted as well as
/// others: where in the cell, 0..1, by a mix of its number's bits.
Vec2 placeInCell(int i, int j) {
  std::uint64_t x =
      (static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint32_t>(j)) + 0x9E3779B97F4A7C15u;
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  x ^= x >> 31;
  constexpr double kUnit = 1.0 / 4294967296.0;
  return {static_cast<double>(x >> 32) * kUnit, static_cast<double>(x & 0xFFFFFFFFu) * kUnit};
}

/// A surface passes a column.
struct Hit {
  std::uint32_t column;
  float at;                ///< along it, from the middle of the bounds, mm
  std::int8_t side, into;  ///< 0 machined, 1 nominal; +1 into the material, -1 out of it
};

/// A stretch of a column between the surfaces.
struct Layer {
  std::uint32_t column;
  float low, high;
};

class Columns {
 public:
  Columns(const Box3& bounds, int axis, int columns)
      : axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), bounds_(bounds) {
    const Vec3 size = bounds.size();
    cell_ = std::max(size[u_], size[v_]) / columns;
    nu_ = std::max(1, static_cast<int>(std::ceil(size[u_] / cell_)));
    nv_ = std::max(1, static_cast<int>(std::ceil(size[v_] / cell_)));
    middle_ = bounds.center()[axis];
  }

  void add(const TreedSurface& surface, std::int8_t side) {
    Box3 reach = bounds_;
    reach.min[axis_] = -1e30;
    reach.max[axis_] = 1e30;
    surface.tree->forEachIn(reach, [&](std::uint32_t t) { addTriangle(*surface.mesh, t, side); });
  }

  double volume(DeviationKind kind, const std::vector<Vec3>& places, double least) {
    findLayers(kind == DeviationKind::kExcess ? 0 : 1, least);
    if (layers_.empty()) return 0.0;
    joinLayers();
    std::vector<char> wanted(layers_.size(), 0);
    for (const Vec3& p : places) markAt(p, least, wanted);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < layers_.size(); ++i) {
      if (!wanted[sets_->find(i)]) continue;
      sum += layers_[i].high - layers_[i].low;
      ++count_;
      low_ = std::min(low_, middle_ + layers_[i].low);
      high_ = std::max(high_, middle_ + layers_[i].high);
    }
    return sum * cell_ * cell_;
  }
  /// Where the pieces that were counted begin and end along the axis; for none low > high.
  double low() const { return low_; }
  double high() const { return high_; }
  /// How many layers that are: the more, the better they fit the pieces.
  std::size_t count() const { return count_; }
  double cell() const { return cell_; }

 private:
  struct Corner {
    double u, v, w;
  };

  /// Twice the signed area of a, b and the place; the same for both triangles at an edge, but for its sign.
  static double edgeArea(const Corner& a, const Corner& b, double u, double v) {
    const bool ordered = a.u != b.u ? a.u < b.u : a.v < b.v;
    const Corner &p = ordered ? a : b, &q = ordered ? b : a;
    const double area = (q.u - p.u) * (v - p.v) - (q.v - p.v) * (u - p.u);
    return ordered ? area : -area;
  }

  void addTriangle(const SurfaceMesh& mesh, std::uint32_t t, std::int8_t side) {
    std::array<Corner, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.points[mesh.triangles[t][k]];
      c[k] = {p[u_] - bounds_.min[u_], p[v_] - bounds_.min[v_], p[axis_] - middle_};
    }
    const auto first = [&](double low) { return std::max(0, static_cast<int>(std::floor(low / cell_))); };
    const auto last = [&](double high, int count) {
      return std::min(count - 1, static_cast<int>(std::floor(high / cell_)));
    };
    const int u0 = first(std::min({c[0].u, c[1].u, c[2].u})),
              u1 = last(std::max({c[0].u, c[1].u, c[2].u}), nu_),
              v0 = first(std::min({c[0].v, c[1].v, c[2].v})),
              v1 = last(std::max({c[0].v, c[1].v, c[2].v}), nv_);
    for (int i = u0; i <= u1; ++i) {
      for (int j = v0; j <= v1; ++j) {
        const Vec2 place = placeInCell(i, j);
        const double u = (i + place.x()) * cell_, v = (j + place.y()) * cell_;
        const double a = edgeArea(c[1], c[2], u, v), b = edgeArea(c[2], c[0], u, v),
                     d = edgeArea(c[0], c[1], u, v);
        const bool up = a > 0.0 && b > 0.0 && d > 0.0, down = a < 0.0 && b < 0.0 && d < 0.0;
        if (!up && !down) continue;  // up: the face looks along the axis, the way out of the material
        const double at = (a * c[0].w + b * c[1].w + d * c[2].w) / (a + b + d);
        hits_.push_back({static_cast<std::uint32_t>(i * nv_ + j), static_cast<float>(at), side,
                         static_cast<std::int8_t>(up ? -1 : 1)});
      }
    }
  }

  /// Where `side` has material and the other has none.
  void findLayers(int side, double least) {
    std::sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) {
      if (a.column != b.column) return a.column < b.column;
      if (a.at != b.at) return a.at < b.at;
      return a.side != b.side ? a.side < b.side : a.into < b.into;
    });
    for (std::size_t i = 0; i < hits_.size();) {
      int depth[2] = {0, 0};
      float begin = 0.0f;
      bool open = false;
      const std::uint32_t column = hits_[i].column;
      for (; i < hits_.size() && hits_[i].column == column; ++i) {
        depth[hits_[i].side] += hits_[i].into;
        const bool now = depth[side] > 0 && depth[1 - side] <= 0;
        if (now && !open) begin = hits_[i].at;
        if (!now && open && hits_[i].at - begin > least) layers_.push_back({column, begin, hits_[i].at});
        open = now;
      }
    }
  }

  std::size_t firstOf(std::uint32_t column) const {
    return static_cast<std::size_t>(
        std::lower_bound(layers_.begin(), layers_.end(), column,
                         [](const Layer& l, std::uint32_t c) { return l.column < c; }) -
        layers_.begin());
  }

  void joinLayers() {
    sets_.emplace(layers_.size());
    PROVEOUT_ASSERT_DEAR(std::ranges::is_sorted(layers_, {}, &Layer::column));
    for (std::uint32_t i = 0; i < layers_.size(); ++i) {
      const std::uint32_t column = layers_[i].column;
      std::array<std::uint32_t, 2> next = {column + 1, column + static_cast<std::uint32_t>(nv_)};
      if (next[0] % static_cast<std::uint32_t>(nv_) == 0) next[0] = next[1];
      for (const std::uint32_t beside : next) {
        for (std::size_t j = firstOf(beside); j < layers_.size() && layers_[j].column == beside; ++j) {
          if (layers_[j].low <= layers_[i].high && layers_[i].low <= layers_[j].high)
            sets_->join(i, static_cast<std::uint32_t>(j));
        }
      }
    }
  }

  /// Marks the pieces that a place of the surface lies on: in its own column or one beside it.
  void markAt(const Vec3& p, double least, std::vector<char>& wanted) {
    const int i = static_cast<int>(std::floor((p[u_] - bounds_.min[u_]) / cell_)),
              j = static_cast<int>(std::floor((p[v_] - bounds_.min[v_]) / cell_));
    const double at = p[axis_] - middle_, slack = least + cell_;
    for (int x = std::max(0, i - 1); x <= std::min(nu_ - 1, i + 1); ++x) {
      for (int y = std::max(0, j - 1); y <= std::min(nv_ - 1, j + 1); ++y) {
        const auto column = static_cast<std::uint32_t>(x * nv_ + y);
        for (std::size_t k = firstOf(column); k < layers_.size() && layers_[k].column == column; ++k) {
          if (at >= layers_[k].low - slack && at <= layers_[k].high + slack)
            wanted[sets_->find(static_cast<std::uint32_t>(k))] = 1;
        }
      }
    }
  }

  int axis_, u_, v_, nu_ = 0, nv_ = 0;
  Box3 bounds_;
  double cell_ = 0.0, middle_ = 0.0;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
  std::size_t count_ = 0;
  std::vector<Hit> hits_;
  std::vector<Layer> layers_;
  std::optional<DisjointSets> sets_;
};

}  // namespace

double differenceVolume(const TreedSurface& machined, const TreedSurface& nominal, DeviationKind kind,
                        const Box3& bounds, const std::vector<Vec3>& places, double least_mm) {
  // Flat bounds have no columns along their face.
  const auto roomy = [&](const Box3& b) { return b.inflated(1e-3 * b.size().maxCoeff() + 2.0 * least_mm); };
  Box3 box = roomy(bounds);
  std::array<double, 3> volume{}, cell{};
  std::array<std::size_t, 3> count{};
  std::size_t best = 0;
  // The pieces reach beyond the samples that are over tolerance.
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    Box3 counted = bounds;
    std::array<double, 3> low{}, high{};
    count = {};
    parallelFor(0, 3, [&](int axis) {
      Columns columns(box, axis, kColumns);
      columns.add(machined, 0);
      columns.add(nominal, 1);
      volume[static_cast<std::size_t>(axis)] = columns.volume(kind, places, least_mm);
      cell[static_cast<std::size_t>(axis)] = columns.cell();
      low[static_cast<std::size_t>(axis)] = columns.low();
      high[static_cast<std::size_t>(axis)] = columns.high();
      count[static_cast<std::size_t>(axis)] = columns.count();
    });
    best = static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin());
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      counted.min[axis] = std::min(counted.min[axis], low[k]);
      counted.max[axis] = std::max(counted.max[axis], high[k]);
    }
    const Box3 wanted = roomy(counted);
    const double beyond = std::max((box.min - wanted.min).maxCoeff(), (wanted.max - box.max).maxCoeff());
    if (beyond < 1e-3 * box.size().maxCoeff()) break;
    box = wanted;
  }
  const double thickness = volume[best] / (static_cast<double>(count[best]) * cell[best] * cell[best]);
  if (count[best] == 0 || thickness > kThin * cell[best]) return volume[best];
  Columns columns(box, static_cast<int>(best), kFineColumns);
  columns.add(machined, 0);
  columns.add(nominal, 1);
  return columns.volume(kind, places, least_mm);
}

}  // namespace proveout
