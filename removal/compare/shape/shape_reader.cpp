#include "removal/compare/shape/shape_reader.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "removal/compare/shape/curved_facets.h"

namespace proveout::shape_detail {

namespace {

/// The face over a triangle of a strip curves by at most this much more than its borders tell: they turn by
/// half of what the strip does from one triangle to the next.
constexpr double kTriangleShare = 2.2;
/// Where the neighbours lie where the face as read would have them it may be off by a share of its chord, and
/// by as many times of what they are off.
constexpr float kWellReadShare = 0.3f, kStripShare = 0.1f, kTriangleReadShare = 1.0f, kMisfits = 3.0f;
/// The most that the normal at a corner leaves a facet's: that of triangles, whose corners are farther off
/// than their neighbours' middles.
constexpr double kMostOfATurn = 1.6;

/// The normals of curved faces at the corners of their facets, and from these the heights.
class ShapeReader {
 public:
  explicit ShapeReader(const SurfaceMesh& mesh) : facets_(mesh), curves_(facets_) {}

  ShapeReading read() {
    ShapeReading out;
    const std::size_t size = facets_.mesh.triangles.size();
    std::vector<std::array<float, 6>>& bulge = out.bulge;
    out.doubt = curves_.doubts();
    if (curves_.any()) {
      gatherNormals();
      findChords();
      leaving_ = arriving_ = {};  // asked no more
    }
    bulge.assign(size, std::array<float, 6>{});
    if (!curves_.any()) return out;
    for (std::uint32_t t = 0; t < size; ++t) {
      if (!curves_.curved(facets_.facet_of[t])) continue;
      for (std::uint32_t c = 0; c < 3; ++c) {
        bulge[t][c] = static_cast<float>(fans_[fanOf(3 * t + c)].height);
        bulge[t][3 + c] = static_cast<float>(edgeBulge(t, c));
      }
    }
    out.misfit = misfits(bulge);
    return out;
  }

 private:
  std::uint32_t corner(std::uint32_t t, std::uint32_t vertex) const {
    const auto& v = facets_.mesh.triangles[t];
    return 3 * t + (v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2);
  }

  void gatherNormals() {
    DisjointSets joined(3 * facets_.mesh.triangles.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> leading;  // corners, facets
    facets_.forEachPair([&](std::uint32_t g, std::uint32_t h) {
      const std::uint32_t a = facets_.facet_of[g / 3], b = facets_.facet_of[h / 3],
                          leads = curves_.leadingOf(a, b);
      if (!curves_.smooth(a, b, facets_.turnAt(g, h))) return;
      const auto& v = facets_.mesh.triangles[g / 3];
      for (const std::uint32_t vertex : {v[g % 3], v[(g % 3 + 1) % 3]}) {
        joined.join(corner(g / 3, vertex), corner(h / 3, vertex));
        if (leads != kNobody) leading.emplace_back(corner(g / 3, vertex), leads);
      }
    });
    numberFans(std::move(joined));
    for (const auto& [at, facet] : leading) fans_[fanOf(at)].leading.push_back(facet);
    for (std::uint32_t corner = 0; corner < fan_of_.size(); ++corner) {
      if (facets_.normals[corner / 3].isZero()) continue;
      Fan& fan = fans_[fanOf(corner)];
      const std::uint32_t facet = facets_.facet_of[corner / 3];
      fan.several = fan.several || (fan.facet != kNobody && fan.facet != facet);
      fan.facet = facet;
    }
    findBorders();
    for (const BorderEdge& out : leaving_) add(out);
  }

  /// A fan has many corners, and much is kept of it: so it has a number of its own.
  void numberFans(DisjointSets joined) {
    constexpr std::uint32_t kOpen = kNobody;
    fan_of_.assign(3 * facets_.mesh.triangles.size(), kOpen);
    std::uint32_t count = 0;
    for (std::uint32_t corner = 0; corner < fan_of_.size(); ++corner) {
      std::uint32_t& of_first = fan_of_[joined.find(corner)];  // the lowest corner of its fan
      if (of_first == kOpen) of_first = count++;
      fan_of_[corner] = of_first;
    }
    fans_.assign(count, {});
  }
  std::uint32_t fanOf(std::uint32_t corner) const { return fan_of_[corner]; }

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

  /// An edge of a facet that another facet has too, from a corner of a triangle to its next one.
  struct BorderEdge {
    std::uint32_t facet, from;
    std::uint32_t to() const { return from % 3 == 2 ? from - 2 : from + 1; }
  };

  void findBorders() {
    leaving_.reserve(fan_of_.size());  // no more than there are; what is not written takes no memory
    facets_.edges.forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
      for (const HalfEdge* e = first; e != last; ++e) {
        const std::uint32_t t = e->half_edge / 3, facet = facets_.facet_of[t];
        const auto same = [&](const HalfEdge& o) {
          return &o != e && facets_.facet_of[o.half_edge / 3] == facet;
        };
        if (facets_.normals[t].isZero() || std::any_of(first, last, same)) continue;
        leaving_.push_back({facet, e->half_edge});
      }
    });
    arriving_ = leaving_;
    const auto sortBy = [this](std::vector<BorderEdge>& edges, const auto& end) {
      std::sort(edges.begin(), edges.end(), [&](const BorderEdge& a, const BorderEdge& b) {
        return std::pair(a.facet, vertexOf(end(a))) < std::pair(b.facet, vertexOf(end(b)));
      });
    };
    sortBy(leaving_, [](const BorderEdge& e) { return e.from; });
    sortBy(arriving_, [](const BorderEdge& e) { return e.to(); });
  }

  /// The border edge of a facet that leaves a corner's vertex (arrives there); null where it has none.
  const BorderEdge* borderAt(std::uint32_t facet, std::uint32_t corner, bool leaving) const {
    const std::vector<BorderEdge>& edges = leaving ? leaving_ : arriving_;
    const auto at = [&](const BorderEdge& e) { return vertexOf(leaving ? e.from : e.to()); };
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
      corner = leaving ? edge->to() : edge->from;
      if (end != kNobody && !aligned(pointOf(corner) - from, pointOf(end) - from)) return end;
      end = corner;
      if (fans_[fanOf(end)].several) return end;
    }
    return end;
  }

  static bool aligned(const Vec3& a, const Vec3& b) {
    return a.dot(b) > 0.0 && a.cross(b).norm() <= 1e-3 * a.norm() * b.norm();
  }

  /// Weights that are exact at vertices on spheres and cylinders (N. Max, "Weights for computing vertex
  /// normals from facet normals", 1999).
  void add(const BorderEdge& out) {
    Fan& fan = fans_[fanOf(out.from)];
    if (!curves_.curved(out.facet)) {
      fan.sum[0] += facets_.normals[out.from / 3];
      return;
    }
    const std::uint32_t after = endOfChord(out.facet, out.from, true),
                        before = endOfChord(out.facet, out.from, false);
    if (after == kNobody || before == kNobody) return;
    const Vec3 e = pointOf(after) - pointOf(out.from), f = pointOf(before) - pointOf(out.from);
    const bool leads = std::find(fan.leading.begin(), fan.leading.end(), out.facet) != fan.leading.end();
    fan.sum[leads ? 1 : 2] +=
        facets_.normals[out.from / 3] * (e.cross(f).norm() / (e.squaredNorm() * f.squaredNorm()) + 1e-12);
  }

  std::uint32_t vertexOf(std::uint32_t corner) const {
    return facets_.mesh.triangles[corner / 3][corner % 3];
  }
  const Vec3& pointOf(std::uint32_t corner) const { return facets_.mesh.points[vertexOf(corner)]; }

  /// Vertices within chords lie below the face.
  void findChords() {
    for (const BorderEdge& out : leaving_) {
      Fan& fan = fans_[fanOf(out.from)];
      if (!curves_.curved(out.facet) || fan.several) continue;
      const std::uint32_t a = endOfChord(out.facet, out.from, false),
                          z = endOfChord(out.facet, out.from, true);
      if (a == kNobody || z == kNobody) continue;
      const Fan &first = fans_[fanOf(a)], &last = fans_[fanOf(z)];
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
    const double angle = std::atan2(normal.cross(facets_.normals[t]).norm(), normal.dot(facets_.normals[t]));
    return angle <= kMostOfATurn * curves_.turn(facets_.facet_of[t]) ? normal : facets_.normals[t];
  }

  /// Height of the curved face over the middle of an edge, beyond the mean of its ends.
  double edgeBulge(std::uint32_t t, std::uint32_t c) {
    const Fan &from = fans_[fanOf(3 * t + c)], &to = fans_[fanOf(3 * t + (c + 1) % 3)];
    if ((!from.known() && !to.known()) || facets_.normals[t].isZero()) return 0.0;
    // At a crease the face ends; it turned there as much as at the other end.
    const auto mirrored = [&](const Fan& fan) {
      const Vec3 n = normalIn(fan, t);
      return Vec3(2.0 * facets_.normals[t].dot(n) * facets_.normals[t] - n);
    };
    const Vec3 n = from.known() ? normalIn(from, t) : mirrored(to),
               m = to.known() ? normalIn(to, t) : mirrored(from);
    return std::clamp(chordHeight(t, m - n, facets_.edge(t, static_cast<int>(c))), -kMostChord, kMostChord);
  }

  /// By how much the normal changes along an edge. Where the facet is straight, along that there is none to
  /// see: what long edges would make of the least tilt is left out.
  double chordHeight(std::uint32_t t, const Vec3& change, const Vec3& edge) const {
    const std::uint32_t facet = facets_.facet_of[t];
    const Straight* const s = curves_.straight(facet);
    if (s == nullptr) return change.dot(edge) / 8.0;
    const double across = edge.dot(s->across), told = change.dot(s->across) * across / 8.0;
    if (facets_.triangles[facet] > 1) return told;
    const double most = kTriangleShare * std::abs(s->curvature) * across * across / 8.0;
    return std::clamp(told, -most, most);
  }

  /// Where the face as read over a triangle and the corner of a neighbour across an edge lie apart, as a
  /// height over the triangle, mm; the reading itself where no neighbour can tell.
  std::vector<float> misfits(const std::vector<std::array<float, 6>>& bulge) const {
    std::vector<float> misfit(facets_.mesh.triangles.size(), 0.0f);
    std::vector<char> told(facets_.mesh.triangles.size(), 0);
    facets_.forEachPair([&](std::uint32_t g, std::uint32_t h) {
      for (const auto& [from, to] : {std::pair(g, h), std::pair(h, g)}) {
        const std::uint32_t t = from / 3;
        if (!curves_.curved(facets_.facet_of[t]) || !goesOn(from, to)) continue;
        misfit[t] =
            std::max(misfit[t], static_cast<float>(misfitAt(t, (to / 3) * 3 + (to % 3 + 2) % 3, bulge[t])));
        told[t] = told[t] || facets_.facet_of[t] != facets_.facet_of[to / 3];
      }
    });
    const std::vector<float> missed = missedFacets(bulge);
    for (std::uint32_t t = 0; t < misfit.size(); ++t) {
      const float chord = largestOf(bulge[t]), share = shareOf(facets_.facet_of[t]);
      if (!told[t]) misfit[t] = std::max(misfit[t], chord);
      const float times =
          curves_.isStrip(facets_.facet_of[t]) ? 1.0f : kMisfits;  // straight ones are known all along
      misfit[t] = std::max(times * misfit[t] + share * chord, missed[facets_.facet_of[t]]);
    }
    return misfit;
  }

  /// Of the chord that a reading which its neighbours confirm is good to.
  float shareOf(std::uint32_t facet) const {
    return curves_.isStrip(facet)         ? kStripShare
           : facets_.triangles[facet] > 1 ? kWellReadShare
                                          : kTriangleReadShare;
  }

  /// Per facet: how high a curved face could be that was not seen there, mm: over one that is read as flat
  /// but is about as large as curved ones against which it turns softly (slivers, ends of balls and tops of
  /// rings that lie in one plane), at the round end of a strip, and where irregular triangles turn against
  /// each other.
  std::vector<float> missedFacets(const std::vector<std::array<float, 6>>& bulge) const {
    std::vector<double> border(facets_.mesh.triangles.size(), 0.0);
    std::vector<float> missed(facets_.mesh.triangles.size(), 0.0f), most(facets_.mesh.triangles.size(), 0.0f);
    for (const Link& l : curves_.links()) {
      border[l.a] += l.length;
      border[l.b] += l.length;
    }
    for (std::uint32_t t = 0; t < bulge.size(); ++t)
      most[facets_.facet_of[t]] = std::max(most[facets_.facet_of[t]], largestOf(bulge[t]));
    const auto size = [&](std::uint32_t f) { return facets_.area[f] / std::max(border[f], 1e-9); };
    for (const Link& l : curves_.links()) {
      // Borders of irregular triangles that nobody could place.
      if (!l.runs && facets_.triangles[l.a] == 1 && facets_.triangles[l.b] == 1 && l.plausible() &&
          l.alike()) {
        const float height = kMisfits * static_cast<float>(l.chord());
        for (const std::uint32_t f : {l.a, l.b}) missed[f] = std::max(missed[f], height);
      }
      const std::uint32_t wide = l.width_a > l.width_b ? l.a : l.b;
      if (curves_.curved(l.a) && curves_.curved(l.b) && !l.runs && goesRound(wide, l))
        missed[wide] = std::max({missed[wide], most[l.a], most[l.b]});
      if (curves_.curved(l.a) == curves_.curved(l.b)) continue;
      const std::uint32_t flat = curves_.curved(l.a) ? l.b : l.a, round = curves_.curved(l.a) ? l.a : l.b;
      const double width = curves_.curved(l.a) ? l.width_a : l.width_b;
      const bool small = size(flat) <= kWidthRatio * std::max(size(round), 0.25 * width);
      const bool soft = l.angle() <= std::max(kSoftRad, kMostOfATurn * curves_.turn(round));
      if (soft && small) missed[flat] = std::max(missed[flat], most[round]);
    }
    return missed;
  }

  /// Whether a curved facet turns across another of its borders as it does where its face goes on.
  bool goesRound(std::uint32_t facet, const Link& l) const {
    const double usual = curves_.turn(facet);
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
    const std::uint32_t a = facets_.facet_of[g / 3], b = facets_.facet_of[h / 3];
    if (a == b) return true;
    const Link* const link = curves_.curved(b) ? curves_.linkOf(a, b) : nullptr;
    return link != nullptr && link->runs;
  }

  double misfitAt(std::uint32_t t, std::uint32_t corner, const std::array<float, 6>& b) const {
    const auto& v = facets_.mesh.triangles[t];
    const Vec3 &p = pointOf(corner), &o = facets_.mesh.points[v[0]], e = facets_.mesh.points[v[1]] - o,
               f = facets_.mesh.points[v[2]] - o, area = e.cross(f);
    const double size = area.squaredNorm();
    if (size == 0.0) return 0.0;
    const double s1 = (p - o).cross(f).dot(area) / size, s2 = e.cross(p - o).dot(area) / size,
                 s0 = 1.0 - s1 - s2;
    const double read =
        b[0] * s0 + b[1] * s1 + b[2] * s2 + 4.0 * (b[3] * s0 * s1 + b[4] * s1 * s2 + b[5] * s2 * s0);
    const double is = (p - o).dot(facets_.normals[t]) + fans_[fanOf(corner)].height;
    const double scale = 4.0 * std::max({std::abs(s0 * s1), std::abs(s1 * s2), std::abs(s2 * s0)});
    return std::abs(read - is) / std::max(1.0, scale);
  }

  MeshFacets facets_;
  CurvedFacets curves_;
  std::vector<std::uint32_t> fan_of_;  ///< per corner
  std::vector<Fan> fans_;
  std::vector<BorderEdge> leaving_, arriving_;  ///< by facet and the vertex that they leave, or arrive at
};

}  // namespace

ShapeReading readShape(const SurfaceMesh& mesh) { return ShapeReader(mesh).read(); }

}  // namespace proveout::shape_detail
