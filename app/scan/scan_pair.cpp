#include "app/scan/scan_pair.h"

#include <fmt/format.h>

#include <cmath>

#include "app/session/nominal/nominal_mesh.h"
#include "io/report_text.h"

namespace proveout {

namespace {

using report_text::figure;

ScanOptions scanOptions(const CompareCommandOptions& options, const NominalSpec& spec,
                        const PreparedMesh& model) {
  ScanOptions out;
  out.compare.gouge_mm = options.gouge_mm;
  out.compare.excess_mm = options.excess_mm;
  out.compare.resolution_mm = options.resolution_mm;
  out.compare.threads = options.threads.value_or(0);
  out.compare.nominal_faces = model.faces;
  out.compare.ignored = spec.ignored;
  out.reach_mm = options.scan_reach_mm.value_or(0.0);
  return out;
}

/// Scans of another part, or of this one elsewhere: of most points nothing could be told.
std::string elsewhere(const ScanComparison& scan, const CompareOptions& options) {
  if (scan.points >= scan.off && scan.points > 0) return {};
  return fmt::format(
      "the scan does not lie where the model does, and is not compared: {} of {} points are more than {:g} "
      "mm off; "
      "check its unit (--unit), where the model lies (--nominal-at, --nominal-rotate), or bring them near to "
      "each "
      "other and let --align fit do the rest",
      scan.off, scan.off + scan.points, scanOffLimit(options));
}

}  // namespace

Result<ScanResult> compareWithScan(const CompareCommandOptions& options, const NominalSpec& spec,
                                   const ScanFile& scan, PreparedMesh& model, Progress& progress) {
  ScanResult out;
  const std::vector<Vec3> points = scanPointsOf(scan.mesh, options.resolution_mm);
  if (spec.align.kind != AlignKind::kNone) {
    Result<AlignOutcome> outcome = alignToScan(spec, points, model, progress);
    if (!outcome) return outcome.error();
    out.alignment = outcome->alignment;
    out.fault = std::move(outcome->fault);
    if (!out.fault.empty()) return out;
  }
  const ScanOptions settings = scanOptions(options, spec, model);
  progress.report("comparing", 0.0);
  Result<ScanComparison> found = compareScan(points, model.mesh, settings, progress);
  if (!found) return found.error();
  out.fault = elsewhere(*found, settings.compare);
  if (out.fault.empty()) out.scan = std::move(*found);
  return out;
}

ReportScan reportScan(const std::string& path, const ScanFile& file, const ScanComparison& scan) {
  ReportScan out;
  out.file = path;
  out.mesh = file.meshed;
  out.points = scan.points;
  out.off = scan.off;
  out.coverage = scan.coverage;
  out.reach_mm = scan.reach_mm;
  return out;
}

void addScanNotes(const ScanComparison& scan, const CompareOptions& options, std::vector<Finding>& findings,
                  Diagnostics& notes) {
  constexpr double kAll = 0.99, kMuch = 0.9;
  if (scan.coverage < kAll) {
    Finding finding(FindingKind::kNotCompared);
    if (scan.coverage < kMuch) finding.severity = Severity::kWarning;
    finding.message = fmt::format(
        "{:.1f} % of the nominal's surface have no point of the scan within {} mm: nothing is known of them, "
        "and they "
        "are not judged",
        std::ceil(1000.0 * (1.0 - scan.coverage)) / 10.0, figure(scan.reach_mm));
    findings.push_back(std::move(finding));
  }
  if (scan.off == 0) return;
  addMeshWarnings(
      {fmt::format("{} of {} points of the scan are more than {:g} mm off the nominal: they are taken for "
                   "fixture, table or dust, and are not judged",
                   scan.off, scan.off + scan.points, scanOffLimit(options))},
      "scan", notes);
}

std::string scanHint(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (extension != "ply" && extension != "stl") return {};
  return "; points or an open mesh as a scanner gives them are compared by `compare MODEL SCAN --scan`";
}

}  // namespace proveout
