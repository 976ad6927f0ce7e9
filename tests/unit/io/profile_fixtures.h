// A turned shaft as a half section and as a mesh.
#pragma once

#include <cmath>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout::io_test {

/// Shaft along Z, steps 10 x 0..20, 15 x 20..40, with the axis; (r, z), material on the left.
inline std::vector<Vec2> shaftLoop() { return {{0, 0}, {10, 0}, {10, 20}, {15, 20}, {15, 40}, {0, 40}}; }

/// The same with a groove 0.05 mm deep and 2 mm wide about z = 12.
inline std::vector<Vec2> gougedLoop() {
  return {{0, 0}, {10, 0}, {10, 11}, {9.95, 11}, {9.95, 13}, {10, 13}, {10, 20}, {15, 20}, {15, 40}, {0, 40}};
}

/// Closed mesh of a loop (material on its left) turned about Z; points on the axis stay one vertex each.
inline TriMesh turned(const std::vector<Vec2>& loop, std::uint32_t sides) {
  TriMesh mesh;
  std::vector<std::uint32_t> first;
  for (const Vec2& p : loop) {
    first.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    for (std::uint32_t i = 0; i < (p.x() > 0 ? sides : 1); ++i) {
      const double a = 2 * kPi * i / sides;
      mesh.positions.push_back(Vec3(p.x() * std::cos(a), p.x() * std::sin(a), p.y()).cast<float>());
    }
  }
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t next = (k + 1) % loop.size();
    const bool axis_from = loop[k].x() == 0, axis_to = loop[next].x() == 0;
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t j = (i + 1) % sides;
      const std::uint32_t a = first[k] + (axis_from ? 0 : i), b = first[k] + (axis_from ? 0 : j);
      const std::uint32_t c = first[next] + (axis_to ? 0 : j), d = first[next] + (axis_to ? 0 : i);
      if (!axis_from) mesh.triangles.push_back({a, b, c});
      if (!axis_to) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

}  // namespace proveout::io_test
