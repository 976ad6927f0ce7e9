#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/session/nominal/placement_search.h"

namespace proveout {
namespace {

/// A prism over a convex outline that no turn brings onto itself.
TriMesh plate(double height = 10.0) {
  const std::vector<Vec2> outline{{0, 0}, {60, 0}, {60, 25}, {35, 40}, {0, 40}};
  const auto n = static_cast<std::uint32_t>(outline.size());
  TriMesh mesh;
  for (const double z : {-height, 0.0}) {
    for (const Vec2& p : outline) mesh.positions.push_back(Vec3(p.x(), p.y(), z).cast<float>());
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    mesh.triangles.push_back({k, next, n + next});
    mesh.triangles.push_back({k, n + next, n + k});
    if (k < 2) continue;
    mesh.triangles.push_back({0, k, k - 1});
    mesh.triangles.push_back({n, n + k - 1, n + k});
  }
  return mesh;
}

TriMesh placed(const MeshPlacement& placement, TriMesh mesh = plate()) {
  placeMesh(placement, mesh);
  return mesh;
}

const Box3 kBlank{{-1, -1, -11}, {61, 41, 1}};
constexpr double kWithin = 0.05;

PlacementFault faultOf(const TriMesh& nominal, const TriMesh& part,
                       const std::optional<Box3>& blank = kBlank) {
  return placementFault(nominal, {}, MeshUnit::kMillimetre, {part, blank, kWithin});
}

TEST(PlacementSearch, EveryTurnUnitAndMoveIsUndone) {
  const TriMesh part = plate();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-90, 90);
  for (const double factor : kUnitFactors) {
    for (const Vec3& turn : quarterTurns()) {
      const TriMesh nominal = placed({factor, turn, Vec3(shift(random), shift(random), shift(random))});
      const auto found = searchPlacement(nominal, part, kWithin);
      ASSERT_TRUE(found) << factor << " " << turn.transpose();
      EXPECT_GT(found->after, 0.99);
      const TriMesh back = placed(found->change, nominal);
      for (std::size_t k = 0; k < back.positions.size(); ++k)
        EXPECT_LT((back.positions[k] - part.positions[k]).norm(), 0.02F) << factor << " " << turn.transpose();
    }
  }
}

TEST(PlacementSearch, APartThatIsNotReadyIsStillFound) {
  // Material stands below and beside: no side of the bounds but the top and two edges agree.
  TriMesh part = plate(14.0);
  const auto found = searchPlacement(placed({1.0, {0, 0, 90}, {20, -7, 5}}), part, kWithin);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->change.rotate_deg, Vec3(0, 0, -90));
}

TEST(PlacementSearch, AnotherPartIsNotFound) {
  TriMesh other;
  other = placed({0.5, {0, 0, 17}, {100, 3, 2}});
  EXPECT_FALSE(searchPlacement(other, plate(), kWithin));
}

TEST(PlacementSearch, WhatLiesElsewhereIsTheOneFinding) {
  const PlacementFault turned = faultOf(placed({1.0, {0, 0, 90}, {0, 0, 0}}), plate());
  EXPECT_FALSE(turned.comparable);
  EXPECT_NE(turned.text.find("turned by -90 about Z it would lie on the part with 100 %"), std::string::npos)
      << turned.text;
  EXPECT_NE(turned.text.find("enter rotate = [0, 0, -90] under [nominal] (--nominal-rotate 0,0,-90)"),
            std::string::npos)
      << turned.text;
  const PlacementFault up = faultOf(placed({1.0, {-90, 0, 0}, {0, 0, 0}}), plate());  // Y up
  EXPECT_NE(up.text.find("turned by 90 about X it would"), std::string::npos) << up.text;
  const PlacementFault centred = faultOf(placed({1.0, {0, 0, 0}, {-30, -20, 5}}), plate());
  EXPECT_NE(centred.text.find("--nominal-at 30,20,-5"), std::string::npos) << centred.text;
  const PlacementFault inch = faultOf(placed({1 / 25.4, {0, 0, 0}, {0, 0, 0}}), plate());
  EXPECT_FALSE(inch.comparable);
  EXPECT_TRUE(inch.rescaled);
  EXPECT_NE(inch.text.find("enter unit = \"inch\" under [nominal]"), std::string::npos) << inch.text;
  // Far off, and nothing to bring it back.
  const PlacementFault other = faultOf(placed({0.9, {0, 0, 30}, {500, 0, 0}}), plate());
  EXPECT_FALSE(other.comparable);
  EXPECT_NE(other.text.find("out of the blank"), std::string::npos) << other.text;
}

TEST(PlacementSearch, AWrongZeroIsNotTakenForAWrongPlace) {
  // The program cut 3 mm too far in X out of a larger blank: the nominal lies right.
  const Box3 large{{-10, -10, -20}, {80, 60, 0}};
  const PlacementFault zero = faultOf(plate(), placed({1.0, {0, 0, 0}, {3, 0, 0}}), large);
  EXPECT_TRUE(zero.comparable);
  EXPECT_NE(zero.text.find("moved by X3 Y0 Z0"), std::string::npos) << zero.text;
  // Turned by 180 degrees its bounds agree: that is for the comparison to tell.
  const PlacementFault half = faultOf(placed({1.0, {0, 0, 180}, {60, 40, 0}}), plate());
  EXPECT_TRUE(half.comparable);
  EXPECT_EQ(half.text, "");
  EXPECT_EQ(faultOf(plate(), plate()).text, "");
  // Moved between clampings by 3 mm too much: so does the blank.
  const Box3 moved{{-1, 2, -11}, {61, 44, 1}};
  const TriMesh part = placed({1.0, {0, 0, 0}, {0, 3, 0}});
  EXPECT_TRUE(placementFault(plate(), {}, MeshUnit::kMillimetre, {part, moved, kWithin, true}).comparable);
  EXPECT_FALSE(placementFault(plate(), {}, MeshUnit::kMillimetre, {part, moved, kWithin, false}).comparable);
}

TEST(PlacementSearch, TwoMeshesAreHeldAgainstEachOther) {
  const PlacementFault moved = faultOf(placed({1.0, {0, 0, 0}, {3, 0, 0}}), plate(), std::nullopt);
  EXPECT_FALSE(moved.comparable);
  EXPECT_NE(moved.text.find("moved by X-3 Y0 Z0"), std::string::npos) << moved.text;
  EXPECT_EQ(faultOf(plate(), plate(9.8), std::nullopt).text, "");  // 0.2 mm lower
}

}  // namespace
}  // namespace proveout
