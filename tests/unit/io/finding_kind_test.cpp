#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "io/report.h"

namespace proveout {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The names of a report's test cases, in their order.
std::vector<std::string> caseNames(const Report& report) {
  const std::string xml = reportJunit(report);
  static const std::regex name("<testcase classname=\"[^\"]*\" name=\"([^\"]*)\"");
  std::vector<std::string> names;
  for (std::sregex_iterator at(xml.begin(), xml.end(), name), end; at != end; ++at) names.push_back((*at)[1]);
  return names;
}

/// What every reader of report.json may have written down: no name and no severity changes unseen.
TEST(FindingKinds, HaveTheNamesOfTheSchema) {
  std::string all;
  for (const FindingKindInfo& info : findingKinds())
    all += std::string(info.name) + " " + std::string(severityName(info.severity)) + "\n";
  EXPECT_EQ(
      all,
      "gouge error\nexcess error\nundecided warning\ncharacteristic error\nrapid_contact "
      "error\nshank_contact error\n"
      "holder_contact error\nfixture_contact error\nspindle_off error\nspindle_direction error\n"
      "insert_contact error\naxis_crossing error\ncut_off_piece error\nthreading error\nwire_supply error\n"
      "free_slug warning\nstuck_slug warning\nbridge warning\nnose_deviation warning\ntool_data "
      "error\nfeed_rate warning\nspindle_speed warning\ncycle_time "
      "warning\ndwell warning\ntool_change warning\ndrill_sideways warning\nprogram_unit warning\npart_off "
      "note\ncoarse_nominal note\n"
      "not_compared note\nnominal_placement error\novertravel error\nclamped_axis error\nforbidden_zone "
      "error\nalarm error\nno_part error\n"
      "thin_feature warning\nnothing_cut warning\nloose_piece warning\nuncertain_part warning\npartial "
      "warning\nmesh error\n"
      "output error\n");
}

TEST(FindingKinds, HaveANameAMeaningAndACheckEach) {
  static const std::regex word("[a-z]+(_[a-z]+)*");
  std::set<std::string_view> names, meanings;
  for (const FindingKindInfo& info : findingKinds()) {
    EXPECT_TRUE(std::regex_match(std::string(info.name), word)) << info.name;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_TRUE(meanings.insert(info.meaning).second) << info.name;
    EXPECT_GT(info.meaning.size(), 15u) << info.name;
    EXPECT_THAT(info.meaning, Not(HasSubstr("|"))) << info.name << ": it stands in a table";
    EXPECT_FALSE(checkName(info.kind).empty()) << info.name;
    EXPECT_EQ(&findingKindInfo(info.kind), &info);
    EXPECT_EQ(findingKindName(info.kind), info.name);
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(FindingKind::kCount));
}

TEST(FindingKinds, OnlyDeviationsAreMeasuredAgainstNominal) {
  std::set<std::string_view> names;
  for (const FindingKindInfo& info : findingKinds()) {
    if (isDeviation(info.kind)) names.insert(info.name);
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"gouge", "excess", "undecided", "characteristic"}));
}

TEST(FindingKinds, FailTheTestCaseOfTheirCheck) {
  const std::vector<std::string> always = caseNames({});
  EXPECT_EQ(always.size(), static_cast<std::size_t>(JunitCheck::kOwn));
  for (std::size_t i = 0; i < always.size(); ++i) EXPECT_EQ(always[i], checkName(static_cast<JunitCheck>(i)));
  EXPECT_EQ(checkName(JunitCheck::kOwn), "");
  for (const FindingKindInfo& info : findingKinds()) {
    Report report;
    report.findings.emplace_back(info.kind).severity = Severity::kError;
    const bool own = info.check == JunitCheck::kOwn;
    EXPECT_EQ(caseNames(report).size(), always.size() + (own ? 1 : 0)) << info.name;
    EXPECT_THAT(reportJunit(report),
                HasSubstr("type=\"" + std::string(own ? info.name : checkName(info.check)) + "\""));
  }
}

TEST(FindingKinds, GiveAFindingItsSeverity) {
  EXPECT_EQ(Finding(FindingKind::kGouge).severity, Severity::kError);
  EXPECT_EQ(Finding(FindingKind::kThinFeature).severity, Severity::kWarning);
  EXPECT_EQ(Finding(FindingKind::kPartOff).severity, Severity::kNote);
}

std::string document(const std::string& name) {
  std::ifstream file(std::string(PROVEOUT_SOURCE_DIR) + "/docs/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The lines of the table that begins with `head`, without its ruler.
std::vector<std::string> tableRows(const std::string& text, const std::string& head) {
  std::istringstream lines(text.substr(std::min(text.size(), text.find(head))));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line) && line.starts_with("|");) rows.push_back(line);
  rows.erase(rows.begin(), rows.begin() + std::min<std::ptrdiff_t>(2, std::ssize(rows)));
  return rows;
}

TEST(FindingKinds, StandInTheReferenceAsTheyAre) {
  const std::vector<std::string> rows =
      tableRows(document("reference/report.md"), "| kind | severity | check | meaning |\n");
  ASSERT_EQ(rows.size(), findingKinds().size())
      << "docs/reference/report.md has a row a kind, in their order";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const FindingKindInfo& info = findingKinds()[i];
    const std::string begin = "| `" + std::string(info.name) + "` | " +
                              std::string(severityName(info.severity)) + " | " +
                              std::string(checkName(info.kind)) + " | " + std::string(info.meaning);
    ASSERT_TRUE(rows[i].starts_with(begin)) << "docs/reference/report.md says\n"
                                            << rows[i] << "\nthe table\n"
                                            << begin;
    const std::string more = rows[i].substr(begin.size());
    EXPECT_TRUE(more == " |" || std::string_view(";:,.").find(more[0]) != std::string_view::npos ||
                more.starts_with(" ("))
        << rows[i];
  }
}

TEST(FindingKinds, ReferenceNamesTheChecks) {
  const std::string text = document("reference/report.md");
  for (std::size_t i = 0; i < static_cast<std::size_t>(JunitCheck::kOwn); ++i)
    EXPECT_THAT(text, HasSubstr("`" + std::string(checkName(static_cast<JunitCheck>(i))) + "`"));
}

/// What the user guide says of findings on a lathe.
TEST(FindingKinds, AreAllThatTheUserGuideKnows) {
  const std::vector<std::string> rows =
      tableRows(document("user-guide.md"), "| finding | what happened | usual reason |\n");
  EXPECT_GE(rows.size(), 5u);
  static const std::regex quoted("`([^`]*)`");
  std::set<std::string> known;
  for (const FindingKindInfo& info : findingKinds()) known.emplace(info.name);
  for (const std::string& row : rows) {
    const std::string cell = row.substr(1, row.find('|', 1) - 1);
    for (std::sregex_iterator at(cell.begin(), cell.end(), quoted), end; at != end; ++at)
      EXPECT_TRUE(known.contains((*at)[1])) << (*at)[1];
  }
}

}  // namespace
}  // namespace proveout
