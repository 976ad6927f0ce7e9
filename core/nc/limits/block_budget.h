// How many blocks a program may execute.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/nc/limits/loop_lines.h"

namespace proveout::nc {

/// Counts blocks against their limit, and those without a motion against a twentieth of it, a million at
/// least: a loop of calculations has an end sooner.
class BlockBudget {
 public:
  explicit BlockBudget(std::uint64_t limit)
      : limit_(limit), idle_limit_(std::max<std::uint64_t>(limit / 20, 1'000'000)) {}

  /// Motions since the last call; `motions`: of the run so far.
  std::uint64_t newMotions(std::uint64_t motions) {
    const std::uint64_t made = motions - motions_;
    motions_ = motions;
    return made;
  }
  void spend(std::uint64_t work, bool moved) {
    work_ += work;
    idle_ = moved ? 0 : idle_ + 1;
  }
  std::uint64_t work() const { return work_; }

  /// Whether a limit is passed, by a block on that line (index) with so many programs open.
  bool over(std::size_t depth, std::size_t line) {
    if (work_ + LoopLines::kWatched > limit_ || idle_ + LoopLines::kWatched > idle_limit_)
      loop_.note(depth, line);
    return work_ > limit_ || idle_ > idle_limit_;
  }
  /// Which one, and where. `counted`: what else than blocks counts, ", chords included".
  std::string message(std::string_view counted = {}) const {
    return work_ > limit_
               ? fmt::format("{} blocks executed without an end{}: {}", limit_, counted, loop_.question())
               : fmt::format("{} blocks executed without a motion: {}", idle_limit_, loop_.question());
  }

 private:
  std::uint64_t limit_, idle_limit_;
  std::uint64_t work_ = 0, idle_ = 0, motions_ = 0;
  LoopLines loop_;
};

}  // namespace proveout::nc
