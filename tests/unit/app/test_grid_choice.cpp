// The spacing that nobody asked for.
#include <gtest/gtest.h>

#include "app/session/machining/grid_choice.h"

namespace proveout {
namespace {

/// A run that cuts one thread of that lead, mm.
RunResult threadOf(double lead) {
  Motion thread;
  thread.kind = MotionKind::kThread;
  thread.to = Vec3(0, 0, -20);
  thread.spindle = 100;
  thread.feed = lead * thread.spindle;
  RunResult run;
  run.setups.emplace_back().interpreted.path.motions.push_back(thread);
  return run;
}

TEST(GridChoice, FiveSamplesHoldTheLeadOfAThread) {
  EXPECT_EQ(threadResolution(RunResult(), 0.5), 0.5);
  EXPECT_EQ(threadResolution(threadOf(2.5), 0.5), 0.5);
  EXPECT_DOUBLE_EQ(threadResolution(threadOf(2.4), 0.5), 0.2);
  EXPECT_DOUBLE_EQ(threadResolution(threadOf(0.35), 0.2), 0.05) << "finer than 0.1 mm";
  EXPECT_DOUBLE_EQ(threadResolution(threadOf(0.001), 0.5), 0.05) << "a tenth is the end";
}

}  // namespace
}  // namespace proveout
