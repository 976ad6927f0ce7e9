#include "removal/wire/section/plane_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/plane.h"
#include "core/geometry/to_float.h"

namespace proveout {
namespace {

const Vec2& endOf(const PlaneLoop& loop, std::size_t i) {
  return loop.edges[i + 1 < loop.edges.size() ? i + 1 : 0].from;
}

/// Between an arc and its chord.
double segmentArea(const PlaneEdge& edge, const Vec2& to) {
  const double radius = 0.5 * ((edge.from - edge.center).norm() + (to - edge.center).norm());
  return 0.5 * radius * radius * (edge.sweep_rad - std::sin(edge.sweep_rad));
}

/// Whether the direction from the center is passed between the ends of an arc.
bool passes(const PlaneEdge& edge, const Vec2& direction) {
  const Vec2 start = edge.from - edge.center;
  double angle = std::atan2(cross2(start, direction), start.dot(direction));
  if (edge.sweep_rad < 0.0) angle = -angle;
  if (angle < 0.0) angle += 2.0 * kPi;
  return angle <= std::abs(edge.sweep_rad);
}

/// Whether a polygon goes back at p, between a and b, on its way there.
bool goesBack(const Vec2& a, const Vec2& p, const Vec2& b) {
  const Vec2 u = a - p, v = b - p;
  if (u.dot(v) <= 0.0) return false;
  const bool back_is_shorter = v.squaredNorm() < u.squaredNorm();
  return distanceToSegment(back_is_shorter ? b : a, p, back_is_shorter ? a : b) <= meshStep(p);
}

}  // namespace

Vec2 asFloat(const Vec2& p) { return toFloat(p).cast<double>(); }

double meshStep(const Vec2& p) {
  constexpr float kSteps = 4.0f;
  constexpr double kLeast = 4e-6;
  const float size = toFloat(p.cwiseAbs().maxCoeff());
  const float step = std::nextafter(size, std::numeric_limits<float>::infinity()) - size;
  return std::max(kLeast, static_cast<double>(kSteps * step));
}

std::vector<KeptCorner> meshCorners(const std::vector<Vec2>& polygon) {
  std::vector<KeptCorner> corners(polygon.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = {i, i};
  // `sound` corners before this one are so with their neighbours.
  for (std::size_t at = 0, sound = 0; sound < corners.size() && corners.size() > 2;) {
    const std::size_t n = corners.size(), before = (at + n - 1) % n, behind = (at + 1) % n;
    const Vec2 &a = polygon[corners[before].point], &p = polygon[corners[at].point],
               &b = polygon[corners[behind].point];
    if (!goesBack(a, p, b) && (b - p).norm() > meshStep(p)) {
      at = behind;
      ++sound;
      continue;
    }
    if ((b - p).squaredNorm() > (a - p).squaredNorm()) corners[before].edge = corners[at].edge;
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(at));
    at = at == 0 ? n - 2 : at - 1;
    sound -= std::min<std::size_t>(sound, 1);
  }
  return corners;
}

Vec2 turnedBy(const Vec2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

int chordCount(double radius_mm, double sweep_rad, double tolerance_mm) {
  const double sagitta = std::min(1.0, tolerance_mm / std::max(radius_mm, 1e-12));
  const double step = std::min(2.0 * std::acos(1.0 - sagitta), 0.5 * kPi);
  return std::max(1, static_cast<int>(std::ceil(std::abs(sweep_rad) / step - 1e-9)));
}

PlaneLoop circleLoop(const Vec2& center, double radius_mm, bool hollow) {
  PlaneLoop loop;
  loop.edges.push_back({center + Vec2(radius_mm, 0.0), center, hollow ? -2.0 * kPi : 2.0 * kPi, kNoMotion});
  return loop;
}

PlaneLoop rectangleLoop(const Vec2& min, const Vec2& max) {
  PlaneLoop loop;
  for (const Vec2& corner : {min, Vec2(max.x(), min.y()), max, Vec2(min.x(), max.y())})
    loop.edges.push_back({corner, Vec2::Zero(), 0.0, kNoMotion});
  return loop;
}

double areaOf(const PlaneLoop& loop) {
  if (loop.edges.empty()) return 0.0;
  // About the first corner, so that a small loop far from the origin loses no digits.
  const Vec2 origin = loop.edges.front().from;
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    const Vec2 &from = loop.edges[i].from, &to = endOf(loop, i);
    sum += 0.5 * cross2(from - origin, to - origin);
    if (loop.edges[i].sweep_rad != 0.0) sum += segmentArea(loop.edges[i], to);
  }
  return sum;
}

double areaOf(const std::vector<PlaneLoop>& loops) {
  double sum = 0.0;
  for (const PlaneLoop& loop : loops) sum += areaOf(loop);
  return sum;
}

ChordLoop chordsOf(const PlaneLoop& loop, double tolerance) {
  ChordLoop out;
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    const PlaneEdge& edge = loop.edges[i];
    out.points.push_back(edge.from);
    out.edge.push_back(static_cast<std::uint32_t>(i));
    if (edge.sweep_rad == 0.0) continue;
    const Vec2 start = edge.from - edge.center;
    const double first = start.norm(), last = (endOf(loop, i) - edge.center).norm();
    const int count = chordCount(std::max(first, last), edge.sweep_rad, tolerance);
    for (int k = 1; k < count; ++k) {
      const double t = static_cast<double>(k) / count, radius = first + t * (last - first);
      out.points.emplace_back(edge.center + turnedBy(start, t * edge.sweep_rad) * (radius / first));
      out.edge.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return out;
}

bool surrounds(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (p.x() < x) inside = !inside;
  }
  return inside;
}

Box3 boundsOf(const PlaneLoop& loop) {
  Box3 box;
  for (const PlaneEdge& edge : loop.edges) {
    box.extend(Vec3(edge.from.x(), edge.from.y(), 0.0));
    if (edge.sweep_rad == 0.0) continue;
    const double radius = (edge.from - edge.center).norm();
    for (const Vec2& side : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
      if (!passes(edge, side)) continue;
      const Vec2 at = edge.center + radius * side;
      box.extend(Vec3(at.x(), at.y(), 0.0));
    }
  }
  return box;
}

}  // namespace proveout
