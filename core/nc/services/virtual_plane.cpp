#include "core/nc/services/virtual_plane.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace proveout {
namespace {

/// Pieces of a turn in which an arc is followed about the origin.
constexpr int kPiecesPerTurn = 512;
/// Halvings of a piece before a chord is taken as it is.
constexpr int kMaxDepth = 16;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Divider {
  const std::function<Vec3(double)>& at;
  double tolerance;
  const std::function<void(double)>& tell;

  void divide(double t0, const Vec3& p0, double t1, const Vec3& p1, int depth) const {
    const double middle = 0.5 * (t0 + t1);
    const Vec3 p = at(middle);
    if (depth < kMaxDepth && !((p - 0.5 * (p0 + p1)).norm() <= tolerance)) {
      divide(t0, p0, middle, p, depth + 1);
      divide(middle, p, t1, p1, depth + 1);
    } else {
      tell(t1);
    }
  }
};

}  // namespace

double turnOfLine(const Vec2& from, const Vec2& to) {
  const double across = cross(from, to), along = from.dot(to);
  if (along < 0.0 && std::abs(across) <= 1e-12 * -along) return kPi;
  return std::atan2(across, along);
}

Vec2 pointOfArc(const Vec2& from, const Vec2& to, const Vec2& center, double sweep, double t) {
  const Vec2 start = from - center;
  const double r0 = start.norm(), r1 = (to - center).norm();
  const double a = std::atan2(start.y(), start.x()) + sweep * t;
  const double r = r0 + (r1 - r0) * t;
  return center + r * Vec2(std::cos(a), std::sin(a));
}

double turnOfArc(const Vec2& from, const Vec2& to, const Vec2& center, double sweep) {
  const double turns = std::abs(sweep) / (2.0 * kPi);
  const int pieces = std::max(8, static_cast<int>(std::ceil(kPiecesPerTurn * std::min(turns, 1e4))));
  double sum = 0.0;
  Vec2 last = from;
  for (int k = 1; k <= pieces; ++k) {
    const Vec2 p = k == pieces ? to : pointOfArc(from, to, center, sweep, static_cast<double>(k) / pieces);
    sum += turnOfLine(last, p);
    last = p;
  }
  return sum;
}

double polarLineMinutes(const Vec2& from, const Vec2& to, double feed, double turn_rate) {
  const Vec2 way = to - from;
  const double length = way.norm();
  if (!(length > 0.0)) return 0.0;
  if (!(turn_rate > 0.0)) return length / feed;
  const Vec2 along = way / length;
  const double distance = std::abs(cross(from, along));
  // The axis turns at feed * distance / r^2: too fast where |s| < reach, s counted from the foot of the
  // perpendicular.
  const double reach2 = feed * distance / turn_rate - distance * distance;
  const double s0 = from.dot(along), s1 = to.dot(along);
  if (!(reach2 > 0.0)) {
    const bool through = distance == 0.0 && s0 < 0.0 && s1 > 0.0;  // half a turn on the spot
    return length / feed + (through ? kPi / turn_rate : 0.0);
  }
  const double reach = std::sqrt(reach2);
  const double slow0 = std::clamp(s0, -reach, reach), slow1 = std::clamp(s1, -reach, reach);
  const double turned = std::atan2(slow1, distance) - std::atan2(slow0, distance);
  return (length - (slow1 - slow0)) / feed + turned / turn_rate;
}

void divideCurve(const std::function<Vec3(double)>& at, int pieces, double tolerance,
                 const std::function<void(double)>& tell) {
  PROVEOUT_ASSERT(pieces >= 1 && tolerance > 0.0);
  const Divider divider{at, tolerance, tell};
  Vec3 last = at(0.0);
  for (int k = 0; k < pieces; ++k) {
    const double t0 = static_cast<double>(k) / pieces, t1 = static_cast<double>(k + 1) / pieces;
    const Vec3 next = at(t1);
    divider.divide(t0, last, t1, next, 0);
    last = next;
  }
}

}  // namespace proveout
