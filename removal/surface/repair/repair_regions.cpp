#include "removal/surface/repair/repair_regions.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/intersections.h"

namespace proveout {

namespace {

/// How far around the pairs the regions reach, and the edge of the blocks that make them up, in cells.
constexpr double kMarginCells = 2.0, kBlockCells = 2.0;
/// Stretches of the filter along each axis.
constexpr int kStretches = 1024;
/// Triangles of one task.
constexpr std::size_t kPart = 8192;
constexpr std::uint32_t kNoGroup = 0xFFFFFFFFu;

/// Rules out quickly that a triangle touches one of some boxes: most triangles are nowhere near.
class BoxFilter {
 public:
  void add(const Box3& box) { boxes_.push_back(box); }
  /// To be called when all boxes are added.
  void finish();
  bool mayTouch(const TriMesh& mesh, std::uint32_t t) const {
    const auto& v = mesh.triangles[t];
    const Eigen::Vector3f &a = mesh.positions[v[0]], &b = mesh.positions[v[1]], &c = mesh.positions[v[2]];
    for (int axis = 0; axis < 3; ++axis) {
      const float low = (std::min({a[axis], b[axis], c[axis]}) - low_[axis]) * scale_[axis],
                  high = (std::max({a[axis], b[axis], c[axis]}) - low_[axis]) * scale_[axis];
      if (high < 0.0f || low >= kStretches) return false;
      const int first = low < 0.0f ? 0 : static_cast<int>(low),
                last = high >= kStretches ? kStretches - 1 : static_cast<int>(high);
      const auto& upto = boxes_upto_[axis];
      if (upto[last + 1] == upto[first]) return false;
    }
    return true;
  }

 private:
  std::vector<Box3> boxes_;
  Eigen::Vector3f low_, scale_;
  /// Stretches that a box reaches into, of those before this one.
  std::array<std::array<int, kStretches + 1>, 3> boxes_upto_;
};

void BoxFilter::finish() {
  Box3 all;
  for (const Box3& box : boxes_) all.extend(box);
  low_ = toFloat(all.min);
  scale_ = toFloat(kStretches * all.size().cwiseInverse());
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, kStretches + 1> taken{};
    for (const Box3& box : boxes_) {
      const auto at = [&](double x) {
        return std::clamp(static_cast<int>((x - low_[axis]) * scale_[axis]), 0, kStretches - 1);
      };
      std::fill(&taken[at(box.min[axis])], &taken[at(box.max[axis])] + 1, 1);
    }
    int sum = 0;
    for (int k = 0; k <= kStretches; ++k) boxes_upto_[axis][k] = std::exchange(sum, sum + taken[k]);
  }
}

/// Triangles that reach into marked blocks, ascending.
std::vector<std::uint32_t> nearTriangles(const TriMesh& mesh, const RepairBlocks& blocks,
                                         const std::unordered_set<std::uint64_t>& marked,
                                         const BoxFilter& regions) {
  const auto isNear = [&](std::uint32_t t) {
    if (!regions.mayTouch(mesh, t)) return false;
    bool inside = false;
    blocks.each(boxOf(cornersOf(mesh, t)),
                [&](std::uint64_t key) { inside = inside || marked.contains(key); });
    return inside;
  };
  const std::size_t count = mesh.triangles.size(), parts = count / kPart + 1;
  std::vector<std::vector<std::uint32_t>> found(parts);
  parallelFor(std::size_t{0}, parts, [&](std::size_t part) {
    for (std::size_t t = part * kPart; t < std::min(count, (part + 1) * kPart); ++t) {
      const auto number = static_cast<std::uint32_t>(t);
      if (isNear(number)) found[part].push_back(number);
    }
  });
  std::vector<std::uint32_t> near;
  for (const auto& part : found) near.insert(near.end(), part.begin(), part.end());
  return near;
}

}  // namespace

RepairBlocks::RepairBlocks(double cell_mm) : scale_(1.0 / (kBlockCells * cell_mm)) {}

RepairRegions::RepairRegions(const TriMesh& mesh, double cell_mm, const std::vector<TrianglePair>& pairs)
    : blocks_(cell_mm) {
  BoxFilter regions;  // that marked_ is in
  for (const TrianglePair& pair : pairs) {
    for (const std::uint32_t t : pair) {
      const Box3 box = boxOf(cornersOf(mesh, t)).inflated(kMarginCells * cell_mm);
      regions.add(blocks_.around(box));
      blocks_.each(box, [&](std::uint64_t key) { marked_.insert(key); });
    }
  }
  regions.finish();
  share(mesh, nearTriangles(mesh, blocks_, marked_, regions), pairs);
}

/// Triangles that reach into one block are of one group.
void RepairRegions::share(const TriMesh& mesh, const std::vector<std::uint32_t>& near,
                          const std::vector<TrianglePair>& pairs) {
  DisjointSets sets(near.size());
  std::unordered_map<std::uint64_t, std::uint32_t> first;
  for (std::uint32_t i = 0; i < near.size(); ++i) {
    blocks_.each(boxOf(cornersOf(mesh, near[i])),
                 [&](std::uint64_t key) { sets.join(first.try_emplace(key, i).first->second, i); });
  }
  std::vector<std::uint32_t> group_at(near.size(), kNoGroup);
  const auto groupOf = [&](std::uint32_t i) -> Group& {
    std::uint32_t& number = group_at[sets.find(i)];
    if (number == kNoGroup) {
      number = static_cast<std::uint32_t>(groups_.size());
      groups_.emplace_back();
    }
    return groups_[number];
  };
  for (std::uint32_t i = 0; i < near.size(); ++i) groupOf(i).triangles.push_back(near[i]);
  for (const TrianglePair& pair : pairs) {
    const auto at = std::lower_bound(near.begin(), near.end(), pair[0]) - near.begin();
    PROVEOUT_ASSERT(static_cast<std::size_t>(at) < near.size() &&
                    near[static_cast<std::size_t>(at)] == pair[0]);
    groupOf(static_cast<std::uint32_t>(at)).pairs.push_back(pair);
  }
}

}  // namespace proveout
