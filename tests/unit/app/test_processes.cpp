// Clampings of one job with controls of different processes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/job_setup.h"
#include "app/session/comparison.h"
#include "app/session/findings/uncertainty.h"
#include "app/session/run/process.h"
#include "app/session/session.h"
#include "io/mesh_io.h"
#include "removal/wire/section/prism_mesh.h"
#include "tests/support/temporary_folder.h"

namespace proveout {
namespace {

constexpr double kGrid = 0.25;

const char* const kTurn =
    "%S\nG54 G90 G95\nN1 T1 M6\nN2 G97 S1000 M3\nN3 G0 X{:.3f} Z5\nN4 G1 Z-30 F0.2\nN5 G1 X26\nN6 G0 X60 "
    "Z20\nN7 "
    "M30\n";
/// A flat at Z = {} over the end of the shaft, whose axis is X.
const char* const kMill =
    "%O1\nG17 G21 G40 G90 G94\nN1 T1 M6\nN2 S1500 M3\nN3 G0 X12 Y0 Z15\nN4 Z{:.3f}\nN5 G1 X-2 F300\nN6 G0 "
    "Z15\nN7 M30\n%\n";
const char* const kInsert =
    "[[tool]]\nnumber = 1\ntype = \"insert\"\nnose_radius = 0.4\norientation = 3\ninsert_angle = 55\n"
    "lead_angle = 93\nedge_length = 15\n";
const char* const kLatheSetup = "[[setup]]\nname = \"lathe\"\nprogram = \"turn.nc\"\n";
const char* const kMillSetup =
    "[[setup]]\nname = \"mill\"\nprogram = \"mill.nc\"\n[setup.control]\nname = \"nct\"\n"
    "[[setup.tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 16\n[setup.transform]\n";

/// A bar of 24 x 40, its end at Z0.
struct ShaftJob {
  test::TemporaryFolder folder;
  std::string turn = fmt::format(fmt::runtime(kTurn), 20.0), mill = fmt::format(fmt::runtime(kMill), 7.0);
  std::string transform = "rotate = [0, 90, 0]\n", more;
  std::string setups;  ///< empty: the lathe, then the mill
  std::string messages;
  Job job;

  bool load() {
    folder.write("turn.nc", turn);
    folder.write("mill.nc", mill);
    const std::string text = fmt::format(
        "schema = \"proveout.job/1\"\ncontrol = \"wl4-lathe\"\n[stock]\nshape = \"cylinder\"\n"
        "base = [0, 0, -40]\ndiameter = 24\nlength = 40\n[simulation]\nresolution = {}\nsimplify = 0\n{}{}{}",
        kGrid, kInsert, more, setups.empty() ? kLatheSetup + std::string(kMillSetup) + transform : setups);
    Diagnostics diagnostics;
    const std::string path = folder.write("job.toml", text);
    std::optional<Job> loaded = loadJob(path, knownJobNames(), diagnostics);
    for (const Diagnostic& d : diagnostics.all()) messages += d.message + "\n";
    if (loaded) job = std::move(*loaded);
    return loaded.has_value();
  }
  Result<RunResult> run() {
    if (!load()) return inputError(messages);
    const JobSources sources(job);
    Progress progress;
    return runRecorded(job, sources.all(), progress);
  }
};

/// Of the flat at height z: chords of the shaft of radius r up to the tool's round end.
double flatVolume(double r, double z) {
  const double half = std::sqrt(r * r - z * z), tool = 8.0;
  const int n = 200000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double y = half * (2.0 * (i + 0.5) / n - 1.0);
    sum += (std::sqrt(r * r - y * y) - z) * (2.0 + std::sqrt(tool * tool - y * y)) * 2.0 * half / n;
  }
  return sum;
}

/// Vertices off their exact places: on the grid a fillet of 1.6 cells is met by few edges.
struct OffPlace {
  double farthest = 0.0;  ///< mm
  double share = 0.0;     ///< of vertices more than 5 micrometres off
};

OffPlace offPlace(const Job& job, const RunResult& run) {
  Progress progress;
  const Result<Blank> blank = openBlank(job, progress);
  const auto part = makeExactPart(blank->shape, run);
  OffPlace out;
  const auto& positions = run.surface().mesh.positions;
  for (const auto& p : positions) {
    const double off = std::abs((*part)->at(p.cast<double>(), 1.0).value);
    out.farthest = std::max(out.farthest, off);
    out.share += (off > 0.005 ? 1.0 : 0.0) / static_cast<double>(positions.size());
  }
  return out;
}

void expectInPlace(const ShaftJob& shaft, const RunResult& run) {
  const OffPlace off = offPlace(shaft.job, run);
  EXPECT_LT(off.farthest, 0.4 * kGrid);
  EXPECT_LT(off.share, 0.002);
}

TEST(Processes, AreThoseOfTheControls) {
  EXPECT_EQ(processOf("nct").kind, ProcessKind::kMilling);
  EXPECT_EQ(processOf("wl4-mill").kind, ProcessKind::kMilling);
  EXPECT_EQ(processOf("wl4-lathe").kind, ProcessKind::kTurning);
  EXPECT_EQ(processOf("wedm").kind, ProcessKind::kWire);
}

/// A plate of 40 x 40 x 20 from which a wire cuts a square of 10; the path is made here.
struct WireJob {
  Job job;
  test::TemporaryFolder folder;
  PreparedRun prepared;

  WireJob() {
    job.control = "wedm";
    job.program = folder.write("wire.nc", "G01 X0 Y0\n");
    job.stock = BoxShape{{-20, -20, 0}, {20, 20, 20}};
    Tool wire;
    wire.number = 1;
    wire.type = ToolType::kWire;
    wire.diameter = 0.2;
    job.tools.push_back(wire);
    SetupRun setup;
    setup.job = job;
    ToolpathBuilder builder(setup.interpreted.path);
    builder.file(0, "wire.nc");
    Vec2 at(-6, 0);
    for (const Vec2& to : {Vec2(-5, 0), Vec2(-5, -5), Vec2(5, -5), Vec2(5, 5), Vec2(-5, 5), Vec2(-5, 0)})
      add(builder, at, to, MotionKind::kFeed);
    add(builder, at, {-5, 15}, MotionKind::kRapid);
    prepared.run.setups.push_back(std::move(setup));
    prepared.run.resolution_mm = 0.2;
    prepared.blank = {
        BoxShape{{-20, -20, 0}, {20, 20, 20}}, {{-20, -20, 0}, {20, 20, 20}}, 0.2, std::nullopt};
  }
  static void add(ToolpathBuilder& builder, Vec2& at, const Vec2& to, MotionKind kind) {
    Motion motion;
    motion.kind = kind;
    motion.source.line = 1;
    motion.from = Vec3(at.x(), at.y(), 0);
    motion.to = Vec3(to.x(), to.y(), 0);
    WireSweep sweep;
    sweep.z_high = 20;
    sweep.lower.from = at;
    sweep.lower.to = to;
    sweep.upper = sweep.lower;
    builder.wireMotion(motion, sweep);
    at = to;
  }
  /// Of the square that is left.
  PreparedMesh punch(double side) const {
    const Vec2 half(side / 2, side / 2);
    PlaneBody body;
    body.loops.push_back(rectangleLoop(-half, half));
    PreparedMesh nominal;
    nominal.mesh = prismMesh({body}, 0, 20, 1e-3);
    return nominal;
  }
  void compareWith(PreparedMesh nominal) {
    job.nominal = NominalSpec{};
    job.nominal->gouge_mm = job.nominal->excess_mm = 0.02;
    prepared.run.setups.front().job.nominal = job.nominal;
    prepared.nominal = std::move(nominal);
  }
  Result<RunResult> run(const WorkOnPart& meanwhile = {}) {
    const JobSources sources(job);
    Progress progress;
    return finishRun(job, sources.all(), std::move(prepared), progress, meanwhile);
  }
};

std::size_t countOf(const RunResult& run, FindingKind kind) {
  return static_cast<std::size_t>(
      std::count_if(run.findings.begin(), run.findings.end(),
                    [&](const Finding& finding) { return finding.kind == kind; }));
}

TEST(Processes, AWireCutsAPunchAndItsDie) {
  WireJob wire;
  const Result<RunResult> run = wire.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  const SetupRun& setup = run->setups.front();
  ASSERT_EQ(setup.bodies.size(), 2u);
  EXPECT_EQ(setup.bodies[0].role, "part");
  EXPECT_EQ(setup.bodies[1].role, "slug");
  EXPECT_NEAR(setup.bodies[1].volume_mm3, 20 * 9.8 * 9.8, 1e-4);
  EXPECT_TRUE(run->topology().closedManifold());
  EXPECT_EQ(run->topology().components, 2u);
  EXPECT_EQ(countOf(*run, FindingKind::kRapidContact), 1u);
  EXPECT_EQ(countOf(*run, FindingKind::kSpindleOff), 0u);
}

TEST(Processes, WorkOnAPartIsDoneOnceWithAndWithoutAComparison) {
  for (const bool compares : {true, false}) {
    WireJob wire;
    if (compares) wire.compareWith(wire.punch(9.8));
    std::size_t triangles = 0;
    int calls = 0;
    const Result<RunResult> run = wire.run([&](const SetupRun& last, Progress&) {
      triangles = last.surface.mesh.triangles.size();
      ++calls;
      return Status(Done{});
    });
    ASSERT_TRUE(run.ok()) << run.error().message;
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(triangles, run->surface().mesh.triangles.size());
    EXPECT_GT(triangles, 0u);
    EXPECT_EQ(run->comparison.has_value(), compares);
  }
}

TEST(Processes, WorkThatFailsEndsTheRun) {
  for (const bool compares : {true, false}) {
    WireJob wire;
    if (compares) wire.compareWith(wire.punch(9.8));
    const Result<RunResult> run = wire.run([](const SetupRun&, Progress&) {
      return Status(Error{ErrorKind::kResourceLimit, "no room for pictures"});
    });
    ASSERT_FALSE(run.ok());
    EXPECT_EQ(run.error().message, "no room for pictures");
  }
}

TEST(Processes, AComparisonThatFailsStopsTheWorkBesideIt) {
  WireJob wire;
  PreparedMesh open = wire.punch(9.8);
  open.mesh.triangles.pop_back();
  open.mesh.motion.clear();
  wire.compareWith(std::move(open));
  bool stopped = false;
  const Result<RunResult> run = wire.run([&](const SetupRun&, Progress& progress) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!progress.cancelled() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    stopped = progress.cancelled();
    return Status(Error{ErrorKind::kInterrupted, "interrupted"});
  });
  ASSERT_FALSE(run.ok());
  EXPECT_NE(run.error().message.find("not closed"), std::string::npos) << run.error().message;
  // With one core the work may come first, and nothing has stopped it yet.
  EXPECT_TRUE(stopped || std::thread::hardware_concurrency() < 2);
}

TEST(Processes, APunchIsComparedWithItsNominal) {
  for (const double side : {9.8, 9.9}) {
    WireJob wire;
    wire.compareWith(wire.punch(side));
    const Result<RunResult> run = wire.run();
    ASSERT_TRUE(run.ok()) << run.error().message;
    EXPECT_NEAR(run->setups.front().bodies[0].volume_mm3, 20 * 9.8 * 9.8, 1e-4);
    ASSERT_TRUE(run->comparison.has_value());
    EXPECT_EQ(run->comparison->patches.empty(), side == 9.8);
  }
}

TEST(Processes, WiresTakeAnyBlankButHolesNeedUprightWalls) {
  const Job job = WireJob().job;
  const Process& wire = processOf(job, 0);
  Blank lying{CylinderShape{0, Vec3::Zero(), 5, 0, 10}, {{0, -5, -5}, {10, 5, 5}}, 0.2, std::nullopt};
  EXPECT_TRUE(wire.check(job, 0, lying).ok());
  lying.start_holes = {{{5.0, 0.0}, 0.5}};
  EXPECT_FALSE(wire.check(job, 0, lying).ok());
  EXPECT_TRUE(wire.holds(job.tools.front()));
  EXPECT_FALSE(processOf("nct").holds(job.tools.front()));
  EXPECT_FALSE(processOf("wl4-lathe").holds(job.tools.front()));
  Blank plate{BoxShape{Vec3::Zero(), Vec3::Ones()}, {Vec3::Zero(), Vec3::Ones()}, 0.2, std::nullopt};
  EXPECT_TRUE(wire.check(job, 0, plate).ok());
  plate.start_holes = {{{0.5, 0.5}, 0.5}};
  EXPECT_TRUE(wire.check(job, 0, plate).ok());
  plate.start_holes = {{{0.5, 0.5}, 1.5}};
  EXPECT_FALSE(wire.check(job, 0, plate).ok());
}

TEST(Processes, ATurnedShaftIsMilled) {
  ShaftJob shaft;
  const Result<RunResult> run = shaft.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  ASSERT_EQ(run->setups.size(), 2u);
  ASSERT_FALSE(run->alarm) << run->findings.front().message;
  EXPECT_NE(run->setups[0].form->profile(), nullptr);
  EXPECT_EQ(run->setups[1].form->profile(), nullptr);
  EXPECT_TRUE(run->stock.has_value());
  EXPECT_TRUE(run->topology().closedManifold());
  const SetupRun& mill = run->setups[1];
  EXPECT_DOUBLE_EQ(mill.initial_mm3, run->setups[0].surface.volume_mm3);
  const double expected = flatVolume(10.0, 7.0);
  EXPECT_NEAR(mill.initial_mm3 - mill.surface.volume_mm3, expected, 1e-3 * expected);
  EXPECT_NEAR(static_cast<double>(mill.removal.removed_mm3[mill.removal.removed_mm3.size() - 2]), expected,
              1e-2 * expected);
  expectInPlace(shaft, *run);
}

/// Turned about its own axis, too, and shifted on the grid: the same is milled off.
TEST(Processes, ATurnedShaftGoesOntoTheGridByAnyMove) {
  for (const double spin_deg : {0.0, 33.0, 90.0, 171.7}) {
    const Eigen::AngleAxisd turn(rotationAbout(Vec3::UnitX(), spin_deg) * rotationAbout(Vec3::UnitY(), 90.0));
    ShaftJob shaft;
    shaft.transform =
        fmt::format("axis = [{}, {}, {}]\nangle = {}\ntranslate = [0.0, {}, 0.0]\n", turn.axis().x(),
                    turn.axis().y(), turn.axis().z(), radToDeg(turn.angle()), 1e-3 * spin_deg);
    const Result<RunResult> run = shaft.run();
    ASSERT_TRUE(run.ok()) << run.error().message;
    const SetupRun& mill = run->setups[1];
    const double expected = flatVolume(10.0, 7.0);
    EXPECT_NEAR(mill.initial_mm3 - mill.surface.volume_mm3, expected, 1e-3 * expected) << spin_deg;
    expectInPlace(shaft, *run);
    EXPECT_DOUBLE_EQ(movesUncertainty(*run), 0.0);
  }
}

/// The bar's rest stays in the account, and is not clamped with the part.
TEST(Processes, WhatFellOffOnTheLatheIsCounted) {
  ShaftJob shaft;
  shaft.turn.insert(shaft.turn.find("N7 M30"),
                    "T2 M6\nG97 S700 M3\nG0 X60\nZ-36\nG1 X-1 F0.05\nG0 X60\nZ20\n");
  shaft.more =
      "[[tool]]\nnumber = 2\ntype = \"insert\"\nshape = \"groove\"\nwidth = 3\nnose_radius = 0.2\n"
      "orientation = 3\nedge_length = 20\n";
  const Result<RunResult> run = shaft.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  ASSERT_EQ(run->setups.size(), 2u);
  const SetupRun &lathe = run->setups[0], &mill = run->setups[1];
  ASSERT_EQ(lathe.bodies.size(), 2u);
  EXPECT_EQ(lathe.bodies[0].role, "part");
  EXPECT_NEAR(lathe.bodies[0].bounds.min.z(), -33.0, 0.01);
  ASSERT_EQ(mill.bodies.size(), 2u);
  EXPECT_EQ(mill.bodies[0].role, "part");
  EXPECT_NEAR(mill.bodies[0].bounds.min.x(), -33.0, 0.01);
  EXPECT_EQ(mill.bodies[1].role, "loose");
  EXPECT_DOUBLE_EQ(mill.bodies[1].volume_mm3, lathe.bodies[1].volume_mm3);
  EXPECT_DOUBLE_EQ(mill.initial_mm3, lathe.surface.volume_mm3);
  for (const Finding& finding : run->findings)
    EXPECT_NE(finding.kind, FindingKind::kLoosePiece) << finding.message;
}

TEST(Processes, ThreadsStayOnWhatIsMilled) {
  ShaftJob shaft;
  shaft.turn.insert(shaft.turn.find("N7 M30"),
                    "T2 M6\nG97 S600 M3\nG0 X30 Z8\nG31 X20 Z-20 F2.5 #1=1.5 #2=0.25 #3=0 #4=0 #5=0\n"
                    "G0 X60 Z20\n");
  shaft.more =
      "[[tool]]\nnumber = 2\ntype = \"insert\"\nshape = \"thread\"\ninsert_angle = 60\ntip_flat = 0.4\n"
      "orientation = 8\nedge_length = 2.2\n";
  const Result<RunResult> run = shaft.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  ASSERT_FALSE(run->alarm) << run->findings.front().message;
  ASSERT_FALSE(run->setups[0].form->revolved());
  const SetupRun& mill = run->setups[1];
  EXPECT_LT(mill.initial_mm3 - mill.surface.volume_mm3, 0.9 * flatVolume(10.0, 7.0));  // less the grooves
  EXPECT_NEAR(mill.extent.volume_mm3 / mill.surface.volume_mm3, 1.0, 5e-3);
}

TEST(Processes, ADeviationIsBlamedOnTheClampingThatMadeIt) {
  constexpr double kFacets = 0.031;  // the nominal's own
  ShaftJob good;
  const Result<RunResult> nominal = good.run();
  ASSERT_TRUE(nominal.ok()) << nominal.error().message;
  struct Case {
    double diameter, height;
    const char* setup;
    int block;
  };
  for (const Case& c : {Case{19.8, 7.0, "lathe", 4}, Case{20.0, 6.8, "mill", 5}}) {
    ShaftJob shaft;
    shaft.turn = fmt::format(fmt::runtime(kTurn), c.diameter);
    shaft.mill = fmt::format(fmt::runtime(kMill), c.height);
    const std::string mesh = shaft.folder.path("nominal.stl");
    ASSERT_TRUE(writeMesh(nominal->surface().mesh, mesh, MeshFormat::kStlBinary).ok());
    shaft.more = "[nominal]\nmesh = \"nominal.stl\"\n";
    const Result<RunResult> run = shaft.run();
    ASSERT_TRUE(run.ok()) << run.error().message;
    const auto gouge = std::find_if(run->findings.begin(), run->findings.end(),
                                    [](const Finding& f) { return f.kind == FindingKind::kGouge; });
    ASSERT_NE(gouge, run->findings.end()) << c.setup;
    EXPECT_EQ(gouge->setup, c.setup);
    ASSERT_TRUE(gouge->source.has_value());
    EXPECT_EQ(gouge->source->block, c.block);
    EXPECT_NEAR(gouge->depth_mm.value_or(0.0), c.diameter < 20.0 ? 0.1 : 0.2, kFacets);
  }
}

TEST(Processes, WhatWasMilledIsNotTurned) {
  ShaftJob shaft;
  shaft.setups =
      "[[setup]]\nname = \"mill\"\nprogram = \"mill.nc\"\n[setup.control]\nname = \"nct\"\n"
      "[[setup.tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 16\n" +
      std::string(kLatheSetup);
  const Result<RunResult> run = shaft.run();
  ASSERT_FALSE(run.ok());
  EXPECT_NE(run.error().message.find("setup 'lathe'"), std::string::npos) << run.error().message;
  EXPECT_NE(run.error().message.find("turned"), std::string::npos) << run.error().message;
}

TEST(Processes, AnInsertIsNoToolOfAMill) {
  ShaftJob shaft;
  shaft.setups = kLatheSetup + std::string(
                                   "[[setup]]\nname = \"mill\"\nprogram = \"mill.nc\"\n"
                                   "[setup.control]\nname = \"nct\"\n");
  const Result<RunResult> run = shaft.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_TRUE(run->alarm);
  ASSERT_FALSE(run->findings.empty());
  EXPECT_NE(run->findings.front().message.find("tool 1 is a lathe insert; control nct mills"),
            std::string::npos);
}

TEST(Processes, ASetupHasAMachineOnlyWithItsControl) {
  ShaftJob shaft;
  shaft.setups = kLatheSetup + std::string("[setup.machine]\nrapid = 1000\n");
  EXPECT_FALSE(shaft.load());
  EXPECT_NE(shaft.messages.find("a control of its own"), std::string::npos) << shaft.messages;
}

/// Nothing of the lathe is the mill's: machine, offsets, tools.
TEST(Processes, ASetupWithAControlOfItsOwnStartsAnew) {
  ShaftJob shaft;
  shaft.more = "[machine]\nrapid = 4000\n[offsets.work]\nG54 = [0, 0, 3]\n";
  ASSERT_TRUE(shaft.load()) << shaft.messages;
  const Job lathe = jobOfSetup(shaft.job, 0), mill = jobOfSetup(shaft.job, 1);
  EXPECT_EQ(lathe.control, "wl4-lathe");
  EXPECT_EQ(mill.control, "nct");
  EXPECT_EQ(lathe.settings.work_offsets[0].z(), 3.0);
  EXPECT_EQ(mill.settings.work_offsets[0].z(), 0.0);
  EXPECT_NE(lathe.settings.rapid_mm_min, mill.settings.rapid_mm_min);
  ASSERT_EQ(mill.tools.size(), 1u);
  EXPECT_EQ(mill.tools[0].type, ToolType::kFlat);
  EXPECT_EQ(lathe.tools[0].type, ToolType::kInsert);
}

/// A measuring move in the second clamping meets what was turned in the first.
TEST(Processes, AMillMeasuresWhatTheLatheLeft) {
  ShaftJob shaft;
  shaft.mill = "%O1\nG17 G21 G40 G90 G94\nT1 M6\nG0 X-20 Y0 Z30\nG31 Z0 F100\nG0 Z30\nM30\n%\n";
  const Result<RunResult> run = shaft.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  const auto& motions = run->setups[1].interpreted.path.motions;
  const auto probe = std::find_if(motions.begin(), motions.end(),
                                  [](const Motion& m) { return m.kind == MotionKind::kProbe; });
  ASSERT_NE(probe, motions.end());
  EXPECT_NEAR(probe->to.z(), 10.0, 0.005);
}

}  // namespace
}  // namespace proveout
