#include "removal/compare/deviation_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/assert.h"
#include "core/mesh/edge_table.h"

namespace proveout {
namespace patch_detail {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// What one maker has of a region on one side.
struct Part {
  double area = 0.0, depth = 0.0;
  Vec3 where = Vec3::Zero(), normal = Vec3::Zero();
};

/// A region while it is gathered. Sides: 0 machined, 1 nominal.
struct Region {
  double area[2] = {0.0, 0.0};
  double volume[2] = {0.0, 0.0};
  double depth = 0.0, bound = 0.0;
  MachinedSample machined;
  SurestPlace surest{-1e300, 0.0, 0.0, Vec3::Zero(), Vec3::Zero()};
  Vec3 where = Vec3::Zero(), normal = Vec3::Zero();
  std::uint32_t deepest = kNone;  ///< node number
  double deepest_sum = -std::numeric_limits<double>::infinity();
  SurfaceMaker deepest_maker;
  std::map<SurfaceMaker, Part> makers[2];
  Box3 bounds, machined_bounds;
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
  PatchFinder(const BothSides& sides, DeviationKind kind, double level, Beyond beyond, const ExactPart* part)
      : sides_(sides),
        kind_(kind),
        level_(level),
        possible_(beyond == Beyond::kPossible),
        part_(part),
        offset_(sides.machined.deviation.size()),
        sets_(offset_ + sides.nominal.deviation.size()) {}

  std::vector<FoundPatch> run() {
    for (const SampledSide* own : {&sides_.machined, &sides_.nominal}) {
      const std::size_t count = own->mesh->surface.points.size();
      PROVEOUT_ASSERT(own->deviation.size() == count && own->bound.size() == count &&
                      own->gradient.size() == count && own->opposite.size() == count);
    }
    joinAlongSurfaces();
    joinAcross();
    numberRegions();
    if (regions_.empty()) return {};
    findTriangles();
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
  /// NaN where the sample is left out.
  double depth(int s, std::uint32_t vertex) const {
    const double d = side(s).deviation[vertex];
    return kind_ == DeviationKind::kExcess ? d : -d;
  }
  bool over(int s, std::uint32_t vertex) const {
    return depth(s, vertex) + (possible_ ? side(s).bound[vertex] : 0.0f) > level_;
  }

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

  /// Outward normal of the other surface at its point nearest to a sample: about that of the nominal, too.
  Vec3 normalAt(int s, std::uint32_t vertex) const { return side(s).gradient[vertex].cast<double>(); }

  void findDeepest() {
    for (int s = 0; s < 2; ++s) {
      const auto& points = side(s).mesh->surface.points;
      for (std::uint32_t i = 0; i < side(s).deviation.size(); ++i) {
        const std::uint32_t number = region_of_[node(s, i)];
        if (number == kNone) continue;
        Region& r = regions_[number];
        r.bounds.extend(points[i]);
        if (s == 0) r.machined_bounds.extend(points[i]);
        const double d = depth(s, i), bound = side(s).bound[i];
        findSurest(s, i, r);
        if (s == 0) r.machined.deepen({d, points[i]});
        if (d <= r.depth && r.deepest != kNone) continue;
        r.depth = d;
        r.bound = bound;
        r.where = points[i];
        r.normal = normalAt(s, i);
        r.deepest = node(s, i);
      }
    }
  }

  /// A triangle of the nominal at each of its samples.
  void findTriangles() {
    const SampleMesh& mesh = *sides_.nominal.mesh;
    PROVEOUT_ASSERT(mesh.parent.size() == mesh.surface.triangles.size());
    triangle_at_.assign(mesh.surface.points.size(), 0);
    for (std::size_t t = 0; t < mesh.surface.triangles.size(); ++t) {
      for (const auto v : mesh.surface.triangles[t]) triangle_at_[v] = mesh.parent[t];
    }
  }

  /// Bounds with what the nominal's facets leave open: asked only of samples that could be the surest.
  void findSurest(int s, std::uint32_t i, Region& r) const {
    const double d = depth(s, i), bound = side(s).bound[i];
    if (d - bound <= std::max(level_, r.surest.margin())) return;
    const double chord = chordAt(s, i);
    if (d - bound - chord > r.surest.margin())
      r.surest = {d, bound + chord, chord, side(s).mesh->surface.points[i], normalAt(s, i)};
  }

  double chordAt(int s, std::uint32_t i) const {
    if (sides_.model == nullptr || sides_.model->shape.mostUnsure() == 0.0) return 0.0;
    const Vec3& p = side(s).mesh->surface.points[i];
    if (s == 1) return sides_.model->shape.unsureAt(triangle_at_[i], p, sides_.reach_mm);
    const Vec3 foot = p - side(0).deviation[i] * normalAt(0, i);
    return sides_.model->shape.unsureAt(side(0).opposite[i], foot, sides_.reach_mm);
  }

  SurfaceMaker makerOf(int s, std::size_t triangle) const {
    const auto& motion = *sides_.motion;
    std::size_t own = triangle;
    if (s == 1) own = sides_.nominal.opposite[side(1).mesh->surface.triangles[triangle][0]];
    SurfaceMaker maker;
    if (!motion.empty()) maker.motion = motion[sides_.machined.mesh->parent[own]];
    if (maker.motion != kNoMotion || part_ == nullptr) return maker;
    // A stock that was clamped again does not know who cut it before.
    constexpr double kNear = 0.05;  // mm
    const Vec3 at = sides_.machined.mesh->surface.middle(own);
    const ExactPart::Sample found = part_->at(at, kNear);
    return std::abs(found.value) < kNear ? found.maker : maker;
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
    std::array<double, 3> f;
    for (std::size_t c = 0; c < 3; ++c) {
      f[c] = depth(s, v[c]);
      if (std::isnan(f[c])) return;  // at the border of what is left out
    }
    const Vec3 doubled = side(s).mesh->surface.areaVector(t);
    const double area = 0.5 * doubled.norm();
    const ClippedIntegral part = integrateAbove(area, f, level_);
    r.area[s] += part.area;
    const SurfaceMaker maker = makerOf(s, t);
    Part& own = r.makers[s][maker];
    own.area += part.area;
    if (area > 0.0) {
      // Depth over the area as the other surface sees it: a pit's wall adds none, its floor all.
      const auto& g = side(s).gradient;
      const Vec3 mean = (g[v[0]] + g[v[1]] + g[v[2]]).cast<double>() / 3.0;
      r.volume[s] += part.integral * mean.dot(doubled) / (2.0 * area);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      if (f[c] > own.depth) own = {own.area, f[c], p[v[c]], normalAt(s, v[c])};
      if (node(s, v[c]) != r.deepest || f[0] + f[1] + f[2] <= r.deepest_sum) continue;
      r.deepest_sum = f[0] + f[1] + f[2];
      r.deepest_maker = maker;
    }
  }

  /// Nominal samples near the rim of a narrow region may have nearest machined triangles just beside it: what
  /// lies within the bounds of a machined region, up to two spacings, is the same finding.
  void attachLonelyNominalRegions() {
    const double reach = 2.0 * std::max(sides_.machined.mesh->spacing_mm, sides_.nominal.mesh->spacing_mm);
    for (Region& lonely : regions_) {
      if (lonely.has_machined) continue;
      for (Region& r : regions_) {
        if (!r.has_machined || !r.machined_bounds.inflated(reach).overlaps(lonely.bounds)) continue;
        merge(lonely, r);
        lonely.deepest = kNone;
        break;
      }
    }
  }

  static void merge(const Region& from, Region& into) {
    into.bounds.extend(from.bounds);
    into.area[1] += from.area[1];
    into.volume[1] += from.volume[1];
    if (from.surest.margin() > into.surest.margin()) into.surest = from.surest;
    for (const auto& [maker, part] : from.makers[1]) {
      Part& own = into.makers[1][maker];
      const double area = own.area + part.area;
      if (part.depth > own.depth) own = part;
      own.area = area;
    }
    if (from.depth <= into.depth) return;
    into.deepest = from.deepest;
    into.depth = from.depth;
    into.bound = from.bound;
    into.where = from.where;
    into.normal = from.normal;
    into.deepest_maker = from.deepest_maker;
  }

  /// Shares of the side that shows more. Only a cutter makes a gouge: at its rim the blank's own surface is
  /// no cause.
  void nameMakers(const Region& r, DeviationPatch& p) const {
    const bool gouge = kind_ == DeviationKind::kGouge;
    const int s = r.has_machined && (r.area[0] > 0.0 || r.area[1] == 0.0) ? 0 : 1;
    double sum = 0.0;
    for (const auto& [maker, part] : r.makers[s]) sum += part.area;
    for (const auto& [maker, part] : r.makers[s]) {
      if (gouge && maker.motion == kNoMotion && r.makers[s].size() > 1) continue;
      p.makers.push_back({maker, sum > 0.0 ? part.area / sum : 1.0, part.depth, part.where, part.normal});
    }
    std::stable_sort(p.makers.begin(), p.makers.end(),
                     [](const MakerShare& a, const MakerShare& b) { return a.share > b.share; });
    if (p.makers.empty()) p.makers.push_back({{}, 1.0, r.depth, r.where, r.normal});
    p.maker = gouge && r.deepest_maker.motion == kNoMotion ? p.makers.front().maker : r.deepest_maker;
  }

  /// Some of the samples of each region, of both sides.
  std::vector<std::vector<Vec3>> somePlaces() const {
    constexpr std::size_t kMost = 2000;
    std::vector<std::size_t> count(regions_.size(), 0), seen(regions_.size(), 0);
    for (const std::uint32_t n : region_of_) {
      if (n != kNone) ++count[n];
    }
    std::vector<std::vector<Vec3>> out(regions_.size());
    for (std::uint32_t n = 0; n < region_of_.size(); ++n) {
      const std::uint32_t region = region_of_[n];
      if (region == kNone || seen[region]++ % (1 + count[region] / kMost) != 0) continue;
      out[region].push_back(pointOf(n));
    }
    return out;
  }

  const Vec3& pointOf(std::uint32_t n) const {
    return n < offset_ ? side(0).mesh->surface.points[n] : side(1).mesh->surface.points[n - offset_];
  }

  std::vector<FoundPatch> finish() const {
    std::vector<FoundPatch> out;
    std::vector<std::vector<Vec3>> places = somePlaces();
    for (const Region& r : regions_) {
      if (r.deepest == kNone) continue;
      FoundPatch found;
      found.surest = r.surest;
      found.volumes = {r.volume[0], r.volume[1]};
      found.places = std::move(places[static_cast<std::size_t>(&r - regions_.data())]);
      found.deepest_on_nominal = r.deepest >= offset_;
      const std::uint32_t vertex =
          found.deepest_on_nominal ? r.deepest - static_cast<std::uint32_t>(offset_) : r.deepest;
      const SampledSide& of = side(found.deepest_on_nominal ? 1 : 0);
      PROVEOUT_ASSERT(vertex < of.deviation.size());
      found.opposite = r.where - (found.deepest_on_nominal ? -1.0 : 1.0) * of.deviation[vertex] * r.normal;
      found.machined = r.machined;
      DeviationPatch& p = found.patch;
      p.kind = kind_;
      p.where = r.where;
      p.normal = r.normal;
      p.depth_mm = r.depth;
      p.bound_mm = r.bound;
      p.from_nominal_only = !r.has_machined;
      p.machined_area_mm2 = r.area[0];
      p.nominal_area_mm2 = r.area[1];
      p.area_mm2 = std::max(r.area[0], r.area[1]);
      // Under offset faces each side's own integral errs by as much as the other's, the other way.
      const bool both = r.volume[0] > 0.0 && r.volume[1] > 0.0;
      p.volume_mm3 = both ? 0.5 * (r.volume[0] + r.volume[1]) : std::max({r.volume[0], r.volume[1], 0.0});
      p.bounds = r.bounds;
      nameMakers(r, p);
      out.push_back(std::move(found));
    }
    return out;
  }

  const BothSides& sides_;
  DeviationKind kind_;
  double level_;
  bool possible_;
  const ExactPart* part_;
  std::size_t offset_;
  DisjointSets sets_;
  std::vector<std::uint32_t> region_of_;  ///< per node
  std::vector<Region> regions_;
  std::vector<std::uint32_t> triangle_at_;  ///< per sample of the nominal: one of its triangles that hold it
};

}  // namespace patch_detail

void SurestPlace::tell(DeviationPatch& patch) const {
  patch.depth_mm = depth_mm;
  patch.bound_mm = bound_mm;
  patch.chord_mm = chord_mm;
  patch.where = where;
  patch.normal = normal;
}

void joinPatch(const DeviationPatch& from, DeviationPatch& into) {
  const double area = into.area_mm2 + from.area_mm2;
  const double kept = area > 0.0 ? into.area_mm2 / area : 0.5;
  for (MakerShare& m : into.makers) m.share *= kept;
  for (MakerShare m : from.makers) {
    m.share *= 1.0 - kept;
    const auto same = std::find_if(into.makers.begin(), into.makers.end(),
                                   [&](const MakerShare& own) { return own.maker == m.maker; });
    if (same == into.makers.end()) {
      into.makers.push_back(m);
      continue;
    }
    const double share = same->share + m.share;
    if (m.depth_mm > same->depth_mm) *same = m;
    same->share = share;
  }
  std::stable_sort(into.makers.begin(), into.makers.end(),
                   [](const MakerShare& a, const MakerShare& b) { return a.share > b.share; });
  if (from.depth_mm > into.depth_mm) {
    into.depth_mm = from.depth_mm;
    into.bound_mm = from.bound_mm;
    into.where = from.where;
    into.normal = from.normal;
    into.maker = from.maker;
  }
  into.area_mm2 = area;
  into.machined_area_mm2 += from.machined_area_mm2;
  into.nominal_area_mm2 += from.nominal_area_mm2;
  into.volume_mm3 += from.volume_mm3;
  into.bounds.extend(from.bounds);
  into.from_nominal_only = into.from_nominal_only && from.from_nominal_only;
  into.spots += from.spots;
}

std::vector<FoundPatch> findPatches(const BothSides& sides, DeviationKind kind, double level_mm,
                                    Beyond beyond, const ExactPart* part) {
  return patch_detail::PatchFinder(sides, kind, level_mm, beyond, part).run();
}

}  // namespace proveout
