// The system fails: a full disk at any writer, a kill at any moment, a folder that cannot be written, closed
// streams, two runs into one folder. An old result stays whole or a new one is whole, and the exit code says
// which.
#include <gtest/gtest.h>

#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>

#include "io/sha256.h"
#include "program_runner.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

const std::string kRun = "run ring.nc --control nct --tool 1=flat:4 --csv --format stl,obj,ply ";
const std::string kOnto = "--size 320x240 --out ";
const std::string kOld = kRun + "--resolution 1 --stock box:0,0,-10:20,20,0 --size 320x240 --out out ";
const std::string kOther = kRun + "--resolution 1 --stock box:0,0,-12:21,21,0 ";
const std::string kNew = kOther + kOnto + "out ";

/// The report in a folder; discarded where there is none or it is not whole.
nlohmann::json reportIn(const std::string& folder) {
  return nlohmann::json::parse(readFile(folder + "/report.json"), nullptr, false);
}

/// Empty, or what does not fit together in a folder with a report.
std::string flaw(const std::string& folder) {
  const nlohmann::json report = reportIn(folder);
  if (report.is_discarded()) return "report.json is cut short";
  for (const char* key : {"meshes", "data"}) {
    for (const auto& file : report["outputs"][key]) {
      const std::string name = file["path"].get<std::string>();
      const Result<std::string> hash = sha256OfFile(folder + "/" + name);
      if (!hash || *hash != file["sha256"].get<std::string>()) return name + " is not that of the report";
    }
  }
  for (const auto& image : report["outputs"]["images"]) {
    const std::string png = readFile(folder + "/" + image["path"].get<std::string>());
    if (!has(png, "IEND")) return image["path"].get<std::string>() + " is cut short";
  }
  for (const auto& table : report["outputs"]["tables"]) {
    if (readFile(folder + "/" + table.get<std::string>()).empty())
      return table.get<std::string>() + " is empty";
  }
  const bool page = !report["outputs"]["html"].is_null() && report["outputs"]["html"] != "";
  if (page && !has(readFile(folder + "/report.html"), "</html>")) return "report.html is cut short";
  if (fs::exists(folder + "/junit.xml") && !has(readFile(folder + "/junit.xml"), "</testsuites>"))
    return "junit.xml is cut short";
  return {};
}

/// Files that no report names.
std::set<std::string> leftovers(const std::string& folder) {
  const nlohmann::json report = reportIn(folder);
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename().string());
  for (const char* name : {"report.json", "report.html", "junit.xml"}) found.erase(name);
  for (const char* key : {"meshes", "images", "data"}) {
    for (const auto& file : report["outputs"][key]) found.erase(file["path"].get<std::string>());
  }
  for (const auto& table : report["outputs"]["tables"]) found.erase(table.get<std::string>());
  return found;
}

std::string blankOf(const std::string& folder) {
  const nlohmann::json report = reportIn(folder);
  return report.is_discarded() ? "" : report["stock"]["initial_mm3"].dump();
}

class Faults : public testing::Test {
 protected:
  Faults() { bench.write("ring.nc", kRing); }
  std::string out() const { return bench.path("out"); }
  Workbench bench;
};

/// A run under the shim, with these variables of it.
Outcome underShim(const Workbench& bench, const std::string& arguments, const std::string& variables) {
  return bench.run(arguments, "timeout 100 env " + variables + " LD_PRELOAD=" PROVEOUT_FAULT_SHIM);
}

/// How many of its calls a run can be killed at.
int killableCalls(const Workbench& bench, const std::string& arguments, const std::string& variables) {
  const Outcome outcome = underShim(bench, arguments, variables + " PROVEOUT_COUNT_CALLS=1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::size_t at = outcome.err.find("calls: ");
  return at == std::string::npos ? 0 : std::atoi(outcome.err.c_str() + at + 7);
}

TEST_F(Faults, AKillAtAnyMoment) {
  if (PROVEOUT_SANITIZED) GTEST_SKIP() << "the fault shim does not go with sanitizers";
  ASSERT_EQ(bench.run(kOld).exit_code, 0);
  const std::string old_blank = blankOf(out());
  fs::copy(out(), bench.path("kept"));
  const int calls = killableCalls(bench, kNew + "--threads 1", "");
  ASSERT_GT(calls, 50);
  int olds = 0, news = 0;
  for (int at = 1; at <= calls; at += at < calls - 60 ? 3 : 1) {
    fs::remove_all(out());
    fs::copy(bench.path("kept"), out());
    const Outcome outcome = underShim(bench, kNew + "--threads 1", "PROVEOUT_KILL_AT=" + std::to_string(at));
    ASSERT_EQ(outcome.exit_code, 137) << outcome.err;
    // Whoever looks finds the old result or the new one, whole.
    EXPECT_EQ(flaw(out()), "") << "killed at call " << at;
    ++(blankOf(out()) == old_blank ? olds : news);
    // Whatever was left aside goes with the next run.
    if (at % 16 != 0) continue;
    ASSERT_EQ(bench.run(kNew).exit_code, 0);
    EXPECT_EQ(flaw(out()), "");
    EXPECT_EQ(leftovers(out()), (std::set<std::string>{})) << "killed at call " << at;
    EXPECT_EQ(bench.files(""), (std::set<std::string>{".err", ".out", "kept", "out", "ring.nc"}));
  }
  EXPECT_GT(olds, 20);
  EXPECT_GT(news, 0);
}

/// Where folders cannot be exchanged a journal stands in the folder, and the next command carries it out: one
/// that only reads there, too.
TEST_F(Faults, AKillBetweenFilesThatAreMoved) {
  if (PROVEOUT_SANITIZED) GTEST_SKIP() << "the fault shim does not go with sanitizers";
  ASSERT_EQ(bench.run(kOld).exit_code, 0);
  const std::string old_blank = blankOf(out());
  fs::copy(out(), bench.path("kept"));
  const std::string variables = "PROVEOUT_NO_EXCHANGE=1";
  const int calls = killableCalls(bench, kNew + "--threads 1", variables);
  ASSERT_GT(calls, 50);
  int olds = 0, news = 0, moving = 0;
  for (int at = calls - 40; at <= calls; ++at) {
    fs::remove_all(out());
    fs::copy(bench.path("kept"), out());
    const Outcome outcome =
        underShim(bench, kNew + "--threads 1", variables + " PROVEOUT_KILL_AT=" + std::to_string(at));
    ASSERT_EQ(outcome.exit_code, 137) << outcome.err;
    moving += !bench.exists("out/report.json");
    const char* const readers[] = {"render out/ring.stl -o p.png --size 16x16",
                                   "compare out/ring.stl out/ring.obj", "explain out --at 5,5,-2"};
    const Outcome reader = bench.run(readers[at % 3]);
    EXPECT_EQ(reader.exit_code, 0) << readers[at % 3] << reader.err;
    EXPECT_EQ(flaw(out()), "") << "killed at call " << at;
    EXPECT_FALSE(bench.exists("out/.proveout-moving"));
    ++(blankOf(out()) == old_blank ? olds : news);
  }
  EXPECT_GT(olds, 0);
  EXPECT_GT(news, 5);
  EXPECT_GT(moving, 2);
}

/// What else stands in the folder stays there, the same file and not a copy.
TEST_F(Faults, OtherFilesInTheFolderStay) {
  for (const char* exchange : {"", "PROVEOUT_NO_EXCHANGE=1"}) {
    if (PROVEOUT_SANITIZED && *exchange != 0) continue;
    fs::remove_all(out());
    bench.write("out/notes.txt", "mine");
    bench.write("out/mine/deep/er.txt", "mine too");
    bench.write("out/ring.stl.old", "older");
    fs::create_symlink("notes.txt", out() + "/link");
    fs::permissions(out(), fs::perms::owner_all | fs::perms::group_read);
    fs::create_hard_link(out() + "/notes.txt", bench.path("same"));
    for (const std::string& arguments : {kOld, kNew}) {
      const Outcome outcome = *exchange == 0 ? bench.run(arguments) : underShim(bench, arguments, exchange);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_EQ(flaw(out()), "");
      EXPECT_EQ(leftovers(out()), (std::set<std::string>{"link", "mine", "notes.txt", "ring.stl.old"}));
      EXPECT_EQ(readFile(out() + "/mine/deep/er.txt"), "mine too");
      EXPECT_TRUE(fs::equivalent(out() + "/notes.txt", bench.path("same")));
      EXPECT_EQ(fs::read_symlink(out() + "/link"), "notes.txt");
      EXPECT_EQ(fs::status(out()).permissions(), fs::perms::owner_all | fs::perms::group_read);
    }
    fs::remove(bench.path("same"));
  }
}

/// A journal is no way out of its folder.
TEST_F(Faults, AForgedJournalReachesNothing) {
  bench.write("precious.txt", "stays");
  bench.write("a.obj", boxObj(0, 0, 0, 10, 20, 30));
  bench.write("out/.proveout-moving/.proveout-gone",
              std::string("../precious.txt\0", 16) + bench.path("precious.txt") + '\0');
  bench.write("out/.proveout-moving/a.obj", boxObj(0, 0, 0, 10, 20, 30));
  EXPECT_EQ(bench.run("compare out/a.obj a.obj").exit_code, 0);
  EXPECT_EQ(readFile(bench.path("precious.txt")), "stays");
}

/// Names that no file can have are told before the work; the longest that one can have are written.
TEST_F(Faults, NamesThatAreTooLong) {
  const auto job = [&](const std::string& name, const std::string& more) {
    bench.write("job.toml",
                "schema = \"proveout.job/1\"\nname = \"" + name +
                    "\"\nprogram = \"ring.nc\"\ncontrol = \"nct\"\n[stock]\nshape = \"box\"\nmin = "
                    "[0, 0, -10]\nmax = [20, 20, 0]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = "
                    "4\n[simulation]\nresolution = 1\n[output]\nviews = []\n" +
                    more);
  };
  bench.write("a.obj", boxObj(0, 0, 0, 10, 20, 30));
  const std::string longest(251, 'n'), beyond(300, 'n');
  job(longest, "formats = [\"stl\", \"vdb\", \"obj\"]\n");
  const Outcome good = bench.run("run job.toml --out out");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_EQ(flaw(out()), "");
  fs::remove_all(out());
  job(beyond, "");
  for (const std::string& arguments :
       {std::string("run job.toml --out out"), "run ring.nc --out " + beyond + kRingOptions,
        "compare a.obj a.obj --out " + beyond, "render a.obj -o " + beyond + ".png"}) {
    const Outcome outcome = bench.run(arguments, "timeout 100 env PROVEOUT_SIMD=baseline");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_TRUE(has(outcome.err, "too long")) << arguments << outcome.err;
    EXPECT_LT(outcome.err.size(), 1000u);
    EXPECT_FALSE(bench.exists("out"));
  }
}

TEST_F(Faults, AKilledPictureLeavesTheEarlierOne) {
  if (PROVEOUT_SANITIZED) GTEST_SKIP() << "the fault shim does not go with sanitizers";
  bench.write("a.obj", boxObj(0, 0, 0, 10, 20, 30));
  bench.write("a.png", "earlier");
  for (int at = 1;; ++at) {
    ASSERT_LT(at, 100);
    const Outcome outcome =
        bench.run("render a.obj --size 64x64", "timeout 100 env PROVEOUT_KILL_AT=" + std::to_string(at) +
                                                   " LD_PRELOAD=" PROVEOUT_FAULT_SHIM);
    if (outcome.exit_code == 0) break;
    ASSERT_EQ(outcome.exit_code, 137);
    EXPECT_EQ(readFile(bench.path("a.png")), "earlier") << at;
  }
  EXPECT_TRUE(has(readFile(bench.path("a.png")), "IEND"));
}

/// Runs in a namespace of its own, in which `bench.path("full")` is a file system of `size` bytes.
class SmallDisk : public Faults {
 protected:
  void SetUp() override {
    if (std::system("unshare -rm sh -c 'mount -t tmpfs -o size=64k none /tmp' >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "no file system of its own can be mounted here (unshare -rm)";
    fs::create_directory(bench.path("full"));
  }
  /// What is left on the small disk is copied to "left". `mount`: more options of it.
  Outcome runOn(const std::string& size, const std::string& before, const std::string& arguments,
                const std::string& mount = "") const {
    fs::remove_all(bench.path("left"));
    bench.write("inside.sh", "set -e\nmount -t tmpfs -o size=" + size + " none full\n" + before + "\n" +
                                 mount + "\nset +e\ntimeout 100 \"$1\" " + arguments +
                                 "\ncode=$?\ncp -a full/. left\nexit $code\n");
    fs::create_directory(bench.path("left"));
    const Workbench& own = bench;
    const std::string command =
        "cd '" + own.path() + "' && unshare -rm sh inside.sh '" + own.program + "' >.out 2>.err";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.err = readFile(own.path(".err"));
    outcome.out = readFile(own.path(".out"));
    return outcome;
  }
};

TEST_F(SmallDisk, FullAtEveryWriter) {
  ASSERT_EQ(bench.run(kOld).exit_code, 0);
  const std::string old_blank = blankOf(out());
  std::set<int> codes;
  int partial = 0, kept = 0;
  for (int pages = 30; pages <= 400; pages = pages * 9 / 8 + 1) {
    const std::string size = std::to_string(4 * pages) + "k";
    for (const bool earlier : {false, true}) {
      const Outcome outcome =
          runOn(size, earlier ? "cp -a out full/out 2>/dev/null" : ":", kOther + kOnto + "full/out");
      if (earlier && outcome.exit_code == 1) continue;  // the earlier result did not fit
      codes.insert(outcome.exit_code);
      ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << size << outcome.err;
      const std::string folder = bench.path("left/out");
      const bool there = fs::exists(folder + "/report.json");
      if (there) {
        EXPECT_EQ(flaw(folder), "") << size << earlier;
        EXPECT_EQ(leftovers(folder), (std::set<std::string>{})) << size << earlier;
        EXPECT_TRUE(fs::exists(folder + "/report.html") || !has(outcome.out, "report.html")) << outcome.out;
      }
      const bool is_new = there && blankOf(folder) != old_blank;
      EXPECT_TRUE(is_new || outcome.exit_code != 0) << size;
      if (outcome.exit_code == 3) {
        EXPECT_TRUE(has(outcome.err, "No space left") || has(outcome.err, "not enough room") ||
                    has(outcome.err, "cannot write") || has(outcome.err, "nothing was written"))
            << outcome.err;
      }
      EXPECT_TRUE(there || !earlier) << "neither the old result nor the new one, " << size;
      partial += is_new && outcome.exit_code == 3;
      kept += earlier && !is_new;
    }
  }
  EXPECT_EQ(codes, (std::set<int>{0, 3}));
  EXPECT_GT(partial, 0);
  EXPECT_GT(kept, 0);
}

TEST_F(SmallDisk, FullForStocksPicturesAndComparisons) {
  bench.write("a.obj", boxObj(0, 0, -10, 20, 20, 0));
  for (const std::string& arguments :
       {std::string("run ring.nc --control nct --tool 1=ball:4 --stock box:0,0,-10:20,20,0 --resolution 0.2 "
                    "--format vdb --no-render --out full/out"),
        std::string("compare a.obj a.obj --size 1000x1000 --out full/out"),
        std::string("render a.obj --size 1000x1000 -o full/a.png")}) {
    const Outcome outcome = runOn("24k", ":", arguments);
    EXPECT_EQ(outcome.exit_code, 3) << arguments << outcome.err;
    EXPECT_FALSE(bench.exists("left/a.png"));
    EXPECT_TRUE(!bench.exists("left/out/report.json") || flaw(bench.path("left/out")).empty());
    for (const auto& entry : fs::recursive_directory_iterator(bench.path("left")))
      EXPECT_FALSE(has(entry.path().filename().string(), "proveout-run") ||
                   has(entry.path().filename().string(), ".tmp"))
          << entry.path();
  }
}

TEST_F(SmallDisk, ThatCannotBeWritten) {
  bench.write("a.obj", boxObj(0, 0, -10, 20, 20, 0));
  ASSERT_EQ(bench.run(kOld).exit_code, 0);
  const std::string report = readFile(bench.path("out/report.json"));
  for (const std::string& arguments :
       {kOther + kOnto + "full/out", kOther + kOnto + "full/other",
        std::string("compare a.obj a.obj --out full/out"), std::string("render a.obj -o full/a.png")}) {
    const Outcome outcome = runOn("4m", "cp -a out full/out", arguments, "mount -o remount,ro full");
    EXPECT_EQ(outcome.exit_code, 2) << arguments << outcome.err;
    EXPECT_TRUE(has(outcome.err, "Read-only file system")) << outcome.err;
    EXPECT_EQ(readFile(bench.path("left/out/report.json")), report);
    EXPECT_EQ(flaw(bench.path("left/out")), "");
  }
}

/// Of every file the bytes behind a limit cannot be written: works without a file system of one's own.
TEST_F(Faults, FilesThatMayNotGrow) {
  ASSERT_EQ(bench.run(kOld).exit_code, 0);
  const std::string old_blank = blankOf(out());
  fs::copy(out(), bench.path("kept"));
  int partial = 0, kept = 0;
  for (int blocks = 1; blocks < 2000; blocks = blocks * 3 / 2 + 1) {
    fs::remove_all(out());
    fs::copy(bench.path("kept"), out());
    // stdout goes into a file as well.
    const Outcome outcome = bench.runInto("/dev/null", kNew + "--quiet",
                                          "ulimit -f " + std::to_string(blocks) + " && timeout 100");
    ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << blocks << outcome.err;
    EXPECT_EQ(flaw(out()), "") << blocks;
    EXPECT_EQ(leftovers(out()), (std::set<std::string>{})) << blocks;
    const bool is_new = blankOf(out()) != old_blank;
    EXPECT_TRUE(is_new || outcome.exit_code != 0) << blocks;
    partial += is_new && outcome.exit_code == 3;
    kept += !is_new;
  }
  EXPECT_GT(partial, 0);
  EXPECT_GT(kept, 0);
}

TEST_F(Faults, ClosedStreams) {
  bench.write("a.obj", boxObj(0, 0, -10, 20, 20, 0));
  ASSERT_EQ(bench.run(kNew).exit_code, 0);
  const std::string mesh = readFile(bench.path("out/ring.ply"));
  for (const std::string closed : {"&-", "/dev/full"}) {
    for (const std::string& arguments :
         {kNew, std::string("compare a.obj a.obj"), std::string("coverage"),
          std::string("check ring.nc --control nct"), std::string("path ring.nc --control nct")}) {
      fs::remove_all(out());
      const Outcome outcome = bench.runInto(closed, arguments);
      EXPECT_EQ(outcome.exit_code, 2) << closed << arguments;
      EXPECT_TRUE(has(outcome.err, "standard output")) << closed << arguments << outcome.err;
      if (arguments != kNew) continue;
      EXPECT_EQ(flaw(out()), "");  // the files are there
      EXPECT_EQ(readFile(bench.path("out/ring.ply")), mesh);
    }
  }
  // Messages never come into a file that has got the number of a stream that was closed.
  for (const char* close : {"2>&-", "0<&- 2>&-", "0<&- 1>&- 2>&-"}) {
    fs::remove_all(out());
    const std::string command =
        "cd '" + bench.path() + "' && '" + bench.program + "' " + kNew + "--progress >.out " + close;
    const int code = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(code) && (WEXITSTATUS(code) == 0 || WEXITSTATUS(code) == 2)) << close;
    EXPECT_EQ(flaw(out()), "") << close;
    EXPECT_EQ(readFile(bench.path("out/ring.ply")), mesh) << close;
  }
}

TEST_F(Faults, TwoRunsIntoOneFolder) {
  ASSERT_EQ(bench.run(kOld).exit_code, 0);
  for (int round = 0; round < 6; ++round) {
    std::vector<std::future<int>> runs;
    for (const std::string& arguments : {kOld, kNew}) {
      runs.push_back(std::async(std::launch::async, [this, arguments] {
        const std::string command =
            "cd '" + bench.path() + "' && '" + bench.program + "' " + arguments + " >/dev/null 2>&1";
        return std::system(command.c_str());
      }));
    }
    for (auto& run : runs) EXPECT_EQ(run.get(), 0);
    EXPECT_EQ(flaw(out()), "");
    EXPECT_EQ(leftovers(out()), (std::set<std::string>{}));
  }
}

}  // namespace
}  // namespace proveout::test
