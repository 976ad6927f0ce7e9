// Distance to the surface of a stock without a closed form.
#pragma once

#include <memory>
#include <mutex>

#include "core/mesh/triangle_tree.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

/// By what cut it in earlier clampings, where that is known; else by the mesh that it was made from, or by
/// one of its surface: flat faces are exact, curved ones are off by the chords of the grid. Made when first
/// asked for, which any thread may do as long as the stock is not changed.
class StockFaces {
 public:
  /// `stock` must outlive this.
  explicit StockFaces(const Stock::Impl& stock) : stock_(stock) {}

  /// Signed distance, negative inside, mm, and its gradient, unit. Throws std::runtime_error where no surface
  /// can be made (not enough memory).
  struct Sample {
    double value;
    Vec3 gradient;
  };
  Sample at(const Vec3& p) const;

 private:
  void make() const;

  const Stock::Impl& stock_;
  mutable std::once_flag made_;
  mutable std::shared_ptr<const TriangleTree> tree_;
};

/// What cut the stock in earlier clampings is not kept beside a path where that takes much memory.
void forgetLargeRecords(Stock::Impl& stock);

}  // namespace proveout
