// What every posted program of a Fanuc-like mill has.
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

IsoRun mill(const std::string& text) { return {ControlId::kFanucMill, text}; }

TEST(FanucMill, RunsAProgram) {
  const IsoRun run =
      mill("%\nO0001(PART)\nN10 G21 G90 G17\nG0 X10. Y0\nG1 Z-1. F100.\nG2 X20. Y-10. I0 J-10.\nM30\n%\n");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 10 0 0", "F 10 0 -1", "A 20 -10 -1 c 10 -10 -1 -90"}));
}

// fan-2-modal
TEST(FanucMill, TheLastCodeOfAGroupHolds) {
  EXPECT_EQ(mill("O1\nG90 G0 G1 X5. F100.\nM30\n").motions(), (Lines{"F 5 0 0"}));
}

// fan-1-flavour
TEST(FanucMill, TheFlavourSaysWhoseRowsHold) {
  const auto as = [](double flavour, const std::string& text) {
    ControlSettings settings = runAtZero({{"flavour", flavour}});
    settings.start.z() = 100.0;
    return IsoRun(ControlId::kFanucMill, text, settings);
  };
  const std::string home = "O1\nG0 Z5.\nG28\nM30\n", group = "O1\nG90 G0 G1 X5. F100.\nM30\n";
  EXPECT_EQ(as(0, home).path.motions.size(), 1u) << "no axis is named";
  EXPECT_GT(as(1, home).path.motions.size(), 1u) << "all axes go home";
  EXPECT_EQ(as(0, group).error(), "");
  EXPECT_NE(as(1, group).error(), "") << "two codes of a group";
}

// fan-19-place
TEST(FanucMill, AlarmsHaveAPlaceTheWordsAndAdvice) {
  struct Case {
    std::string block, code, word;
  };
  for (const Case& c :
       {Case{"G77 X1.", "fanuc-010", "G77"}, Case{"G1 X1.", "fanuc-011", "F"},
        Case{"G2 X10. Y0 R1. F100.", "fanuc-020", "4 mm"}, Case{"G2 X10. Y0 F100.", "fanuc-022", "R"},
        Case{"X1. X2.", "fanuc-5074", "X"}, Case{"M98 P77", "fanuc-076", "77"},
        Case{"GOTO 77", "fanuc-128", "77"}, Case{"#1=1/0", "fanuc-112", ""},
        Case{"#1=SQRT[-1]", "fanuc-119", ""}, Case{"#5001=1", "fanuc-116", "5001"}}) {
    const IsoRun run = mill("O1\nG90\n" + c.block + "\nM30\n");
    const Diagnostic d = run.first(Severity::kError);
    EXPECT_EQ(d.code, c.code) << c.block << ": " << d.message;
    EXPECT_EQ(d.where.line, 3) << c.block;
    EXPECT_NE(d.message.find(c.word), std::string::npos) << c.block << ": " << d.message;
    EXPECT_GT(d.message.size(), 12u) << c.block << ": " << d.message;
  }
}

}  // namespace
}  // namespace proveout::test
