#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/report/report_html_parts.h"
#include "io/report/report_page.h"
#include "io/report_text.h"
#include "report_sample.h"

namespace proveout {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(ReportHtml, ShowsTheReport) {
  const std::string html = reportHtml(io_test::sampleReport(), {{"iso", "png bytes"}});
  EXPECT_THAT(html, HasSubstr("<div class=\"verdict fail\">fail</div>"));
  EXPECT_THAT(html, HasSubstr("1 × gouge, 1 × rapid contact; 1 warning"));
  EXPECT_THAT(html, HasSubstr("7 min 11 s"));
  EXPECT_THAT(html, HasSubstr("O0100.nc:12 (N70)"));
  EXPECT_THAT(html, HasSubstr("<td class=\"num\" data-label=\"Depth mm\">0.250</td>"));
  EXPECT_THAT(html, HasSubstr("20.12, 31.50, -5.25"));
  EXPECT_THAT(html, HasSubstr("ball 3.175"));
  EXPECT_THAT(html, HasSubstr("deepest gouge (allowed 0.02)"));
  EXPECT_THAT(html, HasSubstr("<svg class=\"chart\""));
  EXPECT_THAT(html, HasSubstr("Arcs are cut as arcs."));
  EXPECT_THAT(html, HasSubstr(std::string(64, 'c')));
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,cG5nIGJ5dGVz"));
  EXPECT_THAT(html, HasSubstr("412 MB"));
  EXPECT_THAT(html, HasSubstr("3.50 s, 380 MB"));
}

TEST(ReportHtml, ShowsTheRemovalRate) {
  const std::string html = reportHtml(io_test::sampleReport(), {});
  EXPECT_THAT(html, HasSubstr("<h2>Material removal rate</h2>"));
  EXPECT_THAT(html, HasSubstr("&lt;T2&gt;"));
  EXPECT_THAT(html, HasSubstr("data-label=\"Engagement mm²\">9.933</td>"));
  Report nothing_cut = io_test::sampleReport();
  nothing_cut.accounting->rate.max = nothing_cut.accounting->rate.mean = {0, 0, 0};
  EXPECT_THAT(reportHtml(nothing_cut, {}), Not(HasSubstr("Material removal rate")));
}

TEST(ReportHtml, ListsFeaturesWithTheirDimensions) {
  Report report = io_test::sampleReport();
  EXPECT_THAT(reportHtml(report, {}), Not(HasSubstr("<h2>Features")));
  report.comparison->features = io_test::sampleFeatures();
  const std::string html = reportHtml(report, {});
  EXPECT_EQ(count(html, "hole of diameter 8 at X20.000 Y5.000"), 1u);
  EXPECT_THAT(html, HasSubstr("data-label=\"Simulated mm\">8.0200</td>"));
  EXPECT_THAT(html, HasSubstr("data-label=\"Deviation mm\">+0.0200</td>"));
  EXPECT_THAT(html, HasSubstr("Features (2; 2 of 3 characteristics failed)"));
  EXPECT_THAT(html, HasSubstr("data-label=\"Tolerance\">+0.015 / +0"));
  EXPECT_THAT(html, HasSubstr("≤ 0.04"));
  EXPECT_THAT(html, HasSubstr("seat &lt;H7&gt;"));
  EXPECT_THAT(html, HasSubstr("&lt;slot&gt;</td><td class=\"text\" colspan=\"6\">missing"));
  EXPECT_THAT(html, Not(HasSubstr("found in the facets")));
  report.comparison->features_found = true;
  report.comparison->features[1].residual_mm = 2e-5;
  EXPECT_THAT(reportHtml(report, {}),
              HasSubstr("found in the facets, whose corners lie within 2e-05 mm of them"));
}

TEST(ReportHtml, TellsAlignmentAndScan) {
  Report report = io_test::sampleReport();
  report.comparison->alignment = io_test::sampleAlignment();
  report.comparison->scan = io_test::sampleScan();
  const std::string html = reportHtml(report, {});
  EXPECT_THAT(
      html,
      HasSubstr("Alignment by fit: nominal moved by up to 0.25 mm and turned by 0 degrees; 0.0201 mm rms "
                "left at 12345 points, 32 left out; 1 direction not settled by the surface."));
  EXPECT_THAT(
      html,
      HasSubstr("Scan <code>&lt;scan&gt;.ply</code>: 62.1 % of the nominal's surface was scanned (a point "
                "within 0.375 mm), 98765 points, 12 too far off to be of the part. What was not scanned is "
                "not judged."));
  EXPECT_THAT(html, HasSubstr("<b>62.1 <small>%</small></b><span>of the surface scanned"));
}

TEST(ReportText, FiguresAreTidy) {
  EXPECT_EQ(report_text::figure(0.35312), "0.3531");
  EXPECT_EQ(report_text::figure(174.13), "174.1");
  EXPECT_EQ(report_text::figure(123456.7), "123457");
  EXPECT_EQ(report_text::figure(2.0), "2");
  EXPECT_EQ(report_text::figure(1e-15), "0");
  EXPECT_EQ(report_text::figure(-1e-15), "0");
  EXPECT_EQ(report_text::figure(0.048631), "0.0486");
}

TEST(RateSvg, IsAFileOfItsOwn) {
  const std::string svg = rateSvgFile(io_test::sampleReport().accounting->rate);
  EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
  EXPECT_THAT(svg, HasSubstr("xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
  // Base at 256, top (200) at 44, three steps of 274 user units from 66.
  EXPECT_THAT(svg, HasSubstr("class=\"peak\" d=\"M66 256H66.00V256.00H340.00V44.00H614.00V171.20H888.00\""));
}

TEST(ReportHtml, NeedsNoNetworkAndNoScript) {
  const std::string html = reportHtml(io_test::sampleReport(), {{"iso", "png"}});
  for (const char* word : {"http:", "https:", "<script", "<link", "@import", "url(", "src=\"/"}) {
    EXPECT_THAT(html, Not(HasSubstr(word)));
  }
}

TEST(ReportHtml, HasTheViewOrSaysWhyNot) {
  PageContent content;
  content.view = {"", "", true};
  std::string html = reportPage(io_test::sampleReport(), content);
  EXPECT_THAT(html, HasSubstr("No 3-D view: this program was built without it"));
  EXPECT_THAT(html, HasSubstr("script-src 'none'"));
  content.view = {"show()", "QUJD", true};
  html = reportPage(io_test::sampleReport(), content);
  EXPECT_THAT(
      html,
      HasSubstr("<script type=\"text/plain\" id=\"view3d-data\">QUJD</script>\n<script>show()</script>"));
  EXPECT_THAT(html, HasSubstr("<tr id=\"finding-1\"><td class=\"num\" data-label=\"#\"><a href=\"#view3d\""));
  EXPECT_EQ(count(html, "id=\"view3d\""), 1u);
  content.view.data.clear();  // no part is left to show
  EXPECT_THAT(reportPage(io_test::sampleReport(), content), Not(HasSubstr("view3d\"")));
}

TEST(ReportHtml, FindingsAndCloseUpsLeadToEachOther) {
  PageContent content;
  content.details = {{2, "png", {{11, "N60 G0"}, {12, "N70 </ol><script>"}}, 12}};
  const std::string html = reportPage(io_test::sampleReport(), content);
  EXPECT_THAT(html, HasSubstr("<a href=\"#detail-2\">2</a>"));
  EXPECT_THAT(html, HasSubstr("<figure id=\"detail-2\"><figcaption><a href=\"#finding-2\">2</a>"));
  EXPECT_THAT(html,
              HasSubstr("<li value=\"12\" class=\"own\"><code>N70 &lt;/ol&gt;&lt;script&gt;</code></li>"));
}

TEST(ReportHtml, BandsAndSectionsAreShownWhereTheyAreAskedFor) {
  PageContent content;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  content.bands = {{-kInfinite, -0.02, 10.0, 0.25, "#0c3282"}, {-0.02, kInfinite, 30.0, 0.75, "#e6e6e0"}};
  content.sections = {{{0, 12.5}, {{{0, 0}, {4, 0}, {4, 2}}}, {}, 4.0, 0.0}, {{2, -3.0}, {}, {}, 0.0, 0.0}};
  const std::string html = reportPage(io_test::sampleReport(), content);
  EXPECT_THAT(html,
              HasSubstr("</i>below -0.02</td><td class=\"num\">10.0</td><td class=\"num\">25.00 %</td>"));
  EXPECT_THAT(html, HasSubstr("</i>above -0.02</td>"));
  EXPECT_THAT(html, HasSubstr("<b>X12.5</b>, Y to the right, Z up: 4.00 mm²</figcaption>"));
  EXPECT_THAT(html, HasSubstr("<path class=\"machined\" d=\"M0.000 0.000L4.000 0.000L4.000 -2.000Z\"/>"));
  EXPECT_THAT(html, HasSubstr("<b>Z-3</b>: no material there"));
}

TEST(ReportHtml, HeadIsShownWhereTheJobHasOne) {
  Report report = io_test::sampleReport();
  EXPECT_THAT(reportHtml(report, {}), Not(HasSubstr("class=\"head\"")));
  report.head = {{"part_number", "Part number", "<4711>"}, {"date", "Date", "2026-11-30"}};
  EXPECT_THAT(reportHtml(report, {}), HasSubstr("<dt>Part number</dt><dd>&lt;4711&gt;</dd>"));
}

TEST(ReportHtml, EscapesEverything) {
  Report r = io_test::sampleReport();
  const std::string evil = "<script>alert(\"1\")</script>&";
  r.name = r.version = r.program.control = evil;
  r.findings[0].message = r.findings[0].source->file = r.findings[0].source->text = evil;
  r.time.per_tool[0].name = r.time.per_tool[0].description = evil;
  r.stock->bodies[0].role = r.comparison->nominal = evil;
  r.error_budget[0].source = r.error_budget[0].statement = evil;
  r.diagnostics[0].message = r.diagnostics[0].code = r.diagnostics[0].source_line = evil;
  r.diagnostics[0].where.file = r.diagnostics[0].notes[0] = evil;
  r.inputs[0] = {evil, evil, 1, evil};
  r.outputs.meshes[0] = {evil, evil, evil};
  r.part_sha256 = evil;
  const std::string html = reportHtml(r, {{evil, "png"}});
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("\"1\"")));
  EXPECT_GE(count(html, "&lt;script&gt;"), 24u);
}

TEST(ReportHtml, TablesAreWellFormed) {
  const std::string html = reportHtml(io_test::sampleReport(), {});
  for (const char* tag : {"section", "table", "tr", "td", "dl", "div", "svg", "main", "body", "html"}) {
    const std::string name(tag);
    EXPECT_EQ(count(html, "<" + name + ">") + count(html, "<" + name + " "), count(html, "</" + name + ">"))
        << tag;
  }
}

TEST(ReportHtml, PassWithoutNominalSaysSo) {
  Report r;
  r.verdict = Verdict::kPass;
  EXPECT_THAT(reportHtml(r, {}), HasSubstr("nothing found; no nominal was compared"));
  r.checks.comparison = true;
  r.comparison = ReportComparison();
  const std::string html = reportHtml(r, {}, {false});
  EXPECT_THAT(html, HasSubstr("nothing over tolerance"));
  EXPECT_THAT(html, Not(HasSubstr("Peak memory")));
  EXPECT_THAT(html, Not(HasSubstr("<svg")));
}

TEST(ReportHtml, CountsWhatItDoesNotShow) {
  Report r = io_test::sampleReport();
  r.findings.assign(1203, r.findings[0]);
  const std::string html = reportHtml(r, {});
  EXPECT_THAT(html, HasSubstr("703 more are in report.json"));
  EXPECT_THAT(html, HasSubstr("Findings (1203)"));
}

// RFC 4648, section 10.
TEST(PngDataUri, IsBase64) {
  const std::string head = "data:image/png;base64,";
  EXPECT_EQ(report_html::pngDataUri(""), head);
  EXPECT_EQ(report_html::pngDataUri("f"), head + "Zg==");
  EXPECT_EQ(report_html::pngDataUri("fo"), head + "Zm8=");
  EXPECT_EQ(report_html::pngDataUri("foo"), head + "Zm9v");
  EXPECT_EQ(report_html::pngDataUri("foobar"), head + "Zm9vYmFy");
  EXPECT_EQ(report_html::pngDataUri("\xff\xfe\xfd"), head + "//79");
}

TEST(Histogram, DrawsABarForEveryBinWithArea) {
  const ReportComparison c = *io_test::sampleReport().comparison;
  std::size_t filled = 0;
  for (const double area : c.histogram_area_mm2) filled += area > 0.0 ? 1 : 0;
  const std::string svg = report_html::histogramSvg(c);
  EXPECT_EQ(count(svg, "<title>"), filled);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, HasSubstr("class=\"gouge\""));
}

TEST(Histogram, RefusesDataThatCannotBeDrawn) {
  ReportComparison c = *io_test::sampleReport().comparison;
  c.histogram_edges_mm.pop_back();
  EXPECT_EQ(report_html::histogramSvg(c), "");
  c = *io_test::sampleReport().comparison;
  c.histogram_area_mm2[3] = std::nan("");
  EXPECT_EQ(report_html::histogramSvg(c), "");
  c.histogram_area_mm2.assign(60, 0.0);
  EXPECT_EQ(report_html::histogramSvg(c), "");
  // One bin of one area is drawn, however small.
  c.histogram_edges_mm = {-1e-9, 1e-9};
  c.histogram_area_mm2 = {1e-7};
  EXPECT_EQ(count(report_html::histogramSvg(c), "<title>"), 1u);
}

}  // namespace
}  // namespace proveout
