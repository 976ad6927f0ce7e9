#include "app/session/machining/stock_bodies.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

/// A closed shell of the surface.
struct Shell {
  double volume_mm3 = 0.0;  ///< negative: a hollow
  Box3 bounds;
};

std::vector<Shell> shellsOf(const TriMesh& mesh) {
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> component = meshComponents(mesh, count);
  std::vector<Shell> shells(count);
  if (mesh.positions.empty()) return shells;
  const Vec3 origin = mesh.positions.front().cast<double>();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Shell& shell = shells[component[t]];
    Vec3 p[3];
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] = mesh.positions[mesh.triangles[t][c]].cast<double>();
      shell.bounds.extend(p[c]);
    }
    shell.volume_mm3 += (p[0] - origin).dot((p[1] - origin).cross(p[2] - origin)) / 6.0;
  }
  return shells;
}

bool contains(const Box3& outer, const Box3& inner) {
  return (outer.min.array() <= inner.min.array()).all() && (outer.max.array() >= inner.max.array()).all();
}

/// How often a shell goes round a point: 1 inside of a piece, -1 in a hollow, 0 outside (A. van Oosterom and
/// J. Strackee, 1983).
std::vector<double> turnsAbout(const TriMesh& mesh, const std::vector<std::uint32_t>& component,
                               std::size_t count, const Vec3& point) {
  std::vector<double> turns(count, 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3 p[3];
    for (std::size_t c = 0; c < 3; ++c) p[c] = mesh.positions[mesh.triangles[t][c]].cast<double>() - point;
    const double a = p[0].norm(), b = p[1].norm(), c = p[2].norm();
    const double over = p[0].dot(p[1].cross(p[2]));
    const double under = a * b * c + p[0].dot(p[1]) * c + p[1].dot(p[2]) * a + p[2].dot(p[0]) * b;
    turns[component[t]] += std::atan2(over, under) / (2.0 * kPi);
  }
  return turns;
}

}  // namespace

std::optional<Box3> pieceAround(const TriMesh& mesh, const Vec3& point) {
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> component = meshComponents(mesh, count);
  const std::vector<Shell> shells = shellsOf(mesh);
  const std::vector<double> turns = turnsAbout(mesh, component, count, point);
  const Shell* around = nullptr;  // the innermost shell that holds the point
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const bool inner = !around || std::abs(shells[k].volume_mm3) < std::abs(around->volume_mm3);
    if (std::abs(turns[k]) > 0.5 && inner) around = &shells[k];
  }
  if (around == nullptr || around->volume_mm3 < 0.0) return std::nullopt;
  return around->bounds;
}

std::vector<StockBody> stockBodies(const TriMesh& mesh, const MeshTopology& topology,
                                   const MeshExtent& extent, double volume_mm3,
                                   const std::optional<Box3>& wanted) {
  if (topology.closedManifold() &&
      topology.components == 1) {  // the usual part; no need to tell shells apart
    if (extent.volume_mm3 > 0) return {{volume_mm3, extent.bounds, "part"}};
  }
  std::vector<Shell> shells = shellsOf(mesh);
  std::vector<StockBody> bodies;
  for (const Shell& shell : shells) {
    if (shell.volume_mm3 > 0) bodies.push_back({shell.volume_mm3, shell.bounds, "loose"});
  }
  for (const Shell& hollow : shells) {
    if (hollow.volume_mm3 > 0) continue;
    StockBody* around = nullptr;  // the smallest body that can hold it
    for (StockBody& body : bodies) {
      const bool smaller = !around || body.bounds.size().prod() < around->bounds.size().prod();
      if (smaller && contains(body.bounds, hollow.bounds)) around = &body;
    }
    if (around) around->volume_mm3 += hollow.volume_mm3;
  }
  const auto larger = [](const StockBody& a, const StockBody& b) { return a.volume_mm3 > b.volume_mm3; };
  std::stable_sort(bodies.begin(), bodies.end(), larger);
  if (bodies.empty()) return bodies;
  if (wanted) {
    const auto off = [&](const StockBody& body) {
      return (body.bounds.min - wanted->min).cwiseAbs().sum() +
             (body.bounds.max - wanted->max).cwiseAbs().sum();
    };
    const auto part =
        std::min_element(bodies.begin(), bodies.end(),
                         [&](const StockBody& a, const StockBody& b) { return off(a) < off(b); });
    std::rotate(bodies.begin(), part, part + 1);
  }
  bodies.front().role = "part";
  for (std::size_t k = 1; k < bodies.size(); ++k) volume_mm3 -= bodies[k].volume_mm3;
  bodies.front().volume_mm3 = volume_mm3;
  return bodies;
}

}  // namespace proveout
