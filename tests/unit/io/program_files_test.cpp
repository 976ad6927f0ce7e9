#include "io/program_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

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

// The manual's file names (14.4.2): folders above the caller's, where the job names one that holds them, and
// names that are not in Latin letters.
TEST(FileProgramSource, FindsProgramsAboveTheCaller) {
  const TempFolder folder;
  const std::string main = folder.write("a/b/c/main.nc", "");
  folder.write("папка1/папка2/папка3/файл.txt", "above");
  folder.write("a/b/c/подпрограммы/подпрограмма.prg", "below");
  const FileProgramSource source(main, {folder.path()});
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

/// A secret outside of the folder of the program, and what is said of a program that names it.
class Reach : public testing::Test {
 protected:
  Reach() {
    folder.write("secret/O0011.nc", "SECRET");
    folder.write("secret/81.nc", "SECRET");
    main = folder.write("job/main.nc", "");
    folder.write("job/lib/part.nc", "inside");
  }
  std::string answer(const FileProgramSource& source, const SubprogramQuery& query) const {
    const auto text = source.subprogram(query);
    return text ? text->bytes : text.error().message;
  }
  std::string named(const std::string& path, std::vector<std::string> places = {}) const {
    return answer(FileProgramSource(main, std::move(places)), {main, {}, path});
  }
  void link(const std::string& target, const std::string& name) const {
    std::filesystem::create_symlink(target, folder.path(name));
  }
  const TempFolder folder;
  std::string main;
};

TEST_F(Reach, NamesStayInTheFolderOfTheProgram) {
  for (const char* path : {"../secret/O0011.nc", "lib/../../secret/O0011.nc", "none/../../secret/O0011.nc",
                           "../job/../secret/O0011.nc", "../secret/none.nc", "C:/secret/O0011.nc", "c:x.nc"})
    EXPECT_THAT(named(path), HasSubstr("leads out of the folder of the program")) << path;
  EXPECT_THAT(named(folder.path("secret/O0011.nc").substr(1)), HasSubstr("there is no program"));
  EXPECT_EQ(named("lib/part.nc"), "inside");
  EXPECT_EQ(named("../job/lib/part.nc"), "inside");
}

TEST_F(Reach, NamesAreFoundInTheFoldersOfTheJob) {
  EXPECT_EQ(named("../secret/O0011.nc", {folder.path("secret")}), "SECRET");
  EXPECT_EQ(named("O0011.nc", {folder.path("secret/O0011.nc")}), "SECRET");
  EXPECT_THAT(named("../secret/81.nc", {folder.path("secret/O0011.nc")}), HasSubstr("leads out"));
  // A file that the job names calls what lies beside it.
  const std::string called = folder.path("secret/O0011.nc");
  EXPECT_EQ(answer(FileProgramSource(main, {called}), {called, {}, "81.nc"}), "SECRET");
}

TEST_F(Reach, LinksAreFollowed) {
  link("../secret/O0011.nc", "job/O0011.nc");
  link("../secret", "job/away");
  link("lib/part.nc", "job/O0012.nc");
  link("lib", "job/near");
  link("O0013.nc", "job/O0013.nc");  // in a circle
  EXPECT_THAT(named("O0011.nc"), HasSubstr("leads out"));
  EXPECT_THAT(named("away/O0011.nc"), HasSubstr("leads out"));
  EXPECT_EQ(named("near/part.nc"), "inside");
  EXPECT_THAT(answer(FileProgramSource(main), byStem(main, {"O0011"})), HasSubstr("leads out"));
  EXPECT_EQ(answer(FileProgramSource(main), byStem(main, {"O0012"})), "inside");
  EXPECT_THAT(answer(FileProgramSource(main), byStem(main, {"O0013"})), HasSubstr("there is no program"));
  // Links that the job names open what they point to.
  EXPECT_EQ(named("O0011.nc", {folder.path("job/away")}), "SECRET");
  EXPECT_EQ(answer(FileProgramSource(folder.path("job/O0011.nc")), byStem("", {"O0012"})), "inside");
}

TEST_F(Reach, SystemProgramsAreTheControlsOwn) {
  SubprogramQuery query = byStem(main, {"O9010"});
  query.system_channel = 1;
  folder.write("SystemMacros/Channel1/O9010.nct", "system");
  EXPECT_EQ(answer(FileProgramSource(main), query), "system");
  std::filesystem::remove_all(folder.path("SystemMacros"));
  folder.write("secret/Channel1/O9010.nct", "SECRET");
  link("secret", "SystemMacros");
  EXPECT_THAT(answer(FileProgramSource(main), query), HasSubstr("leads out"));
}

TEST_F(Reach, RefusedFilesKeepTheirPlace) {
  link("../secret/81.nc", "job/81.nc");
  const FileProgramSource source(main);
  EXPECT_TRUE(source.finds(byStem(main, {"81"})));
  EXPECT_TRUE(source.finds({main, {}, "../secret/81.nc"}));
  EXPECT_FALSE(source.finds(byStem(main, {"82"})));
}

}  // namespace
}  // namespace proveout
