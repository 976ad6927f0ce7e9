// New samples for leaves of the stock: installed first, then every changed leaf gets the crossings of its new
// edges, which reach into its neighbours.
#pragma once

#include <tbb/concurrent_vector.h>

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/parallel_for.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

inline constexpr std::uint32_t kNoPass = 0xFFFFFFFFu;

struct LeafChange {
  Coord origin;
  LeafBits material{};        ///< new samples
  LeafEdges before;           ///< crossed edges until now
  bool first_before = false;  ///< the first sample until now
  /// The pass that took most and the last that took something; kNoPass where none did.
  std::array<std::uint32_t, 2> takers{kNoPass, kNoPass};
};

/// Reads what a leaf is now: a change with equal samples.
LeafChange readLeaf(const LeafReader& reader, const Coord& origin);

/// Samples until now.
LeafBits samplesBefore(const LeafChange& change);

/// Writes the changes into the stock. `changes` must hold, once, every leaf of whose 9x9x9 block a sample
/// changes. `find(i, edges, before)` is called in parallel for every changed leaf and returns the crossings
/// of `edges` in order (none for a leaf that is not mixed any more); `before` are the crossings of
/// changes[i]->before. The result does not depend on the order of `changes`.
using FindCrossings = std::function<std::vector<Crossing>(std::size_t i, const LeafEdges& edges,
                                                          const std::vector<Crossing>& before)>;
void commitChanges(Stock::Impl& impl, std::span<const LeafChange* const> changes, const FindCrossings& find);

/// The same in steps, for who gives the crossings leaf by leaf in an order of its own. The samples are in the
/// stock from the start; in between only edges(), before() and set() are called, by any threads.
class LeafCommit {
 public:
  /// `changes` as above; must outlive it.
  LeafCommit(Stock::Impl& impl, std::span<const LeafChange* const> changes);
  /// The crossed edges of a changed leaf now.
  LeafEdges edges(std::size_t i) const;
  /// The crossings until now.
  const std::vector<Crossing>& before(std::size_t i) const;
  /// Once for every changed leaf: the crossings of `edges`, which are its edges now.
  void set(std::size_t i, const LeafEdges& edges, std::vector<Crossing> found);
  void finish();
  /// Whether a sample or a crossing is another one than before.
  bool changed() const { return changed_.load(std::memory_order_relaxed); }

 private:
  Stock::Impl& impl_;
  std::span<const LeafChange* const> changes_;
  std::vector<std::uint32_t> record_;  ///< of each change
  std::atomic<bool> changed_{false};
};

/// All threads add to it. Its memory is the program's, in huge pages (docs/decisions/008), and not TBB's own.
template <typename T>
using ConcurrentList = tbb::concurrent_vector<T, std::allocator<T>>;

/// Where the elements of a list stand, for commitChanges.
template <typename List>
std::vector<const LeafChange*> addressesOf(const List& changes) {
  std::vector<const LeafChange*> out;
  out.reserve(changes.size());
  for (const LeafChange& change : changes) out.push_back(&change);
  return out;
}

}  // namespace proveout
