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

}  // namespace
}  // namespace proveout::test
