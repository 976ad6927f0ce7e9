// A closed 2-manifold triangle mesh as half-edges in flat lists: for many collapses of edges, on several
// threads.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace proveout {

/// Half-edge 8 t + i goes from corner i of triangle t to the next corner. Takes no memory while it changes.
/// Threads may collapse edges at once where the triangles around each end of each edge have no vertex in
/// common with those of another thread.
class CornerTable {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  /// Requires triangles that are closed, 2-manifold and oriented, with corners below `vertices`, fewer than
  /// 2^29. `labels`: a number for each triangle, kept for whoever uses the table; empty: all have 0.
  CornerTable(const Triangles& triangles, const std::vector<std::uint32_t>& labels, std::size_t vertices);

  static std::uint32_t triangleOf(std::uint32_t h) { return h >> 3; }
  static std::uint32_t halfEdge(std::size_t t, std::uint32_t i) {
    return static_cast<std::uint32_t>(8 * t) + i;
  }
  static std::uint32_t next(std::uint32_t h) { return (h & 7) == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return (h & 7) == 0 ? h + 2 : h - 1; }
  std::uint32_t from(std::uint32_t h) const { return to(previous(h)); }
  std::uint32_t to(std::uint32_t h) const { return numbers()[h]; }
  std::uint32_t labelAt(std::uint32_t h) const { return triangles_[triangleOf(h)].label; }
  /// A half-edge out of a vertex; kNone: it has no triangles.
  std::uint32_t outOf(std::uint32_t v) const { return out_[v]; }
  bool gone(std::uint32_t v) const { return out_[v] == kNone; }
  /// The same edge in the other triangle.
  std::uint32_t twin(std::uint32_t h) const { return turned(next(h)); }
  /// The next half-edge out of the same vertex, counterclockwise seen from outside.
  std::uint32_t turned(std::uint32_t h) const { return numbers()[h + 4]; }
  /// Whether a vertex has three triangles.
  bool hasThree(std::uint32_t v) const {
    const std::uint32_t first = out_[v];
    return turned(turned(turned(first))) == first;
  }

  /// Joins from(h) with to(h), which keeps its place; the two triangles at h are gone. Requires that no
  /// vertices but those opposite of h are neighbours of both ends, and that those two have more than three
  /// triangles.
  void collapse(std::uint32_t h);

  std::size_t triangleCount() const { return count_; }
  bool isGone(std::size_t t) const { return triangles_[t].to[0] == kNone; }
  std::array<std::uint32_t, 3> corners(std::size_t t) const {
    const std::array<std::uint32_t, 3>& to = triangles_[t].to;
    return {to[2], to[0], to[1]};
  }

 private:
  /// What belongs together in half a line of the cache. Half-edges are places in it, so that a walk around a
  /// vertex, which waits for each step, is one read a step.
  struct alignas(32) Triangle {
    std::array<std::uint32_t, 3> to;  ///< ends of its half-edges
    std::uint32_t label;
    std::array<std::uint32_t, 3> turned;  ///< from its half-edges
    std::uint32_t unused;
  };
  static_assert(sizeof(Triangle) == 8 * sizeof(std::uint32_t));

  void pairDiagonal(std::uint32_t t);
  void pairEdges(std::uint32_t first, std::uint32_t last, std::size_t begin, std::size_t end,
                 std::uint32_t* waiting);
  const std::uint32_t* numbers() const { return triangles_[0].to.data(); }
  std::uint32_t& numberAt(std::uint32_t h) { return triangles_[0].to.data()[h]; }
  std::uint32_t& twinAt(std::uint32_t h) { return numberAt(next(h) + 4); }
  void pair(std::uint32_t g, std::uint32_t h) {
    twinAt(g) = h;
    twinAt(h) = g;
  }

  // Not vectors, as these would be filled by one thread before all fill them.
  std::size_t count_;
  std::unique_ptr<Triangle[]> triangles_;
  std::unique_ptr<std::uint32_t[]> out_;  ///< a vertex
};

}  // namespace proveout
