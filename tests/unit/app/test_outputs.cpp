#include <gtest/gtest.h>

#include "app/outputs.h"
#include "temporary_folder.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(StagingFolder, NothingAppearsBeforeCommit) {
  const test::TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    Result<StagingFolder> staging = StagingFolder::create(folder.path());
    ASSERT_TRUE(staging.ok());
    std::ofstream(staging->path("a.txt")) << "new";
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
    std::ofstream(staging->path("a.txt")) << "new";
    std::ofstream(staging->path("b.txt")) << "new";
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
    EXPECT_TRUE(writeProgramFiles(files, "", *staging).ok());
    EXPECT_TRUE(writeProgramFiles(files, "second side", *staging).ok());
    EXPECT_FALSE(fs::exists(folder.path("files")));
    EXPECT_TRUE(staging->commit().ok());
  }
  EXPECT_EQ(fs::file_size(folder.path("files/a.txt")), 3u);
  EXPECT_EQ(fs::file_size(folder.path("files/sub/b.bin")), 2u);
  EXPECT_EQ(entries(folder.path()), 1u);
  EXPECT_EQ(entries(folder.path("files")), 3u);
}

TEST(StagingFolder, AFileInTheWayIsAnError) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "x");
  EXPECT_FALSE(StagingFolder::create(file).ok());
  EXPECT_FALSE(StagingFolder::create(file + "/below").ok());
  EXPECT_FALSE(StagingFolder::create("/proc/nowhere").ok());
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
    EXPECT_TRUE(writeProfileChart(machined, &nominal, {"bar"}, *staging, report).ok());
    EXPECT_TRUE(writeReport({}, *staging, report).ok());
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
  EXPECT_TRUE(writeProfileChart({}, nullptr, {"bar"}, *staging, report).ok());
  EXPECT_TRUE(report.outputs.tables.empty());
  EXPECT_TRUE(report.profile_svg.empty());
}

}  // namespace
}  // namespace proveout
