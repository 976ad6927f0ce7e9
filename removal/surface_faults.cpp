#include "removal/surface_faults.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>

#include "core/base/parallel_for.h"

namespace proveout {

namespace {

/// Edge of a fan: from one neighbour of the middle to the next.
using FanEdge = std::array<std::uint32_t, 2>;

/// Whether the edges form one closed ring without repeats. Sorts them.
bool isRing(FanEdge* edges, std::size_t count) {
  if (count < 3) return false;
  std::sort(edges, edges + count);
  for (std::size_t i = 1; i < count; ++i) {
    if (edges[i][0] == edges[i - 1][0]) return false;
  }
  std::size_t length = 0, at = 0;
  do {
    const FanEdge* next = std::lower_bound(edges, edges + count, FanEdge{edges[at][1], 0});
    if (next == edges + count || (*next)[0] != edges[at][1]) return false;
    at = static_cast<std::size_t>(next - edges);
  } while (at != 0 && ++length <= count);
  return length + 1 == count;
}

}  // namespace

void findBrokenFans(const TriMesh& mesh, const std::vector<std::uint32_t>& name,
                    std::vector<std::uint32_t>& broken) {
  constexpr std::size_t kBlock = 4096;
  const std::size_t blocks = (mesh.triangles.size() + kBlock - 1) / kBlock, vertices = name.size();
  std::vector<std::uint32_t> end(vertices + 1, 0);
  std::vector<std::uint8_t> watched(blocks, 1);  ///< blocks of triangles with corners that are watched
  const auto eachCorner = [&](auto&& body) {
    parallelFor(std::size_t{0}, blocks, [&](std::size_t block) {
      if (watched[block] == 0) return;
      bool any = false;
      for (std::size_t t = block * kBlock; t < std::min(mesh.triangles.size(), (block + 1) * kBlock); ++t) {
        const auto& v = mesh.triangles[t];
        for (int i = 0; i < 3; ++i) {
          if (name[v[i]] == kNoWatch) continue;
          body(v[i], FanEdge{v[(i + 1) % 3], v[(i + 2) % 3]});
          any = true;
        }
      }
      watched[block] = any;
    });
  };
  const auto next = [&](std::uint32_t v) {
    return std::atomic_ref<std::uint32_t>(end[v]).fetch_add(1, std::memory_order_relaxed);
  };
  eachCorner([&](std::uint32_t v, const FanEdge&) { next(v); });
  std::uint32_t total = 0;
  for (std::uint32_t& e : end) {
    const std::uint32_t count = e;
    e = total;
    total += count;
  }
  const auto edges = std::make_unique_for_overwrite<FanEdge[]>(total);
  eachCorner([&](std::uint32_t v, const FanEdge& edge) { edges[next(v)] = edge; });
  std::vector<std::vector<std::uint32_t>> found((vertices + kBlock - 1) / kBlock);
  parallelFor(std::size_t{0}, found.size(), [&](std::size_t block) {
    for (std::size_t v = block * kBlock; v < std::min(vertices, (block + 1) * kBlock); ++v) {
      if (name[v] == kNoWatch) continue;
      const std::size_t first = v == 0 ? 0 : end[v - 1];
      if (isRing(edges.get() + first, end[v] - first)) continue;
      found[block].push_back(name[v]);
      for (std::size_t i = first + 1; i < end[v]; ++i) {
        if (edges[i][0] == edges[i - 1][0] && name[edges[i][0]] != kNoWatch) {
          found[block].push_back(name[edges[i][0]]);
        }
      }
    }
  });
  for (const auto& list : found) broken.insert(broken.end(), list.begin(), list.end());
}

}  // namespace proveout
