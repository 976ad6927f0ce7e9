// The quads around crossed edges: the faces of the dual mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "removal/surface/cell/surface_grid.h"

namespace proveout {

/// The quad around a crossed edge. Corners are CCW from outside; lengths in the units of the edge's leaf.
struct Quad {
  std::array<std::uint32_t, 4> v;  ///< vertex numbers of the grid
  std::array<Vec3, 4> p;
  Vec3 middle;                  ///< the crossing
  Vec3 normal;                  ///< there, unit to 1e-4
  std::uint16_t traits;         ///< of its cells, one or the other
  std::uint8_t smooth_corners;  ///< see cutQuad
  std::uint8_t split;           ///< bit i: the face between corners i and i + 1 gets a vertex of its own
};

/// Cut of a quad along a diagonal.
struct QuadCut {
  bool at02 = true;
  double margin = 1.0;  ///< of the worse triangle; above 0: not folded
  bool poor = false;    ///< one leans more than 60 degrees from the exact surface, or is a sliver
};
/// The diagonal whose middle is nearer to the tangent plane at the crossing, so that feature edges are
/// followed and walls not cut; if both are equally near, the shorter one. The other diagonal where it folds
/// less. `smooth_corners`: bit i: no feature edge runs through the cell of corner i.
QuadCut cutQuad(const std::array<Vec3, 4>& p, const Vec3& middle, const Vec3& normal,
                unsigned smooth_corners);

/// Least distance that crossings may be off two triangles, grid steps.
inline constexpr double kFanHeight = 0.005;

/// By how much the crossing lies off the quad's two triangles, if that is more than `limit`, or kFanHeight
/// at feature edges; else 0. Four triangles around it are closer to the surface then. 0 as well where a
/// feature edge runs along the diagonal, or a triangle would fold.
double bulgeOver(const Quad& quad, double limit);

/// Reads the quads of one leaf at a time.
class QuadReader {
 public:
  explicit QuadReader(const SurfaceGrid& grid) : grid_(grid) {}
  void load(const SurfaceLeaf& leaf);
  /// The cells around the edge, whatever their order and sheets. False where one is missing, which no sound
  /// stock has.
  bool cells(int axis, int x, int y, int z, Quad& quad) const;
  /// All but positions, middle and normal. Requires that no cell is missing.
  void readCorners(int axis, int x, int y, int z, Quad& quad) const;
  /// Sets middle and normal.
  static void readCrossing(int axis, int x, int y, int z, const Crossing& c, Quad& quad);
  /// All of it.
  bool read(int axis, int x, int y, int z, const Crossing& c, Quad& quad) const;
  /// Directions (unit, either way) of the feature edges that the corners of a quad, which was read, are on;
  /// 0 where they are not known. Requires loadFeatureEdges after load.
  std::array<Vec3, 4> featureEdgesOf(const Quad& quad, int axis, int x, int y, int z) const;
  void loadFeatureEdges();
  /// The leaf in whose units lengths are.
  const SurfaceLeaf& leaf() const { return *leaf_; }

 private:
  static int index(int x, int y, int z) { return ((x + 1) * 9 + y + 1) * 9 + z + 1; }
  template <typename Use>
  void forEachLeaf(const Use& use) const;
  void add(const SurfaceLeaf& leaf, int place);
  void addFeatureEdges(const SurfaceLeaf& leaf, int place);
  /// Indices of the cells around an edge, in the order of kRing.
  static std::array<int, 4> ring(int axis, int x, int y, int z);
  void arrange(int axis, int x, int y, int z, Quad& quad) const;
  void pickSheets(int axis, int x, int y, int z, bool start_in, Quad& quad) const;

  static constexpr std::uint32_t kNoCell = 0xFFFFFFFFu;
  const SurfaceGrid& grid_;
  const SurfaceLeaf* leaf_ = nullptr;
  std::array<std::uint32_t, 729> number_;
  std::array<std::uint16_t, 729> traits_;
  std::array<Eigen::Vector3f, 729> p_;
  std::vector<Eigen::Vector3f> feature_edges_;      ///< of the cells around the leaf
  std::array<std::uint16_t, 729> feature_edge_at_;  ///< numbers from 1 in there; 0: none
};

/// Calls body(axis, x, y, z, crossing) for each crossed edge of the leaf.
template <typename Body>
void forEachCrossing(const SurfaceLeaf& leaf, Body&& body) {
  const Crossing* c = leaf.stock->crossings.data();
  forEachEdge(leaf.edges, [&](int axis, int x, int y, int z) { body(axis, x, y, z, *c++); });
}

/// Repairs folds: puts vertices that left their cell back into it where they fold the surface.
void repairFolds(SurfaceGrid& grid);

/// CCW about +axis: what to step back along the next axis and the one after it to the cells of an edge.
inline constexpr int kRing[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};

}  // namespace proveout
