// The table of features in report.html.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/geometry/place_text.h"
#include "io/report/report_html_parts.h"
#include "io/report_text.h"

namespace proveout::report_html {
namespace feature_table {

using report_text::escape;
using report_text::fixed;

struct Row {
  const ReportFeature* feature;
  const ReportCharacteristic* c;  ///< null: the feature is missing
};

bool failed(const Row& row) { return row.c == nullptr || row.c->verdict == "fail"; }

/// Angles need fewer digits than lengths.
std::string figure(double value, const ReportCharacteristic& c) {
  return fixed(value + 0.0, c.unit == "mm" ? 4 : 3) + (c.unit == "mm" ? "" : " " + c.unit);
}

std::string limitsText(const ReportCharacteristic& c) {
  if (c.lower && c.upper && *c.lower == -*c.upper) return fmt::format("±{:.6g}", *c.upper);
  if (c.lower && c.upper) return fmt::format("{:+.6g} / {:+.6g}", *c.upper, *c.lower);
  if (c.upper) return fmt::format("≤ {:.6g}", *c.upper);
  if (c.lower) return fmt::format("≥ {:+.6g}", *c.lower);
  return "";
}

/// How much of its tolerance a deviation takes, as a bar; nothing where there is none.
std::string useText(const ReportCharacteristic& c) {
  if (!c.measured || !(c.upper || c.lower)) return "";
  const double off = *c.measured - c.nominal;
  const double limit = off < 0.0 ? (c.lower ? -*c.lower : 0.0) : (c.upper ? *c.upper : 0.0);
  if (!(limit > 0.0)) return "";
  const double share = 100.0 * std::abs(off) / limit;
  return fmt::format("<span class=\"use{}\"><i style=\"width:{:.0f}%\"></i></span>",
                     share > 100.0 ? " over" : "", std::min(share, 100.0));
}

std::string rowText(const Row& row, bool first) {
  const std::string name =
      first ? fmt::format("<b>{}</b> {}", escape(row.feature->id), escape(row.feature->feature)) : "";
  if (row.c == nullptr) {
    return fmt::format(
        "<tr class=\"fail\"><td data-label=\"Feature\">{}</td><td class=\"text\" colspan=\"6\">missing: the "
        "part has "
        "no surface near most of it</td><td data-label=\"Verdict\"><span class=\"tag "
        "error\">fail</span></td></tr>\n",
        name);
  }
  const ReportCharacteristic& c = *row.c;
  std::string what = escape(c.part.empty() ? c.name : c.part + ": " + c.name);
  if (!c.label.empty()) what += fmt::format("<span class=\"line\">{}</span>", escape(c.label));
  const std::string verdict = c.verdict.empty()
                                  ? ""
                                  : fmt::format("<span class=\"tag {}\">{}</span>",
                                                c.verdict == "fail" ? "error" : "good", c.verdict);
  return fmt::format(
      "<tr{}><td data-label=\"Feature\">{}</td><td data-label=\"Characteristic\">{}</td><td class=\"num\" "
      "data-label=\"Nominal mm\">{}</td><td class=\"num\" data-label=\"Tolerance\">{}<span "
      "class=\"line\">{}</span></td><td class=\"num\" data-label=\"Simulated mm\">{}</td><td class=\"num\" "
      "data-label=\"Deviation mm\">{}</td><td data-label=\"Of tolerance\">{}</td><td "
      "data-label=\"Verdict\">{}</td></tr>\n",
      c.verdict == "fail" ? " class=\"fail\"" : "", name, what, figure(c.nominal, c), limitsText(c),
      escape(c.tolerance), c.measured ? figure(*c.measured, c) : "not measured",
      c.measured ? fmt::format("{:+.4f}", *c.measured - c.nominal + 0.0) : "", useText(c), verdict);
}

}  // namespace feature_table

std::string featureTable(const std::vector<ReportFeature>& features, bool found, std::size_t most_rows) {
  using namespace feature_table;
  std::vector<Row> rows;
  for (const ReportFeature& feature : features) {
    if (feature.missing) rows.push_back({&feature, nullptr});
    if (feature.missing) continue;
    for (const ReportCharacteristic& c : feature.characteristics) rows.push_back({&feature, &c});
  }
  if (rows.empty()) return "";
  const auto failures = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), failed));
  const std::size_t all = rows.size();
  if (all > most_rows) {
    std::stable_partition(rows.begin(), rows.end(), failed);
    rows.resize(most_rows);
  }
  std::string out = fmt::format(
      "<section>\n<h2>Features ({}; {} of {} characteristics failed)</h2>\n<div class=\"wide\" "
      "tabindex=\"0\"><table "
      "class=\"stack features\"><thead><tr><th>Feature</th><th>Characteristic</th><th class=\"num\">Nominal "
      "mm</th><th class=\"num\">Tolerance</th><th class=\"num\">Simulated mm</th><th class=\"num\">Deviation "
      "mm</th><th>Of tolerance</th><th>Verdict</th></tr></thead><tbody>\n",
      features.size(), failures, all);
  const ReportFeature* last = nullptr;
  for (const Row& row : rows) {
    out += rowText(row, row.feature != last);
    last = row.feature;
  }
  out += "</tbody></table></div>\n";
  if (all > rows.size())
    out += fmt::format("<p class=\"quiet\">{} more are in report.json; all that failed {}.</p>\n",
                       all - rows.size(), failures <= rows.size() ? "are above" : "are there");
  if (found) {
    double residual = 0.0;
    for (const ReportFeature& feature : features)
      residual = std::max(residual, feature.residual_mm.value_or(0.0));
    out += fmt::format(
        "<p class=\"quiet\">The nominal is a mesh: its faces were found in the facets, whose corners lie "
        "within "
        "{:.2g} mm of them. Sizes are exact to the facets' chord.</p>\n",
        residual);
  }
  return out + "</section>\n";
}

std::string partTable(const std::vector<ReportCharacteristic>& characteristics) {
  using namespace feature_table;
  if (characteristics.empty()) return "";
  std::string out =
      "<section>\n<h2>The part as a whole</h2>\n<div class=\"wide\" tabindex=\"0\"><table class=\"stack "
      "features\"><thead><tr><th>Characteristic</th><th class=\"num\">Allowed</th><th "
      "class=\"num\">Simulated</th><th>At</th><th>Verdict</th></tr></thead><tbody>\n";
  for (const ReportCharacteristic& c : characteristics) {
    std::string allowed = c.lower ? fmt::format("≥ {:.6g}", *c.lower) : "";
    if (c.upper) allowed += fmt::format("{}≤ {:.6g}", allowed.empty() ? "" : ", ", *c.upper);
    const std::string label =
        c.label.empty() ? "" : fmt::format("<span class=\"line\">{}</span>", escape(c.label));
    out += fmt::format(
        "<tr{}><td data-label=\"Characteristic\">{}{}</td><td class=\"num\" data-label=\"Allowed\">{} "
        "{}</td><td class=\"num\" data-label=\"Simulated\">{}</td><td data-label=\"At\">{}</td><td "
        "data-label=\"Verdict\"><span class=\"tag {}\">{}</span></td></tr>\n",
        c.verdict == "fail" ? " class=\"fail\"" : "", escape(c.name), label, allowed, escape(c.unit),
        c.measured ? fixed(*c.measured + 0.0, 4) + " " + escape(c.unit) : "none",
        c.where ? placeText(*c.where) : "", c.verdict == "fail" ? "error" : "good", c.verdict);
  }
  return out + "</tbody></table></div>\n</section>\n";
}

}  // namespace proveout::report_html
