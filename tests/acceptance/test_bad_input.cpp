// Every class of bad input: a clear message, the right exit code, no result file, no crash, no hang.
#include <gtest/gtest.h>

#include <cstring>

#include "program_runner.h"

namespace proveout::test {
namespace {

struct BadRun {
  const char* name;
  std::string program;    ///< text of part.nc
  std::string arguments;  ///< after `run`
  int exit_code;
  std::string message;  ///< part of stderr
};

void PrintTo(const BadRun& run, std::ostream* out) { *out << run.name; }

const std::string kOk = kRing;
std::string with(const std::string& more) { return std::string("part.nc") + kRingOptions + more; }

constexpr const char* kEndlessJob =
    "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"part.nc\"\n[stock]\nshape = \"box\"\n"
    "min = [0, 0, -10]\nmax = [20, 20, 0]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 4\n"
    "[simulation]\nmax_blocks = 1000\n";

class BadInput : public testing::TestWithParam<BadRun> {};

TEST_P(BadInput, IsRefusedClearly) {
  const BadRun& bad = GetParam();
  const Workbench bench;
  bench.write("part.nc", bad.program);
  bench.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  bench.write("cut.stl", std::string(80, ' ') + std::string("\x10\0\0\0short", 9));
  std::string nan_stl(84 + 50, '\0');
  nan_stl[80] = 1;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&nan_stl[96], &nan, sizeof nan);
  bench.write("nan.stl", nan_stl);
  bench.write("wrong.toml", "schema = \"proveout.job/1\"\nprogrm = \"part.nc\"\n");
  bench.write("O0002.nc", "G4 P0\nM99\n");
  bench.write("O0001.nc", "M98 P1\nM99\n");
  bench.write("endless.toml", kEndlessJob);
  bench.write("file", "");
  const Outcome outcome = bench.run("run " + bad.arguments);
  EXPECT_EQ(outcome.exit_code, bad.exit_code) << outcome.err;
  EXPECT_TRUE(has(outcome.err, bad.message)) << outcome.err;
  EXPECT_EQ(outcome.out.find("pass"), std::string::npos);
  EXPECT_FALSE(bench.exists("part-out/part.stl"));
}

const BadRun kBadRuns[] = {
    {"emptied_spindle", "G90 G21\nT1 M6\nM3 S1000\nG0 Z5\nG0 X5 Y5\nT0 M6\nG1 Z-1 F100\nM30\n", with(""), 2,
     "emptied by T0 M6"},
    {"missing_program", kOk, std::string("none.nc") + kRingOptions, 2, "none.nc"},
    {"folder_as_program", kOk, std::string("/tmp") + kRingOptions, 2, "/tmp"},
    {"device_as_program", kOk, std::string("/dev/zero") + kRingOptions, 2, "/dev/zero"},
    {"binary_program",
     std::string("\x7f"
                 "ELF\0\1\2\0\0",
                 9),
     with(""), 2, "part.nc"},
    {"unknown_code", "G21\nG1 X1 F1\nG777\nM30\n", with(""), 2, "part.nc:3:"},
    {"unknown_word", "G21\nG0 X1\nQWERTY\n", with(""), 2, "part.nc:3:"},
    {"number_not_finite", "G21\nG0 Xnan\nM30\n", with(""), 2, "part.nc:2:"},
    {"missing_subprogram", "G21\nM98 P4711\nM30\n", with(""), 2, "4711"},
    {"endless_recursion", "G21\nM98 P1\nM30\n", with(""), 2, "O0001.nc"},
    {"endless_calls", "G21\nM98 P2 L99999999\nM30\n", "endless.toml", 2, "blocks"},
    {"tool_not_defined", "G21 G90 T7 M6\nS1 M3\nG0 X1 Y1 Z5\nG1 Z-1 F100\nM30\n", with(""), 2,
     "tool 7 is not defined"},
    {"no_control", kOk, "part.nc --stock box:0,0,0:1,1,1 --tool 1=flat:1", 2, "--control"},
    {"unknown_control", kOk, "part.nc --control siemens --stock box:0,0,0:1,1,1 --tool 1=flat:1", 2, "nct"},
    {"no_stock", kOk, "part.nc --control nct --tool 1=flat:1", 2, "--stock"},
    {"empty_stock", kOk, "part.nc --control nct --stock box:0,0,0:0,1,1 --tool 1=flat:1", 2, "--stock"},
    {"stock_mesh_open", kOk, "part.nc --control nct --stock mesh:open.obj --tool 1=flat:1 --resolution 0.1",
     2, "open.obj"},
    {"stock_mesh_missing", kOk, "part.nc --control nct --stock mesh:none.stl --tool 1=flat:1", 2, "none.stl"},
    {"stock_vdb_wrong", kOk, "part.nc --control nct --stock vdb:part.nc --tool 1=flat:1", 2, "part.nc"},
    {"no_tool", kOk, "part.nc --control nct --stock box:0,0,0:1,1,1", 2, "tool"},
    {"bad_tool", kOk, "part.nc --control nct --stock box:0,0,0:1,1,1 --tool 1=flat:-3", 2, "--tool"},
    {"hair_thin_tool", kOk, "part.nc --control nct --stock box:0,0,0:1,1,1 --tool 1=flat:1e-300", 2,
     "0.001 mm"},
    {"grid_coarser_than_blank", kOk,
     "part.nc --control nct --stock box:0,0,-10:20,20,0 --tool 1=flat:4 --resolution 100", 2, "too coarse"},
    {"open_nominal", kOk, with("--nominal open.obj"), 2, "open.obj"},
    {"truncated_nominal", kOk, with("--nominal cut.stl"), 2, "cut.stl"},
    {"nan_nominal", kOk, with("--nominal nan.stl"), 2, "nan.stl"},
    {"nominal_of_unknown_kind", kOk, with("--nominal part.nc"), 2, "part.nc"},
    {"bad_view", kOk, with("--view sideways"), 2, "sideways"},
    {"bad_format", kOk, with("--format step"), 2, "step"},
    {"bad_option", kOk, with("--fast"), 2, "--fast"},
    {"bad_number", kOk, with("--threads x"), 2, "--threads"},
    {"bad_until", kOk, with("--until never"), 2, "--until"},
    {"job_missing", kOk, "none.toml", 2, "none.toml"},
    {"job_unknown_key", kOk, "wrong.toml", 2, "progrm"},
    {"out_is_a_file", kOk, with("--out file --no-render"), 2, "file"},
    {"out_not_writable", kOk, with("--out /proc/x --no-render"), 2, "/proc/x"},
    {"grid_too_fine", kOk,
     "part.nc --control nct --stock box:0,0,-10:2000,2000,0 --tool 1=flat:4 --resolution 0.01 --max-memory "
     "0.2",
     3, "resolution"},
};

INSTANTIATE_TEST_SUITE_P(Run, BadInput, testing::ValuesIn(kBadRuns),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BadInput, AFullDeviceIsNoticed) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  for (const std::string command :
       {"path ring.nc --control nct", "check ring.nc --control nct", "coverage"}) {
    const Outcome outcome = bench.runInto("/dev/full", command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_TRUE(has(outcome.err, "standard output")) << command;
  }
}

TEST(BadInput, AlarmsDoNotDestroyEarlierMeshes) {
  const Workbench bench;
  bench.write("part.nc", "G21\nG777\n");
  bench.write("part-out/part.stl", "earlier");
  EXPECT_EQ(bench.run("run " + with("")).exit_code, 2);
  EXPECT_EQ(readFile(bench.path("part-out/part.stl")), "earlier");
}

/// A level that does not exist would be taken for the widest one without a word.
TEST(BadInput, SimdLevelsThatThereAreNot) {
  const Workbench bench;
  bench.write("ring.nc", kRing);
  const std::string run = "run ring.nc --no-render --out out" + std::string(kRingOptions);
  for (const char* level : {"garbage", "AVX2", " avx2", "avx1024"}) {
    const Outcome outcome = bench.run(run, "timeout 100 env PROVEOUT_SIMD='" + std::string(level) + "'");
    EXPECT_EQ(outcome.exit_code, 2) << level;
    EXPECT_TRUE(has(outcome.err, "PROVEOUT_SIMD is '" + std::string(level)) && has(outcome.err, "baseline"))
        << outcome.err;
    EXPECT_FALSE(bench.exists("out"));
  }
  for (const char* level : {"baseline", ""})
    EXPECT_EQ(bench.run(run, "timeout 100 env PROVEOUT_SIMD=" + std::string(level)).exit_code, 0) << level;
  const Outcome explained = bench.run("explain out --at 5,5,-2", "timeout 100 env PROVEOUT_SIMD=garbage");
  EXPECT_EQ(explained.exit_code, 2);
  EXPECT_TRUE(has(explained.err, "PROVEOUT_SIMD")) << explained.err;
}

}  // namespace
}  // namespace proveout::test
