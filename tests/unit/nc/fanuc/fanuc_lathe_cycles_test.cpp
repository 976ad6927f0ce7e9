// Cycles of lathes: single cycles, pecks, threads, drilling (section 16).
#include <gtest/gtest.h>

#include "core/nc/fanuc/lathe/thread_depths.h"
#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

// fan-16-G90: acceptance rows 40 and 41
TEST(FanucLatheCycles, TurningCycle) {
  EXPECT_EQ(turned("G90 X40. Z-30. F.2\nX36.\nM30\n", latheAt(50, 2)),
            (Lines{"R 40 2", "F 40 -30", "F 50 -30", "R 50 2", "R 36 2", "F 36 -30", "F 50 -30", "R 50 2"}));
  EXPECT_EQ(turned("G90 X30. Z-40. R-5. F.2\nM30\n", latheAt(50, 2)),
            (Lines{"R 20 2", "F 30 -40", "F 50 -40", "R 50 2"}));
  EXPECT_EQ(turned("G90 X40. Z-30. R-2.5 F.2\nM30\n", latheAt(50, 2)).front(), "R 35 2");
  EXPECT_EQ(turned("G90 X40. Z-30. I-2.5 F.2\nM30\n", latheAt(50, 2)).front(), "R 35 2");
  EXPECT_EQ(turned("G90 U-10. W-32. F.2\nU-14.\nG0 X60.\nM30\n", latheAt(50, 2)),
            (Lines{"R 40 2", "F 40 -30", "F 50 -30", "R 50 2", "R 36 2", "F 36 -30", "F 50 -30", "R 50 2",
                   "R 60 2"}));
}

// fan-16-G94
TEST(FanucLatheCycles, FacingCycle) {
  EXPECT_EQ(turned("G94 X20. Z-5. F.2\nM30\n", latheAt(50, 2)),
            (Lines{"R 50 -5", "F 20 -5", "F 20 2", "R 50 2"}));
  EXPECT_EQ(turned("G94 X20. Z-5. R-2. F.2\nM30\n", latheAt(50, 2)).front(), "R 50 -7");
}

// fan-16-G92
TEST(FanucLatheCycles, ThreadingCycle) {
  const IsoRun run = lathe("G97 S500 M3\nG92 X19.2 Z-20. F1.5\nX18.6\nM30\n", latheAt(24, 5));
  EXPECT_EQ(turned(run), (Lines{"R 19.2 5", "T 19.2 -18.5", "T 22.2 -20", "R 24 -20", "R 24 5", "R 18.6 5",
                                "T 18.6 -18.5", "T 21.6 -20", "R 24 -20", "R 24 5"}));
  EXPECT_NEAR(run.path.motions[1].feed, 750.0, 1e-9);
  EXPECT_EQ(run.path.motions[1].thread_start_deg, 0.0F);
  // 23.5 / 1.5 turns of the straight part: the run-out goes on from there.
  EXPECT_NEAR(run.path.motions[2].thread_start_deg, 360.0 * (23.5 / 1.5 - 15.0), 1e-3);
  EXPECT_EQ(turned("G97 S500 M3\nG92 X18. Z-20. R-1.25 F2.\nM30\n", latheAt(24, 5, {{"thread_chamfer", 0}})),
            (Lines{"R 15.5 5", "T 18 -20", "R 24 -20", "R 24 5"}));
}

// fan-16-G32
TEST(FanucLatheCycles, ThreadsChain) {
  const IsoRun run = lathe(
      "G97 S600 M3\nG0 X20. Z3.\nG32 Z-10.25 F2. Q90000\nX24. Z-20.\nG0 X30.\nG32 X20. Z-21. F1.\nM30\n",
      latheAt(30, 3));
  EXPECT_EQ(turned(run), (Lines{"R 20 3", "T 20 -10.25", "T 24 -20", "R 30 -20", "T 20 -21"}));
  const auto& m = run.path.motions;
  EXPECT_NEAR(m[1].feed, 1200.0, 1e-9);
  EXPECT_NEAR(m[1].thread_start_deg, 90.0, 1e-4);
  EXPECT_NEAR(m[2].thread_start_deg, std::fmod(90.0 + 360.0 * 13.25 / 2.0, 360.0), 1e-3);
  // Steeper than 45 degrees: the lead counts along X, 5 mm of radius.
  EXPECT_NEAR(m[4].feed, 600.0 * std::hypot(5.0, 1.0) / 5.0, 1e-9);
  EXPECT_EQ(m[4].thread_start_deg, 0.0F);
}

// fan-16-G34
TEST(FanucLatheCycles, ThreadsOfVaryingLead) {
  // F 2, K 0.1: 10 turns go 2 * 10 + 0.1 * 100 / 2 = 25.
  const IsoRun run = lathe("G97 S600 M3\nG0 X20. Z5.\nG34 Z-20. F2. K.1\nM30\n", latheAt(20, 5));
  EXPECT_EQ(turned(run), (Lines{"T 20 -20"}));
  EXPECT_NEAR(run.path.motions.back().feed, 25.0 / 10.0 * 600.0, 1e-4);
  EXPECT_FLOAT_EQ(run.path.motions.back().thread_pitch_change, 0.1F);
  EXPECT_EQ(lathe("G97 S600 M3\nG0 X20. Z5.\nG34 Z-200. F1. K-.1\nM30\n", latheAt(20, 5)).error(),
            "fanuc-thread");
}

// fan-16-G74: acceptance row 45
TEST(FanucLatheCycles, FacePecks) {
  EXPECT_EQ(turned("G74 R1.\nG74 Z-20. Q8000 F.1\nM30\n", latheAt(0, 2)),
            (Lines{"F 0 -6", "R 0 -5", "F 0 -14", "R 0 -13", "F 0 -20", "R 0 2"}));
  Lines columns;
  for (const char* x : {"40", "35", "30", "25", "20"}) {
    const std::string d(x);
    if (d != "40") columns.push_back("R " + d + " 2");
    for (const char* move : {"F {} -3", "R {} -2", "F {} -8", "R {} -7", "F {} -10", "R {} 2"})
      columns.push_back(fmt::format(fmt::runtime(move), d));
  }
  columns.push_back("R 40 2");
  EXPECT_EQ(turned("G74 R1.\nG74 X20. Z-10. P2500 Q5000 F.1\nM30\n", latheAt(40, 2)), columns);
}

// fan-16-G75
TEST(FanucLatheCycles, Grooves) {
  Lines expected;
  for (const char* z : {"-10", "-14", "-18", "-20"}) {
    const std::string at_z(z);
    if (at_z != "-10") expected.push_back("R 41 " + at_z);
    for (const char* move : {"F 35 {}", "R 36 {}", "F 30 {}", "R 41 {}"})
      expected.push_back(fmt::format(fmt::runtime(move), at_z));
  }
  expected.push_back("R 41 -10");
  EXPECT_EQ(turned("G75 R.5\nG75 X30. Z-20. P3000 Q4000 F.1\nM30\n", latheAt(41, -10)), expected);
  EXPECT_EQ(turned("G75 R.5\nG75 X30. P3. F.1\nM30\n", latheAt(41, -10)),
            (Lines{"F 35 -10", "R 36 -10", "F 30 -10", "R 41 -10"}));
}

// haas-18-latheG74
TEST(HaasLathe, PecksInOneLine) {
  EXPECT_EQ(turned("G74 Z-20. K8. F.1\nM30\n", latheAt(0, 2, {{"flavour", 1}, {"g74_return", 1}})),
            (Lines{"F 0 -6", "R 0 -5", "F 0 -14", "R 0 -13", "F 0 -20", "R 0 2"}));
  EXPECT_EQ(turned("G75 X30. I3. F.1\nM30\n", latheAt(41, -10, {{"flavour", 1}})),
            (Lines{"F 35 -10", "R 36 -10", "F 30 -10", "R 41 -10"}));
}

/// Diameters of the threads of a run, in order.
std::vector<double> threads(const IsoRun& run) {
  EXPECT_EQ(run.error(), "") << run.message();
  std::vector<double> all;
  for (const Motion& m : run.path.motions)
    if (m.kind == MotionKind::kThread) all.push_back(2.0 * m.to.x());
  return all;
}

// fan-16-G76: acceptance row 43
TEST(FanucLatheCycles, ThreadInPasses) {
  const IsoRun run =
      lathe("G97 S500 M3\nG76 P010060 Q100 R0.05\nG76 X16.932 Z-25. P1534 Q500 F2.5\nM30\n", latheAt(24, 5));
  const std::vector<double> x = threads(run);
  const std::vector<double> expected{19.0,    18.5858, 18.2679, 18.0,   17.7639,
                                     17.5505, 17.3505, 17.1505, 17.032, 16.932};
  ASSERT_EQ(x.size(), expected.size());
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], expected[k], 1e-4) << k;
  // One-sided infeed: the first pass starts 0.5 tan 30 nearer to the end than the tool stands.
  EXPECT_NEAR(run.path.motions.front().to.z(), 5.0 - 0.5 * std::tan(M_PI / 6.0), 1e-6);
  EXPECT_EQ(turned(run).back(), "R 24 5");
}

TEST(FanucLatheCycles, ThreadInsideWithRunOut) {
  const IsoRun run =
      lathe("G97 S500 M3\nG76 P021060 Q100 R0.05\nG76 X20. Z-15. R-.5 P1000 Q400 F2.\nM30\n", latheAt(16, 4));
  EXPECT_EQ(run.error(), "") << run.message();
  std::vector<double> x;
  for (const Motion& m : run.path.motions)
    if (m.kind == MotionKind::kThread && m.to.z() > -14.9) x.push_back(2.0 * m.to.x());
  // Depths 0.4, 0.5657, 0.6928, 0.8, 0.9 (least 0.1), 0.95, 1, 1; the run-out takes the last 2 mm of 19.
  ASSERT_GE(x.size(), 8U);
  const double rise = 2.0 * 0.5 * 2.0 / (19.0 + 0.4 * std::tan(M_PI / 6.0));
  EXPECT_NEAR(x.front(), 20.0 - 2.0 * 0.6 - 2.0 * 0.5 * 0.0 - rise, 0.01);
  EXPECT_EQ(lathe("G76 P010060 Q100 R.05\nG76 X20. Z-15. P0 Q400 F2.\nM30\n", latheAt(16, 4)).error(),
            "fanuc-062");
}

// haas-18-latheG76: acceptance row 55
TEST(HaasLathe, ThreadInOneLine) {
  const IsoRun run =
      lathe("G97 S500 M3\nM24\nG76 X16.932 Z-25. K1.534 D.485 F2.5\nM30\n", latheAt(24, 5, {{"flavour", 1}}));
  const std::vector<double> x = threads(run);
  const std::vector<double> depths{0.485,  0.6859, 0.84,  0.97,   1.0845, 1.188,
                                   1.2832, 1.3718, 1.455, 1.5337, 1.534};
  ASSERT_EQ(x.size(), depths.size());
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], 16.932 + 2.0 * (1.534 - depths[k]), 2e-4) << k;
  // M23: one lead of run-out at 45 degrees.
  const IsoRun out =
      lathe("G97 S500 M3\nM23\nG76 X16.932 Z-25. K1.534 D.485 F2.5\nM30\n", latheAt(24, 5, {{"flavour", 1}}));
  EXPECT_EQ(threads(out).size(), 2 * depths.size());
}

// fan-16-G76one
TEST(FanucLatheCycles, ThreadInOneLine) {
  const IsoRun run = lathe("G97 S500 M3\nG76 X16.932 Z-25. K1.534 D500 F2.5 A60 P1\nM30\n",
                           latheAt(24, 5, {{"g76_min", 0.1}, {"thread_chamfer", 0}}));
  EXPECT_EQ(threads(run).size(), 10U);
  EXPECT_NEAR(threads(run).front(), 19.0, 1e-9);
}

/// Depths of G76 over random data: they rise, no pass but the last ones takes less than the least, equal
/// sections while the formula rules, the last is the height.
TEST(FanucLatheCycles, ThreadDepthsByTheFormula) {
  std::uint32_t seed = 1;
  const auto random = [&](double low, double high) {
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * (seed >> 8) / double(1u << 24);
  };
  for (int round = 0; round < 300; ++round) {
    nc::ThreadInfeed infeed;
    infeed.height = random(0.3, 4.0);
    infeed.first = random(0.05, 1.2 * infeed.height);
    infeed.least = random(0.0, 0.1);
    infeed.finish = random(0.0, 0.2);
    infeed.repeats = static_cast<int>(random(0.0, 3.99));
    const std::vector<double> d = nc::threadDepths(infeed);
    ASSERT_FALSE(d.empty());
    EXPECT_EQ(d.back(),
              infeed.repeats > 0 || infeed.finish > 1e-9 ? infeed.height : infeed.height - infeed.finish);
    double before = 0.0;
    for (std::size_t n = 0; n < d.size(); ++n) {
      EXPECT_GE(d[n], before);
      const bool last = d[n] > infeed.height - infeed.finish - 1e-9;
      if (!last) {
        const double formula = infeed.first * std::sqrt(static_cast<double>(n + 1));
        const bool small = n > 0 && formula - before < infeed.least;
        EXPECT_NEAR(d[n], small ? before + infeed.least : formula, 1e-12);
      }
      before = d[n];
    }
  }
}

// fan-16-G83 fan-16-G85
TEST(FanucLatheCycles, FaceDrilling) {
  EXPECT_EQ(turned("G0 X0 Z5.\nG83 Z-20. R-3. Q8. F.1\nG80\nM30\n", latheAt(0, 5)),
            (Lines{"R 0 2", "F 0 -6", "R 0 -5.5", "F 0 -14", "R 0 -13.5", "F 0 -20", "R 0 5"}));
  EXPECT_EQ(
      turned("G0 X0 Z5.\nG83 Z-20. R-3. Q8. F.1\nG80\nM30\n", latheAt(0, 5, {{"lathe_peck", 1}})),
      (Lines{"R 0 2", "F 0 -6", "R 0 2", "R 0 -5.5", "F 0 -14", "R 0 2", "R 0 -13.5", "F 0 -20", "R 0 5"}));
  EXPECT_EQ(turned("G85 Z-20. R-3. F.1\nG80\nG1 Z4.\nM30\n", latheAt(0, 5)),
            (Lines{"R 0 2", "F 0 -20", "F 0 2", "R 0 5", "F 0 4"}));
  EXPECT_EQ(turned("G83 Z-20. F.1\nG80\nM30\n", latheAt(0, 5)), (Lines{"F 0 -20", "R 0 5"}));
  // A peck without a point is one of thousandths where it can be no depth.
  for (const double decimal : {0.0, 1.0})
    EXPECT_EQ(
        turned("G0 X0 Z5.\nG83 Z-20. R-3. Q8000 F.1\nG80\nM30\n", latheAt(0, 5, {{"decimal", decimal}})),
        turned("G0 X0 Z5.\nG83 Z-20. R-3. Q8. F.1\nG80\nM30\n", latheAt(0, 5)))
        << decimal;
}

// fan-16-G84
TEST(FanucLatheCycles, FaceTapping) {
  const IsoRun run = lathe("G97 S300 M3\nG84 Z-20. R-3. F1.5\nG80\nM30\n", latheAt(0, 5));
  EXPECT_EQ(turned(run), (Lines{"R 0 2", "T 0 -20", "T 0 2", "R 0 5"}));
}

// fan-16-G87 fan-16-G88 fan-16-G89
TEST(FanucLatheCycles, SideDrilling) {
  EXPECT_EQ(turned("G87 Z-10. X20. R-5. Q4. F.1\nZ-20.\nG80\nM30\n", latheAt(60, 5)),
            (Lines{"R 60 -10", "R 50 -10", "F 42 -10", "R 43 -10", "F 34 -10", "R 35 -10", "F 26 -10",
                   "R 27 -10", "F 20 -10", "R 60 -10", "R 60 -20", "R 50 -20", "F 42 -20", "R 43 -20",
                   "F 34 -20", "R 35 -20", "F 26 -20", "R 27 -20", "F 20 -20", "R 60 -20"}));
  EXPECT_EQ(turned("G97 S300 M3\nG88 X20. R-5. F1.\nG80\nM30\n", latheAt(60, 5)),
            (Lines{"R 50 5", "T 20 5", "T 50 5", "R 60 5"}));
  EXPECT_EQ(turned("G89 X20. R-5. P500 F.1\nG80\nM30\n", latheAt(60, 5)),
            (Lines{"R 50 5", "F 20 5", "F 50 5", "R 60 5"}));
}

}  // namespace
}  // namespace proveout::test
