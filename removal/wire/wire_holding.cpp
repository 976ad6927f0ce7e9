#include "removal/wire/wire_holding.h"

#include <algorithm>
#include <utility>

#include "core/geometry/plane.h"
#include "removal/wire/face_triangles.h"
#include "removal/wire/fixture_solid.h"

namespace proveout {
namespace {

/// Of the chords of a body, mm.
constexpr double kBodyChordMm = 1e-3;

Box3 boxOf(const std::vector<Vec2>& polygon) {
  Box3 box;
  for (const Vec2& p : polygon) box.extend(Vec3(p.x(), p.y(), 0.0));
  return box;
}

bool crosses(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c_side = cross2(b - a, c - a), d_side = cross2(b - a, d - a);
  const double a_side = cross2(d - c, a - c), b_side = cross2(d - c, b - c);
  return c_side * d_side < 0.0 && a_side * b_side < 0.0;
}

bool comeNear(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (crosses(a, b, c, d)) return true;
  const double least = std::min({distanceToSegment(a, c, d), distanceToSegment(b, c, d),
                                 distanceToSegment(c, a, b), distanceToSegment(d, a, b)});
  return least <= kHeldWithinMm;
}

bool bordersMeet(const std::vector<Vec2>& polygon, const std::vector<Vec2>& loop) {
  const Box3 box = boxOf(polygon).inflated(kHeldWithinMm);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &c = loop[i], &d = loop[(i + 1) % loop.size()];
    if (!boxOf({c, d}).overlaps(box)) continue;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      if (comeNear(polygon[k], polygon[(k + 1) % polygon.size()], c, d)) return true;
    }
  }
  return false;
}

bool touchesRegion(const std::vector<Vec2>& polygon, const PlanePolygons& region) {
  if (holds(region, polygon.front())) return true;
  return std::any_of(region.begin(), region.end(), [&](const std::vector<Vec2>& loop) {
    return surrounds(polygon, loop.front()) || bordersMeet(polygon, loop);
  });
}

std::vector<Vec2> middlesOf(const PlanePolygons& region) {
  std::vector<Vec2> points;
  for (const std::vector<Vec2>& loop : region) points.insert(points.end(), loop.begin(), loop.end());
  std::vector<std::pair<double, Vec2>> found;  // with twice the area
  for (const auto& [a, b, c] : faceTriangles(region))
    found.emplace_back(cross2(points[b] - points[a], points[c] - points[a]),
                       (points[a] + points[b] + points[c]) / 3.0);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& x, const auto& y) { return x.first > y.first; });
  std::vector<Vec2> out;
  for (const auto& middle : found) out.push_back(middle.second);
  return out;
}

}  // namespace

PlanePolygons polygonsOf(const std::vector<PlaneLoop>& loops, double tolerance_mm) {
  PlanePolygons out;
  for (const PlaneLoop& loop : loops) out.push_back(chordsOf(loop, tolerance_mm).points);
  return out;
}

bool holds(const PlanePolygons& region, const Vec2& p) {
  const auto around = [&](const std::vector<Vec2>& polygon) { return surrounds(polygon, p); };
  return std::count_if(region.begin(), region.end(), around) % 2 == 1;
}

std::vector<Vec2> placesIn(const std::vector<Vec2>& polygon) { return middlesOf({polygon}); }

Vec2 placeIn(const PlaneBody& body) { return middlesOf(polygonsOf(body.loops, kBodyChordMm)).front(); }

std::size_t heldBody(const std::vector<PlaneBody>& bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::vector<PlaneEdge>& border = bodies[k].loops.front().edges;
    if (std::any_of(border.begin(), border.end(), [](const PlaneEdge& e) { return e.motion == kNoMotion; }))
      return k;
  }
  return 0;
}

bool anyTouches(const PlanePolygons& fixtures, const PlanePolygons& region) {
  Box3 reach;
  for (const std::vector<Vec2>& loop : region) reach.extend(boxOf(loop));
  reach = reach.inflated(kHeldWithinMm);
  return std::any_of(fixtures.begin(), fixtures.end(), [&](const std::vector<Vec2>& polygon) {
    return boxOf(polygon).overlaps(reach) && touchesRegion(polygon, region);
  });
}

WireHolding::WireHolding(PlanePolygons fixtures, const std::vector<PlaneBody>& last)
    : fixtures_(std::move(fixtures)) {
  settle(last);
}

WireHolding::WireHolding(PlanePolygons fixtures, std::function<std::vector<PlaneBody>()> last)
    : fixtures_(std::move(fixtures)), last_(std::move(last)) {}

void WireHolding::settle(const std::vector<PlaneBody>& last) const {
  by_fixtures_ = std::any_of(last.begin(), last.end(), [&](const PlaneBody& body) { return touched(body); });
  if (!by_fixtures_ && !last.empty()) held_ = placeIn(last[heldBody(last)]);
}

void WireHolding::settle() const {
  if (last_) settle(std::exchange(last_, nullptr)());
}

bool WireHolding::touched(const PlaneBody& body) const {
  return !fixtures_.empty() && anyTouches(fixtures_, polygonsOf(body.loops, kBodyChordMm));
}

bool WireHolding::byFixtures() const {
  settle();
  return by_fixtures_;
}

bool WireHolding::keeps(const PlaneBody& body) const {
  settle();
  if (by_fixtures_) return touched(body);
  return held_ && holds(polygonsOf(body.loops, kBodyChordMm), *held_);
}

}  // namespace proveout
