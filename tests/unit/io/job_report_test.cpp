// [report] of a job, and what of [output] is for the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "job_fixture.h"

namespace proveout {
namespace {

using namespace io_test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(JobReport, ReadsHeadBandsAndSections) {
  unsetenv("SOURCE_DATE_EPOCH");
  JobFolder folder;
  const auto job = folder.load(kSmallJob + R"([report]
operator = "N. N."
part_number = "4711-A"
date = "2024-02-29"
bands = [-0.05, -0.02, 0.02, 0.1]
sections = ["X12.5", "Z-3"]
[output]
view3d = false
)");
  ASSERT_TRUE(job) << folder.text();
  ASSERT_EQ(job->report.head.size(), 3u);
  EXPECT_EQ(job->report.head[0].key, "part_number");
  EXPECT_EQ(job->report.head[0].label, "Part number");
  EXPECT_EQ(job->report.head[1].text, "N. N.");
  EXPECT_EQ(job->report.head[2].text, "2024-02-29");
  EXPECT_THAT(job->report.bands_mm, ElementsAre(-0.05, -0.02, 0.02, 0.1));
  ASSERT_EQ(job->report.sections.size(), 2u);
  EXPECT_EQ(job->report.sections[0].axis, 0);
  EXPECT_EQ(job->report.sections[1].at_mm, -3.0);
  EXPECT_FALSE(wantsView(*job));
}

TEST(JobReport, DateIsTheJobsOrThatOfTheSourceAndNeverTheClocks) {
  JobFolder folder;
  unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_TRUE(folder.load(kSmallJob)->report.head.empty());
  for (const char* wrong : {"", "now", "12x", "-5", "999999999999999"}) {
    setenv("SOURCE_DATE_EPOCH", wrong, 1);
    EXPECT_TRUE(folder.load(kSmallJob)->report.head.empty()) << wrong;
  }
  setenv("SOURCE_DATE_EPOCH", "1709164800", 1);  // date -u -d @1709164800
  EXPECT_EQ(folder.load(kSmallJob)->report.head.back().text, "2024-02-29");
  EXPECT_EQ(folder.load(kSmallJob + "[report]\ndate = \"2020-01-01\"\n")->report.head.back().text,
            "2020-01-01");
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST(JobReport, BadValuesAreTold) {
  const std::pair<const char*, const char*> cases[] = {
      {"date = \"30.11.2026\"", "date must be a day like"},
      {"date = \"2023-02-29\"", "date must be a day like"},
      {"bands = [0.1]", "two edges or more"},
      {"bands = [0.1, 0.1]", "edges in mm that ascend"},
      {"bands = [0.1, \"x\"]", "an edge of bands"},
      {"sections = [\"W3\"]", "'W3' is no plane of a section"},
      {"sections = [\"X\"]", "'X' is no plane of a section"},
      {"sections = [\"X1e9\"]", "is no plane of a section"},
      {"sections = [\"Xnan\"]", "is no plane of a section"},
      {"sections = [\"X3mm\"]", "is no plane of a section"},
      {"part = \"1\"", "has no key 'part'"},
      {"customer = \"\"", "customer must not be empty"}};
  for (const auto& [text, message] : cases) {
    JobFolder folder;
    EXPECT_FALSE(folder.load(kSmallJob + "[report]\n" + text + "\n")) << text;
    EXPECT_THAT(folder.text(), HasSubstr(message));
    EXPECT_THAT(folder.text(), HasSubstr("job.toml:"));
  }
}

TEST(JobReport, ViewComesWithThePictures) {
  JobFolder folder;
  EXPECT_TRUE(wantsView(*folder.load(kSmallJob)));
  EXPECT_FALSE(wantsView(*folder.load(kSmallJob + "[output]\nviews = []\n")));
  EXPECT_TRUE(wantsView(*folder.load(kSmallJob + "[output]\nviews = []\nview3d = true\n")));
}

}  // namespace
}  // namespace proveout
