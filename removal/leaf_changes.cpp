#include "removal/leaf_changes.h"

#include <utility>

namespace proveout {

using openvdb::Coord;

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
  auto write = impl.index->getAccessor();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Coord at = leafCoord(changes[i].origin);
    std::int32_t number = write.getValue(at);
    if (number < 0) {
      number = static_cast<std::int32_t>(impl.leaves.size());
      impl.leaves.push_back({changes[i].origin, {}, {}});
      write.setValue(at, number);
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
    if (!mixed[i]) return;
    StockLeaf& leaf = impl.leaves[record[i]];
    leaf.crossings = find(i, reader.edges(leaf), before[i]);
    before[i] = {};
  });
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (mixed[i]) continue;
    const bool inside = changes[i].material[0] & 1;
    write.setValue(leafCoord(changes[i].origin), inside ? Stock::Impl::kInside : Stock::Impl::kOutside);
    impl.leaves[record[i]].origin = Coord::max();
  }
  std::erase_if(impl.leaves, [](const StockLeaf& leaf) { return leaf.origin == Coord::max(); });
  renumberLeaves(impl);
}

}  // namespace proveout
