// The head of report.html and its 3-D view.
#include <fmt/format.h>

#include "io/report/report_html_parts.h"
#include "io/report_text.h"

namespace proveout::report_html {

std::string headLines(const Report& report) {
  if (report.head.empty()) return {};
  std::string out = "<section class=\"head\">\n<dl>\n";
  for (const ReportHeadLine& line : report.head)
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", report_text::escape(line.label),
                       report_text::escape(line.text));
  return out + "</dl>\n</section>\n";
}

std::string viewSection(const ReportView& view) {
  if (!view.wanted) return {};
  if (view.script.empty()) {
    return "<p class=\"quiet no-view\">No 3-D view: this program was built without it (packages libjs-three "
           "and "
           "esbuild).</p>\n";
  }
  if (view.data.empty()) return {};
  return "<section id=\"view3d\" aria-labelledby=\"view3d-title\">\n<h2 id=\"view3d-title\">3-D "
         "view</h2>\n<div "
         "class=\"v3-body\"><p class=\"quiet\">The view needs JavaScript.</p></div>\n</section>\n";
}

std::string viewScript(const ReportView& view) {
  if (!view.wanted || view.script.empty() || view.data.empty()) return {};
  return "<script type=\"text/plain\" id=\"view3d-data\">" + view.data + "</script>\n<script>" + view.script +
         "</script>\n";
}

}  // namespace proveout::report_html
