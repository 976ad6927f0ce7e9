// Stocks of which only a window is built tell the touches of tools in it as whole ones do.
#include <random>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

struct Watched {
  std::string name;
  StockShape shape;
};

std::vector<Watched> plates() {
  return {{"plate", BoxShape{{-60, -50, -30}, {70, 60, -2}}},
          {"wall", BoxShape{{4, -50, -30}, {9, 60, 12}}},
          {"table", CylinderShape{2, {3, 2, -25}, 60, 0, 22}},
          {"ring", CylinderShape{2, {0, 0, -9}, 55, 8, 8}},
          {"bar along X", CylinderShape{0, {-70, 3, -4}, 6, 0, 150}},
          {"tube along Y", CylinderShape{1, {2, -80, -6}, 9, 4, 160}}};
}

Toolpath randomPath(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> side(-12, 12), height(-8, 6);
  PathMaker p;
  Vec3 at(side(random), side(random), 20);
  for (int i = 0; i < 6; ++i) {
    const Vec3 to(side(random), side(random), height(random));
    p.line(at, to, i % 2 == 0 ? MotionKind::kRapid : MotionKind::kFeed);
    at = to;
  }
  return p.path();
}

std::vector<Contact> touches(const StockShape& shape, const Toolpath& path, const Tool& tool,
                             const std::optional<Box3>& window) {
  RemovalOptions options;
  options.resolution_mm = 0.5;
  options.watch_all = true;
  options.window = window;
  Progress progress;
  Result<Stock> stock = Stock::create(shape, options, progress);
  EXPECT_TRUE(stock.ok());
  const Result<RemovalSummary> removed = stock->remove(path, {tool}, options, progress);
  EXPECT_TRUE(removed.ok());
  return removed->contacts;
}

class Window : public testing::TestWithParam<unsigned> {};

TEST_P(Window, TellsTheTouchesOfTheWhole) {
  const Tool cutter = tool(GetParam() % 2 == 0 ? "1=ball:6" : "1=drill:5:118");
  const Toolpath path = randomPath(GetParam());
  // What the tool reaches, and eight cells more.
  const Box3 window{{-19, -19, -12}, {19, 19, 2000}};
  for (const Watched& w : plates()) {
    SCOPED_TRACE(w.name);
    const std::vector<Contact> whole = touches(w.shape, path, cutter, std::nullopt),
                               part = touches(w.shape, path, cutter, window);
    ASSERT_EQ(part.size(), whole.size());
    for (std::size_t i = 0; i < part.size(); ++i) {
      EXPECT_EQ(part[i].kind, whole[i].kind);
      EXPECT_EQ(part[i].motion, whole[i].motion);
      EXPECT_EQ(part[i].last, whole[i].last);
      EXPECT_NEAR(part[i].depth_mm, whole[i].depth_mm, 1e-9);
      EXPECT_LT((part[i].where - whole[i].where).norm(), 1e-9);
      EXPECT_NEAR(part[i].volume_mm3, whole[i].volume_mm3, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, Window, testing::Range(1u, 13u));

TEST(WindowTest, LeavesOutWhatLiesBeyond) {
  PathMaker p;
  p.line({0, 0, 5}, {0, 0, -5});
  const Tool cutter = tool("1=flat:10");
  const BoxShape plate{{-60, -50, -30}, {70, 60, -2}};
  EXPECT_EQ(touches(plate, p.path(), cutter, Box3{{-13, -13, -13}, {13, 13, 20}}).size(), 1u);
  EXPECT_TRUE(touches(plate, p.path(), cutter, Box3{{30, 30, -13}, {40, 40, 20}}).empty());
}

}  // namespace
}  // namespace proveout::test
