// Which corners of a half section are those of the section beside it.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "removal/turning/thread_slices.h"

namespace proveout::thread_detail {

/// Two loops that go over into each other, and their common corners in the order of both.
struct LoopMatch {
  std::size_t a, b;  ///< numbers of the loops
  std::vector<std::pair<std::size_t, std::size_t>> corners;
};

/// `turns`: what a turn of `a` has more in `b`, 1 where one goes on over the angle 0. Nothing where the loops
/// are not the same ones.
std::optional<std::vector<LoopMatch>> matchSlices(const Slice& a, const Slice& b, std::int32_t turns);

/// How far the corners that only one of the two loops has are from the other one, mm.
double mismatch(const CornerLoop& a, const CornerLoop& b, const LoopMatch& match);

}  // namespace proveout::thread_detail
