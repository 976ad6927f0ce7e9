#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stack>

#include "io/report_text.h"
#include "report_sample.h"

namespace proveout {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Well-formedness as far as our writers can break it: tags nest, no bare `<` or `&`, attributes are quoted.
/// Returns what is wrong, or "".
std::string wellFormed(const std::string& xml) {
  std::stack<std::string> open;
  for (std::size_t at = 0; at < xml.size();) {
    if (xml[at] == '&') {
      const std::size_t end = xml.find(';', at);
      if (end == std::string::npos || end - at > 6) return "bare & at " + xml.substr(at, 20);
      at = end + 1;
    } else if (xml[at] != '<') {
      ++at;
    } else {
      const std::size_t end = xml.find('>', at);
      if (end == std::string::npos) return "open tag";
      const std::string tag = xml.substr(at + 1, end - at - 1);
      if (tag.find('<') != std::string::npos) return "< inside " + tag;
      if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "quotes of " + tag;
      const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
      if (tag[0] == '/') {
        if (open.empty() || open.top() != tag.substr(1)) return "closes " + tag;
        open.pop();
      } else if (tag[0] != '?' && tag.back() != '/') {
        open.push(name);
      }
      at = end + 1;
    }
  }
  return open.empty() ? "" : "not closed: " + open.top();
}

TEST(ReportJunit, HasOneCaseACheck) {
  const std::string xml = reportJunit(io_test::sampleReport());
  EXPECT_EQ(wellFormed(xml), "") << xml;
  for (const char* name : {"program", "overtravel", "rapid contact", "shank contact", "holder contact",
                           "fixture contact", "spindle", "gouge", "excess", "resolution", "mesh closed"}) {
    EXPECT_THAT(xml, HasSubstr(std::string("name=\"") + name + "\""));
  }
  EXPECT_THAT(xml, HasSubstr("tests=\"11\" failures=\"2\" errors=\"0\" skipped=\"0\" time=\"3.250\""));
}

TEST(ReportJunit, FailuresCarryTheFindings) {
  const std::string xml = reportJunit(io_test::sampleReport());
  EXPECT_THAT(
      xml,
      HasSubstr("<failure message=\"O0100.nc:12 (N70): error: gouge: 0.250 mm below nominal over 30.5 mm2 "
                "[depth 0.25 mm, area 30.5 mm2, volume 4.125 mm3, at x 20.125 y 31.500 z -5.250]\" "
                "type=\"gouge\">"));
  EXPECT_THAT(xml, HasSubstr("bracket.nc:40: error: rapid contact: tool 2 touches stock in rapid"));
  // A warning is told and does not fail.
  EXPECT_THAT(xml, HasSubstr("<system-out>warning: spindle off: cut without spindle\n</system-out>"));
}

TEST(ReportJunit, ChecksThatWereNotMadeAreSkipped) {
  Report r;
  r.name = "x";
  const std::string xml = reportJunit(r, {false});
  EXPECT_EQ(wellFormed(xml), "");
  EXPECT_THAT(xml, HasSubstr("tests=\"11\" failures=\"0\" errors=\"0\" skipped=\"10\">"));
  EXPECT_THAT(xml, HasSubstr("<skipped message=\"no nominal was compared\"/>"));
}

TEST(ReportJunit, FailsOnAlarmsOpenMeshesAndUndecidedComparisons) {
  Report r = io_test::sampleReport();
  r.findings.clear();
  Diagnostic d;
  d.code = "nct-2017";
  d.message = "bad block";
  d.where.file = "a.nc";
  d.where.line = 3;
  r.diagnostics = {d};
  r.stock->closed = false;
  r.comparison->decided = false;
  r.comparison->deciding_resolution_mm = 0.05;
  const std::string xml = reportJunit(r);
  EXPECT_THAT(xml, HasSubstr("failures=\"3\""));
  EXPECT_THAT(xml, HasSubstr("a.nc:3: error[nct-2017]: bad block"));
  EXPECT_THAT(xml, HasSubstr("not a closed, oriented 2-manifold"));
  EXPECT_THAT(xml, HasSubstr("a grid of 0.05 mm can"));
}

TEST(ReportJunit, NoFindingIsLost) {
  Report r = io_test::sampleReport();
  r.findings[0].kind = FindingKind::kNoPart;
  const std::string xml = reportJunit(r);
  EXPECT_THAT(xml, HasSubstr("tests=\"12\""));
  EXPECT_THAT(xml, HasSubstr("name=\"no_part\""));
  // An error of a check that was not made is still a failure.
  r.checks.comparison = false;
  r.findings[0].kind = FindingKind::kExcess;
  EXPECT_THAT(reportJunit(r), HasSubstr("type=\"excess\""));
}

TEST(ReportJunit, EscapesEverything) {
  Report r = io_test::sampleReport();
  r.name = "]]> <b> \"q\" 'a' & \x01 \xff";
  r.findings[0].message = "</failure><evil attr=\"1\"> & \x1b[31m";
  r.findings[0].source->file = "a\"b<c.nc";
  const std::string xml = reportJunit(r);
  EXPECT_EQ(wellFormed(xml), "") << xml;
  EXPECT_THAT(xml, Not(HasSubstr("<evil")));
  EXPECT_THAT(xml, Not(HasSubstr("\x1b")));
}

TEST(ReportText, EscapesForXml) {
  using report_text::escape;
  EXPECT_EQ(escape("<a b=\"c\">'&"), "&lt;a b=&quot;c&quot;&gt;&#39;&amp;");
  EXPECT_EQ(escape("\xd0\x94\xe4\xb8\xad\xf0\x9f\x98\x80\t\n"), "\xd0\x94\xe4\xb8\xad\xf0\x9f\x98\x80\t\n");
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(escape(std::string("\0", 1)), bad);
  EXPECT_EQ(escape("\xc0\x80"), bad + bad);            // overlong
  EXPECT_EQ(escape("\xed\xa0\x80"), bad + bad + bad);  // surrogate
  EXPECT_EQ(escape("\xf5"), bad);
  EXPECT_EQ(escape("\xe4\xb8"), bad + bad);  // cut short
  EXPECT_EQ(escape("\xEF\xBF\xBF"), bad);    // no character of XML 1.0
}

TEST(ReportText, WritesNumbers) {
  using namespace report_text;
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-1.5, 1), "-1.5");
  EXPECT_EQ(fixed(std::nan(""), 1), "-");
  const std::string gap = "\u202F";
  EXPECT_EQ(grouped(1234567.891, 2), "1" + gap + "234" + gap + "567.89");
  EXPECT_EQ(grouped(-123456, 0), "-123" + gap + "456");
  EXPECT_EQ(grouped(123, 0), "123");
  EXPECT_EQ(duration(3.25), "3.2 s");
  EXPECT_EQ(duration(123.4), "2 min 03 s");
  EXPECT_EQ(duration(3723), "1 h 02 min 03 s");
  EXPECT_EQ(duration(-1), "-");
}

}  // namespace
}  // namespace proveout
