// What `proveout run` predicts of itself beside what it takes, over jobs of many kinds: memory and
// time are to be within 1.5 times, both ways. Ends with 1 where it is not. With --runs the fastest of some
// counts: on a machine that others use.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/child_process.h"
#include "tests/bench/prediction_jobs.h"
#include "tests/bench/workplace.h"

namespace proveout::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kMemoryFactor = 1.5, kTimeFactor = 1.5, kFarFactor = 2.0;
/// A run that takes less than this is over before anybody asks how long it takes.
constexpr double kShortS = 0.25;
constexpr double kLimitS = 300.0;

struct Outcome {
  double memory = 1.0, time = 1.0;  ///< taken over predicted
  bool ran = false;
};

double off(double ratio) { return std::max(ratio, 1.0 / ratio); }

Outcome printLine(const PredictedJob& job, const nlohmann::json& report, const ChildOutcome& child) {
  const nlohmann::json& performance = report.at("performance");
  const auto figure = [&](const char* name) { return performance.at(name).get<double>(); };
  // The report counts MB of 1e6 bytes, the child MiB.
  const double taken_mb = child.peak_mb * 1.048576;
  Outcome outcome{taken_mb / figure("predicted_memory_mb"),
                  std::max(child.wall_s, kShortS) / std::max(figure("predicted_s"), kShortS), true};
  fmt::print("{:<32} {:>9.0f} {:>9.0f} {:>7.2f}{} {:>9.2f} {:>9.2f} {:>9.2f} {:>7.2f}{}\n", job.name,
             figure("predicted_memory_mb"), taken_mb, outcome.memory,
             off(outcome.memory) > kMemoryFactor ? '!' : ' ', figure("predicted_s"), child.wall_s,
             child.cpu_s, outcome.time, off(outcome.time) > kTimeFactor ? '!' : ' ');
  return outcome;
}

Outcome runJob(const PredictedJob& job, int runs, const std::string& threads) {
  const Workplace work;
  for (const auto& [name, text] : job.files) work.write(name, text());
  const auto started = [&](const std::vector<std::string>& words, const std::string& out,
                           const std::string& name = "run") {
    std::vector<std::string> command{programPath(), name};
    command.insert(command.end(), words.begin(), words.end());
    command.insert(command.end(), {"--out", out});
    if (!threads.empty()) command.insert(command.end(), {"--threads", threads});
    return runChild(command, work.path("errors"), kLimitS);
  };
  const fs::path home = fs::current_path();
  fs::current_path(work.path("."));
  if (!job.before.empty()) started(job.before, "before");
  ChildOutcome child = started(job.run, "out", job.command);
  for (int i = 1; i < runs; ++i) {
    const ChildOutcome again = started(job.run, "out", job.command);
    if (again.wall_s < child.wall_s) child = again;
  }
  fs::current_path(home);
  const std::string report = readFile(work.path("out/report.json"));
  Outcome outcome;
  if (child.ended && child.exit_code <= 1 && !report.empty()) {
    outcome = printLine(job, nlohmann::json::parse(report), child);
  } else {
    const std::string said = readFile(work.path("errors"));
    fmt::print("{:<32} ended with code {} after {:.1f} s: {}\n", job.name, child.exit_code, child.wall_s,
               said.substr(0, said.find('\n')));
  }
  std::fflush(stdout);
  return outcome;
}

/// How many of some jobs are off.
struct Count {
  int jobs = 0, failed = 0, memory = 0, time = 0, far = 0;  ///< far: in time, by more than kFarFactor
  Outcome worst;

  void add(const Outcome& outcome) {
    ++jobs;
    if (!outcome.ran) ++failed;
    if (off(outcome.memory) > kMemoryFactor) ++memory;
    if (off(outcome.time) > kTimeFactor) ++time;
    if (off(outcome.time) > kFarFactor) ++far;
    worst.memory = std::max(worst.memory, off(outcome.memory));
    worst.time = std::max(worst.time, off(outcome.time));
  }
  void print(const char* which) const {
    fmt::print(
        "{} {}: memory off by at most {:.2f}, more than {:g} in {}; time off by at most {:.2f}, more than "
        "{:g} "
        "in {}, more than {:g} in {}; {} did not run\n",
        jobs, which, worst.memory, kMemoryFactor, memory, worst.time, kTimeFactor, time, kFarFactor, far,
        failed);
  }
};

int run(const std::string& filter, int runs, const std::string& threads) {
  const std::string shared = PROVEOUT_SHARED_PROGRAMS;
  const bool there = fs::exists(shared + "/bear.nc");
  if (!there) fmt::print("the sample programs are not beside this checkout: their jobs are left out\n");
  fmt::print("{:<32} {:>9} {:>9} {:>8} {:>9} {:>9} {:>9} {:>8}\n", "job", "MB said", "MB", "ratio", "s said",
             "s", "cpu s", "ratio");
  Count fitted, held_out;
  for (const PredictedJob& job : predictedJobs(there ? shared : "", PROVEOUT_PARTS)) {
    if (job.name.find(filter) == std::string::npos) continue;
    (job.held_out ? held_out : fitted).add(runJob(job, runs, threads));
  }
  fitted.print("jobs");
  held_out.print("held out, to which nothing was fitted");
  return fitted.memory + fitted.time + fitted.failed + held_out.failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace proveout::bench

int main(int argc, char** argv) {
  std::string filter, threads;
  int runs = 1;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    if (i + 1 == argc || (name != "--only" && name != "--runs" && name != "--threads")) {
      fmt::print(stderr, "usage: {} [--only PART-OF-NAME] [--runs N] [--threads N]\n", argv[0]);
      return 2;
    }
    if (name == "--only") filter = argv[i + 1];
    if (name == "--threads") threads = argv[i + 1];
    if (name == "--runs") runs = std::max(1, std::atoi(argv[i + 1]));
  }
  return proveout::bench::run(filter, runs, threads);
}
