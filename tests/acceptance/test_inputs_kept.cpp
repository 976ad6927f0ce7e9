// What a command reads is never written over, whatever way leads to it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "program_runner.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJob =
    "schema = \"proveout.job/1\"\nname = \"part\"\ncontrol = \"nct\"\nprogram = \"ring.nc\"\n"
    "subprograms = [\"subs\"]\n[machine]\nfile = \"machine.toml\"\n[stock]\nshape = \"box\"\nmin = [0, 0, "
    "-10]\n"
    "max = [20, 20, 0]\n[nominal]\nmesh = \"part.obj\"\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 4\n"
    "[simulation]\nresolution = 1\n[output]\nformats = [\"obj\"]\nviews = []\n";

class InputsKept : public testing::Test {
 protected:
  InputsKept() {
    bench.write("ring.nc", kRing);
    bench.write("machine.toml", "rapid = 15000\n");
    bench.write("job.toml", kJob);
    bench.write("part.obj", boxObj(0, 0, -10, 20, 20, 0));
    bench.write("subs/O0007.nc", "G4 P0\nM99\n");
  }
  /// Runs and expects a refusal that names both, and every file as it was.
  void refused(const std::string& arguments, const std::string& output, const std::string& input) const {
    const auto before = contents();
    const Outcome outcome = bench.run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_TRUE(has(outcome.err, output)) << outcome.err;
    EXPECT_TRUE(has(outcome.err, input)) << outcome.err;
    EXPECT_TRUE(has(outcome.err, "would be written over")) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    EXPECT_TRUE(contents() == before) << arguments;
  }
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(bench.path())) {
      const std::string name = entry.path().filename().string();
      if (name != ".out" && name != ".err")
        all[entry.path().string()] = entry.is_regular_file() ? readFile(entry.path().string()) : "";
    }
    return all;
  }
  Workbench bench;
};

TEST_F(InputsKept, TheNominalBesideTheJob) {
  // Twice, since once the part stood in its place the second run would compare the part with itself.
  for (int k = 0; k < 2; ++k) refused("run job.toml --out .", "part.obj", "the nominal");
  EXPECT_EQ(bench.run("run job.toml --out results").exit_code, 1);
}

TEST_F(InputsKept, WhateverWayLeadsToThem) {
  fs::create_directory_symlink(".", bench.path("link"));
  fs::create_directory(bench.path("deep"));
  fs::create_directory(bench.path("other"));
  fs::create_hard_link(bench.path("part.obj"), bench.path("other/part.obj"));
  fs::create_directory(bench.path("third"));
  fs::create_symlink("../part.obj", bench.path("third/part.obj"));
  for (const char* out : {"link", "deep/..", "not/yet/../..", "link/link/./deep/..", "other", "third"})
    refused("run job.toml --out " + std::string(out), "part.obj", "the nominal");
}

TEST_F(InputsKept, ALinkThatIsTheInput) {
  fs::rename(bench.path("part.obj"), bench.path("cad.obj"));
  fs::create_symlink("cad.obj", bench.path("part.obj"));
  refused("run job.toml --out .", "part.obj", "the nominal");
}

TEST_F(InputsKept, SpellingsThatTheNextRunWouldTakeForTheInput) {
  fs::rename(bench.path("part.obj"), bench.path("PART.obj"));
  std::string job = kJob;
  job.replace(job.find("part.obj"), 8, "PART.obj");
  bench.write("job.toml", job);
  refused("run job.toml --out .", "part.obj", "PART.obj");
}

TEST_F(InputsKept, ProgramsJobsBlanksAndFixtures) {
  const std::string tool = " --tool 1=flat:4 --resolution 1 --control nct --out . ";
  bench.write("report.json", kRing);
  refused("run report.json --stock box:0,0,-10:20,20,0" + tool, "report.json", "the program");
  bench.write("ring.obj", boxObj(0, 0, -10, 20, 20, 0));
  refused("run ring.nc --format obj --stock mesh:ring.obj" + tool, "ring.obj", "the stock");
  ASSERT_EQ(bench.run("run ring.nc --no-render --format vdb --stock box:0,0,-10:20,20,0" + tool).exit_code,
            0);
  refused("run ring.nc --format vdb --stock vdb:ring.vdb" + tool, "ring.vdb", "the stock");
  fs::rename(bench.path("job.toml"), bench.path("junit.toml"));
  fs::remove(bench.path("junit.xml"));
  fs::create_symlink("junit.toml", bench.path("junit.xml"));
  refused("run junit.toml --out .", "junit.xml", "the job");
  fs::remove(bench.path("junit.xml"));
  fs::create_symlink("machine.toml", bench.path("junit.xml"));
  refused("run junit.toml --out .", "junit.xml", "the machine");
  fs::remove(bench.path("junit.xml"));
  std::string job = kJob;
  bench.write("clamp.obj", boxObj(-20, 0, -10, -10, 5, 0));
  job.replace(job.find("part.obj"), 8, "ring.obj");
  bench.write("clamped.toml", job + "[[fixture]]\nname = \"clamp\"\nmesh = \"clamp.obj\"\n");
  fs::remove(bench.path("part.obj"));
  fs::create_hard_link(bench.path("clamp.obj"), bench.path("part.obj"));
  refused("run clamped.toml --out .", "part.obj", "the fixture");
}

TEST_F(InputsKept, SubprogramsThatAreCalled) {
  bench.write("caller.nc", std::string("M98 P7\n") + kRing);
  fs::create_directory(bench.path("out"));
  fs::create_hard_link(bench.path("subs/O0007.nc"), bench.path("out/report.html"));
  const std::string options = " --subprograms subs --out out" + std::string(kRingOptions);
  refused("run caller.nc" + options, "out/report.html", "the subprogram");
  // A subprogram that nobody calls is no input.
  EXPECT_EQ(bench.run("run ring.nc --no-render" + options).exit_code, 0);
}

TEST_F(InputsKept, FilesThatAProgramWrites) {
  bench.write("files/O0012.nc", "G4 P0\nM99\n");
  bench.write("writer.nc", "M98 P12\nFOPEN2 P12\nDPRNT[HELLO]\nFCLOS\n" + std::string(kRing));
  const std::string options = " --subprograms files" + std::string(kRingOptions);
  refused("run writer.nc --out ." + options, "files/O0012.nc", "the subprogram");
  EXPECT_EQ(bench.run("run writer.nc --no-render --out out" + options).exit_code, 0);
  EXPECT_TRUE(bench.exists("out/files/O0012.nc"));
}

TEST_F(InputsKept, OfComparisons) {
  bench.write("a.obj", boxObj(0, 0, -10, 20, 20, 0));
  for (const char* name : {"report.json", "report.html", "junit.xml", "deviation.png"}) {
    fs::create_hard_link(bench.path("a.obj"), bench.path(name));
    refused("compare a.obj part.obj --out .", name, "the machined mesh");
    refused("compare part.obj a.obj --out .", name, "the nominal");
    fs::remove(bench.path(name));
  }
  EXPECT_EQ(bench.run("compare a.obj part.obj --size 160x120 --out .").exit_code, 0);
}

TEST_F(InputsKept, OfPictures) {
  fs::create_symlink("part.obj", bench.path("a.png"));
  refused("render part.obj -o a.png", "a.png", "the mesh");
  fs::remove(bench.path("a.png"));
  bench.write("other.obj", boxObj(0, 0, -10, 20, 20, 1));
  ASSERT_EQ(bench.run("compare part.obj other.obj --size 160x120 --out out").exit_code, 1);
  fs::create_hard_link(bench.path("out/report.json"), bench.path("b.png"));
  refused("render part.obj --heatmap out/report.json -o b.png", "b.png", "the report");
  fs::create_hard_link(bench.path("other.obj"), bench.path("c.png"));
  refused("render part.obj --heatmap out/report.json -o c.png", "c.png", "the nominal");
}

TEST_F(InputsKept, StandardOutputThatGoesIntoAnInput) {
  for (const std::string command : {"path ring.nc --control nct", "check ring.nc --control nct",
                                    "path ring.nc --control nct --format csv"}) {
    const std::string before = readFile(bench.path("ring.nc"));
    const Outcome outcome = bench.runInto(">ring.nc", command);  // ">>": appended
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_TRUE(has(outcome.err, "standard output: would be written over the program")) << outcome.err;
    EXPECT_EQ(readFile(bench.path("ring.nc")), before);
  }
}

TEST_F(InputsKept, EveryFileOfARunIsLookedAtBeforehand) {
  // Whatever a run writes: an input under that name stops it before the program is looked at.
  std::string job = kJob;
  job.replace(job.find("[\"obj\"]"), 7, "[\"stl\", \"stl-ascii\", \"obj\", \"ply\", \"vdb\"]");
  job.replace(job.find("views = []"), 10, "views = [\"iso\", \"top\"]\ncsv = true");
  bench.write("all.toml", job);
  ASSERT_EQ(bench.run("run all.toml --size 160x120 --out all").exit_code, 1);
  const std::set<std::string> names = bench.files("all");
  ASSERT_GE(names.size(), 13u);
  bench.write("ring.nc", "G21\nG777\n");
  for (const std::string& name : names) {
    fs::create_directory(bench.path("one"));
    fs::create_hard_link(bench.path("part.obj"), bench.path("one/" + name));
    refused("run all.toml --out one", name, "the nominal");
    fs::remove_all(bench.path("one"));
  }
}

}  // namespace
}  // namespace proveout::test
