// An open program: where its run is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace proveout::nc {

/// A control derives its own from this where it must know more of an open program.
struct FlowFrame {
  /// Of the call that opened the program, from 1; 0: the main program.
  struct Call {
    std::uint64_t number = 0;
    int repetition = 0, repetitions = 1;
    /// The program is to be run once more when it has returned.
    bool again() const { return repetition + 1 < repetitions; }
  };

  std::size_t first = 0, end = 0;  ///< the blocks of the program in its text, from and behind; indices
  std::size_t next = 0;            ///< block to be read next
  std::size_t block = 0;           ///< in hand: index of its line, or of the block where lines have several
  std::int64_t number = -1;        ///< that the block in hand bears, or -1
  std::uint64_t run = 0;           ///< tells the runs of programs apart, each repetition of a call
  Call call = {};
};

/// Where a run is: what the limits of a run are told.
struct FlowPlace {
  const FlowFrame& main;
  const FlowFrame& top;
  std::size_t depth = 0;  ///< programs that are open
  std::size_t line = 0;   ///< of the block in hand, index
};

/// `frames` has one at least.
template <class Frame>
FlowPlace flowPlace(const std::vector<Frame>& frames) {
  return {frames.front(), frames.back(), frames.size(), frames.back().block};
}

}  // namespace proveout::nc
