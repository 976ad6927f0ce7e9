#include "removal/grid/leaf_changes.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace proveout {

LeafChange readLeaf(const LeafReader& reader, const Coord& origin) {
  LeafChange change;
  change.origin = origin;
  change.material = reader.bits(origin);
  change.first_before = change.material[0] & 1;
  if (const StockLeaf* leaf = reader.leaf(origin)) change.before = reader.edges(*leaf);
  return change;
}

namespace {

/// Whether the edges inside of the leaf are crossed just where samples beside each other differ.
bool agree(const LeafBits& samples, const std::array<LeafBits, 3>& crossed) {
  for (int z = 0; z < 8; ++z) {
    const std::uint64_t m = samples[z];
    if (((m ^ m >> 8 ^ crossed[0][z]) & ~kColumnX7) != 0 || ((m ^ m >> 1 ^ crossed[1][z]) & ~kColumnY7) != 0)
      return false;
    if (z < 7 && (m ^ samples[z + 1]) != crossed[2][z]) return false;
  }
  return true;
}

/// Whether no leaf is changed twice.
bool differ(std::span<const LeafChange* const> changes) {
  std::vector<Coord> places;
  for (const LeafChange* change : changes) places.push_back(change->origin);
  std::sort(places.begin(), places.end());
  return std::adjacent_find(places.begin(), places.end()) == places.end();
}

}  // namespace

LeafBits samplesBefore(const LeafChange& change) {
  const std::array<LeafBits, 3>& crossed = change.before.crossed;
  // A sample is on the other side than the one before it where the edge between them is crossed.
  std::uint64_t row = change.first_before, layer = 0;
  for (int y = 0; y < 7; ++y) row |= ((row ^ crossed[1][0]) >> y & 1) << (y + 1);
  for (int x = 0; x < 8; ++x) {
    layer |= row << 8 * x;
    row ^= crossed[0][0] >> 8 * x & 0xFF;
  }
  LeafBits out;
  for (int z = 0; z < 8; ++z) {
    out[z] = layer;
    layer ^= crossed[2][z];
  }
  PROVEOUT_ASSERT_DEAR(agree(out, crossed));
  return out;
}

namespace {

constexpr std::uint32_t kNoRecord = 0xFFFFFFFFu;

/// Whether all samples of a leaf are as before.
bool keepsSamples(const LeafChange& change) {
  const bool first = (change.material[0] & 1) != 0;
  return first == change.first_before && samplesBefore(change) == change.material;
}

std::uint32_t addRecord(Stock::Impl& impl, const LeafChange& change) {
  const auto number = static_cast<std::uint32_t>(impl.leaves.size());
  *addLeaf(impl, change.origin).samples = change.material;
  return number;
}

/// Records of the changed leaves that have one or whose 9x9x9 block may hold both sides: those that are all
/// one side, like most that are cut, only where a neighbour differs.
std::vector<std::uint32_t> installChanges(Stock::Impl& impl, std::span<const LeafChange* const> changes) {
  std::vector<std::uint32_t> record(changes.size(), kNoRecord);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const LeafChange& change = *changes[i];
    const Coord at = leafCoord(change.origin);
    const bool inside = change.material == kAllInside;
    if (const std::int32_t number = impl.tree.get(at); number >= 0) {
      record[i] = static_cast<std::uint32_t>(number);
    } else if (inside || change.material == kAllOutside) {
      impl.tree.setUniform(at, inside);
    } else {
      record[i] = addRecord(impl, change);
    }
  }
  std::vector<std::uint8_t> beside(changes.size(), 0);
  parallelFor(std::size_t{0}, changes.size(), [&](std::size_t i) {
    if (record[i] != kNoRecord) *impl.leaves[record[i]].samples = changes[i]->material;
  });
  parallelFor(std::size_t{0}, changes.size(), [&](std::size_t i) {
    beside[i] = record[i] == kNoRecord && isMixed(LeafReader(impl), changes[i]->origin);
  });
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (beside[i] != 0) record[i] = addRecord(impl, *changes[i]);
  }
  return record;
}

}  // namespace

// Every changed leaf is installed before neighbours read each other's new samples.
LeafCommit::LeafCommit(Stock::Impl& impl, std::span<const LeafChange* const> changes)
    : impl_(impl), changes_(changes) {
  PROVEOUT_ASSERT_DEAR(differ(changes));
  record_ = installChanges(impl, changes);
}

LeafEdges LeafCommit::edges(std::size_t i) const {
  if (record_[i] == kNoRecord) return {};
  const LeafReader reader(impl_);
  return isMixed(reader, changes_[i]->origin) ? reader.edges(impl_.leaves[record_[i]]) : LeafEdges{};
}

const std::vector<Crossing>& LeafCommit::before(std::size_t i) const {
  static const std::vector<Crossing> none;
  return record_[i] == kNoRecord ? none : impl_.leaves[record_[i]].crossings;
}

void LeafCommit::set(std::size_t i, const LeafEdges& edges, std::vector<Crossing> found) {
  PROVEOUT_ASSERT(found.size() == edges.count || found.empty());  // when cancelled
  const bool known = changed();                                   // one change is enough
  if (!known && !keepsSamples(*changes_[i])) changed_.store(true, std::memory_order_relaxed);
  if (record_[i] == kNoRecord) return;
  StockLeaf& leaf = impl_.leaves[record_[i]];
  if (!known && leaf.crossings != found) changed_.store(true, std::memory_order_relaxed);
  leaf.crossings = std::move(found);
  if (edges.count == 0 && !isMixed(LeafReader(impl_), leaf.origin)) leaf.origin = kNoLeaf;
}

void LeafCommit::finish() {
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    if (record_[i] == kNoRecord || impl_.leaves[record_[i]].origin != kNoLeaf) continue;
    impl_.tree.setUniform(leafCoord(changes_[i]->origin), (changes_[i]->material[0] & 1) != 0);
  }
  orderLeaves(impl_);
}

void commitChanges(Stock::Impl& impl, std::span<const LeafChange* const> changes, const FindCrossings& find) {
  LeafCommit commit(impl, changes);
  parallelFor(std::size_t{0}, changes.size(), [&](std::size_t i) {
    const LeafEdges edges = commit.edges(i);
    commit.set(i, edges, find(i, edges, commit.before(i)));
  });
  commit.finish();
}

}  // namespace proveout
