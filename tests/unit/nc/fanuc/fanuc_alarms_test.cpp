// Every alarm of Fanuc-like controls is raised by a program (iso-fanuc, section 19).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/nc/fanuc/alarms.h"
#include "tests/support/five_axis_runs.h"
#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

enum class Kind { kMill, kLathe, kRotary };

/// A program whose first error is that alarm, with a word of its text.
struct AlarmProgram {
  int number;
  Kind control;
  std::string text;
  std::string says;
};

/// A mill with a rotary axis C.
ControlSettings rotaryMill() {
  ControlSettings settings = runAtZero();
  AxisSettings c;
  c.name = "C";
  c.number = 4;
  settings.axes.push_back(c);
  settings.start = Vec3(20, 0, 0);
  return settings;
}

ControlSettings withOffset(ControlSettings settings) {
  settings.radius_offsets[1] = {5.0, 0.0};
  settings.length_offsets[1] = {50.0, 0.0};
  settings.reference_points[0] = Vec3(300, 200, 100);
  return settings;
}

IsoRun alarmRun(const AlarmProgram& p) {
  const std::string text = "O1\n" + p.text + "\nM30\n";
  if (p.control == Kind::kLathe) return lathe(text, withOffset(latheAt(44, 2)));
  return {ControlId::kFanucMill, text, withOffset(p.control == Kind::kRotary ? rotaryMill() : runAtZero())};
}

std::string modalMacros(int count) {
  std::string text;
  for (int k = 0; k < count; ++k) text += "G66 P2\n";
  return text + "M30\nO2\nM99";
}

std::string calls(int count) {
  std::string text = "M98 P2\nM30\n";
  for (int k = 2; k < count; ++k) text += fmt::format("O{}\nM98 P{}\nM99\n", k, k + 1);
  return text + fmt::format("O{}\nM99", count);
}

std::vector<AlarmProgram> alarmPrograms() {
  const std::string contour = "\nN10 G0 X20.\nN20 G1 Z-20.";
  const std::string bad_first = "\nN10 X20.\nN20 G1 Z-20.";
  return {
      {3, Kind::kMill, "G1 X1000000. F100.", "range"},
      {5, Kind::kMill, "G1 X F100.", "no number"},
      {6, Kind::kMill, "G1 X--5. F100.", "sign"},
      {7, Kind::kMill, "M3.", "decimal point"},
      {9, Kind::kMill, "G1 X5. E5. F100.", "address"},
      {10, Kind::kMill, "G77 X1.", "G77"},
      {11, Kind::kMill, "G1 X1.", "F"},
      {20, Kind::kMill, "G2 X10. R4.9 F100.", "over tolerance of radius"},
      {21, Kind::kMill, "G2 X10. Y0 I5. K3. F100.", "plane axis"},
      {22, Kind::kMill, "G2 X10. Y5. F100.", "no radius"},
      {23, Kind::kLathe, "G2 X50. Z-5. R-5. F.1", "negative radius"},
      {27, Kind::kMill, "G43 H1", "type C"},
      {28, Kind::kLathe, "G17 G71 P10 Q20 U1. D2. F.3" + contour, "plane"},
      {29, Kind::kMill, "G10 L10 P1 R10000.", "illegal offset value"},
      {30, Kind::kMill, "G43 H1000 Z1.", "illegal offset number"},
      {31, Kind::kMill, "G10 L2 P7 X1.", "illegal P"},
      {33, Kind::kMill,
       "G0 X-20. Y0\nG41 D1 G1 X10. Y0 F100.\nX20.\nG3 X16.961 Y3.504 I-5.903 J-2.051\nG1 X-27.478 Y26.421",
       "intersection"},
      {34, Kind::kMill, "G41 D1 G2 X10. R5. F100.", "G2 or G3"},
      {35, Kind::kMill, "G41 D1 G1 X5. F100.\nG31 X50.", "G31"},
      {36, Kind::kMill, "G95 G31 X50. F.1", "G31"},
      {37, Kind::kMill, "G41 D1 G1 X5. F100.\nG18 X10.", "plane"},
      {41, Kind::kMill, "G41 D1 G1 X20. Y0 F100.\nX20. Y20.\nG3 X14. Y20. R3.\nG1 Y0\nG40 X0",
       "interference"},
      {42, Kind::kMill, "G41 D1 G1 X5. F100.\nG45 D1 X20.", "G45"},
      {45, Kind::kMill, "G83 Z-10. R2. F100.", "address Q"},
      {46, Kind::kMill, "G29 X30.", "intermediate"},
      {49, Kind::kMill, "G51 X0 Y0 P2000\nG18 G0 X1.", "G50"},
      {50, Kind::kLathe, "G97 S500 M3\nG32 Z-20. F1. ,C1.", "thread"},
      {51, Kind::kMill, "G1 X20. ,R5. F100.", "missing move"},
      {52, Kind::kMill, "G1 X20. ,R5. F100.\nG0 Y20.", "G01"},
      {53, Kind::kMill, "G1 X20. ,R5. ,C2. F100.\nY20.", "too many"},
      {54, Kind::kLathe, "G1 X50. Z-10. R2. F.1\nZ-20.", "no taper"},
      {55, Kind::kMill, "G1 X20. ,R25. F100.\nY20.", "missing move value"},
      {56, Kind::kLathe, "G1 ,A90. F.1", "no end point"},
      {57, Kind::kLathe, "G1 ,A180. F.1\nX60. Z-30. ,A180.", "no solution"},
      {61, Kind::kLathe, "G71 P10 U.4 F.3" + contour, "P and Q"},
      {62, Kind::kLathe, "G71 P10 Q20 D0 F.3" + contour, "depth"},
      {63, Kind::kLathe, "G70 P11 Q20 F.3" + contour, "N11"},
      {64, Kind::kLathe, "G71 P10 Q20 U1. D2. F.3\nN10 G0 X20.\nG1 Z-20.\nX30. Z-10.\nN20 X44.", "one way"},
      {65, Kind::kLathe, "G71 P10 Q20 U1. D2. F.3" + bad_first, "G00"},
      {66, Kind::kLathe, "G71 P10 Q20 U1. D2. F.3\nN10 G0 X20.\nM98 P5\nN20 G1 Z-20.", "improper"},
      {69, Kind::kLathe, "G71 P10 Q20 U1. D2. F.3\nN10 G0 X20.\nG1 Z-20.\nN20 X44. ,R2.", "last block"},
      {73, Kind::kMill, "M98 P2\nM30\nO2\nM99\nO2\nM99", "already in use"},
      {76, Kind::kMill, "M98 P77", "not found"},
      {77, Kind::kMill, calls(13), "nested"},
      {78, Kind::kMill, "M98 P2 Q7\nM30\nO2\nM99", "N7"},
      {92, Kind::kMill, "G27 X299.", "reference"},
      {111, Kind::kMill, "#1=EXP[800]", "overflow"},
      {112, Kind::kMill, "#1=1/0", "zero"},
      {114, Kind::kMill, "#1=1+*2", "format"},
      {115, Kind::kMill, "#1=#99999", "variable"},
      {116, Kind::kMill, "#5001=1", "protected"},
      {118, Kind::kMill, "#1=" + std::string(30, '[') + "1" + std::string(30, ']'), "nesting"},
      {119, Kind::kMill, "#1=SQRT[-1]", "argument"},
      {122, Kind::kMill, modalMacros(20), "modal"},
      {124, Kind::kMill, "WHILE[1 EQ 1]DO1\nG0 X1.", "END"},
      {125, Kind::kMill, "#1=[1+2", "bracket"},
      {126, Kind::kMill, "WHILE[1 EQ 1]DO4\nEND4", "loop number"},
      {127, Kind::kMill, "G0 X1. #1=2", "same block"},
      {128, Kind::kMill, "GOTO[-1]", "N-1"},
      {129, Kind::kMill, "G65 P2 L1 G5.\nM30\nO2\nM99", "argument address"},
      {141, Kind::kMill, "G41 D1 G1 X5. F100.\nG51 X0 Y0 P2000", "G51"},
      {142, Kind::kMill, "G51 X0 Y0 P0", "scale"},
      {144, Kind::kMill, "G68 X0 Y0 R30.\nG18 X10.", "plane"},
      {145, Kind::kRotary, "G12.1 X5.", "alone"},
      {146, Kind::kRotary, "G12.1\nG54", "G54"},
      {175, Kind::kRotary, "G07.1 C20. X5.", "radius"},
      {176, Kind::kRotary, "G18\nG07.1 C20.\nG2 Z10. C10. I5. F100.", "cylinder"},
      {190, Kind::kLathe, "G96 S100 P9 M3", "axis select"},
      {200, Kind::kMill, "M29", "S"},
      {201, Kind::kMill, "M29 S500\nG84 Z-5. R1.", "feedrate"},
      {202, Kind::kMill, "M29 S70000\nG84 Z-5. R1. F100.", "LSI"},
      {203, Kind::kMill, "M29 S500\nG0 X5.", "rigid tapping"},
      {206, Kind::kMill, "M29 S500\nG18", "plane"},
      {241, Kind::kMill, "G0 X20.\nG2.2 X25. Y3. R10. F100.", ""},
      {242, Kind::kMill, "G0 X20.\nG2.2 X25. Y3. I-20. R30. F100.", ""},
      {243, Kind::kMill, "G0 X20.\nG2.2 X25. Y25. I-20. R10. F100.", ""},
      {5074, Kind::kMill, "G0 X1. X2.", "duplication"},
      {5115, Kind::kMill, "G6.2 P2 K0 X0 Y0 F100.\nK1. X1.\nK2.\nK3.\nX5.", "ended"},
      {5116, Kind::kMill, "G6.2 P4 K0 X0 Y0 F100.\nK-1. X1.", "must not fall"},
      {5117, Kind::kMill, "G6.2 P4 K0 X0 Y0 F100.\nX1.", "not complete"},
      {5118, Kind::kMill, "G6.2 P4 K0 X0 Y0 R0 F100.", "weights"},
      {5123, Kind::kMill, "G0 X20.\nG3 X30. Y0 I-20. J0 Q50. L2 F100.", "spiral"},
      {5432, Kind::kMill, "G2.4 X5. Y5. Z2. F100.\nG0 X0", "arc in space"},
  };
}

// fan-19-place
TEST(FanucAlarms, EachIsRaisedByAProgram) {
  std::map<int, int> raised;
  for (AlarmProgram p : alarmPrograms()) {
    const std::string code = fmt::format("fanuc-{:03}", p.number);
    if (p.number == 27) {
      ControlSettings settings = withOffset(runAtZero({{"length_type", 2}}));
      EXPECT_EQ(IsoRun(ControlId::kFanucMill, "O1\n" + p.text + "\nM30\n", settings).error(), code);
      ++raised[p.number];
      continue;
    }
    const IsoRun run = alarmRun(p);
    EXPECT_EQ(run.error(), code) << p.text << ": " << run.message();
    EXPECT_NE(run.message().find(p.says), std::string::npos) << code << ": " << run.message();
    if (run.error() == code) ++raised[p.number];
  }
  for (const int number : nc::fanucAlarmNumbers())
    EXPECT_GT(raised[number], 0) << "no program raises " << number;
}

TEST(FanucAlarms, SpeakAsTheControlDoes) {
  const IsoRun arc(ControlId::kFanucMill, "O1\nG2 X10. R4.9 F100.\nM30\n");
  EXPECT_EQ(arc.message(), "over tolerance of radius: 0.1 mm between start and end radius, 0.01 allowed");
  const Diagnostic error = arc.first(Severity::kError);
  EXPECT_EQ(error.where.line, 2);
}

}  // namespace
}  // namespace proveout::test
