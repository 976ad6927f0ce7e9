#include <gtest/gtest.h>

#include "app/freed_pieces.h"
#include "app/outputs.h"
#include "core/mesh/shells.h"
#include "tests/support/temporary_folder.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

Status writeNew(const std::string& path) {
  std::ofstream(path) << "new";
  return Done{};
}

TEST(StagingFolder, NothingAppearsBeforeCommit) {
  const test::TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path());
    ASSERT_TRUE(staging.ok());
    EXPECT_TRUE(staging->write("a.txt", writeNew).ok());
    EXPECT_EQ(fs::file_size(folder.path("a.txt")), 3u);
    std::string text;
    std::ifstream(folder.path("a.txt")) >> text;
    EXPECT_EQ(text, "old");
  }
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(StagingFolder, CommitMovesAllAndCleansUp) {
  const test::TemporaryFolder folder;
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path("deep/er"));
    ASSERT_TRUE(staging.ok());
    EXPECT_TRUE(staging->write("a.txt", writeNew).ok());
    EXPECT_TRUE(staging->write("b.txt", writeNew).ok());
    EXPECT_TRUE(staging->commit().ok());
  }
  EXPECT_EQ(entries(folder.path("deep/er")), 2u);
}

TEST(StagingFolder, FilesOfProgramsComeWithTheirFolders) {
  const test::TemporaryFolder folder;
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path());
    ASSERT_TRUE(staging.ok());
    const std::map<std::string, std::string> files{{"a.txt", "one"}, {"sub/b.bin", std::string("\0\x1", 2)}};
    OutputFailures failures;
    writeProgramFiles(files, "", *staging, failures);
    writeProgramFiles(files, "second side", *staging, failures);
    EXPECT_TRUE(failures.empty());
    EXPECT_FALSE(fs::exists(folder.path("files")));
    EXPECT_TRUE(staging->commit().ok());
  }
  EXPECT_EQ(fs::file_size(folder.path("files/a.txt")), 3u);
  EXPECT_EQ(fs::file_size(folder.path("files/sub/b.bin")), 2u);
  EXPECT_EQ(entries(folder.path()), 1u);
  EXPECT_EQ(entries(folder.path("files")), 3u);
}

TEST(StagingFolder, WhatKilledRunsLeftIsRemovedAndWhatLivesIsNot) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path(".proveout-run-abcdef/files"));
  fs::create_directories(folder.path(".proveout-of-another-kind"));
  Result<StagingFolder> first = StagingFolder::create(folder.path());
  ASSERT_TRUE(first.ok());
  EXPECT_FALSE(fs::exists(folder.path(".proveout-run-abcdef")));
  EXPECT_TRUE(first->write("a.txt", writeNew).ok());
  {
    Result<StagingFolder> second = StagingFolder::create(folder.path());
    ASSERT_TRUE(second.ok());
    EXPECT_EQ(entries(folder.path()), 3u);
  }
  EXPECT_TRUE(first->commit().ok());
  EXPECT_TRUE(fs::exists(folder.path("a.txt")));
  EXPECT_TRUE(fs::exists(folder.path(".proveout-of-another-kind")));
}

TEST(StagingFolder, AnEarlierFileDoesNotStandForOneThatCouldNotBeMade) {
  const test::TemporaryFolder folder;
  folder.write("mesh.stl", "old");
  folder.write("report.json", "old");
  const auto fails = [](const std::string&) { return Status(inputError("no room")); };
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path());
    ASSERT_TRUE(staging.ok());
    EXPECT_FALSE(staging->write("mesh.stl", fails).ok());
    EXPECT_TRUE(staging->write("report.json", writeNew).ok());
    EXPECT_EQ(entries(folder.path()), 3u);
    EXPECT_TRUE(staging->commit().ok());
  }
  EXPECT_FALSE(fs::exists(folder.path("mesh.stl")));
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(StagingFolder, WithoutItsReportNothingIsMoved) {
  const test::TemporaryFolder folder;
  folder.write("mesh.stl", "old");
  folder.write("report.json", "old");
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path());
    ASSERT_TRUE(staging.ok());
    EXPECT_TRUE(staging
                    ->write("mesh.stl",
                            [](const std::string& path) {
                              std::ofstream(path) << "of the new run";
                              return Status(Done{});
                            })
                    .ok());
    EXPECT_FALSE(
        staging->write("report.json", [](const std::string&) { return Status(inputError("no room")); }).ok());
    EXPECT_FALSE(staging->commit().ok());
  }
  EXPECT_EQ(fs::file_size(folder.path("mesh.stl")), 3u);
  EXPECT_EQ(entries(folder.path()), 2u);
}

TEST(StagingFolder, IsAskedOfItsGuardAndOfItsProgress) {
  const test::TemporaryFolder folder;
  const std::string input = folder.write("part.stl", "input");
  OutputGuard guard;
  guard.protect("nominal", input);
  Progress progress;
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path(), &guard, &progress);
    ASSERT_TRUE(staging.ok());
    EXPECT_FALSE(staging->write("part.stl", writeNew).ok());
    EXPECT_TRUE(staging->write("b.txt", writeNew).ok());
    progress.cancel();
    EXPECT_EQ(staging->write("c.txt", writeNew).error().kind, ErrorKind::kInterrupted);
    EXPECT_EQ(staging->commit().error().kind, ErrorKind::kInterrupted);
  }
  EXPECT_EQ(fs::file_size(folder.path("part.stl")), 5u);
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(StagingFolder, AFileInTheWayIsAnError) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "x");
  EXPECT_FALSE(StagingFolder::create(file).ok());
  EXPECT_FALSE(StagingFolder::create(file + "/below").ok());
  EXPECT_FALSE(StagingFolder::create("/proc/nowhere").ok());
}

TEST(StagingFolder, FoldersThatStayEmptyGo) {
  const test::TemporaryFolder folder;
  { EXPECT_TRUE(StagingFolder::create(folder.path("deep/er")).ok()); }
  EXPECT_EQ(entries(folder.path()), 0u);
}

TEST(StagingFolder, AFileThatFailsIsLeftOut) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path("taken.txt/below"));
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path());
    ASSERT_TRUE(staging.ok());
    EXPECT_TRUE(staging->write("a.txt", writeNew).ok());
    const Status taken = staging->write("taken.txt", writeNew);
    ASSERT_FALSE(taken.ok());
    EXPECT_NE(taken.error().message.find(folder.path("taken.txt")), std::string::npos);
    const Status failed = staging->write("b.txt", [](const std::string& path) -> Status {
      std::ofstream(path) << "half";
      return Error{ErrorKind::kResourceLimit, path + ": full"};
    });
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().kind, ErrorKind::kResourceLimit);
    EXPECT_EQ(failed.error().message, folder.path("b.txt") + ": full");  // not the file aside
    EXPECT_TRUE(staging->commit().ok());
  }
  EXPECT_TRUE(fs::exists(folder.path("a.txt")));
  EXPECT_FALSE(fs::exists(folder.path("b.txt")));
  EXPECT_TRUE(fs::is_directory(folder.path("taken.txt")));
}

TEST(Outputs, WhatIsMissingDecidesTheExitCode) {
  Report report;
  report.verdict = Verdict::kPass;
  EXPECT_EQ(exitCodeOf(report, {}), 0);
  EXPECT_EQ(exitCodeOf(report, {inputError("x")}), 2);
  EXPECT_EQ(exitCodeOf(report, {inputError("x"), {ErrorKind::kResourceLimit, "full"}}), 3);
  report.verdict = Verdict::kFail;
  EXPECT_EQ(exitCodeOf(report, {}), 1);
  EXPECT_EQ(exitCodeOf(report, {inputError("x")}), 2);
}

/// Closed square bar along Z, half width 10, length 30; its half section is a rectangle.
TriMesh barMesh() {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({(i & 1) ? 10.0F : -10.0F, (i & 2) ? 10.0F : -10.0F, (i & 4) ? 30.0F : 0.0F});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TEST(ProfileChartFile, IsWrittenRecordedAndShown) {
  const test::TemporaryFolder folder;
  Report report;
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path());
    ASSERT_TRUE(staging.ok());
    const std::vector<std::vector<Vec2>> machined{{{0, 0}, {9.9, 0}, {9.9, 30}, {0, 30}}};
    const TriMesh nominal = barMesh();
    OutputFailures failures;
    writeProfileChart(machined, &nominal, {"bar"}, *staging, report, failures);
    writeReport({}, *staging, report, failures);
    EXPECT_TRUE(failures.empty());
    EXPECT_TRUE(staging->commit().ok());
  }
  ASSERT_EQ(report.outputs.tables, std::vector<std::string>{"profile.svg"});
  const auto text = [&](const char* name) {
    std::ifstream file(folder.path(name));
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_NE(text("profile.svg").find("largest gouge 0.1000 mm"), std::string::npos);
  EXPECT_NE(text("report.html").find("largest gouge 0.1000 mm"), std::string::npos);
  EXPECT_NE(text("report.json").find("profile.svg"), std::string::npos);
}

TEST(ProfileChartFile, IsLeftOutWhereThereIsNoMaterial) {
  const test::TemporaryFolder folder;
  Report report;
  Result<StagingFolder> staging = StagingFolder::create(folder.path());
  ASSERT_TRUE(staging.ok());
  OutputFailures failures;
  writeProfileChart({}, nullptr, {"bar"}, *staging, report, failures);
  EXPECT_TRUE(failures.empty());
  EXPECT_TRUE(report.outputs.tables.empty());
  EXPECT_TRUE(report.profile_svg.empty());
}

/// Two triangles over a square are enough of a piece.
TriMesh sheet(float low, float high) {
  TriMesh mesh;
  mesh.positions = {{0, 0, low}, {1, 0, low}, {0, 1, high}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(TakenApart, ShowsAPieceWhereItLeaves) {
  const TriMesh part = sheet(-10, -9), piece = sheet(0, 1);
  const auto highest = [&](const std::string& leaves) {
    const std::vector<StockBody> bodies = {{2.0, {}, "part", ""}, {1.0, {}, "slug", leaves}};
    return meshBounds(takenApart(part, {piece}, bodies)).max.z();
  };
  EXPECT_NEAR(highest("up"), 2.3, 1e-6);
  EXPECT_NEAR(highest("down"), -0.3, 1e-6);
  EXPECT_NEAR(highest("both"), 2.3, 1e-6) << "no larger than the part";
  EXPECT_NEAR(highest("none"), 2.3, 1e-6);
}

}  // namespace
}  // namespace proveout
