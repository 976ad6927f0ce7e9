#include "io/output_guard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "temp_folder.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;
using io_test::TempFolder;
using ::testing::HasSubstr;

class Guarded : public testing::Test {
 protected:
  Guarded() {
    folder.write("part.stl", "x");
    guard.protect("nominal", folder.path("part.stl"));
  }
  TempFolder folder;
  OutputGuard guard;
};

TEST_F(Guarded, NamesBothAndSaysWhatToDo) {
  const Status status = guard.check(folder.path("./part.stl"));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::kInput);
  EXPECT_THAT(status.error().message, HasSubstr(folder.path("./part.stl")));
  EXPECT_THAT(status.error().message, HasSubstr("the nominal, " + folder.path("part.stl")));
  EXPECT_THAT(status.error().message, HasSubstr("another folder or name"));
}

TEST_F(Guarded, KnowsLinksOfBothKinds) {
  fs::create_hard_link(folder.path("part.stl"), folder.path("hard"));
  fs::create_symlink("part.stl", folder.path("soft"));
  fs::create_symlink("soft", folder.path("softer"));
  for (const char* name : {"hard", "soft", "softer"})
    EXPECT_FALSE(guard.check(folder.path(name)).ok()) << name;
  EXPECT_TRUE(guard.check(folder.path("other")).ok());
}

TEST_F(Guarded, KnowsFoldersBehindLinksAndThoseThatAreNotThereYet) {
  fs::create_directory_symlink(folder.path(), folder.path("way"));
  for (const char* path :
       {"way/part.stl", "way/way/part.stl", "none/../part.stl", "way/none/deeper/../../part.stl"})
    EXPECT_FALSE(guard.check(folder.path(path)).ok()) << path;
  for (const char* path : {"none/part.stl", "way/none/part.stl", "part.stl.txt"})
    EXPECT_TRUE(guard.check(folder.path(path)).ok()) << path;
}

TEST_F(Guarded, KnowsNamesThatDifferInCaseOnly) { EXPECT_FALSE(guard.check(folder.path("Part.STL")).ok()); }

TEST_F(Guarded, InputsThatAreNotThereKeepTheirPlace) {
  guard.protect("subprogram", folder.path("O0007.nc"));
  EXPECT_FALSE(guard.check(folder.path("o0007.NC")).ok());
  EXPECT_TRUE(guard.check(folder.path("O0008.nc")).ok());
}

TEST_F(Guarded, RelativePathsAreThoseOfTheWorkingFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  EXPECT_FALSE(guard.check("part.stl").ok());
  EXPECT_FALSE(guard.check("./part.stl").ok());
  OutputGuard relative;
  relative.protect("nominal", "part.stl");
  EXPECT_FALSE(relative.check(folder.path("part.stl")).ok());
  fs::current_path(before);
}

}  // namespace
}  // namespace proveout
