// The pocket milling macro: what a flat tool on its path cuts, point by point, against the pocket's outline.
// Proves nct-23.6-P9999 nct-23.6-special
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/nc/registry/interpreter.h"
#include "core/path/toolpath.h"

namespace proveout {
namespace {

constexpr double kToolRadius = 5.0;

struct Segment {
  Vec2 a, b;
};

/// The feed motions by level, arcs as chords of one degree: at most 0.6 micrometres inside.
struct PathRecorder : MotionSink {
  void file(std::uint32_t, const std::string&) override {}
  void event(const PathEvent&) override {}
  void diagnostic(const Diagnostic& d) override { said += formatDiagnostic(d); }
  void motion(const Motion& m, const ArcGeometry* arc, const AxisSweep*) override {
    last = m.to;
    if (m.kind != MotionKind::kFeed) return;
    lowest = std::min(lowest, m.to.z());
    if (m.to.z() != m.from.z() || m.to.z() > lowest) return;
    const int steps = arc ? std::max(1, static_cast<int>(std::abs(radToDeg(arc->sweep_rad)))) : 1;
    Vec2 from = m.from.head<2>();
    for (int k = 1; k <= steps; ++k) {
      Vec2 to = m.to.head<2>();
      if (arc) {
        const double angle = arc->sweep_rad * arc->normal.z() * k / steps;
        const Vec2 r = (m.from - arc->center).head<2>();
        to = arc->center.head<2>() + Vec2(r.x() * std::cos(angle) - r.y() * std::sin(angle),
                                          r.x() * std::sin(angle) + r.y() * std::cos(angle));
      }
      levels[m.to.z()].push_back({from, to});
      from = to;
    }
  }
  std::map<double, std::vector<Segment>> levels;
  std::string said;
  double lowest = 1e9;
  Vec3 last = Vec3::Zero();
};

double distance(const Vec2& p, const Segment& s) {
  const Vec2 d = s.b - s.a;
  const double t = d.squaredNorm() > 0 ? std::clamp((p - s.a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - s.a - t * d).norm();
}

/// Signed distance to a rectangle of those half sides with round corners; < 0 inside.
double outline(const Vec2& p, const Vec2& half, double corner) {
  const Vec2 q = p.cwiseAbs() - (half - Vec2::Constant(corner));
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - corner;
}

struct Pocket {
  const char* call;
  Vec2 half;
  double corner, depth;
  int levels;
};

class PocketPath : public testing::TestWithParam<Pocket> {};

TEST_P(PocketPath, ClearsThePocketAndNothingElse) {
  const Pocket& pocket = GetParam();
  MemoryProgramSource source("main.nc", std::string("G17 G90 G0 X0 Y0 Z2\n") + pocket.call + "\nM30\n");
  ControlSettings settings;
  settings.radius_offsets[1] = {kToolRadius, 0.0};
  PathRecorder path;
  ASSERT_TRUE(interpret(ControlId::kNct, source, settings, path).ok()) << path.said;
  EXPECT_EQ(path.said, "");
  EXPECT_NEAR((path.last - Vec3(0, 0, 2)).norm(), 0.0, 1e-9) << "ends where it started";
  EXPECT_NEAR(path.lowest, -pocket.depth, 1e-9);
  ASSERT_EQ(path.levels.size(), static_cast<std::size_t>(pocket.levels));
  constexpr double kStep = 0.4, kNear = 1e-3;
  for (const auto& [z, segments] : path.levels) {
    int left = 0, gouged = 0;
    for (double x = -33.1; x < 33.2; x += kStep) {
      for (double y = -33.1; y < 33.2; y += kStep) {
        const Vec2 p(x, y);
        const double inside = outline(p, pocket.half, pocket.corner);
        const bool cut = std::any_of(segments.begin(), segments.end(),
                                     [&](const Segment& s) { return distance(p, s) <= kToolRadius; });
        left += !cut && inside < -kNear;
        gouged += cut && inside > kNear;
      }
    }
    EXPECT_EQ(left, 0) << "left standing at Z" << z;
    EXPECT_EQ(gouged, 0) << "cut outside at Z" << z;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, PocketPath,
    testing::Values(Pocket{"G65 P9999 X60 Y40 Z10 K2 R8 D1 E60 Q4 F400", {30, 20}, 8, 10, 3},
                    Pocket{"G65 P9999 X60 Y40 Z10 K2 R8 D1 E-60 Q4 F400", {30, 20}, 8, 10, 3},
                    Pocket{"G65 P9999 X40 Y60 Z5 K2 R8 D1 Q5 F400", {20, 30}, 8, 5, 1},
                    Pocket{"G65 P9999 X60 Y40 Z10 K2 D1 Q10 F400", {30, 20}, 5, 10, 1},
                    Pocket{"G65 P9999 Z6 K2 R20 D1 E50 Q3 F300", {20, 20}, 20, 6, 2},
                    Pocket{"G65 P9999 Y50 Z5 K2 D1 Q5 F200", {5, 25}, 5, 5, 1},
                    Pocket{"G65 P9999 X50 Z5 K2 R8 D1 Q5 F200", {25, 8}, 8, 5, 1},
                    Pocket{"G65 P9999 X50 Y50 Z4 K2 D1 Q4 F400", {25, 25}, 5, 4, 1}));

}  // namespace
}  // namespace proveout
