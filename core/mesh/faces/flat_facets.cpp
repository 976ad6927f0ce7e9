#include "core/mesh/faces/flat_facets.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "core/mesh/edge_table.h"

namespace proveout {
namespace flat_detail {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;
/// Facets of one curved face are about as wide as their neighbours.
constexpr double kWidthRatio = 3.0;
/// A triangle lower than so many times what its corners may be off says nothing of its plane.
constexpr double kFirm = 8.0;

/// The plane of the corners gathered so far, and how well it is known.
class GrowingPlane {
 public:
  GrowingPlane(const Vec3& from, const Vec3& normal) : from_(from), normal_(normal) {}
  void add(const Vec3& p) {
    const Vec3 d = p - from_;
    sum_ += d;
    outer_ += d * d.transpose();
    if (++count_ >= next_fit_) fit();
  }
  double off(const Vec3& p) const { return std::abs((p - from_ - offset_).dot(normal_)); }
  /// How far off the plane a corner may seem to be there that lies in it, for corners that are exact to 1.
  double doubt(const Vec3& p) const {
    const Vec3 d = p - from_ - offset_;
    const auto share = [&](const Vec3& along, double squares) {
      const double at = d.dot(along);
      return squares > 0.0 ? at * at / squares : 0.0;
    };
    return std::sqrt(share(u_, squares_u_) + share(v_, squares_v_));
  }
  const Vec3& normal() const { return normal_; }

 private:
  void fit() {
    const double n = count_;
    const Vec3 mean = sum_ / n;
    const Eigen::Matrix3d spread = outer_ - n * mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(spread);
    if (!(solver.eigenvalues()[1] > 0.0)) return;
    offset_ = mean;
    const Vec3 fitted = solver.eigenvectors().col(0);
    normal_ = fitted.dot(normal_) < 0.0 ? Vec3(-fitted) : fitted;
    u_ = solver.eigenvectors().col(2);
    v_ = solver.eigenvectors().col(1);
    squares_u_ = solver.eigenvalues()[2];
    squares_v_ = solver.eigenvalues()[1];
    next_fit_ = count_ + 1 + count_ / 4;
  }

  Vec3 from_, normal_;
  Vec3 offset_ = Vec3::Zero(), sum_ = Vec3::Zero(), u_ = Vec3::UnitX(), v_ = Vec3::UnitY();
  Eigen::Matrix3d outer_ = Eigen::Matrix3d::Zero();
  double squares_u_ = 0.0, squares_v_ = 0.0;
  int count_ = 0, next_fit_ = 3;
};

/// Doubled area along the normal, and the longest edge.
struct Shape {
  Vec3 area = Vec3::Zero();
  double longest = 0.0;
  double height() const { return longest > 0.0 ? area.norm() / longest : 0.0; }
};

Shape shapeOf(const TriMesh& mesh, std::size_t t) {
  const auto& c = mesh.triangles[t];
  const Vec3 p = mesh.positions[c[0]].cast<double>(), q = mesh.positions[c[1]].cast<double>(),
             r = mesh.positions[c[2]].cast<double>();
  return {(q - p).cross(r - p),
          std::sqrt(std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()}))};
}

std::vector<std::uint32_t> trianglesAcross(const TriMesh& mesh) {
  std::vector<std::uint32_t> out(3 * mesh.triangles.size(), kNone);
  EdgeTable(mesh.positions.size(), mesh.triangles)
      .forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
        if (last - first != 2) return;
        out[first[0].half_edge] = first[1].half_edge / 3;
        out[first[1].half_edge] = first[0].half_edge / 3;
      });
  return out;
}

}  // namespace flat_detail

FlatFacets::FlatFacets(const TriMesh& mesh, double near_mm)
    : mesh_(mesh), across_(flat_detail::trianglesAcross(mesh)) {
  joinTriangles(near_mm);
  gatherLinks();
  gatherCorners();
}

void FlatFacets::joinTriangles(double near_mm) {
  using namespace flat_detail;
  const std::size_t count = mesh_.triangles.size();
  std::vector<Shape> shapes(count);
  for (std::size_t t = 0; t < count; ++t) shapes[t] = shapeOf(mesh_, t);
  const double firm_mm = kFirm * near_mm;
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  // Firm ones first, then the large ones.
  std::vector<double> rank(count);
  for (std::size_t t = 0; t < count; ++t)
    rank[t] = shapes[t].height() > firm_mm ? shapes[t].area.norm() : -1.0 / (1.0 + shapes[t].area.norm());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rank[a] > rank[b]; });
  of_triangle_.assign(count, kNone);
  std::vector<std::uint32_t> seen(mesh_.positions.size(), kNone), open;
  for (const std::uint32_t seed : order) {
    if (of_triangle_[seed] != kNone) continue;
    const auto number = static_cast<std::uint32_t>(facets_.size());
    FlatFacet facet;
    const bool firm_seed = shapes[seed].height() > firm_mm;
    GrowingPlane plane(point(mesh_.triangles[seed][0]), shapes[seed].area.normalized());
    const auto take = [&](std::uint32_t t) {
      of_triangle_[t] = number;
      facet.normal += shapes[t].area;
      const double area = 0.5 * shapes[t].area.norm();
      facet.area += area;
      for (const std::uint32_t v : mesh_.triangles[t]) {
        facet.middle += area / 3.0 * point(v);
        if (seen[v] == number) continue;
        seen[v] = number;
        plane.add(point(v));
      }
      if (firm_seed) open.push_back(t);
    };
    const auto fits = [&](std::uint32_t t) {
      if (shapes[t].height() > firm_mm) {
        // A triangle that folds back lies in the plane, too.
        const double tilt = near_mm / shapes[t].height();
        if (shapes[t].area.dot(plane.normal()) < (0.99 - 2.0 * tilt) * shapes[t].area.norm()) return false;
      }
      for (const std::uint32_t v : mesh_.triangles[t]) {
        if (seen[v] == number) continue;
        const Vec3 p = point(v);
        if (plane.off(p) > near_mm * (1.0 + plane.doubt(p))) return false;
      }
      return true;
    };
    take(seed);
    for (std::size_t k = 0; k < open.size(); ++k) {
      for (int c = 0; c < 3; ++c) {
        const std::uint32_t next = across_[3 * open[k] + static_cast<std::uint32_t>(c)];
        if (next != kNone && of_triangle_[next] == kNone && fits(next)) take(next);
      }
    }
    open.clear();
    if (facet.area > 0.0) facet.middle /= facet.area;
    facet.normal.normalize();
    facet.firm = firm_seed;
    facets_.push_back(facet);
  }
}

namespace flat_detail {

/// An edge between two facets, seen from either.
struct Edge {
  std::uint32_t facet, other, half_edge;
};

bool plausible(double turn, double chord) {
  return (turn <= kSoftTurn && chord <= kMostSoftChord) || (turn <= kSteepTurn && chord <= kMostSteepChord);
}

}  // namespace flat_detail

void FlatFacets::gatherLinks() {
  using namespace flat_detail;
  std::vector<Edge> edges;
  for (std::uint32_t h = 0; h < across_.size(); ++h) {
    if (across_[h] == kNone) continue;
    const std::uint32_t a = of_triangle_[h / 3], b = of_triangle_[across_[h]];
    if (a != b) edges.push_back({a, b, h});
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.facet != b.facet ? a.facet < b.facet : a.other < b.other;
  });
  first_link_.assign(facets_.size() + 1, 0);
  for (std::size_t i = 0; i < edges.size();) {
    const std::uint32_t f = edges[i].facet, g = edges[i].other;
    FacetLink link;
    link.other = g;
    for (; i < edges.size() && edges[i].facet == f && edges[i].other == g; ++i) {
      const auto& t = mesh_.triangles[edges[i].half_edge / 3];
      const std::uint32_t c = edges[i].half_edge % 3;
      link.length += (point(t[(c + 1) % 3]) - point(t[c])).norm();
    }
    const FlatFacet &a = facets_[f], &b = facets_[g];
    if (a.firm && b.firm && link.length > 0.0) {
      link.turn = std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal));
      const double wide_a = a.area / link.length, wide_b = b.area / link.length;
      const double chord = 0.5 * std::min(wide_a, wide_b) * std::tan(0.25 * link.turn);
      link.smooth = plausible(link.turn, chord);
      link.alike = wide_a < kWidthRatio * wide_b && wide_b < kWidthRatio * wide_a;
    }
    links_.push_back(link);
    ++first_link_[f + 1];
  }
  std::partial_sum(first_link_.begin(), first_link_.end(), first_link_.begin());
}

void FlatFacets::gatherCorners() {
  using namespace flat_detail;
  first_corner_.assign(facets_.size() + 1, 0);
  struct Of {
    std::uint32_t facet, vertex;
    bool on_curve;
  };
  std::vector<Of> all;
  all.reserve(3 * mesh_.triangles.size());
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    const std::uint32_t f = of_triangle_[t];
    std::array<bool, 3> on{};
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t behind = across_[3 * t + c];
      if (behind == kNone || of_triangle_[behind] == f) continue;
      const auto row = links(f);
      const auto link = std::lower_bound(row.begin(), row.end(), of_triangle_[behind],
                                         [](const FacetLink& l, std::uint32_t g) { return l.other < g; });
      if (link->smooth) on[c] = on[(c + 1) % 3] = true;
    }
    for (std::uint32_t c = 0; c < 3; ++c) all.push_back({f, mesh_.triangles[t][c], on[c]});
  }
  std::sort(all.begin(), all.end(), [](const Of& a, const Of& b) {
    return std::tie(a.facet, a.vertex, b.on_curve) < std::tie(b.facet, b.vertex, a.on_curve);
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && all[i].facet == all[i - 1].facet && all[i].vertex == all[i - 1].vertex) continue;
    corners_.push_back({all[i].vertex, all[i].on_curve});
    ++first_corner_[all[i].facet + 1];
  }
  std::partial_sum(first_corner_.begin(), first_corner_.end(), first_corner_.begin());
}

}  // namespace proveout
