// Properties and behaviour at the interpreter's boundary.
#include "core/nc/registry/interpreter.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace proveout {
namespace {

struct Outcome {
  Toolpath path;
  InterpretSummary summary;
};

Outcome runProgram(const std::string& text, ControlSettings settings = {}, Progress* progress = nullptr) {
  Outcome run;
  ToolpathBuilder sink(run.path);
  run.summary = interpret(ControlId::kNct, MemoryProgramSource("main.nc", text), settings, sink, progress);
  return run;
}

std::string firstError(const Outcome& run) {
  for (const Diagnostic& d : run.path.diagnostics.all()) {
    if (d.severity == Severity::kError) return d.code + ": " + d.message;
  }
  return {};
}

/// A contour with lines, arcs, a helix and a drilled hole; `scale` multiplies every length, `unit` is G20 or
/// G21.
std::string contour(double scale, const std::string& unit, bool incremental) {
  std::ostringstream out;
  out.precision(15);
  const auto w = [&](const char* letter, double v) { out << letter << v * scale << ' '; };
  out << unit << " G90 G0 ";
  w("X", 10), w("Y", 5), w("Z", 20);
  out << (incremental ? "\nG91 G1 " : "\nG1 ");
  w("Z", incremental ? -22 : -2), w("F", 120);
  out << "\n";
  w("X", incremental ? 30 : 40);
  out << "\nG3 ";
  w("X", incremental ? 10 : 50), w("Y", incremental ? 10 : 15), w("J", 10);
  out << "\nG2 ";
  w("X", incremental ? 10 : 60), w("Z", incremental ? -3 : -5), w("R", 7);
  out << "\nG1 ";
  w("X", incremental ? -5 : 55), w("Y", incremental ? 7.5 : 22.5);
  out << "\nM30\n";
  return out.str();
}

void expectSamePath(const Toolpath& a, const Toolpath& b, double tolerance) {
  ASSERT_EQ(a.motions.size(), b.motions.size());
  for (std::size_t i = 0; i < a.motions.size(); ++i) {
    EXPECT_LT((a.motions[i].to - b.motions[i].to).norm(), tolerance) << "motion " << i;
    EXPECT_NEAR(a.motions[i].feed, b.motions[i].feed, 1e-6);
    EXPECT_EQ(a.motions[i].shape(), b.motions[i].shape());
    for (const double u : {0.25, 0.5, 0.75}) {
      EXPECT_LT((a.pointAt(a.motions[i], u) - b.pointAt(b.motions[i], u)).norm(), tolerance)
          << "motion " << i;
    }
  }
}

TEST(Interpreter, InchAndMetricAgree) {
  const Outcome metric = runProgram(contour(1.0, "G21", false));
  const Outcome inch = runProgram(contour(1.0 / 25.4, "G20", false));
  EXPECT_EQ(firstError(metric), "");
  EXPECT_EQ(firstError(inch), "");
  EXPECT_EQ(metric.path.motions.size(), 6u);
  expectSamePath(metric.path, inch.path, 1e-8);
}

TEST(Interpreter, AbsoluteAndIncrementalAgree) {
  const Outcome absolute = runProgram(contour(1.0, "G21", false));
  const Outcome incremental = runProgram(contour(1.0, "G21", true));
  EXPECT_EQ(firstError(incremental), "");
  expectSamePath(absolute.path, incremental.path, 1e-9);
}

TEST(Interpreter, PlanesArePermutations) {
  const auto program = [](const char* plane, const char* u, const char* v, const char* w, const char* i,
                          const char* j) {
    std::ostringstream out;
    out << plane << " G0 " << u << "0 " << v << "0 " << w << "10 F100\nG41 D1 G1 " << u << "20\nG1 " << u
        << "40\nG3 " << u << "50 " << v << "10 " << j << "10\nG1 " << v << "30\nG2 " << u << "60 " << v
        << "40 " << i << "10 " << w << "5\nG1 " << u << "80\nG40 " << v << "60\nG99 G81 " << u << "5 " << v
        << "6 R2 " << w << "-3\nM30\n";
    return out.str();
  };
  ControlSettings settings;
  settings.start = Vec3(0, 0, 0);
  settings.radius_offsets[1] = {3.0, 0.0};
  const Outcome xy = runProgram(program("G17", "X", "Y", "Z", "I", "J"), settings);
  const Outcome zx = runProgram(program("G18", "Z", "X", "Y", "K", "I"), settings);
  const Outcome yz = runProgram(program("G19", "Y", "Z", "X", "J", "K"), settings);
  ASSERT_EQ(firstError(xy), "");
  ASSERT_EQ(xy.path.motions.size(), zx.path.motions.size());
  ASSERT_EQ(xy.path.motions.size(), yz.path.motions.size());
  ASSERT_GT(xy.path.motions.size(), 10u);
  for (std::size_t k = 0; k < xy.path.motions.size(); ++k) {
    for (const double t : {0.3, 1.0}) {
      const Vec3 p = xy.path.pointAt(xy.path.motions[k], t);
      const Vec3 q = zx.path.pointAt(zx.path.motions[k], t);
      const Vec3 r = yz.path.pointAt(yz.path.motions[k], t);
      EXPECT_LT((Vec3(q.z(), q.x(), q.y()) - p).norm(), 1e-9) << k;
      EXPECT_LT((Vec3(r.y(), r.z(), r.x()) - p).norm(), 1e-9) << k;
    }
  }
}

TEST(Interpreter, MotionsJoin) {
  const Outcome run = runProgram(contour(1.0, "G21", false));
  for (std::size_t i = 1; i < run.path.motions.size(); ++i) {
    EXPECT_EQ(run.path.motions[i].from, run.path.motions[i - 1].to);
  }
}

TEST(Interpreter, TimesAddUp) {
  const Outcome run = runProgram("T1 M6\nG0 X10\nG1 X20 F60\nG4 P1.5\nM30\n");
  double motions = 0;
  for (const Motion& m : run.path.motions) motions += m.time_s;
  EXPECT_NEAR(run.summary.cutting_s, 10.0, 1e-9);
  EXPECT_NEAR(run.summary.cycle_s, motions + 1.5 + ControlSettings{}.tool_change_s, 1e-9);
}

TEST(Interpreter, CancelStops) {
  Progress progress;
  progress.cancel();
  const Outcome run = runProgram("N1 G0 X1\nX2\nM99 P1\n", {}, &progress);
  EXPECT_EQ(run.summary.end, ProgramEnd::kCancelled);
  EXPECT_FALSE(run.summary.ok());
}

TEST(Interpreter, BadBytesAreRefused) {
  const Outcome nul = runProgram(std::string("G0 X1\n\0G1 X2\n", 13));
  EXPECT_NE(firstError(nul).find("NUL"), std::string::npos) << firstError(nul);
  EXPECT_EQ(nul.path.motions.size(), 0u);
  const Outcome utf16 = runProgram(std::string("\xFF\xFEG\0000\0", 6));
  EXPECT_FALSE(utf16.summary.ok());
  EXPECT_FALSE(runProgram("").summary.ok());
}

TEST(Interpreter, ABadBlockChangesNothing) {
  ControlSettings settings;
  settings.max_errors = 10;
  settings.start = Vec3::Zero();
  const Outcome run = runProgram("G0 X1\nG91 G20 S500 G55 X5 Q7\nX3\nM30\n", settings);
  ASSERT_EQ(run.path.motions.size(), 2u);
  EXPECT_EQ(run.path.motions[1].to, Vec3(3, 0, 0)) << "still G90, G21, G54";
}

TEST(Interpreter, ControlsAreKnownByName) {
  EXPECT_TRUE(findControl("nct").ok());
  EXPECT_TRUE(findControl("fanuc-lathe").ok());
  ASSERT_FALSE(findControl("fanuc").ok());
  EXPECT_NE(findControl("fanuc").error().message.find("nct"), std::string::npos);
  EXPECT_NE(findControl("NTC").error().message.find("did you mean 'nct'?"), std::string::npos);
}

TEST(Interpreter, CoverageTableIsSound) {
  const auto table = coverageTable(ControlId::kNct);
  ASSERT_TRUE(table.ok());
  std::set<std::string> codes;
  for (const CoverageRow& row : *table) {
    EXPECT_TRUE(codes.insert(row.code).second) << row.code << " twice";
    EXPECT_FALSE(row.ids.empty()) << row.code;
    EXPECT_FALSE(row.meaning.empty()) << row.code;
  }
  EXPECT_GT(table->size(), 120u);
}

/// Every code that the table calls refused is refused, every other one is accepted by name.
TEST(Interpreter, CoverageTableIsWhatRuns) {
  const auto table = coverageTable(ControlId::kNct);
  ASSERT_TRUE(table.ok());
  for (const CoverageRow& row : *table) {
    if (row.code[0] != 'G') continue;
    const std::string error = firstError(runProgram(row.code + "\nM30\n"));
    const bool refused = error.find("nct-2123") == 0;
    EXPECT_EQ(refused, row.status == "refused") << row.code << " " << error;
  }
}

class SharedProgram : public testing::TestWithParam<std::tuple<const char*, std::size_t, double>> {};

TEST_P(SharedProgram, RunsWithoutErrors) {
  const auto [name, motions, lowest] = GetParam();
  std::ifstream in(std::string(PROVEOUT_SHARED_PROGRAMS) + "/" + name, std::ios::binary);
  if (!in) GTEST_SKIP() << "the shared programs are not here";
  std::ostringstream text;
  text << in.rdbuf();
  const Outcome run = runProgram(text.str());
  EXPECT_EQ(firstError(run), "");
  EXPECT_EQ(run.path.motions.size(), motions);
  double z = 1e9;
  for (const Motion& m : run.path.motions) z = std::min(z, m.to.z());
  EXPECT_NEAR(z, lowest, 1e-9);
}

// Lowest Z: by looking at the texts (the flower's in inches).
INSTANTIATE_TEST_SUITE_P(
    Programs, SharedProgram,
    testing::Values(std::make_tuple("bear.nc", std::size_t{15156}, -17.368),
                    std::make_tuple("flower_mold.nc", std::size_t{16557}, -0.3636 * 25.4),
                    std::make_tuple("circle_diamond_square.gcode", std::size_t{953}, -10.0)));

}  // namespace
}  // namespace proveout
