// From program to part on disk: one table of time, memory, triangles and error. Every case is a run of the
// real program as a child process, so that start-up and writing count and each has its own peak memory.
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/child_process.h"
#include "tests/bench/generated_programs.h"
#include "tests/bench/workplace.h"

namespace proveout::bench {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string name, file;                  ///< of the table's line, and of the program
  std::function<std::string()> text = {};  ///< makes the program; empty: it is one of the shared programs
  std::string stock = {}, tool = {};       ///< options of `proveout run`
  double grid_mm = 0.0;
  std::optional<double> exact_mm3 = {};   ///< of the part
  bool heavy = false;                     ///< run on request only
  std::string job_file = {};              ///< where there is a job in place of stock and tool
  std::function<std::string()> job = {};  ///< makes it
  bool picture = false;                   ///< drawn, too
  std::string simplify = {};              ///< value of --simplify, mm; empty: as by default
};

struct Options {
  bool all = false;
  std::string filter;    ///< part of the names of the cases to run
  double limit_s = 300;  ///< per case
};

constexpr const char* kShared = PROVEOUT_SHARED_PROGRAMS;
constexpr const char* kShaft = PROVEOUT_PARTS "/wl4_shaft";

std::vector<Case> samplePrograms() {
  const Case bear{.name = "bear", .file = "bear.nc", .stock = "box:0,0,-20:80,80,0", .tool = "1=ball:3.175"};
  const Case flower{.name = "flower_mold",
                    .file = "flower_mold.nc",
                    .stock = "box:-3.92956,-3.92829,-9.95121:61.0796,61.0529,0",
                    .tool = "1=flat:1"};
  const Case diamond{.name = "circle_diamond",
                     .file = "circle_diamond_square.gcode",
                     .stock = "box:-60,-60,-10:60,60,0",
                     .tool = "1=flat:3"};
  std::vector<Case> cases;
  const auto add = [&](Case c, double grid, bool heavy) {
    c.grid_mm = grid;
    c.heavy = heavy;
    cases.push_back(std::move(c));
  };
  add(bear, 0.25, false);
  add(bear, 0.1, false);
  add(bear, 0.05, true);
  add(flower, 0.25, false);
  for (Case c : {bear, flower}) {  // beside the default, a tenth of the grid
    c.name += ", all triangles";
    c.simplify = "0";
    add(c, 0.25, false);
  }
  add(flower, 0.05, true);
  add(diamond, 0.25, false);
  return cases;
}

std::vector<Case> generatedCases() {
  std::vector<Case> cases;
  cases.push_back({.name = "slot 100x50x20",
                   .file = "slot.nc",
                   .text = slotProgram,
                   .stock = "box:0,0,-20:100,50,0",
                   .tool = "1=flat:10",
                   .grid_mm = 0.1,
                   .exact_mm3 = 95000.0});
  cases.push_back({.name = "pocket 50x40x10",
                   .file = "pocket.nc",
                   .text = pocketProgram,
                   .stock = "box:0,0,-10:50,40,0",
                   .tool = "1=flat:10",
                   .grid_mm = 0.25,
                   .exact_mm3 = 20000.0 - 5.0 * (1200.0 - (4.0 - std::numbers::pi) * 25.0)});
  for (const int lines : {250, 500, 1000}) {
    constexpr int kMovesALine = 2000;
    cases.push_back({.name = fmt::format("finishing {}k moves", lines * kMovesALine / 1000),
                     .file = fmt::format("finishing{}.nc", lines),
                     .text = [lines] { return finishingProgram(lines, kMovesALine); },
                     .stock = "box:0,0,-20:200,200,0",
                     .tool = "1=ball:6",
                     .grid_mm = 0.1,
                     .heavy = lines == 1000});
  }
  return cases;
}

/// The turned sample: without its thread, where there is no grid and the mesh follows the job's profile
/// resolution, and whole on a grid.
std::vector<Case> turnedCases() {
  const auto program = [] { return readFile(std::string(kShaft) + "/shaft.nc"); };
  const auto job = [](const std::string& file) {
    return [file] { return shaftJob(readFile(std::string(kShaft) + "/job.toml"), file); };
  };
  return {{.name = "shaft profile",
           .file = "profile.nc",
           .text = [program] { return shaftWithoutThread(program()); },
           .grid_mm = 0.01,
           .exact_mm3 = shaftVolumeWithoutThread(),
           .job_file = "profile.toml",
           .job = job("profile.nc")},
          {.name = "shaft",
           .file = "shaft.nc",
           .text = program,
           .grid_mm = 0.05,
           .exact_mm3 = 87338.98,  // parts/make_nominals.py: the thread's sections added up
           .job_file = "shaft.toml",
           .job = job("shaft.nc")},
          {.name = "20000 short lines",
           .file = "lines.nc",
           .text = shortLinesProgram,
           .grid_mm = 0.01,
           .job_file = "lines.toml",
           .job = [] { return shortLinesJob("lines.nc"); }},
          {.name = "thread of 400 turns",
           .file = "turns.nc",
           .text = longThreadProgram,
           .grid_mm = 0.2,
           .job_file = "turns.toml",
           .job = [] { return threadJob("turns.nc", 420); }},
          {.name = "30 thread passes",
           .file = "passes.nc",
           .text = manyPassesProgram,
           .grid_mm = 0.1,
           .job_file = "passes.toml",
           .job = [] { return threadJob("passes.nc", 60); }},
          {.name = "worm, with a picture",
           .file = "worm.pmc",
           .text = wormProgram,
           .grid_mm = 0.1,
           .job_file = "worm.toml",
           .job = [] { return wormJob("worm.pmc"); },
           .picture = true}};
}

/// Contours of a wire, whole processes: 20,000 blocks in a plate of 60 mm, upright as an exact section (aim:
/// 0.3 s and 100 MB) and leaning by two degrees (aim: 2 s).
std::vector<Case> wireCases() {
  constexpr int kBlocks = 20000;
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, double lean_deg) {
    Case c{.name = name, .file = name + ".nc", .text = [lean_deg] {
             return gearProgram(kBlocks, 2.5, lean_deg);
           }};
    c.grid_mm = 0.1;
    c.job_file = name + ".toml";
    c.job = [file = c.file] { return gearJob(file); };
    cases.push_back(std::move(c));
  };
  add("wire gear", 0.0);
  add("wire gear, leaning", 2.0);
  return cases;
}

/// Removal time of each case that ran, for the lines below the table.
using RemovalTimes = std::map<std::string, double>;

/// Of the part, without what is parted from it, mm3.
double partVolume(const nlohmann::json& stock) {
  for (const nlohmann::json& body : stock.at("bodies")) {
    if (body.at("role") == "part") return body.at("volume_mm3");
  }
  return stock.at("final_mm3");
}

void printReport(const Case& c, const nlohmann::json& report, const ChildOutcome& child,
                 RemovalTimes& removal) {
  const nlohmann::json &time = report.at("performance"), &stock = report.at("stock");
  const double volume = partVolume(stock);
  removal[c.name] = time.at("remove_s");
  fmt::print("{:<26} {:>5.2f} {:>8} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.0f} {:>9} {:>12.3f}", c.name,
             c.grid_mm, report.at("program").at("motions").get<std::size_t>(), removal[c.name],
             time.at("mesh_s").get<double>(), child.wall_s, child.cpu_s, child.peak_mb,
             stock.at("triangles").get<std::size_t>(), volume);
  if (c.exact_mm3) fmt::print(" {:>9.1e}", volume / *c.exact_mm3 - 1.0);
  fmt::print("\n");
}

void runCase(const Case& c, const Options& options, const Workplace& work, RemovalTimes& removal) {
  const std::string program = c.text ? work.path(c.file) : std::string(kShared) + "/" + c.file;
  if (c.text && !fs::exists(program)) work.write(c.file, c.text());
  const std::string out = work.path("out");
  std::vector<std::string> arguments{programPath(), "run"};
  if (c.job) {
    arguments.push_back(work.write(c.job_file, c.job()));
  } else {
    arguments.insert(arguments.end(), {program, "--control", "nct", "--stock", c.stock, "--tool", c.tool});
  }
  arguments.insert(arguments.end(),
                   {"--resolution", fmt::format("{}", c.grid_mm), "--format", "stl", "--out", out});
  if (!c.picture) arguments.emplace_back("--no-render");
  if (!c.simplify.empty()) arguments.insert(arguments.end(), {"--simplify", c.simplify});
  const ChildOutcome child = runChild(arguments, work.path("errors"), options.limit_s);
  const std::string report = readFile(out + "/report.json");
  if (child.ended && child.exit_code <= 1 && !report.empty()) {
    printReport(c, nlohmann::json::parse(report), child, removal);
  } else if (!child.ended) {
    fmt::print("{:<26} {:>5.2f} stopped after {:.0f} s, at {:.0f} MB\n", c.name, c.grid_mm, child.wall_s,
               child.peak_mb);
  } else {
    const std::string said = readFile(work.path("errors"));
    fmt::print("{:<26} {:>5.2f} ended with code {}: {}\n", c.name, c.grid_mm, child.exit_code,
               said.substr(0, said.find('\n')));
  }
  std::error_code ignored;
  fs::remove_all(out, ignored);
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
  const std::string text = repeatedProgram(readFile(std::string(kShared) + "/bear.nc"), kBlocks);
  const auto blocks = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
  const std::string program = work.write("long.nc", text), empty = work.write("empty.nc", "M30\n");
  for (const char* command : {"check", "path"}) {
    const auto run = [&](const std::string& file) {
      return runChild({programPath(), command, file, "--control", "nct"}, work.path("errors"),
                      options.limit_s);
    };
    const ChildOutcome idle = run(empty), child = run(program);
    if (!child.ended || child.exit_code > 1) {
      fmt::print("interpreter, {}: did not end well (code {})\n", command, child.exit_code);
      continue;
    }
    const double net = child.wall_s - idle.wall_s;
    fmt::print("{:<26}       {:>8.0f} blocks {:.3f} s, cpu {:.3f} s, {:.0f} MB: {:.2f} million blocks/s\n",
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
  fmt::print("{:<26}       {:>8.0f} blocks {:.3f} s, cpu {:.3f} s, {:.0f} MB: {:.2f} million blocks/s\n",
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
  const bool shared = fs::exists(std::string(kShared) + "/bear.nc");
  if (!shared) fmt::print("the sample programs are not beside this checkout: their cases are left out\n");
  std::vector<Case> cases = shared ? samplePrograms() : std::vector<Case>{};
  for (Case& c : generatedCases()) cases.push_back(std::move(c));
  for (Case& c : turnedCases()) cases.push_back(std::move(c));
  for (Case& c : wireCases()) cases.push_back(std::move(c));
  fmt::print("{:<26} {:>5} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>12} {:>9}\n", "case", "grid",
             "motions", "remove s", "mesh s", "whole s", "cpu s", "peak MB", "triangles", "part mm3",
             "error");
  std::fflush(stdout);
  RemovalTimes removal;
  int left_out = 0;
  for (const Case& c : cases) {
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

int main(int argc, char** argv) {
  proveout::bench::Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--all") {
      options.all = true;
    } else if (word == "--limit" && i + 1 < argc) {
      options.limit_s = std::atof(argv[++i]);
    } else if (word == "--only" && i + 1 < argc) {
      options.filter = argv[++i];
    } else {
      fmt::print(stderr, "usage: {} [--all] [--only PART-OF-NAME] [--limit SECONDS-A-CASE]\n", argv[0]);
      return 2;
    }
  }
  if (!(options.limit_s > 0)) {
    fmt::print(stderr, "--limit needs a number of seconds above 0\n");
    return 2;
  }
  return proveout::bench::run(options);
}
