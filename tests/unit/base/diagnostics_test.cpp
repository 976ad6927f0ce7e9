#include "core/base/diagnostics.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

Diagnostic sample() {
  Diagnostic d;
  d.code = "nct-2017";
  d.message = "no plane";
  d.where = {"O0100", 12, 8, 11};
  d.source_line = "N70 G2 X1Y R5";
  return d;
}

TEST(Diagnostics, ReadsLikeACompilerMessage) {
  EXPECT_EQ(formatDiagnostic(sample()),
            "O0100:12:8: error[nct-2017]: no plane\n"
            "    N70 G2 X1Y R5\n"
            "           ^~~\n");
}

TEST(Diagnostics, LeavesOutWhatIsNotKnown) {
  Diagnostic d = sample();
  d.where = {};
  EXPECT_EQ(formatDiagnostic(d), "error[nct-2017]: no plane\n");
  d.code.clear();
  d.severity = Severity::kWarning;
  d.where.file = "job.toml";
  EXPECT_EQ(formatDiagnostic(d), "job.toml: warning: no plane\n");
  d.where.line = 3;
  EXPECT_EQ(formatDiagnostic(d), "job.toml:3: warning: no plane\n    N70 G2 X1Y R5\n");
  d.source_line.clear();
  d.where.column = 4;
  EXPECT_EQ(formatDiagnostic(d), "job.toml:3:4: warning: no plane\n");
}

TEST(Diagnostics, PrintsNotesLast) {
  Diagnostic d = sample();
  d.severity = Severity::kNote;
  d.notes = {"called from O0001:4", "called from O0000:9"};
  const std::string text = formatDiagnostic(d);
  EXPECT_NE(text.find(" note[nct-2017]: no plane\n"), std::string::npos);
  EXPECT_TRUE(text.ends_with("^~~\n    note: called from O0001:4\n    note: called from O0000:9\n"));
}

TEST(Diagnostics, CaretFollowsTabsAndCyrillic) {
  Diagnostic d = sample();
  d.source_line = "\t(\xD0\x94\xD0\xB0) G999";  // tab, "(Da)" in Cyrillic, G999 at byte 9
  d.where.column = 9;
  d.where.column_end = 13;
  EXPECT_NE(formatDiagnostic(d).find("\n    \t     ^~~~\n"), std::string::npos) << formatDiagnostic(d);
}

TEST(Diagnostics, CaretStaysBehindAShortLine) {
  Diagnostic d = sample();
  d.source_line = "G1";
  d.where.column = 40;
  d.where.column_end = 50;
  EXPECT_TRUE(formatDiagnostic(d).ends_with("    G1\n      ^\n"));
  d.where.column = 2;
  d.where.column_end = 0;
  EXPECT_TRUE(formatDiagnostic(d).ends_with("    G1\n     ^\n"));
}

TEST(Diagnostics, ShowsAWindowOfALongLine) {
  Diagnostic d = sample();
  d.source_line = std::string(5000, 'a') + "BAD" + std::string(5000, 'c');
  d.where.column = 5001;
  d.where.column_end = 5004;
  const std::string text = formatDiagnostic(d);
  EXPECT_LT(text.size(), 500u);
  const std::size_t line = text.find("    ...a"), bad = text.find("BAD"), caret = text.find("^~~\n");
  ASSERT_NE(line, std::string::npos);
  ASSERT_NE(caret, std::string::npos);
  const std::size_t caret_line = text.rfind('\n', caret) + 1;
  EXPECT_EQ(bad - line, caret - caret_line);
}

TEST(Diagnostics, DoesNotPassOnTerminalControls) {
  Diagnostic d = sample();
  d.source_line = "G1\x1b[2J X1\r";
  EXPECT_EQ(formatDiagnostic(d).find('\x1b'), std::string::npos);
  EXPECT_EQ(formatDiagnostic(d).find('\r'), std::string::npos);
}

TEST(Diagnostics, CountsErrorsOnly) {
  Diagnostics all;
  EXPECT_FALSE(all.hasErrors());
  Diagnostic d = sample();
  d.severity = Severity::kWarning;
  all.add(d);
  EXPECT_FALSE(all.hasErrors());
  all.add(sample());
  EXPECT_EQ(all.errorCount(), 1);
  EXPECT_EQ(all.all().size(), 2u);
}

}  // namespace
}  // namespace proveout
