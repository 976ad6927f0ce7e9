// Times of programs with accelerations: closed forms, and that what waits keeps its order.
#include "core/nc/stages/time_stage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/nc/registry/interpreter.h"

namespace proveout::nc {
namespace {

class Recorder : public MotionSink {
 public:
  void file(std::uint32_t, const std::string&) override {}
  void motion(const Motion& m, const ArcGeometry*, const AxisSweep*) override {
    motions.push_back(m);
    order += 'm';
  }
  void event(const PathEvent& e) override { order += e.as<event::End>() != nullptr ? '.' : 'e'; }
  void diagnostic(const Diagnostic& d) override { order += d.severity == Severity::kError ? '!' : '?'; }
  double sum() const {
    double s = 0.0;
    for (const Motion& m : motions) s += m.time_s;
    return s;
  }

  std::vector<Motion> motions;
  std::string order;
};

ControlSettings machine(double acceleration) {
  ControlSettings s;
  s.start = Vec3::Zero();
  s.acceleration_mm_s2 = Vec3::Constant(acceleration);
  return s;
}

InterpretSummary run(const std::string& text, const ControlSettings& settings, Recorder& out) {
  const MemoryProgramSource source("main.nc", text);
  const InterpretSummary summary = interpret(ControlId::kNct, source, settings, out);
  EXPECT_NEAR(summary.cutting_s + summary.rapid_s, out.sum(), 1e-9 * (1 + out.sum()));
  return summary;
}

/// Time of one line from stand to stand.
double trapezoid(double length, double speed, double acceleration) {
  return length / speed + speed / acceleration;
}

TEST(TimeStage, ALineAccelerates) {
  Recorder out;
  run("G1 X100 F3000\nM30\n", machine(500), out);
  ASSERT_EQ(out.motions.size(), 1u);
  EXPECT_NEAR(out.motions[0].time_s, trapezoid(100, 50, 500), 1e-9);
}

TEST(TimeStage, TheSlowestAxisSetsTheAcceleration) {
  // nct-7-acc: on the diagonal each axis has 1/sqrt(2) of the acceleration along the path.
  ControlSettings s = machine(500);
  s.acceleration_mm_s2.y() = 250;
  Recorder out;
  run("G1 X100 Y100 F3000\nM30\n", s, out);
  EXPECT_NEAR(out.sum(), trapezoid(100 * std::sqrt(2.0), 50, 250 * std::sqrt(2.0)), 1e-9);
}

TEST(TimeStage, RapidsStandStillAtTheirEnds) {
  // nct-6.1-rapid, nct-7-acc: 15000 mm/min are 250 mm/s.
  Recorder out;
  run("G0 X100\nX200\nM30\n", machine(5000), out);
  EXPECT_NEAR(out.sum(), 2 * trapezoid(100, 250, 5000), 1e-9);
}

TEST(TimeStage, RapidsOverlapWhereTheMachineDoesSo) {
  // nct-4.1.2-ROL, nct-4.1.2-N0422: the next rapid starts when the last one is down to half its speed, which
  // it has half a ramp before its end.
  ControlSettings s = machine(5000);
  s.parameters = {{"N0421.ROL", 1}, {"N0422", 50}};
  Recorder overlapped;
  run("G0 X100\nX200\nM30\n", s, overlapped);
  EXPECT_NEAR(overlapped.sum(), 2 * trapezoid(100, 250, 5000) - 0.025, 1e-9);
  // nct-4.1.1-G9G61, nct-4.1.1-PCH: an exact stop and the check of the position suspend it.
  for (const char* text : {"G61 G0 X100\nX200\nM30\n", "G9 G0 X100\nX200\nM30\n"}) {
    Recorder stopped;
    run(text, s, stopped);
    EXPECT_NEAR(stopped.sum(), 2 * trapezoid(100, 250, 5000), 1e-9) << text;
  }
  s.parameters["N1337.PCH"] = 1;
  Recorder checked;
  run("G0 X100\nX200\nM30\n", s, checked);
  EXPECT_NEAR(checked.sum(), 2 * trapezoid(100, 250, 5000), 1e-9);
}

TEST(TimeStage, OverlappingRapidsRoundTheirCorners) {
  // nct-4.1.2-ROL: the manual's example at 1 m/s^2. Each rapid takes 2 sqrt(d / a), the next one starts half
  // a ramp before its end.
  ControlSettings s = machine(1000);
  s.parameters = {{"N0421.ROL", 1}, {"N0422", 50}};
  Recorder out;
  run("G0 Z10\nX30\nZ1\nM30\n", s, out);
  const double z10 = std::sqrt(0.01), x30 = std::sqrt(0.03), z9 = std::sqrt(0.009);
  EXPECT_NEAR(out.sum(), 2 * (z10 + x30 + z9) - 0.5 * (z10 + x30), 1e-9);
  ASSERT_GT(out.motions.size(), 20u);
  EXPECT_EQ(out.motions.back().to, Vec3(30, 0, 1));
  // Z is z10 / 2 from its end when X starts: with t the time since, x = a t^2 / 2, z = 10 - a (z10 / 2 - t)^2
  // / 2. The corner (0, 10) is missed by some 0.29 mm.
  double nearest = 1e9;
  for (const Motion& m : out.motions) {
    EXPECT_EQ(m.kind, MotionKind::kRapid);
    nearest = std::min(nearest, (m.to - Vec3(0, 0, 10)).norm());
    if (m.to.x() <= 0.0 || m.to.x() > 1.2 || m.source.line != 2) continue;
    const double t = std::sqrt(2 * m.to.x() / 1000), left = std::max(0.0, z10 / 2 - t);
    EXPECT_NEAR(m.to.z(), 10 - 500 * left * left, 1e-9);
  }
  double expected = 1e9;
  for (double t = 0; t < z10 / 2; t += 1e-5) {
    expected = std::min(expected, std::hypot(500 * t * t, 500 * (z10 / 2 - t) * (z10 / 2 - t)));
  }
  EXPECT_NEAR(nearest, expected, 0.02);
  // Feeds, functions and exact stops wait for the axes: no corner is missed in front of them.
  for (const char* end : {"G1 X30 F1000\n", "M8\nX30\n", "G4 P1\nX30\n"}) {
    Recorder waits;
    run(std::string("G0 Z10\n") + end + "M30\n", s, waits);
    EXPECT_EQ(waits.motions[0].to, Vec3(0, 0, 10)) << end;
  }
}

TEST(TimeStage, TheClockOfAProgramCountsRapidsThatWait) {
  // #3001 behind 0.2 s of rapid, in milliseconds; with a bell it counts the rise as well.
  ControlSettings s = machine(1000);
  s.parameters = {{"N0421.ROL", 1}, {"N0422", 50}};
  const std::string text = "#3001=0\nG0 Z10\n#100=#3001\nG0 X#100\nM30\n";
  Recorder plain, bell;
  run(text, s, plain);
  EXPECT_NEAR(plain.motions.back().to.x(), 200.0, 1e-3);
  s.bell_time_s = 0.1;
  run(text, s, bell);
  EXPECT_NEAR(bell.motions.back().to.x(), 300.0, 1e-3);
  s.parameters = {};
  Recorder sharp;
  run(text, s, sharp);
  EXPECT_NEAR(sharp.motions.back().to.x(), 300.0, 1e-3);
}

TEST(TimeStage, ARapidThatOverlapsIsStraightInItsMiddleOnly) {
  // nct-4.1.2-ROL: the axes of one block reach their ends at different times: Z 1.05 s, X 1.25 s after the
  // start.
  ControlSettings s = machine(1000);
  s.parameters = {{"N0421.ROL", 1}};
  Recorder out;
  run("G0 X250 Z50\nM30\n", s, out);
  EXPECT_NEAR(out.sum(), 1.25, 1e-9);
  const Motion& last = out.motions.back();
  EXPECT_EQ(last.from.z(), 50.0);
  EXPECT_NEAR(last.to.x() - last.from.x(), 0.5 * 1000 * 0.2 * 0.2, 0.1);
  // Without accelerations nothing is rounded, and that is told.
  Recorder sharp;
  run(
      "G0 X250 Z50\nM30\n",
      [&] {
        ControlSettings none = machine(0);
        none.parameters = s.parameters;
        return none;
      }(),
      sharp);
  EXPECT_EQ(sharp.motions.size(), 1u);
  EXPECT_EQ(sharp.order, "?m.");
}

TEST(TimeStage, ExactStopAndContinuousCutting) {
  // nct-6.3.1-G9 nct-3-G9, nct-6.3.2-G61 nct-3-G61, nct-6.3.3-G64 nct-3-G64: straight on without a stop,
  // unless one is asked for.
  const double through = trapezoid(200, 50, 500), stopped = 2 * trapezoid(100, 50, 500);
  const auto time = [](const std::string& text) {
    Recorder out;
    run(text, machine(500), out);
    return out.sum();
  };
  EXPECT_NEAR(time("G1 X100 F3000\nX200\nM30\n"), through, 1e-9);
  EXPECT_NEAR(time("G1 G9 X100 F3000\nX200\nM30\n"), stopped, 1e-9);
  EXPECT_NEAR(time("G61 G1 X100 F3000\nX200\nM30\n"), stopped, 1e-9);
  EXPECT_NEAR(time("G61 G1 F3000\nG64 X100\nX200\nM30\n"), through, 1e-9);
  EXPECT_NEAR(time("G1 X100 F3000\nM8\nX200\nM30\n"), stopped, 1e-9);  // functions wait for the axes
}

TEST(TimeStage, CornersByTheChangeOfSpeed) {
  // nct-7.1-corner: 90 degrees at v change X and Y by v each; 600 mm/min allow 10 mm/s.
  ControlSettings s = machine(500);
  s.parameters = {{"N0309", 600}};
  Recorder out;
  run("G1 X100 F3000\nY100\nM30\n", s, out);
  const double ramp = 0.1, slow = 40.0 / 500, slow_mm = (50.0 * 50 - 10 * 10) / 1000;
  EXPECT_NEAR(out.sum(), 2 * (ramp + slow + (100 - 2.5 - slow_mm) / 50), 1e-9);
  // nct-6.3.4-G63 nct-3-G63: no slow-down between blocks.
  Recorder tapping;
  run("G63 G1 X100 F3000\nY100\nM30\n", s, tapping);
  EXPECT_NEAR(tapping.sum(), 2 * (ramp + 97.5 / 50), 1e-9);
}

TEST(TimeStage, CornersByTheirAngle) {
  // nct-7.1-corner
  ControlSettings s = machine(500);
  s.parameters = {{"N0306.FDF", 0}, {"N0307", 45}, {"N0308", 600}};
  Recorder sharp, flat;
  run("G1 X100 F3000\nY100\nM30\n", s, sharp);
  const double slow = 40.0 / 500, slow_mm = (50.0 * 50 - 10 * 10) / 1000;
  EXPECT_NEAR(sharp.sum(), 2 * (0.1 + slow + (100 - 2.5 - slow_mm) / 50), 1e-9);
  run("G1 X100 F3000\nG91 X100 Y99\nM30\n", s, flat);  // 44.7 degrees
  ASSERT_EQ(flat.motions.size(), 2u);
  EXPECT_NEAR(flat.motions[0].time_s, 0.1 + 97.5 / 50, 1e-9);
}

TEST(TimeStage, ArcsKeepTheAccelerationAcross) {
  // nct-7.2-normal: v <= sqrt(a r), the smaller a of the two axes; the third does not count.
  ControlSettings s = machine(0);
  s.parameters = {{"N0402.1", 400}, {"N0402.2", 160}, {"N0402.3", 1}};
  Recorder out;
  run("G17 G2 X20 I10 F6000\nM30\n", s, out);
  ASSERT_EQ(out.motions.size(), 1u);
  EXPECT_NEAR(out.motions[0].feed, 60 * std::sqrt(160.0 * 10), 1e-9);
  EXPECT_NEAR(out.sum(), kPi * 10 / 40, 1e-9);
  s.parameters["N0310"] = 3000;  // never slower than this
  Recorder least;
  run("G17 G2 X20 I10 F6000\nM30\n", s, least);
  EXPECT_NEAR(least.motions[0].feed, 3000, 1e-9);
}

TEST(TimeStage, AnArcBehindALineLimitsTheJumpOfAcceleration) {
  // nct-7.3-jump: the manual's example, F6000 and r = 10 are 1000 mm/s^2; 250 allow 3000 mm/min.
  ControlSettings s = machine(1000);
  s.parameters = {{"N0404", 250}, {"N0309", 1e6}};
  Recorder out;
  run("G17 G1 X1000 F6000\nG3 X1010 Y10 J10\nM30\n", s, out);
  // 0 to 100 mm/s, on, down to 50 mm/s where the arc begins.
  const double up = 0.1, up_mm = 5, down = 0.05, down_mm = (100.0 * 100 - 50 * 50) / 2000;
  EXPECT_NEAR(out.motions[0].time_s, up + down + (1000 - up_mm - down_mm) / 100, 1e-9);
}

TEST(TimeStage, ShortLinesHaveAnAccelerationAcross) {
  // nct-7.2-normal: a circle of r = 10 in lines of half a degree runs as its curvature allows each axis:
  // where the centre lies along an axis sqrt(a r) = 40 mm/s, in between faster.
  ControlSettings s = machine(500);
  s.parameters = {{"N0402", 160}, {"N0309", 1e6}};
  std::string text = "G1 X10 F6000\n";
  for (int k = 1; k <= 720; ++k) {
    const double a = k * kPi / 360;
    text += fmt::format("X{:.7f} Y{:.7f}\n", 10 * std::cos(a), 10 * std::sin(a));
  }
  Recorder out;
  run(text + "M30\n", s, out);
  double circle = 0.0, expected = 0.0;
  for (std::size_t k = 100; k < 620; ++k) {
    circle += out.motions[k].time_s;
    const double a = (static_cast<double>(k) - 0.5) * kPi / 360;
    expected += 10 * kPi / 360 / (40 / std::sqrt(std::max(std::abs(std::cos(a)), std::abs(std::sin(a)))));
  }
  EXPECT_NEAR(circle, expected, 0.01 * expected);
}

TEST(TimeStage, InsideCornersAreSlow) {
  // nct-6.3.5-G62 nct-3-G62: 3 mm before and 2 mm behind a corner of 90 degrees at half the feed: 5 mm more
  // at 10 mm/s.
  ControlSettings s = machine(0);
  s.radius_offsets[1] = {5.0, 0.0};
  s.parameters = {{"N1407", 3}, {"N1408", 2}, {"N1409", 100}, {"N1410", 0.5}};
  const auto extra = [&](const std::string& path) {
    Recorder plain, slow;
    run("G17 G41 D1 G1 F600 X10 Y0\n" + path + "G40 X0 Y-50\nM30\n", s, plain);
    run("G62 G17 G41 D1 G1 F600 X10 Y0\n" + path + "G64 G40 X0 Y-50\nM30\n", s, slow);
    return slow.sum() - plain.sum();
  };
  EXPECT_NEAR(extra("X100\nY100\n"), 0.5, 1e-9);                   // to the left: inside
  EXPECT_NEAR(extra("X100\nY-100\n"), 0.0, 1e-9);                  // to the right: outside
  EXPECT_NEAR(extra("X100\nX200 Y10\n"), 0.0, 1e-9);               // too flat
  EXPECT_NEAR(extra("X100\nY100\nX10\n"), 1.0, 1e-9);              // two of them
  EXPECT_NEAR(extra("X100\nY12\nX10\n"), 0.7, 1e-9);               // between them only 2 mm: slow once
  EXPECT_NEAR(extra("X93\nX94\nX94.5\nX100\nY100\n"), 0.5, 1e-9);  // the way before over several blocks
  s.radius_offsets[1] = {-5.0, 0.0};                               // a negative radius changes the side
  EXPECT_NEAR(extra("X100\nY-100\n"), 0.5, 1e-9);
}

TEST(TimeStage, TheHighestFeedOfAnAxis) {
  // nct-4.5-N0305
  ControlSettings s = machine(0);
  s.parameters = {{"N0305.2", 600}};
  Recorder out;
  run("G1 X30 Y40 F3000\nM30\n", s, out);
  EXPECT_NEAR(out.motions[0].feed, 600 / 0.8, 1e-9);
  EXPECT_NEAR(out.sum(), 60 * 40.0 / 600, 1e-9);
}

TEST(TimeStage, OneLineInManyBlocksTakesNoLonger) {
  // More blocks than the look-ahead holds.
  std::string text = "G91 G1 F3000\n";
  for (int k = 0; k < 5000; ++k) text += "X0.5\n";
  Recorder out;
  run(text + "M30\n", machine(500), out);
  EXPECT_EQ(out.motions.size(), 5000u);
  EXPECT_NEAR(out.sum(), trapezoid(2500, 50, 500), 1e-6);
}

TEST(TimeStage, BellShapedAcceleration) {
  // nct-7-acc: from stand to stand the rise adds its own time; many blocks share one rise.
  ControlSettings s = machine(500);
  s.bell_time_s = 0.04;
  Recorder one, many;
  run("G1 X100 F3000\nM30\n", s, one);
  EXPECT_NEAR(one.sum(), trapezoid(100, 50, 500) + 0.04, 1e-8);
  std::string text = "G91 G1 F3000\n";
  for (int k = 0; k < 3000; ++k) text += "X0.1\n";
  run(text + "M30\n", s, many);
  EXPECT_NEAR(many.sum(), trapezoid(300, 50, 500) + 0.04, 1e-6);
  EXPECT_NEAR(many.motions[1500].time_s, 0.1 / 50, 1e-9);
  // In the first 0.04 s the acceleration comes up evenly: the way is a t^3 / (6 T).
  double time = 0.0, way = 0.0;
  for (const Motion& m : many.motions) {
    time += m.time_s;
    way += 0.1;
    if (time > 0.04) break;
    EXPECT_NEAR(500 * time * time * time / (6 * 0.04), way, 1e-6);
  }
}

/// Time of a line between two speeds with an acceleration that comes up and goes in `rise`, long enough for
/// its speed: each change of speed takes the rise longer, and its mean speed is the middle one.
double sCurve(double length, double from, double speed, double to, double a, double rise) {
  const auto change = [&](double v) { return v == speed ? 0.0 : std::abs(speed - v) / a + rise; };
  const double up = change(from), down = change(to);
  const double ramps = up * (from + speed) / 2 + down * (speed + to) / 2;
  EXPECT_GE(length, ramps);
  return up + down + (length - ramps) / speed;
}

TEST(TimeStage, BellShapedAccelerationAtStandsInBetween) {
  // nct-7-acc: G61, G9, rapids, dwells and functions: from stand to stand the rise counts each time.
  ControlSettings s = machine(1000);
  s.bell_time_s = 0.1;
  const double one = sCurve(100, 0, 100, 0, 1000, 0.1);
  EXPECT_NEAR(one, 1.2, 1e-12);
  s.rapid_mm_min = Vec3::Constant(6000);
  for (const std::string text :
       {"G61 G1 F6000 X100\nX200\nX300\n", "G1 F6000 G9 X100\nG9 X200\nX300\n", "G0 X100\nX200\nX300\n",
        "G1 F6000 X100\nM8\nX200\nM9\nX300\n", "G0 X100\nG1 F6000 X200\nG0 X300\n", "G0 X100\nX0\nX100\n",
        "G61 G1 F6000 X100\nY100\nX0\n"}) {
    Recorder out;
    run(text + "M30\n", s, out);
    ASSERT_EQ(out.motions.size(), 3u) << text;
    for (const Motion& m : out.motions) EXPECT_NEAR(m.time_s, one, 1e-8) << text;
  }
  Recorder dwells;
  EXPECT_NEAR(run("G1 F6000 X100\nG4 P0.5\nX200\nM30\n", s, dwells).cycle_s, 2 * one + 0.5, 1e-8);
  // More blocks than the look-ahead holds, a stop behind every second one.
  std::string text = "G91 G1 F6000\n";
  for (int k = 0; k < 1500; ++k) text += "X50\nG9 X50\n";
  Recorder many;
  run(text + "M30\n", s, many);
  EXPECT_NEAR(many.sum(), 1500 * one, 1e-5);
}

TEST(TimeStage, BellShapedAccelerationAtCornersAndSlowBlocks) {
  // nct-7-acc, nct-7.1-corner: a corner is passed at its speed, without acceleration; so are the ends of a
  // slow block. 1200 mm/min: 20 mm/s of change are 10 mm/s where X turns round, 20 mm/s into Y.
  ControlSettings s = machine(1000);
  s.bell_time_s = 0.1;
  s.parameters = {{"N0309", 1200}};
  const auto time = [&](const std::string& text) {
    Recorder out;
    run(text + "M30\n", s, out);
    return out.sum();
  };
  EXPECT_NEAR(time("G1 F6000 X100\nX0\n"), 2 * sCurve(100, 0, 100, 10, 1000, 0.1), 1e-7);
  EXPECT_NEAR(time("G1 F6000 X100\nY100\nX0\n"),
              2 * sCurve(100, 0, 100, 20, 1000, 0.1) + sCurve(100, 20, 100, 20, 1000, 0.1), 1e-7);
  EXPECT_NEAR(time("G1 F6000 X100\nX150 F1200\nX250 F6000\n"),
              2 * sCurve(100, 0, 100, 20, 1000, 0.1) + 50.0 / 20, 1e-7);
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    // Lines of 60 mm and more along X and Y, some back, some with a stop.
    std::string text = "G91 G1 F6000\n";
    double expected = 0.0, entry = 0.0;
    std::vector<std::array<double, 2>> ways;
    std::vector<bool> stops;
    for (int k = 0; k < 12; ++k) {
      std::array<double, 2> way{0, 0};
      way[random() % 2] = (random() % 2 == 0 ? 1.0 : -1.0) * (60.0 + static_cast<double>(random() % 40));
      ways.push_back(way);
      stops.push_back(random() % 4 == 0 || k == 11);
      text += fmt::format("{}X{} Y{}\n", stops.back() ? "G9 " : "", way[0], way[1]);
    }
    for (std::size_t k = 0; k < ways.size(); ++k) {
      double exit = 0.0;
      if (!stops[k]) {
        const bool along_x = ways[k][0] != 0.0, next_x = ways[k + 1][0] != 0.0;
        const double here = along_x ? ways[k][0] : ways[k][1],
                     next = next_x ? ways[k + 1][0] : ways[k + 1][1];
        exit = along_x != next_x ? 20.0 : here * next < 0.0 ? 10.0 : 100.0;
      }
      expected += sCurve(std::abs(ways[k][0] + ways[k][1]), entry, 100, exit, 1000, 0.1);
      entry = exit;
    }
    EXPECT_NEAR(time(text), expected, 1e-6) << text;
  }
}

TEST(TimeStage, SpindlesTakeTheirTime) {
  // 1000 rpm at 500 rpm a second are 2 s, the reversal 4 s, the stop 2 s; half a turn at 60 rpm 0.5 s.
  ControlSettings s = machine(0);
  SpindleSettings spindle;
  spindle.acceleration = 500;
  spindle.position_name = "CS1";
  s.spindles = {spindle};
  Recorder out;
  EXPECT_NEAR(run("S1000 M3\nM4\nM5\nM30\n", s, out).cycle_s, 8.0, 1e-9);
  EXPECT_NEAR(run("M19\nCS1=180\nM30\n", s, out).cycle_s, 0.5, 1e-9);
}

TEST(TimeStage, EverythingComesInProgramOrder) {
  ControlSettings s = machine(500);
  s.max_errors = 3;
  s.limits[0] = AxisLimit{-10, 15};
  Recorder out;
  // A motion; an overtravel and its motion; an error; a warning and a dwell; back from beyond the limit; a
  // function; the end.
  run("G1 X10 F3000\nX20\nY5 Q7\nG4\nX0\nM8\nM30\n", s, out);
  EXPECT_EQ(out.order, "mem!?eeme.");
}

TEST(TimeStage, AnAlarmLeavesNothingBehind) {
  Recorder out;
  run("G1 X10 F3000\nX20\nX30 G999\n", machine(500), out);
  EXPECT_EQ(out.order, "mm!");
  EXPECT_NEAR(out.sum(), trapezoid(20, 50, 500), 1e-9);
}

}  // namespace
}  // namespace proveout::nc
