// What one clamping hands on to the next: bodies, faces, volumes, and what is told of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;

std::string head(const std::string& control, double resolution, const std::string& stock) {
  return "schema = \"proveout.job/1\"\nname = \"j\"\ncontrol = \"" + control +
         "\"\n[simulation]\nresolution = " + std::to_string(resolution) + "\n[stock]\n" + stock;
}

std::string setup(const std::string& program, const std::string& control, const std::string& turn,
                  const std::string& tool) {
  const std::string transform = turn.empty() ? "" : "[setup.transform]\nrotate = " + turn + "\n";
  return "[[setup]]\nname = \"" + program + "\"\nprogram = \"" + program + "\"\n" + transform +
         "[setup.control]\nname = \"" + control + "\"\n[[setup.tool]]\nnumber = 1\n" + tool;
}

const std::string kWireTool = "type = \"wire\"\ndiameter = 0.2\n";

json report(const Workbench& bench, const std::string& job) {
  bench.write("idle.nc", "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X-60 Y0 Z62\nG0 Z90\nM30\n");
  bench.write("still.nc", "G92 X-32.0 Y0;\nG01 X-32.0 Y1.0;\n");
  bench.write("job.toml", job);
  const Outcome outcome = bench.run("run job.toml --no-render --json --out out");
  EXPECT_LT(outcome.exit_code, 2) << outcome.err;
  return json::parse(outcome.out, nullptr, false);
}

double bodiesOf(const json& report) {
  double sum = 0.0;
  for (const json& body : report["stock"]["bodies"]) sum += body["volume_mm3"].get<double>();
  return sum;
}

/// Of a kind; 0 without one.
double deepest(const json& report, const std::string& kind) {
  double depth = 0.0;
  for (const json& finding : report["findings"])
    if (finding["kind"] == kind) depth = std::max(depth, finding["depth_mm"].get<double>());
  return depth;
}

/// A disc of 0.1 mm was parted off, and lies between the samples of the next clamping's grid.
TEST(Clampings, ALoosePieceStaysWhereTheGridLosesThePart) {
  const Workbench bench;
  bench.write("part.nc",
              "G54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X16 Z4\nG0 Z-2.1\nG1 X0 F0.1\nG0 X16\nG0 Z4\nM2\n");
  const std::string bar = "shape = \"cylinder\"\nbase = [0, 0, -20]\naxis = \"z\"\nlength = 20\nradius = 5\n";
  const json made = report(
      bench, head("wl4-lathe", 0.3, bar) +
                 "[[tool]]\nnumber = 1\ntype = \"insert\"\nshape = \"groove\"\nwidth = 2\nnose_radius = "
                 "0\norientation = 3\nedge_length = 8\n[[setup]]\nname = \"l\"\nprogram = \"part.nc\"\n" +
                 setup("idle.nc", "nct", "[0, 0, 0]", "type = \"ball\"\ndiameter = 2\n"));
  // 2 mm of the bar went into the cut.
  EXPECT_EQ(made["setups"][1]["removed_mm3"].get<double>(), 0.0);
  EXPECT_NEAR(made["stock"]["final_mm3"].get<double>(), 3.14159265 * 25.0 * 18.0, 1.0);
  EXPECT_NEAR(bodiesOf(made), 3.14159265 * 25.0 * 17.9, 1.0);
  EXPECT_TRUE(std::ranges::any_of(made["findings"], [](const json& f) { return f["kind"] == "no_part"; }));
}

/// The bottom of a flat mill 0.3 mm below the top line of a bar that lies along Y.
TEST(Clampings, CurvedFacesOfABlankAreExactBehindClampingsThatCutNothing) {
  const Workbench bench;
  bench.write("over.nc", "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X0 Y-20 Z20\nZ3.7\nG0 Y20\nG0 Z20\nM30\n");
  const std::string bar = "shape = \"cylinder\"\nbase = [0, -8, 0]\naxis = \"y\"\nlength = 16\nradius = 4\n";
  const std::string flat = "type = \"flat\"\ndiameter = 3\n",
                    over = setup("over.nc", "nct", "[0, 0, 0]", flat);
  for (const std::string& idle :
       {setup("idle.nc", "nct", "", flat), setup("still.nc", "wedm", "", kWireTool)}) {
    const bool wire = idle.find("wedm") != std::string::npos;
    const json made = report(bench, head(wire ? "wedm" : "nct", 0.9, bar) + idle + over);
    EXPECT_NEAR(deepest(made, "rapid_contact"), 0.3, 0.002) << idle;
  }
}

/// In a hole of 10 mm that an earlier clamping bored a rapid of a 6 mm mill goes 0.15 mm into the wall.
TEST(Clampings, CurvedWallsOfEarlierClampingsAreExact) {
  for (const char* turn : {"[0, 0, 0]", "[0, 0, 90]", "[0, 0, 33]", "[180, 0, 0]"}) {
    const Workbench bench;
    bench.write("bore.nc", "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X0 Y0 Z30\nG1 Z-20 F100\nG0 Z40\nM30\n");
    bench.write(
        "in.nc",
        "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X0 Y0 Z30\nZ-4\nG0 X1.74 Y1.2547788\nG0 X0 Y0\nG0 Z40\nM30\n");
    const std::string block = "shape = \"box\"\nmin = [-15, -15, -10]\nmax = [15, 15, 10]\n";
    const json made = report(bench, head("nct", 1.0, block) +
                                        setup("bore.nc", "nct", "", "type = \"flat\"\ndiameter = 10\n") +
                                        setup("in.nc", "nct", turn, "type = \"flat\"\ndiameter = 6\n"));
    EXPECT_NEAR(deepest(made, "rapid_contact"), 0.1452, 0.002) << turn;
  }
}

/// A kerf of 0.2 mm through 20 x 10 mm on a grid of 0.7 mm.
TEST(Clampings, AKerfThatTheGridMissesIsTold) {
  const Workbench bench;
  bench.write("groove.nc",
              "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X-20 Y4 Z30\nG1 Z9 F500\nX40\nG0 Z40\nM30\n");
  bench.write("cut.nc", "G92 X-12.0 Y-3.03;\nG01 X12.0 Y-3.03;\n");
  const std::string block = "shape = \"box\"\nmin = [-10, -10, 0]\nmax = [10, 10, 10]\n";
  const json made = report(bench, head("nct", 0.7, block) +
                                      setup("groove.nc", "nct", "", "type = \"flat\"\ndiameter = 2\n") +
                                      setup("cut.nc", "wedm", "[0, 0, 0]", kWireTool));
  ASSERT_EQ(made["setups"].size(), 2u);
  const double kerf = 0.2 * 20.0 * 10.0, removed = made["setups"][1]["removed_mm3"].get<double>();
  EXPECT_GE(made["stock"]["error_mm3"].get<double>(), std::abs(kerf - removed) - 0.05 * kerf);
}

TEST(Clampings, AFreeSlugHasItsVolumeBehindAWire) {
  const Workbench bench;
  bench.write("cut.nc",
              "G92 X-4.0 Y-4.0;\nG01 X4.0 Y-4.0;\nX4.0 Y4.0;\nX-4.0 Y4.0;\nX-4.0 Y-4.0;\nX4.0 Y4.0;\nM02;\n");
  const std::string block = "shape = \"box\"\nmin = [-10, -10, 0]\nmax = [10, 10, 4]\n";
  const json made = report(bench, head("wedm", 0.3, block) + setup("still.nc", "wedm", "", kWireTool) +
                                      setup("cut.nc", "wedm", "[0, 0, 0]", kWireTool));
  double slug = 0.0;
  for (const json& finding : made["findings"])
    if (finding["kind"] == "free_slug") slug = std::max(slug, finding["volume_mm3"].get<double>());
  EXPECT_NEAR(slug, 7.8 * 7.8 * 4.0, 3.0);
}

/// Contours that are cut twice, leaning in and out: 0.3 mm above the block their walls would meet.
TEST(Clampings, WallsThatMeetAboveTheWorkpieceDoNotMatter) {
  const Workbench bench;
  const std::string lines = " A3.800 G01 X21.152 Y3.782;\nG01 X19.466 Y3.620 R0.300;\nG01 X21.150 Y1.262";
  bench.write("cut.nc",
              "H001=0.060;\nH002=0.110;\nG90 G92 X21.044 Y3.200;\nG41 H002 G51" + lines +
                  ";\nG01 X22.836 Y3.944 R0.300;\nG01 X21.152 Y3.782;\nG40 G50 A0 G01 X21.044 "
                  "Y3.200;\nG41 H001 G52 A3.800 G01 X21.152 Y3.782;\nG01 X19.466 Y3.620;\nG01 "
                  "X21.150 Y1.262 R0.300;\nG01 X22.836 Y3.944;\nG01 X21.152 Y3.782;\nG40 G50 A0 G01 "
                  "X21.044 Y3.200;\nM02;\n");
  const json made =
      report(bench, head("wedm", 0.7, "shape = \"box\"\nmin = [4.98, 0, -2.544]\nmax = [29.8, 8.4, 0]\n") +
                        setup("still.nc", "wedm", "", kWireTool) +
                        setup("cut.nc", "wedm", "[0, 0, 0]",
                              "type = \"wire\"\ndiameter = 0.1\nspark_gap = 0.01\n[setup.control.wedm]\nZB = "
                              "-2.544\nT = 2.544\n"));
  EXPECT_GT(made["stock"]["final_mm3"].get<double>(), 500.0);
}

/// In the hollow of a tube a wire goes round a piece of air.
TEST(Clampings, AWireInAHollowFreesNothing) {
  const Workbench bench;
  bench.write("round.nc",
              "G92 X-1.0 Y-1.0;\nG01 X1.0 Y-1.0;\nX1.0 Y1.0;\nX-1.0 Y1.0;\nX-1.0 Y-1.0;\nX1.0 Y1.0;\nM02;\n");
  const std::string tube = "shape = \"tube\"\nbase = [0, 0, 0]\nlength = 4\nradius = 8\ninner_radius = 4\n";
  const json made = report(bench, head("wedm", 0.3, tube) + setup("still.nc", "wedm", "", kWireTool) +
                                      setup("round.nc", "wedm", "[0, 0, 0]", kWireTool));
  EXPECT_EQ(made["stock"]["removed_mm3"].get<double>(), 0.0);
  for (const json& finding : made["findings"])
    EXPECT_TRUE(finding["kind"] != "free_slug" && finding["kind"] != "bridge") << finding;
}

TEST(Clampings, TheVolumeOfASavedStockMayBeOff) {
  const Workbench bench;
  bench.write("idle.nc", "O1\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X-60 Y0 Z62\nG0 Z90\nM30\n");
  bench.write("turn.nc",
              "G54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X16 Z4\nG0 X7 Z1\nG1 X5 Z-3 F0.1\nX9 Z-6.3\nG0 X16\nM2\n");
  bench.write(
      "turn.toml",
      head("wl4-lathe", 0.5,
           "shape = \"cylinder\"\nbase = [0, 0, -12]\naxis = \"z\"\nlength = 12\nradius = 4\n") +
          "[[tool]]\nnumber = 1\ntype = \"insert\"\nnose_radius = 0.4\norientation = 3\ninsert_angle = "
          "35\nlead_angle = 93\nedge_length = 8\n[[setup]]\nname = \"l\"\nprogram = \"turn.nc\"\n");
  const json turned =
      json::parse(bench.run("run turn.toml --no-render --json --format vdb --out a").out, nullptr, false);
  const json again = json::parse(bench
                                     .run("run idle.nc --control nct --stock vdb:a/j.vdb --tool 1=ball:2 "
                                          "--no-render --json --out b")
                                     .out,
                                 nullptr, false);
  ASSERT_TRUE(turned.contains("stock") && again.contains("stock"));
  EXPECT_EQ(turned["stock"]["initial_error_mm3"].get<double>(), 0.0);
  const double off = turned["stock"]["final_mm3"].get<double>() - again["stock"]["initial_mm3"].get<double>(),
               told = again["stock"]["initial_error_mm3"].get<double>();
  EXPECT_GT(std::abs(off), 1e-6);
  EXPECT_LE(std::abs(off), told);
  EXPECT_LT(told, 0.01 * again["stock"]["initial_mm3"].get<double>());
}

}  // namespace
}  // namespace proveout::test
