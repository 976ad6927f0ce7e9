// The part of SurfaceGrid that repair uses: cells that are separated from others, and vertices that may be
// in the way of other surface.
#include <algorithm>

#include "core/base/assert.h"
#include "core/geometry/to_float.h"
#include "removal/grid/leaf_layers.h"
#include "removal/surface/cell/cell_cycles.h"
#include "removal/surface/cell/surface_grid.h"

namespace proveout {

namespace {

/// Vertices outside by kSoftReach at most (in cells), as on shallow feature edges, are in nothing's way as
/// long as they stay kRoom before the vertex beyond the wall.
constexpr float kSoftReach = 0.051f, kRoom = 0.02f;
}  // namespace

bool SurfaceGrid::crowds(const SurfaceLeaf& leaf, int place) const {
  const Coord at = leaf.stock->origin.offsetBy(place >> 3 & 7, place & 7, place >> 6);
  const Eigen::Vector3f to_leaf = toFloat(stepsBetween(at, leaf.stock->origin));
  const Eigen::Vector3f p = vertices_[leaf.cellAt(place)] + to_leaf;
  int axis = -1, side = 0;
  for (int k = 0; k < 3; ++k) {
    if (p[k] >= 0.0f && p[k] <= 1.0f) continue;
    if (axis >= 0 || p[k] < -kSoftReach || p[k] > 1.0f + kSoftReach) return true;
    axis = k;
    side = p[k] < 0.0f ? -1 : 1;
  }
  if (axis < 0) return false;
  Coord entered = at;
  entered[axis] += side;
  const std::int32_t number = LeafReader(impl_).state(entered & ~7);
  if (number < 0) return false;
  const SurfaceLeaf& other = leaves_[static_cast<std::size_t>(number)];
  const int x = entered.x() & 7, y = entered.y() & 7, z = entered.z() & 7;
  if ((other.mixed[z] >> leafBit(x, y) & 1) == 0) return false;
  const std::uint32_t cell = other.base + static_cast<std::uint32_t>(other.rank(x, y, z));
  if ((traits_[cell] & CellTraits::kManySheets) != 0) return true;
  const auto between = toFloat(stepsBetween(at, other.stock->origin)[axis]);
  return toFloat(side) * (vertices_[cell][axis] + between - p[axis]) < kRoom;
}

/// Moves the vertices of the sheets to the middle of their crossings: as planes between corners separate the
/// sheets, the cones over straight lines on the walls then do not meet.
void SurfaceGrid::drawSheetsIn(SurfaceLeaf& leaf, std::uint32_t cell, const Coord& at) {
  const CellCycles cycles = cellCycles(shapes_[cell]);
  std::array<Eigen::Vector3f, 4> sum;
  std::array<float, 4> count{};
  sum.fill(Eigen::Vector3f::Zero());
  for (int edge = 0; edge < 12; ++edge) {
    const int sheet = cycles.cycle_of_edge[edge];
    if (sheet < 0) continue;
    const int corner = edgeStartCorner(edge), axis = edge / 4;
    Eigen::Vector3f p(toFloat(corner & 1), toFloat(corner >> 1 & 1), toFloat(corner >> 2));
    p[axis] += toFloat(crossingOn(axis, at.offsetBy(corner & 1, corner >> 1 & 1, corner >> 2)));
    sum[sheet] += p;
    count[sheet] += 1.0f;
  }
  const Eigen::Vector3f origin = toFloat(stepsBetween(leaf.stock->origin, at));
  vertices_[cell] = origin + sum[0] / count[0];
  for (ExtraVertex& extra : leaf.extra) {
    if (extra.cell == cell - leaf.base) extra.p = origin + sum[extra.sheet] / count[extra.sheet];
  }
}

bool SurfaceGrid::wall(std::uint32_t cell) {
  const bool many = (traits_[cell] & CellTraits::kManySheets) != 0;
  if ((traits_[cell] & (many ? CellTraits::kDrawnIn : CellTraits::kWalled)) != 0) return false;
  if ((traits_[cell] & CellTraits::kWalled) != 0) traits_[cell] |= CellTraits::kDrawnIn;
  traits_[cell] |= CellTraits::kWalled;
  SurfaceLeaf& leaf = leaves_[leafOf(cell)];
  const int place = leaf.placeOf(static_cast<int>(cell - leaf.base));
  const int x = place >> 3 & 7, y = place & 7, z = place >> 6;
  if ((traits_[cell] & CellTraits::kDrawnIn) != 0) {
    drawSheetsIn(leaf, cell, leaf.stock->origin.offsetBy(x, y, z));
    return true;
  }
  if ((traits_[cell] & CellTraits::kOutside) != 0) {
    const auto left = std::find_if(leaf.outside.begin(), leaf.outside.end(),
                                   [&](const OutsideVertex& o) { return o.place == place; });
    PROVEOUT_ASSERT(left != leaf.outside.end());
    vertices_[cell] = left->inside;
    traits_[cell] &= static_cast<std::uint16_t>(~CellTraits::kOutside);
    leaf.outside.erase(left);
  }
  const Eigen::Vector3f low(toFloat(x), toFloat(y), toFloat(z));
  const auto keepInside = [&](Eigen::Vector3f& p) {
    constexpr auto kGap = toFloat(kEndGap);
    p = p.cwiseMax(low + Eigen::Vector3f::Constant(kGap))
            .cwiseMin(low + Eigen::Vector3f::Constant(1.0f - kGap));
  };
  keepInside(vertices_[cell]);
  for (ExtraVertex& extra : leaf.extra) {
    if (many && extra.cell == cell - leaf.base) keepInside(extra.p);
  }
  return true;
}

}  // namespace proveout
