#include "app/run_report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <thread>

#include "app/input_files.h"
#include "app/session/findings/feature_table.h"
#include "app/session/findings/findings.h"
#include "app/session/findings/uncertainty.h"
#include "app/session/forecast/run_limits.h"
#include "app/session/nominal/alignment.h"
#include "app/session/part_check.h"
#include "app/session/process/turning_work.h"
#include "app/session/run/process.h"
#include "core/base/assert.h"
#include "core/tool/tool_table.h"
#include "io/mesh_io.h"
#include "io/sha256.h"

namespace proveout {
namespace {

/// Tools of one number may differ from clamping to clamping.
using ToolUses = std::map<std::pair<int, std::string>, ToolUse>;

/// Adds what the motions of one clamping did. `tools`: those that the job names for it.
void addUses(const SetupRun& run, const std::vector<Tool>& tools, ToolUses& uses) {
  std::map<int, ToolUse*> of_number;
  const auto useOf = [&](int number) -> ToolUse& {
    ToolUse*& use = of_number[number];
    if (use != nullptr) return *use;
    const Tool* tool = ToolTable(tools).find(number);
    const std::string description = tool == nullptr ? "" : describe(*tool);
    use = &uses[{number, description}];
    use->number = number;
    use->description = description;
    if (tool != nullptr) use->name = tool->name;
    return *use;
  };
  const auto& motions = run.interpreted.path.motions;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    ToolUse& use = useOf(motions[i].tool);
    (motions[i].kind == MotionKind::kRapid ? use.rapid_s : use.cutting_s) += motions[i].time_s;
    if (i < run.removal.removed_mm3.size())
      use.removed_mm3 += static_cast<double>(run.removal.removed_mm3[i]);
    ++use.motions;
  }
}

ReportTime reportTime(const Job& job, const RunResult& run) {
  ReportTime time;
  ToolUses uses;
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    const SetupRun& setup = run.setups[k];
    const InterpretSummary& summary = setup.interpreted.summary;
    time.cycle_s += summary.cycle_s;
    time.cutting_s += summary.cutting_s;
    time.rapid_s += summary.rapid_s;
    addUses(setup, jobOfSetup(job, k).tools, uses);
  }
  for (auto& [key, use] : uses) time.per_tool.push_back(use);
  return time;
}

ReportProgram reportProgram(const Job& job, const RunResult& run) {
  ReportProgram program;
  program.control = fmt::format("{}", fmt::join(controlsOf(job), ", "));
  for (const SetupRun& setup : run.setups) {
    const Toolpath& path = setup.interpreted.path;
    for (const std::string& file : path.files) {
      if (std::find(program.files.begin(), program.files.end(), file) == program.files.end())
        program.files.push_back(file);
    }
    program.blocks += path.blocks;
    program.motions += path.motions.size();
    if (setup.interpreted.summary.end == ProgramEnd::kUntil) program.until = untilText(setup.job.settings);
  }
  return program;
}

std::vector<ReportSetup> reportSetups(const Job& job, const RunResult& run) {
  std::vector<ReportSetup> setups;
  if (job.setups.empty()) return setups;
  for (const SetupRun& setup : run.setups) {
    const Toolpath& path = setup.interpreted.path;
    setups.push_back({setup.name, path.files.empty() ? "" : path.files.front(), path.blocks,
                      path.motions.size(), setup.interpreted.summary.cycle_s,
                      setup.initial_mm3 - setup.surface.volume_mm3, setup.surface.volume_mm3,
                      controlsOf(job).size() > 1 ? setup.job.control : ""});
  }
  return setups;
}

ReportStock reportStock(const RunResult& run) {
  ReportStock stock;
  stock.initial_mm3 = run.setups.front().initial_mm3;
  stock.initial_error_mm3 = run.setups.front().initial_error_mm3;
  stock.final_mm3 = run.surface().volume_mm3;
  stock.removed_mm3 = stock.initial_mm3 - stock.final_mm3;
  // Volumes of sections are closed forms; those of a grid are so where nothing was cut.
  const auto isExact = [](const SetupRun& setup) {
    return setup.surface.volume_error_mm3 == 0.0 &&
           (setup.facet_error_mm > 0.0 || setup.surface.volume_mm3 == setup.initial_mm3);
  };
  for (const SetupRun& setup : run.setups) stock.error_mm3 += setup.surface.volume_error_mm3;
  stock.exact = std::ranges::all_of(run.setups, isExact);
  stock.mesh_mm3 = run.setups.back().extent.volume_mm3;
  stock.bodies = run.setups.back().bodies;
  stock.mesh_bodies = run.setups.back().mesh_bodies;
  stock.triangles = run.surface().mesh.triangles.size();
  stock.vertices = run.surface().mesh.positions.size();
  stock.closed = run.topology().closedManifold();
  return stock;
}

ErrorTerm gridTerm(const RunResult& run, double bound_mm) {
  return {"grid", bound_mm,
          fmt::format("facets of the mesh between exact crossings of a {:g} mm grid{}", run.resolution_mm,
                      processOf(run.setups.back()).words.exact_grid)};
}

ErrorTerm simplifyTerm(double bound_mm) {
  return {"simplify", bound_mm,
          bound_mm > 0.0
              ? "the mesh has fewer triangles than the surface had: no point of either is farther "
                "from the other (where walls closer than the grid were parted, that is measured on "
                "programs and not proven); volumes, findings and the comparison do not depend on it"
              : "the mesh is not simplified"};
}

/// As a wire does.
bool cutsThrough(const SetupRun& setup) { return processOf(setup).cuts_through; }

/// Of what a clamping left, mm.
double heightOf(const std::vector<StockBody>& bodies) {
  Box3 all;
  for (const StockBody& body : bodies) all.extend(body.bounds);
  return bodies.empty() ? 0.0 : all.size().z();
}

std::vector<ErrorTerm> errorBudget(const RunResult& run) {
  const double moves = movesUncertainty(run);
  // What a grid leaves is measured on its facets.
  const double grid =
      run.isOfFacets() ? std::max(0.0, partUncertainty(run) - moves) : run.surface().facets.mm;
  std::vector<ErrorTerm> terms;
  const ProcessWords &first = processOf(run.setups.front()).words, &last = processOf(run.setups.back()).words;
  const bool swept = last.exact_section == nullptr;
  if (first.exact_section != nullptr) terms.push_back({"section", kSectionChordMm, first.exact_section});
  if (run.isOfFacets()) {
    PROVEOUT_ASSERT(last.exact_facets != nullptr);  // such meshes come from sections
    terms.push_back({"facets", grid, last.exact_facets(run.setups.back().job)});
  } else {
    terms.push_back(gridTerm(run, grid));
    terms.push_back(simplifyTerm(simplification(run.setups.back().job, run.resolution_mm)));
  }
  if (run.setups.size() > 1 && swept) {
    terms.push_back({"re-clamping", moves,
                     "turns by multiples of 90 degrees move the stock exactly; others move it as its surface "
                     "mesh and add the chord height h^2/(8r) of walls that were cut before; edges then may "
                     "be off by a third of a cell"});
  }
  terms.push_back({"tool", 0.0, last.exact_tool});
  if (swept) terms.push_back({"arcs", 0.0, "arcs and helices are swept as such, not as chords"});
  if (run.comparison) {
    terms.push_back({"nominal", run.comparison->nominal_chord_mm,
                     "chord height of the nominal's facets, estimated from neighbouring facets"});
    terms.push_back(
        {"deviations", run.comparison->largest_bound_mm,
         "largest bound of a deviation near a tolerance; they are measured on the exact part, not on "
         "the facets of its mesh"});
  }
  return terms;
}

/// Whether a clamping's job limits the travel of an axis.
bool checksTravel(const Job& job) {
  const Result<ControlId> control = findControl(job.control);
  return control && limitsTravel(*control, job.settings);
}

Result<std::vector<FileHash>> hashInputs(const Job& job, const RunSources& sources) {
  std::vector<FileHash> hashes;
  std::string failure;
  const auto add = [&](const std::string& role, const std::string& path) {
    const Result<std::string> sha = sha256OfFile(path);
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (!sha) failure = sha.error().message;
    if (sha) hashes.push_back({role, path, error ? 0 : static_cast<std::uint64_t>(bytes), *sha});
  };
  if (!job.path.empty()) add("job", job.path);
  if (!job.machine_file.empty()) add("machine", job.machine_file);
  for (const SetupSpec& setup : job.setups) {
    if (!setup.machine_file.empty()) add("machine", setup.machine_file);
  }
  const std::vector<InputFile> templates = templatesOf(job);
  for (const InputFile& file : templates) add(file.role, file.path);
  for (const RecordingSource* source : sources) {
    const std::size_t channels = source->channels().size();
    for (const ProgramText& text : source->texts()) {
      // The main programs of all channels are loaded before anything is called.
      const bool main = &text - source->texts().data() < static_cast<std::ptrdiff_t>(channels);
      if (std::any_of(templates.begin(), templates.end(),
                      [&](const InputFile& f) { return f.path == text.path; }))
        continue;  // filled in: what lies in the file is hashed below
      FileHash hash{main ? "program" : "subprogram", text.path, text.bytes.size(), sha256Hex(text.bytes)};
      const auto same = [&](const FileHash& other) {
        return other.path == hash.path && other.role == hash.role;
      };
      if (std::none_of(hashes.begin(), hashes.end(), same)) hashes.push_back(std::move(hash));
    }
  }
  if (job.stock) {
    if (const auto* mesh = std::get_if<MeshFile>(&*job.stock)) add("stock", mesh->path);
    if (const auto* saved = std::get_if<SavedStock>(&*job.stock)) add("stock", saved->path);
  }
  for (std::size_t k = 0; k < sources.size(); ++k) {
    for (const FixtureSpec& fixture : jobOfSetup(job, k).fixtures) {
      if (const auto* mesh = std::get_if<MeshFile>(&fixture.shape)) add("fixture", mesh->path);
    }
  }
  if (job.nominal) add("nominal", job.nominal->mesh.path);
  if (!failure.empty()) return inputError(failure);
  return hashes;
}

}  // namespace

ReportComparison reportComparison(const Comparison& comparison, const NominalSpec& nominal) {
  ReportComparison report;
  report.nominal = nominal.mesh.path;
  report.nominal_unit = meshUnitName(nominal.mesh.unit);
  report.placement = nominal.placement;
  report.gouge_tolerance_mm = comparison.gouge_tolerance_mm;
  report.excess_tolerance_mm = comparison.excess_tolerance_mm;
  report.max_gouge_mm = comparison.max_gouge_mm;
  report.max_excess_mm = comparison.max_excess_mm;
  report.rms_mm = comparison.rms_mm;
  report.p95_mm = comparison.p95_mm;
  report.histogram_edges_mm = comparison.histogram.edges_mm;
  report.histogram_area_mm2 = comparison.histogram.area_mm2;
  report.features = featureTable(comparison, nominal.featureTolerances());
  report.features_found = comparison.faces_found;
  report.decided = comparison.undecided.empty();
  double deciding = std::numeric_limits<double>::infinity();
  for (const DeviationPatch& patch : comparison.undecided) {
    if (!(patch.deciding_resolution_mm > 0)) return report;  // no grid decides all of them
    deciding = std::min(deciding, patch.deciding_resolution_mm);
  }
  if (!report.decided) report.deciding_resolution_mm = deciding;
  return report;
}

std::vector<CutPath> cutPaths(const RunResult& run) {
  std::vector<CutPath> paths;
  for (const SetupRun& setup : run.setups)
    paths.push_back({setup.name, &setup.interpreted.path, &setup.removal.removed_mm3, partTurns(setup),
                     cutsThrough(setup) ? heightOf(setup.bodies) : 0.0});
  return paths;
}

Result<Report> makeReport(const Job& job, const RunResult& run, const RunSources& sources) {
  Report report;
  report.name = job.name;
  report.version = versionText();
  report.head = job.report.head;
  report.program = reportProgram(job, run);
  report.setups = reportSetups(job, run);
  report.time = reportTime(job, run);
  report.resolution_mm = run.meshResolution();
  report.findings = run.findings;
  for (const SetupRun& setup : run.setups) {
    const auto& all = setup.interpreted.path.diagnostics.all();
    report.diagnostics.insert(report.diagnostics.end(), all.begin(), all.end());
  }
  report.checks.removal = report.checks.mesh = !run.alarm;
  for (const SetupRun& setup : run.setups)
    report.checks.fixtures |= !run.alarm && !setup.job.fixtures.empty();
  report.checks.comparison = run.comparison.has_value();
  for (const SetupRun& setup : run.setups) report.checks.travel_limits |= checksTravel(setup.job);
  if (!run.alarm) {
    report.stock = reportStock(run);
    report.accounting = accountFor(cutPaths(run));
    report.error_budget = errorBudget(run);
    report.part_sha256 = run.setups.back().mesh_sha256;
  }
  if (run.comparison) report.comparison = reportComparison(*run.comparison, *job.nominal);
  if (run.comparison && run.alignment) report.comparison->alignment = reportAlignment(*run.alignment);
  report.part_characteristics = partCharacteristics(job, run);
  Result<std::vector<FileHash>> hashes = hashInputs(job, sources);
  if (!hashes) return hashes.error();
  report.inputs = std::move(*hashes);
  report.performance = run.performance;
  report.performance.predicted_memory_mb = run.prediction.memory_mb;
  report.performance.predicted_s = run.prediction.time_s;
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  report.performance.threads = job.simulation.threads > 0 ? job.simulation.threads : cores;
  report.verdict = verdictOf(report);
  return report;
}

double peakMemoryMb() {
  struct rusage usage {};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0.0;
  return 1.024e-3 * static_cast<double>(usage.ru_maxrss);  // Linux counts in KiB
}

std::string versionText() { return PROVEOUT_VERSION; }

}  // namespace proveout
