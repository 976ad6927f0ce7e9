// Rows of M codes: the control's own beside what parameters and settings make of others.
#include "core/nc/iso/model/m_index.h"

#include <gtest/gtest.h>

#include "core/nc/control/control_settings.h"
#include "core/nc/nct/dialect.h"
#include "core/nc/nct/parameters/nct_parameters.h"

namespace proveout::nc {
namespace {

class MIndexTest : public testing::Test {
 protected:
  const MFunction& at(int m) {
    index_.update(parameters_);
    return index_.find(m);
  }
  void set(const std::map<std::string, double>& values) { ASSERT_TRUE(parameters_.set(values).ok()); }

  ControlSettings settings_;
  IsoParameters parameters_{nctParameters()};
  MIndex index_{nctCodes(), settings_};
};

TEST_F(MIndexTest, OwnCodesAloneMeanSomething) {
  ASSERT_NE(at(3).own, nullptr);
  EXPECT_EQ(at(3).own->code, 3);
  EXPECT_EQ(at(3).phase(), MPhase::kBefore);
  EXPECT_EQ(at(3).exclusive(0), kSpindleCodes);
  for (const int m : {7, 99999999, -1}) {
    EXPECT_EQ(at(m).own, nullptr) << m;
    EXPECT_EQ(at(m).exclusive(0), 0) << m;
    EXPECT_FALSE(at(m).ofSpindle(0)) << m;
  }
}

TEST_F(MIndexTest, RangesOverlap) {
  set({{"N1341", 50}, {"N1357", 60}, {"N1342", 55}, {"N1358", 99999999}, {"N2201", 58}, {"N2202", 58}});
  EXPECT_EQ(at(49).group, 0);
  EXPECT_EQ(at(50).group, 1);
  EXPECT_EQ(at(60).group, 1) << "the first group that has the code";
  EXPECT_EQ(at(61).group, 2);
  EXPECT_EQ(at(99).group, 2) << "one of the control's own too";
  EXPECT_EQ(at(99).own->code, 99);
  EXPECT_EQ(at(99999999).group, 2);
  EXPECT_TRUE(at(58).waits);
  EXPECT_FALSE(at(57).waits || at(59).waits);
}

TEST_F(MIndexTest, FollowsParameters) {
  EXPECT_FALSE(at(62).of_place);
  set({{"N2924", 62}});
  EXPECT_TRUE(at(62).of_place);
  EXPECT_EQ(at(96).interrupt, InterruptSwitch::kNone);
  set({{"N1758.USD", 1}});
  EXPECT_EQ(at(96).interrupt, InterruptSwitch::kOn);
  EXPECT_EQ(at(97).interrupt, InterruptSwitch::kOff);
}

TEST_F(MIndexTest, CodesOfSpindles) {
  settings_.spindles.resize(2);
  settings_.spindles[1].number = 2;
  settings_.spindles[1].main_code = 45;
  set({{"N0823.2", 24}});
  EXPECT_EQ(at(45).main, 1);
  EXPECT_TRUE(at(45).ofSpindle(0));
  EXPECT_EQ(at(45).exclusive(0), 0);
  EXPECT_FALSE(at(24).ofSpindle(0)) << "it closes the loop of the other one";
  EXPECT_TRUE(at(24).ofSpindle(1));
  EXPECT_EQ(at(24).exclusive(1), kSpindleCodes);
}

}  // namespace
}  // namespace proveout::nc
