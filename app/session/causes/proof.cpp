#include "app/session/causes/proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <set>

#include "app/session/causes/suspects.h"
#include "app/session/nominal/nominal_samples.h"
#include "core/tool/tool_table.h"

namespace proveout {

namespace {

/// Points all over the nominal, and in each patch.
constexpr std::size_t kPartPoints = 1500, kPatchPoints = 150;
/// A trial that spoils more of what was right than this, of the points that were off, is no cure.
constexpr double kMostHarm = 0.1;
/// Less of a patch left than this share of its depth is told as a part of the cause; more says nothing.
constexpr double kWorthTelling = 0.6;
/// Of what puts a finding right, only what puts about as much of the whole part right is told.
constexpr double kOfBest = 0.4;
constexpr std::size_t kMostPatches = 24, kMostCauses = 4;

/// A trial that was run.
struct Outcome {
  const Suspect* suspect = nullptr;
  std::string with;
  std::optional<double> value;  ///< of a number
  bool usual = false;           ///< that is one that it often should have, or another code
  std::vector<double> deviations;
  double spoiled = 0.0, cured = 0.0;  ///< shares of the points that were off
};

class Proof {
 public:
  Proof(const Job& job, const RunSources& sources, const Blank& blank, const TriMesh& nominal,
        const std::vector<PatchFinding>& patches, RunResult& run, Progress& progress)
      : scene_{job, run, sources},
        bench_(job, sources, blank, nominal, run, progress),
        run_(run),
        budget_(bench_.budget()) {
    untried_.resize(patches.size());
    if (!bench_.works() || patches.empty()) return;
    for (const PatchFinding& p : patches) reach_ = std::max(reach_, 1.5 * p.patch->depth_mm);
    reach_ += 2.0 * run.resolution_mm;
    for (const Vec3& corner : {meshBounds(nominal).min, meshBounds(nominal).max}) all_.extend(corner);
    samples_ = nominalSamples(nominal, all_, kPartPoints);
    for (const PatchFinding& p : patches) addPatch(nominal, *p.patch);
    before_ = bench_.deviations(samples_, reach_);
    if (before_.size() != samples_.size()) before_.clear();
    for (const double d : before_) off_ += isOff(d) ? 1.0 : 0.0;
  }

  bool works() const { return !before_.empty() && off_ > 0.0; }

  /// Runs trials for a patch, unless one for another patch puts it right.
  void look(const PatchFinding& told, std::size_t number) {
    const std::vector<std::size_t> points = pointsOf(number);
    std::vector<const Outcome*> cures;
    if (points.empty() || findCures(points, cures)) return;
    for (const Suspect* suspect : suspectsFor(told)) {
      if (!tryOut(*suspect, points)) ++untried_[number];
    }
  }

  /// Puts what has helped into the finding of a patch.
  void tell(const PatchFinding& told, std::size_t number) {
    const std::vector<std::size_t> points = pointsOf(number);
    std::vector<const Outcome*> cures;
    if (points.empty()) return;
    Finding& finding = run_.findings[told.finding];
    if (!findCures(points, cures)) finding.untried_causes = untried_[number];
    tell(finding, points, cures);
  }

 private:
  using MotionAt = std::pair<std::uint32_t, MotionId>;  ///< clamping and motion

  static constexpr double kSlack = 1e-6;
  bool isOff(double d, double unsure = kSlack) const {
    return d > run_.comparison->excess_tolerance_mm + unsure ||
           -d > run_.comparison->gouge_tolerance_mm + unsure;
  }
  /// The same behind a trial: the nominal's own facets are left, as far as they are known to stand for a
  /// round.
  bool isLeft(double d) const {
    return isOff(
        d, kSlack + (run_.comparison->nominal_chord_in_doubt ? 0.0 : run_.comparison->nominal_chord_mm));
  }
  /// Whether a trial puts a sample right that was off: within tolerance, and not as far off as before.
  bool isCured(std::size_t k, double d) const {
    constexpr double kStill = 0.6;
    return !isLeft(d) && std::abs(d) <= kStill * std::abs(before_[k]);
  }

  void addPatch(const TriMesh& nominal, const DeviationPatch& patch) {
    const std::size_t first = samples_.size();
    const Box3 box = patch.bounds.inflated(patch.depth_mm + run_.resolution_mm);
    for (const Vec3& s : nominalSamples(nominal, box, kPatchPoints)) samples_.push_back(s);
    patches_.push_back({&patch, first, samples_.size()});
  }

  /// Samples that show a patch: beyond the tolerance on its side.
  std::vector<std::size_t> pointsOf(std::size_t number) const {
    const auto& [patch, first, end] = patches_[number];
    const bool excess = patch->kind == DeviationKind::kExcess;
    std::vector<std::size_t> out;
    for (std::size_t k = first; k < end; ++k) {
      if (isOff(before_[k]) && (before_[k] > 0.0) == excess) out.push_back(k);
    }
    return out;
  }

  /// What is left of a patch, mm, at its points.
  double leftOf(const std::vector<double>& deviations, const std::vector<std::size_t>& points) const {
    double most = 0.0;
    for (const std::size_t k : points) {
      if (!isCured(k, deviations[k])) most = std::max(most, std::abs(deviations[k]));
    }
    return most;
  }

  /// The same with what is within tolerance.
  static double restOf(const std::vector<double>& deviations, const std::vector<std::size_t>& points) {
    double most = 0.0;
    for (const std::size_t k : points) most = std::max(most, std::abs(deviations[k]));
    return most;
  }

  double depthOf(const std::vector<std::size_t>& points) const { return restOf(before_, points); }

  const Outcome* run(const Suspect& suspect, const Trial& trial, std::string with,
                     std::optional<double> value = std::nullopt, bool usual = false) {
    const auto same = std::find_if(outcomes_.begin(), outcomes_.end(),
                                   [&](const Outcome& o) { return o.suspect == &suspect && o.with == with; });
    if (same != outcomes_.end()) return &*same;
    if (budget_.isSpent()) return nullptr;
    Outcome out{
        &suspect, std::move(with), value, usual, bench_.deviations(trial, samples_, reach_, budget_), 0.0,
        0.0};
    if (out.deviations.size() != samples_.size()) return nullptr;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      if (!isOff(before_[k]) && isLeft(out.deviations[k])) out.spoiled += 1.0 / off_;
      if (isOff(before_[k]) && isCured(k, out.deviations[k])) out.cured += 1.0 / off_;
    }
    outcomes_.push_back(std::move(out));
    return &outcomes_.back();
  }

  /// False: nothing was tried, or not all that is to be, as trials have taken as much as they may.
  bool tryOut(const Suspect& suspect, const std::vector<std::size_t>& points) {
    if (tried_.contains(suspect.key)) return true;
    if (budget_.isSpent()) return false;
    tried_.insert(suspect.key);
    const std::size_t refused = budget_.refused();
    tryValues(suspect, points);
    return budget_.refused() == refused;
  }

  void tryValues(const Suspect& suspect, const std::vector<std::size_t>& points) {
    for (const Suspect::Other& other : suspect.others)
      run(suspect, other.trial, other.text, std::nullopt, !suspect.conventional);
    if (!suspect.put) return;
    for (const double value : suspect.usual) {
      const std::optional<Trial> trial = suspect.put(value);
      const Outcome* const out = trial ? run(suspect, *trial, suspect.text(value), value, true) : nullptr;
      if (out != nullptr && leftOf(out->deviations, points) == 0.0) return;
    }
    // How deep the worst point is covered may be bounded by another face: then one of middling depth tells
    // more.
    std::vector<std::size_t> by_depth = points;
    std::sort(by_depth.begin(), by_depth.end(),
              [&](std::size_t a, std::size_t b) { return std::abs(before_[a]) < std::abs(before_[b]); });
    if (!settle(suspect, points, by_depth.back())) settle(suspect, points, by_depth[by_depth.size() / 2]);
  }

  /// The value that takes one point of a patch back to the nominal: it depends on the value about linearly.
  /// True: the patch goes.
  bool settle(const Suspect& suspect, const std::vector<std::size_t>& points, std::size_t at) {
    constexpr int kRounds = 3;
    double x0 = suspect.value, d0 = before_[at], x1 = x0 + suspect.first_step;
    std::set<std::string> tried{suspect.text(x0)};
    bool gone = false;
    for (int round = 0; round < kRounds; ++round) {
      if (!std::isfinite(x1)) return gone;
      x1 = std::clamp(rounded(x1, suspect), suspect.least, suspect.most);
      const std::string with = suspect.text(x1);
      if (!tried.insert(with).second) return gone;
      const std::optional<Trial> trial = suspect.put(x1);
      const Outcome* const out = trial ? run(suspect, *trial, with, x1) : nullptr;
      if (out == nullptr) return gone;
      const double d1 = out->deviations[at];
      constexpr double kMoved = 1e-5, kAtNominal = 1e-3;
      gone = leftOf(out->deviations, points) == 0.0;
      if ((gone && std::abs(d1) < kAtNominal) || std::abs(d1 - d0) < kMoved) return gone;
      const double next = x1 - d1 * (x1 - x0) / (d1 - d0);
      x0 = x1;
      d0 = d1;
      x1 = next;
    }
    return gone;
  }

  /// With as few decimals as the tolerance allows: people write round numbers.
  double rounded(double value, const Suspect& suspect) const {
    const double tolerance =
        std::min(run_.comparison->excess_tolerance_mm, run_.comparison->gouge_tolerance_mm);
    const double slack = 0.2 * tolerance * suspect.per_mm;
    double unit = 1.0;
    for (int decimals = 0; decimals < suspect.decimals; ++decimals, unit *= 0.1) {
      const double round = std::round(value / unit) * unit;
      if (std::abs(round - value) <= slack) return round;
    }
    return value;
  }

  /// True: one of them puts it right altogether.
  bool findCures(const std::vector<std::size_t>& points, std::vector<const Outcome*>& cures) const {
    bool any = false;
    cures.clear();
    const double depth = depthOf(points);
    for (const Outcome& out : outcomes_) {
      const double left = leftOf(out.deviations, points);
      if (out.spoiled > kMostHarm || left > kWorthTelling * depth) continue;
      cures.push_back(&out);
      any = any || left == 0.0;
    }
    return any;
  }

  std::vector<const Suspect*> suspectsFor(const PatchFinding& told) {
    std::vector<Suspect> found;
    const Finding& finding = run_.findings[told.finding];
    const std::vector<MotionAt> behind = motionsBehind(*told.patch);
    // What deviations suggest of a wire is its diameter, which stands for every wrong offset.
    const bool wire = !run_.setups.back().interpreted.path.wires.empty();
    if (!wire) {
      for (const Cause& cause : finding.causes) guessed(told, behind, cause, found);
    }
    const double depth = told.patch->depth_mm;
    for (const auto& [setup, motion] : behind) {
      for (Suspect& s : suspectsOf(scene_, setup, motion, signedDepth(*told.patch, depth)))
        found.push_back(std::move(s));
    }
    std::vector<const Suspect*> out;
    for (Suspect& s : found) {
      s.conventional = isOfItsTool(behind, s.cause.value);
      const auto [at, added] = suspects_.try_emplace(s.key, std::move(s));
      if (added) at->second.rank = static_cast<int>(suspects_.size());
      if (std::find(out.begin(), out.end(), &at->second) == out.end()) out.push_back(&at->second);
    }
    return out;
  }

  /// Whether a word is T, or D or H with the number of a tool that made the patch: that another tool would do
  /// is no reason to doubt the word.
  bool isOfItsTool(const std::vector<MotionAt>& behind, const std::string& word) const {
    if (word.starts_with('T')) return true;
    if (!word.starts_with('D') && !word.starts_with('H')) return false;
    return std::any_of(behind.begin(), behind.end(), [&](const MotionAt& at) {
      const int tool = run_.setups[at.first].interpreted.path.motions[at.second].tool;
      return std::atoi(word.c_str() + 1) == tool;
    });
  }

  static double signedDepth(const DeviationPatch& patch, double depth) {
    return patch.kind == DeviationKind::kExcess ? depth : -depth;
  }

  /// A cause that the deviations point at.
  void guessed(const PatchFinding& told, const std::vector<MotionAt>& behind, const Cause& cause,
               std::vector<Suspect>& out) const {
    const double off = cause.off_mm.value_or(told.patch->depth_mm);
    std::optional<Suspect> suspect;
    for (const auto& [setup, motion] : behind) {
      if (!cause.source) {
        suspect = suspectDatum(scene_, setup, cause.what, off);
      } else {
        suspect = suspectWord(scene_, setup, wordOf(setup, motion, cause), off);
      }
      if (suspect) break;
    }
    if (!suspect) return;
    suspect->cause.along = cause.along;
    suspect->cause.off_mm = cause.off_mm;
    suspect->cause.explains = cause.explains;
    out.push_back(std::move(*suspect));
  }

  /// The word of a motion that a cause names.
  ResolvedOrigin wordOf(std::uint32_t setup, MotionId motion, const Cause& cause) const {
    const Toolpath& path = run_.setups[setup].interpreted.path;
    const LineText text = lineText(path, *scene_.sources[setup]);
    for (const ResolvedOrigin& word : originsOf(path, motion, text)) {
      const ResolvedOrigin* found = named(word, cause, path);
      if (found != nullptr) return *found;
    }
    return {};
  }

  static const ResolvedOrigin* named(const ResolvedOrigin& word, const Cause& cause, const Toolpath& path) {
    if (word.begin == cause.column && word.line == cause.source->line &&
        path.files[word.file] == cause.source->file)
      return &word;
    for (const ResolvedOrigin& from : word.from) {
      if (const ResolvedOrigin* found = named(from, cause, path)) return found;
    }
    return nullptr;
  }

  /// The motions that made a patch, those of most of it first; where none did, those that came nearest.
  std::vector<MotionAt> motionsBehind(const DeviationPatch& patch) const {
    constexpr std::size_t kMostMakers = 3;
    std::vector<MotionAt> out;
    const auto last = static_cast<std::uint32_t>(run_.setups.size() - 1);
    for (const MakerShare& m : patch.makers) {
      if (m.maker.motion == kNoMotion || out.size() >= kMostMakers) continue;
      out.emplace_back(std::min(m.maker.setup, last), m.maker.motion);
    }
    if (patch.kind == DeviationKind::kExcess) addNearest(patch, out);
    return out;
  }

  /// Of each clamping the cuts that came nearest to where material is left: first the nearest of each tool
  /// that came near enough to be meant for it.
  void addNearest(const DeviationPatch& patch, std::vector<MotionAt>& out) const {
    constexpr std::size_t kMostNearest = 3, kMostTools = 4;
    RigidTransform from_last;
    for (std::size_t k = run_.setups.size(); k-- > 0;) {
      const std::vector<std::pair<double, MotionId>> nearest = byDistance(k, from_last(patch.where));
      const auto& motions = run_.setups[k].interpreted.path.motions;
      std::set<int> tools;
      const auto add = [&](MotionId m) { out.emplace_back(static_cast<std::uint32_t>(k), m); };
      for (const auto& [distance, m] : nearest) {
        if (tools.size() == kMostTools || distance > nearReach(k, motions[m].tool) + patch.depth_mm) break;
        if (tools.insert(motions[m].tool).second) add(m);
      }
      for (std::size_t i = 0; i < std::min(kMostNearest, nearest.size()); ++i) add(nearest[i].second);
      from_last = run_.setups[k].from_previous.inverse() * from_last;
    }
  }

  /// Cuts of a clamping by how far their chord passes from a point.
  std::vector<std::pair<double, MotionId>> byDistance(std::size_t setup, const Vec3& p) const {
    const Toolpath& path = run_.setups[setup].interpreted.path;
    std::vector<std::pair<double, MotionId>> out;
    for (MotionId m = 0; m < path.motions.size(); ++m) {
      if (path.motions[m].kind != MotionKind::kFeed) continue;
      const Vec3 a = path.motions[m].from, way = path.motions[m].to - a;
      const double t = way.isZero() ? 0.0 : std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
      out.emplace_back((a + t * way - p).norm(), m);
    }
    constexpr std::size_t kMost = 2000;
    const std::size_t count = std::min(kMost, out.size());
    std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count), out.end());
    out.resize(count);
    return out;
  }

  /// How near a tool comes to what it is meant to cut.
  double nearReach(std::size_t setup, int tool) const {
    const Tool* const t = ToolTable(run_.setups[setup].job.tools).find(tool);
    return t == nullptr ? 0.0 : t->diameter;
  }

  void tell(Finding& finding, const std::vector<std::size_t>& points,
            std::vector<const Outcome*> cures) const {
    if (cures.empty()) return;
    const auto left = [&](const Outcome* o) { return leftOf(o->deviations, points); };
    std::stable_sort(cures.begin(), cures.end(), [&](const Outcome* a, const Outcome* b) {
      const bool whole_a = left(a) == 0.0, whole_b = left(b) == 0.0;
      if (whole_a != whole_b) return whole_a;
      if (!whole_a) return left(a) < left(b);
      // What puts more of the part right, then what is likelier.
      const int cured_a = static_cast<int>(20.0 * (a->cured - a->spoiled));
      const int cured_b = static_cast<int>(20.0 * (b->cured - b->spoiled));
      if (cured_a != cured_b) return cured_a > cured_b;
      if (a->usual != b->usual) return a->usual;
      if (a->usual && digitsOf(*a) != digitsOf(*b)) return digitsOf(*a) < digitsOf(*b);
      if (a->suspect != b->suspect) return a->suspect->rank < b->suspect->rank;
      return restOf(a->deviations, points) < restOf(b->deviations, points);
    });
    const bool whole = left(cures.front()) == 0.0;
    std::vector<Cause> causes;
    std::set<std::string> told;
    for (const Outcome* out : cures) {
      if (whole && (left(out) > 0.0 ||
                    out->cured - out->spoiled < kOfBest * (cures.front()->cured - cures.front()->spoiled)))
        break;
      if (causes.size() < kMostCauses && told.insert(out->suspect->key).second)
        causes.push_back(causeOf(*out, left(out), depthOf(points)));
    }
    const bool stated = !finding.causes.empty() && finding.causes.front().what == kNoOffset;
    if (!whole && stated) return;
    if (!whole) causes.insert(causes.end(), finding.causes.begin(), finding.causes.end());
    // That a wire went without offset says more than which number would make up for it.
    if (stated) causes.insert(causes.begin(), finding.causes.front());
    finding.causes = std::move(causes);
  }

  /// Decimals that a number is written with: of two that fit each other the rounder one is right.
  static int digitsOf(const Outcome& out) {
    constexpr int kMostDigits = 4;
    if (!out.value) return 0;
    const double value = *out.value / std::max(1.0, out.suspect->per_mm);
    double unit = 1.0;
    for (int digits = 0; digits < kMostDigits; ++digits, unit *= 0.1) {
      if (std::abs(std::round(value / unit) * unit - value) < 1e-9) return digits;
    }
    return kMostDigits;
  }

  static Cause causeOf(const Outcome& out, double left_mm, double depth_mm) {
    Cause cause = out.suspect->cause;
    cause.with = out.with;
    cause.left_mm = left_mm;
    cause.explains = 1.0 - left_mm / depth_mm;
    // Of a datum that shifts the cut the trial knows better by how much than the deviations did.
    const bool shifts = !cause.along.empty() && cause.what.starts_with("offsets.");
    if (shifts && out.value) cause.off_mm = out.suspect->value - *out.value;
    return cause;
  }

  struct PatchPoints {
    const DeviationPatch* patch;
    std::size_t first, end;  ///< of samples_
  };

  SuspectScene scene_;
  TrialBench bench_;
  RunResult& run_;
  TrialBudget budget_;
  std::vector<std::size_t> untried_;  ///< suspects, by patch
  double reach_ = 0.0, off_ = 0.0;
  Box3 all_;
  std::vector<Vec3> samples_;
  std::vector<PatchPoints> patches_;
  std::vector<double> before_;
  std::map<std::string, Suspect> suspects_;
  std::set<std::string> tried_;
  std::deque<Outcome> outcomes_;
};

}  // namespace

void proveCauses(const Job& job, const RunSources& sources, const Blank& blank, const TriMesh& nominal,
                 const std::vector<PatchFinding>& patches, RunResult& run, Progress& progress) {
  std::vector<PatchFinding> told(
      patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(std::min(kMostPatches, patches.size())));
  Proof proof(job, sources, blank, nominal, told, run, progress);
  if (!proof.works()) return;
  for (std::size_t k = 0; k < told.size(); ++k) proof.look(told[k], k);
  for (std::size_t k = 0; k < told.size(); ++k)
    proof.tell(told[k], k);  // what is found for one may help others
}

}  // namespace proveout
