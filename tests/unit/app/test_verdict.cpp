// What a run says of right and wrong parts: grid, bounds, crests, causes.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>

#include "app/session/session.h"
#include "io/mesh_io.h"
#include "tests/support/lofts.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using lofts::Profile;

class Verdict : public testing::Test {
 protected:
  Verdict() {
    std::string pattern = (std::filesystem::temp_directory_path() / "proveout-verdict-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
    job_.name = "plate";
    job_.control = "nct";
    job_.stock = BoxShape{{0, 0, -10}, {40, 30, 0}};
    addTool(1, ToolType::kFlat, 6);
    addTool(2, ToolType::kBall, 6);
    Tool& cone = addTool(3, ToolType::kCone, 10);
    cone.cone_angle_deg = 90;
  }
  ~Verdict() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  Tool& addTool(int number, ToolType type, double diameter) {
    Tool tool;
    tool.number = number;
    tool.type = type;
    tool.diameter = diameter;
    job_.tools.push_back(tool);
    return job_.tools.back();
  }

  Result<RunResult> run(const std::string& program, const TriMesh& nominal, double tolerance) {
    NominalSpec spec;
    spec.mesh.path = folder_ + "/nominal.stl";
    spec.gouge_mm = spec.excess_mm = tolerance;
    EXPECT_TRUE(writeMesh(nominal, spec.mesh.path, MeshFormat::kStlBinary).ok());
    job_.nominal = spec;
    const MemoryProgramSource memory("p.nc", program);
    const RecordingSource source(memory, TextEncoding::kAuto);
    Progress progress;
    return runRecorded(job_, {&source}, progress);
  }

  static std::vector<Finding> of(const RunResult& run, FindingKind kind) {
    std::vector<Finding> out;
    for (const Finding& f : run.findings) {
      if (f.kind == kind) out.push_back(f);
    }
    return out;
  }

  static bool passes(const RunResult& run) {
    return std::none_of(run.findings.begin(), run.findings.end(), [](const Finding& f) {
      return f.severity == Severity::kError || f.kind == FindingKind::kUndecided;
    });
  }

  static constexpr const char* kStart = "G21 G90 G17 T1 M6\nS3000 M3\nG0 X10 Y15 Z5\n";
  const TriMesh plate_ = shapes::box({0, 0, -10}, {40, 30, 0});
  std::string folder_;
  Job job_;
};

/// A slot of the flat 6 from X10 to X30, a countersink with a sharp tip at X20 Y5.
const std::vector<lofts::Hole> kSlotAndSink = {{Profile().line(3, -4).line(3, 2), {20, 15}, {10, 0}},
                                               {Profile().line(0, -3).line(5, 2), {20, 5}, {0, 0}}};
std::string slotAndSink(double z) {
  char text[200];
  std::snprintf(text, sizeof text,
                "G1 Z%.5f F300\nX30\nG0 Z5\nT3 M6\nS3000 M3\nG0 X20 Y5\nG1 Z-3 F200\nG0 Z5\nM30\n", z);
  return text;
}

TEST_F(Verdict, ARightPartPassesOnTheGridThatTheRunChooses) {
  const TriMesh nominal = lofts::plateWith(plate_, kSlotAndSink, 0.002);
  const Result<RunResult> right = run(kStart + slotAndSink(-4), nominal, 0.05);
  ASSERT_TRUE(right.ok()) << right.error().message;
  EXPECT_TRUE(passes(*right));
  EXPECT_GT(right->resolution_mm, 0.0);
  job_.nominal.reset();
}

TEST_F(Verdict, AFlatFloorIsDecidedHoweverRoundItsWallsAre) {
  job_.simulation.resolution_mm = 0.5;  // walls are off by 0.01 mm
  const TriMesh nominal = lofts::plateWith(plate_, kSlotAndSink, 0.002);
  for (const double off : {0.0497, 0.0503}) {
    for (const double sign : {1.0, -1.0}) {
      const Result<RunResult> result = run(kStart + slotAndSink(-4 + sign * off), nominal, 0.05);
      ASSERT_TRUE(result.ok());
      EXPECT_TRUE(of(*result, FindingKind::kUndecided).empty()) << off;
      const auto found = of(*result, sign > 0 ? FindingKind::kExcess : FindingKind::kGouge);
      ASSERT_EQ(found.size(), off > 0.05 ? 1u : 0u) << off;
      if (found.empty()) continue;
      EXPECT_NEAR(*found[0].depth_mm, off, 1e-5);
      EXPECT_EQ(found[0].source->line, 5u);
    }
  }
}

TEST_F(Verdict, CrestsBetweenPassesAreOneFindingAndNoThinFeature) {
  job_.simulation.resolution_mm = 0.4;
  std::string program = "G21 G90 G17 T2 M6\nS3000 M3\nG0 X-5 Y-4 Z5\nG1 Z-3 F500\n";
  const double step = 1.5;
  for (int i = 0; i <= 26; ++i) {
    program += "G1 Y" + std::to_string(-4 + step * i) + "\nX" + (i % 2 == 0 ? "45" : "-5") + "\n";
  }
  const double height = 3 - std::sqrt(9 - step * step / 4);
  const Result<RunResult> result =
      run(program + "G0 Z5\nM30\n", shapes::box({0, 0, -10}, {40, 30, -3}), 0.05);
  ASSERT_TRUE(result.ok());
  const auto crests = of(*result, FindingKind::kExcess);
  ASSERT_EQ(crests.size(), 1u);
  EXPECT_GT(crests[0].spots, 10u);
  EXPECT_NEAR(*crests[0].depth_mm, height, *crests[0].bound_mm + 1e-4);
  EXPECT_TRUE(of(*result, FindingKind::kThinFeature).empty());
  EXPECT_TRUE(of(*result, FindingKind::kGouge).empty());
}

TEST_F(Verdict, TheWordIsNamedThatSetTheModalDepth) {
  job_.simulation.resolution_mm = 0.5;
  // A round pocket whose arc has no Z: the depth was set three lines before.
  const TriMesh nominal =
      lofts::plateWith(plate_, {{Profile().line(6, -3).line(6, 2), {15, 15}, {0, 0}}}, 0.002);
  const Result<RunResult> result =
      run("G21 G90 G17 T1 M6\nS3000 M3\nG0 X15 Y15 Z5\nG1 Z-3.3 F300\nX18\nG3 I-3 J0\nG1 X15\nG0 Z5\nM30\n",
          nominal, 0.05);
  ASSERT_TRUE(result.ok());
  const auto found = of(*result, FindingKind::kGouge);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_FALSE(found[0].blocks.empty());
  EXPECT_EQ(found[0].blocks[0].block.line, 6u);
  ASSERT_FALSE(found[0].causes.empty());
  EXPECT_EQ(found[0].causes[0].value, "Z-3.3");
  EXPECT_EQ(found[0].causes[0].source->line, 4u);
  EXPECT_EQ(found[0].causes[0].along, "Z");
  EXPECT_NEAR(*found[0].causes[0].off_mm, -0.3, 0.01);
}

TEST_F(Verdict, TheRadiusOfTheOperatorIsNamed) {
  job_.simulation.resolution_mm = 0.5;
  const TriMesh nominal = lofts::plateWith(plate_, kSlotAndSink, 0.002);
  job_.tools[0].diameter = 6.4;
  const Result<RunResult> result = run(kStart + slotAndSink(-4), nominal, 0.05);
  ASSERT_TRUE(result.ok());
  const auto found = of(*result, FindingKind::kGouge);
  ASSERT_EQ(found.size(), 1u);
  const auto named = [](const Cause& c) { return c.what == "tools.1.diameter"; };
  EXPECT_TRUE(std::any_of(found[0].causes.begin(), found[0].causes.end(), named));
}

TEST_F(Verdict, WhatWasNotCutIsToldSo) {
  job_.simulation.resolution_mm = 0.5;
  std::vector<lofts::Hole> holes = kSlotAndSink;
  holes.push_back({Profile().line(2, -12).line(2, 2), {35, 25}, {0, 0}});
  const Result<RunResult> result =
      run(kStart + slotAndSink(-4), lofts::plateWith(plate_, holes, 0.002), 0.05);
  ASSERT_TRUE(result.ok());
  const auto found = of(*result, FindingKind::kExcess);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_FALSE(found[0].causes.empty());
  EXPECT_EQ(found[0].causes[0].what, "no motion cuts here");
  EXPECT_NEAR(*found[0].volume_mm3, kPi * 4 * 10, 0.01 * kPi * 4 * 10);
}

TEST_F(Verdict, ADeviationOnAStockFromAFileIsBlamedToo) {
  // Its faces are not known: there is no exact part to ask.
  job_.simulation.resolution_mm = 0.5;
  const TriMesh nominal = lofts::plateWith(plate_, kSlotAndSink, 0.002);
  const Result<RunResult> first = run(kStart + slotAndSink(-4), nominal, 0.05);
  ASSERT_TRUE(first.ok());
  const std::string saved = folder_ + "/stock.vdb";
  ASSERT_TRUE(first->stock->save(saved).ok());
  job_.stock = SavedStock{saved};
  job_.simulation.resolution_mm.reset();  // it has its own
  const Result<RunResult> again =
      run(kStart + std::string("G1 Z-4.5 F300\nX30\nG0 Z5\nM30\n"), nominal, 0.05);
  ASSERT_TRUE(again.ok()) << again.error().message;
  const auto found = of(*again, FindingKind::kGouge);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(*found[0].depth_mm, 0.5, *found[0].bound_mm);
  EXPECT_EQ(found[0].source->line, 5u);
  ASSERT_FALSE(found[0].causes.empty());
  EXPECT_EQ(found[0].causes[0].value, "Z-4.5");
}

TEST_F(Verdict, ACoarseNominalIsToldAndFailsNothing) {
  job_.simulation.resolution_mm = 0.5;
  const Result<RunResult> result =
      run(kStart + slotAndSink(-4), lofts::plateWith(plate_, kSlotAndSink, 0.05), 0.02);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(passes(*result));
  const auto coarse = of(*result, FindingKind::kCoarseNominal);
  ASSERT_EQ(coarse.size(), 1u);
  EXPECT_EQ(coarse[0].severity, Severity::kWarning);
}

}  // namespace
}  // namespace proveout
