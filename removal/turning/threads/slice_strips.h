// What of the surface between two half sections needs none of those that were put in between for the rest of
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "removal/turning/threads/slice_match.h"

namespace proveout::thread_detail {

/// An edge that goes on from the first section to the last, whose ends stand in all of them.
struct Strip {
  struct Point {
    std::size_t slice;
    std::uint32_t vertex;
  };
  EdgeName name;
  /// The ways of the edge's start and end: at the first and the last section, and in between where the
  /// surface beside is no strip and has points there.
  std::vector<Point> start, end;
};

class SliceStrips {
 public:
  /// Two sections at least; `matches` of each with the next one. Corners have their vertices.
  SliceStrips(std::span<const Slice* const> slices, std::span<const std::vector<LoopMatch>> matches);

  const std::vector<Strip>& strips() const { return strips_; }
  /// Whether the edge behind a corner of the k-th section is that of a strip.
  bool covers(std::size_t k, std::size_t loop, std::size_t corner) const {
    return covered_[k][loop][corner] != 0;
  }

 private:
  struct Place {
    std::size_t loop, corner;
  };
  using Way = std::vector<Place>;  ///< of a corner through all sections; empty: it is not in all of them
  using Flags = std::vector<std::vector<std::uint8_t>>;  ///< by loop and corner

  void follow(std::span<const std::vector<LoopMatch>> matches);
  bool goesThrough(std::size_t loop, std::size_t corner) const;
  void addStrip(std::size_t loop, std::size_t corner);
  std::vector<Strip::Point> pointsOf(const Way& way, bool all) const;

  std::span<const Slice* const> slices_;
  std::vector<std::vector<Way>> ways_;  ///< of the first section's corners
  std::vector<Flags> covered_;          ///< by section
  std::vector<Strip> strips_;
};

/// Calls add(a, b, c) for each triangle of a strip, oriented as a surface with the part on the left of the
/// edge. `shorter(a, b, c, d)`: whether the line a-b is to be taken for a diagonal before c-d.
template <typename Shorter, typename Add>
void zip(const Strip& strip, Shorter&& shorter, Add&& add) {
  const auto &start = strip.start, &end = strip.end;
  std::size_t i = 0, j = 0;
  while (i + 1 < start.size() || j + 1 < end.size()) {
    bool on_start = j + 1 == end.size();
    if (!on_start && i + 1 < start.size()) {
      const std::size_t a = start[i + 1].slice, b = end[j + 1].slice;
      on_start =
          a != b ? a < b : !shorter(start[i].vertex, end[j + 1].vertex, start[i + 1].vertex, end[j].vertex);
    }
    if (on_start) {
      add(start[i].vertex, start[i + 1].vertex, end[j].vertex);
      ++i;
    } else {
      add(start[i].vertex, end[j + 1].vertex, end[j].vertex);
      ++j;
    }
  }
}

}  // namespace proveout::thread_detail
