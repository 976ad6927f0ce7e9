// Text and words of Fanuc-like mills: blocks, names, comments, skips, numbers (rows fan-2-*).
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

ControlSettings linearRapids(std::map<std::string, double> parameters = {}) {
  parameters.emplace("rapid", 1.0);
  return runAtZero(std::move(parameters));
}
/// A program behind a usual head; the tool starts at (0, 0, 0).
IsoRun textRun(const std::string& text, std::map<std::string, double> parameters = {}) {
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100.\n" + text + "\nM30\n",
          linearRapids(std::move(parameters))};
}
IsoRun bare(const std::string& text) { return {ControlId::kFanucMill, text, linearRapids()}; }

/// Messages of notes with that code.
int told(const IsoRun& run, const std::string& code, const std::string& part = {}) {
  int count = 0;
  for (const Diagnostic& d : run.path.diagnostics.all())
    count += d.code == code && d.message.find(part) != std::string::npos ? 1 : 0;
  return count;
}

// fan-2-pct fan-2-leader
TEST(FanucText, TapeMarksAndLeader) {
  EXPECT_EQ(bare("%\nO1\nG90 G1 X1. F100.\nM30\n%\nG1 X9.\n").motions(), (Lines{"F 1 0 0"}));
  EXPECT_EQ(bare("this is leader\nanything = goes\n%\nO1\nG90 G1 X1. F100.\nM30\n%\n").motions(),
            (Lines{"F 1 0 0"}));
  EXPECT_TRUE(bare("anything goes\n%\nO1\nG90 G1 X1. F100.\nM30\n%\n").tells("fanuc-leader"));
  EXPECT_EQ(bare("O1\r\nG90 G1 X1. F100.\r\n\r\nM30\r\n").motions(), (Lines{"F 1 0 0"}));
  EXPECT_EQ(bare("\xEF\xBB\xBFO1\nG90 G1 X1. F100.\nM30").motions(), (Lines{"F 1 0 0"}));
}

// fan-2-o fan-2-colon fan-2-name fan-2-n
TEST(FanucText, ProgramsBeginWithNumbersAndNames) {
  const std::string sub = "G91 G1 X1. F100.\nM99\n";
  EXPECT_EQ(bare("O1\nM98 P2\nM30\nO2\n" + sub).end().x(), 1.0);
  EXPECT_EQ(bare(":1\nM98 P2\nM30\n:2\n" + sub).end().x(), 1.0);
  EXPECT_EQ(bare("O12345678\nM98 P2\nM30\nO2\n" + sub).end().x(), 1.0);
  EXPECT_EQ(bare("<PART>\nM98 P2\nM30\nO2\n" + sub).error(), "");
  EXPECT_EQ(bare("O<PART-7>(HOUSING)\nG1 X3. F100.\nM30\nO2\n" + sub).motions(), (Lines{"F 3 0 0"}));
  EXPECT_EQ(bare("%\nO0001(A)\nN99999999 G1 X1. F100.\nN5 X2.\nN5 X3.\nN1 M30\n%").motions(),
            (Lines{"F 1 0 0", "F 2 0 0", "F 3 0 0"}));
}

// fan-2-eob
TEST(FanucText, ASemicolonEndsTheBlock) {
  EXPECT_EQ(textRun("G1 X1.; X2.; Y3.;").motions(), (Lines{"F 1 0 0", "F 2 0 0", "F 2 3 0"}));
  EXPECT_EQ(textRun("G1 X1.;(DONE);").motions(), (Lines{"F 1 0 0"}));
  const IsoRun remark = textRun("G1 X1. ; move to the start\nX2. ; and on");
  EXPECT_EQ(remark.motions(), (Lines{"F 1 0 0", "F 2 0 0"}));
  EXPECT_EQ(told(remark, "fanuc-semicolon"), 1);
  EXPECT_EQ(textRun("G1 X1. (NO; END)").motions(), (Lines{"F 1 0 0"}));
  EXPECT_EQ(textRun("#1=5.; #2=[#1+1.];\nG1 X#1 Y#2;").motions(), (Lines{"F 5 6 0"}));
  EXPECT_EQ(textRun("#1=3.\nIF[#1 EQ 3.]GOTO 7;\nG1 X9.\nN7 G1 X1.;Y[#1];").motions(),
            (Lines{"F 1 0 0", "F 1 3 0"}));
  EXPECT_EQ(bare("O1;\nM98 P2; G1 X5. F100.;\nM30;\nO2;\nG1 Y1. F100.;\nM99;\n").motions(),
            (Lines{"F 0 1 0", "F 5 1 0"}));
}

// fan-2-comment
TEST(FanucText, CommentsDoNotNestAndEndWithTheirLine) {
  const IsoRun nested = textRun("G1 X1. (A (B) Y2.");
  EXPECT_EQ(nested.motions(), (Lines{"F 1 2 0"}));
  EXPECT_EQ(told(nested, "fanuc-nested-comment"), 1);
  const IsoRun open = textRun("G1 X1. (NEVER CLOSED\nX2. (THIS TOO\nN7 X3.\nGOTO 8\nX9.\nN8 Y1. (AND HERE");
  EXPECT_EQ(open.error(), "") << open.message();
  EXPECT_EQ(open.motions(), (Lines{"F 1 0 0", "F 2 0 0", "F 3 0 0", "F 3 1 0"}));
  EXPECT_EQ(told(open, "fanuc-open-comment"), 1);
}

// fan-2-skip: acceptance 59
TEST(FanucText, SlashesSkipByTheirSwitch) {
  const auto with = [](std::size_t number, const std::string& text) {
    ControlSettings settings = linearRapids();
    if (number > 0) settings.skip_switches[number - 1] = true;
    return IsoRun(ControlId::kFanucMill, "O1\nG90\n" + text + "\nM30\n", settings).motions();
  };
  EXPECT_EQ(with(0, "/G0 X9."), (Lines{"R 9 0 0"}));
  EXPECT_EQ(with(1, "/G0 X9."), (Lines{}));
  EXPECT_EQ(with(3, "/3 G0 X9.\n/2 X5."), (Lines{"R 5 0 0"}));
  EXPECT_EQ(with(9, "/9 G0 X9.\nN5 /9 X5."), (Lines{}));
  EXPECT_EQ(with(2, "G0 X9. /2 Y5."), (Lines{"R 9 0 0"}));
  EXPECT_EQ(with(1, "G0 X9. /2 Y5."), (Lines{"R 9 5 0"}));
  EXPECT_EQ(with(2, "/1/2 G0 X9.\nX1."), (Lines{"R 1 0 0"}));
  EXPECT_EQ(with(1, "G0 X[8/2]"), (Lines{"R 4 0 0"}));
}

// fan-2-words fan-2-null
TEST(FanucText, WordsHoldNumbersVariablesAndFormulas) {
  EXPECT_EQ(textRun("#1=2.\n#2=1\nG1 X#1 Y-#1 Z[#1*3.]").motions(), (Lines{"F 2 -2 6"}));
  EXPECT_EQ(textRun("#1=2\n#2=7.\nG1 X#[#1] Y-[#2-1.] Z+.5").motions(), (Lines{"F 7 -6 0.5"}));
  EXPECT_EQ(textRun("G1 X1. Y2.\nX#5 Y3.").motions(), (Lines{"F 1 2 0", "F 1 3 0"}));
  EXPECT_EQ(textRun("G01X1.Y2.Z3.").motions(), (Lines{"F 1 2 3"}));
  EXPECT_EQ(textRun("g1 x1. y2.").motions(), (Lines{"F 1 2 0"}));
}

// fan-2-round
TEST(FanucText, ValuesRoundToTheLeastIncrementHalfAwayFromZero) {
  EXPECT_EQ(textRun("G1 X1.2345 Y-1.2345 Z.0004").motions(), (Lines{"F 1.235 -1.235 0"}));
  EXPECT_EQ(textRun("G1 X[1./3.] Y[2./3.] Z[-2./3.]").motions(), (Lines{"F 0.333 0.667 -0.667"}));
  // 1.00005 inch is 1.0001 inch, 25.40254 mm
  EXPECT_EQ(textRun("G20\nG1 X1.00005").motions(), (Lines{"F 25.4025 0 0"}));
  const Lines arc = textRun("G2 X10. Y0 I[10./3.] J[0-2.0004]").motions();
  EXPECT_EQ(arc.size(), 0u);  // a centre of 3.333 is no circle's: 020
}

// fan-2-decimal: acceptance 2 and the table of section 2
TEST(FanucText, NumbersWithoutAPoint) {
  const std::map<std::string, double> increment{{"decimal", 1.0}};
  EXPECT_EQ(textRun("G1 X50 Y50.", increment).motions(), (Lines{"F 0.05 50 0"}));
  EXPECT_EQ(textRun("G1 X50 Y50.").motions(), (Lines{"F 50 50 0"}));
  EXPECT_EQ(textRun("G20\nG1 X10000", increment).motions(), (Lines{"F 25.4 0 0"}));
  EXPECT_EQ(textRun("G2 X10000 Y0 R5000", increment).motions(), (Lines{"A 10 0 0 c 5 0 0 -180"}));
  EXPECT_EQ(textRun("G3 I10000", increment).motions(), (Lines{"A 0 0 0 c 10 0 0 360"}));
  EXPECT_EQ(textRun("#1=50\nG1 X#1", increment).motions(), (Lines{"F 50 0 0"}));
  EXPECT_EQ(textRun("G1 X20000 ,R5000\nY20000", increment).motions(),
            (Lines{"F 15 0 0", "A 20 5 0 c 15 5 0 90", "F 20 20 0"}));
}

// fan-1-settingnote fan-2-decimal
TEST(FanucText, OneNoteWhereAnIntegerCoordinateDependsOnTheRule) {
  const IsoRun run = textRun("G1 X50\nY20\nX0 Y0");
  EXPECT_EQ(told(run, "fanuc-setting", "setting decimal of the machine: X50 without a point is taken as 50"),
            1);
  EXPECT_EQ(told(run, "fanuc-setting", "decimal"), 1);
  EXPECT_EQ(told(textRun("G1 X50. Y0\nX0"), "fanuc-setting", "decimal"), 0);
  EXPECT_EQ(told(textRun("G1 X50", {{"decimal", 0.0}}), "fanuc-setting", "decimal"), 0);
}

// fan-2-modal: the last code of a group holds (fanuc_basic_test); fan-2-mcount
TEST(FanucText, SeveralMFunctionsAreRunWithANote) {
  const IsoRun run = textRun("M3 S1000 M8\nG1 X1. M9 M5");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(told(run, "fanuc-m-words"), 1);
  EXPECT_EQ(told(textRun("M3 S1000\nM8"), "fanuc-m-words"), 0);
}

// fan-2-twice
TEST(FanucText, AnAddressTwiceIsAnAlarm) {
  EXPECT_EQ(textRun("G1 X1. X2.").error(), "fanuc-5074");
  EXPECT_EQ(textRun("G1 X1. F100. F200.").error(), "fanuc-5074");
  EXPECT_EQ(textRun("G90 G90 G1 X1.").error(), "");
}

struct BadText {
  const char* text;
  const char* code;
  int column = 0;
};

// fan-2-range fan-2-unknown
TEST(FanucText, BadNumbersAndAddressesHaveAlarms) {
  for (const BadText& bad : {
           BadText{"G1 X1000000.", "fanuc-003", 4}, BadText{"G1 X-1000000.", "fanuc-003", 4},
           BadText{"G1 X1e9", "fanuc-009", 6},      BadText{"G1 X99999999999999999999.", "fanuc-003", 4},
           BadText{"S100000 M3", "fanuc-003", 1},   BadText{"G1 X Y5.", "fanuc-005", 4},
           BadText{"G1 X", "fanuc-005", 4},         BadText{"G1 X-", "fanuc-005", 4},
           BadText{"G1 X.", "fanuc-005", 4},        BadText{"G1 X--5.", "fanuc-006", 4},
           BadText{"G1 X5.-", "fanuc-006", 4},      BadText{"G1 X5-3", "fanuc-006", 4},
           BadText{"G-1 X5.", "fanuc-006", 1},      BadText{"G1 X5. F-100.", "fanuc-006", 8},
           BadText{"M-3", "fanuc-006", 1},          BadText{"G1 X1.2.3", "fanuc-007", 4},
           BadText{"M3.", "fanuc-007", 1},          BadText{"T1. M6", "fanuc-007", 1},
           BadText{"G4 P1.5", "fanuc-007", 4},      BadText{"G43 H1. Z5.", "fanuc-007", 5},
           BadText{"G1 X5. $", "fanuc-009", 8},     BadText{"G1 X5. E5.", "fanuc-009", 8},
           BadText{"G1 X5. ?", "fanuc-009", 8},     BadText{"G123 X5.", "fanuc-010", 1},
           BadText{"G5.7", "fanuc-010", 1},         BadText{"G02.3 X5.", "fanuc-010", 1},
           BadText{"G0 X5. ,R3.", "fanuc-009", 8},
       }) {
    const IsoRun run = textRun(bad.text);
    EXPECT_EQ(run.error(), bad.code) << bad.text << ": " << run.message();
    EXPECT_EQ(run.first(Severity::kError).where.line, 3) << bad.text;
    if (bad.column > 0) {
      EXPECT_EQ(run.first(Severity::kError).where.column, bad.column) << bad.text;
    }
  }
}

// fan-2-unknownm
TEST(FanucText, AnUnknownMFunctionIsNotedOnce) {
  const IsoRun run = textRun("M77\nM77\nG1 X1. M78");
  EXPECT_EQ(run.error(), "");
  EXPECT_EQ(told(run, "fanuc-m-function", "M77"), 1);
  EXPECT_EQ(told(run, "fanuc-m-function", "M78"), 1);
  EXPECT_EQ(textRun("M77", {{"strict_m", 1.0}}).error(), "fanuc-m-function");
}

// fan-2-comma
TEST(FanucText, WordsBehindACommaDifferFromTheLetters) {
  EXPECT_EQ(textRun("G1 X20. ,R5.\nY20.").motions().size(), 3u);
  EXPECT_EQ(textRun("G1 X20. , C 2.\nY20.").motions().size(), 3u);
  EXPECT_EQ(textRun("G1 X20. ,D5.\nY20.").error(), "fanuc-114");
}

// fan-2-order: F, S, T and modal codes count in their own block; M03 before, M05 behind the motion
TEST(FanucText, OrderOfExecution) {
  EXPECT_EQ(textRun("X5. G91 G1 X5.").error(), "fanuc-5074");
  EXPECT_EQ(textRun("G1 X5.\nX1. G91").motions(), (Lines{"F 5 0 0", "F 6 0 0"}));
  EXPECT_EQ(textRun("X1. G20 G1").motions(), (Lines{"F 25.4 0 0"}));
  const IsoRun run = textRun("G1 X5. M3 S500\nX6. M5\nX7.");
  ASSERT_EQ(run.path.motions.size(), 3u);
  EXPECT_EQ(run.path.motions[0].spindle, 500.0);
  EXPECT_EQ(run.path.motions[1].spindle, 500.0);
  EXPECT_EQ(run.path.motions[2].spindle, 0.0);
}

}  // namespace
}  // namespace proveout::test
