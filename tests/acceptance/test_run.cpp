// `proveout run` on small parts: files, figures, blame, determinism, interruption.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "core/mesh/tri_mesh.h"
#include "io/mesh_io.h"
#include "program_runner.h"

namespace proveout::test {
namespace {

using nlohmann::json;

json reportIn(const Workbench& bench, const std::string& folder) {
  return json::parse(readFile(bench.path(folder + "/report.json")));
}

TEST(Run, MakesEveryFileAndTrueFigures) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const Outcome outcome =
      bench.run(std::string("run ring.nc") + kRingOptions +
                "--format stl,stl-ascii,obj,ply,vdb --view iso --view top --size 200x150");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(bench.files("ring-out"),
            (std::set<std::string>{"iso.png", "top.png", "junit.xml", "report.html", "report.json",
                                   "ring.obj", "ring.ply", "ring.stl", "ring-ascii.stl", "ring.vdb"}));
  EXPECT_TRUE(has(outcome.out, "ring: pass"));
  EXPECT_FALSE(has(outcome.err, "\r"));  // no progress into a file
  const json report = reportIn(bench, "ring-out");
  EXPECT_EQ(report["schema"], "proveout.report/1");
  EXPECT_EQ(report["verdict"], "pass");
  const double exact = 2.0 * (14 * 14 - (4 - kPi) * 4 - 36);
  EXPECT_NEAR(report["stock"]["removed_mm3"].get<double>(), exact, 0.01 * exact);
  EXPECT_NEAR(report["stock"]["initial_mm3"].get<double>(), 4000.0, 1e-6);
  double per_tool = 0;
  for (const json& tool : report["time"]["per_tool"]) per_tool += tool["removed_mm3"].get<double>();
  EXPECT_NEAR(per_tool, report["stock"]["removed_mm3"].get<double>(), 1e-2);
  for (const char* file : {"ring.stl", "ring-ascii.stl", "ring.obj", "ring.ply"}) {
    const Result<TriMesh> mesh = loadMesh(bench.path(std::string("ring-out/") + file));
    ASSERT_TRUE(mesh.ok()) << file;
    EXPECT_TRUE(analyseTopology(*mesh).closedManifold()) << file;
    EXPECT_NEAR(meshVolume(*mesh), report["stock"]["mesh_mm3"].get<double>(), 0.01) << file;
  }
}

TEST(Run, SameBytesForAnyThreadCount) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  json first;
  std::string mesh, picture;
  for (const std::string threads : {"1", "2", "4"}) {
    const Outcome outcome = bench.run(std::string("run ring.nc") + kRingOptions + "--size 200x150 --out t" +
                                      threads + " --threads " + threads);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    json report = reportIn(bench, "t" + threads);
    report.erase("performance");
    if (first.is_null()) {
      first = report;
      mesh = readFile(bench.path("t1/ring.stl"));
      picture = readFile(bench.path("t1/iso.png"));
      ASSERT_FALSE(mesh.empty() || picture.empty());
      continue;
    }
    EXPECT_EQ(report, first);
    EXPECT_EQ(readFile(bench.path("t" + threads + "/ring.stl")), mesh);
    EXPECT_EQ(readFile(bench.path("t" + threads + "/iso.png")), picture);
  }
}

TEST(Run, GougeIsFoundAndBlamedOnItsBlock) {
  const Workbench bench;
  bench.write("slot.nc",
              "G21 G90 G17 T1 M6\nS1000 M3\nG0 X-5 Y10 Z5\nZ0\nN40 G1 X25 F500\nN50 G0 Z5\n"
              "G0 X10 Y10\nN70 G1 Z-0.5 F100\nG0 Z5\nM30\n");
  bench.write("nominal.obj", boxObj(0, 0, -10, 20, 20, 0));
  const Outcome outcome =
      bench.run(std::string("run slot.nc") + kRingOptions + "--nominal nominal.obj --size 200x150");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "slot.nc:8: error[gouge]")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "N70 G1 Z-0.5 F100"));
  const json report = reportIn(bench, "slot-out");
  EXPECT_EQ(report["verdict"], "fail");
  ASSERT_FALSE(report["findings"].empty());
  EXPECT_EQ(report["findings"][0]["kind"], "gouge");
  EXPECT_EQ(report["findings"][0]["source"]["line"], 8);
  EXPECT_NEAR(report["findings"][0]["depth_mm"].get<double>(), 0.5, 0.01);
  EXPECT_TRUE(bench.exists("slot-out/deviation.png"));
}

TEST(Run, CollisionIsExitOne) {
  const Workbench bench;
  bench.write("crash.nc", "G21 G90 G17 T1 M6\nS1000 M3\nG0 X10 Y10 Z5\nN40 G0 Z-3\nG0 Z5\nM30\n");
  const Outcome outcome = bench.run(std::string("run crash.nc") + kRingOptions + "--size 200x150");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(has(outcome.err, "crash.nc:4: error[rapid_contact]")) << outcome.err;
  EXPECT_TRUE(bench.exists("crash-out/findings.png"));
  EXPECT_TRUE(has(readFile(bench.path("crash-out/junit.xml")), "<failure"));
}

TEST(Run, AlarmIsExitTwoWithAReportAndNoMesh) {
  const Workbench bench;
  bench.write("bad.nc", "G21 G90 T1 M6\nG1 X1 F100\nN30 G1 X(2\nM30\n");
  const Outcome outcome = bench.run(std::string("run bad.nc") + kRingOptions);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(has(outcome.err, "bad.nc:3:")) << outcome.err;
  EXPECT_EQ(bench.files("bad-out"), (std::set<std::string>{"junit.xml", "report.html", "report.json"}));
  const json report = reportIn(bench, "bad-out");
  EXPECT_EQ(report["verdict"], "error");
  EXPECT_EQ(report["findings"][0]["kind"], "alarm");
}

TEST(Run, UntilStopsEarly) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const Outcome outcome =
      bench.run(std::string("run ring.nc") + kRingOptions + "--until N40 --no-render --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_NEAR(report["stock"]["removed_mm3"].get<double>(), 2 * kPi * 4, 0.6);
  EXPECT_FALSE(bench.exists("ring-out/iso.png"));
}

TEST(Run, UntilGivesTheStockAtThatBlockAndSaysSo) {
  const Workbench bench;
  bench.write("two.nc",
              "G21 G90 G17 T1 M6\nS1000 M3\nG0 X5 Y5 Z5\nN40 G1 Z-2 F200\nN50 G0 Z5\nX14 Y14\nN70 G1 Z-3\n"
              "G0 Z5\nM30\n");
  const std::string options = kRingOptions;
  const Outcome part = bench.run("run two.nc" + options + "--until N50 --format stl,vdb --no-render --out a");
  ASSERT_EQ(part.exit_code, 0) << part.err;
  EXPECT_TRUE(has(part.out, "two: pass, partial: only up to N50")) << part.out;
  EXPECT_TRUE(has(part.err, "warning[partial]")) << part.err;
  const json at_block = reportIn(bench, "a");
  EXPECT_EQ(at_block["program"]["until"], "N50");
  EXPECT_NEAR(at_block["stock"]["removed_mm3"].get<double>(), 2 * kPi * 4, 0.6);
  EXPECT_TRUE(has(readFile(bench.path("a/report.html")), "partial: only up to N50 was run"));
  // The rest of the program on the saved stock removes what the whole program removes after that block.
  ASSERT_EQ(bench.run("run two.nc" + options + "--no-render --out b").exit_code, 0);
  const json whole = reportIn(bench, "b");
  EXPECT_TRUE(whole["program"]["until"].is_null());
  ASSERT_EQ(bench.run("run two.nc --control nct --tool 1=flat:4 --stock vdb:a/two.vdb --no-render --out c")
                .exit_code,
            0);
  EXPECT_NEAR(reportIn(bench, "c")["stock"]["final_mm3"].get<double>(),
              whole["stock"]["final_mm3"].get<double>(), 1e-3);
  EXPECT_EQ(readFile(bench.path("a/two.stl")).size() % 50, 84u % 50);
}

TEST(Run, UntilWorksForEveryCommandAndRefusesBlocksThatAreNotThere) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const Outcome check = bench.run("check ring.nc --control nct --until N40");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_TRUE(has(check.out, "partial: only up to N40")) << check.out;
  const Outcome path = bench.run("path ring.nc --control nct --until 4 --format csv");
  EXPECT_EQ(path.exit_code, 0);
  EXPECT_EQ(std::count(path.out.begin(), path.out.end(), '\n'), 3);  // header, rapid, feed
  for (const std::string until : {"N41", "4711"}) {
    const Outcome run = bench.run(std::string("run ring.nc") + kRingOptions + "--no-render --until " + until);
    EXPECT_EQ(run.exit_code, 2) << until;
    EXPECT_TRUE(has(run.err, "ring.nc:10:1: error[nct-until]")) << run.err;
    EXPECT_FALSE(bench.exists("ring-out/ring.stl"));
    EXPECT_EQ(bench.run("check ring.nc --control nct --until " + until).exit_code, 2);
    EXPECT_EQ(bench.run("path ring.nc --control nct --until " + until).exit_code, 2);
  }
  EXPECT_EQ(bench.run("check ring.nc --control nct --until N").exit_code, 2);
  EXPECT_EQ(bench.run("check ring.nc --control nct --until -3").exit_code, 2);
}

TEST(Run, TheBudgetSaysHowFarTheMeshIsSimplified) {
  const Workbench bench;
  bench.write("hole.nc", "G21 G90 T1 M6\nS1000 M3\nG0 X5 Y5 Z5\nG1 Z-4 F200\nG0 Z5\nM30\n");
  const auto bound = [&](const std::string& option) {
    const Outcome outcome = bench.run(
        "run hole.nc --control nct --stock box:0,0,-10:10,10,0 --tool 1=flat:6 --resolution 0.5 --no-render "
        "--out out " +
        option);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json report = reportIn(bench, "out");
    for (const json& term : report["error_budget"])
      if (term["source"] == "simplify") return term["bound_mm"].get<double>();
    return -1.0;
  };
  EXPECT_DOUBLE_EQ(bound(""), 0.05);  // a tenth of the grid
  EXPECT_DOUBLE_EQ(bound("--simplify 0.2"), 0.2);
  EXPECT_DOUBLE_EQ(bound("--simplify 0"), 0.0);
}

/// A pocket of 2 mm on each side of a block of 20 x 20 x 10, turned over about X.
void writeTwoSides(const Workbench& bench, const char* second_z) {
  bench.write("top.nc", "G21 G90 T1 M6\nS1000 M3\nG0 X6 Y5 Z5\nN40 G1 Z-4 F200\nN50 G0 Z5\nM30\n");
  bench.write("bottom.nc", std::string("G21 G90 T1 M6\nS1000 M3\nG0 X14 Y12 Z5\nN40 G1 Z") + second_z +
                               " F200\nG0 Z5\nM30\n");
  bench.write("job.toml",
              "schema = \"proveout.job/1\"\ncontrol = \"nct\"\n[stock]\nshape = \"box\"\nmin = [0, 0, -10]\n"
              "max = [20, 20, 0]\n[[setup]]\nname = \"top\"\nprogram = \"top.nc\"\n[[setup]]\n"
              "name = \"bottom\"\nprogram = \"bottom.nc\"\n[setup.transform]\nrotate = [180, 0, 0]\n"
              "translate = [0, 20, -10]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 6\n"
              "[nominal]\nmesh = \"nominal.obj\"\n[simulation]\nresolution = 0.25\n");
  bench.write("nominal.obj", boxObj(0, 0, -10, 20, 20, 0));
}

TEST(Setups, DeviationsAreBlamedOnTheSetupThatCutThem) {
  const Workbench bench;
  writeTwoSides(bench, "-3");
  const Outcome outcome = bench.run("run job.toml --size 200x150 --csv --out out");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;  // the nominal is the whole block
  EXPECT_TRUE(has(outcome.err, "top.nc:4: error[gouge]")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "bottom.nc:4: error[gouge]")) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "setup top")) << outcome.err;
  const json report = reportIn(bench, "out");
  ASSERT_EQ(report["setups"].size(), 2u);
  EXPECT_NEAR(report["setups"][0]["removed_mm3"].get<double>(), kPi * 9 * 4, 0.6);
  EXPECT_NEAR(report["stock"]["removed_mm3"].get<double>(), kPi * 9 * 7, 1.0);
  EXPECT_NEAR(report["accounting"]["total"]["removed_mm3"].get<double>(),
              report["stock"]["removed_mm3"].get<double>(), 1e-3);
  EXPECT_EQ(report["program"]["files"], json({"top.nc", "bottom.nc"}));
  EXPECT_TRUE(has(readFile(bench.path("out/blocks.csv")), "\nbottom,bottom.nc,4,N40,"));
  EXPECT_TRUE(has(readFile(bench.path("out/report.html")), "<h2>Setups</h2>"));
  EXPECT_TRUE(has(report["error_budget"].dump(), "re-clamping"));
}

TEST(Setups, OptionPicksOne) {
  const Workbench bench;
  writeTwoSides(bench, "-3");
  const Outcome first = bench.run("run job.toml --no-render --setup top --out first");
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_TRUE(has(first.err, "only the setups up to 'top'")) << first.err;
  EXPECT_EQ(reportIn(bench, "first")["checks"]["comparison"], false);
  const Outcome check = bench.run("check job.toml");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_TRUE(has(check.out, "setup top: ") && has(check.out, "setup bottom: ")) << check.out;
  EXPECT_EQ(json::parse(bench.run("check job.toml --json").out)["setups"].size(), 2u);
  EXPECT_EQ(bench.run("path job.toml").exit_code, 2);
  const Outcome path = bench.run("path job.toml --setup bottom --format csv");
  EXPECT_EQ(path.exit_code, 0) << path.err;
  EXPECT_TRUE(has(path.out, "bottom.nc") && !has(path.out, "top.nc")) << path.out;
  const Outcome unknown = bench.run("check job.toml --setup side");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(has(unknown.err, "there are top, bottom")) << unknown.err;
  EXPECT_EQ(bench.run("run job.toml --no-render --until N40").exit_code, 2);
  const Outcome until = bench.run("run job.toml --no-render --setup bottom --until N40 --out until");
  EXPECT_TRUE(has(until.err, "warning[partial]: only the program up to N40")) << until.err;
  bench.write("plain.nc", kRing);
  EXPECT_EQ(bench.run("check plain.nc --control nct --setup top").exit_code, 2);
}

TEST(Run, FixturesMustNotBeTouched) {
  const Workbench bench;
  bench.write("part.nc",
              "G21 G90 T1 M6\nS1000 M3\nG0 X10 Y-10 Z5\nZ-3\nN50 G1 Y10 F200\nN60 X22\nG0 Z5\nM30\n");
  bench.write("clamp.obj", boxObj(20, 0, -7, 24, 20, -1));
  bench.write(
      "job.toml",
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"part.nc\"\n[stock]\nshape = \"box\"\n"
      "min = [0, 0, -10]\nmax = [20, 20, 0]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 4\n"
      "[[fixture]]\nname = \"clamp\"\nmesh = \"clamp.obj\"\n[simulation]\nresolution = 0.25\n");
  const Outcome outcome = bench.run("run job.toml --size 200x150 --out out");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(has(outcome.err, "part.nc:6: error[fixture_contact]: the tool runs into fixture 'clamp'"))
      << outcome.err;
  const json report = reportIn(bench, "out");
  EXPECT_EQ(report["checks"]["fixtures"], true);
  EXPECT_EQ(report["findings"].size(), 1u);
  EXPECT_EQ(report["findings"][0]["source"]["block"], "N60");
  EXPECT_TRUE(has(report["hashes"].dump(), "clamp.obj"));
  EXPECT_TRUE(has(readFile(bench.path("out/junit.xml")), "type=\"fixture contact\""));
  bench.write("clamp.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome open = bench.run("run job.toml --no-render --out open");
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_TRUE(has(open.err, "fixture 'clamp'")) << open.err;
}

/// An OBJ with one of its faces turned round; inside out but for that with `inside_out`.
std::string withTurnedFace(const std::string& obj, bool inside_out) {
  std::istringstream in(obj);
  std::string out;
  bool first = true;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("f ", 0) == 0 && std::exchange(first, false) != inside_out) {
      std::istringstream face(line.substr(2));
      std::string turned, corner;
      while (face >> corner) turned.insert(0, " " + corner);
      line = "f" + turned;
    }
    out += line + "\n";
  }
  return out;
}

TEST(Run, BlanksAndFixturesAreRepairedAsTheNominalIs) {
  const Workbench bench;
  bench.write("part.nc", "G21 G90 T1 M6\nS1000 M3\nG0 X10 Y-10 Z5\nZ-3\nG1 Y10 F200\nX22\nG0 Z5\nM30\n");
  bench.write(
      "job.toml",
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"part.nc\"\n[stock]\nshape = \"mesh\"\n"
      "file = \"blank.obj\"\n"
      "[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 4\n"
      "[[fixture]]\nname = \"clamp\"\nmesh = \"clamp.obj\"\n[simulation]\nresolution = 0.25\n");
  const std::string blank = boxObj(0, 0, -10, 20, 20, 0), clamp = boxObj(20, 0, -7, 24, 20, -1);
  bench.write("blank.obj", blank);
  bench.write("clamp.obj", clamp);
  const std::string run = "run job.toml --no-render --out ";
  ASSERT_EQ(bench.run(run + "sound").exit_code, 1);
  const json sound = reportIn(bench, "sound");
  for (const bool inside_out : {false, true}) {
    bench.write("blank.obj", withTurnedFace(blank, inside_out));
    bench.write("clamp.obj", withTurnedFace(clamp, inside_out));
    const Outcome outcome = bench.run(run + "mended");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "warning[stock]")) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "warning[fixture]: fixture 'clamp'")) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "mixed orientation")) << outcome.err;
    EXPECT_EQ(has(outcome.err, "inside out"), inside_out) << outcome.err;
    const json mended = reportIn(bench, "mended");
    EXPECT_EQ(mended["stock"]["initial_mm3"], sound["stock"]["initial_mm3"]);
    EXPECT_EQ(mended["findings"].size(), sound["findings"].size());
  }
}

TEST(Run, TooMuchMemoryIsRefusedWithTheGridThatFits) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const std::string job =
      "run ring.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=flat:4 --no-render ";
  const Outcome refused = bench.run(job + "--resolution 0.01 --max-memory 0.3");
  EXPECT_EQ(refused.exit_code, 3) << refused.err;
  const std::size_t at = refused.err.find("a grid of 0.01 mm would need about");
  ASSERT_NE(at, std::string::npos) << refused.err;
  const std::size_t fits = refused.err.find("allowed; a grid of ") + 19;
  const std::string grid = refused.err.substr(fits, refused.err.find(' ', fits) - fits);
  EXPECT_EQ(bench.run(job + "--max-memory 0.3 --resolution " + grid).exit_code, 0) << grid;
  const json report = reportIn(bench, "ring-out");
  EXPECT_LE(report["performance"]["predicted_memory_mb"].get<double>(), 300.0);
  EXPECT_LE(report["performance"]["peak_memory_mb"].get<double>(), 1.5 * 300.0);
  const Outcome none = bench.run(job + "--max-memory 0.001");
  EXPECT_EQ(none.exit_code, 3);
}

TEST(Run, ThePartThatIsGoneFailsItsNominal) {
  const Workbench bench;
  bench.write("gone.nc", "G21 G90 T1 M6\nS1000 M3\nG0 X-50 Y10 Z5\nZ-11\nG1 X70 F500\nM30\n");
  bench.write("nominal.obj", boxObj(0, 0, -10, 20, 20, 0));
  const Outcome outcome = bench.run(
      "run gone.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=flat:60 --resolution 0.5 --nominal "
      "nominal.obj");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(has(outcome.err, "error[no_part]")) << outcome.err;
  EXPECT_EQ(reportIn(bench, "gone-out")["verdict"], "fail");
}

TEST(Run, TablesOfBlocksAddUp) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  ASSERT_EQ(bench.run(std::string("run ring.nc") + kRingOptions + "--csv --no-render").exit_code, 0);
  const json report = reportIn(bench, "ring-out");
  EXPECT_EQ(report["outputs"]["tables"], json({"blocks.csv", "mrr.svg"}));
  EXPECT_TRUE(has(readFile(bench.path("ring-out/mrr.svg")), "</svg>"));
  std::istringstream csv(readFile(bench.path("ring-out/blocks.csv")));
  std::string line;
  ASSERT_TRUE(std::getline(csv, line));
  ASSERT_EQ(line.rfind("setup,file,line,block,depth,tool,kind,start_s,time_s,length_mm,removed_mm3,", 0), 0u);
  double time_s = 0, removed_mm3 = 0;
  int rows = 0;
  while (std::getline(csv, line)) {
    ++rows;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 14u) << line;
    time_s += std::stod(cells[8]);
    removed_mm3 += std::stod(cells[10]);
  }
  EXPECT_EQ(rows, 8);  // the tool change and seven blocks with motions
  EXPECT_NEAR(time_s, report["time"]["cycle_s"].get<double>(), 1e-5);
  EXPECT_NEAR(removed_mm3, report["stock"]["removed_mm3"].get<double>(), 1e-3);
  EXPECT_NEAR(report["accounting"]["total"]["removed_mm3"].get<double>(),
              report["stock"]["removed_mm3"].get<double>(), 1e-3);
}

TEST(Run, QuietSaysNothingWhenAllIsWell) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const Outcome outcome = bench.run(std::string("run ring.nc") + kRingOptions + "--no-render --quiet");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(Run, SavedStockGoesOnWhereItStopped) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  ASSERT_EQ(bench.run(std::string("run ring.nc") + kRingOptions + "--no-render --format vdb").exit_code, 0);
  const Outcome again = bench.run(
      "run ring.nc --control nct --stock vdb:ring-out/ring.vdb --tool 1=flat:4 --no-render --out again "
      "--json");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const json report = json::parse(again.out);
  EXPECT_NEAR(report["stock"]["removed_mm3"].get<double>(), 0.0, 1e-6);
}

TEST(Run, InterruptLeavesEarlierResultsAlone) {
  const Workbench bench;
  std::string program = "G21 G90 T1 M6\nS1000 M3 F1000\nG0 X0 Y0 Z5\n";
  for (int i = 0; i < 20000; ++i) {
    program += "G1 X" + std::to_string(i * 37 % 200) + " Y" + std::to_string(i * 91 % 200) + " Z-" +
               std::to_string(1 + i % 15) + "\n";
  }
  bench.write("long.nc", program + "M30\n");
  bench.write("long-out/report.json", "earlier");
  const Outcome outcome = bench.run(
      "run long.nc --control nct --stock box:0,0,-20:200,200,0 --tool 1=ball:6 --resolution 0.1 --threads 1 "
      "--no-render",
      "timeout --preserve-status --kill-after=60 --signal=INT 1 ");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(bench.files("long-out"), std::set<std::string>{"report.json"});
  EXPECT_EQ(readFile(bench.path("long-out/report.json")), "earlier");
}

}  // namespace
}  // namespace proveout::test
