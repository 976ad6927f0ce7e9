// Solids of every tool type against their drawings and closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "tests/unit/tool/drawings.h"

namespace proveout::test {
namespace {

/// Length of the union of the parts' height intervals at radius r.
double covered(const std::vector<ConvexProfile>& parts, double r) {
  std::vector<Vec2> spans;
  for (const ConvexProfile& p : parts) {
    if (r <= p.maxRadius()) spans.emplace_back(p.lowerHeight(r), p.upperHeight(r));
  }
  std::sort(spans.begin(), spans.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  double sum = 0.0, top = -1e300;
  for (const Vec2& s : spans) {
    sum += std::max(0.0, s.y() - std::max(s.x(), top));
    top = std::max(top, s.y());
  }
  return sum;
}

/// Shells of equal thickness, by the midpoint rule.
double volumeOf(const std::vector<ConvexProfile>& parts, int shells = 200000) {
  double radius = 0.0, sum = 0.0;
  for (const ConvexProfile& p : parts) radius = std::max(radius, p.maxRadius());
  const double dr = radius / shells;
  for (int i = 0; i < shells; ++i) sum += 2 * kPi * (i + 0.5) * dr * dr * covered(parts, (i + 0.5) * dr);
  return sum;
}

TEST(ToolShape, EveryDrawingIsAGoodTool) {
  for (const Drawing& d : drawings(8)) {
    const Status status = validateTool(d.tool);
    EXPECT_TRUE(status.ok()) << d.name << ": " << status.error().message;
  }
}

TEST(ToolShape, VolumesMatchDrawings) {
  for (const Drawing& d : drawings(4000)) {
    const auto parts = makeToolSolid(d.tool).cutter;
    const double expected = d.volume(), surface = 2 * kPi * d.tool.diameter / 2 * 5;
    const double volume = volumeOf(parts);
    EXPECT_GE(volume, expected * (1 - 2e-6)) << d.name;
    EXPECT_LE(volume, expected * (1 + 2e-6) + d.hollow * surface) << d.name;
  }
}

TEST(ToolShape, VolumesMatchClosedForms) {
  const auto volume = [](const std::string& name) {
    for (const Drawing& d : drawings(1)) {
      if (d.name == name) return volumeOf(makeToolSolid(d.tool).cutter);
    }
    ADD_FAILURE() << name;
    return 0.0;
  };
  const auto frustum = [](double a, double b, double h) { return kPi / 3 * h * (a * a + a * b + b * b); };
  const double top = 5 - 4 / std::tan(degToRad(60));
  EXPECT_NEAR(volume("dovetail"), frustum(5, top, 4), 1e-3);
  EXPECT_NEAR(volume("T-slot"), kPi * 36 * 3, 1e-3);
  // Half a torus (centre radius 5) outside of a disc of radius 5.
  EXPECT_NEAR(volume("T-slot with round corners"),
              kPi * 25 * 3 + kPi * (36 - 25) * 1 + 2 * kPi * (5 + 4 / (3 * kPi)) * kPi / 2, 1e-3);
  const double cap = 4 - 4 * std::sin(degToRad(60));  // what the neck takes off the sphere
  EXPECT_NEAR(volume("lollipop"), kPi * (4.0 / 3 * 64 - cap * cap * (4 - cap / 3)), 1e-3);
  const double f = 1.5 * std::tan(degToRad(30)), tooth = 2 * frustum(3.5, 5, f);
  EXPECT_NEAR(volume("thread mill, one tooth"), tooth, 1e-3);
  EXPECT_NEAR(volume("thread mill, teeth apart"),
              3 * (tooth + kPi * 25 * 0.25) + 2 * kPi * 3.5 * 3.5 * (2.5 - 2 * f - 0.25), 2e-3);
  EXPECT_NEAR(volume("thread mill, full form"), 2 * (tooth + kPi * 25 * 0.2), 1e-3);
  const double s = std::sin(degToRad(10)), r = std::cos(degToRad(10)), z = 1 - s, t = std::tan(degToRad(10));
  EXPECT_NEAR(
      volume("taper ball"),
      kPi * z * z * (1 - z / 3) + frustum(r, 2.5, (2.5 - r) / t) + kPi * 6.25 * (15 - z - (2.5 - r) / t),
      1e-3);
}

TEST(ToolShape, DistanceMatchesDrawing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0, 9), height(-5, 20);
  constexpr int kSteps = 2000;  // chords of a quarter of a 4 mm circle are off by 4 (pi / 4 / kSteps)^2 / 2
  constexpr double kChord = 1e-6;
  for (const Drawing& d : drawings(kSteps)) {
    const auto parts = makeToolSolid(d.tool).cutter;
    const double top = d.outline.back().y();
    for (int i = 0; i < 400; ++i) {
      const double r = radius(random), z = (i % 2 != 0 ? height(random) : (height(random) + 5) / 25 * top);
      double value = 1e300;
      ProfileSample best{};
      for (const ConvexProfile& p : parts) {
        const ProfileSample s = p.sample(r, z);
        if (s.value < value) value = s.value, best = s;
      }
      const double distance = d.surfaceDistance(r, z);
      const bool inside = z >= 0 && z <= top && r <= d.radiusAt(z);
      if (distance > kChord + d.hollow) {
        ASSERT_EQ(value < 0, inside) << d.name << " r " << r << " z " << z;
      }
      if (inside && parts.size() > 1) {  // the depth in one part: at most the whole
        ASSERT_GE(value, -distance - kChord - d.hollow) << d.name;
      } else {
        const double expected = inside ? -distance : distance;
        ASSERT_LE(value, expected + kChord) << d.name << " r " << r << " z " << z;
        ASSERT_GE(value, expected - kChord - d.hollow) << d.name << " r " << r << " z " << z;
      }
      ASSERT_NEAR(std::hypot(best.gr, best.gz), 1.0, 1e-12) << d.name;
    }
  }
}

TEST(ToolShape, GradientIsTheSlope) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.02, 9), height(-5, 20);
  for (const Drawing& d : drawings(1)) {
    for (const ConvexProfile& p : makeToolSolid(d.tool).cutter) {
      for (int i = 0; i < 60; ++i) {
        const double r = radius(random), z = height(random), step = 1e-6;
        const ProfileSample s = p.sample(r, z);
        ASSERT_NEAR(p.sample(r + step * s.gr, z + step * s.gz).value - s.value, step, 1e-9) << d.name;
      }
    }
  }
}

TEST(ToolShape, HeightsBoundTheSolidAndAreConvex) {
  for (const Drawing& d : drawings(1)) {
    for (const ConvexProfile& p : makeToolSolid(d.tool).cutter) {
      constexpr int kSteps = 500;
      double low[kSteps + 1], high[kSteps + 1];
      for (int i = 0; i <= kSteps; ++i) {
        const double r = p.maxRadius() * i / kSteps;
        low[i] = p.lowerHeight(r);
        high[i] = p.upperHeight(r);
        ASSERT_LE(low[i], high[i] + 1e-12) << d.name;
        ASSERT_NEAR(p.sample(r, low[i]).value, 0, 1e-9) << d.name << " r " << r;
        ASSERT_NEAR(p.sample(r, high[i]).value, 0, 1e-9) << d.name << " r " << r;
        ASSERT_GT(p.sample(r, low[i] - 1e-3).value, 0) << d.name << " r " << r;
        ASSERT_GT(p.sample(r, high[i] + 1e-3).value, 0) << d.name << " r " << r;
        if (i > 0) {
          ASSERT_GE(low[i], low[i - 1]) << d.name;
          ASSERT_LE(high[i], high[i - 1]) << d.name;
        }
        if (i > 1) {
          ASSERT_GE(low[i] - 2 * low[i - 1] + low[i - 2], -1e-12) << d.name;
          ASSERT_LE(high[i] - 2 * high[i - 1] + high[i - 2], 1e-12) << d.name;
        }
      }
      EXPECT_EQ(low[0], p.zMin());
      EXPECT_EQ(high[0], p.zMax());
    }
  }
}

TEST(ToolShape, PartsAreFewOverlapAndHaveTheirOwnIds) {
  std::map<std::string, std::size_t> parts;
  for (const Drawing& d : drawings(1)) {
    const auto cutter = makeToolSolid(d.tool).cutter;
    parts[d.name] = cutter.size();
    for (std::size_t i = 1; i < cutter.size(); ++i) {
      EXPECT_GT(cutter[i].firstElementId(),
                cutter[i - 1].firstElementId() + cutter[i - 1].elementCount() - 1);
      // On the axis every part shares more than a point with an earlier one.
      bool overlaps = false;
      for (std::size_t j = 0; j < i; ++j)
        overlaps =
            overlaps || (cutter[j].zMax() > cutter[i].zMin() + 1e-4 && cutter[j].zMin() < cutter[i].zMax());
      EXPECT_TRUE(overlaps) << d.name << " part " << i;
    }
    if (!cutter.empty()) {
      EXPECT_LT(cutter.back().firstElementId() + cutter.back().elementCount(), ConvexProfile::kEdgeIds);
    }
  }
  for (const char* convex :
       {"flat", "ball", "bull", "cone", "drill", "taper ball", "dovetail", "dovetail with a round corner",
        "T-slot", "T-slot with round corners", "lollipop", "thread mill, one tooth"})
    EXPECT_EQ(parts[convex], 1u) << convex;
  EXPECT_EQ(parts["thread mill, full form"], 2u);
  EXPECT_EQ(parts["thread mill, teeth apart"], 4u);  // three teeth and one core
  EXPECT_EQ(parts["form with steps and undercut"], 4u);
  EXPECT_EQ(parts["form with a bulge"], 3u);
}

TEST(ToolShape, NeckAndShankAreNoCutter) {
  Tool tool;
  tool.number = 1;
  tool.type = ToolType::kTSlot;
  tool.diameter = 20;
  tool.cutter_height = 5;
  tool.neck_diameter = 8;
  ToolSolid solid = makeToolSolid(tool);
  ASSERT_EQ(solid.shank.size(), 1u);  // without overall_length the neck does not end
  EXPECT_EQ(solid.shank[0].zMin(), 5);
  EXPECT_EQ(solid.shank[0].zMax(), kUnlimitedFluteMm);
  EXPECT_EQ(solid.shank[0].maxRadius(), 4);
  tool.neck_length = 30;
  tool.shank_diameter = 12;
  tool.overall_length = 60;
  ASSERT_TRUE(validateTool(tool).ok());
  solid = makeToolSolid(tool);
  ASSERT_EQ(solid.shank.size(), 2u);
  EXPECT_EQ(solid.shank[0].zMax(), 30);
  EXPECT_EQ(solid.shank[1].zMin(), 30);
  EXPECT_EQ(solid.shank[1].zMax(), 60);
  EXPECT_EQ(solid.shank[1].maxRadius(), 6);
  EXPECT_EQ(solid.cutter[0].zMax(), 5);
}

TEST(ToolShape, CylindersAreSampledLikeAnyProfile) {
  const double radius = 2.5, low = -0.25, high = 7.0, seam = 3.0;
  ConvexProfile cylinder, seamed;  // the second with its flank in two pieces
  for (ConvexProfile* p : {&cylinder, &seamed}) {
    p->start(0.0, low);
    p->lineTo(radius, low);
    if (p == &seamed) p->lineTo(radius, seam);
    p->lineTo(radius, high);
    p->lineTo(0.0, high);
    p->setFirstElementId(5);
  }
  ASSERT_EQ(cylinder.elementCount(), 3);
  ASSERT_EQ(seamed.elementCount(), 4);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::vector<double> r_marks = {0.0, radius, 1.0, 4.0}, z_marks = {low, high, 1.0, -2.0, 9.0};
  for (int i = 0; i < 20000; ++i) {
    // On corners, on lines through them, and anywhere.
    const double r = i % 3 == 0 ? 5.0 * unit(random) : r_marks[random() % r_marks.size()];
    const double z = i % 5 < 2 ? 12.0 * unit(random) - 3.0 : z_marks[random() % z_marks.size()];
    const ProfileSample fast = cylinder.sample(r, z), slow = seamed.sample(r, z);
    EXPECT_EQ(fast.value, slow.value) << r << " " << z;
    EXPECT_EQ(fast.radius, slow.radius) << r << " " << z;
    EXPECT_EQ(fast.gr, slow.gr) << r << " " << z;
    EXPECT_EQ(fast.gz, slow.gz) << r << " " << z;
    const int element = slow.element - 5;  // the pieces of the flank are 1 and 2
    EXPECT_EQ(fast.element - 5, element < 2 ? element : element - 1) << r << " " << z;
    if (HasFailure()) break;
  }
}

TEST(ToolShape, BallEndIsOnlyWhereACylinderFollows) {
  for (const Drawing& d : drawings(1)) {
    const double center = makeToolSolid(d.tool).cutter.front().ballCenter();
    EXPECT_EQ(center, d.name == "ball" ? 3.0 : -1.0) << d.name;
  }
}

}  // namespace
}  // namespace proveout::test
