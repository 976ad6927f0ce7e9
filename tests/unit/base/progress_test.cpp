#include "core/base/progress.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

TEST(Progress, PartsAreCancelledWithTheWholeOrAlone) {
  Progress whole;
  Progress first(&whole), second(&whole);
  EXPECT_FALSE(first.cancelled());
  first.cancel();
  EXPECT_TRUE(first.cancelled());
  EXPECT_FALSE(whole.cancelled());
  EXPECT_FALSE(second.cancelled());
  whole.cancel();
  EXPECT_TRUE(second.cancelled());
}

}  // namespace
}  // namespace proveout
