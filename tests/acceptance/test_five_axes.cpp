// Heads and tables: one part on three machines, and what must not pass. Rows: nct-25.5-EX nct-25.12-EX
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

fs::path partsFolder() { return fs::path(PROVEOUT_SOURCE_DIR) / "parts"; }
std::string machineFile(const char* name) { return (partsFolder() / "machines" / name).string(); }

class Tetrahedron : public testing::TestWithParam<const char*> {};

/// The manual's part (25.5, 25.12): the same three faces on a head-head, a table-table and a head-table
/// machine.
TEST_P(Tetrahedron, PassesOnEveryMachine) {
  const Workbench bench;
  const fs::path job = partsFolder() / "tetrahedron" / GetParam();
  const Outcome outcome = bench.run("run '" + job.string() + "' --resolution 0.4 --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_LE(report["comparison"]["max_gouge_mm"].get<double>(), 0.03);
}

INSTANTIATE_TEST_SUITE_P(Machines, Tetrahedron,
                         testing::Values("job-hh-255.toml", "job-tt-255.toml", "job-ht-255.toml",
                                         "job-hh-2512.toml", "job-tt-2512.toml", "job-ht-2512.toml"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name.substr(0, name.find('.'));
                         });

/// The tetrahedron with one thing wrong.
class PlantedFault {
 public:
  PlantedFault(const std::string& job, const std::string& file, const std::string& from,
               const std::string& to) {
    fs::copy(partsFolder() / "tetrahedron", bench_.path("tetra"), fs::copy_options::recursive);
    std::string text = readFile(bench_.path("tetra/" + file));
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("nothing to change in " + file);
    bench_.write("tetra/" + file, text.replace(at, from.size(), to));
    outcome_ = bench_.run("run tetra/" + job + " --resolution 0.8 --no-render --out out");
    if (outcome_.exit_code == 1) report_ = json::parse(readFile(bench_.path("out/report.json")));
  }

  /// The verdict is no pass, and a finding of that kind stands at one of `lines`, "FILE:LINE".
  void expectFailAt(const std::string& kind, const std::set<std::string>& lines) const {
    ASSERT_EQ(outcome_.exit_code, 1) << outcome_.err;
    EXPECT_EQ(report_["verdict"], "fail");
    const auto is = [&](const json& finding) {
      return finding["kind"] == kind && finding["severity"] == "error" && finding.contains("source") &&
             lines.contains(placeOf(finding["source"]));
    };
    EXPECT_TRUE(std::ranges::any_of(report_["findings"], is)) << outcome_.err;
  }
  /// What diagnostics of that code say, with their places.
  std::string told(const std::string& code) const {
    std::string all;
    for (const json& d : report_["diagnostics"]) {
      if (d["code"] != code) continue;
      all +=
          (d.contains("source") ? placeOf(d["source"]) : "") + " " + d["message"].get<std::string>() + "\n";
    }
    return all;
  }
  const std::string& said() const { return outcome_.err; }

 private:
  static std::string placeOf(const json& source) {
    return source["file"].get<std::string>() + ":" + std::to_string(source["line"].get<int>());
  }
  Workbench bench_;
  Outcome outcome_;
  json report_;
};

/// Lines of O1000 that cut a face: what is wrong with a face was cut by one of them.
std::set<std::string> cutsOfAFace() {
  std::set<std::string> lines;
  for (const int line : {3, 4, 5, 6, 9, 10, 12}) lines.insert("O1000.nc:" + std::to_string(line));
  return lines;
}

/// The part lies at 0, the operator has entered 0.5: the cause is found with both values.
TEST(FiveAxisFaults, AWrongZero) {
  const PlantedFault fault("job-hh-2512.toml", "job-hh-2512.toml", "[offsets.work]\nG54 = [0, 0, 0]",
                           "[placement]\norigin = [0, 0, 0]\n[offsets.work]\nG54 = [0.5, 0, 0]");
  fault.expectFailAt("gouge", cutsOfAFace());
  EXPECT_TRUE(has(fault.said(), "cause: offsets.work.G54.x = 0.5: X off by +0.5 mm")) << fault.said();
}

/// The tip is 0.2 m beside where the program says: nothing is cut, and the first feed is named.
TEST(FiveAxisFaults, G43InPlaceOfG431) {
  const PlantedFault fault("job-hh-255.toml", "hh255.nc", "N50 G43.1 H1", "N50 G43 H1");
  ASSERT_TRUE(has(fault.said(), "nothing_cut")) << fault.said();
  EXPECT_TRUE(fault.told("nct-length-beside-tool").starts_with("O1000.nc:3 ")) << fault.said();
  EXPECT_TRUE(has(fault.said(), "above nominal")) << fault.said();
}

/// A70.529 C-330 and C-150 are one direction; one angle of each is another.
TEST(FiveAxisFaults, OneAngleOfAPairIsTurnedRound) {
  const PlantedFault fault("job-tt-255.toml", "tt255.nc", "N180 C-330", "N180 A-70.529 C-330");
  fault.expectFailAt("rapid_contact", {"O1000.nc:2"});
  fault.expectFailAt("excess", cutsOfAFace());
}

/// The control takes the table for 0.5 mm beside where it is.
TEST(FiveAxisFaults, AWrongParameterOfTheTable) {
  const PlantedFault fault("job-tt-2512.toml", "job-tt-2512.toml", "control = \"nct\"",
                           "control = { name = \"nct\", nct = { N3213 = 400.5 } }");
  fault.expectFailAt("gouge", cutsOfAFace());
  EXPECT_TRUE(has(fault.told("nct-machine-data"), "N3213 = 400.5, but the machine has 400:")) << fault.said();
}

/// An H that is not the tool's length shows in the part: the body follows the gauge length.
TEST(FiveAxes, AWrongLengthShowsInThePart) {
  const Workbench bench;
  fs::copy(partsFolder() / "tetrahedron", bench.path("tetra"), fs::copy_options::recursive);
  std::string job = readFile(bench.path("tetra/job-hh-255.toml"));
  const std::size_t at = job.find("1 = 45.0");
  ASSERT_NE(at, std::string::npos);
  job.replace(at, 8, "1 = 45.5");
  bench.write("tetra/wrong.toml", job);
  const Outcome outcome = bench.run("run tetra/wrong.toml --resolution 0.4 --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
}

/// What a rapid that turns the table touches is a finding, and only what it touches.
TEST(FiveAxes, ARapidThatTurnsIsWatched) {
  const Workbench bench;
  const std::string job =
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"a.nc\"\n[machine]\nfile = \"" +
      machineFile("trunnion_ac.toml") +
      "\"\n[stock]\nshape = \"box\"\nmin = [-20, -20, -20]\nmax = [20, 20, 0]\n[[tool]]\nnumber = 1\ntype = "
      "\"flat\"\n"
      "diameter = 8\ngauge_length = 60\n[offsets.work]\nG54 = [400, 300, -430]\n[offsets.length]\n1 = 60\n"
      "[simulation]\nresolution = 0.5\n";
  bench.write("job.toml", job);
  // The block turns about a line 70 mm below its top: its edges, 72.8 mm away from there, come up by 2.8 mm.
  bench.write("a.nc", "G54 G0 X0 Y0 Z100\nG43 H1 Z2\nM3 S1000\nA60\nZ50\nM30\n");
  const Outcome low = bench.run("run job.toml --no-render --out low");
  EXPECT_EQ(low.exit_code, 1) << low.err;
  const json report = json::parse(readFile(bench.path("low/report.json")));
  bool rapid = false;
  for (const json& finding : report["findings"])
    rapid = rapid || (finding["kind"] == "rapid_contact" && finding["source"]["line"] == 4);
  EXPECT_TRUE(rapid) << report["findings"].dump(1);
  bench.write("a.nc", "G54 G0 X0 Y0 Z100\nG43 H1 Z4\nM3 S1000\nA60\nZ50\nM30\n");
  const Outcome high = bench.run("run job.toml --no-render --out high");
  EXPECT_EQ(high.exit_code, 0) << high.err;
}

/// With more travel the head takes the other pair in 25.12, and swings through the part on its way to the
/// second face.
TEST(FiveAxes, ASwingThroughThePartIsFound) {
  const Workbench bench;
  fs::copy(partsFolder() / "tetrahedron", bench.path("tetra"), fs::copy_options::recursive);
  std::string machine = readFile(bench.path("tetra/ht.toml"));
  const std::size_t at = machine.find("[-110, 30]");
  ASSERT_NE(at, std::string::npos);
  bench.write("tetra/ht.toml", machine.replace(at, 10, "[-110, 110]"));
  const Outcome outcome = bench.run("run tetra/job-ht-2512.toml --resolution 0.5 --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  bool swing = false;
  for (const json& finding : report["findings"])
    swing = swing || finding.value("/source/text"_json_pointer, std::string()).find("N120 G53.1") == 0;
  EXPECT_TRUE(swing) << report["findings"].dump(1);
}

TEST(FiveAxes, TheMachineIsShownAndAsked) {
  const Workbench bench;
  for (const char* name : {"trunnion_ac.toml", "trunnion_bc.toml", "head_cb.toml", "head_b_table_c.toml",
                           "inclined_bc.toml", "table_a.toml"}) {
    const Outcome outcome = bench.run("machine '" + machineFile(name) + "'");
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.err;
    EXPECT_TRUE(has(outcome.out, "tool directions")) << outcome.out;
  }
  const Outcome at = bench.run("machine '" + machineFile("head_cb.toml") +
                               "' --at 'X60 Y236.7767 Z16.7767 C90 B45' --picture m.png");
  EXPECT_EQ(at.exit_code, 0) << at.err;
  EXPECT_TRUE(has(at.out, "0.0000, 0.7071, 0.7071")) << at.out;
  EXPECT_TRUE(bench.exists("m.png"));
  EXPECT_EQ(bench.run("machine nothing.toml").exit_code, 2);
  EXPECT_EQ(bench.run("machine '" + machineFile("head_cb.toml") + "' --at 'Q5'").exit_code, 2);
  EXPECT_EQ(bench.run("machine '" + machineFile("head_cb.toml") + "' --at 'X1e9'").exit_code, 2);
  bench.write("old.toml", "rapid = 5000\n");
  EXPECT_EQ(bench.run("machine old.toml").exit_code, 2);
}

}  // namespace
}  // namespace proveout::test
