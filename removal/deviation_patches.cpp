#include "removal/deviation_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/mesh/edge_table.h"

namespace proveout {
namespace patch_detail {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A region while it is gathered. Sides: 0 machined, 1 nominal.
struct Region {
  double area[2] = {0.0, 0.0};
  double volume[2] = {0.0, 0.0};
  double depth = 0.0;
  Vec3 where = Vec3::Zero();
  std::uint32_t deepest = kNone;  ///< node number
  double deepest_sum = -std::numeric_limits<double>::infinity();
  MotionId deepest_motion = kNoMotion;
  std::map<MotionId, double> area_by_motion[2];
  Box3 bounds;
  bool has_machined = false;
};

/// Area and integral of f over the part of a triangle where f, linear between its corners, exceeds `level`.
struct ClippedIntegral {
  double area = 0.0, integral = 0.0;
};
ClippedIntegral integrateAbove(double area, const std::array<double, 3>& f, double level) {
  // Clipping in barycentric coordinates: a corner's share of the triangle is the product of two edge
  // parameters.
  const int above = (f[0] > level) + (f[1] > level) + (f[2] > level);
  const double whole = area * (f[0] + f[1] + f[2]) / 3.0;
  if (above == 0) return {};
  if (above == 3) return {area, whole};
  int lone = 0;  // the corner that is alone on its side of the level
  while ((f[lone] > level) != (above == 1)) ++lone;
  const double f0 = f[lone], f1 = f[(lone + 1) % 3], f2 = f[(lone + 2) % 3];
  const double cut = area * ((f0 - level) / (f0 - f1)) * ((f0 - level) / (f0 - f2));
  const double cut_integral = cut * (f0 + 2.0 * level) / 3.0;
  if (above == 1) return {cut, cut_integral};
  return {area - cut, whole - cut_integral};
}

class PatchFinder {
 public:
  PatchFinder(const BothSides& sides, DeviationKind kind, double level)
      : sides_(sides),
        kind_(kind),
        level_(level),
        offset_(sides.machined.deviation.size()),
        sets_(offset_ + sides.nominal.deviation.size()) {}

  std::vector<DeviationPatch> run() {
    joinAlongSurfaces();
    joinAcross();
    numberRegions();
    findDeepest();
    for (int side = 0; side < 2; ++side) gatherTriangles(side);
    attachLonelyNominalRegions();
    return finish();
  }

 private:
  const SampledSide& side(int i) const { return i == 0 ? sides_.machined : sides_.nominal; }
  std::uint32_t node(int s, std::uint32_t vertex) const {
    return s == 0 ? vertex : static_cast<std::uint32_t>(offset_ + vertex);
  }
  double depth(int s, std::uint32_t vertex) const {
    const double d = side(s).deviation[vertex];
    return kind_ == DeviationKind::kExcess ? d : -d;
  }
  bool over(int s, std::uint32_t vertex) const { return depth(s, vertex) > level_; }

  void joinAlongSurfaces() {
    for (int s = 0; s < 2; ++s) {
      for (const auto& t : side(s).mesh->surface.triangles) {
        for (int c = 0; c < 3; ++c) {
          const std::uint32_t a = t[c], b = t[(c + 1) % 3];
          if (over(s, a) && over(s, b)) sets_.join(node(s, a), node(s, b));
        }
      }
    }
  }

  /// A nominal point belongs to the region that its nearest machined triangle lies in.
  void joinAcross() {
    for (std::uint32_t i = 0; i < sides_.nominal.deviation.size(); ++i) {
      if (!over(1, i)) continue;
      for (const auto v : sides_.machined.mesh->surface.triangles[sides_.nominal.opposite[i]]) {
        if (over(0, v)) sets_.join(node(1, i), v);
      }
    }
  }

  void numberRegions() {
    region_of_.assign(offset_ + sides_.nominal.deviation.size(), kNone);
    for (int s = 0; s < 2; ++s) {
      for (std::uint32_t i = 0; i < side(s).deviation.size(); ++i) {
        if (!over(s, i)) continue;
        const std::uint32_t n = node(s, i), root = sets_.find(n);
        if (root == n) {  // the representative is the smallest of its set: it comes first
          region_of_[n] = static_cast<std::uint32_t>(regions_.size());
          regions_.emplace_back();
        } else {
          region_of_[n] = region_of_[root];
        }
        if (s == 0) regions_[region_of_[n]].has_machined = true;
      }
    }
  }

  void findDeepest() {
    for (int s = 0; s < 2; ++s) {
      const auto& points = side(s).mesh->surface.points;
      for (std::uint32_t i = 0; i < side(s).deviation.size(); ++i) {
        const std::uint32_t number = region_of_[node(s, i)];
        if (number == kNone) continue;
        Region& r = regions_[number];
        if (s == 0 || !r.has_machined) r.bounds.extend(points[i]);
        if (depth(s, i) <= r.depth) continue;
        r.depth = depth(s, i);
        r.where = points[i];
        r.deepest = node(s, i);
      }
    }
  }

  MotionId motionOf(int s, std::size_t triangle) const {
    const auto& motion = *sides_.motion;
    if (motion.empty()) return kNoMotion;
    if (s == 0) return motion[sides_.machined.mesh->parent[triangle]];
    const std::uint32_t vertex = side(1).mesh->surface.triangles[triangle][0];
    return motion[sides_.machined.mesh->parent[sides_.nominal.opposite[vertex]]];
  }

  void gatherTriangles(int s) {
    const SampledSide& surface = side(s);
    for (std::size_t t = 0; t < surface.mesh->surface.triangles.size(); ++t) {
      const auto& v = surface.mesh->surface.triangles[t];
      std::uint32_t number = kNone;
      for (const auto i : v) {
        if (number == kNone) number = region_of_[node(s, i)];
      }
      if (number != kNone) gather(s, t, v, regions_[number]);
    }
  }

  void gather(int s, std::size_t t, const std::array<std::uint32_t, 3>& v, Region& r) const {
    const auto& p = side(s).mesh->surface.points;
    const Vec3 doubled = (p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[0]]);
    const std::array<double, 3> f = {depth(s, v[0]), depth(s, v[1]), depth(s, v[2])};
    const double area = 0.5 * doubled.norm();
    const ClippedIntegral part = integrateAbove(area, f, level_);
    r.area[s] += part.area;
    const MotionId motion = motionOf(s, t);
    r.area_by_motion[s][motion] += part.area;
    if (area > 0.0) {
      // Depth over the area as the other surface sees it: a pit's wall adds none, its floor all.
      const auto& g = side(s).gradient;
      const Vec3 mean = (g[v[0]] + g[v[1]] + g[v[2]]).cast<double>() / 3.0;
      r.volume[s] += part.integral * mean.dot(doubled) / (2.0 * area);
    }
    for (const auto i : v) {
      if (node(s, i) != r.deepest || f[0] + f[1] + f[2] <= r.deepest_sum) continue;
      r.deepest_sum = f[0] + f[1] + f[2];
      r.deepest_motion = motion;
    }
  }

  /// Nominal samples near the rim of a narrow region may have nearest machined triangles just beside it: what
  /// lies within the bounds of a machined region, up to two spacings, is the same finding.
  void attachLonelyNominalRegions() {
    const double reach = 2.0 * std::max(sides_.machined.mesh->spacing_mm, sides_.nominal.mesh->spacing_mm);
    for (Region& lonely : regions_) {
      if (lonely.has_machined) continue;
      for (Region& r : regions_) {
        if (!r.has_machined || !r.bounds.inflated(reach).overlaps(lonely.bounds)) continue;
        merge(lonely, r);
        lonely.deepest = kNone;
        break;
      }
    }
  }

  static void merge(const Region& from, Region& into) {
    into.area[1] += from.area[1];
    into.volume[1] += from.volume[1];
    if (from.depth <= into.depth) return;
    into.depth = from.depth;
    into.where = from.where;
    into.deepest_motion = from.deepest_motion;
  }

  void chooseMotions(const Region& r, int s, DeviationPatch& p) const {
    const bool gouge = kind_ == DeviationKind::kGouge;
    double largest = -1.0;
    for (const auto& [motion, area] : r.area_by_motion[s]) {
      // Only a cutter makes a gouge: at its rim the blank's own surface is no cause.
      if (area <= largest || (gouge && motion == kNoMotion && largest >= 0.0)) continue;
      largest = area;
      p.main_motion = motion;
    }
    p.main_motion_share = p.area_mm2 > 0.0 ? largest / p.area_mm2 : 1.0;
    p.motion = gouge && r.deepest_motion == kNoMotion ? p.main_motion : r.deepest_motion;
  }

  std::vector<DeviationPatch> finish() const {
    std::vector<DeviationPatch> out;
    for (const Region& r : regions_) {
      if (r.deepest == kNone) continue;
      DeviationPatch p;
      p.kind = kind_;
      p.where = r.where;
      p.depth_mm = r.depth;
      p.from_nominal_only = !r.has_machined;
      const int s = r.has_machined ? 0 : 1;
      p.area_mm2 = r.area[s];
      // Depth is a distance to the nearest point, so that seen from a rim it falls short: the larger of the
      // two integrals is the better one. A pit is seen whole from the machined side, an uncut pocket from the
      // nominal's.
      p.volume_mm3 = std::max({r.volume[0], r.volume[1], 0.0});
      p.bounds = r.bounds;
      chooseMotions(r, s, p);
      out.push_back(p);
    }
    return out;
  }

  const BothSides& sides_;
  DeviationKind kind_;
  double level_;
  std::size_t offset_;
  DisjointSets sets_;
  std::vector<std::uint32_t> region_of_;  ///< per node
  std::vector<Region> regions_;
};

}  // namespace patch_detail

std::vector<DeviationPatch> findPatches(const BothSides& sides, DeviationKind kind, double level_mm) {
  return patch_detail::PatchFinder(sides, kind, level_mm).run();
}

}  // namespace proveout
