#include "core/mesh/faces/round_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/mesh/edge_table.h"
#include "core/mesh/faces/round_fit.h"

namespace proveout {
namespace region_detail {

/// A facet looks the way of its face to within this: half of the turn to a neighbour, and of a flat facet of
/// a torus some more.
const double kAlikeNormal = std::cos(degToRad(27.0));
/// Facets of one face leave it by about as much as those that it was found in.
constexpr double kChordRatio = 4.0;
/// Points that a fit takes while a region grows, and at its end.
constexpr std::size_t kFitPoints = 240, kLastPoints = 1'500;
constexpr std::array<SurfaceKind, 4> kKinds = {SurfaceKind::kCylinder, SurfaceKind::kCone,
                                               SurfaceKind::kSphere, SurfaceKind::kTorus};

/// Marks that are cleared all at once.
class Marks {
 public:
  explicit Marks(std::size_t size) : mark_(size, 0) {}
  void clear() { ++now_; }
  bool has(std::uint32_t i) const { return mark_[i] == now_; }
  bool add(std::uint32_t i) {
    if (mark_[i] == now_) return false;
    mark_[i] = now_;
    return true;
  }
  void drop(std::uint32_t i) { mark_[i] = 0; }

 private:
  std::vector<std::uint32_t> mark_;
  std::uint32_t now_ = 1;
};

class RoundSearch {
 public:
  RoundSearch(const FlatFacets& facets, double near_mm, std::vector<bool>& taken)
      : facets_(facets), near_(near_mm), taken_(taken), in_(facets.size()), seen_(facets.vertices()) {}

  std::vector<FacetRegion> run();

 private:
  struct Group {
    std::vector<std::uint32_t> facets;
    std::vector<Vec3> points;
  };
  Group nearest(std::uint32_t seed) const;
  std::vector<std::uint32_t> around(std::uint32_t seed, int rings, std::size_t most);
  std::vector<Vec3> pointsOf(const std::vector<std::uint32_t>& of, std::size_t most);
  bool lies(std::uint32_t facet, const CadFace& face, double chord) const;
  double chordOf(const std::vector<std::uint32_t>& of, const CadFace& face) const;
  void orient(const std::vector<std::uint32_t>& of, CadFace& face) const;
  std::optional<CadFace> start(SurfaceKind kind, std::vector<std::uint32_t>& of, double& chord);
  std::optional<FacetRegion> grow(std::vector<std::uint32_t> of, CadFace face, double chord);
  void spread(FacetRegion& region, double chord);
  bool refit(FacetRegion& region, std::size_t points, double chord);
  bool accepted(FacetRegion& region);
  std::optional<FacetRegion> bestAt(std::uint32_t seed);

  const FlatFacets& facets_;
  const double near_;
  std::vector<bool>& taken_;
  Marks in_, seen_;
};

/// Neighbours across smooth borders, ring by ring; those alike first in each.
std::vector<std::uint32_t> RoundSearch::around(std::uint32_t seed, int rings, std::size_t most) {
  in_.clear();
  in_.add(seed);
  std::vector<std::uint32_t> out = {seed};
  std::size_t from = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t to = out.size();
    for (; from < to; ++from)
      for (const FacetLink& link : facets_.links(out[from]))
        if (link.smooth && link.alike && !taken_[link.other] && out.size() < most && in_.add(link.other))
          out.push_back(link.other);
  }
  return out;
}

/// Corners on the curve, each once.
std::vector<Vec3> RoundSearch::pointsOf(const std::vector<std::uint32_t>& of, std::size_t most) {
  seen_.clear();
  std::vector<std::uint32_t> all;
  for (const std::uint32_t f : of)
    for (const FacetCorner& corner : facets_.corners(f))
      if (corner.on_curve && seen_.add(corner.vertex)) all.push_back(corner.vertex);
  std::vector<Vec3> out;
  const std::size_t count = std::min(most, all.size());
  out.reserve(count);
  for (std::size_t k = 0; k < count; ++k) out.push_back(facets_.point(all[k * all.size() / count]));
  return out;
}

bool RoundSearch::lies(std::uint32_t f, const CadFace& face, double chord) const {
  const FlatFacet& facet = facets_[f];
  const double allowed = chord + near_;
  if (facet.firm && (facet.normal.dot(face.normalAt(facet.middle)) < kAlikeNormal ||
                     std::abs(face.distance(facet.middle)) > allowed))
    return false;
  const bool torus = face.kind == SurfaceKind::kTorus;
  bool any = !facet.firm;
  for (const FacetCorner& corner : facets_.corners(f)) {
    double d = face.distance(facets_.point(corner.vertex));
    if (face.hollow) d = -d;  // facets are on the axis' side
    if (corner.on_curve ? std::abs(d) > near_ : (d < -allowed || d > (torus ? allowed : near_))) return false;
    any = any || corner.on_curve;
  }
  return any;
}

double RoundSearch::chordOf(const std::vector<std::uint32_t>& of, const CadFace& face) const {
  double most = 0.0;
  for (const std::uint32_t f : of)
    if (facets_[f].firm) most = std::max(most, std::abs(face.distance(facets_[f].middle)));
  return most;
}

/// Material inside of the round, or outside.
void RoundSearch::orient(const std::vector<std::uint32_t>& of, CadFace& face) const {
  face.hollow = false;
  double sum = 0.0;
  for (const std::uint32_t f : of)
    sum += facets_[f].area * facets_[f].normal.dot(face.normalAt(facets_[f].middle));
  face.hollow = sum < 0.0;
}

/// The face of the kind through most of the facets; those off it are dropped from `of`.
std::optional<CadFace> RoundSearch::start(SurfaceKind kind, std::vector<std::uint32_t>& of, double& chord) {
  constexpr double kMostDropped = 0.4;
  constexpr int kTries = 3;
  const std::size_t first = of.size();
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const std::vector<Vec3> points = pointsOf(of, kFitPoints);
    if (points.size() < freedomOf(kind) + (kind == SurfaceKind::kSphere ? 2 : 3)) return std::nullopt;
    std::optional<CadFace> face = guessRound(kind, facets_, of, points);
    if (!face || !fitRound(points, true, *face)) return std::nullopt;
    orient(of, *face);
    chord = std::min(kMostSoftChord, kChordRatio * chordOf(of, *face) + near_);
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t f : of)
      if (lies(f, *face, chord)) kept.push_back(f);
    if (kept.size() == of.size()) return face;
    // Those that lie farthest off are of another face; the fit through all lies between both.
    std::vector<std::pair<double, std::uint32_t>> off;
    for (const std::uint32_t f : of) {
      double most = 0.0;
      for (const FacetCorner& corner : facets_.corners(f))
        if (corner.on_curve) most = std::max(most, std::abs(face->distance(facets_.point(corner.vertex))));
      off.emplace_back(most, f);
    }
    std::vector<double> sorted;
    for (const auto& [d, f] : off) sorted.push_back(d);
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                     sorted.end());
    const double limit = std::max(near_, 1.5 * sorted[sorted.size() / 2]);
    std::vector<std::uint32_t> fewer;
    for (const auto& [d, f] : off)
      if (d <= limit) fewer.push_back(f);
    if (fewer.size() == of.size() || static_cast<double>(fewer.size()) < (1.0 - kMostDropped) * static_cast<double>(first))
      return std::nullopt;
    of = std::move(fewer);
  }
  return std::nullopt;
}

/// Adds neighbours that lie on the face, from the region's facets on.
void RoundSearch::spread(FacetRegion& region, double chord) {
  std::size_t next_fit = 2 * region.facets.size() + 4;
  for (std::size_t k = 0; k < region.facets.size(); ++k) {
    for (const FacetLink& link : facets_.links(region.facets[k])) {
      if (taken_[link.other] || in_.has(link.other) || link.turn > kSteepTurn ||
          !lies(link.other, region.face, chord))
        continue;
      in_.add(link.other);
      region.facets.push_back(link.other);
    }
    if (region.facets.size() < next_fit) continue;
    next_fit = 2 * region.facets.size();
    CadFace face = region.face;
    if (fitRound(pointsOf(region.facets, kFitPoints), true, face)) region.face = face;
  }
}

/// Fits the face to all of the region; facets that leave it are dropped.
bool RoundSearch::refit(FacetRegion& region, std::size_t points, double chord) {
  CadFace face = region.face;
  if (!fitRound(pointsOf(region.facets, points), true, face)) return false;
  region.face = face;
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t f : region.facets) {
    if (lies(f, face, chord)) {
      kept.push_back(f);
    } else {
      in_.drop(f);
    }
  }
  const bool good = 2 * kept.size() >= region.facets.size() && kept.size() >= 2;
  region.facets = std::move(kept);
  return good;
}

std::optional<FacetRegion> RoundSearch::grow(std::vector<std::uint32_t> of, CadFace face, double chord) {
  constexpr int kRounds = 3;
  in_.clear();
  for (const std::uint32_t f : of) in_.add(f);
  FacetRegion region;
  region.face = face;
  region.facets = std::move(of);
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t before = region.facets.size();
    spread(region, chord);
    if (!refit(region, kLastPoints, chord)) return std::nullopt;
    if (region.facets.size() == before) break;
  }
  return accepted(region) ? std::optional(std::move(region)) : std::nullopt;
}

/// Whether there is enough of it for its kind.
bool RoundSearch::accepted(FacetRegion& region) {
  const SurfaceKind kind = region.face.kind;
  const bool strips = kind == SurfaceKind::kCylinder || kind == SurfaceKind::kCone;
  std::size_t firm = 0;
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t f : region.facets) {
    if (!facets_[f].firm) continue;
    ++firm;
    sum += facets_[f].normal;
  }
  const std::vector<Vec3> points = pointsOf(region.facets, facets_.vertices());
  region.corners = points.size();
  region.residual_mm = 0.0;
  for (const Vec3& p : points) region.residual_mm = std::max(region.residual_mm, std::abs(region.face.distance(p)));
  region.chord_mm = chordOf(region.facets, region.face);
  if (firm < (strips ? 3u : 8u)) return false;
  if (region.corners < freedomOf(kind) + (strips ? 3 : 5)) return false;
  // What the face curves by in all has to be far beyond what its corners may be off.
  constexpr double kClear = 10.0;
  const double radius = kind == SurfaceKind::kTorus ? region.face.tube_radius : region.face.radius;
  double least = 1.0;
  if (sum.norm() > 0.0)
    for (const std::uint32_t f : region.facets)
      if (facets_[f].firm) least = std::min(least, facets_[f].normal.dot(sum.normalized()));
  return radius * (1.0 - least) > kClear * near_ || region.chord_mm > kClear * near_;
}

double areaOf(const FlatFacets& facets, const FacetRegion& region) {
  double sum = 0.0;
  for (const std::uint32_t f : region.facets) sum += facets[f].area;
  return sum;
}

std::optional<FacetRegion> RoundSearch::bestAt(std::uint32_t seed) {
  /// A kind with one more number has to have so much more of the surface.
  constexpr double kMore = 1.15;
  constexpr std::size_t kMost = 48;
  // The two longest neighbours alike: those of a strip.
  std::vector<std::uint32_t> strip = {seed};
  std::vector<FacetLink> links(facets_.links(seed).begin(), facets_.links(seed).end());
  std::erase_if(links, [&](const FacetLink& l) { return !l.smooth || !l.alike || taken_[l.other]; });
  std::stable_sort(links.begin(), links.end(),
                   [](const FacetLink& a, const FacetLink& b) { return a.length > b.length; });
  for (std::size_t k = 0; k < std::min<std::size_t>(2, links.size()); ++k) strip.push_back(links[k].other);
  const std::array<std::vector<std::uint32_t>, 3> sets = {strip, around(seed, 1, kMost), around(seed, 2, kMost)};
  std::optional<FacetRegion> best;
  double most = 0.0;
  for (const SurfaceKind kind : kKinds) {
    const bool strips = kind == SurfaceKind::kCylinder || kind == SurfaceKind::kCone;
    for (std::size_t k = strips ? 0 : 1; k < sets.size(); ++k) {
      if (k > 0 && sets[k].size() == sets[k - 1].size()) continue;
      std::vector<std::uint32_t> of = sets[k];
      double chord = 0.0;
      const std::optional<CadFace> face = start(kind, of, chord);
      if (!face) continue;
      std::optional<FacetRegion> region = grow(std::move(of), *face, chord);
      if (!region) continue;
      const double area = areaOf(facets_, *region);
      if (best && area <= kMore * most) break;
      most = area;
      best = std::move(region);
      break;
    }
  }
  return best;
}

std::vector<FacetRegion> RoundSearch::run() {
  const auto count = static_cast<std::uint32_t>(facets_.size());
  // Facets that could be of one face; each of these parts may be tried in vain so often.
  DisjointSets parts(count);
  std::vector<std::uint32_t> smooth(count, 0);
  for (std::uint32_t f = 0; f < count; ++f) {
    for (const FacetLink& link : facets_.links(f)) {
      if (!link.smooth || !link.alike) continue;
      parts.join(f, link.other);
      ++smooth[f];
    }
  }
  std::vector<std::uint32_t> size(count, 0), order;
  std::vector<double> tries(count, 0.0);
  for (std::uint32_t f = 0; f < count; ++f) ++size[parts.find(f)];
  constexpr double kTries = 40.0, kShare = 0.06;
  double in_all = 20'000.0;
  for (std::uint32_t f = 0; f < count; ++f) {
    if (smooth[f] > 0) order.push_back(f);
    tries[f] = kTries + kShare * size[f];
  }
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if ((smooth[a] > 1) != (smooth[b] > 1)) return smooth[a] > 1;
    return facets_[a].area > facets_[b].area;
  });
  std::vector<FacetRegion> out;
  std::vector<bool> tried(count, false);
  for (const std::uint32_t seed : order) {
    double& left = tries[parts.find(seed)];
    if (taken_[seed] || tried[seed] || left < 1.0 || in_all < 1.0) continue;
    std::optional<FacetRegion> found = bestAt(seed);
    if (!found) {
      --left;
      --in_all;
      tried[seed] = true;
      continue;
    }
    for (const std::uint32_t f : found->facets) taken_[f] = true;
    out.push_back(std::move(*found));
  }
  return out;
}

}  // namespace region_detail

std::vector<FacetRegion> findRoundRegions(const FlatFacets& facets, double near_mm,
                                          std::vector<bool>& taken) {
  return region_detail::RoundSearch(facets, near_mm, taken).run();
}

}  // namespace proveout
