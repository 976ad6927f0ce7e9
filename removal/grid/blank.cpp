// The blank as leaves, from a closed form.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/base/parallel_for.h"
#include "core/mesh/triangle_tree.h"
#include "removal/grid/blank_field.h"
#include "removal/grid/leaf_changes.h"
#include "removal/grid/placed_field.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

namespace {

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
    const Box3& box = impl_.blank;
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
    commitChanges(impl_, addressesOf(changes_), [this](std::size_t i, const LeafEdges& edges, const auto&) {
      return crossings(changes_[i], edges);
    });
    return Done{};
  }

 private:
  void visit(const Coord& origin, const Coord& high, int size) {
    if (over_limit_ || progress_.cancelled()) return;
    if (origin.x() > high.x() || origin.y() > high.y() || origin.z() > high.z()) return;
    // The block of a leaf reaches one layer beyond its own samples.
    const double half = 0.5 * size * impl_.h;
    const Vec3 center = impl_.position(origin) + Vec3::Constant(half);
    const double reach = std::sqrt(3.0) * half + 0.01 * impl_.h;
    const double value = field_.sample(center).value;
    if (value > reach) return;  // background
    if (value < -reach) {
      fillInside(origin, size);
      return;
    }
    if (size == 8) {
      LeafChange change;
      change.origin = origin;
      change.material = field_.material(impl_.position(origin), impl_.h);
      changes_.push_back(change);
      if (leafBytes(static_cast<double>(++leaves_)) > limit_bytes_) over_limit_ = true;
      return;
    }
    const int half_size = size / 2;
    const auto child = [&](int i) {
      visit(origin.offsetBy(i & 1 ? half_size : 0, i & 2 ? half_size : 0, i & 4 ? half_size : 0), high,
            half_size);
    };
    if (size >= 64) {
      parallelFor(0, 8, child);
    } else {
      for (int i = 0; i < 8; ++i) child(i);
    }
  }

  void fillInside(const Coord& origin, int size) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Coord first = leafCoord(origin);
    impl_.tree.fillInside(first, first.offsetBy(size / 8 - 1));
  }

  std::vector<Crossing> crossings(const LeafChange& leaf, const LeafEdges& edges) const {
    std::vector<Crossing> out;
    out.reserve(edges.count);
    const bool level = field_.isLevel();
    int last = -1;
    forEachEdge(edges, [&](int axis, int x, int y, int z) {
      const bool inside = leafSample(leaf.material, x, y, z);
      const int layer = (axis * 8 + std::array{x, y, z}[static_cast<std::size_t>(axis)]) * 2 + inside;
      if (level && layer == last) {
        out.push_back(out.back());
        return;
      }
      last = layer;
      const Vec3 start = impl_.position(leaf.origin.offsetBy(x, y, z));
      const auto hit = field_.edgeHit(start, axis, impl_.h, inside);
      Crossing c;
      c.setPosition(hit.t);
      c.setNormal(hit.normal);
      c.motion = hit.motion;
      c.element = static_cast<std::uint16_t>(hit.face);
      out.push_back(c);
    });
    return out;
  }

  Stock::Impl& impl_;
  const BlankField& field_;
  Progress& progress_;
  double limit_bytes_;
  std::mutex mutex_;
  ConcurrentList<LeafChange> changes_;
  std::atomic<std::size_t> leaves_{0};
  std::atomic<bool> over_limit_{false};
};

Status buildField(Stock::Impl& impl, Result<std::unique_ptr<BlankField>> field, const RemovalOptions& options,
                  Progress& progress) {
  if (!field) return field.error();
  impl.uncut = std::move(*field);
  impl.initial_volume = impl.uncut->volume();
  return FieldBlank(impl, *impl.uncut, progress, memoryLimit(options)).build();
}

Status buildFromField(Stock::Impl& impl, const FieldShape& shape, const RemovalOptions& options,
                      Progress& progress) {
  Result<std::unique_ptr<BlankField>> made = placedField(shape);
  if (!made) return made.error();
  const std::shared_ptr<const BlankField> field = std::move(*made);
  if (Status status = FieldBlank(impl, *field, progress, memoryLimit(options)).build(); !status)
    return status;
  impl.field = field;
  impl.initial_volume = field->volume();
  return Done{};
}

/// Most triangles of a mesh that is kept for questions about places between its crossings, 15 MB: those of
/// larger ones are mostly smaller than the cells.
constexpr std::size_t kMostKeptTriangles = 100'000;

bool isKept(const MeshShape& shape) { return shape.mesh.triangles.size() <= kMostKeptTriangles; }

Status buildFromMesh(Stock::Impl& impl, const MeshShape& shape, const RemovalOptions& options) {
  if (Status built = buildMeshBlank(impl, shape, options); !built) return built;
  if (isKept(shape)) impl.blank_mesh = std::make_shared<const TriangleTree>(toSurface(shape.mesh));
  return Done{};
}

}  // namespace

Status buildBlank(Stock::Impl& impl, const StockShape& shape, const RemovalOptions& options,
                  Progress& progress) {
  const auto* const mesh = std::get_if<MeshShape>(&shape);
  if (mesh == nullptr || isKept(*mesh)) impl.made_from = std::make_shared<const StockShape>(shape);
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return buildField(impl, makeBlankField(*box), options, progress);
  if (const auto* round = std::get_if<CylinderShape>(&shape)) {
    return buildField(impl, makeBlankField(*round), options, progress);
  }
  if (const auto* body = std::get_if<FieldShape>(&shape))
    return buildFromField(impl, *body, options, progress);
  return buildFromMesh(impl, *mesh, options);
}

}  // namespace proveout
