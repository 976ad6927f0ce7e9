#include <fmt/core.h>

#include <cmath>

#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/motion/contour.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/motion/planes.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {
namespace {

constexpr double kTurnRad = 2.0 * kPi;
constexpr double kMostSpiralTurns = 1000.0;
constexpr double kTinySpiralMm = 1e-9;

double toleranceOf(const IsoContext& c) {
  const double tolerance = c.parameters[MotionParam::kRadiusDifference];
  return tolerance > 0.0 ? tolerance : 1e9;
}

bool failSpiral(IsoContext& c, std::string why) {
  return c.fail("5123", "spiral or cone does not fit: " + std::move(why));
}

/// What the words of a spiral tell.
struct SpiralWords {
  Vec2 center = Vec2::Zero();           ///< plane coordinates
  bool has_end = false;                 ///< a word of the plane's axes
  std::optional<double> change, turns;  ///< Q: of the radius for a turn; L
  std::optional<double> rise;           ///< height for a turn
};

bool readSpiral(IsoContext& c, const BlockPlan& plan, SpiralWords& spiral) {
  const PlaneFrame letters(plan.next.plane());
  const WorkPlane plane = plan.next.workPlane();
  spiral.center = plane.of(plan.start).head<2>();
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    const double value = lengthOf(plan, *w);
    if (axis == letters.u()) spiral.center.x() += value;
    if (axis == letters.v()) spiral.center.y() += value;
    if (axis == letters.w()) spiral.rise = value;
  }
  spiral.has_end = plan.motion.named[static_cast<std::size_t>(plane.u)] ||
                   plan.motion.named[static_cast<std::size_t>(plane.v)];
  if (const Word* q = c.ownWord(plan, 'Q')) spiral.change = lengthOf(plan, *q);
  if (const Word* l = c.ownWord(plan, 'L')) {
    if (!(l->value > 0.0 && l->value <= kMostSpiralTurns))
      return c.alarm(SharedAlarm::kOutOfRange, *l, "turns from above 0 up to 1000");
    spiral.turns = l->value;
  }
  return true;
}

/// Angle from the start to the end direction in the arc's direction, above 0 up to a turn.
double partOf(const Vec2& a, const Vec2& b, bool ccw) {
  constexpr double kSame = 1e-9;
  double part = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (!ccw) part = -part;
  return part <= kSame ? part + kTurnRad : part;
}

/// Angle that the spiral turns by, with its radius at the end.
bool spiralEnd(IsoContext& c, const SpiralWords& spiral, const PlaneArc& arc, bool ccw, double& sweep,
               double& radius) {
  const Vec2 from = arc.start.head<2>() - spiral.center, to = arc.end.head<2>() - spiral.center;
  const double r0 = from.norm();
  if (!spiral.has_end) {
    if (!spiral.change || !spiral.turns) return failSpiral(c, "of the end, Q and L two are needed");
    sweep = kTurnRad * *spiral.turns;
    radius = r0 + *spiral.change * *spiral.turns;
    return radius >= 0.0 || failSpiral(c, "the radius would fall below 0");
  }
  const double r1 = to.norm(), part = partOf(from, to, ccw);
  double turns = 0.0;  // whole ones in front of the part
  if (spiral.turns) {
    turns = std::ceil(*spiral.turns - 1e-9) - 1.0;
  } else {
    const double all = *spiral.change != 0.0 ? (r1 - r0) / *spiral.change : part / kTurnRad;
    turns = std::round(all - part / kTurnRad);
  }
  if (!(turns >= 0.0 && turns <= kMostSpiralTurns)) return failSpiral(c, "the end lies on another turn");
  sweep = part + kTurnRad * turns;
  radius = spiral.change ? r0 + *spiral.change * sweep / kTurnRad : r1;
  const double off = std::abs(radius - r1);
  if (off <= toleranceOf(c)) return true;
  return failSpiral(c, fmt::format("the radius at the end is {:.6g}, by Q it is {:.6g}", r1, radius));
}

bool planSpiral(IsoContext& c, BlockPlan& plan) {
  if (!planeOfLines(c, plan, SharedAlarm::kCircle, "circles need linear axes")) return false;
  if (const Word* r = c.ownWord(plan, 'R'))
    return c.alarm(SharedAlarm::kIllegalAddress, *r, "a spiral has its centre by I, J, K");
  SpiralWords spiral;
  if (!readSpiral(c, plan, spiral)) return false;
  const WorkPlane plane = plan.next.workPlane();
  PlaneArc& arc = plan.motion.arc;
  arc.start = plane.of(plan.start);
  arc.end = plane.of(plan.motion.target);
  arc.center = spiral.center;
  const bool ccw = plan.next.active[kGroupMotion] == gcode::kArcCounterClockwise;
  if (!(arc.startRadius() > kTinySpiralMm)) return failSpiral(c, "it starts at its centre");
  double sweep = 0.0, radius = 0.0;
  if (!spiralEnd(c, spiral, arc, ccw, sweep, radius)) return false;
  arc.sweep_rad = ccw ? sweep : -sweep;
  if (!spiral.has_end) {
    const Vec2 from = arc.start.head<2>() - spiral.center;
    const double angle = std::atan2(from.y(), from.x()) + arc.sweep_rad;
    plan.motion.target[plane.u] = spiral.center.x() + radius * std::cos(angle);
    plan.motion.target[plane.v] = spiral.center.y() + radius * std::sin(angle);
    plan.motion.named.set(static_cast<std::size_t>(plane.u)).set(static_cast<std::size_t>(plane.v));
  }
  if (spiral.rise) {
    const double rise = *spiral.rise * sweep / kTurnRad;
    double& end = plan.motion.target[plane.w];
    const bool named = plan.motion.named[static_cast<std::size_t>(plane.w)];
    const double off = std::abs(end - plan.start[plane.w] - rise);
    if (named && off > toleranceOf(c)) return failSpiral(c, "the height by turn and the end differ");
    if (!named) end = plan.start[plane.w] + rise;
  }
  arc.end = plane.of(plan.motion.target);
  plan.perform = performMove;
  plan.motion.is_arc = true;
  return carryArc(c, plan) && planJoin(c, plan) && feedStyle(c, plan, plan.motion.feed);
}

/// An arc whose ends are not on one circle goes on only because of the tolerance.
void noteTolerance(IsoContext& c, const BlockPlan& plan) {
  constexpr double kRoundingMm = 0.0025;
  if (!plan.motion.is_arc) return;
  const double differ = std::abs(plan.motion.arc.startRadius() - plan.motion.arc.endRadius());
  if (differ <= kRoundingMm) return;
  noteSetting(
      c, MotionParam::kRadiusDifference,
      fmt::format("the radii at start and end differ by {:.6g} mm, {:.6g} are allowed (parameter 3410)",
                  differ, c.parameters[MotionParam::kRadiusDifference]));
}

}  // namespace

bool planFanucArc(IsoContext& c, BlockPlan& plan) {
  const Word* q = c.ownWord(plan, 'Q');
  const Word* l = c.ownWord(plan, 'L');
  for (const Address a : {'I', 'J', 'K'}) {
    if (plan.next.axes.mode != VirtualMode::kCylinder || c.ownWord(plan, a) == nullptr) continue;
    return c.failWord("176", "improper G-code in cylinder mode: arcs are given by R", *c.word(a));
  }
  if (q == nullptr && l != nullptr && !c.anyAxisWord())
    return c.alarm(SharedAlarm::kIllegalAddress, *l, "an arc takes no turns");
  if (q == nullptr && l == nullptr) {
    if (!planArc(c, plan)) return false;
    noteTolerance(c, plan);
    return true;
  }
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  if (q == nullptr) {  // L alone: of a spiral the radii differ
    const WorkPlane plane = plan.next.workPlane();
    SpiralWords spiral;
    if (!readSpiral(c, plan, spiral)) return false;
    const double from = (plane.of(plan.start).head<2>() - spiral.center).norm();
    const double to = (plane.of(plan.motion.target).head<2>() - spiral.center).norm();
    if (!spiral.has_end || std::abs(from - to) <= toleranceOf(c))
      return c.alarm(SharedAlarm::kIllegalAddress, *l, "L belongs to a spiral (Q)");
  }
  plan.motion.named.reset();
  return axisTarget(c, plan, plan.motion.target) && planSpiral(c, plan);
}

}  // namespace proveout::nc
