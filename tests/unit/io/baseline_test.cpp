#include "io/baseline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace proveout {
namespace {

using ::testing::HasSubstr;

Finding gouge(double x, const std::string& text = "N40 G1 X15", std::uint32_t line = 12) {
  Finding finding(FindingKind::kGouge);
  finding.where = Vec3(x, 2.00004, -0.00001);
  finding.depth_mm = 0.35123456;
  finding.area_mm2 = 12.5;
  finding.source = BlockRef{"folder/plate.nc", line, 40, 0, text};
  finding.tool = 1;
  finding.message = "0.3512 mm below nominal";
  return finding;
}

TEST(Baseline, WhatIsWrittenIsRead) {
  Finding contact(FindingKind::kRapidContact);
  contact.setup = "top";
  contact.spots = 3;
  contact.message = "line\nbreak \"quoted\" \xff";
  const std::string text = baselineText({gouge(7), contact});
  const auto read = parseBaseline(text, "known.json");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 2u);
  const KnownFinding& first = (*read)[0];
  EXPECT_EQ(first.kind, FindingKind::kGouge);
  EXPECT_EQ(first.severity, Severity::kError);
  EXPECT_EQ(first.file, "plate.nc");
  EXPECT_EQ(first.line, 12u);
  EXPECT_EQ(first.block, "G1 X15");
  EXPECT_EQ(*first.where, Vec3(7, 2, 0));
  EXPECT_EQ(*first.depth_mm, 0.3512);
  EXPECT_EQ(*first.area_mm2, 12.5);
  EXPECT_FALSE(first.volume_mm3);
  EXPECT_EQ((*read)[1].setup, "top");
  EXPECT_EQ((*read)[1].spots, 3u);
  EXPECT_EQ((*read)[1].message, knownFinding(contact).message);
}

TEST(Baseline, IsTheSameForTheSameFindingsInAnyOrder) {
  const std::string text = baselineText({gouge(7), gouge(3), gouge(5, "X9", 4)});
  EXPECT_EQ(text, baselineText({gouge(5, "X9", 4), gouge(3), gouge(7)}));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3 + 5) << "a finding is a line:\n" << text;
  EXPECT_LT(text.find("\"block\":\"X9\""), text.find("G1 X15"));
  EXPECT_THAT(baselineText({}), HasSubstr("proveout.baseline/1"));
  EXPECT_TRUE(parseBaseline(baselineText({}), "x"));
}

TEST(Baseline, LeavesOutWhatIsNeverKnown) {
  Finding alarm(FindingKind::kAlarm), undecided(FindingKind::kUndecided), part(FindingKind::kPartial);
  EXPECT_EQ(baselineCount({alarm, undecided, part, gouge(1)}), 1u);
  EXPECT_EQ(baselineText({alarm, undecided, part}), baselineText({}));
}

TEST(Baseline, NumbersOfBlocksAndBlanksDoNotCount) {
  EXPECT_EQ(knownFinding(gouge(1, "N40 G1  X15 ")).block, knownFinding(gouge(1, "N1040\tG1 X15\r")).block);
  EXPECT_EQ(knownFinding(gouge(1, "N40G1X15")).block, "G1X15");
  EXPECT_EQ(knownFinding(gouge(1, "NEXT")).block, "NEXT");
  EXPECT_EQ(knownFinding(gouge(1, "N40")).block, "");
}

TEST(Baseline, BadFilesAreRefusedWithTheReason) {
  const auto refusal = [](const std::string& text) {
    const auto read = parseBaseline(text, "known.json");
    return read ? std::string("read") : read.error().message;
  };
  const auto entry = [&](const std::string& finding) {
    return refusal("{\"schema\": \"proveout.baseline/1\", \"findings\": [" + finding + "]}");
  };
  const std::string good = "\"kind\": \"gouge\", \"severity\": \"error\"";
  EXPECT_EQ(entry("{" + good + "}"), "read");
  for (const std::string& bad :
       {std::string(), std::string("{"), std::string("[]"), baselineText({gouge(1)}).substr(0, 60)})
    EXPECT_THAT(refusal(bad), HasSubstr("no JSON document")) << bad;
  EXPECT_THAT(refusal("{}"), HasSubstr("has no schema"));
  EXPECT_THAT(refusal("{\"schema\": \"proveout.report/1\"}"), HasSubstr("it is a report"));
  EXPECT_THAT(refusal("{\"schema\": \"proveout.baseline/2\"}"), HasSubstr("proveout.baseline/2"));
  EXPECT_THAT(refusal("{\"schema\": \"proveout.baseline/1\"}"), HasSubstr("no list of findings"));
  EXPECT_THAT(entry("1"), HasSubstr("finding 1: it is no object"));
  EXPECT_THAT(entry("{" + good + "}, {\"kind\": \"gauge\"}"),
              HasSubstr("finding 2: there is no kind of finding 'gauge'"));
  EXPECT_THAT(entry("{\"kind\": \"alarm\", \"severity\": \"error\"}"), HasSubstr("never known"));
  EXPECT_THAT(entry("{\"kind\": \"gouge\", \"severity\": \"bad\"}"), HasSubstr("severity"));
  EXPECT_THAT(entry("{" + good + ", \"line\": -1}"), HasSubstr("line is no count"));
  EXPECT_THAT(entry("{" + good + ", \"where\": [1, 2]}"), HasSubstr("where"));
  EXPECT_THAT(entry("{" + good + ", \"where\": [1, 2, null]}"), HasSubstr("where"));
  EXPECT_THAT(entry("{" + good + ", \"depth_mm\": \"1\"}"), HasSubstr("depth_mm is no number"));
  EXPECT_THAT(entry("{" + good + ", \"file\": 1}"), HasSubstr("--write-baseline"));
}

}  // namespace
}  // namespace proveout
