// Wrong input of lathe jobs: a clear message, the right exit code, no crash, no hang.
#include <gtest/gtest.h>

#include "program_runner.h"

namespace proveout::test {
namespace {

const std::string kCylinder = "shape = \"cylinder\"\nbase = [0, 0, -50]\ndiameter = 40\nlength = 51\n";
const std::string kNose = "nose_radius = 0.4\n";
const std::string kStart = "rapid = 10000\n";
const std::string kControl = "wl4-lathe";

/// A bar of 40, a turning insert, a drill of 10 and a blade for parting.
std::string job() {
  return "schema = \"proveout.job/1\"\nname = \"part\"\nprogram = \"part.nc\"\n[control]\nname = \"" +
         kControl + "\"\n[machine]\n" + kStart + "[stock]\n" + kCylinder +
         "[[tool]]\nnumber = 1\ntype = \"insert\"\n" + kNose +
         "orientation = 3\ninsert_angle = 55\nlead_angle = 93\nedge_length = 11\n"
         "[[tool]]\nnumber = 2\ntype = \"drill\"\ndiameter = 10\n"
         "[[tool]]\nnumber = 5\ntype = \"insert\"\nshape = \"groove\"\nwidth = 3\nnose_radius = "
         "0.1\norientation = 3\n"
         "edge_length = 30\n[simulation]\nresolution = 0.5\n[output]\nviews = []\n";
}

std::string jobWith(const std::string& old, const std::string& now) {
  std::string text = job();
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::runtime_error("the job has no " + old);
  return text.replace(at, old.size(), now);
}

std::string program(const std::string& body, int tool = 1) {
  return "%T\nG54 G90 G95\nT" + std::to_string(tool) + " M6\nG97 S1000 M3\n" + body + "M5\nM2\n%\n";
}

const std::string kCut = "G0 X36 Z5\nG1 Z-20 F0.2\nX44\nG0 Z5\n";
const std::string kThread = "G0 X38 Z5\nG33 Z-40 F2\nG0 X50\n";

std::string partedToPieces() {
  std::string body = "G0 X50 Z1\n";
  for (int z = -2; z > -54; z -= 2) body += "G0 Z" + std::to_string(z) + "\nG1 X-2 F0.1\nG0 X50\n";
  return program(body, 5);
}

struct Turning {
  const char* name;
  std::string job, program, options;
  int exit_code;
  std::string message;  ///< part of stderr
};
void PrintTo(const Turning& run, std::ostream* out) { *out << run.name; }

class BadTurning : public testing::TestWithParam<Turning> {};

TEST_P(BadTurning, IsToldClearly) {
  const Turning& bad = GetParam();
  const Workbench bench;
  bench.write("part.nc", bad.program);
  bench.write("job.toml", bad.job);
  const Outcome outcome = bench.run("run job.toml --out out " + bad.options);
  EXPECT_EQ(outcome.exit_code, bad.exit_code) << outcome.err;
  EXPECT_TRUE(has(outcome.err, bad.message)) << outcome.err;
  EXPECT_EQ(outcome.out.find("pass"), std::string::npos);
  EXPECT_EQ(bench.exists("out/part.stl"), bad.exit_code == 1);
}

const Turning kTurnings[] = {
    {"box", jobWith(kCylinder, "shape = \"box\"\nmin = [-20, -20, -50]\nmax = [20, 20, 1]\n"), program(kCut),
     "", 2, "cylinder or a tube about Z"},
    {"bar_along_x", jobWith(kCylinder, kCylinder + "axis = \"x\"\n"), program(kCut), "", 2,
     "cylinder or a tube about Z"},
    {"bar_off_the_axis", jobWith("base = [0, 0", "base = [0.1, 0"), program(kCut), "", 2, "X0 Y0"},
    {"start_inside", jobWith(kStart, "start = [5, 0, -10]\n"), program(kCut), "", 2, "inside the blank"},
    {"start_off_the_plane", jobWith(kStart, "start = [50, 5, 10]\n"), program(kCut), "", 2, "Y5"},
    {"jaw_not_round",
     jobWith("[simulation]",
             "[[fixture]]\nname = \"jaw\"\nshape = \"box\"\nmin = [20, -5, -50]\nmax = [30, 5, "
             "-40]\n[simulation]"),
     program(kCut), "", 2, "'jaw'"},
    {"nose_missing", jobWith(kNose, ""), program(kCut), "", 2, "nose_radius"},
    {"nose_not_finite", jobWith(kNose, "nose_radius = nan\n"), program(kCut), "", 2, "nose_radius"},
    {"insert_that_mills", jobWith(kControl, "wl4-mill"), program(kCut), "", 2, "lathe insert"},
    {"tool_not_defined", job(), program(kCut, 9), "", 2, "tool 9 is not defined"},
    {"spindle_emptied", job(), program(kCut, 0), "", 2, "emptied"},
    {"out_of_the_plane", job(), program("G0 X50 Z5\nG1 Y5 X36 F0.1\n"), "", 2, "part.nc:6:"},
    {"arc_across_the_plane", job(), program("G0 X50 Z5\nG17\nG2 X36 Y0 R20 F0.1\n"), "", 2, "part.nc:7:"},
    {"pitch_of_nothing", job(), program("G0 X38 Z5\nG33 Z-40 F0.001\nG0 X50\n"), "", 2, "turns"},
    {"pitch_of_a_slip", job(), program("G0 X38 Z5\nG33 Z-40 F0.0001\nG0 X50\n"), "", 2, "turns"},
    {"until_never", job(), program(kCut), "--until N99", 2, "not reached"},
    {"grid_too_fine", job(), program(kThread), "--resolution 0.001 --format vdb", 3, "would fit"},
    {"memory_too_small", job(), program(kThread), "--resolution 0.05 --max-memory 0.1 --format vdb", 3,
     "100 MB are allowed"},
    {"drill_off_the_axis", job(), program("G0 X10 Z5\nG1 Z-20 F0.1\nG0 Z5\n", 2), "", 1,
     "error[axis_crossing]"},
    {"beyond_the_axis", job(), program("G0 X50 Z5\nG0 X-36\nG1 Z-20 F0.1\nX-50\nG0 Z5\nX50\n"), "", 1,
     "error[axis_crossing]"},
    {"rapid_into_the_bar", job(), program("G0 X36 Z5\nG0 Z-20\nG0 X50\n"), "", 1, "error[rapid_contact]"},
    {"contour_too_steep", job(), program("G0 X44 Z-5\nG1 X30 Z-9 F0.1\nG0 X50\n"), "", 1,
     "error[insert_contact]"},
    {"nothing_left", job(), partedToPieces(), "", 1, "error[no_part]"},
};

INSTANTIATE_TEST_SUITE_P(Run, BadTurning, testing::ValuesIn(kTurnings),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BadTurning, AThreadThatIsCutAwayLeavesNoPart) {
  const Workbench bench;
  std::string body = kThread + "T5 M6\n";
  for (int z = -53; z < 3; z += 2) body += "G0 X50 Z" + std::to_string(z) + "\nG1 X-2 F0.1\nG0 X50\n";
  bench.write("part.nc", program(body));
  bench.write("job.toml", job());
  const Outcome outcome = bench.run("run job.toml --out out --csv --format stl,vdb");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "error[no_part]")) << outcome.err;
}

TEST(BadTurning, StopsWithoutFilesWhenInterrupted) {
  const Workbench bench;
  bench.write("part.nc", program(kThread));
  bench.write("job.toml", job());
  const Outcome outcome = bench.run("run job.toml --out out --resolution 0.02 --max-memory 100 --format vdb",
                                    "timeout --preserve-status --kill-after=60 --signal=INT 1");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_TRUE(bench.files("out").empty());
}

}  // namespace
}  // namespace proveout::test
