#include "removal/wire/section/segment_meetings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/plane.h"
#include "removal/wire/section/order_tree.h"

namespace proveout {
namespace {

/// Twice an area of less than this share of what its sides span is rounding.
constexpr double kFlat = 1e-15;

/// Twice the area of a triangle, 0 within rounding.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  const double twice = cross2(u, v);
  const double spanned = u.cwiseAbs().sum() * v.cwiseAbs().sum();
  return std::abs(twice) <= kFlat * spanned ? 0.0 : twice;
}

/// Two edges with a common corner: whether the shorter one lies on the other.
bool folded(const Vec2& corner, const Vec2& p, const Vec2& q) {
  return turn(corner, p, q) == 0.0 && (p - corner).dot(q - corner) > 0.0;
}

bool meet(const PlaneSegment& s, const PlaneSegment& t) {
  if (s.end == t.start && s.start == t.end) return true;
  if (s.end == t.start) return folded(s.to, s.from, t.to);
  if (s.start == t.end) return folded(s.from, s.to, t.from);
  if (s.start == t.start) return folded(s.from, s.to, t.to);
  if (s.end == t.end) return folded(s.to, s.from, t.from);
  return turn(s.from, s.to, t.from) * turn(s.from, s.to, t.to) <= 0.0 &&
         turn(t.from, t.to, s.from) * turn(t.from, t.to, s.to) <= 0.0;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> meetingSegments(const std::vector<PlaneSegment>& segments) {
  std::vector<Box3> boxes(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const Vec2& p : {segments[i].from, segments[i].to}) boxes[i].extend(Vec3(p.x(), p.y(), 0.0));
  }
  std::vector<std::array<std::uint32_t, 2>> found;
  OrderTree(std::move(boxes)).eachPair([&](std::size_t i, std::size_t k) {
    if (i != k && meet(segments[i], segments[k]))
      found.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)});
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace proveout
