#include "removal/turning/section/sweep_paths.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/plane.h"

namespace proveout {

namespace {

constexpr double kQuarter = 0.5 * kPi;
/// Of chords along the way of an arc. They lie on one side of it, so that the volume has all of their error:
/// with those of an outline it was 2e-5 of an arc of radius 20 in a thin layer.
constexpr double kWayChordMm = 0.25 * kSectionChordMm;

Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

void append(SectionPath& path, const std::vector<Vec2>& points, const Vec2& by) {
  for (const Vec2& p : points) path.push_back(p + by);
}

SectionPath wholeOutline(const ConvexOutline& outline, const Vec2& at) {
  std::vector<Vec2> points;
  outline.chain(0.0, 2.0 * kPi, kSectionChordMm, points);
  SectionPath path;
  append(path, points, at);
  return path;
}

/// The hull of the outline at both ends of a line.
SectionPath lineHull(const ConvexOutline& outline, const Vec2& from, const Vec2& to) {
  const double along = std::atan2(to.y() - from.y(), to.x() - from.x());
  std::vector<Vec2> front, back;
  outline.chain(along - kQuarter, along + kQuarter, kSectionChordMm, front);
  outline.chain(along + kQuarter, along + 3.0 * kQuarter, kSectionChordMm, back);
  SectionPath path;
  append(path, front, to);
  append(path, back, from);
  return path;
}

/// Parts of the way in 0..1 at which the outline's supports beside it are looked at: evenly, and where a
/// straight side is parallel to the way.
std::vector<double> arcSamples(const ConvexOutline& outline, const PlaneWay& way) {
  double round = 0.0;
  for (const OutlineSide& side : outline.sides()) round = std::max(round, side.arc ? side.radius : 0.0);
  const double radius = (way.from - way.center).norm() + round, sweep = std::abs(way.sweep_rad);
  const int steps =
      std::max(2, static_cast<int>(std::ceil(sweep / (2.0 * kPi) * circleSteps(radius, kWayChordMm))));
  std::vector<double> samples;
  for (int i = 0; i <= steps; ++i) samples.push_back(static_cast<double>(i) / steps);
  const double start = way.direction(0.0);
  for (const OutlineSide& side : outline.sides()) {
    if (side.arc) continue;
    const Vec2 d = side.to - side.from;
    for (const double parallel : {std::atan2(d.y(), d.x()), std::atan2(-d.y(), -d.x())}) {
      double turn = std::remainder(parallel - start, 2.0 * kPi);
      if (turn * way.sweep_rad < 0.0) turn += std::copysign(2.0 * kPi, way.sweep_rad);
      for (; std::abs(turn) < sweep; turn += std::copysign(2.0 * kPi, way.sweep_rad))
        samples.push_back(turn / way.sweep_rad);
    }
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

/// The strip between the traces of the outline's points farthest to the right and to the left of the way.
/// Parts of it that lie over each other wind in the same sense, so that non-zero winding fills their union: a
/// chord's parallelogram always has its left point on the left, and the wedges between two chords make up for
/// what their parallelograms have too much or too little.
SectionPath arcStrip(const ConvexOutline& outline, const PlaneWay& way) {
  constexpr double kHair = 1e-7;  // rad: both ends of a straight side that is parallel to the way
  SectionPath right, left;
  const double turn = way.sweep_rad > 0.0 ? 1.0 : -1.0;
  for (const double t : arcSamples(outline, way)) {
    const Vec2 at = way.at(t);
    const double along = way.direction(t);
    for (const double hair : {-kHair, kHair}) {
      right.push_back(at + outline.support(along - kQuarter + turn * hair));
      left.push_back(at + outline.support(along + kQuarter + turn * hair));
    }
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return right;
}

}  // namespace

double PlaneWay::direction(double t) const {
  if (!arc) return std::atan2(to.y() - from.y(), to.x() - from.x());
  const Vec2 arm = from - center;
  return std::atan2(arm.y(), arm.x()) + t * sweep_rad + std::copysign(kQuarter, sweep_rad);
}

PlaneWay PlaneWay::mirrored() const {
  PlaneWay way = *this;
  for (Vec2* p : {&way.from, &way.to, &way.center}) p->x() = -p->x();
  way.sweep_rad = -sweep_rad;
  return way;
}

Vec2 PlaneWay::at(double t) const {
  if (!arc) return from + t * (to - from);
  if (t <= 0.0) return from;
  if (t >= 1.0) return to;
  // The radius goes evenly from that of the start to that of the end.
  const Vec2 arm = from - center;
  const double radius = (1.0 - t) * arm.norm() + t * (to - center).norm();
  return center + radius * unit(std::atan2(arm.y(), arm.x()) + t * sweep_rad);
}

double PlaneWay::length() const {
  if (!arc) return (to - from).norm();
  const double first = (from - center).norm(), last = (to - center).norm();
  return std::max(first, last) * std::abs(sweep_rad) + std::abs(last - first);
}

PlaneWay PlaneWay::between(double t, double u) const {
  PlaneWay way = *this;
  way.from = t <= 0.0 ? from : at(t);
  way.to = u >= 1.0 ? to : at(u);
  way.sweep_rad = (u - t) * sweep_rad;
  return way;
}

std::vector<SectionPath> sweptPaths(const ConvexOutline& outline, const PlaneWay& way) {
  std::vector<SectionPath> paths;
  if (!way.arc) {
    if ((way.to - way.from).norm() < 1e-9) return {wholeOutline(outline, way.to)};
    return {lineHull(outline, way.from, way.to)};
  }
  paths.push_back(wholeOutline(outline, way.from));
  paths.push_back(arcStrip(outline, way));
  paths.push_back(wholeOutline(outline, way.to));
  return paths;
}

std::vector<SectionPath> sweptSides(const ConvexOutline& outline, const PlaneWay& way,
                                    const SideFilter& counts) {
  std::vector<SectionPath> paths;
  std::vector<double> samples{0.0, 1.0};
  if (way.arc) samples = arcSamples(outline, way);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const Vec2 a = way.at(samples[i]), step = way.at(samples[i + 1]) - a;
    if (step.norm() < 1e-9) continue;
    const Vec2 direction = step.normalized();
    for (const OutlineSide& side : outline.sides()) {
      if (side.arc || !counts(side, direction)) continue;
      const Vec2 d = (side.to - side.from).normalized();
      if (Vec2(d.y(), -d.x()).dot(direction) <= 1e-9) continue;  // it leaves the material
      // In the order that goes counter-clockwise: the side moves to its right.
      SectionPath path{a + side.to, a + side.from, a + side.from + step, a + side.to + step};
      if (cross2(path[1] - path[0], path[2] - path[1]) < 0.0) std::reverse(path.begin(), path.end());
      paths.push_back(std::move(path));
    }
  }
  return paths;
}

std::vector<SectionPath> mirroredPaths(const std::vector<SectionPath>& paths) {
  std::vector<SectionPath> mirrored;
  for (const SectionPath& path : paths) {
    if (std::none_of(path.begin(), path.end(), [](const Vec2& p) { return p.x() < 0.0; })) continue;
    SectionPath other;
    for (auto p = path.rbegin(); p != path.rend(); ++p) other.emplace_back(-p->x(), p->y());
    mirrored.push_back(std::move(other));
  }
  return mirrored;
}

}  // namespace proveout
