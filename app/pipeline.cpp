#include "app/pipeline.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/clearance.h"
#include "app/comparison.h"
#include "app/contact_findings.h"
#include "app/diagnosis.h"
#include "app/findings.h"
#include "app/grid_choice.h"
#include "app/nominal_mesh.h"
#include "app/nose_data.h"
#include "app/outputs.h"
#include "app/parted_bodies.h"
#include "app/placement_hint.h"
#include "app/plausibility.h"
#include "app/process/process.h"
#include "app/run_limits.h"
#include "app/run_report.h"
#include "app/spindle_direction.h"
#include "app/tool_offsets.h"
#include "app/turning_work.h"
#include "core/base/parallel_for.h"
#include "core/base/stopwatch.h"
#include "io/sha256.h"

namespace proveout {
namespace {

/// A nominal that the blank cannot hold, or whose bounds agree with the blank's in another unit or at another
/// place (`placement`).
std::optional<std::string> misplaced(const Job& job, const Box3& nominal, const Box3& blank,
                                     const std::optional<Placement>& placement) {
  const double out = std::max((blank.min - nominal.min).maxCoeff(), (nominal.max - blank.max).maxCoeff());
  if (out <= job.nominal->gouge_mm && !placement) return std::nullopt;
  const std::string bounds =
      fmt::format("X{:g} Y{:g} Z{:g} to X{:g} Y{:g} Z{:g}", nominal.min.x(), nominal.min.y(), nominal.min.z(),
                  nominal.max.x(), nominal.max.y(), nominal.max.z());
  std::string text = out > job.nominal->gouge_mm
                         ? fmt::format("the nominal reaches {:.4g} mm out of the blank ({})", out, bounds)
                         : fmt::format("the nominal is much smaller than the blank ({})", bounds);
  if (!placement) return text + "; check its unit and its place";
  text += "; " + placementText(*placement, job.nominal->mesh.unit, "the blank");
  const auto* mesh = job.stock ? std::get_if<MeshFile>(&*job.stock) : nullptr;
  if (mesh != nullptr && placement->scale != 1.0)
    text += fmt::format("; or the blank is wrong, which was read with unit \"{}\"", meshUnitName(mesh->unit));
  return text;
}

/// The same for a nominal whose bounds agree with those of what was machined.
void noteMisplaced(const Job& job, const PreparedMesh& nominal, RunResult& run) {
  const auto placement = evidentPlacement(meshBounds(nominal.mesh), meshBounds(run.surface().mesh));
  if (!placement) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.code = "nominal";
  warning.message = "the nominal: " + placementText(*placement, job.nominal->mesh.unit, "the machined part");
  run.setups.back().interpreted.path.diagnostics.add(std::move(warning));
}

Error outgrown(const Interpreted& interpreted) {
  const SourceRef& at = *interpreted.outgrown_at;
  return Error{ErrorKind::kResourceLimit,
               fmt::format("{}:{}: the tool path outgrows the memory after {} motions: an endless loop? else "
                           "allow more (--max-memory)",
                           at.file < interpreted.path.files.size() ? interpreted.path.files[at.file] : "",
                           at.line, interpreted.path.motions.size())};
}

/// Calls `add`, which adds findings to `run`, and puts the name of the clamping into them.
template <typename Add>
void inSetup(RunResult& run, const SetupRun& setup, const Add& add) {
  const std::size_t before = run.findings.size();
  add(run.findings);
  for (std::size_t i = before; i < run.findings.size(); ++i) run.findings[i].setup = setup.name;
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
    Blank fresh{blank.shape, blank.bounds, blank.resolution_mm, std::nullopt};
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

/// Runs the programs of all clampings on their controls. Sets `alarm` where one is wrong.
Status interpretAll(const Job& job, const RunSources& sources, const Blank& blank, RunResult& run,
                    Progress& progress) {
  for (std::size_t k = 0; k < sources.size(); ++k) {
    SetupRun setup;
    if (!job.setups.empty()) {
      setup.name = job.setups[k].name;
      setup.from_previous = job.setups[k].from_previous;
    }
    setup.job = jobOfSetup(job, k);
    const ControlSettings settings = controlSettings(setup.job, movedBounds(job, blank.bounds, k));
    const ProbedStock stock = probedStock(job, setup, blank, run.setups);
    setup.interpreted = interpretProgram(setup.job, *sources[k], settings, progress, &stock);
    if (setup.interpreted.outgrown_at) return outgrown(setup.interpreted);
    if (setup.interpreted.summary.end == ProgramEnd::kCancelled || progress.cancelled())
      return Error{ErrorKind::kInterrupted, "interrupted"};
    const std::optional<Error>& failure = setup.interpreted.probe_failure;
    if (failure && failure->kind != ErrorKind::kInput) return *failure;
    Toolpath& path = setup.interpreted.path;
    noteLowToolChange(setup.job, movedBounds(job, blank.bounds, k), path.diagnostics);
    addOffsetTools(path, setup.job.tools);
    const bool good = setup.interpreted.summary.ok() && refuseRotaryMotion(path, *sources[k]) &&
                      assignTools(path, setup.job.tools, *sources[k]);
    if (!good) run.alarm = true;
    inSetup(run, setup, [&](std::vector<Finding>& findings) {
      addAlarms(path, findings);
      addOvertravel(path, *sources[k], findings);
      addForbiddenZones(path, *sources[k], findings);
    });
    run.setups.push_back(std::move(setup));
  }
  return Done{};
}

Workload workOf(const Job& job, const PreparedRun& prepared) {
  Workload work;
  for (std::size_t k = 0; k < prepared.run.setups.size(); ++k)
    work = together(work, processOf(job, k).work(job, prepared.run, k, prepared.blank));
  if (const auto* mesh = std::get_if<MeshShape>(&prepared.blank.shape))
    work.blank_triangles = static_cast<double>(mesh->mesh.triangles.size());
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

/// Whether the blank can be made before it is known what is cut from it: its grid alone fits into the memory.
bool makesBlankEarly(const Job& job, const Blank& blank) {
  if (!processOf(job, 0).on_grid || blank.stock || choosesGrid(job, blank)) return false;
  Workload uncut;
  uncut.surface_mm2 = blankArea(blank.shape, blank.bounds);
  return predict(uncut, blank.resolution_mm).memory_mb <= memoryLimitMb(job);
}

/// Reads the programs, and predicts the run if they are good.
Status interpretAndPredict(const Job& job, const RunSources& sources, PreparedRun& prepared,
                           Progress& progress) {
  RunResult& run = prepared.run;
  Stopwatch watch;
  if (Status done = interpretAll(job, sources, prepared.blank, run, progress); !done) return done;
  run.performance.interpret_s = watch.lap();
  if (prepared.nominal)
    noteRepairs(*prepared.nominal, "nominal", run.setups.back().interpreted.path.diagnostics);
  if (run.alarm) return Done{};
  const Workload work = workOf(job, prepared);
  double& resolution_mm = prepared.blank.resolution_mm;
  if (!processOf(job, 0).on_grid && !job.simulation.resolution_mm)
    resolution_mm = threadResolution(run, resolution_mm);
  if (choosesGrid(job, prepared.blank))
    resolution_mm = chooseResolution(job, run, prepared.blank, work, memoryLimitMb(job));
  run.resolution_mm = resolution_mm;
  run.prediction = predict(work, run.resolution_mm);
  if (const Status fits = checkMemory(job, work, run.resolution_mm); !fits) return fits;
  return checkTime(job, run.prediction);
}

/// Takes over what a clamping made of its workpiece. Returns how many of its bodies are to be told of: not
/// what fell off before, and of turned parts not what is told by what parted it.
std::size_t keep(Machined&& made, SetupRun& setup, ReportPerformance& performance) {
  performance.remove_s += made.remove_s;
  performance.mesh_s += made.mesh_s;
  setup.initial_mm3 = made.initial_mm3;
  setup.removal = std::move(made.removal);
  setup.surface = std::move(made.surface);
  setup.turned = std::move(made.turned);
  setup.facet_error_mm = made.facet_error_mm;
  parallelFor(0, 3, [&setup](int part) {
    if (part == 0) setup.topology = analyseTopology(setup.surface.mesh);
    if (part == 1) setup.mesh_sha256 = sha256OfMesh(setup.surface.mesh);
    if (part == 2) setup.extent = meshExtent(setup.surface.mesh);
  });
  if (made.bodies) {
    setup.bodies = std::move(*made.bodies);
    return std::min<std::size_t>(setup.bodies.size(), 1);
  }
  setup.bodies = stockBodies(setup.surface.mesh, setup.topology, setup.extent);
  const std::size_t told = setup.bodies.size();
  setup.bodies.insert(setup.bodies.end(), made.apart.begin(), made.apart.end());
  return told;
}

/// Findings on what a clamping made. `touched`: those of its fixtures.
void lookAt(const SetupRun& setup, std::size_t told_bodies, const RecordingSource& source,
            std::vector<Finding>&& touched, RunResult& run) {
  inSetup(run, setup, [&](std::vector<Finding>& findings) {
    addContacts(setup.removal.contacts, setup.job.simulation.contact_mm, setup.turned != nullptr,
                setup.interpreted.path, source, findings);
    findings.insert(findings.end(), touched.begin(), touched.end());
    std::vector<StockBody> bodies = setup.bodies;
    bodies.resize(told_bodies);
    addOutcome(setup.initial_mm3, setup.surface.volume_mm3, bodies, findings);
    const NominalSpec tolerance = setup.job.nominal.value_or(NominalSpec{});
    const double least_mm = std::min(tolerance.gouge_mm, tolerance.excess_mm);
    addNoseFindings(setup, least_mm, source, findings);
    addToolOffsets(setup, least_mm, source, findings);
    addImplausible(setup, source, findings);
    addPartedBodies(setup, source, findings);
    if (!processOf(setup.job.control).part_turns)
      addSpindleDirection(setup.interpreted.path, setup.removal.removed_mm3, setup.job.tools, source,
                          findings);
    addVolumeError(setup.initial_mm3 - setup.surface.volume_mm3, setup.surface.volume_error_mm3,
                   run.resolution_mm, findings);
    addThinFeatures(setup.removal, setup.surface, run.resolution_mm, setup.interpreted.path, source,
                    findings);
    addPartial(setup.interpreted.summary.end, setup.job.settings, findings);
  });
}

/// Bounds of the nominal in the frame of a clamping.
Box3 nominalIn(const Job& job, const TriMesh& nominal, std::size_t setup) {
  Box3 bounds = meshBounds(nominal);
  for (std::size_t k = setupCount(job); k-- > setup + 1;)
    bounds = job.setups[k].from_previous.inverse()(bounds);
  return bounds;
}

PieceOptions pieceOptions(const Job& job, const PreparedRun& prepared, std::size_t k) {
  const SetupRun& setup = prepared.run.setups[k];
  PieceOptions options;
  options.grid = removalOptions(setup.job, prepared.run.resolution_mm);
  options.surface = surfaceOptions(setup.job, prepared.run.resolution_mm);
  options.facet_mm = facetTolerance(setup.job);
  options.keeps_grid = k + 1 == setupCount(job) && savesStock(job);
  if (prepared.nominal && processOf(job, k).part_turns)
    options.part = nominalIn(job, prepared.nominal->mesh, k);
  options.grid_fits = [&job, &prepared] {
    return checkMemory(job, turnedGridWork(prepared.blank), prepared.run.resolution_mm);
  };
  return options;
}

/// Machines the workpiece in all clampings, one after the other.
Status machineAll(const Job& job, const RunSources& sources, PreparedRun& prepared, Progress& progress) {
  RunResult& run = prepared.run;
  Stopwatch watch;
  std::unique_ptr<Workpiece> piece;
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    SetupRun& setup = run.setups[k];
    const Process& process = processOf(job, k);
    const PieceOptions options = pieceOptions(job, prepared, k);
    Result<std::unique_ptr<Fixtures>> fixtures = process.fixtures(setup, run.resolution_mm, progress);
    if (!fixtures) return fixtures.error();
    watch.lap();
    Result<std::unique_ptr<Workpiece>> clamped =
        k == 0 ? process.make(prepared.blank, job, progress)
               : piece->become(process.kind, setup.from_previous, options, progress);
    if (!clamped) return clamped.error();
    piece = std::move(*clamped);
    run.performance.remove_s += watch.lap();
    Result<Machined> made = piece->machine(setup.interpreted.path, setup.job.tools, options, progress);
    if (!made) return made.error();
    if (made->holding)
      inSetup(run, setup, [&](std::vector<Finding>& findings) {
        addGridVolume(made->holding->own_mm3, made->holding->held_mm3, run.resolution_mm, findings);
      });
    const std::size_t told_bodies = keep(std::move(*made), setup, run.performance);
    std::vector<Finding> touched;
    if (Status done = (*fixtures)->addContacts(setup, *sources[k], touched, progress); !done) return done;
    lookAt(setup, told_bodies, *sources[k], std::move(touched), run);
    if (setup.surface.mesh.triangles.empty()) {
      run.setups.resize(k + 1);  // there is nothing to clamp again
    }
  }
  run.stock = piece->takeGrid();
  return Done{};
}

/// What was found on the part comes before what the grid could not hold.
void tellThinFeaturesLast(std::vector<Finding>& findings) {
  std::stable_partition(findings.begin(), findings.end(),
                        [](const Finding& finding) { return finding.kind != "thin_feature"; });
}

}  // namespace

Result<PreparedRun> prepareRun(const Job& job, const RunSources& sources, Progress& progress) {
  PreparedRun prepared;
  RunResult& run = prepared.run;
  Result<Blank> blank = openBlank(job, progress);
  if (!blank) return blank.error();
  if (const Status start = checkStart(jobOfSetup(job, 0), *blank); !start) return start.error();
  if (const Status place = checkToolChange(jobOfSetup(job, 0), *blank); !place) return place.error();
  if (const Status possible = checkProcesses(job, *blank); !possible) return possible.error();
  prepared.blank = std::move(*blank);
  const Box3& bounds = prepared.blank.bounds;
  if (job.nominal) {
    Result<PreparedMesh> nominal = loadNominal(*job.nominal);
    if (!nominal) return nominal.error();
    const Box3 wanted = movedBounds(job, bounds, sources.size() - 1), given = meshBounds(nominal->mesh);
    const auto placement = evidentPlacement(given, wanted);
    if (auto note = misplaced(job, given, wanted, placement)) nominal->notes.push_back(std::move(*note));
    prepared.placement_told = placement.has_value();
    prepared.nominal = std::move(*nominal);
  }
  run.resolution_mm = prepared.blank.resolution_mm;
  // Programs are read on one thread; another makes the blank meanwhile.
  Status done = Done{};
  std::optional<Stock> early;
  Progress making(&progress);
  parallelFor(0, makesBlankEarly(job, prepared.blank) ? 2 : 1, [&](int part) {
    if (part == 0) {
      done = interpretAndPredict(job, sources, prepared, progress);
      if (!done || run.alarm) making.cancel();
    } else {
      const RemovalOptions options = removalOptions(job, run.resolution_mm);
      Result<Stock> stock = Stock::create(prepared.blank.shape, options, making);
      if (stock) early = std::move(*stock);  // else it fails again where it is needed
    }
  });
  if (!done) return done.error();
  if (early) prepared.blank.stock = std::move(early);
  return prepared;
}

Result<RunResult> finishRun(const Job& job, const RunSources& sources, PreparedRun prepared,
                            Progress& progress) {
  RunResult& run = prepared.run;
  if (run.alarm) return std::move(run);
  if (const Status done = machineAll(job, sources, prepared, progress); !done) return done.error();
  tellWordsInForce(sources, run);
  addMeshDefects(run.topology(), run.surface(), run.findings);
  if (job.stops_early) addUnrunSetups(job.setups.back().name, run.findings);
  if (!prepared.nominal || run.surface().mesh.triangles.empty()) {
    tellThinFeaturesLast(run.findings);
    return std::move(run);
  }

  if (!prepared.placement_told) noteMisplaced(job, *prepared.nominal, run);
  Stopwatch watch;
  if (const Status done = compareRun(job, sources, prepared.blank, *prepared.nominal, run, progress); !done)
    return done.error();
  if (run.comparison) dropRefuted(*run.comparison, run.findings);
  if (run.setups.back().turned) run.nominal = std::move(prepared.nominal->mesh);
  run.performance.compare_s = watch.lap();
  tellThinFeaturesLast(run.findings);
  return std::move(run);
}

Result<RunResult> runPipeline(const Job& job, const RunSources& sources, Progress& progress) {
  Result<PreparedRun> prepared = prepareRun(job, sources, progress);
  if (!prepared) return prepared.error();
  return finishRun(job, sources, std::move(*prepared), progress);
}

}  // namespace proveout
