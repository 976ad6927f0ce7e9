// Points in the cells of a cubic grid: which lie near a place.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

class PointCells {
 public:
  /// Keeps a copy. `cell_mm` > 0: about as far as is asked for later; it is widened where the points reach
  /// too far for so small cells. Points have to be finite.
  PointCells(std::vector<Vec3> points, double cell_mm);

  const std::vector<Vec3>& points() const { return points_; }
  double cell() const { return cell_; }
  /// Cell by cell: points that follow each other lie near each other. The same for the same input.
  const std::vector<std::uint32_t>& order() const { return order_; }
  /// How many points lie in the cell of each point, itself included.
  std::vector<std::uint32_t> crowds() const;

  /// Calls visit(index, squared distance) for every point no farther than `radius` mm from `p`, cell by cell.
  template <typename Visit>
  void forEachNear(const Vec3& p, double radius, const Visit& visit) const {
    const Cell low = cellOf(p - Vec3::Constant(radius)), high = cellOf(p + Vec3::Constant(radius));
    for (std::int64_t x = low.x; x <= high.x; ++x) {
      for (std::int64_t y = low.y; y <= high.y; ++y) {
        for (std::int64_t z = low.z; z <= high.z; ++z) {
          const auto found = ranges_.find(keyOf({x, y, z}));
          if (found == ranges_.end()) continue;
          for (std::uint32_t k = found->second.first; k < found->second.second; ++k) {
            const double squared = (points_[order_[k]] - p).squaredNorm();
            if (squared <= radius * radius) visit(order_[k], squared);
          }
        }
      }
    }
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  Cell cellOf(const Vec3& p) const;
  static std::uint64_t keyOf(const Cell& cell);

  std::vector<Vec3> points_;
  double cell_;
  Vec3 corner_ = Vec3::Zero();
  std::vector<std::uint32_t> order_;
  std::unordered_map<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>> ranges_;  ///< of `order_`
};

/// The distance of points on a surface from their neighbours, mm: the side of the square that each has for
/// itself, by the neighbours of some of them; half of them have less. 0 for fewer than 9 points.
double pointSpacing(const std::vector<Vec3>& points, double area_mm2);

}  // namespace proveout
