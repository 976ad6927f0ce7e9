// What is thinner than the grid: it is in the volume, or it is reported.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.2;

struct Wall {
  double thickness, offset, angle_deg;
  bool through;
};

/// Two slots along a direction, the wall between them through `offset` mm beside the middle of a 26 x 26 x 6
/// block.
struct TwoSlots {
  explicit TwoSlots(const Wall& wall, int threads = 2) {
    const double angle = wall.angle_deg * kPi / 180, z = wall.through ? -7.0 : -3.0;
    const Vec3 along(std::cos(angle), std::sin(angle), 0), side(-along.y(), along.x(), 0);
    const Vec3 middle = wall.offset * side + Vec3(0, 0, z);
    const double away = 2.0 + 0.5 * wall.thickness;
    PathMaker p;
    p.line(middle + away * side - 8 * along, middle + away * side + 8 * along);
    p.line(middle - away * side + 8 * along, middle - away * side - 8 * along);
    c = cut(BoxShape{{-13, -13, -6}, {13, 13, 0}}, p.path(), {tool("1=flat:4")}, kGrid, threads);
    depth = wall.through ? 6.0 : 3.0;
    // Between the straight flanks, and the two wedges at either end where the tool's circle stood.
    const double slot = 4.0 * 16 + kPi * 4;
    missing = c.volume - (c.initial - 2 * slot * depth);
    area = 16 * depth;
  }
  Cut c;
  double depth, missing, area;
};

class ThinWalls : public ::testing::TestWithParam<double> {};

TEST_P(ThinWalls, AlongAnAxisAreHeldOrReported) {
  const double thickness = GetParam();
  int lost = 0;
  for (const double angle : {0.0, 90.0}) {
    for (int i = 0; i < 10; i += 3) {
      const TwoSlots s({thickness, 0.02 * i + 0.003, angle, i % 2 == 0});
      const double film = s.c.summary.lost_film_mm2;
      if (std::abs(s.missing) < 0.02 * s.area * thickness) {
        EXPECT_EQ(film, 0.0) << angle << ' ' << i;
        continue;
      }
      ++lost;
      // At either end the wall widens between the tool's circles: a piece of that is lost with it.
      const double ends = 2 * 0.06 * s.depth;
      EXPECT_NEAR(s.missing, -s.area * thickness, 0.02 * s.area * thickness + ends) << angle << ' ' << i;
      EXPECT_NEAR(film, s.area, 0.2 * s.area) << angle << ' ' << i;  // the lowest row stands on the floor
      const double across = angle == 0.0 ? s.c.summary.lost_film_at.y() : s.c.summary.lost_film_at.x();
      EXPECT_NEAR(std::abs(across), 0.02 * i + 0.003, 0.5 * kGrid) << angle << ' ' << i;
    }
  }
  EXPECT_EQ(lost > 0, thickness < kGrid);
}

TEST_P(ThinWalls, AcrossTheGridAreHeldOrReported) {
  const double thickness = GetParam();
  for (const double angle : {7.0, 30.0, 45.0, 63.0, 135.0}) {
    const TwoSlots s({thickness, 0.07, angle, false});
    const double film = s.c.summary.lost_film_mm2, volume = s.area * thickness;
    const bool held = std::abs(s.missing) < 0.05 * volume;
    // Single samples within the wall: its cells hold more than one sheet.
    const bool reported = film > 0.2 * s.area * (1.0 - thickness / kGrid) || s.c.thin_cells > 100;
    EXPECT_TRUE(held || reported) << angle << ": " << s.missing / volume << ' ' << film << ' '
                                  << s.c.thin_cells;
    EXPECT_LT(film, 1.6 * s.area) << angle;
    if (thickness > 1.45 * kGrid) {
      EXPECT_EQ(film, 0.0) << angle;
    }
  }
}

// Of each square of samples two opposite ones are in the wall: material goes through between them. The wall was
// a row of pillars, without up to two thirds of its volume.
TEST(ThinWalls, AlongADiagonalThroughSamplesAreWhole) {
  for (const double thickness : {0.1, 0.18}) {
    for (const double angle : {45.0, 135.0}) {
      const TwoSlots s({thickness, 0.0, angle, false});
      EXPECT_LT(std::abs(s.missing), 0.02 * s.area * thickness) << thickness << ' ' << angle;
      const MeshTopology topology = analyseTopology(s.c.mesh);
      EXPECT_TRUE(topology.closedManifold());
      EXPECT_EQ(topology.components, 1u) << thickness << ' ' << angle;
    }
  }
}

TEST_P(ThinWalls, BetweenUndercutsAreHeldOrReported) {
  const double thickness = GetParam();
  int lost = 0;
  for (int i = 0; i < 10; ++i) {
    // Two discs, one above the other, go into the side of the block.
    const double top = -2.0 - 0.02 * i;
    PathMaker p;
    p.line({-14, 30, top}, {-14, -30, top})
        .line({-14, -30, top - 1.5 - thickness}, {-14, 30, top - 1.5 - thickness});
    const Cut c = cut(BoxShape{{-15, -15, -6}, {15, 15, 0}}, p.path(), {tool("1=tslot:10:1.5:2")}, kGrid);
    const double area = 6 * 30,
                 left = 2 * 1.5 * area - (c.initial - c.volume);  // below 0 where the wall is gone
    const double film = c.summary.lost_film_mm2;
    if (std::abs(left) < 0.02 * area * thickness) {
      EXPECT_EQ(film, 0.0) << i;
      continue;
    }
    ++lost;
    EXPECT_NEAR(left, -area * thickness, 0.1 * area * thickness) << i;
    EXPECT_NEAR(film, area, 0.15 * area) << i;
  }
  EXPECT_EQ(lost > 0, thickness < kGrid);
}

INSTANTIATE_TEST_SUITE_P(Thickness, ThinWalls, ::testing::Values(0.02, 0.1, 0.18, 0.3));

TEST(ThinWalls, RidgesOfScallopsAreNone) {
  PathMaker p;
  for (int i = 0; i < 40; ++i) {
    const double y = -10 + 0.5 * i, z = -2 - 0.013 * i;
    p.line({-10, y, z}, {10, y, z + 1});
  }
  for (const double h : {0.1, 0.17, 0.3}) {
    const Cut c = cut(BoxShape{{-15, -15, -6}, {15, 15, 0}}, p.path(), {tool("1=ball:4")}, h);
    EXPECT_EQ(c.summary.lost_film_mm2, 0.0) << h;
  }
}

TEST(ThinWalls, SameForAnyThreadCount) {
  const Wall wall{0.1, 0.07, 30, false};
  const RemovalSummary one = TwoSlots(wall, 1).c.summary;
  EXPECT_GT(one.lost_film_mm2, 0.0);
  for (const int threads : {2, 3, 8}) {
    const RemovalSummary other = TwoSlots(wall, threads).c.summary;
    EXPECT_EQ(one.lost_film_mm2, other.lost_film_mm2) << threads;
    EXPECT_EQ(one.lost_film_at, other.lost_film_at) << threads;
  }
}

TEST(ThinWalls, PillarsInsideACircleAreReportedWhereAnEdgeMeetsThem) {
  int lost = 0;
  for (int i = 0; i < 20; ++i) {
    const double x = i % 2 == 0 ? 0.01 : 0.11, y = 0.02 * (i / 2) + 0.001;
    PathMaker p;
    p.arc({x + 2.04, y, -3}, {x, y, -3}, {0, 0, 1}, 360);  // leaves 0.04 mm around the middle
    const RemovalSummary s =
        cut(BoxShape{{-15, -15, -6}, {15, 15, 0}}, p.path(), {tool("1=flat:4")}, kGrid).summary;
    if (s.lost_film_mm2 == 0.0) continue;
    ++lost;
    EXPECT_NEAR(s.lost_film_at.x(), x, 0.04);
    EXPECT_NEAR(s.lost_film_at.y(), y, 0.04);
  }
  EXPECT_GE(lost, 2);
}

/// One straight cut, 16 mm long, 2 mm deep, into a block of 20 x 20 x 3.
Cut groove(const std::string& option, double offset, double angle_deg, double depth, double h) {
  const double angle = angle_deg * kPi / 180;
  const Vec3 along(std::cos(angle), std::sin(angle), 0), side(-along.y(), along.x(), 0);
  const Vec3 middle = offset * side - Vec3(0, 0, depth);
  PathMaker p;
  p.line(middle - 8 * along + Vec3(0, 0, 4), middle - 8 * along).line(middle - 8 * along, middle + 8 * along);
  return cut(BoxShape{{-10, -10, -3}, {10, 10, 0}}, p.path(), {tool(option)}, h);
}

TEST(NarrowCuts, AreHeldOrReported) {
  for (const double width : {0.02, 0.05, 0.1, 0.19}) {
    int lost = 0;
    for (int i = 0; i < 10; i += 2) {
      for (const double angle : {0.0, 90.0}) {
        const Cut c = groove(fmt::format("1=flat:{}", width), 0.02 * i + 0.003, angle, 2, kGrid);
        const double volume = 16 * 2 * width, taken = c.initial - c.volume;
        if (c.summary.narrow_cuts.empty()) {
          EXPECT_NEAR(taken, volume, 0.1 * volume) << width << ' ' << i;
          continue;
        }
        ++lost;
        const NarrowCut& narrow = c.summary.narrow_cuts[0];
        EXPECT_LT(taken, 0.1 * volume) << width << ' ' << i;
        EXPECT_NEAR(narrow.width_mm, width, 1e-9);
        EXPECT_NEAR(narrow.length_mm, 18, 1) << width << ' ' << i;  // 16 level, 2 down
        EXPECT_NEAR(narrow.area_mm2, narrow.length_mm * width, 1e-9);
      }
    }
    EXPECT_TRUE(lost > 0 || width > 0.15) << width;
  }
}

TEST(NarrowCuts, TheGridNamedHoldsThem) {
  for (const double width : {0.15, 0.3}) {
    for (const double angle : {0.0, 17.0, 45.0, 71.0}) {
      const Cut c = groove(fmt::format("1=flat:{}", width), 0.0331, angle, 1, width / 1.5);
      EXPECT_TRUE(c.summary.narrow_cuts.empty()) << width << ' ' << angle;
      const double volume = 1 * (16 * width + kPi * width * width / 4);
      EXPECT_NEAR(c.initial - c.volume, volume, 0.3 * volume) << width << ' ' << angle;
    }
  }
}

TEST(NarrowCuts, AcrossTheGridPiecesAreReported) {
  for (const double angle : {10.0, 30.0, 45.0, 80.0}) {
    const Cut c = groove("1=flat:0.05", 0.033, angle, 2, kGrid);
    ASSERT_EQ(c.summary.narrow_cuts.size(), 1u) << angle;
    EXPECT_GT(c.summary.narrow_cuts[0].length_mm, 5.0) << angle;
  }
}

TEST(NarrowCuts, EngravingWithAPointedTool) {
  for (int i = 0; i < 10; ++i) {
    // 90 degrees, 0.08 mm deep: 0.16 mm wide at the top. Where a column meets a flank, the mesh does not show
    // more.
    const double offset = 0.02 * i + 0.0061;
    const Cut shallow = groove("1=cone:6:0.001:90", offset, 0, 0.08, kGrid);
    EXPECT_NEAR(shallow.mesh_volume, shallow.initial, 0.02 * 16 * 0.0064);  // of what was cut
    ASSERT_EQ(shallow.summary.narrow_cuts.size(), 1u) << i;
    EXPECT_NEAR(shallow.summary.narrow_cuts[0].width_mm, 0.16, 0.17) << i;
    EXPECT_NEAR(shallow.summary.narrow_cuts[0].length_mm, 16, 1) << i;
    // Deep ones are held.
    const Cut deep = groove("1=cone:6:0.001:90", offset, 9.0 * i, 0.5, kGrid);
    EXPECT_TRUE(deep.summary.narrow_cuts.empty()) << i;
    EXPECT_NEAR(deep.initial - deep.mesh_volume, 16 * 0.25 + kPi * 0.125 / 3, 0.06) << i;
  }
}

TEST(NarrowCuts, SawsThinnerThanTheGrid) {
  int lost = 0;
  for (int i = 0; i < 10; ++i) {
    PathMaker p;
    p.line({-18, 30, -2.0 - 0.02 * i}, {-18, -30, -2.0 - 0.02 * i});  // the rim is 2 mm in the block
    const Cut c = cut(BoxShape{{-15, -15, -6}, {15, 15, 0}}, p.path(), {tool("1=tslot:10:0.05:2")}, kGrid);
    const double volume = 2 * 30 * 0.05, taken = c.initial - c.volume;
    if (c.summary.narrow_cuts.empty()) {
      EXPECT_NEAR(taken, volume, 0.1 * volume) << i;
      continue;
    }
    ++lost;
    EXPECT_LT(taken, 0.1 * volume) << i;
    EXPECT_NEAR(c.summary.narrow_cuts[0].width_mm, 0.05, 1e-9);
    EXPECT_NEAR(c.summary.narrow_cuts[0].length_mm, 35,
                2);  // the rim enters before the axis is beside the block
  }
  EXPECT_GT(lost, 0);
}

TEST(NarrowCuts, OrdinaryToolsHaveNone) {
  for (const std::string option :
       {"1=flat:0.4", "1=ball:0.6", "1=cone:6:0.5:60", "1=drill:3:118", "1=tslot:10:1:4"}) {
    for (const double h : {0.1, 0.2}) {
      PathMaker p;
      p.line({-8, 0.03, 4}, {-8, 0.03, -2}).line({-8, 0.03, -2}, {8, 3, -3}).line({8, 3, -3}, {7, -9, -1});
      p.arc({7, -9, -1}, {5, -8, -1}, {0, 0, 1}, 200, -0.5);
      EXPECT_TRUE(
          cut(BoxShape{{-10, -10, -4}, {10, 10, 0}}, p.path(), {tool(option)}, h).summary.narrow_cuts.empty())
          << option << ' ' << h;
    }
  }
}

TEST(Slivers, StayWithinTheBlank) {
  // The ball stands so near to a side of the block that what is left between them ends below the top in a
  // wedge that no edge of the grid meets there.
  const Box3 block{{0, 0, -10}, {20, 16, 0}};
  PathMaker p;
  p.line({3, 4, -2}, {17, 9, -4}).line({5, -5, -8}, {12, 5, -3});
  for (const double h : {0.5, 0.4, 0.3, 0.1}) {
    double worst = 0.0;
    for (const auto& v :
         cut(BoxShape{block.min, block.max}, p.path(), {tool("1=ball:6")}, h).mesh.positions) {
      const Vec3 q = v.cast<double>();
      worst = std::max({worst, (block.min - q).maxCoeff(), (q - block.max).maxCoeff()});
    }
    EXPECT_LT(worst, 2e-4 * h) << h;
  }
}

}  // namespace
}  // namespace proveout::test
