// The sample jobs and real programs, on grids coarse enough for a quick suite.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>
#include <set>
#include <utility>

#include "core/mesh/surface_mesh.h"
#include "core/mesh/tri_mesh.h"
#include "core/mesh/triangle_tree.h"
#include "io/mesh_io.h"
#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

struct SharedProgram {
  const char* file;
  const char* options;
  double part_mm3, tolerance_mm3;  ///< a second simulator's volume, where one is known; else 0
};

/// Names of tests must not hold addresses.
void PrintTo(const SharedProgram& sample, std::ostream* out) { *out << sample.file; }

class Shared : public testing::TestWithParam<SharedProgram> {};

TEST_P(Shared, MachinesToAClosedPart) {
  const SharedProgram& sample = GetParam();
  const fs::path program = fs::path(PROVEOUT_SHARED_PROGRAMS) / sample.file;
  if (!fs::exists(program)) GTEST_SKIP() << program << " is not here";
  const Workbench bench;
  const Outcome outcome = bench.run("run '" + program.string() + "' --control nct " + sample.options +
                                    " --size 320x240 --out out");
  ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  const std::string stl = "out/" + fs::path(sample.file).stem().string() + ".stl";
  const Result<TriMesh> mesh = loadMesh(bench.path(stl));
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_TRUE(analyseTopology(*mesh).closedManifold());
  EXPECT_NEAR(meshVolume(*mesh), report["stock"]["final_mm3"].get<double>(),
              1e-3 * report["stock"]["final_mm3"].get<double>());
  EXPECT_TRUE(bench.exists("out/iso.png"));
  if (sample.part_mm3 > 0) {
    EXPECT_NEAR(report["stock"]["final_mm3"].get<double>(), sample.part_mm3, sample.tolerance_mm3);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Programs, Shared,
    testing::Values(SharedProgram{"bear.nc",
                                  "--stock box:0,0,-20:80,80,0 --tool 1=ball:3.175 --resolution 0.5", 39730,
                                  200},
                    SharedProgram{"flower_mold.nc",
                                  "--stock box:-3.92956,-3.92829,-9.95121:61.0796,61.0529,0 --tool 1=flat:1 "
                                  "--resolution 0.5",
                                  27980, 280},
                    SharedProgram{"circle_diamond_square.gcode",
                                  "--stock box:-60,-60,-10:60,60,0 --tool 1=flat:3 --resolution 0.5", 0, 0}),
    [](const auto& test) { return fs::path(test.param.file).stem().string(); });

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Predicted over taken is within a factor of 1.5.
void expectPredicted(const Workbench& bench, const std::string& arguments) {
  const Outcome outcome = bench.run("run " + arguments + " --no-render --out out");
  ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err;
  const json figures = json::parse(readFile(bench.path("out/report.json")))["performance"];
  const double ratio = figures["predicted_memory_mb"].get<double>() / figures["peak_memory_mb"].get<double>();
  EXPECT_LT(ratio, 1.5) << arguments;
  EXPECT_GT(ratio, 1 / 1.5) << arguments;
}

TEST(Prediction, MemoryIsThatOfTheRunWhateverItIsMadeFrom) {
  const Workbench bench;
  bench.write("slant.nc",
              "T1 M6\nS1000 M3\nG0 X-30 Y0\nZ5\nG1 Z-4 F500\nG1 X30 Y12\nX-20 Y-20\nG0 Z50\nM30\n");
  bench.write("blank.obj", boxObj(-40, -30, -20, 40, 30, 0));
  const std::string rest = " --control nct --tool 1=flat:10";
  expectPredicted(bench, "slant.nc --stock mesh:blank.obj --resolution 0.12" + rest);
  expectPredicted(bench,
                  "slant.nc --stock box:-40,-30,-20:40,30,0 --resolution 0.12 --format stl,vdb" + rest);
  fs::rename(bench.path("out"), bench.path("before"));
  expectPredicted(bench, "slant.nc --stock vdb:before/slant.vdb" + rest);
  const std::string
      head = "schema = \"proveout.job/1\"\ncontrol = \"nct\"\n",
      stock =
          "[stock]\nshape = \"box\"\nmin = [-40, -30, -20]\nmax = [40, 30, 0]\n[[tool]]\nnumber = 1\n"
          "type = \"flat\"\ndiameter = 10\n[simulation]\nresolution = ";
  bench.write("turned.toml", head +
                                 "[[setup]]\nname = \"a\"\nprogram = \"slant.nc\"\n[[setup]]\nname = \"b\"\n"
                                 "program = \"slant.nc\"\n[setup.transform]\nrotate = [0, 0, 33]\n" +
                                 stock + "0.15\n");
  expectPredicted(bench, "turned.toml");
  const std::string plate =
      "[[fixture]]\nname = \"plate\"\nshape = \"box\"\nmin = [-200, -200, -60]\nmax = [200, 200, -20]\n";
  bench.write("plate.toml", head + "program = \"slant.nc\"\n" + plate + stock + "0.15\n");
  expectPredicted(bench, "plate.toml");
  bench.write("vise.obj", boxObj(-60, 15.5, -40, 60, 60, -3));
  bench.write("vise.toml", head +
                               "program = \"slant.nc\"\n[[fixture]]\nname = \"vise\"\nmesh = \"vise.obj\"\n" +
                               stock + "0.15\n");
  expectPredicted(bench, "vise.toml");
}

TEST(Prediction, MemoryIsThatOfTheRunWithinAFactorOfOneAndAHalf) {
  const auto expectRatio = [](const std::string& arguments) {
    const Workbench bench;
    expectPredicted(bench, arguments);
  };
  for (const char* part : {"bracket", "circle_diamond_square", "freeform_patch"}) {
    const fs::path job = fs::path(PROVEOUT_SOURCE_DIR) / "parts" / part / "job.toml";
    expectRatio("'" + job.string() + "' --resolution 0.4");
  }
  const fs::path programs(PROVEOUT_SHARED_PROGRAMS);
  if (!fs::exists(programs / "bear.nc")) GTEST_SKIP() << programs << " is not here";
  for (const char* grid : {"0.5", "0.25"}) {
    expectRatio("'" + (programs / "bear.nc").string() +
                "' --control nct --stock box:0,0,-20:80,80,0 --tool 1=ball:3.175 --resolution " + grid);
  }
}
#endif

/// The jobs under parts/, found when the test runs.
TEST(Parts, EveryJobRunsAndTheGougeIsFound) {
  int jobs = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(PROVEOUT_SOURCE_DIR) / "parts")) {
    const fs::path job = entry.path() / "job.toml";
    if (!fs::exists(job)) continue;
    ++jobs;
    const Workbench bench;
    const Outcome outcome =
        bench.run("run '" + job.string() + "' --resolution 0.6 --size 320x240 --quiet --out out");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << job << "\n" << outcome.err;
    ASSERT_TRUE(bench.exists("out/report.json")) << job;
    const json report = json::parse(readFile(bench.path("out/report.json")));
    EXPECT_TRUE(report["stock"]["closed"].get<bool>()) << job;
    if (entry.path().filename() != "gouged_plate") continue;
    EXPECT_EQ(outcome.exit_code, 1);
    ASSERT_FALSE(report["findings"].empty());
    EXPECT_EQ(report["findings"][0]["kind"], "gouge");
    EXPECT_GT(report["findings"][0]["depth_mm"].get<double>(), 0.3);
    EXPECT_EQ(report["findings"][0]["source"]["block"], "N340");
  }
  EXPECT_GE(jobs, 3);
}

struct PassingPart {
  const char* name;
  double part_mm3;  ///< by the closed form, see make_nominals.py
};

class PassingParts : public testing::TestWithParam<PassingPart> {};

TEST_P(PassingParts, PassAgainstTheirNominals) {
  const Workbench bench;
  const fs::path job = fs::path(PROVEOUT_SOURCE_DIR) / "parts" / GetParam().name / "job.toml";
  const Outcome outcome = bench.run("run '" + job.string() + "' --resolution 0.4 --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(readFile(bench.path("out/report.json")));
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_TRUE(report["findings"].empty());
  EXPECT_NEAR(report["stock"]["final_mm3"].get<double>(), GetParam().part_mm3, 1e-5 * GetParam().part_mm3);
}

INSTANTIATE_TEST_SUITE_P(Programs, PassingParts,
                         testing::Values(PassingPart{"bracket", 69333.394}, PassingPart{"two_sides", 39540.0},
                                         PassingPart{"macro_plate", 141832.212},
                                         PassingPart{"fanuc_plate", 93796.320},
                                         PassingPart{"linuxcnc_plate", 35721.290},
                                         PassingPart{"polar_boss", 91385.824},
                                         PassingPart{"wl4_plate", 23827.168}),
                         [](const auto& test) { return std::string(test.param.name); });

double partVolume(const json& report) {
  double volume = 0.0;
  for (const json& body : report["stock"]["bodies"]) {
    if (body["role"] == "part") volume = body["volume_mm3"].get<double>();
  }
  return volume;
}

// 20 x 12 x 20 mm with corners of 2 mm.
TEST(WirePunch, PassesAndFailsWithoutItsOffset) {
  const Workbench bench;
  const fs::path from = fs::path(PROVEOUT_SOURCE_DIR) / "parts" / "wire_punch";
  for (const char* name : {"job.toml", "punch.nc", "punch.stl", "forgotten.toml", "forgotten.nc"})
    fs::copy(from / name, bench.path(name));
  const Outcome right = bench.run("run job.toml --no-render --out out");
  EXPECT_EQ(right.exit_code, 0) << right.err;
  EXPECT_EQ(right.err, "");
  const double exact = 20.0 * (20.0 * 12.0 - (4.0 - std::numbers::pi) * 4.0);
  EXPECT_NEAR(partVolume(json::parse(readFile(bench.path("out/report.json")))), exact, 1e-5 * exact);
  const Outcome wrong = bench.run("run forgotten.toml --no-render --out wrong");
  EXPECT_EQ(wrong.exit_code, 1) << wrong.err;
  EXPECT_TRUE(has(wrong.err, "gouge")) << wrong.err;
  EXPECT_TRUE(has(wrong.err, "cut without offset")) << wrong.err;
}

/// Slugs as files, sections at heights, of a die with taper.
TEST(WireDie, WritesItsSlugAndSections) {
  const Workbench bench;
  const fs::path from = fs::path(PROVEOUT_SOURCE_DIR) / "parts" / "wire_die";
  for (const char* name : {"die.nc", "die.stl"}) fs::copy(from / name, bench.path(name));
  std::string job = readFile(from / "job.toml");
  bench.write("job.toml", job + "\n[output]\nsections = [0.5, 10]\n");
  const Outcome outcome = bench.run("run job.toml --no-render --bodies --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  const Result<TriMesh> slug = loadMesh(bench.path("out/slugs/1-wire_die.stl"));
  ASSERT_TRUE(slug) << outcome.out;
  const double told = report["stock"]["bodies"][1]["volume_mm3"].get<double>();
  EXPECT_NEAR(meshVolume(*slug), told, 1e-4 * told);
  // 20 x 12 with corners of 2 at the top; 19.5 mm below 2 degrees wider.
  const double out = 19.5 * std::tan(2.0 * std::numbers::pi / 180.0);
  const double hole = (20 + 2 * out) * (12 + 2 * out) - (4.0 - std::numbers::pi) * (2 + out) * (2 + out);
  const std::string drawing = readFile(bench.path("out/section-z0.5.svg"));
  const std::size_t at = drawing.find("z = 0.5 mm: ");
  ASSERT_NE(at, std::string::npos) << drawing.substr(0, 400);
  EXPECT_NEAR(std::stod(drawing.substr(at + 12)), 1200.0 - hole, 0.02);
  EXPECT_TRUE(fs::exists(bench.path("out/section-z10.svg")));
  EXPECT_EQ(bench.run("run job.toml --no-render --out none").exit_code, 0);
  EXPECT_FALSE(fs::exists(bench.path("none/slugs")));
}

/// Runs a sample of a leaning wire, which passes; warnings there may be only of slugs that are lifted out.
json passedReport(const char* part) {
  const Workbench bench;
  const fs::path job = fs::path(PROVEOUT_SOURCE_DIR) / "parts" / part / "job.toml";
  const Outcome outcome = bench.run("run '" + job.string() + "' --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  json report = json::parse(readFile(bench.path("out/report.json")));
  for (const json& finding : report["findings"]) EXPECT_EQ(finding["kind"], "stuck_slug");
  return report;
}

/// A plate less what opens by 2 degrees below a rounded rectangle of 20 x 12; offsets are told level, the
/// wire leans.
TEST(WireDie, HasItsTaper) {
  const json report = passedReport("wire_die");
  const auto area = [](double out) {
    return (20 + 2 * out) * (12 + 2 * out) - (4.0 - std::numbers::pi) * (2 + out) * (2 + out);
  };
  const double angle = 2.0 * std::numbers::pi / 180.0, q = 20.0 * std::tan(angle);
  const double wider = 0.11 * (1.0 / std::cos(angle) - 1.0);
  const double exact =
      20.0 * 40.0 * 30.0 - 20.0 / 6.0 * (area(wider) + 4.0 * area(0.5 * q + wider) + area(q + wider));
  EXPECT_NEAR(partVolume(report), exact, 1e-6 * exact);
  EXPECT_LE(report["comparison"]["max_gouge_mm"].get<double>(), 0.002);
}

/// Between the contours the wire comes nearer than its offset: by less than 0.011 mm.
TEST(WireRuled, IsRuledBetweenItsContours) {
  const json report = passedReport("wire_ruled");
  EXPECT_NEAR(partVolume(report), 4583.619, 3.0);
  EXPECT_NEAR(report["comparison"]["max_gouge_mm"].get<double>(), 0.0106, 0.001);
  EXPECT_LE(report["comparison"]["max_excess_mm"].get<double>(), 0.002);
}

fs::path shaft(const char* job) { return fs::path(PROVEOUT_SOURCE_DIR) / "parts/wl4_shaft" / job; }

TEST(TurnedShaft, PassesAndTellsWhatPartsIt) {
  const Workbench bench;
  const Outcome outcome = bench.run("run '" + shaft("job.toml").string() + "' --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  EXPECT_EQ(report["verdict"], "pass");
  // By make_nominals.py, from the drawing.
  EXPECT_NEAR(partVolume(report), 87338.98, 1e-5 * 87338.98);
  const json& findings = report["findings"];
  const auto is = [](const char* kind) { return [kind](const json& f) { return f["kind"] == kind; }; };
  const auto off = std::find_if(findings.begin(), findings.end(), is("part_off"));
  ASSERT_NE(off, findings.end());
  EXPECT_EQ((*off)["source"]["block"], "N34");
  EXPECT_NEAR((*off)["volume_mm3"], 87338.98, 1e-5 * 87338.98);  // with the thread
  // The verdict's own term is below the tolerance of 0.02.
  for (const json& term : report["error_budget"]) {
    if (term["source"] == "deviations") {
      EXPECT_LT(term["bound_mm"], 0.001);
    }
  }
  // The bar is not the part.
  EXPECT_NE(outcome.out.find("Z-100.000..0.000, beside 1 other piece of 528"), std::string::npos)
      << outcome.out;
  // Besides, the chords of its nominal are told.
  for (const json& f : findings) EXPECT_EQ(f["severity"], "note") << f;
  EXPECT_TRUE(fs::exists(bench.path("out/profile.svg")));
}

/// Mesh of a sample with `options`, and its report.
std::pair<TriMesh, json> sampleOf(const std::string& part, const std::string& options) {
  const Workbench bench;
  const std::string job = (fs::path(PROVEOUT_SOURCE_DIR) / "parts" / part / "job.toml").string();
  const Outcome outcome = bench.run("run '" + job + "' --no-render --out out " + options);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  const std::string file = report["outputs"]["meshes"][0]["path"].get<std::string>();
  return {*loadMesh(bench.path("out/" + file)), report};
}

TEST(Simplify, OfTurnedPartsAllowsLargerFacets) {
  const auto [fine, usual] = sampleOf("flexnc_shaft", "");
  const auto [coarse, report] = sampleOf("flexnc_shaft", "--simplify 0.05");
  EXPECT_LT(6 * coarse.triangles.size(), fine.triangles.size());
  EXPECT_TRUE(analyseTopology(coarse).closedManifold());
  // The verdict is that of the section.
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_NEAR(partVolume(report), partVolume(usual), 1e-6 * partVolume(usual));
  const SurfaceMesh fine_surface = toSurface(fine), coarse_surface = toSurface(coarse);
  const TriangleTree fine_tree(fine_surface), coarse_tree(coarse_surface);
  double most = 0.0;
  for (std::size_t t = 0; t < coarse_surface.triangles.size(); ++t)
    most = std::max(most, fine_tree.nearest(coarse_surface.middle(t)).squared);
  for (const Vec3& p : fine_surface.points) most = std::max(most, coarse_tree.nearest(p).squared);
  EXPECT_LT(std::sqrt(most), 0.05 + 0.001);  // and the facets of the fine one
  EXPECT_GT(std::sqrt(most), 0.01);
}

TEST(Simplify, OfPartsThatAWireCutIsNoReasonForDoubt) {
  const auto [mesh, report] = sampleOf("wire_ruled", "--simplify 0.05");
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_EQ(mesh.triangles.size(), sampleOf("wire_ruled", "").first.triangles.size());
  EXPECT_NE(report["error_budget"].dump().find("simplify does not apply"), std::string::npos);
}

std::string flexncJob(const char* part, const char* job) {
  return "'" + (fs::path(PROVEOUT_SOURCE_DIR) / "parts" / part / job).string() + "'";
}

/// Runs a sample of the FlexNC lathe; `volume` by make_nominals.py, from the drawing.
void expectFlexncPasses(const char* part, double volume) {
  const Workbench bench;
  const Outcome outcome = bench.run("run " + flexncJob(part, "job.toml") + " --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_NEAR(partVolume(report), volume, 1e-5 * volume);
  for (const json& f : report["findings"]) EXPECT_EQ(f["severity"], "note") << f;
}

TEST(FlexncParts, AreWhatTheirTemplatesSay) {
  expectFlexncPasses("flexnc_shaft", 69812.08);
  expectFlexncPasses("flexnc_bore", 118246.78);
}

/// The finding names the template with its parameters, and the motion within it.
TEST(FlexncParts, NameTheTemplateWithTheWrongParameter) {
  const Workbench bench;
  const Outcome outcome =
      bench.run("run " + flexncJob("flexnc_shaft", "wrong-parameter.toml") + " --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  int gouges = 0;
  for (const json& finding : report["findings"]) {
    if (finding["kind"] != "gouge") continue;
    ++gouges;
    EXPECT_EQ(finding["source"]["line"], 21);
    EXPECT_EQ(finding["source"]["text"], "G77X20A16Y1.5P0C2K1");
    EXPECT_EQ(finding["inside"]["file"], "G77 of line 21");
    const json& first = finding["causes"][0];
    EXPECT_EQ(first["value"], "A16");
    EXPECT_EQ(first["along"], "X");
    EXPECT_NEAR(first["off_mm"].get<double>(), -0.5, 0.1);  // the cone gets flatter, too
    EXPECT_GT(first["explains"].get<double>(), 0.99);
  }
  EXPECT_GE(gouges, 1);
}

/// Slot and flat of the sample by integration over the plane: chords of the shaft of 20 mm above Z6.5 and Z7,
/// the chamfer of 1 mm taken off.
constexpr double kKeySlotMm3 = 417.142, kFlatMm3 = 266.216;

/// One job, two controls: every command takes each setup's own.
TEST(KeyedShaft, IsTurnedAndMilledInOneJob) {
  const fs::path job = fs::path(PROVEOUT_SOURCE_DIR) / "parts/keyed_shaft/job.toml";
  const Workbench bench;
  const Outcome check = bench.run("check '" + job.string() + "' --json");
  EXPECT_EQ(check.exit_code, 0) << check.out;
  const json checked = json::parse(check.out);
  EXPECT_EQ(checked["control"], "wl4-lathe, nct");
  ASSERT_EQ(checked["setups"].size(), 2u);
  EXPECT_EQ(checked["setups"][1]["errors"], 0);
  const Outcome path = bench.run("path '" + job.string() + "' --setup mill");
  EXPECT_EQ(path.exit_code, 0) << path.err;
  EXPECT_EQ(json::parse(path.out.substr(0, path.out.find('\n')))["control"], "nct");

  const Outcome outcome = bench.run("run '" + job.string() + "' --resolution 0.4 --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_EQ(report["setups"][0]["control"], "wl4-lathe");
  EXPECT_EQ(report["setups"][1]["control"], "nct");
  EXPECT_NEAR(report["setups"][1]["removed_mm3"].get<double>(), kKeySlotMm3 + kFlatMm3, 1.0);
  const Outcome why = bench.run("explain out --at=-20,0,6.5");
  EXPECT_NE(why.out.find("mill: mill.nc:8"), std::string::npos) << why.out << why.err;
}

TEST(TurnedShaft, FailsWithAWrongNoseAndNamesTheBlocks) {
  const Workbench bench;
  const Outcome outcome =
      bench.run("run '" + shaft("wrong-nose.toml").string() + "' --resolution 0.2 --no-render --out out");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(readFile(bench.path("out/report.json")));
  std::set<std::string> blocks;  // of the contour that the finishing cycle N15 left wrong
  std::size_t by_operator = 0;
  for (const json& finding : report["findings"]) {
    if (!finding.contains("inside") || finding["inside"]["block"] != "N15") continue;
    if (finding["kind"] == "tool_data") {
      EXPECT_NE(finding["message"].get<std::string>().find("RT.2 is 0.4"), std::string::npos);
      // The steepest place of the contour: 0.4 mm less radius, at 45 degrees.
      EXPECT_NEAR(finding["depth_mm"].get<double>(), 0.4 * (std::sqrt(2.0) - 1.0), 2e-3);
      continue;
    }
    blocks.insert(finding["source"]["block"].get<std::string>());
    by_operator += finding["causes"].front()["what"] == "control.wl4-lathe.RT.2";
  }
  EXPECT_TRUE(blocks.contains("N200") && blocks.contains("N203") && blocks.contains("N205"));
  EXPECT_EQ(by_operator, blocks.size());
}

}  // namespace
}  // namespace proveout::test
