#include "io/report/profile_chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "profile_fixtures.h"

namespace proveout {
namespace {

using io_test::gougedLoop;
using io_test::shaftLoop;
using io_test::turned;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The numbers of the first match's groups.
std::vector<double> numbers(const std::string& text, const char* pattern) {
  std::smatch match;
  std::vector<double> found;
  if (!std::regex_search(text, match, std::regex(pattern))) return found;
  for (std::size_t i = 1; i < match.size(); ++i) found.push_back(std::stod(match[i]));
  return found;
}

/// Every point of a path's data.
std::vector<Vec2> points(const std::string& data) {
  std::vector<Vec2> found;
  const std::regex point("[ML]([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator it(data.begin(), data.end(), point), end; it != end; ++it)
    found.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  return found;
}

std::string pathOf(const std::string& svg, const std::string& attribute) {
  std::smatch match;
  const std::regex path("<path " + attribute + "[^>]* d=\"([^\"]*)\"");
  return std::regex_search(svg, match, path) ? match[1].str() : std::string();
}

TEST(ProfileChart, SaysTheGougeAndWhereItIs) {
  const TriMesh nominal = turned(shaftLoop(), 96);
  const ProfileChart chart = drawProfileChart({gougedLoop()}, halfSection(nominal), {"shaft"});
  const auto gouge =
      numbers(chart.file, "largest gouge ([0-9.]+) mm at z ([-0-9.]+), r ([0-9.]+) \\(allowed ([0-9.]+)");
  ASSERT_EQ(gouge.size(), 4u);
  EXPECT_NEAR(gouge[0], 0.05, 1e-4);
  EXPECT_GE(gouge[1], 11.0);
  EXPECT_LE(gouge[1], 13.0);
  EXPECT_NEAR(gouge[2], 9.95, 1e-9);
  EXPECT_EQ(gouge[3], 0.02);
  EXPECT_TRUE(has(chart.file, ">over tolerance:<"));
  // 5 % of 15 mm over 0.05 mm is 15: the next lower of 1, 2, 5, 10.
  EXPECT_TRUE(has(chart.file, "deviations \u00d7 10<"));
  EXPECT_FALSE(has(chart.file, "cut off"));
  EXPECT_FALSE(has(chart.file, "stretched"));
}

/// The gouge's band goes from the profile inwards, ten times as deep as the gouge, over the groove's width.
TEST(ProfileChart, DrawsTheGougeMagnified) {
  const ProfileChart chart =
      drawProfileChart({gougedLoop()}, halfSection(turned(shaftLoop(), 96)), {"shaft"});
  const auto metal = points(pathOf(chart.file, "fill=\"#e3e7ea\""));
  ASSERT_EQ(metal.size(), 10u);
  const double scale = (metal[9] - metal[0]).norm() / 40.0;  // user units a mm, from the axis
  const auto band = points(pathOf(chart.file, "class=\"gouge\""));
  ASSERT_GT(band.size(), 8u);
  Vec2 least = band[0], most = band[0];
  for (const Vec2& p : band) {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  EXPECT_NEAR((most.x() - least.x()) / scale, 2.0, 0.15);
  const double axis_y = metal[0].y();
  EXPECT_NEAR((axis_y - most.y()) / scale, 9.95 - 0.5, 0.01);  // towards the axis
  EXPECT_NEAR((axis_y - least.y()) / scale, 10.0, 0.051);
  EXPECT_TRUE(pathOf(chart.file, "class=\"excess\"").empty());
}

TEST(ProfileChart, GoodPartIsWithinTolerance) {
  const ProfileChart chart = drawProfileChart({shaftLoop()}, halfSection(turned(shaftLoop(), 96)), {"shaft"});
  EXPECT_TRUE(has(chart.file, ">within tolerance:<"));
  EXPECT_TRUE(has(chart.file, "largest gouge 0.0000 mm (allowed 0.02)"));
  EXPECT_TRUE(pathOf(chart.file, "class=\"gouge\"").empty());
  EXPECT_FALSE(has(chart.file, "<circle"));
}

TEST(ProfileChart, LargeExcessIsCutOffAndSaidSo) {
  std::vector<Vec2> bar = gougedLoop();
  bar[8].x() = bar[7].x() = 24;  // not turned yet
  const ProfileChart chart = drawProfileChart({bar}, halfSection(turned(shaftLoop(), 96)), {"shaft"});
  EXPECT_TRUE(has(chart.file, "cut off at 1 mm"));  // 20 times the larger tolerance
  const auto excess = numbers(chart.file, "largest excess ([0-9.]+) mm");
  ASSERT_EQ(excess.size(), 1u);
  EXPECT_NEAR(excess[0], 9.0, 1e-3);
}

TEST(ProfileChart, LongShaftsAreStretchedAndSaidSo) {
  const std::vector<Vec2> bar{{0, 0}, {2, 0}, {2, 200}, {0, 200}};
  const ProfileChart chart = drawProfileChart({bar}, {}, {"bar"});
  const auto stretch = numbers(chart.file, "r stretched ([0-9.]+) times");
  ASSERT_EQ(stretch.size(), 1u);
  const auto metal = points(pathOf(chart.file, "fill=\"#e3e7ea\""));
  ASSERT_EQ(metal.size(), 4u);
  const double scale_z = (metal[2].x() - metal[1].x()) / 200, scale_r = (metal[0].y() - metal[1].y()) / 2;
  EXPECT_NEAR(scale_r / scale_z, stretch[0], 0.01 * stretch[0]);
  EXPECT_TRUE(has(chart.file, "no nominal"));
  const std::vector<Vec2> disc{{0, 0}, {200, 0}, {200, 2}, {0, 2}};
  EXPECT_TRUE(has(drawProfileChart({disc}, {}, {"disc"}).file, "z stretched"));
}

TEST(ProfileChart, ShowsBlankToolsAndBlocks) {
  const std::vector<Vec2> part{{0, 0}, {10, 0}, {10, 40}, {0, 40}};
  ProfileChartOptions options;
  options.blank = {{{0, -60}, {11, -60}, {11, 40.5}, {0, 40.5}}};
  options.marks = {{{10, 20}, "N12"}, {{10, 20.2}, "N13"}};
  options.tools = {{{{9, 30}, {19, 30}, {19, 45}, {9, 45}}, "T<2>"}};
  const ProfileChart chart = drawProfileChart({part}, {}, options);
  const auto metal = points(pathOf(chart.file, "fill=\"#e3e7ea\""));
  ASSERT_EQ(metal.size(), 4u);
  const double scale = (metal[2].x() - metal[1].x()) / 40;
  EXPECT_TRUE(has(chart.file, "stroke=\"#7b858d\""));  // its outline, without a nominal too
  const auto blank = points(pathOf(chart.file, "fill=\"none\" stroke=\"#8a949c\""));
  ASSERT_EQ(blank.size(), 4u);
  EXPECT_NEAR((metal[1].y() - blank[1].y()) / scale, 1.0, 0.01);  // 1 mm larger
  EXPECT_NEAR((blank[2].x() - metal[2].x()) / scale, 0.5, 0.01);
  EXPECT_NEAR((metal[1].x() - blank[1].x()) / scale, 4.0,
              0.01);  // no more than a tenth of the part beside it
  const auto tool = points(pathOf(chart.file, "fill=\"#b7791f\" fill-opacity=\".25\""));
  ASSERT_EQ(tool.size(), 4u);
  EXPECT_NEAR((metal[1].y() - tool[0].y()) / scale, -1.0, 0.01);
  EXPECT_TRUE(has(chart.file, "T&lt;2&gt;<"));
  // Labels do not lie over each other.
  const char* label = "<text x=\"[-0-9.]+\" y=\"([-0-9.]+)\" style=\"fill:#8f2415;font-weight:600\">";
  const auto first = numbers(chart.file, (std::string(label) + "N12<").c_str()),
             second = numbers(chart.file, (std::string(label) + "N13<").c_str());
  ASSERT_TRUE(first.size() == 1 && second.size() == 1);
  EXPECT_GE(std::abs(first[0] - second[0]), 13.0);
  options.marks[0].at.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(drawProfileChart({part}, {}, options).file.empty());
}

TEST(ProfileChart, NamesAreEscaped) {
  ProfileChartOptions options;
  options.name = "<script>\"A&B\"</script>";
  const ProfileChart chart = drawProfileChart({shaftLoop()}, {}, options);
  for (const std::string* svg : {&chart.page, &chart.file}) {
    EXPECT_FALSE(has(*svg, "<script>"));
    EXPECT_TRUE(has(*svg, "&lt;script&gt;"));
    EXPECT_TRUE(has(*svg, "A&amp;B"));
    EXPECT_TRUE(has(*svg, "</svg>"));
  }
  EXPECT_FALSE(has(chart.page, "<style"));  // the page has its own
}

TEST(ProfileChart, EmptyWhereThereIsNothingToDraw) {
  const auto drawn = [](const std::vector<std::vector<Vec2>>& loops,
                        const ProfileChartOptions& options = {}) {
    const ProfileChart chart = drawProfileChart(loops, {}, options);
    EXPECT_EQ(chart.page.empty(), chart.file.empty());
    return !chart.file.empty();
  };
  EXPECT_TRUE(drawn({shaftLoop()}));
  EXPECT_FALSE(drawn({}));
  EXPECT_FALSE(drawn({{}}));
  EXPECT_FALSE(drawn({{Vec2(0, 0), Vec2(0, 5), Vec2(0, 10)}}));  // on the axis
  std::vector<Vec2> broken = shaftLoop();
  broken[1].x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(drawn({broken}));
  EXPECT_FALSE(drawn({{Vec2(-1, 0), Vec2(3, 0), Vec2(3, 5)}}));
  ProfileChartOptions negative;
  negative.gouge_mm = -1;
  EXPECT_FALSE(drawn({shaftLoop()}, negative));
}

}  // namespace
}  // namespace proveout
