#include "app/session/machining/programs.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/session/findings/findings.h"
#include "app/session/findings/setup_findings.h"
#include "app/session/program_checks/program_checks.h"
#include "app/session/programs/clearance.h"
#include "app/session/programs/first_offset.h"
#include "app/session/programs/interpretation.h"
#include "app/session/programs/rotary_motions.h"
#include "app/session/programs/wire_heights.h"
#include "app/session/run/control_choice.h"
#include "app/session/run/process.h"
#include "app/session/run/stock_probe.h"
#include "core/base/memory_limit.h"

namespace proveout {
namespace {

Error outgrown(const Interpreted& interpreted) {
  const SourceRef& at = *interpreted.outgrown_at;
  return Error{ErrorKind::kResourceLimit,
               fmt::format("{}:{}: the tool path outgrows the memory after {} motions: an endless loop? else "
                           "allow more (--max-memory)",
                           at.file < interpreted.path.files.size() ? interpreted.path.files[at.file] : "",
                           at.line, interpreted.path.motions.size())};
}

/// The stock that the program of a clamping starts with, cut by those in `before`.
ProbedStock probedStock(const Job& job, const SetupRun& setup, const Blank& blank,
                        const std::vector<SetupRun>& before) {
  ProbedStock probed;
  probed.options = removalOptions(setup.job, blank.resolution_mm);
  probed.tools = setup.job.tools;
  if (before.empty()) probed.blank = &blank.shape;
  probed.make = [&job, &setup, &blank, &before](Progress& progress) -> Result<Stock> {
    PieceOptions options;
    options.grid = removalOptions(job, blank.resolution_mm);
    Blank fresh{blank.shape, blank.bounds, blank.resolution_mm, std::nullopt, blank.start_holes};
    Result<std::unique_ptr<Workpiece>> piece = processOf(job, 0).make(fresh, job, progress);
    for (std::size_t k = 0; piece && k < before.size(); ++k) {
      const Status cut = (*piece)->cut(before[k].interpreted.path, before[k].job.tools, options, progress);
      if (!cut) return cut.error();
      const RigidTransform& move = k + 1 < before.size() ? before[k + 1].from_previous : setup.from_previous;
      piece = (*piece)->become(processOf(job, k + 1).kind, move, options, progress);
    }
    if (!piece) return piece.error();
    return std::move(*(*piece)->takeGrid());
  };
  return probed;
}

SetupRun emptySetup(const Job& job, std::size_t k) {
  SetupRun setup;
  if (!job.setups.empty()) {
    setup.name = job.setups[k].name;
    setup.from_previous = job.setups[k].from_previous;
  }
  setup.job = jobOfSetup(job, k);
  return setup;
}

/// Runs the program of a clamping on its control.
Status read(SetupRun& setup, const RecordingSource& source, const ControlSettings& settings,
            const ProbedStock* stock, Progress& progress) {
  setup.interpreted = interpretProgram(setup.job, source, settings, progress, stock);
  if (setup.interpreted.summary.errors > 0 && !source.texts().empty()) {
    if (auto note = otherControlNote(setup.job, source.texts().front()))
      setup.interpreted.path.diagnostics.add(std::move(*note));
  }
  if (setup.interpreted.outgrown_at) return outgrown(setup.interpreted);
  if (const std::optional<Error> refused = memoryRefusal()) return *refused;
  if (const Status fits = memoryFor(0.0, "what the programs have made"); !fits) return fits.error();
  if (setup.interpreted.summary.end == ProgramEnd::kCancelled || progress.cancelled())
    return Error{ErrorKind::kInterrupted, "interrupted"};
  const std::optional<Error>& failure = setup.interpreted.probe_failure;
  if (failure && failure->kind != ErrorKind::kInput) return *failure;
  return Done{};
}

/// What the bounds of the blank tell of the places that a job leaves open or gives. `notes` came before the
/// program was read.
void addPlaceNotes(const Job& job, std::size_t k, const Box3& bounds, const Diagnostics& notes,
                   Toolpath& path) {
  for (const Diagnostic& note : notes.all()) path.diagnostics.add(note);
  noteLowToolChange(job, bounds, path.diagnostics);
  noteWireHeights(job, k, bounds, path);
}

}  // namespace

Status interpretAll(const Job& job, const RunSources& sources, const Blank& blank, RunResult& run,
                    Progress& progress) {
  for (std::size_t k = 0; k < sources.size(); ++k) {
    SetupRun setup = emptySetup(job, k);
    // One control runs them one after the other: what it keeps, the next program finds.
    if (k > 0 && run.setups.back().job.control == setup.job.control)
      setup.job.person.kept = run.setups.back().interpreted.summary.kept;
    const Box3 bounds = movedBounds(job, blank.bounds, k);
    Diagnostics placing;
    placeByFirstOffset(setup.job, *sources[k], bounds, placing, progress);
    const ControlSettings settings = controlSettings(setup.job, bounds);
    const ProbedStock stock = probedStock(job, setup, blank, run.setups);
    if (const Status done = read(setup, *sources[k], settings, &stock, progress); !done) return done;
    Toolpath& path = setup.interpreted.path;
    addPlaceNotes(setup.job, k, bounds, placing, path);
    addOffsetTools(path, setup.job.tools);
    const bool good = setup.interpreted.summary.ok() && assignTools(path, setup.job.tools, *sources[k]) &&
                      checkRotaryMotions(path, *sources[k]);
    if (!good) run.alarm = true;
    inSetup(run, setup, [&](std::vector<Finding>& findings) {
      addAlarms(path, findings);
      addOvertravel(path, *sources[k], findings);
      if (setup.job.settings.machine)
        addClampedAxes(*setup.job.settings.machine, path, *sources[k], findings);
      addForbiddenZones(path, *sources[k], findings);
    });
    run.setups.push_back(std::move(setup));
  }
  return Done{};
}

Result<ReadProgram> readProgram(const Job& job, std::size_t k, const Blank* blank,
                                const RecordingSource& source, int max_errors, Progress& progress) {
  ReadProgram done{emptySetup(job, k), {}};
  SetupRun& setup = done.setup;
  std::optional<Box3> bounds;
  if (blank != nullptr) bounds = movedBounds(job, blank->bounds, job.setups.empty() ? 0 : k);
  Diagnostics placing;
  ControlSettings settings = setup.job.settings;
  if (bounds) {
    placeByFirstOffset(setup.job, source, *bounds, placing, progress);
    settings = controlSettings(setup.job, *bounds);
  } else if (setup.job.start) {
    settings.start = *setup.job.start;
  }
  settings.max_errors = std::max(settings.max_errors, max_errors);
  if (const Status read_well = read(setup, source, settings, nullptr, progress); !read_well)
    return read_well.error();
  Toolpath& path = setup.interpreted.path;
  if (bounds) addPlaceNotes(setup.job, k, *bounds, placing, path);
  addOffsetTools(path, setup.job.tools);
  if (setup.interpreted.summary.ok() && !setup.job.tools.empty()) assignTools(path, setup.job.tools, source);
  addOvertravel(path, source, done.findings);
  if (setup.job.settings.machine) addClampedAxes(*setup.job.settings.machine, path, source, done.findings);
  addForbiddenZones(path, source, done.findings);
  const bool first = blank != nullptr && k == 0;  // what the clampings before it leave is not known
  addProgramFindings(
      {setup.job, path, source, first ? bounds : std::nullopt, first ? &blank->shape : nullptr},
      done.findings);
  for (Finding& finding : done.findings) finding.setup = setup.name;
  return done;
}

}  // namespace proveout
