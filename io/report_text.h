// What the written forms of a report share: numbers, findings and markup as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/report.h"

namespace proveout::report_text {

/// Escapes for XML and HTML, in text and in attributes with double quotes. Characters that XML 1.0 does not
/// have and bytes that are not UTF-8 become U+FFFD.
std::string escape(std::string_view text);

/// Fixed number of decimals, "-" for values that are not finite; no "-0.00".
std::string fixed(double value, int decimals);
/// Four digits that count, at most four decimals, no exponent and no trailing zeros: "0.353", "17410", "0".
std::string figure(double value);
/// With blanks between thousands: "39 730.12".
std::string grouped(double value, int decimals);
/// "1 h 02 min 03 s", "2 min 03 s", "3.2 s".
std::string duration(double seconds);
/// By how much the mesh of a part without a grid may leave its walls, mm; none: the part is on a grid.
std::optional<double> facetsMm(const Report& report);
/// The kind's name with blanks: "rapid contact".
std::string spoken(FindingKind kind);
/// "O0100:12 (N70)".
std::string place(const BlockRef& block);
/// The same with its clamping, "top: O0100:12"; `setup` is empty in a job without setups.
std::string place(const std::string& setup, const BlockRef& block);
/// "O0100:12 (N70)", of a job with setups "top: O0100:12", of several blocks "O0100:12 (N70) to O0100:30"; ""
/// without a source.
std::string place(const Finding& finding);
/// One line: place, severity, kind, message and figures.
std::string summaryLine(const Finding& finding);

/// What was accepted of the findings, a line each: "3 known of baseline.json, 1 gone". None where nothing was
/// said of it.
std::vector<std::string> acceptanceLines(const ReportAcceptance& acceptance);
/// An entry of a baseline that no finding stands for: "plate.nc:40: gouge: 0.35 mm below nominal ...".
std::string goneLine(const KnownFinding& known);

/// "depth of the cycle Z-3.5 (O0100:12): Z off by -0.5 mm, explains 98 %".
std::string causeLine(const Cause& cause);
/// The same as a remark: "could be depth of the cycle ...".
std::string causeNote(const Cause& cause);
/// Of a finding that has any: how many causes were not tried.
std::string untriedNote(const Finding& finding);
/// "O0100:12 (N70) 61 %, O0100:14 39 %"; at most `most` blocks.
std::string blocksLine(const Finding& finding, std::size_t most);

/// A line, of a finding or of a diagnostic, that says why a program was refused.
std::string diagnosticLine(const Diagnostic& diagnostic);

}  // namespace proveout::report_text
