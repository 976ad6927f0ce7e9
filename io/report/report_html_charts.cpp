// Style sheet, chart and pictures of report.html.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "io/report/report_html_parts.h"
#include "io/report/view/scene_data.h"
#include "io/report_text.h"

namespace proveout::report_html {

namespace {

// Chart in user units; the page scales it to its width.
constexpr double kWidth = 720, kHeight = 280;
constexpr double kLeft = 54, kRight = 12, kTop = 26, kBottom = 44;
constexpr double kPlotWidth = kWidth - kLeft - kRight, kPlotHeight = kHeight - kTop - kBottom;
/// The smallest share of the largest bin that is still drawn: five decades.
constexpr double kSmallestShare = 1e-5;

class HistogramChart {
 public:
  explicit HistogramChart(const ReportComparison& comparison) : c_(comparison) {
    PROVEOUT_ASSERT(c_.histogram_edges_mm.size() == c_.histogram_area_mm2.size() + 1);
    low_ = c_.histogram_edges_mm.front();
    high_ = c_.histogram_edges_mm.back();
    const double largest = *std::max_element(c_.histogram_area_mm2.begin(), c_.histogram_area_mm2.end());
    top_decade_ = std::ceil(std::log10(largest));
    bottom_decade_ = std::floor(std::log10(largest * kSmallestShare));
    for (const double area : c_.histogram_area_mm2) {
      if (area > 0.0) smallest_ = std::min(smallest_, area);
    }
    bottom_decade_ = std::max(bottom_decade_, std::floor(std::log10(smallest_)));
    if (bottom_decade_ >= top_decade_) bottom_decade_ = top_decade_ - 1.0;
  }

  std::string draw() const {
    return fmt::format(
        "<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Histogram of "
        "deviations\">{}{}{}{}</svg>",
        kWidth, kHeight, toleranceBand(), decades(), bars(), axis());
  }

 private:
  double x(double mm) const {
    return kLeft + kPlotWidth * (std::clamp(mm, low_, high_) - low_) / (high_ - low_);
  }
  double y(double area) const {
    const double share = (std::log10(area) - bottom_decade_) / (top_decade_ - bottom_decade_);
    return kTop + kPlotHeight * (1.0 - std::clamp(share, 0.0, 1.0));
  }

  std::string toleranceBand() const {
    const double from = x(-c_.gouge_tolerance_mm), to = x(c_.excess_tolerance_mm);
    return fmt::format("<rect class=\"band\" x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{}\"/>", from,
                       kTop, to - from, kPlotHeight);
  }

  std::string decades() const {
    std::string out;
    for (double decade = bottom_decade_; decade <= top_decade_; decade += 1.0) {
      const double at = y(std::pow(10.0, decade));
      out += fmt::format("<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{:.2f}\" y2=\"{:.2f}\"/>", kLeft,
                         kWidth - kRight, at, at);
      out += fmt::format("<text x=\"{}\" y=\"{:.2f}\" text-anchor=\"end\">{:g}</text>", kLeft - 6, at + 4,
                         std::pow(10.0, decade));
    }
    return out + fmt::format("<text x=\"4\" y=\"{}\">area, mm² (logarithmic)</text>", kTop - 13);
  }

  std::string bars() const {
    std::string out;
    for (std::size_t i = 0; i < c_.histogram_area_mm2.size(); ++i) {
      const double area = c_.histogram_area_mm2[i];
      if (!(area > 0.0)) continue;
      const double from = c_.histogram_edges_mm[i], to = c_.histogram_edges_mm[i + 1],
                   middle = 0.5 * (from + to);
      const char* side = middle < -c_.gouge_tolerance_mm   ? "gouge"
                         : middle > c_.excess_tolerance_mm ? "excess"
                                                           : "within";
      const double left = x(from), right = x(to), top = std::min(y(area), kTop + kPlotHeight - 1.0);
      out += fmt::format(
          "<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"><title>{:.4g} to "
          "{:.4g} mm: "
          "{:.4g} mm²</title></rect>",
          side, left, top, std::max(0.5, right - left - 0.6), kTop + kPlotHeight - top, from, to, area);
    }
    return out;
  }

  std::string tick(double mm, double label_y) const {
    return fmt::format(
        "<line class=\"tick\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1}\" y2=\"{2}\"/>"
        "<text x=\"{0:.2f}\" y=\"{3}\" text-anchor=\"middle\">{4:.3g}</text>",
        x(mm), kTop + kPlotHeight, kTop + kPlotHeight + 5, label_y, mm);
  }

  /// Limits, tolerances and zero; a label that would cover its neighbour is left out.
  std::string axis() const {
    const double base = kTop + kPlotHeight;
    std::string out = fmt::format("<line class=\"axis\" x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\"/>", kLeft,
                                  kWidth - kRight, base, base);
    std::vector<double> taken;
    for (const double mm :
         {-c_.gouge_tolerance_mm, c_.excess_tolerance_mm, low_, high_, 0.0, 0.5 * low_, 0.5 * high_}) {
      const bool free = std::all_of(taken.begin(), taken.end(),
                                    [&](double other) { return std::abs(x(other) - x(mm)) > 44.0; });
      if (!free || mm < low_ || mm > high_) continue;
      taken.push_back(mm);
      out += tick(mm, base + 18);
    }
    return out + fmt::format(
                     "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">deviation, mm (below nominal | above "
                     "nominal)</text>",
                     kLeft + 0.5 * kPlotWidth, kHeight - 6);
  }

  const ReportComparison& c_;
  double low_ = 0.0, high_ = 0.0;
  double bottom_decade_ = 0.0, top_decade_ = 0.0;
  double smallest_ = std::numeric_limits<double>::infinity();
};

bool drawable(const ReportComparison& c) {
  const auto finite = [](double v) { return std::isfinite(v); };
  const auto& edges = c.histogram_edges_mm;
  const auto& areas = c.histogram_area_mm2;
  if (areas.empty() || edges.size() != areas.size() + 1 || !std::is_sorted(edges.begin(), edges.end()))
    return false;
  if (!std::all_of(edges.begin(), edges.end(), finite) || !std::all_of(areas.begin(), areas.end(), finite))
    return false;
  return edges.front() < edges.back() && *std::max_element(areas.begin(), areas.end()) > 0.0;
}

}  // namespace

std::string histogramSvg(const ReportComparison& comparison) {
  if (!drawable(comparison)) return {};
  return HistogramChart(comparison).draw();
}

std::string pngDataUri(std::string_view png) { return "data:image/png;base64," + base64(png); }

std::string_view styleSheet() {
  return R"css(
:root{--ink:#1d2329;--soft:#5c6770;--line:#d9dee3;--wash:#f4f6f8;--paper:#fff;--pass:#1a7f4b;--fail:#b42318;
--error:#8a1c7c;--warn:#a15c00;--gouge:#2e7acc;--excess:#d94d38;--within:#9aa6ae;--band:#e6f3ec;--link:#0b57a4;--machined:#c2410c;--nominal:#15803d}
*{box-sizing:border-box}
body{margin:0;background:var(--wash);color:var(--ink);font:15px/1.45 system-ui,-apple-system,"Segoe UI",Roboto,
"Helvetica Neue",Arial,sans-serif;-webkit-text-size-adjust:100%}
main{max-width:1120px;margin:0 auto;padding:20px 16px 48px}
header{display:flex;flex-wrap:wrap;gap:12px 20px;align-items:center;margin:8px 0 18px}
h1{font-size:26px;line-height:1.2;margin:0;overflow-wrap:anywhere}
h2{font-size:18px;margin:0 0 10px}
header p{margin:2px 0 0;color:var(--soft);overflow-wrap:anywhere}
.verdict{font-size:20px;font-weight:700;letter-spacing:.06em;text-transform:uppercase;color:#fff;padding:10px 20px;
border-radius:8px}
.verdict.pass{background:var(--pass)}.verdict.fail{background:var(--fail)}.verdict.error{background:var(--error)}
section{background:var(--paper);border:1px solid var(--line);border-radius:10px;padding:16px 18px;margin:0 0 16px}
.cards{display:flex;flex-wrap:wrap;padding:0;overflow:hidden}
.card{flex:1 1 158px;padding:12px 16px;border-right:1px solid var(--line);border-bottom:1px solid var(--line);
margin:0 -1px -1px 0}
.card b{display:block;font-size:21px;font-weight:650;font-variant-numeric:tabular-nums;white-space:nowrap}
.card b small{font-size:13px;font-weight:400;color:var(--soft)}
.card span{color:var(--soft);font-size:13px}
.card.over b{color:var(--fail)}
.pictures{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,420px),1fr));gap:14px}
figure{margin:0}
figure img{display:block;width:100%;height:auto;border-radius:6px;background:#eef1f4}
figcaption{color:var(--soft);font-size:13px;padding-top:4px}
.wide{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:14px}
th{text-align:left;color:var(--soft);font-weight:600;font-size:13px;white-space:nowrap}
th,td{padding:6px 16px 6px 0;border-bottom:1px solid var(--line);vertical-align:top}
tr:last-child td{border-bottom:0}
.num{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
td.num:last-child,th.num:last-child{padding-right:0}
code{font:13px/1.4 ui-monospace,SFMono-Regular,Menlo,Consolas,"DejaVu Sans Mono",monospace;overflow-wrap:anywhere}
.line{display:block;color:var(--soft)}
.tag{display:inline-block;font-size:12px;font-weight:650;border-radius:4px;padding:1px 7px;white-space:nowrap;
border:1px solid currentColor}
.tag.error{color:var(--fail)}.tag.warning{color:var(--warn)}.tag.note{color:var(--soft)}.tag.good{color:var(--pass)}
.use{display:inline-block;width:56px;height:7px;border-radius:4px;background:var(--line);overflow:hidden}
.use i{display:block;height:7px;background:var(--pass)}.use.over i{background:var(--fail)}
.share{width:22%;min-width:110px}
.bar{display:block;height:6px;margin-top:7px;border-radius:3px;background:var(--gouge);min-width:1px}
.quiet{color:var(--soft);margin:8px 0 0}
.figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(235px,1fr));gap:4px 26px;margin:0 0 12px}
.figures div{display:flex;justify-content:space-between;gap:10px;border-bottom:1px solid var(--line);padding:4px 0}
.figures dt{color:var(--soft)}.figures dd{margin:0;font-variant-numeric:tabular-nums;white-space:nowrap}
.chart{display:block;width:100%;height:auto;max-width:860px;margin:0 auto}
.chart text{font-size:12px;fill:var(--soft)}
.chart .grid{stroke:var(--line)}.chart .axis,.chart .tick{stroke:var(--soft)}
.chart .band{fill:var(--band)}.chart .gouge{fill:var(--gouge)}.chart .excess{fill:var(--excess)}
.chart .within{fill:var(--within)}
.wide-chart{max-width:none}.chart .span{fill:var(--wash)}.chart .mean{fill:var(--gouge);fill-opacity:.75}
.chart .peak{fill:none;stroke:#e39b2d;stroke-width:1}
.key{display:flex;flex-wrap:wrap;gap:4px 18px;justify-content:center;color:var(--soft);font-size:13px;margin:4px 0 0}
.key i{display:inline-block;width:11px;height:11px;border-radius:2px;margin-right:6px}
.hash{color:var(--soft);font-size:12px}
footer{color:var(--soft);font-size:13px;text-align:center}
.head dl{display:grid;grid-template-columns:repeat(auto-fit,minmax(190px,1fr));gap:8px 24px;margin:0}
.sheet dl{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,320px),1fr));gap:8px 24px;margin:0 0 12px}
.sheet img{max-width:640px}.sheet dt{color:var(--soft);font-size:13px}.sheet dd{margin:0;overflow-wrap:anywhere}
.head dt{color:var(--soft);font-size:13px}.head dd{margin:0;overflow-wrap:anywhere}
.no-view{margin:0 0 16px}
a{color:var(--link)}
tr[id] a,figcaption a{display:inline-block;min-width:24px;min-height:24px;line-height:24px;text-align:center}
.details{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,330px),1fr));gap:18px}
.details figcaption{padding:0 0 6px}
.section{display:block;width:100%;max-height:420px}
.section path{vector-effect:non-scaling-stroke;stroke-width:1.4;fill:none}
.section .machined{fill:var(--within);fill-opacity:.35;fill-rule:evenodd;stroke:var(--machined)}
.section .nominal{stroke:var(--nominal);stroke-dasharray:5 3}.section .scale{stroke:var(--soft)}.section text{fill:var(--soft)}
.key i.key-machined{background:var(--machined)}.key i.key-nominal{background:var(--nominal)}
.swatch{display:inline-block;width:14px;height:14px;border-radius:3px;border:1px solid #0003;margin-right:8px;vertical-align:-2px}
.program{margin:8px 0 0;padding:6px 6px 6px 56px;background:var(--wash);border-radius:6px;color:var(--soft);font-size:13px}
.program .own{color:var(--ink);font-weight:700}
@media screen and (prefers-color-scheme:dark){
:root{--ink:#e4e8ec;--soft:#a3aeb8;--line:#38424b;--wash:#14191e;--paper:#1d242b;--fail:#ff8a80;--warn:#f0b45c;--gouge:#5aa2ee;
--excess:#f0705a;--within:#7d8a94;--band:#1f3a2c;--link:#7db7ff;--machined:#ff9a5c;--nominal:#5fd08a;--chosen:#4a3c12;--stage-top:#39434c;--stage-low:#2a3239;--edge:#6c7780}
.verdict.fail{background:#b42318}.tag.error{color:var(--fail)}}
@media (max-width:720px){
main{padding:12px 10px 32px}h1{font-size:22px}section{padding:12px}.cards{padding:0}.card{flex-basis:128px;padding:10px 12px}.card b{font-size:18px}
.share{min-width:50px}th{white-space:normal}th,td{padding-right:10px}
.stack thead{display:none}.stack tr{display:block;border-bottom:1px solid var(--line);padding:8px 0}
.stack tr:last-child{border-bottom:0}
.stack td{display:flex;justify-content:space-between;gap:14px;border:0;padding:2px 0;text-align:right}
.stack td::before{content:attr(data-label);color:var(--soft);text-align:left;flex:none}
.stack td.text{display:block;text-align:left}.stack td.text::before{display:block}
.stack td:empty{display:none}}
@media print{
body{background:#fff;font-size:11px}main{max-width:none;padding:0}section{border-radius:0;break-inside:auto;padding:8px 10px}
h2,figure,tr,.figures,.chart{break-inside:avoid}h2{break-after:avoid}
.pictures{grid-template-columns:1fr 1fr}.wide{overflow:visible}
table{font-size:9px}code,.hash{font-size:8.5px}.tag{font-size:8.5px;padding:0 4px}
th{font-size:8.5px;white-space:normal}th,td{padding:3px 8px 3px 0}.share{min-width:60px}
*{-webkit-print-color-adjust:exact;print-color-adjust:exact}}
)css";
}

}  // namespace proveout::report_html
