// Curves of the 30i: involute, arc in space, NURBS. All go along chords.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/curve.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/motion/planes.h"
#include "core/nc/services/virtual_plane.h"

namespace proveout::nc {
namespace {

constexpr std::int32_t kInvoluteCcw = 32;
constexpr double kMostUnrollRad = 2000.0 * kPi;

bool refuseCurveInComp(IsoContext& c, const BlockPlan& plan) {
  if (!plan.next.compOn()) return true;
  return c.fail("curve-comp", fmt::format("{} cannot run with cutter compensation here: program G40 first",
                                          gName(plan.next.active[kGroupMotion])));
}

/// Angle of the direction from the centre, less that of the base direction, at unrolled angle `a`.
double involuteTurn(double a) { return a - std::atan(a); }

// Data of an involute: 0, 1 centre in the plane; 2 radius of the base circle; 3 base direction, rad; 4, 5
// unrolled angles at start and end; 6 hand, +1 unrolls counter-clockwise; 7 to 9 axes u, v, w; 10, 11 w at
// start and end.
Vec3 involutePoint(const CurveMove& m, double t) {
  const auto& d = m.data;
  const double a = d[4] + (d[5] - d[4]) * t;
  const double x = std::cos(a) + a * std::sin(a), y = d[6] * (std::sin(a) - a * std::cos(a));
  const double cosine = std::cos(d[3]), sine = std::sin(d[3]);
  Vec3 p;
  p[static_cast<int>(d[7])] = d[0] + d[2] * (cosine * x - sine * y);
  p[static_cast<int>(d[8])] = d[1] + d[2] * (sine * x + cosine * y);
  p[static_cast<int>(d[9])] = d[10] + (d[11] - d[10]) * t;
  return p;
}

double toleranceOfCurve(const IsoContext& c) {
  const double tolerance = c.parameters[MotionParam::kRadiusDifference];
  return tolerance > 0.0 ? tolerance : 0.01;
}

/// Fills the data of the involute between the ends; false: reported.
bool solveInvolute(IsoContext& c, const BlockPlan& plan, const Vec2& center, double base, CurveMove& m) {
  const WorkPlane plane = plan.next.workPlane();
  const Vec2 from = plane.of(plan.start).head<2>() - center;
  const Vec2 to = plane.of(plan.motion.target).head<2>() - center;
  if (from.norm() < base - 1e-6 || to.norm() < base - 1e-6)
    return c.fail("242", "improper involute: an end lies inside of the base circle");
  const auto unrolled = [&](const Vec2& p) {
    const double ratio = p.norm() / base;
    return std::sqrt(std::max(0.0, ratio * ratio - 1.0));
  };
  const double a0 = unrolled(from), a1 = unrolled(to);
  if (!(std::max(a0, a1) <= kMostUnrollRad)) return c.fail("242", "improper involute: too many turns");
  const bool ccw = plan.next.active[kGroupMotion] == kInvoluteCcw;
  const double hand = (ccw ? 1.0 : -1.0) * (a1 >= a0 ? 1.0 : -1.0);
  const double base_direction = std::atan2(from.y(), from.x()) - hand * involuteTurn(a0);
  const double off =
      std::remainder(std::atan2(to.y(), to.x()) - base_direction - hand * involuteTurn(a1), 2.0 * kPi);
  if (std::abs(off) * to.norm() > toleranceOfCurve(c))
    return c.fail("243", fmt::format("over tolerance of the end point: the end is {:.6g} mm off the involute",
                                     std::abs(off) * to.norm()));
  m.data = {center.x(),
            center.y(),
            base,
            base_direction,
            a0,
            a1,
            hand,
            1.0 * plane.u,
            1.0 * plane.v,
            1.0 * plane.w,
            plan.start[plane.w],
            plan.motion.target[plane.w]};
  m.pieces = std::max(1, static_cast<int>(std::ceil(std::abs(a1 - a0) / kCurvePieceRad)));
  return true;
}

}  // namespace

bool planInvolute(IsoContext& c, BlockPlan& plan) {
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  const bool words = !(c.block.present & AddressSet("IJKR")).without(plan.claimed).empty();
  if (!c.anyAxisWord() && !words) return true;
  if (!refuseCurveInComp(c, plan)) return false;
  if (!planeOfLines(c, plan, SharedAlarm::kCircle, "involutes need linear axes")) return false;
  const WorkPlane plane = plan.next.workPlane();
  if (plane.u >= kMainAxes || plane.v >= kMainAxes)
    return c.alarm(SharedAlarm::kPlane, "", "involutes with parallel axes are not simulated");
  const PlaneFrame letters(plan.next.plane());
  const Word* r = c.ownWord(plan, 'R');
  if (r == nullptr || !(r->value > 0.0))
    return c.fail("241", "improper involute: R, the radius of the base circle, above 0",
                  r ? r->columns : Columns{});
  Vec2 center = plane.of(plan.start).head<2>();
  bool given = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.ownWord(plan, "IJK"[axis]);
    if (w == nullptr || axis == letters.w()) continue;
    given = true;
    (axis == letters.u() ? center.x() : center.y()) += lengthOf(plan, *w);
  }
  if (!given) return c.fail("241", "improper involute: I, J, K tell the centre");
  CurveMove& move = plan.payload.emplace<CurveMove>();
  move.at = involutePoint;
  if (!solveInvolute(c, plan, center, lengthOf(plan, *r), move)) return false;
  plan.perform = performCurve;
  return feedStyle(c, plan, plan.motion.feed);
}

namespace {

// Data of an arc in space: 0 to 2 centre; 3 to 5 and 6 to 8 its axes, times the radius; 9 angle, rad.
Vec3 spaceArcPoint(const CurveMove& m, double t) {
  const auto& d = m.data;
  const double cosine = std::cos(d[9] * t), sine = std::sin(d[9] * t);
  return {d[0] + cosine * d[3] + sine * d[6], d[1] + cosine * d[4] + sine * d[7],
          d[2] + cosine * d[5] + sine * d[8]};
}

/// The circle through three points; false: they stand on a line.
bool solveSpaceArc(const Vec3& start, const Vec3& middle, const Vec3& end, CurveMove& m) {
  const Vec3 a = middle - start, b = end - start;
  const Vec3 normal = a.cross(b);
  const double area2 = normal.squaredNorm();
  if (!(area2 > 1e-12 * a.squaredNorm() * b.squaredNorm()) || !(area2 > 0.0)) return false;
  const Vec3 to_center =
      (a.squaredNorm() * b.cross(normal) + b.squaredNorm() * normal.cross(a)) / (2.0 * area2);
  const Vec3 center = start + to_center, u = -to_center;
  const Vec3 v = normal.normalized().cross(u);
  const Vec3 last = end - center;
  double angle = std::atan2(last.dot(v), last.dot(u));
  if (angle <= 0.0) angle += 2.0 * kPi;
  m.data = {center.x(), center.y(), center.z(), u.x(), u.y(), u.z(), v.x(), v.y(), v.z(), angle};
  m.pieces = std::max(1, static_cast<int>(std::ceil(angle / kCurvePieceRad)));
  return true;
}

bool keepMiddle(IsoContext& c, BlockPlan& plan) {
  CurveInput& curve = fanucData(c).curve;
  curve.arc = true;
  curve.points.assign(1, {Vec3(std::get<CurveMove>(plan.payload).data.data()), 1.0});
  return true;
}

bool performSpaceArc(IsoContext& c, BlockPlan& plan) {
  fanucData(c).curve = CurveInput();
  if (std::get<CurveMove>(plan.payload).at != nullptr) return performCurve(c, plan);
  return sendChords(c, plan, {plan.motion.target.xyz});
}

}  // namespace

bool planSpaceArc(IsoContext& c, BlockPlan& plan) {
  const CurveInput& curve = fanucData(c).curve;
  const bool ends = curve.arc;
  if (!c.anyAxisWord()) return true;
  if (!refuseCurveInComp(c, plan)) return false;
  AxisPoint& target = plan.motion.target;
  if (!axisTarget(c, plan, target)) return false;
  if (ends) {
    const Vec3 middle = curve.points.front().at;
    for (int axis = 0; axis < kMainAxes; ++axis) {  // what is incremental or not named counts from the middle
      const bool named = plan.motion.named[static_cast<std::size_t>(axis)];
      const bool steps = plan.next.incremental();
      if (named && steps) target[axis] += middle[axis] - plan.start[axis];
      if (!named) target[axis] = middle[axis];
    }
  }
  if (!feedStyle(c, plan, plan.motion.feed)) return false;
  CurveMove& move = plan.payload.emplace<CurveMove>();
  if (!ends) {
    for (int axis = 0; axis < kMainAxes; ++axis) move.data[static_cast<std::size_t>(axis)] = target[axis];
    target = plan.start;
    plan.perform = keepMiddle;
    return true;
  }
  move.at = spaceArcPoint;
  if (!solveSpaceArc(plan.start.xyz, curve.points.front().at, target.xyz, move)) move.at = nullptr;
  plan.perform = performSpaceArc;
  return true;
}

namespace {

/// Where the curve is at `u`, within the span that begins at knots[span]: the form of de Boor with weights.
Vec3 nurbsPoint(const CurveInput& curve, std::size_t span, double u) {
  const auto order = static_cast<std::size_t>(curve.order);
  std::vector<Eigen::Vector4d> d(order);
  for (std::size_t j = 0; j < order; ++j) {
    const CurvePoint& p = curve.points[span + 1 - order + j];
    d[j] << p.at * p.weight, p.weight;
  }
  for (std::size_t r = 1; r < order; ++r) {
    for (std::size_t j = order - 1; j >= r; --j) {
      const std::size_t i = span + 1 - order + j;
      const double low = curve.knots[i], high = curve.knots[i + order - r];
      const double share = high > low ? (u - low) / (high - low) : 0.0;
      d[j] = (1.0 - share) * d[j - 1] + share * d[j];
    }
  }
  const Eigen::Vector4d& last = d[order - 1];
  return last.head<3>() / last.w();
}

/// All points of the curve, its start first.
std::vector<Vec3> nurbsChords(const CurveInput& curve) {
  const auto order = static_cast<std::size_t>(curve.order);
  std::vector<Vec3> points;
  constexpr int kPiecesOfSpan = 8;
  for (std::size_t span = order - 1; span < curve.points.size(); ++span) {
    const double low = curve.knots[span], high = curve.knots[span + 1];
    if (!(high > low)) continue;
    const auto at = [&](double t) { return nurbsPoint(curve, span, low + (high - low) * t); };
    if (points.empty()) points.push_back(at(0.0));
    divideCurve(at, kPiecesOfSpan, kCurveToleranceMm, [&](double t) { points.push_back(at(t)); });
  }
  return points;
}

/// What a block adds to the list. Data: 0 to 2 point, 3 weight, 4 knot, 5 order of a list that begins or 0,
/// 6: it has a point.
bool performNurbs(IsoContext& c, BlockPlan& plan) {
  CurveInput& curve = fanucData(c).curve;
  const auto& d = std::get<CurveMove>(plan.payload).data;
  if (d[5] > 0.0) curve = CurveInput();
  if (d[5] > 0.0) curve.order = static_cast<int>(d[5]);
  curve.knots.push_back(d[4]);
  if (d[6] != 0.0) curve.points.push_back({Vec3(d[0], d[1], d[2]), d[3]});
  const std::size_t needed = curve.points.size() + static_cast<std::size_t>(curve.order);
  if (d[6] != 0.0 || curve.knots.size() < needed) return true;
  const CurveInput whole = std::exchange(curve, CurveInput());
  if (whole.points.size() < static_cast<std::size_t>(whole.order))
    return c.fail("5117", "NURBS: fewer control points than the order");
  std::vector<Vec3> points = nurbsChords(whole);
  if (points.empty()) return c.fail("5115", "NURBS: all knots are the same");
  plan.motion.target.xyz = points.back();
  constexpr double kThereMm = 1e-3;
  if ((points.front() - c.position.xyz).norm() <= kThereMm) points.erase(points.begin());
  return sendChords(c, plan, points);
}

/// The control point of the block: axes without a word stay where the last point was.
bool nurbsTarget(IsoContext& c, BlockPlan& plan, const CurveInput& curve, bool begins, Vec3& point) {
  AxisPoint target;
  if (!axisTarget(c, plan, target)) return false;
  const Vec3 last = begins || curve.points.empty() ? plan.start.xyz : curve.points.back().at;
  for (int axis = 0; axis < kMainAxes; ++axis) {
    const bool named = plan.motion.named[static_cast<std::size_t>(axis)];
    point[axis] = !named                    ? last[axis]
                  : plan.next.incremental() ? target[axis] - plan.start[axis] + last[axis]
                                            : target[axis];
  }
  for (int axis = kMainAxes; axis < c.axes.count(); ++axis) {
    if (plan.motion.named[static_cast<std::size_t>(axis)])
      return c.fail("nurbs-axis", "NURBS with axes besides X, Y, Z are not simulated");
  }
  return true;
}

}  // namespace

bool planNurbs(IsoContext& c, BlockPlan& plan) {
  const CurveInput& curve = fanucData(c).curve;
  const bool begins = plan.by_group[kGroupMotion] != nullptr;
  const Word* k = c.ownWord(plan, 'K');
  plan.motion.target = plan.start;
  if (curve.order == 0 && !begins) {
    if (!c.anyAxisWord() && k == nullptr) return true;
    return c.fail("5115", "the NURBS curve has ended: program G06.2 for another one");
  }
  if (!refuseCurveInComp(c, plan)) return false;
  if (k == nullptr) return c.fail("5117", "NURBS: a block without its knot K, and the list is not complete");
  std::int64_t order = begins ? 4 : 0;
  if (const Word* p = c.ownWord(plan, 'P'); p != nullptr) {
    if (!begins) return c.alarm(SharedAlarm::kIllegalAddress, *p, "the order stands in the first block");
    if (!integerWord(c, *p, 2, 20, order)) return false;
  }
  if (!begins && k->value < curve.knots.back())
    return c.fail("5116", "NURBS: the knots must not fall", k->columns);
  if (begins && curve.open()) return c.fail("5117", "NURBS: the list before is not complete");
  double weight = 1.0;
  if (const Word* r = c.ownWord(plan, 'R')) weight = r->value;
  if (!(weight > 0.0 && weight <= 1e6)) return c.fail("5118", "NURBS: weights are above 0");
  Vec3 point = Vec3::Zero();
  const bool has_point = c.anyAxisWord();
  if (has_point && !nurbsTarget(c, plan, curve, begins, point)) return false;
  CurveMove& move = plan.payload.emplace<CurveMove>();
  move.data = {point.x(),
               point.y(),
               point.z(),
               weight,
               k->value,
               1.0 * static_cast<double>(order),
               has_point ? 1.0 : 0.0};
  plan.motion.target = plan.start;
  plan.perform = performNurbs;
  return feedStyle(c, plan, plan.motion.feed);
}

}  // namespace proveout::nc
