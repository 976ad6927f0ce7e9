// From program to part on disk: one table of time, memory, triangles and error. Every case is a run of the
// real program as a child process, so that start-up and writing count and each has its own peak memory. With
// --against another build of the program runs in turn with this one; figures are medians of --times runs.
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/bench_cases.h"
#include "tests/bench/child_process.h"
#include "tests/bench/generated_programs.h"
#include "tests/bench/workplace.h"

namespace proveout::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
  bool all = false;
  std::string filter;    ///< part of the names of the cases to run
  double limit_s = 300;  ///< per run
  std::string against;   ///< another build of the program; empty: none
  int times = 1;         ///< runs of each case, of each program
};

/// Removal time of each case that ran, for the lines below the table.
using RemovalTimes = std::map<std::string, double>;

/// Of the part, without what is parted from it, mm3.
double partVolume(const nlohmann::json& stock) {
  for (const nlohmann::json& body : stock.at("bodies")) {
    if (body.at("role") == "part") return body.at("volume_mm3");
  }
  return stock.at("final_mm3");
}

/// The runs of a case by one program.
struct Runs {
  std::vector<double> remove_s, mesh_s, wall_s, cpu_s, peak_mb;
  nlohmann::json report;  ///< of the last
  std::string failure;    ///< of the first that did not end well; empty: none
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::vector<std::string> argumentsOf(const Case& c, const Workplace& work) {
  std::vector<std::string> arguments{"run"};
  if (!c.job_file.empty()) {
    arguments.push_back(c.job ? work.write(c.job_file, c.job()) : c.job_file);
  } else {
    const std::string program = c.text ? work.path(c.file) : sharedFolder() + "/" + c.file;
    arguments.insert(arguments.end(), {program, "--control", "nct", "--stock", c.stock, "--tool", c.tool});
  }
  arguments.insert(arguments.end(), {"--resolution", fmt::format("{}", c.grid_mm), "--format", "stl", "--out",
                                     work.path("out")});
  if (!c.picture) arguments.emplace_back("--no-render");
  if (!c.simplify.empty()) arguments.insert(arguments.end(), {"--simplify", c.simplify});
  return arguments;
}

void runOnce(const std::string& program, const Case& c, const Options& options, const Workplace& work,
             Runs& runs) {
  if (!runs.failure.empty()) return;
  std::vector<std::string> command = argumentsOf(c, work);
  command.insert(command.begin(), program);
  const ChildOutcome child = runChild(command, work.path("errors"), options.limit_s);
  const std::string report = readFile(work.path("out/report.json"));
  if (child.ended && child.exit_code <= 1 && !report.empty()) {
    runs.report = nlohmann::json::parse(report);
    const nlohmann::json& time = runs.report.at("performance");
    runs.remove_s.push_back(time.at("remove_s"));
    runs.mesh_s.push_back(time.at("mesh_s"));
    runs.wall_s.push_back(child.wall_s);
    runs.cpu_s.push_back(child.cpu_s);
    runs.peak_mb.push_back(child.peak_mb);
  } else if (!child.ended) {
    runs.failure = fmt::format("stopped after {:.0f} s, at {:.0f} MB", child.wall_s, child.peak_mb);
  } else {
    const std::string said = readFile(work.path("errors"));
    runs.failure = fmt::format("ended with code {}: {}", child.exit_code, said.substr(0, said.find('\n')));
  }
  std::error_code ignored;
  fs::remove_all(work.path("out"), ignored);
}

void printRuns(const std::string& name, const Case& c, const Runs& runs) {
  fmt::print("{:<30} {:>5.2f} ", name, c.grid_mm);
  if (!runs.failure.empty()) {
    fmt::print("{}\n", runs.failure);
    return;
  }
  const nlohmann::json& stock = runs.report.at("stock");
  const double volume = partVolume(stock);
  fmt::print("{:>8} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.0f} {:>9} {:>12.3f}",
             runs.report.at("program").at("motions").get<std::size_t>(), median(runs.remove_s),
             median(runs.mesh_s), median(runs.wall_s), median(runs.cpu_s), median(runs.peak_mb),
             stock.at("triangles").get<std::size_t>(), volume);
  if (c.exact_mm3) fmt::print(" {:>9.1e}", volume / *c.exact_mm3 - 1.0);
  fmt::print("\n");
}

/// What runs in turn took, as a share of what the other program took: medians of the pairs.
void printRatios(const Runs& before, const Runs& now) {
  if (!before.failure.empty() || !now.failure.empty()) return;
  const auto ratio = [](const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < a.size(); ++k) ratios.push_back(a[k] / std::max(b[k], 1e-6));
    return median(ratios);
  };
  fmt::print("{:<30} cpu x {:.3f}, mesh x {:.3f}, peak memory x {:.3f}\n", "  now to before",
             ratio(now.cpu_s, before.cpu_s), ratio(now.mesh_s, before.mesh_s),
             ratio(now.peak_mb, before.peak_mb));
}

void runCase(const Case& c, const Options& options, const Workplace& work, RemovalTimes& removal) {
  if (c.text && !fs::exists(work.path(c.file))) work.write(c.file, c.text());
  Runs before, now;
  for (int time = 0; time < options.times; ++time) {
    if (!options.against.empty()) runOnce(options.against, c, options, work, before);
    runOnce(programPath(), c, options, work, now);
  }
  printRuns(c.name, c, now);
  if (!options.against.empty()) {
    printRuns("  before", c, before);
    printRatios(before, now);
  }
  if (now.failure.empty()) removal[c.name] = median(now.remove_s);
  std::fflush(stdout);
}

void printDoubling(const RemovalTimes& removal) {
  for (const auto& [fewer, more] : {std::pair{"finishing 500k moves", "finishing 1000k moves"},
                                    std::pair{"finishing 1000k moves", "finishing 2000k moves"}}) {
    const auto a = removal.find(fewer), b = removal.find(more);
    if (a == removal.end() || b == removal.end()) continue;
    fmt::print("{} -> {}: removal time x {:.2f}\n", fewer, more, b->second / a->second);
  }
}

/// Blocks a second of the commands that interpret alone, less the time that they take for an empty program.
void printInterpreterRate(const Workplace& work, const Options& options) {
  constexpr int kBlocks = 1'000'000;
  const std::string text = repeatedProgram(readFile(sharedFolder() + "/bear.nc"), kBlocks);
  const auto blocks = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
  const std::string program = work.write("long.nc", text), empty = work.write("empty.nc", "M30\n");
  struct Asked {
    const char *command, *control;
  };
  for (const Asked asked :
       {Asked{"check", "nct"}, {"path", "nct"}, {"check", "fanuc-mill"}, {"check", "linuxcnc"}}) {
    const std::string command = fmt::format("{} {}", asked.command, asked.control);
    const auto run = [&](const std::string& file) {
      return runChild({programPath(), asked.command, file, "--control", asked.control}, work.path("errors"),
                      options.limit_s);
    };
    const ChildOutcome idle = run(empty), child = run(program);
    if (!child.ended || child.exit_code > 1) {
      fmt::print("interpreter, {}: did not end well (code {})\n", command, child.exit_code);
      continue;
    }
    const double net = child.wall_s - idle.wall_s;
    fmt::print("{:<30}       {:>8.0f} blocks {:.3f} s, cpu {:.3f} s, {:.0f} MB: {:.2f} million blocks/s\n",
               fmt::format("interpreter, {}", command), blocks, child.wall_s, child.cpu_s, child.peak_mb,
               blocks / net * 1e-6);
  }
}

/// Macro blocks a second in a loop with arithmetic, less the time of an empty program. More than 5 million
/// blocks without a motion would be refused as an endless loop.
void printMacroRate(const Workplace& work, const Options& options) {
  constexpr int kPasses = 900'000, kBlocksAPass = 5;
  const auto run = [&](const std::string& file) {
    return runChild({programPath(), "check", file, "--control", "nct"}, work.path("errors"), options.limit_s);
  };
  const ChildOutcome idle = run(work.write("empty.nc", "M30\n"));
  const ChildOutcome child = run(work.write("loop.nc", macroLoopProgram(kPasses)));
  if (!child.ended || child.exit_code > 1) {
    fmt::print("macro loop: did not end well (code {})\n", child.exit_code);
    return;
  }
  constexpr double kBlocks = double{kPasses} * kBlocksAPass;
  fmt::print("{:<30}       {:>8.0f} blocks {:.3f} s, cpu {:.3f} s, {:.0f} MB: {:.2f} million blocks/s\n",
             "interpreter, macros", kBlocks, child.wall_s, child.cpu_s, child.peak_mb,
             kBlocks / (child.cpu_s - idle.cpu_s) * 1e-6);
}

void printStart(const Workplace& work) {
  ChildOutcome best;
  for (int i = 0; i < 5; ++i) {
    const ChildOutcome child = runChild({programPath(), "--version"}, work.path("errors"), 10);
    if (i == 0 || child.wall_s < best.wall_s) best = child;
  }
  double load[1] = {0.0};
  getloadavg(load, 1);
  fmt::print("{} cores, load {:.1f}; the program starts in {:.0f} ms and {:.0f} MB\n",
             sysconf(_SC_NPROCESSORS_ONLN), load[0], best.wall_s * 1e3, best.peak_mb);
}

int run(const Options& options) {
  const Workplace work;
  if (!fs::exists(programPath())) {
    fmt::print(stderr, "{}: build the program first\n", programPath());
    return 1;
  }
  printStart(work);
  const bool shared = fs::exists(sharedFolder() + "/bear.nc");
  if (!shared) fmt::print("the sample programs are not beside this checkout: their cases are left out\n");
  fmt::print("{:<30} {:>5} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>12} {:>9}\n", "case", "grid",
             "motions", "remove s", "mesh s", "whole s", "cpu s", "peak MB", "triangles", "part mm3",
             "error");
  std::fflush(stdout);
  RemovalTimes removal;
  int left_out = 0;
  for (const Case& c : allCases()) {
    const bool asked = c.name.find(options.filter) != std::string::npos;
    if (asked && c.heavy && !options.all) ++left_out;
    if (asked && (!c.heavy || options.all)) runCase(c, options, work, removal);
  }
  printDoubling(removal);
  if (shared && std::string_view("interpreter").find(options.filter) != std::string_view::npos)
    printInterpreterRate(work, options);
  if (std::string_view("interpreter macros").find(options.filter) != std::string_view::npos)
    printMacroRate(work, options);
  if (left_out > 0) fmt::print("{} heavy cases left out: --all runs them\n", left_out);
  return 0;
}

}  // namespace
}  // namespace proveout::bench

namespace {

constexpr const char* kUsage =
    "usage: {} [--all] [--only PART-OF-NAME] [--limit SECONDS-A-RUN] [--against PROGRAM] [--times RUNS]\n";

/// False: they are wrong, and it was said how.
bool readOptions(int argc, char** argv, proveout::bench::Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--all") {
      options.all = true;
    } else if (word == "--limit" && has_value) {
      options.limit_s = std::atof(argv[++i]);
    } else if (word == "--only" && has_value) {
      options.filter = argv[++i];
    } else if (word == "--against" && has_value) {
      options.against = argv[++i];
    } else if (word == "--times" && has_value) {
      options.times = std::atoi(argv[++i]);
    } else {
      fmt::print(stderr, kUsage, argv[0]);
      return false;
    }
  }
  if (!(options.limit_s > 0) || options.times < 1) {
    fmt::print(stderr, "--limit needs a number of seconds above 0, --times a number of runs\n");
    return false;
  }
  if (!options.against.empty() && !std::filesystem::exists(options.against)) {
    fmt::print(stderr, "{}: there is no such program\n", options.against);
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  proveout::bench::Options options;
  return readOptions(argc, argv, options) ? proveout::bench::run(options) : 2;
}
