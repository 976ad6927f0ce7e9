#include "app/session/causes/trial.h"

#include <algorithm>
#include <map>

#include "app/session/machining/machining.h"
#include "app/session/programs/first_offset.h"
#include "app/session/programs/interpretation.h"
#include "app/session/programs/rotary_motions.h"
#include "app/session/run/process.h"
#include "core/mesh/signed_distance.h"
#include "core/tool/tool_solid.h"
#include "core/tool/tool_table.h"
#include "core/tool/tool_type.h"
#include "removal/exact/swept_part.h"
#include "removal/sweep/motion_bodies.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {

/// A clamping as it would be.
struct TrialBench::Changed {
  std::size_t setup = 0;
  Job whole;  ///< with the datum put otherwise
  Job part;   ///< of the clamping
  Interpreted interpreted;
};

namespace {

/// What a trial takes besides its motions, in motions.
constexpr double kSweptSize = 1500.0, kMachinedSize = 800.0;

bool measures(const Toolpath& path) {
  return std::any_of(path.motions.begin(), path.motions.end(),
                     [](const Motion& motion) { return motion.kind == MotionKind::kProbe; });
}

/// How far a tool may reach from its control point, mm.
double reachOf(const std::vector<Tool>& tools, int number) {
  const Tool* tool = ToolTable(tools).ofMotion(number);
  return tool == nullptr || tool->insert ? 0.0 : 0.5 * tool->diameter;
}

/// Which motions come to a box.
class NearMotions {
 public:
  NearMotions(const Toolpath& path, const std::vector<Tool>& tools, const Box3& box)
      : path_(path), tools_(tools), box_(box) {}

  bool isNear(const Motion& motion) {
    const MotionWay way = wayOf(path_, motion);
    const Box3 tip = path_.bounds(motion);
    if (way.leans() || way.turns()) {
      const std::vector<ConvexProfile>& cutter = cutterOf(motion.tool);
      return std::any_of(cutter.begin(), cutter.end(), [&](const ConvexProfile& part) {
        return partBounds(part, way, tip, 0.0).overlaps(box_);
      });
    }
    // Downwards a tool takes what is above its tip.
    Box3 swept = tip.inflated(reachOf(tools_, motion.tool));
    swept.max.z() = std::max(swept.max.z(), box_.max.z());
    return swept.overlaps(box_);
  }

 private:
  /// What cuts of a tool; nothing of one that does not turn.
  const std::vector<ConvexProfile>& cutterOf(int number) {
    const auto [at, fresh] = cutters_.try_emplace(number);
    const Tool* const tool = fresh ? ToolTable(tools_).ofMotion(number) : nullptr;
    if (tool != nullptr && rowOf(tool->type).rotates) at->second = makeToolSolid(*tool).cutter;
    return at->second;
  }

  const Toolpath& path_;
  const std::vector<Tool>& tools_;
  const Box3& box_;
  std::map<int, std::vector<ConvexProfile>> cutters_;  ///< by number of the tool
};

/// The motions of a path whose tools may come to a box.
Toolpath near(const Toolpath& path, const std::vector<Tool>& tools, const Box3& box) {
  Toolpath out;
  NearMotions motions(path, tools, box);
  for (const Motion& motion : path.motions) {
    if (!motions.isNear(motion)) continue;
    Motion kept = motion;
    if (motion.arc >= 0) {
      kept.arc = static_cast<std::int32_t>(out.arcs.size());
      out.arcs.push_back(path.arcs[static_cast<std::size_t>(motion.arc)]);
    }
    kept.axis = -1;
    const MotionWay way = wayOf(path, motion);
    if (way.leans() || way.turns()) {
      kept.axis = static_cast<std::int32_t>(out.axes.size());
      out.axes.push_back(*way.axis);
    }
    out.motions.push_back(kept);
  }
  return out;
}

Box3 boundsOf(const std::vector<Vec3>& samples, const RigidTransform& move) {
  Box3 box;
  for (const Vec3& p : samples) box.extend(move(p));
  constexpr double kBesideMm = 0.1;
  return box.inflated(kBesideMm);
}

/// `part` is asked from the nominal's side: what is in the material there is left over.
std::vector<double> measured(const ExactPart& part, const std::vector<Vec3>& samples, double reach_mm) {
  std::vector<double> out;
  out.reserve(samples.size());
  for (const Vec3& p : samples) out.push_back(-part.at(p, reach_mm).value);
  return out;
}

std::vector<double> measured(const TriMesh& mesh, const std::vector<Vec3>& samples, double reach_mm) {
  if (mesh.triangles.empty()) return {};
  const SurfaceMesh surface = toSurface(mesh);
  const SignedDistance distance(surface);
  std::vector<double> out;
  for (const Vec3& p : samples) out.push_back(std::clamp(-distance.at(p).distance, -reach_mm, reach_mm));
  return out;
}

}  // namespace

TrialBench::TrialBench(const Job& job, const RunSources& sources, const Blank& blank, const TriMesh& nominal,
                       const RunResult& run, Progress& progress)
    : job_(job), sources_(sources), blank_(blank), nominal_(nominal), run_(run), progress_(progress) {
  works_ = job.channels.empty() && !std::holds_alternative<SavedStock>(blank.shape) &&
           run.setups.size() == setupCount(job);
  swept_ = works_;
  for (const SetupRun& setup : run.setups) {
    works_ = works_ && !setup.job.filled && !measures(setup.interpreted.path);
    swept_ = swept_ && !partTurns(setup) && setup.interpreted.path.wires.empty();
  }
  swept_ = swept_ && !run.isOfFacets();
}

double trialSize(const Toolpath& path) {
  // Of motions that turn the tool some 40 take as long as 1,600 others: parts/cone_frustum with a wrong
  // parameter.
  constexpr double kTurning = 40.0;
  double size = 0.0;
  for (const Motion& motion : path.motions) size += wayOf(path, motion).turns() ? kTurning : 1.0;
  return size;
}

/// Of all clampings, one of which may be changed.
double TrialBench::sizeWith(const Changed* changed) const {
  double size = swept_ ? kSweptSize : kMachinedSize;
  for (std::size_t k = 0; k < run_.setups.size(); ++k) {
    const bool other = changed != nullptr && changed->setup == k;
    size += trialSize(other ? changed->interpreted.path : run_.setups[k].interpreted.path);
  }
  return size;
}

TrialBudget TrialBench::budget() const {
  std::size_t motions = 0;
  for (const SetupRun& setup : run_.setups) motions += setup.interpreted.path.motions.size();
  // A program of 75 motions is tried in 2 ms near its samples, one of 100,000 in a third of its run. Where
  // tools turn the run takes longer as well.
  const double swept = 3e5 / (static_cast<double>(motions) + kSweptSize);
  const double machined = 2e4 / (static_cast<double>(motions) + kMachinedSize);
  const double trials = swept_ ? std::clamp(swept, 2.0, 150.0) : std::clamp(machined, 2.0, 24.0);
  return {static_cast<std::size_t>(trials), sizeWith(nullptr)};
}

std::optional<TrialBench::Changed> TrialBench::changedSetup(const Trial& trial) const {
  Changed out;
  out.setup = trial.setup;
  out.whole = job_;
  if (trial.datum && !trial.datum(out.whole)) return std::nullopt;
  out.part = jobOfSetup(out.whole, trial.setup);
  out.part.person.kept = run_.setups[trial.setup].job.person.kept;
  const RecordingSource& texts = *sources_[trial.setup];
  const TextEncoding encoding = out.part.settings.encoding;
  out.part.settings.encoding = TextEncoding::kUtf8;
  const ChangedSource changed(texts, encoding, trial.text.value_or(TextChange{}));
  const RecordingSource source(changed, TextEncoding::kUtf8);
  const Box3 bounds = movedBounds(out.whole, blank_.bounds, trial.setup);
  Diagnostics placing;
  placeByFirstOffset(out.part, source, bounds, placing, progress_);
  out.interpreted = interpretProgram(out.part, source, controlSettings(out.part, bounds), progress_);
  Toolpath& path = out.interpreted.path;
  if (out.interpreted.outgrown_at || !out.interpreted.summary.ok()) return std::nullopt;
  addOffsetTools(path, out.part.tools);
  if (!assignTools(path, out.part.tools, source) || !checkRotaryMotions(path, source)) return std::nullopt;
  return out;
}

std::vector<double> TrialBench::ofSweptPart(const Changed* changed, const std::vector<Vec3>& samples,
                                            double reach_mm) const {
  std::vector<ClampedCut> cuts(run_.setups.size());
  std::vector<Toolpath> paths(cuts.size());
  RigidTransform from_last;
  for (std::size_t k = cuts.size(); k-- > 0;) {
    const bool other = changed != nullptr && changed->setup == k;
    const SetupRun& setup = run_.setups[k];
    const Toolpath& path = other ? changed->interpreted.path : setup.interpreted.path;
    const std::vector<Tool>& tools = other ? changed->part.tools : setup.job.tools;
    paths[k] = near(path, tools, boundsOf(samples, from_last));
    cuts[k] = {&paths[k], &tools, from_last};
    const bool moved = changed != nullptr && !changed->whole.setups.empty();
    const RigidTransform& from_previous =
        moved ? changed->whole.setups[k].from_previous : setup.from_previous;
    from_last = from_previous.inverse() * from_last;
  }
  const Result<std::unique_ptr<ExactPart>> part = makeSweptPart(blank_.shape, cuts);
  if (!part || *part == nullptr) return {};
  return measured(**part, samples, reach_mm);
}

std::vector<double> TrialBench::deviations(const Trial& trial, const std::vector<Vec3>& samples,
                                           double reach_mm, TrialBudget& budget) const {
  if (!works_ || progress_.cancelled()) return {};
  budget.takeOne();
  const std::optional<Changed> changed = changedSetup(trial);
  if (!changed || !budget.takeRest(sizeWith(&*changed))) return {};
  return swept_ ? ofSweptPart(&*changed, samples, reach_mm) : machinedAgain(*changed, samples, reach_mm);
}

std::vector<double> TrialBench::deviations(const std::vector<Vec3>& samples, double reach_mm) const {
  return swept_ ? ofSweptPart(nullptr, samples, reach_mm) : measured(run_.surface().mesh, samples, reach_mm);
}

std::vector<double> TrialBench::machinedAgain(const Changed& changed, const std::vector<Vec3>& samples,
                                              double reach_mm) const {
  PreparedRun again;
  again.blank = {blank_.shape, blank_.bounds, blank_.resolution_mm, std::nullopt, blank_.start_holes};
  again.nominal = PreparedMesh{nominal_, {}};
  again.run.resolution_mm = run_.resolution_mm;
  for (std::size_t k = 0; k < run_.setups.size(); ++k) {
    SetupRun setup;
    setup.name = run_.setups[k].name;
    setup.job = k == changed.setup ? changed.part : jobOfSetup(changed.whole, k);
    if (!changed.whole.setups.empty()) setup.from_previous = changed.whole.setups[k].from_previous;
    setup.interpreted = k == changed.setup ? changed.interpreted : run_.setups[k].interpreted;
    again.run.setups.push_back(std::move(setup));
  }
  if (!machineAll(changed.whole, sources_, again, progress_)) return {};
  return measured(again.run.surface().mesh, samples, reach_mm);
}

}  // namespace proveout
