#include "removal/cut/leaf_stacks.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"

namespace proveout {
namespace {

/// Lists up to such a size are used again; larger ones are few.
constexpr std::size_t kMostSpare = 1 << 16;

constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// A float that is less, or more, than a finite value, by two of its last places or three.
float roundedDown(double value) {
  const auto near = toFloat(value);
  return near - 2.0F * std::numeric_limits<float>::epsilon() * std::abs(near);
}
float roundedUp(double value) { return -roundedDown(-value); }

StackList allPasses(const PassTable& table, double h) {
  StackList all;
  all.reserve(table.passes.size());
  for (std::uint32_t i = 0; i < table.passes.size(); ++i) {
    const Pass& pass = table.passes[i];
    // The block of a leaf reaches one step beyond its samples.
    const float covered =
        pass.lower == 0 ? -kNowhere : roundedDown((&pass + pass.lower)->body.coveredTop() - h);
    all.push_back({i, -kNowhere, roundedUp(pass.body.highestReach()), covered});
  }
  return all;
}

}  // namespace

void reachesBetween(const StackList& list, double bottom, double top, ReachList& out) {
  out.clear();
  for (const StackReach& reach : list) {
    if (reach.counts(bottom, top)) out.push_back({reach.pass, reach.low, reach.high});
  }
}

LeafStacks::LeafStacks(const Stock::Impl& impl, float height) : impl_(impl) {
  for (int axis = 0; axis < 3; ++axis) {
    const double first = (impl.blank.min[axis] - impl.origin[axis]) / impl.h,
                 last = (impl.blank.max[axis] - impl.origin[axis]) / impl.h;
    low_[axis] = (static_cast<int>(std::floor(first)) - 1) & ~7;
    end_[axis] = ((static_cast<int>(std::ceil(last)) + 1) & ~7) + 8;
  }
  width_.push_back(static_cast<std::size_t>((end_.x() - low_.x()) >> 3));
  levels_.emplace_back(width_[0] * static_cast<std::size_t>((end_.y() - low_.y()) >> 3), height);
  while (levels_.back().size() > 1) {
    const std::size_t rows = levels_.back().size() / width_.back();
    width_.push_back((width_.back() + 1) / 2);
    levels_.emplace_back(width_.back() * ((rows + 1) / 2));
  }
}

/// Heights of the larger squares.
void LeafStacks::spread() {
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    const std::vector<float>& finer = levels_[level - 1];
    std::fill(levels_[level].begin(), levels_[level].end(), kNone);
    for (std::size_t i = 0; i < finer.size(); ++i) {
      const std::size_t x = i % width_[level - 1] / 2, y = i / width_[level - 1] / 2;
      float& most = levels_[level][y * width_[level] + x];
      most = std::max(most, finer[i]);
    }
  }
}

float LeafStacks::heightOf(int level, int x, int y) const {
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  const std::size_t width = width_[static_cast<std::size_t>(level)];
  const std::vector<float>& heights = levels_[static_cast<std::size_t>(level)];
  return column < width && row * width < heights.size() ? heights[row * width + column] : kNone;
}

struct LeafStacks::Visit {
  const PassTable& table;
  const std::function<bool()>& stopped;
  const Body& body;
  /// Lists that were used. Freed ones would go back to the system and come again as new pages, over and over.
  tbb::enumerable_thread_specific<std::vector<StackList>> spare;

  StackList take() {
    std::vector<StackList>& mine = spare.local();
    if (mine.empty()) return {};
    StackList list = std::move(mine.back());
    mine.pop_back();
    return list;
  }
  void giveBack(StackList& list) {
    StackList used = std::move(list);
    list = {};
    used.clear();
    if (used.capacity() <= kMostSpare) spare.local().push_back(std::move(used));
  }
};

void LeafStacks::visit(const PassTable& table, const std::function<bool()>& stopped, const Body& body) {
  spread();
  const int top = static_cast<int>(levels_.size()) - 1;
  if (heightOf(top, 0, 0) == kNone) return;
  Visit visit{table, stopped, body, {}};
  quarter(visit, top, 0, 0, allPasses(table, impl_.h));
}

/// The four quarters of a square, whose level is one lower.
FourBlocks LeafStacks::blocksOf(int level, int x, int y) const {
  FourBlocks blocks;
  const int size = 8 << (level - 1);
  blocks.half_width = 0.5 * size * impl_.h;
  for (int i = 0; i < 4; ++i) {
    const int left = 2 * x + (i & 1), front = 2 * y + (i >> 1);
    const Vec3 low = impl_.position(low_.offsetBy(left * size, front * size, 0));
    blocks.x[i] = low.x() + blocks.half_width;
    blocks.y[i] = low.y() + blocks.half_width;
    blocks.z_low[i] = low.z();
    blocks.z_high[i] = heightOf(level - 1, left, front);
  }
  return blocks;
}

void LeafStacks::quarter(Visit& visit, int level, int x, int y, const StackList& list) const {
  if (visit.stopped()) return;
  if (level == 0) {
    visit.body(low_.offsetBy(8 * x, 8 * y, 0), list);
    return;
  }
  const FourBlocks blocks = blocksOf(level, x, y);
  std::array<StackList, 4> lists;
  for (StackList& own : lists) {
    own = visit.take();
    own.reserve(list.size() / 3);
  }
  for (const StackReach& reach : list) {
    double low[4], high[4];
    visit.table.passes[reach.pass].body.reach(blocks, low, high);
    for (std::size_t i = 0; i < 4; ++i) {
      if (low[i] >= blocks.z_high[i] || reach.covered >= blocks.z_high[i]) continue;
      lists[i].push_back({reach.pass, roundedDown(low[i]), roundedUp(high[i]), reach.covered});
    }
  }
  const auto child = [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    if (blocks.z_high[i] > kNone) quarter(visit, level - 1, 2 * x + (i & 1), 2 * y + (i >> 1), lists[at]);
    visit.giveBack(lists[at]);
  };
  if (level >= 2) {
    parallelFor(0, 4, child);
  } else {
    for (int i = 0; i < 4; ++i) child(i);
  }
}

}  // namespace proveout
