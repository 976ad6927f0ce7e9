// The links of vertices: the edges of their triangles that lie opposite. Include it in .cpp files only.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// Edge of a triangle opposite of a vertex, from end to end in the triangle's order.
using LinkEdge = std::array<std::uint32_t, 2>;

/// Whether the edges, joined end to start, form one closed walk over all of them: the triangles one closed
/// fan. May change their order.
inline bool isOneCycle(std::span<LinkEdge> link) {
  constexpr std::size_t kSearchedInOrder = 16;  // beyond, sorting pays
  if (link.empty()) return false;
  const bool sorted = link.size() > kSearchedInOrder;
  if (sorted) std::sort(link.begin(), link.end());
  const auto startingAt = [&](std::uint32_t vertex) {
    if (!sorted) return std::ranges::find_if(link, [&](const LinkEdge& edge) { return edge[0] == vertex; });
    const auto at = std::ranges::lower_bound(link, LinkEdge{vertex, 0});
    return at != link.end() && at->front() == vertex ? at : link.end();
  };
  // The walk goes on from each vertex in one way: back at the start after that many steps, it has passed that
  // many vertices, and so every edge once.
  const auto [start, first_end] = link.front();
  std::uint32_t at = first_end;
  for (std::size_t step = 1; step < link.size(); ++step) {
    const auto next = startingAt(at);
    if (at == start || next == link.end()) return false;
    at = next->back();
  }
  return at == start;
}

/// Stretches of following vertices that are looked at on one thread each.
inline constexpr std::size_t kLinkStretches = 64;

namespace links_detail {

constexpr std::size_t kBlock = 2048;  ///< of triangles

/// Calls body(vertex, edge) for each corner of a block of triangles.
template <typename Body>
void eachCorner(const TriMesh& mesh, std::size_t block, const Body& body) {
  for (std::size_t t = block * kBlock; t < std::min(mesh.triangles.size(), (block + 1) * kBlock); ++t) {
    const auto& v = mesh.triangles[t];
    body(v[0], LinkEdge{v[1], v[2]});
    body(v[1], LinkEdge{v[2], v[0]});
    body(v[2], LinkEdge{v[0], v[1]});
  }
}

}  // namespace links_detail

/// Calls body(stretch, vertex, link) for each vertex with wanted(vertex), on several threads: those of one
/// stretch in their order on one. The link may be changed; it is empty for vertices without triangles.
/// Requires triangles whose corners are vertices of the mesh. Neither atomic counters nor lists of all edges
/// are needed where each stretch gathers its own.
template <typename Wanted, typename Body>
void forEachLink(const TriMesh& mesh, const Wanted& wanted, const Body& body) {
  using links_detail::eachCorner;
  const std::size_t vertices = mesh.positions.size();
  const int shift = std::bit_width(vertices / kLinkStretches);
  // Bit: a stretch that has corners in the block.
  std::vector<std::uint64_t> blocks((mesh.triangles.size() + links_detail::kBlock - 1) / links_detail::kBlock,
                                    0);
  parallelFor(std::size_t{0}, blocks.size(), [&](std::size_t block) {
    std::uint64_t stretches = 0;
    eachCorner(mesh, block, [&](std::uint32_t v, const LinkEdge&) {
      if (wanted(v)) stretches |= 1ull << (v >> shift);
    });
    blocks[block] = stretches;
  });
  parallelFor(std::size_t{0}, kLinkStretches, [&](std::size_t stretch) {
    const std::size_t first = std::min(vertices, stretch << shift),
                      last = std::min(vertices, (stretch + 1) << shift);
    std::vector<std::uint32_t> end(last - first, 0);
    const auto each = [&](const auto& use) {
      for (std::size_t block = 0; block < blocks.size(); ++block) {
        if ((blocks[block] >> stretch & 1) == 0) continue;
        eachCorner(mesh, block, [&](std::uint32_t v, const LinkEdge& edge) {
          if (v >> shift == stretch && wanted(v)) use(v - first, edge);
        });
      }
    };
    each([&](std::size_t i, const LinkEdge&) { ++end[i]; });
    std::uint32_t total = 0;
    for (std::uint32_t& e : end) total += std::exchange(e, total);
    const auto edges = std::make_unique_for_overwrite<LinkEdge[]>(total);
    each([&](std::size_t i, const LinkEdge& edge) { edges[end[i]++] = edge; });
    std::uint32_t begin = 0;
    for (std::size_t v = first; v < last; ++v) {
      const auto number = static_cast<std::uint32_t>(v);
      if (wanted(number))
        body(stretch, number, std::span<LinkEdge>(edges.get() + begin, edges.get() + end[v - first]));
      begin = end[v - first];
    }
  });
}

}  // namespace proveout
