#include "io/verdict.h"

#include <gtest/gtest.h>

#include "io/report.h"

namespace proveout {
namespace {

TEST(Verdict, FollowsFindingsAndDiagnostics) {
  Report r;
  EXPECT_EQ(verdictOf(r), Verdict::kPass);
  Finding f(FindingKind::kGouge);
  f.severity = Severity::kWarning;
  r.findings = {f};
  EXPECT_EQ(verdictOf(r), Verdict::kPass);
  r.findings[0].severity = Severity::kError;
  EXPECT_EQ(verdictOf(r), Verdict::kFail);
  r.findings.clear();
  r.comparison = ReportComparison();
  EXPECT_EQ(verdictOf(r), Verdict::kPass);
  r.comparison->decided = false;
  EXPECT_EQ(verdictOf(r), Verdict::kFail);
  f.kind = FindingKind::kAlarm;
  f.severity = Severity::kError;
  r.findings = {f};
  EXPECT_EQ(verdictOf(r), Verdict::kError);
  r.findings.clear();
  r.diagnostics = {Diagnostic{}};
  EXPECT_EQ(verdictOf(r), Verdict::kError);
}

}  // namespace
}  // namespace proveout
