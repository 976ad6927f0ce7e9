// Finds loops that can have no end: a program that comes back to a line with everything as it was before.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "core/nc/limits/loop_lines.h"

namespace proveout::nc {

class LoopWatch {
 public:
  using Bytes = std::span<const std::byte>;
  template <class T>
  static Bytes bytesOf(const T& object) {
    return std::as_bytes(std::span(&object, 1));
  }

  /// The block on line `line` (index) is next, `depth` programs being open; `run` tells the runs of programs
  /// apart, each repetition of a call.
  /// `state`: the objects that the next blocks depend on, the same ones each time; `fingerprint`: of the
  /// variables, and another one where something was asked that changes by itself (clocks, tables, the person
  /// at the machine). States are compared by their bytes: padding may hide a loop, but never makes one up.
  /// True: the program goes round without end; message() names the lines.
  bool comesBack(std::uint64_t run, std::size_t depth, std::size_t line, std::uint64_t fingerprint,
                 std::initializer_list<Bytes> state) {
    if (known_ && (depth < depth_ || (depth == depth_ && run != run_))) forget();
    const bool back = run == last_run_ && depth == last_depth_ && line <= last_line_;
    last_run_ = run;
    last_depth_ = depth;
    last_line_ = line;
    if (known_ && depth == depth_) {
      first_ = line < first_ ? line : first_;
      furthest_ = line > furthest_ ? line : furthest_;
    }
    if (!back) return false;
    const bool same = known_ && run == run_ && depth == depth_ && line == line_ &&
                      fingerprint == fingerprint_ && isSame(state);
    if (same) return ++rounds_ >= kRounds;
    // The state to compare with is taken anew after twice as many jumps each time (Brent's algorithm), so
    // that loops of any length are found.
    if (++jumps_ < wait_) return false;
    take(run, depth, line, fingerprint, state);
    return false;
  }
  std::string message() const {
    return fmt::format("an endless loop: the program comes back to {} with nothing changed",
                       LoopLines::named(first_, furthest_));
  }

 private:
  void forget() {
    known_ = false;
    jumps_ = 0;
    wait_ = 1;
  }

  bool isSame(std::initializer_list<Bytes> state) const {
    std::size_t at = 0;
    for (const Bytes& bytes : state) {
      if (std::memcmp(bytes.data(), state_.data() + at, bytes.size()) != 0) return false;
      at += bytes.size();
    }
    return true;
  }

  void take(std::uint64_t run, std::size_t depth, std::size_t line, std::uint64_t fingerprint,
            std::initializer_list<Bytes> state) {
    jumps_ = 0;
    wait_ *= 2;
    known_ = true;
    rounds_ = 0;
    run_ = run;
    depth_ = depth;
    line_ = first_ = furthest_ = line;
    fingerprint_ = fingerprint;
    state_.clear();
    for (const Bytes& bytes : state) state_.insert(state_.end(), bytes.begin(), bytes.end());
  }

  static constexpr int kRounds = 3;
  bool known_ = false;
  int rounds_ = 0;
  std::uint64_t jumps_ = 0, wait_ = 1, fingerprint_ = 0;
  std::uint64_t run_ = 0, last_run_ = 0;
  std::size_t depth_ = 0, line_ = 0, first_ = 0, furthest_ = 0, last_depth_ = 0, last_line_ = 0;
  std::vector<std::byte> state_;
};

}  // namespace proveout::nc
