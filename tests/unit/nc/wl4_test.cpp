// The WL4 control where a golden file does not reach: texts of the shipped programs, encodings, limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/nc/registry/interpreter.h"
#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_programs.h"

namespace proveout {
namespace {

using testing::HasSubstr;

struct Trace : MotionSink {
  std::vector<Motion> motions;
  std::vector<Diagnostic> diagnostics;
  InterpretSummary summary;

  Trace(ControlId control, const std::string& text, const ControlSettings& settings = {},
        const std::vector<std::pair<std::string, std::string>>& programs = {}) {
    MemoryProgramSource source("main.nc", text);
    for (const auto& [name, bytes] : programs) source.add(name, bytes);
    ControlSettings from_zero = settings;
    from_zero.start = Vec3::Zero();
    summary = interpret(control, source, from_zero, *this);
  }
  void file(std::uint32_t, const std::string&) override {}
  void motion(const Motion& m, const ArcGeometry*, const AxisSweep*) override { motions.push_back(m); }
  void event(const PathEvent&) override {}
  void diagnostic(const Diagnostic& d) override { diagnostics.push_back(d); }
};

std::string ownProgram(const char* name) { return std::string(nc::wl4OwnProgram(name)); }

/// A call that makes the program %1 report an error, its label, and the text of the manual.
struct OwnError {
  const char* call;
  const char* label;
  const char* text;
};

class Wl4OwnErrors : public testing::TestWithParam<OwnError> {};

TEST_P(Wl4OwnErrors, ComeWithTheTextOfTheProgram) {
  const Trace run(ControlId::kWl4Lathe,
                  std::string("%E\nG54 G95 S500 M3\nG0 X60 Z2\n") + GetParam().call + " F0.2\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 1);
  EXPECT_EQ(run.summary.end, ProgramEnd::kAlarm);
  const Diagnostic& d = run.diagnostics.back();
  EXPECT_EQ(d.code, std::string("wl4-err-") + GetParam().label);
  EXPECT_EQ(d.message, GetParam().text);
  EXPECT_EQ(d.where.file, "%1");
  ASSERT_FALSE(d.notes.empty());
  EXPECT_EQ(d.notes.front(), "called from main.nc:4");
}

// Coverage of wl4-11-open, wl4-11-G79: all errors that the program %1 knows (digest wl4, 11).
INSTANTIATE_TEST_SUITE_P(
    Program1, Wl4OwnErrors,
    testing::Values(
        OwnError{"G79", "N10", "ERROR -> UNKNOWN CYCLE IN RANGE G70-G79"},
        OwnError{"G31 X50 Z-30 #1=-1", "N3191", "ERROR IN G31 -> PARAMETER #1 < 0"},
        OwnError{"G31 X50 Z-30 #1=1 #2=-1", "N3192", "ERROR IN G31 -> PARAMETER #2 < 0"},
        OwnError{"G31 X50 Z-30 #1=1 #2=1 #3=-1", "N3193", "ERROR IN G31 -> PARAMETER #3 < 0"},
        OwnError{"G31 X50 Z-30 #1=1 #2=1 #4=-1", "N3194", "ERROR IN G31 -> PARAMETER #4 < 0"},
        OwnError{"G31 X50 Z-30 #1=1 #2=1 #5=-1", "N3195", "ERROR IN G31 -> PARAMETER #5 < 0"},
        OwnError{"G31 X50 Z-30 #1=1 #2=1 #4=81", "N3196", "ERROR IN G31 -> PARAMETER #4 > 80"},
        OwnError{"G70 X30 Z-40 #1=10 #2=31", "N7010", "ERROR IN G70 -> PARAMETER #2 > Xrel"},
        OwnError{"G70 X30 Z-40 #1=43 #2=8", "N7015", "ERROR IN G70 -> PARAMETER #1 > Zrel"},
        OwnError{"G70 X30 Z-40 #1=-1 #2=8", "N7020", "ERROR IN G70 -> PARAMETER #1 < 0"},
        OwnError{"G70 X30 Z-40 #1=1 #2=-8", "N7025", "ERROR IN G70 -> PARAMETER #2 < 0"},
        OwnError{"G71 X30 Z-10 #1=8 #2=13", "N7110", "ERROR IN G71 -> PARAMETER #2 > Zrel"},
        OwnError{"G71 X30 Z-10 #1=31 #2=4", "N7115", "ERROR IN G71 -> PARAMETER #1 > Xrel"},
        OwnError{"G71 X30 Z-10 #1=-8 #2=4", "N7120", "ERROR IN G71 -> PARAMETER #1 < 0"},
        OwnError{"G71 X30 Z-10 #1=8 #2=-4", "N7125", "ERROR IN G71 -> PARAMETER #2 < 0"},
        OwnError{"G72 X34 W6 #1=27 #2=1", "N7210", "ERROR IN G72 -> PARAMETER #1 > Xrel"},
        OwnError{"G72 X34 W6 #1=6 #2=7", "N7215", "ERROR IN G72 -> PARAMETER #1 > #2"},
        OwnError{"G72 X34 W6 #1=0 #2=-1", "N7220", "ERROR IN G72 -> PARAMETER #1 <= 0"},
        OwnError{"G72 X34 W6 #1=6 #2=-1", "N7225", "ERROR IN G72 -> PARAMETER #2 < 0"},
        OwnError{"G73 U4 Z-23 #1=26 #2=1", "N7310", "ERROR IN G73 -> PARAMETER #1 > Zrel"},
        OwnError{"G73 U4 Z-23 #1=6 #2=7", "N7315", "ERROR IN G73 -> PARAMETER #1 > #2"},
        OwnError{"G73 U4 Z-23 #1=0 #2=-1", "N7320", "ERROR IN G73 -> PARAMETER #1 <= 0"},
        OwnError{"G73 U4 Z-23 #1=6 #2=-1", "N7325", "ERROR IN G73 -> PARAMETER #2 < 0"},
        OwnError{"G74 X40 Z-5 #1=21", "N7410", "ERROR IN G74 -> PARAMETER #1 > Xrel"},
        OwnError{"G74 X40 Z-5 #1=0", "N7415", "ERROR IN G74 -> PARAMETER #1 <= 0"},
        OwnError{"G75 X40 Z-20 #1=23", "N7510", "ERROR IN G75 -> PARAMETER #1 > Zrel"},
        OwnError{"G75 X40 Z-20 #1=0", "N7515", "ERROR IN G75 -> PARAMETER #1 <= 0"},
        OwnError{"G77 X40 Z-50 #1=30 #2=5 #3=0.1", "N7710", "ERROR IN G77 -> PARAMETER #1 > Xrel"},
        OwnError{"G77 X40 Z-50 #1=8 #2=53 #3=0.1", "N7715", "ERROR IN G77 -> PARAMETER #2 > Zrel"},
        OwnError{"G77 X40 Z-50 #1=0 #2=5 #3=0.1", "N7720", "ERROR IN G77 -> PARAMETER #1 <= 0"},
        OwnError{"G77 X40 Z-50 #1=8 #2=-5 #3=0.1", "N7725", "ERROR IN G77 -> PARAMETER #2 < 0"},
        OwnError{"G78 X40 Z-50 #1=53 #2=5 #3=0.1", "N7810", "ERROR IN G78 -> PARAMETER #1 > Xrel"},
        OwnError{"G78 X40 Z-50 #1=8 #2=23 #3=0.1", "N7815", "ERROR IN G78 -> PARAMETER #2 > Zrel"},
        OwnError{"G78 X40 Z-50 #1=0 #2=5 #3=0.1", "N7820", "ERROR IN G78 -> PARAMETER #1 <= 0"},
        OwnError{"G78 X40 Z-50 #1=8 #2=-5 #3=0.1", "N7825", "ERROR IN G78 -> PARAMETER #2 < 0"}),
    [](const auto& test) { return std::string(test.param.label); });

TEST(Wl4Programs, AJobReplacesTheControlsOwn) {
  const std::string main = "%M\nG54 G0 Z50\nG81 #2=1 #3=-5 F100\nX10\nG80\nM30\n%\n";
  const Trace own(ControlId::kWl4Mill, main),
      replaced(ControlId::kWl4Mill, main, {}, {{"81.nc", "%81\nG0G90Z#3\nM99\n%\n"}});
  EXPECT_EQ(own.motions.size(), 5u);
  ASSERT_EQ(replaced.motions.size(), 3u);
  EXPECT_DOUBLE_EQ(replaced.motions.back().to.z(), -5.0);
}

TEST(Wl4Programs, LinesOfTheShippedTextsFitTheControl) {
  for (const char* name : {"1", "81", "82", "83", "84", "85", "86", "87", "88", "89"}) {
    const std::string text = ownProgram(name);
    EXPECT_EQ(text.rfind(std::string("%") + name + "\n", 0), 0u);
    EXPECT_EQ(text.substr(text.size() - 2), "%\n");
  }
  EXPECT_TRUE(ownProgram("80").empty());
}

// wl4-4.1-charset: comments in KOI8-R, CP1251 and UTF-8.
TEST(Wl4Programs, CommentsOfAllCodePagesAreRead) {
  const std::string koi8 =
      "%K\nG0 X1 $ \xF0\xCF\xDA\xC9\xC3\xC9\xCF\xCE\xC9\xD2\xCF\xD7\xC1\xCE\xC9\xC5\nM30\n%\n";
  const std::string cp1251 =
      "%K\nG0 X1 $ \xCF\xEE\xE7\xE8\xF6\xE8\xEE\xED\xE8\xF0\xEE\xE2\xE0\xED\xE8\xE5\nX#\nM30\n%\n";
  EXPECT_EQ(Trace(ControlId::kWl4Mill, koi8).summary.errors, 0);
  EXPECT_EQ(Trace(ControlId::kWl4Mill, cp1251).summary.errors, 1);
  const Trace bad(ControlId::kWl4Mill, std::string("%K\nG0 X1\0\n", 9));
  EXPECT_EQ(bad.summary.errors, 1);
}

// wl4-1-limits: coordinates, feeds and offsets beyond the control's ranges are refused or held back.
TEST(Wl4Limits, AreThoseOfTheControl) {
  for (const char* block :
       {"X10000", "Y10000", "F100000", "S70000", "T128", "D128", "H128", "X1e5", "I10000"}) {
    const Trace run(ControlId::kWl4Mill, std::string("%L\n") + block + "\nM30\n%\n");
    EXPECT_EQ(run.summary.errors, 1) << block;
  }
  ControlSettings settings;
  settings.parameters["MAX_FEED"] = 1000;
  const Trace fast(ControlId::kWl4Mill, "%L\nG1 X10 F5000\nM30\n%\n", settings);
  ASSERT_EQ(fast.motions.size(), 1u);
  EXPECT_DOUBLE_EQ(fast.motions[0].feed, 1000.0);
  EXPECT_EQ(fast.summary.warnings, 1);
}

// wl4-4.3-len: a block of more than 80 characters is told and runs.
TEST(Wl4Limits, LongBlocksAreTold) {
  const Trace run(ControlId::kWl4Mill, "%L\nG0 X1 $ " + std::string(90, 'x') + "\nM30\n%\n");
  EXPECT_EQ(run.summary.errors, 0);
  ASSERT_EQ(run.summary.warnings, 1);
  EXPECT_EQ(run.diagnostics[0].code, "wl4-long-block");
  EXPECT_EQ(run.motions.size(), 1u);
}

TEST(Wl4Limits, ParametersAreChecked) {
  ControlSettings settings;
  settings.parameters["RT.200"] = 1;
  EXPECT_EQ(Trace(ControlId::kWl4Lathe, "%P\nM30\n%\n", settings).summary.errors, 1);
  settings.parameters = {{"RT.3", 0.8}};
  EXPECT_EQ(Trace(ControlId::kWl4Lathe, "%P\nM30\n%\n", settings).summary.errors, 0);
  EXPECT_EQ(Trace(ControlId::kWl4Mill, "%P\nM30\n%\n", settings).summary.errors, 1);
}

// wl4-4.2-ABC: rotary axes move with the others; B is one where the job has it.
TEST(Wl4Axes, RotaryAxesMoveWhereTheJobHasThem) {
  ControlSettings settings;
  AxisSettings b;
  b.name = "B";
  b.number = 5;
  b.carries = RotaryCarries::kNothing;
  settings.axes.push_back(b);
  const Trace run(ControlId::kWl4Mill, "%A\nG54 G0 X10 B90\nG91 B10\nM30\n%\n", settings);
  EXPECT_EQ(run.summary.errors, 0);
  EXPECT_EQ(run.motions.size(), 2u);
  const Trace none(ControlId::kWl4Mill, "%A\nG54 G0 X10 A90\nM30\n%\n");
  ASSERT_EQ(none.summary.errors, 1);
  EXPECT_THAT(none.diagnostics[0].message, HasSubstr("no axis A"));
}

/// Digest wl4, 9.4, worked example 3: an internal thread with taper and angle in eight passes; nine would
/// show that values were compared exactly.
TEST(Wl4Cycles, InternalThreadHasEightPasses) {
  const Trace run(ControlId::kWl4Lathe,
                  "%T\nG54 S500 M3\nG0 X30 Z3\nG31 X40 Z-20 F1.5 #1=0.9 #2=0.3 #3=2 #4=25 #5=1\nM30\n%\n");
  ASSERT_EQ(run.summary.errors, 0);
  std::vector<Motion> threads;
  for (const Motion& m : run.motions) {
    if (m.kind == MotionKind::kThread) threads.push_back(m);
  }
  ASSERT_EQ(threads.size(), 16u);
  const auto near = [](const Vec3& p, double diameter, double z) {
    return std::abs(2.0 * p.x() - diameter) < 1e-4 && std::abs(p.z() - z) < 1e-4;
  };
  EXPECT_TRUE(near(threads[0].from, 39.8013, 0.7148));
  EXPECT_TRUE(near(threads[0].to, 38.0870, -19.0));
  EXPECT_TRUE(near(threads[1].to, 36.0870, -20.0));
  EXPECT_TRUE(near(threads[14].from, 41.5655, 0.3035));
  EXPECT_TRUE(near(threads[14].to, 39.8870, -19.0));
  EXPECT_TRUE(near(threads[15].to, 37.8870, -20.0));
}

std::vector<Motion> threadsOf(const std::string& text, const ControlSettings& settings = {}) {
  const Trace run(ControlId::kWl4Lathe, text, settings);
  EXPECT_EQ(run.summary.errors, 0);
  std::vector<Motion> threads;
  for (const Motion& m : run.motions) {
    if (m.kind == MotionKind::kThread) threads.push_back(m);
  }
  return threads;
}

/// Turns from the motion alone.
double turnsOf(const Motion& m) { return threadTurns(Toolpath(), m); }

// Digest wl4, 4.5: P is the phase at the start, F the pitch along the longer axis.
TEST(Wl4Threads, TwoStartsAndTheirRunOuts) {
  const std::string start = "G0 X40 Z5\nG32 ";
  const std::vector<Motion> threads =
      threadsOf("%T\nG54 G97 S400 M3\n" + start + "Z-20.3 F1.5\nG9 X44 Z-21.3\n" + start +
                "Z-20.3 F1.5 P180\nG9 X44 Z-21.3\nG0 X50\nM30\n%\n");
  ASSERT_EQ(threads.size(), 4u);
  EXPECT_EQ(threads[0].thread_start_deg, 0.0F);
  EXPECT_NEAR(turnsOf(threads[0]), 25.3 / 1.5, 1e-9);
  // The run-out goes 2 along X and 1 along Z: 2 / 1.5 turns.
  EXPECT_NEAR(turnsOf(threads[1]), 2 / 1.5, 1e-9);
  const double there = 360.0 * (25.3 / 1.5 - 16.0);
  EXPECT_NEAR(threads[1].thread_start_deg, there, 1e-4);
  EXPECT_EQ(threads[2].thread_start_deg, 180.0F);
  EXPECT_NEAR(threads[3].thread_start_deg, there + 180.0 - 360.0, 1e-4);
  for (const Motion& m : threads) {
    EXPECT_EQ(m.spindle, 400);
    EXPECT_EQ(m.thread_pitch_change, 0.0F);
  }
}

TEST(Wl4Threads, ASequenceEndsWithAStopOrAnotherMotion) {
  const auto start = [](const std::string& between) {
    const auto threads =
        threadsOf("%T\nG54 G97 S400 M4\nG0 X40 Z5\nG32 Z-20.5 F1 P30\n" + between + "\nM30\n%\n");
    return threads.at(1).thread_start_deg;
  };
  EXPECT_NEAR(start("Z-30"), 210, 1e-4);             // 25 and a half turns behind 30 degrees
  EXPECT_NEAR(start("Z-30 P77"), 210, 1e-4);         // P of a block within the sequence has no effect
  EXPECT_NEAR(start("G32 Z-30 F1 P77"), 210, 1e-4);  // nor has it with the code said again
  EXPECT_EQ(start("G0 X50\nZ5\nG32 Z-30 F1 P77"), 77.0F);
  EXPECT_EQ(start("G1 X41 F1\nG32 Z-30 F1"), 0.0F);
  EXPECT_EQ(start("G33 Z-30 F1 P5"), 5.0F);
  EXPECT_EQ(start("G4 E1\nG32 Z-30 F1 P5"), 5.0F);
  EXPECT_EQ(start("M1\nG32 Z-30 F1 P5"), 5.0F);
  EXPECT_EQ(start("S300 M4\nG32 Z-30 F1 P5"), 5.0F);
  EXPECT_NEAR(start("M8\n#1=3\nZ-30"), 210, 1e-4);
  const auto stopped =
      threadsOf("%T\nG54 G97 S400 M4\nG0 X40 Z5\nG32 G9 Z-20.5 F1 P30\nG32 Z-30 F1 P60\nM30\n%\n");
  EXPECT_EQ(stopped.at(1).thread_start_deg, 60.0F);
  EXPECT_EQ(stopped.at(1).spindle, -400);
  EXPECT_EQ(threadsOf("%T\nG54 G97 S400 M3\nG0 X40 Z5\nG32 Z-30 F1 P720\nM30\n%\n").at(0).thread_start_deg,
            0.0F);
}

/// Where the part stands, degrees by the right-hand rule about +Z seen against the way M3 turns it.
double partAngle(const Motion& m, double turns) {
  return (m.spindle < 0.0 ? -1.0 : 1.0) * (m.thread_start_deg + 360.0 * turns);
}

TEST(Wl4Threads, TheWayBackOfG33IsTheSameHelix) {
  for (const char* words : {"Z-15 F1.5 P40", "Z-13.2 F1.7 P200 I0.1"}) {
    for (const char* turn : {"M3", "M4"}) {
      const auto threads =
          threadsOf(std::string("%T\nG54 G97 S600 ") + turn + "\nG0 X20 Z5\nG33 " + words + "\nM30\n%\n");
      ASSERT_EQ(threads.size(), 2u);
      const Motion &there = threads[0], &back = threads[1];
      EXPECT_EQ(there.spindle, -back.spindle);
      EXPECT_NE(there.spindle, 0.0);
      const double turns = turnsOf(there), length = (there.to - there.from).norm();
      EXPECT_NEAR(turnsOf(back), turns, 1e-9);
      const auto way = [&](const Motion& m, double k) {
        return length * k / turns + m.thread_pitch_change * k * (k - turns) / 2.0;
      };
      for (const double k : {0.0, 0.3 * turns, 0.5 * turns, turns}) {
        EXPECT_NEAR(way(there, k), length - way(back, turns - k), 1e-5);
        const double apart = partAngle(there, k) - partAngle(back, turns - k);
        EXPECT_NEAR(std::remainder(apart, 360.0), 0.0, 1e-3) << words << turn;
      }
    }
  }
}

// Digest wl4, 4.5: n turns with F n + I n (n - 1) / 2 = L.
TEST(Wl4Threads, AGrowingPitchIsTold) {
  const auto threads = threadsOf("%T\nG54 G97 S600 M3\nG0 X30 Z5\nG32 Z-25 F2 I1\nG0 X0\nM30\n%\n");
  ASSERT_EQ(threads.size(), 1u);
  EXPECT_EQ(threads[0].thread_pitch_change, 1.0F);
  const double n = turnsOf(threads[0]);
  EXPECT_NEAR(2 * n + n * (n - 1) / 2, 30, 1e-9);
}

// Digest wl4, 4.5: F, I, P of a block that follows have no effect.
TEST(Wl4Threads, WordsOfBlocksThatFollowHaveNoEffect) {
  const Trace run(ControlId::kWl4Lathe,
                  "%T\nG54 G97 S600 M3\nG0 X30 Z5\nG32 Z-5 F2 P10\nG9 Z-25 I1 P20 F3\nG0 X0\nM30\n%\n");
  ASSERT_EQ(run.motions.size(), 4u);
  EXPECT_EQ(run.motions[2].thread_pitch_change, 0.0F);
  EXPECT_EQ(run.motions[2].feed, 1200);
  EXPECT_EQ(run.summary.warnings, 2);
  EXPECT_THAT(run.diagnostics.at(0).message, HasSubstr("has no effect in this block"));
}

// Nothing is made up: the default speed is for the time alone.
TEST(Wl4Threads, ASpindleThatStandsMakesNoTurns) {
  const auto threads = threadsOf("%T\nG54\nG0 X30 Z5\nG32 Z-25 F2\nG0 X0\nM30\n%\n");
  ASSERT_EQ(threads.size(), 1u);
  EXPECT_EQ(threads[0].spindle, 0.0);
  EXPECT_NEAR(threads[0].time_s, 60.0 * 15.0 / ControlSettings().default_spindle_rpm, 1e-9);
}

TEST(Wl4Threads, TurnsStayWithConstantCuttingSpeedAndSlowAxes) {
  const std::string text = "%T\nG54 G96 S100 M3\nG0 X40 Z5\nG32 X60 Z-25 F3\nG0 X70\nM30\n%\n";
  auto threads = threadsOf(text);
  ASSERT_EQ(threads.size(), 1u);
  EXPECT_NEAR(threads[0].spindle, 1000 * 100 / (kPi * 40), 1e-6);  // that at the start, to the end
  EXPECT_NEAR(turnsOf(threads[0]), 10, 1e-9);
}

TEST(Wl4Threads, MotionsStayAsSmallAsTheyWere) {
  struct WithoutThreads {
    Vec3 from, to;
    double feed, time_s, spindle;
    std::int32_t tool, arc, axis;
    SourceRef source;
    MotionKind kind;
    std::uint8_t channel;
  };
  constexpr std::size_t kWire = 8;  // the index of a wire's motion, aligned
  EXPECT_EQ(sizeof(Motion), sizeof(WithoutThreads) + kWire);
}

/// A program with compensation that ends in an alarm: its code, and where the tool stops.
struct CompAlarm {
  const char* name;
  std::string blocks;
  const char* code;
  Vec2 stop;
  std::size_t motions;
};

void PrintTo(const CompAlarm& alarm, std::ostream* out) { *out << alarm.name; }

class Wl4CompAlarms : public testing::TestWithParam<CompAlarm> {};

TEST_P(Wl4CompAlarms, ComeBehindTheBlocksBeforeTheFaultyOne) {
  ControlSettings settings;
  settings.radius_offsets[1] = {8.0, 0.0};
  settings.radius_offsets[2] = {2.0, 0.0};
  const Trace run(ControlId::kWl4Mill, "%R\nG54 G0 X0 Y-10\n" + GetParam().blocks + "M30\n%\n", settings);
  ASSERT_EQ(run.summary.errors, 1);
  EXPECT_EQ(run.diagnostics.back().code, GetParam().code);
  EXPECT_EQ(run.summary.end, ProgramEnd::kAlarm);
  ASSERT_EQ(run.motions.size(), GetParam().motions);
  EXPECT_NEAR((run.motions.back().to.head<2>() - GetParam().stop).norm(), 0.0, 1e-9)
      << run.motions.back().to.transpose();
}

std::string repeated(const std::string& block, int times) {
  std::string text;
  for (int k = 0; k < times; ++k) text += block;
  return text;
}

constexpr const char* kTooSmall = "wl4-negative-radius";
const std::string kShortLines = "Y9\nY9.2\nY9.4\nY9.6\nY9.8\nY10\n";
const std::string kManyDwells = repeated("G4 P0\n", 101);

// The manual's 6.2.1: the centre stops at 2', the end of the block before the arc; on the way in that is
// perpendicular to the start of the arc (digest wl4, 5.3).
INSTANTIATE_TEST_SUITE_P(
    Alarms, Wl4CompAlarms,
    testing::Values(
        CompAlarm{"TangentArc", "G41 D1 G1 X10 F100\nY10\nG3 X4 Y16 R6\n", kTooSmall, {2, 10}, 3},
        CompAlarm{"ArcOnTheRight", "G42 D1 G1 X10 F100\nY10\nG2 X16 Y16 R6\n", kTooSmall, {18, 10}, 3},
        CompAlarm{"ArcBehindAnInnerCorner", "G41 D1 G1 X10 F100\nY10\nG3 X-2 R6\n", kTooSmall, {2, 10}, 3},
        CompAlarm{"ArcBehindTheWayIn", "G41 D1 G1 X10 Y0 F100\nG3 Y12 R6\n", kTooSmall, {10, 8}, 2},
        CompAlarm{
            "ShortBlocks", "G41 D1 G1 X10 F100\n" + kShortLines + "G3 X4 Y16 R6\n", kTooSmall, {2, 10}, 8},
        CompAlarm{"FullBuffer", "G41 D2 G1 X10 F100\nY10\n" + kManyDwells, "wl4-compensation", {8, 10}, 3}),
    [](const auto& test) { return test.param.name; });

TEST(Wl4Codes, EveryRowNamesWhatExecutesIt) {
  for (const nc::Wl4GCode& g : nc::wl4GCodes()) {
    SCOPED_TRACE(g.code);
    EXPECT_EQ(nc::wl4GCode(g.code), &g);
    EXPECT_NE(g.group == nc::Wl4Group::kFlag || g.group == nc::Wl4Group::kDeed, g.mode != nullptr);
    EXPECT_TRUE(g.group != nc::Wl4Group::kMotion || (g.plan != nullptr && g.perform != nullptr));
    if (g.group == nc::Wl4Group::kDeed) {
      EXPECT_NE(g.plan, nullptr);
      EXPECT_TRUE(g.perform != nullptr || !g.program.empty() || g.code == 92);  // G92 only sets the state
    }
    EXPECT_TRUE(g.group != nc::Wl4Group::kFlag || g.flag != nullptr);
    EXPECT_TRUE(g.program.empty() || !nc::wl4OwnProgram(g.program).empty());
  }
  for (int m = 0; m < 100; ++m) {
    const nc::Wl4MCode& code = nc::wl4MCode(m);
    EXPECT_TRUE(code.first <= m && m <= code.last) << m;
    EXPECT_NE(code.perform != nullptr, code.flow != nc::Wl4Flow::kOn) << m;
  }
  EXPECT_EQ(nc::wl4MCode(19).first, 19);
  EXPECT_EQ(nc::wl4MCode(44).first, 40);
  EXPECT_EQ(nc::wl4GCode(5), nullptr);
  EXPECT_EQ(nc::wl4GCode(100), nullptr);
  EXPECT_EQ(nc::wl4GCode(-1), nullptr);
}

}  // namespace
}  // namespace proveout
