// Settings of controls that are no numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/io/job_fixture.h"

namespace proveout::io_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::pair<std::string, std::string>> namedBy(std::string_view text) {
  std::vector<std::pair<std::string, std::string>> out;
  if (text.find("TABLE") != std::string_view::npos) out.emplace_back("table", "t.tbl");
  out.emplace_back("folders", "subs");
  return out;
}

class JobControlTexts : public ::testing::Test {
 protected:
  JobControlTexts() {
    using Kind = TextSetting::Kind;
    folder.names.parameters["nct"] = {{"N1339", 0, 10}};
    folder.names.texts["nct"] = {{"axes", Kind::kText, ""},
                                 {"table", Kind::kFile, ""},
                                 {"ini", Kind::kFile, "", namedBy},
                                 {"folders", Kind::kFolders, ""},
                                 {"remap", Kind::kTable, ""}};
    folder.write("t.tbl", "T1 P1\n");
    folder.write("subs/x.ngc", "M2\n");
    folder.write("m.ini", "TABLE\n");
  }
  static std::string with(const std::string& keys) {
    return replacedOnce(kSmallJob, "control = \"nct\"\n", "") + "[control]\nname = \"nct\"\n[control.nct]\n" +
           keys;
  }
  JobFolder folder;
};

TEST_F(JobControlTexts, AreRead) {
  const auto job =
      folder.load(with("N1339 = 1\naxes = 'XYZA'\ntable = 't.tbl'\nfolders = 'subs'\n[control.nct.remap]\nM6 "
                       "= 'change.ngc'\nP0 = 1\n\"G88.6\" = 2.5\n"));
  ASSERT_TRUE(job) << folder.text();
  using Text = std::pair<const std::string, std::string>;
  EXPECT_THAT(job->settings.texts,
              ElementsAre(Text("axes", "XYZA"), Text("remap.G88.6", "2.5"), Text("remap.M6", "change.ngc"),
                          Text("remap.P0", "1"), Text("table", "T1 P1\n")));
  EXPECT_THAT(job->subprograms, ElementsAre(HasSubstr("subs")));
}

TEST_F(JobControlTexts, NameFurtherFiles) {
  const auto job = folder.load(with("ini = 'm.ini'\n"));
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->settings.texts.at("table"), "T1 P1\n");
  EXPECT_THAT(job->subprograms, ElementsAre(HasSubstr("subs")));
  folder.write("own.tbl", "T2 P2\n");
  const auto own = folder.load(with("ini = 'm.ini'\ntable = 'own.tbl'\n"));
  ASSERT_TRUE(own) << folder.text();
  EXPECT_EQ(own->settings.texts.at("table"), "T2 P2\n");
}

TEST_F(JobControlTexts, AreRefused) {
  EXPECT_THAT(folder.refusal(with("axes = 3\n")), HasSubstr("axes"));
  EXPECT_THAT(folder.refusal(with("table = 'nowhere.tbl'\n")), HasSubstr("nowhere.tbl"));
  EXPECT_THAT(folder.refusal(with("remap = 'M6'\n")), HasSubstr("remap is a table"));
  EXPECT_THAT(folder.refusal(with("tabel = 't.tbl'\n")), HasSubstr("no parameter 'tabel'"));
}

}  // namespace
}  // namespace proveout::io_test
