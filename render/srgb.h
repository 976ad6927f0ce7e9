// sRGB transfer function by table.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/color_map.h"

namespace proveout::render_detail {

class SrgbTable {
 public:
  SrgbTable() {
    for (int i = 0; i <= kSteps; ++i) {
      const double s = static_cast<double>(i) / kSteps;
      to_linear_[static_cast<std::size_t>(i)] =
          static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
  }
  /// sRGB 0..1 to linear light, interpolated; clamps.
  float toLinear(float s) const {
    const float x = std::clamp(s, 0.0F, 1.0F) * kSteps;
    const int i = std::min(static_cast<int>(x), kSteps - 1);
    const auto k = static_cast<std::size_t>(i);
    return to_linear_[k] + (to_linear_[k + 1] - to_linear_[k]) * (x - static_cast<float>(i));
  }
  Eigen::Vector3f toLinear(const Rgb& c) const { return {toLinear(c[0]), toLinear(c[1]), toLinear(c[2])}; }

 private:
  static constexpr int kSteps = 1020;  ///< a multiple of 255: bytes map exactly
  std::array<float, kSteps + 1> to_linear_;
};

/// Linear light to the nearest sRGB byte; clamps.
class LinearToByte {
 public:
  LinearToByte() : bytes_(kSteps + 1) {
    for (int i = 0; i <= kSteps; ++i) {
      const double l = static_cast<double>(i) / kSteps;
      const double s = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
      bytes_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255.0 * s));
    }
  }
  std::uint8_t operator()(float linear) const {
    return bytes_[static_cast<std::size_t>(std::clamp(linear, 0.0F, 1.0F) * kSteps + 0.5F)];
  }

 private:
  static constexpr int kSteps =
      1 << 15;  ///< the steepest stretch, where it is dark, then moves by a tenth of a byte
  std::vector<std::uint8_t> bytes_;
};

}  // namespace proveout::render_detail
