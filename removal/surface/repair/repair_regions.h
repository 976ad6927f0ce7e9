// The regions around triangles that intersect, in groups that can be repaired independently.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

using TrianglePair = std::array<std::uint32_t, 2>;

inline Box3 boxOf(const std::array<Vec3, 3>& p) {
  return {p[0].cwiseMin(p[1]).cwiseMin(p[2]), p[0].cwiseMax(p[1]).cwiseMax(p[2])};
}

/// Space in blocks of two cells.
class RepairBlocks {
 public:
  explicit RepairBlocks(double cell_mm);

  std::uint64_t keyAt(const Vec3& p) const { return keyOf(blockOf(p)); }
  /// Calls body(key) for each block that the box reaches into.
  template <typename Body>
  void each(const Box3& box, Body&& body) const {
    const Eigen::Vector3i from = blockOf(box.min), to = blockOf(box.max);
    for (int x = from.x(); x <= to.x(); ++x) {
      for (int y = from.y(); y <= to.y(); ++y) {
        for (int z = from.z(); z <= to.z(); ++z) body(keyOf(Eigen::Vector3i(x, y, z)));
      }
    }
  }

  /// The blocks that the box reaches into, and a little more.
  Box3 around(const Box3& box) const {
    const auto corner = [&](const Vec3& p, double more) {
      return Vec3((blockOf(p).cast<double>() + Vec3::Constant(more)) / scale_);
    };
    return {corner(box.min, -0.1), corner(box.max, 1.1)};
  }

 private:
  Eigen::Vector3i blockOf(const Vec3& p) const { return (p * scale_).array().floor().cast<int>().matrix(); }
  static std::uint64_t keyOf(const Eigen::Vector3i& block) {
    const auto part = [](int i) { return static_cast<std::uint64_t>(i) & 0x1FFFFF; };
    return part(block.x()) << 42 | part(block.y()) << 21 | part(block.z());
  }

  double scale_;
};

/// The triangles around the pairs, in groups that do not touch each other.
class RepairRegions {
 public:
  struct Group {
    std::vector<std::uint32_t> triangles;  ///< ascending
    std::vector<TrianglePair> pairs;       ///< in the order given
  };

  RepairRegions(const TriMesh& mesh, double cell_mm, const std::vector<TrianglePair>& pairs);
  const std::vector<Group>& groups() const { return groups_; }
  const RepairBlocks& blocks() const { return blocks_; }
  /// Whether all triangles at a vertex at `p` (mm) belong to these regions.
  bool hasWholeStar(const Vec3& p) const { return marked_.contains(blocks_.keyAt(p)); }

 private:
  void share(const TriMesh& mesh, const std::vector<std::uint32_t>& near,
             const std::vector<TrianglePair>& pairs);

  RepairBlocks blocks_;
  std::unordered_set<std::uint64_t> marked_;  ///< blocks of the regions
  std::vector<Group> groups_;
};

}  // namespace proveout
