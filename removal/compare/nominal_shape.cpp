#include "removal/compare/nominal_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/assert.h"
#include "core/mesh/edge_table.h"

namespace proveout {

namespace {

/// Triangles that turn by less against each other are one facet: above the noise of float coordinates, rad.
constexpr double kFlatRad = degToRad(0.05);
/// Text with six digits rounds coordinates by this share: slivers turn by it against the facet that they were
/// cut of, and are at most this part of it wide.
constexpr double kTextNoise = 1e-5, kSliverShare = 0.25;
/// Facets of a curved face turn by less than this; those of small radii by more, as long as the chord is
/// small.
constexpr double kSoftRad = degToRad(20.0), kSteepRad = degToRad(55.0);
/// Chords larger than this are not an exporter's, mm; those between steep facets.
constexpr double kMostChord = 0.25, kMostSteepChord = 0.12;
/// Facets of one curved face are about as wide as their neighbours, and it curves about alike on two sides.
constexpr double kWidthRatio = 2.5, kCurvatureRatio = 3.0, kSteepTurnRatio = 1.3;
/// Flats of regular polygons with chords of up to this could stand for a round, mm: of those that turn
/// softly, and steeply. Nobody makes rounds of hexagons.
constexpr double kMostDoubt = 1.0, kMostSteepDoubt = 0.25;
/// Cosine of how far borders may turn off each other for a facet to be straight along them, and how many
/// times as long as wide it is then.
constexpr double kStraight = 0.65, kStraightLength = 2.0;
/// The face over a triangle of a strip curves by at most this much more than its borders tell: they turn by
/// half of what the strip does from one triangle to the next.
constexpr double kTriangleShare = 2.2;
/// Off both readings the face may be by this many of its chords: where facets are cut by others the reading
/// is rough. By less where the neighbours lie where the face as read would have them: a share of the chord,
/// and as many of what they are off.
constexpr double kMisread = 2.0;
constexpr float kWellReadShare = 0.3f, kStripShare = 0.1f, kTriangleReadShare = 1.0f, kMisfits = 3.0f;
/// Cosine; triangles that turn by less than a degree are of one face.
constexpr double kSameFace = 0.99985;
constexpr double kLeastOfRing = 0.5, kMostMisfit = 3.0;
/// The same of flats in doubt: the round of a regular polygon is known to a few per cent.
constexpr double kDoubtShare = 1.2;
/// A plane turns against the first facet of a round that touches it by half of what the facets turn.
constexpr double kTangentTurn = 0.8;
/// The most that the normal at a corner leaves a facet's: that of triangles, whose corners are farther off
/// than their neighbours' middles.
constexpr double kMostOfATurn = 1.6;
/// Cosine; the sides of an equilateral triangle still count.
constexpr double kParallel = 0.4;
/// Height of a triangle below which its normal is noise, as a share of its coordinates.
constexpr double kFloatNoise = 400 * 1.2e-7;
constexpr std::uint32_t kNobody = 0xFFFFFFFFu;

/// Two facets that meet.
struct Link {
  std::uint32_t a, b;   ///< facets
  double length, turn;  ///< of the border, mm; rad, > 0 where it is convex
  double width_a, width_b;
  Vec3 along;         ///< direction of the border, unit
  bool runs = false;  ///< a curved face goes on across it
  double width() const { return 0.5 * (width_a + width_b); }
  double curvature() const { return turn / width(); }
  bool alike() const { return width_a < kWidthRatio * width_b && width_b < kWidthRatio * width_a; }
  double angle() const { return std::abs(turn); }
  double chord() const { return 0.5 * std::min(width_a, width_b) * std::tan(0.25 * angle()); }
  bool plausible() const {
    return chord() <= kMostChord &&
           (angle() <= kSoftRad || (angle() <= kSteepRad && chord() <= kMostSteepChord));
  }
  bool doubtful() const {
    return !plausible() && angle() <= kSteepRad &&
           chord() <= (angle() <= kSoftRad ? kMostDoubt : kMostSteepDoubt);
  }
};

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

/// What is read of a mesh, per triangle.
struct ShapeReading {
  std::vector<std::array<float, 6>> bulge;  ///< see NominalShape
  std::vector<float> doubt;                 ///< empty: there is none
  std::vector<float> misfit;                ///< by how much neighbours leave what is read; empty: all is flat
};

/// Finds facets, which of them are curved, and their normals at the corners.
class ShapeReader {
 public:
  explicit ShapeReader(const SurfaceMesh& mesh)
      : mesh_(mesh), facet_of_(mesh.triangles.size()), edges_(mesh.points.size(), mesh.triangles) {
    normals_.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vec3 area = mesh.areaVector(t);
      double longest = 0.0;
      for (int c = 0; c < 3; ++c) longest = std::max(longest, edge(t, c).norm());
      const double coordinate = mesh.middle(t).cwiseAbs().maxCoeff();
      // No normal to trust: floats turn it by more than a tenth of a degree.
      const bool sliver = area.norm() <= std::max(2e-5 * longest, kFloatNoise * coordinate) * longest;
      normals_.push_back(sliver ? Vec3::Zero() : Vec3(area.normalized()));
    }
  }

  ShapeReading read() {
    ShapeReading out;
    std::vector<std::array<float, 6>>& bulge = out.bulge;
    bulge.assign(mesh_.triangles.size(), std::array<float, 6>{});
    findFacets();
    findLinks();
    out.doubt = doubts();
    if (!findCurved()) return out;
    findStraight();
    gatherNormals();
    findChords();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!curved_[facet_of_[t]]) continue;
      for (std::uint32_t c = 0; c < 3; ++c) {
        bulge[t][c] = static_cast<float>(fans_[fan_->find(3 * t + c)].height);
        bulge[t][3 + c] = static_cast<float>(edgeBulge(t, c));
      }
    }
    out.misfit = misfits(bulge);
    return out;
  }

 private:
  Vec3 edge(std::size_t t, int c) const {
    return mesh_.points[mesh_.triangles[t][(c + 1) % 3]] - mesh_.points[mesh_.triangles[t][c]];
  }

  /// Calls body(half edge, half edge) where two triangles with normals meet.
  template <typename Body>
  void forEachPair(const Body& body) const {
    edges_.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
      if (last - first != 2) return;
      const std::uint32_t g = first[0].half_edge, h = first[1].half_edge;
      if (!normals_[g / 3].isZero() && !normals_[h / 3].isZero()) body(g, h);
    });
  }

  double turnAt(std::uint32_t g, std::uint32_t h) const {
    const Vec3 &n = normals_[g / 3], &m = normals_[h / 3], cross = n.cross(m);
    const double angle = std::atan2(cross.norm(), n.dot(m));
    return cross.dot(edge(g / 3, static_cast<int>(g % 3))) > 0.0 ? angle : -angle;
  }

  void findFacets() {
    DisjointSets sets(mesh_.triangles.size());
    std::vector<char> joined(mesh_.triangles.size(), 0);
    forEachPair([&](std::uint32_t g, std::uint32_t h) {
      if (std::abs(turnAt(g, h)) >= kFlatRad) return;
      sets.join(g / 3, h / 3);
      joined[g / 3] = joined[h / 3] = 1;
    });
    const std::vector<std::uint32_t> slivers = joinSlivers(joined, sets);
    straighten(slivers, sets);
    area_.assign(mesh_.triangles.size(), 0.0);
    triangles_.assign(mesh_.triangles.size(), 0);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      facet_of_[t] = sets.find(t);
      area_[facet_of_[t]] += 0.5 * mesh_.areaVector(t).norm();
      ++triangles_[facet_of_[t]];
    }
    // A triangle with a sliver is no strip.
    for (const std::uint32_t t : slivers) {
      if (triangles_[facet_of_[t]] > 1) --triangles_[facet_of_[t]];
    }
  }

  /// A triangle that was cut off another's facet and is so narrow that rounding turned it.
  struct Sliver {
    std::uint32_t triangle = kNobody, beside = kNobody;    ///< kNobody: neither of the two is one
    double off = std::numeric_limits<double>::infinity();  ///< of that facet, mm
  };

  Sliver sliverOf(std::uint32_t g, std::uint32_t h) const {
    const double length = edge(g / 3, static_cast<int>(g % 3)).norm();
    const double a = mesh_.areaVector(g / 3).norm() / length, b = mesh_.areaVector(h / 3).norm() / length;
    const auto [narrow, wide] = a < b ? std::pair(g / 3, h / 3) : std::pair(h / 3, g / 3);
    if (std::min(a, b) >= kSliverShare * std::max(a, b)) return {};
    const double off = std::abs(turnAt(g, h)) * std::min(a, b);
    const double noise = kTextNoise * mesh_.middle(narrow).cwiseAbs().maxCoeff();
    return off < noise ? Sliver{narrow, wide, off} : Sliver();
  }

  /// Joins those that are of no facet yet with the one that rounding turned them least against: never two
  /// facets by what lies between them. Returns them.
  std::vector<std::uint32_t> joinSlivers(const std::vector<char>& joined, DisjointSets& sets) const {
    std::vector<Sliver> best(mesh_.triangles.size());
    forEachPair([&](std::uint32_t g, std::uint32_t h) {
      const Sliver sliver = sliverOf(g, h);
      if (sliver.triangle == kNobody || joined[sliver.triangle]) return;
      if (sliver.off < best[sliver.triangle].off) best[sliver.triangle] = sliver;
    });
    std::vector<std::uint32_t> out;
    for (const Sliver& sliver : best) {
      if (sliver.triangle == kNobody) continue;
      sets.join(sliver.triangle, sliver.beside);
      out.push_back(sliver.triangle);
    }
    return out;
  }

  /// Slivers have the normal of the facet that they are of.
  void straighten(const std::vector<std::uint32_t>& slivers, DisjointSets& sets) {
    if (slivers.empty()) return;
    std::vector<Vec3> sum(mesh_.triangles.size(), Vec3::Zero());
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) sum[sets.find(t)] += mesh_.areaVector(t);
    for (const std::uint32_t t : slivers) {
      const Vec3& whole = sum[sets.find(t)];
      normals_[t] = normals_[sets.find(t)] = whole.normalized();
    }
  }

  double widthOf(std::uint32_t facet, double length) const {
    return (triangles_[facet] == 1 ? 2.0 : 1.0) * area_[facet] / length;  // a strip's, a triangle's height
  }

  void findLinks() {
    forEachPair([&](std::uint32_t g, std::uint32_t h) {
      const std::uint32_t a = facet_of_[g / 3], b = facet_of_[h / 3];
      if (a == b) return;
      const Vec3 way = edge(g / 3, static_cast<int>(g % 3));
      links_.push_back(
          {std::min(a, b), std::max(a, b), way.norm(), turnAt(g, h), 0.0, 0.0, a < b ? way : -way});
    });
    std::stable_sort(links_.begin(), links_.end(),
                     [](const Link& l, const Link& m) { return std::pair(l.a, l.b) < std::pair(m.a, m.b); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < links_.size();) {  // a border of several edges is one
      Link sum = links_[i];
      sum.turn *= sum.length;
      std::size_t j = i + 1;
      for (; j < links_.size() && links_[j].a == sum.a && links_[j].b == sum.b; ++j) {
        sum.turn += links_[j].turn * links_[j].length;
        sum.length += links_[j].length;
        sum.along += links_[j].along;
      }
      sum.along.normalize();
      sum.turn /= sum.length;
      sum.width_a = widthOf(sum.a, sum.length);
      sum.width_b = widthOf(sum.b, sum.length);
      links_[kept++] = sum;
      i = j;
    }
    links_.resize(kept);
  }

  /// Per triangle: the chord of the round that flats of a regular polygon could stand for, mm.
  std::vector<float> doubts() const {
    std::vector<float> doubt(mesh_.triangles.size(), 0.0f);    // per facet first
    std::vector<std::pair<std::uint32_t, std::uint32_t>> own;  // facets, links
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
    for (std::uint32_t t = static_cast<std::uint32_t>(doubt.size()); t-- > 0;) doubt[t] = doubt[facet_of_[t]];
    return doubt;
  }

  /// False where no facet is curved.
  bool findCurved() {
    curved_.assign(mesh_.triangles.size(), 0);
    turn_.assign(mesh_.triangles.size(), 0.0);
    links_of_.assign(mesh_.triangles.size(), {});
    for (std::uint32_t i = 0; i < links_.size(); ++i) {
      if (!links_[i].plausible() || !links_[i].alike()) continue;
      links_of_[links_[i].a].push_back(i);
      links_of_[links_[i].b].push_back(i);
    }
    bool any = false;
    for (std::uint32_t f = 0; f < links_of_.size(); ++f) {
      const std::vector<std::uint32_t>& own = links_of_[f];
      for (std::size_t i = 0; i < own.size(); ++i) {
        for (std::size_t j = i + 1; j < own.size(); ++j) {
          Link &l = links_[own[i]], &m = links_[own[j]];
          // Strips curve across their long sides; of a triangle the side opposite is another one's.
          if ((triangles_[f] > 1 && !parallel(l, m)) || !sameCurve(l, m)) continue;
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

  /// How a facet that is straight in one direction curves across it.
  struct Straight {
    Vec3 along = Vec3::Zero(), across = Vec3::Zero();  ///< unit; zero: the facet is no such
    double curvature = 0.0;                            ///< 1/mm, > 0: convex
    Eigen::Array2d low = Eigen::Array2d::Constant(1e300), high = Eigen::Array2d::Constant(-1e300);
    bool holds() const {
      const Eigen::Array2d size = high - low;
      return !along.isZero() && size[0] >= kStraightLength * size[1];
    }
  };

  /// Facets with all the borders that a curved face crosses in about one direction.
  void findStraight() {
    straight_of_.assign(mesh_.triangles.size(), kNobody);
    for (std::uint32_t f = 0; f < links_of_.size(); ++f) {
      const Straight found = curved_[f] ? straightBy(f) : Straight();
      if (found.along.isZero()) continue;
      straight_of_[f] = static_cast<std::uint32_t>(straight_.size());
      straight_.push_back(found);
    }
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::uint32_t number = straight_of_[facet_of_[t]];
      if (number == kNobody) continue;
      Straight& s = straight_[number];
      for (const std::uint32_t v : mesh_.triangles[t]) {
        const Eigen::Array2d at(s.along.dot(mesh_.points[v]), s.across.dot(mesh_.points[v]));
        s.low = s.low.min(at);
        s.high = s.high.max(at);
      }
    }
  }

  Straight straightBy(std::uint32_t facet) const {
    Straight out;
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t i : links_of_[facet]) {
      const Link& l = links_[i];
      if (!l.runs) continue;
      sum += sum.dot(l.along) < 0.0 ? -l.along : l.along;
      if (std::abs(l.curvature()) > std::abs(out.curvature)) out.curvature = l.curvature();
    }
    if (sum.isZero()) return out;
    const Vec3& normal = normals_[facet];  // facets of several triangles have one: slivers join nobody
    if (normal.isZero()) return out;
    sum = (sum - sum.dot(normal) * normal).normalized();
    for (const std::uint32_t i : links_of_[facet]) {
      if (links_[i].runs && std::abs(links_[i].along.dot(sum)) < kStraight) return out;
    }
    out.along = sum;
    out.across = normal.cross(sum);
    return out;
  }

  /// The last facet before a crease turns against one neighbour only.
  void endAtCreases() {
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
  double turnAcross(std::uint32_t facet, const Link& border) const {
    double most = 0.0;
    for (const std::uint32_t i : links_of_[facet]) {
      const Link& l = links_[i];
      const bool across = triangles_[facet] == 1 || parallel(l, border);
      if (&l != &border && l.runs && across) most = std::max(most, std::abs(l.turn));
    }
    return most;
  }

  const Link* linkOf(std::uint32_t a, std::uint32_t b) const {
    const std::pair<std::uint32_t, std::uint32_t> key = std::minmax(a, b);
    const auto link = std::lower_bound(links_.begin(), links_.end(), key,
                                       [](const Link& l, const auto& k) { return std::pair(l.a, l.b) < k; });
    return link != links_.end() && std::pair(link->a, link->b) == key ? &*link : nullptr;
  }

  /// Whether the surface goes on smoothly from one facet to the other.
  bool smooth(std::uint32_t a, std::uint32_t b, double turn) const {
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

  /// Where a long facet of one curved face meets the short ones of another that it touches (a straight fillet
  /// the round of its corner), the face is straight on the long one's side: its normal is the right one.
  std::uint32_t leadingOf(std::uint32_t a, std::uint32_t b) const {
    if (a == b || !curved_[a] || !curved_[b]) return kNobody;
    const Link* const link = linkOf(a, b);
    if (link == nullptr || link->alike()) return kNobody;
    return link->width_a > link->width_b ? link->a : link->b;
  }

  std::uint32_t corner(std::uint32_t t, std::uint32_t vertex) const {
    const auto& v = mesh_.triangles[t];
    return 3 * t + (v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2);
  }

  void gatherNormals() {
    fan_ = std::make_unique<DisjointSets>(3 * mesh_.triangles.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> leading;  // corners, facets
    forEachPair([&](std::uint32_t g, std::uint32_t h) {
      const std::uint32_t a = facet_of_[g / 3], b = facet_of_[h / 3], leads = leadingOf(a, b);
      if (!smooth(a, b, turnAt(g, h))) return;
      const auto& v = mesh_.triangles[g / 3];
      for (const std::uint32_t vertex : {v[g % 3], v[(g % 3 + 1) % 3]}) {
        fan_->join(corner(g / 3, vertex), corner(h / 3, vertex));
        if (leads != kNobody) leading.emplace_back(corner(g / 3, vertex), leads);
      }
    });
    fans_.assign(3 * mesh_.triangles.size(), {});
    for (const auto& [at, facet] : leading) fans_[fan_->find(at)].leading.push_back(facet);
    for (std::uint32_t corner = 0; corner < fans_.size(); ++corner) {
      if (normals_[corner / 3].isZero()) continue;
      Fan& fan = fans_[fan_->find(corner)];
      const std::uint32_t facet = facet_of_[corner / 3];
      fan.several = fan.several || (fan.facet != kNobody && fan.facet != facet);
      fan.facet = facet;
    }
    findBorders();
    for (const BorderEdge& out : leaving_) add(out);
  }

  struct Fan {
    std::array<Vec3, 3> sum{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< of flat, leading and other facets
    std::vector<std::uint32_t> leading;                                 ///< facets
    std::uint32_t facet = kNobody;
    bool several = false;  ///< facets
    double height = 0.0;   ///< of the curved face there, mm
    bool in_chord = false;
    bool known() const { return several || in_chord; }  ///< the normal is the curved face's
    Vec3 normal() const {
      return (!sum[0].isZero() ? sum[0] : !sum[1].isZero() ? sum[1] : sum[2]).normalized();
    }
  };

  /// An edge of a facet that another facet has too; corners of one triangle.
  struct BorderEdge {
    std::uint32_t facet, from, to;
  };

  void findBorders() {
    edges_.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
      for (const HalfEdge* e = first; e != last; ++e) {
        const std::uint32_t t = e->half_edge / 3, c = e->half_edge % 3, facet = facet_of_[t];
        const auto same = [&](const HalfEdge& o) { return &o != e && facet_of_[o.half_edge / 3] == facet; };
        if (normals_[t].isZero() || std::any_of(first, last, same)) continue;
        leaving_.push_back({facet, 3 * t + c, 3 * t + (c + 1) % 3});
      }
    });
    arriving_ = leaving_;
    const auto by = [this](std::uint32_t BorderEdge::*end) {
      return [this, end](const BorderEdge& a, const BorderEdge& b) {
        return std::pair(a.facet, vertexOf(a.*end)) < std::pair(b.facet, vertexOf(b.*end));
      };
    };
    std::sort(leaving_.begin(), leaving_.end(), by(&BorderEdge::from));
    std::sort(arriving_.begin(), arriving_.end(), by(&BorderEdge::to));
  }

  /// The border edge of a facet that leaves a corner's vertex (arrives there); null where it has none.
  const BorderEdge* borderAt(std::uint32_t facet, std::uint32_t corner, bool leaving) const {
    const std::vector<BorderEdge>& edges = leaving ? leaving_ : arriving_;
    const auto at = [&](const BorderEdge& e) { return vertexOf(leaving ? e.from : e.to); };
    const std::pair key(facet, vertexOf(corner));
    const auto found =
        std::lower_bound(edges.begin(), edges.end(), key,
                         [&](const BorderEdge& e, const auto& k) { return std::pair(e.facet, at(e)) < k; });
    return found != edges.end() && found->facet == facet && at(*found) == key.second ? &*found : nullptr;
  }

  /// The other end of the straight border that leaves a corner (arrives there): programs that cut meshes with
  /// meshes leave vertices within it. kNobody: there is no border.
  std::uint32_t endOfChord(std::uint32_t facet, std::uint32_t corner, bool leaving) const {
    constexpr int kMostSplits = 1000;
    const Vec3& from = pointOf(corner);
    std::uint32_t end = kNobody;
    for (int i = 0; i < kMostSplits; ++i) {
      const BorderEdge* edge = borderAt(facet, corner, leaving);
      if (edge == nullptr) return end;
      corner = leaving ? edge->to : edge->from;
      if (end != kNobody && !aligned(pointOf(corner) - from, pointOf(end) - from)) return end;
      end = corner;
      if (fans_[fan_->find(end)].several) return end;
    }
    return end;
  }

  static bool aligned(const Vec3& a, const Vec3& b) {
    return a.dot(b) > 0.0 && a.cross(b).norm() <= 1e-3 * a.norm() * b.norm();
  }

  /// Weights that are exact at vertices on spheres and cylinders (N. Max, "Weights for computing vertex
  /// normals from facet normals", 1999).
  void add(const BorderEdge& out) {
    Fan& fan = fans_[fan_->find(out.from)];
    if (!curved_[out.facet]) {
      fan.sum[0] += normals_[out.from / 3];
      return;
    }
    const std::uint32_t after = endOfChord(out.facet, out.from, true),
                        before = endOfChord(out.facet, out.from, false);
    if (after == kNobody || before == kNobody) return;
    const Vec3 e = pointOf(after) - pointOf(out.from), f = pointOf(before) - pointOf(out.from);
    const bool leads = std::find(fan.leading.begin(), fan.leading.end(), out.facet) != fan.leading.end();
    fan.sum[leads ? 1 : 2] +=
        normals_[out.from / 3] * (e.cross(f).norm() / (e.squaredNorm() * f.squaredNorm()) + 1e-12);
  }

  std::uint32_t vertexOf(std::uint32_t corner) const { return mesh_.triangles[corner / 3][corner % 3]; }
  const Vec3& pointOf(std::uint32_t corner) const { return mesh_.points[vertexOf(corner)]; }

  /// Vertices within chords lie below the face.
  void findChords() {
    for (const BorderEdge& out : leaving_) {
      Fan& fan = fans_[fan_->find(out.from)];
      if (!curved_[out.facet] || fan.several) continue;
      const std::uint32_t a = endOfChord(out.facet, out.from, false),
                          z = endOfChord(out.facet, out.from, true);
      if (a == kNobody || z == kNobody) continue;
      const Fan &first = fans_[fan_->find(a)], &last = fans_[fan_->find(z)];
      const Vec3 chord = pointOf(z) - pointOf(a), part = pointOf(out.from) - pointOf(a);
      if (!first.several || !last.several || !aligned(part, chord)) continue;
      const Vec3 n = first.normal(), m = last.normal();
      const double t = part.norm() / chord.norm();
      fan.in_chord = true;
      fan.sum = {Vec3::Zero(), Vec3::Zero(), (1.0 - t) * n + t * m};
      fan.height = 4.0 * t * (1.0 - t) * std::clamp((m - n).dot(chord) / 8.0, -kMostChord, kMostChord);
    }
  }

  /// A fan's normal as a triangle sees it: at the tip of a cone there is none.
  Vec3 normalIn(const Fan& fan, std::uint32_t t) const {
    const Vec3 normal = fan.normal();
    const double angle = std::atan2(normal.cross(normals_[t]).norm(), normal.dot(normals_[t]));
    return angle <= kMostOfATurn * turn_[facet_of_[t]] ? normal : normals_[t];
  }

  /// Height of the curved face over the middle of an edge, beyond the mean of its ends.
  double edgeBulge(std::uint32_t t, std::uint32_t c) {
    const Fan &from = fans_[fan_->find(3 * t + c)], &to = fans_[fan_->find(3 * t + (c + 1) % 3)];
    if ((!from.known() && !to.known()) || normals_[t].isZero()) return 0.0;
    // At a crease the face ends; it turned there as much as at the other end.
    const auto mirrored = [&](const Fan& fan) {
      const Vec3 n = normalIn(fan, t);
      return Vec3(2.0 * normals_[t].dot(n) * normals_[t] - n);
    };
    const Vec3 n = from.known() ? normalIn(from, t) : mirrored(to),
               m = to.known() ? normalIn(to, t) : mirrored(from);
    return std::clamp(chordHeight(t, m - n, edge(t, static_cast<int>(c))), -kMostChord, kMostChord);
  }

  /// By how much the normal changes along an edge. Where the facet is straight, along that there is none to
  /// see: what long edges would make of the least tilt is left out.
  double chordHeight(std::uint32_t t, const Vec3& change, const Vec3& edge) const {
    const std::uint32_t facet = facet_of_[t];
    if (straight_of_[facet] == kNobody || !straight_[straight_of_[facet]].holds())
      return change.dot(edge) / 8.0;
    const Straight& s = straight_[straight_of_[facet]];
    const double across = edge.dot(s.across), told = change.dot(s.across) * across / 8.0;
    if (triangles_[facet] > 1) return told;
    const double most = kTriangleShare * std::abs(s.curvature) * across * across / 8.0;
    return std::clamp(told, -most, most);
  }

  /// Where the face as read over a triangle and the corner of a neighbour across an edge lie apart, as a
  /// height over the triangle, mm; the reading itself where no neighbour can tell.
  std::vector<float> misfits(const std::vector<std::array<float, 6>>& bulge) const {
    std::vector<float> misfit(mesh_.triangles.size(), 0.0f);
    std::vector<char> told(mesh_.triangles.size(), 0);
    forEachPair([&](std::uint32_t g, std::uint32_t h) {
      for (const auto& [from, to] : {std::pair(g, h), std::pair(h, g)}) {
        const std::uint32_t t = from / 3;
        if (!curved_[facet_of_[t]] || !goesOn(from, to)) continue;
        misfit[t] =
            std::max(misfit[t], static_cast<float>(misfitAt(t, (to / 3) * 3 + (to % 3 + 2) % 3, bulge[t])));
        told[t] = told[t] || facet_of_[t] != facet_of_[to / 3];
      }
    });
    const std::vector<float> missed = missedFacets(bulge);
    for (std::uint32_t t = 0; t < misfit.size(); ++t) {
      const float chord = largestOf(bulge[t]), share = shareOf(facet_of_[t]);
      if (!told[t]) misfit[t] = std::max(misfit[t], chord);
      const float times = isStrip(facet_of_[t]) ? 1.0f : kMisfits;  // straight ones are known all along
      misfit[t] = std::max(times * misfit[t] + share * chord, missed[facet_of_[t]]);
    }
    return misfit;
  }

  /// Of the chord that a reading which its neighbours confirm is good to.
  float shareOf(std::uint32_t facet) const {
    return isStrip(facet) ? kStripShare : triangles_[facet] > 1 ? kWellReadShare : kTriangleReadShare;
  }

  bool isStrip(std::uint32_t facet) const {
    return triangles_[facet] > 1 && straight_of_[facet] != kNobody && straight_[straight_of_[facet]].holds();
  }

  /// Per facet: how high a curved face could be that was not seen there, mm: over one that is read as flat
  /// but is about as large as curved ones against which it turns softly (slivers, ends of balls and tops of
  /// rings that lie in one plane), at the round end of a strip, and where irregular triangles turn against
  /// each other.
  std::vector<float> missedFacets(const std::vector<std::array<float, 6>>& bulge) const {
    std::vector<double> border(mesh_.triangles.size(), 0.0);
    std::vector<float> missed(mesh_.triangles.size(), 0.0f), most(mesh_.triangles.size(), 0.0f);
    for (const Link& l : links_) {
      border[l.a] += l.length;
      border[l.b] += l.length;
    }
    for (std::uint32_t t = 0; t < bulge.size(); ++t)
      most[facet_of_[t]] = std::max(most[facet_of_[t]], largestOf(bulge[t]));
    const auto size = [&](std::uint32_t f) { return area_[f] / std::max(border[f], 1e-9); };
    for (const Link& l : links_) {
      // Borders of irregular triangles that nobody could place.
      if (!l.runs && triangles_[l.a] == 1 && triangles_[l.b] == 1 && l.plausible() && l.alike()) {
        const float height = kMisfits * static_cast<float>(l.chord());
        for (const std::uint32_t f : {l.a, l.b}) missed[f] = std::max(missed[f], height);
      }
      const std::uint32_t wide = l.width_a > l.width_b ? l.a : l.b;
      if (curved_[l.a] && curved_[l.b] && !l.runs && goesRound(wide, l))
        missed[wide] = std::max({missed[wide], most[l.a], most[l.b]});
      if (curved_[l.a] == curved_[l.b]) continue;
      const std::uint32_t flat = curved_[l.a] ? l.b : l.a, round = curved_[l.a] ? l.a : l.b;
      const double width = curved_[l.a] ? l.width_a : l.width_b;
      const bool small = size(flat) <= kWidthRatio * std::max(size(round), 0.25 * width);
      const bool soft = l.angle() <= std::max(kSoftRad, kMostOfATurn * turn_[round]);
      if (soft && small) missed[flat] = std::max(missed[flat], most[round]);
    }
    return missed;
  }

  /// Whether a curved facet turns across another of its borders as it does where its face goes on.
  bool goesRound(std::uint32_t facet, const Link& l) const {
    const double usual = turn_[facet];
    return l.angle() <= kSoftRad && l.angle() <= kSteepTurnRatio * usual &&
           kSteepTurnRatio * l.angle() >= usual;
  }

  static float largestOf(const std::array<float, 6>& bulge) {
    float most = 0.0f;
    for (const float b : bulge) most = std::max(most, std::abs(b));
    return most;
  }

  /// Whether one face goes on from triangle to triangle, and about as far.
  bool goesOn(std::uint32_t g, std::uint32_t h) const {
    const std::uint32_t a = facet_of_[g / 3], b = facet_of_[h / 3];
    if (a == b) return true;
    const Link* const link = curved_[b] ? linkOf(a, b) : nullptr;
    return link != nullptr && link->runs;
  }

  double misfitAt(std::uint32_t t, std::uint32_t corner, const std::array<float, 6>& b) const {
    const auto& v = mesh_.triangles[t];
    const Vec3 &p = pointOf(corner), &o = mesh_.points[v[0]], e = mesh_.points[v[1]] - o,
               f = mesh_.points[v[2]] - o, area = e.cross(f);
    const double size = area.squaredNorm();
    if (size == 0.0) return 0.0;
    const double s1 = (p - o).cross(f).dot(area) / size, s2 = e.cross(p - o).dot(area) / size,
                 s0 = 1.0 - s1 - s2;
    const double read =
        b[0] * s0 + b[1] * s1 + b[2] * s2 + 4.0 * (b[3] * s0 * s1 + b[4] * s1 * s2 + b[5] * s2 * s0);
    const double is = (p - o).dot(normals_[t]) + fans_[fan_->find(corner)].height;
    const double scale = 4.0 * std::max({std::abs(s0 * s1), std::abs(s1 * s2), std::abs(s2 * s0)});
    return std::abs(read - is) / std::max(1.0, scale);
  }

  const SurfaceMesh& mesh_;
  std::vector<std::uint32_t> facet_of_;  ///< per triangle: the first triangle of its facet
  EdgeTable edges_;
  std::vector<Vec3> normals_;  ///< unit; zero: not to be trusted
  std::vector<double> area_;   ///< per facet, mm2
  std::vector<std::uint32_t> triangles_;
  std::vector<Link> links_;
  std::vector<std::vector<std::uint32_t>> links_of_;  ///< per facet: those that a curved face could cross
  std::vector<char> curved_;                          ///< per facet
  std::vector<std::uint32_t> straight_of_;            ///< per facet: its place in straight_, or kNobody
  std::vector<Straight> straight_;
  std::vector<double> turn_;  ///< per curved facet: against its neighbours, rad
  std::unique_ptr<DisjointSets> fan_;
  std::vector<Fan> fans_;
  std::vector<BorderEdge> leaving_, arriving_;  ///< by facet and the vertex that they leave, or arrive at
};

}  // namespace

double NominalShape::largestOf(std::uint32_t t) const {
  double largest = std::abs(at(t, surface_.mesh().middle(t)));
  for (std::size_t c = 0; c < 3; ++c) {
    const float middle = 0.5f * (bulge_[t][c] + bulge_[t][(c + 1) % 3]) + bulge_[t][3 + c];
    largest = std::max(largest, static_cast<double>(std::abs(middle)));
  }
  return largest;
}

double NominalShape::mostUnsure() const { return kMisread * std::max(largest_, largest_doubt_); }

double NominalShape::unsureAt(std::uint32_t triangle, const Vec3& place, double reach) const {
  if (largest_ == 0.0 && largest_doubt_ == 0.0) return 0.0;
  PROVEOUT_ASSERT(triangle < bulge_.size());
  double largest = 0.0, misfit = 0.0, doubt = 0.0;
  const auto add = [&](std::uint32_t t) {
    if (largest_ > 0.0) {
      largest = std::max(largest, largestOf(t));
      misfit = std::max(misfit, static_cast<double>(misfit_[t]));
    }
    if (!doubt_.empty()) doubt = std::max(doubt, static_cast<double>(doubt_[t]));
  };
  add(triangle);
  const double own = largest;
  if (own > 0.0 || misfit > 0.0) {
    for (const std::uint32_t v : surface_.mesh().triangles[triangle]) {
      largest = std::max(largest, static_cast<double>(around_[v][0]));
      misfit = std::max(misfit, static_cast<double>(around_[v][1]));
    }
  }
  // Beside another face what that one is cut of counts: the pieces left at the border tell little themselves.
  const Vec3 normal = surface_.mesh().areaVector(triangle).normalized();
  surface_.tree().forEachIn(
      {place - Vec3::Constant(reach), place + Vec3::Constant(reach)}, [&](std::uint32_t t) {
        add(t);
        if (around_.empty() || surface_.mesh().areaVector(t).normalized().dot(normal) > kSameFace) return;
        for (const std::uint32_t v : surface_.mesh().triangles[t])
          largest = std::max(largest, static_cast<double>(around_[v][0]));
      });
  const double most = kMisread * largest;
  // What is much lower than around it was hardly read at all.
  const bool well = own > kLeastOfRing * largest;
  return std::max(well ? std::min(most, misfit) : std::max(most, std::min(misfit, kMostMisfit * largest)),
                  kDoubtShare * doubt);
}

NominalShape::NominalShape(const SignedDistance& surface) : surface_(surface) {
  const SurfaceMesh& mesh = surface.mesh();
  ShapeReading reading = ShapeReader(mesh).read();
  bulge_ = std::move(reading.bulge);
  doubt_ = std::move(reading.doubt);
  misfit_ = std::move(reading.misfit);
  PROVEOUT_ASSERT(bulge_.size() == mesh.triangles.size());
  PROVEOUT_ASSERT((doubt_.empty() || doubt_.size() == bulge_.size()) &&
                  (misfit_.empty() || misfit_.size() == bulge_.size()));
  if (!misfit_.empty()) lookAround();
  for (std::uint32_t t = 0; t < bulge_.size(); ++t) {
    const double largest = largestOf(t);
    if (!doubt_.empty() && doubt_[t] > largest_doubt_) {
      largest_doubt_ = doubt_[t];
      largest_doubt_at_ = mesh.middle(t);
    }
    if (largest <= largest_) continue;
    largest_ = largest;
    largest_at_ = mesh.middle(t);
  }
}

void NominalShape::lookAround() {
  const SurfaceMesh& mesh = surface_.mesh();
  const auto raise = [](std::array<float, 2>& most, const std::array<float, 2>& by) {
    most = {std::max(most[0], by[0]), std::max(most[1], by[1])};
  };
  std::vector<std::array<float, 2>> of(mesh.triangles.size());
  for (std::uint32_t t = 0; t < of.size(); ++t) of[t] = {static_cast<float>(largestOf(t)), misfit_[t]};
  constexpr int kRings = 2;
  for (int ring = 0; ring < kRings; ++ring) {
    around_.assign(mesh.points.size(), {0.0f, 0.0f});
    for (std::uint32_t t = 0; t < of.size(); ++t) {
      for (const std::uint32_t v : mesh.triangles[t]) raise(around_[v], of[t]);
    }
    for (std::uint32_t t = 0; t < of.size(); ++t) {
      if (of[t][0] == 0.0f && of[t][1] == 0.0f) continue;  // a flat face between two rounds joins nothing
      for (const std::uint32_t v : mesh.triangles[t]) raise(of[t], around_[v]);
    }
  }
}

double NominalShape::at(std::uint32_t triangle, const Vec3& point) const {
  const auto& b = bulge_[triangle];
  if (b == std::array<float, 6>{}) return 0.0;
  const SurfaceMesh& mesh = surface_.mesh();
  const auto& v = mesh.triangles[triangle];
  const Vec3 normal = mesh.areaVector(triangle);
  const auto share = [&](int c) {  // barycentric
    const Vec3 &p = mesh.points[v[(c + 1) % 3]], &q = mesh.points[v[(c + 2) % 3]];
    return std::clamp((p - point).cross(q - point).dot(normal) / normal.squaredNorm(), 0.0, 1.0);
  };
  const double s[3] = {share(0), share(1), share(2)};
  return b[0] * s[0] + b[1] * s[1] + b[2] * s[2] +
         4.0 * (b[3] * s[0] * s[1] + b[4] * s[1] * s[2] + b[5] * s[2] * s[0]);
}

Bulge NominalShape::at(const SurfaceDistance& nearest, const Vec3& place) const {
  if (largest_ == 0.0) return {};
  const Vec3 foot = place - nearest.distance * nearest.gradient.cast<double>();
  Bulge out;
  const auto add = [&](std::uint32_t t) {
    const double b = at(t, foot);
    out.low = std::min(out.low, b);
    out.high = std::max(out.high, b);
  };
  add(nearest.triangle);
  if (nearest.part >= 3 && nearest.part < kFacePart) {
    const std::uint32_t other = surface_.neighbour(nearest.triangle, nearest.part - 3);
    if (other != TriangleTree::kNone) add(other);
  }
  return out;
}

}  // namespace proveout
