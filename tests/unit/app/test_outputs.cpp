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

}  // namespace
}  // namespace proveout
