#include "removal/surface_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/parallel_for.h"

namespace proveout {

namespace {

using Points = std::array<Vec3, 3>;
using Vec3i = Eigen::Vector3i;

/// A triangle whose height is less than this part of its length is none.
constexpr double kFlat = 1e-7;

/// Six times the volume of the tetrahedron.
double orient(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool sameSide(double a, double b, double c) {
  return (a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0);
}

/// A segment and a triangle of one plane.
bool meetFlat(const Vec3& p, const Vec3& q, const Points& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  int drop = 0;
  n.cwiseAbs().maxCoeff(&drop);
  const auto flat = [&](const Vec3& v) { return Vec2(v[(drop + 1) % 3], v[(drop + 2) % 3]); };
  const Vec2 a = flat(p), b = flat(q);
  const std::array<Vec2, 3> c = {flat(t[0]), flat(t[1]), flat(t[2])};
  if (sameSide(turn(c[0], c[1], a), turn(c[1], c[2], a), turn(c[2], c[0], a))) return true;
  for (int i = 0; i < 3; ++i) {
    const Vec2 &from = c[i], &to = c[(i + 1) % 3];
    const double to_a = turn(from, to, a), to_b = turn(from, to, b);
    if (to_a == 0.0 && to_b == 0.0) continue;  // on one line: told by the other edges, if they overlap
    if (to_a * to_b <= 0.0 && turn(a, b, from) * turn(a, b, to) <= 0.0) return true;
  }
  return false;
}

bool segmentMeets(const Vec3& p, const Vec3& q, const Points& t) {
  const double side_p = orient(t[0], t[1], t[2], p), side_q = orient(t[0], t[1], t[2], q);
  if (side_p * side_q > 0.0) return false;
  if (side_p == 0.0 && side_q == 0.0) return meetFlat(p, q, t);
  return sameSide(orient(p, q, t[0], t[1]), orient(p, q, t[1], t[2]), orient(p, q, t[2], t[0]));
}

class Finder {
 public:
  Finder(const TriMesh& mesh, double block_mm) : mesh_(mesh), scale_(1.0 / block_mm) {}

  std::vector<std::array<std::uint32_t, 2>> find(std::span<const std::uint8_t> suspect);

 private:
  struct Span {
    Eigen::Vector3f low, high;
  };
  struct Held {
    Span span;
    std::uint32_t triangle;
  };
  Span spanOf(std::uint32_t t) const {
    const auto& v = mesh_.triangles[t];
    const auto &a = mesh_.positions[v[0]], &b = mesh_.positions[v[1]], &c = mesh_.positions[v[2]];
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
  }
  Vec3i blockOf(const Eigen::Vector3f& p) const {
    return (p.cast<double>() * scale_).array().floor().cast<int>().matrix();
  }
  std::size_t bucketOf(const Vec3i& block) const {
    const auto key = static_cast<std::uint64_t>(block.x()) * 0x9E3779B97F4A7C15ull ^
                     static_cast<std::uint64_t>(block.y()) * 0xC2B2AE3D27D4EB4Full ^
                     static_cast<std::uint64_t>(block.z()) * 0x165667B19E3779F9ull;
    return (key ^ key >> 29) * 0xBF58476D1CE4E5B9ull >> shift_;
  }
  template <typename Body>
  void eachBlock(std::uint32_t t, const Span& span, Body&& body) const;
  Points points(std::uint32_t t) const {
    const auto& v = mesh_.triangles[t];
    return {mesh_.positions[v[0]].cast<double>(), mesh_.positions[v[1]].cast<double>(),
            mesh_.positions[v[2]].cast<double>()};
  }
  bool meet(std::uint32_t s, std::uint32_t t) const;
  bool isFlat(std::uint32_t t) const {
    const Points p = points(t);
    const Vec3 a = p[1] - p[0], b = p[2] - p[0];
    const double size2 = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return a.cross(b).squaredNorm() <= kFlat * kFlat * size2 * size2;
  }

  const TriMesh& mesh_;
  double scale_;
  int shift_ = 44;
  /// Bit of a region of blocks, kRegion each way.
  std::size_t regionOf(const Vec3i& block) const {
    return bucketOf(Vec3i(block.x() >> kRegionBits, block.y() >> kRegionBits, block.z() >> kRegionBits)) %
           (kRegionWords * 64);
  }
  bool nearSuspects(const Span& span) const {
    const Vec3i low = blockOf(span.low);
    if ((span.high - span.low).maxCoeff() * scale_ >= kRegion) return true;
    const std::size_t region = regionOf(low);
    return (near_[region / 64] >> (region % 64) & 1) != 0;
  }
  void markRegions(const Span& span);

  static constexpr int kRegionBits = 2, kRegion = 1 << kRegionBits;
  static constexpr std::size_t kRegionWords = 4096;
  std::array<std::uint64_t, kRegionWords>
      near_{};  ///< regions in which triangles may start that reach suspects
  std::vector<std::uint32_t> end_;
  std::vector<Held> held_;  ///< triangles of suspects by bucket
};

void Finder::markRegions(const Span& span) {
  const Vec3i low = blockOf(span.low) - Vec3i::Constant(kRegion), high = blockOf(span.high);
  for (int x = low.x() >> kRegionBits; x <= high.x() >> kRegionBits; ++x) {
    for (int y = low.y() >> kRegionBits; y <= high.y() >> kRegionBits; ++y) {
      for (int z = low.z() >> kRegionBits; z <= high.z() >> kRegionBits; ++z) {
        const std::size_t region = regionOf(Vec3i(x, y, z) * kRegion);
        near_[region / 64] |= 1ull << (region % 64);
      }
    }
  }
}

/// Blocks of the span that the triangle's plane comes to.
template <typename Body>
void Finder::eachBlock(std::uint32_t t, const Span& span, Body&& body) const {
  const Vec3i low = blockOf(span.low), high = blockOf(span.high);
  const Vec3i size = high - low;
  const bool large = size.maxCoeff() > 2;
  Vec3 n = Vec3::Zero();
  double d = 0.0, reach = 0.0;
  if (large) {
    const Points p = points(t);
    n = (p[1] - p[0]).cross(p[2] - p[0]);
    d = n.dot(p[0]) * scale_;
    reach = 0.51 * n.cwiseAbs().sum() + 1e-9;
  }
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) {
        if (large && std::abs(n.dot(Vec3(x + 0.5, y + 0.5, z + 0.5)) - d) > reach) continue;
        body(Vec3i(x, y, z));
      }
    }
  }
}

/// Whether the corners of `q`, apart from number `but`, are all off the plane of `t` on one side.
bool apart(const Points& t, const Points& q, int but) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  int above = 0, below = 0;
  for (int i = 0; i < 3; ++i) {
    if (i == but) continue;
    const double side = n.dot(q[i] - t[0]);
    above += side > 0.0;
    below += side < 0.0;
  }
  const int all = but < 0 ? 3 : 2;
  return above == all || below == all;
}

bool Finder::meet(std::uint32_t s, std::uint32_t t) const {
  const auto &a = mesh_.triangles[s], &b = mesh_.triangles[t];
  int common = 0, at_a = 0, at_b = 0, sum_b = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      ++common;
      at_a = i;
      at_b = j;
      sum_b += j;
    }
  }
  if (common >= 3) return true;
  const Points p = points(s), q = points(t);
  if (common == 2) {  // folded flat onto each other
    if (orient(p[0], p[1], p[2], q[3 - sum_b]) != 0.0) return false;
    const Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]), m = (q[1] - q[0]).cross(q[2] - q[0]);
    return n.dot(m) < 0.0 && n.squaredNorm() > 0.0;
  }
  if (common == 1) {
    if (apart(p, q, at_b) || apart(q, p, at_a)) return false;
    return segmentMeets(p[(at_a + 1) % 3], p[(at_a + 2) % 3], q) ||
           segmentMeets(q[(at_b + 1) % 3], q[(at_b + 2) % 3], p);
  }
  if (apart(p, q, -1) || apart(q, p, -1)) return false;
  for (int i = 0; i < 3; ++i) {
    if (segmentMeets(p[i], p[(i + 1) % 3], q) || segmentMeets(q[i], q[(i + 1) % 3], p)) return true;
  }
  return false;
}

std::vector<std::array<std::uint32_t, 2>> Finder::find(std::span<const std::uint8_t> suspect) {
  std::vector<std::uint32_t> suspects;
  const auto isSuspect = [&](std::uint32_t t) {
    const auto& v = mesh_.triangles[t];
    return (suspect[v[0]] | suspect[v[1]] | suspect[v[2]]) != 0;
  };
  const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
  for (std::uint32_t t = 0; t < count; ++t) {
    if (isSuspect(t)) suspects.push_back(t);
  }
  if (suspects.empty()) return {};
  const int bits = std::clamp(static_cast<int>(std::bit_width(suspects.size())) + 3, 12, 28);
  shift_ = 64 - bits;
  end_.assign((std::size_t{1} << bits) + 1, 0);
  for (const std::uint32_t t : suspects) {
    markRegions(spanOf(t));
    eachBlock(t, spanOf(t), [&](const Vec3i& block) { ++end_[bucketOf(block)]; });
  }
  std::uint32_t total = 0;
  for (std::uint32_t& e : end_) {
    const std::uint32_t n = e;
    e = total;
    total += n;
  }
  held_.resize(total);
  for (const std::uint32_t t : suspects) {
    const Span span = spanOf(t);
    eachBlock(t, span, [&](const Vec3i& block) { held_[end_[bucketOf(block)]++] = {span, t}; });
  }
  constexpr std::uint32_t kPart = 4096;
  std::vector<std::vector<std::array<std::uint32_t, 2>>> found((count + kPart - 1) / kPart);
  parallelFor(std::size_t{0}, found.size(), [&](std::size_t part) {
    const auto first = static_cast<std::uint32_t>(part) * kPart;
    for (std::uint32_t t = first; t < std::min(count, first + kPart); ++t) {
      const Span own = spanOf(t);
      if (!nearSuspects(own)) continue;
      const bool doubtful = isSuspect(t);
      if (doubtful && isFlat(t)) found[part].push_back({t, t});
      eachBlock(t, own, [&](const Vec3i& block) {
        const std::size_t bucket = bucketOf(block);
        for (std::uint32_t i = bucket == 0 ? 0 : end_[bucket - 1]; i < end_[bucket]; ++i) {
          const auto& [other, s] = held_[i];
          if (s == t || (doubtful && s > t)) continue;
          if ((own.low.array() > other.high.array()).any() || (other.low.array() > own.high.array()).any()) {
            continue;
          }
          if (blockOf(own.low.cwiseMax(other.low)) != block) continue;  // once a pair
          if (meet(s, t)) found[part].push_back({std::min(s, t), std::max(s, t)});
        }
      });
    }
  });
  std::vector<std::array<std::uint32_t, 2>> out;
  for (const auto& list : found) out.insert(out.end(), list.begin(), list.end());
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> findIntersections(const TriMesh& mesh,
                                                            std::span<const std::uint8_t> suspect,
                                                            double block_mm) {
  return Finder(mesh, block_mm).find(suspect);
}

}  // namespace proveout
