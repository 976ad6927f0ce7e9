#include "io/job/job_offsets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace proveout {
namespace {

using ::testing::HasSubstr;

const std::vector<ParameterRange> kMill;
const std::vector<ParameterRange> kLathe = {{"RT", 0, 100, 99}, {"TIP", 0, 9, 99}, {"DXW", -1e4, 1e4, 99}};
const std::vector<ParameterRange> kWire = {{"H", -100, 100, 99}, {"T", 0, 1000}};

ControlSettings settingsWith(const std::string& text, const std::vector<ParameterRange>& parameters = kMill) {
  ControlSettings settings;
  const auto entry = parseOffset(text, parameters);
  EXPECT_TRUE(entry) << entry.error().message;
  if (entry) setOffset(*entry, parameters, settings);
  return settings;
}

std::string refusal(const std::string& text, const std::vector<ParameterRange>& parameters = kMill) {
  const auto entry = parseOffset(text, parameters);
  return entry ? "taken as " + entry->name : entry.error().message;
}

TEST(Offsets, WorkOffsets) {
  const ControlSettings settings = settingsWith("g55=10,-2.5,0");
  EXPECT_EQ(settings.work_offsets[1], Vec3(10, -2.5, 0));
  EXPECT_TRUE(settings.work_given[1]);
  EXPECT_FALSE(settings.work_given[0]);
  for (const char* name : {"G54.1 P3=1,2,3", "g54.1p3=1,2,3"}) {
    const ControlSettings extended = settingsWith(name);
    EXPECT_EQ(extended.extended_offsets, (std::map<int, Vec3>{{3, Vec3(1, 2, 3)}}));
  }
  EXPECT_EQ(settingsWith("common=0,0,5").common_offset, Vec3(0, 0, 5));
}

TEST(Offsets, RowsOfTheTables) {
  for (const char* name : {"D1=5", "d01=5"}) {
    const ControlSettings settings = settingsWith(name);
    ASSERT_TRUE(settings.radius_offsets.contains(1));
    EXPECT_EQ(settings.radius_offsets.at(1).geometry, 5.0);
    EXPECT_EQ(settings.radius_offsets.at(1).wear, 0.0);
  }
  EXPECT_EQ(settingsWith("H12=-0.5").length_offsets.at(12).geometry, -0.5);
  EXPECT_TRUE(settingsWith("D1=0").radius_offsets.contains(1)) << "a 0 that somebody has said";
}

TEST(Offsets, OfLathesAndWires) {
  EXPECT_EQ(settingsWith("dxw.3=0.25", kLathe).parameters, (std::map<std::string, double>{{"DXW.3", 0.25}}));
  EXPECT_EQ(settingsWith("TIP.2=3", kLathe).parameters, (std::map<std::string, double>{{"TIP.2", 3.0}}));
  EXPECT_EQ(settingsWith("H1=0.15", kWire).parameters, (std::map<std::string, double>{{"H.1", 0.15}}));
  EXPECT_THAT(refusal("TIP.2=10", kLathe), HasSubstr("10 is not from 0 to 9"));
  EXPECT_THAT(refusal("DXW.3=1"), HasSubstr("there is no offset 'DXW.3'"));
  EXPECT_THAT(refusal("D1=5", kWire), HasSubstr("did you mean 'H1'?"));
}

TEST(Offsets, OtherNamesAreRefusedWithTheNearest) {
  EXPECT_THAT(refusal("G60=1,2,3"), HasSubstr("G54 to G59"));
  EXPECT_THAT(refusal("G5=1,2,3"), HasSubstr("there is no offset 'G5', did you mean 'G5"));
  EXPECT_THAT(refusal("L4=1"), HasSubstr("did you mean 'D4'?"));
  EXPECT_THAT(refusal("comon=1,2,3"), HasSubstr("did you mean 'common'?"));
  EXPECT_THAT(refusal("D0=1"), HasSubstr("there is no offset 'D0'"));
  EXPECT_THAT(refusal("G54.1 P100=1,2,3"), HasSubstr("there is no offset"));
  EXPECT_THAT(refusal("D10000=1"), HasSubstr("there is no offset"));
  EXPECT_THAT(refusal(""), HasSubstr("there is no offset ''"));
  EXPECT_THAT(refusal("="), HasSubstr("there is no offset ''"));
}

TEST(Offsets, ValuesAreWholeFiniteAndAsManyAsMeant) {
  for (const char* bad :
       {"G55", "G55=", "G55=1", "G55=1,2", "G55=1,2,3,4", "G55=1,2,x", "G55=1,,3", "G55=1,2,nan"})
    EXPECT_THAT(refusal(bad), HasSubstr("G55 takes three numbers, mm: G55=X,Y,Z")) << bad;
  for (const char* bad : {"D1", "D1=", "D1=5mm", "D1=1,2", "D1=inf", "D1= 5"})
    EXPECT_THAT(refusal(bad), HasSubstr("D1 takes one number, mm: D1=VALUE")) << bad;
  EXPECT_THAT(refusal("D1=1e9"), HasSubstr("beyond"));
}

}  // namespace
}  // namespace proveout
