#include "removal/compare/shape/curved_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace proveout::shape_detail {

namespace {

/// A plane turns against the first facet of a round that touches it by half of what the facets turn.
constexpr double kTangentTurn = 0.8;
/// Cosine; the sides of an equilateral triangle still count.
constexpr double kParallel = 0.4;

/// Borders that cross bound curves of different directions.
bool parallel(const Link& l, const Link& m) { return std::abs(l.along.dot(m.along)) > kParallel; }

bool sameCurve(const Link& l, const Link& m) {
  if ((l.turn > 0.0) != (m.turn > 0.0)) return false;
  const double r = l.curvature() / m.curvature();
  if (r > kCurvatureRatio || r * kCurvatureRatio < 1.0) return false;
  const double steep = std::max(std::abs(l.turn), std::abs(m.turn)), t = l.turn / m.turn;
  return steep <= kSoftRad || (t < kSteepTurnRatio && t * kSteepTurnRatio > 1.0);
}

/// Whether two links are of one regular polygon.
bool regular(const Link& l, const Link& m) {
  const double t = l.turn / m.turn, w = l.width() / m.width();
  return t < kSteepTurnRatio && t * kSteepTurnRatio > 1.0 && w < kSteepTurnRatio && w * kSteepTurnRatio > 1.0;
}

}  // namespace

CurvedFacets::CurvedFacets(const MeshFacets& facets) : facets_(facets), links_(facets.links()) {
  any_ = findCurved();
  if (any_) findStraight();
}

std::vector<float> CurvedFacets::doubts() const {
  std::vector<float> doubt(facets_.mesh.triangles.size(), 0.0f);  // per facet first
  std::vector<std::pair<std::uint32_t, std::uint32_t>> own;       // facets, links
  for (std::uint32_t i = 0; i < links_.size(); ++i) {
    if (!links_[i].doubtful() || !links_[i].alike()) continue;
    own.emplace_back(links_[i].a, i);
    own.emplace_back(links_[i].b, i);
  }
  if (own.empty()) return {};
  std::sort(own.begin(), own.end());
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (std::size_t j = i + 1; j < own.size() && own[j].first == own[i].first; ++j) {
      const Link &l = links_[own[i].second], &m = links_[own[j].second];
      if (!parallel(l, m) || !regular(l, m)) continue;
      float& most = doubt[own[i].first];
      most = std::max(most, static_cast<float>(std::max(l.chord(), m.chord())));
    }
  }
  for (std::uint32_t t = static_cast<std::uint32_t>(doubt.size()); t-- > 0;)
    doubt[t] = doubt[facets_.facet_of[t]];
  return doubt;
}

void CurvedFacets::gatherLinks() {
  const auto isCrossed = [](const Link& l) { return l.plausible() && l.alike(); };
  first_link_.assign(facets_.mesh.triangles.size() + 1, 0);
  for (const Link& l : links_) {
    if (!isCrossed(l)) continue;
    ++first_link_[l.a];
    ++first_link_[l.b];
  }
  // From the ends: what is put in moves them to the begins.
  std::partial_sum(first_link_.begin(), first_link_.end(), first_link_.begin());
  link_of_.resize(first_link_.back());
  for (std::size_t i = links_.size(); i-- > 0;) {
    if (!isCrossed(links_[i])) continue;
    for (const std::uint32_t f : {links_[i].a, links_[i].b})
      link_of_[--first_link_[f]] = static_cast<std::uint32_t>(i);
  }
}

/// False where no facet is curved.
bool CurvedFacets::findCurved() {
  curved_.assign(facets_.mesh.triangles.size(), 0);
  turn_.assign(facets_.mesh.triangles.size(), 0.0);
  gatherLinks();
  bool any = false;
  for (std::uint32_t f = 0; f < curved_.size(); ++f) {
    const std::span<const std::uint32_t> own = linksOf(f);
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t j = i + 1; j < own.size(); ++j) {
        Link &l = links_[own[i]], &m = links_[own[j]];
        // Strips curve across their long sides; of a triangle the side opposite is another one's.
        if ((facets_.triangles[f] > 1 && !parallel(l, m)) || !sameCurve(l, m)) continue;
        curved_[f] = 1;
        l.runs = m.runs = true;
      }
    }
    any = any || curved_[f];
  }
  endAtCreases();
  for (const Link& l : links_) {
    if (!l.runs) continue;
    for (const std::uint32_t f : {l.a, l.b}) turn_[f] = std::max(turn_[f], std::abs(l.turn));
  }
  return any;
}

/// Facets with all the borders that a curved face crosses in about one direction.
void CurvedFacets::findStraight() {
  straight_of_.assign(facets_.mesh.triangles.size(), kNobody);
  straight_.reserve(static_cast<std::size_t>(std::ranges::count(curved_, 1)));
  for (std::uint32_t f = 0; f < curved_.size(); ++f) {
    const Straight found = curved_[f] ? straightBy(f) : Straight();
    if (found.along.isZero()) continue;
    straight_of_[f] = static_cast<std::uint32_t>(straight_.size());
    straight_.push_back(found);
  }
  for (std::uint32_t t = 0; t < facets_.mesh.triangles.size(); ++t) {
    const std::uint32_t number = straight_of_[facets_.facet_of[t]];
    if (number == kNobody) continue;
    Straight& s = straight_[number];
    for (const std::uint32_t v : facets_.mesh.triangles[t]) {
      const Eigen::Array2d at(s.along.dot(facets_.mesh.points[v]), s.across.dot(facets_.mesh.points[v]));
      s.low = s.low.min(at);
      s.high = s.high.max(at);
    }
  }
  dropShort();
}

/// Keeps those that are long enough: few, where faces curve in both directions.
void CurvedFacets::dropShort() {
  std::uint32_t kept = 0;
  for (std::uint32_t& number : straight_of_) {
    if (number == kNobody) continue;
    if (straight_[number].holds()) {
      straight_[kept] = straight_[number];  // their numbers ascend
      number = kept++;
    } else {
      number = kNobody;
    }
  }
  straight_.resize(kept);
  straight_.shrink_to_fit();
}

Straight CurvedFacets::straightBy(std::uint32_t facet) const {
  Straight out;
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t i : linksOf(facet)) {
    const Link& l = links_[i];
    if (!l.runs) continue;
    sum += sum.dot(l.along) < 0.0 ? -l.along : l.along;
    if (std::abs(l.curvature()) > std::abs(out.curvature)) out.curvature = l.curvature();
  }
  if (sum.isZero()) return out;
  const Vec3& normal = facets_.normals[facet];  // facets of several triangles have one: slivers join nobody
  if (normal.isZero()) return out;
  sum = (sum - sum.dot(normal) * normal).normalized();
  for (const std::uint32_t i : linksOf(facet)) {
    if (links_[i].runs && std::abs(links_[i].along.dot(sum)) < kStraight) return out;
  }
  out.along = sum;
  out.across = normal.cross(sum);
  return out;
}

/// The last facet before a crease turns against one neighbour only.
void CurvedFacets::endAtCreases() {
  std::vector<char> last = curved_;
  std::vector<Link*> ends;
  for (Link& l : links_) {
    if (!l.plausible() || !l.alike() || curved_[l.a] == curved_[l.b]) continue;
    const double usual = turnAcross(curved_[l.a] ? l.a : l.b, l), turn = std::abs(l.turn);
    if (turn > kSteepTurnRatio * usual || turn < kTangentTurn * usual) continue;
    last[curved_[l.a] ? l.b : l.a] = 1;
    ends.push_back(&l);
  }
  for (Link* l : ends) l->runs = true;
  curved_ = last;
}

/// How much a facet turns against others in the direction across a border of its own; 0: nothing is known.
double CurvedFacets::turnAcross(std::uint32_t facet, const Link& border) const {
  double most = 0.0;
  for (const std::uint32_t i : linksOf(facet)) {
    const Link& l = links_[i];
    const bool across = facets_.triangles[facet] == 1 || parallel(l, border);
    if (&l != &border && l.runs && across) most = std::max(most, std::abs(l.turn));
  }
  return most;
}

const Link* CurvedFacets::linkOf(std::uint32_t a, std::uint32_t b) const {
  const std::pair<std::uint32_t, std::uint32_t> key = std::minmax(a, b);
  const auto link = std::lower_bound(links_.begin(), links_.end(), key,
                                     [](const Link& l, const auto& k) { return std::pair(l.a, l.b) < k; });
  return link != links_.end() && std::pair(link->a, link->b) == key ? &*link : nullptr;
}

bool CurvedFacets::smooth(std::uint32_t a, std::uint32_t b, double turn) const {
  if (a == b) return true;
  if (!curved_[a] && !curved_[b]) return false;
  const Link* const link = linkOf(a, b);
  if (link == nullptr) return false;
  if (link->runs) return true;
  // A face that touches: the first facet of the round turns by half of what it does elsewhere.
  double usual = 0.0;
  for (const std::uint32_t f : {a, b}) {
    if (curved_[f]) usual = std::max(usual, turnAcross(f, *link));
  }
  return std::abs(turn) <= kTangentTurn * usual;
}

std::uint32_t CurvedFacets::leadingOf(std::uint32_t a, std::uint32_t b) const {
  if (a == b || !curved_[a] || !curved_[b]) return kNobody;
  const Link* const link = linkOf(a, b);
  if (link == nullptr || link->alike()) return kNobody;
  return link->width_a > link->width_b ? link->a : link->b;
}

}  // namespace proveout::shape_detail
