#include "tests/reference/reference_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace proveout::reference {

namespace {

/// Facets of one face have the same normal but for rounding.
constexpr double kSameNormal = 1e-9;

struct Piece {
  std::array<int, 2> ends;  ///< vertices
  std::array<Vec3, 2> normals;
};

bool sameFaces(const Piece& a, const Piece& b) {
  const auto same = [](const Vec3& x, const Vec3& y) { return (x - y).norm() < kSameNormal; };
  return (same(a.normals[0], b.normals[0]) && same(a.normals[1], b.normals[1])) ||
         (same(a.normals[0], b.normals[1]) && same(a.normals[1], b.normals[0]));
}

/// Vertices in which two pieces of one edge meet and nothing else: those that facets alone have put there.
class EdgeJoiner {
 public:
  void add(const Piece& piece, const std::array<Vec3, 2>& ends) {
    for (std::size_t k = 0; k < 2; ++k) {
      at_[piece.ends[k]].push_back(pieces_.size());
      places_[piece.ends[k]] = ends[k];
    }
    pieces_.push_back(piece);
  }

  std::vector<ReferenceEdge> join() const {
    std::vector<ReferenceEdge> out;
    std::vector<bool> done(pieces_.size(), false);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (done[i]) continue;
      done[i] = true;
      const Vec3 a = places_.at(lastOf(i, pieces_[i].ends[0], done)),
                 b = places_.at(lastOf(i, pieces_[i].ends[1], done));
      out.push_back({{a, b}, (pieces_[i].normals[0] + pieces_[i].normals[1]).normalized()});
    }
    return out;
  }

 private:
  /// The vertex at which the edge of a piece ends, beyond `vertex`.
  int lastOf(std::size_t piece, int vertex, std::vector<bool>& done) const {
    while (true) {
      const auto& here = at_.at(vertex);
      if (here.size() != 2) return vertex;
      const std::size_t next = here[0] == piece ? here[1] : here[0];
      if (done[next] || !sameFaces(pieces_[piece], pieces_[next])) return vertex;
      done[next] = true;
      piece = next;
      vertex = pieces_[next].ends[0] == vertex ? pieces_[next].ends[1] : pieces_[next].ends[0];
    }
  }

  std::vector<Piece> pieces_;
  std::map<int, std::vector<std::size_t>> at_;
  std::map<int, Vec3> places_;
};

std::vector<ReferenceEdge> piecesOf(const ReferenceEdge& edge, double longest) {
  const Vec3 way = edge.ends[1] - edge.ends[0];
  const int n = std::max(1, static_cast<int>(std::ceil(way.norm() / longest - 1e-6)));
  std::vector<ReferenceEdge> out;
  for (int i = 0; i < n; ++i)
    out.push_back({{edge.ends[0] + 1.0 * i / n * way, edge.ends[0] + 1.0 * (i + 1) / n * way}, edge.normal});
  return out;
}

bool isOneCurve(const std::array<Vec3, 2>& edge, const std::array<Vec3, 2>& other) {
  constexpr double kLeastRadius = 1.5, kSame = 5e-3, kParallel = 0.9;
  const Vec3 along = (edge[1] - edge[0]).normalized(), to = 0.5 * (other[0] + other[1] - edge[0] - edge[1]);
  const double way = along.dot(to), beside = (to - way * along).norm();
  return std::abs(along.dot((other[1] - other[0]).normalized())) > kParallel &&
         beside < kSame + way * way / (2.0 * kLeastRadius);
}

}  // namespace

std::vector<ReferenceEdge> edgesOf(const std::vector<ReferencePart::Facet>& facets, double least_deg) {
  EdgeJoiner joiner;
  const double most = std::cos(degToRad(least_deg));
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = static_cast<std::size_t>(facets[i].beside[k]);
      if (other < i || facets[i].normal.dot(facets[other].normal) >= most) continue;
      const std::size_t l = (k + 1) % 3;
      joiner.add({{facets[i].vertices[k], facets[i].vertices[l]}, {facets[i].normal, facets[other].normal}},
                 {facets[i].corners[k], facets[i].corners[l]});
    }
  }
  return joiner.join();
}

SortedEdges sortEdges(const std::vector<ReferenceEdge>& edges, double within) {
  constexpr double kShortest = 1e-4;  // shorter ones have no direction
  struct Sorted {
    Vec3 middle;
    ReferenceEdge edge;
  };
  std::vector<Sorted> sorted;
  for (const ReferenceEdge& edge : edges) {
    if ((edge.ends[1] - edge.ends[0]).norm() <= kShortest) continue;
    for (const ReferenceEdge& e : piecesOf(edge, within / 3.0))
      sorted.push_back({0.5 * (e.ends[0] + e.ends[1]), e});
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const Sorted& a, const Sorted& b) { return a.middle.x() < b.middle.x(); });
  SortedEdges out;
  for (const Sorted& s : sorted) {
    auto other = std::lower_bound(sorted.begin(), sorted.end(), s.middle.x() - within,
                                  [](const Sorted& a, double x) { return a.middle.x() < x; });
    bool alone = true;
    for (; alone && other != sorted.end() && other->middle.x() < s.middle.x() + within; ++other) {
      alone = (other->middle - s.middle).norm() > within || isOneCurve(s.edge.ends, other->edge.ends);
    }
    (alone ? out.alone : out.crowded).push_back(s.edge);
  }
  return out;
}

std::vector<std::array<Vec3, 2>> segmentsOf(const std::vector<ReferenceEdge>& edges) {
  std::vector<std::array<Vec3, 2>> out;
  for (const ReferenceEdge& e : edges) out.push_back(e.ends);
  return out;
}

}  // namespace proveout::reference
