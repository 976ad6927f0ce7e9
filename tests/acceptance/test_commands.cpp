// The other commands, as a user calls them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;

TEST(Commands, PathGivesOneJsonObjectALine) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const Outcome outcome = bench.run("path ring.nc --control nct");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(json::parse(line)["schema"], "proveout.path/1");
  int cuts = 0;
  while (std::getline(lines, line)) {
    const json entry = json::parse(line);
    cuts += entry["type"] == "motion" && entry["kind"] == "feed";
  }
  EXPECT_EQ(cuts, 5);
  const Outcome csv = bench.run("path ring.nc --control nct --format csv --until N40");
  EXPECT_EQ(csv.exit_code, 0);
  EXPECT_FALSE(has(csv.out, "{"));
  EXPECT_EQ(bench.run("path ring.nc").exit_code, 2);
}

TEST(Commands, CheckTellsAllErrors) {
  const Workbench bench;
  bench.write("bad.nc", "G21\nG777\nG0 X1\nG778\nM30\n");
  const Outcome outcome = bench.run("check bad.nc --control nct");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(has(outcome.err, "bad.nc:2:") && has(outcome.err, "bad.nc:4:")) << outcome.err;
  const Outcome as_json = bench.run("check bad.nc --control nct --json");
  EXPECT_EQ(as_json.exit_code, 2);
  EXPECT_EQ(json::parse(as_json.out)["errors"], 2);
  bench.write("good.nc", kRing);
  EXPECT_EQ(bench.run("check good.nc --control nct").exit_code, 0);
}

TEST(Commands, CheckTellsOvertravel) {
  const Workbench bench;
  bench.write("far.nc", "G21 G90\nG0 X5\nX900\nM30\n");
  bench.write("far.toml",
              "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"far.nc\"\n"
              "[machine.limits]\nX = [-400, 400]\n"
              "[stock]\nshape = \"box\"\nmin = [0, 0, -5]\nmax = [9, 9, 0]\n"
              "[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 3\n");
  const Outcome outcome = bench.run("check far.toml");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(has(outcome.err, "far.nc:3: error[overtravel]: X goes to 900")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "X900")) << outcome.err;
  EXPECT_EQ(json::parse(bench.run("check far.toml --json").out)["errors"], 1);
}

TEST(Commands, CoverageListsTheControls) {
  const Workbench bench;
  const Outcome outcome = bench.run("coverage --json");
  ASSERT_EQ(outcome.exit_code, 0);
  const json root = json::parse(outcome.out);
  ASSERT_FALSE(root["controls"].empty());
  EXPECT_EQ(root["controls"][0]["control"], "nct");
  EXPECT_GT(root["controls"][0]["codes"].size(), 50u);
  const std::map<std::string, int> rows = {
      {"nct", 844}, {"wl4-mill", 202}, {"wl4-lathe", 202}, {"flexnc", 163}, {"wedm", 95}};
  int found = 0;
  for (const json& control : root["controls"]) {
    const auto expected = rows.find(control["control"]);
    if (expected == rows.end()) continue;
    ++found;
    const json& all = control["specification"];
    EXPECT_EQ(all["rows"], expected->second) << expected->first;
    EXPECT_EQ(all["rows"].get<int>(), all["done"].get<int>() + all["open"].get<int>());
    EXPECT_EQ(control["rows"].size(), all["rows"].get<std::size_t>());
    for (const json& row : control["rows"]) EXPECT_NE(row["status"], "unlisted") << row["id"];
    if (control["codes"].empty()) {
      EXPECT_EQ(all["done"], 0) << expected->first;
    }
  }
  EXPECT_EQ(found, 5);
  EXPECT_TRUE(has(bench.run("coverage --control nct").out, "rows of the specification"));
  EXPECT_TRUE(has(bench.run("coverage --control wedm").out, "all         95    95     0"));
  EXPECT_TRUE(has(bench.run("coverage --control flexnc").out, "all        163   163     0"));
  EXPECT_EQ(bench.run("coverage --control siemens").exit_code, 2);
}

/// Words in place of numbers, correctors by number, the nearest key where one is wrong.
TEST(Commands, FlexncReadsTheSwitchesOfItsMachine) {
  const Workbench bench;
  bench.write("arc.pmc", "S300M03\nG98F100\nG00X30Z0\nG02X20Z-10I0K-10\nM02\n");
  const auto checked = [&](const std::string& settings) {
    bench.write(
        "arc.toml",
        "schema = \"proveout.job/1\"\nprogram = \"arc.pmc\"\n[control]\nname = \"flexnc\"\n"
        "[control.flexnc]\n" +
            settings +
            "\n[stock]\nshape = \"cylinder\"\nbase = [0, 0, -50]\ndiameter = 60\nlength = 50\n"
            "[[tool]]\nnumber = 1\ntype = \"insert\"\nshape = \"round\"\nnose_radius = 2\norientation = 3\n");
    return bench.run("path arc.toml");
  };
  EXPECT_TRUE(has(checked("arc_view = 'x_up'").out, "\"sweep_deg\":-90"));
  EXPECT_TRUE(has(checked("RT.1 = 0.8").out, "\"sweep_deg\":270"));
  EXPECT_TRUE(has(checked("arc_veiw = 'x_up'").err, "did you mean 'arc_view'?"));
  const Outcome word = checked("arc_view = 'x_upp'");
  EXPECT_EQ(word.exit_code, 2);
  EXPECT_TRUE(has(word.err, "arc.toml:6:") && has(word.err, "did you mean 'x_up'?")) << word.err;
  EXPECT_TRUE(has(checked("raw_x = 1").err, "a text in quotes"));
  EXPECT_TRUE(has(checked("TIP.1 = 12").err, "TIP.1"));
}

TEST(Commands, WireEdmCutsUprightAndLeaningWalls) {
  const Workbench bench;
  bench.write("hole.nc", "T84T86;\nC001;\nG92X0Y0;\nG01X5.;\nG02X-5.I-5.;\nX5.I5.;\nG01X0;\nM02;\n");
  EXPECT_EQ(bench.run("check hole.nc --control wedm").exit_code, 0);
  const Outcome path = bench.run("path hole.nc --control wedm");
  EXPECT_EQ(path.exit_code, 0);
  EXPECT_TRUE(has(path.out, R"("kind":"cut","z":[0,20],"lower":{"from":[5,0],"to":[-5,0],"center":[0,0],)"));
  const std::string job =
      "schema = \"proveout.job/1\"\ncontrol = \"wedm\"\nprogram = \"PROGRAM\"\n[stock]\nshape = \"box\"\n"
      "min = [-9, -9, 0]\nmax = [9, 9, 20]\nstart_hole = [{ at = [0, 0], diameter = 1 }]\n[[tool]]\nnumber = "
      "1\ntype = \"wire\"\ndiameter = 0.2\n"
      "spark_gap = 0.01\n";
  const auto jobOf = [&](const std::string& program) {
    return std::string(job).replace(job.find("PROGRAM"), 7, program);
  };
  bench.write("hole.toml", jobOf("hole.nc"));
  const Outcome run = bench.run("run hole.toml --no-render --out out");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json report = nlohmann::json::parse(readFile(bench.path("out/report.json")));
  const auto& bodies = report["stock"]["bodies"];
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0]["role"], "part");
  EXPECT_NEAR(bodies[0]["volume_mm3"].get<double>(), 20 * (18.0 * 18 - std::numbers::pi * 5.11 * 5.11), 0.5);
  EXPECT_EQ(bodies[1]["role"], "slug");
  // Without the hole there is nothing to thread the wire through.
  std::string solid = jobOf("hole.nc");
  solid.replace(solid.find("start_hole"), solid.find("[[tool]]") - solid.find("start_hole"), "");
  bench.write("solid.toml", solid);
  const Outcome blind = bench.run("run solid.toml --no-render --out blind");
  EXPECT_EQ(blind.exit_code, 1);
  EXPECT_TRUE(has(blind.err, "hole.nc:4: error[threading]: there is no hole")) << blind.err;
  // With taper the hole is a cone.
  bench.write("taper.nc",
              "T84T86;\nC001;\nG92X0Y0;\nG51A2.;\nG01X5.;\nG02X-5.I-5.;\nX5.I5.;\nM00;\nG50G01X0;\nM02;\n");
  bench.write("taper.toml", jobOf("taper.nc"));
  EXPECT_EQ(bench.run("check taper.toml").exit_code, 0);
  const Outcome leans = bench.run("run taper.toml --no-render --out lean");
  EXPECT_EQ(leans.exit_code, 0) << leans.err;
  const nlohmann::json cone = nlohmann::json::parse(readFile(bench.path("lean/report.json")));
  const double angle = 2.0 * std::numbers::pi / 180.0, low = 5.0 + 0.11 / std::cos(angle),
               high = low + 20.0 * std::tan(angle);
  const double frame = 20.0 * (18.0 * 18.0 - std::numbers::pi * (low * low + low * high + high * high) / 3.0);
  EXPECT_NEAR(cone["stock"]["bodies"][0]["volume_mm3"].get<double>(), frame, 1e-5 * frame);
  EXPECT_EQ(cone["stock"]["bodies"][1]["leaves"], "up");
}

/// A slot of 6 x 2 is milled along a plate, then a punch of 20 x 12 with corners of 2 cut out of it.
TEST(Commands, AWireCutsWhatWasMilled) {
  const Workbench bench;
  bench.write("punch.nc", readFile(std::string(PROVEOUT_SOURCE_DIR) + "/parts/wire_punch/punch.nc"));
  bench.write("slot.nc",
              "%\nO0001\nN1 G90 G21 G17 G54\nN2 T2 M6\nN3 S3000 M3\nN4 G0 X-25 Y0 Z25\nN5 G0 Z18\n"
              "N6 G1 X25 F500\nN7 G0 Z30\nN8 M30\n%\n");
  const std::string mill =
      "[[setup]]\nname = \"mill\"\nprogram = \"slot.nc\"\n[setup.control]\nname = \"nct\"\n"
      "[[setup.tool]]\nnumber = 2\ntype = \"flat\"\ndiameter = 6\n";
  const std::string wire =
      "[[setup]]\nname = \"wire\"\nprogram = \"punch.nc\"\n[setup.control]\nname = \"wedm\"\n"
      "[[setup.tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = 0.2\nspark_gap = 0.01\n";
  const std::string stock =
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\n[stock]\nshape = \"box\"\nmin = [-15, -12, 0]\n"
      "max = [15, 12, 20]\npart_point = [0, 0, 5]\n[simulation]\nresolution = 0.2\n";
  const double exact = 20.0 * (240.0 - (4.0 - std::numbers::pi) * 4.0) - 240.0;
  for (const std::string& setups : {mill + wire, wire + mill}) {
    bench.write("job.toml", stock + setups);
    const Outcome outcome = bench.run("run job.toml --no-render --out out");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json report = json::parse(readFile(bench.path("out/report.json")));
    const auto& bodies = report["stock"]["bodies"];
    ASSERT_EQ(bodies.size(), 2u) << setups;
    EXPECT_EQ(bodies[0]["role"], "part");
    EXPECT_NEAR(bodies[0]["volume_mm3"].get<double>(), exact, 1e-3 * exact) << setups;
    EXPECT_TRUE(report["stock"]["closed"].get<bool>());
  }
}

TEST(Commands, WireEdmLeanLimit) {
  const Workbench bench;
  bench.write("taper.nc",
              "T84T86;\nC001;\nG92X0Y0;\nG51A2.;\nG01X5.;\nG02X-5.I-5.;\nX5.I5.;\nG50G01X0;\nM02;\n");
  bench.write("taper.toml",
              "schema = \"proveout.job/1\"\nprogram = \"taper.nc\"\n[control]\nname = \"wedm\"\n"
              "[control.wedm]\nMAX_TILT = 1.5\n[stock]\nshape = \"box\"\nmin = [-9, -9, 0]\n"
              "max = [9, 9, 20]\n[[tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = 0.2\n");
  for (const char* command : {"check taper.toml", "run taper.toml --no-render --out out"}) {
    const Outcome outcome = bench.run(command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_TRUE(has(outcome.err, "taper.nc:5:") && has(outcome.err, "[wedm-tilt]")) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "the machine's limit is 1.5 (MAX_TILT of the job)")) << outcome.err;
  }
}

TEST(Commands, CompareMeasuresABox) {
  const Workbench bench;
  bench.write("part.obj", boxObj(0, 0, 0, 10, 10, 4.9));
  bench.write("cad.obj", boxObj(0, 0, 0, 10, 10, 5));
  const Outcome bad = bench.run("compare part.obj cad.obj --json");
  EXPECT_EQ(bad.exit_code, 1) << bad.err;
  EXPECT_NEAR(json::parse(bad.out)["comparison"]["max_gouge_mm"].get<double>(), 0.1, 1e-5);
  EXPECT_TRUE(has(bad.err, "error[gouge]"));
  const Outcome good = bench.run("compare part.obj cad.obj --gouge 0.2 --out result --size 200x150");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_TRUE(bench.exists("result/report.json") && bench.exists("result/deviation.png"));
  EXPECT_EQ(bench.run("compare part.obj none.obj").exit_code, 2);
  bench.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(bench.run("compare open.obj cad.obj").exit_code, 2);
}

/// Points in a grid of 0.5 mm on top and sides of a box from 0, 0, 0, as PLY; its bottom was not scanned.
std::string boxScan(const std::array<double, 3>& size, const std::array<double, 3>& moved,
                    const std::string& more = "") {
  std::ostringstream rows;
  auto count = std::count(more.begin(), more.end(), '\n');
  const auto add = [&](double x, double y, double z) {
    rows << x + moved[0] << ' ' << y + moved[1] << ' ' << z + moved[2] << '\n';
    ++count;
  };
  for (double a = 0.25; a < size[0]; a += 0.5)
    for (double b = 0.25; b < size[1]; b += 0.5) add(a, b, size[2]);
  for (double z = 0.25; z < size[2]; z += 0.5) {
    for (double a = 0.25; a < size[0]; a += 0.5) {
      add(a, 0, z);
      add(a, size[1], z);
    }
    for (double b = 0.25; b < size[1]; b += 0.5) {
      add(0, b, z);
      add(size[0], b, z);
    }
  }
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + rows.str() + more;
}

TEST(Commands, CompareMeasuresAScan) {
  const Workbench bench;
  bench.write("cad.obj", boxObj(0, 0, 0, 20, 16, 6));
  bench.write("scan.ply", boxScan({20, 16, 6}, {0, 0, 0}));
  const Outcome good =
      bench.run("compare cad.obj scan.ply --scan --out result --size 200x150 --deviation ply,csv");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  const json report = json::parse(readFile(bench.path("result/report.json")));
  const json& scan = report["comparison"]["scan"];
  EXPECT_EQ(scan["kind"], "points");
  EXPECT_EQ(scan["off"], 0);
  const double all = 2.0 * (20 * 16 + 20 * 6 + 16 * 6), seen = all - 20 * 16;
  EXPECT_NEAR(scan["coverage"].get<double>(), seen / all, 0.05);
  EXPECT_LT(report["comparison"]["rms_mm"].get<double>(), 1e-5);
  EXPECT_EQ(report["comparison"]["nominal"], "cad.obj");
  // What was not scanned is told everywhere.
  EXPECT_TRUE(has(good.err, "warning[not_compared]")) << good.err;
  EXPECT_TRUE(has(good.out, "% of the nominal's surface was scanned")) << good.out;
  EXPECT_TRUE(has(readFile(bench.path("result/report.html")), "of the surface scanned"));
  EXPECT_TRUE(bench.exists("result/deviation.png"));
  EXPECT_TRUE(bench.exists("result/cad-deviation.ply"));

  bench.write("bumped.ply", boxScan({20, 16, 6}, {0, 0, 0}, "10 8 6.3\n10.1 8 6.3\n500 0 0\n"));
  const Outcome bad = bench.run("compare cad.obj bumped.ply --scan --json");
  EXPECT_EQ(bad.exit_code, 1);
  const json told = json::parse(bad.out);
  EXPECT_NEAR(told["comparison"]["max_excess_mm"].get<double>(), 0.3, 1e-5);
  EXPECT_EQ(told["comparison"]["scan"]["off"], 1);
  EXPECT_TRUE(has(bad.err, "error[excess]") && has(bad.err, "warning[scan]")) << bad.err;
}

TEST(Commands, CompareAlignsTheNominal) {
  const Workbench bench;
  bench.write("cad.obj", boxObj(0, 0, 0, 20, 16, 6));
  bench.write("part.obj", boxObj(0.3, -0.2, 0.1, 20.3, 15.8, 6.1));
  EXPECT_EQ(bench.run("compare part.obj cad.obj").exit_code, 1);
  const Outcome fit =
      bench.run("compare part.obj cad.obj --align fit --out result --no-view3d --size 200x150");
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_TRUE(has(fit.out, "fit: nominal moved by up to 0.3742 mm")) << fit.out;
  const json report = json::parse(readFile(bench.path("result/report.json")));
  const json& matrix = report["comparison"]["alignment"]["matrix"];
  EXPECT_NEAR(matrix[0][3].get<double>(), 0.3, 1e-5);
  EXPECT_NEAR(matrix[1][3].get<double>(), -0.2, 1e-5);
  EXPECT_NEAR(matrix[2][3].get<double>(), 0.1, 1e-5);
  // A picture that is coloured later has the nominal where it was compared.
  EXPECT_EQ(bench.run("render part.obj -o heat.png --size 200x150 --heatmap result/report.json").exit_code,
            0);

  bench.write("scan.ply", boxScan({20, 16, 6}, {0.3, -0.2, 0.1}));
  const Outcome scan = bench.run("compare cad.obj scan.ply --scan --align fit --json");
  EXPECT_EQ(scan.exit_code, 0) << scan.err;
  EXPECT_NEAR(json::parse(scan.out)["comparison"]["alignment"]["matrix"][1][3].get<double>(), -0.2, 1e-5);

  const Outcome far = bench.run("compare part.obj cad.obj --align fit --align-limit 0.2");
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_TRUE(has(far.err, "error[nominal_placement]") && has(far.err, "--align-limit")) << far.err;
}

TEST(Commands, CompareRefusesWhatIsNoScan) {
  const Workbench bench;
  bench.write("cad.obj", boxObj(0, 0, 0, 20, 16, 6));
  bench.write("scan.ply", boxScan({20, 16, 6}, {0, 0, 0}));
  bench.write("nan.ply", boxScan({20, 16, 6}, {0, 0, 0}, "nan 0 0\n"));
  bench.write("none.ply", boxScan({0, 0, 0}, {0, 0, 0}));
  bench.write("far.ply", boxScan({20, 16, 6}, {300, 0, 0}));
  const auto errorOf = [&](const std::string& command) {
    const Outcome outcome = bench.run(command);
    EXPECT_EQ(outcome.exit_code, 2) << command << outcome.err;
    return outcome.err;
  };
  // Without --scan points are no solid, and the message says what to do.
  EXPECT_TRUE(has(errorOf("compare scan.ply cad.obj"), "MODEL SCAN --scan"));
  EXPECT_TRUE(has(errorOf("compare cad.obj nan.ply --scan"), "not a finite number"));
  EXPECT_TRUE(has(errorOf("compare cad.obj none.ply --scan"), "has no points"));
  EXPECT_TRUE(has(errorOf("compare scan.ply cad.obj --scan"), "must end in .ply or .stl"));
  EXPECT_TRUE(
      has(errorOf("compare cad.obj scan.ply --scan --general-tolerance m"), "not measured on a scan"));
  EXPECT_TRUE(has(errorOf("compare cad.obj scan.ply --scan --align datums"), "--datum X,Y,Z three times"));
  EXPECT_TRUE(has(errorOf("compare cad.obj scan.ply --align-limit 2"), "nothing is aligned"));
  const Outcome far = bench.run("compare cad.obj far.ply --scan");
  EXPECT_EQ(far.exit_code, 1);
  EXPECT_TRUE(has(far.err, "the scan does not lie where the model does")) << far.err;
}

/// A bush of that bore about Z, 20 in diameter and 10 high, as facets of 5 degrees.
std::string bushObj(double bore) {
  constexpr int kSectors = 72;
  std::string text, faces;
  for (int i = 0; i < kSectors; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSectors;
    for (const double radius : {10.0, 0.5 * bore})
      for (const int z : {0, 10})
        text += "v " + std::to_string(radius * std::cos(angle)) + " " +
                std::to_string(radius * std::sin(angle)) + " " + std::to_string(z) + "\n";
    const auto corner = [&](int sector, int k) {
      return " " + std::to_string(4 * (sector % kSectors) + k + 1);
    };
    // Outside, top, bore, bottom: from this sector to the next one.
    for (const auto& [low, high] : {std::pair(0, 1), std::pair(1, 3), std::pair(3, 2), std::pair(2, 0)})
      faces += "f" + corner(i, low) + corner(i + 1, low) + corner(i + 1, high) + corner(i, high) + "\n";
  }
  return text + faces;
}

TEST(Commands, CompareFindsFeaturesInMeshes) {
  const Workbench bench;
  bench.write("part.obj", bushObj(8.5));
  bench.write("cad.obj", bushObj(8.0));
  const Outcome bad = bench.run("compare part.obj cad.obj --general-tolerance m --gouge 1 --json");
  EXPECT_EQ(bad.exit_code, 1) << bad.err;
  const json comparison = json::parse(bad.out)["comparison"];
  EXPECT_TRUE(comparison["features_found"].get<bool>());
  const json& hole = comparison["features"][0];
  EXPECT_EQ(hole["feature"], "through hole of diameter 8 at X0.000 Y0.000");
  EXPECT_LT(hole["residual_mm"].get<double>(), 1e-4);
  EXPECT_EQ(hole["characteristics"][0]["name"], "diameter");
  EXPECT_NEAR(hole["characteristics"][0]["nominal"].get<double>(), 8.0, 1e-4);
  EXPECT_NEAR(hole["characteristics"][0]["measured"].get<double>(), 8.5, 1e-3);
  EXPECT_EQ(hole["characteristics"][0]["verdict"], "fail");
  EXPECT_TRUE(has(bad.err, "diameter of the through hole of diameter 8")) << bad.err;
  EXPECT_EQ(bench.run("compare cad.obj cad.obj --general-tolerance mK").exit_code, 0);
  // Nobody asked for features: none are looked for.
  const Outcome plain = bench.run("compare part.obj cad.obj --gouge 1 --json");
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_FALSE(json::parse(plain.out)["comparison"].contains("features"));
}

TEST(Commands, RenderDrawsAMeshAndAHeatMap) {
  const Workbench bench;
  bench.write("part.obj", boxObj(0, 0, 0, 10, 10, 4.9));
  bench.write("cad.obj", boxObj(0, 0, 0, 10, 10, 5));
  ASSERT_EQ(bench.run("render part.obj --size 200x150").exit_code, 0);
  const std::string plain = readFile(bench.path("part.png"));
  EXPECT_EQ(plain.substr(1, 3), "PNG");
  ASSERT_EQ(bench.run("compare part.obj cad.obj --out result --size 200x150").exit_code, 1);
  const Outcome heat =
      bench.run("render part.obj -o heat.png --view top --size 200x150 --heatmap result/report.json");
  EXPECT_EQ(heat.exit_code, 0) << heat.err;
  EXPECT_NE(readFile(bench.path("heat.png")), plain);
  // The nominal's unit is the report's: the same model in inch gives the same colours.
  bench.write("cad_inch.obj", boxObj(0, 0, 0, 10 / 25.4, 10 / 25.4, 5 / 25.4));
  std::string report = readFile(bench.path("result/report.json"));
  report.replace(report.find("cad.obj"), 7, "cad_inch.obj");
  bench.write("result/inch.json", report);
  const std::string render =
      "render part.obj -o inch.png --view top --size 200x150 --heatmap result/inch.json";
  ASSERT_EQ(bench.run(render).exit_code, 0);
  EXPECT_NE(readFile(bench.path("inch.png")), readFile(bench.path("heat.png")));
  report.replace(report.find("\"nominal_unit\": \"mm\""), 20, "\"nominal_unit\": \"inch\"");
  bench.write("result/inch.json", report);
  ASSERT_EQ(bench.run(render).exit_code, 0);
  EXPECT_EQ(readFile(bench.path("inch.png")), readFile(bench.path("heat.png")));
  ASSERT_EQ(bench.run("render part.obj -o cut.png --view section --size 200x150").exit_code, 0);
  EXPECT_NE(readFile(bench.path("cut.png")), readFile(bench.path("part.png")));  // the same view, whole
  bench.write("open.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
  EXPECT_EQ(bench.run("render open.obj").exit_code, 0);
  const Outcome open = bench.run("render open.obj --view section");
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_TRUE(has(open.err, "open edges 3")) << open.err;
  bench.write("turned.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  EXPECT_TRUE(has(bench.run("render turned.obj --view section").err, "inside out"));
  EXPECT_EQ(bench.run("render part.obj --view sideways").exit_code, 2);
  EXPECT_EQ(bench.run("render part.obj --size 9x9").exit_code, 2);
  EXPECT_EQ(bench.run("render none.obj").exit_code, 2);
  EXPECT_EQ(bench.run("render part.obj --heatmap part.obj").exit_code, 2);
  EXPECT_EQ(bench.run("render part.obj -o none/x.png").exit_code, 2);
  const Outcome jpeg = bench.run("render part.obj -o x.jpg");
  EXPECT_EQ(jpeg.exit_code, 2);
  EXPECT_TRUE(has(jpeg.err, "must end in .png")) << jpeg.err;
  EXPECT_FALSE(bench.exists("x.jpg"));
  EXPECT_EQ(bench.run("render").err.rfind("proveout: error: MESH is required", 0), 0u);
}

TEST(Commands, AModelThatLiesElsewhereIsTheOneFinding) {
  const Workbench bench;
  bench.write("part.obj", boxObj(0, 0, 0, 20, 10, 5));
  bench.write("turned.obj", boxObj(-10, 0, 0, 0, 20, 5));
  const Outcome told = bench.run("compare part.obj turned.obj --json");
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_TRUE(has(told.out, "nominal_placement")) << told.out;
  EXPECT_FALSE(has(told.out, "\"excess\"")) << told.out;
  EXPECT_TRUE(has(told.err, "--nominal-rotate 0,0,-90")) << told.err;
  EXPECT_EQ(bench.run("compare part.obj turned.obj --nominal-rotate 0,0,-90").exit_code, 0);
  // Colours by a report know where the model lay.
  bench.write("low.obj", boxObj(-10, 0, 0, 0, 20, 4.9));
  ASSERT_EQ(bench.run("compare part.obj low.obj --nominal-rotate 0,0,-90 --out o --size 200x150").exit_code,
            1);
  EXPECT_EQ(bench.run("render part.obj -o heat.png --size 200x150 --heatmap o/report.json").exit_code, 0);
  std::string report = readFile(bench.path("o/report.json"));
  const std::size_t at = report.find("\"rotate\"");
  ASSERT_NE(at, std::string::npos);
  report.replace(at, 8, "\"rotated\"");
  bench.write("o/report.json", report);
  EXPECT_EQ(bench.run("render part.obj -o heat.png --size 200x150 --heatmap o/report.json").exit_code, 2);
  for (const char* const wrong :
       {"--nominal-at 1,2", "--nominal-at 1,2,nan", "--nominal-rotate 0,0,400", "--nominal-at x"})
    EXPECT_EQ(bench.run(std::string("compare part.obj turned.obj ") + wrong).exit_code, 2) << wrong;
}

TEST(Commands, UnknownWordsNameTheNearestOne) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const auto told = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = bench.run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_TRUE(has(outcome.err, words)) << arguments << "\n" << outcome.err;
  };
  told("rnu ring.nc", "there is no command 'rnu', did you mean 'run'?");
  told("simulate ring.nc", "there is no command 'simulate'; there are run, path, check");
  told("", "a command is missing; there are run, path, check");
  told("--verison", "did you mean '--version'?");
  told("run ring.nc --contorl nct", "run has no option --contorl, did you mean '--control'?");
  told("run ring.nc --tol=1", "did you mean '--tolerance'?");
  told("render part.stl --out x.png", "render has no option --out, did you mean '--output'?");
  told("path ring.nc --control nct --format jsonn", "did you mean 'jsonl'?");
  told("check ring.nc --control ntc", "unknown control ntc, did you mean 'nct'?");
  const std::string run = "run ring.nc --control nct --stock box:0,0,0:9,9,9 --tool 1=flat:3 ";
  told(run + "--view tpo", "did you mean 'top'?");
  told("run ring.nc --control nct --stock cylnder:1 --tool 1=flat:3", "did you mean 'cylinder:'?");
  told("run ring.nc --control nct --stock box:0,0,0:9,9,9 --tool 1=bal:3", "did you mean 'ball'?");
}

TEST(Commands, KeysOfJobsThatPeopleWriteAreMet) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const auto told = [&](const std::string& stock, const std::string& tool, const std::string& words) {
    bench.write("job.toml",
                "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"ring.nc\"\n[stock]\n" + stock +
                    "[[tool]]\nnumber = 1\ntype = \"flat\"\n" + tool);
    const Outcome outcome = bench.run("check job.toml");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(has(outcome.err, words)) << outcome.err;
  };
  const std::string box = "shape = \"box\"\nmin = [0, 0, -5]\nmax = [9, 9, 0]\n";
  told(box, "dia = 3\n", "has no key 'dia'; did you mean 'diameter'?");
  told("type" + box.substr(5), "diameter = 3\n", "has no key 'type'; did you mean 'shape'?");
  told(box, "diameter = 3\n[nominal]\nfile = \"x.stl\"\n", "has no key 'file'; did you mean 'mesh'?");
}

TEST(Commands, ProgramsOfOtherMakersAreNamedInOneLine) {
  const Workbench bench;
  bench.write("plate.h",
              "0 BEGIN PGM PLATE MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 TOOL CALL 1 Z S2000\n"
              "3 L X+10 Y+5 R0 FMAX M3\n4 END PGM PLATE MM\n");
  bench.write("plate.mpf", "N10 G17 G54\nN20 T=\"MILL6\"\nN30 M6\nN40 CYCLE83(10,0,2,-20)\nN50 M30\n");
  for (const char* control : {"nct", "wl4-mill", "wl4-lathe", "flexnc", "wedm"}) {
    const Outcome dialogue = bench.run(std::string("check plate.h --control ") + control);
    EXPECT_EQ(dialogue.exit_code, 2);
    EXPECT_TRUE(has(dialogue.err, "a dialogue program of Heidenhain") && has(dialogue.err, "TNC controls"))
        << dialogue.err;
    EXPECT_EQ(std::count(dialogue.err.begin(), dialogue.err.end(), '\n'), 1) << dialogue.err;
    const Outcome siemens = bench.run(std::string("check plate.mpf --control ") + control);
    EXPECT_TRUE(has(siemens.err, "a program of Sinumerik") && has(siemens.err, "Siemens controls"))
        << siemens.err;
  }
}

TEST(Commands, ANewcomersWireProgramIsToldOfTheJob) {
  const Workbench bench;
  bench.write("wire.nc", "%\nO0001 (PUNCH)\nG90\nG92 X-18. Y0\nM60\nG01 X-10.\nM50\nM02\n%\n");
  const std::string run = "run wire.nc --control wedm --stock box:-15,-12,0:15,12,20";
  for (const char* tool : {"", " --tool 1=ball:6"}) {
    const Outcome outcome = bench.run(run + tool);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(has(outcome.err, "cuts with a wire, which a job file gives")) << outcome.err;
    EXPECT_FALSE(has(outcome.err, "ball:6")) << outcome.err;
  }
  bench.write(
      "wire.toml",
      "schema = \"proveout.job/1\"\ncontrol = \"wedm\"\nprogram = \"wire.nc\"\n[stock]\nshape = \"box\"\n"
      "min = [-15, -12, 0]\nmax = [15, 12, 20]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 6\n");
  const Outcome job = bench.run("run wire.toml --no-render");
  EXPECT_EQ(job.exit_code, 2);
  EXPECT_TRUE(
      has(job.err, "control wedm cuts with a wire: it needs a job file whose [[tool]] has type = \"wire\""))
      << job.err;
}

TEST(Commands, G53WithoutMachineDataGoesToTheTop) {
  const Workbench bench;
  bench.write(
      "up.nc",
      "G21 G90 G17\nT1 M6\nG53 G0 Z0.\nG54 G0 X5 Y5 S5000 M3\nG0 Z15\nG1 Z8 F300\nX15\nG53 G0 Z-100.\nM30\n");
  const Outcome outcome =
      bench.run("run up.nc --control nct --stock box:0,0,0:20,10,10 --tool 1=flat:6 --no-render --out up");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "removed 176.5")) << outcome.out;
  EXPECT_TRUE(has(outcome.err, "[offsets.work]")) << "the key to enter";
  EXPECT_TRUE(has(outcome.out, "0 errors, 1 warning or note")) << "the control's warnings count\n"
                                                               << outcome.out;
}

TEST(Commands, HelpAndVersion) {
  const Workbench bench;
  EXPECT_EQ(bench.run("--help").exit_code, 0);
  EXPECT_TRUE(has(bench.run("--version").out, "proveout "));
  const Outcome none = bench.run("");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(none.out, "");
}

}  // namespace
}  // namespace proveout::test
