// What a run tells of volumes: nothing where nothing was cut, and what was cut where it is thinner than a
// cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;

constexpr const char* kNothing = "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X-40 Y0 Z42\nG0 Z90\nM30\n";
constexpr const char* kTurnNothing = "G54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X50 Z9\nG0 Z0\nG0 X50\nM5\nM2\n";
constexpr const char* kGroove =
    "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X-20 Y4.3 Z30\nG1 Z1.7 F500\nX40\nG0 Z40\nM30\n";
constexpr const char* kMill = "[[setup.tool]]\nnumber = 1\ntype = \"ball\"\ndiameter = 2.8\n";

std::string head(const std::string& control, double resolution) {
  return "schema = \"proveout.job/1\"\nname = \"j\"\ncontrol = \"" + control +
         "\"\n[simulation]\nresolution = " + std::to_string(resolution) + "\n";
}

/// `turn`: empty in a first setup.
std::string milled(const std::string& name, const std::string& program, const std::string& turn) {
  const std::string transform = turn.empty() ? "" : "[setup.transform]\nrotate = " + turn + "\n";
  return "[[setup]]\nname = \"" + name + "\"\nprogram = \"" + program +
         "\"\n[setup.control]\nname = \"nct\"\n" + transform + kMill;
}

json runJob(const Workbench& bench, const std::string& job) {
  bench.write("nothing.nc", kNothing);
  bench.write("turn.nc", kTurnNothing);
  bench.write("groove.nc", kGroove);
  bench.write("job.toml", job);
  const Outcome outcome = bench.run("run job.toml --no-render --json --out out");
  EXPECT_LT(outcome.exit_code, 2) << outcome.err;
  return json::parse(outcome.out, nullptr, false);
}

/// The setups that cut nothing removed nothing, and if all are such nothing may be off.
void expectNothing(const json& report, std::size_t first) {
  ASSERT_TRUE(report.contains("setups"));
  for (std::size_t i = first; i < report["setups"].size(); ++i)
    EXPECT_EQ(report["setups"][i]["removed_mm3"].get<double>(), 0.0) << i;
  if (first > 0) return;
  EXPECT_EQ(report["stock"]["removed_mm3"].get<double>(), 0.0);
  EXPECT_EQ(report["stock"]["error_mm3"].get<double>(), 0.0);
  EXPECT_EQ(report["stock"].value("error_is", ""), "exact");
}

const std::string kTube =
    "[stock]\nshape = \"tube\"\nbase = [0, 0, -17.4]\nlength = 18\nradius = 10\ninner_radius = 0.4\n";
const std::string kTurned =
    "[[tool]]\nnumber = 1\ntype = \"insert\"\nshape = \"groove\"\nwidth = 0.5\nnose_radius = 0\n"
    "orientation = 3\nedge_length = 14\n[[setup]]\nname = \"l\"\nprogram = \"turn.nc\"\n";

TEST(Volumes, NothingIsRemovedBehindALathe) {
  for (const char* turn : {"[90, 0, 0]", "[0, 0, 0]", "[17, 31, 5]"}) {
    const Workbench bench;
    const json report = runJob(bench, head("wl4-lathe", 0.4) + kTube + kTurned +
                                          milled("m", "nothing.nc", turn) + milled("n", "nothing.nc", turn));
    expectNothing(report, 0);
  }
}

TEST(Volumes, NothingIsRemovedInSetupsOfAnyBlank) {
  for (const char* blank :
       {"shape = \"cylinder\"\nbase = [0, 0, 0]\nlength = 7\nradius = 3.3\n",
        "shape = \"tube\"\nbase = [0, 0, 0]\nlength = 7\nradius = 3.3\ninner_radius = 1.1\n",
        "shape = \"box\"\nmin = [0, 0, 0]\nmax = [9, 8, 3]\n"}) {
    for (const char* turn : {"[90, 0, 0]", "[17, 31, 5]"}) {
      const Workbench bench;
      const std::string stock = std::string("[stock]\n") + blank;
      expectNothing(runJob(bench, head("nct", 0.5) + stock + milled("a", "nothing.nc", "") +
                                      milled("b", "nothing.nc", turn)),
                    0);
      expectNothing(runJob(bench, head("nct", 0.5) + stock + milled("a", "groove.nc", "") +
                                      milled("b", "nothing.nc", turn) + milled("c", "nothing.nc", turn)),
                    1);
    }
  }
}

TEST(Volumes, NothingIsRemovedFromASavedStock) {
  const Workbench bench;
  bench.write("nothing.nc", kNothing);
  bench.write("groove.nc", kGroove);
  ASSERT_EQ(bench
                .run("run groove.nc --control nct --stock cylinder:4,4,0:9:3 --tool 1=ball:2.8 --resolution "
                     "0.5 --no-render --format vdb --out a")
                .exit_code,
            0);
  for (const char* program : {"nothing.nc", "groove.nc"}) {
    const Outcome again = bench.run(std::string("run ") + program +
                                    " --control nct --stock vdb:a/groove.vdb --tool 1=ball:2.8 --no-render "
                                    "--json --out b");
    const json report = json::parse(again.out, nullptr, false);
    EXPECT_EQ(report["stock"]["removed_mm3"].get<double>(), 0.0) << program;
    EXPECT_EQ(report["stock"]["error_mm3"].get<double>(), 0.0) << program;
  }
}

TEST(Volumes, NothingIsRemovedBehindAWire) {
  const Workbench bench;
  bench.write("cut.nc", "G92 X-12.0 Y0;\nG01 X-3.0 Y-3.0;\nG01 X9.0 Y-0.5;\nG01 X-3.0 Y4.0;\nG01 X-3.0 Y-3.0;\n");
  bench.write("still.nc", "G92 X-12.0 Y0;\nG01 X-12.0 Y1.0;\n");
  const std::string wire = "[[setup.tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = 0.2\n";
  const auto wired = [&](const std::string& name, const std::string& program) {
    return "[[setup]]\nname = \"" + name + "\"\nprogram = \"" + program +
           "\"\n[setup.control]\nname = \"wedm\"\n[setup.control.wedm]\nZM = 5\nZS = 0\n" + wire;
  };
  const std::string stock = "[stock]\nshape = \"box\"\nmin = [-10, -8, 0]\nmax = [10, 8, 5]\n";
  for (const char* first : {"cut.nc", "still.nc"}) {
    for (const std::string& second :
         {milled("b", "nothing.nc", "[0, 0, 0]"), milled("b", "nothing.nc", "[90, 0, 0]"),
          milled("b", "nothing.nc", "[10, 20, 30]"), wired("b", "still.nc")}) {
      const json report = runJob(bench, head("wedm", 0.4) + stock + wired("a", first) + second);
      expectNothing(report, first == std::string("still.nc") ? 0 : 1);
    }
  }
}

double removedBy(const Workbench& bench, const std::string& options, double& error) {
  const Outcome outcome = bench.run("run p.nc --control nct --no-render --json --out out " + options);
  const json report = json::parse(outcome.out, nullptr, false);
  error = report["stock"]["error_mm3"].get<double>();
  return report["stock"]["removed_mm3"].get<double>();
}

/// The round bottom of a groove comes through a plate's bottom by a slit that is narrower than a cell.
TEST(Volumes, ASlitInThePlatesBottomCounts) {
  const Workbench bench;
  for (const double depth : {2.9, 2.95, 3.0, 3.02}) {
    char text[200];
    std::snprintf(text, sizeof text, "G21 G90\nT1 M6\nS1000 M3\nG0 X-5 Y5 Z5\nG1 Z-%.2f F500\nX15\nZ5\nM30\n",
                  depth);
    bench.write("p.nc", text);
    double error = 0.0;
    const double removed =
        removedBy(bench, "--stock box:0,0,-3:10,10,0 --tool 1=bull:1.38:0.6 --resolution 0.7", error);
    const double r = 0.69, c = 0.6, over = std::max(0.0, depth - 3.0);
    // Of the whole groove, less what lies below the plate.
    const double below = 2.0 * (r - c) * over + c * c * std::acos(1.0 - over / c) -
                         (c - over) * std::sqrt(2.0 * c * over - over * over);
    const double section = 2.0 * r * depth - (2.0 - 0.5 * std::numbers::pi) * c * c - below;
    const double exact = 10.0 * section;
    EXPECT_NEAR(removed, exact, 1e-3 * exact) << depth;
    EXPECT_LE(std::abs(removed - exact), error + 1e-5 * exact) << depth;
  }
}

/// A chip at a side that is a tenth of a cell and less.
TEST(Volumes, AChipAtASideCounts) {
  const Workbench bench;
  for (const double chip : {0.02, 0.1, 0.35}) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "G21 G90\nT1 M6\nS1000 M3\nG0 X%.3f Y-20 Z30\nG1 Z-5 F500\nY30\nG0 Z40\nM30\n",
                  15.0 - chip);
    bench.write("p.nc", text);
    double error = 0.0;
    const double removed =
        removedBy(bench, "--stock box:0,0,-10:10,10,0 --tool 1=flat:10 --resolution 1", error);
    const double exact = 50.0 * chip;
    EXPECT_LE(std::abs(removed - exact), error + 1e-5 * exact) << chip;
    EXPECT_NEAR(removed, exact, 2e-2 * exact) << chip;
  }
}

}  // namespace
}  // namespace proveout::test
