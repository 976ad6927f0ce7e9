#include <gtest/gtest.h>

#include <random>

#include "app/session/nominal/placement_hint.h"
#include "app/session/session.h"
#include "tests/support/temporary_folder.h"

namespace proveout {
namespace {

const Box3 kPart{{0, 0, -20}, {100, 80, 0}};

Box3 scaled(const Box3& box, double by) { return {by * box.min, by * box.max}; }

TEST(PlacementHint, UnitsAreFound) {
  for (const double factor : {25.4, 1 / 25.4, 1000.0, 0.001}) {
    const auto found = evidentPlacement(scaled(kPart, 1.004 / factor), kPart);
    ASSERT_TRUE(found) << factor;
    EXPECT_NEAR(found->scale / factor, 1.0, 1e-12);
    EXPECT_TRUE(found->move.isZero(0.0));
  }
}

TEST(PlacementHint, PlacesAreFound) {
  Box3 moved = kPart;
  moved.min += Vec3(-50, -40, 10);
  moved.max += Vec3(-50, -40, 10);
  const auto found = evidentPlacement(moved, kPart);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scale, 1.0);
  EXPECT_EQ(found->move, Vec3(50, 40, -10));
  const auto both = evidentPlacement(scaled(moved, 1 / 25.4), kPart);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->scale, 25.4);
  EXPECT_LT((both->move - Vec3(50, 40, -10)).norm(), 1e-9);
}

TEST(PlacementHint, WhatFitsOrIsNotEvidentIsLeftAlone) {
  EXPECT_FALSE(evidentPlacement(kPart, kPart));
  EXPECT_FALSE(evidentPlacement(scaled(kPart, 1.009), kPart));
  EXPECT_FALSE(evidentPlacement(scaled(kPart, 1.03 / 25.4), kPart));  // 3 % off
  EXPECT_FALSE(evidentPlacement(scaled(kPart, 10.0), kPart));
  Box3 higher = scaled(kPart, 1 / 25.4);
  higher.max.z() += 0.3 * higher.size().z();  // one side of three does not agree
  EXPECT_FALSE(evidentPlacement(higher, kPart));
  EXPECT_FALSE(evidentPlacement(Box3(), kPart));
}

TEST(PlacementHint, TurnsAreFound) {
  ASSERT_EQ(quarterTurns().size(), 24U);
  EXPECT_TRUE(quarterTurns().front().isZero(0.0));
  for (const Vec3& turn : quarterTurns()) {
    const Box3 turned = MeshPlacement{1.0, turn, {5, 6, 7}}.motion()(kPart);
    const auto found = evidentPlacement(turned, kPart);
    ASSERT_TRUE(found) << turn.transpose();
    EXPECT_TRUE(boundsAgree(placedBounds(*found, turned), kPart)) << turn.transpose();
  }
}

TEST(PlacementHint, TheTextNamesUnitTurnAndVector) {
  const auto text = [](double scale, const Vec3& turn, const Vec3& move, MeshUnit unit = MeshUnit::kMillimetre) {
    return placementText({scale, turn, move}, unit);
  };
  const Vec3 zero = Vec3::Zero();
  EXPECT_EQ(text(25.4, zero, zero), "scaled by 25.4 (unit \"inch\" in place of \"mm\")");
  EXPECT_EQ(text(1 / 25.4, zero, zero, MeshUnit::kInch), "scaled by 1/25.4 (unit \"mm\" in place of \"inch\")");
  EXPECT_EQ(text(0.001, zero, zero), "scaled by 1/1000");
  EXPECT_EQ(text(1.0, zero, {-0.00001, 2.5, -3}), "moved by X0 Y2.5 Z-3");
  EXPECT_EQ(text(1.0, {0, 0, 90}, {40, 0, 0}), "turned by 90 about Z and moved by X40 Y0 Z0");
  EXPECT_EQ(text(1.0, {90, 0, -90}, zero), "turned by 90 about X, then by -90 about Z");
}

TEST(PlacementHint, KeysAndOptionsPutTheMeshThere) {
  const MeshPlacement none, turned{1.0, {0, 0, 90}, {40, 0, 0}};
  EXPECT_EQ(placementKeys(none, turned, MeshUnit::kMillimetre), "rotate = [0, 0, 90], move = [40, 0, 0]");
  EXPECT_EQ(placementOptions(none, turned), "--nominal-rotate 0,0,90 --nominal-at 40,0,0");
  const MeshPlacement inch{25.4, Vec3::Zero(), Vec3::Zero()};
  EXPECT_EQ(placementKeys(none, inch, MeshUnit::kMillimetre), "unit = \"inch\"");
  EXPECT_EQ(placementOptions(none, inch), "");
  EXPECT_EQ(placementKeys(none, {0.001, Vec3::Zero(), Vec3::Zero()}, MeshUnit::kMillimetre), "scale = 0.001");
  // On top of what the job says.
  EXPECT_EQ(placementKeys({1.0, {0, 0, 90}, {1, 2, 3}}, turned, MeshUnit::kMillimetre),
            "rotate = [0, 0, 180], move = [38, 1, 3]");
}

TEST(PlacementHint, ChainedPlacementsAreOneAfterTheOther) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-180, 180);
  const auto vec = [&] { return Vec3(any(random), any(random), any(random)); };
  for (int i = 0; i < 200; ++i) {
    const MeshPlacement first{0.5 + 0.01 * i, vec(), vec()}, second{2.0, i % 2 == 0 ? Vec3(90, 0, -90) : vec(), vec()};
    const MeshPlacement both = chained(first, second);
    const Vec3 p = vec();
    EXPECT_LT((both(p) - second(first(p))).norm(), 1e-9);
  }
  for (const Vec3& turn : quarterTurns()) {
    const Vec3 again = xyzDegOf(rotationXyzDeg(turn));
    EXPECT_EQ(rotationXyzDeg(again), rotationXyzDeg(turn)) << turn.transpose();
  }
}

/// What a run tells of a nominal that is a box.
std::string toldOf(const Box3& nominal, const StockSpec& stock = BoxShape{{0, 0, -10}, {20, 20, 0}}) {
  const test::TemporaryFolder folder;
  std::string obj;
  for (int i = 0; i < 8; ++i) {
    obj += "v";
    for (int axis = 0; axis < 3; ++axis)
      obj += " " + std::to_string((i >> axis & 1) != 0 ? nominal.max[axis] : nominal.min[axis]);
    obj += "\n";
  }
  obj += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  Job job;
  job.name = "ring";
  job.control = "nct";
  job.stock = stock;
  Tool tool;
  tool.number = 1;
  tool.diameter = 4;
  job.tools = {tool};
  job.simulation.resolution_mm = 0.5;
  job.nominal.emplace();
  job.nominal->mesh.path = folder.write("nominal.obj", obj);
  // A square of 10 mm is cut through: what is left of the blank is 16 wide.
  const MemoryProgramSource memory(
      "ring.nc",
      "G21 G90 G17 T1 M6\nS1000 M3\nG0 X-4 Y0 Z5\nG1 Z-10 F200\nX20\nY20\nX0\nY0\n"
      "G0 Z5\nM30\n");
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  const Result<RunResult> run = runRecorded(job, {&source}, progress);
  if (!run.ok()) return "refused: " + run.error().message;
  std::string told;
  for (const Diagnostic& d : run->setups.back().interpreted.path.diagnostics.all()) {
    if (d.code == "nominal") told += d.message + "\n";
  }
  for (const Finding& finding : run->findings) {
    if (finding.kind == FindingKind::kNominalPlacement) told += finding.message + "\n";
  }
  return told;
}

TEST(PlacementHint, ANominalInInchesIsToldBesideTheBlank) {
  const std::string small = toldOf(scaled({{0, 0, -10}, {20, 20, 0}}, 1 / 25.4));
  EXPECT_NE(small.find("much smaller than the blank"), std::string::npos) << small;
  EXPECT_NE(small.find("scaled by 25.4 (unit \"inch\""), std::string::npos) << small;
  const std::string large = toldOf(scaled({{0, 0, -10}, {20, 20, 0}}, 1000));
  EXPECT_NE(large.find("out of the blank"), std::string::npos) << large;
  EXPECT_NE(large.find("scaled by 1/1000"), std::string::npos) << large;
}

TEST(PlacementHint, ANominalElsewhereIsToldItsWay) {
  const std::string told = toldOf({{-10, -10, 0}, {10, 10, 10}});
  EXPECT_NE(told.find("moved by X10 Y10 Z-10"), std::string::npos) << told;
}

TEST(PlacementHint, WhatWasMachinedCountsToo) {
  // The finished part is 16 x 16: smaller than the blank, and told by what was machined.
  const std::string told = toldOf({{20, 2, -10}, {36, 18, 0}});
  EXPECT_NE(told.find("moved by X-18 Y0 Z0"), std::string::npos) << told;
}

TEST(PlacementHint, ANominalThatFitsIsNotSpokenOf) {
  EXPECT_EQ(toldOf({{2, 2, -10}, {18, 18, 0}}), "");
  EXPECT_EQ(toldOf({{0, 0, -10}, {20, 20, 0}}), "");
  EXPECT_EQ(toldOf({{5, 5, -8}, {12, 9, -1}}), "");  // another part, inside the blank
}

}  // namespace
}  // namespace proveout
