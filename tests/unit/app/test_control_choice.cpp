// Jobs that leave the control to the program.
#include <gtest/gtest.h>

#include "app/job_setup.h"
#include "app/session/run/control_choice.h"
#include "app/session/session.h"
#include "tests/support/temporary_folder.h"

namespace proveout {
namespace {

constexpr const char* kFanuc =
    "%\nO0001 (PART)\nG90 G54 G0 X10. Y5.\nT1 M6\nS1000 M3\nG43 Z10. H1\nG1 Z-1. F100.\nX50.\nG28 G91 "
    "Z0.\nM30\n%\n";
constexpr const char* kHaas =
    "%\nO00001\nG53 G0 Z0.\nT1 M6\nS1000 M3\nG0 G90 G54 X1. Y2.\nG43 Z10. H01\nM97 P100\nM30\nN100 G1 Z-1. "
    "F50.\n"
    "X20.\nM99\n%\n";
constexpr const char* kPlain = "G0 X1 Y2\nM30\n";

std::optional<Job> jobOf(const test::TemporaryFolder& folder, const std::string& program,
                         const std::string& control, std::string* said = nullptr) {
  folder.write("a.nc", program);
  RunOptions options;
  options.program.input = folder.write(
      "a.toml", "schema = \"proveout.job/1\"\nprogram = \"a.nc\"\n" + control +
                    "\n[stock]\nshape = \"box\"\nmin = [0, 0, -10]\nmax = [60, 60, 0]\n[[tool]]\nnumber = 1\n"
                    "type = \"flat\"\ndiameter = 6\n");
  Diagnostics diagnostics;
  auto job = setUpJob(options.program, diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    if (said != nullptr) *said += d.message + "\n";
  }
  return job;
}

TEST(ControlChoice, TakesTheControlThatTheProgramTells) {
  const test::TemporaryFolder folder;
  const auto job = jobOf(folder, kFanuc, "");
  ASSERT_TRUE(job);
  EXPECT_EQ(job->control, "fanuc-mill");
  EXPECT_FALSE(job->settings.parameters.contains("flavour"));
  EXPECT_NE(job->control_note.find("taken for a program of fanuc-mill: "), std::string::npos)
      << job->control_note;
  ASSERT_TRUE(choiceNote(*job));
  EXPECT_EQ(choiceNote(*job)->severity, Severity::kNote);
}

TEST(ControlChoice, SetsTheFlavourWhereTheJobDoesNot) {
  const test::TemporaryFolder folder;
  const auto told =
      jobOf(folder, kHaas, "[control]\nname = \"auto\"\n[control.fanuc]\ndecimal = \"increment\"\n");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->control, "fanuc-mill");
  EXPECT_EQ(told->settings.parameters.at("flavour"), 1);
  EXPECT_EQ(told->settings.parameters.at("decimal"), 1);
  const auto given = jobOf(folder, kHaas, "[control.fanuc]\nflavour = \"fanuc\"\n");
  ASSERT_TRUE(given);
  EXPECT_EQ(given->settings.parameters.at("flavour"), 0);
}

TEST(ControlChoice, RefusesAProgramThatTellsNothing) {
  const test::TemporaryFolder folder;
  std::string said;
  EXPECT_FALSE(jobOf(folder, kPlain, "", &said));
  EXPECT_NE(said.find("name the control: --control NAME"), std::string::npos) << said;
  EXPECT_TRUE(jobOf(folder, kPlain, "control = \"nct\""));
}

TEST(ControlChoice, LooksAtEachSetupAlone) {
  const test::TemporaryFolder folder;
  folder.write("one.nc", kFanuc);
  folder.write("two.ngc", "o<s> sub\ng1 x#1 f100\no<s> endsub\nt1 m6\no<s> call [1]\nm2\n");
  RunOptions options;
  options.program.input = folder.write(
      "a.toml",
      "schema = \"proveout.job/1\"\n[stock]\nshape = \"box\"\nmin = [0, 0, -10]\nmax = [60, 60, "
      "0]\n[[tool]]\n"
      "number = 1\ntype = \"flat\"\ndiameter = 6\n[[setup]]\nname = \"a\"\nprogram = \"one.nc\"\n[[setup]]\n"
      "name = \"b\"\nprogram = \"two.ngc\"\n");
  Diagnostics diagnostics;
  const auto job = setUpJob(options.program, diagnostics);
  ASSERT_TRUE(job) << (diagnostics.all().empty() ? "" : diagnostics.all().front().message);
  EXPECT_EQ(jobOfSetup(*job, 0).control, "fanuc-mill");
  EXPECT_EQ(jobOfSetup(*job, 1).control, "linuxcnc");
  EXPECT_NE(jobOfSetup(*job, 1).control_note.find("O-words"), std::string::npos);
}

TEST(ControlChoice, ARunFromMemoryTellsTheControlToo) {
  Job job;
  job.control = kAutoControl;
  job.stock = BoxShape{Vec3(0, 0, -10), Vec3(60, 60, 0)};
  Tool tool;
  tool.number = 1;
  tool.diameter = 6;
  job.tools = {tool};
  job.simulation.resolution_mm = 1.0;
  const MemoryProgramSource source("part.nc", kFanuc);
  Progress progress;
  const Result<RunResult> run = runJob(job, std::vector<const ProgramSource*>{&source}, progress);
  ASSERT_TRUE(run.ok()) << run.error().message;
  const auto& diagnostics = run->setups.front().interpreted.path.diagnostics.all();
  ASSERT_FALSE(diagnostics.empty());
  EXPECT_EQ(diagnostics.front().code, "control");
  EXPECT_EQ(run->setups.front().job.control, "fanuc-mill");
  const MemoryProgramSource plain("part.nc", kPlain);
  EXPECT_FALSE(runJob(job, std::vector<const ProgramSource*>{&plain}, progress).ok());
}

TEST(ControlChoice, SaysWhatAProgramLooksLikeThatWentWrong) {
  Job job;
  job.control = "nct";
  const ProgramText haas{"part.nc", "part.nc", kHaas};
  const auto note = otherControlNote(job, haas);
  ASSERT_TRUE(note);
  EXPECT_NE(note->message.find("looks like a program of fanuc-mill (flavour haas)"), std::string::npos);
  EXPECT_NE(note->message.find("the job runs it on nct"), std::string::npos) << note->message;
  job.control = "fanuc-mill";
  EXPECT_TRUE(otherControlNote(job, haas)) << "of another flavour";
  job.settings.parameters["flavour"] = 1;
  EXPECT_FALSE(otherControlNote(job, haas));
  EXPECT_FALSE(otherControlNote(job, ProgramText{"part.nc", "part.nc", kPlain}));
}

}  // namespace
}  // namespace proveout
