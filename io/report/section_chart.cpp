#include "io/report/section_chart.h"

#include <fmt/format.h>

#include <iterator>

#include "io/report_text.h"

namespace proveout {
namespace {

/// Around the drawing, and of its title, mm.
constexpr double kMargin = 5.0, kTitleHeight = 4.0;

void addPath(const SectionPolygons& polygons, const char* fill, std::string& out) {
  out +=
      fmt::format("<path fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#222\" stroke-width=\"0.05\" d=\"", fill);
  for (const std::vector<Vec2>& polygon : polygons) {
    char step = 'M';
    for (const Vec2& p : polygon) {
      fmt::format_to(std::back_inserter(out), "{}{:.4f} {:.4f}", step, p.x(), -p.y());
      step = 'L';
    }
    out += 'Z';
  }
  out += "\"/>\n";
}

}  // namespace

std::string sectionSvgFile(const std::string& title, const SectionPolygons& part,
                           const std::vector<SectionPolygons>& pieces) {
  Box3 bounds;
  const auto extend = [&](const SectionPolygons& polygons) {
    for (const std::vector<Vec2>& polygon : polygons)
      for (const Vec2& p : polygon) bounds.extend(Vec3(p.x(), -p.y(), 0.0));
  };
  extend(part);
  for (const SectionPolygons& piece : pieces) extend(piece);
  if (bounds.empty()) return {};
  const double x = bounds.min.x() - kMargin, y = bounds.min.y() - kMargin - kTitleHeight;
  const double width = bounds.max.x() + kMargin - x, height = bounds.max.y() + kMargin - y;
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "width=\"{0:.3f}mm\" "
      "height=\"{1:.3f}mm\" viewBox=\"{2:.3f} {3:.3f} {0:.3f} {1:.3f}\">\n<text x=\"{4:.3f}\" y=\"{5:.3f}\" "
      "font-family=\"sans-serif\" font-size=\"{6}\">{7}</text>\n",
      width, height, x, y, x + 1.0, y + kTitleHeight, 0.8 * kTitleHeight, report_text::escape(title));
  for (const SectionPolygons& piece : pieces) addPath(piece, "#dde3ea", out);
  addPath(part, "#8fa3b8", out);
  return out + "</svg>\n";
}

}  // namespace proveout
