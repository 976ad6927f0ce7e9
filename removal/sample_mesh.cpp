#include "removal/sample_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace proveout {
namespace sample_detail {

using Indices = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNotSplit = 0xFFFFFFFFu;

/// Triangles after splitting, estimated: by area, and by length for those that are thinner than the spacing.
double estimateTriangles(const TriMesh& mesh, double spacing) {
  double count = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>();
    const Vec3 b = mesh.positions[t[1]].cast<double>();
    const Vec3 c = mesh.positions[t[2]].cast<double>();
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    count += std::max(1.0, 4.0 * area / (spacing * spacing) + 2.0 * longest / spacing);
  }
  return count;
}

class Splitter {
 public:
  Splitter(SampleMesh& mesh, double spacing) : mesh_(mesh), limit_(spacing * spacing) {}

  /// Splits every long edge once. Returns the triangles that may need more; the others go to the mesh.
  void run(std::vector<Indices> open, std::vector<std::uint32_t> parents) {
    while (!open.empty()) {
      std::vector<Indices> next;
      std::vector<std::uint32_t> next_parents;
      middle_.clear();
      for (std::size_t i = 0; i < open.size(); ++i) {
        const Indices& t = open[i];
        const Indices m = {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
        if (m[0] == kNotSplit && m[1] == kNotSplit && m[2] == kNotSplit) {
          mesh_.surface.triangles.push_back(t);
          mesh_.parent.push_back(parents[i]);
          continue;
        }
        divide(t, m, next);
        next_parents.resize(next.size(), parents[i]);
      }
      open = std::move(next);
      parents = std::move(next_parents);
    }
  }

 private:
  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    auto& points = mesh_.surface.points;
    if ((points[a] - points[b]).squaredNorm() <= limit_) return kNotSplit;
    const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [place, is_new] = middle_.try_emplace(key, static_cast<std::uint32_t>(points.size()));
    if (is_new) points.push_back(0.5 * (points[a] + points[b]));
    return place->second;
  }

  void divide(const Indices& t, const Indices& m, std::vector<Indices>& out) const {
    const int splits = (m[0] != kNotSplit) + (m[1] != kNotSplit) + (m[2] != kNotSplit);
    if (splits == 3) {
      out.insert(out.end(),
                 {Indices{t[0], m[0], m[2]}, Indices{m[0], t[1], m[1]}, Indices{m[2], m[1], t[2]}, m});
      return;
    }
    // Turn so that the split edge is the first one (one split), or the whole edge the last one (two).
    int turn = 0;
    if (splits == 1) {
      while (m[turn] == kNotSplit) ++turn;
    } else {
      while (m[(turn + 2) % 3] != kNotSplit) ++turn;
    }
    const std::uint32_t a = t[turn], b = t[(turn + 1) % 3], c = t[(turn + 2) % 3];
    const std::uint32_t ab = m[turn], bc = m[(turn + 1) % 3];
    if (splits == 1) {
      out.insert(out.end(), {Indices{a, ab, c}, Indices{ab, b, c}});
      return;
    }
    out.push_back({ab, b, bc});
    const auto& p = mesh_.surface.points;
    if ((p[a] - p[bc]).squaredNorm() <= (p[ab] - p[c]).squaredNorm()) {
      out.insert(out.end(), {Indices{a, ab, bc}, Indices{a, bc, c}});
    } else {
      out.insert(out.end(), {Indices{a, ab, c}, Indices{ab, bc, c}});
    }
  }

  SampleMesh& mesh_;
  double limit_;
  std::unordered_map<std::uint64_t, std::uint32_t> middle_;
};

}  // namespace sample_detail

SampleMesh makeSampleMesh(const TriMesh& mesh, double spacing_mm, std::size_t max_triangles) {
  SampleMesh out;
  out.spacing_mm = spacing_mm;
  const double limit =
      std::max(static_cast<double>(max_triangles), 1.5 * static_cast<double>(mesh.triangles.size()));
  while (sample_detail::estimateTriangles(mesh, out.spacing_mm) > limit) out.spacing_mm *= 1.25;
  out.surface.points.reserve(mesh.positions.size());
  for (const auto& p : mesh.positions) out.surface.points.push_back(p.cast<double>());
  std::vector<std::uint32_t> parents(mesh.triangles.size());
  for (std::uint32_t i = 0; i < parents.size(); ++i) parents[i] = i;
  sample_detail::Splitter(out, out.spacing_mm).run(mesh.triangles, std::move(parents));
  return out;
}

}  // namespace proveout
