// Which body is the part where a program leaves several, and what is clamped behind.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/job_setup.h"
#include "app/session/session.h"
#include "tests/support/temporary_folder.h"

namespace proveout {
namespace {

/// A job file with the programs that it names.
struct FileJob {
  test::TemporaryFolder folder;
  std::string text;

  void program(const std::string& name, const std::string& lines) { folder.write(name, lines); }
  Result<RunResult> run(const std::string& in_stock = "") {
    std::string whole = "schema = \"proveout.job/1\"\n" + text;
    whole.insert(whole.find("[stock]\n") + 8, in_stock);
    Diagnostics diagnostics;
    const std::optional<Job> job = loadJob(folder.write("job.toml", whole), knownJobNames(), diagnostics);
    if (!job) return inputError(diagnostics.all().front().message);
    const JobSources sources(*job);
    Progress progress;
    return runRecorded(*job, sources.all(), progress);
  }
};

const Finding* found(const RunResult& run, FindingKind kind) {
  const auto at = std::find_if(run.findings.begin(), run.findings.end(),
                               [&](const Finding& finding) { return finding.kind == kind; });
  return at == run.findings.end() ? nullptr : &*at;
}

const char* const kRound =
    "[[tool]]\nnumber = 1\ntype = \"insert\"\nshape = \"round\"\nnose_radius = 0.8\norientation = 9\n"
    "points_to = 8\n";
const char* const kBlade =
    "[[tool]]\nnumber = 1\ntype = \"insert\"\nshape = \"groove\"\nwidth = 2\nnose_radius = 0.1\n"
    "orientation = 3\nedge_length = 14\n";
const char* const kBar = "[stock]\nshape = \"cylinder\"\nbase = [0, 0, -12]\nlength = 13\nradius = 10\n";
const char* const kFacing =
    "%P\nG54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X30 Z0.3\nG1 X1.5 F0.2\nG1 X4.5\nG1 Z0\nG1 X30\nG0 Z9\nM5\nM2\n";

/// Facing that ends before the axis leaves a pip; the bar is the part, also behind another clamping.
TEST(PartChoice, APipOfFacingIsNotThePart) {
  FileJob one;
  one.text = fmt::format("control = \"wl4-lathe\"\nprogram = \"nub.nc\"\n{}{}", kBar, kRound);
  one.program("nub.nc", kFacing);
  const Result<RunResult> run = one.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  const std::vector<StockBody>& bodies = run->setups[0].bodies;
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_GT(bodies[0].volume_mm3, 3500.0);
  EXPECT_EQ(bodies[0].role, "part");
  EXPECT_LT(bodies[1].volume_mm3, 0.1);
  EXPECT_NEAR(run->setups[0].extent.bounds.min.z(), -12.0, 1e-6);
  EXPECT_EQ(found(*run, FindingKind::kUncertainPart), nullptr);
  EXPECT_EQ(found(*run, FindingKind::kCutOffPiece), nullptr);  // as the tool leaves

  FileJob two;
  two.text = fmt::format(
      "control = \"wl4-lathe\"\n{}{}[[setup]]\nprogram = \"nub.nc\"\n[[setup]]\nprogram = \"idle.nc\"\n",
      kBar, kRound);
  two.program("nub.nc", kFacing);
  two.program("idle.nc", "%P\nG54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X30 Z9\nM5\nM2\n");
  const Result<RunResult> behind = two.run();
  ASSERT_TRUE(behind.ok()) << behind.error().message;
  EXPECT_NEAR(behind->setups[1].extent.bounds.min.z(), -12.0, 1e-6);
  EXPECT_DOUBLE_EQ(behind->setups[1].bodies[0].volume_mm3, bodies[0].volume_mm3);
}

/// A round insert that cuts a bar in two is no parting: nothing says which piece is meant.
TEST(PartChoice, APieceThatNoPartingLeftIsInDoubt) {
  FileJob job;
  job.text = fmt::format("control = \"wl4-lathe\"\nprogram = \"cut.nc\"\n{}{}", kBar, kRound);
  job.program("cut.nc", "%P\nG54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X30 Z-3\nG1 X0 F0.1\nG1 X30\nG0 Z9\nM2\n");
  const Result<RunResult> run = job.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  ASSERT_EQ(run->setups[0].bodies.size(), 2u);
  EXPECT_NEAR(run->setups[0].bodies[0].bounds.min.z(), -12.0, 1e-6);  // the larger one
  const Finding* doubt = found(*run, FindingKind::kUncertainPart);
  ASSERT_NE(doubt, nullptr);
  EXPECT_EQ(doubt->severity, Severity::kWarning);
  for (const StockBody& body : run->setups[0].bodies)
    EXPECT_NE(doubt->message.find(fmt::format("{:.6g} mm3", body.volume_mm3)), std::string::npos)
        << doubt->message;

  const Result<RunResult> pointed = job.run("part_point = [4, 0, 0]\n");
  ASSERT_TRUE(pointed.ok()) << pointed.error().message;
  EXPECT_NEAR(pointed->setups[0].bodies[0].bounds.max.z(), 1.0, 1e-6);
  EXPECT_EQ(found(*pointed, FindingKind::kUncertainPart), nullptr);
  const Result<RunResult> beside = job.run("part_point = [4, 0, -3]\n");
  ASSERT_FALSE(beside.ok());
  EXPECT_NE(beside.error().message.find("part_point"), std::string::npos) << beside.error().message;
}

TEST(PartChoice, AProgrammedPartingLeavesThePart) {
  FileJob job;
  job.text = fmt::format("control = \"wl4-lathe\"\nprogram = \"part.nc\"\n{}{}", kBar, kBlade);
  job.program("part.nc",
              "%P\nG54 G90 G95\nT1 M6\nG97 S800 M3\nG0 X30 Z-4\nG1 X-0.4 F0.1\nG0 X30\nG0 Z9\nM2\n");
  const Result<RunResult> run = job.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_NEAR(run->setups[0].bodies[0].bounds.max.z(), 1.0, 1e-6);  // the smaller one
  EXPECT_EQ(found(*run, FindingKind::kUncertainPart), nullptr);
}

const char* const kPlate =
    "control = \"nct\"\n[stock]\nshape = \"box\"\nmin = [0, 0, -5]\nmax = [40, 20, 0]\n[[tool]]\nnumber = 1\n"
    "type = \"flat\"\ndiameter = 6\n[simulation]\nresolution = 0.5\n"
    "[[setup]]\nprogram = \"slot.nc\"\n[[setup]]\nprogram = \"behind.nc\"\n";
/// Parts the plate at X10 to X16.
const char* const kSlotAcross = "%O1\nG90 G54\nT1 M6\nS1000 M3\nG0 X13 Y-5 Z5\nG1 Z-6 F300\nY25\nG0 Z9\nM30\n%\n";
/// Cuts over where the smaller piece was.
const char* const kBehind = "%O2\nG90 G54\nT1 M6\nS1000 M3\nG0 X5 Y-5 Z5\nG1 Z-2 F300\nY25\nG0 Z9\nM30\n%\n";

TEST(PartChoice, AMilledPieceThatCameLooseIsNotClampedAgain) {
  FileJob job;
  job.text = kPlate;
  job.program("slot.nc", kSlotAcross);
  job.program("behind.nc", kBehind);
  const Result<RunResult> run = job.run();
  ASSERT_TRUE(run.ok()) << run.error().message;
  ASSERT_EQ(run->setups.size(), 2u);
  const SetupRun &first = run->setups[0], &second = run->setups[1];
  ASSERT_EQ(first.bodies.size(), 2u);
  EXPECT_NEAR(first.bodies[0].volume_mm3, 24 * 20 * 5, 1e-3);
  EXPECT_NE(found(*run, FindingKind::kUncertainPart), nullptr);
  EXPECT_EQ(second.topology.components, 1u);
  EXPECT_NEAR(second.initial_mm3, first.surface.volume_mm3, 1e-9);
  EXPECT_EQ(second.surface.volume_mm3, second.initial_mm3);  // nothing is where the loose piece was
  ASSERT_EQ(second.bodies.size(), 2u);
  EXPECT_NEAR(second.bodies[1].volume_mm3, 10 * 20 * 5, 1e-3);

  const Result<RunResult> pointed = job.run("part_point = [5, 10, -4]\n");
  ASSERT_TRUE(pointed.ok()) << pointed.error().message;
  EXPECT_NEAR(pointed->setups[0].bodies[0].volume_mm3, 10 * 20 * 5, 1e-3);
  EXPECT_EQ(found(*pointed, FindingKind::kUncertainPart), nullptr);
  EXPECT_NEAR(pointed->setups[1].initial_mm3 - pointed->setups[1].surface.volume_mm3, 6 * 20 * 2, 1e-2);
  EXPECT_FALSE(job.run("part_point = [13, 10, -2]\n").ok());
}

}  // namespace
}  // namespace proveout
