#include "core/tool/tool_table.h"

#include <gtest/gtest.h>

#include <vector>

namespace proveout {
namespace {

std::vector<Tool> numbered(const std::vector<int>& numbers) {
  std::vector<Tool> tools(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    tools[i].number = numbers[i];
    tools[i].diameter = 1.0 + static_cast<double>(i);
  }
  return tools;
}

TEST(ToolTable, FindsToolsByNumber) {
  const std::vector<Tool> tools = numbered({7, 3, 12, 3});
  const ToolTable table(tools);
  EXPECT_EQ(table.find(12), &tools[2]);
  EXPECT_EQ(table.find(3), &tools[1]) << "of two the first";
  EXPECT_EQ(table.find(0), nullptr);
  EXPECT_EQ(table.find(4), nullptr);
}

TEST(ToolTable, TheLowestIsInTheSpindleWhereNoneIsNamed) {
  const std::vector<Tool> tools = numbered({7, 3, 12});
  const ToolTable table(tools);
  EXPECT_EQ(table.unnamed(), &tools[1]);
  EXPECT_EQ(table.ofMotion(0), &tools[1]);
  EXPECT_EQ(table.ofMotion(7), &tools[0]);
  EXPECT_EQ(table.ofMotion(4), nullptr) << "a number that is named is meant";
}

TEST(ToolTable, AToolMayHaveTheNumber0) {
  const std::vector<Tool> tools = numbered({7, 0});
  EXPECT_EQ(ToolTable(tools).ofMotion(0), &tools[1]);
}

TEST(ToolTable, WithoutToolsThereIsNone) {
  const std::vector<Tool> none;
  EXPECT_EQ(ToolTable(none).unnamed(), nullptr);
  EXPECT_EQ(ToolTable(none).ofMotion(0), nullptr);
}

TEST(ToolTable, GaugesAreSeenFromTheControlPoint) {
  Tool mill;
  mill.gauge_length = 120.0;
  EXPECT_EQ(gaugeOf(mill), Vec3(0.0, 0.0, 120.0));
  Tool lathe;
  lathe.insert.emplace();
  EXPECT_EQ(gaugeOf(lathe), Vec3(0.0, 0.0, 0.0));
  lathe.insert->gauge = Vec2(50.0, 30.0);
  EXPECT_EQ(gaugeOf(lathe), Vec3(50.0, 0.0, 30.0));
}

}  // namespace
}  // namespace proveout
