#include "removal/wire/falls/wire_holding.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "removal/wire/falls/fixture_solid.h"
#include "removal/wire/section/edge_curves.h"
#include "removal/wire/section/face_triangles.h"
#include "removal/wire/section/kerf_section.h"

namespace proveout {
namespace {

/// Of the chords of a body, mm.
constexpr double kBodyChordMm = 1e-3;
/// At so many values of y a point well inside of a region is searched for.
constexpr int kScanLines = 7;

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

/// The middle of the widest stretch of a region along a line of constant y.
std::optional<Vec2> widestAt(const PlanePolygons& region, double y) {
  std::vector<double> crossings;
  for (const std::vector<Vec2>& loop : region) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a.y() > y) != (b.y() > y))
        crossings.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::optional<Vec2> middle;
  double widest = 0.0;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const double width = crossings[k + 1] - crossings[k];
    if (width <= widest) continue;
    widest = width;
    middle = Vec2(crossings[k] + 0.5 * width, y);
  }
  return middle;
}

/// Bodies that have some of the blank's outer border.
std::vector<PlaneBody> bodiesAtBorder(const std::vector<PlaneLoop>& blank,
                                      const std::vector<PlaneBody>& bodies) {
  std::vector<PlaneLoop> outer;
  std::copy_if(blank.begin(), blank.end(), std::back_inserter(outer),
               [](const PlaneLoop& loop) { return areaOf(loop) > 0.0; });
  const std::vector<WireStretch> borders = wire_detail::sidesOf(outer);
  const auto isOuter = [&](const WireStretch& side) {
    return side.motion == kNoMotion &&
           std::any_of(borders.begin(), borders.end(), [&](const WireStretch& border) {
             return distanceTo(border, side.at(0.5)).mm <= kBodyChordMm;
           });
  };
  std::vector<PlaneBody> out;
  std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(out), [&](const PlaneBody& body) {
    const std::vector<WireStretch> sides = wire_detail::sidesOf({body.loops.front()});
    return std::any_of(sides.begin(), sides.end(), isOuter);
  });
  return out;
}

/// What is left at a time.
class CutsInTime {
 public:
  CutsInTime(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts)
      : blank_(blank), cuts_(cuts) {
    for (const PlaneLoop& loop : blank) box_.extend(boundsOf(loop));
  }

  /// Of some places those that lie in the largest body then.
  std::vector<Vec2> largestOf(const std::vector<Vec2>& places, const CutTime& time) const {
    std::vector<Vec2> best;
    double largest = 0.0;
    for (const PlanePolygons& region : regionsInside(box_.inflated(1.0), blank_, cutUntil(cuts_, time))) {
      double area = 0.0;
      for (const std::vector<Vec2>& loop : region) area += polygonArea(loop);
      if (area <= largest) continue;
      std::vector<Vec2> in;
      std::copy_if(places.begin(), places.end(), std::back_inserter(in),
                   [&](const Vec2& p) { return holds(region, p); });
      if (in.empty()) continue;
      best = std::move(in);
      largest = area;
    }
    return best;
  }

 private:
  const std::vector<PlaneLoop>& blank_;
  const std::vector<WireStretch>& cuts_;
  Box3 box_;
};

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

double borderDistance(const PlanePolygons& region, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& loop : region) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      least = std::min(least, distanceToSegment(p, loop[i], loop[(i + 1) % loop.size()]));
  }
  return least;
}

bool holds(const PlanePolygons& region, const Vec2& p) {
  const auto around = [&](const std::vector<Vec2>& polygon) { return surrounds(polygon, p); };
  return std::count_if(region.begin(), region.end(), around) % 2 == 1;
}

std::vector<Vec2> placesIn(const std::vector<Vec2>& polygon) { return middlesOf({polygon}); }

Vec2 placeIn(const PlaneBody& body) { return placeIn(polygonsOf(body.loops, kBodyChordMm)); }

Vec2 placeIn(const PlanePolygons& region) {
  PROVEOUT_ASSERT(!region.empty() && !region.front().empty());
  Box3 box;
  for (const std::vector<Vec2>& loop : region) {
    for (const Vec2& p : loop) box.extend(Vec3(p.x(), p.y(), 0.0));
  }
  Vec2 best = region.front().front();
  double farthest = -1.0;
  for (int k = 1; k <= kScanLines; ++k) {
    const double y = box.min.y() + box.size().y() * k / (kScanLines + 1.0);
    const std::optional<Vec2> middle = widestAt(region, y);
    if (!middle) continue;
    const double off = borderDistance(region, *middle);
    if (off <= farthest) continue;
    farthest = off;
    best = *middle;
  }
  return best;
}

Vec2 heldPlace(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
               const std::vector<PlaneBody>& last) {
  PROVEOUT_ASSERT(!last.empty());
  std::vector<Vec2> places;
  for (const PlaneBody& body : bodiesAtBorder(blank, last)) places.push_back(placeIn(body));
  if (places.empty()) return placeIn(last.front());
  const CutsInTime in_time(blank, cuts);
  const CutTime end{static_cast<std::uint32_t>(cuts.size()), 0.0};
  CutTime together;
  while (places.size() > 1 && together < end) {
    const CutTime apart = firstTime(cuts, together, end, [&](const CutTime& at) {
      return in_time.largestOf(places, at).size() < places.size();
    });
    std::vector<Vec2> stays = in_time.largestOf(places, apart);
    if (stays.empty() || stays.size() == places.size()) break;
    places = std::move(stays);
    together = apart;
  }
  return places.front();
}

bool anyTouches(const PlanePolygons& fixtures, const PlanePolygons& region) {
  Box3 reach;
  for (const std::vector<Vec2>& loop : region) reach.extend(boxOf(loop));
  reach = reach.inflated(kHeldWithinMm);
  return std::any_of(fixtures.begin(), fixtures.end(), [&](const std::vector<Vec2>& polygon) {
    return boxOf(polygon).overlaps(reach) && touchesRegion(polygon, region);
  });
}

WireHolding::WireHolding(PlanePolygons fixtures, const std::vector<PlaneLoop>& blank,
                         const std::vector<WireStretch>& cuts, const std::vector<PlaneBody>& last)
    : fixtures_(std::move(fixtures)) {
  settle(blank, cuts, last);
}

WireHolding::WireHolding(PlanePolygons fixtures, const std::vector<PlaneLoop>& blank,
                         const std::vector<WireStretch>& cuts, std::function<std::vector<PlaneBody>()> last)
    : fixtures_(std::move(fixtures)), blank_(&blank), cuts_(&cuts), last_(std::move(last)) {}

void WireHolding::settle(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& cuts,
                         const std::vector<PlaneBody>& last) const {
  by_fixtures_ = std::any_of(last.begin(), last.end(), [&](const PlaneBody& body) { return touched(body); });
  if (!by_fixtures_ && !last.empty()) held_ = heldPlace(blank, cuts, last);
}

void WireHolding::settle() const {
  if (last_) settle(*blank_, *cuts_, std::exchange(last_, nullptr)());
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
