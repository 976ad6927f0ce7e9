#include "app/session/machining/machining.h"

#include <algorithm>

#include "app/session/findings/contact_findings.h"
#include "app/session/findings/drill_moves.h"
#include "app/session/findings/findings.h"
#include "app/session/findings/nose_data.h"
#include "app/session/findings/parted_bodies.h"
#include "app/session/findings/plausibility.h"
#include "app/session/findings/setup_findings.h"
#include "app/session/findings/spindle_direction.h"
#include "app/session/findings/tool_offsets.h"
#include "app/session/forecast/run_limits.h"
#include "app/session/machining/stock_bodies.h"
#include "app/session/nominal/nominal_mesh.h"
#include "app/session/process/turning_work.h"
#include "app/session/program_checks/program_checks.h"
#include "app/session/run/process.h"
#include "core/base/parallel_for.h"
#include "core/base/stopwatch.h"
#include "core/mesh/mesh_placement.h"
#include "io/sha256.h"
#include "removal/process/part_choice.h"

namespace proveout {
namespace {

/// What says which body of a mesh is the part, frame of the clamping.
struct PartWish {
  std::optional<Vec3> point;
  std::optional<Box3> nominal;
};

/// The bodies that the mesh of a clamping bounds. Error: the point of the part is in none of them.
Status takeBodies(const PartWish& wish, double clamped_mm3, SetupRun& setup) {
  std::optional<Box3> wanted = wish.nominal;
  const bool any = !setup.surface.mesh.triangles.empty();
  if (wish.point && any) {
    wanted = pieceAround(setup.surface.mesh, *wish.point);
    if (!wanted) return inputError(pointInNoBody(*wish.point));
  }
  setup.bodies = stockBodies(setup.surface.mesh, setup.topology, setup.extent, clamped_mm3, wanted);
  std::vector<double> volumes;
  for (const StockBody& body : setup.bodies) volumes.push_back(body.volume_mm3);
  if (!any || volumes.empty()) return Done{};
  const PartChoice doubt = doubted(0, volumes);
  const bool small = volumes.front() < kNotableShare * *std::max_element(volumes.begin(), volumes.end());
  if (!wish.point && (!wish.nominal || small)) setup.rival = doubt.rival;
  return Done{};
}

/// Takes over what a clamping made of its workpiece. Returns how many of its bodies are to be told of: not
/// what fell off before, and of turned parts not what is told by what parted it.
Result<std::size_t> keep(Machined&& made, const PartWish& wish, SetupRun& setup,
                         ReportPerformance& performance) {
  performance.remove_s += made.remove_s;
  performance.mesh_s += made.mesh_s;
  setup.initial_mm3 = made.initial_mm3;
  setup.initial_error_mm3 = made.initial_error_mm3;
  setup.removal = std::move(made.removal);
  setup.surface = std::move(made.surface);
  setup.form = std::move(made.form);
  setup.facet_error_mm = made.facet_error_mm;
  setup.freed = std::move(made.freed);
  setup.freed_self_intersections = made.freed_self_intersections;
  parallelFor(0, 3, [&setup](int part) {
    if (part == 0) setup.topology = analyseTopology(setup.surface.mesh);
    if (part == 1) setup.mesh_sha256 = sha256OfMesh(setup.surface.mesh);
    if (part == 2) setup.extent = meshExtent(setup.surface.mesh);
  });
  if (made.bodies) {
    setup.bodies = std::move(*made.bodies);
    setup.mesh_bodies = made.mesh_bodies;
    setup.rival = made.rival;
    return std::min<std::size_t>(setup.bodies.size(), 1);
  }
  double clamped_mm3 = setup.surface.volume_mm3;
  for (const StockBody& body : made.apart) clamped_mm3 -= body.volume_mm3;
  if (const Status taken = takeBodies(wish, clamped_mm3, setup); !taken) return taken.error();
  const std::size_t told = setup.mesh_bodies = setup.bodies.size();
  setup.bodies.insert(setup.bodies.end(), made.apart.begin(), made.apart.end());
  return told;
}

/// The program of a clamping, with what that began with.
CheckedProgram programOf(const PreparedRun& prepared, std::size_t k, const RecordingSource& source) {
  const SetupRun& setup = prepared.run.setups[k];
  CheckedProgram program{setup.job, setup.interpreted.path, source};
  if (k == 0) {
    program.blank = prepared.blank.bounds;
    program.shape = &prepared.blank.shape;
  } else {
    const TriMesh& left = prepared.run.setups[k - 1].surface.mesh;
    program.blank = boundsMoved(setup.from_previous, left);
    program.left_before.emplace(LeftBefore{left, setup.from_previous});
  }
  return program;
}

/// Findings on what a clamping made. `touched`: those of its fixtures.
void lookAt(const SetupRun& setup, const CheckedProgram& program, std::size_t told_bodies,
            std::vector<Finding>&& touched, RunResult& run) {
  const RecordingSource& source = program.texts;
  inSetup(run, setup, [&](std::vector<Finding>& findings) {
    addContacts(setup.removal.contacts, setup.job.simulation.contact_mm, setup.interpreted.path, source,
                findings);
    findings.insert(findings.end(), touched.begin(), touched.end());
    std::vector<StockBody> bodies = setup.bodies;
    bodies.resize(told_bodies);
    addOutcome(setup.initial_mm3, setup.surface.volume_mm3, bodies, findings);
    addUncertainPart(setup.bodies, setup.rival, findings);
    const NominalSpec tolerance = setup.job.nominal.value_or(NominalSpec{});
    const double least_mm = std::min(tolerance.gouge_mm, tolerance.excess_mm);
    addNoseFindings(setup, least_mm, source, findings);
    addToolOffsets(setup, least_mm, source, findings);
    addImplausible(setup, source, findings);
    addProgramFindings(program, findings);
    addPartedBodies(setup, source, findings);
    const Process& process = processOf(setup.job.control);
    if (process.look != nullptr) process.look(setup, source, findings);
    if (process.tool_turns) {
      addSpindleDirection(setup.interpreted.path, setup.removal.removed_mm3, setup.job.tools, source,
                          findings);
      addDrillMoves(setup.interpreted.path, setup.removal.removed_mm3, setup.job.tools, source, findings);
    }
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
  options.facet_mm = processOf(job, k).part_turns ? turnedFacets(setup.job) : facetTolerance(setup.job);
  options.keeps_grid = k + 1 == setupCount(job) && savesStock(job);
  if (prepared.nominal && !processOf(job, k).on_grid)
    options.part = nominalIn(job, prepared.nominal->mesh, k);
  options.part_alone = writesBodies(job);
  options.part_point = job.part_point;
  for (std::size_t i = 1; options.part_point && i <= k; ++i)
    options.part_point = job.setups[i].from_previous(*options.part_point);
  options.grid_fits = [&job, &prepared] {
    return checkMemory(job, turnedGridWork(prepared.blank), prepared.run.resolution_mm);
  };
  return options;
}

}  // namespace

Status machineAll(const Job& job, const RunSources& sources, PreparedRun& prepared, Progress& progress) {
  RunResult& run = prepared.run;
  Stopwatch watch;
  std::unique_ptr<Workpiece> piece;
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    SetupRun& setup = run.setups[k];
    const Process& process = processOf(job, k);
    PieceOptions options = pieceOptions(job, prepared, k);
    Result<std::unique_ptr<Fixtures>> fixtures = process.fixtures(setup, run.resolution_mm, progress);
    if (!fixtures) return fixtures.error();
    addMeshWarnings((*fixtures)->repairs(), "fixture", setup.interpreted.path.diagnostics);
    (*fixtures)->hold(movedBounds(job, prepared.blank.bounds, k), options);
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
    const bool in_mesh = !made->bodies.has_value();
    PartWish wish{options.part_point, std::nullopt};
    if (in_mesh && prepared.nominal) wish.nominal = nominalIn(job, prepared.nominal->mesh, k);
    const Result<std::size_t> told = keep(std::move(*made), wish, setup, run.performance);
    if (!told) return told.error();
    std::vector<Finding> touched;
    if (Status done = (*fixtures)->addContacts(setup, *sources[k], touched, progress); !done) return done;
    lookAt(setup, programOf(prepared, k, *sources[k]), *told, std::move(touched), run);
    if (setup.surface.mesh.triangles.empty()) {
      run.setups.resize(k + 1);  // there is nothing to clamp again
    } else if (in_mesh && k + 1 < run.setups.size()) {
      piece->letFall({setup.bodies.begin(), setup.bodies.begin() + static_cast<std::ptrdiff_t>(*told)});
    }
  }
  run.stock = piece->takeGrid();
  return Done{};
}

}  // namespace proveout
