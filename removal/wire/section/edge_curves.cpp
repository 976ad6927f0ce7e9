#include "removal/wire/section/edge_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/plane.h"

namespace proveout::wire_detail {
namespace {

/// An edge deviates from its curve by its chord height and by rounding; the search reaches somewhat farther,
/// mm.
constexpr double kReach = 3e-4;
/// Corners that rounding or chords have moved are put back by no more than a part of the edges beside them,
/// mm.
constexpr double kMostShift = 5e-3, kShareOfEdge = 0.25, kRounding = 3e-6;
/// A name has the number of the stretch above these bits.
constexpr int kNameBits = 4;
constexpr std::uint64_t kBlankName = std::uint64_t{1} << 63;

/// Where two curves meet, the nearest to p; where they only touch, the middle between them.
std::optional<Vec2> meetingPoint(const EdgeCurve& a, const EdgeCurve& b, const Vec2& p) {
  if (!a.circle && !b.circle) {
    const double cross = cross2(a.along, b.along);
    if (std::abs(cross) < 1e-9) return std::nullopt;
    return a.at + a.along * (cross2(b.at - a.at, b.along) / cross);
  }
  if (!a.circle) return meetingPoint(b, a, p);
  // The points of circle a on the line: b itself, or that through the points where both circles meet.
  Vec2 foot, along;
  if (!b.circle) {
    foot = b.nearest(a.at);
    along = b.along;
  } else {
    const Vec2 d = b.at - a.at;
    const double length2 = d.squaredNorm();
    if (length2 < 1e-16) return std::nullopt;
    foot = a.at + d * (0.5 * (1.0 + (a.radius * a.radius - b.radius * b.radius) / length2));
    along = leftOf(d) / std::sqrt(length2);
  }
  const double half2 = a.radius * a.radius - (foot - a.at).squaredNorm();
  if (half2 < -2e-6 * a.radius) return std::nullopt;
  const double half = half2 > 1e-12 ? std::sqrt(half2) : 0.0;
  const Vec2 first = foot + half * along, second = foot - half * along;
  return (first - p).squaredNorm() < (second - p).squaredNorm() ? first : second;
}

/// A run of polygon edges on one curve: from points[first] on, `count` edges.
struct Run {
  std::size_t first, count;
};

std::vector<Run> runsOf(const std::vector<EdgeCurve>& curves) {
  const std::size_t n = curves.size();
  std::size_t start = 0;
  while (start < n && curves[start].name == curves[(start + n - 1) % n].name) ++start;
  if (start == n) return {{0, n}};
  std::vector<Run> runs;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k == 0 || curves[i].name != curves[(i + n - 1) % n].name)
      runs.push_back({i, 1});
    else
      ++runs.back().count;
  }
  return runs;
}

double angleBetween(const Vec2& u, const Vec2& v) { return std::atan2(cross2(u, v), u.dot(v)); }

/// About the center of a curve, from the first point of a run to its last, with corners in place of both.
double sweepOf(const std::vector<Vec2>& points, const Run& run, const Vec2& center, const Vec2& from,
               const Vec2& to) {
  const std::size_t n = points.size();
  double sweep = 0.0;
  Vec2 before = from - center;
  for (std::size_t k = 1; k <= run.count; ++k) {
    const Vec2 at = (k == run.count ? to : points[(run.first + k) % n]) - center;
    sweep += angleBetween(before, at);
    before = at;
  }
  return sweep;
}

}  // namespace

std::vector<WireStretch> sidesOf(const std::vector<PlaneLoop>& loops) {
  std::vector<WireStretch> sides;
  for (const PlaneLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
      const PlaneEdge& edge = loop.edges[i];
      WireStretch side;
      side.from = edge.from;
      side.to = loop.edges[(i + 1) % loop.edges.size()].from;
      side.center = edge.center;
      side.sweep_rad = edge.sweep_rad;
      side.motion = edge.motion;
      sides.push_back(side);
    }
  }
  return sides;
}

double EdgeCurve::distance(const Vec2& p) const {
  return circle ? std::abs((p - at).norm() - radius) : std::abs(cross2(along, p - at));
}

Vec2 EdgeCurve::nearest(const Vec2& p) const {
  if (!circle) return at + along * along.dot(p - at);
  const Vec2 d = p - at;
  const double length = d.norm();
  return length > 0.0 ? Vec2(at + d * (radius / length)) : p;
}

CurveFinder::CurveFinder(const std::vector<PlaneLoop>& blank, const std::vector<WireStretch>& stretches)
    : stretches_(stretches), kerf_(stretches), sides_(sidesOf(blank)), blank_(sides_) {}

std::optional<EdgeCurve> CurveFinder::ofBlank(const Vec2& p, double reach) const {
  const StretchIndex::Found found = blank_.nearest(p, reach);
  if (found.stretch == StretchIndex::kNone) return std::nullopt;
  const WireStretch& side = sides_[found.stretch];
  EdgeCurve curve;
  curve.circle = side.isArc();
  curve.at = curve.circle ? side.center : side.from;
  curve.along = side.directionAtStart();
  curve.radius = curve.circle ? side.radius() : 0.0;
  curve.name = kBlankName | found.stretch;
  curve.motion = side.motion;
  return curve;
}

std::optional<EdgeCurve> CurveFinder::ofKerf(const Vec2& p, double reach) const {
  const StretchIndex::Found found = kerf_.nearest(p, reach);
  if (found.stretch == StretchIndex::kNone) return std::nullopt;
  const WireStretch& s = stretches_[found.stretch];
  EdgeCurve curve;
  curve.motion = s.motion;
  bool outside = false;
  if (found.part != StretchPart::kMiddle) {
    curve.circle = true;
    curve.at = found.part == StretchPart::kFrom ? s.from : s.to;
    curve.radius = s.kerf_mm;
  } else if (s.isArc()) {
    outside = (p - s.center).norm() > s.radius();
    curve.circle = true;
    curve.at = s.center;
    curve.radius = std::abs(s.radius() + (outside ? s.kerf_mm : -s.kerf_mm));
  } else {
    curve.along = s.directionAtStart();
    outside = cross2(curve.along, p - s.from) > 0.0;
    curve.at = s.from + leftOf(curve.along) * (outside ? s.kerf_mm : -s.kerf_mm);
  }
  curve.name = (std::uint64_t{found.stretch} << kNameBits) | (static_cast<std::uint64_t>(found.part) << 1) |
               (outside ? 1u : 0u);
  return curve;
}

EdgeCurve CurveFinder::of(const Vec2& middle) const {
  for (double reach = kReach;; reach *= 16.0) {
    const std::optional<EdgeCurve> old = ofBlank(middle, reach), cut = ofKerf(middle, reach);
    if (old && (!cut || old->distance(middle) <= cut->distance(middle))) return *old;
    if (cut) return *cut;
    PROVEOUT_ASSERT(reach < 1e9);
  }
}

PlaneLoop curvedLoop(const std::vector<Vec2>& points, const std::vector<EdgeCurve>& curves) {
  PROVEOUT_ASSERT(!points.empty() && curves.size() == points.size());
  const std::size_t n = points.size();
  const std::vector<Run> runs = runsOf(curves);
  PlaneLoop loop;
  const auto chord = [&](const Run& run) {
    if (runs.size() == 1) return 0.0;
    return (points[(run.first + run.count) % n] - points[run.first]).norm();
  };
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run &run = runs[r], &before = runs[(r + runs.size() - 1) % runs.size()];
    const EdgeCurve& curve = curves[run.first];
    PlaneEdge edge;
    edge.from = points[run.first];
    edge.motion = curve.motion;
    if (runs.size() == 1) {
      edge.from = curve.nearest(edge.from);
    } else if (const auto corner = meetingPoint(curves[before.first], curve, edge.from)) {
      const double most =
          std::min(kMostShift, kShareOfEdge * std::min(chord(run), chord(before)) + kRounding);
      if ((*corner - edge.from).norm() <= most) edge.from = *corner;
    }
    loop.edges.push_back(edge);
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const EdgeCurve& curve = curves[runs[r].first];
    if (!curve.circle) continue;
    const Vec2 &from = loop.edges[r].from, &to = loop.edges[(r + 1) % runs.size()].from;
    loop.edges[r].center = curve.at;
    loop.edges[r].sweep_rad = sweepOf(points, runs[r], curve.at, from, to);
  }
  return loop;
}

}  // namespace proveout::wire_detail
