// Jobs whose nominal is brought onto the part.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "app/run_report.h"
#include "app/session/nominal/alignment.h"
#include "io/mesh_io.h"
#include "removal/compare/fit/fit.h"
#include "tests/unit/app/block_job.h"
#include "tests/unit/app/memory_run.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using testing::HasSubstr;

/// A step along X in a block of 20 x 20 x 10.
const std::string kStep =
    "%\nO1\nG21 G90 G17 T1 M6\nS3000 M3\nG0 X-6 Y0 Z5\nG1 Z-4 F300\nX26\nG0 Z5\nX-6 Y5\nG1 Z-4\nX26\nG0 "
    "Z50\nM30\n%\n";

TriMesh stepped() {
  return shapes::blocks({0, 20}, {0, 8, 20}, {-10, -4, 0},
                        [](int, int j, int k) { return j == 1 || k == 0; });
}

class Aligned : public testing::Test {
 protected:
  Aligned() : folder_(std::filesystem::temp_directory_path() / "proveout_test_alignment") {
    std::filesystem::create_directories(folder_);
  }
  ~Aligned() override { std::filesystem::remove_all(folder_); }

  /// The part's own model, moved off by `away`.
  Job jobWith(const RigidTransform& away, AlignKind kind, double limit_mm) const {
    Job job = app_test::blockJob("step", {20, 20, 10}, {app_test::toolOf(1, 6)});
    TriMesh mesh = stepped();
    moveMesh(away, mesh);
    const std::string path = (folder_ / "nominal.stl").string();
    EXPECT_TRUE(writeMesh(mesh, path, MeshFormat::kStlBinary));
    job.nominal.emplace();
    job.nominal->mesh.path = path;
    job.nominal->align.kind = kind;
    job.nominal->align.limit_mm = limit_mm;
    return job;
  }

  std::filesystem::path folder_;
};

const RigidTransform kAway{rotationXyzDeg({0.2, -0.1, 0.3}), {0.15, -0.1, 0.2}};

TEST_F(Aligned, ByAFitThePartIsRight) {
  const Result<RunResult> off = app_test::run(jobWith(kAway, AlignKind::kNone, 1.0), {kStep});
  ASSERT_TRUE(off) << off.error().message;
  ASSERT_TRUE(off->comparison);
  EXPECT_FALSE(off->comparison->pass());
  EXPECT_FALSE(off->alignment);
  const Job job = jobWith(kAway, AlignKind::kFit, 1.0);
  const Result<RunResult> run = app_test::run(job, {kStep});
  ASSERT_TRUE(run) << run.error().message;
  ASSERT_TRUE(run->alignment);
  EXPECT_LT(farthestMove(run->alignment->motion * kAway, stepped()), 1e-3);
  EXPECT_LT(turnOf(run->alignment->motion * kAway), 1e-5);
  EXPECT_EQ(run->alignment->free_directions, 0);
  ASSERT_TRUE(run->comparison);
  EXPECT_TRUE(run->comparison->pass());
  EXPECT_LT(run->comparison->rms_mm, 1e-3);
  ASSERT_TRUE(run->nominal);
  EXPECT_LT((meshBounds(*run->nominal).min - Vec3(0, 0, -10)).norm(), 1e-3);
  EXPECT_TRUE(app_test::ofKind(run->findings, FindingKind::kNominalPlacement).empty());
}

TEST_F(Aligned, AGougeDoesNotPull) {
  // A drill hole that is not in the model.
  const std::string gouged =
      kStep.substr(0, kStep.find("G0 Z50")) + "G0 Z5\nX10 Y14\nG1 Z-0.5\nG0 Z50\nM30\n%\n";
  const Result<RunResult> run = app_test::run(jobWith(kAway, AlignKind::kFit, 1.0), {gouged});
  ASSERT_TRUE(run) << run.error().message;
  ASSERT_TRUE(run->alignment && run->comparison);
  EXPECT_LT(farthestMove(run->alignment->motion * kAway, stepped()), 2e-3);
  ASSERT_EQ(run->comparison->patches.size(), 1u);
  EXPECT_NEAR(run->comparison->patches[0].depth_mm, 0.5, 2e-3);
}

TEST_F(Aligned, NoFartherThanTheLimit) {
  const Result<RunResult> run = app_test::run(jobWith(kAway, AlignKind::kFit, 0.1), {kStep});
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_FALSE(run->alignment);
  EXPECT_FALSE(run->comparison);
  const auto told = app_test::ofKind(run->findings, FindingKind::kNominalPlacement);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_THAT(told[0].message, HasSubstr("no more than 0.1 mm is allowed"));
  EXPECT_THAT(told[0].message, HasSubstr("align_limit = 0.3"));
}

TEST_F(Aligned, DatumsNeedACadModel) {
  Job job = jobWith(kAway, AlignKind::kDatums, 1.0);
  job.nominal->align.datums = {{10, 14, 0}, {1, 1, 1}, {2, 2, 2}};
  const Result<RunResult> run = app_test::run(job, {kStep});
  ASSERT_FALSE(run);
  EXPECT_THAT(run.error().message, HasSubstr("needs a STEP file"));
}

TEST_F(Aligned, TheReportHasItsMatrix) {
  Alignment found;
  found.kind = AlignKind::kFit;
  found.motion = kAway;
  found.turned_rad = degToRad(0.5);
  found.points = 7;
  const ReportAlignment report = reportAlignment(found);
  EXPECT_EQ(report.kind, "fit");
  EXPECT_EQ(report.matrix[1][3], -0.1);
  EXPECT_EQ(report.matrix[0][1], kAway.rotation(0, 1));
  EXPECT_NEAR(report.turned_deg, 0.5, 1e-12);
  EXPECT_EQ(report.points, 7u);
}

}  // namespace
}  // namespace proveout
