#include "io/program_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temp_folder.h"

namespace proveout {
namespace {

using io_test::TempFolder;
using ::testing::HasSubstr;

SubprogramQuery byStem(const std::string& caller, std::vector<std::string> stems) {
  return {caller, std::move(stems), ""};
}

TEST(FileProgramSource, PassesBytesThrough) {
  const TempFolder folder;
  const std::string bytes = "O1(\xcf\xd2)\r\nM30\r\n\x00%";
  const FileProgramSource source(folder.write("main.nc", bytes));
  const auto main = source.mainProgram();
  ASSERT_TRUE(main.ok());
  EXPECT_EQ(main->bytes, bytes);
  EXPECT_EQ(main->name, "main.nc");
  EXPECT_EQ(main->path, folder.path("main.nc"));
}

TEST(FileProgramSource, FindsSubprogramsBesideTheCaller) {
  const TempFolder folder;
  const std::string main = folder.write("main.nc", "M98 P11");
  folder.write("O0011.nc", "beside");
  folder.write("O0011.txt", "other extension");
  folder.write("sub/O0011.nc", "not here");
  const FileProgramSource source(main);
  const auto found = source.subprogram(byStem(main, {"O0011", "O11"}));
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->bytes, "beside");
  EXPECT_EQ(found->name, "O0011.nc");
}

TEST(FileProgramSource, TakesStemsInOrderOfPreference) {
  const TempFolder folder;
  const std::string main = folder.write("main.nc", "");
  folder.write("O11.nc", "short");
  EXPECT_EQ(FileProgramSource(main).subprogram(byStem(main, {"O0011", "O11"}))->bytes, "short");
  folder.write("O0011.nc", "long");
  EXPECT_EQ(FileProgramSource(main).subprogram(byStem(main, {"O0011", "O11"}))->bytes, "long");
}

TEST(FileProgramSource, SearchesTheFoldersAndFilesOfTheJob) {
  const TempFolder folder;
  const std::string main = folder.write("main.nc", "");
  folder.write("a/O0100.txt", "from a");
  folder.write("b/O0100.nc", "from b");
  folder.write("b/0200", "no extension");
  const std::string single = folder.write("c/O0300.mpf", "single");
  const FileProgramSource source(main, {folder.path("a"), folder.path("b"), single});
  EXPECT_EQ(source.subprogram(byStem(main, {"O0100"}))->bytes, "from a");
  EXPECT_EQ(source.subprogram(byStem(main, {"O0200", "0200"}))->bytes, "no extension");
  EXPECT_EQ(source.subprogram(byStem(main, {"O0300"}))->bytes, "single");
  // A called program looks beside itself, with its own extension.
  folder.write("b/O0101.nc", "nested");
  EXPECT_EQ(source.subprogram(byStem(folder.path("b/O0100.nc"), {"O0101"}))->bytes, "nested");
}

TEST(FileProgramSource, FindsSystemProgramsInTheirFolders) {
  const TempFolder folder;
  const std::string main = folder.write("job/main.nc", "");
  folder.write("job/O9010.nct", "beside the main program");
  SubprogramQuery query = byStem(main, {"O9010"});
  query.system_channel = 1;
  EXPECT_FALSE(FileProgramSource(main).subprogram(query).ok());
  EXPECT_EQ(FileProgramSource(main, {folder.path("job")}).subprogram(query)->bytes,
            "beside the main program");
  folder.write("job/SystemMacros/Channel2/O9010.nct", "of another channel");
  EXPECT_FALSE(FileProgramSource(main).subprogram(query).ok());
  folder.write("SystemMacros/Channel1/O9010.nct", "above");
  EXPECT_EQ(FileProgramSource(main, {folder.path("job")}).subprogram(query)->bytes, "above");
  folder.write("job/SystemMacros/Channel1/o9010.NCT", "beside");
  EXPECT_EQ(FileProgramSource(main).subprogram(query)->bytes, "beside");
  query.system_channel = 0;
  query.caller = folder.path("job/x.nct");
  EXPECT_EQ(FileProgramSource(main).subprogram(query)->bytes, "beside the main program");
}

TEST(FileProgramSource, DoesNotCareForCaseButPrefersTheExactName) {
  const TempFolder folder;
  const std::string main = folder.write("MAIN.NC", "");
  folder.write("o0011.nc", "lower");
  EXPECT_EQ(FileProgramSource(main).subprogram(byStem(main, {"O0011"}))->bytes, "lower");
  folder.write("O0011.NC", "exact");
  EXPECT_EQ(FileProgramSource(main).subprogram(byStem(main, {"O0011"}))->bytes, "exact");
}

TEST(FileProgramSource, FindsProgramsByPath) {
  const TempFolder folder;
  const std::string main = folder.write("main.nc", "");
  folder.write("cycles/Drill.nc", "by path");
  folder.write("lib/bore.nc", "in a folder of the job");
  const FileProgramSource source(main, {folder.path("lib")});
  EXPECT_EQ(source.subprogram({main, {}, "cycles/drill.NC"})->bytes, "by path");
  EXPECT_EQ(source.subprogram({main, {}, "bore.nc"})->bytes, "in a folder of the job");
  EXPECT_FALSE(source.subprogram({main, {}, "cycles/"}).ok());
  EXPECT_FALSE(source.subprogram({main, {}, "nowhere/at/all.nc"}).ok());
}

// The manual's file names (14.4.2): folders above the caller's, names that are not in Latin letters.
TEST(FileProgramSource, FindsProgramsAboveTheCaller) {
  const TempFolder folder;
  const std::string main = folder.write("a/b/c/main.nc", "");
  folder.write("папка1/папка2/папка3/файл.txt", "above");
  folder.write("a/b/c/подпрограммы/подпрограмма.prg", "below");
  const FileProgramSource source(main);
  EXPECT_EQ(source.subprogram({main, {}, "../../../папка1/папка2/папка3/файл.txt"})->bytes, "above");
  EXPECT_EQ(source.subprogram({main, {}, "подпрограммы/подпрограмма.prg"})->bytes, "below");
}

TEST(FileProgramSource, SaysWhatWasLookedForAndWhere) {
  const TempFolder folder;
  const std::string main = folder.write("main.nc", "");
  std::filesystem::create_directories(folder.path("subs"));
  const auto missing =
      FileProgramSource(main, {folder.path("subs")}).subprogram(byStem(main, {"O0099", "O99"}));
  ASSERT_FALSE(missing.ok());
  EXPECT_THAT(missing.error().message, HasSubstr("O0099.nc"));
  EXPECT_THAT(missing.error().message, HasSubstr(folder.path("subs")));
}

TEST(FileProgramSource, RefusesWhatIsNoProgramFile) {
  const TempFolder folder;
  EXPECT_THAT(FileProgramSource(folder.path("none.nc")).mainProgram().error().message,
              HasSubstr("no such file"));
  EXPECT_THAT(FileProgramSource(folder.path()).mainProgram().error().message, HasSubstr("is a folder"));
  EXPECT_FALSE(FileProgramSource("/dev/zero").mainProgram().ok());
  // A folder with the name of a subprogram, and a name that leads elsewhere, are no programs.
  const std::string main = folder.write("p/main.nc", "");
  std::filesystem::create_directories(folder.path("p/O0001.nc"));
  folder.write("secret.nc", "x");
  EXPECT_FALSE(FileProgramSource(main).subprogram(byStem(main, {"O0001"})).ok());
  EXPECT_FALSE(FileProgramSource(main).subprogram(byStem(main, {"../secret"})).ok());
  EXPECT_FALSE(FileProgramSource(main).subprogram(byStem(main, {""})).ok());
}

}  // namespace
}  // namespace proveout
