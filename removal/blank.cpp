// The blank as a grid, from a closed form.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/base/parallel_for.h"
#include "removal/blank_field.h"
#include "removal/edge_root.h"
#include "removal/stock_impl.h"

namespace proveout {

namespace {

using openvdb::Coord;

/// Blocks of the blank are found by halving a cube of this many voxels (a power of two times 8).
int rootSize(const Coord& low, const Coord& high) {
  int size = 8;
  while (size < high.x() - low.x() + 1 || size < high.y() - low.y() + 1 || size < high.z() - low.z() + 1)
    size *= 2;
  return size;
}

class FieldBlank {
 public:
  FieldBlank(Stock::Impl& impl, const BlankField& field, Progress& progress, double limit_bytes)
      : impl_(impl), field_(field), progress_(progress), limit_bytes_(limit_bytes) {}

  Status build() {
    const Box3 box = field_.bounds();
    const auto index = [&](const Vec3& p, int axis) {
      return static_cast<int>(std::floor((p[axis] - impl_.origin[axis]) / impl_.h));
    };
    Coord low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = (index(box.min, axis) - 4) & ~7;
      high[axis] = index(box.max, axis) + 5;
    }
    const int size = rootSize(low, high);
    visit(low, high, size);
    if (over_limit_) return memoryError(leafBytes(static_cast<double>(leaves_)), limit_bytes_, impl_.h);
    if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
    commitLeaves(impl_, results_);
    return Done{};
  }

 private:
  void visit(const Coord& origin, const Coord& high, int size) {
    if (over_limit_ || progress_.cancelled()) return;
    if (origin.x() > high.x() || origin.y() > high.y() || origin.z() > high.z()) return;
    const double half = 0.5 * size * impl_.h;
    const Vec3 center = impl_.position(origin) + Vec3::Constant(half - 0.5 * impl_.h);
    const double reach = std::sqrt(3.0) * (half + 0.5 * impl_.h) + impl_.band();
    const double value = field_.sample(center).value;
    if (value > reach) return;  // background
    if (value < -reach) {
      fillInside(origin, size);
      return;
    }
    if (size == 8) {
      leaf(origin);
      return;
    }
    const int half_size = size / 2;
    const auto child = [&](int i) {
      visit(origin.offsetBy(i & 1 ? half_size : 0, i & 2 ? half_size : 0, i & 4 ? half_size : 0), high,
            half_size);
    };
    if (size >= 32) {
      parallelFor(0, 8, child);
    } else {
      for (int i = 0; i < 8; ++i) child(i);
    }
  }

  void fillInside(const Coord& origin, int size) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Coord last = origin.offsetBy(size - 1);
    impl_.distance->fill(openvdb::CoordBBox(origin, last), -impl_.band(), false);
  }

  void leaf(const Coord& origin) {
    std::vector<float> distance(kBlockSize);
    std::vector<std::uint32_t> owner(kBlockSize, kNoMotion);
    for (int x = 0; x < kBlock; ++x) {
      for (int y = 0; y < kBlock; ++y) {
        for (int z = 0; z < kBlock; ++z) {
          const double d = field_.sample(impl_.position(origin.offsetBy(x, y, z))).value;
          distance[blockIndex(x, y, z)] = std::clamp(static_cast<float>(d), -impl_.band(), impl_.band());
        }
      }
    }
    LeafResult result;
    result.origin = origin;
    packLeaf(distance.data(), owner.data(), impl_.band(), result);
    if (result.state == LeafResult::State::kSurface) addCrossings(distance, result);
    const std::lock_guard<std::mutex> lock(mutex_);
    results_.push_back(std::move(result));
    if (leafBytes(static_cast<double>(++leaves_)) > limit_bytes_) over_limit_ = true;
  }

  void addCrossings(const std::vector<float>& distance, LeafResult& result) {
    for (int v = 0; v < 512; ++v) {
      const int x = v >> 6, y = (v >> 3) & 7, z = v & 7;
      const int at = blockIndex(x, y, z);
      for (int axis = 0; axis < 3; ++axis) {
        const bool in = distance[at] < 0.0f;
        if (in == (distance[at + kBlockStride[axis]] < 0.0f)) continue;
        const Vec3 start = impl_.position(result.origin.offsetBy(x, y, z));
        const Vec3 step = Vec3::Unit(axis) * impl_.h;
        const auto f = [&](double t) { return (in ? -1.0 : 1.0) * field_.sample(start + t * step).value; };
        const double t = edgeRoot(f, 0.0, f(0.0), 1.0, f(1.0), 1e-9);
        const BlankSample s = field_.sample(start + t * step);
        Crossing c;
        c.key = static_cast<std::uint16_t>(v * 3 + axis);
        c.element = static_cast<std::uint16_t>(s.face);
        c.t = static_cast<float>(std::clamp(t, kEdgeMargin, 1.0 - kEdgeMargin));
        for (int i = 0; i < 3; ++i) c.normal[i] = static_cast<float>(s.normal[i]);
        result.crossings.push_back(c);
      }
    }
  }

  Stock::Impl& impl_;
  const BlankField& field_;
  Progress& progress_;
  double limit_bytes_;
  std::mutex mutex_;
  std::vector<LeafResult> results_;
  std::size_t leaves_ = 0;
  std::atomic<bool> over_limit_{false};
};

Status buildField(Stock::Impl& impl, Result<std::unique_ptr<BlankField>> field, const RemovalOptions& options,
                  Progress& progress) {
  if (!field) return field.error();
  impl.initial_volume = field.value()->volume();
  return FieldBlank(impl, *field.value(), progress, memoryLimit(options)).build();
}

}  // namespace

Status buildBlank(Stock::Impl& impl, const StockShape& shape, const RemovalOptions& options,
                  Progress& progress) {
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return buildField(impl, makeBlankField(*box), options, progress);
  if (const auto* round = std::get_if<CylinderShape>(&shape)) {
    return buildField(impl, makeBlankField(*round), options, progress);
  }
  return buildMeshBlank(impl, std::get<MeshShape>(shape), options);
}

}  // namespace proveout
