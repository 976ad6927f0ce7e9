// What report.html shows beside the report itself.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/report.h"

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

struct PageContent {
  std::vector<ReportPicture> pictures;
  ReportView view;
  std::vector<FindingDetail> details;  ///< of some findings, in their order
};

/// report.html: one self-contained page, no network; no script but that of the view. Everything from outside
/// is escaped.
std::string reportPage(const Report& report, const PageContent& content, const ReportOptions& options = {});

}  // namespace proveout
