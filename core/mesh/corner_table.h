// A closed 2-manifold triangle mesh as half-edges in flat lists: for many collapses of edges, on several
// threads.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace proveout {

/// Half-edge 3 t + i goes from corner i of triangle t to the next corner. Takes no memory while it changes.
/// Threads may collapse edges at once where the triangles around each end of each edge have no vertex in
/// common with those of another thread.
class CornerTable {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  /// Requires triangles that are closed, 2-manifold and oriented, with corners below `vertices`.
  CornerTable(Triangles triangles, std::size_t vertices);

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::uint32_t from(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
  std::uint32_t to(std::uint32_t h) const { return from(next(h)); }
  /// A half-edge out of a vertex; kNone: it has no triangles.
  std::uint32_t outOf(std::uint32_t v) const { return out_[v]; }
  bool gone(std::uint32_t v) const { return out_[v] == kNone; }
  /// The next half-edge out of the same vertex, counterclockwise seen from outside.
  std::uint32_t turned(std::uint32_t h) const { return twin_[previous(h)]; }
  /// Whether a vertex has three triangles.
  bool hasThree(std::uint32_t v) const {
    const std::uint32_t first = out_[v];
    return turned(turned(turned(first))) == first;
  }

  /// Joins from(h) with to(h), which keeps its place; the two triangles at h are gone, their first corner is
  /// kNone. Requires that no vertices but those opposite of h are neighbours of both ends, and that those two
  /// have more than three triangles.
  void collapse(std::uint32_t h);

  std::size_t vertexCount() const { return out_.size(); }
  const Triangles& triangles() const { return triangles_; }

 private:
  void pair(std::uint32_t g, std::uint32_t h) {
    twin_[g] = h;
    twin_[h] = g;
  }

  Triangles triangles_;
  std::vector<std::uint32_t> twin_;  ///< a half-edge: the same edge in the other triangle
  std::vector<std::uint32_t> out_;   ///< a vertex
};

}  // namespace proveout
