// Small meshes and picture measures shared by the renderer's tests.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/mesh/image.h"
#include "core/mesh/tri_mesh.h"

namespace proveout::test {

/// Closed box, outward.
inline TriMesh boxMesh(const Vec3& lo, const Vec3& hi) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Vec3 p((i & 1) ? hi.x() : lo.x(), (i & 2) ? hi.y() : lo.y(), (i & 4) ? hi.z() : lo.z());
    mesh.positions.push_back(p.cast<float>());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Closed cylinder along z with `sides` facets.
inline TriMesh cylinderMesh(double radius, double height, int sides) {
  TriMesh mesh;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * kPi * i / sides;
    for (const double z : {0.0, height}) {
      mesh.positions.push_back(Vec3(radius * std::cos(a), radius * std::sin(a), z).cast<float>());
    }
  }
  const auto n = static_cast<std::uint32_t>(2 * sides);
  mesh.positions.push_back(Vec3(0, 0, 0).cast<float>());
  mesh.positions.push_back(Vec3(0, 0, height).cast<float>());
  for (std::uint32_t i = 0; i < n; i += 2) {
    const std::uint32_t j = (i + 2) % n;
    mesh.triangles.push_back({i, j, j + 1});
    mesh.triangles.push_back({i, j + 1, i + 1});
    mesh.triangles.push_back({n, j, i});
    mesh.triangles.push_back({n + 1, i + 1, j + 1});
  }
  return mesh;
}

/// Closed stairs of two steps: their outline in x and z along y, turned so that no edge runs along the
/// pixels.
inline TriMesh stairMesh(double length) {
  const std::vector<Vec2> outline{{0, 0}, {30, 0}, {30, 6}, {20, 6}, {20, 12}, {10, 12}, {10, 18}, {0, 18}};
  const auto n = static_cast<std::uint32_t>(outline.size());
  TriMesh mesh;
  const Eigen::AngleAxisd turn(0.3, Vec3::UnitZ());
  for (const double y : {0.0, length}) {
    for (const Vec2& p : outline) mesh.positions.push_back((turn * Vec3(p.x(), y, p.y())).cast<float>());
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, i + n, j + n});
    mesh.triangles.push_back({i, j + n, j});
  }
  for (const auto& [a, b, c] : std::vector<std::array<std::uint32_t, 3>>{
           {0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}, {0, 5, 7}, {5, 6, 7}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a + n, c + n, b + n});
  }
  return mesh;
}

inline std::array<int, 3> pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgb[(static_cast<std::size_t>(y) * image.width + x) * 3];
  return {p[0], p[1], p[2]};
}

inline int colorDistance(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace proveout::test
