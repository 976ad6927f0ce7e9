// Finds pairs of objects whose boxes overlap, where objects with consecutive numbers lie close together: a
// tree over them in their order, without sorting.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

class OrderTree {
 public:
  /// Takes the boxes of the objects.
  explicit OrderTree(std::vector<Box3> things) {
    levels_.push_back(std::move(things));
    while (levels_.back().size() > 1) {
      const std::vector<Box3>& below = levels_.back();
      std::vector<Box3> level((below.size() + kGroup - 1) / kGroup);
      for (std::size_t i = 0; i < below.size(); ++i) level[i / kGroup].extend(below[i]);
      levels_.push_back(std::move(level));
    }
  }

  /// Calls visit(i, k), i <= k, for each object with itself and for each pair whose boxes overlap.
  template <typename Visit>
  void eachPair(const Visit& visit) const {
    if (!levels_.front().empty()) compare(levels_.size() - 1, 0, 0, visit);
  }

 private:
  static constexpr std::size_t kGroup = 8;

  template <typename Visit>
  void compare(std::size_t level, std::size_t a, std::size_t b, const Visit& visit) const {
    if (level == 0) {
      visit(a, b);
      return;
    }
    const std::vector<Box3>& below = levels_[level - 1];
    const std::size_t end_a = std::min(below.size(), (a + 1) * kGroup),
                      end_b = std::min(below.size(), (b + 1) * kGroup);
    for (std::size_t i = a * kGroup; i < end_a; ++i) {
      if (!below[i].overlaps(levels_[level][b])) continue;
      for (std::size_t k = a == b ? i : b * kGroup; k < end_b; ++k) {
        if (below[i].overlaps(below[k])) compare(level - 1, i, k, visit);
      }
    }
  }

  std::vector<std::vector<Box3>> levels_;  ///< of objects; of groups of the level below; ...; one at the top
};

}  // namespace proveout
