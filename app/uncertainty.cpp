// How far the part's surface may lie off the true one after several clampings.
#include <algorithm>

#include "app/pipeline.h"
#include "app/turning.h"

namespace proveout {
namespace {

/// Error of what a clamping cut, mm: by chords of the part's mesh, and of the meshes that moves were made
/// from.
struct Chords {
  double once = 0.0, by_moves = 0.0;
};

Chords chordsOf(const RunResult& run, std::size_t setup) {
  const SetupRun& made = run.setups[setup];
  Chords chords;
  if (made.turned) return {turnedUncertainty(made, run.resolution_mm), 0.0};
  chords.once = surfaceUncertainty(made.interpreted.path, made.job.tools, run.resolution_mm);
  for (std::size_t k = setup + 1; k < run.setups.size(); ++k) {
    if (!movesExactly(run.setups[k].from_previous)) chords.by_moves += chords.once;
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
