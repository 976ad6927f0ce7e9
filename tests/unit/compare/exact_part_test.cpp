// The part without a grid against tools that stand at many places of their paths.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/path/posed_way.h"
#include "removal/exact/swept_part.h"
#include "tests/support/exact_part_reference.h"

namespace proveout {
namespace {

Tool flat() {
  Tool tool;
  tool.number = 1;
  tool.diameter = 2 * test::kReferenceRadius;
  return tool;
}
Tool ball() {
  Tool tool = flat();
  tool.number = 2;
  tool.type = ToolType::kBall;
  return tool;
}

struct Cuts {
  Toolpath path;
  std::vector<Tool> tools{flat(), ball()};

  void add(int tool, const Vec3& from, const Vec3& to) {
    Motion m;
    m.from = from;
    m.to = to;
    m.kind = MotionKind::kFeed;
    m.tool = tool;
    path.motions.push_back(m);
  }
  void arc(int tool, const Vec3& from, const Vec3& center, const Vec3& normal, double sweep, double rise) {
    const Eigen::AngleAxisd turn(sweep, normal);
    add(tool, from, center + turn * (from - center) + rise * normal);
    path.motions.back().arc = static_cast<std::int32_t>(path.arcs.size());
    path.arcs.push_back({center, normal, sweep});
  }

  /// The distance to the nearest of many places of the tools, and how far they are apart.
  std::pair<double, double> nearest(const Vec3& p) const {
    constexpr int kPlaces = 4000;
    double least = 1e9, gap = 0.0;
    for (const Motion& m : path.motions) {
      Vec3 last = m.from;
      for (int i = 0; i <= kPlaces; ++i) {
        const Vec3 tip = path.pointAt(m, static_cast<double>(i) / kPlaces);
        gap = std::max(gap, (tip - last).norm());
        last = tip;
        least = std::min(least, test::fromTool(m.tool, p, {tip, Vec3::UnitZ()}));
      }
    }
    return {least, gap};
  }
};

Cuts randomCuts(std::mt19937& random) {
  std::uniform_real_distribution<double> x(5, 35), y(5, 25), z(-6, -0.5), angle(-6.5, 6.5), size(2, 9);
  const auto point = [&] { return Vec3(x(random), y(random), z(random)); };
  Cuts cuts;
  for (int tool : {1, 2}) {
    cuts.add(tool, point(), point());
    cuts.add(tool, point(), point());
    const Vec3 center = point();
    cuts.arc(tool, center + Vec3(size(random), 0, 0), center, Vec3::UnitZ(), angle(random), 0.0);
    cuts.arc(tool, center + Vec3(0, size(random), 0), center, Vec3::UnitZ(), angle(random), -0.8);
    cuts.arc(tool, center + Vec3(0, 2.0, 0), center, Vec3::UnitX(), 0.3 * angle(random), 0.0);
  }
  return cuts;
}

const BoxShape& kBlank = test::kReferenceBlank;

TEST(ExactPart, IsTheBlankLessEveryPlaceOfTheTools) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> x(-1, 41), y(-1, 31), z(-11, 1);
  for (int round = 0; round < 6; ++round) {
    const Cuts cuts = randomCuts(random);
    const auto part = makeSweptPart(kBlank, {{&cuts.path, &cuts.tools, {}}});
    ASSERT_TRUE(part.ok());
    for (int i = 0; i < 40; ++i) {
      const Vec3 p(x(random), y(random), z(random));
      const auto [tool, gap] = cuts.nearest(p);
      const double depth = std::min(test::insideBlank(p), tool);  // in the material exact, else below 0
      const ExactPart::Sample s = (*part)->at(p, 100.0);
      if (depth > 0.0) {
        EXPECT_NEAR(-s.value, depth, gap) << p.transpose();
      } else if (depth < -gap) {
        EXPECT_GT(s.value, 0.0) << p.transpose();
      }
    }
  }
}

/// Tools that tilt on their way, a whole turn of a cone included.
Toolpath tiltingPath(std::mt19937& random) {
  std::uniform_real_distribution<double> x(5, 35), y(5, 25), z(-6, -0.5), lean(-0.5, 0.5);
  const auto point = [&] { return Vec3(x(random), y(random), z(random)); };
  const auto axis = [&] { return Vec3(lean(random), lean(random), 1.0).normalized(); };
  Toolpath path;
  for (const int tool : {1, 2}) {
    for (int i = 0; i < 3; ++i) {
      Motion m;
      m.kind = MotionKind::kFeed;
      m.tool = tool;
      m.from = point(), m.to = point();
      AxisSweep sweep;
      sweep.from = axis(), sweep.to = axis();
      if (i == 2) {
        const Vec3 center = m.from + Vec3(5, 0, 0);
        m.to = m.from, m.arc = static_cast<std::int32_t>(path.arcs.size());
        path.arcs.push_back({center, Vec3::UnitZ(), 2 * kPi});
        sweep.to = sweep.from, sweep.law = PoseLaw::kCone;
      }
      m.axis = static_cast<std::int32_t>(path.axes.size());
      path.axes.push_back(sweep);
      path.motions.push_back(m);
    }
  }
  return path;
}

TEST(ExactPart, ToolsThatTiltAreAskedInPiecesOfTheirWay) {
  constexpr double kNear = 5.0, kReach = 20.0;
  constexpr int kPlaces = 4000;
  std::mt19937 random(14);
  std::uniform_real_distribution<double> x(-1, 41), y(-1, 31), z(-11, 1);
  std::vector<Tool> tools{flat(), ball()};
  for (Tool& tool : tools) tool.flute_length = 40.0;
  for (int round = 0; round < 4; ++round) {
    const Toolpath path = tiltingPath(random);
    const auto part = makeSweptPart(kBlank, {{&path, &tools, {}}});
    ASSERT_TRUE(part.ok());
    for (int i = 0; i < 40; ++i) {
      const Vec3 p(x(random), y(random), z(random));
      double depth = test::insideBlank(p), gap = 0.0;
      for (const Motion& m : path.motions) {
        const PosedWay way = posedWayOf(path, m);
        ToolPose last = way.at(0.0);
        for (int k = 0; k <= kPlaces; ++k) {
          const ToolPose pose = way.at(static_cast<double>(k) / kPlaces);
          gap = std::max(gap, (pose.tip - last.tip).norm() + kReach * (pose.axis - last.axis).norm());
          last = pose;
          depth = std::min(depth, test::fromTool(m.tool, p, pose));
        }
      }
      const ExactPart::Sample s = (*part)->at(p, kNear);
      if (depth > 0.0) {
        EXPECT_NEAR(-s.value, std::min(depth, kNear), gap) << p.transpose();
      } else if (depth < -gap) {
        EXPECT_GT(s.value, 0.0) << p.transpose();
      }
    }
  }
}

TEST(ExactPart, PointsSettleOnTheSurfaceAndKnowTheirMotion) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> x(1, 39), y(1, 29), z(-7, 0);
  int made = 0;
  for (int round = 0; round < 4; ++round) {
    const Cuts cuts = randomCuts(random);
    const auto part = makeSweptPart(kBlank, {{&cuts.path, &cuts.tools, {}}});
    ASSERT_TRUE(part.ok());
    for (int i = 0; i < 600; ++i) {
      // As the samples of a mesh: not far off.
      const Vec3 from(x(random), y(random), z(random));
      made += test::settles(**part, cuts, from) ? 1 : 0;
    }
  }
  EXPECT_GT(made, 50);
}

TEST(ExactPart, ClampingsAreTurnedIntoTheLastFrame) {
  // A slot from above, then one from below: the part lies turned over about X.
  Cuts top, bottom;
  top.add(1, {10, 15, -2}, {30, 15, -2});
  bottom.add(1, {10, 15, -3}, {30, 15, -3});
  RigidTransform back;  // from the last frame, whose Z points down, into the first
  back.rotation = Eigen::AngleAxisd(kPi, Vec3::UnitX()).toRotationMatrix();
  back.translation = {0, 30, -10};
  const auto part = makeSweptPart(kBlank, {{&top.path, &top.tools, back}, {&bottom.path, &bottom.tools, {}}});
  ASSERT_TRUE(part.ok());
  // In the last frame the blank is the same box; the first slot opens at its bottom.
  EXPECT_NEAR((*part)->at({20, 15, -5}, 50).value, -2.0, 1e-9);  // 2 above the floor at -3
  EXPECT_NEAR((*part)->at({20, 15, -7}, 50).value, -1.0, 1e-9);  // 1 from the ceiling at -8
  EXPECT_GT((*part)->at({20, 15, -9}, 50).value, 0.0);
  EXPECT_EQ((*part)->at({20, 15, -7.9}, 50).maker.setup, 0u);
  EXPECT_NE((*part)->at({20, 15, -3.1}, 50).maker.setup, 0u);
}

}  // namespace
}  // namespace proveout
