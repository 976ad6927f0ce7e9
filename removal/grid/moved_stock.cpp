// The stock in another clamping: quarter turns exactly, sample by sample; other turns by way of the mesh.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/assert.h"
#include "core/mesh/mesh_placement.h"
#include "removal/grid/earlier_stock.h"
#include "removal/grid/face_numbers.h"
#include "removal/grid/leaf_changes.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

namespace {

/// A turn that takes grid lines to grid lines: new axis a is old axis from[a], turned round where sign[a] is
/// -1. Sample i of an axis that is turned round becomes sample -1 - i, so that leaves stay leaves.
struct AxisMap {
  int from[3] = {0, 1, 2};
  int sign[3] = {1, 1, 1};

  /// Of samples and of leaves (in leaf coordinates) alike.
  Coord operator()(const Coord& old) const {
    Coord now;
    for (int a = 0; a < 3; ++a) now[a] = sign[a] > 0 ? old[from[a]] : -1 - old[from[a]];
    return now;
  }
  Coord back(const Coord& now) const {
    Coord old;
    for (int a = 0; a < 3; ++a) old[from[a]] = sign[a] > 0 ? now[a] : -1 - now[a];
    return old;
  }
};

/// None where the rotation is not one of the 24 that are exactly so.
std::optional<AxisMap> axisMap(const Eigen::Matrix3d& rotation) {
  AxisMap map;
  for (int a = 0; a < 3; ++a) {
    int found = 0;
    for (int b = 0; b < 3; ++b) {
      const double entry = rotation(a, b);
      if (entry == 0.0) continue;
      if (std::abs(entry) != 1.0) return std::nullopt;
      ++found;
      map.from[a] = b;
      map.sign[a] = entry > 0 ? 1 : -1;
    }
    if (found != 1) return std::nullopt;
  }
  return map;
}

class ExactMove {
 public:
  ExactMove(const Stock::Impl& old, const AxisMap& map, const RigidTransform& move) : old_(old), map_(map) {
    now_.h = old.h;
    now_.initial_volume = old.initial_volume;
    now_.blank = move(old.blank);
    for (int a = 0; a < 3; ++a) {
      const double origin = old.origin[map.from[a]];
      now_.origin[a] = move.translation[a] + (map.sign[a] > 0 ? origin : old.h - origin);
    }
  }

  Stock::Impl run() {
    makeTree(now_);
    fillInside();
    const std::vector<LeafChange> changes = movedLeaves();
    commitChanges(now_, addressesOf(changes), [&](std::size_t i, const LeafEdges& edges, const auto&) {
      return crossings(changes[i].origin, edges);
    });
    numberFaces(now_);
    return std::move(now_);
  }

 private:
  void fillInside() {
    old_.tree.forEachInside([&](const Coord& low, const Coord& high) {
      const Coord a = map_(low), b = map_(high);
      Coord first, last;
      for (int axis = 0; axis < 3; ++axis) {
        first[axis] = std::min(a[axis], b[axis]);
        last[axis] = std::max(a[axis], b[axis]);
      }
      now_.tree.fillInside(first, last);
    });
  }

  /// The leaves with surface, and those below them: whether a leaf counts as mixed depends on its upper
  /// neighbours, and up may be down now.
  std::vector<LeafChange> movedLeaves() const {
    std::set<Coord> places;
    for (const StockLeaf& leaf : old_.leaves) {
      const Coord at = map_(leafCoord(leaf.origin));
      for (int n = 0; n < 27; ++n) {
        const Coord place = at.offsetBy(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        if (now_.tree.holds(place)) places.insert(place);
      }
    }
    const LeafReader reader(old_);
    std::vector<LeafChange> changes;
    changes.reserve(places.size());
    for (const Coord& place : places) {
      LeafChange& change = changes.emplace_back();
      change.origin = Coord(place.x() * 8, place.y() * 8, place.z() * 8);
      const Coord from = map_.back(place);
      const LeafBits& bits = reader.bits(Coord(from.x() * 8, from.y() * 8, from.z() * 8));
      for (int v = 0; v < 512; ++v) {
        const Coord sample = map_.back(change.origin.offsetBy(v >> 6, v >> 3 & 7, v & 7));
        if (leafSample(bits, sample.x() & 7, sample.y() & 7, sample.z() & 7))
          change.material[v & 7] |= 1ull << leafBit(v >> 6, v >> 3 & 7);
      }
    }
    return changes;
  }

  std::vector<Crossing> crossings(const Coord& origin, const LeafEdges& edges) const {
    const LeafReader reader(old_);
    std::vector<Crossing> out;
    out.reserve(edges.count);
    forEachEdge(edges, [&](int axis, int x, int y, int z) {
      const Coord start = origin.offsetBy(x, y, z), end = start.offsetBy(axis == 0, axis == 1, axis == 2);
      const bool turned = map_.sign[axis] < 0;
      out.push_back(moved(crossingAt(reader, map_.back(turned ? end : start), map_.from[axis]), turned));
    });
    return out;
  }

  static const Crossing& crossingAt(const LeafReader& reader, const Coord& at, int axis) {
    const StockLeaf* const leaf = reader.leaf(at & ~7);
    PROVEOUT_ASSERT(leaf != nullptr);
    const LeafEdges edges = reader.edges(*leaf);
    const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
    PROVEOUT_ASSERT(edges.isCrossed(axis, x, y, z));
    return leaf->crossings[static_cast<std::size_t>(edges.indexOf(axis, x, y, z))];
  }

  Crossing moved(const Crossing& old, bool turned) const {
    Crossing now = old;
    if (turned) now.t = 1.0f - old.t;
    for (int a = 0; a < 3; ++a) {
      now.normal[a] = static_cast<std::int16_t>(map_.sign[a] * old.normal[map_.from[a]]);
    }
    return now;
  }

  const Stock::Impl& old_;
  AxisMap map_;
  Stock::Impl now_;
};

CylinderShape movedCylinder(const CylinderShape& old, const AxisMap& map, const RigidTransform& move) {
  CylinderShape now = old;
  now.axis = static_cast<int>(std::find(map.from, map.from + 3, old.axis) - map.from);
  const bool turned = map.sign[now.axis] < 0;
  now.base = move(turned ? Vec3(old.base + old.length * Vec3::Unit(old.axis)) : old.base);
  return now;
}

/// Null where it is not known what cut the stock, or from what.
std::shared_ptr<const EarlierStock> earlierStock(const Stock::Impl& stock, const RigidTransform& move) {
  const RigidTransform back = move.inverse();
  if (stock.cut == nullptr && stock.earlier != nullptr && stock.dropped.empty()) {
    EarlierStock same = *stock.earlier;
    same.back = {same.back.rotation * back.rotation, same.back(back.translation)};
    return std::make_shared<const EarlierStock>(std::move(same));
  }
  const auto uncut = stock.uncut != nullptr ? stock.uncut : stock.field;
  const auto blank = stock.cut != nullptr ? stock.cut_blank : uncut;
  if (blank == nullptr && stock.earlier == nullptr && stock.blank_mesh == nullptr) return nullptr;
  return std::make_shared<const EarlierStock>(
      EarlierStock{back, blank, stock.earlier, stock.blank_mesh, stock.cut, stock.dropped});
}

/// None where the moved shape is of another kind.
std::optional<StockShape> movedShape(const StockShape& shape, const RigidTransform& move) {
  const std::optional<AxisMap> map = axisMap(move.rotation);
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    if (!map) return std::nullopt;
    const Box3 moved = move(Box3{box->min, box->max});
    return BoxShape{moved.min, moved.max};
  }
  if (const auto* round = std::get_if<CylinderShape>(&shape)) {
    if (!map) return std::nullopt;
    return movedCylinder(*round, *map, move);
  }
  if (const auto* field = std::get_if<FieldShape>(&shape)) {
    const RigidTransform& place = field->place;
    return FieldShape{field->body, {move.rotation * place.rotation, move(place.translation)}};
  }
  MeshShape mesh = std::get<MeshShape>(shape);
  moveMesh(move, mesh.mesh);
  return mesh;
}

}  // namespace

bool movesExactly(const RigidTransform& move) { return axisMap(move.rotation).has_value(); }

Result<Stock> Stock::moved(const RigidTransform& move, const RemovalOptions& options,
                           Progress& progress) const {
  if (impl_->leaves.empty()) return inputError("nothing is left of the stock that could be moved");
  RemovalOptions at_own_grid = options;
  at_own_grid.resolution_mm = resolution();
  const std::shared_ptr<const EarlierStock> earlier = earlierStock(*impl_, move);
  if (impl_->made_from != nullptr) {
    if (const auto shape = movedShape(*impl_->made_from, move)) return create(*shape, at_own_grid, progress);
  }
  if (const auto map = axisMap(move.rotation)) {
    Stock stock;
    stock.impl_ = std::make_unique<Impl>(ExactMove(*impl_, *map, move).run());
    stock.impl_->earlier = earlier;
    return stock;
  }
  // What the mesh is off, all later clampings are.
  constexpr double kShare = 0.02;
  SurfaceOptions fine;
  fine.simplify_mm = kShare * resolution();
  fine.threads = options.threads;
  Result<StockSurface> surface = this->surface(fine, progress);
  if (!surface) return surface.error();
  MeshShape shape;
  shape.name = "the stock of the clamping before";
  shape.mesh = std::move(surface->mesh);
  shape.mesh.motion.clear();
  moveMesh(move, shape.mesh);
  Result<Stock> stock = create(shape, at_own_grid, progress);
  if (stock) {
    stock->impl_->made_from = nullptr;
    stock->impl_->earlier = earlier;
  }
  return stock;
}

Stock Stock::crossingsAlone() const {
  Stock stock;
  stock.impl_ = std::make_unique<Impl>(ExactMove(*impl_, AxisMap{}, RigidTransform{}).run());
  return stock;
}

}  // namespace proveout
