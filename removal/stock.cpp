#include "removal/stock.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>
#include <string>

#include "removal/stock_impl.h"
#include "removal/threads.h"

namespace proveout {

using openvdb::Coord;

std::string_view contactKindName(ContactKind kind) {
  switch (kind) {
    case ContactKind::kRapid:
      return "rapid_contact";
    case ContactKind::kShank:
      return "shank_contact";
    case ContactKind::kHolder:
      return "holder_contact";
    case ContactKind::kSpindleOff:
      return "spindle_off";
  }
  return "rapid_contact";
}

namespace {

/// Measured on the sample programs: samples, owners, masks, tree nodes, crossings and the leaf's entry in the
/// map.
constexpr double kBytesPerLeaf = 512 * (4 + 4) + 2 * 160 + 130 * sizeof(Crossing) + 200;

/// Voxel indices stay far inside 32 bits.
constexpr double kMaxVoxelsPerSide = 1 << 24;

/// Where the grid lies against whole millimetres, in voxels: unlikely fractions, so that faces at round
/// coordinates do not coincide with grid points.
const Vec3 kGridShift(0.38197, 0.41421, 0.44721);

double availableBytes() {
  std::ifstream info("/proc/meminfo");
  std::string key, unit;
  double kilobytes = 0.0;
  while (info >> key >> kilobytes) {
    std::getline(info, unit);
    if (key == "MemAvailable:") return kilobytes * 1024.0;
  }
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

Box3 shapeBounds(const StockShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return {box->min, box->max};
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return meshBounds(mesh->mesh);
  Box3 bounds;
  if (const auto* round = std::get_if<CylinderShape>(&shape)) {
    bounds.extend(round->base - Vec3::Constant(round->radius));
    bounds.extend(round->base + Vec3::Constant(round->radius));
    bounds.min[round->axis] = round->base[round->axis];
    bounds.max[round->axis] = round->base[round->axis] + round->length;
  }
  return bounds;
}

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

}  // namespace

double leafBytes(double leaves) { return leaves * kBytesPerLeaf; }

double memoryLimit(const RemovalOptions& options) {
  return options.max_memory_gb > 0.0 ? options.max_memory_gb * 1e9 : availableBytes();
}

Error memoryError(double needed_bytes, double limit_bytes, double resolution_mm) {
  // Leaves lie on surfaces: their number goes with the square of the resolution.
  const double fits = resolution_mm * std::sqrt(needed_bytes / limit_bytes) * 1.1;
  return {ErrorKind::kResourceLimit,
          fmt::format("the stock grid needs more than the {:.3g} GB allowed at a resolution of {} mm; about "
                      "{:.2g} mm would fit "
                      "(--resolution), or allow more (--max-memory)",
                      limit_bytes / 1e9, resolution_mm, std::max(fits, resolution_mm * 1.1))};
}

const Crossing* findCrossing(const CrossingMap& map, const Coord& at, int axis) {
  const auto leaf = map.find(at & ~7);
  if (leaf == map.end()) return nullptr;
  const int offset = ((at.x() & 7) << 6) | ((at.y() & 7) << 3) | (at.z() & 7);
  const auto key = static_cast<std::uint16_t>(offset * 3 + axis);
  const auto it = std::lower_bound(leaf->second.begin(), leaf->second.end(), key,
                                   [](const Crossing& c, std::uint16_t k) { return c.key < k; });
  return it != leaf->second.end() && it->key == key ? &*it : nullptr;
}

void packLeaf(const float* distance, const std::uint32_t* owner, float band, LeafResult& result) {
  bool any_in = false, any_out = false, near = false;
  result.distance.resize(512);
  result.owner.resize(512);
  for (int v = 0; v < 512; ++v) {
    const int at = blockIndex(v >> 6, (v >> 3) & 7, v & 7);
    result.distance[v] = distance[at];
    result.owner[v] = static_cast<std::int32_t>(owner[at]);
    (distance[at] < 0.0f ? any_in : any_out) = true;
    near = near || std::abs(distance[at]) < band;
  }
  using State = LeafResult::State;
  result.state = near || (any_in && any_out) ? State::kSurface : (any_in ? State::kInside : State::kOutside);
  if (result.state != State::kSurface) {
    result.distance.clear();
    result.owner.clear();
  }
}

void makeGrids(Stock::Impl& impl) {
  impl.distance = openvdb::FloatGrid::create(impl.band());
  impl.owner = openvdb::Int32Grid::create(-1);
}

namespace {

void commitSurfaceLeaf(Stock::Impl& impl, LeafResult& r) {
  auto* distance = new openvdb::FloatTree::LeafNodeType(r.origin, impl.band(), false);
  auto* owner = new openvdb::Int32Tree::LeafNodeType(r.origin, -1, false);
  for (int v = 0; v < 512; ++v) {
    if (std::abs(r.distance[v]) < impl.band()) {
      distance->setValueOn(v, r.distance[v]);
      owner->setValueOn(v, r.owner[v]);
    } else {
      distance->setValueOff(v, r.distance[v]);
      owner->setValueOff(v, r.owner[v]);
    }
  }
  impl.distance->tree().addLeaf(distance);
  impl.owner->tree().addLeaf(owner);
}

}  // namespace

void commitLeaves(Stock::Impl& impl, std::vector<LeafResult>& results) {
  for (LeafResult& r : results) {
    if (r.state == LeafResult::State::kSurface) {
      commitSurfaceLeaf(impl, r);
    } else {
      const float value = r.state == LeafResult::State::kInside ? -impl.band() : impl.band();
      impl.distance->tree().addTile(1, r.origin, value, false);
      impl.owner->tree().addTile(1, r.origin, -1, false);
    }
    if (r.crossings.empty()) {
      impl.crossings.erase(r.origin);
    } else {
      impl.crossings[r.origin] = std::move(r.crossings);
    }
    r = LeafResult{};
  }
}

Stock::Stock() = default;
Stock::~Stock() = default;
Stock::Stock(Stock&&) noexcept = default;
Stock& Stock::operator=(Stock&&) noexcept = default;

Result<Stock> Stock::create(const StockShape& shape, const RemovalOptions& options, Progress& progress) {
  static std::once_flag once;
  std::call_once(once, [] { openvdb::initialize(); });
  const ThreadLimit limit(options.threads);
  Stock stock;
  stock.impl_ = std::make_unique<Impl>();
  try {
    if (const auto* saved = std::get_if<SavedStock>(&shape)) {
      if (Status status = loadStock(*stock.impl_, saved->path); !status) return status.error();
      return stock;
    }
    const Box3 bounds = shapeBounds(shape);
    if (Status status = checkGrid(bounds, options.resolution_mm); !status) return status.error();
    stock.impl_->h = options.resolution_mm;
    stock.impl_->origin = kGridShift * options.resolution_mm;
    stock.impl_->blank = bounds;
    makeGrids(*stock.impl_);
    if (Status status = buildBlank(*stock.impl_, shape, options, progress); !status) return status.error();
  } catch (const std::bad_alloc&) {
    return memoryError(2.0 * memoryLimit(options), memoryLimit(options), options.resolution_mm);
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("building the stock failed: {}", e.what())};
  }
  return stock;
}

double Stock::initialVolume() const { return impl_->initial_volume; }
double Stock::resolution() const { return impl_->h; }
Box3 Stock::bounds() const { return impl_->blank; }

}  // namespace proveout
