#include "core/nc/services/cutter_comp_corner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace proveout::comp_detail {
namespace {

constexpr double kTangentTolerance = degToRad(0.001);  ///< corners straighter than this have one normal
constexpr double kNearTangent = degToRad(0.5);         ///< rounded part-program coordinates
constexpr double kClassTolerance = degToRad(1e-6);     ///< of the limits 90 and 180 deg

double turnSign(const Element& e) { return e.sweep >= 0.0 ? 1.0 : -1.0; }

Vec2 arcTangent(const Element& e, const Vec2& at) {
  return turnSign(e) * leftOf((at - e.center).normalized());
}

PlaneCurve offsetLine(const Vec2& point, const Vec2& tangent, double rho) {
  return {false, point + rho * leftOf(tangent), tangent, 0.0};
}
PlaneCurve offsetAtStart(const Element& e, double rho) {
  if (e.kind != ElementKind::kArc) return offsetLine(planar(e.p0), startTangent(e), rho);
  return {true, e.center, Vec2::UnitX(), std::abs((planar(e.p0) - e.center).norm() - turnSign(e) * rho)};
}
PlaneCurve offsetAtEnd(const Element& e, double rho) {
  if (e.kind != ElementKind::kArc) return offsetLine(planar(e.p1), endTangent(e), rho);
  return {true, e.center, Vec2::UnitX(), std::abs((planar(e.p1) - e.center).norm() - turnSign(e) * rho)};
}

/// The meeting point nearest to `p`; of two equally near ones the one behind `p` along `tangent`.
std::optional<Vec2> meetNearest(const PlaneCurve& a, const PlaneCurve& b, const Vec2& p,
                                const Vec2& tangent) {
  const Meeting m = meet(a, b);
  if (m.count == 0) return std::nullopt;
  if (m.count == 1) return m.points[0];
  const double d0 = (m.points[0] - p).norm(), d1 = (m.points[1] - p).norm();
  if (std::abs(d0 - d1) > kTinyLength) return m.points[d0 < d1 ? 0 : 1];
  return m.points[(m.points[0] - p).dot(tangent) < (m.points[1] - p).dot(tangent) ? 0 : 1];
}

enum class CornerClass { kStraight, kInner, kObtuse, kAcute };

/// Directions at a corner and everything that the corner lists need.
struct Turn {
  Vec2 p, t1, t2, n1, n2;
  double rho = 0.0;
  double delta = 0.0;  ///< rad, change of direction, > 0 to the left

  Turn(const Vec2& at, const Vec2& in, const Vec2& out, double offset)
      : p(at), t1(in), t2(out), n1(leftOf(in)), n2(leftOf(out)), rho(offset) {
    delta = std::atan2(cross2(t1, t2), t1.dot(t2));
  }
  Vec2 before() const { return p + rho * n1; }
  Vec2 behind() const { return p + rho * n2; }
  Vec2 tangentMeeting() const { return p + rho * (n1 + n2) / (1.0 + n1.dot(n2)); }
  Vec2 prolonged1() const { return before() + std::abs(rho) * t1; }
  Vec2 prolonged2() const { return behind() - std::abs(rho) * t2; }

  CornerClass classify() const {
    if (std::abs(delta) < kTangentTolerance) return CornerClass::kStraight;
    const double towards_tool = rho > 0.0 ? delta : -delta;
    if (std::abs(delta) >= kPi - kClassTolerance) return CornerClass::kAcute;
    if (towards_tool > 0.0) return CornerClass::kInner;
    return towards_tool >= -0.5 * kPi - kClassTolerance ? CornerClass::kObtuse : CornerClass::kAcute;
  }
};

/// The points of an outer corner: with the normal points where an arc needs them.
Corner outerCorner(const Turn& turn, bool normal_first, bool normal_last, const CutterCompPolicy& policy) {
  Corner corner;
  if (policy.outer_corner == CompOuterCorner::kArc) {
    corner.points = {turn.before(), turn.behind()};
    corner.arc_join = (turn.behind() - turn.before()).norm() > policy.arc_threshold &&
                      std::abs(turn.delta) >= policy.arc_least_turn_rad;
    if (!corner.arc_join && !normal_last) corner.points.pop_back();
    return corner;
  }
  if (normal_first) corner.points.push_back(turn.before());
  if (turn.classify() == CornerClass::kObtuse) {
    corner.points.push_back(turn.tangentMeeting());
  } else {
    corner.points.push_back(turn.prolonged1());
    corner.points.push_back(turn.prolonged2());
  }
  if (normal_last) corner.points.push_back(turn.behind());
  return corner;
}

Corner single(const Vec2& p) {
  Corner corner;
  corner.points = {p};
  return corner;
}

Corner failed(CompError error) {
  Corner corner;
  corner.error = error;
  return corner;
}

Corner insideCorner(const Element& a, const Element& b, const CutterCompPolicy& policy) {
  const Turn turn(planar(a.p1), endTangent(a), startTangent(b), a.rho_end);
  if (turn.rho == 0.0) return single(turn.p);
  switch (turn.classify()) {
    case CornerClass::kStraight:
      return single(turn.before());
    case CornerClass::kInner:
      break;
    case CornerClass::kObtuse:
    case CornerClass::kAcute:
      return outerCorner(turn, a.kind == ElementKind::kArc, b.kind == ElementKind::kArc, policy);
  }
  if (const auto x = meetNearest(offsetAtEnd(a, turn.rho), offsetAtStart(b, turn.rho), turn.p, turn.t1)) {
    return single(*x);
  }
  if (std::abs(turn.delta) >= kNearTangent) return failed(CompError::kNoIntersection);
  Corner corner;
  corner.points = {turn.before(), turn.behind()};
  corner.near_tangent = true;
  return corner;
}

/// 3.5: from an uncompensated line `a` to the first element `b`.
Corner startCorner(const Element& a, const Element& b, const CutterCompPolicy& policy) {
  // A change of side acts from the start of its block: right behind the start-up line only the new side
  // counts.
  const double rho = a.rho_end * b.rho_start < 0.0 ? b.rho_start : a.rho_end;
  const Vec2 p = planar(a.p1);
  const bool has_direction = b.kind == ElementKind::kLine || b.kind == ElementKind::kArc;
  if (a.kind == ElementKind::kZero) {
    const bool starts = has_direction && b.phase != ElementPhase::kCancel;
    return single(starts ? p + rho * leftOf(startTangent(b)) : p);
  }
  if (!has_direction || b.phase == ElementPhase::kCancel) return single(p + rho * leftOf(endTangent(a)));
  const Turn turn(p, endTangent(a), startTangent(b), rho);
  if (a.direction && a.direction->norm() > kTinyLength) {
    const Vec2 t = a.direction->normalized();
    const auto x = meetNearest(offsetLine(p, t, rho), offsetAtStart(b, rho), p, t);
    return single(x ? *x : turn.behind());
  }
  const CornerClass kind = turn.classify();
  if (rho == 0.0 || kind == CornerClass::kStraight || kind == CornerClass::kInner ||
      policy.start_ramp == CompRamp::kA) {
    return single(turn.behind());
  }
  return outerCorner(turn, false, b.kind == ElementKind::kArc, policy);
}

/// 3.7: from the last compensated element to the line that cancels.
Corner cancelCorner(const Element& a, const Element& b, const CutterCompPolicy& policy) {
  const Vec2 p = planar(a.p1), t1 = endTangent(a);
  const bool in_place = b.kind == ElementKind::kZero;
  Corner corner = single(p + a.rho_end * leftOf(t1));
  if (b.direction && b.direction->norm() > kTinyLength) {
    const Vec2 t = b.direction->normalized();
    if (const auto x = meetNearest(offsetAtEnd(a, a.rho_end), offsetLine(p, t, a.rho_end), p, t1)) {
      corner = single(*x);
    }
  } else if (!in_place && a.phase == ElementPhase::kInside && policy.cancel_ramp == CompRamp::kB) {
    const Turn turn(p, t1, startTangent(b), a.rho_end);
    const CornerClass kind = turn.classify();
    if (turn.rho != 0.0 && (kind == CornerClass::kObtuse || kind == CornerClass::kAcute)) {
      corner = outerCorner(turn, a.kind == ElementKind::kArc, false, policy);
    }
  }
  if (in_place) corner.points.push_back(p);
  return corner;
}

/// 3.8: the offsets before and after the corner have opposite signs.
Corner sideChangeCorner(const Element& a, const Element& b, const Vec2& from,
                        const CutterCompPolicy& policy) {
  const Vec2 p = planar(a.p1);
  const Vec2 behind = p + b.rho_start * leftOf(startTangent(b));
  if (const auto x =
          meetNearest(offsetAtEnd(a, a.rho_end), offsetAtStart(b, b.rho_start), p, endTangent(a))) {
    return single(*x);
  }
  Corner corner = single(behind);
  if (policy.square_side_change) {
    corner.points.insert(corner.points.begin(), p + a.rho_end * leftOf(endTangent(a)));
  } else if (a.kind == ElementKind::kArc) {
    Vec2 center;
    double sweep;
    if (!chordArc(a, from, behind, center, sweep)) return failed(CompError::kSideChange);
    corner.chord_arc = true;
  }
  return corner;
}

/// After an element that has no direction of its own.
Corner cornerBehindPoint(const Element& a, const Element& b, const Vec2& from) {
  const Vec2 p = planar(a.p1);
  const bool has_direction = b.kind == ElementKind::kLine || b.kind == ElementKind::kArc;
  Corner corner = single(from);
  if (a.kind == ElementKind::kCornerArc) {
    const bool own = a.direction && a.direction->norm() > kTinyLength;
    if (!own && !has_direction) return failed(CompError::kCornerArcInside);
    corner = single(p + a.rho_end * leftOf(own ? a.direction->normalized() : startTangent(b)));
  } else if (has_direction && b.phase != ElementPhase::kCancel) {
    corner = single(p + b.rho_start * leftOf(startTangent(b)));
  }
  if (b.phase == ElementPhase::kCancel && b.kind == ElementKind::kZero) corner.points.push_back(p);
  return corner;
}

Corner buildCorner(const Element& a, const Element* b, const Vec2& from, const CutterCompPolicy& policy) {
  const Vec2 p = planar(a.p1);
  if (a.square_end && !a.keep_vector) {
    const bool directed = a.kind == ElementKind::kLine || a.kind == ElementKind::kArc;
    Corner corner = single(directed ? Vec2(p + a.rho_end * leftOf(endTangent(a))) : from);
    if (b && b->phase == ElementPhase::kCancel && b->kind == ElementKind::kZero) corner.points.push_back(p);
    return corner;
  }
  if (b == nullptr) return single(p);
  const bool cancel = b->phase == ElementPhase::kCancel;
  if (a.keep_vector) {
    Corner corner = single(p + from - planar(a.p0));
    if (cancel && b->kind == ElementKind::kZero) corner.points.push_back(p);
    return corner;
  }
  if (a.phase == ElementPhase::kStartUp && !(cancel && b->kind == ElementKind::kZero)) {
    return startCorner(a, *b, policy);
  }
  if (a.kind == ElementKind::kZero || a.kind == ElementKind::kCornerArc)
    return cornerBehindPoint(a, *b, from);
  if (cancel) return cancelCorner(a, *b, policy);
  if (b->kind == ElementKind::kZero || b->kind == ElementKind::kCornerArc) {
    return single(p + a.rho_end * leftOf(endTangent(a)));
  }
  if (a.rho_end * b->rho_start < 0.0) return sideChangeCorner(a, *b, from, policy);
  return insideCorner(a, *b, policy);
}

/// Leaves out points that lie closer together than the control's limit in both coordinates.
void mergeClosePoints(Corner& corner, bool keep_last, double min_step) {
  std::vector<Vec2>& points = corner.points;
  if (corner.arc_join) return;
  for (std::size_t i = 1; i < points.size();) {
    if ((points[i] - points[i - 1]).cwiseAbs().maxCoeff() >= min_step) {
      ++i;
      continue;
    }
    const bool later_stays = keep_last && i + 1 == points.size();
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(later_stays ? i - 1 : i));
    if (later_stays) break;
  }
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * kPi); }

double angleAbout(const Vec2& center, const Vec2& p, double radius_sign) {
  const Vec2 d = radius_sign < 0.0 ? Vec2(center - p) : Vec2(p - center);
  return std::atan2(d.y(), d.x());
}

}  // namespace

Vec2 startTangent(const Element& e) {
  if (e.kind == ElementKind::kArc) return arcTangent(e, planar(e.p0));
  return (planar(e.p1) - planar(e.p0)).normalized();
}

Vec2 endTangent(const Element& e) {
  if (e.kind == ElementKind::kArc) return arcTangent(e, planar(e.p1));
  return (planar(e.p1) - planar(e.p0)).normalized();
}

double offsetRadiusAtStart(const Element& e) {
  return (planar(e.p0) - e.center).norm() - turnSign(e) * e.rho_start;
}
double offsetRadiusAtEnd(const Element& e) {
  return (planar(e.p1) - e.center).norm() - turnSign(e) * e.rho_end;
}

Corner makeCorner(const Element& a, const Element* b, const Vec2& from, const CutterCompPolicy& policy) {
  Corner corner = buildCorner(a, b, from, policy);
  const bool in_place = b && b->phase == ElementPhase::kCancel && b->kind == ElementKind::kZero;
  mergeClosePoints(corner, in_place || (b && b->kind == ElementKind::kArc), policy.min_step);
  return corner;
}

std::optional<Vec2> meetOffsets(const Element& a, const Element& b) {
  return meetNearest(offsetAtEnd(a, a.rho_end), offsetAtStart(b, b.rho_start), planar(a.p1), endTangent(a));
}

std::optional<Vec2> meetLines(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  const Vec2 a = a1 - a0, b = b1 - b0;
  if (a.norm() < kTinyLength || b.norm() < kTinyLength) return std::nullopt;
  const Meeting m = meet({false, a0, a.normalized(), 0.0}, {false, b0, b.normalized(), 0.0});
  if (m.count == 0) return std::nullopt;
  return m.points[0];
}

double offsetSweep(const Element& arc, const Vec2& from, const Vec2& to) {
  const double at_start = wrapped(angleAbout(arc.center, from, offsetRadiusAtStart(arc)) -
                                  angleAbout(arc.center, planar(arc.p0), 1.0));
  const double at_end = wrapped(angleAbout(arc.center, to, offsetRadiusAtEnd(arc)) -
                                angleAbout(arc.center, planar(arc.p1), 1.0));
  return std::abs(arc.sweep) + turnSign(arc) * (at_end - at_start);
}

bool runsBackwards(const Element& e, const Vec2& from, const Vec2& to) {
  if (e.kind == ElementKind::kLine) {
    return startTangent(e).dot(to - from) < -kReverseTolerance;
  }
  const double r0 = offsetRadiusAtStart(e), r1 = offsetRadiusAtEnd(e);
  if (std::min(r0, r1) < -kReverseTolerance) return true;
  const double radius = std::max(r0, r1);
  return radius > kReverseTolerance && offsetSweep(e, from, to) * radius < -kReverseTolerance;
}

bool chordArc(const Element& arc, const Vec2& from, const Vec2& to, Vec2& center, double& sweep) {
  const double radius = (planar(arc.p1) - arc.center).norm();
  const Vec2 chord = to - from;
  const double length = chord.norm();
  if (length < kTinyLength || length > 2.0 * radius) return false;
  const double height = std::sqrt(std::max(0.0, radius * radius - 0.25 * length * length));
  const double minor = 2.0 * std::asin(std::min(1.0, 0.5 * length / radius));
  const double programmed = std::abs(arc.sweep);
  const bool take_minor = std::abs(programmed - minor) <= std::abs(programmed - (2.0 * kPi - minor));
  const double side = turnSign(arc) * (take_minor ? 1.0 : -1.0);
  center = 0.5 * (from + to) + leftOf(chord) * (side * height / length);
  sweep = turnSign(arc) * (take_minor ? minor : 2.0 * kPi - minor);
  return true;
}

}  // namespace proveout::comp_detail
