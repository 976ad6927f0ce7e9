#include "tests/soak/case_runner.h"

#include <nlohmann/json.hpp>

#include "app/job_setup.h"

namespace proveout::soak {

CaseRunner::CaseRunner(const SoakCase& made) : made_(made) {
  for (const auto& [name, text] : made.files) bench_.write(name, text);
  if (!made.files.contains("before.toml")) return;
  bench_.write("before.vdb", "");  // the job must find it
  const Result<RunResult> before = run("before.toml");
  if (!before) {
    before_ = before.error();
  } else if (!before->stock) {
    before_ = Error{ErrorKind::kInput, "no stock is left that could be saved"};
  } else if (const Status saved = before->stock->save(bench_.path("before.vdb")); !saved) {
    before_ = saved.error();
  }
}

Job CaseRunner::load(const std::string& job, std::string& error) const {
  ProgramOptions options;
  options.input = bench_.path(job);
  Diagnostics diagnostics;
  std::optional<Job> loaded = setUpJob(options, diagnostics);
  if (loaded) return std::move(*loaded);
  for (const Diagnostic& d : diagnostics.all()) error += d.message + "; ";
  return {};
}

Result<RunResult> CaseRunner::run(const std::string& job, const RunOptions& options) {
  if (before_) return *before_;
  std::string error;
  Job loaded = load(job, error);
  if (!error.empty()) return Error{ErrorKind::kInput, error};
  loaded.simulation.threads = options.threads;
  loaded.output.views.clear();
  if (options.until > 0)
    (loaded.setups.empty() ? loaded.settings : loaded.setups.back().settings).until =
        UntilBlock{options.until, std::nullopt};
  const JobSources sources(loaded);
  Progress progress;
  Result<RunResult> result = runRecorded(loaded, sources.all(), progress);
  if (!result || !result->alarm) return result;
  std::string why = "alarm:";
  for (const Finding& finding : result->findings) why += " " + finding.message;
  return Error{ErrorKind::kInput, why};
}

std::optional<CaseRunner::Reported> CaseRunner::report(const std::string& simd_level, int threads) {
  const test::Outcome outcome =
      bench_.run("run job.toml --no-render --quiet --out out --threads " + std::to_string(threads),
                 "env PROVEOUT_SIMD=" + simd_level + " timeout 100");
  if (outcome.exit_code != 0 && outcome.exit_code != 1) return std::nullopt;
  const auto report = nlohmann::json::parse(test::readFile(bench_.path("out/report.json")), nullptr, false);
  if (!report.is_object()) return std::nullopt;
  const nlohmann::json& performance = report["performance"];
  return Reported{report["hashes"].value("part_sha256", std::string()),
                  performance.value("peak_memory_mb", 0.0), performance.value("predicted_memory_mb", 0.0)};
}

}  // namespace proveout::soak
