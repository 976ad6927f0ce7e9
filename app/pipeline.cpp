#include "app/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "app/clearance.h"
#include "app/comparison.h"
#include "app/contact_findings.h"
#include "app/diagnosis.h"
#include "app/findings.h"
#include "app/fixtures.h"
#include "app/grid_choice.h"
#include "app/nominal_mesh.h"
#include "app/nose_data.h"
#include "app/outputs.h"
#include "app/placement_hint.h"
#include "app/plausibility.h"
#include "app/run_limits.h"
#include "app/run_report.h"
#include "app/spindle_direction.h"
#include "app/stopwatch.h"
#include "app/tool_offsets.h"
#include "app/turning.h"
#include "app/turning_work.h"
#include "core/base/parallel_for.h"
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

/// The stock that the program behind the clampings in `before` starts with, cut by their programs.
ProbedStock probedStock(const Job& job, const SetupRun& setup, const Blank& blank,
                        const std::vector<SetupRun>& before) {
  ProbedStock probed;
  probed.options = removalOptions(setup.job, blank.resolution_mm);
  probed.tools = setup.job.tools;
  if (before.empty()) probed.blank = &blank.shape;
  probed.make = [&job, &setup, &blank, &before](Progress& progress) -> Result<Stock> {
    const RemovalOptions options = removalOptions(job, blank.resolution_mm);
    Result<Stock> stock = Stock::create(blank.shape, options, progress);
    for (std::size_t k = 0; stock && k < before.size(); ++k) {
      const Result<RemovalSummary> cut =
          stock->remove(before[k].interpreted.path, before[k].job.tools, options, progress);
      if (!cut) return cut.error();
      const RigidTransform& move = k + 1 < before.size() ? before[k + 1].from_previous : setup.from_previous;
      stock = stock->moved(move, options, progress);
    }
    return stock;
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
  const double area = blankArea(prepared.blank.shape, prepared.blank.bounds);
  Workload work;
  for (std::size_t k = 0; k < prepared.run.setups.size(); ++k) {
    const SetupRun& setup = prepared.run.setups[k];
    if (turnsPart(job)) {
      work = together(work, turningWork(setup, prepared.blank));
      continue;
    }
    Workload part =
        workloadOf(setup.interpreted.path, setup.job.tools, movedBounds(job, prepared.blank.bounds, k), area);
    const FixtureAreas fixtures = fixtureAreas(setup);
    part.fixture_mm2 = fixtures.solids_mm2 + fixtures.meshes_mm2;
    part.fixture_mesh_mm2 = fixtures.meshes_mm2;
    work = together(work, part);
  }
  if (const auto* mesh = std::get_if<MeshShape>(&prepared.blank.shape))
    work.blank_triangles = static_cast<double>(mesh->mesh.triangles.size());
  work.reads_grid = std::holds_alternative<SavedStock>(prepared.blank.shape);
  work.writes_grid = savesStock(job);
  work.text_files = static_cast<int>(std::count_if(
      job.output.formats.begin(), job.output.formats.end(),
      [](OutputFormat format) { return format == OutputFormat::kStlAscii || format == OutputFormat::kObj; }));
  for (std::size_t k = 1; k < setupCount(job) && !turnsPart(job); ++k)
    work.mesh_moves += movesExactly(job.setups[k].from_previous) ? 0 : 1;
  if (prepared.nominal) work.nominal_mm2 = meshArea(prepared.nominal->mesh);
  if (!job.output.views.empty()) {
    work.pixels = static_cast<double>(job.output.width) * job.output.height;
    work.pictures = static_cast<int>(job.output.views.size()) + (prepared.nominal ? 1 : 0);
  }
  return work;
}

/// Whether the blank can be made before it is known what is cut from it: its grid alone fits into the memory.
bool makesBlankEarly(const Job& job, const Blank& blank) {
  if (turnsPart(job) || blank.stock || choosesGrid(job, blank)) return false;
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
  if (turnsPart(job) && !job.simulation.resolution_mm) {
    prepared.blank.resolution_mm = threadResolution(run, prepared.blank.resolution_mm);
    run.resolution_mm = prepared.blank.resolution_mm;
  } else if (choosesGrid(job, prepared.blank)) {
    prepared.blank.resolution_mm = chooseResolution(job, run, prepared.blank, work, memoryLimitMb(job));
    run.resolution_mm = prepared.blank.resolution_mm;
  }
  run.prediction = predict(work, run.resolution_mm);
  if (const Status fits = checkMemory(job, work, run.resolution_mm); !fits) return fits;
  return checkTime(job, run.prediction);
}

/// Part of the volume up to which the integral over the grid's crossings is the closed form but for rounding.
constexpr double kSameVolume = 1e-6;

/// Volume of what a run starts with: what the grid holds of it, as all volumes behind it are integrals over
/// that grid. Where the blank's own volume is the same but for rounding, that.
double startVolume(const Blank& blank, double own_mm3, double held_mm3) {
  const bool same = std::abs(held_mm3 - own_mm3) <= kSameVolume * own_mm3;
  return same && !std::holds_alternative<SavedStock>(blank.shape) ? own_mm3 : held_mm3;
}

/// What a clamping made, looked at: topology, bodies, findings.
void lookAt(SetupRun& setup, const RecordingSource& source, std::vector<Finding>&& touched, RunResult& run) {
  parallelFor(0, 3, [&setup](int part) {
    if (part == 0) setup.topology = analyseTopology(setup.surface.mesh);
    if (part == 1) setup.mesh_sha256 = sha256OfMesh(setup.surface.mesh);
    if (part == 2) setup.extent = meshExtent(setup.surface.mesh);
  });
  if (!setup.turned) setup.bodies = stockBodies(setup.surface.mesh, setup.topology, setup.extent);
  inSetup(run, setup, [&](std::vector<Finding>& findings) {
    addContacts(setup.removal.contacts, setup.job.simulation.contact_mm, setup.turned != nullptr,
                setup.interpreted.path, source, findings);
    findings.insert(findings.end(), touched.begin(), touched.end());
    std::vector<StockBody> bodies = setup.bodies;
    if (setup.turned && bodies.size() > 1) bodies.resize(1);  // the others are told of by what parted them
    addOutcome(setup.initial_mm3, setup.surface.volume_mm3, bodies, findings);
    const NominalSpec tolerance = setup.job.nominal.value_or(NominalSpec{});
    const double least_mm = std::min(tolerance.gouge_mm, tolerance.excess_mm);
    addNoseFindings(setup, least_mm, source, findings);
    addToolOffsets(setup, least_mm, source, findings);
    addImplausible(setup, source, findings);
    addPartedBodies(setup, source, findings);
    if (!setup.turned)
      addSpindleDirection(setup.interpreted.path, setup.removal.removed_mm3, setup.job.tools, source,
                          findings);
    addVolumeError(setup.initial_mm3 - setup.surface.volume_mm3, setup.surface.volume_error_mm3,
                   run.resolution_mm, findings);
    addThinFeatures(setup.removal, setup.surface, run.resolution_mm, setup.interpreted.path, source,
                    findings);
    addPartial(setup.interpreted.summary.end, setup.job.settings, findings);
  });
}

/// What a path took, mm3: by the integrals over one grid before and after it, so that what no tool reached
/// cancels. Where walls share cells these may be off by more than little cuts take, even below 0; then what
/// the columns of the grid count stands. `initial_mm3`: as the report tells it; a move onto another grid may
/// have made more of it than there was, and then what is left is what the grid holds.
double removedVolume(const RemovalSummary& removal, double initial_mm3, double before_mm3, double after_mm3) {
  const double counted = std::accumulate(removal.removed_mm3.begin(), removal.removed_mm3.end(), 0.0);
  const double removed_mm3 = after_mm3 <= before_mm3 ? before_mm3 - after_mm3 : std::min(counted, before_mm3);
  if (removed_mm3 <= initial_mm3) return removed_mm3;
  return initial_mm3 - std::clamp(after_mm3, 0.0, initial_mm3);
}

/// Cuts the path of a clamping into the stock and fills removal, surface and volume. The stock comes from the
/// blank, or from the clamping before. `initial_mm3`: its volume as the report tells it, `held`: as
/// Stock::volume tells it now; what is left is the first less what the second falls by. The surface's error
/// is that of what was removed.
Status machineSetup(Stock& stock, double initial_mm3, const StockVolume& held, SetupRun& setup,
                    ReportPerformance& performance, Progress& progress) {
  Stopwatch watch;
  const RemovalOptions options = removalOptions(setup.job, stock.resolution());
  Result<RemovalSummary> removal = stock.remove(setup.interpreted.path, setup.job.tools, options, progress);
  if (!removal) return removal.error();
  performance.remove_s += watch.lap();
  Result<StockSurface> surface = stock.surface(surfaceOptions(setup.job, stock.resolution()), progress);
  if (!surface) return surface.error();
  performance.mesh_s += watch.lap();
  const double removed_mm3 = surface->mesh.triangles.empty()
                                 ? initial_mm3  // whatever moves and rounding made of it
                                 : removedVolume(*removal, initial_mm3, held.mm3, surface->volume_mm3);
  surface->volume_mm3 = initial_mm3 - removed_mm3;
  // Faces that no tool reached are as wrong before as after.
  surface->volume_error_mm3 = std::abs(surface->volume_error_mm3 - held.error_mm3);
  fitRemovedVolume(*removal, removed_mm3);
  setup.removal = std::move(*removal);
  setup.surface = std::move(*surface);
  setup.initial_mm3 = initial_mm3;
  return Done{};
}

/// Cuts all clampings, one after the other.
Status machineAll(Blank& blank, const Job& job, const RunSources& sources, RunResult& run,
                  Progress& progress) {
  Stopwatch watch;
  Result<Stock> stock = takeStock(blank, job, progress);
  if (!stock) return stock.error();
  run.performance.remove_s += watch.lap();
  // What is clamped: as the report tells it, and by its own shape.
  double left_mm3 = 0.0, own_mm3 = stock->initialVolume();
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    SetupRun& setup = run.setups[k];
    Result<std::vector<FixtureStock>> fixtures = makeFixtures(setup, run.resolution_mm, progress);
    if (!fixtures) return fixtures.error();
    if (k > 0) {
      watch.lap();
      stock = stock->moved(setup.from_previous, removalOptions(job, blank.resolution_mm), progress);
      if (!stock) return stock.error();
      run.performance.remove_s += watch.lap();
    }
    const Result<StockVolume> held = stock->volume(surfaceOptions(setup.job, stock->resolution()), progress);
    if (!held) return held.error();
    run.performance.remove_s += watch.lap();
    if (k > 0 || !std::holds_alternative<SavedStock>(blank.shape))
      inSetup(run, setup, [&](std::vector<Finding>& findings) {
        addGridVolume(own_mm3, held->mm3, run.resolution_mm, findings);
      });
    const double initial_mm3 = k == 0 ? startVolume(blank, own_mm3, held->mm3) : left_mm3;
    if (Status done = machineSetup(*stock, initial_mm3, *held, setup, run.performance, progress); !done)
      return done;
    left_mm3 = setup.surface.volume_mm3;
    own_mm3 = held->mm3 - (initial_mm3 - left_mm3);
    std::vector<Finding> touched;
    if (Status done = addFixtureContacts(*fixtures, setup, *sources[k], touched, progress); !done)
      return done;
    lookAt(setup, *sources[k], std::move(touched), run);
    if (setup.surface.mesh.triangles.empty()) {
      run.setups.resize(k + 1);  // there is nothing to clamp again
    }
  }
  run.stock = std::move(*stock);
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
  if (turnsPart(job)) {
    if (const Status possible = checkTurning(job, *blank); !possible) return possible.error();
  }
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
  if (turnsPart(job)) {
    const TriMesh* const nominal = prepared.nominal ? &prepared.nominal->mesh : nullptr;
    if (const Status done = machineTurned(job, prepared.blank, nominal, run, progress); !done)
      return done.error();
    for (std::size_t k = 0; k < run.setups.size(); ++k) {
      std::vector<Finding> touched;
      if (const Status done = addTurnedFixtureContacts(run.setups[k], *sources[k], touched, progress); !done)
        return done.error();
      lookAt(run.setups[k], *sources[k], std::move(touched), run);
    }
  } else if (const Status done = machineAll(prepared.blank, job, sources, run, progress); !done) {
    return done.error();
  }
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
  if (turnsPart(job)) run.nominal = std::move(prepared.nominal->mesh);
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
