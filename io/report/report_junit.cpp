// junit.xml: one test case a check, in the form that CI systems read (the Ant / Surefire schema's common
// part).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "io/report.h"
#include "io/report_text.h"

namespace proveout {

namespace {

using report_text::escape;

/// A test case: one of the checks of every run, or a kind's own.
struct Case {
  JunitCheck check = JunitCheck::kOwn;
  std::string_view name;
  bool made = false;
  std::string_view skipped_because;
};

/// Which look at the job makes a check, and what is said where that was not taken.
struct CheckRow {
  JunitCheck check;
  bool ReportChecks::*made;
  std::string_view skipped_because;
};

constexpr std::string_view kNoRemoval = "no stock was cut";
constexpr std::string_view kNoNominal = "no nominal was compared";
constexpr std::array<CheckRow, static_cast<std::size_t>(JunitCheck::kOwn)> kChecks{{
    {JunitCheck::kProgram, &ReportChecks::interpreted, "the program was not run"},
    {JunitCheck::kOvertravel, &ReportChecks::travel_limits, "the job gives no travel limits"},
    {JunitCheck::kRapidContact, &ReportChecks::removal, kNoRemoval},
    {JunitCheck::kShankContact, &ReportChecks::removal, kNoRemoval},
    {JunitCheck::kHolderContact, &ReportChecks::removal, kNoRemoval},
    {JunitCheck::kFixtureContact, &ReportChecks::fixtures, "the job has no fixtures"},
    {JunitCheck::kSpindle, &ReportChecks::removal, kNoRemoval},
    {JunitCheck::kGouge, &ReportChecks::comparison, kNoNominal},
    {JunitCheck::kExcess, &ReportChecks::comparison, kNoNominal},
    {JunitCheck::kResolution, &ReportChecks::comparison, kNoNominal},
    {JunitCheck::kMeshClosed, &ReportChecks::mesh, "no mesh was made"},
}};

/// The cases that every run has.
std::vector<Case> casesOf(const ReportChecks& checks) {
  std::vector<Case> cases;
  for (const CheckRow& row : kChecks)
    cases.push_back({row.check, checkName(row.check), checks.*row.made, row.skipped_because});
  return cases;
}

/// The place of the kind's case. A kind that has none yet gets one, so that no finding is lost.
std::size_t caseOf(FindingKind kind, std::vector<Case>& cases) {
  const std::string_view name = checkName(kind);
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& c) { return c.name == name; });
  const auto at = static_cast<std::size_t>(found - cases.begin());
  if (found == cases.end()) cases.push_back({JunitCheck::kOwn, name, true, {}});
  return at;
}

struct Outcome {
  std::string summary;  ///< of the failure; empty: passed
  std::string details;
  std::string notes;  ///< findings below error
  int failures = 0;

  void fail(const std::string& line) {
    if (summary.empty()) summary = line;
    details += line + "\n";
    ++failures;
  }
};

void addFinding(const Finding& finding, Outcome& outcome) {
  const std::string line = report_text::summaryLine(finding);
  if (finding.severity == Severity::kError && !finding.known) {
    outcome.fail(line);
  } else {
    outcome.notes += line + "\n";
  }
}

/// What a check finds beyond the findings of its kinds.
void addOwn(const Report& report, const Case& test, Outcome& outcome) {
  if (test.check == JunitCheck::kProgram) {
    for (const Diagnostic& d : report.diagnostics) {
      if (d.severity == Severity::kError) outcome.fail(report_text::diagnosticLine(d));
    }
  }
  if (test.check == JunitCheck::kResolution && report.comparison && !report.comparison->decided) {
    const auto& grid = report.comparison->deciding_resolution_mm;
    outcome.fail(grid ? fmt::format("the grid cannot decide these tolerances; a grid of {:.4g} mm can", *grid)
                      : "the grid cannot decide these tolerances");
  }
  if (test.check == JunitCheck::kMeshClosed && report.stock && !report.stock->closed) {
    outcome.fail("the exported mesh is not a closed, oriented 2-manifold");
  }
}

std::string caseXml(const Report& report, const Case& test, const Outcome& outcome) {
  std::string out = fmt::format("    <testcase classname=\"proveout.{}\" name=\"{}\"",
                                escape(report.name.empty() ? "job" : report.name), escape(test.name));
  if (!test.made && outcome.failures == 0) {
    return out +
           fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n", escape(test.skipped_because));
  }
  if (outcome.failures == 0 && outcome.notes.empty()) return out + "/>\n";
  out += ">\n";
  if (outcome.failures > 0) {
    const std::string more = outcome.failures > 1 ? fmt::format(" (and {} more)", outcome.failures - 1) : "";
    out += fmt::format("      <failure message=\"{}\" type=\"{}\">{}</failure>\n",
                       escape(outcome.summary + more), escape(test.name), escape(outcome.details));
  }
  if (!outcome.notes.empty())
    out += fmt::format("      <system-out>{}</system-out>\n", escape(outcome.notes));
  return out + "    </testcase>\n";
}

}  // namespace

std::string reportJunit(const Report& report, const ReportOptions& options) {
  std::vector<Case> cases = casesOf(report.checks);
  std::vector<Outcome> outcomes(cases.size());
  for (const Finding& finding : report.findings) {
    const std::size_t at = caseOf(finding.kind, cases);
    outcomes.resize(cases.size());
    addFinding(finding, outcomes[at]);
  }
  std::string text;
  int failed = 0, skipped = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    PROVEOUT_ASSERT(i < outcomes.size());
    addOwn(report, cases[i], outcomes[i]);
    text += caseXml(report, cases[i], outcomes[i]);
    if (outcomes[i].failures > 0) ++failed;
    if (outcomes[i].failures == 0 && !cases[i].made) ++skipped;
  }
  const std::string time = options.with_performance
                               ? fmt::format(" time=\"{}\"", report_text::fixed(report.performance.wall_s, 3))
                               : "";
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"{}",
                                         cases.size(), failed, skipped, time);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n  <testsuite name=\"proveout {1}\" "
      "{0}>\n{2}"
      "  </testsuite>\n</testsuites>\n",
      counts, escape(report.name), text);
}

}  // namespace proveout
