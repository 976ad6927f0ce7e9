// G5 G5.1 G5.2 G5.3 G6.2: splines in chords.
#include "core/nc/services/splines.h"

#include <fmt/core.h>

#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {
namespace {

constexpr int kLcnMostOrder = 20;
constexpr double kLcnChordMm = 1e-3;
constexpr std::size_t kLcnMostPoints = 100000;

/// A word of the plane's first or second letter (I J, J K, K I; X Y, ...) in mm; false: it is not there.
bool lcnLength(IsoContext& c, const BlockPlan& plan, Address a, double& out) {
  const Word* w = c.ownWord(plan, a);
  if (w != nullptr) out = lengthOf(plan, *w);
  return w != nullptr;
}

bool lcnSplineState(IsoContext& c, BlockPlan& plan, const char* code) {
  if (lcnCompOn(c, plan))
    return lcnFail(c, "comp", fmt::format("Cannot convert {} with cutter radius compensation on", code));
  if (plan.next.active[kGroupFeedMode] == lcn::kInverseTime)
    return lcnFail(c, "feed", fmt::format("Cannot use inverse time feed with {}", code));
  return true;
}

/// The chords of a curve as steps, through (u, v) of the plane; other axes go evenly.
bool lcnChords(IsoContext& c, BlockPlan& plan, const std::vector<Vec2>& chords, const char* code) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const WorkPlane plane = plan.next.workPlane();
  double length = 0.0;
  Vec2 last = plane.of(plan.start).head<2>();
  for (const Vec2& at : chords) {
    length += (at - last).norm();
    last = at;
  }
  if (!lcnFeed(c, plan, length, 0.0, code, plan.motion.feed)) return false;
  for (std::size_t k = 0; k < chords.size(); ++k) {
    AxisPoint to = between(plan.start, plan.motion.target,
                           static_cast<double>(k + 1) / static_cast<double>(chords.size()));
    to[plane.u] = chords[k].x();
    to[plane.v] = chords[k].y();
    lcnFeedTo(own, to);
  }
  plan.perform = performLinuxCncSteps;
  return true;
}

}  // namespace

bool planLcnCubic(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  if (!lcnSplineState(c, plan, "g5")) return false;
  if (plan.next.active[kGroupPlane] != gcode::kPlaneXY)
    return lcnFail(c, "spline", "Cubic spline not in XY plane");
  Vec2 out = Vec2::Zero(), in = Vec2::Zero();
  const bool i = lcnLength(c, plan, 'I', out.x()), j = lcnLength(c, plan, 'J', out.y());
  if (i != j) return lcnFail(c, "spline", "Must specify both I and J with G5");
  if (!i) {
    if (!own.modal.cubic || c.state.active[kGroupMotion] != 50)
      return lcnFail(c, "spline", "Must specify both I and J with the first G5");
    out = -*own.modal.cubic;
  }
  const bool p = lcnLength(c, plan, 'P', in.x()), q = lcnLength(c, plan, 'Q', in.y());
  if (!p || !q) return lcnFail(c, "spline", "Must specify both P and Q with G5");
  if (!lcnTarget(c, plan, plan.motion.target)) return false;
  own.next.cubic = in;
  const Vec2 p0 = plan.start.xyz.head<2>(), p3 = plan.motion.target.xyz.head<2>();
  std::vector<Vec2> chords;
  appendBezier({p0, p0 + out, p3 + in, p3}, kLcnChordMm, chords);
  return lcnChords(c, plan, chords, "g5");
}

bool planLcnQuadratic(IsoContext& c, BlockPlan& plan) {
  if (!lcnSplineState(c, plan, "g5.1")) return false;
  if (plan.next.active[kGroupPlane] != gcode::kPlaneXY)
    return lcnFail(c, "spline", "Quadratic spline not in XY plane");
  Vec2 out = Vec2::Zero();
  const bool i = lcnLength(c, plan, 'I', out.x()), j = lcnLength(c, plan, 'J', out.y());
  if (!i || !j) return lcnFail(c, "spline", "Must specify both I and J with G5.1");
  if (out == Vec2::Zero())
    return lcnFail(c, "spline", "I and J of G5.1 must not both be 0: the curve has no direction");
  if (!lcnTarget(c, plan, plan.motion.target)) return false;
  const Vec2 p0 = plan.start.xyz.head<2>(), p1 = p0 + out, p2 = plan.motion.target.xyz.head<2>();
  std::vector<Vec2> chords;
  // A quadratic curve as a cubic one.
  appendBezier({p0, p0 + 2.0 / 3.0 * (p1 - p0), p2 + 2.0 / 3.0 * (p1 - p2), p2}, kLcnChordMm, chords);
  return lcnChords(c, plan, chords, "g5.1");
}

namespace {

/// The end of the words, from the last control point on. False: reported.
bool lcnControlPoint(IsoContext& c, BlockPlan& plan, const LinuxCncChannel& own, bool open, Vec2& at) {
  const AxisPoint start = plan.start;
  if (open) plan.start = own.nurbs.last;
  const bool good = lcnTarget(c, plan, plan.motion.target);
  plan.start = start;
  at = plan.next.workPlane().of(plan.motion.target).head<2>();
  return good;
}

/// The point and knot of the block join the curve; nothing moves.
bool performLcnPoint(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  LinuxCncNurbs& curve = own.nurbs;
  if (own.modal.nurbs == 0) {
    curve.points.clear();
    curve.knots.clear();
  }
  curve.points.insert(curve.points.end(), curve.added.begin(), curve.added.end());
  if (curve.added_knot) curve.knots.push_back(*curve.added_knot);
  if (curve.added_order > 0) curve.order = curve.added_order;
  curve.last = plan.motion.target;
  own.modal = own.next;
  return true;
}

/// What the words of the block add is kept apart until it is carried out.
void lcnBeginPoint(LinuxCncNurbs& curve, bool open) {
  curve.added.clear();
  curve.added_knot.reset();
  curve.added_order = open ? 0 : 3;
}

bool lcnCurve(IsoContext& c, BlockPlan& plan, const std::vector<Vec3>& points,
              const std::vector<double>& knots, int order, const char* code) {
  std::vector<Vec2> chords;
  if (!appendNurbs(points, knots, order, kLcnChordMm, chords))
    return lcnFail(c, "spline", "the knots of the curve must not fall, and must not all be the same");
  LinuxCncChannel& own = linuxCncChannel(c);
  plan.motion.target = own.nurbs.last;
  own.next.nurbs = 0;
  return lcnChords(c, plan, chords, code);
}

}  // namespace

bool planLcnNurbs(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  if (!lcnSplineState(c, plan, "g5.2")) return false;
  if (own.next.feed <= 0.0) return lcnFail(c, "feed", "Cannot make a NURBS with 0 feedrate");
  const Word* p = c.ownWord(plan, 'P');
  if (p == nullptr || !(p->value > 0.0))
    return lcnFail(c, "spline", "Must specify positive weight P for every control point", p);
  const bool open = own.modal.nurbs == 1;
  if (open && own.nurbs.points.size() >= kLcnMostPoints)
    return c.alarm(SharedAlarm::kOutOfRange, "G5.2", "more than 100000 control points");
  lcnBeginPoint(own.nurbs, open);
  Vec2 at;
  if (!lcnControlPoint(c, plan, own, open, at)) return false;
  const bool start_alone = !open && !lcnAnyAxis(c);
  if (!open) {
    const Vec2 start = plan.next.workPlane().of(plan.start).head<2>();
    own.nurbs.added.push_back({start.x(), start.y(), start_alone ? p->value : 1.0});
  }
  if (!start_alone) own.nurbs.added.push_back({at.x(), at.y(), p->value});
  if (const Word* l = c.ownWord(plan, 'L')) {
    std::int64_t order = 0;
    if (!lcnInteger(c, *l, order)) return false;
    own.nurbs.added_order = static_cast<int>(std::clamp<std::int64_t>(order, 3, 1000));
  }
  own.next.nurbs = 1;
  plan.perform = performLcnPoint;
  return true;
}

bool planLcnNurbsEnd(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const LinuxCncNurbs& curve = own.nurbs;
  if (own.modal.nurbs != 1) return lcnFail(c, "spline", "Cannot use G5.3 without G5.2 first");
  if (curve.points.size() < static_cast<std::size_t>(curve.order))
    return lcnFail(
        c, "spline",
        fmt::format("You must specify a number of control points at least equal to the order L = {}: "
                    "there are {}",
                    curve.order, curve.points.size()));
  return lcnCurve(c, plan, curve.points, uniformKnots(curve.points.size(), curve.order), curve.order, "g5.3");
}

bool planLcnKnots(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  LinuxCncNurbs& curve = own.nurbs;
  if (!lcnSplineState(c, plan, "g6.2")) return false;
  const bool open = own.modal.nurbs == 2;
  if (!open)
    c.warnOnce("g6.2", "version",
               "G6.2 is of versions of LinuxCNC behind 2.9: it runs as the exact curve here");
  lcnBeginPoint(curve, open);
  Vec2 at;
  if (!lcnControlPoint(c, plan, own, open, at)) return false;
  const Word* k = c.ownWord(plan, 'K');
  if (k == nullptr) return lcnFail(c, "spline", "K word (knot) missing with G6.2");
  curve.added_knot = k->value;
  if (!open) {
    const Word* p = c.ownWord(plan, 'P');
    std::int64_t order = 4;
    if (p != nullptr && !lcnInteger(c, *p, order)) return false;
    if (order < 2 || order > kLcnMostOrder)
      return lcnFail(c, "spline", fmt::format("P of G6.2 is the order, 2 to {}", kLcnMostOrder), p);
    curve.added_order = static_cast<int>(order);
    if ((at - plan.next.workPlane().of(plan.start).head<2>()).norm() > kLcnChordMm)
      return lcnFail(c, "spline", "the tool must stand at the first point of G6.2");
  }
  if (lcnAnyAxis(c)) {
    const Word* r = c.ownWord(plan, 'R');
    if (r != nullptr && !(r->value > 0.0))
      return lcnFail(c, "spline", "R of G6.2, a weight, must be above 0", r);
    if (open && curve.points.size() >= kLcnMostPoints)
      return c.alarm(SharedAlarm::kOutOfRange, "G6.2", "more than 100000 control points");
    curve.added.push_back({at.x(), at.y(), r == nullptr ? 1.0 : r->value});
  } else if (open && curve.knots.size() + 1 == curve.points.size() + static_cast<std::size_t>(curve.order)) {
    std::vector<double> knots = curve.knots;
    knots.push_back(k->value);
    plan.next.active[kGroupMotion] = 62;
    return lcnCurve(c, plan, curve.points, knots, curve.order, "g6.2");
  }
  own.next.nurbs = 2;
  plan.perform = performLcnPoint;
  return true;
}

}  // namespace proveout::nc
