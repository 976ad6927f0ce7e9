#include "removal/turning/threads/thread_sections.h"

#include <algorithm>
#include <cmath>

#include "removal/turning/section/sweep_paths.h"

namespace proveout {

namespace {

/// Angles nearer to each other than this are one, rad.
constexpr double kOneAngle = 1e-6;
/// Angles whose sections are kept.
constexpr std::size_t kMostAngles = 16;
/// Cuts that are kept for them: with more the sections are made anew.
constexpr std::size_t kMostCuts = 256;

/// How much more than is asked is known then, mm.
constexpr double kAround = 2.0;

Eigen::AlignedBox2d boundsOf(const std::vector<SectionPath>& paths) {
  Eigen::AlignedBox2d out;
  for (const SectionPath& path : paths) {
    for (const Vec2& p : path) out.extend(p);
  }
  return out;
}

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

ThreadSections::Known ThreadSections::within(double angle, const Window& window, const SectionArea& section) {
  Known out{angle, window, 0, 0, section};
  if (section.empty()) return out;
  const Window all = Window(section.min(), section.max()).merged(window);
  const Vec2 low = all.min() - Vec2::Ones(), high = all.max() + Vec2::Ones();
  const auto rectangle = [](double r0, double z0, double r1, double z1) {
    return SectionPath{{r0, z0}, {r1, z0}, {r1, z1}, {r0, z1}};
  };
  out.area.subtract({rectangle(low.x(), low.y(), window.min().x(), high.y()),
                     rectangle(window.max().x(), low.y(), high.x(), high.y()),
                     rectangle(low.x(), low.y(), high.x(), window.min().y()),
                     rectangle(low.x(), window.max().y(), high.x(), high.y())},
                    kNoMotion);
  return out;
}

const SectionArea& ThreadSections::at(double angle, const std::vector<SectionPath>& asked,
                                      const SectionArea& section, const std::vector<ThreadSweep>& threads) {
  auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& k) {
    return std::abs(std::remainder(k.angle - angle, 2.0 * kPi)) <= kOneAngle;
  });
  Window window = boundsOf(asked);
  if (known == known_.end() || !known->window.contains(window)) {
    // The next pass asks a little farther.
    window = Window(window.min() - Vec2::Constant(kAround), window.max() + Vec2::Constant(kAround));
    if (known == known_.end()) {
      if (known_.size() == kMostAngles) known_.erase(known_.begin());
      known = known_.emplace(known_.end());
    } else {
      window.extend(known->window);
    }
    *known = within(angle, window, section);
    known->cuts = cuts_.size();
  }
  for (; known->threads < threads.size(); ++known->threads) {
    const ThreadSweep& thread = threads[known->threads];
    std::vector<SectionPath> passes = passesThrough(thread, known->angle);
    std::erase_if(passes,
                  [&](const SectionPath& path) { return !known->window.intersects(boundsOf({path})); });
    known->area.subtractMany(passes, thread.motion);
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
