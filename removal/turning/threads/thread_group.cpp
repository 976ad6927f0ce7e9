#include "removal/turning/threads/thread_group.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"

namespace proveout {

namespace {

/// Ways and turns that differ by less are the same: mm, turns, rad.
constexpr double kAlike = 1e-6;
/// The box reaches so far beyond the outlines, mm.
constexpr double kMargin = 1.0;
/// Of edges of the box.
constexpr MotionId kBoxLabel = kNoMotion;

bool goTogether(const ThreadSweep& a, const ThreadSweep& b) {
  return std::abs(std::remainder(a.start_rad - b.start_rad, 2.0 * kPi)) <= kAlike &&
         std::abs(a.turns - b.turns) <= kAlike && std::abs(a.bend - b.bend) <= kAlike &&
         ((a.to - a.from) - (b.to - b.from)).cwiseAbs().maxCoeff() <= kAlike;
}

}  // namespace

std::vector<std::vector<std::size_t>> threadGroups(const std::vector<ThreadSweep>& threads) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    const auto known = std::find_if(groups.begin(), groups.end(), [&](const std::vector<std::size_t>& group) {
      return goTogether(threads[group.front()], threads[i]);
    });
    if (known != groups.end())
      known->push_back(i);
    else
      groups.push_back({i});
  }
  return groups;
}

GroupOutline::GroupOutline(const std::vector<ThreadSweep>& threads, const std::vector<std::size_t>& group)
    : GroupOutline(threads, group, -std::numeric_limits<double>::infinity(),
                   std::numeric_limits<double>::infinity()) {}

GroupOutline::GroupOutline(const std::vector<ThreadSweep>& threads, const std::vector<std::size_t>& group,
                           double low, double high) {
  PROVEOUT_ASSERT(!group.empty());
  const Vec2 first = threads[group.front()].from;
  for (const std::size_t i : group) {
    SectionPath& path = outlines_.emplace_back();
    threads[i].outline->chain(0.0, 2.0 * kPi, kSectionChordMm, path);
    for (Vec2& p : path) p += threads[i].from - first;
  }
  makeBox(low - first.x(), high - first.x());
}

void GroupOutline::makeBox(double low, double high) {
  Vec2 min = Vec2::Constant(std::numeric_limits<double>::infinity()), max = -min;
  for (const SectionPath& path : outlines_) {
    for (const Vec2& p : path) {
      min = min.cwiseMin(p);
      max = max.cwiseMax(p);
    }
  }
  min -= Vec2::Constant(kMargin);
  max += Vec2::Constant(kMargin);
  min.x() = std::max(min.x(), low);
  max.x() = std::min(max.x(), high);
  if (!(min.x() < max.x())) return;
  shift_ = Vec2(kMargin - min.x(), 0.0);  // sections have no r below 0
  for (SectionPath& path : outlines_) {
    for (Vec2& p : path) p += shift_;
  }
  SectionLoop box;
  box.points = {min, {max.x(), min.y()}, max, {min.x(), max.y()}};
  for (Vec2& p : box.points) p += shift_;
  box.motion.assign(box.points.size(), kBoxLabel);
  left_ = SectionArea({box});
}

bool GroupOutline::add(std::size_t k) {
  PROVEOUT_ASSERT(k < outlines_.size());
  return !left_.empty() && left_.subtract({outlines_[k]}, static_cast<MotionId>(k)) > 0.0;
}

std::vector<SectionLoop> GroupOutline::borders() const {
  std::vector<SectionLoop> out;
  for (const SectionBody& body : left_.bodies()) {
    for (const SectionLoop& loop : body.loops) {
      const std::size_t n = loop.points.size();
      if (std::find(loop.motion.begin(), loop.motion.end(), kBoxLabel) != loop.motion.end()) continue;
      SectionLoop& border = out.emplace_back();
      for (std::size_t i = n; i-- > 0;) {
        border.points.push_back(loop.points[i] - shift_);
        border.motion.push_back(loop.motion[(i + n - 1) % n]);
      }
    }
  }
  return out;
}

std::vector<bool> GroupOutline::onBorder() const {
  std::vector<bool> there(outlines_.size(), false);
  for (const SectionBody& body : left_.bodies()) {
    for (const SectionLoop& loop : body.loops) {
      for (const MotionId k : loop.motion) {
        if (k != kBoxLabel) there[k] = true;
      }
    }
  }
  return there;
}

std::vector<std::size_t> passesThatCount(const std::vector<ThreadSweep>& threads,
                                         const std::vector<std::size_t>& group, double low, double high) {
  GroupOutline whole(threads, group, low, high), counted = whole;
  for (std::size_t k = 0; k < group.size(); ++k) whole.add(k);
  const std::vector<bool> there = whole.onBorder();
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < group.size(); ++k) {
    if (there[k] && counted.add(k)) out.push_back(k);
  }
  // What those leave inside of the union is taken by passes without a border; the last ones are the deepest.
  for (std::size_t k = group.size(); k-- > 0;) {
    if (!there[k] && counted.add(k)) out.push_back(k);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace proveout
