// A tree of axis-aligned boxes, for whoever looks for what is near.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// A box with corners in single precision, mm: half the memory where there are very many.
struct ShortBox {
  Eigen::Vector3f min, max;
  /// Rounded outwards where single precision does not hold the corners.
  static ShortBox around(const Box3& box);
};

/// Binary; leaves hold up to four boxes. Halved where the sum of "surface of the bounds times count" is
/// least. Does not depend on the number of threads but for the numbers of its nodes.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box3>& boxes);
  explicit BoxTree(const std::vector<ShortBox>& boxes);

  /// Two children: their bounds, rounded outwards, and what they are.
  struct Node {
    float low[2][3], high[2][3];
    std::uint32_t child[2];

    /// From a point to a child's bounds, squared, mm2; a lower bound.
    double distance2(int side, const Vec3& p) const {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double below = static_cast<double>(low[side][k]) - p[k], above = p[k] - high[side][k];
        const double gap = below > above ? below : above;
        if (gap > 0.0) sum += gap * gap;
      }
      return sum;
    }
    bool overlaps(int side, const Box3& box) const {
      bool apart = false;
      for (int k = 0; k < 3; ++k) apart = apart || low[side][k] > box.max[k] || high[side][k] < box.min[k];
      return !apart;
    }
  };

  // A child is the number of a node, or a leaf: a stretch of order().
  static constexpr std::uint32_t kEmptyLeaf = 0x80000000u;
  static bool isLeaf(std::uint32_t child) { return (child & kEmptyLeaf) != 0; }
  static std::uint32_t leafBegin(std::uint32_t child) { return (child & ~kEmptyLeaf) >> kCountBits; }
  static std::uint32_t leafEnd(std::uint32_t child) {
    return leafBegin(child) + (child & ((1u << kCountBits) - 1));
  }
  /// Of walks that push one child a level, or both.
  static constexpr int kStack = 128;

  std::uint32_t root() const { return root_; }
  /// Children have higher numbers than their parent.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// The numbers of the boxes as the leaves hold them.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Calls visit(place) for each place in order() whose leaf touches the box.
  template <typename Visit>
  void forEachPlace(const Box3& box, const Visit& visit) const {
    forEachPlaceWhere([&box](const Node& node, int side) { return node.overlaps(side, box); }, visit);
  }

  /// The same below children for which reaches(node, side) is true, as it has to be for theirs.
  template <typename Reaches, typename Visit>
  void forEachPlaceWhere(const Reaches& reaches, const Visit& visit) const {
    std::array<std::uint32_t, kStack> stack;
    int size = 0;
    stack[size++] = root_;
    while (size > 0) {
      const std::uint32_t at = stack[--size];
      if (isLeaf(at)) {
        for (std::uint32_t i = leafBegin(at); i < leafEnd(at); ++i) visit(i);
        continue;
      }
      const Node& node = nodes_[at];
      for (int side = 0; side < 2; ++side) {
        if (reaches(node, side)) stack[size++] = node.child[side];
      }
    }
  }

 private:
  template <typename Box>
  class Builder;
  static constexpr std::uint32_t kCountBits = 3;

  std::vector<Node> nodes_;  ///< the root first; none for a tree of one leaf
  std::vector<std::uint32_t> order_;
  std::uint32_t root_ = kEmptyLeaf;
};

}  // namespace proveout
