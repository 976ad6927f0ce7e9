// How far meshes are from each other, by samples: it knows nothing of how one was made of the other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/mesh/triangle_tree.h"

namespace proveout::test {

/// Largest distance of a mesh from another, mm: at its corners, in the middle of its edges and at `points`
/// places in each of its triangles.
inline double farthest(const TriMesh& from, const TriMesh& to, int points, std::mt19937& random) {
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const SurfaceMesh surface = toSurface(from);
  const TriangleTree tree(toSurface(to));
  double most = 0.0;
  const auto look = [&](const Vec3& p) { most = std::max(most, tree.nearest(p).squared); };
  for (const Vec3& p : surface.points) look(p);
  for (const auto& t : surface.triangles) {
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    if (t[0] < t[1]) look(0.5 * (a + b));
    if (t[1] < t[2]) look(0.5 * (b + c));
    if (t[2] < t[0]) look(0.5 * (c + a));
    for (int i = 0; i < points; ++i) {
      const double root = std::sqrt(part(random)), along = part(random);
      look((1.0 - root) * a + root * ((1.0 - along) * b + along * c));
    }
  }
  return std::sqrt(most);
}

/// Holds a simplified mesh against the one of all cells, both ways.
inline void expectNear(const TriMesh& all, const TriMesh& lean, double most_mm) {
  constexpr int kPoints = 2;
  std::mt19937 random(1);
  EXPECT_LE(farthest(all, lean, kPoints, random), most_mm);
  EXPECT_LE(farthest(lean, all, 4 * kPoints, random), most_mm);
}

}  // namespace proveout::test
