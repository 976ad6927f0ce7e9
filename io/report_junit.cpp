// junit.xml: one test case a check, in the form that CI systems read (the Ant / Surefire schema's common
// part).
#include <fmt/format.h>

#include <algorithm>

#include "io/report.h"
#include "io/report_text.h"

namespace proveout {

namespace {

using report_text::escape;

/// A check, and the kinds of findings that make it fail.
struct Check {
  std::string_view name;
  std::vector<std::string_view> kinds;
  bool made = false;
  std::string_view skipped_because;
};

std::vector<Check> checksOf(const Report& report) {
  const ReportChecks& made = report.checks;
  constexpr std::string_view kNoRemoval = "no stock was cut";
  constexpr std::string_view kNoNominal = "no nominal was compared";
  return {{"program", {"alarm", "forbidden_zone"}, made.interpreted, "the program was not run"},
          {"overtravel", {"overtravel"}, made.travel_limits, "the job gives no travel limits"},
          {"rapid contact", {"rapid_contact"}, made.removal, kNoRemoval},
          {"shank contact", {"shank_contact"}, made.removal, kNoRemoval},
          {"holder contact", {"holder_contact"}, made.removal, kNoRemoval},
          {"fixture contact", {"fixture_contact"}, made.fixtures, "the job has no fixtures"},
          {"spindle", {"spindle_off", "spindle_direction"}, made.removal, kNoRemoval},
          {"gouge", {"gouge"}, made.comparison, kNoNominal},
          {"excess", {"excess"}, made.comparison, kNoNominal},
          {"resolution", {"undecided"}, made.comparison, kNoNominal},
          {"mesh closed", {"mesh"}, made.mesh, "no mesh was made"}};
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
  if (finding.severity == Severity::kError) {
    outcome.fail(line);
  } else {
    outcome.notes += line + "\n";
  }
}

/// What a check finds beyond the findings of its kinds.
void addOwn(const Report& report, const Check& check, Outcome& outcome) {
  if (check.name == "program") {
    for (const Diagnostic& d : report.diagnostics) {
      if (d.severity == Severity::kError) outcome.fail(report_text::diagnosticLine(d));
    }
  }
  if (check.name == "resolution" && report.comparison && !report.comparison->decided) {
    const auto& grid = report.comparison->deciding_resolution_mm;
    outcome.fail(grid ? fmt::format("the grid cannot decide these tolerances; a grid of {:.4g} mm can", *grid)
                      : "the grid cannot decide these tolerances");
  }
  if (check.name == "mesh closed" && report.stock && !report.stock->closed) {
    outcome.fail("the exported mesh is not a closed, oriented 2-manifold");
  }
}

std::string caseXml(const Report& report, const Check& check, const Outcome& outcome) {
  std::string out = fmt::format("    <testcase classname=\"proveout.{}\" name=\"{}\"",
                                escape(report.name.empty() ? "job" : report.name), escape(check.name));
  if (!check.made && outcome.failures == 0) {
    return out + fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n",
                             escape(check.skipped_because));
  }
  if (outcome.failures == 0 && outcome.notes.empty()) return out + "/>\n";
  out += ">\n";
  if (outcome.failures > 0) {
    const std::string more = outcome.failures > 1 ? fmt::format(" (and {} more)", outcome.failures - 1) : "";
    out += fmt::format("      <failure message=\"{}\" type=\"{}\">{}</failure>\n",
                       escape(outcome.summary + more), escape(check.name), escape(outcome.details));
  }
  if (!outcome.notes.empty())
    out += fmt::format("      <system-out>{}</system-out>\n", escape(outcome.notes));
  return out + "    </testcase>\n";
}

}  // namespace

std::string reportJunit(const Report& report, const ReportOptions& options) {
  std::vector<Check> checks = checksOf(report);
  std::vector<Outcome> outcomes(checks.size());
  for (const Finding& finding : report.findings) {
    std::size_t at = 0;
    const auto names = [&](const Check& check) {
      return std::find(check.kinds.begin(), check.kinds.end(), finding.kind) != check.kinds.end();
    };
    while (at < checks.size() && !names(checks[at])) ++at;
    if (at == checks.size()) {
      // A kind that has no check of its own gets one, so that no finding is lost.
      checks.push_back({finding.kind, {finding.kind}, true, {}});
      outcomes.emplace_back();
    }
    addFinding(finding, outcomes[at]);
  }
  std::string cases;
  int failed = 0, skipped = 0;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    addOwn(report, checks[i], outcomes[i]);
    cases += caseXml(report, checks[i], outcomes[i]);
    if (outcomes[i].failures > 0) ++failed;
    if (outcomes[i].failures == 0 && !checks[i].made) ++skipped;
  }
  const std::string time = options.with_performance
                               ? fmt::format(" time=\"{}\"", report_text::fixed(report.performance.wall_s, 3))
                               : "";
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"{}",
                                         checks.size(), failed, skipped, time);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n  <testsuite name=\"proveout {1}\" "
      "{0}>\n{2}"
      "  </testsuite>\n</testsuites>\n",
      counts, escape(report.name), cases);
}

}  // namespace proveout
