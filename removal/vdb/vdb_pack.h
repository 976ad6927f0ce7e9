// What every OpenVDB grid of a stock is made from. Only for the sources of the module and of vdb_grids.
#pragma once

#include <openvdb/openvdb.h>

#include "removal/grid/stock_impl.h"
#include "removal/vdb/vdb_coord.h"

namespace proveout {

/// From the voxels of the grid into the workpiece frame.
inline openvdb::math::Transform::Ptr gridTransform(const Stock::Impl& impl) {
  auto transform = openvdb::math::Transform::createLinearTransform(impl.h);
  transform->postTranslate(openvdb::Vec3d(impl.origin.x(), impl.origin.y(), impl.origin.z()));
  return transform;
}

/// Calls body(crossing, axis, sample, next sample along the axis) for every edge that the surface crosses,
/// leaf by leaf in the order of StockLeaf::crossings.
template <typename Body>
void forEachCrossing(const Stock::Impl& impl, Body&& body) {
  const LeafReader reader(impl);
  for (const StockLeaf& leaf : impl.leaves) {
    std::size_t next = 0;
    forEachEdge(reader.edges(leaf), [&](int axis, int x, int y, int z) {
      const Coord at = leaf.origin.offsetBy(x, y, z);
      body(leaf.crossings[next++], axis, at, at.offsetBy(axis == 0, axis == 1, axis == 2));
    });
  }
}

/// `background` outside, minus it inside, by the samples; no voxel is active. A leaf of the stock is a leaf
/// of the grid.
inline openvdb::FloatGrid::Ptr sidesOf(const Stock::Impl& impl, float background) {
  auto grid = openvdb::FloatGrid::create(background);
  impl.tree.forEachInside([&](const Coord& low, const Coord& high) {
    grid->fill(openvdb::CoordBBox(openvdb::Coord(low.x() * 8, low.y() * 8, low.z() * 8),
                                  openvdb::Coord(high.x() * 8 + 7, high.y() * 8 + 7, high.z() * 8 + 7)),
               -background, false);
  });
  for (const StockLeaf& leaf : impl.leaves) {
    auto* node = grid->tree().touchLeaf(toVdb(leaf.origin));
    for (int v = 0; v < 512; ++v) {
      const bool inside = leafSample(leaf.material(), v >> 6, v >> 3 & 7, v & 7);
      node->setValueOff(static_cast<openvdb::Index>(v), inside ? -background : background);
    }
  }
  return grid;
}

}  // namespace proveout
