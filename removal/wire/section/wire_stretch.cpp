#include "removal/wire/section/wire_stretch.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/plane.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {
namespace {

/// Radii at the ends of an arc that differ by no more than this count as equal, mm.
constexpr double kSameRadius = 1e-6;
/// How far circles may leave an arc whose radius changes, mm.
constexpr double kSpiralTolerance = 1e-5;

Vec2 unitOr(const Vec2& v, const Vec2& other) {
  const double length = v.norm();
  return length > 0.0 ? Vec2(v / length) : other;
}

/// Angle of `p` from the start of an arc, in its direction, 0 to a turn.
double angleAlong(const WireStretch& arc, const Vec2& p) {
  const Vec2 u = arc.from - arc.center, d = p - arc.center;
  double angle = std::atan2(cross2(u, d), u.dot(d));
  if (arc.sweep_rad < 0.0) angle = -angle;
  return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

/// The circle through three points; nothing where they lie on a line.
bool circleThrough(const Vec2& a, const Vec2& b, const Vec2& c, Vec2& center) {
  const Vec2 ab = b - a, ac = c - a;
  const double cross = 2.0 * cross2(ab, ac);
  if (std::abs(cross) < 1e-14) return false;
  const double ab2 = ab.squaredNorm(), ac2 = ac.squaredNorm();
  center = a + Vec2(ac.y() * ab2 - ab.y() * ac2, ab.x() * ac2 - ac.x() * ab2) / cross;
  return true;
}

/// Three points of a curve r = r0 + k a fix a circle that leaves it by less than k h^3, where h is half of
/// their angle.
void addSpiral(const WireTrack& track, WireStretch stretch, std::vector<WireStretch>& out) {
  const double change = std::abs((track.to - track.center).norm() - (track.from - track.center).norm());
  const double sweep = std::abs(track.sweep_rad), rate = change / sweep;
  const double half = std::min(0.25, std::cbrt(kSpiralTolerance / rate));
  const int count = std::max(1, static_cast<int>(std::ceil(sweep / (2.0 * half))));
  for (int i = 0; i < count; ++i) {
    stretch.from = i == 0 ? track.from : out.back().to;
    stretch.to = i + 1 == count ? track.to : pointOnTrack(track, (i + 1.0) / count);
    const Vec2 middle = pointOnTrack(track, (i + 0.5) / count);
    if (circleThrough(stretch.from, middle, stretch.to, stretch.center)) {
      const Vec2 u = stretch.from - stretch.center, v = stretch.to - stretch.center;
      stretch.sweep_rad = std::atan2(cross2(u, v), u.dot(v));
    } else {
      stretch.sweep_rad = 0.0;
    }
    out.push_back(stretch);
  }
}

bool sameTrack(const WireTrack& a, const WireTrack& b) {
  const auto near = [](const Vec2& p, const Vec2& q) { return (p - q).norm() <= kUprightMm; };
  if (!near(a.from, b.from) || !near(a.to, b.to)) return false;
  if (a.sweep_rad == 0.0 && b.sweep_rad == 0.0) return true;
  const double reach = (a.from - a.center).norm();
  return near(a.center, b.center) && std::abs(a.sweep_rad - b.sweep_rad) * reach <= kUprightMm;
}

}  // namespace

Vec2 WireStretch::directionAtStart() const {
  if (!isArc()) return unitOr(to - from, Vec2::UnitX());
  return unitOr(sweep_rad > 0.0 ? leftOf(from - center) : Vec2(-leftOf(from - center)), Vec2::UnitX());
}

Vec2 WireStretch::directionAtEnd() const {
  if (!isArc()) return directionAtStart();
  return unitOr(sweep_rad > 0.0 ? leftOf(to - center) : Vec2(-leftOf(to - center)), Vec2::UnitX());
}

Vec2 WireStretch::at(double t) const {
  return isArc() ? Vec2(center + turnedBy(from - center, t * sweep_rad)) : Vec2(from + t * (to - from));
}

double WireStretch::length() const { return isArc() ? radius() * std::abs(sweep_rad) : (to - from).norm(); }

Vec2 onFront(const WireStretch& stretch, double t, double across) {
  PROVEOUT_ASSERT(across >= -1.0 && across <= 1.0);
  constexpr double kShortStep = 1e-6;
  const Vec2 at = stretch.at(t), to = stretch.at(std::min(1.0, t + kShortStep)) - at;
  const Vec2 ahead = to.norm() > 0.0 ? Vec2(to.normalized()) : stretch.directionAtStart();
  return at + stretch.kerf_mm * (across * leftOf(ahead) + std::sqrt(1.0 - across * across) * ahead);
}

WireStretch beginningOf(const WireStretch& stretch, double part) {
  constexpr double kRounding = 1e-9;
  PROVEOUT_ASSERT(part >= 0.0 && part <= 1.0 + kRounding);
  WireStretch out = stretch;
  out.to = part < 1.0 ? stretch.at(part) : stretch.to;
  out.sweep_rad = part * stretch.sweep_rad;
  return out;
}

std::vector<WireStretch> cutUntil(const std::vector<WireStretch>& cuts, const CutTime& time) {
  PROVEOUT_ASSERT(time.cuts < cuts.size() || (time.cuts == cuts.size() && time.share <= 0.0));
  std::vector<WireStretch> done(cuts.begin(), cuts.begin() + time.cuts);
  if (time.share > 0.0) done.push_back(beginningOf(cuts[time.cuts], time.share));
  return done;
}

StretchDistance distanceTo(const WireStretch& s, const Vec2& p) {
  if (s.isArc()) {
    const double angle = angleAlong(s, p);
    if (angle > 0.0 && angle < std::abs(s.sweep_rad))
      return {std::abs((p - s.center).norm() - s.radius()), StretchPart::kMiddle};
  } else {
    const Vec2 d = s.to - s.from;
    const double along = (p - s.from).dot(d), length2 = d.squaredNorm();
    if (along > 0.0 && along < length2)
      return {std::abs(cross2(d, p - s.from)) / std::sqrt(length2), StretchPart::kMiddle};
  }
  const double first = (p - s.from).norm(), last = (p - s.to).norm();
  return first <= last ? StretchDistance{first, StretchPart::kFrom} : StretchDistance{last, StretchPart::kTo};
}

Box3 boundsOf(const WireStretch& s) {
  Box3 box;
  box.extend(Vec3(s.from.x(), s.from.y(), 0.0));
  box.extend(Vec3(s.to.x(), s.to.y(), 0.0));
  if (!s.isArc()) return box;
  for (const Vec2& side : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
    const Vec2 at = s.center + s.radius() * side;
    if (angleAlong(s, at) < std::abs(s.sweep_rad)) box.extend(Vec3(at.x(), at.y(), 0.0));
  }
  return box;
}

bool isUpright(const WireSweep& wire) { return sameTrack(wire.lower, wire.upper); }

Vec2 pointOnTrack(const WireTrack& track, double t) {
  if (track.sweep_rad == 0.0) return track.from + t * (track.to - track.from);
  const Vec2 start = track.from - track.center, end = track.to - track.center;
  const double first = start.norm(), last = end.norm();
  const double radius = first + t * (last - first);
  if (first >= last)
    return first > 0.0 ? Vec2(track.center + turnedBy(start, t * track.sweep_rad) * (radius / first))
                       : track.center;
  return track.center + turnedBy(end, (t - 1.0) * track.sweep_rad) * (radius / last);
}

void addStretches(const WireTrack& track, double kerf_mm, MotionId motion, std::vector<WireStretch>& out) {
  WireStretch stretch;
  stretch.from = track.from;
  stretch.to = track.to;
  stretch.kerf_mm = kerf_mm;
  stretch.motion = motion;
  if (track.sweep_rad == 0.0) {
    out.push_back(stretch);
    return;
  }
  const double first = (track.from - track.center).norm(), last = (track.to - track.center).norm();
  if (std::abs(first - last) > kSameRadius) {
    addSpiral(track, stretch, out);
    return;
  }
  stretch.center = track.center;
  stretch.sweep_rad = track.sweep_rad;
  out.push_back(stretch);
}

}  // namespace proveout
