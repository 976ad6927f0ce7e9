// Words and codes that do nothing are told, and values that no control has are refused.
#include <gtest/gtest.h>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

enum class ToldBy { kMill, kLathe, kHaas };

struct ToldRow {
  ToldBy control;
  const char *text, *code;
  bool error = false;
};

IsoRun toldRun(const ToldRow& row) {
  const std::string text = std::string("O1\nG21 G40 G97 S500 M3\nG0 X44. Z2.\n") + row.text + "\nM30\n";
  if (row.control == ToldBy::kLathe) return lathe(text, latheAt(50, 5));
  ControlSettings settings = runAtZero({{"flavour", row.control == ToldBy::kHaas ? 1 : 0}});
  settings.radius_offsets[1] = {2.0, 0.0};
  settings.length_offsets[1] = {50.0, 0.0};
  return {ControlId::kFanucMill, text, settings};
}

TEST(FanucTold, NothingIsTakenInSilence) {
  for (const ToldRow& row : {
           ToldRow{ToldBy::kMill, "G8 P5", "fanuc-003", true},
           {ToldBy::kMill, "G5 P77", "fanuc-003", true},
           {ToldBy::kMill, "G5 P10001", "fanuc-003", true},
           {ToldBy::kMill, "G5.1 Q7", "fanuc-003", true},
           {ToldBy::kMill, "G31 P5 X5. F10.", "fanuc-003", true},
           {ToldBy::kMill, "G33 Z-5. F1. Q400000", "fanuc-003", true},
           {ToldBy::kMill, "G27", "fanuc-no-axis"},
           {ToldBy::kMill, "G28", "fanuc-no-axis"},
           {ToldBy::kMill, "G29", "fanuc-no-axis"},
           {ToldBy::kMill, "G53", "fanuc-no-axis"},
           {ToldBy::kMill, "G60", "fanuc-no-axis"},
           {ToldBy::kMill, "G45 X5.", "fanuc-no-d"},
           {ToldBy::kMill, "G43 Z5.", "fanuc-no-h"},
           {ToldBy::kMill, "G81 Z-5. R1. P500 F100.", "fanuc-unused-word"},
           {ToldBy::kMill, "G68 X5. Y5. Z5. R30.", "fanuc-unused-word"},
           {ToldBy::kLathe, "G10 P0 X1. R5.", "fanuc-unused-word"},
           {ToldBy::kLathe, "T12345", "fanuc-003", true},
           {ToldBy::kLathe, "G50 X5. U3.", "fanuc-009", true},
           {ToldBy::kLathe, "G50", "fanuc-missing-data", true},
           {ToldBy::kLathe, "G76 P010045 Q100 R.05", "fanuc-thread-angle"},
           {ToldBy::kLathe, "G32 Z-20. F1. Q400000", "fanuc-003", true},
           {ToldBy::kLathe, "G92 X39. Z-20. F1. Q400000", "fanuc-003", true},
           {ToldBy::kLathe, "G41 X50. D3", "fanuc-unused-word"},
           {ToldBy::kLathe, "G70 P10 Q20 U1.\nN10 G0 X20.\nN20 G1 Z-20. F.1", "fanuc-unused-word"},
           {ToldBy::kLathe, "G83 Z-10. R-1. Q3000 F.1", "fanuc-point"},
           {ToldBy::kHaas, "G13 I10. Z-2. D1 F100. Q5.", "fanuc-unused-word"},
           {ToldBy::kHaas, "G103 P5", "fanuc-noted"},
           {ToldBy::kHaas, "G187 P2 E.01", "fanuc-noted"},
       }) {
    const IsoRun run = toldRun(row);
    if (row.error) {
      EXPECT_EQ(run.error(), row.code) << row.text << ": " << run.message();
    } else {
      EXPECT_EQ(run.error(), "") << row.text << ": " << run.message();
      EXPECT_TRUE(run.tells(row.code)) << row.text;
    }
  }
  EXPECT_NE(toldRun({ToldBy::kLathe, "G50", ""}).message().find("G50"), std::string::npos);
  EXPECT_FALSE(toldRun({ToldBy::kHaas, "G103 P5", ""}).tells("fanuc-unused-word")) << "the note is for P too";
}

/// fan-6-G10L50: choices that are one bit of a parameter leave the other bits alone.
TEST(FanucTold, ParametersOfOneBit) {
  const auto motions = [](const std::string& text) {
    const IsoRun run(ControlId::kFanucMill, "O1\nG21 G90 G17\n" + text + "\nM30\n", runAtZero());
    EXPECT_EQ(run.error(), "") << text << run.message();
    return run.motions();
  };
  // 3401#0 DPI: 1 is the rule of a calculator.
  EXPECT_EQ(motions("G10 L52\nN3401 Q0 R0\nG11\nG0 X5"), (Lines{"R 0.005 0 0"}));
  EXPECT_EQ(motions("G10 L52\nN3401 R00000000\nG11\nG10 L52\nN3401 R00000001\nG11\nG0 X5"),
            (Lines{"R 5 0 0"}));
  // 1401#1 LRP: straight rapids or dog legs.
  EXPECT_EQ(motions("G10 L52\nN1401 Q4 R1\nG11\nG0 X5. Y5."), (Lines{"R 5 5 0"}));
  // 5200#0: G84 is rigid without M29; #5 is another choice.
  const IsoRun rigid(ControlId::kFanucMill,
                     "O1\nG21 G90 G17 S500\nG10 L52\nN5200 R00000001\nG11\nG84 X5. Z-5. R2. Q4. F500.\nM30\n",
                     runAtZero());
  EXPECT_EQ(rigid.error(), "") << rigid.message();
  EXPECT_EQ(rigid.motions(),
            (Lines{"R 5 0 0", "R 5 0 2", "T 5 0 -2", "T 5 0 -1.5", "T 5 0 -5", "T 5 0 2", "R 5 0 0"}));
}

TEST(FanucTold, ModesOfLookAheadStay) {
  for (const char* text : {"G8 P1", "G8 P0", "G5 P10000", "G5 P0", "G5.1 Q1", "G5.1 Q0", "G31 P4 X5. F10."})
    EXPECT_EQ(toldRun({ToldBy::kMill, text, ""}).error(), "") << text;
}

}  // namespace
}  // namespace proveout::test
