// The findings of report.html: a row each, and close-ups with the program around the block.
#include <fmt/format.h>

#include <algorithm>

#include "io/report/report_html_parts.h"
#include "io/report_text.h"

namespace proveout::report_html {

namespace {

using report_text::escape;
using report_text::fixed;

class Findings {
 public:
  Findings(const Report& report, const PageContent& content) : r_(report), content_(content) {
    for (const FindingDetail& detail : content.details) detailed_.push_back(detail.number);
  }

  std::string build() {
    add("<section>\n<h2>Findings ({})</h2>\n", r_.findings.size());
    acceptance();
    if (r_.findings.empty()) {
      out_ += "<p class=\"quiet\">None.</p>\n</section>\n";
      return std::move(out_);
    }
    out_ +=
        "<div class=\"wide\" tabindex=\"0\"><table class=\"stack\"><thead><tr><th "
        "class=\"num\">#</th><th>Kind</th><th>Program line</th>"
        "<th class=\"num\">Tool</th><th class=\"num\">x, y, z (mm)</th><th class=\"num\">Depth mm</th>"
        "<th class=\"num\">Area mm²</th><th class=\"num\">Volume "
        "mm³</th><th>Finding</th></tr></thead><tbody>\n";
    const std::size_t shown = std::min(kMaxRows, r_.findings.size());
    for (std::size_t i = 0; i < shown; ++i) findingRow(i);
    out_ += "</tbody></table></div>\n";
    if (shown < r_.findings.size()) {
      add("<p class=\"quiet\">{} more are in report.json.</p>\n", r_.findings.size() - shown);
    }
    out_ += "</section>\n";
    details();
    return std::move(out_);
  }

 private:
  /// What was accepted of the findings, and what is gone of the known ones.
  void acceptance() {
    for (const std::string& line : report_text::acceptanceLines(r_.acceptance))
      add("<p class=\"quiet\">{}</p>\n", escape(line));
    if (!r_.acceptance.baseline || r_.acceptance.baseline->gone.empty()) return;
    const std::vector<KnownFinding>& gone = r_.acceptance.baseline->gone;
    out_ += "<ul class=\"quiet\">\n";
    for (std::size_t i = 0; i < std::min(kMaxRows, gone.size()); ++i)
      add("<li>gone: {}</li>\n", escape(report_text::goneLine(gone[i])));
    out_ += "</ul>\n";
    if (gone.size() > kMaxRows)
      add("<p class=\"quiet\">{} more are in report.json.</p>\n", gone.size() - kMaxRows);
  }

  void findingRow(std::size_t index) {
    const Finding& f = r_.findings[index];
    add("<tr id=\"finding-{}\"><td class=\"num\" data-label=\"#\">{}</td><td data-label=\"Kind\"><span "
        "class=\"tag "
        "{}\">{}</span></td>",
        index + 1, number(index), severityName(f.known ? Severity::kNote : f.severity),
        (f.known ? "known: " : "") + escape(report_text::spoken(f.kind)));
    out_ += "<td class=\"text\" data-label=\"Program line\">";
    if (f.source) {
      add("<code>{}</code>", escape(report_text::place(f)));
      if (!f.source->text.empty()) add("<code class=\"line\">{}</code>", escape(f.source->text));
    }
    add("</td><td class=\"num\" data-label=\"Tool\">{}</td>", f.tool ? fmt::format("T{}", *f.tool) : "");
    add("<td class=\"num\" data-label=\"x, y, z (mm)\">{}</td>",
        f.where ? fmt::format("{}, {}, {}", fixed(f.where->x(), 2), fixed(f.where->y(), 2),
                              fixed(f.where->z(), 2))
                : "");
    figureCell("Depth mm", f.depth_mm, 3);
    figureCell("Area mm²", f.area_mm2, 2);
    figureCell("Volume mm³", f.volume_mm3, 2);
    add("<td class=\"text\" data-label=\"Finding\">{}", escape(f.message));
    if (!f.worse.empty()) add("<span class=\"line\">worse than known: {}</span>", escape(f.worse));
    if (f.inside)
      add("<span class=\"line\">moved by <code>{}</code></span>", escape(report_text::place(*f.inside)));
    constexpr std::size_t kBlocks = 5;
    if (f.blocks.size() > 1)
      add("<span class=\"line\">made by {}</span>", escape(report_text::blocksLine(f, kBlocks)));
    for (const Cause& cause : f.causes)
      add("<span class=\"line\">{}</span>", escape(report_text::causeNote(cause)));
    if (f.untried_causes > 0) add("<span class=\"line\">{}</span>", escape(report_text::untriedNote(f)));
    if (hasDetail(index + 1)) add("<a class=\"line\" href=\"#detail-{}\">from near</a>", index + 1);
    out_ += "</td></tr>\n";
  }

  void figureCell(std::string_view label, const std::optional<double>& value, int decimals) {
    add("<td class=\"num\" data-label=\"{}\">{}</td>", label, value ? fixed(*value, decimals) : "");
  }

  /// The number leads to the place in the view, or to the close-up.
  std::string number(std::size_t index) const {
    const Finding& f = r_.findings[index];
    const bool seen = !content_.view.data.empty() && f.where;
    if (seen) return fmt::format("<a href=\"#view3d\" title=\"Show in the 3-D view\">{}</a>", index + 1);
    return hasDetail(index + 1) ? fmt::format("<a href=\"#detail-{0}\">{0}</a>", index + 1)
                                : std::to_string(index + 1);
  }
  bool hasDetail(std::size_t number) const {
    return std::binary_search(detailed_.begin(), detailed_.end(), number);
  }

  void details() {
    if (content_.details.empty()) return;
    out_ += "<section>\n<h2>Findings from near</h2>\n<div class=\"details\">\n";
    for (const FindingDetail& detail : content_.details) {
      const Finding& f = r_.findings[detail.number - 1];
      add("<figure id=\"detail-{0}\"><figcaption><a href=\"#finding-{0}\">{0}</a> <span class=\"tag "
          "{1}\">{2}</span> {3}</figcaption>\n",
          detail.number, severityName(f.known ? Severity::kNote : f.severity),
          escape(report_text::spoken(f.kind)), escape(report_text::place(f)));
      if (!detail.png.empty())
        add("<img alt=\"Close-up of finding {}\" src=\"{}\">\n", detail.number, pngDataUri(detail.png));
      programLines(detail);
      out_ += "</figure>\n";
    }
    out_ += "</div>\n</section>\n";
  }

  void programLines(const FindingDetail& detail) {
    if (detail.lines.empty()) return;
    out_ += "<ol class=\"program\">\n";
    for (const FindingDetail::Line& line : detail.lines) {
      add("<li value=\"{}\"{}><code>{}</code></li>\n", line.number,
          line.number == detail.own_line ? " class=\"own\"" : "", escape(line.text));
    }
    out_ += "</ol>\n";
  }

  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  const Report& r_;
  const PageContent& content_;
  std::vector<std::size_t> detailed_;
  std::string out_;
};

}  // namespace

std::string findingsSection(const Report& report, const PageContent& content) {
  return Findings(report, content).build();
}

}  // namespace proveout::report_html
