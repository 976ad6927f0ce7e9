// Edges of the part that booleans leave: the same however its faces are cut into facets. All mm.
#pragma once

#include <array>
#include <vector>

#include "tests/reference/reference_part.h"

namespace proveout::reference {

struct ReferenceEdge {
  std::array<Vec3, 2> ends;
  Vec3 normal;  ///< unit, mean of its faces'
};

/// Where faces meet at `least_deg` or more: pieces of one straight line between the same two faces are one.
std::vector<ReferenceEdge> edgesOf(const std::vector<ReferencePart::Facet>& facets, double least_deg);

/// Pieces of edges, none longer than a third of `within`: those that are farther than it from others, and the
/// rest. Pieces of one curve do not count as others: they turn no more than a circle of 1.5 mm does.
struct SortedEdges {
  std::vector<ReferenceEdge> alone, crowded;
};
SortedEdges sortEdges(const std::vector<ReferenceEdge>& edges, double within);

std::vector<std::array<Vec3, 2>> segmentsOf(const std::vector<ReferenceEdge>& edges);

}  // namespace proveout::reference
