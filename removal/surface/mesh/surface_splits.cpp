#include "removal/surface/mesh/surface_splits.h"

#include <algorithm>

#include "core/geometry/to_float.h"

namespace proveout {

namespace {

/// A face of cells between two corners of a quad, and the quad's edge in it.
struct Face {
  Coord at;         ///< voxel of its lowest corner
  int cross, axis;  ///< axis across it, and of the quad's edge
  int back;         ///< 1 where that edge is the farther of two along `axis`
  int material;     ///< 1 where the edge's far end is in material

  int other() const { return 3 - cross - axis; }
};

struct FaceEdge {
  int axis;
  Coord at;
};

/// An edge of the face: of the two along `axis`, the near (0) or the far one (1) along `along`.
FaceEdge edgeOf(const Face& face, int axis, int along, int far) {
  Coord at = face.at;
  at[along] += far;
  return {axis, at};
}

/// The edge that the surface leads to in the face. With four crossed edges that is the one at the same
/// material corner; in a `joined` face, the one at the same corner that is not material.
FaceEdge farEdge(const SurfaceGrid& grid, const Face& face, bool joined, bool& sole) {
  const int other = face.other();
  const FaceEdge opposite = edgeOf(face, face.axis, other, 1 - face.back),
                 at_material = edgeOf(face, other, face.axis, face.material),
                 at_air = edgeOf(face, other, face.axis, 1 - face.material);
  const auto crossed = [&](const FaceEdge& e) { return grid.isCrossed(e.axis, e.at); };
  sole = !(crossed(opposite) && crossed(at_material) && crossed(at_air));
  if (!sole && joined) return at_air;
  if (crossed(at_material)) return at_material;
  return crossed(opposite) ? opposite : at_air;
}

/// The place of the vertex between the quad's crossing and the one that the surface leads to, in grid steps
/// from the face's corner. `sole`: no other surface goes through the face.
FaceSplit splitFace(const SurfaceGrid& grid, const Face& face, Vec3& place, bool& sole) {
  const std::optional<std::uint32_t> cell = grid.cellAt(face.at);
  const bool joined = cell && isJoined(grid.shape(*cell), face.cross, 0);
  const FaceEdge own = edgeOf(face, face.axis, face.other(), face.back),
                 end = farEdge(grid, face, joined, sole);
  const auto placeOn = [&](const FaceEdge& e) {
    Vec3 p = stepsBetween(face.at, e.at);
    p[e.axis] += grid.crossingOn(e.axis, e.at);
    return p;
  };
  place = 0.5 * (placeOn(own) + placeOn(end));
  FaceSplit out;
  Coord corner = face.at;
  if (!sole) {
    corner[face.other()] += face.back;
    corner[face.axis] += joined ? 1 - face.material : face.material;
  }
  out.key = {face.at.x(), face.at.y(), face.at.z(), face.cross, corner.x(), corner.y(), corner.z()};
  return out;
}

/// Where the line between the vertices of two cells goes through the face between them, clamped to the face;
/// in grid steps from the face's corner, as the vertices are.
Vec3 passage(const Vec3& from, const Vec3& to, int cross) {
  const double across = to[cross] - from[cross];
  const double part = std::abs(across) < kEndGap ? 0.5 : std::clamp(-from[cross] / across, 0.0, 1.0);
  Vec3 p = (from + part * (to - from)).cwiseMax(kEndGap).cwiseMin(1.0 - kEndGap);
  p[cross] = 0.0;
  return p;
}

}  // namespace

SplitQuad splitQuad(const SurfaceGrid& grid, const SurfaceLeaf& leaf, int axis, int x, int y, int z,
                    const Quad& quad, const Crossing& c) {
  const Stock::Impl& impl = grid.impl();
  Vec3 middle(x, y, z);
  middle[axis] += std::clamp<double>(c.t, kEndGap, 1.0 - kEndGap);
  SplitQuad out{
      quad.v, knownMotion(c.motion), toFloat(impl.position(leaf.stock->origin) + impl.h * middle), {}};
  const bool start_in = leafSample(leaf.stock->material(), x, y, z);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (int after = 0; after < 4; ++after) {
    if (!(quad.split >> after & 1)) continue;
    const int i = start_in ? after : (6 - after) % 4, j = (i + 1) % 4;  // cells in the order of kRing
    const int cross = kRing[i][0] != kRing[j][0] ? u : v, other = cross == u ? v : u;
    const int back = other == u ? kRing[i][0] : kRing[i][1];
    Face face{leaf.stock->origin.offsetBy(x, y, z), cross, axis, back, start_in ? 0 : 1};
    face.at[other] -= back;
    Vec3 place;
    bool sole = false;
    FaceSplit split = splitFace(grid, face, place, sole);
    const std::array<std::uint32_t, 2> cells = {grid.cellOf(quad.v[after]),
                                                grid.cellOf(quad.v[(after + 1) % 4])};
    const auto traits = static_cast<std::uint16_t>(grid.traits(cells[0]) | grid.traits(cells[1]));
    // Two lines through one face may join the same vertices, and would go through it at the same place.
    if (sole && (traits & CellTraits::kManySheets) == 0 && (traits & CellTraits::kWalled) != 0) {
      const Vec3 corner = stepsBetween(leaf.stock->origin, face.at);
      place = passage(quad.p[after] - corner, quad.p[(after + 1) % 4] - corner, cross);
    }
    split.p = toFloat(impl.position(face.at) + impl.h * place);
    split.after = after;
    out.faces.push_back(split);
  }
  return out;
}

}  // namespace proveout
