// Lists of passes for stacks of leaves, and the tree over the cutters, against looking at every pass.
#include "removal/cut/leaf_stacks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <random>

#include "removal/cut/cut_record.h"
#include "tests/unit/removal/cut_fixture.h"

namespace proveout {
namespace {

using test::tool;

/// Random short lines of a ball over a blank.
class LeafStacksTest : public ::testing::Test {
 protected:
  void SetUp() override {
    Progress progress;
    RemovalOptions options;
    options.resolution_mm = 0.5;
    stock_ = Stock::create(BoxShape{{0, 0, -10}, {31, 22, 0}}, options, progress).value();
    record_.tools.try_emplace(1, tool("1=ball:4"));
  }

  void addLines(std::uint32_t count) {
    const ToolParts::Part& cutter = record_.tools.at(1).parts.front();
    std::mt19937 engine(5);
    const auto random = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(engine);
    };
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3 from(random(-4, 35), random(-4, 26), random(-9, 1));
      Pass pass;
      pass.motion = i;
      pass.body = SweptBody(*cutter.profile,
                            LineBody(columnLine(cutter.columns, from,
                                                from + Vec3(random(-2, 2), random(-2, 2), random(-1, 1)))));
      record_.table.passes.push_back(pass);
    }
  }

  /// Whether a pass covers one of the 9x9 columns of a stack below a height.
  bool covers(const Pass& pass, const Coord& origin, double height) const {
    std::array<double, kMaxColumns> x{}, y{}, lo{}, hi{};
    for (int i = 0; i < 81; ++i) {
      const Vec3 at = stock_.inside().position(origin.offsetBy(i % 9, i / 9, 0));
      x[static_cast<std::size_t>(i)] = at.x(), y[static_cast<std::size_t>(i)] = at.y();
    }
    pass.body.columns(x.data(), y.data(), 81, lo.data(), hi.data());
    return *std::min_element(lo.begin(), lo.begin() + 81) < height;
  }

  std::map<Coord, StackList> listsOf(LeafStacks& stacks) {
    std::map<Coord, StackList> lists;
    std::mutex mutex;
    stacks.visit(
        record_.table, [] { return false; },
        [&](const Coord& origin, const StackList& list) {
          const std::lock_guard lock(mutex);
          EXPECT_TRUE(lists.emplace(origin, list).second) << "twice";
        });
    return lists;
  }

  Stock stock_;
  CutRecord record_;
};

bool holds(const StackList& list, std::uint32_t pass) {
  return std::any_of(list.begin(), list.end(), [&](const StackReach& reach) { return reach.pass == pass; });
}

TEST_F(LeafStacksTest, EachStackHasThePassesThatReachIntoIt) {
  addLines(400);
  LeafStacks stacks(stock_.inside(), std::numeric_limits<float>::infinity());
  const auto lists = listsOf(stacks);
  EXPECT_EQ(lists.size(), stacks.count());
  std::size_t listed = 0, reaching = 0;
  for (const auto& [origin, list] : lists) {
    listed += list.size();
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end(),
                               [](const StackReach& a, const StackReach& b) { return a.pass < b.pass; }));
    for (std::uint32_t i = 0; i < 400; ++i) {
      if (!covers(record_.table.passes[i], origin, 1e9)) continue;
      ++reaching;
      EXPECT_TRUE(holds(list, i)) << i;
    }
  }
  EXPECT_GT(reaching, 1000u);
  EXPECT_LT(listed, 2 * reaching);
}

TEST_F(LeafStacksTest, AHeightLeavesOutStacksAndPassesAboveIt) {
  addLines(400);
  constexpr double kHeight = -6.0;
  LeafStacks all(stock_.inside(), std::numeric_limits<float>::infinity()),
      one(stock_.inside(), LeafStacks::kNone);
  const Coord asked = all.low().offsetBy(16, 24, 0);
  one.raise(one.number(asked), static_cast<float>(kHeight));
  const auto lists = listsOf(one);
  ASSERT_EQ(lists.size(), 1u);
  ASSERT_EQ(lists.begin()->first, asked);
  const StackList& list = lists.begin()->second;
  EXPECT_LT(list.size(), listsOf(all).at(asked).size());
  for (std::uint32_t i = 0; i < 400; ++i) {
    EXPECT_TRUE(!covers(record_.table.passes[i], asked, kHeight) || holds(list, i)) << i;
  }
}

TEST_F(LeafStacksTest, TheTreeOverManyCuttersFindsTheNearest) {
  addLines(9000);
  const CutterIndex& index = record_.cutters();
  std::mt19937 engine(6);
  std::uniform_real_distribution<double> random(-20.0, 45.0);
  int outside = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3 p(random(engine), random(engine), -0.5 * random(engine));
    const MotionId end = i % 2 == 0 ? 9000 : 3000;
    double nearest = std::numeric_limits<double>::infinity();
    for (MotionId m = 0; m < end; ++m)
      nearest = std::min(nearest, record_.table.passes[m].body.field().distance(p, nearest));
    const CutterIndex::Near found = index.nearest(p, end, std::numeric_limits<double>::infinity());
    if (nearest < 0.0) {
      EXPECT_LT(found.distance, 0.0);
    } else {
      EXPECT_NEAR(found.distance, nearest, 2 * kSweepToleranceMm);
      ++outside;
    }
  }
  EXPECT_GT(outside, 10);
}

/// Every leaf here is in reach of some thousand motions: lists of them would take ten times the memory
/// allowed.
TEST(DensePath, NeedsNoMemoryForEachLeafAndMotion) {
  test::PathMaker path;
  Vec3 at(0, 0, -3);
  for (int line = 0; line <= 160; ++line) {
    for (int i = 1; i <= 200; ++i) {
      const Vec3 to((line % 2 == 0 ? i : 200 - i) * 0.1, line * 0.125, -3 + 0.2 * std::sin(0.05 * i));
      path.line(at, to);
      at = to;
    }
  }
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = 0.1;
  options.max_memory_gb = 0.03;
  auto stock = Stock::create(BoxShape{{0, 0, -5}, {20, 20, 0}}, options, progress);
  ASSERT_TRUE(stock.ok());
  const auto summary = stock->remove(path.path(), {tool("1=ball:6")}, options, progress);
  ASSERT_TRUE(summary.ok()) << summary.error().message;
}

}  // namespace
}  // namespace proveout
