// The stock less what lies outside of a closed mesh.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <variant>

#include "core/base/assert.h"
#include "core/mesh/triangle_tree.h"
#include "removal/grid/face_numbers.h"
#include "removal/grid/leaf_changes.h"
#include "removal/grid/mesh_rows.h"
#include "removal/grid/stock_impl.h"

namespace proveout {
namespace {

/// The samples of the stock and of the body; where an edge leaves both the crossing nearer to the material
/// counts.
class Intersection {
 public:
  Intersection(Stock::Impl& stock, const TriMesh& body)
      : stock_(stock), body_(body), rows_(body, stock.origin, stock.h) {}

  void run() {
    const std::set<Coord> places = changedLeaves();
    std::vector<LeafChange> changes;
    const LeafReader reader(stock_);
    for (const Coord& place : places) {
      const Coord origin(place.x() * 8, place.y() * 8, place.z() * 8);
      changes.push_back(readLeaf(reader, origin));
      const LeafBits keep = rows_.material(origin);
      for (int z = 0; z < 8; ++z) changes.back().material[z] &= keep[z];
    }
    commitChanges(stock_, addressesOf(changes),
                  [&](std::size_t i, const LeafEdges& edges, const std::vector<Crossing>& before) {
                    return crossings(changes[i], edges, before);
                  });
  }

 private:
  /// Leaves of whose block a sample changes, in leaf coordinates.
  std::set<Coord> changedLeaves() const {
    std::set<Coord> places;
    const LeafReader reader(stock_);
    const auto look = [&](const Coord& leaf) {
      const Coord origin(leaf.x() * 8, leaf.y() * 8, leaf.z() * 8);
      const LeafBits &own = reader.bits(origin), keep = rows_.material(origin);
      bool changes = false;
      for (int z = 0; z < 8; ++z) changes = changes || (own[z] & ~keep[z]) != 0;
      if (!changes) return;
      for (int n = 0; n < 8; ++n) {
        const Coord below = leaf.offsetBy(-(n & 1), -(n >> 1 & 1), -(n >> 2));
        if (stock_.tree.holds(below)) places.insert(below);
      }
    };
    for (const StockLeaf& leaf : stock_.leaves) look(leafCoord(leaf.origin));
    stock_.tree.forEachInside([&](const Coord& low, const Coord& high) {
      for (int x = low.x(); x <= high.x(); ++x)
        for (int y = low.y(); y <= high.y(); ++y)
          for (int z = low.z(); z <= high.z(); ++z) look(Coord(x, y, z));
    });
    return places;
  }

  std::vector<Crossing> crossings(const LeafChange& change, const LeafEdges& edges,
                                  const std::vector<Crossing>& before) const {
    std::vector<Crossing> out;
    out.reserve(edges.count);
    forEachEdge(edges, [&](int axis, int x, int y, int z) {
      const bool from_start = leafSample(change.material, x, y, z);
      const auto nearer = [&](const Crossing& a, const Crossing& b) {
        return from_start ? a.t < b.t : a.t > b.t;
      };
      std::optional<Crossing> best = ofBody(change.origin.offsetBy(x, y, z), axis, from_start);
      if (change.before.isCrossed(axis, x, y, z)) {
        const Crossing& own = before[static_cast<std::size_t>(change.before.indexOf(axis, x, y, z))];
        if (!best || nearer(own, *best)) best = own;
      }
      // A body's wall through the sample itself: its line along z says outside, that along the edge nothing.
      if (!best) best = atSample(axis, from_start);
      out.push_back(*best);
    });
    return out;
  }

  std::optional<Crossing> ofBody(const Coord& start, int axis, bool from_start) const {
    const MeshRows::Meeting* const meeting = rows_.onEdge(start, axis, from_start);
    if (meeting == nullptr) return std::nullopt;
    Crossing c;
    const Vec3 n = rows_.normal(meeting->triangle);
    c.setPosition(std::clamp(meeting->at - start[axis], 0.0, 1.0));
    c.setNormal(n);
    c.element = flatFaceOf(n);
    if (!body_.motion.empty()) c.motion = body_.motion[meeting->triangle];
    return c;
  }

  static Crossing atSample(int axis, bool from_start) {
    Crossing c;
    const Vec3 n = Vec3::Unit(axis) * (from_start ? 1.0 : -1.0);
    c.setPosition(from_start ? 1.0 : 0.0);
    c.setNormal(n);
    c.element = flatFaceOf(n);
    return c;
  }

  Stock::Impl& stock_;
  const TriMesh& body_;
  MeshRows rows_;
};

}  // namespace

Status Stock::keepWithin(const MeshShape& body) {
  if (const Status solid = checkSolid(body); !solid) return solid;
  Intersection(*impl_, body.mesh).run();
  // What lies in an uncut box is the body itself.
  const Box3 bounds = meshBounds(body.mesh);
  const bool whole = impl_->made_from != nullptr && std::holds_alternative<BoxShape>(*impl_->made_from) &&
                     (impl_->blank.min.array() < bounds.min.array()).all() &&
                     (impl_->blank.max.array() > bounds.max.array()).all();
  impl_->blank = {impl_->blank.min.cwiseMax(bounds.min), impl_->blank.max.cwiseMin(bounds.max)};
  impl_->made_from.reset();
  impl_->cut.reset();
  impl_->field.reset();
  impl_->uncut.reset();
  impl_->cut_blank.reset();
  impl_->cut_field.reset();
  impl_->blank_mesh = whole ? std::make_shared<const TriangleTree>(toSurface(body.mesh)) : nullptr;
  impl_->earlier.reset();
  return Done{};
}

}  // namespace proveout
