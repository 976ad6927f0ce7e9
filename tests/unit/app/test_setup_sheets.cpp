// What a setup sheet says: blank, fixtures, zero points, tools with the offsets that the program called.
#include <gtest/gtest.h>

#include "app/page/setup_sheets.h"
#include "app/page/shape_mesh.h"
#include "tests/unit/app/block_job.h"
#include "tests/unit/app/memory_run.h"

namespace proveout {
namespace {

const std::string kTwoTools =
    "G21 G17 G90 G40 G49 G80 G94\nT1 M6\nS4000 M3\nG54 G0 X15 Y-10\nG43 H1 Z5\nG1 Z-4 F300\nG41 D1 X20\nY50\n"
    "G40 X0\nG0 Z50\nT2 M6\nG55 G0 X0 Y0\nG43 H2 Z5\nG1 Z-1 F100\nG0 Z50\nM5\nM30\n";

Job sheetJob() {
  Job job = app_test::blockJob("block", {60, 40, 10},
                               {app_test::toolOf(1, 10), app_test::toolOf(2, 6, ToolType::kDrill)});
  job.tools[0].overall_length = 62.5;
  job.settings.placement.origin = Vec3(100, 50, 0);
  job.settings.work_offsets[0] = Vec3(100, 50, 0);
  job.settings.work_offsets[1] = Vec3(130, 70, 0);
  job.settings.work_given = {true, true};
  job.settings.length_offsets = {{1, {0.0, 0.0}}, {2, {0.0, 0.0}}};
  job.settings.radius_offsets = {{1, {4.9, 0.1}}};
  job.fixtures.push_back({"clamp", BoxShape{{-20, 10, -10}, {-5, 30, 5}}});
  job.output.views = {"iso"};
  return job;
}

TEST(SetupSheets, TellWhatIsClampedAndHow) {
  const Job job = sheetJob();
  const Result<RunResult> run = app_test::run(job, {kTwoTools});
  ASSERT_TRUE(run.ok()) << run.error().message;
  Progress progress;
  const std::vector<SetupSheet> sheets = setupSheets(job, *run, progress);
  ASSERT_EQ(sheets.size(), 1u);
  const SetupSheet& sheet = sheets[0];
  EXPECT_EQ(sheet.program, "part.nc");
  const auto lineOf = [&](const std::string& label) {
    for (const SheetLine& line : sheet.lines)
      if (line.label == label) return line.text;
    return std::string();
  };
  EXPECT_EQ(lineOf("Blank"), "box 60 x 40 x 10 mm, X0.000..60.000 Y0.000..40.000 Z-10.000..0.000");
  EXPECT_NE(lineOf("Fixture clamp").find("box 15 x 20 x 15 mm"), std::string::npos);
  EXPECT_EQ(lineOf("G54"), "X100.000 Y50.000 Z0.000 in the machine");
  EXPECT_EQ(lineOf("G55"), "X130.000 Y70.000 Z0.000 in the machine");
  ASSERT_EQ(sheet.tools.size(), 2u);
  EXPECT_EQ(sheet.tools[0].number, 1);
  EXPECT_EQ(sheet.tools[0].stick_out, 62.5);
  EXPECT_EQ(sheet.tools[0].length_offset, "H1 = 0.000");
  EXPECT_EQ(sheet.tools[0].radius_offset, "D1 = 5.000");
  EXPECT_EQ(sheet.tools[1].length_offset, "H2 = 0.000");
  EXPECT_EQ(sheet.tools[1].radius_offset, "");
  EXPECT_FALSE(sheet.tools[1].stick_out);
  EXPECT_EQ(sheet.before.substr(1, 3), "PNG");
  EXPECT_TRUE(sheet.after.empty()) << "the page begins with that picture";
}

TEST(SetupSheets, WithoutPicturesHaveNone) {
  Job job = sheetJob();
  job.output.views.clear();
  const Result<RunResult> run = app_test::run(job, {kTwoTools});
  ASSERT_TRUE(run.ok());
  Progress progress;
  EXPECT_TRUE(setupSheets(job, *run, progress).at(0).before.empty());
}

TEST(ShapeMeshes, AreClosedAndOfTheRightVolume) {
  const auto check = [](const StockShape& shape, double volume, double within) {
    const std::optional<TriMesh> mesh = meshOfShape(shape);
    ASSERT_TRUE(mesh);
    const TriMesh welded = weldVertices(*mesh);
    EXPECT_TRUE(analyseTopology(welded).closedManifold());
    EXPECT_NEAR(meshVolume(welded), volume, within * volume);
  };
  check(BoxShape{{1, 2, 3}, {4, 6, 8}}, 60.0, 1e-6);
  check(CylinderShape{2, {1, 2, 3}, 5.0, 0.0, 10.0}, kPi * 250.0, 2e-3);
  check(CylinderShape{0, {1, 2, 3}, 5.0, 2.0, 10.0}, kPi * 210.0, 2e-3);
  EXPECT_FALSE(meshOfShape(SavedStock{"a.vdb"}));
}

}  // namespace
}  // namespace proveout
