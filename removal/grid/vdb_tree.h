// The samples of a stock as an OpenVDB tree, with a leaf node of our own. For people who write against
// OpenVDB, and for stock_tree.cpp; nothing else of removal sees it.
//
// Configuration (4096, 128 and 8 voxels a side) and leaf masks are those of OpenVDB's own trees, so that
// LeafManager, NodeManager, iterators, accessors and the topology operations with FloatTree and MaskTree work
// on it. A voxel is active, and its value true, where its sample is material.
//
// Index space: (i, j, k) counts (z, x, y) of the grid, so that a word of OpenVDB's leaf mask is a layer of z
// as the kernels have it (LeafBits), from a corner near the blank, so that most stocks need one node below
// the root. The transform (VdbStock::transform) says where a voxel is; it is a turn, no mirror image, and all
// steps are the grid spacing.
//
// Reading and writing files is left out: those functions of OpenVDB are all that would need its shared
// library, which costs 30 MB and 40 ms a start. A stock is saved by Stock::save; a tree that is to be written
// on its own is copied into a MaskTree first: openvdb::MaskTree(tree, false, true, openvdb::TopologyCopy()).
#pragma once

#include <openvdb/tree/InternalNode.h>
#include <openvdb/tree/LeafNodeMask.h>
#include <openvdb/tree/RootNode.h>
#include <openvdb/tree/Tree.h>

#include <type_traits>

namespace proveout {

/// The 8x8x8 samples of a leaf and the place of its crossings: transientData() is the number of its record in
/// the stock's list of leaves.
class StockLeafNode : public openvdb::tree::LeafNode<openvdb::ValueMask, 3> {
 public:
  using BaseLeaf = openvdb::tree::LeafNode<openvdb::ValueMask, 3>;
  using LeafNodeType = StockLeafNode;
  using Ptr = openvdb::SharedPtr<StockLeafNode>;
  using BaseLeaf::BaseLeaf;
  StockLeafNode() = default;

  // What a parent node asks for by the leaf's own type.
  StockLeafNode* touchLeaf(const openvdb::Coord&) { return this; }
  StockLeafNode* probeLeaf(const openvdb::Coord&) { return this; }
  const StockLeafNode* probeLeaf(const openvdb::Coord&) const { return this; }
  const StockLeafNode* probeConstLeaf(const openvdb::Coord&) const { return this; }
  template <typename Accessor>
  StockLeafNode* touchLeafAndCache(const openvdb::Coord&, Accessor&) {
    return this;
  }
  template <typename Accessor>
  StockLeafNode* probeLeafAndCache(const openvdb::Coord&, Accessor&) {
    return this;
  }
  template <typename Accessor>
  const StockLeafNode* probeLeafAndCache(const openvdb::Coord&, Accessor&) const {
    return this;
  }
  template <typename Accessor>
  const StockLeafNode* probeConstLeafAndCache(const openvdb::Coord&, Accessor&) const {
    return this;
  }
  template <typename Node, typename Accessor>
  Node* probeNodeAndCache(const openvdb::Coord&, Accessor&) {
    if constexpr (std::is_same_v<Node, StockLeafNode>) return this;
    return nullptr;
  }
  template <typename Node, typename Accessor>
  const Node* probeConstNodeAndCache(const openvdb::Coord&, Accessor&) const {
    if constexpr (std::is_same_v<Node, StockLeafNode>) return this;
    return nullptr;
  }

  // Iterators that know this type as their parent. A leaf has no children.
  template <typename MaskIter, typename Node>
  using ValueIterOf = BaseLeaf::ValueIter<MaskIter, Node, const bool>;
  using ValueOnIter = ValueIterOf<MaskOnIter, StockLeafNode>;
  using ValueOnCIter = ValueIterOf<MaskOnIter, const StockLeafNode>;
  using ValueOffIter = ValueIterOf<MaskOffIter, StockLeafNode>;
  using ValueOffCIter = ValueIterOf<MaskOffIter, const StockLeafNode>;
  using ValueAllIter = ValueIterOf<MaskDenseIter, StockLeafNode>;
  using ValueAllCIter = ValueIterOf<MaskDenseIter, const StockLeafNode>;
  using ChildOnIter = BaseLeaf::ChildIter<MaskOnIter, StockLeafNode>;
  using ChildOnCIter = BaseLeaf::ChildIter<MaskOnIter, const StockLeafNode>;
  using ChildOffIter = BaseLeaf::ChildIter<MaskOffIter, StockLeafNode>;
  using ChildOffCIter = BaseLeaf::ChildIter<MaskOffIter, const StockLeafNode>;
  using ChildAllIter = BaseLeaf::DenseIter<StockLeafNode, bool>;
  using ChildAllCIter = BaseLeaf::DenseIter<const StockLeafNode, const bool>;

  ValueOnCIter cbeginValueOn() const { return {getValueMask().beginOn(), this}; }
  ValueOnCIter beginValueOn() const { return cbeginValueOn(); }
  ValueOnIter beginValueOn() { return {getValueMask().beginOn(), this}; }
  ValueOffCIter cbeginValueOff() const { return {getValueMask().beginOff(), this}; }
  ValueOffCIter beginValueOff() const { return cbeginValueOff(); }
  ValueOffIter beginValueOff() { return {getValueMask().beginOff(), this}; }
  ValueAllCIter cbeginValueAll() const { return {getValueMask().beginDense(), this}; }
  ValueAllCIter beginValueAll() const { return cbeginValueAll(); }
  ValueAllIter beginValueAll() { return {getValueMask().beginDense(), this}; }
  ChildOnCIter cbeginChildOn() const { return {getValueMask().endOn(), this}; }
  ChildOnCIter beginChildOn() const { return cbeginChildOn(); }
  ChildOnIter beginChildOn() { return {getValueMask().endOn(), this}; }
  ChildOffCIter cbeginChildOff() const { return {getValueMask().endOff(), this}; }
  ChildOffCIter beginChildOff() const { return cbeginChildOff(); }
  ChildOffIter beginChildOff() { return {getValueMask().endOff(), this}; }
  ChildAllCIter cbeginChildAll() const { return {getValueMask().beginDense(), this}; }
  ChildAllCIter beginChildAll() const { return cbeginChildAll(); }
  ChildAllIter beginChildAll() { return {getValueMask().beginDense(), this}; }
};

using StockLowerNode = openvdb::tree::InternalNode<StockLeafNode, 4>;
using StockUpperNode = openvdb::tree::InternalNode<StockLowerNode, 5>;
using VdbTree = openvdb::tree::Tree<openvdb::tree::RootNode<StockUpperNode>>;

}  // namespace proveout

// Files are left out (see above): these throw openvdb::NotImplementedError, but for print.
namespace openvdb {
OPENVDB_USE_VERSION_NAMESPACE
namespace OPENVDB_VERSION_NAME {
namespace tree {
template <>
const Name& proveout::VdbTree::treeType();
template <>
void proveout::VdbTree::readTopology(std::istream&, bool);
template <>
void proveout::VdbTree::writeTopology(std::ostream&, bool) const;
template <>
void proveout::VdbTree::readBuffers(std::istream&, bool);
template <>
void proveout::VdbTree::readBuffers(std::istream&, const CoordBBox&, bool);
template <>
void proveout::VdbTree::readNonresidentBuffers() const;
template <>
void proveout::VdbTree::writeBuffers(std::ostream&, bool) const;
template <>
void proveout::VdbTree::print(std::ostream&, int) const;
/// Null: OpenVDB's library makes such metadata.
template <>
Metadata::Ptr proveout::VdbTree::getBackgroundValue() const;
}  // namespace tree
}  // namespace OPENVDB_VERSION_NAME
}  // namespace openvdb
