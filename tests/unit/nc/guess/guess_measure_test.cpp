// How often the guess of a control is right, wrong or refused, over all programs that are here.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "core/nc/guess/control_guess.h"
#include "tests/unit/nc/guess/posted_programs.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

struct Counts {
  int right = 0, wrong = 0, refused = 0;
  std::string wrong_ones;
};

/// "control" of a job or of a golden's settings: the word behind `key` at the start of a line.
std::string wordBehind(const std::string& text, const std::string& key) {
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    if (at > 0 && text[at - 1] != '\n') continue;
    const std::size_t first = text.find_first_not_of("= \"", at + key.size());
    return text.substr(first, text.find_first_of("\"\n ", first) - first);
  }
  return {};
}

void count(Counts& counts, const std::string& wanted, const std::string& flavour, const std::string& name,
           const std::string& text) {
  const GuessedControl guess = guessControl(name, text);
  if (!guess.chosen) {
    ++counts.refused;
  } else if (guess.chosen->control == wanted && (flavour.empty() || guess.chosen->flavour == flavour)) {
    ++counts.right;
  } else {
    ++counts.wrong;
    counts.wrong_ones += name + ": " + guess.choiceText() + "\n";
  }
}

void print(const char* what, const std::map<std::string, Counts>& all) {
  for (const auto& [control, counts] : all)
    std::cout << what << ' ' << control << ": right " << counts.right << ", wrong " << counts.wrong
              << ", refused " << counts.refused << '\n';
}

TEST(ControlGuess, OfPostedProgramsIsRightWithTheFlavour) {
  std::map<std::string, Counts> all;
  for (const PostedProgram& program : postedPrograms()) {
    Counts& counts = all[program.control + (program.flavour.empty() ? "" : " " + program.flavour)];
    count(counts, program.control, program.flavour, program.file, program.text());
    EXPECT_EQ(counts.wrong_ones, "");
    EXPECT_EQ(counts.refused, 0) << program.file;
  }
  print("posted", all);
  EXPECT_GE(all.size(), 7u);
}

TEST(ControlGuess, OfTheSamplePartsIsNeverWrong) {
  std::map<std::string, Counts> all;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PROVEOUT_SOURCE_DIR) / "parts")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string job = textOfFile(entry.path());
    const std::string program = wordBehind(job, "program"), whole = wordBehind(job, "control =");
    const std::size_t table = std::min(job.find("[control]\n"), job.size());
    const std::string control = whole.empty() ? wordBehind(job.substr(table), "name") : whole;
    const fs::path file = entry.path().parent_path() / program;
    if (program.empty() || !fs::exists(file) || control == "auto") continue;
    Counts& counts = all[control];
    count(counts, control, "", program, textOfFile(file));
    EXPECT_EQ(counts.wrong_ones, "") << entry.path();
  }
  print("parts", all);
  EXPECT_GE(all["wedm"].right, 4);
  EXPECT_GE(all["flexnc"].right, 3);
  EXPECT_GE(all["wl4-lathe"].right, 2);
  EXPECT_GE(all["fanuc-mill"].right, 1);
  EXPECT_GE(all["linuxcnc"].right, 1);
}

/// Most of these are a few blocks that any control reads: the more are refused, the better.
TEST(ControlGuess, OfTheGoldenProgramsIsNeverWrong) {
  std::map<std::string, Counts> all;
  const fs::path root = fs::path(PROVEOUT_SOURCE_DIR) / "tests/unit/nc/golden";
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".nc") continue;
    const std::string golden = textOfFile(entry.path()), given = wordBehind(golden, "control"),
                      control = given.empty() ? "nct" : given;
    const std::size_t marker = golden.find("=== main\n");
    std::string text = marker == std::string::npos ? golden : golden.substr(marker + 9);
    text.erase(std::min(text.find("\n=== ") + 1, text.size()));
    Counts& counts = all[control];
    count(counts, control, "", "main.nc", text);
    EXPECT_EQ(counts.wrong_ones, "") << entry.path();
  }
  print("golden", all);
  EXPECT_GT(all["nct"].refused + all["nct"].right, 600);
  EXPECT_GE(all["wedm"].right, 8);
  EXPECT_GE(all["flexnc"].right, 60);
  EXPECT_GE(all["wl4-mill"].right, 15);
}

}  // namespace
}  // namespace proveout::test
