#include "removal/surface_splits.h"

#include <algorithm>

namespace proveout {

namespace {

/// Fraction of a crossed edge, or its middle. The edge may start below the leaf.
double crossingOn(const SurfaceGrid& grid, const SurfaceLeaf& leaf, int axis, const Eigen::Vector3i& at) {
  const int below = (at.x() < 0) | (at.y() < 0) << 1 | (at.z() < 0) << 2;
  const int above = (at.x() > 7) | (at.y() > 7) << 1 | (at.z() > 7) << 2;
  const std::int32_t number = below != 0 ? leaf.lower[below] : leaf.upper[above];
  if (number < 0 || (below != 0 && above != 0)) return 0.5;
  const SurfaceLeaf& there = grid.leaves()[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!there.edges.isCrossed(axis, x, y, z)) return 0.5;
  return there.stock->crossings[static_cast<std::size_t>(there.edges.indexOf(axis, x, y, z))].t;
}

}  // namespace

SplitQuad splitQuad(const SurfaceGrid& grid, const SurfaceLeaf& leaf, int axis, int x, int y, int z,
                    const Quad& quad, const Crossing& c) {
  const Stock::Impl& impl = grid.impl();
  const auto position = [&](const Vec3& p) {
    return Eigen::Vector3f((impl.position(leaf.stock->origin) + impl.h * p).cast<float>());
  };
  SplitQuad out{quad.v, c.motion, position(quad.middle), {}};
  const bool start_in = leafSample(leaf.stock->material, x, y, z);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (int after = 0; after < 4; ++after) {
    if (!(quad.split >> after & 1)) continue;
    const int i = start_in ? after : (6 - after) % 4, j = (i + 1) % 4;  // cells in the order of kRing
    const int cross = kRing[i][0] != kRing[j][0] ? u : v, other = cross == u ? v : u;
    const int back = other == u ? kRing[i][0] : kRing[i][1];
    Eigen::Vector3i face(x, y, z), material = face;
    face[other] -= back;
    if (!start_in) ++material[axis];
    Eigen::Vector3i edge = material;  // the crossed edge along `other` at the material corner, in this face
    edge[other] -= back;
    Vec3 end = edge.cast<double>();
    end[other] += crossingOn(grid, leaf, other, edge);
    const Coord& o = leaf.stock->origin;
    out.faces.push_back({after,
                         {face.x() + o.x(), face.y() + o.y(), face.z() + o.z(), cross, material.x() + o.x(),
                          material.y() + o.y(), material.z() + o.z()},
                         position(0.5 * (quad.middle + end))});
  }
  return out;
}

}  // namespace proveout
