// Points and lines for property tests, the same in every run.
#pragma once

#include <random>

#include "core/geometry/types.h"

namespace proveout::test {

class RandomMoves {
 public:
  explicit RandomMoves(unsigned seed) : engine_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 point() { return {number(-8, 8), number(-8, 8), number(-4, 4)}; }

  struct Line {
    Vec3 from, to;
  };
  /// 0: level, 1: vertical, 2: short, 3: in a plane of the grid; else any.
  Line line(int style) {
    Line out{point(), point()};
    if (style == 0) out.to.z() = out.from.z();
    if (style == 1) out.to.head<2>() = out.from.head<2>();
    if (style == 2) out.to = out.from + 1e-3 * (out.to - out.from);
    if (style == 3) out.to.x() = out.from.x();
    return out;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace proveout::test
