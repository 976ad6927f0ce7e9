// Characteristics of the part as a whole against closed forms: walls, inner corners, the blank's skin, crests
// between passes and the roughness that they are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/session/part_check.h"
#include "tests/unit/app/block_job.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

const std::string kStart = "G21 G17 G90 G40 G49 G80 G94\nT1 M6\nS4000 M3\nG54 G0 X0 Y0\nG43 H1 Z5\n";

PartRule atMost(Quantity quantity, double value) {
  PartRule rule;
  rule.quantity = quantity;
  rule.max = value;
  return rule;
}

PartRule within(PartRule rule, const Vec3& min, const Vec3& max) {
  rule.region.emplace();
  rule.region->box = {min, max};
  return rule;
}

class PartCheck : public testing::Test {
 protected:
  PartCheck() {
    job = app_test::blockJob("block", {60, 40, 10}, {app_test::toolOf(1, 10)});
    job.settings.placement.origin = Vec3(0, 0, 0);
    job.settings.work_given[0] = true;
    job.settings.length_offsets = {{1, {0, 0}}};
    job.settings.radius_offsets = {{1, {5, 0}}};
  }
  std::vector<PartFeature> measure(const std::string& program, std::vector<PartRule> rules) {
    job.part_characteristics = std::move(rules);
    Result<RunResult> result = app_test::run(job, {kStart + program + "G0 Z50\nM5\nM30\n"});
    EXPECT_TRUE(result.ok()) << result.error().message;
    if (!result.ok()) return {};
    EXPECT_FALSE(result->alarm);
    findings = app_test::ofKind(result->findings, FindingKind::kCharacteristic);
    rows = partCharacteristics(job, *result);
    return result->part_features;
  }
  Job job;
  std::vector<Finding> findings;
  std::vector<ReportCharacteristic> rows;
};

TEST_F(PartCheck, LeastWallBetweenSlots) {
  // Two slots of 10, the second one runs off the first: the wall is thinnest where it leaves the block.
  const double tilt = std::atan2(1.5, 60.0), left = 27.345 + 1.5 * 10.0 / 60.0 - 5.0 / std::cos(tilt);
  const std::vector<PartFeature> told =
      measure("G0 X15 Y-10\nG1 Z-4 F300\nG1 Y50\nG0 Z5\nG0 X27.345 Y-10\nG1 Z-4\nG1 X28.845 Y50\n",
              {atMost(Quantity::kThickness, 1.0), atMost(Quantity::kThickness, 50.0),
               within(atMost(Quantity::kThickness, 9.0), {12, 5, -11}, {18, 35, -3.5})});
  ASSERT_EQ(told.size(), 3u);
  ASSERT_TRUE(told[0].measured);
  EXPECT_NEAR(*told[0].measured, left - 20.0, 2e-3);
  EXPECT_NEAR(told[0].where.y(), 0.0, 0.01);
  ASSERT_TRUE(told[2].measured);
  EXPECT_NEAR(*told[2].measured, 6.0, 1e-5) << "the floor of the slot";
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(findings[0].message.find("wall thickness is 2."), std::string::npos) << findings[0].message;
  ASSERT_TRUE(findings[0].source);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].verdict, "fail");
  EXPECT_EQ(rows[1].verdict, "pass");
}

TEST_F(PartCheck, InnerRadiiOfPockets) {
  const std::string pocket =
      "G0 X25 Y20\nG1 Z-4 F200\nG41 D1 X19 Y16\nG3 X25 Y10 R6\nG1 X34.5\nG3 X40 Y15.5 R5.5\nG1 Y24.5\n"
      "G3 X34.5 Y30 R5.5\nG1 X15.5\nG3 X10 Y24.5 R5.5\nG1 Y15.5\nG3 X15.5 Y10 R5.5\nG1 X25\nG3 X31 Y16 R6\n"
      "G40 G1 X25 Y20\n";
  const std::vector<PartFeature> told =
      measure(pocket, {atMost(Quantity::kInnerRadius, 50.0),
                       within(atMost(Quantity::kInnerRadius, 50.0), {0, 0, -3.5}, {60, 40, -0.5})});
  ASSERT_EQ(told.size(), 2u);
  ASSERT_TRUE(told[0].measured);
  EXPECT_EQ(*told[0].measured, 0.0) << "between floor and wall";
  EXPECT_NEAR(told[0].where.z(), -4.0, 0.01);
  ASSERT_TRUE(told[1].measured);
  EXPECT_NEAR(*told[1].measured, 5.5, 1e-3);
}

TEST_F(PartCheck, InnerRadiusOfABallNosedGroove) {
  job.tools = {app_test::toolOf(1, 4, ToolType::kBall)};
  const std::vector<PartFeature> told =
      measure("G0 X15 Y-10\nG1 Z-2 F300\nG1 Y50\n", {atMost(Quantity::kInnerRadius, 5.0)});
  ASSERT_TRUE(told.at(0).measured);
  EXPECT_NEAR(*told[0].measured, 2.0, 1e-3);
}

TEST_F(PartCheck, ABlockWithoutCornersHasNoInnerRadius) {
  const std::vector<PartFeature> told =
      measure("G0 X-20 Y-10\n", {atMost(Quantity::kInnerRadius, 5.0), atMost(Quantity::kScallop, 0.01)});
  EXPECT_FALSE(told.at(0).measured);
  EXPECT_FALSE(told.at(1).measured);
  EXPECT_TRUE(findings.empty());
}

TEST_F(PartCheck, SkinOfTheBlank) {
  const std::vector<PartFeature> told = measure(
      "G0 X15 Y-10\nG1 Z-4 F300\nG1 Y50\n",
      {atMost(Quantity::kSkin, 100.0), within(atMost(Quantity::kSkin, 2001.0), {-1, -1, -0.1}, {61, 41, 1})});
  ASSERT_TRUE(told.at(0).measured && told.at(1).measured);
  EXPECT_NEAR(*told[0].measured, 2400.0 + 2000.0 + 800.0 + 2 * 560.0, 0.5);
  EXPECT_NEAR(*told[1].measured, 2000.0, 0.5);
  EXPECT_EQ(findings.size(), 1u);
}

/// Mean distance from the mean line of arcs of radius r side by side, in micrometres, by a sum.
double arcRoughness(double r, double step) {
  constexpr int kCount = 100'000;
  double mean = 0.0, sum = 0.0;
  const auto height = [&](int k) {
    const double u = step * ((k + 0.5) / kCount - 0.5);
    return r - std::sqrt(r * r - u * u);
  };
  for (int k = 0; k < kCount; ++k) mean += height(k) / kCount;
  for (int k = 0; k < kCount; ++k) sum += std::abs(height(k) - mean) / kCount;
  return 1e3 * sum;
}

TEST_F(PartCheck, CrestsOfABallNose) {
  job.tools = {app_test::toolOf(1, 6, ToolType::kBall)};
  for (const double step : {0.3, 1.2, 2.5}) {
    std::string passes = "G0 X5 Y-10\nG1 Z-2 F300\n";
    for (int k = 0; k < 6; ++k)
      passes += fmt::format("G1 X{} Y{}\nY{}\n", 5 + k * step, k % 2 == 0 ? -10 : 50, k % 2 == 0 ? 50 : -10);
    const std::vector<PartFeature> told =
        measure(passes, {atMost(Quantity::kScallop, 0.001), atMost(Quantity::kRoughness, 0.01)});
    ASSERT_TRUE(told.at(0).measured && told.at(1).measured) << step;
    EXPECT_NEAR(*told[0].measured, 3.0 - std::sqrt(9.0 - 0.25 * step * step), 2e-5) << step;
    EXPECT_NEAR(*told[1].measured, arcRoughness(3.0, step), 0.02 * arcRoughness(3.0, step)) << step;
    EXPECT_EQ(findings.size(), 2u);
    EXPECT_EQ(rows[1].unit, "um");
  }
}

TEST_F(PartCheck, StairsOfAFlatTool) {
  // Steps of 1 across and 0.5 down: a crest is the height of that triangle.
  std::string passes;
  for (int k = 0; k < 6; ++k)
    passes += fmt::format("G0 X{} Y-10\nG1 Z{} F300\nY50\nG0 Z5\n", 45 + k, -4.0 + 0.5 * k);
  const std::vector<PartFeature> told = measure(passes, {atMost(Quantity::kScallop, 0.1)});
  ASSERT_TRUE(told.at(0).measured);
  EXPECT_NEAR(*told[0].measured, 0.5 / std::hypot(1.0, 0.5), 1e-4);
}

TEST_F(PartCheck, ARibIsNoCrest) {
  // Two slots of 10 side by side with a rib of the blank between them.
  const std::vector<PartFeature> told =
      measure("G0 X15 Y-10\nG1 Z-4 F300\nG1 Y50\nG0 Z5\nG0 X27 Y-10\nG1 Z-4\nG1 Y50\n",
              {atMost(Quantity::kScallop, 0.1)});
  EXPECT_FALSE(told.at(0).measured);
}

}  // namespace
}  // namespace proveout
