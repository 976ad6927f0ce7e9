#include "app/session/session.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/session/causes/diagnosis.h"
#include "app/session/comparison.h"
#include "app/session/findings/findings.h"
#include "app/session/findings/nose_data.h"
#include "app/session/findings/uncertainty.h"
#include "app/session/forecast/machine_speed.h"
#include "app/session/forecast/run_limits.h"
#include "app/session/forecast/thread_supply.h"
#include "app/session/machining/grid_choice.h"
#include "app/session/machining/machining.h"
#include "app/session/machining/programs.h"
#include "app/session/nominal/nominal_mesh.h"
#include "app/session/nominal/placement_search.h"
#include "app/session/part_check.h"
#include "app/session/programs/clearance.h"
#include "app/session/run/control_choice.h"
#include "app/session/run/process.h"
#include "core/base/parallel_for.h"
#include "core/base/stopwatch.h"
#include "removal/compare/fit/fit.h"
#include "removal/sweep/column_sweep.h"
#include "removal/turning/turned_stock.h"

namespace proveout {
namespace {

void tellPlacement(std::string text, RunResult& run) {
  Finding finding(FindingKind::kNominalPlacement);
  finding.message = std::move(text);
  run.findings.push_back(std::move(finding));
}

/// Tells what is wrong about where the nominal lies. Where it cannot be compared there, that is the one
/// finding.
bool tellElsewhere(const Job& job, const PreparedRun& prepared, RunResult& run) {
  const NominalSpec& nominal = *job.nominal;
  const PartSpace space{run.surface().mesh, movedBounds(job, prepared.blank.bounds, run.setups.size() - 1),
                        std::max(nominal.gouge_mm, nominal.excess_mm) + partUncertainty(run),
                        run.setups.size() > 1};
  const MeshPlacement given =
      run.alignment ? chained(nominal.placement, placementOf(run.alignment->motion)) : nominal.placement;
  PlacementFault fault = placementFault(prepared.nominal->mesh, given, nominal.mesh.unit, space);
  if (fault.text.empty()) return false;
  const auto* mesh = job.stock ? std::get_if<MeshFile>(&*job.stock) : nullptr;
  if (mesh != nullptr && fault.rescaled)
    fault.text +=
        fmt::format("; or the blank is wrong, which was read with unit \"{}\"", meshUnitName(mesh->unit));
  if (fault.comparable) {
    addMeshWarnings({std::move(fault.text)}, "nominal", run.setups.back().interpreted.path.diagnostics);
    return false;
  }
  tellPlacement(std::move(fault.text), run);
  return true;
}

Workload workOf(const Job& job, const PreparedRun& prepared) {
  Workload work;
  for (std::size_t k = 0; k < prepared.run.setups.size(); ++k)
    work = together(work, processOf(job, k).work(job, prepared.run, k, prepared.blank));
  if (const auto* mesh = std::get_if<MeshShape>(&prepared.blank.shape)) {
    work.blank_triangles = static_cast<double>(mesh->mesh.triangles.size());
    work.blank_thin_mm = thinLength(mesh->mesh);
  }
  // Triangles stay as they are made, on flat faces too.
  if (job.simulation.simplify_mm == 0.0) work.unmerged_mm2 = work.surface_mm2;
  work.reads_grid = std::holds_alternative<SavedStock>(prepared.blank.shape);
  work.writes_grid = savesStock(job);
  work.text_files = static_cast<int>(std::count_if(
      job.output.formats.begin(), job.output.formats.end(),
      [](OutputFormat format) { return format == OutputFormat::kStlAscii || format == OutputFormat::kObj; }));
  if (prepared.nominal) work.nominal_mm2 = meshArea(prepared.nominal->mesh);
  if (!job.output.views.empty()) {
    work.pixels = static_cast<double>(job.output.width) * job.output.height;
    work.pictures = static_cast<int>(job.output.views.size()) + (prepared.nominal ? 1 : 0);
  }
  return work;
}

/// Shorter runs are over before anybody asks how long they take: there the machine is not measured.
constexpr double kShortS = 0.15;

/// Whether the blank can be made before it is known what is cut from it: its grid alone is allowed. Not where
/// reading is held to a limit by what the process holds (MemoryLimit).
bool makesBlankEarly(const Job& job, const Blank& blank) {
  if (job.simulation.max_memory_gb > 0.0) return false;
  if (!processOf(job, 0).on_grid || blank.stock || choosesGrid(job, blank)) return false;
  Workload uncut;
  uncut.surface_mm2 = blankArea(blank.shape, blank.bounds);
  const Prediction alone = predict(uncut, blank.resolution_mm);
  return alone.memory_mb <= memoryLimitMb(job) && checkTime(job, alone);
}

/// Measuring moves ask the stock while the programs are read: what that took is known by now.
void addMeasuring(RunResult& run) {
  const auto measures = [](const SetupRun& setup) {
    const std::vector<Motion>& motions = setup.interpreted.path.motions;
    return std::any_of(motions.begin(), motions.end(),
                       [](const Motion& motion) { return motion.kind == MotionKind::kProbe; });
  };
  if (std::any_of(run.setups.begin(), run.setups.end(), measures))
    run.prediction.time_s += run.performance.interpret_s;
}

/// What no lathe turns is refused before anybody predicts the mesh of it: a thread of a lead that is a slip.
Status checkTurned(const RunResult& run) {
  for (const SetupRun& setup : run.setups) {
    if (!processOf(setup.job.control).part_turns) continue;
    if (Status possible = turnable(setup.interpreted.path, setup.job.tools); !possible) return possible;
  }
  return Done{};
}

/// Reads the programs, and predicts the run if they are good.
Status interpretAndPredict(const Job& job, const RunSources& sources, PreparedRun& prepared,
                           Progress& progress) {
  RunResult& run = prepared.run;
  Stopwatch watch;
  if (Status done = interpretAll(job, sources, prepared.blank, run, progress); !done) return done;
  run.performance.interpret_s = watch.lap();
  if (prepared.nominal)
    addMeshWarnings(prepared.nominal->notes, "nominal", run.setups.back().interpreted.path.diagnostics);
  addMeshWarnings(prepared.blank.repairs, "stock", run.setups.front().interpreted.path.diagnostics);
  if (run.alarm) return Done{};
  if (Status possible = checkTurned(run); !possible) return possible;
  const Workload work = workOf(job, prepared);
  double& resolution_mm = prepared.blank.resolution_mm;
  if (!processOf(job, 0).on_grid && !job.simulation.resolution_mm)
    resolution_mm = threadResolution(run, resolution_mm);
  if (choosesGrid(job, prepared.blank))
    resolution_mm = chooseResolution(job, run, prepared.blank, work, memoryLimitMb(job));
  run.resolution_mm = resolution_mm;
  run.prediction = predict(work, run.resolution_mm);
  if (const Status fits = checkMemory(job, work, run.resolution_mm); !fits) return fits;
  if (run.prediction.time_s > kShortS)
    run.prediction = predictedOn(measureMachine(run.prediction.time_s), run.prediction);
  addMeasuring(run);
  return checkTime(job, run.prediction);
}

/// What was found on the part comes before what the grid could not hold.
void tellThinFeaturesLast(std::vector<Finding>& findings) {
  std::stable_partition(findings.begin(), findings.end(),
                        [](const Finding& finding) { return finding.kind != FindingKind::kThinFeature; });
}

/// Compares the finished part with its nominal, which is moved where the job aligns it.
Status compareFinished(const Job& job, const RunSources& sources, PreparedRun& prepared, RunResult& run,
                       Progress& progress) {
  Stopwatch watch;
  Result<std::string> unaligned = alignRun(job, prepared.blank, *prepared.nominal, run, progress);
  if (!unaligned) return unaligned.error();
  if (tellElsewhere(job, prepared, run)) return Done{};
  if (!unaligned->empty()) {
    tellPlacement(std::move(*unaligned), run);
    return Done{};
  }
  if (Status done = compareRun(job, sources, prepared.blank, *prepared.nominal, run, progress); !done)
    return done;
  if (run.comparison) dropRefuted(*run.comparison, run.findings);
  run.performance.compare_s = watch.lap();
  return Done{};
}

/// The same, with `meanwhile` beside it. What fails first stops the other.
Status compareAndWork(const Job& job, const RunSources& sources, PreparedRun& prepared, RunResult& run,
                      Progress& progress, const WorkOnPart& meanwhile) {
  Status compared = Done{}, worked = Done{};
  Progress working(&progress);
  parallelFor(0, meanwhile ? 2 : 1, [&](int part) {
    if (part == 0) {
      compared = compareFinished(job, sources, prepared, run, progress);
      if (!compared) working.cancel();
    } else {
      worked = meanwhile(run.setups.back(), working);
    }
  });
  return compared ? worked : compared;
}

}  // namespace

Result<PreparedRun> prepareRun(const Job& job, const RunSources& sources, Progress& progress) {
  PreparedRun prepared;
  RunResult& run = prepared.run;
  if (const Status level = checkSimdWish(); !level) return level.error();
  Result<Blank> blank = openBlank(job, progress);
  if (!blank) return blank.error();
  const Status start =
      processOf(job, 0).starts_outside ? checkStart(jobOfSetup(job, 0), *blank) : Status(Done{});
  if (!start) return start.error();
  if (const Status place = checkToolChange(jobOfSetup(job, 0), *blank); !place) return place.error();
  if (const Status possible = checkProcesses(job, *blank); !possible) return possible.error();
  prepared.blank = std::move(*blank);
  if (job.nominal) {
    Result<PreparedMesh> nominal = loadNominal(*job.nominal);
    if (!nominal) return nominal.error();
    prepared.nominal = std::move(*nominal);
  }
  run.resolution_mm = prepared.blank.resolution_mm;
  // Programs are read on one thread; another makes the blank meanwhile.
  Status done = Done{};
  std::optional<Stock> early;
  Progress making(&progress);
  const RemovalOptions options = removalOptions(job, run.resolution_mm);  // the reader writes what it is from
  parallelFor(0, makesBlankEarly(job, prepared.blank) ? 2 : 1, [&](int part) {
    if (part == 0) {
      done = interpretAndPredict(job, sources, prepared, progress);
      if (!done || run.alarm) making.cancel();
    } else {
      Result<Stock> stock = Stock::create(prepared.blank.shape, options, making);
      if (stock) early = std::move(*stock);  // else it fails again where it is needed
    }
  });
  if (!done) return done.error();
  if (early) prepared.blank.stock = std::move(early);
  return prepared;
}

Result<RunResult> finishRun(const Job& job, const RunSources& sources, PreparedRun prepared,
                            Progress& progress, const WorkOnPart& meanwhile) {
  RunResult& run = prepared.run;
  if (run.alarm) return std::move(run);
  if (const Status done = machineAll(job, sources, prepared, progress); !done) return done.error();
  tellWordsInForce(sources, run);
  addMeshDefects(run.topology(), run.surface(), run.findings);
  addFreedDefects(run.setups.back().freed_self_intersections, run.findings);
  if (job.stops_early) addUnrunSetups(job.setups.back().name, run.findings);
  const bool something = !run.surface().mesh.triangles.empty();
  Status done = Done{};
  if (something && prepared.nominal) {
    done = compareAndWork(job, sources, prepared, run, progress, meanwhile);
    run.nominal = std::move(prepared.nominal->mesh);
  } else if (something && meanwhile) {
    done = meanwhile(run.setups.back(), progress);
  }
  if (done && something) done = checkPart(job, sources, prepared.blank, run, progress);
  if (!done) return done.error();
  tellThinFeaturesLast(run.findings);
  return std::move(run);
}

Result<RunResult> runRecorded(const Job& job, const RunSources& sources, Progress& progress) {
  Result<PreparedRun> prepared = prepareRun(job, sources, progress);
  if (!prepared) return prepared.error();
  return finishRun(job, sources, std::move(*prepared), progress);
}

Result<RunResult> runJob(const Job& job, Progress& progress) {
  const ThreadSupply threads(job.simulation.threads);
  const JobSources sources(job);
  if (!leavesControl(job)) return runRecorded(job, sources.all(), progress);
  Job told = job;
  if (Status done = chooseControls(told, {sources.all().begin(), sources.all().end()}); !done)
    return done.error();
  return runRecorded(told, sources.all(), progress);
}

Result<RunResult> runJob(const Job& job, const std::vector<const ProgramSource*>& programs,
                         Progress& progress) {
  if (programs.size() != setupCount(job))
    return inputError(
        fmt::format("the job has {} clampings, and there are {} programs", setupCount(job), programs.size()));
  if (job.channels.size() > 1) return inputError("programs in memory are for jobs with one channel");
  const ThreadSupply threads(job.simulation.threads);
  std::vector<std::unique_ptr<RecordingSource>> recorded;
  RunSources sources;
  for (std::size_t k = 0; k < programs.size(); ++k) {
    recorded.push_back(std::make_unique<RecordingSource>(*programs[k], jobOfSetup(job, k).settings.encoding));
    sources.push_back(recorded.back().get());
  }
  if (!leavesControl(job)) return runRecorded(job, sources, progress);
  Job told = job;
  if (Status done = chooseControls(told, programs); !done) return done.error();
  return runRecorded(told, sources, progress);
}

}  // namespace proveout
