// Bands of deviation and drawings of sections in report.html.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/report/report_html_parts.h"
#include "io/report_text.h"

namespace proveout::report_html {

namespace {

using report_text::fixed;
using report_text::grouped;

std::string bandText(const DeviationBand& band) {
  if (std::isinf(band.from_mm)) return fmt::format("below {:+g}", band.to_mm);
  if (std::isinf(band.to_mm)) return fmt::format("above {:+g}", band.from_mm);
  return fmt::format("{:+g} to {:+g}", band.from_mm, band.to_mm);
}

/// A step of 1, 2 or 5 times a power of ten, a tenth to a quarter of the length.
double scaleStep(double length) {
  const double decade = std::pow(10.0, std::floor(std::log10(length)));
  const double share = length / decade;
  return decade * (share < 2.0 ? 0.2 : share < 5.0 ? 0.5 : 1.0);
}

class SectionDrawing {
 public:
  explicit SectionDrawing(const PageSection& section) : s_(section) {
    for (const auto* loops : {&section.machined, &section.nominal}) {
      for (const std::vector<Vec2>& loop : *loops) {
        for (const Vec2& p : loop) box_.extend(Vec3(p.x(), -p.y(), 0.0));
      }
    }
  }
  bool empty() const { return box_.empty(); }

  std::string svg() {
    const Vec3 size = box_.size();
    const double large = std::max({size.x(), size.y(), 1e-6}), margin = 0.06 * large, text = 0.035 * large;
    const double x = box_.min.x() - margin, y = box_.min.y() - margin;
    const double width = size.x() + 2.0 * margin, height = size.y() + 2.5 * margin + text;
    fmt::format_to(
        std::back_inserter(out_),
        "<svg class=\"section\" viewBox=\"{:.4f} {:.4f} {:.4f} {:.4f}\" role=\"img\" aria-label=\"Section at "
        "{}\">",
        x, y, width, height, title());
    path(s_.machined, "machined");
    path(s_.nominal, "nominal");
    const double step = scaleStep(large), low = y + height - 0.5 * margin;
    fmt::format_to(
        std::back_inserter(out_),
        "<path class=\"scale\" d=\"M{0:.4f} {1:.4f}v{2:.4f}h{3:.4f}v-{2:.4f}\"/><text x=\"{4:.4f}\" "
        "y=\"{5:.4f}\" font-size=\"{6:.4f}\">{3:g} mm</text></svg>",
        box_.min.x(), low - 0.4 * text, 0.4 * text, step, box_.min.x() + step + 0.5 * text, low, text);
    return std::move(out_);
  }

  std::string title() const { return fmt::format("{}{:g}", "XYZ"[s_.plane.axis], s_.plane.at_mm); }

 private:
  void path(const std::vector<std::vector<Vec2>>& loops, const char* kind) {
    if (loops.empty()) return;
    fmt::format_to(std::back_inserter(out_), "<path class=\"{}\" d=\"", kind);
    for (const std::vector<Vec2>& loop : loops) {
      char step = 'M';
      for (const Vec2& p : loop) {
        fmt::format_to(std::back_inserter(out_), "{}{:.3f} {:.3f}", step, p.x(), 0.0 - p.y());
        step = 'L';
      }
      out_ += 'Z';
    }
    out_ += "\"/>";
  }

  const PageSection& s_;
  Box3 box_;
  std::string out_;
};

}  // namespace

std::string bandsSection(const std::vector<DeviationBand>& bands) {
  if (bands.empty()) return {};
  std::string out =
      "<section>\n<h2>Bands of deviation</h2>\n<table><thead><tr><th>Deviation mm</th><th class=\"num\">Area "
      "mm²</th><th "
      "class=\"num\">Share</th><th class=\"share\">of the part's surface</th></tr></thead><tbody>\n";
  for (const DeviationBand& band : std::vector<DeviationBand>(bands.rbegin(), bands.rend())) {
    out += fmt::format(
        "<tr><td><i class=\"swatch\" style=\"background:{0}\"></i>{1}</td><td class=\"num\">{2}</td><td "
        "class=\"num\">{3} %</td><td class=\"share\"><span class=\"bar\" "
        "style=\"width:{4:.1f}%\"></span></td></tr>\n",
        band.colour, bandText(band), grouped(band.area_mm2, 1), fixed(100.0 * band.share, 2),
        100.0 * band.share);
  }
  return out + "</tbody></table>\n</section>\n";
}

std::string sectionsSection(const std::vector<PageSection>& sections) {
  if (sections.empty()) return {};
  static constexpr const char* kAcross[] = {"Y to the right, Z up", "X to the right, Z up",
                                            "X to the right, Y up"};
  std::string out = "<section>\n<h2>Sections</h2>\n<div class=\"details\">\n";
  for (const PageSection& section : sections) {
    SectionDrawing drawing(section);
    const std::string title = drawing.title();
    if (drawing.empty()) {
      out += fmt::format("<figure><figcaption><b>{}</b>: no material there</figcaption></figure>\n", title);
      continue;
    }
    out += fmt::format("<figure><figcaption><b>{}</b>, {}: {} mm²", title, kAcross[section.plane.axis],
                       fixed(section.machined_mm2, 2));
    if (!section.nominal.empty()) out += fmt::format(", nominal {} mm²", fixed(section.nominal_mm2, 2));
    out += "</figcaption>" + drawing.svg() + "</figure>\n";
  }
  return out +
         "</div>\n<p class=\"key\"><span><i class=\"key-machined\"></i>machined</span><span><i "
         "class=\"key-nominal\"></i>nominal</span></p>\n</section>\n";
}

}  // namespace proveout::report_html
