// Pieces of report.html.
#pragma once

#include <string>
#include <string_view>

#include "io/report.h"

namespace proveout::report_html {

/// The page's style sheet, without the tags around it.
std::string_view styleSheet();
/// Histogram of the deviations as SVG, area on a logarithmic scale; "" if there is nothing to draw.
std::string histogramSvg(const ReportComparison& comparison);
/// Material removal rate over the machining time as SVG; "" if there is nothing to draw.
std::string rateSvg(const RateSeries& rate);
/// Bytes as a data URI of a PNG picture.
std::string pngDataUri(std::string_view png);

}  // namespace proveout::report_html
