#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/cli_options.h"
#include "app/exit_codes.h"

namespace proveout {
namespace {

template <typename Options>
Options parsed(const std::vector<std::string>& arguments) {
  const CommandLine line = parseCommandLine(arguments);
  EXPECT_TRUE(line.command.has_value()) << line.errors;
  if (!line.command || !std::holds_alternative<Options>(*line.command)) {
    ADD_FAILURE() << "another command was meant";
    return {};
  }
  return std::get<Options>(*line.command);
}

TEST(CommandLine, RunTakesEveryOption) {
  const auto o = parsed<RunOptions>(
      {"run",           "a.nc",     "--control",    "nct",      "--stock",     "box:0,0,-1:2,3,0",
       "--tool",        "1=flat:3", "--tool",       "2=ball:4", "--nominal",   "n.stl",
       "--out",         "o",        "--resolution", "0.25",     "--tolerance", "0.01",
       "--threads",     "2",        "--max-memory", "1.5",      "--until",     "N70",
       "--format",      "stl,obj",  "--view",       "iso",      "--view",      "top",
       "--size",        "64x48",    "--json",       "--quiet",  "--lenient",   "--progress",
       "--subprograms", "subs",     "--max-time",   "2.5",      "--simplify",  "0"});
  EXPECT_EQ(o.program.input, "a.nc");
  EXPECT_EQ(o.program.control, "nct");
  EXPECT_EQ(o.program.until, "N70");
  EXPECT_EQ(o.program.subprograms, std::vector<std::string>{"subs"});
  EXPECT_TRUE(o.program.lenient);
  EXPECT_EQ(o.tools, (std::vector<std::string>{"1=flat:3", "2=ball:4"}));
  EXPECT_EQ(o.stock, "box:0,0,-1:2,3,0");
  EXPECT_DOUBLE_EQ(*o.resolution_mm, 0.25);
  EXPECT_DOUBLE_EQ(*o.tolerance_mm, 0.01);
  EXPECT_EQ(o.simplify_mm, 0.0);
  EXPECT_DOUBLE_EQ(*o.max_memory_gb, 1.5);
  EXPECT_DOUBLE_EQ(*o.program.max_time_s, 2.5);
  EXPECT_EQ(o.threads, 2);
  EXPECT_EQ(o.views, (std::vector<std::string>{"iso", "top"}));
  EXPECT_TRUE(o.json && o.quiet && o.progress);
  EXPECT_FALSE(o.no_render);
}

TEST(CommandLine, WhatIsEnteredAndAccepted) {
  const std::vector<std::string> words = {"run",       "a.nc",      "--control", "nct",      "--offset",
                                          "G55=1,2,3", "--offset",  "D1=5",      "--skip",   "--program-unit",
                                          "inch",      "--machine", "m.toml",    "--select", "gouge,excess",
                                          "--ignore",  "partial"};
  std::vector<std::string> all = words;
  all.insert(all.end(), {"--baseline", "known.json", "--write-baseline", "new.json"});
  const auto o = parsed<RunOptions>(all);
  EXPECT_EQ(o.program.offsets, (std::vector<std::string>{"G55=1,2,3", "D1=5"}));
  EXPECT_TRUE(o.program.skip);
  EXPECT_EQ(o.program.program_unit, "inch");
  EXPECT_EQ(o.program.machine, "m.toml");
  EXPECT_EQ(o.select, std::vector<std::string>{"gouge,excess"});
  EXPECT_EQ(o.ignore, std::vector<std::string>{"partial"});
  EXPECT_EQ(o.baseline, "known.json");
  EXPECT_EQ(o.write_baseline, "new.json");
  EXPECT_EQ(decidingArguments(o), words) << "a baseline decides no finding";
  EXPECT_EQ(parsed<CheckOptions>({"check", "a.nc", "--offset", "D1=5"}).program.offsets.size(), 1u);
  EXPECT_EQ(parsed<PathOptions>({"path", "--offset", "D1=5", "a.nc"}).program.input, "a.nc");
  EXPECT_EQ(parseCommandLine({"run", "a.nc", "--program-unit", "m"}).exit_code, kExitInput);
}

TEST(CommandLine, ToolDoesNotSwallowThePositional) {
  const auto o = parsed<RunOptions>({"run", "--tool", "1=flat:3", "a.nc"});
  EXPECT_EQ(o.program.input, "a.nc");
  EXPECT_EQ(o.tools.size(), 1u);
}

TEST(CommandLine, OtherCommands) {
  EXPECT_EQ(parsed<CheckOptions>({"check", "a.nc", "--max-time", "3"}).program.max_time_s, 3.0);
  EXPECT_EQ(parsed<RenderCommandOptions>({"render", "a.stl", "--max-time", "3"}).max_time_s, 3.0);
  EXPECT_EQ(parsed<CompareCommandOptions>({"compare", "a.stl", "b.stl", "--max-time", "3"}).max_time_s, 3.0);
  EXPECT_EQ(parsed<ExplainOptions>({"explain", "out", "--at", "0,0,0", "--max-time", "3"}).max_time_s, 3.0);
  EXPECT_FALSE(parsed<PathOptions>({"path", "a.nc"}).program.max_time_s);
  EXPECT_EQ(parsed<PathOptions>({"path", "a.nc", "--control", "nct", "--format", "csv"}).format, "csv");
  EXPECT_TRUE(parsed<CheckOptions>({"check", "job.toml", "--json"}).json);
  const auto compare = parsed<CompareCommandOptions>({"compare", "a.stl", "b.stl", "--gouge", "0.1"});
  EXPECT_EQ(compare.nominal, "b.stl");
  EXPECT_DOUBLE_EQ(compare.gouge_mm, 0.1);
  EXPECT_DOUBLE_EQ(compare.excess_mm, 0.05);
  EXPECT_EQ(compare.align, "none");
  EXPECT_FALSE(compare.scan);
  const auto scan = parsed<CompareCommandOptions>({"compare", "a.stl", "b.ply", "--scan", "--scan-reach",
                                                   "0.5", "--align", "fit", "--align-limit", "0.2"});
  EXPECT_TRUE(scan.scan);
  EXPECT_EQ(scan.scan_reach_mm, 0.5);
  EXPECT_EQ(scan.align, "fit");
  EXPECT_EQ(scan.align_limit_mm, 0.2);
  const auto datums =
      parsed<CompareCommandOptions>({"compare", "a.stl", "b.step", "--align", "datums", "--datum", "1,2,3",
                                     "--datum", "4,5,6", "--datum", "7,8,-9"});
  EXPECT_EQ(datums.datums, (std::vector<std::string>{"1,2,3", "4,5,6", "7,8,-9"}));
  const auto render = parsed<RenderCommandOptions>({"render", "a.stl", "-o", "a.png", "--view", "top"});
  EXPECT_EQ(render.output, "a.png");
  EXPECT_EQ(render.view, "top");
  EXPECT_EQ(parsed<CoverageOptions>({"coverage", "--control", "nct"}).control, "nct");
}

TEST(CommandLine, BadUsageIsExitTwoWithAMessage) {
  const std::vector<std::vector<std::string>> bad = {
      {},
      {"mill"},
      {"run"},
      {"run", ""},
      {"run", "a", "b"},
      {"run", "a", "--resolution", "0"},
      {"run", "a", "--simplify", "-0.1"},
      {"run", "a", "--simplify", "11"},
      {"run", "a", "--resolution", "-0.1"},
      {"run", "a", "--resolution", "nan"},
      {"run", "a", "--resolution", "inf"},
      {"run", "a", "--resolution", "0.1mm"},
      {"run", "a", "--resolution", "1e300"},
      {"run", "a", "--threads", "0"},
      {"run", "a", "--threads", "99999999999"},
      {"run", "a", "--threads", "two"},
      {"run", "a", "--max-memory", "-1"},
      {"run", "a", "--no-such"},
      {"run", "a", "--out"},
      {"run", "a", "--out", ""},
      {"path", "a", "--format", "xml"},
      {"compare", "a.stl"},
      {"compare", "a.stl", "b.stl", "--gouge", "0"},
      {"compare", "a.stl", "b.stl", "--align", "best"},
      {"compare", "a.stl", "b.stl", "--align", "fit", "--align-limit", "0"},
      {"compare", "a.stl", "b.stl", "--scan-reach", "1"},
      {"render"},
      {"coverage", "extra"},
  };
  for (const auto& arguments : bad) {
    const CommandLine line = parseCommandLine(arguments);
    const std::string shown = arguments.empty() ? "" : arguments.front() + " ... " + arguments.back();
    EXPECT_FALSE(line.command.has_value()) << shown;
    EXPECT_EQ(line.exit_code, kExitInput) << shown;
    EXPECT_FALSE(line.errors.empty()) << shown;
    EXPECT_TRUE(line.output.empty()) << shown;
  }
}

TEST(CommandLine, VersionAndHelpGoToStdout) {
  const CommandLine version = parseCommandLine({"--version"});
  EXPECT_EQ(version.exit_code, kExitOk);
  EXPECT_EQ(version.output.rfind("proveout ", 0), 0u);
  EXPECT_EQ(parseCommandLine({"--help"}).exit_code, kExitOk);
}

// The help texts as files: a change shows in review. PROVEOUT_UPDATE_GOLDEN=1 writes them anew.
TEST(CommandLine, HelpIsAsRecorded) {
  for (const std::string command :
       {"", "run", "explain", "path", "check", "template", "compare", "render", "coverage"}) {
    std::vector<std::string> arguments{"--help"};
    if (!command.empty()) arguments.insert(arguments.begin(), command);
    const std::string help = parseCommandLine(arguments).output;
    const std::string file = std::string(PROVEOUT_SOURCE_DIR) + "/tests/unit/app/golden/help" +
                             (command.empty() ? "" : "_" + command) + ".txt";
    if (std::getenv("PROVEOUT_UPDATE_GOLDEN") != nullptr) std::ofstream(file) << help;
    std::stringstream recorded;
    recorded << std::ifstream(file).rdbuf();
    EXPECT_EQ(help, recorded.str()) << file;
  }
}

TEST(CommandLine, WordsThatAReportKeepsMeanTheSame) {
  const std::vector<std::vector<std::string>> commands = {
      {"run", "a.nc", "--control", "nct", "--stock", "box:0,0,-1:2,3,0", "--tool", "1=flat:3", "--lenient"},
      {"run", "--resolution", "0.25", "--", "-a.nc"},
      {"run", "--", "--tool"},
      {"run", "--until=-5", "--setup=--lenient", "-"},
  };
  for (const std::vector<std::string>& words : commands) {
    const auto options = parsed<RunOptions>(words);
    const auto again = parsed<RunOptions>(decidingArguments(options));
    EXPECT_EQ(again.program.input, options.program.input);
    EXPECT_EQ(again.program.until, options.program.until);
    EXPECT_EQ(again.program.setup, options.program.setup);
    EXPECT_EQ(again.program.lenient, options.program.lenient);
    EXPECT_EQ(again.stock, options.stock);
    EXPECT_EQ(again.tools, options.tools);
    EXPECT_EQ(again.resolution_mm, options.resolution_mm);
  }
}

TEST(ExitCodes, FollowTheContract) {
  EXPECT_EQ(exitCodeOf(ErrorKind::kInput), 2);
  EXPECT_EQ(exitCodeOf(ErrorKind::kInternal), 2);
  EXPECT_EQ(exitCodeOf(ErrorKind::kResourceLimit), 3);
  EXPECT_EQ(exitCodeOf(ErrorKind::kInterrupted), 130);
  EXPECT_EQ(exitCodeOf(Verdict::kPass), 0);
  EXPECT_EQ(exitCodeOf(Verdict::kFail), 1);
  EXPECT_EQ(exitCodeOf(Verdict::kError), 2);
}

}  // namespace
}  // namespace proveout
