// Which lines a program went round in before it was stopped.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace proveout::nc {

/// Fed with the blocks executed last; the loop is where the calls were least deep.
class LoopLines {
 public:
  static constexpr std::uint64_t kWatched = 10000;  ///< blocks before the limit that are looked at

  /// Index of the block's line, and how many calls are open there.
  void note(std::size_t depth, std::size_t line) {
    if (depth > depth_) return;
    if (depth < depth_) first_ = last_ = line;
    depth_ = depth;
    first_ = std::min(first_, line);
    last_ = std::max(last_, line);
  }
  /// "line 3", "lines 3 to 5"; indices.
  static std::string named(std::size_t first, std::size_t last) {
    return first == last ? fmt::format("line {}", first + 1)
                         : fmt::format("lines {} to {}", first + 1, last + 1);
  }
  /// "an endless loop in lines 3 to 5?" and how to go on.
  std::string question() const {
    const std::string lines = named(first_, last_);
    return fmt::format("an endless loop in {}? [simulation] max_blocks of the job sets the limit", lines);
  }

 private:
  std::size_t depth_ = std::numeric_limits<std::size_t>::max();
  std::size_t first_ = 0, last_ = 0;
};

}  // namespace proveout::nc
