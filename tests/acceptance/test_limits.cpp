// Time, threads and files: what there is not enough of is told, and nothing is left half done.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "program_runner.h"

namespace proveout::test {
namespace {

/// A loop that goes on to other places each time, and ends only after seconds.
constexpr const char* kLasting =
    "G21 G90 G17 T1 M6\nS1000 M3\nG0 X5 Y5 Z5\n#1=0\nN10 #1=#1+0.001\nX[5+SIN[#1]]\nX5\n"
    "IF[#1 LT 2400] GOTO 10\nM30\n";

/// Closed, of `n` by `n` fields to a side.
std::string plateObj(int n, double size) {
  std::string text;
  for (int side = 0; side < 2; ++side) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i)
        text += "v " + std::to_string(size * i / n) + " " + std::to_string(size * j / n) + " " +
                std::to_string(side * size) + "\n";
    }
  }
  const auto at = [n](int i, int j, int side) {
    return std::to_string(1 + i + j * (n + 1) + side * (n + 1) * (n + 1)) + " ";
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      text += "f " + at(i, j, 0) + at(i, j + 1, 0) + at(i + 1, j + 1, 0) + at(i + 1, j, 0) + "\n";
      text += "f " + at(i, j, 1) + at(i + 1, j, 1) + at(i + 1, j + 1, 1) + at(i, j + 1, 1) + "\n";
    }
  }
  for (int i = 0; i < n; ++i) {
    text += "f " + at(i, 0, 0) + at(i + 1, 0, 0) + at(i + 1, 0, 1) + at(i, 0, 1) + "\n";
    text += "f " + at(i + 1, n, 0) + at(i, n, 0) + at(i, n, 1) + at(i + 1, n, 1) + "\n";
    text += "f " + at(0, i + 1, 0) + at(0, i, 0) + at(0, i, 1) + at(0, i + 1, 1) + "\n";
    text += "f " + at(n, i, 0) + at(n, i + 1, 0) + at(n, i + 1, 1) + at(n, i, 1) + "\n";
  }
  return text;
}

double secondsOf(const std::function<void()>& work) {
  const auto from = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

/// Of the programs that `work` runs, on all cores together: a busy machine or a slow disk does not add to it.
double processorSecondsOf(const std::function<void()>& work) {
  const auto used = [] {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  };
  const double from = used();
  work();
  return used() - from;
}

class Limits : public testing::Test {
 protected:
  Limits() {
    bench.write("ring.nc", kRing);
    bench.write("lasting.nc", kLasting);
  }
  /// The command works no longer than it may and says why.
  void stopped(const std::string& arguments, double limit_s) const {
    Outcome outcome;
    const double took = processorSecondsOf([&] { outcome = bench.run(arguments); });
    EXPECT_EQ(outcome.exit_code, 3) << arguments << "\n" << outcome.err;
    EXPECT_TRUE(has(outcome.err, "time limit") || has(outcome.err, "are allowed")) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "max-time")) << outcome.err;
    const double cores = std::max(1u, std::thread::hardware_concurrency());
    EXPECT_LT(took, cores * limit_s + 1.0) << arguments;
  }
  Workbench bench;
};

TEST_F(Limits, EveryCommandStopsInItsTime) {
  stopped("check lasting.nc --control nct --max-time 1", 1.0);
  stopped("path lasting.nc --control nct --max-time 1", 1.0);
  stopped("run lasting.nc --max-time 1 --out out" + std::string(kRingOptions), 1.0);
  EXPECT_FALSE(bench.exists("out"));
  bench.write("a.obj", plateObj(200, 100.0));
  stopped("compare a.obj a.obj --resolution 0.05 --max-time 0.5 --out out", 0.5);
  EXPECT_FALSE(bench.exists("out"));
  stopped("render a.obj --size 8192x8192 -o a.png --max-time 0.5", 0.5);
  EXPECT_FALSE(bench.exists("a.png"));
  ASSERT_EQ(bench.run("run ring.nc --out out --no-render" + std::string(kRingOptions)).exit_code, 0);
  stopped("explain out --at 5,5,-2 --max-time 0.0001", 0.0);
}

TEST_F(Limits, AnEarlierResultStays) {
  ASSERT_EQ(bench.run("run ring.nc --out out" + std::string(kRingOptions)).exit_code, 0);
  const std::string report = readFile(bench.path("out/report.json"));
  const auto files = bench.files("out");
  for (const char* limit : {"0.001", "0.02", "0.1", "0.3"}) {
    const Outcome outcome = bench.run(
        "run ring.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=flat:4 --resolution 0.05 --out out "
        "--size 4000x4000 --max-time " +
        std::string(limit));
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_EQ(readFile(bench.path("out/report.json")), report);
    EXPECT_EQ(bench.files("out"), files);
  }
}

TEST_F(Limits, TheJobHasAKeyForIt) {
  const std::string job =
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"lasting.nc\"\n[stock]\nshape = \"box\"\n"
      "min = [0, 0, -10]\nmax = [20, 20, 0]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = "
      "4\n[simulation]\n";
  bench.write("job.toml", job + "max_time_s = 0.5\n");
  for (const char* command : {"check", "path", "run"}) stopped(std::string(command) + " job.toml", 0.5);
  // The command line has the last word, also where it allows more.
  Outcome outcome;
  EXPECT_GT(secondsOf([&] { outcome = bench.run("check job.toml --max-time 2"); }), 1.5);
  EXPECT_EQ(outcome.exit_code, 3);
  bench.write("wrong.toml", job + "max_time_s = 0\n");
  EXPECT_EQ(bench.run("check wrong.toml").exit_code, 2);
  for (const char* wrong : {"0", "-1", "x", "nan", "1e12"})
    EXPECT_EQ(bench.run("check ring.nc --control nct --max-time " + std::string(wrong)).exit_code, 2)
        << wrong;
  EXPECT_EQ(bench.run("check ring.nc --control nct --max-time 1e8").exit_code, 0);
}

TEST_F(Limits, WorkOutOfProportionIsToldBeforeItIsBegun) {
  const std::string run =
      "run ring.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=ball:4 --resolution 0.01 --out out "
      "--max-memory 100 ";
  Outcome outcome;
  const double took = processorSecondsOf([&] { outcome = bench.run(run + "--max-time 2"); });
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "this run would take about")) << outcome.err;
  EXPECT_LT(took, 2.0);
  EXPECT_FALSE(bench.exists("out"));
  // An hour is allowed where nobody says more.
  outcome = bench.run(
      "run ring.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=ball:4 --resolution 0.0002 --out out "
      "--max-memory 1e6");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "3600 s are allowed")) << outcome.err;
  EXPECT_FALSE(bench.exists("out"));
}

TEST_F(Limits, MeshesBeyondMeasureAreRefused) {
  bench.write("part.obj", boxObj(0, 0, -10, 20, 20, 0));
  bench.write("far.obj", boxObj(0, 0, -10, 1e9, 1e9, 0));
  for (const char* pair : {"far.obj far.obj", "far.obj part.obj", "part.obj far.obj"}) {
    Outcome outcome;
    const double took = processorSecondsOf([&] { outcome = bench.run("compare " + std::string(pair)); });
    EXPECT_EQ(outcome.exit_code, 2) << pair;
    EXPECT_TRUE(has(outcome.err, "far.obj: the mesh reaches as far as 1e+09 mm")) << outcome.err;
    EXPECT_LT(took, 1.0);
  }
  const Outcome run = bench.run("run ring.nc --nominal far.obj" + std::string(kRingOptions));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(has(run.err, "unit")) << run.err;
}

TEST_F(Limits, MeshesOfWrongUnitsAreComparedInSeconds) {
  // Of a nominal in metres that was taken for millimetres every sample once cost what the whole mesh does.
  bench.write("large.obj", plateObj(50, 100000.0));
  bench.write("small.obj", plateObj(50, 100.0));
  for (const char* pair : {"large.obj small.obj", "small.obj large.obj"}) {
    const Outcome outcome = bench.run("compare " + std::string(pair) + " --max-time 30");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  }
}

/// Sanitizers start before any other library and do not like it.
#define SKIP_WITHOUT_SHIM() \
  if (PROVEOUT_SANITIZED) GTEST_SKIP() << "the fault shim does not go with sanitizers"

TEST_F(Limits, WithoutThreadsOneDoes) {
  SKIP_WITHOUT_SHIM();
  const std::string without = "timeout 100 env PROVEOUT_NO_THREADS=1 LD_PRELOAD=" PROVEOUT_FAULT_SHIM;
  const std::string options = std::string(kRingOptions) + "--format obj --size 160x120 ";
  ASSERT_EQ(bench.run("run ring.nc --out with" + options).exit_code, 0);
  for (const char* threads : {"", "--threads 1", "--threads 8"}) {
    const Outcome outcome = bench.run("run ring.nc --out without" + options + threads, without);
    ASSERT_EQ(outcome.exit_code, 0) << threads << outcome.err;
    EXPECT_EQ(readFile(bench.path("with/ring.obj")), readFile(bench.path("without/ring.obj")));
    EXPECT_EQ(readFile(bench.path("with/iso.png")), readFile(bench.path("without/iso.png")));
  }
  for (const char* command :
       {"check ring.nc --control nct", "path ring.nc --control nct",
        "render with/ring.obj --size 160x120 -o a.png",
        "compare with/ring.obj without/ring.obj --size 160x120 --out c", "explain with --at 5,5,-2"}) {
    const Outcome outcome = bench.run(command, without);
    EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
  }
  // Where OpenVDB is needed, whose logger must have threads, that is said before anything is done.
  for (const char* more : {"--format vdb", "--stock mesh:with/ring.obj"}) {
    std::string run =
        "run ring.nc --control nct --tool 1=flat:4 --resolution 0.5 --out v " + std::string(more);
    if (!has(more, "--stock")) run += " --stock box:0,0,-10:20,20,0";
    const Outcome outcome = bench.run(run, without);
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "no threads may be started")) << outcome.err;
    EXPECT_FALSE(bench.exists("v"));
  }
}

TEST_F(Limits, FilesThatAProgramOpens) {
  const auto writer = [](int files) {
    return "#1=0\nWHILE[#1LT" + std::to_string(files) + "]DO1\n#1=#1+1\nFOPEN2 P#1\nDPRNT[X]\nFCLOS\nEND1\n" +
           std::string(kRing);
  };
  bench.write("many.nc", writer(100000));
  bench.write("some.nc", writer(1000));
  for (const std::string command :
       {"check many.nc --control nct", "path many.nc --control nct",
        "run many.nc --out out --control nct --stock box:0,0,-10:20,20,0 --tool 1=flat:4"}) {
    Outcome outcome;
    const double took = processorSecondsOf([&] { outcome = bench.run(command); });
    EXPECT_EQ(outcome.exit_code, 2) << command << outcome.err;
    EXPECT_TRUE(has(outcome.err, "many.nc:4:")) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "more than 1000 files")) << outcome.err;
    EXPECT_LT(took, 5.0);
  }
  EXPECT_EQ(bench.run("run some.nc --out out2 --no-render" + std::string(kRingOptions)).exit_code, 0);
  EXPECT_EQ(bench.files("out2/files").size(), 1000u);
}

std::string repeated(std::size_t count, const std::string& item) {
  std::string text;
  text.reserve(count * item.size());
  for (std::size_t k = 0; k < count; ++k) text += item;
  return text;
}

/// Of the largest program that was waited for so far, kB.
long peakOfChildren() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss;
}

TEST_F(Limits, ReadingIsHeldToTheMemoryOfTheRun) {
  constexpr long kMostKb = 300'000;
  const std::string options = std::string(kRingOptions) + "--no-render --out out --max-memory 0.2";
  bench.write("comment.nc", "(" + std::string(60'000'000, 'x') + ")\nM30\n");
  bench.write("words.nc", repeated(20'000'000, "X1") + "\nM30\n");
  bench.write("lines.nc", repeated(30'000'000, "\n") + "M30\n");
  bench.write("moves.nc",
              "G21 G90 G17 T1 M6\nS1000 M3\nG0 X5 Y5 Z5\n#1=0\nWHILE[#1LT4900000]DO1\n#1=#1+1\n"
              "X[#1/1000000]\nEND1\nM30\n");
  struct Case {
    std::string program;
    int exit_code;
    std::string told;
  };
  for (const Case& c :
       {Case{"comment.nc", 3, "--max-memory"}, Case{"words.nc", 2, "line 1 has 40000000 bytes"},
        Case{"lines.nc", 3, "--max-memory"}, Case{"moves.nc", 3, "--max-memory"}}) {
    Outcome outcome;
    const bool measured = !PROVEOUT_SANITIZED && peakOfChildren() <= kMostKb;
    const double took = processorSecondsOf([&] { outcome = bench.run("run " + c.program + options); });
    EXPECT_EQ(outcome.exit_code, c.exit_code) << c.program << outcome.err;
    EXPECT_TRUE(has(outcome.err, c.told)) << c.program << outcome.err;
    EXPECT_LT(outcome.err.size(), 2'000u) << c.program;
    if (!PROVEOUT_SANITIZED) {
      EXPECT_LT(took, 5.0) << c.program;
    }
    if (measured) {
      EXPECT_LE(peakOfChildren(), kMostKb) << c.program;
    }
  }
}

TEST_F(Limits, ManySetupsHoldThemselvesOnce) {
  bench.write("p.nc", "G21 G90\nG0 X5 Y5 Z5\nM30\n");
  std::string job =
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\n[stock]\nshape = \"box\"\nmin = [0, 0, -10]\n"
      "max = [10, 10, 0]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 6\n";
  for (int k = 0; k < 600; ++k) job += "[[setup]]\nprogram = \"p.nc\"\n";
  bench.write("job.toml", job);
  const bool measured = !PROVEOUT_SANITIZED && peakOfChildren() <= 250'000;
  const Outcome outcome = bench.run("run job.toml --no-render --out out --resolution 1 --max-memory 0.2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err.substr(0, 500);
  if (measured) {
    EXPECT_LE(peakOfChildren(), 250'000);
  }
}

/// Whichever limit is met is told by its name, and nothing is left half done.
TEST_F(Limits, TheLimitOfTheProcessIsNamed) {
  if (PROVEOUT_SANITIZED) GTEST_SKIP() << "sanitizers take more address space than there is";
  const std::string fine =
      "run ring.nc --control nct --tool 1=flat:4 --stock box:0,0,-10:200,200,0 --resolution 0.1 --no-render "
      "--threads 2 --out ";
  int named = 0;
  for (const char* limit : {"-v 300000", "-v 400000", "-v 600000", "-v 900000", "-d 200000"}) {
    const std::string out = "out" + std::to_string(named);
    const Outcome outcome = bench.run(fine + out, "ulimit " + std::string(limit) + " && timeout 100");
    if (outcome.exit_code == 0) {
      std::filesystem::remove_all(bench.path(out));
      continue;
    }
    EXPECT_EQ(outcome.exit_code, 3) << limit << outcome.err;
    EXPECT_TRUE(has(outcome.err, "ulimit " + std::string(limit, 2))) << limit << outcome.err;
    EXPECT_FALSE(bench.exists(out + "/report.json"));
    ++named;
  }
  EXPECT_GT(named, 2);
  const Outcome allowed = bench.run(fine + "out --max-memory 0.05");
  EXPECT_EQ(allowed.exit_code, 3);
  EXPECT_TRUE(has(allowed.err, "--max-memory") && !has(allowed.err, "ulimit")) << allowed.err;
}

}  // namespace
}  // namespace proveout::test
