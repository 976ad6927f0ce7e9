#include "core/mesh/corner_table.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/stretches.h"

namespace proveout {

CornerTable::CornerTable(Triangles triangles, std::size_t vertices)
    : triangles_(std::move(triangles)), twin_(3 * triangles_.size(), kNone), out_(vertices, kNone) {
  // Half-edges by the lower one of their ends, with the other one, so that both of an edge are close
  // together.
  struct Edge {
    std::uint32_t other, half;
  };
  std::vector<std::uint32_t> start(vertices + 1, 0);
  for (const auto& t : triangles_) {
    for (int i = 0; i < 3; ++i) ++start[std::min(t[i], t[(i + 1) % 3]) + 1];
  }
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<std::uint32_t> place(start.begin(), start.end() - 1);
  std::vector<Edge> edges(twin_.size());
  for (std::uint32_t h = 0; h < twin_.size(); ++h) {
    const std::uint32_t a = from(h), b = to(h);
    edges[place[std::min(a, b)]++] = {std::max(a, b), h};
    out_[a] = h;
  }
  forEachBelow(vertices, [&](std::size_t v) {
    for (std::uint32_t k = start[v]; k < start[v + 1]; ++k) {
      if (twin_[edges[k].half] != kNone) continue;
      for (std::uint32_t j = k + 1; j < start[v + 1]; ++j) {
        if (edges[j].other == edges[k].other) pair(edges[j].half, edges[k].half);
      }
    }
  });
  PROVEOUT_ASSERT(std::ranges::find(twin_, kNone) == twin_.end());
}

void CornerTable::collapse(std::uint32_t h) {
  const std::uint32_t a = from(h), b = to(h), t = twin_[h];
  const std::uint32_t left = previous(h), right = next(t);  // ca of the triangle abc, ad of bad
  const std::uint32_t c = from(left), d = to(right);
  const std::uint32_t inner_left = twin_[left], inner_right = twin_[right];           // ac, da
  const std::uint32_t outer_left = twin_[next(h)], outer_right = twin_[previous(t)];  // cb, bd
  for (std::uint32_t g = inner_left; g != right; g = turned(g)) triangles_[g / 3][g % 3] = b;
  pair(inner_left, outer_left);
  pair(inner_right, outer_right);
  out_[b] = inner_left;
  out_[c] = outer_left;
  out_[d] = inner_right;
  out_[a] = kNone;
  triangles_[h / 3][0] = triangles_[t / 3][0] = kNone;
}

}  // namespace proveout
