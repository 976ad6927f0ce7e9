// How deep contacts are told to be, against closed forms: it must not depend on the grid.
#include <cmath>
#include <random>

#include "core/tool/tool_solid.h"
#include "removal/sweep/sweep.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

const BoxShape kBlank{{0, 0, -20}, {40, 30, 0}};
constexpr double kGrids[] = {0.2, 0.37, 0.5, 1.0};
constexpr double kExact = 1e-4;  ///< mm; a micrometre is asked for

/// The only contact of a path.
Contact onlyContact(const StockShape& blank, const Toolpath& path, const std::vector<Tool>& tools,
                    double grid) {
  const Cut c = cut(blank, path, tools, grid);
  EXPECT_EQ(c.summary.contacts.size(), 1u) << grid;
  return c.summary.contacts.empty() ? Contact{} : c.summary.contacts.front();
}

const char* const kShapes[] = {"1=drill:10:118", "1=drill:3:140",  "1=cone:8:0:60", "1=cone:8:0.2:90",
                               "1=ball:6",       "1=ball:0.8",     "1=flat:10",     "1=bull:10:2",
                               "1=taper:1:5:6",  "1=lollipop:6:3", "1=tslot:12:3:6"};

TEST(ContactDepth, APlungeIsAsDeepAsItsTip) {
  for (const char* shape : kShapes) {
    for (const double grid : kGrids) {
      PathMaker p;
      p.line({17.3, 14.7, 5}, {17.3, 14.7, -3.0}, MotionKind::kRapid);
      const Cut c = cut(kBlank, p.path(), {tool(shape)}, grid);
      ASSERT_FALSE(c.summary.contacts.empty()) << shape << " " << grid;
      const Contact& contact = c.summary.contacts.front();
      EXPECT_EQ(contact.kind, ContactKind::kRapid);
      EXPECT_NEAR(contact.depth_mm, 3.0, kExact) << shape << " " << grid;
      EXPECT_NEAR(contact.where.z(), -3.0, kExact) << shape << " " << grid;
    }
  }
}

TEST(ContactDepth, ThePlaceOfAPointedToolIsItsTip) {
  for (const char* shape : {"1=drill:10:118", "1=cone:8:0:60", "1=ball:6"}) {
    PathMaker p;
    p.line({17.3, 14.7, 5}, {17.3, 14.7, -3.0}, MotionKind::kRapid);
    const Contact contact = onlyContact(kBlank, p.path(), {tool(shape)}, 0.5);
    // On a ball a step aside costs only its square.
    EXPECT_LT((contact.where - Vec3(17.3, 14.7, -3.0)).norm(), 0.02) << shape;
  }
}

TEST(ContactDepth, ASlantedRapidIsAsDeepAsItsEnd) {
  for (const char* shape : kShapes) {
    for (const double grid : kGrids) {
      PathMaker p;
      p.line({9, 10, 4}, {25.3, 18.1, -3.7}, MotionKind::kRapid);
      const Cut c = cut(kBlank, p.path(), {tool(shape)}, grid);
      ASSERT_FALSE(c.summary.contacts.empty()) << shape << " " << grid;
      EXPECT_NEAR(c.summary.contacts.front().depth_mm, 3.7, kExact) << shape << " " << grid;
    }
  }
}

TEST(ContactDepth, ALevelRapidIsAsDeepAsItRuns) {
  for (const char* shape : {"1=drill:10:118", "1=cone:8:0:60", "1=ball:6", "1=flat:10", "1=bull:10:2"}) {
    for (const double grid : kGrids) {
      PathMaker p;
      p.line({-10, 15.13, -2.6}, {50, 15.13, -2.6}, MotionKind::kRapid);
      EXPECT_NEAR(onlyContact(kBlank, p.path(), {tool(shape)}, grid).depth_mm, 2.6, kExact) << shape << grid;
    }
  }
}

TEST(ContactDepth, ASpindleThatStandsStillIsTheSame) {
  for (const double grid : kGrids) {
    PathMaker p;
    p.line({17.3, 14.7, 5}, {17.3, 14.7, -3.0});
    p.path().motions[0].spindle = 0;
    const Contact contact = onlyContact(kBlank, p.path(), {tool("1=drill:10:118")}, grid);
    EXPECT_EQ(contact.kind, ContactKind::kSpindleOff);
    EXPECT_NEAR(contact.depth_mm, 3.0, kExact) << grid;
  }
}

TEST(ContactDepth, OfAPathWithoutASpindleTheFirstCutIsTold) {
  PathMaker p;
  p.line({-10, 15, -2}, {20, 15, -2}).line({20, 15, -2}, {20, 15, -6}).line({20, 15, -6}, {50, 15, -6});
  for (Motion& m : p.path().motions) m.spindle = 0.0;
  const Contact contact = onlyContact(kBlank, p.path(), {tool("1=flat:6")}, 0.5);
  EXPECT_EQ(contact.motion, 0u);
  EXPECT_NEAR(contact.depth_mm, 2.0, kExact);
}

TEST(ContactDepth, AHelixIsAsDeepAsItsEnd) {
  for (const double grid : kGrids) {
    PathMaker p;
    p.arc({24, 15, 1}, {20, 15, 1}, Vec3::UnitZ(), 500.0, -3.3);
    p.path().motions[0].spindle = 0;
    EXPECT_NEAR(onlyContact(kBlank, p.path(), {tool("1=ball:6")}, grid).depth_mm, 2.3, kExact) << grid;
  }
}

/// A slot 5 deep with a round end, from x 10 to 30.
PathMaker slotAlongX() {
  PathMaker p;
  p.line({15, 15, 5}, {15, 15, -5}).line({15, 15, -5}, {25, 15, -5});
  return p;
}

TEST(ContactDepth, BelowAnEarlierFloorItCountsFromThere) {
  for (const char* shape : {"2=drill:4:118", "2=cone:4:0:60", "2=ball:4", "2=flat:4", "2=bull:4:1"}) {
    for (const double grid : kGrids) {
      Toolpath path = slotAlongX().path();
      PathMaker rapid(2);
      rapid.line({18.1, 15.2, 5}, {18.1, 15.2, -7.2}, MotionKind::kRapid);
      path.motions.push_back(rapid.path().motions[0]);
      EXPECT_NEAR(onlyContact(kBlank, path, {tool("1=flat:10"), tool(shape)}, grid).depth_mm, 2.2, kExact)
          << shape << " " << grid;
    }
  }
}

TEST(ContactDepth, IntoTheEndOfAnEarlierSlot) {
  for (const double grid : kGrids) {
    Toolpath path = slotAlongX().path();
    PathMaker rapid(2);
    // Radius 3 at x 29.5 reaches 2.5 beyond the round end; its floor is above that of the slot.
    rapid.line({18, 15, -4}, {29.5, 15, -4}, MotionKind::kRapid);
    path.motions.push_back(rapid.path().motions[0]);
    const Contact contact = onlyContact(kBlank, path, {tool("1=flat:10"), tool("2=flat:6")}, grid);
    EXPECT_NEAR(contact.depth_mm, 2.5, kExact) << grid;
    EXPECT_NEAR(contact.where.x(), 32.5, 0.01) << grid;
  }
}

TEST(ContactDepth, AlongAnEarlierRoundChannel) {
  for (const double grid : kGrids) {
    PathMaker p;
    p.line({-10, 15, -3}, {50, 15, -3}).line({-10, 15, -4.5}, {50, 15, -4.5}, MotionKind::kRapid);
    EXPECT_NEAR(onlyContact(kBlank, p.path(), {tool("1=ball:6")}, grid).depth_mm, 1.5, kExact) << grid;
  }
}

TEST(ContactDepth, BesideAWallItIsTheStepOver) {
  for (const double grid : kGrids) {
    PathMaker p;
    p.line({43.5, -20, -12}, {43.5, 50, -12}, MotionKind::kRapid);
    EXPECT_NEAR(onlyContact(kBlank, p.path(), {tool("1=flat:10")}, grid).depth_mm, 1.5, kExact) << grid;
  }
}

TEST(ContactDepth, InARoundBlank) {
  const CylinderShape round{2, {0, 0, -20}, 15.0, 0.0, 20.0};
  for (const double grid : kGrids) {
    PathMaker p;
    p.line({-40, 18.7, -25}, {40, 18.7, -25}, MotionKind::kRapid);  // radius 5: 1.3 inside
    const Contact contact = onlyContact(round, p.path(), {tool("1=flat:10")}, grid);
    EXPECT_NEAR(contact.depth_mm, 1.3, kExact) << grid;
    EXPECT_LT((contact.where.head<2>() - Vec2(0, 13.7)).norm(), 0.05) << grid;
  }
}

TEST(ContactDepth, AWallIsHalfAsDeepAsItIsThick) {
  const BoxShape wall{{0, 0, -20}, {40, 2.4, 0}};
  for (const double grid : {0.2, 0.37, 0.5}) {
    PathMaker p;
    p.line({20, -20, -15}, {20, 20, -15}, MotionKind::kRapid);
    EXPECT_NEAR(onlyContact(wall, p.path(), {tool("1=flat:10")}, grid).depth_mm, 1.2, kExact) << grid;
  }
}

TEST(ContactDepth, TheDeepestOfSeveralPlacesOfAMotionIsTold) {
  // Two ribs, 4 and 3 thick, between slots: the rapid goes through both and 2.5 below their floors' height.
  for (const double grid : {0.2, 0.5, 1.0}) {
    PathMaker p;
    for (const double y : {3.0, 13.0, 22.0}) p.line({-10, y, -8}, {50, y, -8});
    p.line({20, -10, -6}, {20, 40, -6}, MotionKind::kRapid);
    // Slots are y 0-6, 10-16, 19-25: ribs 6-10, 16-19 and 25-30, all of z 0; the last is the thickest.
    EXPECT_NEAR(onlyContact(kBlank, p.path(), {tool("1=flat:6")}, grid).depth_mm, 2.5, kExact) << grid;
  }
}

TEST(ContactDepth, AShankInItsOwnSlot) {
  Tool t = tool("1=flat:6");
  t.flute_length = 4;
  t.shank_diameter = 8;
  t.overall_length = 12;
  for (const double grid : kGrids) {
    PathMaker p;
    p.line({-10, 15, -3.5}, {50, 15, -3.5}).line({50, 15, -7}, {-10, 15, -7});
    const Contact contact = onlyContact(kBlank, p.path(), {t}, grid);
    EXPECT_EQ(contact.kind, ContactKind::kShank);
    EXPECT_NEAR(contact.depth_mm, 1.0, kExact) << grid;
  }
}

/// The volume in the way counts once, however the curve is taken apart: it is at most that of a ring. Ahead
/// of the end the shank stands in the full material, a mm beyond the flutes, which end 3 mm below its top:
/// the deepest point there is as far from both.
TEST(ContactDepth, AShankOnAHelixMeetsNoMoreThanThereIs) {
  Tool t = tool("1=flat:6");
  t.flute_length = 4;
  t.shank_diameter = 8;
  t.overall_length = 12;
  for (const double grid : {0.25, 0.5}) {
    PathMaker p;
    p.arc({26, 15, 0}, {20, 15, 0}, Vec3::UnitZ(), 360.0, -7.0);
    const Contact contact = onlyContact(kBlank, p.path(), {t}, grid);
    EXPECT_EQ(contact.kind, ContactKind::kShank);
    EXPECT_NEAR(contact.depth_mm, 5.0 / 3.0, kExact) << grid;
    constexpr double kRing = kPi * (10.0 * 10.0 - 2.0 * 2.0) * 3.0;
    EXPECT_LT(contact.volume_mm3, kRing) << grid;
    EXPECT_GT(contact.volume_mm3, 0.02 * kRing) << grid;
  }
}

TEST(ContactDepth, InAStockThatWasTurnedOver) {
  for (const double grid : kGrids) {
    RemovalOptions options;
    options.resolution_mm = grid;
    Progress progress;
    Result<Stock> stock = Stock::create(kBlank, options, progress);
    ASSERT_TRUE(stock.ok());
    ASSERT_TRUE(stock->remove(slotAlongX().path(), {tool("1=flat:10")}, options, progress).ok());
    RigidTransform over;
    over.rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;
    over.translation = {0, 30, -20};
    stock = stock->moved(over, options, progress);
    ASSERT_TRUE(stock.ok());
    PathMaker p;  // 12 of the 15 that are left over the slot: the middle of that floor
    p.line({18.1, 15.2, 5}, {18.1, 15.2, -3.4}, MotionKind::kRapid);
    const auto cut = stock->remove(p.path(), {tool("1=drill:6:118")}, options, progress);
    ASSERT_TRUE(cut.ok());
    ASSERT_EQ(cut->contacts.size(), 1u);
    EXPECT_NEAR(cut->contacts[0].depth_mm, 3.4, 1e-3) << grid;
  }
}

TEST(ContactDepth, ThinTipsAreFoundBetweenTheGridsLines) {
  for (const char* shape : {"1=cone:8:0:60", "1=ball:2", "1=drill:4:118", "1=taper:0.3:3:4"}) {
    for (const double grid : kGrids) {
      PathMaker p;
      p.line({-10, 15.41, -0.13}, {50, 15.41, -0.13}, MotionKind::kRapid);
      EXPECT_NEAR(onlyContact(kBlank, p.path(), {tool(shape)}, grid).depth_mm, 0.13, kExact) << shape << grid;
    }
  }
}

/// The deepest of points a step apart in the volume that the last motion of a path sweeps through what the
/// others have left of a box. All motions are lines of the one tool.
double deepestOfMany(const BoxShape& blank, const Toolpath& path, const Tool& mill, double step) {
  const ToolSolid solid = makeToolSolid(mill);
  const ConvexProfile& profile = solid.cutter.front();
  std::vector<Sweep> cuts;
  for (std::size_t i = 0; i + 1 < path.motions.size(); ++i)
    cuts.emplace_back(profile, path.motions[i].from, path.motions[i].to, nullptr);
  const Sweep last(profile, path.motions.back().from, path.motions.back().to, nullptr);
  const Vec3 low = last.bounds().min.cwiseMax(blank.min), high = last.bounds().max.cwiseMin(blank.max);
  double deepest = 0.0;
  for (double x = low.x(); x <= high.x(); x += step) {
    for (double y = low.y(); y <= high.y(); y += step) {
      for (double z = low.z(); z <= high.z(); z += step) {
        const Vec3 p(x, y, z);
        double depth = std::min((p - blank.min).minCoeff(), (blank.max - p).minCoeff());
        if (depth <= deepest || last.distance(p, 1e-9) > 0.0) continue;
        for (const Sweep& cut : cuts)
          depth = std::min(depth, depth > deepest ? cut.distance(p, depth) : depth);
        deepest = std::max(deepest, depth);
      }
    }
  }
  return deepest;
}

TEST(ContactDepth, NoPointOfTheSweptVolumeLiesDeeper) {
  constexpr double kStep = 0.2, kGrid = 0.5;
  int unmet = 0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(5, 35), y(5, 25), z(-6, -0.5);
  for (const char* shape : {"1=drill:6:118", "1=ball:5", "1=flat:6", "1=bull:7:2"}) {
    for (int round = 0; round < 60; ++round) {
      PathMaker p;
      Vec3 at(x(random), y(random), z(random));
      for (int i = 0; i < 6; ++i) {
        const Vec3 to(x(random), y(random), z(random));
        p.line(at, to, i == 5 ? MotionKind::kRapid : MotionKind::kFeed);
        at = to;
      }
      const Cut c = cut(kBlank, p.path(), {tool(shape)}, kGrid);
      const double told = c.summary.contacts.empty() ? 0.0 : c.summary.contacts.front().depth_mm;
      const double found = deepestOfMany(kBlank, p.path(), tool(shape), kStep);
      if (told > 0.0) {
        EXPECT_GE(told, found - 1e-3) << shape << " " << round;
      } else {  // slivers between the grid's vertical lines are not met
        EXPECT_LT(found, 0.1 * kGrid) << shape << " " << round;
        ++unmet;
      }
      // A point that the samples miss is no farther from one than the diagonal of a cell, if that is inside.
      EXPECT_LE(told, found + std::sqrt(3.0) * kStep) << shape << " " << round;
    }
  }
  EXPECT_LT(unmet, 12);  // of 240
}

TEST(ContactDepth, ThousandsOfContactsAreStillTold) {
  // A slot in steps that each go 0.4 mm on: as deep as the step, at the front of the mill.
  constexpr int kSteps = 4000;
  constexpr double kStep = 0.4;
  PathMaker p;
  for (int i = 0; i < kSteps; ++i) p.line({i * kStep, 0, -2}, {(i + 1) * kStep, 0, -2}, MotionKind::kRapid);
  const Cut c = cut(BoxShape{{0, -6, -4}, {kSteps * kStep + 10, 6, 0}}, p.path(), {tool("1=flat:8")}, 1.0);
  ASSERT_EQ(c.summary.contacts.size(), static_cast<std::size_t>(kSteps));
  for (int i = 1; i < kSteps; ++i) {
    const Contact& contact = c.summary.contacts[static_cast<std::size_t>(i)];
    EXPECT_EQ(contact.motion, static_cast<MotionId>(i));
    EXPECT_NEAR(contact.depth_mm, kStep, 0.02) << i;
  }
}

TEST(ContactDepth, RapidsInsideWhatWasCutAreClean) {
  for (const char* shape : {"1=cone:8:0:60", "1=ball:4", "1=drill:8:118", "1=bull:6:1"}) {
    PathMaker p;
    p.line({10, 10, 5}, {10, 10, -3}).line({10, 10, -3}, {30, 20, -3}).line({30, 20, -3}, {12, 25, -1});
    p.line({12, 25, -1}, {12, 25, 4}, MotionKind::kRapid).line({10, 10, 5}, {10, 10, -3}, MotionKind::kRapid);
    p.line({10, 10, -3}, {30, 20, -3}, MotionKind::kRapid)
        .line({30, 20, -3}, {30, 20, 5}, MotionKind::kRapid);
    EXPECT_TRUE(cut(kBlank, p.path(), {tool(shape)}, 0.5).summary.contacts.empty()) << shape;
  }
}

}  // namespace
}  // namespace proveout::test
