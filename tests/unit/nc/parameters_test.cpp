// Parameters of the nct control: by name from the job, by number from the program.
#include "core/nc/iso/parameters/parameters.h"

#include <gtest/gtest.h>

#include "core/nc/control/control_settings.h"
#include "core/nc/nct/parameters/nct_parameters.h"

namespace proveout::nc {
namespace {

TEST(Parameters, DefaultsAreThoseOfTheTable) {
  const IsoParameters parameters{nctParameters()};
  EXPECT_EQ(parameters[MotionParam::kRadiusDifference], 2);
  EXPECT_EQ(parameters[CycleParam::kBoreRetract], 100);
  EXPECT_TRUE(parameters.flag(MachineParam::kSpindleOrients, 16));
  EXPECT_FALSE(parameters.given(MotionParam::kRadiusDifference));
}

TEST(Parameters, TablesAgreeWithTheirEnumerations) {
  EXPECT_EQ(nctParameters().row(MotionParam::kRadiusDifference).name, "N1339");
  EXPECT_EQ(nctParameters().row(MachineParam::kToolChangeOnM6).name, "N1338.M06");
  EXPECT_EQ(nctParameters().row(CompParam::kMinCompStep).name, "N1405");
  EXPECT_EQ(nctParameters().row(CycleParam::kTapRetract).name, "N1506");
  for (std::size_t c = 0; c < static_cast<std::size_t>(ParamChapter::kCount); ++c) {
    for (const ParamInfo& info : nctParameters().chapter(static_cast<ParamChapter>(c))) {
      EXPECT_TRUE(info.min <= info.default_value && info.default_value <= info.max) << info.name;
      if (info.name.empty()) continue;  // other controls have it
      if (info.number < 0) {            // the manual names it without a number
        EXPECT_TRUE(info.name.starts_with("CLR.") || info.name.starts_with("BUF.")) << info.name;
        continue;
      }
      EXPECT_EQ(info.name.substr(0, 1), "N");
      EXPECT_EQ(std::stoi(std::string(info.name.substr(1, 4))), info.number) << info.name;
      EXPECT_EQ(info.name.find('.') != std::string_view::npos, info.bit != kWholeParam) << info.name;
    }
  }
}

TEST(Parameters, NamesMayEndInANumber) {
  IsoParameters parameters{nctParameters()};
  ASSERT_TRUE(parameters.set({{"N0607.ORI", 0}, {"N0607.INX.3", 0}}).ok());
  EXPECT_FALSE(parameters.flag(MachineParam::kSpindleOrients, 1));
  EXPECT_FALSE(parameters.flag(MachineParam::kSpindleOrients, 16));
  EXPECT_TRUE(parameters.flag(MachineParam::kSpindleIndexes, 2));
  EXPECT_FALSE(parameters.flag(MachineParam::kSpindleIndexes, 3));
  EXPECT_FALSE(parameters.set({{"N0607.ORI.17", 0}}).ok());
  EXPECT_FALSE(parameters.set({{"N1339.2", 0}}).ok()) << "belongs to the channel";
  EXPECT_FALSE(parameters.set({{"N0607.ORI.2", 0.5}}).ok());
  EXPECT_FALSE(parameters.set({{"N0607", 1}}).ok());
}

TEST(Parameters, ProgramsReachThemByNumberAndBit) {
  IsoParameters parameters{nctParameters()};
  double value = 0;
  EXPECT_EQ(parameters.write(1339, kWholeParam, 0, 0.5, false), ParamStatus::kOk);
  EXPECT_EQ(parameters.write(1339, kWholeParam, 0, 0.25, true), ParamStatus::kOk);
  EXPECT_EQ(parameters[MotionParam::kRadiusDifference], 0.75);
  EXPECT_TRUE(parameters.given(MotionParam::kRadiusDifference));
  EXPECT_EQ(parameters.write(1339, kWholeParam, 0, -1, false), ParamStatus::kOutOfRange);
  EXPECT_EQ(parameters.write(1337, kWholeParam, 0, 1, false), ParamStatus::kNeedsBit);
  EXPECT_EQ(parameters.write(1337, 1, 0, 1, false), ParamStatus::kOk);
  EXPECT_TRUE(parameters.flag(MotionParam::kDwellSeconds));
  EXPECT_EQ(parameters.write(1337, 1, 0, 1, true), ParamStatus::kOutOfRange) << "a bit is 0 or 1";
  EXPECT_EQ(parameters.write(607, 2, 0, 0, false), ParamStatus::kNeedsIndex);
  EXPECT_EQ(parameters.write(607, 2, 17, 0, false), ParamStatus::kBadIndex);
  EXPECT_EQ(parameters.write(1339, kWholeParam, 1, 0.5, false), ParamStatus::kOk) << "the own channel";
  EXPECT_EQ(parameters.write(1339, kWholeParam, 2, 0.5, false), ParamStatus::kBadIndex);
  EXPECT_EQ(parameters.write(1401, kWholeParam, 0, 5, false), ParamStatus::kRestart);
  EXPECT_EQ(parameters.write(607, 2, 4, 0, false), ParamStatus::kOk);
  EXPECT_EQ(parameters.read(607, 2, 4, value), ParamStatus::kOk);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(parameters.read(607, 2, 5, value), ParamStatus::kOk);
  EXPECT_EQ(value, 1);
  EXPECT_EQ(parameters.read(9999, kWholeParam, 0, value), ParamStatus::kUnknown);
  EXPECT_EQ(parameters.read(1339, 3, 0, value), ParamStatus::kUnknown);
}

TEST(Parameters, EndsOfTheStrokeLimitTheTravel) {
  ControlSettings settings;
  const auto limited = [&](std::map<std::string, double> values, ControlId control = ControlId::kNct) {
    settings.parameters = std::move(values);
    return limitsTravel(control, settings);
  };
  EXPECT_FALSE(limited({}));
  EXPECT_FALSE(limited({{"N1001.CBM", 1}, {"N1006.1", 5}}));
  for (const char* name : {"N1002", "N1003", "N1004", "N1005", "N1002.3", "N1005.1"})
    EXPECT_TRUE(limited({{"N1001.CBM", 1}, {name, 0}})) << name;
  EXPECT_FALSE(limited({{"N1002", 1}}, ControlId::kWl4Mill)) << "a parameter of nct";
  settings.axes.emplace_back().limit = AxisLimit{-90, 90};
  EXPECT_TRUE(limited({})) << "a rotary axis";
  settings.axes.clear();
  EXPECT_FALSE(limited({}));
  settings.limits[1] = AxisLimit{-10, 10};
  EXPECT_TRUE(limited({}));
  EXPECT_TRUE(limited({}, ControlId::kWl4Mill));
}

}  // namespace
}  // namespace proveout::nc
