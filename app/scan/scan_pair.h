// A scan against a model: `compare MODEL SCAN --scan`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli_options.h"
#include "app/session/nominal/alignment.h"
#include "core/base/progress.h"
#include "io/scan_file.h"
#include "removal/compare/fit/scan.h"

namespace proveout {

/// What a comparison with a scan came to: it, or a fault.
struct ScanResult {
  std::optional<ScanComparison> scan;
  std::optional<Alignment> alignment;
  std::string fault;  ///< why nothing was compared: a sentence, with what to do
};

/// Aligns the model to the scan where `spec` asks for it (then `model` is moved), and compares. Errors:
/// interrupted; datums.
Result<ScanResult> compareWithScan(const CompareCommandOptions& options, const NominalSpec& spec,
                                   const ScanFile& scan, PreparedMesh& model, Progress& progress);

ReportScan reportScan(const std::string& path, const ScanFile& file, const ScanComparison& scan);

/// What the scan does not show: a finding where more than a hundredth of the surface is not covered, which is
/// a warning from a tenth on; and a warning of points that were too far off.
void addScanNotes(const ScanComparison& scan, const CompareOptions& options, std::vector<Finding>& findings,
                  Diagnostics& notes);

/// A file that is refused as a solid may be a scan: what to add to the message.
std::string scanHint(const std::string& path);

}  // namespace proveout
