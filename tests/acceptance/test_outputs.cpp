// Outputs that cannot be written: told before the run where that is known, and never at the cost of the
// others.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program_runner.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

/// A limit of 512 bytes a block on every file that the program writes.
std::string withFilesUpTo(int blocks) { return "ulimit -f " + std::to_string(blocks) + " && timeout 100"; }

nlohmann::json reportOf(const Workbench& bench) {
  return nlohmann::json::parse(readFile(bench.path("out/report.json")), nullptr, false);
}

/// The messages of the findings of kind "output".
std::string missing(const nlohmann::json& report) {
  std::string told;
  for (const auto& finding : report["findings"]) {
    if (finding["kind"] == "output") told += finding["message"].get<std::string>() + "\n";
  }
  return told;
}

class Outputs : public testing::Test {
 protected:
  Outputs() { bench.write("ring.nc", kRing); }
  Outcome run(const std::string& options, const std::string& before = "timeout 100") const {
    return bench.run("run ring.nc --out out" + std::string(kRingOptions) + options, before);
  }
  Workbench bench;
};

TEST_F(Outputs, AFolderInTheWayOfAMeshLeavesTheReport) {
  fs::create_directories(bench.path("out/ring.obj/below"));
  const Outcome outcome = run("--format stl,obj --view iso --csv");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "ring.obj")) << outcome.err;
  for (const char* name : {"ring.stl", "iso.png", "blocks.csv", "report.html", "junit.xml", "report.json"})
    EXPECT_TRUE(bench.exists(std::string("out/") + name)) << name;
  const auto report = reportOf(bench);
  EXPECT_TRUE(has(missing(report), "ring.obj"));
  EXPECT_FALSE(has(missing(report), ".proveout-")) << missing(report);
  ASSERT_EQ(report["outputs"]["meshes"].size(), 1u);
  EXPECT_EQ(report["outputs"]["meshes"][0]["path"], "ring.stl");
  EXPECT_EQ(report["verdict"], "fail");
  EXPECT_TRUE(has(readFile(bench.path("out/junit.xml")), "ring.obj"));
  EXPECT_TRUE(has(readFile(bench.path("out/report.html")), "ring.obj"));
}

TEST_F(Outputs, AFolderInTheWayOfAPictureOrATableLeavesTheOthers) {
  for (const char* name : {"iso.png", "blocks.csv", "mrr.svg", "report.html", "junit.xml"}) {
    const Workbench own;
    own.write("ring.nc", kRing);
    fs::create_directories(own.path("out/" + std::string(name)));
    const Outcome outcome = own.run("run ring.nc --out out --view iso --csv" + std::string(kRingOptions));
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_TRUE(has(outcome.err, name)) << outcome.err;
    EXPECT_TRUE(has(missing(reportOf(own)), name)) << name;
    EXPECT_TRUE(own.exists("out/ring.stl")) << name;
  }
}

TEST_F(Outputs, AFullDiskLeavesWhatFits) {
  // The mesh of a ring on a fine grid takes more than 200 KB, the report less.
  const Outcome outcome = bench.run(
      "run ring.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=ball:4 --resolution 0.1 --simplify 0 --out out "
      "--format stl,vdb --no-render",
      withFilesUpTo(400));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  const auto report = reportOf(bench);
  ASSERT_FALSE(report.is_discarded());
  EXPECT_TRUE(has(missing(report), "ring.stl")) << missing(report);
  EXPECT_TRUE(has(missing(report), "ring.vdb")) << missing(report);
  EXPECT_TRUE(report["outputs"]["meshes"].empty());
  EXPECT_FALSE(bench.exists("out/ring.stl"));
  EXPECT_FALSE(bench.exists("out/ring.vdb"));
  EXPECT_EQ(bench.files("out"), (std::set<std::string>{"report.html", "report.json", "junit.xml"}));
}

TEST_F(Outputs, OfAComparisonAreKeptToo) {
  bench.write("a.obj", boxObj(0, 0, 0, 10, 20, 30));
  fs::create_directories(bench.path("out/deviation.png"));
  const Outcome outcome = bench.run("compare a.obj a.obj --out out");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_TRUE(has(missing(reportOf(bench)), "deviation.png"));
}

TEST_F(Outputs, AFolderThatCannotBeWrittenIsToldBeforeTheRun) {
  bench.write("file", "x");
  bench.write("alarm.nc", "G21\nG777\n");  // the program is not looked at
  for (const char* out : {"file", "file/below", "/proc/nowhere"}) {
    const Outcome outcome = bench.run("run alarm.nc --out " + std::string(out) + kRingOptions);
    EXPECT_EQ(outcome.exit_code, 2) << out;
    EXPECT_FALSE(has(outcome.err, "G777")) << outcome.err;
  }
  EXPECT_EQ(readFile(bench.path("file")), "x");
}

/// The program without the folder that its module is in.
class WithoutModule : public Outputs {
 protected:
  WithoutModule() {
    fs::create_directories(bench.path("alone/bin"));
    fs::copy_file(bench.program, bench.path("alone/bin/proveout"));
    bench.program = bench.path("alone/bin/proveout");
    bench.write("block.obj", boxObj(0, 0, -10, 20, 20, 0));
    bench.write("alarm.nc", "G21\nG777\n");
  }
};

TEST_F(WithoutModule, WhatNeedsItIsToldBeforeTheRun) {
  const std::string grid = " --control nct --tool 1=flat:4 --resolution 0.5 --out out ";
  for (const char* needs : {"--stock box:0,0,-10:20,20,0 --format stl,vdb", "--stock mesh:block.obj"}) {
    const Outcome outcome = bench.run("run alarm.nc" + grid + needs);
    EXPECT_EQ(outcome.exit_code, 2) << needs;
    EXPECT_TRUE(has(outcome.err, "libproveout_vdb.so")) << outcome.err;
    EXPECT_FALSE(has(outcome.err, "G777")) << outcome.err;
    EXPECT_FALSE(bench.exists("out")) << needs;
  }
  EXPECT_EQ(bench.run("run ring.nc" + grid + "--stock box:0,0,-10:20,20,0 --no-render").exit_code, 0);
}

TEST_F(Outputs, SavedStocksAreTheSameInEveryRun) {
  std::string first;
  for (const char* threads : {"1", "1", "4"}) {
    ASSERT_EQ(run("--format vdb --no-render --threads " + std::string(threads)).exit_code, 0);
    const std::string bytes = readFile(bench.path("out/ring.vdb"));
    if (first.empty()) first = bytes;
    ASSERT_GT(bytes.size(), 1000u);
    EXPECT_TRUE(bytes == first) << threads;
  }
}

}  // namespace
}  // namespace proveout::test
