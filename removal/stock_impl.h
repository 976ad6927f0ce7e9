// Inside of Stock: grids and crossings. Only for the .cpp files of the stock; pulls in OpenVDB.
#pragma once

#include <openvdb/openvdb.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "removal/stock.h"

namespace proveout {

/// Half width of the narrow band in voxels. A cell that the surface crosses has all its corners within
/// sqrt(3) voxels of it, so that every voxel that the surface extraction asks for lies in a leaf; a wider
/// band costs time only.
inline constexpr double kBandVoxels = 2.0;

/// Crossing positions stay this far (as a fraction of the edge) from its ends, so that dual cells never
/// collapse.
inline constexpr double kEdgeMargin = 1e-4;

/// Where the surface crosses a grid edge. The edge starts at voxel `key / 3` of its leaf (OpenVDB's offset)
/// and runs to the next voxel along axis `key % 3`.
struct Crossing {
  std::uint16_t key = 0;
  std::uint16_t element = 0;         ///< face of the blank, or element of the cutter's profile
  float t = 0.5f;                    ///< fraction of the edge, 0 at its start
  float normal[3] = {0, 0, 1};       ///< unit, out of the material
  std::uint32_t motion = kNoMotion;  ///< motion that made the surface
};

using CrossingMap = std::unordered_map<openvdb::Coord, std::vector<Crossing>>;

struct Stock::Impl {
  double h = 0.0;                    ///< grid spacing, mm
  Vec3 origin = Vec3::Zero();        ///< position of voxel (0, 0, 0), mm
  openvdb::FloatGrid::Ptr distance;  ///< mm, negative in material; background +band
  openvdb::Int32Grid::Ptr owner;     ///< motion that left the voxel (as int32), -1: the blank
  CrossingMap crossings;             ///< by leaf origin, sorted by key
  double initial_volume = 0.0;       ///< mm3
  Box3 blank;

  float band() const { return static_cast<float>(kBandVoxels * h); }
  Vec3 position(const openvdb::Coord& c) const {
    return {origin.x() + c.x() * h, origin.y() + c.y() * h, origin.z() + c.z() * h};
  }
};

/// The crossing on the edge that starts at voxel `at` along `axis`, or null.
const Crossing* findCrossing(const CrossingMap& map, const openvdb::Coord& at, int axis);

/// A block of 9x9x9 samples: a leaf and the first layer of its upper neighbours, index (x * 9 + y) * 9 + z.
inline constexpr int kBlock = 9;
inline constexpr int kBlockSize = kBlock * kBlock * kBlock;
inline constexpr int blockIndex(int x, int y, int z) { return (x * kBlock + y) * kBlock + z; }
inline constexpr int kBlockStride[3] = {kBlock * kBlock, kBlock, 1};

/// What work on one leaf gives back.
struct LeafResult {
  openvdb::Coord origin;
  enum class State { kInside, kOutside, kSurface } state = State::kOutside;
  std::vector<float> distance;      ///< 512, kSurface only
  std::vector<std::int32_t> owner;  ///< 512, kSurface only
  std::vector<Crossing> crossings;
};

/// Fills state, distance and owner of a result from block samples.
void packLeaf(const float* distance, const std::uint32_t* owner, float band, LeafResult& result);

/// Writes results into the grids (serial; order does not matter).
void commitLeaves(Stock::Impl& impl, std::vector<LeafResult>& results);

/// Fills an empty Impl with the blank. `impl` has h, origin and blank set.
Status buildBlank(Stock::Impl& impl, const StockShape& shape, const RemovalOptions& options,
                  Progress& progress);

/// The same for a closed mesh. Errors: open, inside out or empty (names the place), too large.
Status buildMeshBlank(Stock::Impl& impl, const MeshShape& shape, const RemovalOptions& options);

/// Reads what Stock::save wrote.
Status loadStock(Stock::Impl& impl, const std::string& path);

/// Empty grids for spacing h.
void makeGrids(Stock::Impl& impl);

/// Bytes that `leaves` leaves take in memory, with crossings and bookkeeping (measured: see
/// docs/architecture.md).
double leafBytes(double leaves);
/// Limit in bytes from the options: max_memory_gb, or what the machine has free.
double memoryLimit(const RemovalOptions& options);
/// The refusal, with the grid that would fit.
Error memoryError(double needed_bytes, double limit_bytes, double resolution_mm);

}  // namespace proveout
