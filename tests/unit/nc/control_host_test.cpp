#include "core/nc/control/control_host.h"

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

TEST(MemoryOutput, RefusesMoreFilesThanAnyoneMeasures) {
  MemoryOutput out;
  for (int k = 0; k < 1000; ++k) ASSERT_TRUE(out.open(std::to_string(k), false).ok()) << k;
  const Status more = out.open("1000", false);
  ASSERT_FALSE(more.ok());
  EXPECT_EQ(more.error().kind, ErrorKind::kResourceLimit);
  EXPECT_NE(more.error().message.find("1000 files"), std::string::npos) << more.error().message;
  EXPECT_TRUE(out.open("999", true).ok());  // those that are there can be gone on with
  EXPECT_EQ(out.files().size(), 1000u);
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
