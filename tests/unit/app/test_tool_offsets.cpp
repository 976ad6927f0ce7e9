// What the operator entered for milling tools, held against the tools of the job.
#include <gtest/gtest.h>

#include "app/session/session.h"

namespace proveout {
namespace {

/// Two mills of 8 and 6 with their gauge lengths; the second one is compensated.
struct Milling {
  Milling() {
    job.name = "plate";
    job.control = "nct";
    job.stock = BoxShape{{0, 0, -20}, {40, 40, 0}};
    job.simulation.resolution_mm = 1.0;
    for (const auto& [number, diameter, gauge] : {std::tuple{1, 8.0, 100.0}, std::tuple{2, 6.0, 80.0}}) {
      Tool tool;
      tool.number = number;
      tool.diameter = diameter;
      tool.gauge_length = gauge;
      job.tools.push_back(tool);
      job.settings.length_offsets[number] = {gauge, 0.0};
    }
    job.settings.radius_offsets[2] = {3.0, 0.0};
  }

  /// Messages of kind tool_data.
  std::vector<Finding> told() const {
    const MemoryProgramSource memory("plate.nc",
                                     "G21 G90 G17 G54\nT1 M6\nG43 H1 Z50\nS2000 M3\nG0 X-10 Y5\nZ-1\nG1 X50 "
                                     "F500\nG0 Z50\nT2 M6\nG43 H2 Z50\nS2000 M3\n" +
                                         before_second + "G0 X-10 Y25\nZ-1\nG41 " + d +
                                         "G1 X0 Y20 F500\nX50\nG40 G0 Z50\nM30\n");
    const RecordingSource source(memory, TextEncoding::kAuto);
    Progress progress;
    const Result<RunResult> result = runRecorded(job, {&source}, progress);
    std::vector<Finding> found;
    if (!result) {
      ADD_FAILURE() << result.error().message;
      return found;
    }
    for (const Finding& finding : result->findings) {
      if (finding.kind == FindingKind::kToolData) found.push_back(finding);
    }
    return found;
  }
  Job job;
  std::string d = "D2 ";      ///< of the compensated block
  std::string before_second;  ///< blocks before the second cut
};

TEST(ToolOffsets, RightDataAreQuiet) { EXPECT_TRUE(Milling().told().empty()); }

TEST(ToolOffsets, TheLengthThatDiffersIsTold) {
  Milling milling;
  milling.job.settings.length_offsets[2].geometry = 79.5;
  const std::vector<Finding> told = milling.told();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].source->line, 14u);
  EXPECT_NEAR(*told[0].depth_mm, 0.5, 1e-9);
  EXPECT_NE(told[0].message.find("H2 is 79.5, its gauge length 80: all that it cuts is off by Z-0.5 mm"),
            std::string::npos)
      << told[0].message;
}

TEST(ToolOffsets, WhatAllHaveInCommonIsTheWorkOffsets) {
  Milling milling;
  for (auto& [row, value] : milling.job.settings.length_offsets) value.geometry -= 30.0;
  milling.job.settings.work_offsets[0].z() = 30.0;
  EXPECT_TRUE(milling.told().empty());
}

TEST(ToolOffsets, WearIsMeant) {
  Milling milling;
  milling.job.settings.length_offsets[2].wear = -0.1;
  milling.job.settings.radius_offsets[2].wear = -0.05;
  EXPECT_TRUE(milling.told().empty());
}

TEST(ToolOffsets, CorrectorsThatAreNoRadius) {
  Milling milling;
  milling.job.settings.radius_offsets[2].geometry = 6.0;
  ASSERT_EQ(milling.told().size(), 1u);
  EXPECT_NE(milling.told()[0].message.find("the diameter of the cutter"), std::string::npos);
  milling.job.settings.radius_offsets[2].geometry = 1.5;
  ASSERT_EQ(milling.told().size(), 1u);
  EXPECT_NE(milling.told()[0].message.find("1.5 mm too deep"), std::string::npos);
  for (const double meant : {0.0, 0.02, 3.2, 4.0}) {
    milling.job.settings.radius_offsets[2].geometry = meant;
    EXPECT_TRUE(milling.told().empty()) << meant;
  }
}

TEST(ToolOffsets, ARadiusThatNobodyHasEntered) {
  Milling milling;
  milling.job.settings.radius_offsets.clear();
  std::vector<Finding> told = milling.told();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].severity, Severity::kError);
  EXPECT_EQ(told[0].source->line, 14u);
  EXPECT_NEAR(*told[0].depth_mm, 3.0, 1e-9);
  EXPECT_NE(told[0].message.find("D2 has no value, 0 is taken: contours are cut 3 mm too deep"), std::string::npos)
      << told[0].message;
  EXPECT_NE(told[0].message.find("--offset D2=3"), std::string::npos) << told[0].message;
  milling.job.settings.radius_offsets[2] = {0.0, 0.0};
  EXPECT_TRUE(milling.told().empty()) << "the middle of the tool is programmed";
}

TEST(ToolOffsets, ARadiusThatTheProgramEnters) {
  Milling milling;
  milling.job.settings.radius_offsets.clear();
  for (const char* value : {"0", "3"}) {
    milling.before_second = std::string("G10 L12 P2 R") + value + "\n";
    EXPECT_TRUE(milling.told().empty()) << value;
  }
}

TEST(ToolOffsets, CompensationWithoutD) {
  Milling milling;
  for (const char* d : {"", "D0 "}) {
    milling.d = d;
    const std::vector<Finding> told = milling.told();
    ASSERT_EQ(told.size(), 1u) << d;
    EXPECT_EQ(told[0].severity, Severity::kError);
    EXPECT_NE(told[0].message.find("without a D, or with D0"), std::string::npos) << told[0].message;
  }
}

}  // namespace
}  // namespace proveout
