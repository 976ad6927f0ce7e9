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
/// So far beyond what corners may be off a figure says something.
constexpr double kClear = 10.0;
/// The ring of a torus for its tube, at least.
constexpr double kLeastRing = 0.02;
/// Points that a fit takes while a region grows, and at its end.
constexpr std::size_t kStartPoints = 48, kFitPoints = 240, kLastPoints = 1'500;
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
      : facets_(facets),
        near_(near_mm),
        taken_(taken),
        in_(facets.size()),
        seen_(facets.vertices()),
        vain_(facets.size(), false) {}

  std::vector<FacetRegion> run();

 private:
  struct Group {
    std::vector<std::uint32_t> facets;
    std::vector<Vec3> points;
  };
  Group nearest(std::uint32_t seed) const;
  std::vector<std::uint32_t> around(std::uint32_t seed, int rings, std::size_t most);
  std::vector<Vec3> pointsOf(const std::vector<std::uint32_t>& of, std::size_t most);
  /// Whether a facet's corners lie on the face, to `near` where they stand for it.
  bool lies(std::uint32_t facet, const CadFace& face, double chord, double near) const;
  bool lies(std::uint32_t facet, const CadFace& face, double chord) const {
    return lies(facet, face, chord, near_);
  }
  double chordOf(const std::vector<std::uint32_t>& of, const CadFace& face) const;
  void orient(const std::vector<std::uint32_t>& of, CadFace& face) const;
  struct Start {
    std::optional<CadFace> face;
    bool few = false;  ///< too few corners to say anything
    double chord = 0.0;
  };
  Start start(SurfaceKind kind, std::vector<std::uint32_t>& of);
  std::optional<FacetRegion> grow(std::vector<std::uint32_t> of, CadFace face, double chord);
  void spread(FacetRegion& region, double chord);
  bool refit(FacetRegion& region, std::size_t points, double chord);
  bool accepted(FacetRegion& region);
  bool endsClean(const FacetRegion& region);
  void look(const std::vector<std::uint32_t>& order, bool all, std::vector<FacetRegion>& out);
  void giveUp(std::uint32_t seed, bool many);
  void takeBack(std::vector<FacetRegion>& regions);
  std::optional<FacetRegion> bestAt(std::uint32_t seed);

  const FlatFacets& facets_;
  const double near_;
  std::vector<bool>& taken_;
  Marks in_, seen_;
  std::vector<bool> vain_;  ///< facets that nothing was found from
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

bool RoundSearch::lies(std::uint32_t f, const CadFace& face, double chord, double near) const {
  const FlatFacet& facet = facets_[f];
  const double allowed = chord + near;
  if (facet.firm && (facet.normal.dot(face.normalAt(facet.middle)) < kAlikeNormal ||
                     std::abs(face.distance(facet.middle)) > allowed))
    return false;
  const bool torus = face.kind == SurfaceKind::kTorus;
  bool any = !facet.firm;
  for (const FacetCorner& corner : facets_.corners(f)) {
    double d = face.distance(facets_.point(corner.vertex));
    if (face.hollow) d = -d;  // facets are on the axis' side
    if (corner.on_curve ? std::abs(d) > near : (d < -allowed || d > (torus ? allowed : near))) return false;
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
RoundSearch::Start RoundSearch::start(SurfaceKind kind, std::vector<std::uint32_t>& of) {
  constexpr double kMostDropped = 0.4;
  constexpr int kTries = 3;
  const std::size_t first = of.size();
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const std::vector<Vec3> points = pointsOf(of, kStartPoints);
    if (points.size() < freedomOf(kind) + (kind == SurfaceKind::kSphere ? 2 : 3))
      return {std::nullopt, attempt == 0, 0.0};
    std::optional<CadFace> face = guessRound(kind, facets_, of, points);
    if (!face) return {std::nullopt, attempt == 0, 0.0};
    if (!fitRound(points, true, *face)) return {};
    orient(of, *face);
    const double chord = std::min(kMostSoftChord, kChordRatio * chordOf(of, *face) + near_);
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t f : of)
      if (lies(f, *face, chord)) kept.push_back(f);
    if (kept.size() == of.size()) return {face, false, chord};
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
    if (fewer.size() == of.size() ||
        static_cast<double>(fewer.size()) < (1.0 - kMostDropped) * static_cast<double>(first))
      return {};
    of = std::move(fewer);
  }
  return {};
}

/// Adds neighbours that lie on the face, from the region's facets on. What a few facets say of the others is
/// not exact: there more is allowed until they are part of the fit.
void RoundSearch::spread(FacetRegion& region, double chord) {
  constexpr std::size_t kFew = 24, kSome = 400;
  const auto after = [](std::size_t size) { return size < kFew ? size + 2 : size + size / 2; };
  const auto allowed = [this](std::size_t size) {
    return (size < kFew ? 4.0 : size < kSome ? 2.0 : 1.0) * near_;
  };
  std::size_t next_fit = after(region.facets.size());
  for (std::size_t k = 0; k < region.facets.size(); ++k) {
    for (const FacetLink& link : facets_.links(region.facets[k])) {
      const double near = allowed(region.facets.size());
      if (taken_[link.other] || in_.has(link.other) || link.turn > kSteepTurn ||
          !lies(link.other, region.face, chord, near))
        continue;
      in_.add(link.other);
      region.facets.push_back(link.other);
    }
    if (region.facets.size() < next_fit) continue;
    next_fit = after(region.facets.size());
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
  constexpr int kRounds = 12;
  constexpr double kStill = 1.02;  // hardly grown
  in_.clear();
  for (const std::uint32_t f : of) in_.add(f);
  FacetRegion region;
  region.face = face;
  region.facets = std::move(of);
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t before = region.facets.size();
    spread(region, chord);
    if (!refit(region, kLastPoints, chord)) return std::nullopt;
    if (static_cast<double>(region.facets.size()) <= kStill * static_cast<double>(before)) break;
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
  for (const Vec3& p : points)
    region.residual_mm = std::max(region.residual_mm, std::abs(region.face.distance(p)));
  region.chord_mm = chordOf(region.facets, region.face);
  if (firm < (strips ? 3u : 8u)) return false;
  // A circle about a point is a sphere.
  if (kind == SurfaceKind::kTorus &&
      region.face.radius < kLeastRing * region.face.tube_radius + kClear * near_)
    return false;
  if (region.corners < freedomOf(kind) + (strips ? 3 : 5)) return false;
  // What the face curves by in all has to be far beyond what its corners may be off.
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
  // The two longest neighbours alike: those of a strip.
  std::vector<std::uint32_t> strip = {seed};
  std::vector<FacetLink> links(facets_.links(seed).begin(), facets_.links(seed).end());
  std::erase_if(links, [&](const FacetLink& l) { return !l.smooth || !l.alike || taken_[l.other]; });
  std::stable_sort(links.begin(), links.end(),
                   [](const FacetLink& a, const FacetLink& b) { return a.length > b.length; });
  for (std::size_t k = 0; k < std::min<std::size_t>(2, links.size()); ++k) strip.push_back(links[k].other);
  // Larger ones only where what is smaller leaves open how the face goes on.
  struct Reach {
    int rings;
    std::size_t most;
  };
  constexpr std::array<Reach, 5> kReach = {{{0, 0}, {1, 48}, {2, 48}, {5, 48}, {16, 600}}};
  std::array<std::vector<std::uint32_t>, kReach.size()> sets = {strip};
  std::optional<FacetRegion> best;
  double most = 0.0;
  for (const SurfaceKind kind : kKinds) {
    const bool strips = kind == SurfaceKind::kCylinder || kind == SurfaceKind::kCone;
    for (std::size_t k = strips ? 0 : 1; k < sets.size(); ++k) {
      if (k > 0 && sets[k].empty()) sets[k] = around(seed, kReach[k].rings, kReach[k].most);
      if (k > 1 && sets[k].size() == sets[k - 1].size()) continue;
      std::vector<std::uint32_t> of = sets[k];
      const Start found = start(kind, of);
      if (found.few) continue;
      if (!found.face) break;  // more of the surface fits no better
      std::optional<FacetRegion> region = grow(std::move(of), *found.face, found.chord);
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

/// Whether the region ends where the surface does not go on smoothly into facets alike: all of a face was
/// found, and no piece of another one that it happens to fit.
bool RoundSearch::endsClean(const FacetRegion& region) {
  constexpr double kMostOpen = 0.15;
  in_.clear();
  for (const std::uint32_t f : region.facets) in_.add(f);
  double all = 0.0, open = 0.0;
  for (const std::uint32_t f : region.facets) {
    for (const FacetLink& link : facets_.links(f)) {
      if (in_.has(link.other)) continue;
      all += link.length;
      if (link.smooth && link.alike) open += link.length;
    }
  }
  return open <= kMostOpen * all;
}

/// Looks from each facet on; `all`: for faces that do not end clean, too.
void RoundSearch::look(const std::vector<std::uint32_t>& order, bool all, std::vector<FacetRegion>& out) {
  const auto count = static_cast<std::uint32_t>(facets_.size());
  // Facets that could be of one face; each of these parts may be tried in vain so often.
  DisjointSets parts(count);
  for (std::uint32_t f = 0; f < count; ++f)
    for (const FacetLink& link : facets_.links(f))
      if (link.smooth && link.alike && !taken_[f] && !taken_[link.other]) parts.join(f, link.other);
  std::vector<std::uint32_t> size(count, 0);
  for (std::uint32_t f = 0; f < count; ++f) ++size[parts.find(f)];
  std::vector<double> tries(count, 0.0);
  constexpr double kTries = 40.0, kShare = 0.02, kTriesInAll = 3'000.0;
  for (std::uint32_t f = 0; f < count; ++f) tries[f] = kTries + kShare * size[f];
  double in_all = kTriesInAll;
  constexpr std::size_t kMany = 40;      // so many facets do not fit by chance
  constexpr std::uint32_t kLarge = 400;  // a part of so many facets is not asked from each of them
  std::vector<bool> tried(count, false);
  for (const std::uint32_t seed : order) {
    const std::uint32_t part = parts.find(seed);
    if (taken_[seed] || tried[seed] || vain_[seed] || tries[part] < 1.0 || in_all < 1.0) continue;
    std::optional<FacetRegion> found = bestAt(seed);
    const bool good = found && (endsClean(*found) || (all && found->facets.size() >= kMany));
    if (good) {
      for (const std::uint32_t f : found->facets) taken_[f] = true;
      out.push_back(std::move(*found));
      continue;
    }
    --tries[part];
    --in_all;
    if (!found) giveUp(seed, size[part] > kLarge);
    if (found)
      for (const std::uint32_t f : found->facets) tried[f] = true;
  }
}

/// Nothing was found from the seed: nor will there be from its neighbours, where there are many.
void RoundSearch::giveUp(std::uint32_t seed, bool many) {
  vain_[seed] = true;
  if (!many) return;
  for (const FacetLink& link : facets_.links(seed))
    if (link.smooth && link.alike) vain_[link.other] = true;
}

/// Small regions that lie on the face of a larger one beside them, and facets left beside them, go to it.
void RoundSearch::takeBack(std::vector<FacetRegion>& regions) {
  constexpr std::uint32_t kFree = 0xFFFFFFFFu;
  std::vector<std::uint32_t> region_of(facets_.size(), kFree), order(regions.size());
  for (std::uint32_t r = 0; r < regions.size(); ++r)
    for (const std::uint32_t f : regions[r].facets) region_of[f] = r;
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return areaOf(facets_, regions[a]) > areaOf(facets_, regions[b]);
  });
  std::vector<bool> gone(regions.size(), false);
  for (const std::uint32_t r : order) {
    if (gone[r]) continue;
    const double chord = std::min(kMostSoftChord, kChordRatio * regions[r].chord_mm + near_);
    for (std::size_t k = 0; k < regions[r].facets.size(); ++k) {
      for (const FacetLink& link : facets_.links(regions[r].facets[k])) {
        const std::uint32_t other = region_of[link.other];
        if (other == r || link.turn > kSteepTurn) continue;
        if (other == kFree) {
          if (!lies(link.other, regions[r].face, chord)) continue;
          region_of[link.other] = r;
          taken_[link.other] = true;
          regions[r].facets.push_back(link.other);
          continue;
        }
        const auto& others = regions[other].facets;
        if (others.size() >= regions[r].facets.size() ||
            !std::all_of(others.begin(), others.end(),
                         [&](std::uint32_t f) { return lies(f, regions[r].face, chord); }))
          continue;
        for (const std::uint32_t f : others) {
          region_of[f] = r;
          regions[r].facets.push_back(f);
        }
        gone[other] = true;
        regions[other].facets.clear();
      }
    }
  }
  std::erase_if(regions, [](const FacetRegion& r) { return r.facets.empty(); });
}

std::vector<FacetRegion> RoundSearch::run() {
  std::vector<std::uint32_t> order, smooth(facets_.size(), 0);
  for (std::uint32_t f = 0; f < facets_.size(); ++f) {
    for (const FacetLink& link : facets_.links(f))
      if (link.smooth && link.alike) ++smooth[f];
    if (smooth[f] > 0) order.push_back(f);
  }
  // The middle of a face and large facets say most.
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if ((smooth[a] > 1) != (smooth[b] > 1)) return smooth[a] > 1;
    return facets_[a].area > facets_[b].area;
  });
  std::vector<FacetRegion> out;
  look(order, false, out);
  look(order, true, out);
  takeBack(out);
  return out;
}

}  // namespace region_detail

std::vector<FacetRegion> findRoundRegions(const FlatFacets& facets, double near_mm,
                                          std::vector<bool>& taken) {
  return region_detail::RoundSearch(facets, near_mm, taken).run();
}

}  // namespace proveout
