// The cells that the surface runs through: one vertex a cell and sheet.
//
// A cell belongs to the leaf of its lowest corner and has that corner's place. Inside a leaf, lengths are in
// grid steps from the leaf's first sample ("leaf units").
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "removal/grid/stock_impl.h"
#include "removal/surface/cell/cell_cycles.h"
#include "removal/surface/cell/cell_vertex.h"
#include "removal/surface/cell/surface_clusters.h"

namespace proveout {

/// From one voxel or leaf to another, grid steps.
inline Vec3 stepsBetween(const Coord& from, const Coord& to) {
  return {static_cast<double>(to.x() - from.x()), static_cast<double>(to.y() - from.y()),
          static_cast<double>(to.z() - from.z())};
}

/// Vertex of a further sheet of a cell; the first sheet's is in the cell's own place.
struct ExtraVertex {
  std::uint16_t cell = 0;  ///< rank of the cell in its leaf
  std::uint8_t sheet = 1;
  Eigen::Vector3f p;  ///< leaf units
};

/// A vertex that is outside its cell.
struct OutsideVertex {
  std::uint16_t place = 0;  ///< of the cell: z * 64 + leafBit(x, y)
  Eigen::Vector3f inside;   ///< where it is put if it folds the surface; leaf units
  bool off = false;         ///< whether it is off the surface there
};

/// Where a step lower than a cell runs through one; see LowStep.
struct StepCell {
  std::uint16_t cell = 0;     ///< rank of the cell in its leaf
  Eigen::Vector3f low, high;  ///< leaf units
  std::uint32_t motion = 0;
};

/// The direction of the feature edge that a vertex is on.
struct FeatureEdgeDirection {
  std::uint16_t place = 0;  ///< of the cell, as in OutsideVertex
  bool outside = false;     ///< known where the vertex is outside its cell, unless it was put back
  Eigen::Vector3f along;    ///< unit, either way
};

/// States that all surface of a leaf is a level piece of one face: one layer of equal crossings across an
/// axis.
struct LevelFace {
  std::int8_t axis = -1, layer = 0;  ///< -1: that does not hold
  bool material_below = false;
  Crossing crossing;
  bool operator==(const LevelFace&) const = default;
};

/// How far the vertex of a cell is off the surface of one of its faces, at most.
struct OffVertex {
  float off = 0.0f;         ///< cells
  std::uint16_t place = 0;  ///< of the cell, as in OutsideVertex
};

struct SurfaceLeaf {
  const StockLeaf* stock = nullptr;
  LeafEdges edges;
  LeafBits mixed{};                           ///< cells with surface
  std::array<std::uint16_t, 8> first_cell{};  ///< rank of the layer's first such cell
  std::uint16_t cells = 0;
  /// Numbers of the leaves around, -1 where none: bit 0 of the place: one step along x, 1: y, 2: z.
  std::array<std::int32_t, 8> upper{}, lower = {-1, -1, -1, -1, -1, -1, -1, -1};
  std::uint32_t base = 0;        ///< vertex number of its first cell
  std::uint32_t extra_base = 0;  ///< vertex number of its first extra vertex
  std::vector<ExtraVertex> extra;
  std::vector<OutsideVertex> outside;
  std::vector<StepCell> steps;
  OffVertex farthest;                               ///< of its vertices
  double hidden = 0.0;                              ///< sum of CellVertex::lifted over its cells
  std::vector<FeatureEdgeDirection> feature_edges;  ///< those that are known, of cells with one sheet
  LeafClusters clusters;
  LevelFace level;
  bool all_level = false;  ///< the vertices of all cells are on the level face, in the middle of their cells

  /// Number of the cell among those of the leaf.
  int rank(int x, int y, int z) const {
    return first_cell[z] + countBits(mixed[z] & ((1ull << leafBit(x, y)) - 1));
  }
  /// Number of the cell at a place (z * 64 + leafBit(x, y)).
  std::uint32_t cellAt(int place) const {
    return base + static_cast<std::uint32_t>(rank(place >> 3 & 7, place & 7, place >> 6));
  }
  /// The place of a cell.
  int placeOf(int cell_rank) const {
    int z = 7;
    while (first_cell[z] > cell_rank) --z;
    std::uint64_t rest = mixed[z];
    for (int k = first_cell[z]; k < cell_rank; ++k) rest &= rest - 1;
    return z << 6 | std::countr_zero(rest);
  }
};

/// What is known of a cell besides its vertex.
struct CellTraits {
  static constexpr std::uint16_t kOneSheetFaces = 0x3F;  ///< see oneSheetFaces
  static constexpr std::uint16_t kManySheets = 0x40;
  static constexpr std::uint16_t kSmooth = 0x80;
  static constexpr std::uint16_t kOutside = 0x100;   ///< its vertex is outside the cell
  static constexpr std::uint16_t kFolds = 0x200;     ///< and folds the surface
  static constexpr std::uint16_t kOff = 0x400;       ///< its vertex is off the surface
  static constexpr std::uint16_t kWalled = 0x800;    ///< its triangles stay in it; see SurfaceGrid::wall
  static constexpr std::uint16_t kDrawnIn = 0x1000;  ///< and its sheets are in the middle of their crossings
  static constexpr std::uint16_t kMisses = 0x2000;   ///< a face of its crossings is trimmed before its vertex
  static constexpr std::uint16_t kStep = 0x4000;     ///< a step lower than the cell runs through it
  static constexpr std::uint16_t kClose =
      0x8000;  ///< triangles near it intersected; see SurfaceGrid::markClose
};

/// Faces of a cell (bit axis * 2 + side) whose four edges are all crossed and belong to one sheet.
std::uint8_t oneSheetFaces(CellShape shape);

/// Vertices on edges stay this far from the ends (in cells), so that those of several edges never coincide;
/// vertices in walled cells stay this far from the walls.
inline constexpr double kEndGap = 1e-3;

class SurfaceGrid {
 public:
  /// `flatness`: range of heights over a plane (grid steps) up to which cells may be merged; 0: none.
  SurfaceGrid(const Stock::Impl& impl, double flatness) : impl_(impl), flatness_(flatness) {}

  /// Finds the cells, places their vertices and finds which may be merged. Stops early when cancelled. False
  /// if crossings are missing, which no sound stock has.
  bool build(Progress& progress);

  const Stock::Impl& impl() const { return impl_; }
  const std::vector<SurfaceLeaf>& leaves() const { return leaves_; }
  std::vector<SurfaceLeaf>& leaves() { return leaves_; }
  /// Number of vertices of leaves: first those of the cells, then the extra ones.
  std::size_t vertexCount() const { return cell_count_ + extra_count_; }
  std::size_t cellCount() const { return cell_count_; }
  /// The vertex of a cell's first sheet, in leaf units.
  const Eigen::Vector3f& vertex(std::uint32_t cell) const { return vertices_[cell]; }
  void markFolding(std::uint32_t cell) { traits_[cell] |= CellTraits::kFolds; }
  /// Moves a vertex that was marked to `p`, in leaf units; false if it was not marked. `off`: it is off the
  /// surface there.
  bool putInside(std::uint32_t cell, const Eigen::Vector3f& p, bool off);
  /// Separates what is in a cell from what is in others: its vertices go inside, and where its surface goes
  /// through a face of the cell there will be a vertex. Each triangle then lies in one cell, as part of a
  /// cone over closed lines on its walls, and does not meet those of others. A second call parts the sheets
  /// of one cell for certain. False if all was done already.
  bool wall(std::uint32_t cell);
  /// Makes quads at this cell keep as near to the surface as those of a mesh that is not simplified. False
  /// if they did already.
  bool markClose(std::uint32_t cell) {
    const bool fresh = (traits_[cell] & CellTraits::kClose) == 0;
    traits_[cell] |= CellTraits::kClose;
    return fresh;
  }
  /// Whether the vertex of this cell, which is outside, may be in the way of other surface: it left through
  /// an edge of the cell, by more than shallow feature edges do, or comes near to the vertex of the cell
  /// that it is in.
  bool crowds(const SurfaceLeaf& leaf, int place) const;
  /// Number of the leaf of a cell.
  std::size_t leafOf(std::uint32_t cell) const;
  /// The cell of a vertex, which may be of a further sheet.
  std::uint32_t cellOf(std::uint32_t vertex) const;
  CellShape shape(std::uint32_t cell) const { return shapes_[cell]; }
  /// The cell whose lowest corner is this voxel of the whole grid; none where no surface goes through it.
  std::optional<std::uint32_t> cellAt(const Coord& at) const;
  std::uint16_t traits(std::uint32_t cell) const { return traits_[cell]; }
  /// Fraction of the edge along `axis` from voxel `at` (of the whole grid) at which it is crossed, at least
  /// kEndGap from its ends; 0.5 where it is not crossed.
  double crossingOn(int axis, const Coord& at) const;
  bool isCrossed(int axis, const Coord& at) const;
  /// Motion of the last path that made the crossing of an edge; kNoMotion where there is no crossing or it
  /// is older.
  MotionId motionOn(int axis, const Coord& at) const;
  /// Counts the cells with more than one sheet, or whose vertex is off the surface.
  std::size_t countThin() const;

  /// Whether the level face of a leaf continues in the leaves `beside` it (SurfaceLeaf::upper or lower).
  bool isLevel(const SurfaceLeaf& leaf, const std::array<std::int32_t, 8>& beside) const;
  /// Samples of a leaf and its upper neighbours.
  std::array<const LeafBits*, 8> blockBits(const SurfaceLeaf& leaf) const;

 private:
  void linkLeaf(SurfaceLeaf& leaf, std::size_t number);
  void placeLeaf(SurfaceLeaf& leaf);
  void placeLevel(SurfaceLeaf& leaf);
  void numberExtras();
  void drawSheetsIn(SurfaceLeaf& leaf, std::uint32_t cell, const Coord& at);

  const Stock::Impl& impl_;
  double flatness_;
  std::vector<SurfaceLeaf> leaves_;
  std::size_t cell_count_ = 0, extra_count_ = 0;
  // A cell each; not cleared, so that the threads that write them also touch their pages first.
  std::unique_ptr<Eigen::Vector3f[]> vertices_;
  std::unique_ptr<CellShape[]> shapes_;
  std::unique_ptr<std::uint16_t[]> traits_;
};

/// Whether each vertex is where its cell may put it: inside, or as far outside as its traits allow. For a
/// grid whose folds are repaired.
bool verticesInReach(const SurfaceGrid& grid);

}  // namespace proveout
