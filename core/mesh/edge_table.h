// Edges of a triangle mesh, gathered in linear time: half-edges are put into buckets by their smaller
// vertex and sorted inside the bucket. Same input, same order, on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// True where all three indices are below `vertices` and differ.
inline bool triangleIsProper(const TriangleIndices& t, std::size_t vertices) {
  return t[0] < vertices && t[1] < vertices && t[2] < vertices && t[0] != t[1] && t[1] != t[2] &&
         t[2] != t[0];
}

/// One directed edge of a triangle: corner `half_edge % 3` of triangle `half_edge / 3` and the corner after
/// it.
struct HalfEdge {
  std::uint32_t other;      ///< the larger vertex of the edge
  std::uint32_t half_edge;  ///< 3 * triangle + corner
};

/// Half-edges of the proper triangles. Improper ones (see triangleIsProper) have no edges.
class EdgeTable {
 public:
  EdgeTable(std::size_t vertices, const std::vector<TriangleIndices>& triangles);

  /// Calls `visit(low, first, last)` for every undirected edge: `low` is its smaller vertex, [first, last)
  /// its half-edges in order of triangle.
  template <typename Visit>
  void forEachEdge(Visit visit) const {
    for (std::size_t low = 0; low + 1 < start_.size(); ++low) {
      const HalfEdge* first = entries_.data() + start_[low];
      const HalfEdge* const end = entries_.data() + start_[low + 1];
      while (first != end) {
        const HalfEdge* last = first + 1;
        while (last != end && last->other == first->other) ++last;
        visit(static_cast<std::uint32_t>(low), first, last);
        first = last;
      }
    }
  }

 private:
  std::vector<std::uint32_t> start_;  ///< per vertex, into entries_
  std::vector<HalfEdge> entries_;
};

/// Disjoint sets whose representative is always their smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size);
  /// How many sets have more than one member.
  std::size_t setsOfSeveral() const;
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace proveout
