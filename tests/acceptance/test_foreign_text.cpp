// What comes from outside as text, names of files and words of programs, acts on no terminal and on no table.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/printable.h"
#include "program_runner.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

/// Escape, bell, a C1 control (CSI), one that turns the direction of writing, DEL and a byte that is no text.
const std::string kEvil =
    "a\x1b[31m\x07\xC2\x9B"
    "2J\xE2\x80\xAE\x7F\xFFz";
/// The same as far as a TOML text can hold it, written as one.
constexpr const char* kEvilToml = "a\\u001b[31m\\u0007\\u009b2J\\u202e\\u007fz";

/// What acts in a text, with where it stands; "" where nothing does.
std::string acting(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8Length(std::string_view(text).substr(at));
    const std::string_view sequence = std::string_view(text).substr(at, std::max<std::size_t>(length, 1));
    const bool layout = sequence == "\n" || sequence == "\t";
    if (length == 0 || (!layout && isControlCharacter(sequence)))
      return "byte " + std::to_string(at) + ": " + printable(text.substr(at < 30 ? 0 : at - 30, 60));
    at += length;
  }
  return {};
}

class ForeignText : public testing::Test {
 protected:
  void clean(const std::string& arguments, int exit_code) const {
    const Outcome outcome = bench.run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << printable(arguments) << "\n" << printable(outcome.err);
    EXPECT_EQ(acting(outcome.out), "") << printable(arguments);
    EXPECT_EQ(acting(outcome.err), "") << printable(arguments);
    EXPECT_FALSE((outcome.out + outcome.err).empty());
  }
  static std::string quoted(const std::string& text) { return "'" + text + "'"; }
  /// Every text file that was written.
  void cleanFiles(const std::string& folder) const {
    int texts = 0;
    for (const auto& entry : fs::recursive_directory_iterator(bench.path(folder))) {
      const std::string ending = entry.path().extension().string();
      if (!entry.is_regular_file() || ending == ".png" || ending == ".stl" || ending == ".vdb") continue;
      if (ending == ".ply") continue;
      ++texts;
      EXPECT_EQ(acting(readFile(entry.path().string())), "") << entry.path().filename();
    }
    EXPECT_GE(texts, 3);
  }
  Workbench bench;
};

TEST_F(ForeignText, NamesOfPrograms) {
  bench.write(kEvil + ".nc", kRing);
  bench.write("wrong" + kEvil + ".nc", "G21\nG777\nM30\n");
  const std::string program = quoted(kEvil + ".nc"), options = std::string(kRingOptions) + "--size 160x120 ";
  clean("run " + program + options + "--out out --csv --format stl,obj", 0);
  cleanFiles("out");
  clean("run " + program + options + "--out out --json", 0);
  clean("check " + program + " --control nct", 0);
  clean("check " + program + " --control nct --json", 0);
  clean("path " + program + " --control nct", 0);
  clean("path " + program + " --control nct --format csv", 0);
  clean("explain out --at 5,5,-2", 2);  // JSON cannot hold a name that is no text
  const std::string text = kEvil.substr(0, kEvil.find('\xFF'));
  bench.write(text + ".nc", kRing);
  clean("run " + quoted(text + ".nc") + options + "--out out", 0);
  clean("explain out --at 5,5,-2", 0);
  for (const char* command : {"check ", "path "})
    clean(command + quoted("wrong" + kEvil + ".nc") + " --control nct", 2);
  clean("check " + quoted("wrong" + kEvil + ".nc") + " --control nct --json", 2);
  clean("run " + quoted("wrong" + kEvil + ".nc") + options + "--out out2", 2);
  clean("run " + quoted("none" + kEvil) + options, 2);
}

TEST_F(ForeignText, LineEndsInNamesMakeNoLines) {
  const std::string name = "x\nproveout: error: forged\n.nc";
  bench.write(name, "G21\nG777\nM30\n");
  for (const char* command : {"check ", "path "}) {
    const Outcome outcome = bench.run(command + quoted(name) + " --control nct");
    EXPECT_FALSE(has("\n" + outcome.err, "\nproveout: error: forged")) << outcome.err;
  }
  bench.write(name, kRing);
  const Outcome csv = bench.run("path " + quoted(name) + " --control nct --format csv");
  EXPECT_FALSE(has(csv.out, "\nproveout")) << csv.out.substr(0, 500);
  ASSERT_EQ(bench.run("run " + quoted(name) + kRingOptions + "--out out --csv --no-render").exit_code, 0);
  EXPECT_FALSE(has(readFile(bench.path("out/blocks.csv")), "\nproveout"));
}

TEST_F(ForeignText, WordsOfPrograms) {
  const std::string comment = "(" + kEvil + ")";
  bench.write("p.nc", "G21 " + comment + "\n#3006=1" + comment + "\n" + kRing);
  bench.write("q.nc", "G21 G777 " + comment + "\n" + kEvil + "\n#3000=1(" + kEvil + ")\n");
  bench.write("r.nc", "FOPEN1 <" + kEvil + ">\nFCLOS\n" + std::string(kRing));
  for (const char* program : {"p.nc", "q.nc", "r.nc"}) {
    for (const std::string command : {"check ", "path "}) {
      const Outcome outcome = bench.run(command + program + " --control nct");
      EXPECT_EQ(acting(outcome.out + outcome.err), "") << command << program;
    }
    const Outcome outcome = bench.run("run " + std::string(program) + kRingOptions + "--out out-" + program);
    EXPECT_EQ(acting(outcome.out + outcome.err), "") << program;
    if (bench.exists(std::string("out-") + program)) cleanFiles(std::string("out-") + program);
  }
}

TEST_F(ForeignText, NamesInJobs) {
  const std::string evil = kEvilToml;
  bench.write("ring.nc", kRing);
  bench.write("nominal" + kEvil.substr(0, 7) + ".obj", boxObj(0, 0, -10, 20, 20, 0));
  bench.write(
      "job.toml",
      "schema = \"proveout.job/1\"\nname = \"" + evil + "\"\ncontrol = \"nct\"\n[stock]\nshape = \"box\"\n" +
          "min = [0, 0, -10]\nmax = [20, 20, 0]\n[nominal]\nmesh = \"nominala\\u001b[31m\\u0007.obj\"\n" +
          "[[nominal.ignore]]\nname = \"" + evil + "\"\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n" +
          "[[tool]]\nnumber = 1\nname = \"" + evil + "\"\ntype = \"flat\"\ndiameter = 4\n" +
          "[[setup]]\nname = \"" + evil + "\"\nprogram = \"ring.nc\"\n[[setup.fixture]]\nname = \"" + evil +
          "\"\nshape = \"box\"\nmin = [4, 4, -10]\nmax = [16, 16, 1]\n[simulation]\nresolution = 0.5\n" +
          "[output]\nformats = [\"stl-ascii\", \"obj\"]\ncsv = true\nsize = [160, 120]\n");
  clean("run job.toml --out out", 1);
  cleanFiles("out");
  clean("run job.toml --out out --json", 1);
  clean("check job.toml", 0);
  clean("check job.toml --json", 0);
  clean("check job.toml --setup none", 2);
  bench.write("wrong.toml", "schema = \"" + evil + "\"\n\"" + evil + "\" = 1\ncontrol = \"" + evil + "\"\n");
  clean("run wrong.toml", 2);
}

TEST_F(ForeignText, CommandLines) {
  bench.write("ring.nc", kRing);
  const std::string evil = quoted(kEvil), options = std::string(kRingOptions);
  for (const std::string& wrong :
       {evil, "run " + evil, "run --" + evil, "run ring.nc --control " + evil,
        "run ring.nc --threads " + evil + options,
        "run ring.nc --stock " + evil + " --control nct --tool 1=flat:4",
        "run ring.nc --view " + evil + options, "run ring.nc --until " + evil + options,
        "run ring.nc --format " + evil + options, "coverage --control " + evil, "render " + evil,
        "render ring.nc --view " + evil, "compare " + evil + " " + evil, "explain " + evil + " --at 1,2,3",
        "explain ring.nc --at " + evil})
    clean(wrong, 2);
}

// Called programs are those of the job: nothing of another file is shown, whatever way leads there.
TEST_F(ForeignText, ProgramsReachOnlyWhatTheJobNames) {
  const std::string secret = "hunter2:x:0:0\n";
  bench.write("secret.nc", secret);
  bench.write("job/sub/inside.nc", "G0 X1\nM99\n");
  fs::create_symlink("../secret.nc", bench.path("job/O0011.nc"));
  fs::create_symlink("../secret.nc", bench.path("job/81.nc"));
  fs::create_symlink("..", bench.path("job/up"));
  const auto refused = [&](const std::string& arguments, const std::string& place) {
    const Outcome outcome = bench.run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_TRUE(has(outcome.out + outcome.err, "leads out of the folder")) << arguments << outcome.err;
    EXPECT_TRUE(has(outcome.out + outcome.err, place)) << outcome.err;
    EXPECT_FALSE(has(outcome.out + outcome.err, "hunter2")) << arguments << outcome.err;
  };
  for (const char* call : {"M98 <../secret.nc>", "M98 <..\\secret.nc>", "G65 <..\\sub\\..\\secret.nc>",
                           "M98 <up/secret.nc>", "M98 <C:\\secret.nc>", "M98 P11"}) {
    bench.write("job/main.nc", std::string("G21 G90 T1 M6\n") + call + "\nM30\n");
    refused("check job/main.nc --control nct", "main.nc:2:");
    refused("check job/main.nc --control nct --json", "");
    refused("path job/main.nc --control nct", "main.nc:2:");
    refused("run job/main.nc --out out" + std::string(kRingOptions), "main.nc:2:");
    for (const char* file : {"out/report.json", "out/report.html", "out/junit.xml"})
      EXPECT_FALSE(has(readFile(bench.path(file)), "hunter2")) << file;
  }
  bench.write("job/main.nc", "M98 <sub/inside.nc>\nM98 <up/job/sub/inside.nc>\nM30\n");
  EXPECT_EQ(bench.run("check job/main.nc --control nct").exit_code, 0);
  bench.write("job/wl4.nc", "%01\nG81 X1 Y1 Z-1\nM02\n");
  EXPECT_FALSE(has(bench.run("check job/wl4.nc --control wl4-mill").err, "hunter2"));
}

TEST_F(ForeignText, WhatIsNoProgramIsToldInOneLine) {
  std::string users, bytes =
                         "\x7F"
                         "ELF\x02\x01\n";
  for (int k = 0; k < 30; ++k) users += "hunter2:x:0:" + std::to_string(k) + ":/bin/sh\n";
  for (int k = 1; k < 2000; ++k) bytes += static_cast<char>(1 + k * 7 % 255);
  bench.write("users.nc", users);
  bench.write("binary.nc", bytes);
  bench.write("main.nc", "G21 G90\nM98 <users.nc>\nM30\n");
  for (const char* control : {"nct", "wl4-mill", "wl4-lathe", "flexnc", "wedm"}) {
    for (const char* file : {"users.nc", "binary.nc", "main.nc"}) {
      if (std::string(file) == "main.nc" && std::string(control) != "nct") continue;
      const Outcome outcome = bench.run("check " + std::string(file) + " --control " + control);
      EXPECT_EQ(outcome.exit_code, 2) << control << file;
      EXPECT_FALSE(has(outcome.err, "hunter2")) << control << outcome.err;
      EXPECT_FALSE(has(outcome.err, "ELF")) << control << outcome.err;
      const auto lines = std::count(outcome.err.begin(), outcome.err.end(), '\n');
      EXPECT_LE(lines, std::string(file) == "main.nc" ? 2 : 1) << control << outcome.err;
    }
  }
}

}  // namespace
}  // namespace proveout::test
