#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands.h"
#include "app/deviation/deviation_outputs.h"
#include "app/exit_codes.h"
#include "app/input_files.h"
#include "app/job_setup.h"
#include "app/outputs.h"
#include "app/page/measured_surface.h"
#include "app/page/reduced_mesh.h"
#include "app/page/report_view.h"
#include "app/page/setup_sheets.h"
#include "app/pictures.h"
#include "app/run_report.h"
#include "app/session/findings/acceptance.h"
#include "app/session/findings/provenance.h"
#include "app/session/forecast/thread_supply.h"
#include "app/session/session.h"
#include "app/summary.h"
#include "app/time_limit.h"
#include "app/turned_profile.h"
#include "core/base/memory_limit.h"
#include "core/base/printable.h"
#include "core/base/stopwatch.h"
#include "io/baseline.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;

/// The findings with their places where they are on the finished part. Deviations are measured there.
std::vector<Finding> findingsInLastFrame(const RunResult& run) {
  std::vector<Finding> findings = run.findings;
  for (Finding& finding : findings) {
    if (!finding.where || isDeviation(finding.kind)) continue;
    for (std::size_t k = 0; k < run.setups.size(); ++k) {
      if (run.setups[k].name == finding.setup) finding.where = inLastFrame(run, k, *finding.where);
    }
  }
  return findings;
}

/// The pictures of a run: of the part while it is compared, of deviations and findings behind that.
class RunPictures {
 public:
  explicit RunPictures(const Job& job) : maker_(requestOf(job)) {}

  /// As WorkOnPart.
  Status drawPart(const SetupRun& last, Progress& progress) {
    Stopwatch watch;
    if (const std::optional<Vec2> axis = last.form->pictureAxis()) maker_.turnAbout(*axis);
    const TriMesh& mesh = last.surface.mesh;
    Status done = maker_.drawViews(mesh, progress);
    if (done) done = maker_.drawApart(mesh, last.freed, last.bodies, progress);
    drawn_s_ += watch.lap();
    return done;
  }

  Status drawFindings(const RunResult& run, const RunSources& sources, Progress& progress) {
    if (run.alarm) return Done{};
    Stopwatch watch;
    const std::vector<Finding> findings = findingsInLastFrame(run);
    const TriMesh& mesh = run.surface().mesh;
    Status done = Done{};
    if (run.comparison) done = maker_.drawDeviation(mesh, *run.comparison, findings, progress);
    if (done) done = drawScallops(run, progress);
    if (done) done = maker_.drawFindings(mesh, findings, progress);
    if (!done) return done;
    Result<std::vector<FindingDetail>> details = maker_.drawDetails(
        mesh, run.comparison ? &*run.comparison : nullptr, findings, &run, &sources, progress);
    if (!details) return details.error();
    details_ = std::move(*details);
    maker_.forgetMesh();
    drawn_s_ += watch.lap();
    return done;
  }

  double drawnS() const { return drawn_s_; }
  const std::vector<Picture>& pictures() const { return maker_.pictures; }
  const std::vector<Error>& failures() const { return maker_.failures; }
  const std::vector<FindingDetail>& details() const { return details_; }

 private:
  /// Of the first characteristic that asks for them.
  Status drawScallops(const RunResult& run, Progress& progress) {
    const std::vector<PartRule>& rules = run.setups.back().job.part_characteristics;
    for (std::size_t k = 0; k < run.part_features.size(); ++k)
      if (rules[k].quantity == Quantity::kScallop)
        return maker_.drawScallops(run.surface().mesh, run.part_features[k].crests,
                                   std::max(rules[k].max.value_or(0.0), 1e-3), progress);
    return Done{};
  }

  static PictureRequest requestOf(const Job& job) {
    PictureRequest request;
    request.name = job.name;
    request.views = job.output.views;
    request.size = {job.output.width, job.output.height};
    request.threads = job.simulation.threads;
    return request;
  }

  PictureMaker maker_;
  std::vector<FindingDetail> details_;
  double drawn_s_ = 0.0;
};

/// Of the whole surface. None where nothing was compared, or the job asks for none.
std::vector<DeviationBand> bandsOf(const Job& job, const RunResult& run) {
  if (job.report.bands_mm.empty() || !run.comparison || !run.comparison->field) return {};
  constexpr std::size_t kHalved = 200'000;  // triangles, on top of those of the mesh
  ViewMesh surface{run.surface().mesh, run.comparison->vertex_deviation, 0.0, 0};
  const std::size_t most = surface.mesh.triangles.size() + kHalved;
  addDeviations([&](const Vec3& p) { return run.comparison->field->at(p); }, shownDeviation(*run.comparison),
                most, surface);
  return deviationBands(surface, job.report.bands_mm);
}

/// What report.html has besides pictures and close-ups. `drawn_s` grows by the time that it takes.
PageContent pageOf(const Job& job, const RunResult& run, const RunSources& sources, Progress& progress,
                   double& drawn_s) {
  PageContent page;
  if (run.alarm) return page;
  Stopwatch watch;
  const TriMesh* nominal = run.comparison && run.nominal ? &*run.nominal : nullptr;
  page.bands = bandsOf(job, run);
  page.sections = pageSections(run.surface().mesh, nominal, job.report.sections);
  page.sheets = setupSheets(job, run, progress);
  if (wantsView(job)) {
    const std::vector<Finding> findings = findingsInLastFrame(run);
    page.view = viewOfRun(
        run, sources,
        {run.surface().mesh, nominal, run.comparison ? &*run.comparison : nullptr, page.bands, findings},
        progress);
  }
  drawn_s += watch.lap();
  return page;
}

/// Where a run writes, and what it must not write over.
struct Target {
  std::string folder;
  OutputGuard guard;
};

/// Takes in what was called, and errors where a file that a program wrote would go over an input: known only
/// when the programs have run.
Status checkPrograms(const RunResult& run, const RunSources& sources, const Job& job, Target& target) {
  for (const RecordingSource* source : sources) protectAll(programsRead(*source), target.guard);
  std::vector<std::string> names = outputNames(job);
  for (const SetupRun& setup : run.setups) {
    for (const auto& file : setup.interpreted.files) names.push_back(programFileName(setup.name, file.first));
  }
  for (std::size_t k = 0; writesBodies(job) && k < run.setups.back().freed.size(); ++k) {
    for (const OutputFormat format : job.output.formats) names.push_back(bodyFileName(job, format, k + 1));
  }
  return checkNames(names, target.folder, target.guard);
}

/// Errors: the folder cannot be written at all. What else fails is kept and told by the report.
Status writeAll(const Job& job, const RunResult& run, const RunSources& sources,
                const std::vector<Picture>& pictures, PageContent page, const Target& target,
                Progress& progress, Report& report, OutputFailures& failures) {
  Result<StagingFolder> staging = StagingFolder::create(target.folder, &target.guard, &progress);
  if (!staging) return staging.error();
  if (!run.alarm) {
    for (const SetupRun& setup : run.setups)
      writeProgramFiles(setup.interpreted.files, setup.name, *staging, failures);
    writeMeshes(run.surface().mesh, run.stock ? &*run.stock : nullptr, job, *staging, report, failures);
    if (writesBodies(job)) writeBodies(run.setups.back().freed, job, *staging, report, failures);
    writeSections(run.surface().mesh, run.setups.back().freed, job, *staging, report, failures);
    writeTurnedProfile(job, run, *staging, report, failures);
    if (job.output.csv) writeTables(cutPaths(run), *staging, report, failures);
    writeRunDeviation(job, run, sources, progress, *staging, report, failures);
  }
  report.performance.peak_memory_mb = peakMemoryMb();  // files take more than the run that they are of
  writeReport(pictures, *staging, report, failures, std::move(page), job.output.csv);
  return staging->commit();
}

/// A run's report and what of its outputs is missing.
struct Written {
  Report report;
  OutputFailures failures;
};

/// What the command line says besides the job.
struct RunWish {
  std::vector<std::string> command;  ///< words that decide the findings
  std::string folder;                ///< for the results
  AcceptanceWish acceptance;
  std::optional<std::string> write_baseline;
};

Result<AcceptanceWish> acceptanceWish(const RunOptions& options) {
  AcceptanceWish wish;
  Result<KindFilter> filter = parseKindFilter(options.select, options.ignore);
  if (!filter) return filter.error();
  wish.filter = std::move(*filter);
  if (!options.baseline) return wish;
  if (const Status settled = settleInputs({{"baseline", *options.baseline}}); !settled)
    return settled.error();
  Result<AcceptanceWish::File> file = loadBaseline(*options.baseline);
  if (!file) return file.error();
  wish.baseline = std::move(*file);
  return wish;
}

/// Errors: the new baseline could not be written, or would be over an input or a result. Over the baseline
/// that is read is fine.
Status checkNewBaseline(const Job& job, const RunWish& wish, OutputGuard guard) {
  if (!wish.write_baseline) return Done{};
  const fs::path path(*wish.write_baseline);
  for (const std::string& name : outputNames(job))
    guard.protect("result", (fs::path(wish.folder) / name).string());
  if (const Status free = guard.check(path.string()); !free) return free;
  std::error_code error;
  if (fs::is_directory(path, error)) return inputError("--write-baseline: " + path.string() + " is a folder");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (folder.lexically_normal() == fs::path(wish.folder).lexically_normal())
    return Done{};  // made with the results
  if (!fs::is_directory(folder, error))
    return inputError("--write-baseline: " + folder.string() + ": no such folder");
  return Done{};
}

/// Says what was written.
Status writeNewBaseline(const Report& report, const std::string& path, Console& console) {
  if (report.verdict == Verdict::kError)
    return inputError(path + ": no baseline is written of a program that was not run to its end");
  if (const Status written = writeFileAtomically(path, baselineText(report.findings)); !written)
    return written;
  const std::size_t count = baselineCount(report.findings);
  console.err << fmt::format("proveout: {} {} written to {}\n", count, count == 1 ? "finding" : "findings",
                             printable(path));
  return Done{};
}

Result<Written> runJob(const Job& job, const RunWish& wish, ConsoleProgress& progress) {
  Stopwatch wall;
  const ThreadSupply threads(job.simulation.threads);
  const JobSources sources(job);
  Target target{wish.folder, {}};
  if (const Status settled = settleInputs(namedInputs(job)); !settled) return settled.error();
  protectAll(namedInputs(job), target.guard);
  if (const Status free = checkNewBaseline(job, wish, target.guard); !free) return free.error();
  if (wish.acceptance.baseline) target.guard.protect("baseline", wish.acceptance.baseline->path);
  if (const Status possible = checkOutputs(job, wish.folder, target.guard); !possible)
    return possible.error();
  Result<PreparedRun> prepared = prepareRun(job, sources.all(), progress);
  if (!prepared) return prepared.error();
  if (const Status free = checkPrograms(prepared->run, sources.all(), job, target); !free)
    return free.error();
  if (!prepared->run.alarm) progress.expect(prepared->run.prediction);
  RunPictures pictures(job);
  Result<RunResult> run =
      finishRun(job, sources.all(), std::move(*prepared), progress,
                [&](const SetupRun& last, Progress& drawing) { return pictures.drawPart(last, drawing); });
  if (!run) return run.error();
  ReportAcceptance accepted = accept(job, wish.acceptance, run->comparison.has_value(), run->findings);
  if (const Status drawn = pictures.drawFindings(*run, sources.all(), progress); !drawn) return drawn.error();
  run->performance.render_s = pictures.drawnS();
  PageContent page = pageOf(job, *run, sources.all(), progress, run->performance.render_s);
  page.details = pictures.details();
  Result<Report> report = makeReport(job, *run, sources.all());
  if (!report) return report.error();
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  report->performance.wall_s = wall.lap();
  Written written{std::move(*report), pictures.failures()};
  written.report.command = wish.command;
  written.report.acceptance = std::move(accepted);
  if (const Status done = writeAll(job, *run, sources.all(), pictures.pictures(), std::move(page), target,
                                   progress, written.report, written.failures);
      !done)
    return done.error();
  return written;
}

}  // namespace

int runCommand(const RunOptions& options, Console& console, ConsoleProgress& progress) {
  TimeLimit limit(progress);
  limit.set(options.program.max_time_s.value_or(0.0));
  MemoryLimit memory(1e9 * options.max_memory_gb.value_or(0.0));
  Diagnostics diagnostics;
  std::optional<Job> job = setUpJob(options.program, diagnostics);
  const bool good = job && applyRunOptions(options, *job, diagnostics);
  printDiagnostics(console, diagnostics.all(), options.quiet ? Severity::kError : Severity::kNote);
  if (!good) return memoryRefusal() ? kExitResource : kExitInput;
  limit.set(job->simulation.max_time_s);
  memory.set(1e9 * job->simulation.max_memory_gb);
  job->simulation.max_time_s = limit.limit();
  Result<AcceptanceWish> acceptance = acceptanceWish(options);
  if (!acceptance) return printError(console, acceptance.error());
  const RunWish wish{decidingArguments(options), outputFolder(options, *job), std::move(*acceptance),
                     options.write_baseline};
  progress.show(options.progress || (console.err_is_terminal && !options.quiet));
  const Result<Written> written = runJob(*job, wish, progress);
  progress.clear();
  if (!written) return printError(console, limit.told(written.error()));
  printResult(console, written->report, options.quiet, options.json, wish.folder);
  const int code = exitCodeOf(written->report, written->failures);
  if (!options.write_baseline) return code;
  const Status kept = writeNewBaseline(written->report, *options.write_baseline, console);
  return kept ? code : std::max(code, printError(console, kept.error()));
}

}  // namespace proveout
