// What makes a tool impossible, told with the tool's number and the field; the command line's short form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/tool/drawings.h"

namespace proveout::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Tool drawn(const std::string& name) {
  for (const Drawing& d : drawings(1)) {
    if (d.name == name) return d.tool;
  }
  ADD_FAILURE() << name;
  return {};
}

/// The message for the drawn tool after a change; empty if it is good.
template <typename Change>
std::string refusal(const std::string& name, Change&& change) {
  Tool tool = drawn(name);
  tool.number = 7;
  change(tool);
  const Status status = validateTool(tool);
  return status.ok() ? "" : status.error().message;
}

testing::Matcher<std::string> says(const std::string& what) {
  return AllOf(StartsWith("tool 7: "), HasSubstr(what));
}

TEST(ToolCheck, LengthsOfEveryFieldAreChecked) {
  const double bad[] = {-1.0, 2e5, std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()};
  const auto check = [&](const char* name, double Tool::*field, const char* what) {
    for (const double value : bad) {
      EXPECT_THAT(refusal(name, [&](Tool& t) { t.*field = value; }), says(what)) << name << " " << value;
    }
  };
  check("T-slot", &Tool::diameter, "diameter");
  check("T-slot", &Tool::cutter_height, "thickness");
  check("T-slot", &Tool::neck_diameter, "neck_diameter");
  check("T-slot", &Tool::neck_length, "neck_length");
  check("T-slot", &Tool::overall_length, "overall_length");
  check("T-slot", &Tool::shank_diameter, "shank_diameter");
  check("dovetail", &Tool::cutter_height, "height");
  check("dovetail", &Tool::dovetail_angle_deg, "dovetail_angle");
  check("dovetail", &Tool::corner_radius, "corner_radius");
  check("taper ball", &Tool::tip_diameter, "tip diameter");
  check("taper ball", &Tool::cone_angle_deg, "the taper's included angle");
  check("taper ball", &Tool::flute_length, "flute_length");
  check("lollipop", &Tool::neck_diameter, "neck_diameter");
  check("thread mill, full form", &Tool::pitch, "pitch");
  check("thread mill, full form", &Tool::thread_angle_deg, "thread_angle");
  check("thread mill, full form", &Tool::crest_flat, "crest_flat");
  check("thread mill, full form", &Tool::root_diameter, "root_diameter");
}

TEST(ToolCheck, TaperBallsAndDovetailsThatDoNotFit) {
  EXPECT_THAT(refusal("taper ball", [](Tool& t) { t.diameter = 1.9; }),
              says("where the ball meets the taper"));
  EXPECT_THAT(refusal("taper ball", [](Tool& t) { t.flute_length = 0.5; }),
              says("shorter than the ball end"));
  EXPECT_THAT(refusal("taper ball", [](Tool& t) { t.neck_diameter = 1; }), says("has no neck_diameter"));
  EXPECT_THAT(refusal("dovetail", [](Tool& t) { t.dovetail_angle_deg = 90; }), says("below 90 degrees"));
  EXPECT_THAT(refusal("dovetail", [](Tool& t) { t.cutter_height = 10; }),
              says("neck_diameter must be at most 0 mm"));
  // 10 - 2 x 4 / tan 60 deg.
  EXPECT_THAT(refusal("dovetail", [](Tool& t) { t.neck_diameter = 6; }), says("at most 5.3812 mm"));
  EXPECT_THAT(refusal("dovetail", [](Tool& t) { t.corner_radius = 3; }), says("corner_radius does not fit"));
  EXPECT_THAT(refusal("dovetail", [](Tool& t) { t.flute_length = 4; }), says("has no flute_length"));
}

TEST(ToolCheck, ToolsShorterThanTheirEnds) {
  const auto said = [](const std::string& option, double overall_length, double flute_length) {
    Tool tool = *parseToolOption(option);
    tool.overall_length = overall_length;
    tool.flute_length = flute_length;
    const Status status = validateTool(tool);
    return status.ok() ? "" : status.error().message;
  };
  // Ball and corner by their radius, the drill's point 10 / tan 59 deg = 6.0086, the taper's ball 2 (1 - sin
  // 5 deg).
  for (const auto& [option, height] : std::initializer_list<std::pair<const char*, double>>{
           {"1=ball:20", 10.0}, {"1=bull:20:4", 4.0}, {"1=drill:20", 6.0087}, {"1=taper:4:5:10", 1.8257}}) {
    EXPECT_EQ(said(option, 0.0, 0.0), "");
    EXPECT_EQ(said(option, height, 0.0), "") << option;
    EXPECT_EQ(said(option, 30.0, height), "") << option;
    EXPECT_THAT(said(option, height - 0.001, 0.0), HasSubstr("overall_length is shorter than the")) << option;
    EXPECT_THAT(said(option, 30.0, height - 0.001), HasSubstr("flute_length is shorter than the")) << option;
  }
  // Without any length flutes are 2 m long.
  for (const char* option : {"1=drill:58000", "1=drill:100:1", "1=ball:4001"})
    EXPECT_THAT(parseToolOption(option).error().message, HasSubstr("flute_length is needed")) << option;
  EXPECT_TRUE(parseToolOption("1=ball:4000").ok());
}

TEST(ToolCheck, NecksAndShanksThatDoNotFit) {
  EXPECT_THAT(refusal("T-slot", [](Tool& t) { t.neck_diameter = 12; }), says("below the diameter"));
  EXPECT_THAT(refusal("T-slot", [](Tool& t) { t.neck_diameter = 0; }),
              says("neck_diameter must be at least"));
  EXPECT_THAT(refusal("T-slot", [](Tool& t) { t.corner_radius = 1.6; }), says("half the thickness"));
  EXPECT_THAT(refusal("T-slot", [](Tool& t) { t.overall_length = 2; }),
              says("shorter than the cutting part"));
  EXPECT_THAT(refusal("T-slot", [](Tool& t) { t.shank_diameter = 8; }), says("needs neck_length"));
  EXPECT_THAT(refusal("T-slot", [](Tool& t) { t.neck_length = 8; }), says("needs shank_diameter"));
  const auto shank = [](double neck_length) {
    return [neck_length](Tool& t) {
      t.neck_length = neck_length;
      t.shank_diameter = 8;
      t.overall_length = 40;
    };
  };
  EXPECT_EQ(refusal("T-slot", shank(20)), "");
  EXPECT_THAT(refusal("T-slot", shank(2)), says("ends inside the cutting part"));
  EXPECT_THAT(refusal("T-slot", shank(41)), says("longer than overall_length"));
  EXPECT_THAT(refusal("form with a bulge", [](Tool& t) { t.neck_length = 20; }), says("neck_length needs"));
  EXPECT_THAT(refusal("lollipop", [](Tool& t) { t.neck_diameter = 8; }), says("below the diameter"));
}

TEST(ToolCheck, ThreadMillsThatDoNotFit) {
  const char* const full = "thread mill, full form";
  EXPECT_EQ(refusal(full, [](Tool& t) { t.root_diameter = 0; }), "");  // the same by default
  EXPECT_THAT(refusal(full, [](Tool& t) { t.root_diameter = 6.9; }), says("where the flanks of teeth"));
  EXPECT_THAT(refusal(full, [](Tool& t) { t.root_diameter = 10; }), says("below the diameter"));
  EXPECT_THAT(refusal(full, [](Tool& t) { t.pitch = 12, t.root_diameter = 0; }),
              says("deeper than the tool"));
  EXPECT_THAT(refusal(full, [](Tool& t) { t.crest_flat = 3; }), says("crest_flat must be below the pitch"));
  EXPECT_THAT(refusal(full, [](Tool& t) { t.teeth = 0; }), says("teeth must be between 1 and 200, not 0"));
  EXPECT_THAT(refusal(full, [](Tool& t) { t.teeth = 201; }), says("teeth must be"));
  EXPECT_THAT(refusal(full, [](Tool& t) { t.neck_diameter = 7.5; }), says("between the teeth"));
}

TEST(ToolCheck, ProfilesThatCannotBe) {
  const auto form = [](std::vector<OutlinePoint> points) {
    return refusal("form with a bulge", [&](Tool& t) { t.outline = std::move(points); });
  };
  EXPECT_THAT(form({}), says("at least two points"));
  EXPECT_THAT(form({{4, 1}, {4, 8}}), says("point 1 of the profile must have z = 0"));
  EXPECT_THAT(form({{4, 0, 1}, {4, 8}}), says("point 1 of the profile cannot end an arc"));
  EXPECT_THAT(form({{4, 0}, {4, 8}, {3, 7}}), says("point 3 of the profile is lower"));
  EXPECT_THAT(form({{4, 0}, {0, 4}, {4, 8}}), says("point 2 of the profile lies on the axis"));
  EXPECT_THAT(form({{4, 0}, {4, 0}, {4, 8}}), says("point 2 of the profile is the same"));
  EXPECT_THAT(form({{4, 0}, {3, 0}}), says("no height"));
  EXPECT_THAT(form({{3, 0}, {4, 8, 1}}), says("too far from the one before"));
  EXPECT_THAT(form({{0, 0}, {4, 0.1, 3}}), says("turns back in height"));
  EXPECT_THAT(form({{2, 0}, {4, 0.1, -3}}), says("turns back in height"));
  EXPECT_THAT(form({{-4, 0}, {4, 8}}), says("a radius of the profile"));
  EXPECT_THAT(form({{3, 0}, {3, 8}}), says("diameter is not twice the largest radius"));
  std::vector<OutlinePoint> comb{{4, 0}};
  for (int i = 1; i <= 1002; ++i) comb.push_back({i % 2 ? 3.0 : 4.0, i * 0.1});
  EXPECT_THAT(form(comb), says("more than 500 convex parts"));
  comb.resize(901);
  EXPECT_EQ(form(comb), "");
}

TEST(ToolCheck, TypeNamesGoBothWays) {
  for (const Drawing& d : drawings(1))
    EXPECT_EQ(toolTypeOf(toolTypeName(d.tool.type)), d.tool.type) << d.name;
  EXPECT_FALSE(toolTypeOf("star"));
}

TEST(ToolOption, ParsesShapesWithNecks) {
  const Tool taper = parseToolOption("1=taper:2:5:6").value();
  EXPECT_EQ(taper.type, ToolType::kTaperBall);
  EXPECT_EQ(taper.tip_diameter, 2);
  EXPECT_EQ(taper.cone_angle_deg, 10);
  EXPECT_EQ(taper.diameter, 6);
  const Tool dovetail = parseToolOption("2=dovetail:20:60:8:9").value();
  EXPECT_EQ(dovetail.dovetail_angle_deg, 60);
  EXPECT_EQ(dovetail.cutter_height, 8);
  EXPECT_EQ(dovetail.neck_diameter, 9);
  const Tool slot = parseToolOption("3=tslot:20:5:8").value();
  EXPECT_EQ(slot.cutter_height, 5);
  EXPECT_EQ(slot.neck_diameter, 8);
  EXPECT_EQ(parseToolOption("4=lollipop:8:4")->neck_diameter, 4);
  for (const char* bad :
       {"1=taper:2:5", "1=taper:2:90:6", "1=taper:2:0:6", "1=dovetail:20:60:8", "1=tslot:20:5",
        "1=tslot:20:5:20", "1=lollipop:8", "1=lollipop:8:9", "1=tslot:20:5:8:1"})
    EXPECT_FALSE(parseToolOption(bad).ok()) << bad;
  for (const char* big : {"1=thread-mill:10:1.5", "1=form:3"})
    EXPECT_THAT(parseToolOption(big).error().message, HasSubstr("needs a job file")) << big;
}

}  // namespace
}  // namespace proveout::test
