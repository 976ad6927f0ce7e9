// Which corners of a half section are those of the section beside it.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "removal/turning/threads/thread_slices.h"

namespace proveout::thread_detail {

/// Two loops that go over into each other, and their common corners in the order of both.
struct LoopMatch {
  std::size_t a, b;  ///< numbers of the loops
  std::vector<std::pair<std::size_t, std::size_t>> corners;
};

/// `turns`: what a turn of `a` has more in `b`, 1 where one goes on over the angle 0. Nothing where the loops
/// are not the same ones.
std::optional<std::vector<LoopMatch>> matchSlices(const Slice& a, const Slice& b, std::int32_t turns);

/// Corners of a loop from one to another, the second one behind the first, and how far along the way each is,
/// 0 to 1.
struct Stretch {
  std::vector<const Corner*> corners;
  std::vector<double> along;

  Stretch(const CornerLoop& loop, std::size_t first, std::size_t last);
  std::size_t edges() const { return corners.size() - 1; }
};

/// The triangles between two stretches that begin and end together: calls body(i, j, of_b) for the one on
/// edge j of `b` and corner i of `a`, or on edge i of `a` and corner j of `b`. The stretch that is less far
/// along goes on; even(i, j) says whether `b` does where both are.
template <typename Even, typename Body>
void zigzag(const Stretch& a, const Stretch& b, Even&& even, Body&& body) {
  std::size_t i = 0, j = 0;
  while (i < a.edges() || j < b.edges()) {
    bool of_b = i == a.edges();
    if (i < a.edges() && j < b.edges()) {
      const double ahead = b.along[j + 1] - a.along[i + 1];
      of_b = std::abs(ahead) > 1e-9 ? ahead < 0.0 : even(i, j);
    }
    body(i, j, of_b);
    ++(of_b ? j : i);
  }
}

/// How far the surface between two sections, where corners of one have none in the other, is off the section
/// half way between them, mm; infinite where that cannot be told. `turns` as in matchSlices, of `middle`.
double offMiddle(const Slice& a, const Slice& b, const std::vector<LoopMatch>& matches, const Slice& middle,
                 std::int32_t turns);

/// How thick what only one of the two loops holds is where corners of one have none in the other, mm: area
/// over half of the perimeter.
double thickness(const CornerLoop& a, const CornerLoop& b, const LoopMatch& match);

/// How far the corners that only one of the two loops has are from the other one, mm.
double mismatch(const CornerLoop& a, const CornerLoop& b, const LoopMatch& match);

}  // namespace proveout::thread_detail
