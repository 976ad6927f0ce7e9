// Distances to tools as they are drawn: references that know nothing of profiles.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/unit/tool/drawings.h"

namespace proveout::test {

/// Signed distance of (r, z) to a drawn outline, negative inside.
class DrawnOutline {
 public:
  explicit DrawnOutline(const Drawing& drawing) : p_(drawing.outline) {
    p_.insert(p_.begin(), Vec2(0.0, p_.front().y()));
    p_.emplace_back(0.0, p_.back().y());
    for (std::size_t i = 0; i + 1 < p_.size(); i += kRun) {
      const std::size_t end = std::min(i + kRun, p_.size() - 1);
      Box3 box;
      for (std::size_t k = i; k <= end; ++k) box.extend(Vec3(p_[k].x(), p_[k].y(), 0.0));
      runs_.push_back({i, end, box.center().head<2>(), 0.5 * box.size().norm()});
    }
  }

  double distance(double r, double z) const {
    const Vec2 p(r, z);
    double best = std::numeric_limits<double>::infinity();
    for (const Run& run : runs_) {
      if ((p - run.middle).norm() - run.reach > best) continue;
      for (std::size_t k = run.first; k < run.last; ++k)
        best = std::min(best, toSegment(p, p_[k], p_[k + 1]));
    }
    return inside(p) ? -best : best;
  }
  double reach() const {
    double most = 0.0;
    for (const Vec2& p : p_) most = std::max(most, p.norm());
    return most;
  }

 private:
  static constexpr std::size_t kRun = 16;
  struct Run {
    std::size_t first, last;
    Vec2 middle;
    double reach;
  };
  static double toSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 d = b - a;
    const double length2 = d.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
    return (p - a - t * d).norm();
  }
  /// A level ray outwards crosses the outline an odd number of times.
  bool inside(const Vec2& p) const {
    bool in = false;
    for (const Run& run : runs_) {
      if (std::abs(p.y() - run.middle.y()) > run.reach) continue;
      for (std::size_t k = run.first; k < run.last; ++k) {
        const Vec2 &a = p_[k], &b = p_[k + 1];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        if (a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) > p.x()) in = !in;
      }
    }
    return in;
  }

  std::vector<Vec2> p_;
  std::vector<Run> runs_;
};

}  // namespace proveout::test
