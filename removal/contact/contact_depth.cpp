#include "removal/contact/contact_depth.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/base/assert.h"

namespace proveout {
namespace {

/// By how much a point outside of the swept volume loses more than it can gain in depth: with any factor
/// above 1 the best point is inside.
constexpr double kPenalty = 2.0;
/// Rounds of one search: from 1 m to kWithinMm it takes 400.
constexpr int kMaxRounds = 600;
/// Searches from different places that may find nothing better before the best is taken.
constexpr int kVainSearches = 6;
/// The same of boxes: their bounds are loose, and the place of a narrow rib may come late.
constexpr int kVainBoxes = 64;
/// Searches on from what was found; each must gain something.
constexpr int kMaxRepeats = 8;
/// Reach of a search from a sample, in grid steps: the quarters of leaves, from which samples come, and a
/// step around them.
constexpr double kReach = 6.0;
/// Half the diagonal of boxes in which searches begin, in grid steps.
constexpr double kSmallBox = 1.0;

/// An ellipsoid that holds the best point, as the ellipsoid method keeps it (Shor; Bland, Goldfarb and Todd
/// 1981, deep cuts).
struct Ellipsoid {
  Vec3 middle;
  Eigen::Matrix3d shape;

  /// Greatest step of a linear function with this gradient from the middle to the border.
  double reach(const Vec3& gradient) const {
    return std::sqrt(std::max(0.0, gradient.dot(shape * gradient)));
  }
  /// Leaves the part where a concave function with this gradient in the middle may be `gain` above its value
  /// there. Requires gain < reach(gradient).
  void cut(const Vec3& gradient, double gain) {
    constexpr double n = 3.0;
    PROVEOUT_ASSERT_DEAR(gain < reach(gradient));
    const double length = reach(gradient), alpha = std::max(0.0, gain / length);
    const Vec3 step = shape * gradient / length;
    middle += (1.0 + n * alpha) / (n + 1.0) * step;
    shape = n * n * (1.0 - alpha * alpha) / (n * n - 1.0) *
            (shape - 2.0 * (1.0 + n * alpha) / ((n + 1.0) * (1.0 + alpha)) * step * step.transpose());
  }
};

}  // namespace

DeepestPoint::DeepestPoint(const StockDepth& stock, const Pass& pass, MotionId before, double h)
    : stock_(stock), before_(before), sweep_(pass.body.field()), h_(h) {}

StockDepth::Sample DeepestPoint::depthAt(const Vec3& p) {
  --effort_;
  return stock_.at(p, before_, hint_);
}

/// `outside`, `away`: of the swept volume, at `p`; the point of it nearest to `p` is looked at.
void DeepestPoint::consider(const Vec3& p, double outside, const Vec3& away, DeepPoint& best) {
  const Vec3 at = outside > 0.0 ? Vec3(p - outside * away) : p;
  const double depth = depthAt(at).value;
  if (depth > best.depth) best = {depth, at};
}

/// Ellipsoid method for the depth less the penalty, which is concave where the stock is convex: then it finds
/// the best point of the ball. Whether it found a better one.
bool DeepestPoint::search(const Vec3& middle, double radius, DeepPoint& best) {
  const double before = best.depth;
  Ellipsoid ellipsoid{middle, radius * radius * Eigen::Matrix3d::Identity()};
  for (int round = 0; round < kMaxRounds && !tired(); ++round) {
    const Vec3& p = ellipsoid.middle;
    const SweepSample body = sweep_.sample(p);
    const double outside = std::max(0.0, body.value);
    const StockDepth::Sample depth = depthAt(p);
    if (outside > 0.0 ? depth.value + outside > best.depth : depth.value > best.depth)
      consider(p, outside, body.gradient, best);
    const double value = depth.value - kPenalty * outside;
    const Vec3 gradient = outside > 0.0 ? Vec3(depth.gradient - kPenalty * body.gradient) : depth.gradient;
    if (value + ellipsoid.reach(gradient) <= best.depth + kWithinMm) break;
    ellipsoid.cut(gradient, best.depth - value);
  }
  return best.depth > before + kWithinMm;
}

/// Points and, with each, the nearest one of the swept volume's border, the deepest first.
std::vector<DeepestPoint::Start> DeepestPoint::ordered(const std::vector<Vec3>& points) {
  std::vector<Start> starts;
  for (const Vec3& p : points) {
    if (tired() && !starts.empty()) break;
    const SweepSample body = sweep_.sample(p);
    const Vec3 border = p - body.value * body.gradient;
    const double inside = depthAt(p).value, there = depthAt(border).value;
    starts.push_back(there > inside ? Start{there, border} : Start{inside, p});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.depth > b.depth; });
  return starts;
}

/// A search, and others from what it finds as long as they find better.
bool DeepestPoint::searchOn(const Vec3& from, double radius, DeepPoint& best) {
  const bool better = search(from, radius, best);
  for (int i = 0; better && i < kMaxRepeats && search(best.where, kReach * h_, best); ++i) {
  }
  return better;
}

void DeepestPoint::searchFrom(const std::vector<Vec3>& starts, DeepPoint& best) {
  const double radius = kReach * h_;
  std::vector<Vec3> tried;
  int vain = 0;
  for (const Start& start : ordered(starts)) {
    if (tired()) {
      if (start.depth > best.depth) best = {start.depth, start.at};
      break;
    }
    if (start.depth + radius <= best.depth || vain == kVainSearches) break;
    const auto near = [&](const Vec3& other) { return (other - start.at).norm() < 0.5 * radius; };
    if (std::any_of(tried.begin(), tried.end(), near)) continue;
    tried.push_back(start.at);
    vain = searchOn(start.at, radius, best) ? 0 : vain + 1;
  }
}

/// Halves the box of what the swept volume and the stock have in common, the part with the largest bound
/// first: no point of a box lies deeper than its middle by more than half its diagonal, nor than the blank's
/// sides allow. Where a box is small and may still hold a better point, a search sets out.
void DeepestPoint::searchBoxes(DeepPoint& best) {
  struct Part {
    double bound;
    Vec3 middle, half;
    bool operator<(const Part& other) const { return bound < other.bound; }
  };
  std::priority_queue<Part> parts;
  const auto add = [&](const Vec3& middle, const Vec3& half) {
    const double reach = half.norm(), most = stock_.mostIn(middle, half);
    if (most <= best.depth + kWithinMm || sweep_.distance(middle, reach) > reach) return;
    const double bound = std::min(most, depthAt(middle).value + reach);
    if (bound > best.depth + kWithinMm) parts.push({bound, middle, half});
  };
  const Vec3 low = sweep_.bounds().min.cwiseMax(stock_.bounds().min);
  const Vec3 high = sweep_.bounds().max.cwiseMin(stock_.bounds().max);
  if ((low.array() >= high.array()).any()) return;
  add(0.5 * (low + high), 0.5 * (high - low));
  int vain = 0;
  while (!parts.empty() && !tired() && vain < kVainBoxes) {
    Part part = parts.top();
    parts.pop();
    if (part.bound <= best.depth + kWithinMm) break;
    const double reach = part.half.norm();
    if (reach <= kSmallBox * h_) {
      vain = searchOn(part.middle, kReach * h_, best) ? 0 : vain + 1;
      continue;
    }
    int axis = 0;
    part.half.maxCoeff(&axis);
    part.half[axis] *= 0.5;
    for (const double side : {-1.0, 1.0})
      add(part.middle + side * part.half[axis] * Vec3::Unit(axis), part.half);
  }
}

DeepPoint DeepestPoint::find(const std::vector<Vec3>& starts, double known, int& effort) {
  DeepPoint best{known, Vec3::Zero()};
  effort_ = effort;
  searchFrom(starts, best);
  searchBoxes(best);
  effort = effort_;
  return best.depth > known ? best : DeepPoint{};
}

}  // namespace proveout
