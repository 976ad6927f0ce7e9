#include "app/page/shape_mesh.h"

#include <cmath>

namespace proveout {
namespace {

constexpr std::uint32_t kFacets = 64;

void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, TriMesh& mesh) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

TriMesh meshOfBox(const Box3& box) {
  TriMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.positions.push_back(Vec3((k & 1) != 0 ? box.max.x() : box.min.x(),
                                  (k & 2) != 0 ? box.max.y() : box.min.y(),
                                  (k & 4) != 0 ? box.max.z() : box.min.z())
                                 .cast<float>());
  quad(0, 2, 3, 1, mesh);
  quad(4, 5, 7, 6, mesh);
  quad(0, 1, 5, 4, mesh);
  quad(2, 6, 7, 3, mesh);
  quad(0, 4, 6, 2, mesh);
  quad(1, 3, 7, 5, mesh);
  return mesh;
}

/// Rings of points at both ends, outside and, of a tube, inside; else the middles of the ends.
TriMesh meshOfCylinder(const CylinderShape& shape) {
  TriMesh mesh;
  const int u = (shape.axis + 1) % 3, v = (shape.axis + 2) % 3;
  const auto ring = [&](double radius, double height) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t k = 0; k < kFacets; ++k) {
      const double angle = 2.0 * kPi * k / kFacets;
      Vec3 p = shape.base;
      p[shape.axis] += height;
      p[u] += radius * std::cos(angle);
      p[v] += radius * std::sin(angle);
      mesh.positions.push_back(p.cast<float>());
    }
    return first;
  };
  const std::uint32_t low = ring(shape.radius, 0.0), high = ring(shape.radius, shape.length),
                      low_in = ring(shape.inner_radius, 0.0),
                      high_in = ring(shape.inner_radius, shape.length);
  for (std::uint32_t k = 0; k < kFacets; ++k) {
    const std::uint32_t n = (k + 1) % kFacets;
    quad(low + k, low + n, high + n, high + k, mesh);
    quad(high + k, high + n, high_in + n, high_in + k, mesh);
    quad(low_in + k, low_in + n, low + n, low + k, mesh);
    if (shape.inner_radius > 0.0) quad(high_in + k, high_in + n, low_in + n, low_in + k, mesh);
  }
  return mesh;
}

}  // namespace

std::optional<TriMesh> meshOfShape(const StockShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return meshOfBox({box->min, box->max});
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return meshOfCylinder(*cylinder);
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return mesh->mesh;
  return std::nullopt;
}

void appendMesh(const TriMesh& more, TriMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& t : more.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace proveout
