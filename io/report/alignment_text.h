// Alignments and scans in a line, for people.
#pragma once

#include <string>

#include "io/report.h"

namespace proveout::report_text {

/// "fit: nominal moved by up to 0.412 mm and turned by 0.15 degrees; 0.0201 mm rms left at 12345 points, 32
/// left out; 1 direction not settled".
std::string alignmentLine(const ReportAlignment& alignment);

/// "62.1 % of the nominal's surface was scanned (a point within 0.375 mm), 12345 points, 50 too far off to be
/// of the part". The share is rounded down.
std::string scanLine(const ReportScan& scan);

}  // namespace proveout::report_text
