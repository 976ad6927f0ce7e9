#include "removal/leaf_changes.h"

#include <utility>

namespace proveout {

namespace {

constexpr Coord kDropped(1 << 30, 1 << 30, 1 << 30);  ///< no leaf of any stock

}  // namespace

LeafChange readLeaf(const LeafReader& reader, const Coord& origin) {
  LeafChange change;
  change.origin = origin;
  change.material = reader.bits(origin);
  if (const StockLeaf* leaf = reader.leaf(origin)) change.before = reader.edges(*leaf);
  return change;
}

void commitChanges(Stock::Impl& impl, std::vector<LeafChange>& changes, const FindCrossings& find) {
  // Every changed leaf has a record while neighbours read each other's new samples.
  std::vector<std::vector<Crossing>> before(changes.size());
  std::vector<std::uint32_t> record(changes.size());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Coord at = leafCoord(changes[i].origin);
    std::int32_t number = impl.index.get(at);
    if (number < 0) {
      number = static_cast<std::int32_t>(impl.leaves.size());
      impl.leaves.push_back({changes[i].origin, {}, {}});
      impl.index.set(at, number);
    }
    record[i] = static_cast<std::uint32_t>(number);
    StockLeaf& leaf = impl.leaves[record[i]];
    leaf.material = changes[i].material;
    before[i] = std::exchange(leaf.crossings, {});
  }
  std::vector<char> mixed(changes.size());
  parallelFor(std::size_t{0}, changes.size(), [&](std::size_t i) {
    const LeafReader reader(impl);
    mixed[i] = isMixed(reader, changes[i].origin);
    StockLeaf& leaf = impl.leaves[record[i]];
    leaf.crossings = find(i, mixed[i] ? reader.edges(leaf) : LeafEdges{}, before[i]);
    before[i] = {};
  });
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (mixed[i]) continue;
    const bool inside = changes[i].material[0] & 1;
    impl.index.set(leafCoord(changes[i].origin), inside ? LeafIndex::kInside : LeafIndex::kOutside);
    impl.leaves[record[i]].origin = kDropped;
  }
  std::erase_if(impl.leaves, [](const StockLeaf& leaf) { return leaf.origin == kDropped; });
  renumberLeaves(impl);
}

}  // namespace proveout
