// Material that no crossing shows: the grid has no sample in it, and its vertices stand beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "removal/process/milled_piece.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.25, kVolume = 1e-5;

/// One tooth of a thread mill: a disc with an edge of 60 degrees and a flat crest.
Tool tooth() {
  Tool tool;
  tool.number = 1;
  tool.type = ToolType::kThreadMill;
  tool.diameter = 7.4;
  tool.root_diameter = 3.4;
  tool.pitch = 3.3;
  tool.teeth = 1;
  tool.crest_flat = 0.66;
  return tool;
}

/// A slot across a block, whose crest ends `lip` below the top: what hangs over it there is thinner than the
/// grid.
struct LippedSlot {
  LippedSlot(double lip, double angle_deg) {
    const Tool tool = tooth();
    const double slope = std::tan(degToRad(30.0)), crest = 0.5 * tool.diameter,
                 root = 0.5 * tool.root_diameter;
    const double flank = (crest - root) * slope, z = -lip - tool.crest_flat - flank;
    const double lower = flank * (crest + root), upper = lip * (2.0 * crest - lip / slope);
    const double cosine = std::cos(degToRad(angle_deg)), length = 24.13;
    exact = (lower + 2.0 * crest * tool.crest_flat + upper) * length / cosine;
    const Vec3 along(cosine, std::sin(degToRad(angle_deg)), 0.0), middle(12.0, 15.017, z);
    path = PathMaker().line(middle - 22.0 * along, middle + 22.0 * along).path();
    block = {{12.0 - 0.5 * length, 0.0, -6.1}, {12.0 + 0.5 * length, 30.0, 0.0}};
  }
  BoxShape block;
  Toolpath path;
  double exact;
};

StockSurface surfaceOf(const LippedSlot& slot, int threads) {
  RemovalOptions options;
  options.resolution_mm = kGrid;
  options.threads = threads;
  Progress progress;
  Result<Stock> stock = Stock::create(slot.block, options, progress);
  EXPECT_TRUE(stock.ok());
  EXPECT_TRUE(stock->remove(slot.path, {tooth()}, options, progress).ok());
  Result<StockSurface> surface = stock->surface(threads, progress);
  EXPECT_TRUE(surface.ok());
  return std::move(*surface);
}

TEST(UnseenVolume, LipsOverATooth) {
  for (const double lip : {0.03, 0.07, 0.11}) {
    for (const double angle : {0.0, 3.0, 17.0}) {
      const LippedSlot slot(lip, angle);
      const double block = (slot.block.max - slot.block.min).prod();
      const StockSurface surface = surfaceOf(slot, 1);
      const double seen = (block - surface.volume_mm3) / slot.exact - 1.0,
                   all = (block - surface.volume_mm3 - surface.unseen_mm3) / slot.exact - 1.0;
      std::printf("lip of %.2f mm, %4.1f degrees: %8.1e, without what no crossing shows %8.1e; thin %zu\n",
                  lip, angle, all, seen, surface.thin_cells);
      EXPECT_LT(std::abs(all), kVolume) << lip << ' ' << angle;
    }
  }
}

TEST(UnseenVolume, DoesNotDependOnThreads) {
  const LippedSlot slot(0.07, 17.0);
  const StockSurface one = surfaceOf(slot, 1), four = surfaceOf(slot, 4);
  EXPECT_NE(one.unseen_mm3, 0.0);
  EXPECT_EQ(one.unseen_mm3, four.unseen_mm3);
  EXPECT_EQ(one.volume_error_mm3, four.volume_error_mm3);
  EXPECT_EQ(one.thin_cells, four.thin_cells);
}

TEST(UnseenVolume, MeetsNothingWhereFacesGoOn) {
  RemovalOptions options;
  options.resolution_mm = kGrid;
  Progress progress;
  Result<Stock> stock = Stock::create(BoxShape{{0, 0, -6.1}, {20.07, 30, 0}}, options, progress);
  ASSERT_TRUE(stock.ok());
  const Vec3 a(-5, 15, -2.03), b(11, 15, -2.03), c(14, 40, -2.03);
  const Toolpath path = PathMaker().line(a, b).line(b, c).path();
  ASSERT_TRUE(stock->remove(path, {tool("1=flat:7.3")}, options, progress).ok());
  const Result<StockSurface> surface = stock->surface(1, progress);
  ASSERT_TRUE(surface.ok());
  EXPECT_EQ(surface->unseen_mm3, 0.0);
  EXPECT_EQ(surface->thin_cells, 0u);
}

/// Small tubes with walls thinner than the grid: what the grid holds of them stays as long as nothing is cut.
TEST(UnseenVolume, IsNothingWhereNoToolCame) {
  int thin = 0;
  for (int i = 0; i < 12; ++i) {
    RemovalOptions options;
    options.resolution_mm = kGrid;
    Progress progress;
    const double radius = 0.35 + 0.03 * i;
    Result<Stock> stock =
        Stock::create(CylinderShape{2, {0.07, 0.03, 0.02}, radius, radius - 0.15, 0.4}, options, progress);
    if (!stock) continue;  // nothing of it is on the grid
    const double before = stock->volume({}, progress)->mm3;
    const Toolpath path = PathMaker().line({-20, 8, 0}, {20, 8, 0}).path();
    ASSERT_TRUE(stock->remove(path, {tool("1=flat:3")}, options, progress).ok());
    const Result<StockSurface> surface = stock->surface(1, progress);
    ASSERT_TRUE(surface.ok());
    thin += surface->thin_cells > 0 && surface->thin_cells <= 10 ? 1 : 0;
    EXPECT_EQ(surface->volume_mm3, before);
    EXPECT_EQ(surface->unseen_mm3, 0.0);
  }
  EXPECT_GT(thin, 0);
}

/// The second path finds lips that it did not make: what they hold stays counted.
TEST(UnseenVolume, IsReportedOnce) {
  const LippedSlot slot(0.07, 3.0);
  PieceOptions options;
  options.grid.resolution_mm = kGrid;
  Progress progress;
  Result<Stock> stock = Stock::create(slot.block, options.grid, progress);
  ASSERT_TRUE(stock.ok());
  MilledPiece piece(std::move(*stock), false);
  const Result<Machined> first = piece.machine(slot.path, {tooth()}, options, progress);
  ASSERT_TRUE(first.ok());
  const double block = (slot.block.max - slot.block.min).prod();
  EXPECT_NEAR(block - first->surface.volume_mm3, slot.exact, kVolume * slot.exact);
  const auto next = piece.become(ProcessKind::kMilling, RigidTransform{}, options, progress);
  ASSERT_TRUE(next.ok());
  const Toolpath above = PathMaker().line({0, 4, 5}, {20, 4, 5}).path();
  const Result<Machined> second = (*next)->machine(above, {tooth()}, options, progress);
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(second->surface.volume_mm3, first->surface.volume_mm3);
}

}  // namespace
}  // namespace proveout::test
