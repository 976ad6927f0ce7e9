// Pieces of report.html.
#pragma once

#include <string>
#include <string_view>

#include "io/report/report_page.h"

namespace proveout::report_html {

/// More rows than these are counted, not shown: nobody reads them, and browsers choke on them.
inline constexpr std::size_t kMaxRows = 500;

/// What the job says of part and people; "" if it says nothing.
std::string headLines(const Report& report);
/// The findings in a table, and what is known of them besides.
std::string findingsSection(const Report& report, const PageContent& content);
/// Bands of deviation with their shares; "" without.
std::string bandsSection(const std::vector<DeviationBand>& bands);
/// Drawings of sections; "" without.
std::string sectionsSection(const std::vector<PageSection>& sections);
/// Where the 3-D view goes, or why there is none; "" where none is wanted.
std::string viewSection(const ReportView& view);
/// The view's data and script, for the end of the page; "" without.
std::string viewScript(const ReportView& view);

/// Setup sheets, a section each.
std::string sheetSections(const std::vector<SetupSheet>& sheets);

/// The page's style sheet, without the tags around it.
std::string_view styleSheet();
/// Characteristics of the part as a whole; "" where there are none.
std::string partTable(const std::vector<ReportCharacteristic>& characteristics);
/// The table of features and their dimensions, a row a dimension; "" where there is none. No more than
/// `most_rows` of them: failed ones are never left out before others. `found`: in facets.
std::string featureTable(const std::vector<ReportFeature>& features, bool found, std::size_t most_rows);
/// Histogram of the deviations as SVG, area on a logarithmic scale; "" if there is nothing to draw.
std::string histogramSvg(const ReportComparison& comparison);
/// Material removal rate over the machining time as SVG; "" if there is nothing to draw.
std::string rateSvg(const RateSeries& rate);
/// Bytes as a data URI of a PNG picture.
std::string pngDataUri(std::string_view png);

}  // namespace proveout::report_html
