#include <gtest/gtest.h>

#include <sstream>

#include "app/console.h"
#include "app/summary.h"

namespace proveout {
namespace {

TEST(PrintDiagnostics, TellsTheSameOfTheSameBlockOnce) {
  std::ostringstream out, err;
  Console console{out, err};
  Diagnostic first, second;
  first.code = "nct-2017";
  first.message = "illegal address";
  second = first;
  second.where.line = 7;
  printDiagnostics(console, {first, second, first, first});
  const std::string text = err.str();
  EXPECT_EQ(text.find("illegal address"), text.rfind("illegal address", text.size() / 2));
  EXPECT_NE(text.find("note: told 3 times"), std::string::npos);
  EXPECT_EQ(text.find("told"), text.rfind("told"));
}

TEST(ConsoleProgress, SilentUnlessShown) {
  std::ostringstream err;
  ConsoleProgress progress(err);
  progress.report("cutting", 0.5);
  progress.clear();
  EXPECT_EQ(err.str(), "");
}

TEST(ConsoleProgress, OverwritesItsLineAndTakesItAway) {
  std::ostringstream err;
  ConsoleProgress progress(err);
  progress.show(true);
  progress.report("interpreting", 0.5);
  progress.report("interpreting", 0.501);  // no news
  progress.report("cut", 0.01);
  progress.clear();
  EXPECT_EQ(err.str(), "\rinterpreting 50 %\rcut 1 %          \r                 \r");
}

TEST(Summary, CountsWhatItDoesNotPrint) {
  std::ostringstream out, err;
  Console console{out, err};
  Report report;
  for (int i = 0; i < 25; ++i) {
    Finding finding(FindingKind::kGouge);
    finding.message = "deep";
    report.findings.push_back(finding);
  }
  printFindings(console, report, Severity::kNote);
  EXPECT_NE(err.str().find("5 more, see the report"), std::string::npos);
  EXPECT_EQ(out.str(), "");
}

TEST(Summary, QuietPrintsErrorsOnly) {
  std::ostringstream out, err;
  Console console{out, err};
  Report report;
  Finding warning(FindingKind::kThinFeature);
  warning.message = "not so bad";
  Finding error(FindingKind::kGouge);
  error.message = "really bad";
  report.findings = {warning, error};
  printFindings(console, report, Severity::kError);
  EXPECT_EQ(err.str().find("not so bad"), std::string::npos);
  EXPECT_NE(err.str().find("really bad"), std::string::npos);
}

}  // namespace
}  // namespace proveout
