// Curves of the 30i: NURBS, involutes, arcs in space, polar and cylindrical planes (rows fan-3-*).
#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

IsoRun curveRun(const std::string& text) {
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100.\n" + text + "\nM30\n", runAtZero({{"rapid", 1.0}})};
}
/// How far the path is from the curve, both ways: of the path's points from the curve, of the curve's points
/// from the path, mm.
double distanceTo(const IsoRun& run, const std::function<Vec3(double)>& curve) {
  std::vector<Vec3> points;
  for (int k = 0; k <= 20000; ++k) points.push_back(curve(k / 20000.0));
  double most = 0.0;
  for (std::size_t k = 0; k < points.size(); k += 50) {
    double best = 1e9;
    for (const Motion& m : run.path.motions) {
      const Vec3 d = m.to - m.from;
      const double t =
          d.squaredNorm() > 0.0 ? std::clamp((points[k] - m.from).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      best = std::min(best, (points[k] - m.from - t * d).norm());
    }
    most = std::max(most, best);
  }
  return most;
}

// fan-3-G02.4: a circle of radius 10 about (10, 0, 0) in the plane X-Z
TEST(FanucCurves, AnArcInSpaceGoesThroughItsMiddle) {
  const IsoRun run = curveRun("G02.4 X10. Z10.\nX20. Z0\nG1 Y5.");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_NEAR((run.end() - Vec3(20.0, 5.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_LT(distanceTo(run,
                       [](double t) {
                         return Vec3(10.0 - 10.0 * std::cos(M_PI * t), 0.0, 10.0 * std::sin(M_PI * t));
                       }),
            1e-3);
  // Incremental: the end counts from the middle.
  EXPECT_NEAR((curveRun("G91 G03.4 X10. Z10.\nX10. Z-10.").end() - Vec3(20.0, 0.0, 0.0)).norm(), 0.0, 1e-9);
  // Three points on a line.
  EXPECT_EQ(curveRun("G02.4 X10.\nX20.").motions(), (Lines{"F 20 0 0"}));
  EXPECT_EQ(curveRun("G02.4 X10. Z10.\nG1 X20.").error(), "fanuc-5432");
}

// fan-3-G02.2: base circle radius 10 about (0, 0), from a = 1 to a = 2
TEST(FanucCurves, Involutes) {
  const auto at = [](double a) {
    return Vec3(10.0 * (std::cos(a) + a * std::sin(a)), 10.0 * (std::sin(a) - a * std::cos(a)), 0.0);
  };
  const Vec3 from = at(1.0), to = at(2.0);
  const std::string head = fmt::format("G1 X{:.3f} Y{:.3f}\n", from.x(), from.y());
  const std::string words =
      fmt::format("X{:.3f} Y{:.3f} I{:.3f} J{:.3f} R10.", to.x(), to.y(), -from.x(), -from.y());
  const IsoRun run = curveRun(head + "G03.2 " + words);
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_LT(distanceTo(run, [&](double t) { return at(1.0 + t); }), 2e-3);
  // Back along the same curve.
  const std::string back = fmt::format("G1 X{:.3f} Y{:.3f}\nG02.2 X{:.3f} Y{:.3f} I{:.3f} J{:.3f} R10.",
                                       to.x(), to.y(), from.x(), from.y(), -to.x(), -to.y());
  const IsoRun inwards = curveRun(back);
  EXPECT_EQ(inwards.error(), "") << inwards.message();
  EXPECT_LT(distanceTo(inwards, [&](double t) { return at(1.0 + t); }), 2e-3);
  EXPECT_EQ(curveRun(head + "G02.2 " + words).error(), "fanuc-243");
  EXPECT_EQ(curveRun(head + "G03.2 X30. Y0 I-13.818 J-3.012 R10.").error(), "fanuc-243");
  EXPECT_EQ(curveRun(head + "G03.2 X1. Y0 I-13.818 J-3.012 R10.").error(), "fanuc-242");
  EXPECT_EQ(curveRun(head + "G03.2 X20. Y0 I-13. J-3.").error(), "fanuc-241");
}

// fan-3-G06.2: a cubic Bezier curve, and a quarter of a circle by weights
TEST(FanucCurves, Nurbs) {
  const IsoRun bezier =
      curveRun("G06.2 P4 K0 X0 Y0\nK0 X0 Y10.\nK0 X20. Y10.\nK0 X20. Y0\nK1.\nK1.\nK1.\nK1.\nG1 Z5.");
  EXPECT_EQ(bezier.error(), "") << bezier.message();
  EXPECT_EQ(bezier.motions().back(), "F 20 0 5");
  EXPECT_LT(distanceTo(bezier,
                       [](double t) {
                         const double s = 1.0 - t;
                         return Vec3(60.0 * s * t * t + 20.0 * t * t * t, 30.0 * s * s * t + 30.0 * s * t * t,
                                     0.0);
                       }),
            1e-3);
  const IsoRun quarter =
      curveRun("G1 X10.\nG06.2 P3 K0 X10. Y0 R1.\nK0 X10. Y10. R.70710678\nK0 X0 Y10. R1.\nK1.\nK1.\nK1.");
  EXPECT_EQ(quarter.error(), "") << quarter.message();
  EXPECT_LT(distanceTo(quarter,
                       [](double t) {
                         return Vec3(10.0 * std::cos(0.5 * M_PI * t), 10.0 * std::sin(0.5 * M_PI * t), 0.0);
                       }),
            1e-3);
  EXPECT_NEAR((quarter.end() - Vec3(0.0, 10.0, 0.0)).norm(), 0.0, 1e-6);
}

TEST(FanucCurves, NurbsThatAreNone) {
  for (const auto& [text, code] : std::vector<std::pair<const char*, const char*>>{
           {"G06.2 P4 K0 X0 Y0\nK0 X5.\nG1 X10.", "fanuc-5117"},
           {"G06.2 P4 K0 X0 Y0\nK0 X5.\nX6.", "fanuc-5117"},
           {"G06.2 P2 K0 X0 Y0\nK1. X5.\nK0\nK1.", "fanuc-5116"},
           {"G06.2 P4 X0 Y0", "fanuc-5117"},
           {"G06.2 P99 K0 X0 Y0", "fanuc-003"},
           {"G06.2 P4 K0 X0\nK1.\nK1.\nK1.\nK1.", "fanuc-5117"},
           {"G06.2 P2 K0 X0\nK0 X1.\nK0\nK0", "fanuc-5115"},
           {"G06.2 P4 K0 X0 Y0\nK0 X5.", "fanuc-5117"},
       }) {
    EXPECT_EQ(curveRun(text).error(), code) << text << ": " << curveRun(text).message();
  }
}

// fan-3-G02.3
TEST(FanucCurves, ExponentialInterpolationIsRefused) {
  EXPECT_EQ(curveRun("G02.3 X5. I2. J3. R4.").error(), "fanuc-010");
  EXPECT_EQ(curveRun("G03.3 X5. I2. J3. R4.").error(), "fanuc-010");
}

/// A table C about Z through the workpiece's origin.
ControlSettings withTable() {
  ControlSettings settings = runAtZero({{"rapid", 1.0}});
  AxisSettings c;
  c.name = "C";
  c.number = 4;
  c.center = Vec3::Zero();
  settings.axes.push_back(c);
  return settings;
}

// fan-3-G12.1 fan-3-G13.1
TEST(FanucCurves, PolarPlane) {
  for (const auto& [on, off] :
       std::vector<std::pair<const char*, const char*>>{{"G12.1", "G13.1"}, {"G112", "G113"}}) {
    const std::string text = fmt::format(
        "O1\nG21 G90 G17\nG0 X20. C0\n{}\nG1 X20. C10. F100.\nX-20. C10.\n{}\nG0 X30.\nM30\n", on, off);
    const IsoRun run(ControlId::kFanucMill, text, withTable());
    EXPECT_EQ(run.error(), "") << text << run.message();
    ASSERT_GT(run.path.motions.size(), 2u);
  }
}

// fan-3-G07.1: on a cylinder of radius 20 mm, 90 degrees are 31.416 mm
TEST(FanucCurves, Cylinder) {
  for (const char* code : {"G07.1", "G107"}) {
    const std::string text = fmt::format(
        "O1\nG21 G90 G17\nG0 Z25. C0\n{0} C20.\nG1 Z20. F100.\nC90. X10.\n{0} C0\nG0 Z30.\nM30\n", code);
    const IsoRun run(ControlId::kFanucMill, text, withTable());
    EXPECT_EQ(run.error(), "") << text << run.message();
    double time = 0.0;
    for (const Motion& m : run.path.motions)
      if (m.source.line == 6) time += m.time_s;
    EXPECT_NEAR(time, 60.0 * std::hypot(20.0 * M_PI / 2.0, 10.0) / 100.0, 1e-6) << code;
  }
}

}  // namespace
}  // namespace proveout::test
