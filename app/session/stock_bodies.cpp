#include "app/session/stock_bodies.h"

#include <Eigen/Geometry>
#include <algorithm>

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

}  // namespace

std::vector<StockBody> stockBodies(const TriMesh& mesh, const MeshTopology& topology,
                                   const MeshExtent& extent, double volume_mm3) {
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
  bodies.front().role = "part";
  for (std::size_t k = 1; k < bodies.size(); ++k) volume_mm3 -= bodies[k].volume_mm3;
  bodies.front().volume_mm3 = volume_mm3;
  return bodies;
}

}  // namespace proveout
