// Setup sheets in report.html.
#include <fmt/format.h>

#include "io/report/report_html_parts.h"
#include "io/report_text.h"

namespace proveout::report_html {
namespace setup_sheets {

using report_text::escape;
using report_text::fixed;

std::string figureOf(const std::string& png, const std::string& caption) {
  if (png.empty()) return "";
  return fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                     escape(caption), pngDataUri(png));
}

std::string toolTable(const std::vector<SheetTool>& tools) {
  if (tools.empty()) return "";
  std::string out =
      "<div class=\"wide\" tabindex=\"0\"><table class=\"stack\"><thead><tr><th>Tool</th><th>Shape</th><th "
      "class=\"num\">Stick-out mm</th><th>Length offset</th><th>Radius offset</th></tr></thead><tbody>\n";
  for (const SheetTool& tool : tools) {
    out += fmt::format(
        "<tr><td data-label=\"Tool\">T{}{}</td><td data-label=\"Shape\">{}</td><td class=\"num\" "
        "data-label=\"Stick-out mm\">{}</td><td data-label=\"Length offset\">{}</td><td data-label=\"Radius "
        "offset\">{}</td></tr>\n",
        tool.number, tool.name.empty() ? "" : " " + escape(tool.name), escape(tool.description),
        tool.stick_out ? fixed(*tool.stick_out, 3) : "", escape(tool.length_offset),
        escape(tool.radius_offset));
  }
  return out + "</tbody></table></div>\n";
}

std::string sheetText(const SetupSheet& sheet) {
  const std::string title =
      sheet.setup.empty() ? std::string("Setup sheet") : "Setup sheet: " + escape(sheet.setup);
  std::string out = fmt::format("<section class=\"sheet\">\n<h2>{}</h2>\n<dl>\n", title);
  out += fmt::format("<div><dt>Program</dt><dd>{}</dd></div>\n", escape(sheet.program));
  for (const SheetLine& line : sheet.lines)
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape(line.label), escape(line.text));
  out += "</dl>\n" + toolTable(sheet.tools);
  if (!sheet.before.empty() || !sheet.after.empty())
    out += "<div class=\"pictures\">\n" +
           figureOf(sheet.before, "clamped, with fixtures (orange) and zero points") +
           figureOf(sheet.after, "when the program has run") + "</div>\n";
  return out + "</section>\n";
}

}  // namespace setup_sheets

std::string sheetSections(const std::vector<SetupSheet>& sheets) {
  std::string out;
  for (const SetupSheet& sheet : sheets) out += setup_sheets::sheetText(sheet);
  return out;
}

}  // namespace proveout::report_html
