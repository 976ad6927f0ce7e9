// `path` and `check`: the interpreter alone.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/findings.h"
#include "app/interpretation.h"
#include "app/job_setup.h"
#include "io/path_writer.h"
#include "io/program_files.h"

namespace proveout {
namespace {

/// So many errors of a program are collected before `check` gives up.
constexpr int kCheckErrors = 20;

/// Passes everything on and keeps the diagnostics.
class DiagnosticsTap : public MotionSink {
 public:
  explicit DiagnosticsTap(MotionSink* next) : next_(next) {}
  void file(std::uint32_t index, const std::string& name) override {
    if (overtravels.files.size() <= index) overtravels.files.resize(index + 1);
    overtravels.files[index] = name;
    if (next_) next_->file(index, name);
  }
  void motion(const Motion& motion, const ArcGeometry* arc) override {
    if (next_) next_->motion(motion, arc);
  }
  void event(const PathEvent& event) override {
    if (event.event == "overtravel") overtravels.events.push_back({kNoMotion, event});
    if (next_) next_->event(event);
  }
  void diagnostic(const Diagnostic& diagnostic) override {
    diagnostics.add(diagnostic);
    if (next_) next_->diagnostic(diagnostic);
  }
  Diagnostics diagnostics;
  Toolpath overtravels;  ///< events of that kind and the names of the files, no motions

 private:
  MotionSink* next_;
};

/// Settings for a job whose blank may be unknown: the default start then is that of the control.
Result<ControlSettings> settingsOf(const Job& job, Progress& progress) {
  if (job.stock) {
    const Result<Blank> blank = openBlank(job, progress);
    if (!blank) return blank.error();
    return controlSettings(job, blank->bounds);
  }
  ControlSettings settings = job.settings;
  if (job.start) settings.start = *job.start;
  return settings;
}

struct Interpretation {
  InterpretSummary summary;
  Diagnostics diagnostics;        ///< the control's
  std::vector<Finding> findings;  ///< overtravel
};

Result<Interpretation> interpretInto(const Job& job, int max_errors, MotionSink* sink, Progress& progress) {
  const Result<ControlId> control = findControl(job.control);
  if (!control) return control.error();
  Result<ControlSettings> settings = settingsOf(job, progress);
  if (!settings) return settings.error();
  settings->max_errors = std::max(settings->max_errors, max_errors);
  const FileProgramSource files(job.program, job.subprograms);
  const RecordingSource source(files, job.settings.encoding);
  DiagnosticsTap tap(sink);
  Interpretation result;
  result.summary = interpret(*control, source, *settings, tap, &progress);
  addOvertravel(tap.overtravels, source, result.findings);
  result.diagnostics = std::move(tap.diagnostics);
  if (result.summary.end == ProgramEnd::kCancelled) return Error{ErrorKind::kInterrupted, "interrupted"};
  return result;
}

int exitCodeOf(const Interpretation& done) {
  if (!done.summary.ok()) return kExitInput;
  return done.findings.empty() ? kExitOk : kExitFindings;
}

std::optional<Job> jobOrPrint(const ProgramOptions& options, Console& console) {
  Diagnostics diagnostics;
  std::optional<Job> job = setUpJob(options, diagnostics);
  printDiagnostics(console, diagnostics.all());
  return job;
}

nlohmann::ordered_json toJson(const Diagnostic& d) {
  return {{"severity", severityName(d.severity)},
          {"code", d.code},
          {"message", d.message},
          {"source", {{"file", d.where.file}, {"line", d.where.line}, {"column", d.where.column}}}};
}

}  // namespace

int pathCommand(const PathOptions& options, Console& console, ConsoleProgress& progress) {
  const std::optional<Job> job = jobOrPrint(options.program, console);
  if (!job) return kExitInput;
  Result<std::unique_ptr<MotionSink>> writer = makePathWriter(options.format, console.out, job->control);
  if (!writer) return printError(console, writer.error());
  const Result<Interpretation> done = interpretInto(*job, 1, writer->get(), progress);
  if (!done) return printError(console, done.error());
  printDiagnostics(console, done->diagnostics.all());
  return exitCodeOf(*done);
}

int checkCommand(const CheckOptions& options, Console& console, ConsoleProgress& progress) {
  const std::optional<Job> job = jobOrPrint(options.program, console);
  if (!job) return kExitInput;
  const Result<Interpretation> done = interpretInto(*job, kCheckErrors, nullptr, progress);
  if (!done) return printError(console, done.error());
  const InterpretSummary& summary = done->summary;
  Diagnostics all = done->diagnostics;
  for (const Finding& finding : done->findings) all.add(findingDiagnostic(finding));
  const auto errors = static_cast<std::size_t>(summary.errors) + done->findings.size();
  if (options.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Diagnostic& diagnostic : all.all()) list.push_back(toJson(diagnostic));
    const nlohmann::ordered_json root = {{"schema", "proveout.check/1"},
                                         {"control", job->control},
                                         {"program", job->program},
                                         {"blocks", summary.blocks},
                                         {"motions", summary.motions},
                                         {"cycle_s", summary.cycle_s},
                                         {"partial", summary.end == ProgramEnd::kUntil},
                                         {"errors", errors},
                                         {"warnings", summary.warnings},
                                         {"diagnostics", list}};
    console.out << root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  } else {
    printDiagnostics(console, all.all());
    const bool partial = summary.end == ProgramEnd::kUntil;
    console.out << fmt::format("{}: {} blocks, {} motions, {:.1f} s, errors: {}, warnings: {}{}\n",
                               job->program, summary.blocks, summary.motions, summary.cycle_s, errors,
                               summary.warnings,
                               partial ? ", partial: only up to " + untilText(job->settings) : "");
  }
  return exitCodeOf(*done);
}

}  // namespace proveout
