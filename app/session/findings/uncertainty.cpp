#include "app/session/findings/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/geometry/plane.h"
#include "removal/turning/section.h"

namespace proveout {

double surfaceUncertainty(const Toolpath& path, const std::vector<Tool>& tools, double resolution_mm) {
  std::set<int> used, measuring;
  for (const Motion& motion : path.motions) {
    if (motion.kind == MotionKind::kProbe) measuring.insert(motion.tool);
  }
  for (const Motion& motion : path.motions) {
    const bool moves_only = motion.kind == MotionKind::kProbe || motion.kind == MotionKind::kRapid;
    if (!moves_only || !measuring.contains(motion.tool)) used.insert(motion.tool);
  }
  double radius = std::numeric_limits<double>::infinity();
  for (const Tool& tool : tools) {
    if (used.contains(tool.number)) radius = std::min(radius, smallestRadius(tool));
  }
  if (!std::isfinite(radius)) return 0.0;
  return std::min(resolution_mm * resolution_mm / (8 * radius), resolution_mm / 2);
}

namespace {

/// Chords that turn by less belong to an arc, radians; those of a corner radius of 0.1 mm turn by 0.09.
constexpr double kArcTurn = 0.1;

/// How far a turned surface may be off, mm: of the part's mesh, which is its own or, `gridded`, that of a
/// grid.
double turnedUncertainty(const SetupRun& setup, double resolution_mm, bool gridded) {
  if (!gridded && setup.facet_error_mm > 0.0) return setup.facet_error_mm + kSectionChordMm;
  if (setup.turned->bodies.empty()) return 0.0;
  double most = 0.0;
  const auto add = [&](double radius) {
    // A chord of the grid leaves a circle by h^2 / (8 r), but never by more than its radius.
    if (radius > 0.0)
      most = std::max(
          most, std::min({resolution_mm * resolution_mm / (8.0 * radius), radius, 0.5 * resolution_mm}));
  };
  for (const SectionLoop& loop : setup.turned->bodies.front().loops) {
    const std::size_t n = loop.points.size();
    for (std::size_t k = 0; k < n; ++k) {
      add(loop.points[k].x());
      // Chords of an arc turn by a little from one to the next: their length over that angle is its radius.
      const Vec2 into = loop.points[k] - loop.points[(k + n - 1) % n],
                 out = loop.points[(k + 1) % n] - loop.points[k];
      const double turn = std::abs(std::atan2(cross2(into, out), into.dot(out)));
      if (turn > 1e-6 && turn < kArcTurn) add(std::max(into.norm(), out.norm()) / turn);
    }
  }
  return most;
}

/// Error of what a clamping cut, mm: by chords of the part's mesh, and of the meshes that moves were made
/// from.
struct Chords {
  double once = 0.0, by_moves = 0.0;
};

Chords chordsOf(const RunResult& run, std::size_t setup) {
  const SetupRun& made = run.setups[setup];
  Chords chords;
  if (made.turned) {
    const bool gridded = run.setups.back().turned == nullptr;
    chords.once = turnedUncertainty(made, run.resolution_mm, gridded);
    if (!gridded) return chords;
  } else {
    chords.once = made.facet_error_mm > 0.0
                      ? made.facet_error_mm
                      : surfaceUncertainty(made.interpreted.path, made.job.tools, run.resolution_mm);
  }
  for (std::size_t k = setup + 1; k < run.setups.size(); ++k) {
    if (!run.setups[k - 1].turned && !movesExactly(run.setups[k].from_previous))
      chords.by_moves += chords.once;
  }
  return chords;
}

}  // namespace

double partUncertainty(const RunResult& run) {
  double largest = 0.0;
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    const Chords chords = chordsOf(run, k);
    largest = std::max(largest, chords.once + chords.by_moves);
  }
  return largest;
}

double movesUncertainty(const RunResult& run) {
  double largest = 0.0;
  for (std::size_t k = 0; k < run.setups.size(); ++k) largest = std::max(largest, chordsOf(run, k).by_moves);
  return largest;
}

}  // namespace proveout
