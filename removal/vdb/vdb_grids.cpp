#include "removal/vdb/vdb_grids.h"

#include <openvdb/tools/Morphology.h>
#include <openvdb/tree/LeafManager.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/mesh/signed_distance.h"
#include "removal/grid/stock_nodes.h"
#include "removal/vdb/vdb_extern.h"
#include "removal/vdb/vdb_pack.h"

namespace proveout {

namespace {

constexpr double kMostHalfWidth = 100.0;

/// The samples that are nearer to the surface than `half_width`, and more.
openvdb::MaskTree bandOf(const Stock::Impl& impl, double half_width) {
  openvdb::MaskTree band;
  openvdb::tree::ValueAccessor<openvdb::MaskTree> write(band);
  forEachCrossing(impl, [&](const Crossing&, int, const Coord& a, const Coord& b) {
    write.setValueOn(toVdb(a));
    write.setValueOn(toVdb(b));
  });
  openvdb::tools::dilateActiveValues(band, static_cast<int>(std::ceil(half_width)),
                                     openvdb::tools::NN_FACE_EDGE_VERTEX, openvdb::tools::EXPAND_TILES);
  return band;
}

}  // namespace

const VdbTree& vdbTree(const Stock& stock) { return stock.inside().tree.nodes().tree; }

openvdb::math::Transform::Ptr vdbTreeTransform(const Stock& stock) {
  const Stock::Impl& impl = stock.inside();
  const Coord low = impl.tree.nodes().low;
  const Vec3 first = impl.position({8 * low.x(), 8 * low.y(), 8 * low.z()});
  // Rows are the images of the axes of the index space (OpenVDB multiplies rows by matrices): z, x, y.
  const double h = impl.h;
  return openvdb::math::Transform::createLinearTransform(openvdb::Mat4d(
      0.0, 0.0, h, 0.0, h, 0.0, 0.0, 0.0, 0.0, h, 0.0, 0.0, first.x(), first.y(), first.z(), 1.0));
}

Result<openvdb::FloatGrid::Ptr> levelSet(const Stock& stock, double half_width, Progress& progress) {
  if (!(half_width >= 1.0 && half_width <= kMostHalfWidth))
    return inputError("level set: the band must be 1 to 100 voxels wide on either side");
  const Stock::Impl& impl = stock.inside();
  if (impl.leaves.empty()) return inputError("level set: nothing is left of the stock");
  SurfaceOptions options;
  options.simplify_mm = 0.0;
  const Result<StockSurface> made = stock.surface(options, progress);
  if (!made) return made.error();
  const SurfaceMesh mesh = toSurface(made->mesh);
  const SignedDistance surface(mesh);
  const double most = half_width * impl.h;
  const openvdb::FloatGrid::Ptr grid = sidesOf(impl, static_cast<float>(most));
  grid->setTransform(gridTransform(impl));
  const openvdb::MaskTree band = bandOf(impl, half_width);
  for (auto leaf = band.cbeginLeaf(); leaf; ++leaf) grid->tree().touchLeaf(leaf->origin());
  openvdb::tree::LeafManager<openvdb::FloatTree> leaves(grid->tree());
  leaves.foreach ([&](openvdb::FloatTree::LeafNodeType& leaf, std::size_t) {
    const auto* wanted = band.probeConstLeaf(leaf.origin());
    if (wanted == nullptr || progress.cancelled()) return;
    for (auto it = wanted->cbeginValueOn(); it; ++it) {
      const double distance = std::abs(surface.at(impl.position(fromVdb(it.getCoord()))).distance);
      if (distance >= most) continue;
      const auto value = static_cast<float>(distance);
      leaf.setValueOn(it.pos(), leaf.getValue(it.pos()) < 0.0f ? -value : value);
    }
  });
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  grid->setName("distance");
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  return grid;
}

openvdb::Int32Grid::Ptr provenance(const Stock& stock) {
  const Stock::Impl& impl = stock.inside();
  auto grid = openvdb::Int32Grid::create(-1);
  auto nearest = openvdb::FloatGrid::create(2.0f);
  auto write = grid->getAccessor();
  auto distance = nearest->getAccessor();
  forEachCrossing(impl, [&](const Crossing& c, int axis, const Coord& a, const Coord& b) {
    const auto across = static_cast<float>(std::abs(c.unitNormal()[axis]));
    const MotionId motion = knownMotion(c.motion);
    for (const auto& [sample, part] : {std::pair{a, c.t}, std::pair{b, 1.0f - c.t}}) {
      const openvdb::Coord at = toVdb(sample);
      if (part * across >= distance.getValue(at)) continue;
      distance.setValue(at, part * across);
      write.setValue(at, motion == kNoMotion ? -1 : static_cast<std::int32_t>(motion));
    }
  });
  grid->setTransform(gridTransform(impl));
  grid->setName("motion");
  return grid;
}

}  // namespace proveout
