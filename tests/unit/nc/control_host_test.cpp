#include "core/nc/control_host.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

TEST(MemoryOutput, EmptiesOrGoesOn) {
  MemoryOutput out;
  EXPECT_FALSE(out.exists("a"));
  ASSERT_TRUE(out.open("a", false).ok());
  EXPECT_TRUE(out.write("one").ok());
  EXPECT_TRUE(out.close().ok());
  EXPECT_TRUE(out.exists("a"));
  ASSERT_TRUE(out.open("a", true).ok());
  EXPECT_TRUE(out.write("two").ok());
  EXPECT_EQ(out.files().at("a"), "onetwo");
  ASSERT_TRUE(out.open("a", false).ok());
  EXPECT_EQ(out.files().at("a"), "");
}

TEST(MemoryOutput, RefusesToGrowBeyondItsLimit) {
  MemoryOutput out(8);
  ASSERT_TRUE(out.open("a", false).ok());
  EXPECT_TRUE(out.write("12345678").ok());
  const Status full = out.write("9");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().kind, ErrorKind::kResourceLimit);
  ASSERT_TRUE(out.open("a", false).ok());  // emptied: there is room again
  EXPECT_TRUE(out.write("9").ok());
  ASSERT_TRUE(out.close().ok());
  EXPECT_FALSE(out.write("x").ok());
}

}  // namespace
}  // namespace proveout
