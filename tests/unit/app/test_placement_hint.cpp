#include <gtest/gtest.h>

#include "app/session/placement_hint.h"
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
    EXPECT_TRUE(found->shift.isZero(0.0));
  }
}

TEST(PlacementHint, PlacesAreFound) {
  Box3 moved = kPart;
  moved.min += Vec3(-50, -40, 10);
  moved.max += Vec3(-50, -40, 10);
  const auto found = evidentPlacement(moved, kPart);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scale, 1.0);
  EXPECT_EQ(found->shift, Vec3(50, 40, -10));
  const auto both = evidentPlacement(scaled(moved, 1 / 25.4), kPart);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->scale, 25.4);
  EXPECT_LT((both->shift - Vec3(50, 40, -10)).norm(), 1e-9);
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

TEST(PlacementHint, TheTextNamesUnitAndVector) {
  const std::string inch = placementText({25.4, Vec3::Zero()}, MeshUnit::kMillimetre, "the blank");
  EXPECT_EQ(
      inch,
      "scaled by 25.4 (unit \"inch\" in place of \"mm\") its bounds would agree with those of the blank");
  const std::string back = placementText({1 / 25.4, Vec3::Zero()}, MeshUnit::kInch, "it");
  EXPECT_EQ(back,
            "scaled by 1/25.4 (unit \"mm\" in place of \"inch\") its bounds would agree with those of it");
  const std::string none = placementText({0.001, Vec3::Zero()}, MeshUnit::kMillimetre, "it");
  EXPECT_EQ(none, "scaled by 1/1000 its bounds would agree with those of it");
  const std::string moved = placementText({1.0, Vec3(-0.00001, 2.5, -3)}, MeshUnit::kMillimetre, "it");
  EXPECT_EQ(moved, "moved by X0 Y2.5 Z-3 its bounds would agree with those of it");
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
  EXPECT_NE(told.find("the nominal reaches 16 mm out of the blank"), std::string::npos) << told;
  EXPECT_NE(told.find("moved by X-18 Y0 Z0"), std::string::npos) << told;
}

TEST(PlacementHint, ANominalThatFitsIsNotSpokenOf) {
  EXPECT_EQ(toldOf({{2, 2, -10}, {18, 18, 0}}), "");
  EXPECT_EQ(toldOf({{0, 0, -10}, {20, 20, 0}}), "");
  EXPECT_EQ(toldOf({{5, 5, -8}, {12, 9, -1}}), "");  // another part, inside the blank
}

}  // namespace
}  // namespace proveout
