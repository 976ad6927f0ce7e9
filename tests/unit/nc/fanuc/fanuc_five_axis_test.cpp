// Five axes of Fanuc-like mills (iso-fanuc, section 17) on machines with heads, tables and both.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "tests/support/five_axis_runs.h"
#include "tests/unit/nc/iso_run.h"

namespace proveout {
namespace fanuc_five_axis_test {
namespace {

using namespace test;  // NOLINT

Outcome fanucOf(const std::string& text, ControlSettings settings) {
  settings.parameters["rapid"] = 1;  // straight
  Outcome out;
  ToolpathBuilder sink(out.path);
  out.summary = interpret(ControlId::kFanucMill, MemoryProgramSource("main.nc", "O1\n" + text + "\nM30\n"),
                          settings, sink);
  for (const Diagnostic& d : out.path.diagnostics.all()) {
    if (d.severity == Severity::kError && out.error.empty()) out.error = d.code + ": " + d.message;
  }
  return out;
}

Eigen::Matrix3d about(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * M_PI / 180.0, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

/// Where the tool goes by `X10 Y20 Z5` behind a G68.2 of these words.
Vec3 goesTo(const std::string& words, char machine) {
  const Outcome out =
      fanucOf("G54 G90 G0 G43 H1 X0 Y0 Z50\n" + words + "\nG1 X10 Y20 Z5 F500", machineOf(machine));
  EXPECT_EQ(out.error, "") << words;
  return out.path.motions.empty() ? Vec3(Vec3::Zero()) : out.path.motions.back().to;
}

// fan-17-G68.2
TEST(FanucFiveAxis, TiltedPlanes) {
  const Vec3 p(10, 20, 5), origin(3, -4, 7);
  const auto expectAt = [&](const std::string& words, const Vec3& expected) {
    for (const char machine : {'H', 'T', 'M'}) {
      EXPECT_LT((goesTo(words, machine) - expected).norm(), kPrinted) << words << machine;
    }
  };
  expectAt("G68.2 X3 Y-4 Z7 I30 J40 K-20", origin + about(2, 30) * about(0, 40) * about(2, -20) * p);
  expectAt("G68.2 P0 X3 Y-4 Z7 I0 J25 K0", origin + about(0, 25) * p);
  expectAt("G68.2 P1 Q123 X3 Y-4 Z7 I10 J20 K30", origin + about(2, 30) * about(1, 20) * about(0, 10) * p);
  expectAt("G68.2 P1 X3 Y-4 Z7 I10 J20 K30", origin + about(2, 30) * about(1, 20) * about(0, 10) * p);
  // Three points: origin, on X, in the XY plane.
  expectAt("G68.2 P2 Q1 X3 Y-4 Z7\nG68.2 P2 Q2 X3 Y-3 Z7\nG68.2 P2 Q3 X2 Y-4 Z7", origin + about(2, 90) * p);
  // Two vectors: X and Z.
  expectAt("G68.2 P3 Q1 X3 Y-4 Z7 I0 J1 K0\nG68.2 P3 Q2 I0 J0 K1", origin + about(2, 90) * p);
}

TEST(FanucFiveAxis, G69EndsTheTiltedPlane) {
  const Outcome out = fanucOf("G54 G90 G0 G43 H1 X0 Y0 Z50\nG68.2 X3 Y4 Z5 I30 J40 K0\nG69\nG1 X1 Y2 Z3 F500",
                              machineOf('T'));
  EXPECT_EQ(out.error, "");
  EXPECT_LT((out.path.motions.back().to - Vec3(1, 2, 3)).norm(), kPrinted);
}

// fan-17-G53.1 fan-17-G43.4 fan-17-G43.5 fan-17-G54.2 fan-17-abc: as the service of nct, whose tests check
// it against the machines themselves.
TEST(FanucFiveAxis, TheServiceIsThatOfNct) {
  const std::vector<std::string> programs{
      "G54 G90 G0 X0 Y0 Z100\nG43 H1 Z90\nG68.2 X10 Y0 Z0 I0 J30 K0\nG53.1\nG0 X5 Y5 Z10\nG1 Z-2 F300\nG69",
      "G54 G90 G0 X0 Y0 Z100 %0 C0\nG43.4 H1 X50 Y0 Z0\nG1 X40 Y30 Z-20 %40 C60 F500\nG49 G0 Z100",
      "G54 G90 G0 X0 Y0 Z100 %0 C0\nG43.5 H1 X50 Y0 Z0\nG1 X40 Y30 Z-20 I1 J0 K2 F500\nG49 G0 Z100",
      "G54 G90 G0 X0 Y0 Z100 %0 C0\nG1 %20 C30 F500\nX10 %10 C-10",
      "G54 G90 G0 X0 Y0 Z100 %0 C0\nG43 H1 Z90\nG68.2 P4 X3 Y-4 Z7 I10 J20 K30\nG53.1\nG0 X5 Y5 Z10\nG1 Z-2 "
      "F300\nG69",
      "G54 G90 G0 X0 Y0 Z100 %0 C0\nG43 H1 Z90\nG68.2 P1 Q213 X3 I10 J20 K30\nG53.1\nG1 X5 Z-2 F300\nG69",
      "G54 G90 G0 X0 Y0 Z100 %0 C0\nG43.4 H1 X50 Y0 Z0\nG91 G1 X-10 Y30 %20 F500\n%20 C60\nG90 G2 X30 Y10 "
      "R40 "
      "%10\nG49 G0 Z100",
      "G10 L21 P2 X410 Y310 Z-400\nG54 G90 G0 X0 Y0 Z100 %0 C0\nG43 H1 Z90\nG54.2 P2\nG0 X5 Y5 Z50\n%30 "
      "C40\nX5 Y5\nG1 X10 %10 F500\nG10 L21 P2 Z-390\nX0\nG54 X0 Z200"};
  for (const std::string& program : programs) {
    for (const char machine : {'H', 'T', 'M'}) {
      std::string text = program;
      for (std::size_t at; (at = text.find('%')) != std::string::npos;)
        text.replace(at, 1, machine == 'T' ? "A" : "B");
      const Outcome fanuc = fanucOf(text, machineOf(machine));
      if (const std::size_t end = text.find("\nG69"); end != std::string::npos)
        text.replace(end, 4, "\nG69.1");
      const Outcome nct = runOf("\n" + text, machineOf(machine));
      const bool table = machine != 'H' || text.find("G54.2") == std::string::npos;
      if (!table) {  // there is none that could turn
        EXPECT_NE(fanuc.error, "");
        EXPECT_NE(nct.error, "");
        continue;
      }
      ASSERT_EQ(fanuc.error, "") << text << machine;
      ASSERT_EQ(nct.error, "") << text << machine;
      ASSERT_EQ(fanuc.path.motions.size(), nct.path.motions.size()) << text << machine;
      for (std::size_t k = 0; k < nct.path.motions.size(); ++k) {
        const Motion &a = fanuc.path.motions[k], &b = nct.path.motions[k];
        EXPECT_LT((a.to - b.to).norm(), 1e-9) << text << machine << k;
        ASSERT_EQ(a.axis >= 0, b.axis >= 0);
        if (a.axis < 0) continue;
        const Vec3 axis = fanuc.path.axes[static_cast<std::size_t>(a.axis)].to;
        EXPECT_LT((axis - nct.path.axes[static_cast<std::size_t>(b.axis)].to).norm(), 1e-9);
      }
    }
  }
}

/// P0 ends a dynamic zero, and the row may be another zero than the control at hand has: told. fan-17-G54.2
TEST(FanucFiveAxis, DynamicZeroEndsByP0) {
  const std::string text =
      "G10 L21 P1 X410 Y310 Z-400\nG54 G90 G0 X0 Y0 Z100 A0 C0\nG43 H1 Z90\nG54.2 P1\nG0 X5 Y6 Z50\nC90\n";
  const Outcome run = fanucOf(text + "X5 Y6 Z50\nG54.2 P0\nX1 Y2 Z3", machineOf('T'));
  ASSERT_EQ(run.error, "");
  const Outcome without = fanucOf("G54 G90 G0 X0 Y0 Z100 A0 C90\nG43 H1 Z90\nX1 Y2 Z3", machineOf('T'));
  ASSERT_EQ(without.error, "");
  // P0: G54 holds again.
  EXPECT_LT((run.path.motions.back().to - without.path.motions.back().to).norm(), kPrinted);
  bool told = false;
  for (const Diagnostic& d : run.path.diagnostics.all()) told = told || d.code == "fanuc-fixture-offset";
  EXPECT_TRUE(told);
  EXPECT_NE(fanucOf("G54.2", machineOf('T')).error, "");
  EXPECT_NE(fanucOf("G54.2 P9", machineOf('T')).error, "");
}

// fan-17-nokin
TEST(FanucFiveAxis, NeedsHeadsOrTables) {
  for (const char* line : {"G68.2 X0 Y0 Z0 I0 J30 K0\n", "G43.4 H1\n", "G43.5 H1\n", "G54.2 P1\n"}) {
    const IsoRun run(ControlId::kFanucMill, std::string("O1\nG90 G0 X1\n") + line + "M30\n");
    EXPECT_EQ(run.error(), "fanuc-machine-data") << line << run.message();
    EXPECT_NE(run.message().find("machine"), std::string::npos);
  }
  EXPECT_EQ(IsoRun(ControlId::kFanucMill, "O1\nG53.1\nM30\n").error(), "fanuc-machine-data");
}

}  // namespace
}  // namespace fanuc_five_axis_test
}  // namespace proveout
