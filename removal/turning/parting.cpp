#include "removal/turning/parting.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/base/assert.h"

namespace proveout {
namespace {

/// Ways of one stroke meet within this, mm, and turn by no more than this, as a cosine: points of programs
/// are rounded to micrometres.
constexpr double kSamePlace = 1e-6, kStraightOn = 0.999;
/// How exactly it is looked for where a piece comes free, mm of way.
constexpr double kFreeWayMm = 1e-7;

void addTaken(const ToolWay& on, std::vector<SectionPath>& out) {
  std::vector<SectionPath> sweeps = on.tool->swept(on.way);
  std::vector<SectionPath> beyond = mirroredPaths(sweeps);
  std::move(sweeps.begin(), sweeps.end(), std::back_inserter(out));
  std::move(beyond.begin(), beyond.end(), std::back_inserter(out));
}

bool takesWholly(const std::vector<SectionPath>& sweeps, const SectionBody& body) {
  SectionArea left(body.loops);
  left.subtract(sweeps, kNoMotion);
  return left.bodies().empty();
}

}  // namespace

bool goesOn(const PlaneWay& before, const PlaneWay& behind) {
  if ((before.to - behind.from).norm() > kSamePlace) return false;
  return std::cos(behind.direction(0.0) - before.direction(1.0)) > kStraightOn;
}

Freed freedIn(const SectionArea& area, const std::vector<ToolWay>& stroke) {
  Freed freed;
  std::vector<SectionPath> sweeps;
  for (const ToolWay& on : stroke) addTaken(on, sweeps);
  for (SectionBody& body : area.bodies()) {
    const bool stays = freed.held.empty() || (!sweeps.empty() && takesWholly(sweeps, body));
    (stays ? freed.held : freed.falls).push_back(std::move(body));
  }
  return freed;
}

double freedAt(const SectionArea& before, const ToolWay& on, const std::vector<ToolWay>& stroke) {
  const auto falls = [&](double t) {
    std::vector<SectionPath> sweeps;
    addTaken(on.between(0.0, t), sweeps);
    SectionArea left = before;
    left.subtract(sweeps, kNoMotion);
    if (!left.apart()) return false;
    std::vector<ToolWay> rest{on.between(t, 1.0)};
    rest.insert(rest.end(), stroke.begin(), stroke.end());
    return !freedIn(left, rest).falls.empty();
  };
  const double length = on.way.length();
  double whole = 0.0, free = 1.0;
  while ((free - whole) * length > kFreeWayMm) {
    const double middle = 0.5 * (whole + free);
    (falls(middle) ? free : whole) = middle;
  }
  return free;
}

SectionArea besideStroke(const SectionBody& piece, const std::vector<ToolWay>& stroke) {
  std::vector<SectionPath> sweeps;
  for (const ToolWay& on : stroke) addTaken(on, sweeps);
  SectionArea area(piece.loops);
  if (!sweeps.empty()) area.subtract(sweeps, kNoMotion);
  return area;
}

double trimCorners(SectionBody& piece, const std::vector<ToolWay>& stroke, MotionId motion) {
  if (stroke.empty() || stroke.front().tool->blade_mm <= 0.0) return 0.0;
  double left_mm = stroke.front().tool->nose_mm;
  std::vector<SectionPath> sweeps;
  for (const ToolWay& on : stroke) {
    if (left_mm <= 0.0) break;
    const double length = on.way.length();
    addTaken(length > left_mm ? on.between(0.0, left_mm / length) : on, sweeps);
    left_mm -= length;
  }
  SectionArea area(piece.loops);
  if (area.subtract(sweeps, motion) <= 0.0) return 0.0;
  const std::vector<SectionBody> bodies = area.bodies();
  if (bodies.size() != 1) return 0.0;
  const double taken = piece.volume_mm3 - bodies.front().volume_mm3;
  piece.loops = bodies.front().loops;
  piece.volume_mm3 = bodies.front().volume_mm3;
  return taken;
}

bool isPartedBy(const ToolWay& on, const SectionBody& piece) {
  const Vec2 along = on.way.to - on.way.from;
  const bool inwards = std::abs(on.way.to.x()) < std::abs(on.way.from.x());
  if (on.tool->blade_mm <= 0.0 || !inwards || std::abs(along.x()) < std::abs(along.y())) return false;
  PROVEOUT_ASSERT(!piece.loops.empty());
  double low = std::numeric_limits<double>::infinity(), high = -low, radius = 0.0;
  for (const Vec2& p : piece.loops.front().points) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
    radius = std::max(radius, p.x());
  }
  return std::max(2.0 * radius, high - low) > on.tool->blade_mm;
}

}  // namespace proveout
