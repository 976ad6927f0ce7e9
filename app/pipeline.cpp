#include "app/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/run_report.h"
#include "app/stopwatch.h"
#include "core/base/parallel_for.h"
#include "io/mesh_io.h"
#include "io/sha256.h"

namespace proveout {
namespace {

/// Smallest radius that a tool's cutting surface has, mm: of its corner, or of the wall that it leaves.
double smallestRadius(const Tool& tool) {
  // Corners of bull noses, dovetails and T-slot cutters; the arcs of a profile; the ball of a taper.
  if (tool.corner_radius > 0) return std::min(tool.corner_radius, tool.diameter / 2);
  if (tool.type == ToolType::kTaperBall) return tool.tip_diameter / 2;
  if (tool.type == ToolType::kForm) {
    double radius = tool.diameter / 2;
    for (const OutlinePoint& p : tool.outline) {
      if (p.arc_radius != 0) radius = std::min(radius, std::abs(p.arc_radius));
      if (p.r > 0) radius = std::min(radius, p.r);
    }
    return radius;
  }
  if (tool.type == ToolType::kCone) return std::max(tool.tip_diameter, 0.1 * tool.diameter) / 2;
  return tool.diameter / 2;
}

Result<Comparison> comparePart(const Job& job, const PreparedMesh& nominal, const RunResult& run,
                               Progress& progress) {
  CompareOptions options;
  options.gouge_mm = job.nominal->gouge_mm;
  options.excess_mm = job.nominal->excess_mm;
  options.resolution_mm = run.resolution_mm;
  options.uncertainty_mm = surfaceUncertainty(run.interpreted.path, job.tools, run.resolution_mm);
  options.threads = job.simulation.threads;
  progress.report("comparing", 0.0);
  return compareToNominal(run.surface.mesh, nominal.mesh, options, progress);
}

/// A nominal that the blank cannot hold: the usual reasons are a wrong unit and a wrong place.
std::optional<std::string> misplaced(const Box3& nominal, const Box3& blank, double gouge_mm) {
  const double out = std::max((blank.min - nominal.min).maxCoeff(), (nominal.max - blank.max).maxCoeff());
  if (out <= gouge_mm) return std::nullopt;
  return fmt::format(
      "the nominal reaches {:.4g} mm out of the blank (X{:g} Y{:g} Z{:g} to X{:g} Y{:g} Z{:g}); check its "
      "unit and its place",
      out, nominal.min.x(), nominal.min.y(), nominal.min.z(), nominal.max.x(), nominal.max.y(),
      nominal.max.z());
}

Error outgrown(const Interpreted& interpreted) {
  const SourceRef& at = *interpreted.outgrown_at;
  return Error{ErrorKind::kResourceLimit,
               fmt::format("{}:{}: the tool path outgrows the memory after {} motions: an endless loop? else "
                           "allow more (--max-memory)",
                           at.file < interpreted.path.files.size() ? interpreted.path.files[at.file] : "",
                           at.line, interpreted.path.motions.size())};
}

}  // namespace

void noteRepairs(const PreparedMesh& mesh, const std::string& code, Diagnostics& diagnostics) {
  for (const std::string& note : mesh.notes) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::kWarning;
    diagnostic.code = code;
    diagnostic.message = note;
    diagnostics.add(std::move(diagnostic));
  }
}

Result<PreparedMesh> loadNominal(const NominalSpec& nominal) {
  MeshLoadOptions options;
  options.unit = nominal.mesh.unit;
  const Result<TriMesh> mesh = loadMesh(nominal.mesh.path, options);
  if (!mesh) return mesh.error();
  return prepareNominal(*mesh, nominal.mesh.path);
}

double surfaceUncertainty(const Toolpath& path, const std::vector<Tool>& tools, double resolution_mm) {
  std::set<int> used;
  for (const Motion& motion : path.motions) used.insert(motion.tool);
  double radius = std::numeric_limits<double>::infinity();
  for (const Tool& tool : tools) {
    if (used.contains(tool.number)) radius = std::min(radius, smallestRadius(tool));
  }
  if (!std::isfinite(radius)) return 0.0;
  return std::min(resolution_mm * resolution_mm / (8 * radius), resolution_mm / 2);
}

Result<Machined> machineStock(Blank& blank, const Toolpath& path, const Job& job,
                              ReportPerformance& performance, Progress& progress) {
  Stopwatch watch;
  Result<Stock> stock = takeStock(blank, job, progress);
  if (!stock) return stock.error();
  const RemovalOptions options = removalOptions(job, blank.resolution_mm);
  double initial_mm3 = stock->initialVolume();
  if (std::holds_alternative<SavedStock>(blank.shape)) {  // the stock's own figure is that of its first blank
    const Result<StockSurface> before = stock->surface(job.simulation.threads, progress);
    if (!before) return before.error();
    initial_mm3 = before->volume_mm3;
  }
  Result<RemovalSummary> removal = stock->remove(path, job.tools, options, progress);
  if (!removal) return removal.error();
  performance.remove_s = watch.lap();
  Result<StockSurface> surface = stock->surface(job.simulation.threads, progress);
  if (!surface) return surface.error();
  performance.mesh_s = watch.lap();
  fitRemovedVolume(*removal, initial_mm3 - surface->volume_mm3);
  return Machined{std::move(*stock), std::move(*removal), std::move(*surface), initial_mm3};
}

Result<RunResult> runPipeline(const Job& job, const RecordingSource& source, Progress& progress) {
  RunResult run;
  Result<Blank> blank = openBlank(job, progress);
  if (!blank) return blank.error();
  if (const Status start = checkStart(job, *blank); !start) return start.error();
  std::optional<PreparedMesh> nominal;
  if (job.nominal) {
    Result<PreparedMesh> prepared = loadNominal(*job.nominal);
    if (!prepared) return prepared.error();
    nominal = std::move(*prepared);
    if (auto note = misplaced(meshBounds(nominal->mesh), blank->bounds, job.nominal->gouge_mm))
      nominal->notes.push_back(std::move(*note));
  }
  run.resolution_mm = blank->resolution_mm;

  Stopwatch watch;
  run.interpreted = interpretProgram(job, source, controlSettings(job, blank->bounds), progress);
  run.performance.interpret_s = watch.lap();
  if (run.interpreted.outgrown_at) return outgrown(run.interpreted);
  if (run.interpreted.summary.end == ProgramEnd::kCancelled)
    return Error{ErrorKind::kInterrupted, "interrupted"};
  Toolpath& path = run.interpreted.path;
  if (nominal) noteRepairs(*nominal, "nominal", path.diagnostics);
  run.alarm = !run.interpreted.summary.ok() || !assignTools(path, job.tools, source);
  addAlarms(path, run.findings);
  addOvertravel(path, source, run.findings);
  if (run.alarm) return run;

  Result<Machined> machined = machineStock(*blank, path, job, run.performance, progress);
  if (!machined) return machined.error();
  run.stock = std::move(machined->stock);
  run.removal = std::move(machined->removal);
  run.surface = std::move(machined->surface);
  run.initial_mm3 = machined->initial_mm3;
  parallelFor(0, 2, [&run](int job) {
    if (job == 0) run.topology = analyseTopology(run.surface.mesh);
    if (job == 1) run.part_sha256 = sha256OfMesh(run.surface.mesh);
  });
  addContacts(run.removal.contacts, path, source, run.findings);
  addMeshDefects(run.topology, run.findings);
  run.bodies = stockBodies(run.surface.mesh, run.topology);
  addOutcome(run.initial_mm3, run.surface.volume_mm3, run.bodies, run.findings);
  addPartial(run.interpreted.summary.end, job.settings, run.findings);
  if (!nominal || run.surface.mesh.triangles.empty()) return run;

  watch.lap();
  Result<Comparison> comparison = comparePart(job, *nominal, run, progress);
  if (!comparison) return comparison.error();
  run.comparison = std::move(*comparison);
  addDeviations(*run.comparison, path, source, run.findings);
  run.performance.compare_s = watch.lap();
  return run;
}

}  // namespace proveout
