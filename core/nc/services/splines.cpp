#include "core/nc/services/splines.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace splines_detail {

constexpr int kDeepest = 16;  ///< halvings of a stretch
constexpr int kAtLeast = 2;   ///< halvings that are always made: a curve may cross its chord
constexpr std::size_t kMost = 65536;

double fromSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double n = d.squaredNorm();
  const double t = n > 0.0 ? std::clamp((p - a).dot(d) / n, 0.0, 1.0) : 0.0;
  return (a + t * d - p).norm();
}

/// Chords of `at` from t0 to t1, whose points are a and b.
template <typename Curve>
void chords(const Curve& at, double t0, const Vec2& a, double t1, const Vec2& b, double tolerance, int depth,
            std::vector<Vec2>& out) {
  const double tm = 0.5 * (t0 + t1);
  const Vec2 m = at(tm);
  const bool flat = depth >= kAtLeast && fromSegment(m, a, b) <= tolerance &&
                    fromSegment(at(0.5 * (t0 + tm)), a, b) <= tolerance &&
                    fromSegment(at(0.5 * (tm + t1)), a, b) <= tolerance;
  if (flat || depth >= kDeepest || out.size() >= kMost) {
    out.push_back(b);
    return;
  }
  chords(at, t0, a, tm, m, tolerance, depth + 1, out);
  chords(at, tm, m, t1, b, tolerance, depth + 1, out);
}

}  // namespace splines_detail

void appendBezier(const std::array<Vec2, 4>& control, double tolerance, std::vector<Vec2>& out) {
  const auto at = [&](double t) {
    const double s = 1.0 - t;
    return Vec2(s * s * s * control[0] + 3.0 * s * s * t * control[1] + 3.0 * s * t * t * control[2] +
                t * t * t * control[3]);
  };
  splines_detail::chords(at, 0.0, control[0], 1.0, control[3], tolerance, 0, out);
}

std::vector<double> uniformKnots(std::size_t points, int order) {
  std::vector<double> knots;
  const int inner = static_cast<int>(points) - order;
  for (int k = 0; k < order; ++k) knots.push_back(0.0);
  for (int k = 1; k <= inner; ++k) knots.push_back(k);
  for (int k = 0; k < order; ++k) knots.push_back(inner + 1);
  return knots;
}

Vec2 nurbsPoint(const std::vector<Vec3>& points, const std::vector<double>& knots, int order, double t) {
  const auto degree = static_cast<std::size_t>(order - 1);
  std::size_t span = degree;
  while (span + 1 < points.size() && t >= knots[span + 1]) ++span;
  std::vector<Vec3> d;
  for (std::size_t k = 0; k <= degree; ++k) {
    const Vec3& p = points[span - degree + k];
    d.push_back({p.x() * p.z(), p.y() * p.z(), p.z()});
  }
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t k = degree; k >= r; --k) {
      const double low = knots[span - degree + k], high = knots[span + 1 + k - r];
      const double a = high > low ? (t - low) / (high - low) : 0.0;
      d[k] = (1.0 - a) * d[k - 1] + a * d[k];
    }
  }
  return {d[degree].x() / d[degree].z(), d[degree].y() / d[degree].z()};
}

bool appendNurbs(const std::vector<Vec3>& points, const std::vector<double>& knots, int order,
                 double tolerance, std::vector<Vec2>& out) {
  const bool counts = order >= 2 && points.size() >= static_cast<std::size_t>(order) &&
                      knots.size() == points.size() + static_cast<std::size_t>(order);
  if (!counts || !std::is_sorted(knots.begin(), knots.end())) return false;
  const auto at = [&](double t) { return nurbsPoint(points, knots, order, t); };
  const auto first = static_cast<std::size_t>(order - 1);
  if (!(knots[points.size()] > knots[first])) return false;
  for (std::size_t k = first; k < points.size(); ++k) {
    if (!(knots[k + 1] > knots[k])) continue;
    splines_detail::chords(at, knots[k], at(knots[k]), knots[k + 1], at(knots[k + 1]), tolerance, 0, out);
  }
  return true;
}

}  // namespace proveout
