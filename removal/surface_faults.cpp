#include "removal/surface_faults.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "core/base/parallel_for.h"

namespace proveout {

namespace {

/// Vertices are looked at in this many stretches, which are bits of a word.
constexpr int kStretches = 64;
constexpr std::size_t kBlock = 2048;  ///< of triangles

/// Edge of a fan: from one neighbour of the middle to the next.
using FanEdge = std::array<std::uint32_t, 2>;

/// Whether the edges form one closed ring without repeats. May sort them.
bool isRing(FanEdge* edges, std::size_t count) {
  constexpr std::size_t kFew = 24;  // are found as fast without order
  if (count < 3) return false;
  if (count > kFew) std::sort(edges, edges + count);
  FanEdge* const end = edges + count;
  const auto following = [&](const FanEdge& edge) {
    if (count > kFew) return std::lower_bound(edges, end, FanEdge{edge[1], 0});
    return std::find_if(edges, end, [&](const FanEdge& e) { return e[0] == edge[1]; });
  };
  // Of edges with one start only the first is found: the ring that leaves none out has no repeats.
  const FanEdge* at = edges;
  for (std::size_t length = 1; length <= count; ++length) {
    const FanEdge* next = following(*at);
    if (next == end || (*next)[0] != (*at)[1]) return false;
    if (next == edges) return length == count;
    at = next;
  }
  return false;
}

/// Finds the broken fans of a stretch of vertices, in memory of its own.
class FanFinder {
 public:
  FanFinder(const TriMesh& mesh, const std::vector<std::uint32_t>& name, std::uint32_t first,
            std::uint32_t last)
      : mesh_(mesh), name_(name), first_(first), last_(last), end_(last - first + 1, 0) {}

  /// `blocks`: bit `bit` tells where triangles with corners of this stretch are.
  std::vector<std::uint32_t> find(const std::vector<std::uint64_t>& blocks, int bit) {
    const auto eachEdge = [&](const auto& body) {
      for (std::size_t block = 0; block < blocks.size(); ++block) {
        if ((blocks[block] >> bit & 1) != 0) eachEdgeOf(block, body);
      }
    };
    eachEdge([&](std::uint32_t v, const FanEdge&) { ++end_[v - first_]; });
    std::uint32_t total = 0;
    for (std::uint32_t& e : end_) total += std::exchange(e, total);
    const auto edges = std::make_unique_for_overwrite<FanEdge[]>(total);
    eachEdge([&](std::uint32_t v, const FanEdge& edge) { edges[end_[v - first_]++] = edge; });
    std::vector<std::uint32_t> broken;
    std::uint32_t begin = 0;
    for (std::uint32_t v = first_; v < last_; ++v) {
      const std::uint32_t end = end_[v - first_];
      if (name_[v] != kNoWatch) look(edges.get() + begin, end - begin, name_[v], broken);
      begin = end;
    }
    return broken;
  }

 private:
  template <typename Body>
  void eachEdgeOf(std::size_t block, const Body& body) const {
    for (std::size_t t = block * kBlock; t < std::min(mesh_.triangles.size(), (block + 1) * kBlock); ++t) {
      const auto& v = mesh_.triangles[t];
      for (int i = 0; i < 3; ++i) {
        if (v[i] < first_ || v[i] >= last_ || name_[v[i]] == kNoWatch) continue;
        body(v[i], FanEdge{v[(i + 1) % 3], v[(i + 2) % 3]});
      }
    }
  }

  void look(FanEdge* edges, std::size_t count, std::uint32_t name, std::vector<std::uint32_t>& broken) const {
    if (isRing(edges, count)) return;
    broken.push_back(name);
    std::sort(edges, edges + count);
    for (std::size_t i = 1; i < count; ++i) {
      if (edges[i][0] == edges[i - 1][0] && name_[edges[i][0]] != kNoWatch)
        broken.push_back(name_[edges[i][0]]);
    }
  }

  const TriMesh& mesh_;
  const std::vector<std::uint32_t>& name_;
  std::uint32_t first_, last_;
  std::vector<std::uint32_t> end_;  ///< of the edges of each vertex
};

}  // namespace

void findBrokenFans(const TriMesh& mesh, const std::vector<std::uint32_t>& name,
                    std::vector<std::uint32_t>& broken) {
  const auto vertices = static_cast<std::uint32_t>(name.size());
  const std::uint32_t stretch = vertices / kStretches + 1;
  // Neither atomic counters nor lists of all edges are needed where each stretch of vertices has one reader.
  std::vector<std::uint64_t> blocks((mesh.triangles.size() + kBlock - 1) / kBlock, 0);
  parallelFor(std::size_t{0}, blocks.size(), [&](std::size_t block) {
    std::uint64_t stretches = 0;
    for (std::size_t t = block * kBlock; t < std::min(mesh.triangles.size(), (block + 1) * kBlock); ++t) {
      for (const std::uint32_t v : mesh.triangles[t]) {
        if (name[v] != kNoWatch) stretches |= 1ull << (v / stretch);
      }
    }
    blocks[block] = stretches;
  });
  std::array<std::vector<std::uint32_t>, kStretches> found;
  parallelFor(0, kStretches, [&](int i) {
    const std::uint32_t first = std::min(vertices, static_cast<std::uint32_t>(i) * stretch),
                        last = std::min(vertices, first + stretch);
    if (first < last) found[static_cast<std::size_t>(i)] = FanFinder(mesh, name, first, last).find(blocks, i);
  });
  for (const auto& list : found) broken.insert(broken.end(), list.begin(), list.end());
}

}  // namespace proveout
