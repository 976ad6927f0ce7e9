// What the command line enters as the operator does, and what it accepts of the findings.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program_runner.h"

namespace proveout::test {
namespace {

using Json = nlohmann::json;

/// A rapid into the stock at X5, and a cut with a standing spindle at X12.
constexpr const char* kDives =
    "G21 G90 G17 G54\nT1 M6\nS1000 M3\nG0 X5 Y5 Z5\nN40 G0 Z-2\nZ5\nX12 Y12\nM5\nN70 G1 Z-3 F100\nG0 "
    "Z5\nM30\n";
const std::string kRunDives =
    "run part.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=flat:4 --resolution 0.5 --no-render ";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

Json reportOf(const Workbench& bench, const std::string& folder = "part-out") {
  return Json::parse(readFile(bench.path(folder + "/report.json")));
}

/// Counts of findings of the report: known and others of severity error.
std::pair<int, int> knownAndNew(const Json& report) {
  std::pair<int, int> counts;
  for (const Json& finding : report["findings"]) {
    if (finding["severity"] != "error") continue;
    ++(finding.value("known", false) ? counts.first : counts.second);
  }
  return counts;
}

TEST(Baseline, OnlyWhatIsNewFails) {
  const Workbench bench;
  bench.write("part.nc", kDives);
  const Outcome first = bench.run(kRunDives + "--write-baseline known.json");
  EXPECT_EQ(first.exit_code, 1) << "writing changes no verdict";
  EXPECT_TRUE(has(first.err, "2 findings written to known.json")) << first.err;
  const Outcome again = bench.run(kRunDives + "--baseline known.json");
  EXPECT_EQ(again.exit_code, 0) << again.err << again.out;
  EXPECT_TRUE(has(again.out, "2 known of known.json, 0 gone")) << again.out;
  EXPECT_TRUE(has(again.out, "part: pass")) << again.out;
  EXPECT_TRUE(has(again.err, "known error")) << again.err;
  EXPECT_FALSE(has(again.err, "error[")) << again.err;
  const Json report = reportOf(bench);
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_EQ(knownAndNew(report), std::pair(2, 0));
  EXPECT_EQ(report["acceptance"]["baseline"]["known"], 2);
  EXPECT_EQ(report["acceptance"]["baseline"]["gone"], Json::array());
  EXPECT_TRUE(has(readFile(bench.path("part-out/report.html")), "nothing found beyond what is accepted"));
  EXPECT_TRUE(has(readFile(bench.path("part-out/report.html")), "known: rapid contact"));
  EXPECT_FALSE(has(readFile(bench.path("part-out/junit.xml")), "<failure"));
  // Blocks put in before, numbers changed: still known. One more rapid into the stock is not.
  bench.write("part.nc", replaced(kDives, "N40 G0 Z-2", "G4 P1\nN44 G0 Z-2"));
  EXPECT_EQ(bench.run(kRunDives + "--baseline known.json").exit_code, 0);
  bench.write("part.nc", replaced(replaced(kDives, "N40 G0 Z-2", "G4 P1\nN44 G0 Z-2"), "M30",
                                  "M3\nX16 Y5\nG0 Z-1\nZ5\nM30"));
  const Outcome third = bench.run(kRunDives + "--baseline known.json");
  EXPECT_EQ(third.exit_code, 1);
  EXPECT_EQ(knownAndNew(reportOf(bench)), std::pair(2, 1)) << third.err;
}

TEST(Baseline, WhatIsWorseFailsAndWhatIsGoneIsTold) {
  const Workbench bench;
  bench.write("part.nc", kDives);
  ASSERT_EQ(bench.run(kRunDives + "--write-baseline known.json").exit_code, 1);
  bench.write("part.nc", replaced(kDives, "M5\n", ""));
  const Outcome gone = bench.run(kRunDives + "--baseline known.json");
  EXPECT_EQ(gone.exit_code, 0) << gone.err;
  EXPECT_TRUE(has(gone.out, "1 known of known.json, 1 gone")) << gone.out;
  EXPECT_TRUE(has(gone.err, "note[gone]: known, and not found any more: part.nc:9: spindle off")) << gone.err;
  EXPECT_EQ(reportOf(bench)["acceptance"]["baseline"]["gone"][0]["source"]["line"], 9);
  EXPECT_TRUE(has(readFile(bench.path("part-out/report.html")), "gone: part.nc:9"));
  // Up to the first dive only: the second one is not gone, it was not looked for.
  bench.write("part.nc", kDives);
  const Outcome part = bench.run(kRunDives + "--baseline known.json --until N40");
  EXPECT_TRUE(has(part.out, "is not known")) << part.out;
  EXPECT_TRUE(reportOf(bench)["acceptance"]["baseline"]["gone"].is_null());
  // Deeper in the baseline's terms.
  std::string known = readFile(bench.path("known.json"));
  const std::size_t depth = known.find("\"depth_mm\":");
  ASSERT_NE(depth, std::string::npos) << known;
  known.replace(depth, known.find(',', depth) - depth, "\"depth_mm\":0.25");
  bench.write("known.json", known);
  const Outcome deeper = bench.run(kRunDives + "--baseline known.json");
  EXPECT_EQ(deeper.exit_code, 1);
  EXPECT_TRUE(has(deeper.err, "worse than known: depth")) << deeper.err;
  EXPECT_EQ(knownAndNew(reportOf(bench)), std::pair(1, 1));
}

TEST(Baseline, IsUpdatedInPlaceAndGoesOverNothingElse) {
  const Workbench bench;
  bench.write("part.nc", kDives);
  ASSERT_EQ(bench.run(kRunDives + "--write-baseline known.json").exit_code, 1);
  const std::string before = readFile(bench.path("known.json"));
  EXPECT_EQ(bench.run(kRunDives + "--baseline known.json --write-baseline known.json").exit_code, 0);
  EXPECT_EQ(readFile(bench.path("known.json")), before);
  for (const std::string target : {"part.nc", "part-out/report.json", "nowhere/known.json", "part-out"}) {
    const Outcome refused = bench.run(kRunDives + "--write-baseline " + target);
    EXPECT_EQ(refused.exit_code, 2) << target << refused.err;
    EXPECT_TRUE(has(refused.err, target.substr(0, target.find('/')))) << refused.err;
  }
  EXPECT_EQ(readFile(bench.path("part.nc")), kDives);
  EXPECT_EQ(bench.run(kRunDives + "--write-baseline part-out/known.json").exit_code, 1);
  EXPECT_EQ(readFile(bench.path("part-out/known.json")), before);
  // A program that is not run to its end has no baseline.
  bench.write("part.nc", "G0 X1\nG999\nM30\n");
  EXPECT_EQ(bench.run(kRunDives + "--write-baseline known.json").exit_code, 2);
  EXPECT_EQ(readFile(bench.path("known.json")), before);
}

TEST(Baseline, BadFilesAreRefusedBeforeAnythingIsDone) {
  const Workbench bench;
  bench.write("part.nc", kDives);
  const auto refusal = [&](const std::string& name) {
    const Outcome outcome = bench.run(kRunDives + "--baseline " + name);
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_FALSE(bench.exists("part-out")) << name;
    return outcome.err;
  };
  EXPECT_TRUE(has(refusal("none.json"), "no such file; --write-baseline none.json writes one"));
  bench.write("bad.json", "{\"schema\": \"proveout.baseline/7\"}");
  EXPECT_TRUE(has(refusal("bad.json"), "proveout.baseline/7"));
  bench.write("bad.json", std::string("\0\1\2", 3));
  EXPECT_TRUE(has(refusal("bad.json"), "write it anew with --write-baseline"));
  bench.write("bad.json", std::string(100000, '['));
  EXPECT_TRUE(has(refusal("bad.json"), "no JSON document"));
  EXPECT_TRUE(has(refusal("."), "--baseline"));
}

TEST(Kinds, SelectedAndIgnoredOnesDecide) {
  const Workbench bench;
  bench.write("part.nc", kDives);
  const Outcome ignored = bench.run(kRunDives + "--ignore rapid_contact,spindle_off");
  EXPECT_EQ(ignored.exit_code, 0) << ignored.err;
  EXPECT_TRUE(has(ignored.out, "without rapid_contact, spindle_off (--ignore)")) << ignored.out;
  EXPECT_TRUE(has(ignored.out, "not listed: 1 rapid_contact by --ignore, 1 spindle_off by --ignore"))
      << ignored.out;
  EXPECT_EQ(reportOf(bench)["acceptance"]["left_out"],
            Json::parse(R"([{"kind": "rapid_contact", "count": 1, "by": "--ignore"},
                             {"kind": "spindle_off", "count": 1, "by": "--ignore"}])"));
  EXPECT_EQ(bench.run(kRunDives + "--select gouge,excess").exit_code, 0);
  EXPECT_EQ(bench.run(kRunDives + "--select gouge,rapid_contact").exit_code, 1);
  const Outcome wrong = bench.run(kRunDives + "--ignore rapid_contacts");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(has(wrong.err, "did you mean 'rapid_contact'?")) << wrong.err;
  EXPECT_EQ(bench.run(kRunDives + "--ignore alarm").exit_code, 2);
  // An alarm counts whatever is selected.
  bench.write("part.nc", "G0 X1\nG999\nM30\n");
  EXPECT_EQ(bench.run(kRunDives + "--select gouge").exit_code, 2);
}

TEST(Kinds, SeveritiesOfTheJob) {
  const Workbench bench;
  bench.write("part.nc", kDives);
  const std::string job =
      "schema = 'proveout.job/1'\ncontrol = 'nct'\nprogram = 'part.nc'\n[stock]\nshape = 'box'\nmin = [0, 0, "
      "-10]\n"
      "max = [20, 20, 0]\n[[tool]]\nnumber = 1\ntype = 'flat'\ndiameter = 4\n[simulation]\nresolution = "
      "0.5\n[severity]\nspindle_off = 'note'\n";
  const auto run = [&](const std::string& lines) {
    bench.write("part.toml", job + lines + "\n");
    return bench.run("run part.toml --no-render --out part-out");
  };
  EXPECT_EQ(run("").exit_code, 1);
  const Outcome warned = run("rapid_contact = 'warning'");
  EXPECT_EQ(warned.exit_code, 0) << warned.err;
  EXPECT_TRUE(has(warned.err, "warning[rapid_contact]")) << warned.err;
  EXPECT_TRUE(has(warned.out, "severities by the job: rapid_contact = warning, spindle_off = note"))
      << warned.out;
  const Outcome off = run("rapid_contact = 'off'");
  EXPECT_EQ(off.exit_code, 0);
  EXPECT_TRUE(has(off.out, "1 rapid_contact turned off by the job")) << off.out;
  EXPECT_FALSE(has(off.err, "rapid_contact]")) << off.err;
  EXPECT_EQ(reportOf(bench)["acceptance"]["severities"],
            Json::parse(R"({"rapid_contact": "off", "spindle_off": "note"})"));
  const Outcome unknown = run("rapid_contract = 'off'");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(has(unknown.err, "did you mean 'rapid_contact'?")) << unknown.err;
  EXPECT_EQ(run("spindle_off = 'note'").exit_code, 2) << "twice";
  EXPECT_EQ(run("no_part = 'off'").exit_code, 2);
  EXPECT_EQ(run("rapid_contact = 'none'").exit_code, 2);
}

TEST(Offsets, TheCommandLineEntersWhatTheOperatorDoes) {
  const Workbench bench;
  bench.write(
      "part.nc",
      "G21 G90 G17 G55\nT1 M6\nS1000 M3\nG0 X-10 Y-10 Z5\nG1 Z-2 F200\nG41 D1 X5 Y5\nY15\nX15\nY5\nX0\nG40 "
      "X-10 Y-10\nG0 Z5\nM30\n");
  const Outcome missing = bench.run(kRunDives);
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_TRUE(has(missing.err, "contours are cut 2 mm too deep, the radius of the tool")) << missing.err;
  EXPECT_TRUE(has(missing.err, "--offset D1=2")) << missing.err;
  const Outcome given = bench.run(kRunDives + "--offset D1=2 --offset G55=0,0,0");
  EXPECT_EQ(given.exit_code, 0) << given.err;
  EXPECT_FALSE(has(given.err, "has no value")) << given.err;
  const double with_radius = reportOf(bench)["stock"]["removed_mm3"];
  EXPECT_EQ(bench.run(kRunDives + "--offset D1=0 --offset G55=0,0,0").exit_code, 0)
      << "0 is what somebody says";
  EXPECT_NE(reportOf(bench)["stock"]["removed_mm3"].get<double>(), with_radius);
  const Outcome wrong = bench.run(kRunDives + "--offset L1=2");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(has(wrong.err, "did you mean 'D1'?")) << wrong.err;
  EXPECT_EQ(bench.run(kRunDives + "--offset D1=2 --offset D01=3").exit_code, 2);
  // explain runs the same command again.
  ASSERT_EQ(bench.run(kRunDives + "--offset D1=2 --offset G55=0,0,0").exit_code, 0);
  const Outcome explained = bench.run("explain part-out --at 5,10,-1");
  EXPECT_EQ(explained.exit_code, 0) << explained.err;
  EXPECT_TRUE(has(explained.out, "offsets.radius.1 = 2")) << explained.out;
  // path and check take them too.
  EXPECT_FALSE(
      has(bench.run("check part.nc --control nct --offset D1=2 --offset G55=0,0,0").err, "has no value"));
}

TEST(Offsets, OfAClampingAndOverTheJob) {
  const Workbench bench;
  bench.write("part.nc", kRing);
  const std::string head =
      "schema = 'proveout.job/1'\ncontrol = 'nct'\n[stock]\nshape = 'box'\nmin = [0, 0, -10]\nmax = [20, 20, "
      "0]\n"
      "[[tool]]\nnumber = 1\ntype = 'flat'\ndiameter = 4\n[simulation]\nresolution = "
      "0.5\n[placement]\norigin = [0, 0, 0]\n";
  bench.write("two.toml",
              head +
                  "[offsets.work]\nG54 = [0, 0, 3]\n[[setup]]\nname = 'top'\nprogram = 'part.nc'\n"
                  "[[setup]]\nname = 'again'\nprogram = 'part.nc'\n[setup.offsets.work]\nG54 = [0, 0, 3]\n");
  const auto removed = [&](const std::string& options) {
    const Outcome outcome = bench.run("run two.toml --no-render --out o " + options);
    EXPECT_NE(outcome.exit_code, 2) << outcome.err;
    const Json report = reportOf(bench, "o");
    return std::pair(report["setups"][0]["removed_mm3"].get<double>() > 1,
                     report["setups"][1]["removed_mm3"].get<double>() > 1);
  };
  EXPECT_EQ(removed(""), std::pair(false, false)) << "cut in the air";
  EXPECT_EQ(removed("--offset again:G54=0,0,0"), std::pair(false, true));
  EXPECT_EQ(removed("--offset G54=0,0,0 --offset again:G54.1P1=1,1,1"), std::pair(true, false))
      << "cut before";
}

TEST(Options, BlockSkipUnitAndMachineOfAProgram) {
  const Workbench bench;
  bench.write("part.nc", "G90 G17 T1 M6\nS1000 M3\nG0 X0.2 Y0.2 Z0.2\nG1 Z-0.05 F10\n/ X0.6\nG0 Z0.2\nM30\n");
  const auto removed = [&](const std::string& options) {
    const Outcome outcome = bench.run(kRunDives + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return reportOf(bench)["stock"]["removed_mm3"].get<double>();
  };
  const double mm = removed(""), inch = removed("--program-unit inch");
  EXPECT_GT(inch, 20 * mm);
  EXPECT_LT(removed("--program-unit inch --skip"), 0.9 * inch);
  bench.write("machine.toml", "tool_change_s = 100\n");
  removed("--machine machine.toml");
  EXPECT_GT(reportOf(bench)["time"]["cycle_s"], 100);
  EXPECT_TRUE(has(readFile(bench.path("part-out/report.json")), "\"role\": \"machine\""));
  bench.write("machine.toml", "[machine]\ntool_change_s = 200\n");
  removed("--machine machine.toml");
  EXPECT_GT(reportOf(bench)["time"]["cycle_s"], 200);
  bench.write("machine.toml", "tool_chnage_s = 1\n");
  const Outcome wrong = bench.run(kRunDives + "--machine machine.toml");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(has(wrong.err, "did you mean 'tool_change_s'?")) << wrong.err;
  EXPECT_EQ(bench.run(kRunDives + "--machine none.toml").exit_code, 2);
}

}  // namespace
}  // namespace proveout::test
