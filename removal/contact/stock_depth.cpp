#include "removal/contact/stock_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {
namespace {

/// A crossing stands for a disc of the surface with this radius, share of the grid: those of neighbouring
/// grid lines meet.
constexpr double kDiscShare = 0.75;

}  // namespace

StockDepth::StockDepth(const Stock::Impl& stock, const BlankField* blank, const PassTable& table,
                       const CutterIndex& cutters)
    : stock_(stock), blank_(blank), table_(table), cutters_(cutters) {}

StockDepth::Sample StockDepth::at(const Vec3& p, MotionId motion, const SweptCutter*& hint) const {
  Sample best = blank_ != nullptr ? ofBlank(p) : ofBounds(p);
  if (best.value <= 0.0) return best;
  const CutterIndex::Near cut = cutters_.nearest(p, motion, best.value, hint);
  if (cut.body != nullptr) {
    hint = cut.body;
    best = {cut.distance, cut.body->sweep(table_).sample(p).gradient};
  }
  return blank_ != nullptr || best.value <= 0.0 ? best : ofCrossings(p, best);
}

StockDepth::Sample StockDepth::ofBlank(const Vec3& p) const {
  const BlankSample s = blank_->sample(p);
  return {-s.value, -s.normal};
}

/// The stock is no larger than its blank's bounds.
StockDepth::Sample StockDepth::ofBounds(const Vec3& p) const {
  Sample best{std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = p[axis] - stock_.blank.min[axis], high = stock_.blank.max[axis] - p[axis];
    if (low < best.value) best = {low, Vec3::Unit(axis)};
    if (high < best.value) best = {high, -Vec3::Unit(axis)};
  }
  return best;
}

double StockDepth::mostIn(const Vec3& middle, const Vec3& half) const {
  // Of the whole blank: a window's grid holds a part of it.
  const Box3 sides = blank_ != nullptr ? blank_->bounds() : stock_.blank;
  const Vec3 off = (middle - sides.center()).cwiseAbs() - half;
  return (0.5 * sides.size() - off.cwiseMax(0.0)).minCoeff();
}

void StockDepth::lookAt(const StockLeaf& leaf, const Vec3& p, Sample& best, double& nearest) const {
  const LeafReader reader(stock_);
  std::size_t next = 0;
  forEachEdge(reader.edges(leaf), [&](int axis, int x, int y, int z) {
    const Crossing& crossing = leaf.crossings[next++];
    Vec3 at = stock_.position(leaf.origin.offsetBy(x, y, z));
    at[axis] += static_cast<double>(crossing.t) * stock_.h;
    const Vec3 to = p - at;
    const double disc = kDiscShare * stock_.h;
    if (to.squaredNorm() >= (nearest + disc) * (nearest + disc)) return;
    const Vec3 normal = crossing.unitNormal();
    const double height = normal.dot(to);
    const double beside = std::max(0.0, (to - height * normal).norm() - disc);
    const double distance = std::sqrt(height * height + beside * beside);
    if (distance >= nearest) return;
    nearest = distance;
    best = {height > 0.0 ? -distance : distance, -normal};
  });
}

/// Rings of leaves around the point's, until no crossing in the next one can be nearer than `best`.
StockDepth::Sample StockDepth::ofCrossings(const Vec3& p, Sample best) const {
  const double size = 8.0 * stock_.h;
  const Vec3 local = (p - stock_.origin) / size;
  const Coord middle(static_cast<int>(std::floor(local.x())), static_cast<int>(std::floor(local.y())),
                     static_cast<int>(std::floor(local.z())));
  const LeafReader reader(stock_);
  double nearest = best.value;
  for (int ring = 0; (ring - 1) * size - kDiscShare * stock_.h < nearest; ++ring) {
    for (int x = -ring; x <= ring; ++x) {
      for (int y = -ring; y <= ring; ++y) {
        const bool side = std::abs(x) == ring || std::abs(y) == ring;
        for (int z = -ring; z <= ring; z += side || ring == 0 ? 1 : 2 * ring) {
          const Coord leaf = middle.offsetBy(x, y, z), origin(8 * leaf.x(), 8 * leaf.y(), 8 * leaf.z());
          const StockLeaf* found = reader.leaf(origin);
          if (found == nullptr) continue;
          const Vec3 low = stock_.position(origin);
          const Vec3 off = (low - p).cwiseMax(p - low - Vec3::Constant(size)).cwiseMax(Vec3::Zero());
          if (off.norm() - kDiscShare * stock_.h < nearest) lookAt(*found, p, best, nearest);
        }
      }
    }
  }
  return best;
}

}  // namespace proveout
