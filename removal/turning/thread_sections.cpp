#include "removal/turning/thread_sections.h"

#include <algorithm>
#include <cmath>

#include "removal/turning/sweep_paths.h"

namespace proveout {

namespace {

/// Angles nearer to each other than this are one, rad.
constexpr double kOneAngle = 1e-6;
/// Angles whose sections are kept.
constexpr std::size_t kMostAngles = 16;
/// Cuts that are kept for them: with more the sections are made anew.
constexpr std::size_t kMostCuts = 256;

}  // namespace

std::vector<SectionPath> passesThrough(const ThreadSweep& thread, double angle) {
  std::vector<SectionPath> paths;
  const double total = 2.0 * kPi * thread.turns;
  if (total == 0.0) return paths;
  double turn = std::remainder(angle - thread.start_rad, 2.0 * kPi);
  if (turn * total < 0.0 && std::abs(turn) > kOneAngle) turn += std::copysign(2.0 * kPi, total);
  for (; std::abs(turn) <= std::abs(total) + kOneAngle; turn += std::copysign(2.0 * kPi, total)) {
    PlaneWay still;
    still.from = still.to = thread.at(std::clamp(turn / total, 0.0, 1.0));
    for (SectionPath& path : sweptPaths(*thread.outline, still)) paths.push_back(std::move(path));
  }
  return paths;
}

const SectionArea& ThreadSections::at(double angle, const SectionArea& section,
                                      const std::vector<ThreadSweep>& threads) {
  auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& k) {
    return std::abs(std::remainder(k.angle - angle, 2.0 * kPi)) <= kOneAngle;
  });
  if (known == known_.end()) {
    if (known_.size() == kMostAngles) known_.erase(known_.begin());
    known = known_.insert(known_.end(), {angle, 0, cuts_.size(), section});
  }
  for (; known->threads < threads.size(); ++known->threads) {
    const ThreadSweep& thread = threads[known->threads];
    known->area.subtractMany(passesThrough(thread, known->angle), thread.motion);
  }
  for (; known->cuts < cuts_.size(); ++known->cuts) {
    const Cut& cut = cuts_[known->cuts];
    known->area.subtract(cut.sweeps, cut.motion, cut.spared);
  }
  return known->area;
}

void ThreadSections::cut(const std::vector<SectionPath>& sweeps, MotionId motion,
                         const std::vector<SectionPath>& spared) {
  if (known_.empty()) return;
  if (cuts_.size() == kMostCuts) return clear();
  cuts_.push_back({sweeps, motion, spared});
}

void ThreadSections::clear() {
  known_.clear();
  cuts_.clear();
}

}  // namespace proveout
