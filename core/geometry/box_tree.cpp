#include "core/geometry/box_tree.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"

namespace proveout {

namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr int kBins = 16;
/// Subtrees with fewer boxes are built on one thread.
constexpr std::uint32_t kParallelSize = 8192;
/// Deeper than this, sets are halved by number, so that stacks of a fixed size do.
constexpr int kMaxDepth = 48;

float below(double v) { return std::nextafter(toFloat(v), -std::numeric_limits<float>::infinity()); }
float above(double v) { return std::nextafter(toFloat(v), std::numeric_limits<float>::infinity()); }

double halfSurface(const Box3& box) {
  const Vec3 s = box.size();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

}  // namespace

template <typename Box>
class BoxTree::Builder {
 public:
  Builder(BoxTree& tree, const std::vector<Box>& boxes)
      : tree_(tree), boxes_(boxes), nodes_(std::make_unique_for_overwrite<Node[]>(boxes.size())) {}

  void run() {
    tree_.order_.resize(boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i) tree_.order_[i] = static_cast<std::uint32_t>(i);
    Box3 bounds;
    tree_.root_ = build(0, static_cast<std::uint32_t>(boxes_.size()), 0, bounds);
    PROVEOUT_ASSERT(used_ <= boxes_.size());
    tree_.nodes_.assign(nodes_.get(), nodes_.get() + used_);
  }

 private:
  std::uint32_t build(std::uint32_t first, std::uint32_t last, int depth, Box3& bounds) {
    if (last - first <= kLeafSize) {
      for (std::uint32_t i = first; i < last; ++i) bounds.extend(boxAt(tree_.order_[i]));
      return kEmptyLeaf | first << kCountBits | (last - first);
    }
    const std::uint32_t middle = depth < kMaxDepth ? split(first, last) : first + (last - first) / 2;
    PROVEOUT_ASSERT(first < middle && middle < last);
    const std::uint32_t number = used_++;
    Box3 halves[2];
    std::uint32_t children[2];
    const auto half = [&](int side) {
      children[side] =
          side == 0 ? build(first, middle, depth + 1, halves[0]) : build(middle, last, depth + 1, halves[1]);
    };
    if (last - first >= kParallelSize) {
      parallelFor(0, 2, half);
    } else {
      half(0);
      half(1);
    }
    Node& node = nodes_[number];
    for (int side = 0; side < 2; ++side) {
      node.child[side] = children[side];
      for (int k = 0; k < 3; ++k) {
        node.low[side][k] = below(halves[side].min[k]);
        node.high[side][k] = above(halves[side].max[k]);
      }
      bounds.extend(halves[side]);
    }
    return number;
  }

  Box3 boxAt(std::uint32_t number) const {
    return {boxes_[number].min.template cast<double>(), boxes_[number].max.template cast<double>()};
  }

  std::uint32_t split(std::uint32_t first, std::uint32_t last) {
    Box3 centers;
    for (std::uint32_t i = first; i < last; ++i) centers.extend(boxAt(tree_.order_[i]).center());
    int axis = 0;
    centers.size().maxCoeff(&axis);
    const std::uint32_t half = first + (last - first) / 2;
    const double low = centers.min[axis], width = centers.size()[axis];
    if (!(width > 0.0)) return half;
    const double scale = kBins / width;
    const auto binOf = [&](std::uint32_t i) {
      const double center =
          0.5 * (static_cast<double>(boxes_[i].min[axis]) + static_cast<double>(boxes_[i].max[axis]));
      return std::min(kBins - 1, static_cast<int>((center - low) * scale));
    };
    const int border = bestBorder(first, last, binOf);
    const auto begin = tree_.order_.begin();
    const auto at =
        std::partition(begin + first, begin + last, [&](std::uint32_t i) { return binOf(i) < border; });
    const auto found = static_cast<std::uint32_t>(at - begin);
    return found == first || found == last ? half : found;
  }

  /// The bins below it go to one side.
  template <typename BinOf>
  int bestBorder(std::uint32_t first, std::uint32_t last, const BinOf& binOf) const {
    std::array<Box3, kBins> box;
    std::array<double, kBins> count{};
    for (std::uint32_t i = first; i < last; ++i) {
      const std::uint32_t number = tree_.order_[i];
      const int bin = binOf(number);
      box[bin].extend(boxAt(number));
      ++count[bin];
    }
    std::array<double, kBins> cost{};  // of the bins from here on
    Box3 side;
    double on_side = 0.0;
    for (int b = kBins - 1; b > 0; --b) {
      if (count[b] > 0.0) side.extend(box[b]);
      on_side += count[b];
      cost[b] = on_side > 0.0 ? halfSurface(side) * on_side : 0.0;
    }
    side = Box3();
    on_side = 0.0;
    int best = kBins / 2;
    double least = std::numeric_limits<double>::infinity();
    for (int b = 1; b < kBins; ++b) {
      if (count[b - 1] > 0.0) side.extend(box[b - 1]);
      on_side += count[b - 1];
      if (on_side == 0.0 || cost[b] == 0.0) continue;
      const double sum = halfSurface(side) * on_side + cost[b];
      if (sum >= least) continue;
      least = sum;
      best = b;
    }
    return best;
  }

  BoxTree& tree_;
  const std::vector<Box>& boxes_;
  /// For as many as there may be; the system gives memory for those only that are written.
  std::unique_ptr<Node[]> nodes_;
  std::atomic<std::uint32_t> used_{0};
};

ShortBox ShortBox::around(const Box3& box) {
  ShortBox out{toFloat(box.min), toFloat(box.max)};
  for (int k = 0; k < 3; ++k) {
    if (out.min[k] > box.min[k]) out.min[k] = below(box.min[k]);
    if (out.max[k] < box.max[k]) out.max[k] = above(box.max[k]);
  }
  return out;
}

BoxTree::BoxTree(const std::vector<Box3>& boxes) { Builder<Box3>(*this, boxes).run(); }
BoxTree::BoxTree(const std::vector<ShortBox>& boxes) { Builder<ShortBox>(*this, boxes).run(); }

}  // namespace proveout
