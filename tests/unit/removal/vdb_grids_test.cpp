// The stock as OpenVDB sees it: its tree under OpenVDB's own means, the grids made of it, and grids as
// blanks.
#include "removal/vdb/vdb_grids.h"

#include <openvdb/tools/LevelSetMeasure.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tree/LeafManager.h>
#include <openvdb/tree/NodeManager.h>

#include <sstream>

#include "core/mesh/tri_mesh.h"
#include "removal/vdb/vdb_extern.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.4;

Vec3 at(const openvdb::math::Transform& transform, const openvdb::Coord& voxel) {
  const openvdb::Vec3d p = transform.indexToWorld(voxel);
  return {p.x(), p.y(), p.z()};
}

/// A block 40 x 30 x 20 below z = 0 with a slot 6 wide and 3 deep along x at y = 12.
class VdbGrids : public ::testing::Test {
 protected:
  VdbGrids() {
    RemovalOptions options;
    options.resolution_mm = kGrid;
    Result<Stock> made = Stock::create(BoxShape{{0, 0, -20}, {40, 30, 0}}, options, progress_);
    PathMaker path;
    path.line({-10, 12, 5}, {-10, 12, -3}).line({-10, 12, -3}, {50, 12, -3});
    EXPECT_TRUE(made.ok() && made->remove(path.path(), {tool("1=flat:6")}, options, progress_).ok());
    stock_ = std::move(*made);
  }
  static bool holds(const Vec3& p) {
    const bool in_blank = p.x() > 0 && p.x() < 40 && p.y() > 0 && p.y() < 30 && p.z() > -20 && p.z() < 0;
    return in_blank && !(std::abs(p.y() - 12.0) < 3.0 && p.z() > -3.0);
  }

  Progress progress_;
  Stock stock_;
};

TEST_F(VdbGrids, EveryActiveVoxelIsMaterialAtItsPlace) {
  const VdbTree& tree = vdbTree(stock_);
  const auto transform = vdbTreeTransform(stock_);
  EXPECT_NEAR(transform->voxelSize().x(), kGrid, 1e-12);
  EXPECT_TRUE(transform->hasUniformScale());
  const openvdb::math::CoordBBox box = [&] {
    openvdb::math::CoordBBox b;
    EXPECT_TRUE(tree.evalActiveVoxelBoundingBox(b));
    b.expand(2);
    return b;
  }();
  std::size_t material = 0;
  for (auto voxel = box.begin(); voxel; ++voxel) {
    const bool inside = holds(at(*transform, *voxel));
    ASSERT_EQ(tree.isValueOn(*voxel), inside) << *voxel;
    ASSERT_EQ(tree.getValue(*voxel), inside) << *voxel;
    material += inside ? 1 : 0;
  }
  EXPECT_EQ(tree.activeVoxelCount(), material);
  std::size_t iterated = 0;
  for (auto it = tree.cbeginValueOn(); it; ++it) iterated += it.getVoxelCount();
  EXPECT_EQ(iterated, material);
}

TEST_F(VdbGrids, OpenVdbsManagersWalkTheTree) {
  const VdbTree& tree = vdbTree(stock_);
  openvdb::tree::LeafManager<const VdbTree> leaves(tree);
  ASSERT_GT(leaves.leafCount(), 500u);
  std::vector<int> named(leaves.leafCount(), 0);
  std::atomic<std::size_t> in_leaves{0};
  leaves.foreach ([&](const StockLeafNode& leaf, std::size_t) { in_leaves += leaf.onVoxelCount(); });
  for (std::size_t i = 0; i < leaves.leafCount(); ++i) ++named.at(leaves.leaf(i).transientData());
  EXPECT_EQ(named, std::vector<int>(leaves.leafCount(), 1)) << "every leaf has the number of one record";
  EXPECT_EQ(in_leaves, tree.activeLeafVoxelCount());
  openvdb::tree::NodeManager<const VdbTree> nodes(tree);
  EXPECT_GT(nodes.nodeCount(), leaves.leafCount());
  openvdb::tree::ValueAccessor<const VdbTree> read(tree);
  const openvdb::Coord some = leaves.leaf(7).origin();
  EXPECT_EQ(read.probeConstLeaf(some), &leaves.leaf(7));
  EXPECT_EQ(tree.probeConstLeaf(some), &leaves.leaf(7));
  EXPECT_EQ(tree.probeConstNode<StockLeafNode>(some), &leaves.leaf(7));
}

TEST_F(VdbGrids, TopologyGoesToOpenVdbsOwnTrees) {
  const VdbTree& tree = vdbTree(stock_);
  openvdb::MaskTree mask(tree, false, true, openvdb::TopologyCopy());
  EXPECT_EQ(mask.activeVoxelCount(), tree.activeVoxelCount());
  EXPECT_TRUE(mask.hasSameTopology(tree));
  openvdb::FloatTree numbers(0.0f);
  numbers.fill({openvdb::Coord(0), openvdb::Coord(40)}, 1.0f);
  const auto own = numbers.activeVoxelCount();
  openvdb::FloatTree common(numbers);
  common.topologyIntersection(tree);
  numbers.topologyUnion(tree);
  EXPECT_EQ(numbers.activeVoxelCount() + common.activeVoxelCount(), own + tree.activeVoxelCount());
  VdbTree copy(tree);
  EXPECT_EQ(copy.leafCount(), tree.leafCount());
  copy.prune();
  EXPECT_EQ(copy.activeVoxelCount(), tree.activeVoxelCount());
}

TEST_F(VdbGrids, FilesOfTheTreeAreRefusedNotWrittenWrong) {
  std::ostringstream out;
  EXPECT_THROW(vdbTree(stock_).writeTopology(out), openvdb::NotImplementedError);
  EXPECT_NE(vdbTree(stock_).type(), openvdb::MaskTree::treeType());
  vdbTree(stock_).print(out);
  EXPECT_NE(out.str().find("voxels of material"), std::string::npos);
}

TEST_F(VdbGrids, TheLevelSetHoldsDistances) {
  const auto grid = levelSet(stock_, 3.0, progress_);
  ASSERT_TRUE(grid.ok()) << grid.error().message;
  std::size_t looked = 0;
  for (auto it = (*grid)->cbeginValueOn(); it; ++it) {
    const Vec3 p = at((*grid)->transform(), it.getCoord());
    ASSERT_EQ(it.getValue() < 0.0f, holds(p)) << p.transpose();
    // Beside one face only, far from edges.
    if (p.x() < 3 || p.x() > 37 || p.y() < 20 || p.y() > 25) continue;
    const double floor = -20.0 - p.z(), top = p.z();
    ASSERT_NEAR(it.getValue(), std::max(floor, top), 2e-6) << p.transpose();
    ++looked;
  }
  EXPECT_GT(looked, 5000u);
  EXPECT_NEAR(openvdb::tools::levelSetVolume(**grid), stock_.volume({}, progress_)->mm3, 30.0);
  EXPECT_FALSE(levelSet(stock_, 0.5, progress_).ok());
  EXPECT_FALSE(levelSet(stock_, std::nan(""), progress_).ok());
}

TEST(VdbGridsOfATurnedShape, TheLevelSetFollowsACylinder) {
  RemovalOptions options;
  options.resolution_mm = 0.2;
  Progress progress;
  const auto stock = Stock::create(CylinderShape{2, {1, 2, 0}, 8.0, 0.0, 12.0}, options, progress);
  const auto grid = levelSet(*stock, 4.0, progress);
  ASSERT_TRUE(grid.ok());
  const double chord = 0.2 * 0.2 / (8 * 8.0) * 2.0;
  for (auto it = (*grid)->cbeginValueOn(); it; ++it) {
    const Vec3 p = at((*grid)->transform(), it.getCoord());
    if (p.z() < 2 || p.z() > 10) continue;
    ASSERT_NEAR(it.getValue(), std::hypot(p.x() - 1, p.y() - 2) - 8.0, chord) << p.transpose();
  }
  const double area = 2 * kPi * 8 * 12 + 2 * kPi * 64;
  EXPECT_NEAR(openvdb::tools::levelSetArea(**grid), area, 0.02 * area);
}

TEST_F(VdbGrids, ProvenanceNamesTheMotion) {
  const auto grid = provenance(stock_);
  std::size_t slot = 0, blank = 0;
  for (auto it = grid->cbeginValueOn(); it; ++it) {
    const Vec3 p = at(grid->transform(), it.getCoord());
    const bool in_floor = std::abs(p.y() - 12) < 2 && p.z() > -4 && p.x() > 1 && p.x() < 39;
    const bool at_bottom = p.z() < -19 && p.x() > 1 && p.x() < 39 && p.y() > 1 && p.y() < 29;
    if (in_floor) {
      ASSERT_EQ(it.getValue(), 1) << p.transpose();
    }
    if (at_bottom) {
      ASSERT_EQ(it.getValue(), -1) << p.transpose();
    }
    slot += in_floor ? 1 : 0;
    blank += at_bottom ? 1 : 0;
  }
  EXPECT_GT(slot, 500u);
  EXPECT_GT(blank, 5000u);
}

TEST(VdbBlank, ALevelSetIsCutOnAnyGrid) {
  const auto sphere =
      openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(9.0f, {3.0f, -2.0f, 1.0f}, 0.15f, 3.0f);
  const auto shape = blankOf(sphere);
  ASSERT_TRUE(shape.ok()) << shape.error().message;
  const Cut whole = cut(*shape, Toolpath{}, {tool("1=flat:6")}, 0.25);
  const double exact = 4.0 / 3.0 * kPi * std::pow(9.0, 3);
  EXPECT_NEAR(whole.volume, exact, 5e-4 * exact);
  for (const auto& p : whole.mesh.positions)
    ASSERT_NEAR((p.cast<double>() - Vec3(3, -2, 1)).norm(), 9.0, 0.005);
  // The upper half goes.
  PathMaker path;
  path.line({-20, -2, 1}, {20, -2, 1});
  const Cut half = cut(*shape, path.path(), {tool("1=flat:30")}, 0.25);
  EXPECT_NEAR(half.volume, 0.5 * exact, 1e-3 * exact);
}

TEST(VdbBlank, TheStocksOwnLevelSetComesBack) {
  RemovalOptions options;
  options.resolution_mm = 0.25;
  Progress progress;
  const auto stock = Stock::create(CylinderShape{0, {0, 0, 0}, 6.0, 2.0, 15.0}, options, progress);
  const auto shape = blankOf(*levelSet(*stock, 3.0, progress));
  ASSERT_TRUE(shape.ok());
  const auto again = Stock::create(*shape, options, progress);
  ASSERT_TRUE(again.ok()) << again.error().message;
  const double volume = kPi * 32 * 15;
  EXPECT_NEAR(again->volume({}, progress)->mm3, volume,
              4e-3 * volume);  // its edges are rounded within a voxel
}

TEST(VdbBlank, AMaskIsABlank) {
  openvdb::MaskGrid mask;
  mask.setTransform(openvdb::math::Transform::createLinearTransform(0.5));
  mask.denseFill({openvdb::Coord(0), openvdb::Coord(19, 29, 39)}, true);
  const auto shape = blankOf(mask);
  ASSERT_TRUE(shape.ok()) << shape.error().message;
  const Cut whole = cut(*shape, Toolpath{}, {tool("1=flat:6")}, 0.5);
  EXPECT_NEAR(whole.volume, 10 * 15 * 20, 0.01 * 10 * 15 * 20);
}

TEST(VdbBlank, WhatIsNoBlankIsRefused) {
  const auto refused = [](openvdb::FloatGrid::Ptr grid) {
    const auto shape = blankOf(openvdb::FloatGrid::ConstPtr(grid));
    return shape.ok() ? std::string() : shape.error().message;
  };
  const auto sphere = [](float band) {
    return openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(5.0f, {0.0f, 0.0f, 0.0f}, 0.5f, band);
  };
  EXPECT_NE(refused(nullptr).find("no level set"), std::string::npos);
  EXPECT_NE(refused(openvdb::FloatGrid::create(1.0f)).find("no level set"), std::string::npos);
  EXPECT_NE(refused(sphere(1.5f)).find("two voxels"), std::string::npos);
  auto stretched = sphere(3.0f);
  stretched->transform().preScale(openvdb::Vec3d(1, 2, 1));
  EXPECT_NE(refused(stretched).find("one size"), std::string::npos);
  auto bad = sphere(3.0f);
  bad->tree().setValueOn(openvdb::Coord(0, 0, 10), std::nanf(""));
  EXPECT_NE(refused(bad).find("not a number"), std::string::npos);
  auto nothing = openvdb::FloatGrid::create(1.5f);
  nothing->setGridClass(openvdb::GRID_LEVEL_SET);
  nothing->setTransform(openvdb::math::Transform::createLinearTransform(0.5));
  EXPECT_NE(refused(nothing).find("nothing is inside"), std::string::npos);
  EXPECT_FALSE(blankOf(openvdb::MaskGrid()).ok());
}

}  // namespace
}  // namespace proveout::test
