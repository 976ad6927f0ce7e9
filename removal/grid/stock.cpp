#include "removal/grid/stock.h"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/assert.h"
#include "core/base/memory.h"
#include "core/base/parallel_for.h"
#include "core/base/thread_limit.h"
#include "core/geometry/place_text.h"
#include "core/geometry/to_float.h"
#include "removal/grid/placed_field.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

namespace {

/// Measured on the sample programs: a record, a node of the tree, crossings, the list of motions while
/// cutting.
constexpr double kBytesPerLeaf = sizeof(StockLeaf) + 80 + 64 * sizeof(Crossing) + 200;

/// Voxel indices stay far inside 32 bits.
constexpr double kMaxVoxelsPerSide = 1 << 24;

/// Where the grid lies against whole millimetres, in voxels: unlikely fractions, so that faces at round
/// coordinates do not coincide with grid points.
const Vec3 kGridShift(0.38197, 0.41421, 0.44721);

/// What is built of a shape with these bounds; see RemovalOptions::window.
Box3 windowed(const StockShape& shape, const Box3& bounds, const std::optional<Box3>& window) {
  const bool closed_form =
      std::holds_alternative<BoxShape>(shape) || std::holds_alternative<CylinderShape>(shape);
  if (!window || !closed_form || !bounds.overlaps(*window)) return bounds;
  return {bounds.min.cwiseMax(window->min), bounds.max.cwiseMin(window->max)};
}

}  // namespace

Status checkGrid(const Box3& bounds, double resolution) {
  if (!std::isfinite(resolution) || resolution <= 0.0) {
    return inputError(fmt::format("resolution must be above 0 mm, not {}", resolution));
  }
  if (bounds.empty() || !bounds.min.allFinite() || !bounds.max.allFinite()) {
    return inputError("stock: no volume, or a coordinate that is not a finite number");
  }
  const double side =
      std::max(bounds.size().maxCoeff(), bounds.min.cwiseAbs().cwiseMax(bounds.max.cwiseAbs()).maxCoeff());
  if (side / resolution > kMaxVoxelsPerSide) {
    return Error{
        ErrorKind::kResourceLimit,
        fmt::format("the stock is {:.0f} voxels long at {} mm; take a resolution of {:.3g} mm or more",
                    side / resolution, resolution, side / kMaxVoxelsPerSide)};
  }
  return Done{};
}

Box3 shapeBounds(const StockShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return {box->min, box->max};
  if (const auto* round = std::get_if<CylinderShape>(&shape)) {
    Vec3 reach = Vec3::Constant(round->radius);
    reach[round->axis] = 0.0;
    return {round->base - reach, round->base + reach + Vec3::Unit(round->axis) * round->length};
  }
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return meshBounds(mesh->mesh);
  if (const auto* known = std::get_if<FieldShape>(&shape)) {
    const Box3 bounds = known->body->bounds();
    return staysInPlace(known->place) ? bounds : known->place(bounds);
  }
  return {};
}

Status checkSolid(const MeshShape& shape) {
  const std::string name = shape.name.empty() ? "stock mesh" : "stock mesh " + shape.name;
  if (shape.mesh.triangles.empty()) return inputError(name + ": no triangles");
  const MeshTopology topology = analyseTopology(shape.mesh);
  if (!topology.closedManifold()) {
    return inputError(fmt::format(
        "{}: not closed (open edges {}, non-manifold edges {}, inconsistent edges {}), first defect near {}; "
        "close it in CAD and export it again",
        name, topology.boundary_edges, topology.non_manifold_edges, topology.misoriented_edges,
        placeText(topology.first_defect)));
  }
  if (meshVolume(shape.mesh) <= 0.0)
    return inputError(name + ": inside out or without volume; turn its normals round");
  return Done{};
}

double leafBytes(double leaves) { return leaves * kBytesPerLeaf; }

double memoryLimit(const RemovalOptions& options) {
  return options.max_memory_gb > 0.0 ? options.max_memory_gb * 1e9 : availableMemoryBytes();
}

Error memoryError(double needed_bytes, double limit_bytes, double resolution_mm) {
  // Leaves lie on surfaces: their number goes with the square of the resolution.
  const double fits = resolution_mm * std::sqrt(needed_bytes / limit_bytes) * 1.1;
  const std::string process = processMemoryBound().reason;  // may be what was met
  return {ErrorKind::kResourceLimit,
          fmt::format("the stock grid needs more than the {:.3g} GB allowed at a resolution of {} mm; about "
                      "{:.2g} mm would fit "
                      "(--resolution), or allow more (--max-memory{}{})",
                      limit_bytes / 1e9, resolution_mm, std::max(fits, resolution_mm * 1.1),
                      process.empty() ? "" : "; ", process)};
}

Error gridAllocationError(const RemovalOptions& options, double resolution_mm) {
  if (!std::isfinite(processMemoryBound().bytes))
    return memoryError(2.0 * memoryLimit(options), memoryLimit(options), resolution_mm);
  return outOfMemory(fmt::format("not enough memory for the stock grid at {} mm", resolution_mm),
                     "take a coarser one (--resolution)");
}

void Crossing::setNormal(const Vec3& n) {
  PROVEOUT_ASSERT_DEAR(std::abs(n.squaredNorm() - 1.0) < 1e-4);  // those of saved stocks were rounded before
  for (int i = 0; i < 3; ++i)
    normal[i] = static_cast<std::int16_t>(n[i] * kNormalScale + (n[i] < 0.0 ? -0.5 : 0.5));
}

void Crossing::setPosition(double from_start) {
  PROVEOUT_ASSERT_DEAR(from_start >= -1e-6 && from_start <= 1.0 + 1e-6);
  t = std::clamp(toFloat(from_start), kEdgeMargin, 1.0f - kEdgeMargin);
}

LeafEdges leafEdges(const LeafBits& own, const std::array<const LeafBits*, 3>& next) {
  constexpr std::uint64_t kFirstX = 0xFF, kFirstY = 0x0101010101010101;
  LeafEdges e;
  for (int z = 0; z < 8; ++z) {
    const std::uint64_t m = own[z];
    e.crossed[0][z] = m ^ (m >> 8 | ((*next[0])[z] & kFirstX) << 56);
    e.crossed[1][z] = m ^ ((m >> 1 & ~(kFirstY << 7)) | ((*next[1])[z] & kFirstY) << 7);
    e.crossed[2][z] = m ^ (z < 7 ? own[z + 1] : (*next[2])[0]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int z = 0; z < 8; ++z) {
      e.first[axis][z] = e.count;
      e.count = static_cast<std::uint16_t>(e.count + countBits(e.crossed[axis][z]));
    }
  }
  return e;
}

bool isMixed(const LeafReader& reader, const Coord& origin) {
  // Own samples, and of each upper neighbour the layer, row or corner that belongs to the block.
  constexpr std::uint64_t kRowX = 0xFF, kRowY = 0x0101010101010101;
  const std::array<const LeafBits*, 8> beside = reader.bitsBeside(origin);
  const std::uint64_t side = (*beside[0])[0] & 1 ? ~0ull : 0;
  for (int n = 0; n < 8; ++n) {
    const LeafBits& bits = *beside[static_cast<std::size_t>(n)];
    const std::uint64_t mask = (n & 1 ? kRowX : ~0ull) & (n & 2 ? kRowY : ~0ull);
    for (int z = 0; z < (n & 4 ? 1 : 8); ++z) {
      if ((bits[z] ^ side) & mask) return true;
    }
  }
  return false;
}

namespace {

/// Leaves that hold the blank, with room for the layers around it that the block of a leaf reaches into.
std::pair<Coord, Coord> treeRoom(const Stock::Impl& impl) {
  Coord low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<int>(std::floor((impl.blank.min[axis] - impl.origin[axis]) / impl.h)) / 8 - 3;
    high[axis] = static_cast<int>(std::ceil((impl.blank.max[axis] - impl.origin[axis]) / impl.h)) / 8 + 3;
  }
  return {low, high};
}

}  // namespace

void makeTree(Stock::Impl& impl) {
  const auto [low, high] = treeRoom(impl);
  impl.tree.reset(low, high);
}

double treeBytes(const Stock::Impl& impl) {
  const auto [low, high] = treeRoom(impl);
  return StockTree::bytesFor(low, high);
}

StockLeaf& addLeaf(Stock::Impl& impl, const Coord& origin) {
  PROVEOUT_ASSERT(origin == (origin & ~7) && origin != kNoLeaf);
  LeafBits* samples = impl.tree.number(leafCoord(origin), static_cast<std::int32_t>(impl.leaves.size()));
  impl.leaves.push_back({origin, samples, {}});
  return impl.leaves.back();
}

void orderLeaves(Stock::Impl& impl) {
  struct Place {
    Coord origin;
    std::uint32_t number;
  };
  std::vector<Place> places;
  places.reserve(impl.leaves.size());
  for (std::uint32_t i = 0; i < impl.leaves.size(); ++i) {
    if (impl.leaves[i].origin != kNoLeaf) places.push_back({impl.leaves[i].origin, i});
  }
  const auto before = [](const Place& a, const Place& b) { return a.origin < b.origin; };
#if defined(__SANITIZE_THREAD__)
  std::sort(places.begin(), places.end(), before);  // it cannot see how TBB hands parts of a sort over
#else
  tbb::parallel_sort(places.begin(), places.end(), before);
#endif
  PROVEOUT_ASSERT_DEAR(std::adjacent_find(places.begin(), places.end(), [&](const Place& a, const Place& b) {
                         return !before(a, b);
                       }) == places.end());  // one leaf at a place
  std::vector<StockLeaf> leaves(places.size());
  parallelFor(std::size_t{0}, places.size(),
              [&](std::size_t i) { leaves[i] = std::move(impl.leaves[places[i].number]); });
  impl.leaves = std::move(leaves);
  parallelFor(std::size_t{0}, impl.leaves.size(), [&](std::size_t i) {
    const LeafBits* const samples =
        impl.tree.number(leafCoord(impl.leaves[i].origin), static_cast<std::int32_t>(i));
    PROVEOUT_ASSERT(samples == impl.leaves[i].samples);
  });
}

Stock::Stock() = default;
Stock::~Stock() = default;
Stock::Stock(Stock&&) noexcept = default;
Stock& Stock::operator=(Stock&&) noexcept = default;

Result<Stock> Stock::create(const StockShape& shape, const RemovalOptions& options, Progress& progress) {
  const ThreadLimit limit(options.threads);
  Stock stock;
  stock.impl_ = std::make_unique<Impl>();
  try {
    if (const auto* saved = std::get_if<SavedStock>(&shape)) {
      if (Status status = loadStock(*stock.impl_, saved->path, options); !status) return status.error();
      return stock;
    }
    const Box3 bounds = shapeBounds(shape);
    if (Status status = checkGrid(bounds, options.resolution_mm); !status) return status.error();
    stock.impl_->h = options.resolution_mm;
    stock.impl_->origin = kGridShift * options.resolution_mm;
    stock.impl_->blank = windowed(shape, bounds, options.window);
    if (const double bytes = treeBytes(*stock.impl_), most = memoryLimit(options); bytes > most)
      return memoryError(bytes, most, options.resolution_mm);
    makeTree(*stock.impl_);
    if (Status status = buildBlank(*stock.impl_, shape, options, progress); !status) return status.error();
    if (const auto* known = std::get_if<FieldShape>(&shape);
        known != nullptr && !known->body->volumeIsExact()) {
      const Result<StockVolume> volume = stock.volume({-1.0, options.threads}, progress);
      if (!volume) return volume.error();
      stock.impl_->initial_volume = volume->mm3;
    }
  } catch (const std::bad_alloc&) {
    return gridAllocationError(options, options.resolution_mm);
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("building the stock failed: {}", e.what())};
  }
  return stock;
}

double Stock::initialVolume() const { return impl_->initial_volume; }
double Stock::resolution() const { return impl_->h; }
Box3 Stock::bounds() const { return impl_->blank; }

}  // namespace proveout
