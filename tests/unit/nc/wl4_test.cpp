// The WL4 control where a golden file does not reach: texts of the shipped programs, encodings, limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/nc/interpreter.h"
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

}  // namespace
}  // namespace proveout
