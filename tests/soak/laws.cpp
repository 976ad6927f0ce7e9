#include "tests/soak/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/session/comparison.h"
#include "core/mesh/tri_mesh.h"
#include "removal/compare/exact_part.h"
#include "removal/wire/falls/wire_work.h"

namespace proveout::soak {
namespace {

using Broken = std::optional<std::string>;

/// Rounding of sums, by the blank's volume.
constexpr double kRounding = 1e-9;
/// And where nothing is told, of what was removed.
constexpr double kQuietShare = 1e-4;
/// By how much of the blank the removed volume may fall where the run tells that walls are thinner than its
/// grid: such walls are lost and, cut again, may come back.
constexpr double kThinShare = 0.02;

/// How far a vertex of a milled part may be off without a word, in cells: where two floors with a step lower
/// than a cell between them share a cell, its vertex lies halfway.
constexpr double kPlaceCells = 0.5;

double initialOf(const RunResult& run) { return run.setups.front().initial_mm3; }
double finalOf(const RunResult& run) { return run.surface().volume_mm3; }

bool tells(const RunResult& run, FindingKind kind) {
  return std::any_of(run.findings.begin(), run.findings.end(),
                     [&](const Finding& finding) { return finding.kind == kind; });
}

Broken nothingCut(const LawCase& c) {
  const Result<RunResult> idle = c.runner.run("idle.toml");
  if (!idle) return fmt::format("the idle job fails: {}", idle.error().message);
  const double initial = initialOf(*idle), left = finalOf(*idle);
  if (initial == left) return std::nullopt;
  return fmt::format("nothing is cut, and of {} mm3 {} are removed (grid {} mm)", initial, initial - left,
                     idle->resolution_mm);
}

Broken balance(const LawCase& c) {
  double sum = 0.0;
  for (const SetupRun& setup : c.whole.setups) {
    const double removed = setup.initial_mm3 - setup.surface.volume_mm3;
    sum += removed;
    if (removed < 0.0)
      return fmt::format("setup '{}' removes {} of {} mm3", setup.name, removed, setup.initial_mm3);
    if (setup.surface.volume_mm3 < 0.0) return fmt::format("{} mm3 are left", setup.surface.volume_mm3);
    double motions = 0.0;
    for (const float volume : setup.removal.removed_mm3) motions += static_cast<double>(volume);
    // What a move onto another grid lost no motion has removed.
    const bool lost = setup.surface.mesh.triangles.empty() && tells(c.whole, FindingKind::kThinFeature);
    const double slack = 1e-5 * setup.initial_mm3 + setup.surface.volume_error_mm3;
    if (std::abs(motions - removed) > slack && !lost)
      return fmt::format("motions remove {}, the setup {} of {} mm3", motions, removed, setup.initial_mm3);
  }
  const double off = initialOf(c.whole) - sum - finalOf(c.whole);
  if (std::abs(off) <= kRounding * initialOf(c.whole)) return std::nullopt;
  return fmt::format("initial {} - removed {} is not final {}", initialOf(c.whole), sum, finalOf(c.whole));
}

/// The pieces of each clamping are what it left.
Broken pieces(const LawCase& c) {
  for (const SetupRun& setup : c.whole.setups) {
    double sum = 0.0;
    for (const StockBody& body : setup.bodies) sum += body.volume_mm3;
    const double left = setup.surface.volume_mm3;
    if (!setup.bodies.empty() && std::abs(sum - left) > kRounding * initialOf(c.whole))
      return fmt::format("the {} pieces of setup '{}' have {} mm3 of {}", setup.bodies.size(), setup.name,
                         sum, left);
  }
  return std::nullopt;
}

/// How far the removed volume may be off, as the run tells.
double slackOf(const RunResult& run) {
  double stated = 0.0;
  for (const SetupRun& setup : run.setups) stated += setup.surface.volume_error_mm3;
  if (tells(run, FindingKind::kThinFeature)) return std::max(stated, kThinShare * initialOf(run));
  return kRounding * initialOf(run) + kQuietShare * (initialOf(run) - finalOf(run)) + stated;
}

Broken growing(const LawCase& c) {
  double before = 0.0, slack_before = 0.0;
  int line = 0;
  std::vector<int> stops = c.runner.made().stops;
  stops.push_back(0);
  for (const int stop : stops) {
    const Result<RunResult> run =
        stop == 0 ? Result<RunResult>(Error{}) : c.runner.run("job.toml", {1, stop});
    if (stop != 0 && !run) return fmt::format("until line {}: {}", stop, run.error().message);
    const RunResult& at = stop == 0 ? c.whole : *run;
    const double removed = initialOf(at) - finalOf(at);
    const double slack = slackOf(at);
    if (removed < before - std::max(slack, slack_before))
      return fmt::format(
          "up to line {} {} mm3 are removed, up to line {} {} ({:.3g} less) of {} mm3, grid {}{}", line,
          before, stop, removed, before - removed, initialOf(at), at.resolution_mm,
          tells(at, FindingKind::kThinFeature) ? ", thin_feature" : "");
    before = removed;
    slack_before = slack;
    line = stop;
  }
  return std::nullopt;
}

Broken closed(const LawCase& c) {
  for (const SetupRun& setup : c.whole.setups) {
    if (!analyseTopology(setup.surface.mesh).closedManifold()) return fmt::format("setup '{}'", setup.name);
    if (!setup.surface.mesh.triangles.empty() && !(setup.extent.volume_mm3 > 0.0))
      return fmt::format("setup '{}': the mesh encloses {} mm3", setup.name, setup.extent.volume_mm3);
  }
  return std::nullopt;
}

Broken meshVolumes(const LawCase& c) {
  const SetupRun& last = c.whole.setups.back();
  if (last.surface.mesh.triangles.empty()) return std::nullopt;
  const double part = (last.form->profile() != nullptr)
                          ? (last.bodies.empty() ? 0.0 : last.bodies.front().volume_mm3)
                          : finalOf(c.whole);
  const double area = meshArea(last.surface.mesh), mesh = last.extent.volume_mm3;
  const bool section = (last.form->profile() != nullptr) || c.runner.made().cutsWithWire();
  const double within =
      section ? 0.1 * last.job.simulation.profile_resolution_mm * 2 : c.whole.resolution_mm * 0.1;
  if (std::abs(part - mesh) <= within * area || tells(c.whole, FindingKind::kThinFeature))
    return std::nullopt;
  return fmt::format("the mesh has {} mm3, the part {}: {:.2g} %, {:.4f} mm over its {} mm2 (grid {}){}",
                     mesh, part, 100 * (mesh / part - 1), (mesh - part) / area, area, c.whole.resolution_mm,
                     tells(c.whole, FindingKind::kThinFeature) ? ", thin_feature" : "");
}

Broken places(const LawCase& c) {
  if (tells(c.whole, FindingKind::kThinFeature) || c.whole.surface().mesh.triangles.empty())
    return std::nullopt;
  if (c.runner.made().kind == Kind::kSetups) return std::nullopt;
  std::string error;
  const Job job = c.runner.load("job.toml", error);
  Progress progress;
  const Result<Blank> blank = openBlank(job, progress);
  if (!blank) return std::nullopt;
  const auto part = makeExactPart(blank->shape, c.whole);
  if (!part) return part.error().message;
  if (*part == nullptr) return std::nullopt;
  double worst = 0.0;
  Vec3 where = Vec3::Zero();
  const auto& positions = c.whole.surface().mesh.positions;
  const std::size_t step = std::max<std::size_t>(1, positions.size() / 3000);
  for (std::size_t i = 0; i < positions.size(); i += step) {
    const Vec3 p = positions[i].cast<double>();
    const double off = std::abs((*part)->at(p, 2.0).value);
    if (off > worst) worst = off, where = p;
  }
  const double within =
      (c.whole.setups.back().form->profile() != nullptr) ? 0.01 : kPlaceCells * c.whole.resolution_mm;
  if (worst <= within) return std::nullopt;
  return fmt::format("a vertex is {:.4f} mm off its place (grid {}) at X{:.3f} Y{:.3f} Z{:.3f}", worst,
                     c.whole.resolution_mm, where.x(), where.y(), where.z());
}

Broken sameForThreads(const LawCase& c) {
  for (const int threads : {2, 4}) {
    const Result<RunResult> run = c.runner.run("job.toml", {threads, 0});
    if (!run) return fmt::format("{} threads: {}", threads, run.error().message);
    if (run->setups.back().mesh_sha256 != c.whole.setups.back().mesh_sha256 ||
        finalOf(*run) != finalOf(c.whole))
      return fmt::format("{} threads make another part than one", threads);
  }
  return std::nullopt;
}

Broken sameForSimd(const LawCase& c) {
  std::string first;
  for (const char* level : {"baseline", "avx2", "avx512"}) {
    const auto made = c.runner.report(level, 2);
    if (!made || made->part_sha256.empty()) return fmt::format("{}: the program fails", level);
    if (first.empty()) first = made->part_sha256;
    if (made->part_sha256 != first) return fmt::format("{} makes another part than baseline", level);
  }
  return std::nullopt;
}

/// Of wires only: tests/bench/bench_prediction measures the others, over jobs large enough to matter.
/// The address sanitizer takes several times the memory of what it watches.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

Broken memoryAsPredicted(const LawCase& c) {
  // How many heights the walls of a leaning wire take shows when they are made.
  constexpr double kFactor = 1.5, kFewerHeights = 10.0;
  if (kSanitized || !c.runner.made().cutsWithWire()) return std::nullopt;
  const auto made = c.runner.report("baseline", 2);
  if (!made) return "the program fails";
  const double ratio = made->peak_mb / made->predicted_mb;
  const bool leans = !standsUpright(c.whole.setups.back().interpreted.path);
  if (ratio < kFactor && ratio > 1.0 / (leans ? kFewerHeights : kFactor)) return std::nullopt;
  return fmt::format("{:.0f} MB taken, {:.0f} predicted", made->peak_mb, made->predicted_mb);
}

}  // namespace

const std::vector<Law>& laws() {
  static const std::vector<Law> kLaws = {
      {"nothing cut, nothing removed", 1, nothingCut},
      {"initial = removed + final", 1, balance},
      {"final = the sum of the pieces", 1, pieces},
      {"removed never falls", 1, growing},
      {"closed 2-manifold", 1, closed},
      {"the mesh encloses the part", 1, meshVolumes},
      {"vertices in their places", 1, places},
      {"walls beside the wire's way", 1, wallsBesideTheWire},
      {"the same for any number of threads", 4, sameForThreads},
      {"the same for any SIMD level", 16, sameForSimd},
      {"memory as predicted", 16, memoryAsPredicted},
  };
  return kLaws;
}

Judged judge(std::uint64_t seed) {
  Judged judged;
  CaseRunner runner(makeCase(seed));
  const Result<RunResult> whole = runner.run("job.toml");
  if (!whole) {
    judged.why = whole.error().message;
    return judged;
  }
  judged.ran = true;
  for (const Law& law : laws()) {
    if (seed % static_cast<std::uint64_t>(law.every) != 0) continue;
    if (const Broken broken = law.broken({runner, *whole}))
      judged.broken.push_back(std::string(law.name) + ": " + *broken);
  }
  return judged;
}

}  // namespace proveout::soak
