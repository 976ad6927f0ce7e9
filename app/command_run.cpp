#include <fmt/format.h>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/job_setup.h"
#include "app/outputs.h"
#include "app/pictures.h"
#include "app/pipeline.h"
#include "app/provenance.h"
#include "app/run_report.h"
#include "app/stopwatch.h"
#include "app/summary.h"
#include "app/turning.h"
#include "removal/threads.h"

namespace proveout {
namespace {

/// The findings with their places where they are on the finished part. Deviations are measured there.
std::vector<Finding> findingsInLastFrame(const RunResult& run) {
  std::vector<Finding> findings = run.findings;
  for (Finding& finding : findings) {
    if (!finding.where || isDeviation(finding)) continue;
    for (std::size_t k = 0; k < run.setups.size(); ++k) {
      if (run.setups[k].name == finding.setup) finding.where = inLastFrame(run, k, *finding.where);
    }
  }
  return findings;
}

Result<std::vector<Picture>> drawRun(const Job& job, const RunResult& run, Progress& progress) {
  if (run.alarm) return std::vector<Picture>{};
  PictureRequest request;
  request.name = job.name;
  request.views = job.output.views;
  request.size = {job.output.width, job.output.height};
  request.threads = job.simulation.threads;
  request.comparison = run.comparison ? &*run.comparison : nullptr;
  const std::vector<Finding> findings = findingsInLastFrame(run);
  request.findings = &findings;
  if (turnsPart(job)) request.turned_axis = Vec2::Zero();
  return drawPictures(run.surface().mesh, request, progress);
}

Status writeAll(const Job& job, const RunResult& run, const std::vector<Picture>& pictures,
                const std::string& folder, Report& report) {
  Result<StagingFolder> staging = StagingFolder::create(folder);
  if (!staging) return staging.error();
  if (!run.alarm) {
    for (const SetupRun& setup : run.setups) {
      if (Status done = writeProgramFiles(setup.interpreted.files, setup.name, *staging); !done) return done;
    }
    if (Status done =
            writeMeshes(run.surface().mesh, run.stock ? &*run.stock : nullptr, job, *staging, report);
        !done)
      return done;
    if (turnsPart(job)) {
      if (Status done = writeTurnedProfile(job, run, *staging, report); !done) return done;
    }
    if (job.output.csv) {
      if (Status done = writeTables(cutPaths(run), *staging, report); !done) return done;
    }
  }
  if (Status done = writeReport(pictures, *staging, report); !done) return done;
  return staging->commit();
}

Result<Report> runJob(const Job& job, const std::string& folder, ConsoleProgress& progress) {
  Stopwatch wall, watch;
  const ThreadLimit limit(job.simulation.threads);
  const JobSources sources(job);
  Result<PreparedRun> prepared = prepareRun(job, sources.all(), progress);
  if (!prepared) return prepared.error();
  if (!prepared->run.alarm) progress.expect(prepared->run.prediction);
  Result<RunResult> run = finishRun(job, sources.all(), std::move(*prepared), progress);
  if (!run) return run.error();
  watch.lap();
  Result<std::vector<Picture>> pictures = drawRun(job, *run, progress);
  if (!pictures) return pictures.error();
  run->performance.render_s = watch.lap();
  Result<Report> report = makeReport(job, *run, sources.all());
  if (!report) return report;
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  report->performance.wall_s = wall.lap();
  if (const Status written = writeAll(job, *run, *pictures, folder, *report); !written)
    return written.error();
  return report;
}

}  // namespace

int runCommand(const RunOptions& options, Console& console, ConsoleProgress& progress) {
  Diagnostics diagnostics;
  std::optional<Job> job = setUpJob(options.program, diagnostics);
  const bool good = job && applyRunOptions(options, *job, diagnostics);
  printDiagnostics(console, diagnostics.all(), options.quiet ? Severity::kError : Severity::kNote);
  if (!good) return kExitInput;
  const std::string folder = outputFolder(options, *job);
  progress.show(options.progress || (console.err_is_terminal && !options.quiet));
  const Result<Report> report = runJob(*job, folder, progress);
  progress.clear();
  if (!report) return printError(console, report.error());
  printResult(console, *report, options.quiet, options.json, folder);
  return exitCodeOf(report->verdict);
}

}  // namespace proveout
