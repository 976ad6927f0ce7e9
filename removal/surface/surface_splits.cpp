#include "removal/surface/surface_splits.h"

#include <algorithm>

namespace proveout {

namespace {

/// Vertices on edges keep this far from the ends (in cells), so that those of several edges never coincide.
constexpr double kEndGap = 1e-3;

/// Fraction of the edge along `axis` from voxel `at` (of the whole grid) at which it is crossed; its middle
/// where it is not, which no sound stock has.
double crossingOn(const SurfaceGrid& grid, int axis, const Coord& at) {
  const std::int32_t number = LeafReader(grid.impl()).state(at & ~7);
  if (number < 0) return 0.5;
  const SurfaceLeaf& leaf = grid.leaves()[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!leaf.edges.isCrossed(axis, x, y, z)) return 0.5;
  const auto i = static_cast<std::size_t>(leaf.edges.indexOf(axis, x, y, z));
  return std::clamp<double>(leaf.stock->crossings[i].t, kEndGap, 1.0 - kEndGap);
}

/// A face of cells between two corners of a quad, and the quad's edge in it.
struct Face {
  Coord at;         ///< voxel of its lowest corner
  int cross, axis;  ///< axis across it, and of the quad's edge
  int back;         ///< 1 where that edge is the farther of two along `axis`
  int material;     ///< 1 where the edge's far end is in material
};

/// Its place between the quad's crossing and the one that the surface leads to in the face, which is at the
/// same material corner.
FaceSplit splitFace(const SurfaceGrid& grid, const Face& face) {
  const int other = 3 - face.cross - face.axis;
  struct Edge {
    int axis;
    Coord at;
    double t;
  };
  const auto edge = [&](int axis, int along, int far) {
    Coord at = face.at;
    at[along] += far;
    return Edge{axis, at, crossingOn(grid, axis, at)};
  };
  const Edge own = edge(face.axis, other, face.back), end = edge(other, face.axis, face.material);
  const auto place = [&](const Edge& e) {
    Vec3 p(e.at.x() - face.at.x(), e.at.y() - face.at.y(), e.at.z() - face.at.z());
    p[e.axis] += e.t;
    return p;
  };
  FaceSplit out;
  Coord corner = face.at;
  corner[other] += face.back;
  corner[face.axis] += face.material;
  out.key = {face.at.x(), face.at.y(), face.at.z(), face.cross, corner.x(), corner.y(), corner.z()};
  out.p = (grid.impl().position(face.at) + grid.impl().h * 0.5 * (place(own) + place(end))).cast<float>();
  return out;
}

}  // namespace

SplitQuad splitQuad(const SurfaceGrid& grid, const SurfaceLeaf& leaf, int axis, int x, int y, int z,
                    const Quad& quad, const Crossing& c) {
  const Stock::Impl& impl = grid.impl();
  Vec3 middle(x, y, z);
  middle[axis] += std::clamp<double>(c.t, kEndGap, 1.0 - kEndGap);
  SplitQuad out{
      quad.v, knownMotion(c.motion), (impl.position(leaf.stock->origin) + impl.h * middle).cast<float>(), {}};
  const bool start_in = leafSample(leaf.stock->material(), x, y, z);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (int after = 0; after < 4; ++after) {
    if (!(quad.split >> after & 1)) continue;
    const int i = start_in ? after : (6 - after) % 4, j = (i + 1) % 4;  // cells in the order of kRing
    const int cross = kRing[i][0] != kRing[j][0] ? u : v, other = cross == u ? v : u;
    const int back = other == u ? kRing[i][0] : kRing[i][1];
    Face face{leaf.stock->origin.offsetBy(x, y, z), cross, axis, back, start_in ? 0 : 1};
    face.at[other] -= back;
    FaceSplit split = splitFace(grid, face);
    split.after = after;
    out.faces.push_back(split);
  }
  return out;
}

}  // namespace proveout
