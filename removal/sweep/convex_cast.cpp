// Method: the solid meets the triangle at t where t (to - from) lies in the difference of both, a convex set
// that is known by its furthest points. A ray is clipped by planes that hold the set, found by the nearest
// point of a growing simplex in it (Gilbert, Johnson and Keerthi; van den Bergen for the ray).
#include "removal/sweep/convex_cast.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"

namespace proveout {
namespace {

/// This near to the set counts as in it, mm.
constexpr double kTouchMm = 1e-7;
/// Weights of corners of a simplex below this are none.
constexpr double kNoWeight = 1e-12;
constexpr int kMaxRounds = 200;

struct Simplex {
  std::array<Vec3, 4> p;
  int count = 0;
};

/// Weights of the corners in `mask` for the point of their plane (line, point) nearest to `x`; false where
/// one is not above 0 or the corners are dependent.
bool weightsOf(const Simplex& s, unsigned mask, const Vec3& x, std::array<double, 4>& weights) {
  std::array<int, 4> corner{};
  int count = 0;
  for (int k = 0; k < s.count; ++k) {
    if (mask >> k & 1u) corner[static_cast<std::size_t>(count++)] = k;
  }
  const Vec3 base = s.p[static_cast<std::size_t>(corner[0])];
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, count - 1);
  for (int k = 1; k < count; ++k)
    edges.col(k - 1) = s.p[static_cast<std::size_t>(corner[static_cast<std::size_t>(k)])] - base;
  weights.fill(0.0);
  double rest = 1.0;
  if (count > 1) {
    const auto qr = edges.colPivHouseholderQr();
    if (qr.rank() < count - 1) return false;
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> solved = qr.solve(x - base);
    for (int k = 1; k < count; ++k) {
      const double w = solved[k - 1];
      if (!(w > kNoWeight)) return false;
      weights[static_cast<std::size_t>(corner[static_cast<std::size_t>(k)])] = w;
      rest -= w;
    }
  }
  weights[static_cast<std::size_t>(corner[0])] = rest;
  return rest > kNoWeight;
}

/// The point of the simplex nearest to `x`; keeps only the corners that it needs.
Vec3 nearest(Simplex& s, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  unsigned kept = 1;
  Vec3 best = s.p[0];
  for (unsigned mask = 1; mask < 1u << s.count; ++mask) {
    std::array<double, 4> weights;
    if (!weightsOf(s, mask, x, weights)) continue;
    Vec3 q = Vec3::Zero();
    for (int k = 0; k < s.count; ++k)
      q += weights[static_cast<std::size_t>(k)] * s.p[static_cast<std::size_t>(k)];
    const double d = (x - q).squaredNorm();
    if (!(d < least)) continue;
    least = d;
    kept = mask;
    best = q;
  }
  int count = 0;
  for (int k = 0; k < s.count; ++k) {
    if (kept >> k & 1u) s.p[static_cast<std::size_t>(count++)] = s.p[static_cast<std::size_t>(k)];
  }
  s.count = count;
  return best;
}

Vec3 furthestOf(const Triangle& t, const Vec3& direction) {
  const double a = t[0].dot(direction), b = t[1].dot(direction), c = t[2].dot(direction);
  return a >= b && a >= c ? t[0] : b >= c ? t[1] : t[2];
}

}  // namespace

Vec3 furthestPoint(const ConvexProfile& profile, const Vec3& direction) {
  const double across = direction.head<2>().norm(), up = direction.z();
  const double norm = std::hypot(across, up);
  double most = -std::numeric_limits<double>::infinity(), r = 0.0, z = 0.0;
  const auto take = [&](double pr, double pz) {
    const double value = across * pr + up * pz;
    if (value > most) {
      most = value;
      r = pr;
      z = pz;
    }
  };
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    take(e.ar, e.az);
    take(e.br, e.bz);
    if (!e.arc || !(norm > 0.0)) continue;
    const double pr = e.radius * across / norm, pz = e.radius * up / norm;
    const bool behind_a = (e.ar - e.cr) * pz - (e.az - e.cz) * pr >= 0.0;
    const bool before_b = pr * (e.bz - e.cz) - pz * (e.br - e.cr) >= 0.0;
    if (behind_a && before_b) take(e.cr + pr, e.cz + pz);
  }
  if (!(across > 0.0)) return {r, 0.0, z};
  return {r * direction.x() / across, r * direction.y() / across, z};
}

std::optional<double> castAgainst(const ConvexProfile& profile, const Vec3& from, const Vec3& to,
                                  const Triangle& triangle, double within) {
  const Vec3 way = to - from;
  const auto furthest = [&](const Vec3& d) -> Vec3 {
    Vec3 p = furthestOf(triangle, d) - from - furthestPoint(profile, -d);
    if (within > 0.0) p += d * (within / d.norm());
    return p;
  };
  double t = 0.0;
  Vec3 x = Vec3::Zero();
  Simplex simplex;
  Vec3 v = x - (triangle[0] - from - furthestPoint(profile, Vec3::UnitZ()));
  for (int round = 0; round < kMaxRounds && v.norm() > kTouchMm; ++round) {
    const Vec3 p = furthest(v);
    const double gap = v.dot(x - p);
    if (gap > 0.0) {
      const double speed = v.dot(way);
      if (speed >= 0.0) return std::nullopt;
      t -= gap / speed;
      if (t > 1.0) return std::nullopt;
      x = t * way;
    }
    // A corner that comes again would only make the simplex flat.
    const bool known = std::any_of(simplex.p.begin(), simplex.p.begin() + simplex.count,
                                   [&](const Vec3& q) { return q == p; });
    PROVEOUT_ASSERT(simplex.count < 4);
    if (!known) simplex.p[static_cast<std::size_t>(simplex.count++)] = p;
    if (known && !(gap > 0.0)) break;
    v = x - nearest(simplex, x);
    if (simplex.count == 4) break;  // in the set
  }
  PROVEOUT_ASSERT_DEAR(t >= 0.0 && t <= 1.0);
  return t;
}

}  // namespace proveout
