#include "core/mesh/corner_table.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

namespace proveout {

CornerTable::CornerTable(Triangles triangles, std::size_t vertices)
    : triangles_(std::move(triangles)), twin_(3 * triangles_.size(), kNone), out_(vertices, kNone) {
  // Half-edges by the vertex that they come from.
  std::vector<std::uint32_t> start(vertices + 1, 0), leaving(twin_.size());
  for (const auto& t : triangles_) {
    for (const std::uint32_t v : t) ++start[v + 1];
  }
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<std::uint32_t> place(start.begin(), start.end() - 1);
  for (std::uint32_t h = 0; h < twin_.size(); ++h) leaving[place[from(h)]++] = h;
  constexpr std::size_t kStretch = 1024;
  parallelFor(std::size_t{0}, (vertices + kStretch - 1) / kStretch, [&](std::size_t stretch) {
    const auto last = static_cast<std::uint32_t>(std::min(vertices, (stretch + 1) * kStretch));
    for (auto v = static_cast<std::uint32_t>(stretch * kStretch); v < last; ++v) {
      for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
        const std::uint32_t h = leaving[i], w = to(h);
        for (std::uint32_t j = start[w]; j < start[w + 1]; ++j) {
          if (to(leaving[j]) == v) twin_[h] = leaving[j];
        }
      }
      if (start[v] < start[v + 1]) out_[v] = leaving[start[v]];
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
