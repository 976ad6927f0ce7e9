// Chamfers and corners of lathes by I, K, C and R. fan-3-chamfer fan-3-corner fan-3-cornererr
#include <gtest/gtest.h>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

IsoRun cornerRun(const std::string& text) {
  return lathe("G21 G98 F100.\n" + text + "\nM30\n", latheAt(20, 0));
}

TEST(FanucPlainCorners, StandBetweenBlocksAtRightAngles) {
  EXPECT_EQ(turned(cornerRun("G1 Z-20. R3.\nX40.")), (Lines{"F 20 -17", "A 26 -20", "F 40 -20"}));
  EXPECT_EQ(turned(cornerRun("G1 Z-20. I3.\nX40.")), (Lines{"F 20 -17", "F 26 -20", "F 40 -20"}));
  EXPECT_EQ(turned(cornerRun("G1 Z-20. I-3.\nX4.")), (Lines{"F 20 -17", "F 14 -20", "F 4 -20"}));
  EXPECT_EQ(turned(cornerRun("G1 X40. K-2.\nZ-20. C2.\nX60.")),
            (Lines{"F 36 0", "F 40 -2", "F 40 -18", "F 44 -20", "F 60 -20"}));
}

TEST(FanucPlainCorners, AreRefusedWhereTheyDoNotFit) {
  struct Row {
    const char *text, *code;
  };
  for (const Row& row : {Row{"G1 Z-20. R-3.\nX40.", "fanuc-052"},
                         {"G1 X40. K-2.\nX50. Z-20.", "fanuc-052"},
                         {"G1 X40. K-2.\nG2 X50. Z-5. R5.", "fanuc-052"},
                         {"G1 X40. Z-5. R2.\nX50.", "fanuc-054"},
                         {"G1 Z-20. K3.\nX40.", "fanuc-009"},
                         {"G1 X40. I3.\nZ-20.", "fanuc-009"},
                         {"G1 X40. K-2. R3.\nZ-20.", "fanuc-053"},
                         {"G1 X40. ,R2. R3.\nZ-20.", "fanuc-053"},
                         {"G1 X20. R3.\nZ-20.", "fanuc-055"},
                         {"G1 X40. R0\nZ-20.", "fanuc-055"},
                         {"G1 X40. R-15.\nZ-20.", "fanuc-055"},
                         {"G1 X40. K-2.", "fanuc-051"}})
    EXPECT_EQ(cornerRun(row.text).error(), row.code) << row.text;
}

}  // namespace
}  // namespace proveout::test
