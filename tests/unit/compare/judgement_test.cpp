// Tolerances of characteristics: the tables of ISO 2768, rules of a job, and what the surface's tolerances
// leave.
#include "removal/compare/features/judgement.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

Characteristic characteristicOf(Quantity quantity, double nominal, double length = 1.0) {
  Characteristic c;
  c.quantity = quantity;
  c.nominal = nominal;
  c.faces = {0};
  c.to = Vec3(0, 0, length);
  return c;
}

TEST(GeneralTolerance, HasTheValuesOfTheStandard) {
  struct Limit {
    const char* general;
    Quantity quantity;
    double nominal, length, limit;
  };
  // ISO 2768-1 tables 1 to 3, ISO 2768-2 tables 1 and 2; borders belong to the smaller range.
  const Limit rows[] = {{"m", Quantity::kDiameter, 3.0, 1, 0.1},
                      {"m", Quantity::kDiameter, 3.1, 1, 0.1},
                      {"m", Quantity::kDepth, 6.1, 1, 0.2},
                      {"m", Quantity::kWidth, 30.0, 1, 0.2},
                      {"m", Quantity::kWidth, 30.1, 1, 0.3},
                      {"f", Quantity::kX, 400.0, 1, 0.2},
                      {"c", Quantity::kY, -500.0, 1, 2.0},
                      {"v", Quantity::kHeight, 4.0, 1, 0.5},
                      {"f", Quantity::kRadius, 2.0, 1, 0.2},
                      {"m", Quantity::kRadius, 5.0, 1, 0.5},
                      {"c", Quantity::kRadius, 50.0, 1, 2.0},
                      {"m", Quantity::kAngle, 90.0, 10.0, 1.0},
                      {"m", Quantity::kAngle, 90.0, 40.0, 0.5},
                      {"c", Quantity::kAngle, 30.0, 100.0, 0.5},
                      {"mH", Quantity::kFlatness, 0.0, 100.0, 0.1},
                      {"mK", Quantity::kFlatness, 0.0, 101.0, 0.4},
                      {"K", Quantity::kPerpendicularity, 0, 50, 0.4},
                      {"ISO 2768-mL", Quantity::kFlatness, 0.0, 9.0, 0.1}};
  for (const Limit& row : rows) {
    const auto general = parseGeneralTolerance(row.general);
    ASSERT_TRUE(general) << row.general;
    const auto limit = general->limit(characteristicOf(row.quantity, row.nominal), row.length);
    EXPECT_NEAR(limit.value_or(-1.0), row.limit, 1e-12) << row.general << " " << row.nominal;
  }
  EXPECT_FALSE(parseGeneralTolerance("m")->limit(characteristicOf(Quantity::kDiameter, 0.4), 1.0));
  EXPECT_FALSE(parseGeneralTolerance("v")->limit(characteristicOf(Quantity::kDiameter, 2.0), 1.0));
  EXPECT_FALSE(parseGeneralTolerance("m")->limit(characteristicOf(Quantity::kFlatness, 0.0), 1.0));
  EXPECT_FALSE(parseGeneralTolerance("mK")->limit(characteristicOf(Quantity::kPosition, 0.0), 1.0));
  EXPECT_EQ(parseGeneralTolerance("mK")->text(), "ISO 2768-mK");
  for (const char* wrong : {"", "x", "Km", "mm", "m K", "mKH"})
    EXPECT_FALSE(parseGeneralTolerance(wrong)) << wrong;
}

class Judging : public testing::Test {
 protected:
  Judging() {
    for (const double x : {0.0, 20.0}) {
      CadFace hole;
      hole.kind = SurfaceKind::kCylinder;
      hole.hollow = true;
      hole.radius = 4.0;
      hole.origin = Vec3(x, 0, 0);
      hole.name = x == 0.0 ? "left, seat" : "right";
      faces_.faces.push_back(hole);
      Feature feature;
      feature.kind = FeatureKind::kHole;
      feature.faces = {static_cast<std::uint32_t>(faces_.faces.size() - 1)};
      feature.bounds = {Vec3(x - 4, -4, -10), Vec3(x + 4, 4, 0)};
      Characteristic diameter = characteristicOf(Quantity::kDiameter, 8.0);
      diameter.faces = feature.faces;
      diameter.measured = 8.03;
      Characteristic position = characteristicOf(Quantity::kPosition, 0.0);
      position.faces = feature.faces;
      feature.characteristics = {diameter, position};
      features_.push_back(feature);
    }
    tolerances_.gouge_mm = 0.02;
    tolerances_.excess_mm = 0.05;
  }
  JudgedCharacteristic diameterOf(std::size_t feature) {
    return judgeFeatures(features_, faces_, tolerances_).features[feature][0];
  }
  CadFaces faces_;
  std::vector<Feature> features_;
  FeatureTolerances tolerances_;
};

TEST_F(Judging, SurfaceTolerancesCountOnBothSides) {
  const JudgedCharacteristic judged = diameterOf(0);
  EXPECT_EQ(judged.source, ToleranceSource::kSurface);
  EXPECT_NEAR(*judged.lower, -0.1, 1e-12);  // material left over makes a hole smaller
  EXPECT_NEAR(*judged.upper, 0.04, 1e-12);
  EXPECT_EQ(judged.verdict, CharacteristicVerdict::kPass);
  // What was not measured fails.
  EXPECT_EQ(judgeFeatures(features_, faces_, tolerances_).features[0][1].verdict,
            CharacteristicVerdict::kFail);
  faces_.faces[0].hollow = false;
  EXPECT_NEAR(*diameterOf(0).upper, 0.1, 1e-12);
}

TEST_F(Judging, RulesHoldWhereTheyFitAndTheLastOneWins) {
  tolerances_.general = *parseGeneralTolerance("m");
  CharacteristicRule all, left, seat, nowhere;
  all.quantity = left.quantity = seat.quantity = nowhere.quantity = Quantity::kDiameter;
  all.size = 8.0;
  all.lower = -0.01;
  all.upper = 0.01;
  left.at = Vec3(0.5, 0, -1);
  left.upper = 0.05;
  left.lower = 0.0;
  left.nominal = 8.02;
  nowhere.at = Vec3(10, 0, 0);
  nowhere.upper = 1.0;
  tolerances_.rules = {all, left, nowhere};
  const Judgement judgement = judgeFeatures(features_, faces_, tolerances_);
  EXPECT_EQ(judgement.features[0][0].nominal, 8.02);
  EXPECT_EQ(judgement.features[0][0].verdict, CharacteristicVerdict::kPass);
  EXPECT_EQ(judgement.features[1][0].verdict, CharacteristicVerdict::kFail);
  ASSERT_EQ(judgement.unused.size(), 1u);
  EXPECT_EQ(judgement.unused.front(), &tolerances_.rules[2]);
  seat.face = "seat";
  seat.upper = 0.001;
  tolerances_.rules = {seat};
  EXPECT_EQ(diameterOf(0).verdict, CharacteristicVerdict::kFail);
  EXPECT_EQ(diameterOf(1).source, ToleranceSource::kGeneral);
  tolerances_.rules[0].face = "sea";
  EXPECT_EQ(judgeFeatures(features_, faces_, tolerances_).unused.size(), 1u);
}

TEST_F(Judging, LimitsBelongToTheTolerance) {
  CharacteristicRule exact;
  exact.quantity = Quantity::kDiameter;
  exact.lower = 0.03;
  exact.upper = 0.03;
  tolerances_.rules = {exact};
  EXPECT_EQ(diameterOf(0).verdict, CharacteristicVerdict::kPass);
  features_[0].characteristics[0].measured = 8.0300001;
  EXPECT_EQ(diameterOf(0).verdict, CharacteristicVerdict::kFail);
}

}  // namespace
}  // namespace proveout
