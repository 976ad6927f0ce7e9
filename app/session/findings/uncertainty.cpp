#include "app/session/findings/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/geometry/plane.h"
#include "removal/turning/section/section.h"

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

/// Error of what a clamping cut, mm: by chords of the part's mesh, and of the meshes that moves were made
/// from.
struct Chords {
  double once = 0.0, by_moves = 0.0;
};

Chords chordsOf(const RunResult& run, std::size_t setup) {
  const SetupRun& made = run.setups[setup];
  Chords chords;
  if (const std::optional<double> of_grid = made.form->gridChords(run.resolution_mm)) {
    const bool gridded = !run.setups.back().form->closedForm();
    const bool of_facets = !gridded && made.facet_error_mm > 0.0;
    chords.once = of_facets ? made.facet_error_mm + kSectionChordMm : *of_grid;
    if (!gridded) return chords;
  } else {
    chords.once = made.facet_error_mm > 0.0
                      ? made.facet_error_mm
                      : surfaceUncertainty(made.interpreted.path, made.job.tools, run.resolution_mm);
  }
  for (std::size_t k = setup + 1; k < run.setups.size(); ++k) {
    if (!run.setups[k - 1].form->closedForm() && !movesExactly(run.setups[k].from_previous))
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
