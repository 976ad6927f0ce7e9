#include "app/page/reduced_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/base/parallel_for.h"
#include "core/mesh/mesh_simplifier.h"

namespace proveout {

namespace {

/// Simplifying takes some microseconds a triangle; of larger meshes the vertices are gathered first.
constexpr std::size_t kMostSimplified = 1'500'000;

/// Simplified with ever more tolerance, as far as it can be.
void simplifyTo(std::size_t most, const Progress& progress, ViewMesh& view) {
  const double size = meshBounds(view.mesh).size().norm();
  view.mesh.motion.clear();  // borders between motions do not matter to the eye
  for (double tolerance = 2e-5 * size; view.mesh.triangles.size() > most && tolerance < 4e-3 * size;
       tolerance *= 2.0) {
    const auto done = simplifyMesh(view.mesh, tolerance, progress);
    if (!done) return;
    view.off_mm += done->distance_mm;
  }
}

/// Vertices that share a cell of a grid become the first of them.
TriMesh gatheredIn(const TriMesh& mesh, const Box3& box, double cell_mm) {
  std::unordered_map<std::uint64_t, std::uint32_t> first;
  std::vector<std::uint32_t> place(mesh.positions.size());
  TriMesh out;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
      const double at = static_cast<double>(mesh.positions[v][k]) - box.min[k];
      key = key << 21 | static_cast<std::uint64_t>(std::clamp(at / cell_mm, 0.0, 2'000'000.0));
    }
    const auto [entry, is_new] = first.try_emplace(key, static_cast<std::uint32_t>(out.positions.size()));
    if (is_new) out.positions.push_back(mesh.positions[v]);
    place[v] = entry->second;
  }
  for (const auto& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> moved{place[t[0]], place[t[1]], place[t[2]]};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) out.triangles.push_back(moved);
  }
  return out;
}

void gatherTo(std::size_t most, ViewMesh& view) {
  const Box3 box = meshBounds(view.mesh);
  // A surface of area A has about 2 A / cell^2 triangles.
  double cell = std::sqrt(2.0 * meshArea(view.mesh) / static_cast<double>(most));
  TriMesh gathered = gatheredIn(view.mesh, box, cell);
  while (gathered.triangles.size() > most) gathered = gatheredIn(view.mesh, box, cell *= 1.25);
  view.mesh = std::move(gathered);
  view.off_mm += std::sqrt(3.0) * cell;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;
Edge edgeOf(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// One step of halving: the edges that need it, and the triangles at them anew.
class Halving {
 public:
  Halving(const std::function<float(const Vec3&)>& deviation, double tolerance_mm, double least_mm,
          double longest_mm, ViewMesh& view)
      : deviation_(deviation),
        tolerance_(tolerance_mm),
        least_(least_mm),
        longest_(longest_mm),
        view_(view) {}

  /// Halves edges unless that makes more than `most` triangles; false: none was halved.
  bool run(std::size_t most) {
    findEdges();
    measure();
    const auto chosen = static_cast<std::size_t>(std::count(split_.begin(), split_.end(), 1));
    if (chosen == 0 || view_.mesh.triangles.size() + 2 * chosen > most) return false;
    addMiddles();
    splitTriangles();
    return true;
  }

 private:
  Vec3 at(std::uint32_t v) const { return view_.mesh.positions[v].cast<double>(); }

  void findEdges() {
    for (const auto& t : view_.mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge edge = edgeOf(t[k], t[(k + 1) % 3]);
        if ((at(edge.first) - at(edge.second)).norm() > least_) edges_.push_back(edge);
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  /// Asking for a deviation is dear: it is done where the ends differ, or are so far apart that they say
  /// nothing of the middle.
  void measure() {
    middle_.resize(edges_.size());
    split_.assign(edges_.size(), 0);
    parallelFor(std::size_t{0}, edges_.size(), [&](std::size_t i) {
      const auto [a, b] = edges_[i];
      const float da = view_.deviation_mm[a], db = view_.deviation_mm[b];
      const bool known = std::isfinite(da) && std::isfinite(db);
      const double length = (at(a) - at(b)).norm();
      if (length < 0.4 * longest_ &&
          (known ? std::abs(da - db) <= tolerance_ : std::isfinite(da) == std::isfinite(db)))
        return;
      middle_[i] = deviation_(0.5 * (at(a) + at(b)));
      const bool bends =
          known && std::isfinite(middle_[i]) && std::abs(middle_[i] - 0.5F * (da + db)) > tolerance_;
      const bool ends =
          std::isfinite(da) != std::isfinite(middle_[i]) || std::isfinite(db) != std::isfinite(middle_[i]);
      split_[i] = bends || ends || length > longest_ ? 1 : 0;
    });
  }

  void addMiddles() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (split_[i] == 0) continue;
      const auto [a, b] = edges_[i];
      vertex_.emplace(edges_[i], static_cast<std::uint32_t>(view_.mesh.positions.size()));
      view_.mesh.positions.emplace_back(0.5F * (view_.mesh.positions[a] + view_.mesh.positions[b]));
      view_.deviation_mm.push_back(middle_[i]);
    }
  }

  void splitTriangles() {
    std::vector<std::array<std::uint32_t, 3>> made;
    for (const auto& t : view_.mesh.triangles) splitTriangle(t, made);
    view_.mesh.triangles = std::move(made);
  }

  std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) const {
    const auto found = vertex_.find(edgeOf(a, b));
    return found == vertex_.end() ? kWhole : found->second;
  }

  void splitTriangle(std::array<std::uint32_t, 3> t, std::vector<std::array<std::uint32_t, 3>>& out) const {
    std::array<std::uint32_t, 3> m{middleOf(t[0], t[1]), middleOf(t[1], t[2]), middleOf(t[2], t[0])};
    const auto halves = std::count_if(m.begin(), m.end(), [](std::uint32_t v) { return v != kWhole; });
    // Turned so that the first edge is halved, and of two the first two are.
    while (halves > 0 && (m[0] == kWhole || (halves == 2 && m[1] == kWhole))) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if (halves == 0) {
      out.push_back(t);
    } else if (halves == 1) {
      out.insert(out.end(), {{t[0], m[0], t[2]}, {m[0], t[1], t[2]}});
    } else if (halves == 2) {
      out.insert(out.end(), {{m[0], t[1], m[1]}, {t[0], m[0], m[1]}, {t[0], m[1], t[2]}});
    } else {
      out.insert(out.end(), {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
    }
  }

  static constexpr std::uint32_t kWhole = 0xFFFFFFFFU;
  const std::function<float(const Vec3&)>& deviation_;
  double tolerance_, least_, longest_;
  ViewMesh& view_;
  std::vector<Edge> edges_;
  std::vector<float> middle_;  ///< deviation by edge
  std::vector<std::uint8_t> split_;
  std::map<Edge, std::uint32_t> vertex_;
};

}  // namespace

ViewMesh reducedMesh(const TriMesh& mesh, std::size_t most, const Progress& progress) {
  ViewMesh view{mesh, {}, 0.0, mesh.triangles.size()};
  if (mesh.triangles.size() <= most) return view;
  if (mesh.triangles.size() <= kMostSimplified && analyseTopology(mesh).closedManifold())
    simplifyTo(most, progress, view);
  if (view.mesh.triangles.size() > most + most / 4) gatherTo(most, view);
  return view;
}

void addDeviations(const std::function<float(const Vec3&)>& deviation, double tolerance_mm, std::size_t most,
                   ViewMesh& view) {
  const bool measured = view.deviation_mm.size() == view.mesh.positions.size();
  view.deviation_mm.resize(view.mesh.positions.size());
  if (!measured)
    parallelFor(std::size_t{0}, view.mesh.positions.size(), [&](std::size_t v) {
      view.deviation_mm[v] = deviation(view.mesh.positions[v].cast<double>());
    });
  const double size = meshBounds(view.mesh).size().norm();
  for (int step = 0; step < 12; ++step) {
    if (!Halving(deviation, tolerance_mm, 2e-3 * size, size / 40.0, view).run(most)) return;
  }
}

}  // namespace proveout
