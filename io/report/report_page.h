// What report.html shows beside the report itself.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/report.h"
#include "io/report/setup_sheet.h"

namespace proveout {

/// The 3-D view. Without `data` the page has none, and says so where it was `wanted` and `script` is missing.
struct ReportView {
  std::string script;  ///< JavaScript that shows `data` (io/report/view/main.js, with what it needs)
  std::string data;    ///< see encodeView()
  bool wanted = false;
};

/// More of a finding than its row has.
struct FindingDetail {
  std::size_t number = 0;  ///< as in the findings, from 1
  std::string png;         ///< close-up; may be empty
  struct Line {
    std::uint32_t number = 0;
    std::string text;
  };
  std::vector<Line> lines;  ///< of the program around the block, whose own line is `own_line`
  std::uint32_t own_line = 0;
};

/// A band of deviations and its share of the part's surface.
struct DeviationBand {
  double from_mm = 0.0, to_mm = 0.0;   ///< -inf and inf: what is beyond the outermost edges
  double area_mm2 = 0.0, share = 0.0;  ///< share of what was measured, 0..1
  std::string colour;                  ///< "#rrggbb", as in the 3-D view
};

/// A section of the part: the outlines that a plane across an axis cuts.
struct PageSection {
  SectionPlane plane;
  std::vector<std::vector<Vec2>> machined, nominal;  ///< closed; (Y, Z), (X, Z) or (X, Y) of the part, mm
  double machined_mm2 = 0.0, nominal_mm2 = 0.0;
};

struct PageContent {
  std::vector<ReportPicture> pictures;
  ReportView view;
  std::vector<FindingDetail> details;  ///< of some findings, in their order
  std::vector<DeviationBand> bands;    ///< ascending
  std::vector<PageSection> sections;
  std::vector<SetupSheet> sheets;  ///< one a clamping, in their order
};

/// report.html: one self-contained page, no network; no script but that of the view. Everything from outside
/// is escaped.
std::string reportPage(const Report& report, const PageContent& content, const ReportOptions& options = {});

}  // namespace proveout
