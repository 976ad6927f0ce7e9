// `path` and `check`: the interpreter alone.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exit_codes.h"
#include "app/input_files.h"
#include "app/job_setup.h"
#include "app/session/findings/findings.h"
#include "app/session/forecast/thread_supply.h"
#include "app/session/machining/programs.h"
#include "app/session/programs/first_offset.h"
#include "app/session/programs/interpretation.h"
#include "app/session/run/control_choice.h"
#include "app/time_limit.h"
#include "core/base/memory_limit.h"
#include "core/base/printable.h"
#include "io/path_writer.h"

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
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) override {
    if (next_) next_->motion(motion, arc, axis);
  }
  void wireMotion(const Motion& motion, const WireSweep& wire) override {
    if (next_) next_->wireMotion(motion, wire);
  }
  void event(const PathEvent& event) override {
    if (event.as<event::Overtravel>() != nullptr || event.as<event::ForbiddenZone>() != nullptr)
      overtravels.events.push_back({kNoMotion, event});
    if (next_) next_->event(event);
  }
  void diagnostic(const Diagnostic& diagnostic) override {
    diagnostics.add(diagnostic);
    if (next_) next_->diagnostic(diagnostic);
  }
  void originWord(const WordOrigin& word) override {
    if (next_) next_->originWord(word);
  }
  void originData(const DataInForce& data) override {
    if (next_) next_->originData(data);
  }
  void originModal(const ModalOrigins& modal) override {
    if (next_) next_->originModal(modal);
  }
  void originSet(const OriginSet& set) override {
    if (next_) next_->originSet(set);
  }
  Diagnostics diagnostics;
  Toolpath overtravels;  ///< events of axes beyond their limits or in forbidden areas, and the names of the
                         ///< files, no motions

 private:
  MotionSink* next_;
};

/// Settings of a setup, `source` being its program. Where the blank is unknown, the default start is that of
/// the control.
Result<ControlSettings> settingsOf(const Job& job, std::size_t setup, const RecordingSource& source,
                                   MotionSink& notes, Progress& progress) {
  Job part = jobOfSetup(job, setup);
  if (part.stock) {
    const Result<Blank> blank = openBlank(part, progress);
    if (!blank) return blank.error();
    const Box3 bounds = movedBounds(job, blank->bounds, job.setups.empty() ? 0 : setup);
    Diagnostics placing;
    placeByFirstOffset(part, source, bounds, placing, progress);
    for (const Diagnostic& note : placing.all()) notes.diagnostic(note);
    return controlSettings(part, bounds);
  }
  ControlSettings settings = part.settings;
  if (part.start) settings.start = *part.start;
  return settings;
}

struct Interpretation {
  InterpretSummary summary;
  Diagnostics diagnostics;        ///< the control's
  std::vector<Finding> findings;  ///< overtravel, forbidden areas
};

Result<Interpretation> interpretInto(const Job& job, std::size_t setup, MotionSink* sink,
                                     Progress& progress) {
  const ThreadSupply threads(job.simulation.threads);
  const MemoryLimit memory(1e9 * job.simulation.max_memory_gb);
  const Result<ControlId> control = findControl(jobOfSetup(job, setup).control);
  if (!control) return control.error();
  const JobSources sources(job);
  const RecordingSource& source = *sources.all()[setup];
  DiagnosticsTap tap(sink);
  if (const auto note = choiceNote(jobOfSetup(job, setup))) tap.diagnostic(*note);
  Result<ControlSettings> settings = settingsOf(job, setup, source, tap, progress);
  if (!settings) return settings.error();
  Interpretation result;
  ControlHost host;  // files that the program writes are lost
  host.person = job.person;
  result.summary = interpretJob(job, *control, source, *settings, tap, progress, host);
  addOvertravel(tap.overtravels, source, result.findings);
  addForbiddenZones(tap.overtravels, source, result.findings);
  result.diagnostics = std::move(tap.diagnostics);
  if (const std::optional<Error> refused = memoryRefusal()) return *refused;
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
  if (!job) return job;
  OutputGuard guard;
  protectAll(namedInputs(*job), guard);
  for (const Status& fit : {settleInputs(namedInputs(*job)), guard.checkStandardOutput()}) {
    if (fit) continue;
    printError(console, fit.error());
    return std::nullopt;
  }
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
  TimeLimit limit(progress);
  limit.set(options.program.max_time_s.value_or(0.0));
  const std::optional<Job> job = jobOrPrint(options.program, console);
  if (!job) return kExitInput;
  limit.set(job->simulation.max_time_s);
  if (job->setups.size() > 1 && !options.program.setup) {
    return printError(console, inputError("the job has several setups: --setup NAME says whose path it is"));
  }
  Result<std::unique_ptr<MotionSink>> writer =
      makePathWriter(options.format, console.out, jobOfSetup(*job, setupCount(*job) - 1).control);
  if (!writer) return printError(console, writer.error());
  const Result<Interpretation> done = interpretInto(*job, setupCount(*job) - 1, writer->get(), progress);
  if (!done) return printError(console, limit.told(done.error()));
  printDiagnostics(console, done->diagnostics.all());
  return exitCodeOf(*done);
}

namespace {

/// What `check` tells of one program.
struct Checked {
  std::string setup;  ///< empty in a job without setups
  std::string program;
  std::string until;  ///< where it stopped early
  InterpretSummary summary;
  Diagnostics all;  ///< of the control, then what was found
  std::size_t errors = 0, warnings = 0;
  int exit_code = kExitOk;
};

std::size_t countOf(const Diagnostics& all, Severity severity) {
  return static_cast<std::size_t>(std::count_if(all.all().begin(), all.all().end(),
                                                [&](const Diagnostic& d) { return d.severity == severity; }));
}

Result<Checked> checkSetup(const Job& job, std::size_t setup, const Blank* blank,
                           const RecordingSource& source, Progress& progress) {
  Result<ReadProgram> done = readProgram(job, setup, blank, source, kCheckErrors, progress);
  if (!done) return done.error();
  const SetupRun& read = done->setup;
  Checked checked;
  checked.setup = read.name;
  checked.program = programNames(read.job);
  checked.summary = read.interpreted.summary;
  if (checked.summary.end == ProgramEnd::kUntil) checked.until = untilText(read.job.settings);
  checked.all = read.interpreted.path.diagnostics;
  if (!checked.summary.ok() || countOf(checked.all, Severity::kError) > 0) checked.exit_code = kExitInput;
  for (const Finding& finding : done->findings) {
    if (finding.severity == Severity::kError)
      checked.exit_code = std::max<int>(checked.exit_code, kExitFindings);
    checked.all.add(findingDiagnostic(finding));
  }
  checked.errors = countOf(checked.all, Severity::kError);
  checked.warnings = countOf(checked.all, Severity::kWarning);
  return checked;
}

/// Of all programs that are asked for.
Result<std::vector<Checked>> checkAll(const Job& job, std::size_t first, Progress& progress) {
  const ThreadSupply threads(job.simulation.threads);
  const MemoryLimit memory(1e9 * job.simulation.max_memory_gb);
  std::optional<Blank> blank;
  if (job.stock) {
    Result<Blank> opened = openBlank(job, progress);
    if (!opened) return opened.error();
    blank = std::move(*opened);
  }
  const JobSources sources(job);
  std::vector<Checked> programs;
  for (std::size_t k = first; k < setupCount(job); ++k) {
    const Result<ControlId> control = findControl(jobOfSetup(job, k).control);
    if (!control) return control.error();
    Result<Checked> checked = checkSetup(job, k, blank ? &*blank : nullptr, *sources.all()[k], progress);
    if (!checked) return checked.error();
    programs.push_back(std::move(*checked));
  }
  return programs;
}

std::string checkText(const Checked& checked) {
  const InterpretSummary& summary = checked.summary;
  const std::string line =
      fmt::format("{}{}: {} blocks, {} motions, {:.1f} s, errors: {}, warnings: {}{}",
                  checked.setup.empty() ? "" : "setup " + checked.setup + ": ", checked.program,
                  summary.blocks, summary.motions, summary.cycle_s, checked.errors, checked.warnings,
                  checked.until.empty() ? "" : ", partial: only up to " + checked.until);
  return printable(line) + "\n";
}

nlohmann::ordered_json checkJson(const Checked& checked) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : checked.all.all()) list.push_back(toJson(diagnostic));
  const InterpretSummary& summary = checked.summary;
  nlohmann::ordered_json out;
  if (!checked.setup.empty()) out["setup"] = checked.setup;
  out.update({{"program", checked.program},
              {"blocks", summary.blocks},
              {"motions", summary.motions},
              {"cycle_s", summary.cycle_s},
              {"partial", !checked.until.empty()},
              {"errors", checked.errors},
              {"warnings", checked.warnings},
              {"diagnostics", list}});
  return out;
}

/// One program stands in the document itself, those of several setups in a list.
nlohmann::ordered_json checkDocument(const Job& job, const std::vector<Checked>& programs) {
  nlohmann::ordered_json root = {{"schema", "proveout.check/1"},
                                 {"control", fmt::format("{}", fmt::join(controlsOf(job), ", "))}};
  if (programs.size() == 1) {
    root.update(checkJson(programs.front()));
    return root;
  }
  root["setups"] = nlohmann::ordered_json::array();
  for (const Checked& checked : programs) root["setups"].push_back(checkJson(checked));
  return root;
}

}  // namespace

int checkCommand(const CheckOptions& options, Console& console, ConsoleProgress& progress) {
  TimeLimit limit(progress);
  limit.set(options.program.max_time_s.value_or(0.0));
  const std::optional<Job> job = jobOrPrint(options.program, console);
  if (!job) return kExitInput;
  limit.set(job->simulation.max_time_s);
  const Result<std::vector<Checked>> programs =
      checkAll(*job, options.program.setup ? setupCount(*job) - 1 : 0, progress);
  if (!programs) return printError(console, limit.told(programs.error()));
  int code = kExitOk;
  for (const Checked& checked : *programs) {
    code = std::max(code, checked.exit_code);
    if (options.json) continue;
    printDiagnostics(console, checked.all.all());
    console.out << checkText(checked);
  }
  if (options.json) {
    const std::string text =
        checkDocument(*job, *programs).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    console.out << jsonPrintable(text) << "\n";
  }
  return code;
}

}  // namespace proveout
