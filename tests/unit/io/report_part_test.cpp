// Characteristics of the part as a whole, and setup sheets, as the report tells them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/report/report_page.h"

namespace proveout {
namespace {

using testing::HasSubstr;
using testing::Not;

Report partReport() {
  Report report;
  report.name = "part";
  ReportCharacteristic wall;
  wall.name = "wall thickness";
  wall.label = "rib <left>";
  wall.unit = "mm";
  wall.measured = 1.25;
  wall.where = Vec3(1, 2, 3);
  wall.lower = 1.5;
  wall.verdict = "fail";
  ReportCharacteristic crest;
  crest.name = "scallop height";
  crest.unit = "mm";
  crest.upper = 0.01;
  crest.verdict = "pass";
  report.part_characteristics = {wall, crest};
  return report;
}

TEST(ReportOfAPart, JsonTellsValuesAndLimits) {
  const auto json = nlohmann::json::parse(reportJson(partReport()));
  const auto& rows = json.at("part_characteristics");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].at("name"), "wall thickness");
  EXPECT_EQ(rows[0].at("measured"), 1.25);
  EXPECT_EQ(rows[0].at("least"), 1.5);
  EXPECT_FALSE(rows[0].contains("most"));
  EXPECT_EQ(rows[0].at("at"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(rows[0].at("verdict"), "fail");
  EXPECT_TRUE(rows[1].at("measured").is_null());
  EXPECT_FALSE(rows[1].contains("at"));
  EXPECT_FALSE(nlohmann::json::parse(reportJson(Report())).contains("part_characteristics"));
}

TEST(ReportOfAPart, PageTellsThemEscaped) {
  const std::string page = reportPage(partReport(), {});
  EXPECT_THAT(page, HasSubstr("The part as a whole"));
  EXPECT_THAT(page, HasSubstr("≥ 1.5 mm"));
  EXPECT_THAT(page, HasSubstr("1.2500 mm"));
  EXPECT_THAT(page, HasSubstr("X1.000 Y2.000 Z3.000"));
  EXPECT_THAT(page, HasSubstr("rib &lt;left&gt;"));
  EXPECT_THAT(page, HasSubstr(">none<"));
  EXPECT_THAT(reportPage(Report(), {}), Not(HasSubstr("The part as a whole")));
}

TEST(ReportOfAComparison, SpeaksOfNoProgram) {
  Report report;
  EXPECT_THAT(reportPage(report, {}), HasSubstr("cycle time"));
  report.checks.interpreted = false;
  const std::string page = reportPage(report, {});
  EXPECT_THAT(page, Not(HasSubstr("cycle time")));
  EXPECT_THAT(page, Not(HasSubstr("<span>motions</span>")));
}

TEST(SetupSheetOfThePage, HasLinesToolsAndPictures) {
  PageContent content;
  SetupSheet sheet;
  sheet.setup = "first <side>";
  sheet.program = "a.nc";
  sheet.lines = {{"Blank", "box 60 x 40 x 10 mm"}};
  sheet.tools = {{3, "mill", "flat 10", 62.5, "H3 = 1.000", "D3 = 5.000"}};
  sheet.before = "PNG";
  content.sheets = {sheet};
  const std::string page = reportPage(Report(), content);
  EXPECT_THAT(page, HasSubstr("Setup sheet: first &lt;side&gt;"));
  EXPECT_THAT(page, HasSubstr("box 60 x 40 x 10 mm"));
  EXPECT_THAT(page, HasSubstr("H3 = 1.000"));
  EXPECT_THAT(page, HasSubstr("D3 = 5.000"));
  EXPECT_THAT(page, HasSubstr("62.500"));
  EXPECT_THAT(page, HasSubstr("clamped, with fixtures"));
  EXPECT_THAT(page, Not(HasSubstr("when the program has run")));
}

}  // namespace
}  // namespace proveout
