#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/atomic_file.h"
#include "temp_folder.h"

namespace proveout {
namespace {

using io_test::readBytes;
using io_test::TempFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(AtomicFile, AppearsOnCommitOnly) {
  const TempFolder folder;
  auto file = AtomicFile::create(folder.path("part.stl"));
  ASSERT_TRUE(file.ok());
  file->write("abc");
  EXPECT_FALSE(std::filesystem::exists(folder.path("part.stl")));
  ASSERT_TRUE(file->commit().ok());
  EXPECT_EQ(readBytes(folder.path("part.stl")), "abc");
  EXPECT_THAT(folder.names(), ElementsAre("part.stl"));
}

TEST(AtomicFile, LeavesTheEarlierFileAloneWithoutCommit) {
  const TempFolder folder;
  folder.write("report.json", "earlier");
  {
    auto file = AtomicFile::create(folder.path("report.json"));
    ASSERT_TRUE(file.ok());
    file->write("half of");
  }
  EXPECT_EQ(readBytes(folder.path("report.json")), "earlier");
  EXPECT_THAT(folder.names(), ElementsAre("report.json"));
}

TEST(AtomicFile, MovedFromFileOwnsNothing) {
  const TempFolder folder;
  auto first = AtomicFile::create(folder.path("a"));
  ASSERT_TRUE(first.ok());
  AtomicFile second = std::move(*first);
  second.write("x");
  EXPECT_TRUE(second.commit().ok());
  EXPECT_FALSE(first->commit().ok());
  EXPECT_EQ(readBytes(folder.path("a")), "x");
}

TEST(AtomicFile, FollowsALinkAndKeepsIt) {
  const TempFolder folder;
  folder.write("real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder.path("link.txt"));
  ASSERT_TRUE(writeFileAtomically(folder.path("link.txt"), "new").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.txt")));
  EXPECT_EQ(readBytes(folder.path("real.txt")), "new");
}

TEST(AtomicFile, ReportsAFullDisk) {
  // /dev/full takes no byte: what stdio still holds fails on close at the latest.
  const Status small = writeFileAtomically("/dev/full", "x");
  ASSERT_FALSE(small.ok());
  EXPECT_THAT(small.error().message, HasSubstr("/dev/full: cannot be written: No space left on device"));
  const Status large = writeFileAtomically("/dev/full", std::string(1 << 20, 'x'));
  ASSERT_FALSE(large.ok());
  EXPECT_THAT(large.error().message, HasSubstr("No space left on device"));
}

TEST(AtomicFile, ReportsFoldersThatCannotTakeIt) {
  const TempFolder folder;
  const std::string file = folder.write("file", "x");
  EXPECT_THAT(writeFileAtomically(file + "/below", "x").error().message, HasSubstr("Not a directory"));
  EXPECT_THAT(writeFileAtomically(folder.path("missing/a"), "x").error().message, HasSubstr("No such file"));
  EXPECT_THAT(writeFileAtomically(folder.path(), "x").error().message, HasSubstr("is a folder"));
  // /proc refuses new files even for root.
  EXPECT_FALSE(writeFileAtomically("/proc/proveout-test", "x").ok());
  EXPECT_FALSE(writeFileAtomically("", "x").ok());
  EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST(ReadWholeFile, ReadsBytes) {
  const TempFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  EXPECT_EQ(*readWholeFile(folder.write("f", bytes), 100), bytes);
  EXPECT_EQ(*readWholeFile(folder.write("empty", ""), 100), "");
  EXPECT_EQ(*readWholeFile(folder.path("f"), 6), bytes);
}

TEST(ReadWholeFile, RefusesWhatIsNoFile) {
  const TempFolder folder;
  EXPECT_THAT(readWholeFile(folder.path("none"), 10).error().message, HasSubstr("there is no such file"));
  EXPECT_THAT(readWholeFile(folder.path(), 10).error().message, HasSubstr("is a folder"));
  // A device or pipe would be read for ever.
  EXPECT_THAT(readWholeFile("/dev/zero", 10).error().message, HasSubstr("not a regular file"));
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_THAT(readWholeFile(folder.path("pipe"), 10).error().message, HasSubstr("not a regular file"));
  EXPECT_THAT(readWholeFile(folder.write("long", "12345"), 4).error().message,
              HasSubstr("larger than 4 bytes"));
  // Opens, but reading fails with EIO: address 0 of the own process is not mapped.
  EXPECT_FALSE(readWholeFile("/proc/self/mem", 1000).ok());
}

TEST(MakeFolders, MakesAllOfThem) {
  const TempFolder folder;
  EXPECT_TRUE(makeFolders(folder.path("a/b/c")).ok());
  EXPECT_TRUE(makeFolders(folder.path("a/b/c")).ok());
  EXPECT_TRUE(std::filesystem::is_directory(folder.path("a/b/c")));
  folder.write("file", "x");
  EXPECT_FALSE(makeFolders(folder.path("file")).ok());
  EXPECT_FALSE(makeFolders(folder.path("file/below")).ok());
  EXPECT_FALSE(makeFolders("/proc/proveout-test").ok());
}

}  // namespace
}  // namespace proveout
