// The volume that tools without undercut take from a box, without a grid and without any of the engine: the
// height that the tools leave over each place, integrated over squares that are halved where it bends or
// breaks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/geometry/types.h"

namespace proveout::test {

/// One tool on its straight way. The tool reaches up beyond the box.
struct HeightPass {
  Vec3 from, to;                        ///< of its tip, mm
  double radius;                        ///< mm
  std::function<double(double)> lower;  ///< height over the tip at a distance up to `radius`; convex, rising
};

class HeightTruth {
 public:
  HeightTruth(Vec3 min, Vec3 max, std::vector<HeightPass> passes)
      : min_(min), max_(max), passes_(std::move(passes)) {}

  /// mm3; off by some `share` of the box's area times its height, about.
  double removed(double share = 2e-8) {
    smallest_ = 2e-3 * std::min(max_.x() - min_.x(), max_.y() - min_.y());
    share_ = share * (max_ - min_).prod();
    const int n = 16;
    double sum = 0.0;
    const Vec2 size = (max_ - min_).head<2>() / n;
    for (int i = 0; i < n * n; ++i) {
      const Vec2 low = min_.head<2>() + size.cwiseProduct(Vec2(i % n, i / n));
      sum += square({low, size, share_ / (n * n)}, all());
    }
    return sum;
  }

 private:
  struct Square {
    Vec2 low, size;
    double allowed;
    Vec2 at(double u, double v) const { return low + size.cwiseProduct(Vec2(u, v)); }
    double area() const { return size.prod(); }
  };
  using Few = std::vector<std::size_t>;

  Few all() const {
    Few out;
    for (std::size_t i = 0; i < passes_.size(); ++i) out.push_back(i);
    return out;
  }

  /// Level distance from the way.
  static double beside(const HeightPass& pass, const Vec2& p) {
    const Vec2 a = pass.from.head<2>(), way = pass.to.head<2>() - a;
    const double l2 = way.squaredNorm(), t = l2 > 0.0 ? std::clamp((p - a).dot(way) / l2, 0.0, 1.0) : 0.0;
    return (p - a - t * way).norm();
  }

  /// Lowest height of the tool over a place, by golden sections; `p` is no farther than the radius.
  static double heightOver(const HeightPass& pass, const Vec2& p) {
    const Vec2 a = pass.from.head<2>(), way = pass.to.head<2>() - a;
    const double l2 = way.squaredNorm(), rise = pass.to.z() - pass.from.z();
    if (l2 == 0.0)
      return std::min(pass.from.z(), pass.to.z()) + pass.lower(std::min((p - a).norm(), pass.radius));
    const double foot = (p - a).dot(way) / l2, off2 = (p - a - foot * way).squaredNorm();
    const double half = std::sqrt(std::max(0.0, pass.radius * pass.radius - off2) / l2);
    double low = std::clamp(foot - half, 0.0, 1.0), high = std::clamp(foot + half, 0.0, 1.0);
    const auto height = [&](double t) {
      const double r = std::sqrt(off2 + (t - foot) * (t - foot) * l2);
      return pass.from.z() + t * rise + pass.lower(std::min(r, pass.radius));
    };
    if (rise == 0.0) return height(std::clamp(foot, low, high));
    constexpr double kGolden = 0.6180339887498949;
    for (int i = 0; i < 60 && high - low > 1e-12; ++i) {
      const double c = high - kGolden * (high - low), d = low + kGolden * (high - low);
      (height(c) < height(d) ? high : low) = height(c) < height(d) ? d : c;
    }
    return std::min({height(low), height(high), height(0.5 * (low + high))});
  }

  double taken(double height) const { return max_.z() - std::clamp(height, min_.z(), max_.z()); }

  double at(const Vec2& p, const Few& passes) const {
    double height = max_.z();
    for (const std::size_t i : passes) {
      if (beside(passes_[i], p) <= passes_[i].radius) height = std::min(height, heightOver(passes_[i], p));
    }
    return taken(height);
  }

  double gauss(const Square& s, const Few& passes) const {
    constexpr std::array<double, 2> kAt = {0.21132486540518713, 0.7886751345948129};
    double sum = 0.0;
    for (const double u : kAt) {
      for (const double v : kAt) sum += at(s.at(u, v), passes);
    }
    return 0.25 * sum * s.area();
  }

  /// Where a tool's side goes through a small square: the part of it that the side's line leaves counts.
  double onSides(const Square& s, const Few& passes, const Few& sides) const {
    const Vec2 middle = s.at(0.5, 0.5);
    double height = max_.z();
    for (const std::size_t i : passes) {
      const bool side = std::find(sides.begin(), sides.end(), i) != sides.end();
      if (!side) height = std::min(height, heightOver(passes_[i], middle));
    }
    double here = taken(height);
    for (const std::size_t i : sides) {
      const double d = beside(passes_[i], middle) - passes_[i].radius;
      const double part = std::clamp(0.5 - d / s.size.maxCoeff(), 0.0, 1.0);
      const double with = taken(heightOver(passes_[i], nearest(passes_[i], middle)));
      here += part * std::max(0.0, with - here);
    }
    return here * s.area();
  }

  /// Moved to where the tool is, if it is not.
  static Vec2 nearest(const HeightPass& pass, const Vec2& p) {
    const double d = beside(pass, p), in = (1.0 - 1e-9) * pass.radius;
    if (d <= in) return p;
    const Vec2 a = pass.from.head<2>(), way = pass.to.head<2>() - a;
    const double l2 = way.squaredNorm(), t = l2 > 0.0 ? std::clamp((p - a).dot(way) / l2, 0.0, 1.0) : 0.0;
    const Vec2 foot = a + t * way;
    return foot + (p - foot) * (in / d);
  }

  double square(const Square& s, const Few& near) {
    const Vec2 middle = s.at(0.5, 0.5);
    const double half = 0.5 * s.size.norm();
    Few passes, sides;
    for (const std::size_t i : near) {
      const double d = beside(passes_[i], middle) - passes_[i].radius;
      if (d >= half) continue;
      passes.push_back(i);
      if (d > -half) sides.push_back(i);
    }
    if (passes.empty()) return 0.0;
    if (sides.empty()) {
      const double whole = gauss(s, passes);
      double parts = 0.0;
      for (int i = 0; i < 4; ++i) parts += gauss(quarter(s, i), passes);
      if (std::abs(parts - whole) <= s.allowed || s.size.maxCoeff() < 0.1 * smallest_) return parts;
    } else if (s.size.maxCoeff() < smallest_) {
      return onSides(s, passes, sides);
    }
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += square(quarter(s, i), passes);
    return sum;
  }

  static Square quarter(const Square& s, int i) {
    return {s.at(0.5 * (i & 1), 0.5 * (i >> 1)), 0.5 * s.size, 0.35 * s.allowed};
  }

  Vec3 min_, max_;
  std::vector<HeightPass> passes_;
  double smallest_ = 0.0, share_ = 0.0;
};

inline std::function<double(double)> flatEnd() {
  return [](double) { return 0.0; };
}
inline std::function<double(double)> ballEnd(double radius) {
  return [radius](double r) { return radius - std::sqrt(std::max(0.0, radius * radius - r * r)); };
}
inline std::function<double(double)> bullEnd(double radius, double corner) {
  return [flat = radius - corner, corner](double r) {
    const double out = r - flat;
    return out <= 0.0 ? 0.0 : corner - std::sqrt(std::max(0.0, corner * corner - out * out));
  };
}
/// A cone with a flat tip; `half_deg` from its axis.
inline std::function<double(double)> coneEnd(double tip_radius, double half_deg) {
  return [tip_radius, slope = 1.0 / std::tan(degToRad(half_deg))](double r) {
    return std::max(0.0, r - tip_radius) * slope;
  };
}

}  // namespace proveout::test
