// What every program of LinuxCNC has.
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

TEST(LinuxCnc, RunsAProgram) {
  const IsoRun run(ControlId::kLinuxCnc,
                   "%\nN10 G21 G90 G17\nG0 X10 Y0\nG1 Z-1 F100\nG2 X20 Y-10 I0 J-10\nM2\n%\n");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"R 10 0 0", "F 10 0 -1", "A 20 -10 -1 c 10 -10 -1 -90"}));
}

}  // namespace
}  // namespace proveout::test
