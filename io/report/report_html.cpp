// report.html: the report for people, in one file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/report.h"
#include "io/report/alignment_text.h"
#include "io/report/report_html_parts.h"
#include "io/report_text.h"

namespace proveout {

namespace {

using report_html::kMaxRows;
using report_text::duration;
using report_text::escape;
using report_text::fixed;
using report_text::grouped;

/// What the figures of the table of tools are.
constexpr const char* kToolFigures =
    "the rest is tool changes and dwells. In air: feed motions that removed nothing. Engagement: removed "
    "volume over the "
    "path on which it was removed, the mean section of the chip. Rate: removed volume over the time in which "
    "it was "
    "removed.";
constexpr const char* kWireFigures =
    "the rest is dwells. In air: cutting motions that removed nothing. Section: removed volume over the path "
    "on which it "
    "was removed, kerf by height. Cutting rate: path on which something was removed, times the height of the "
    "workpiece, "
    "over its time.";

class Page {
 public:
  Page(const Report& report, const PageContent& content, const ReportOptions& options)
      : r_(report), content_(content), options_(options) {}

  std::string build() {
    begin();
    header();
    out_ += report_html::headLines(r_);
    cards();
    out_ += report_html::viewSection(content_.view);
    pictures();
    out_ += report_html::findingsSection(r_, content_);
    messages();
    comparison();
    out_ += report_html::partTable(r_.part_characteristics);
    out_ += report_html::bandsSection(content_.bands);
    out_ += report_html::sectionsSection(content_.sections);
    profile();
    setups();
    out_ += report_html::sheetSections(content_.sheets);
    tools();
    rate();
    stock();
    errorBudget();
    files();
    performance();
    add("<footer>proveout {}</footer>\n</main>\n", escape(r_.version));
    out_ += report_html::viewScript(content_.view);
    out_ += "</body>\n</html>\n";
    return std::move(out_);
  }

 private:
  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  void begin() {
    add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
        "'unsafe-inline'; script-src {}\">\n"
        "<title>{}: {}</title>\n<style>",
        content_.view.data.empty() ? "'none'" : "'unsafe-inline'", escape(r_.name), verdictName(r_.verdict));
    out_ += report_html::styleSheet();
    out_ += "</style>\n</head>\n<body>\n<main>\n";
  }

  void header() {
    add("<header><div class=\"verdict {0}\">{0}</div><div><h1>{1}</h1><p>{2}</p></div></header>\n",
        verdictName(r_.verdict), escape(r_.name), escape(sentence()));
  }

  /// What the run found, in one sentence.
  std::string sentence() const {
    std::map<std::string, int> kinds;
    int warnings = 0;
    for (const Finding& f : r_.findings) {
      if (f.known) continue;
      if (f.severity == Severity::kError) ++kinds[report_text::spoken(f.kind)];
      if (f.severity == Severity::kWarning) ++warnings;
    }
    std::string text;
    for (const auto& [kind, count] : kinds)
      text += fmt::format("{}{} × {}", text.empty() ? "" : ", ", count, kind);
    if (text.empty()) text = verdictSentence();
    if (!r_.program.until.empty()) text += fmt::format("; partial: only up to {} was run", r_.program.until);
    if (warnings > 0) text += fmt::format("; {} warning{}", warnings, warnings == 1 ? "" : "s");
    return text;
  }

  std::string verdictSentence() const {
    if (r_.verdict == Verdict::kError) return "the program could not be run to its end";
    if (r_.verdict == Verdict::kFail) return "the comparison is undecided on this grid";
    if (!r_.acceptance.left_out.empty() || (r_.acceptance.baseline && r_.acceptance.baseline->known > 0))
      return "nothing found beyond what is accepted";
    return r_.checks.comparison ? "nothing over tolerance" : "nothing found; no nominal was compared";
  }

  void card(const std::string& value, std::string_view unit, std::string_view label, bool over = false) {
    add("<div class=\"card{}\"><b>{} <small>{}</small></b><span>{}</span></div>\n", over ? " over" : "",
        value, unit, label);
  }

  void cards() {
    out_ += "<section class=\"cards\">\n";
    if (r_.checks.interpreted) card(duration(r_.time.cycle_s), "", "cycle time");
    if (r_.stock) {
      card(grouped(r_.stock->removed_mm3, 1), "mm³", "removed");
      card(grouped(r_.stock->final_mm3, 1), "mm³", "left");
    }
    if (r_.comparison) {
      const ReportComparison& c = *r_.comparison;
      card(fixed(c.max_gouge_mm, 3), "mm", fmt::format("deepest gouge (allowed {:g})", c.gouge_tolerance_mm),
           c.max_gouge_mm > c.gouge_tolerance_mm);
      card(fixed(c.max_excess_mm, 3), "mm",
           fmt::format("highest excess (allowed {:g})", c.excess_tolerance_mm),
           c.max_excess_mm > c.excess_tolerance_mm);
      if (c.scan)
        card(fmt::format("{:.1f}", std::floor(1000.0 * c.scan->coverage) / 10.0), "%",
             "of the surface scanned");
    }
    const std::optional<double> facets = report_text::facetsMm(r_);
    if (facets || r_.resolution_mm > 0.0)
      card(facets ? report_text::figure(*facets) : fmt::format("{:g}", r_.resolution_mm), "mm",
           facets ? "facets" : "grid");
    if (r_.checks.interpreted) {
      card(grouped(static_cast<double>(r_.program.motions), 0), "", "motions");
      card(escape(r_.program.control), "", "control");
    }
    out_ += "</section>\n";
  }

  void pictures() {
    if (content_.pictures.empty()) return;
    out_ += "<section class=\"pictures\">\n";
    for (const ReportPicture& picture : content_.pictures) {
      add("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
          escape(picture.title), report_html::pngDataUri(picture.png));
    }
    out_ += "</section>\n";
  }

  void figureCell(std::string_view label, const std::optional<double>& value, int decimals) {
    add("<td class=\"num\" data-label=\"{}\">{}</td>", label, value ? fixed(*value, decimals) : "");
  }

  void messages() {
    if (r_.diagnostics.empty()) return;
    add("<section>\n<h2>What the control said ({})</h2>\n<table><tbody>\n", r_.diagnostics.size());
    const std::size_t shown = std::min(kMaxRows, r_.diagnostics.size());
    for (std::size_t i = 0; i < shown; ++i) {
      const Diagnostic& d = r_.diagnostics[i];
      const std::string where =
          d.where.line > 0 ? fmt::format("{}:{}", d.where.file, d.where.line) : d.where.file;
      add("<tr><td><span class=\"tag {0}\">{0}</span></td><td><code>{1}</code></td><td>{2}",
          severityName(d.severity), escape(where), escape(d.message));
      if (!d.source_line.empty()) add("<code class=\"line\">{}</code>", escape(d.source_line));
      for (const std::string& note : d.notes) add("<span class=\"line\">{}</span>", escape(note));
      add("</td><td class=\"num\"><code>{}</code></td></tr>\n", escape(d.code));
    }
    out_ += "</tbody></table>\n";
    if (shown < r_.diagnostics.size()) {
      add("<p class=\"quiet\">{} more are in report.json.</p>\n", r_.diagnostics.size() - shown);
    }
    out_ += "</section>\n";
  }

  void figure(std::string_view label, const std::string& value) {
    add("<div><dt>{}</dt><dd>{}</dd></div>\n", label, value);
  }

  void comparison() {
    if (!r_.comparison) return;
    const ReportComparison& c = *r_.comparison;
    out_ += "<section>\n<h2>Comparison with nominal</h2>\n<dl class=\"figures\">\n";
    figure("Deepest gouge", fixed(c.max_gouge_mm, 4) + " mm");
    figure("Gouge allowed", fmt::format("{:g} mm", c.gouge_tolerance_mm));
    figure("Highest excess", fixed(c.max_excess_mm, 4) + " mm");
    figure("Excess allowed", fmt::format("{:g} mm", c.excess_tolerance_mm));
    figure("Root mean square", fixed(c.rms_mm, 4) + " mm");
    figure("95 % of the area within", fixed(c.p95_mm, 4) + " mm");
    out_ += "</dl>\n";
    const std::string chart = report_html::histogramSvg(c);
    if (!chart.empty()) {
      out_ += chart;
      out_ +=
          "\n<p class=\"key\"><span><i style=\"background:var(--gouge)\"></i>below nominal, over "
          "tolerance</span>"
          "<span><i style=\"background:var(--within)\"></i>within tolerance</span>"
          "<span><i style=\"background:var(--excess)\"></i>above nominal, over tolerance</span></p>\n";
    }
    if (!c.decided) {
      add("<p class=\"quiet\">Deviations too close to a tolerance for this grid are undecided{}.</p>\n",
          c.deciding_resolution_mm
              ? fmt::format("; a grid of {:.3g} mm would decide them", *c.deciding_resolution_mm)
              : "");
    }
    if (c.scan)
      add("<p class=\"quiet\">Scan <code>{}</code>: {}. What was not scanned is not judged.</p>\n",
          escape(c.scan->file), report_text::scanLine(*c.scan));
    if (c.alignment)
      add("<p class=\"quiet\">Alignment by {}.</p>\n", escape(report_text::alignmentLine(*c.alignment)));
    add("<p class=\"quiet\">Nominal: <code>{}</code></p>\n</section>\n", escape(c.nominal));
    out_ += report_html::featureTable(c.features, c.features_found, kMaxRows);
  }

  void setups() {
    if (r_.setups.empty()) return;
    out_ +=
        "<section>\n<h2>Setups</h2>\n<div class=\"wide\" tabindex=\"0\"><table "
        "class=\"stack\"><thead><tr><th>Setup</th><th>Program</th><th class=\"num\">Time</th><th "
        "class=\"num\">Motions</th><th class=\"num\">Removed mm³</th><th class=\"num\">Left "
        "mm³</th></tr></thead><tbody>\n";
    for (const ReportSetup& s : r_.setups) {
      add("<tr><td data-label=\"Setup\">{}</td><td data-label=\"Program\">{}</td><td class=\"num\" "
          "data-label=\"Time\">{}</td><td class=\"num\" data-label=\"Motions\">{}</td><td class=\"num\" "
          "data-label=\"Removed mm³\">{}</td><td class=\"num\" data-label=\"Left mm³\">{}</td></tr>\n",
          escape(s.name), escape(s.control.empty() ? s.program : s.program + " (" + s.control + ")"),
          duration(s.cycle_s), s.motions, grouped(s.removed_mm3, 1), grouped(s.final_mm3, 1));
    }
    out_ += "</tbody></table></div>\n</section>\n";
  }

  void tools() {
    if (r_.time.per_tool.empty()) return;
    double largest = 0.0;
    for (const ToolUse& use : r_.time.per_tool) largest = std::max(largest, use.removed_mm3);
    const bool wires = r_.accounting && r_.accounting->rate.by_area;
    const char *const section = wires ? "Section mm²" : "Engagement mm²", *const speed =
                                                                              wires ? "Cutting rate mm²/min"
                                                                                    : "Rate mm³/min";
    add("<section>\n<h2>{0}s</h2>\n<div class=\"wide\" tabindex=\"0\"><table "
        "class=\"stack\"><thead><tr><th>{0}</th><th>Shape</th>"
        "<th class=\"num\">Cutting</th><th class=\"num\">Rapid</th><th class=\"num\">Motions</th>"
        "<th class=\"num\">In air</th><th class=\"num\">Removed mm³</th><th class=\"num\">{1}</th>"
        "<th class=\"num\">{2}</th><th>Share</th></tr></thead><tbody>\n",
        wires ? "Wire" : "Tool", section, speed);
    for (const ToolUse& use : r_.time.per_tool) {
      const double share = largest > 0.0 ? std::max(0.0, use.removed_mm3) / largest : 0.0;
      add("<tr><td data-label=\"Tool\">T{}{}</td><td data-label=\"Shape\">{}</td>", use.number,
          use.name.empty() ? "" : " " + escape(use.name), escape(use.description));
      add("<td class=\"num\" data-label=\"Cutting\">{}</td><td class=\"num\" data-label=\"Rapid\">{}</td>"
          "<td class=\"num\" data-label=\"Motions\">{}</td>",
          duration(use.cutting_s), duration(use.rapid_s), use.motions);
      const CutFigures figures = figuresOf(use.number);
      const auto engagement = figures.engagement_mm2(),
                 rate = wires ? figures.area_mm2_min() : figures.rate_mm3_min();
      add("<td class=\"num\" data-label=\"In air\">{}</td><td class=\"num\" data-label=\"Removed "
          "mm³\">{}</td><td class=\"num\" data-label=\"{}\">{}</td><td class=\"num\" "
          "data-label=\"{}\">{}</td>",
          r_.accounting ? duration(figures.air_s) : "", grouped(use.removed_mm3, 1), section,
          engagement ? fixed(*engagement, 3) : "", speed, rate ? grouped(*rate, wires ? 1 : 0) : "");
      add("<td class=\"text share\"><span class=\"bar\" style=\"width:{:.1f}%\"></span></td></tr>\n",
          100.0 * share);
    }
    add("</tbody></table></div>\n<p class=\"quiet\">Cycle {}: cutting {}, rapid {}, {}</p>\n</section>\n",
        duration(r_.time.cycle_s), duration(r_.time.cutting_s), duration(r_.time.rapid_s),
        wires ? kWireFigures : kToolFigures);
  }

  CutFigures figuresOf(int tool) const {
    if (!r_.accounting) return {};
    for (const ToolFigures& entry : r_.accounting->per_tool) {
      if (entry.tool == tool) return entry.figures;
    }
    return {};
  }

  void profile() {
    if (r_.profile_svg.empty()) return;
    out_ += "<section>\n<h2>Profile</h2>\n" + r_.profile_svg + "\n</section>\n";
  }

  void rate() {
    const std::string chart = r_.accounting ? report_html::rateSvg(r_.accounting->rate) : std::string();
    if (chart.empty()) return;
    add("<section>\n<h2>{}</h2>\n", r_.accounting->rate.by_area ? "Cutting rate" : "Material removal rate");
    out_ += chart;
    out_ +=
        "\n<p class=\"key\"><span><i style=\"background:var(--gouge)\"></i>mean</span><span><i "
        "style=\"background:#e39b2d\"></i>largest of the motions at that time</span></p>\n</section>\n";
  }

  void stock() {
    if (!r_.stock) return;
    const ReportStock& s = *r_.stock;
    out_ += "<section>\n<h2>Stock</h2>\n<dl class=\"figures\">\n";
    figure("Blank", grouped(s.initial_mm3, 2) + " mm³");
    figure("Removed", grouped(s.removed_mm3, 2) + " mm³");
    figure("Left", grouped(s.final_mm3, 2) + " mm³");
    figure("Enclosed by the facets", grouped(s.mesh_mm3, 2) + " mm³");
    figure("Triangles", grouped(static_cast<double>(s.triangles), 0));
    figure("Mesh", s.closed ? "closed 2-manifold" : "not closed");
    out_ += "</dl>\n";
    if (!s.bodies.empty()) bodies(s);
    out_ += "</section>\n";
  }

  void bodies(const ReportStock& s) {
    out_ +=
        "<div class=\"wide\" tabindex=\"0\"><table><thead><tr><th>Body</th><th class=\"num\">Volume "
        "mm³</th><th "
        "class=\"num\">From "
        "(mm)</th><th class=\"num\">To (mm)</th></tr></thead><tbody>\n";
    const auto corner = [](const Vec3& p) {
      return fmt::format("{}, {}, {}", fixed(p.x(), 2), fixed(p.y(), 2), fixed(p.z(), 2));
    };
    for (std::size_t i = 0; i < std::min(kMaxRows, s.bodies.size()); ++i) {
      const StockBody& body = s.bodies[i];
      add("<tr><td>{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
          escape(body.role), grouped(body.volume_mm3, 2), corner(body.bounds.min), corner(body.bounds.max));
    }
    out_ += "</tbody></table></div>\n";
    if (s.bodies.size() > kMaxRows) {
      add("<p class=\"quiet\">{} more are in report.json.</p>\n", s.bodies.size() - kMaxRows);
    }
  }

  void errorBudget() {
    if (r_.error_budget.empty()) return;
    out_ +=
        "<section>\n<h2>How far these figures can be off</h2>\n<table><thead><tr><th>Source</th><th "
        "class=\"num\">Bound "
        "mm</th><th>Why</th></tr></thead><tbody>\n";
    for (const ErrorTerm& term : r_.error_budget) {
      add("<tr><td>{}</td><td class=\"num\">{}</td><td>{}</td></tr>\n", escape(term.source),
          term.bound_mm ? fmt::format("{:.2g}", *term.bound_mm) : "not known", escape(term.statement));
    }
    out_ += "</tbody></table>\n</section>\n";
  }

  void files() {
    if (r_.inputs.empty() && r_.outputs.meshes.empty() && r_.outputs.data.empty() && r_.part_sha256.empty())
      return;
    out_ +=
        "<section>\n<h2>Files</h2>\n<table><thead><tr><th>What</th><th>File and "
        "SHA-256</th></tr></thead><tbody>\n";
    const auto row = [&](const std::string& role, const std::string& path, const std::string& hash) {
      add("<tr><td>{}</td><td><code>{}</code><br><code class=\"hash\">{}</code></td></tr>\n", escape(role),
          escape(path), escape(hash));
    };
    for (const FileHash& file : r_.inputs) row(file.role, file.path, file.sha256);
    for (const ReportMesh& mesh : r_.outputs.meshes) row("part, " + mesh.format, mesh.path, mesh.sha256);
    for (const ReportData& file : r_.outputs.data) row(file.what, file.path, file.sha256);
    if (!r_.part_sha256.empty()) row("part", "positions and triangles", r_.part_sha256);
    out_ += "</tbody></table>\n</section>\n";
  }

  void performance() {
    if (!options_.with_performance) return;
    const ReportPerformance& p = r_.performance;
    out_ += "<section>\n<h2>Run</h2>\n<dl class=\"figures\">\n";
    figure("Wall time", fixed(p.wall_s, 2) + " s");
    figure("Interpret", fixed(p.interpret_s, 2) + " s");
    figure("Remove", fixed(p.remove_s, 2) + " s");
    figure("Mesh", fixed(p.mesh_s, 2) + " s");
    if (p.read_s > 0.0) figure("Read", fixed(p.read_s, 2) + " s");
    figure("Compare", fixed(p.compare_s, 2) + " s");
    figure("Render", fixed(p.render_s, 2) + " s");
    figure("Peak memory", fixed(p.peak_memory_mb, 0) + " MB");
    if (p.predicted_memory_mb > 0.0) {
      figure("Predicted", fixed(p.predicted_s, 2) + " s, " + fixed(p.predicted_memory_mb, 0) + " MB");
    }
    figure("Threads", std::to_string(p.threads));
    out_ += "</dl>\n</section>\n";
  }

  const Report& r_;
  const PageContent& content_;
  const ReportOptions& options_;
  std::string out_;
};

}  // namespace

std::string reportPage(const Report& report, const PageContent& content, const ReportOptions& options) {
  return Page(report, content, options).build();
}

std::string reportHtml(const Report& report, const std::vector<ReportPicture>& pictures,
                       const ReportOptions& options) {
  PageContent content;
  content.pictures = pictures;
  return reportPage(report, content, options);
}

}  // namespace proveout
