// Inside of Stock: which leaves the surface crosses, the samples there as bits, and the exact crossings.
// Only for the .cpp files of the stock.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "removal/grid/coord.h"
#include "removal/grid/leaf_bits.h"
#include "removal/grid/stock.h"
#include "removal/grid/stock_tree.h"

namespace proveout {

/// Crossing positions stay this far (as a fraction of the edge) from its ends, so that dual cells never
/// collapse.
inline constexpr float kEdgeMargin = 1e-4f;

/// Numbers of motions from here on are those of paths before the last one: told apart, but not known any
/// more.
inline constexpr std::uint32_t kEarlierMotions = 0x80000000u;
inline MotionId knownMotion(std::uint32_t motion) { return motion < kEarlierMotions ? motion : kNoMotion; }

/// Where the surface crosses a grid edge.
struct Crossing {
  float t = 0.5f;                          ///< fraction of the edge, 0 at its start
  std::uint32_t motion = kNoMotion;        ///< motion that made the surface; see knownMotion
  std::int16_t normal[3] = {0, 0, 32767};  ///< out of the material, length kNormalScale to rounding
  std::uint16_t element = 0;               ///< face of the blank, or element of the cutter's profile

  static constexpr std::int16_t kNormalScale = 32767;
  /// Unit; off by at most 3e-5.
  Vec3 unitNormal() const { return Vec3(normal[0], normal[1], normal[2]).normalized(); }
  /// Requires a unit vector.
  void setNormal(const Vec3& n);
  /// `from_start`: fraction of the edge, in [0, 1]; kept off the ends by kEdgeMargin.
  void setPosition(double from_start);
  /// Equal for crossings of one smooth face.
  std::uint64_t face() const { return (static_cast<std::uint64_t>(motion) << 16) | element; }
  bool operator==(const Crossing&) const = default;
};
static_assert(sizeof(Crossing) == 16);

/// A leaf whose block of 9x9x9 samples (its own and the first layer of its upper neighbours) is not all one
/// side. Edge (axis, x, y, z) runs from that sample of the leaf to the next along the axis.
struct StockLeaf {
  Coord origin;                 ///< voxel of its first sample, a multiple of 8
  LeafBits* samples = nullptr;  ///< in the tree
  const LeafBits& material() const { return *samples; }
  std::vector<Crossing> crossings;  ///< one an edge that is crossed, sorted by axis, then z, then leafBit
};

/// Which edges of a leaf are crossed, and where their crossings stand in the list.
struct LeafEdges {
  std::array<LeafBits, 3> crossed{};                    ///< [axis][z], bit leafBit(x, y)
  std::array<std::array<std::uint16_t, 8>, 3> first{};  ///< [axis][z]: index of the layer's first crossing
  std::uint16_t count = 0;

  bool isCrossed(int axis, int x, int y, int z) const { return leafSample(crossed[axis], x, y, z); }
  /// Index into StockLeaf::crossings. Requires isCrossed.
  int indexOf(int axis, int x, int y, int z) const {
    const std::uint64_t below = (1ull << leafBit(x, y)) - 1;
    return first[axis][z] + countBits(crossed[axis][z] & below);
  }
};

/// Calls body(axis, x, y, z) for each crossed edge, in the order of StockLeaf::crossings.
template <typename Body>
void forEachEdge(const LeafEdges& edges, Body&& body) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int z = 0; z < 8; ++z) {
      for (std::uint64_t left = edges.crossed[axis][z]; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        body(axis, bit >> 3, bit & 7, z);
      }
    }
  }
}

/// `next`: samples of the neighbours along +x, +y, +z.
LeafEdges leafEdges(const LeafBits& own, const std::array<const LeafBits*, 3>& next);

struct CutRecord;
struct EarlierStock;
class BlankField;
class TriangleTree;

struct Stock::Impl {
  double h = 0.0;                 ///< grid spacing, mm
  Vec3 origin = Vec3::Zero();     ///< position of voxel (0, 0, 0), mm
  StockTree tree;                 ///< the samples; numbers in `leaves`
  std::vector<StockLeaf> leaves;  ///< sorted by origin
  double initial_volume = 0.0;    ///< mm3
  Box3 blank;
  /// What it was made of, as long as nothing was taken from it; null for saved stocks and large meshes.
  std::shared_ptr<const StockShape> made_from;
  std::shared_ptr<const CutRecord> cut;  ///< what the last path did; null where that is not known
  /// The blank, where its faces are known between the crossings and nothing has been cut from it; else null.
  std::shared_ptr<const BlankField> field;
  /// The closed form of a box or cylinder from which nothing has been cut; else null.
  std::shared_ptr<const BlankField> uncut;
  /// What the last path cut: a box or cylinder, or a mesh of few triangles; else null. Faces that the path
  /// did not make are of it.
  std::shared_ptr<const BlankField> cut_blank;
  /// As `field`, where the last path has cut it: tells its faces, whose motions count from kEarlierMotions
  /// now.
  std::shared_ptr<const BlankField> cut_field;
  std::shared_ptr<const TriangleTree> blank_mesh;
  /// What it was before it was clamped again, where all is known that cut it then.
  std::shared_ptr<const EarlierStock> earlier;
  std::vector<Box3> dropped;  ///< where pieces fell off behind the last path

  Vec3 position(const Coord& c) const {
    return {origin.x() + c.x() * h, origin.y() + c.y() * h, origin.z() + c.z() * h};
  }
};

/// Leaf coordinates of the leaf at `origin`.
inline Coord leafCoord(const Coord& origin) { return {origin.x() >> 3, origin.y() >> 3, origin.z() >> 3}; }

/// Reads leaves by their place.
class LeafReader {
 public:
  explicit LeafReader(const Stock::Impl& impl) : impl_(impl) {}
  /// `origin`: voxel of the leaf's first sample.
  std::int32_t state(const Coord& origin) const { return impl_.tree.get(leafCoord(origin)); }
  const StockLeaf* leaf(const Coord& origin) const {
    const std::int32_t s = state(origin);
    return s >= 0 ? &impl_.leaves[static_cast<std::size_t>(s)] : nullptr;
  }
  const LeafBits& bits(const Coord& origin) const { return impl_.tree.bits(leafCoord(origin)); }
  /// The sample at a voxel of the whole grid.
  bool isMaterial(const Coord& at) const {
    return leafSample(bits(at & ~7), at.x() & 7, at.y() & 7, at.z() & 7);
  }
  LeafEdges edges(const StockLeaf& leaf) const {
    const auto beside = impl_.tree.bitsBeside(leafCoord(leaf.origin));
    return leafEdges(leaf.material(), {beside[1], beside[2], beside[4]});
  }
  /// As StockTree::getBeside and bitsBeside.
  std::array<std::int32_t, 8> statesBeside(const Coord& origin, int step) const {
    return impl_.tree.getBeside(leafCoord(origin), step);
  }
  std::array<const LeafBits*, 8> bitsBeside(const Coord& origin) const {
    return impl_.tree.bitsBeside(leafCoord(origin));
  }

 private:
  const Stock::Impl& impl_;
};

/// Reads samples that follow each other nearby: asks the tree once a leaf. For one thread.
class SampleReader {
 public:
  explicit SampleReader(const Stock::Impl& impl) : impl_(impl) {}
  /// The sample at a voxel of the whole grid.
  bool isMaterial(const Coord& at) {
    const Coord origin = at & ~7;
    if (bits_ == nullptr || origin != origin_) {
      origin_ = origin;
      bits_ = &impl_.tree.bits(leafCoord(origin));
    }
    return leafSample(*bits_, at.x() & 7, at.y() & 7, at.z() & 7);
  }

 private:
  const Stock::Impl& impl_;
  Coord origin_;
  const LeafBits* bits_ = nullptr;
};

/// Whether the 9x9x9 block of the leaf at `origin` holds both sides.
bool isMixed(const LeafReader& reader, const Coord& origin);

/// Origin of a leaf that is to be left out by orderLeaves; no leaf of any stock has it.
inline constexpr Coord kNoLeaf(1 << 30, 1 << 30, 1 << 30);
/// Adds a leaf that has none yet; its samples are all outside.
StockLeaf& addLeaf(Stock::Impl& impl, const Coord& origin);
/// Sorts `leaves` by origin, without those at kNoLeaf, and writes their numbers into the tree.
void orderLeaves(Stock::Impl& impl);

/// Fills an empty Impl with the blank. `impl` has h, origin and blank set.
Status buildBlank(Stock::Impl& impl, const StockShape& shape, const RemovalOptions& options,
                  Progress& progress);

/// The same for a closed mesh. Errors: open, inside out or empty (names the place), too large.
Status buildMeshBlank(Stock::Impl& impl, const MeshShape& shape, const RemovalOptions& options);

/// Reads what Stock::save wrote. Errors: as VdbSupport::load.
Status loadStock(Stock::Impl& impl, const std::string& path, const RemovalOptions& options);
/// Errors: bounds without volume, numbers that are not finite, more voxels along a side than are counted.
Status checkGrid(const Box3& bounds, double resolution);

/// An empty tree with room for the blank; h, origin and blank must be set.
void makeTree(Stock::Impl& impl);
/// Bytes that this room takes at the least.
double treeBytes(const Stock::Impl& impl);

/// Bytes that `leaves` leaves take in memory, with crossings and bookkeeping: see docs/design/removal.md.
double leafBytes(double leaves);
/// Limit in bytes from the options: max_memory_gb, or what the machine has free.
double memoryLimit(const RemovalOptions& options);
/// For an allocation of the grid that failed: names the limit of the process, or of the options.
Error gridAllocationError(const RemovalOptions& options, double resolution_mm);
/// The refusal, with the grid that would fit.
Error memoryError(double needed_bytes, double limit_bytes, double resolution_mm);

}  // namespace proveout
