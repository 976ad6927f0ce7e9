#include "core/mesh/corner_table.h"

#include <algorithm>
#include <bit>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

namespace proveout {

CornerTable::CornerTable(const Triangles& triangles, const std::vector<std::uint32_t>& labels,
                         std::size_t vertices)
    : count_(triangles.size()),
      triangles_(std::make_unique_for_overwrite<Triangle[]>(count_)),
      out_(std::make_unique_for_overwrite<std::uint32_t[]>(vertices)) {
  PROVEOUT_ASSERT(triangles.size() < std::size_t{1} << 29);
  PROVEOUT_ASSERT(labels.empty() || labels.size() == triangles.size());
  // Edges belong to the lower one of their ends. Ranges of vertices are worked on side by side, each with the
  // stretches of triangles that have edges of it.
  constexpr std::size_t kStretch = 512, kMostRanges = 32;
  const std::size_t stretches = (triangles.size() + kStretch - 1) / kStretch;
  const int shift = std::bit_width(vertices / kMostRanges);  // a range has 1 << shift vertices
  const auto endOf = [&](std::size_t stretch) {
    return std::min(triangles.size(), (stretch + 1) * kStretch);
  };
  std::vector<std::uint32_t> ranges(stretches, 0);  // bits
  parallelFor(std::size_t{0}, stretches, [&](std::size_t stretch) {
    for (std::size_t t = stretch * kStretch; t < endOf(stretch); ++t) {
      const auto& [a, b, c] = triangles[t];
      triangles_[t] = {{b, c, a}, labels.empty() ? 0 : labels[t], {kNone, kNone, kNone}, 0};
      for (const std::uint32_t v : triangles[t]) ranges[stretch] |= 1u << (v >> shift);
    }
    for (std::size_t t = stretch * kStretch + 1; t < endOf(stretch); ++t)
      pairDiagonal(static_cast<std::uint32_t>(t));
  });
  const auto waiting = std::make_unique_for_overwrite<std::uint32_t[]>(vertices);
  parallelFor(std::size_t{0}, (vertices >> shift) + 1, [&](std::size_t i) {
    const auto first = static_cast<std::uint32_t>(i << shift),
               last = static_cast<std::uint32_t>(std::min(vertices, (i + 1) << shift));
    for (std::uint32_t v = first; v < last; ++v) waiting[v] = out_[v] = kNone;
    for (std::size_t stretch = 0; stretch < stretches; ++stretch) {
      if ((ranges[stretch] >> i & 1u) != 0)
        pairEdges(first, last, stretch * kStretch, endOf(stretch), waiting.get());
    }
  });
  PROVEOUT_ASSERT(std::all_of(&waiting[0], &waiting[vertices], [](std::uint32_t h) { return h == kNone; }));
}

/// Pairs what a triangle has in common with the one before it, if they are a quad cut in two: a third of all
/// edges, without a search.
void CornerTable::pairDiagonal(std::uint32_t t) {
  const std::array<std::uint32_t, 3> a = corners(t - 1), b = corners(t);
  if (a[0] == b[0] && a[2] == b[1] && twin(halfEdge(t - 1, 2)) == kNone)
    pair(halfEdge(t - 1, 2), halfEdge(t, 0));
  else if (a[1] == b[0] && a[2] == b[2] && twin(halfEdge(t - 1, 1)) == kNone)
    pair(halfEdge(t - 1, 1), halfEdge(t, 2));
}

/// Pairs the half-edges of triangles begin .. end - 1 whose lower end is in first .. last - 1. Those that
/// wait for their other one are a list for each lower end, linked by their twins.
void CornerTable::pairEdges(std::uint32_t first, std::uint32_t last, std::size_t begin, std::size_t end,
                            std::uint32_t* waiting) {
  for (std::size_t t = begin; t < end; ++t) {
    const Triangle& triangle = triangles_[t];
    for (std::uint32_t i = 0, before = 2; i < 3; before = i++) {
      const std::uint32_t h = halfEdge(t, i), a = triangle.to[before], b = triangle.to[i];
      if (a - first < last - first) out_[a] = h;
      const std::uint32_t low = std::min(a, b);
      if (low - first >= last - first || twin(h) != kNone) continue;
      std::uint32_t* link = &waiting[low];
      while (*link != kNone && (to(*link) != a || from(*link) != b)) link = &twinAt(*link);
      if (*link == kNone) {
        twinAt(h) = waiting[low];
        waiting[low] = h;
        continue;
      }
      const std::uint32_t g = *link;
      *link = twin(g);
      pair(g, h);
    }
  }
}

void CornerTable::collapse(std::uint32_t h) {
  const std::uint32_t a = from(h), b = to(h), t = twin(h);
  const std::uint32_t left = previous(h), right = next(t);  // ca of the triangle abc, ad of bad
  const std::uint32_t c = from(left), d = to(right);
  const std::uint32_t inner_left = twin(left), inner_right = twin(right);           // ac, da
  const std::uint32_t outer_left = twin(next(h)), outer_right = twin(previous(t));  // cb, bd
  for (std::uint32_t g = inner_left; g != right; g = turned(g)) numberAt(previous(g)) = b;
  pair(inner_left, outer_left);
  pair(inner_right, outer_right);
  out_[b] = inner_left;
  out_[c] = outer_left;
  out_[d] = inner_right;
  out_[a] = kNone;
  triangles_[triangleOf(h)].to[0] = triangles_[triangleOf(t)].to[0] = kNone;
}

}  // namespace proveout
