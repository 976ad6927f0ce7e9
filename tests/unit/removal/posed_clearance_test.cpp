// Tools that turn in the air, against blanks: nothing that touches is taken for clear.
#include "removal/contact/posed_clearance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "removal/grid/shape_field.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout {
namespace {

using test::tool;

struct Turning {
  Toolpath path;
  Motion motion;
  AxisSweep axis;
};

Turning turning(const Vec3& from, const Vec3& to, const Vec3& axis_from, const Vec3& axis_to) {
  Turning out;
  out.motion.from = from;
  out.motion.to = to;
  out.axis.from = axis_from;
  out.axis.to = axis_to;
  return out;
}

bool isClear(const Turning& t, const ToolSolid& tool, const BlankField& body) {
  const BlankField* const bodies[] = {&body};
  return !firstUnclear(t.path, t.motion, t.axis, tool, bodies);
}

/// Points of a box's surface, about `step` apart.
std::vector<Vec3> pointsOf(const BoxShape& box, double step) {
  std::vector<Vec3> out;
  const Eigen::Array3i n = ((box.max - box.min) / step).array().ceil().cast<int>();
  for (int x = 0; x <= n.x(); ++x) {
    for (int y = 0; y <= n.y(); ++y) {
      for (int z = 0; z <= n.z(); ++z) {
        if (x > 0 && x < n.x() && y > 0 && y < n.y() && z > 0 && z < n.z()) continue;
        const Vec3 share(double(x) / n.x(), double(y) / n.y(), double(z) / n.z());
        out.push_back(box.min + share.cwiseProduct(box.max - box.min));
      }
    }
  }
  return out;
}

/// Least distance of the points from the tool, at many poses.
double denseClearance(const Turning& t, const ToolSolid& tool, const std::vector<Vec3>& points) {
  double least = std::numeric_limits<double>::infinity();
  const double angle = std::acos(std::clamp(t.axis.from.dot(t.axis.to), -1.0, 1.0));
  const Vec3 about = t.axis.from.cross(t.axis.to).normalized();
  for (int k = 0; k <= 100; ++k) {
    const double u = k / 100.0;
    const Vec3 axis = Eigen::AngleAxisd(u * angle, about) * t.axis.from;
    const Vec3 tip = t.motion.from + u * (t.motion.to - t.motion.from);
    for (const Vec3& p : points) {
      const double z = axis.dot(p - tip), r = (p - tip - z * axis).norm();
      for (const auto* parts : {&tool.cutter, &tool.shank, &tool.holder}) {
        for (const ConvexProfile& part : *parts) least = std::min(least, part.sample(r, z).value);
      }
    }
  }
  return least;
}

TEST(PosedClearance, HighIsClearAndLowIsNot) {
  const auto body = shapeField(BoxShape{{-50, -50, -20}, {50, 50, 0}});
  ASSERT_TRUE(body.ok());
  const ToolSolid solid = makeToolSolid(tool("1=flat:10"));
  const Vec3 up = Vec3::UnitZ(), level = Vec3::UnitX(), half = Vec3(1, 0, 1).normalized();
  EXPECT_TRUE(isClear(turning({0, 0, 30}, {0, 0, 30}, up, level), solid, **body));
  EXPECT_TRUE(isClear(turning({0, 0, 5.3}, {0, 0, 5.3}, up, level), solid, **body));
  EXPECT_FALSE(isClear(turning({0, 0, 4.9}, {0, 0, 4.9}, up, level), solid, **body));
  // Leaning by 45 degrees the rim is 5 sin 45 below the tip.
  EXPECT_TRUE(isClear(turning({0, 0, 3.8}, {0, 0, 3.8}, up, half), solid, **body));
  EXPECT_FALSE(isClear(turning({0, 0, 3.5}, {0, 0, 3.5}, up, half), solid, **body));
  EXPECT_FALSE(isClear(turning({0, 0, 30}, {0, 0, -1}, up, half), solid, **body));
  EXPECT_TRUE(isClear(turning({80, 0, -10}, {80, 0, -10}, up, level), solid, **body));
  EXPECT_FALSE(isClear(turning({80, 0, -10}, {80, 0, -10}, up, -level), solid, **body));
}

TEST(PosedClearance, NothingThatTouchesIsTakenForClear) {
  const BoxShape box{{-20, -15, -10}, {20, 15, 0}};
  const auto body = shapeField(box);
  ASSERT_TRUE(body.ok());
  const std::vector<Vec3> points = pointsOf(box, 4.0);
  constexpr double kSpaced = 6.0;  // mm: a diagonal between points, and what poses are apart
  std::mt19937_64 engine(7);
  const auto random = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto direction = [&] { return Vec3(random(-1, 1), random(-1, 1), random(0, 1)).normalized(); };
  int clear = 0, touched = 0, doubtful = 0;
  for (const char* name : {"1=flat:6", "1=ball:8", "1=bull:8:2", "1=drill:6:118", "1=lollipop:6:3"}) {
    const ToolSolid solid = makeToolSolid(tool(name));
    for (int i = 0; i < 60; ++i) {
      const Vec3 from(random(-40, 40), random(-40, 40), random(-5, 30));
      Turning t = turning(from, from + Vec3(random(-20, 20), random(-20, 20), random(-10, 10)), direction(),
                          Vec3::UnitZ());
      t.axis.to = (t.axis.from + Vec3(random(-1, 1), random(-1, 1), random(-1, 1)) * 0.7).normalized();
      const double dense = denseClearance(t, solid, points);
      const bool is_clear = isClear(t, solid, **body);
      EXPECT_FALSE(is_clear && dense < -1e-3) << name << ' ' << i << ": " << dense;
      EXPECT_TRUE(is_clear || dense <= kSpaced) << name << ' ' << i << ": " << dense;
      (dense < -1e-3 ? touched : dense > kSpaced ? clear : doubtful) += 1;
    }
  }
  EXPECT_GT(clear, 40);
  EXPECT_GT(touched, 30);
}

}  // namespace
}  // namespace proveout
