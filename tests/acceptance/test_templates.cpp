// Templates, filled by their command and by jobs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;

constexpr const char* kTemplate =
    "// Cone on a shaft of [D]\n"
    "//@ [D] = 60, 10..200: diameter of the bar, mm\n"
    "//@ [d1], 0..\n"
    "T1M06D1\nS222M03\nG98F120\n"
    "G77X[D]A[d1]Y10Z0P3C2B2V0\n"
    "G81X100Z100\nM02\n";

/// `more`: keys of [template.set].
std::string job(const std::string& file, const std::string& more) {
  return "schema = \"proveout.job/1\"\ncontrol = \"flexnc\"\n[template]\nfile = \"" + file +
         "\"\n[template.set]\n" + more +
         "[stock]\nshape = \"cylinder\"\nbase = [0, 0, -60]\ndiameter = 60\nlength = 60\n"
         "[machine]\nrapid = 10000\n"
         "[[tool]]\nnumber = 1\ntype = \"insert\"\nnose_radius = 0\norientation = 3\ninsert_angle = 35\n"
         "lead_angle = 93\nedge_length = 40\n";
}

TEST(Templates, TheCommandPrintsTheProgram) {
  const Workbench bench;
  bench.write("cone.tmpl", kTemplate);
  const Outcome outcome = bench.run("template cone.tmpl --set d1=40");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(
      outcome.out,
      "// Cone on a shaft of 60\n\n\nT1M06D1\nS222M03\nG98F120\nG77X60A40Y10Z0P3C2B2V0\nG81X100Z100\nM02\n");
  EXPECT_EQ(bench.run("template cone.tmpl --set d1=40 --set D=50 -o cone.pmc").exit_code, 0);
  EXPECT_TRUE(has(readFile(bench.path("cone.pmc")), "G77X50A40"));
  // What came out is a program without parameters.
  EXPECT_EQ(bench.run("template cone.pmc").out, readFile(bench.path("cone.pmc")));
}

TEST(Templates, TheCommandListsParameters) {
  const Workbench bench;
  bench.write("cone.tmpl", kTemplate);
  const Outcome outcome = bench.run("template cone.tmpl --list");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "[D]          60         10..200          diameter of the bar, mm\n"))
      << outcome.out;
  EXPECT_TRUE(has(outcome.out, "[d1]         -          0..              -\n")) << outcome.out;
  const json root = json::parse(bench.run("template cone.tmpl --list --json").out);
  EXPECT_EQ(root["parameters"].size(), 2u);
  EXPECT_EQ(root["parameters"][0]["default"], "60");
  EXPECT_EQ(root["parameters"][0]["max"], 200.0);
}

TEST(Templates, TheCommandRefusesWrongInput) {
  const Workbench bench;
  bench.write("cone.tmpl", kTemplate);
  bench.write("box.tmpl", std::string("BM\0\0picture", 11));
  const std::map<std::string, std::string> refused{
      {"template cone.tmpl", "cone.tmpl:3:5: error[template]: [d1] has no value"},
      {"template cone.tmpl --set d1=", "[d1] is empty"},
      {"template cone.tmpl --set d1=40 --set D=201", "[D] must be from 10 to 200, not 201"},
      {"template cone.tmpl --set d2=40", "cone.tmpl has no parameter [d2]; do you mean [d1]?"},
      {"template cone.tmpl --set d1=4 --set d1=5", "--set gives [d1] two values"},
      {"template cone.tmpl --set d1", "--set takes NAME=VALUE"},
      {"template cone.tmpl --set d1=40 -o cone.tmpl", "cone.tmpl"},
      {"template cone.tmpl --list --set d1=4", "--list takes no --set"},
      {"template cone.tmpl --set d1=4 --json", "--json goes with --list"},
      {"template box.tmpl", "export as .pmc (Save Text)"},
      {"template gone.tmpl", "gone.tmpl"},
  };
  for (const auto& [command, error] : refused) {
    const Outcome outcome = bench.run(command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_TRUE(has(outcome.err, error)) << command << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << command;
  }
  EXPECT_EQ(readFile(bench.path("cone.tmpl")), kTemplate);
}

TEST(Templates, AJobFillsOneIn) {
  const Workbench bench;
  bench.write("cone.tmpl", kTemplate);
  bench.write("job.toml", job("cone.tmpl", "d1 = 40\n"));
  const Outcome outcome = bench.run("run job.toml --no-render --json --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["program"]["files"][0], "cone.tmpl");
  EXPECT_GT(report["stock"]["removed_mm3"], 1000.0);
  EXPECT_EQ(bench.run("explain out --at 20,0,-1").exit_code, 0);
  // Another number in the field, or another template: not what was run.
  bench.write("cone.tmpl", std::string(kTemplate) + "// more\n");
  EXPECT_TRUE(has(bench.run("explain out --at 20,0,-1").err, "cone.tmpl is not what it was"));
}

TEST(Templates, AJobsValuesAreCheckedAtTheirPlace) {
  const Workbench bench;
  bench.write("cone.tmpl", kTemplate);
  const std::map<std::string, std::string> refused{
      {"d1 = 40\nD = 500\n", "job.toml:7:1: error[template]: [D] must be from 10 to 200, not 500"},
      {"d2 = 40\n", "job.toml:6:1: error[template]: cone.tmpl has no parameter [d2]; do you mean [d1]?"},
      {"d1 = true\n", "job.toml:6:6: error[job-type]: d1 must be a number"},
      {"D = 50\n", "cone.tmpl:3:5: error[template]: [d1] has no value"},
      {"d1 = 40\n[fixtures]\n", "error[job-unknown-key]"},
  };
  for (const auto& [values, error] : refused) {
    bench.write("job.toml", job("cone.tmpl", values));
    const Outcome outcome = bench.run("check job.toml");
    EXPECT_EQ(outcome.exit_code, 2) << values;
    EXPECT_TRUE(has(outcome.err, error)) << values << outcome.err;
  }
  bench.write("both.toml", "program = \"cone.tmpl\"\n" + job("cone.tmpl", "d1 = 40\n"));
  EXPECT_TRUE(has(bench.run("check both.toml").err, "give program or [template], not both"));
}

TEST(Templates, DiagnosticsShowTheTemplatesLineFilled) {
  const Workbench bench;
  bench.write("bad.tmpl", "//@ [D]\nG01X[D]\nG777X[D]\nM02\n");
  bench.write("job.toml", job("bad.tmpl", "D = 12.5\n"));
  const Outcome outcome = bench.run("check job.toml");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(has(outcome.err, "bad.tmpl:3:") && has(outcome.err, "\n    G777X12.5\n")) << outcome.err;
}

TEST(Templates, ASetNamesTheLinesOfItsTemplates) {
  const Workbench bench;
  bench.write("start.tmpl", "T[T]M06D[T]\nS[S]M03\nG98F[F]\n");
  bench.write("bad.tmpl", "// none\nG777X[D]\n");
  bench.write("part.tmps",
              "@ start.tmpl T=1;S=222;F=120\nG77X60A40Y10Z0P3C2B2V0\n@ bad.tmpl D=7\n@ bad.tmpl D=8\nM02\n");
  bench.write("job.toml", job("part.tmps", ""));
  const Outcome outcome = bench.run("check job.toml");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(has(outcome.err, "bad.tmpl (part.tmps:3):2:") && has(outcome.err, "\n    G777X7\n"))
      << outcome.err;
  EXPECT_TRUE(has(outcome.err, "bad.tmpl (part.tmps:4):2:") && has(outcome.err, "\n    G777X8\n"))
      << outcome.err;
  bench.write("bad.tmpl", "G00X[D]\n");
  const Outcome path = bench.run("path job.toml");
  EXPECT_TRUE(has(path.out, "\"file\":\"G77 of part.tmps:2\"")) << path.err;
}

TEST(Templates, ASetIsRunAndItsTemplatesAreInputs) {
  const Workbench bench;
  bench.write("start.tmpl", "T[T]M06D[T]\nS[S]M03\nG98F[F]\n");
  bench.write("part.tmps", "@ start.tmpl T=1;S=222;F=120\nG77X60A40Y10Z0P3C2B2V0\nG81X100Z100\nM02\n");
  bench.write("job.toml", job("part.tmps", ""));
  const Outcome outcome = bench.run("run job.toml --no-render --json --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  bool start = false;
  const json report = json::parse(outcome.out);
  for (const json& input : report["hashes"]["inputs"])
    start |= input["role"] == "template" && has(input["path"].get<std::string>(), "start.tmpl");
  EXPECT_TRUE(start);
  EXPECT_EQ(bench.run("explain out --at 20,0,-1").exit_code, 0);
}

}  // namespace
}  // namespace proveout::test
