#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/commands.h"
#include "app/deviation/deviation_outputs.h"
#include "app/exit_codes.h"
#include "app/input_files.h"
#include "app/outputs.h"
#include "app/page/report_view.h"
#include "app/run_report.h"
#include "app/scan/scan_pair.h"
#include "app/session/findings/feature_table.h"
#include "app/session/findings/findings.h"
#include "app/session/forecast/comparison_work.h"
#include "app/session/forecast/machine_speed.h"
#include "app/session/forecast/thread_supply.h"
#include "app/session/nominal/alignment.h"
#include "app/session/nominal/nominal_mesh.h"
#include "app/session/nominal/placement_search.h"
#include "app/summary.h"
#include "app/time_limit.h"
#include "core/base/parallel_for.h"
#include "core/base/stopwatch.h"
#include "io/program_files.h"
#include "io/sha256.h"
#include "io/step/step_file.h"

namespace proveout {
namespace {

struct Pair {
  PreparedMesh machined, nominal;
  NominalSpec spec;              ///< of the nominal
  std::optional<ScanFile> scan;  ///< in place of the machined mesh

  /// What is drawn: where a scan was compared, the nominal with its deviations.
  const TriMesh& drawn() const { return scan ? nominal.mesh : machined.mesh; }
};

std::string partName(const CompareCommandOptions& options) {
  return std::filesystem::path(options.machined).stem().string();
}

Result<std::vector<DeviationOutput>> deviationsOf(const CompareCommandOptions& options) {
  if (!options.deviation) return std::vector<DeviationOutput>();
  Result<std::vector<DeviationOutput>> outputs = parseDeviationOutputs(*options.deviation);
  if (!outputs) return inputError("--deviation: " + outputs.error().message);
  return outputs;
}

/// The units of the two files.
struct PairUnits {
  MeshUnit machined, nominal;
};

Result<PairUnits> unitsOf(const CompareCommandOptions& options) {
  const Result<MeshUnit> both = parseMeshUnit(options.unit);
  if (!both) return inputError("--unit: " + both.error().message);
  const Result<MeshUnit> nominal = parseMeshUnit(options.nominal_unit.value_or(options.unit));
  if (!nominal) return inputError("--nominal-unit: " + nominal.error().message);
  return PairUnits{*both, *nominal};
}

Status applyAlignment(const CompareCommandOptions& options, NominalSpec& nominal) {
  AlignWish& wish = nominal.align;
  wish.kind = options.align == "fit"      ? AlignKind::kFit
              : options.align == "datums" ? AlignKind::kDatums
                                          : AlignKind::kNone;
  wish.limit_mm = options.align_limit_mm.value_or(wish.limit_mm);
  if (options.align_limit_mm && wish.kind == AlignKind::kNone)
    return inputError("--align-limit: nothing is aligned; add --align fit");
  if (!options.datums.empty() && wish.kind != AlignKind::kDatums)
    return inputError("--datum: nothing is aligned by datums; add --align datums");
  for (const std::string& text : options.datums) {
    const Result<Vec3> at = parseTriple("--datum", text, 1e6, "a point: X,Y,Z in mm");
    if (!at) return at.error();
    wish.datums.push_back(*at);
  }
  if (wish.kind == AlignKind::kDatums && wish.datums.size() != 3)
    return inputError("--align datums: give --datum X,Y,Z three times, on a plane, a hole and another hole");
  return Done{};
}

/// Where the files that are no solids may be a scan, that is said.
Result<PreparedMesh> loadSolidOf(const NominalSpec& spec) {
  Result<PreparedMesh> out = loadNominal(spec);
  if (out || out.error().kind != ErrorKind::kInput) return out;
  const std::string& message = out.error().message;
  const bool open =
      message.find("is not closed") != std::string::npos || message.find("no surface") != std::string::npos;
  return open ? inputError(message + scanHint(spec.mesh.path)) : out.error();
}

template <typename T>
Status take(Result<T> from, T& into) {
  if (!from) return from.error();
  into = std::move(*from);
  return Done{};
}

/// The model, and what lies beside it: the machined mesh, or a scan. Of a scan the model comes first.
Result<Pair> loadPair(const CompareCommandOptions& options, const PairUnits& units) {
  NominalSpec machined, nominal;
  const std::string& model_path = options.scan ? options.machined : options.nominal;
  machined.mesh = {options.machined, units.machined};
  nominal.mesh = {model_path, units.nominal};
  if (const Status placed = applyNominal(options.place, nominal); !placed) return placed.error();
  if (const Status aligned = applyAlignment(options, nominal); !aligned) return aligned.error();
  if (options.nominal_unit && statesUnit(model_path))
    return inputError("--nominal-unit: STEP, 3MF and GLB files state their unit themselves");
  if (statesUnit(model_path)) nominal.mesh.unit = MeshUnit::kMillimetre;  // what they are read into
  if (options.scan && !options.general.none())
    return inputError(
        "--general-tolerance: features are not measured on a scan; leave it out, or compare a closed mesh");
  Pair pair;
  nominal.gouge_mm = options.gouge_mm;
  nominal.excess_mm = options.excess_mm;
  nominal.general = options.general;
  // Side by side: a STEP file is read by a process of its own meanwhile.
  Status part = Done{}, model = Done{};
  parallelFor(0, 2, [&](int which) {
    if (which == 1) {
      model = take(options.scan ? loadNominal(nominal) : loadSolidOf(nominal), pair.nominal);
    } else if (options.scan) {
      part = take(loadScan(options.nominal, {.unit = units.machined}), pair.scan.emplace());
    } else {
      part = take(loadSolidOf(machined), pair.machined);
    }
  });
  if (!part) return part.error();
  if (!model) return model.error();
  pair.spec = std::move(nominal);
  return pair;
}

/// What the command will take. Errors: it is more than allowed.
Result<Prediction> predictPair(const CompareCommandOptions& options, const Pair& pair, ImageSize size) {
  constexpr double kShortS = 0.15;  // shorter ones are over before anybody asks
  constexpr int kPictures = 3;
  const TriMesh &machined = pair.scan ? pair.scan->mesh : pair.machined.mesh, &nominal = pair.nominal.mesh;
  ComparisonWork work;
  work.area_mm2 = meshArea(machined) + meshArea(nominal);
  work.triangles = static_cast<double>(machined.triangles.size() + nominal.triangles.size());
  if (pair.scan) work.triangles += static_cast<double>(machined.positions.size());
  work.pixels = static_cast<double>(size.width) * size.height;
  work.pictures = options.out ? kPictures : 0;
  Prediction prediction = predict(work, options.resolution_mm);
  if (prediction.time_s > kShortS) prediction = predictedOn(measureMachine(prediction.time_s), prediction);
  const double limit_mb = options.max_memory_gb ? 1000.0 * *options.max_memory_gb : availableMemoryMb();
  const Status fits = checkLimits(work, options.resolution_mm, prediction,
                                  {limit_mb, options.max_time_s.value_or(kDefaultMaxTimeS)});
  if (!fits) return fits.error();
  return prediction;
}

/// The comparison, or why there is none.
struct PairResult {
  std::optional<Comparison> comparison;
  PlacementFault fault;
  std::optional<Alignment> alignment;
  std::optional<ScanComparison> scan;  ///< without the comparison, which is above
};

Result<PairResult> compareScanPair(const CompareCommandOptions& options, Pair& pair, Progress& progress) {
  Result<ScanResult> found = compareWithScan(options, pair.spec, *pair.scan, pair.nominal, progress);
  if (!found) return found.error();
  PairResult result;
  result.alignment = found->alignment;
  if (found->scan) {
    result.comparison = std::move(found->scan->comparison);
    result.scan = std::move(found->scan);
  } else {
    result.fault.text = std::move(found->fault);
    result.fault.comparable = false;
  }
  return result;
}

/// `pair`: the nominal is moved where it is to be aligned.
Result<PairResult> comparePair(const CompareCommandOptions& options, Pair& pair, Progress& progress) {
  if (pair.scan) return compareScanPair(options, pair, progress);
  PairResult result;
  if (pair.spec.align.kind != AlignKind::kNone) {
    Result<AlignOutcome> outcome = alignNominal(pair.spec, {pair.machined.mesh}, pair.nominal, progress);
    if (!outcome) return outcome.error();
    result.alignment = outcome->alignment;
    if (!outcome->fault.empty()) {
      result.fault.text = std::move(outcome->fault);
      result.fault.comparable = false;
      return result;
    }
  }
  result.fault =
      placementFault(pair.nominal.mesh, pair.spec.placement, pair.spec.mesh.unit,
                     {pair.machined.mesh, std::nullopt, std::max(options.gouge_mm, options.excess_mm)});
  if (!result.fault.comparable) return result;
  CompareOptions settings;
  settings.gouge_mm = options.gouge_mm;
  settings.excess_mm = options.excess_mm;
  settings.resolution_mm = options.resolution_mm;
  settings.threads = options.threads.value_or(0);
  settings.nominal_faces = pair.nominal.faces;
  const bool measured_behind =
      result.alignment && pair.nominal.faces != nullptr && pair.spec.measuresFeatures();
  settings.measure_features = pair.spec.measuresFeatures() && !measured_behind;
  settings.find_features = pair.spec.findsFeatures();
  Result<Comparison> comparison = compareToNominal(pair.machined.mesh, pair.nominal.mesh, settings, progress);
  if (!comparison) return comparison.error();
  result.comparison = std::move(*comparison);
  if (measured_behind)
    measureAligned(pair.nominal, *result.alignment, {pair.machined.mesh}, options.resolution_mm,
                   *result.comparison);
  return result;
}

/// What was found. No program is involved: nothing is blamed.
void addFound(const CompareCommandOptions& options, const Pair& pair, const PairResult& result,
              Report& report) {
  if (!result.comparison) {
    Finding finding(FindingKind::kNominalPlacement);
    finding.message = result.fault.text;
    report.findings.push_back(std::move(finding));
    return;
  }
  const Comparison& comparison = *result.comparison;
  report.comparison = reportComparison(comparison, pair.spec);
  if (result.alignment) report.comparison->alignment = reportAlignment(*result.alignment);
  if (result.scan) report.comparison->scan = reportScan(options.nominal, *pair.scan, *result.scan);
  for (const DeviationPatch& patch : comparison.patches) addDeviation(patch, comparison, report.findings);
  addUndecided(comparison, report.findings);
  const std::size_t first = report.findings.size();
  addCharacteristics(comparison, pair.spec.featureTolerances(), report.findings);
  if (result.alignment) placeOnPart(result.alignment->motion, first, report.findings);
  addCoarseNominal(comparison, report.findings);
  report.error_budget.push_back({"nominal", comparison.nominal_chord_mm,
                                 "chord height of the nominal's facets, estimated from neighbouring facets"});
}

CompareOptions scanLimits(const CompareCommandOptions& options) {
  CompareOptions out;
  out.gouge_mm = options.gouge_mm;
  out.excess_mm = options.excess_mm;
  return out;
}

Result<Report> makeCompareReport(const CompareCommandOptions& options, const Pair& pair,
                                 const PairResult& result) {
  Report report;
  report.name = partName(options);
  report.version = versionText();
  report.checks.interpreted = false;
  report.checks.comparison = result.comparison.has_value();
  report.resolution_mm = options.resolution_mm;
  Diagnostics notes;
  addMeshWarnings(pair.machined.notes, "mesh", notes);
  addMeshWarnings(pair.nominal.notes, "mesh", notes);
  if (result.comparison && !result.fault.text.empty()) addMeshWarnings({result.fault.text}, "nominal", notes);
  addFound(options, pair, result, report);
  if (result.scan) addScanNotes(*result.scan, scanLimits(options), report.findings, notes);
  report.diagnostics = notes.all();
  const std::pair<const char*, std::string> files[] = {{pair.scan ? "nominal" : "machined", options.machined},
                                                       {pair.scan ? "scan" : "nominal", options.nominal}};
  for (const auto& [role, path] : files) {
    const Result<std::string> hash = sha256OfFile(path);
    if (!hash) return hash.error();
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    report.inputs.push_back({role, path, error ? 0 : static_cast<std::uint64_t>(bytes), *hash});
  }
  report.part_sha256 = sha256OfMesh(pair.scan ? pair.scan->mesh : pair.machined.mesh);
  report.performance.peak_memory_mb = peakMemoryMb();
  report.verdict = verdictOf(report);
  return report;
}

Status writeResults(const CompareCommandOptions& options, const Pair& pair, const PairResult& result,
                    ImageSize size, const std::vector<DeviationOutput>& deviations, const OutputGuard& guard,
                    Report& report, OutputFailures& failures, Progress& progress) {
  Stopwatch watch;
  PictureRequest request;
  request.size = size;
  request.name = report.name;
  request.threads = options.threads.value_or(0);
  const TriMesh& mesh = pair.drawn();
  PictureMaker maker(std::move(request));
  Status drawn = maker.drawViews(mesh, progress);
  if (drawn && result.comparison)
    drawn = maker.drawDeviation(mesh, *result.comparison, report.findings, progress);
  if (drawn) drawn = maker.drawFindings(mesh, report.findings, progress);
  if (!drawn) return drawn;
  PageContent page;
  const Comparison* const comparison = result.comparison ? &*result.comparison : nullptr;
  Result<std::vector<FindingDetail>> details =
      maker.drawDetails(mesh, comparison, report.findings, nullptr, nullptr, progress);
  if (!details) return details.error();
  page.details = std::move(*details);
  if (!options.no_view3d)
    page.view = viewOfMeshes({mesh, result.comparison && !pair.scan ? &pair.nominal.mesh : nullptr,
                              comparison, page.bands, report.findings},
                             progress);
  report.performance.render_s = watch.lap();
  report.performance.wall_s += report.performance.render_s;
  report.performance.peak_memory_mb = peakMemoryMb();
  failures.insert(failures.end(), maker.failures.begin(), maker.failures.end());
  Result<StagingFolder> staging = StagingFolder::create(*options.out, &guard, &progress);
  if (!staging) return staging.error();
  if (result.comparison)
    writePairDeviation(report.name, mesh, *result.comparison, deviations, progress, *staging, report,
                       failures);
  writeReport(maker.pictures, *staging, report, failures, std::move(page), options.csv);
  return staging->commit();
}

/// Fills the guard with the two files, and checks that the results can be written beside them.
Status checkTarget(const CompareCommandOptions& options, const std::vector<DeviationOutput>& deviations,
                   OutputGuard& guard) {
  const std::string first = options.scan ? "model" : "machined mesh",
                    second = options.scan ? "scan" : "nominal";
  if (Status settled = settleInputs({{first, options.machined}, {second, options.nominal}}); !settled)
    return settled;
  guard.protect(first, options.machined);
  guard.protect(second, options.nominal);
  if (Status streams = guard.checkStandardOutput(); !streams) return streams;
  if (!options.out) return Done{};
  std::vector<std::string> names;
  for (const DeviationOutput output : deviations)
    names.push_back(deviationFileName(partName(options), output));
  if (options.csv) names.emplace_back("findings.csv");
  if (Status free = checkNames(comparisonOutputNames(names), *options.out, guard); !free) return free;
  const Result<StagingFolder> proof = StagingFolder::create(*options.out);
  return proof ? Status(Done{}) : Status(proof.error());
}

Result<Report> compareFiles(const CompareCommandOptions& options, OutputFailures& failures,
                            Progress& progress) {
  Stopwatch wall, watch;
  const ThreadSupply threads(options.threads.value_or(0));
  const Result<ImageSize> size = parseImageSize(options.size);
  if (!size) return size.error();
  const Result<PairUnits> units = unitsOf(options);
  if (!units) return units.error();
  const Result<std::vector<DeviationOutput>> deviations = deviationsOf(options);
  if (!deviations) return deviations.error();
  OutputGuard guard;
  if (const Status possible = checkTarget(options, *deviations, guard); !possible) return possible.error();
  Result<Pair> pair = loadPair(options, *units);
  if (!pair) return pair.error();
  const double read_s = watch.lap();
  const Result<Prediction> prediction = predictPair(options, *pair, *size);
  if (!prediction) return prediction.error();
  const Result<PairResult> result = comparePair(options, *pair, progress);
  if (!result) return result.error();
  Result<Report> report = makeCompareReport(options, *pair, *result);
  if (!report) return report;
  report->performance.threads = threads.count();
  report->performance.read_s = read_s;
  report->performance.compare_s = watch.lap();
  report->performance.predicted_memory_mb = prediction->memory_mb;
  report->performance.predicted_s = prediction->time_s;
  report->performance.wall_s = wall.lap();
  if (options.out) {
    if (const Status done =
            writeResults(options, *pair, *result, *size, *deviations, guard, *report, failures, progress);
        !done)
      return done.error();
  }
  return report;
}

}  // namespace

int compareCommand(const CompareCommandOptions& options, Console& console, ConsoleProgress& progress) {
  TimeLimit limit(progress);
  limit.set(options.max_time_s.value_or(kDefaultMaxTimeS));
  progress.show(options.progress || (console.err_is_terminal && !options.quiet));
  OutputFailures failures;
  const Result<Report> report = compareFiles(options, failures, progress);
  progress.clear();
  if (!report) return printError(console, limit.told(report.error()));
  printResult(console, *report, options.quiet, options.json, options.out.value_or(""));
  return exitCodeOf(*report, failures);
}

}  // namespace proveout
