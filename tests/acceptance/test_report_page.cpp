// report.html in a browser: the 3-D view draws, turns to a finding, and asks for nothing from outside.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "core/base/installed_file.h"
#include "program_runner.h"

namespace proveout::test {
namespace {

bool pageHas(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

constexpr const char* kPageJob = R"(schema = "proveout.job/1"
name = "</script>&\"plate\""
control = "nct"
program = "plate.nc"
[stock]
shape = "box"
min = [0, 0, -10]
max = [40, 30, 0]
[[tool]]
number = 1
type = "flat"
diameter = 8
[simulation]
resolution = 0.5
[output]
size = [160, 120]
[report]
part_number = "</script><script>alert(1)</script>"
)";
constexpr const char* kPageProgram =
    "(</script><script>alert`2`</script>)\nN10 G54 G90 G0 X10 Y10 Z5 S3000 M3 T1\nN20 G0 Z-2 "
    "(</script>)\nN30 G1 X30 "
    "F400\nN40 G2 X30 Y20 R5\nN50 G0 Z20\nN60 M30\n";

/// What is left of a page without what stands between `from` and `to`.
std::string pageWithout(std::string page, const std::string& from, const std::string& to) {
  const std::size_t begin = page.find(from), end = page.find(to, begin);
  if (begin != std::string::npos && end != std::string::npos) page.erase(begin, end - begin);
  return page;
}

std::size_t timesIn(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

/// The page as it is once its script has run. Empty: there is no browser.
std::string domOf(const std::string& url) {
  const std::string command =
      "timeout 100 chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader "
      "--enable-unsafe-swiftshader "
      "--force-prefers-reduced-motion --virtual-time-budget=10000 --dump-dom '" +
      url + "' 2>/dev/null";
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string dom;
  std::array<char, 65536> buffer{};
  for (std::size_t got = 0; (got = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    dom.append(buffer.data(), got);
  pclose(pipe);
  return dom;
}

class ReportPage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (installedFiles("report_view.js").empty())
      GTEST_SKIP() << "the program was built without the 3-D view (packages esbuild, libjs-three)";
    bench_.write("job.toml", kPageJob);
    bench_.write("plate.nc", kPageProgram);
  }
  Workbench bench_;
};

TEST_F(ReportPage, CarriesTheViewAndNothingFromOutsideBreaksOut) {
  EXPECT_EQ(bench_.run("run job.toml --out out --quiet").exit_code, 1);
  const std::string page = readFile(bench_.path("out/report.html"));
  EXPECT_TRUE(pageHas(page, "<section id=\"view3d\""));
  EXPECT_TRUE(pageHas(page, "default-src 'none'"));
  EXPECT_LT(page.size(), std::size_t{6} << 20);
  // The data, and the script: no other, and neither is ended early.
  EXPECT_EQ(timesIn(page, "<script"), 2u);
  EXPECT_EQ(timesIn(page, "</script"), 2u);
  EXPECT_TRUE(pageHas(page, "&lt;/script&gt;&lt;script&gt;alert(1)"));
  EXPECT_TRUE(pageHas(page, "<li value=\"3\" class=\"own\"><code>N20 G0 Z-2 (&lt;/script&gt;)</code></li>"));
  EXPECT_TRUE(pageHas(page, "<img alt=\"Close-up of finding 1\""));
  EXPECT_TRUE(pageHas(page, "<li value=\"1\">") && pageHas(page, "<li value=\"6\">") &&
              !pageHas(page, "<li value=\"7\">"));
  EXPECT_EQ(bench_.run("run job.toml --out again --quiet").exit_code, 1);
  const std::string run = "<h2>Run</h2>", end = "</section>";
  EXPECT_EQ(pageWithout(page, run, end), pageWithout(readFile(bench_.path("again/report.html")), run, end));
}

TEST_F(ReportPage, IsLeftOutWhereNobodyWantsIt) {
  for (const char* option : {"--no-view3d", "--no-render"}) {
    EXPECT_EQ(bench_.run(std::string("run job.toml --out out --quiet ") + option).exit_code, 1);
    const std::string page = readFile(bench_.path("out/report.html"));
    EXPECT_FALSE(pageHas(page, "<script")) << option;
    EXPECT_TRUE(pageHas(page, "script-src 'none'")) << option;
  }
}

TEST_F(ReportPage, ViewTurnsToTheFindingInABrowser) {
  if (std::system("chromium --version >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "there is no chromium: the 3-D view was not looked at in a browser";
  EXPECT_EQ(bench_.run("run job.toml --out out --quiet").exit_code, 1);
  const std::string dom = domOf("file://" + bench_.path("out/report.html") + "#finding-1");
  EXPECT_TRUE(pageHas(dom, "data-state=\"drawn\"")) << dom.substr(0, 2000);
  EXPECT_TRUE(pageHas(dom, "data-finding=\"1\""));
  EXPECT_TRUE(pageHas(dom, "class=\"v3-marker error chosen\""));
  EXPECT_TRUE(pageHas(dom, "<tr id=\"finding-1\" class=\"v3-row chosen\">"));
  EXPECT_TRUE(
      pageHas(dom, "N20 G0 Z-2 (&lt;/script&gt;)</code>"));  // the block in the range of the tool path
}

}  // namespace
}  // namespace proveout::test
