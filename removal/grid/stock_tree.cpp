#include "removal/grid/stock_tree.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/base/assert.h"
#include "removal/grid/stock_nodes.h"

namespace proveout {

namespace {

constexpr int kBlockLeaves = 16;
static_assert(StockLowerNode::DIM == 8 * kBlockLeaves);

/// A node's mask as the kernels see it: OpenVDB's word i is a layer of z, bit 8 * j + k is leafBit(x, y).
/// Both are eight words and nothing else.
LeafBits* samplesOf(StockLeafNode& node) {
  using Mask = StockLeafNode::NodeMaskType;
  static_assert(sizeof(Mask) == sizeof(LeafBits) && std::is_same_v<Mask::Word, LeafBits::value_type>);
  return reinterpret_cast<LeafBits*>(&const_cast<Mask&>(node.getValueMask()));
}

std::size_t numberOfBlock(const StockTree::Nodes& nodes, int x, int y, int z) {
  return (static_cast<std::size_t>(x) * static_cast<std::size_t>(nodes.block_count[1]) +
          static_cast<std::size_t>(y)) *
             static_cast<std::size_t>(nodes.block_count[2]) +
         static_cast<std::size_t>(z);
}

bool inRoom(const StockTree::Nodes& nodes, int x, int y, int z) {
  return x >= 0 && y >= 0 && z >= 0 && x < nodes.size[0] && y < nodes.size[1] && z < nodes.size[2];
}

/// The block of a leaf and the leaf's place in it.
struct Place {
  const StockTree::Nodes::Block* block;
  openvdb::Index offset;
};

[[gnu::always_inline]] inline Place placeOf(const StockTree::Nodes& nodes, const Coord& leaf) {
  const int x = leaf.x() - nodes.low.x(), y = leaf.y() - nodes.low.y(), z = leaf.z() - nodes.low.z();
  if (!inRoom(nodes, x, y, z)) return {nullptr, 0};
  const auto offset = static_cast<openvdb::Index>((z & 15) << 8 | (x & 15) << 4 | (y & 15));
  return {&nodes.blocks[numberOfBlock(nodes, x >> 4, y >> 4, z >> 4)], offset};
}

/// The node of a leaf; null for tiles, of which `inside` tells the side.
[[gnu::always_inline]] inline StockLeafNode* nodeAt(const Place& place, bool& inside) {
  inside = false;
  if (place.block == nullptr) return nullptr;
  const StockLowerNode* lower = place.block->node;
  inside = place.block->inside;
  if (lower == nullptr) return nullptr;
  if (lower->isChildMaskOn(place.offset)) return lower->getTable()[place.offset].getChild();
  inside = lower->isValueMaskOn(place.offset);
  return nullptr;
}

[[gnu::always_inline]] inline std::int32_t stateAt(const Place& place) {
  bool inside;
  const StockLeafNode* node = nodeAt(place, inside);
  if (node != nullptr) return static_cast<std::int32_t>(node->transientData());
  return inside ? StockTree::kInside : StockTree::kOutside;
}

[[gnu::always_inline]] inline const LeafBits& bitsAt(const Place& place) {
  bool inside;
  StockLeafNode* node = nodeAt(place, inside);
  if (node != nullptr) return *samplesOf(*node);
  return inside ? kAllInside : kAllOutside;
}

/// Calls body(i, place) for a leaf and its seven neighbours. Most of them are in one block, where places are
/// offsets.
template <typename Body>
void eachBeside(const StockTree::Nodes& nodes, const Coord& leaf, int step, Body&& body) {
  const Place own = placeOf(nodes, leaf);
  const auto offset = static_cast<int>(own.offset);
  const int last = step > 0 ? 15 : 0;
  const bool one_block = own.block != nullptr && (offset >> 8) != last && (offset >> 4 & 15) != last &&
                         (offset & 15) != last &&
                         inRoom(nodes, leaf.x() - nodes.low.x() + step, leaf.y() - nodes.low.y() + step,
                                leaf.z() - nodes.low.z() + step);
  for (int i = 0; i < 8; ++i) {
    const int x = i & 1, y = i >> 1 & 1, z = i >> 2;
    if (one_block) {
      body(i, Place{own.block, static_cast<openvdb::Index>(offset + step * (z << 8 | x << 4 | y))});
    } else {
      body(i, placeOf(nodes, leaf.offsetBy(step * x, step * y, step * z)));
    }
  }
}

/// Looks the block up again, behind changes that may have made or dropped its node.
void refresh(StockTree::Nodes& nodes, int x, int y, int z) {
  const openvdb::Coord at(8 * kBlockLeaves * z, 8 * kBlockLeaves * x, 8 * kBlockLeaves * y);
  StockTree::Nodes::Block& block = nodes.blocks[numberOfBlock(nodes, x, y, z)];
  block.node = nodes.tree.root().probeNode<StockLowerNode>(at);
  block.inside = block.node == nullptr && nodes.tree.isValueOn(at);
}

void refreshBlockOf(StockTree::Nodes& nodes, const Coord& leaf) {
  refresh(nodes, (leaf.x() - nodes.low.x()) >> 4, (leaf.y() - nodes.low.y()) >> 4,
          (leaf.z() - nodes.low.z()) >> 4);
}

}  // namespace

StockTree::StockTree() : nodes_(std::make_unique<Nodes>()) {}
StockTree::~StockTree() {
  if (nodes_ != nullptr) nodes_->tree.clear();  // frees its leaves on all threads
}
StockTree::StockTree(StockTree&&) noexcept = default;
StockTree& StockTree::operator=(StockTree&&) noexcept = default;

void StockTree::reset(const Coord& low, const Coord& high) {
  Nodes& n = *nodes_;
  n.tree.clear();
  n.low = low;
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    n.size[a] = high[axis] - low[axis] + 1;
    n.block_count[a] = (n.size[a] - 1) / kBlockLeaves + 1;
    count *= static_cast<std::size_t>(n.block_count[a]);
  }
  n.blocks.assign(count, {});
}

double StockTree::bytesFor(const Coord& low, const Coord& high) {
  double count = 1.0;
  for (int axis = 0; axis < 3; ++axis) count *= (high[axis] - low[axis]) / double{kBlockLeaves} + 1.0;
  return count * sizeof(Nodes::Block);
}

bool StockTree::holds(const Coord& leaf) const { return placeOf(*nodes_, leaf).block != nullptr; }

std::int32_t StockTree::get(const Coord& leaf) const { return stateAt(placeOf(*nodes_, leaf)); }

const LeafBits& StockTree::bits(const Coord& leaf) const { return bitsAt(placeOf(*nodes_, leaf)); }

std::array<std::int32_t, 8> StockTree::getBeside(const Coord& leaf, int step) const {
  std::array<std::int32_t, 8> out;
  eachBeside(*nodes_, leaf, step,
             [&](int i, const Place& place) { out[static_cast<std::size_t>(i)] = stateAt(place); });
  return out;
}

std::array<const LeafBits*, 8> StockTree::bitsBeside(const Coord& leaf) const {
  std::array<const LeafBits*, 8> out;
  eachBeside(*nodes_, leaf, 1,
             [&](int i, const Place& place) { out[static_cast<std::size_t>(i)] = &bitsAt(place); });
  return out;
}

LeafBits* StockTree::number(const Coord& leaf, std::int32_t number) {
  Nodes& n = *nodes_;
  const Place place = placeOf(n, leaf);
  PROVEOUT_ASSERT(place.block != nullptr && number >= 0);
  bool inside;
  StockLeafNode* node = nodeAt(place, inside);
  if (node == nullptr) {
    node = new StockLeafNode(n.indexOf(leaf), false, false);
    if (place.block->node != nullptr) {
      place.block->node->addLeaf(node);
    } else {
      n.tree.addLeaf(node);
      refreshBlockOf(n, leaf);
    }
  }
  node->setTransientData(static_cast<openvdb::Index32>(number));
  return samplesOf(*node);
}

void StockTree::setUniform(const Coord& leaf, bool inside) {
  Nodes& n = *nodes_;
  const Place place = placeOf(n, leaf);
  PROVEOUT_ASSERT(place.block != nullptr);
  if (place.block->node == nullptr && place.block->inside == inside) return;
  if (place.block->node != nullptr) {
    place.block->node->addTile(place.offset, inside, inside);
  } else {
    n.tree.addTile(1, n.indexOf(leaf), inside, inside);
    refreshBlockOf(n, leaf);
  }
}

void StockTree::fillInside(const Coord& low, const Coord& high) {
  Nodes& n = *nodes_;
  Coord first, last;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = std::max(low[axis], n.low[axis]);
    last[axis] = std::min(high[axis], n.low[axis] + n.size[static_cast<std::size_t>(axis)] - 1);
    if (first[axis] > last[axis]) return;
  }
  n.tree.sparseFill(openvdb::CoordBBox(n.indexOf(first), n.indexOf(last).offsetBy(7)), true, true);
  const Coord a = first.offsetBy(-n.low.x(), -n.low.y(), -n.low.z()),
              b = last.offsetBy(-n.low.x(), -n.low.y(), -n.low.z());
  for (int x = a.x() >> 4; x <= b.x() >> 4; ++x) {
    for (int y = a.y() >> 4; y <= b.y() >> 4; ++y) {
      for (int z = a.z() >> 4; z <= b.z() >> 4; ++z) refresh(n, x, y, z);
    }
  }
}

void StockTree::forEachInside(const std::function<void(const Coord&, const Coord&)>& body) const {
  const Nodes& n = *nodes_;
  for (int x = 0; x < n.block_count[0]; ++x) {
    for (int y = 0; y < n.block_count[1]; ++y) {
      for (int z = 0; z < n.block_count[2]; ++z) {
        const Nodes::Block& block = n.blocks[numberOfBlock(n, x, y, z)];
        const Coord first = n.low.offsetBy(kBlockLeaves * x, kBlockLeaves * y, kBlockLeaves * z);
        if (block.node == nullptr) {
          if (block.inside) body(first, first.offsetBy(kBlockLeaves - 1));
          continue;
        }
        for (auto tile = block.node->cbeginValueOn(); tile; ++tile) {
          const Coord leaf = n.leafAt(tile.getCoord());
          body(leaf, leaf);
        }
      }
    }
  }
}

}  // namespace proveout

// What would need OpenVDB's library, see vdb_tree.h.
namespace openvdb {
OPENVDB_USE_VERSION_NAMESPACE
namespace OPENVDB_VERSION_NAME {
namespace tree {

namespace {
[[noreturn]] void noFiles() {
  OPENVDB_THROW(NotImplementedError,
                "a tree of a proveout stock has no files: save the stock, or copy its topology");
}
}  // namespace

template <>
const Name& proveout::VdbTree::treeType() {
  static const Name kName("Tree_proveout_5_4_3");
  return kName;
}
template <>
void proveout::VdbTree::readTopology(std::istream&, bool) {
  noFiles();
}
template <>
void proveout::VdbTree::writeTopology(std::ostream&, bool) const {
  noFiles();
}
template <>
void proveout::VdbTree::readBuffers(std::istream&, bool) {
  noFiles();
}
template <>
void proveout::VdbTree::readBuffers(std::istream&, const CoordBBox&, bool) {
  noFiles();
}
template <>
void proveout::VdbTree::readNonresidentBuffers() const {}
template <>
void proveout::VdbTree::writeBuffers(std::ostream&, bool) const {
  noFiles();
}
template <>
void proveout::VdbTree::print(std::ostream& out, int) const {
  out << treeType() << ": " << leafCount() << " leaves, " << activeVoxelCount() << " voxels of material\n";
}
template <>
Metadata::Ptr proveout::VdbTree::getBackgroundValue() const {
  return nullptr;
}

}  // namespace tree
}  // namespace OPENVDB_VERSION_NAME
}  // namespace openvdb
