// `align` and its kin of [nominal].
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job_fixture.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class JobAlignment : public testing::Test {
 protected:
  static std::string with(const std::string& nominal) {
    return io_test::kSmallJob + "[nominal]\nmesh = \"bracket.stl\"\n" + nominal;
  }
  io_test::JobFolder folder_;
};

TEST_F(JobAlignment, IsNoneUnlessItIsAskedFor) {
  const auto job = folder_.load(with(""));
  ASSERT_TRUE(job) << folder_.text();
  EXPECT_EQ(job->nominal->align.kind, AlignKind::kNone);
  EXPECT_EQ(job->nominal->align.limit_mm, 1.0);
  EXPECT_TRUE(folder_.load(with("align = \"none\"\n")));
}

TEST_F(JobAlignment, IsRead) {
  const auto fit = folder_.load(with("align = \"fit\"\nalign_limit = 0.25\n"));
  ASSERT_TRUE(fit) << folder_.text();
  EXPECT_EQ(fit->nominal->align.kind, AlignKind::kFit);
  EXPECT_EQ(fit->nominal->align.limit_mm, 0.25);
  const auto datums =
      folder_.load(with("align = \"datums\"\ndatums = [[1, 2, 3], [4, 5, 6], [7, 8, 9.5]]\n"));
  ASSERT_TRUE(datums) << folder_.text();
  EXPECT_EQ(datums->nominal->align.kind, AlignKind::kDatums);
  ASSERT_EQ(datums->nominal->align.datums.size(), 3u);
  EXPECT_EQ(datums->nominal->align.datums[2], Vec3(7, 8, 9.5));
}

TEST_F(JobAlignment, WrongOnesAreRefused) {
  const std::pair<std::string, std::string> wrong[] = {
      {"align = \"best\"\n", "there are none, fit, datums"},
      {"align = true\n", "align"},
      {"align = \"fit\"\nalign_limit = 0\n", "align_limit"},
      {"align_limit = 2\n", "`align_limit` is for align"},
      {"align = \"datums\"\n", "needs `datums`"},
      {"align = \"fit\"\ndatums = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]\n", "are for align = \"datums\""},
      {"align = \"datums\"\ndatums = [[1, 2, 3], [4, 5, 6]]\n", "three points"},
      {"align = \"datums\"\ndatums = [[1, 2, 3], [4, 5, 6], [7, 8]]\n", "datum 3"},
      {"align = \"datums\"\ndatums = 3\n", "datums"},
  };
  for (const auto& [text, message] : wrong) {
    EXPECT_FALSE(folder_.load(with(text))) << text;
    EXPECT_THAT(folder_.text(), HasSubstr(message)) << text;
  }
}

}  // namespace
}  // namespace proveout
