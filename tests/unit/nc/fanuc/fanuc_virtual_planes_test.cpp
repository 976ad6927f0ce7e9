// Polar and cylindrical interpolation against the same contours in a plane of linear axes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

ControlSettings tableMill(const Vec3& start) {
  ControlSettings settings = runAtZero();
  AxisSettings c;
  c.name = "C";
  c.number = 4;
  c.center = Vec3::Zero();
  settings.axes.push_back(c);
  settings.start = start;
  settings.radius_offsets[1] = {2.0, 0.0};
  return settings;
}

/// A contour in (X, C), with `second` as the name of the second axis: lines at right angles and arcs between
/// them, compensated or not. It stays away from the centre.
std::string contour(std::mt19937& random, char second, char centre) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const bool comp = below(2) == 0;
  std::string text = fmt::format("{} G1 X40. F200.\n", comp ? (below(2) == 0 ? "G41 D1" : "G42 D1") : "");
  int x = 40, y = 0;
  for (int k = 0; k < 4; ++k) {
    const int dx = 10 * (1 + below(3)), dy = (below(2) == 0 ? 1 : -1) * 10 * (1 + below(2));
    if (below(3) == 0) {  // a quarter, then a line that goes on
      const int r = 10;
      const bool up = below(2) == 0;
      text += fmt::format("G1 X{}.\n", x += dx);
      text += fmt::format("G{} X{}. {}{}. I0 {}{}.\n", up ? 3 : 2, x + r, second, y + (up ? r : -r), centre,
                          up ? r : -r);
      x += r;
      y += up ? r : -r;
      text += fmt::format("G1 {}{}.\n", second, y += (up ? 20 : -20));
      continue;
    }
    text += fmt::format("G1 X{}.\n{}{}.\n", x += dx, second, y += dy);
  }
  return text + fmt::format("G1 X{}.\n{}X{}.\n", x + 20, comp ? "G40 " : "", x + 40);
}

std::vector<Vec3> pointsOf(const IsoRun& run) {
  std::vector<Vec3> all;
  for (const Motion& m : run.path.motions) {
    all.push_back(m.to);
    if (m.arc >= 0) all.push_back(run.path.arcs[static_cast<std::size_t>(m.arc)].center);
  }
  return all;
}

// fan-3-G12.1 fan-3-G13.1: seen from the part the tool goes as X and C are written
TEST(FanucVirtualPlanes, PolarContoursAreThoseOfThePlane) {
  const Vec3 start(60, 0, 5);
  int arcs = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937 first(seed), second(seed);
    const std::string head = "O1\nG21 G90 G17\n";
    const IsoRun polar(ControlId::kFanucMill, head + "G12.1\n" + contour(first, 'C', 'J') + "G13.1\nM30\n",
                       tableMill(start));
    const IsoRun plane(ControlId::kFanucMill, head + contour(second, 'Y', 'J') + "M30\n", tableMill(start));
    ASSERT_EQ(plane.error(), "") << plane.message();
    ASSERT_EQ(polar.error(), "") << polar.message();
    const auto a = pointsOf(polar), b = pointsOf(plane);
    ASSERT_EQ(a.size(), b.size()) << seed;
    for (std::size_t k = 0; k < a.size(); ++k)
      ASSERT_LT((a[k] - b[k]).norm(), 1e-6) << seed << " point " << k;
    for (const Motion& m : polar.path.motions) arcs += m.arc >= 0 ? 1 : 0;
  }
  EXPECT_GT(arcs, 50);
}

TEST(FanucVirtualPlanes, PolarFeedIsThatOfThePlane) {
  const std::string text = "G1 X20. C30. F300.\nC-30.\nX40.\n";
  const IsoRun polar(ControlId::kFanucMill, "O1\nG21 G90\nG12.1\n" + text + "G13.1\nM30\n",
                     tableMill(Vec3(60, 0, 5)));
  std::string flat = text;
  std::replace(flat.begin(), flat.end(), 'C', 'Y');
  const IsoRun plane(ControlId::kFanucMill, "O1\nG21 G90\n" + flat + "M30\n", tableMill(Vec3(60, 0, 5)));
  EXPECT_NEAR(polar.summary.cycle_s, plane.summary.cycle_s, 1e-6);
}

// fan-3-G07.1: unrolled, the path is that of the plane
TEST(FanucVirtualPlanes, CylindersUnroll) {
  constexpr double kRadius = 20.0, kDegree = kRadius * M_PI / 180.0;
  const std::string body =
      "G1 Z20. F100.\nC90. Z12.\nG3 C120. Z5. R12.\nG2 C150. Z12. R15.\nG91 G1 C30. Z-4.\nG90 C0 Z0\n";
  const IsoRun run(ControlId::kFanucMill, "O1\nG21 G90 G17\nG07.1 C20.\n" + body + "G07.1 C0\nM30\n",
                   tableMill(Vec3(kRadius, 0, 25)));
  ASSERT_EQ(run.error(), "") << run.message();
  struct Arc {
    std::uint32_t line;
    Vec2 from, to;
    double radius;
    bool ccw;
  };
  const auto flat = [&](double degrees, double z) { return Vec2(kDegree * degrees, z); };
  const std::vector<Arc> arcs{{6, flat(90, 12), flat(120, 5), 12.0, true},
                              {7, flat(120, 5), flat(150, 12), 15.0, false}};
  double turned = 0.0;
  std::size_t on_arcs = 0;
  Vec3 before(kRadius, 0, 25);
  for (const Motion& m : run.path.motions) {
    // The angle goes on from that of the motion before.
    turned += std::remainder(std::atan2(m.to.y(), m.to.x()) - std::atan2(before.y(), before.x()), 2.0 * M_PI);
    before = m.to;
    EXPECT_NEAR(m.to.head<2>().norm(), kRadius, 1e-6);
    const Vec2 at(kRadius * turned, m.to.z());
    for (const Arc& arc : arcs) {
      if (m.source.line != arc.line) continue;
      const Vec2 way = arc.to - arc.from, normal(-way.y(), way.x());
      const double rise = std::sqrt(arc.radius * arc.radius - 0.25 * way.squaredNorm());
      const Vec2 centre = arc.from + 0.5 * way + (arc.ccw ? 1.0 : -1.0) * rise * normal.normalized();
      EXPECT_NEAR((at - centre).norm(), arc.radius, 2e-3) << "line " << arc.line;
      ++on_arcs;
    }
  }
  EXPECT_GT(on_arcs, 20U);
  EXPECT_NEAR(turned, 0.0, 1e-9);
}

TEST(FanucVirtualPlanes, CompensationRunsOnTheCylinder) {
  constexpr double kRadius = 20.0;
  // 36 degrees are 4 pi mm; the words of the plane are rounded to a thousandth.
  const IsoRun run(ControlId::kFanucMill,
                   "O1\nG21 G90 G17\nG07.1 C20.\nG41 D1 G1 C36. Z20. F100.\nC144.\nZ5.\nC36.\nZ30.\nG40 C0\n"
                   "G07.1 C0\nM30\n",
                   tableMill(Vec3(kRadius, 0, 25)));
  ASSERT_EQ(run.error(), "") << run.message();
  const IsoRun plane(
      ControlId::kFanucMill,
      "O1\nG21 G90 G19\nG41 D1 G1 Y12.566 Z20. F100.\nY50.265\nZ5.\nY12.566\nZ30.\nG40 Y0\nM30\n",
      tableMill(Vec3(kRadius, 0, 25)));
  ASSERT_EQ(plane.error(), "") << plane.message();
  ASSERT_EQ(run.path.motions.size(), plane.path.motions.size());
  for (std::size_t k = 0; k < plane.path.motions.size(); ++k) {
    const Vec3 &on = run.path.motions[k].to, &flat = plane.path.motions[k].to;
    double angle = std::atan2(on.y(), on.x());
    if (angle < -0.5) angle += 2.0 * M_PI;
    EXPECT_NEAR(kRadius * angle, flat.y(), 2e-3) << k;
    EXPECT_NEAR(on.z(), flat.z(), 2e-3) << k;
  }
}

TEST(FanucVirtualPlanes, AreRefusedWhereTheyCannotBe) {
  struct Row {
    const char *text, *code;
  };
  for (const Row& row : {Row{"G12.1 X5.", "fanuc-145"},
                         {"G0 C10.\nG12.1", "fanuc-145"},
                         {"G0 X0\nG12.1", "fanuc-145"},
                         {"G41 D1\nG12.1", "fanuc-146"},
                         {"G12.1\nG28 X0", "fanuc-146"},
                         {"G12.1\nG92 X0", "fanuc-146"},
                         {"G12.1\nG18", "fanuc-146"},
                         {"G12.1\nG31 X5.", "fanuc-146"},
                         {"G12.1\nG53 X0", "fanuc-146"},
                         {"G12.1\nG52 X1.", "fanuc-146"},
                         {"G12.1\nG07.1 C5.", "fanuc-146"},
                         {"G07.1 C20. X5.", "fanuc-175"},
                         {"G07.1 X20.", "fanuc-175"},
                         {"G07.1 C20.\nG12.1", "fanuc-146"},
                         {"G07.1 C20.\nG81 Z1. R2. F100.", "fanuc-146"},
                         {"G07.1 C20.\nG2 Z10. C10. I5. F100.", "fanuc-176"},
                         {"G68 X0 Y0 R30.\nG12.1", "fanuc-virtual-frame"}})
    EXPECT_EQ(IsoRun(ControlId::kFanucMill, std::string("O1\nG21 G90\n") + row.text + "\nM30\n",
                     tableMill(Vec3(40, 0, 10)))
                  .error(),
              row.code)
        << row.text;
  EXPECT_EQ(IsoRun(ControlId::kFanucMill, "O1\nG21 G90\nG12.1\nM30\n").error(), "fanuc-028");
}

}  // namespace
}  // namespace proveout::test
