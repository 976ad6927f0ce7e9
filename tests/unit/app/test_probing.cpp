// Measuring moves of programs against the stock that they have cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/run_report.h"
#include "app/session/findings/uncertainty.h"
#include "tests/unit/app/block_job.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

/// A block of 40 x 30 x 20, its top at Z0; tool 1 a flat of 8, tool 2 a ball of 6 to measure with.
Job probingJob() {
  return app_test::blockJob("probing", {40, 30, 20},
                            {app_test::toolOf(1, 8), app_test::toolOf(2, 6, ToolType::kBall)});
}

Result<RunResult> run(const Job& job, const std::string& program) {
  return app_test::run(job, {"G21 G90 G94 T1 M6\n" + program + "M30\n"});
}

/// A pocket X8 to X32, Y7 to Y22, 5 deep, corners of 4.
constexpr const char* kPocket =
    "S1000 M3\nG0 X12 Y11 Z5\nG1 Z-5 F500\nX28\nY18\nX12\nY11\nX20\nY18\nG0 Z50\nM5\nT2 M6\n";

/// Ends of the probing motions.
std::vector<Vec3> probed(const Result<RunResult>& result) {
  std::vector<Vec3> ends;
  for (const Motion& m : result->setups[0].interpreted.path.motions) {
    if (m.kind == MotionKind::kProbe) ends.push_back(m.to);
  }
  return ends;
}

constexpr double kTwoMicrons = 2e-3;

TEST(Probing, FacesOfTheBlockAndOfThePocketJustMilled) {
  const Result<RunResult> result =
      run(probingJob(),
          std::string(kPocket) +
              "F100\nG0 X-10 Y15\nZ-10\nG31 X10\nG0 X-10\nZ10\nX4 Y4\nG31 Z-5\nG0 Z10\n"
              "X20 Y15\nZ-4\nG31 X50\nG0 X20\nG31 X-20\nG0 X20\nG31 Y50\nG0 Y15\nG31 Y-20\nG0 Y15\nG31 Z-20\n"
              "G0 Z-4\nX28 Y18\nG31 X38 Y28\nG0 X28 Y18\nZ50\n");
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_FALSE(result->alarm);
  const std::vector<Vec3> ends = probed(result);
  const double corner = std::sqrt(0.5);  // the ball's centre comes 4 - 3 from the corner's centre
  const std::vector<Vec3> wanted{{-3, 15, -10}, {4, 4, 0},    {29, 15, -4}, {11, 15, -4},
                                 {20, 19, -4},  {20, 10, -4}, {20, 15, -5}, {28 + corner, 18 + corner, -4}};
  ASSERT_EQ(ends.size(), wanted.size());
  for (std::size_t k = 0; k < ends.size(); ++k) {
    EXPECT_LT((ends[k] - wanted[k]).norm(), kTwoMicrons) << k << ": " << ends[k].transpose();
  }
  // Measuring takes nothing away and is no contact.
  const double pocket = 5 * (24 * 15 - (4 - kPi) * 16);
  EXPECT_NEAR(24000.0 - result->surface().volume_mm3, pocket, 1e-3 * pocket);
  EXPECT_TRUE(result->findings.empty());
}

TEST(Probing, APocketIsCutWhereTheMeasuredOneIsAndResultsArePrinted) {
  const Result<RunResult> result =
      run(probingJob(),
          std::string(kPocket) +
              "F100\nG0 X20 Y15\nZ-4\nG31 X50\n#100=#5061\nG0 X20\nG31 X-20\n#101=#5061\nG0 X20\nG31 Y50\n"
              "#102=#5062\nG0 Y15\nG31 Y-20\n#103=#5062\nG0 Y15\nZ50\nFOPEN2 "
              "<measured.txt>\nDPRNT[X#100[33]Y#103[33]]\nFCLOS\n"
              "T1 M6\nS1000 M3\nG0 X[[#100+#101]/2] Y[[#102+#103]/2]\nG1 Z-8 F300\nG0 Z50\n"
              "M5\nT2 M6\nG31 Z-20 F100\nG0 Z50\n");
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_FALSE(result->alarm);
  const std::vector<Vec3> ends = probed(result);
  ASSERT_EQ(ends.size(), 5u);
  // The hole in the middle of the pocket, X20 Y14.5, 8 deep: measured behind the cut.
  EXPECT_LT((ends[4] - Vec3(20, 14.5, -8)).norm(), kTwoMicrons) << ends[4].transpose();
  ASSERT_EQ(result->setups[0].interpreted.files.size(), 1u);
  const std::string text = result->setups[0].interpreted.files.begin()->second;
  EXPECT_NE(text.find("29.000"), std::string::npos) << text;
  EXPECT_NE(text.find("10.000"), std::string::npos) << text;
}

TEST(Probing, FixturesAreNotMeasuredAndSaidSo) {
  Job job = probingJob();
  job.fixtures = {{"clamp", BoxShape{{50, 0, -7}, {56, 30, -1}}}};
  const Result<RunResult> result = run(job, "T2 M6\nG0 X70 Y15 Z10\nZ-15\nN40 G31 X20 F100\nG0 X70\n");
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_EQ(probed(result).size(), 1u);
  EXPECT_NEAR(probed(result)[0].x(), 43.0, kTwoMicrons);
  bool told = false, met = false;
  for (const Diagnostic& d : result->setups[0].interpreted.path.diagnostics.all())
    told = told || d.code == "probe";
  for (const Finding& f : result->findings)
    met = met || (f.kind == FindingKind::kFixtureContact && f.source->block == 40);
  EXPECT_TRUE(told);
  EXPECT_TRUE(met);
}

TEST(Probing, TheSecondClampingMeasuresWhatTheFirstLeft) {
  Job job = probingJob();
  SetupSpec first, second;
  first.name = "top";
  second.name = "bottom";
  // Turned about X by half a turn: Y becomes 30 - Y, the top looks down.
  second.from_previous.rotation = rotationAbout(Vec3::UnitX(), 180.0);
  second.from_previous.translation = Vec3(0, 30, -20);
  job.setups = {first, second};
  // A slot right through, Y8 to Y16.
  const MemoryProgramSource top(
      "top.nc", "G21 G90 G94 T1 M6\nS1000 M3\nG0 X-10 Y12 Z5\nG1 Z-21 F500\nX50\nG0 Z50\nM30\n");
  const MemoryProgramSource bottom(
      "bottom.nc",
      "G21 G90 G94 T2 M6\nF100\nG0 X-10 Y5 Z-12\nG31 X20\nG0 X-10\nZ10\nX20\nG31 Z-30\nG0 Z10\n"
      "Y18\nZ-10\nG31 Y40\nG0 Y18\nG31 Y0\nG0 Y18\nZ50\nM30\n");
  const RecordingSource a(top, TextEncoding::kAuto), b(bottom, TextEncoding::kAuto);
  Progress progress;
  const Result<RunResult> result = runRecorded(job, {&a, &b}, progress);
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_FALSE(result->alarm);
  std::vector<Vec3> ends;
  for (const Motion& m : result->setups[1].interpreted.path.motions) {
    if (m.kind == MotionKind::kProbe) ends.push_back(m.to);
  }
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_NEAR(ends[0].x(), -3.0, kTwoMicrons);
  EXPECT_NEAR(ends[1].z(), 0.0, kTwoMicrons);
  EXPECT_NEAR(ends[2].y(), 22.0 - 3.0, kTwoMicrons);
  EXPECT_NEAR(ends[3].y(), 14.0 + 3.0, kTwoMicrons);
}

TEST(Probing, WhatOnlyMeasuresMakesNoSurfaceUncertain) {
  Toolpath path;
  path.motions.resize(3);
  path.motions[0].tool = 1;
  path.motions[0].kind = MotionKind::kFeed;
  path.motions[1].tool = path.motions[2].tool = 2;
  path.motions[2].kind = MotionKind::kProbe;
  const Job job = probingJob();
  EXPECT_DOUBLE_EQ(surfaceUncertainty(path, job.tools, 0.4), 0.16 / 32);
  path.motions[1].kind = MotionKind::kFeed;
  EXPECT_DOUBLE_EQ(surfaceUncertainty(path, job.tools, 0.4), 0.16 / 24);
}

TEST(Probing, AToolThatIsNotDefinedIsAnAlarm) {
  Job job = probingJob();
  job.tools.pop_back();
  const Result<RunResult> result = run(job, "T2 M6\nG0 X-10 Y15 Z-10\nG31 X10 F100\n");
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->alarm);
  ASSERT_FALSE(result->findings.empty());
  EXPECT_NE(result->findings[0].message.find("tool 2 is not defined"), std::string::npos);
}

TEST(Zones, AForbiddenAreaIsAFindingWithItsBlockInTheReport) {
  Job job = probingJob();
  const MemoryProgramSource memory(
      "part.nc", "G21 G90 G94 T1 M6\nG22 X100 Y100 Z500 I-100 J-100 K-500 P1\nG0 X50\nN40 G0 X150\nM30\n");
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  const Result<RunResult> result = runRecorded(job, {&source}, progress);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_TRUE(result->alarm);
  const auto kinds = [&](FindingKind kind) {
    return std::count_if(result->findings.begin(), result->findings.end(),
                         [&](const Finding& f) { return f.kind == kind; });
  };
  EXPECT_EQ(kinds(FindingKind::kAlarm), 1);
  ASSERT_EQ(kinds(FindingKind::kForbiddenZone), 1);
  const Result<Report> report = makeReport(job, *result, {&source});
  ASSERT_TRUE(report.ok());
  const std::string json = reportJson(*report);
  const auto at = json.find("forbidden_zone");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NE(json.find("\"block\": \"N40\"", at), std::string::npos) << json.substr(at, 600);
}

}  // namespace
}  // namespace proveout
