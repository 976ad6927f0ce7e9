#include "tests/soak/second/plan_runner.h"

#include "app/job_setup.h"

namespace proveout::soak::second {
namespace {

Result<Job> load(const std::string& path) {
  ProgramOptions options;
  options.input = path;
  Diagnostics diagnostics;
  std::optional<Job> job = setUpJob(options, diagnostics);
  if (job) return std::move(*job);
  std::string why;
  for (const Diagnostic& d : diagnostics.all()) why += d.message + "; ";
  return inputError(why);
}

Error alarmOf(const RunResult& run) {
  std::string why = "alarm:";
  for (const Finding& finding : run.findings) why += " " + finding.message;
  return inputError(why);
}

}  // namespace

Result<RunResult> runFolder(const test::Workbench& folder, const Files& files, const std::string& saved) {
  for (const auto& [name, text] : files) folder.write(name, text);
  Result<Job> job = load(folder.path("job.toml"));
  if (!job) return job.error();
  job->simulation.threads = 1;
  job->output.views.clear();
  const JobSources sources(*job);
  Progress progress;
  Result<RunResult> run = runRecorded(*job, sources.all(), progress);
  if (!run) return run;
  if (run->alarm) return alarmOf(*run);
  if (saved.empty()) return run;
  if (!run->stock) return inputError("no stock is left that could be saved");
  if (const Status done = run->stock->save(saved); !done) return done.error();
  return run;
}

}  // namespace proveout::soak::second
