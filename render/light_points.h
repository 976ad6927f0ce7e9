// Points of a light grid side by side, as means over alike neighbours read them.
#pragma once

#include <vector>

#include "render/lights.h"
#include "render/surfaces.h"

namespace proveout::render_detail {

/// How much what is seen at one pixel says of another, 0 to 1: by kind, normal and plane. `near`: distance
/// across the surface, units, from which on it says nothing.
float likeness(const Seen& a, const Seen& b, float near);

/// Shares of light at all points, in the order of LightPoints::index.
struct LitPoints {
  std::vector<float> key, sky;
  std::vector<float> alike;  ///< points that the shares are means of, by likeness
  Lit at(std::size_t k) const { return {key[k], sky[k]}; }
  void set(std::size_t k, const Lit& lit) {
    key[k] = lit.key;
    sky[k] = lit.sky;
  }
};

class LightPoints {
 public:
  static constexpr int kBlock = 8;      ///< columns that are averaged together
  static constexpr int kMostReach = 3;  ///< points

  /// Columns from 0, rows from row0. `near`: see likeness.
  LightPoints(int columns, int row0, int rows, float near);

  int columns() const { return columns_; }
  int firstRow() const { return row0_; }
  int endRow() const { return row0_ + rows_; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j - row0_) * pitch_ + static_cast<std::size_t>(i + kMostReach);
  }
  /// As many as index() tells apart, all of full light.
  LitPoints fullLight() const;

  void set(int i, int j, const Seen& seen);
  /// How much the point says of what is seen elsewhere.
  float likenessTo(const Seen& seen, int i, int j) const;
  /// Means over the points within `reach`, by likeness, for kBlock columns from column i on, a multiple of
  /// kBlock. Points that show nothing are alike. Requires reach <= kMostReach.
  void average(const LitPoints& in, int i, int j, int reach, LitPoints& out) const;

 private:
  const int columns_, row0_, rows_;
  const std::size_t pitch_;
  const float near_;
  std::vector<float> kind_, normal_[3], point_[3];
};

}  // namespace proveout::render_detail
