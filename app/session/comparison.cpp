#include "app/session/comparison.h"

#include <algorithm>

#include "app/session/causes/diagnosis.h"
#include "app/session/causes/proof.h"
#include "app/session/findings/blame.h"
#include "app/session/findings/feature_table.h"
#include "app/session/findings/findings.h"
#include "app/session/findings/provenance.h"
#include "app/session/findings/uncertainty.h"
#include "app/session/forecast/run_limits.h"
#include "app/session/nominal/alignment.h"
#include "core/tool/tool_table.h"
#include "removal/exact/swept_part.h"
#include "removal/turning/section/section.h"

namespace proveout {

void blameMaker(const SurfaceMaker& maker, const Vec3& where, double within_mm, const RunSources& sources,
                RunResult& run, Finding& finding) {
  const std::size_t last = run.setups.size() - 1;
  MadeBy made{maker.setup == SurfaceMaker::kLastSetup ? last : maker.setup, maker.motion};
  if (made.motion == kNoMotion) {
    made = madeEarlier(run, where, within_mm).value_or(MadeBy{last, kNoMotion});
  }
  const SetupRun& setup = run.setups[made.setup];
  blame(finding, made.motion, setup.interpreted.path, *sources[made.setup]);
  finding.setup = setup.name;
}

namespace {

/// Spots that one tool leaves side by side, as crests between its passes, are one finding: nearer to each
/// other than it is wide.
double spotGap(const RunResult& run, const SurfaceMaker& a, const SurfaceMaker& b) {
  const auto numberOf = [&](const SurfaceMaker& m) {
    return std::min<std::size_t>(m.setup, run.setups.size() - 1);
  };
  const SetupRun& setup = run.setups[numberOf(a)];
  const std::vector<Motion>& motions = setup.interpreted.path.motions;
  if (numberOf(a) != numberOf(b) || a.motion >= motions.size() || b.motion >= motions.size()) return -1.0;
  const int tool = motions[a.motion].tool;
  if (motions[b.motion].tool != tool) return -1.0;
  const Tool* t = ToolTable(setup.job.tools).find(tool);
  return t == nullptr ? -1.0 : t->insert ? 2.0 * t->insert->nose_radius : t->diameter;
}

/// Names who made the last finding.
void blamePatch(const DeviationPatch& patch, const RunSources& sources, RunResult& run) {
  blameMaker(mainMaker(patch), patch.where, patch.depth_mm + 2.0 * run.resolution_mm, sources, run,
             run.findings.back());
}

/// How far the mesh of the part may lie off its surface, mm.
double meshUncertainty(const Job& job, const RunResult& run) {
  return partUncertainty(run) + (run.isOfFacets() ? 0.0 : simplification(job, run.resolution_mm));
}

void addCharacteristicFindings(const Job& job, const RunSources& sources, RunResult& run) {
  const RigidTransform onto_part = run.alignment ? run.alignment->motion : RigidTransform();
  const std::size_t first = run.findings.size();
  const std::vector<CharacteristicFault> faults =
      addCharacteristics(*run.comparison, job.nominal->featureTolerances(), run.findings);
  if (run.alignment) placeOnPart(onto_part, first, run.findings);
  for (const CharacteristicFault& fault : faults)
    blameMaker(fault.maker, onto_part(fault.at), 2.0 * run.resolution_mm, sources, run,
               run.findings[fault.finding]);
}

/// `unsure_facets_mm`: the profile resolution, where the part is compared as a mesh of facets.
std::vector<PatchFinding> addFindings(const Job& job, const RunSources& sources, const ExactPart* part,
                                      double unsure_facets_mm, RunResult& run) {
  std::vector<PatchFinding> told;
  for (const DeviationPatch& patch : run.comparison->patches) {
    addDeviation(patch, *run.comparison, run.findings);
    told.push_back({run.findings.size() - 1, &patch});
    blamePatch(patch, sources, run);
  }
  if (const DeviationPatch* worst = addUndecided(*run.comparison, run.findings, unsure_facets_mm)) {
    told.push_back({run.findings.size() - 1, worst});
    blamePatch(*worst, sources, run);
  }
  if (job.simulation.causes != CauseSearch::kOff) diagnoseDeviations(sources, part, told, run);
  return told;
}

}  // namespace

Result<std::unique_ptr<ExactPart>> makeExactPart(const StockShape& blank, const RunResult& run) {
  if (auto exact = run.setups.back().form->exactPart()) return std::move(*exact);
  if (run.isOfFacets()) return std::unique_ptr<ExactPart>();  // the mesh is nearly exact
  const bool wire_cut = std::any_of(run.setups.begin(), run.setups.end(), [](const SetupRun& setup) {
    return !setup.interpreted.path.wires.empty();
  });
  if (wire_cut) return std::unique_ptr<ExactPart>();  // cutters' bodies alone are known
  // What a clamping left in closed form is the blank of those behind it.
  static const Toolpath kNothing;
  StockShape start = blank;
  std::uint32_t left_by = 0;
  RigidTransform to_first;
  std::vector<bool> known(run.setups.size(), false);
  std::vector<ClampedCut> cuts(run.setups.size());
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    const SetupRun& setup = run.setups[k];
    if (k > 0) to_first = to_first * setup.from_previous.inverse();
    std::optional<StockShape> left = setup.form->asBlank(to_first);
    if (!left) continue;
    start = std::move(*left);
    left_by = static_cast<std::uint32_t>(k);
    known[k] = true;
  }
  RigidTransform from_last;
  for (std::size_t k = run.setups.size(); k-- > 0;) {
    const SetupRun& setup = run.setups[k];
    cuts[k] = {known[k] ? &kNothing : &setup.interpreted.path, &setup.job.tools, from_last};
    from_last = setup.from_previous.inverse() * from_last;
  }
  return makeSweptPart(start, cuts, left_by);
}

Result<std::string> alignRun(const Job& job, const Blank& blank, PreparedMesh& nominal, RunResult& run,
                             Progress& progress) {
  if (job.nominal->align.kind == AlignKind::kNone) return std::string();
  const Result<std::unique_ptr<ExactPart>> part = makeExactPart(blank.shape, run);
  if (!part) return part.error();
  Result<AlignOutcome> outcome = alignNominal(
      *job.nominal, {run.surface().mesh, part->get(), meshUncertainty(job, run)}, nominal, progress);
  if (!outcome) return outcome.error();
  run.alignment = outcome->alignment;
  return std::move(outcome->fault);
}

Status compareRun(const Job& job, const RunSources& sources, const Blank& blank, const PreparedMesh& nominal,
                  RunResult& run, Progress& progress) {
  Result<std::unique_ptr<ExactPart>> part = makeExactPart(blank.shape, run);
  if (!part) return part.error();
  CompareOptions options;
  options.gouge_mm = job.nominal->gouge_mm;
  options.excess_mm = job.nominal->excess_mm;
  options.resolution_mm = run.resolution_mm;
  options.uncertainty_mm = meshUncertainty(job, run);
  options.part = std::move(*part);
  options.spot_gap = [&run](const SurfaceMaker& a, const SurfaceMaker& b) { return spotGap(run, a, b); };
  options.threads = job.simulation.threads;
  options.ignored = job.nominal->ignored;
  options.nominal_faces = nominal.faces;
  options.local = job.nominal->local;
  const bool measured_behind = run.alignment && nominal.faces != nullptr && job.nominal->measuresFeatures();
  options.measure_features = job.nominal->measuresFeatures() && !measured_behind;
  const auto by_kind = [](const LocalTolerance& local) { return local.kind.has_value(); };
  options.find_features =
      job.nominal->findsFeatures() || std::any_of(options.local.begin(), options.local.end(), by_kind);
  progress.report("comparing", 0.0);
  Result<Comparison> comparison = compareToNominal(run.surface().mesh, nominal.mesh, options, progress);
  if (!comparison) return comparison.error();
  run.comparison = std::move(*comparison);
  if (measured_behind)
    measureAligned(nominal, *run.alignment, {run.surface().mesh, options.part.get(), options.uncertainty_mm},
                   options.resolution_mm, *run.comparison);
  const double unsure_facets_mm = options.part == nullptr && run.isOfFacets() ? run.meshResolution() : 0.0;
  if (unsure_facets_mm > 0.0) {
    for (DeviationPatch& patch : run.comparison->undecided) patch.deciding_resolution_mm = 0.0;  // no grid is
  }
  addCharacteristicFindings(job, sources, run);
  addCoarseNominal(*run.comparison, run.findings);
  addIgnored(job.nominal->ignored, *run.comparison, run.findings);
  const std::vector<PatchFinding> told = addFindings(job, sources, options.part.get(), unsure_facets_mm, run);
  if (job.simulation.causes == CauseSearch::kProven && !told.empty()) {
    progress.report("trying causes", 0.0);
    proveCauses(job, sources, blank, nominal.mesh, told, run, progress);
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  }
  return Done{};
}

}  // namespace proveout
