#include "app/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/session/findings/findings.h"
#include "core/base/printable.h"
#include "core/geometry/place_text.h"
#include "io/report/alignment_text.h"
#include "io/report_text.h"

namespace proveout {
namespace {

constexpr int kMaxPrinted = 20;

/// "1:02:03" or "2:03".
std::string clock(double seconds) {
  const auto total = static_cast<long long>(std::llround(seconds));
  const long long h = total / 3600, m = total / 60 % 60, s = total % 60;
  return h > 0 ? fmt::format("{}:{:02}:{:02} h", h, m, s) : fmt::format("{}:{:02} min", m, s);
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string findingCounts(const Report& report) {
  std::size_t errors = 0, others = 0;
  for (const Finding& finding : report.findings) {
    if (!finding.known) ++(finding.severity == Severity::kError ? errors : others);
  }
  // What the control said; its errors are findings already.
  others += static_cast<std::size_t>(
      std::count_if(report.diagnostics.begin(), report.diagnostics.end(),
                    [](const Diagnostic& diagnostic) { return diagnostic.severity != Severity::kError; }));
  if (errors + others == 0) return "none";
  return fmt::format("{}, {}", counted(errors, "error", "errors"),
                     counted(others, "warning or note", "warnings or notes"));
}

/// Of slugs that taper holds.
std::string heldText(const std::vector<StockBody>& bodies) {
  std::string text;
  for (const auto& way : {std::pair("up", "only upwards"), std::pair("down", "only downwards"),
                          std::pair("none", "neither up nor down")}) {
    const auto count = std::count_if(bodies.begin(), bodies.end(),
                                     [&](const StockBody& body) { return body.leaves == way.first; });
    if (count > 0) text += fmt::format(", {} {} {}", count, count == 1 ? "leaves" : "leave", way.second);
  }
  return text;
}

/// The part alone: a bar or a slug beside it is told as such.
std::string partText(const ReportStock& stock) {
  const auto part = std::find_if(stock.bodies.begin(), stock.bodies.end(),
                                 [](const StockBody& body) { return body.role == "part"; });
  if (part == stock.bodies.end()) return fmt::format("{:.2f} mm3", stock.final_mm3);
  const std::string text = fmt::format("{:.2f} mm3, {}", part->volume_mm3, extentText(part->bounds));
  if (stock.bodies.size() == 1) return text + ", in 1 piece";
  return text +
         fmt::format(", beside {} of {:.2f} mm3",
                     counted(stock.bodies.size() - 1, "other piece", "other pieces"),
                     stock.final_mm3 - part->volume_mm3) +
         heldText(stock.bodies);
}

/// What the mesh file has: the part, unless nothing says which of several bodies that is.
std::string meshText(const Report& report) {
  const ReportStock& stock = *report.stock;
  const std::optional<double> facets = report_text::facetsMm(report);
  const std::string of = stock.mesh_bodies > 1 ? fmt::format(" of all {} pieces", stock.mesh_bodies) : "",
                    fineness = facets ? "facets within " + report_text::figure(*facets)
                                      : fmt::format("grid {:g}", report.resolution_mm);
  return fmt::format("mesh{} {} triangles, {}, {} mm", of, stock.triangles,
                     stock.closed ? "closed" : "NOT closed", fineness);
}

/// What the baseline has and the run has not.
Diagnostic goneNote(const KnownFinding& known) {
  Diagnostic note;
  note.severity = Severity::kNote;
  note.code = "gone";
  note.message = "known, and not found any more: " + report_text::goneLine(known);
  return note;
}

}  // namespace

std::string summaryText(const Report& report, const std::string& folder) {
  const std::string& until = report.program.until;
  std::string text = fmt::format("{}: {}{}\n", printable(report.name), verdictName(report.verdict),
                                 until.empty() ? "" : ", partial: only up to " + printable(until));
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<10} {}\n", what, printable(value));
  };
  if (!report.program.files.empty()) {
    row("program", fmt::format("{} ({}), {}, {}", report.program.files.front(), report.program.control,
                               counted(report.program.blocks, "block", "blocks"),
                               counted(report.program.motions, "motion", "motions")));
    row("time", fmt::format("{} in the machine: cutting {}, rapid {}", clock(report.time.cycle_s),
                            clock(report.time.cutting_s), clock(report.time.rapid_s)));
  }
  if (const auto& stock = report.stock) {
    row("blank", fmt::format("{:.2f} mm3, removed {} mm3", stock->initial_mm3,
                             report_text::fixed(stock->removed_mm3, 2)));
    row("part", partText(*stock) + "; " + meshText(report));
  }
  if (const auto& c = report.comparison) {
    row("nominal", fmt::format("gouge {} mm (allowed {:g}), excess {} mm (allowed {:g}), rms {} mm{}",
                               report_text::figure(c->max_gouge_mm), c->gouge_tolerance_mm,
                               report_text::figure(c->max_excess_mm), c->excess_tolerance_mm,
                               report_text::figure(c->rms_mm), c->decided ? "" : ", undecided on this grid"));
  }
  if (report.comparison && report.comparison->scan)
    row("scan", report_text::scanLine(*report.comparison->scan));
  if (report.comparison && report.comparison->alignment)
    row("aligned", report_text::alignmentLine(*report.comparison->alignment));
  row("findings", findingCounts(report));
  for (const std::string& line : report_text::acceptanceLines(report.acceptance)) row("accepted", line);
  // Without report.html (no room on the disk) there may still be others.
  if (!folder.empty()) row("results", (std::filesystem::path(folder) / report.outputs.html).string());
  return text;
}

void printFindings(Console& console, const Report& report, Severity least) {
  int printed = 0, left = 0;
  const auto print = [&](const Diagnostic& diagnostic) {
    if (diagnostic.severity < least) return;
    if (printed == kMaxPrinted) {
      ++left;
      return;
    }
    ++printed;
    console.err << formatDiagnostic(diagnostic);
  };
  for (const Diagnostic& diagnostic : report.diagnostics) print(diagnostic);
  for (const Finding& finding : report.findings) {
    if (finding.kind != FindingKind::kAlarm)
      print(findingDiagnostic(finding));  // alarms are diagnostics already
  }
  const auto& baseline = report.acceptance.baseline;
  for (std::size_t k = 0; baseline && k < baseline->gone.size(); ++k) print(goneNote(baseline->gone[k]));
  if (left > 0) console.err << fmt::format("proveout: {} more, see the report\n", left);
}

void printResult(Console& console, const Report& report, bool quiet, bool json, const std::string& folder) {
  printFindings(console, report, quiet ? Severity::kError : Severity::kNote);
  if (json) {
    console.out << reportJson(report);
  } else if (!quiet) {
    console.out << summaryText(report, folder);
  }
}

}  // namespace proveout
