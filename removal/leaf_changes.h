// New samples for leaves of the stock: installed first, then every changed leaf gets the crossings of its new
// edges, which reach into its neighbours.
#pragma once

#include <functional>
#include <vector>

#include "core/base/parallel_for.h"
#include "removal/stock_impl.h"

namespace proveout {

struct LeafChange {
  openvdb::Coord origin;
  LeafBits material{};              ///< new samples
  LeafEdges before;                 ///< crossed edges until now
};

/// Reads what a leaf is now: a change with equal samples.
LeafChange readLeaf(const LeafReader& reader, const openvdb::Coord& origin);

/// Writes the changes into the stock. `changes` must hold, once, every leaf of whose 9x9x9 block a sample changes.
/// `find(i, edges, before)` is called in parallel for every changed leaf that is mixed and returns the crossings
/// of `edges` in order; `before` are the crossings of changes[i].before. The result does not depend on the order
/// of `changes`.
using FindCrossings = std::function<std::vector<Crossing>(std::size_t i, const LeafEdges& edges,
                                                          const std::vector<Crossing>& before)>;
void commitChanges(Stock::Impl& impl, std::vector<LeafChange>& changes, const FindCrossings& find);

}  // namespace proveout
