// Motions with axes besides X Y Z: turning tables, parallel axes in arcs, planes with a rotary axis. The path
// in the part is a line or an arc where it is one exactly; else it goes along chords, or, where the tool's
// axis turns, by the law of its axes.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/degrees.h"
#include "core/nc/services/virtual_plane.h"
#include "core/nc/stages/axis_arc.h"
#include "core/nc/stages/path_emitter.h"

namespace proveout::nc {
namespace {

/// A path this near to a line or an arc is one: rounding noise of the coordinates.
constexpr double kShapeMm = 1e-7;
/// Largest angle that the tool's direction turns in one motion: it must say which way round.
constexpr double kAxisTurnRad = 0.5 * kPi;
/// Most pieces of one motion before the tolerance divides them further: 100 turns.
constexpr int kMaxPieces = 3600;

int piecesOf(double angle, double largest) {
  const double pieces = std::ceil(std::abs(angle) / largest - 1e-9);
  return std::clamp(pieces < kMaxPieces ? static_cast<int>(pieces) : kMaxPieces, 1, kMaxPieces);
}

}  // namespace

Vec2 PolarLeg::at(double t) const {
  if (arc) return pointOfArc(from, to, arc->center, arc->sweep_rad, t);
  return from + (to - from) * t;
}

double PolarLeg::length() const {
  if (!arc) return (to - from).norm();
  return arcLength((from - arc->center).norm(), (to - arc->center).norm(), arc->sweep_rad, 0.0);
}

Vec2 PolarPlane::of(const AxisPoint& machine) const {
  const auto [s, c] = sinCosDegrees(machine[rotary] - zero_deg);
  return (machine[linear] - zero) * Vec2(c, s);
}

PathEmitter::Shape PathEmitter::shapeOf(const MachineCurve& at, const ArcGeometry* arc) const {
  const Vec3 from = toolPoint(at(0.0)), to = toolPoint(at(1.0));
  const double scale = 1e-12 * std::max(from.norm(), to.norm());
  Shape shape;
  bool line = true, circle = arc != nullptr;
  ArcFrame frame;
  if (circle) frame = arcFrame(from, to, *arc);
  for (const double t : kProbes) {
    const Vec3 p = toolPoint(at(t));
    line = line && (p - (from + (to - from) * t)).norm() <= kShapeMm + scale;
    circle = circle && (p - arcPoint(frame, *arc, t)).norm() <= kShapeMm + scale;
  }
  if (line) {
    shape.kind = Shape::Kind::kLine;
  } else if (circle) {
    shape.kind = Shape::Kind::kArc;
    shape.arc = *arc;
  }
  return shape;
}

void PathEmitter::sendPiece(Motion& piece, const AxisPoint& to, const ArcGeometry* arc, double length,
                            const AxisSweep* sweep) {
  if (piece.kind != MotionKind::kRapid && piece.time_s > 0.0) {
    const double feed = 60.0 * length / piece.time_s;
    if (length > 0.0 && std::abs(feed - piece.feed) > 1e-9 * feed) piece.feed = feed;
  }
  piece.from = toolPoint(machine_);
  piece.to = toolPoint(to);
  piece.tool = tool_;
  if (piece.spindle == 0.0) piece.spindle = spindle_;
  piece.arc = arc != nullptr ? 0 : -1;
  const AxisPoint from = machine_;
  machine_ = to;
  if (any_limit_) checkMachineTravel(from, piece.source);
  ++summary_.motions;
  time_.pass(piece, arc, sweep);
}

void PathEmitter::sendCurve(const Motion& whole, const MachineCurve& at, const ArcGeometry* arc) {
  time_.flush();  // these motions have their own times
  const Shape shape = shapeOf(at, arc);
  const AxisPoint start = at(0.0);
  const double turned = chain_->turned(start, at(1.0));
  double done = 0.0;
  const auto piece = [&](double t) {
    Motion m = whole;
    m.time_s = whole.time_s * (t - done);
    const AxisPoint to = at(t);
    const Vec3 from = toolPoint(machine_), end = toolPoint(to);
    if (shape.kind == Shape::Kind::kArc) {
      ArcGeometry part = shape.arc;
      part.center += part.normal * part.normal.dot(from - part.center);
      part.sweep_rad *= t - done;
      const ArcFrame f = arcFrame(from, end, part);
      sendPiece(m, to, &part, arcLength(f.radius_start, f.radius_end, part.sweep_rad, f.rise), sweepTo(to));
    } else {
      sendPiece(m, to, nullptr, (end - from).norm(), sweepTo(to));
    }
    done = t;
  };
  if (shape.kind == Shape::Kind::kOther) {
    const double bends = turned + (arc != nullptr ? std::abs(arc->sweep_rad) : 0.0);
    divideCurve([&](double t) { return toolPoint(at(t)); }, piecesOf(std::max(bends, kPi), kCurvePieceRad),
                kCurveChordMm, piece);
    return;
  }
  const bool upright =
      chain_->toolAxis(start) == Vec3::UnitZ() && chain_->toolAxis(at(0.618)) == Vec3::UnitZ();
  const int pieces = upright ? 1 : piecesOf(turned, kAxisTurnRad);
  for (int k = 1; k <= pieces; ++k) piece(static_cast<double>(k) / pieces);
}

void PathEmitter::sendTurned(const Motion& motion, const AxisPoint& to) {
  const AxisPoint start = machine_;
  const MachineCurve at = [&start, &to](double t) { return between(start, to, t); };
  const auto upright = [&](double t) { return chain_->toolAxis(at(t)) == Vec3::UnitZ(); };
  const bool stands = upright(0.0) && upright(0.618);
  ArcGeometry arc;
  const MachineChain::Turn turn = chain_->onlyTurn(start, to);
  if (turn.axis < 0) return stands ? sendCurve(motion, at, nullptr) : sendByAxes(motion, to);
  arc.normal = turn.direction;
  arc.center = turn.point + arc.normal * arc.normal.dot(toolPoint(start) - turn.point);
  arc.sweep_rad = degToRad(turn.sign * (to[turn.axis] - start[turn.axis]));
  // A direction at right angles to the axis turns in one plane; others go along cones.
  constexpr double kRight = 1e-12;
  const bool in_plane = std::abs(turn.direction.dot(chain_->toolAxis(start))) < kRight &&
                        shapeOf(at, &arc).kind != Shape::Kind::kOther;
  if (!stands && !in_plane) return sendByAxes(motion, to);
  sendCurve(motion, at, &arc);
}

void PathEmitter::furtherArc(const AxisPoint& to, const MachineArc& arc, const FeedStyle& style,
                             const SourceRef& source) {
  const AxisPoint start = machine_;
  const WorkPlane& plane = arc.plane;
  const AxisArc way(start, to, arc);
  AxisPoint center = start;
  Vec3 normal = arc.normal;
  if (way.isMain()) {
    center.xyz = arc.center;
  } else {
    const auto direction = [&](int axis) {
      return Vec3(Vec3::Unit(axis < kMainAxes ? axis : axes_.at(axis).parallel_to));
    };
    center[plane.u] = arc.center.x();
    center[plane.v] = arc.center.y();
    normal = direction(plane.u).cross(direction(plane.v));
  }
  // Seen from the part: heads lean the tool, and not the arc.
  AxisPoint above = center;
  above.xyz += normal;
  const ArcGeometry guess{toolPoint(center), (toolPoint(above) - toolPoint(center)).normalized(),
                          arc.sweep_rad};
  Motion m;
  m.spindle = style.spindle;
  m.kind = style.kind;
  m.feed = style.feed;
  m.time_s = 60.0 * way.pacedLength(style, axes_.count(), style.slaves) / style.feed;
  m.source = source;
  sendCurve(
      m, [&way](double t) { return way.at(t); }, &guess);
}

/// Duration of a feed motion in a polar plane, min; `others` is the way of the axes outside it.
double PathEmitter::polarMinutes(const PolarPlane& plane, const PolarLeg& leg, const FeedStyle& style,
                                 double others) const {
  const double in_plane = leg.length();
  const double length = std::hypot(in_plane, others);
  if (!(in_plane > 0.0)) return length / style.feed;
  const bool plane_only = leg.arc && style.along == FeedStyle::Along::kPlane;
  const double feed = plane_only ? style.feed : style.feed * in_plane / length;
  const double rate = degToRad(time_.limits().axes[static_cast<std::size_t>(plane.rotary)].max_feed);
  if (!(rate > 0.0)) return in_plane / feed;
  const int pieces = leg.arc ? piecesOf(leg.arc->sweep_rad, kCurvePieceRad / 5) : 1;
  double minutes = 0.0;
  Vec2 last = leg.from;
  for (int k = 1; k <= pieces; ++k) {
    const Vec2 q = leg.at(static_cast<double>(k) / pieces);
    // The speed limit at the chord, the length of the arc.
    const double chord = (q - last).norm();
    const double stretch = leg.arc && chord > 0.0 ? in_plane / pieces / chord : 1.0;
    minutes += polarLineMinutes(last, q, feed, rate) * stretch;
    last = q;
  }
  return minutes;
}

/// A circle of the plane as it is in the part if the rotary axis turns it about the plane's origin.
std::optional<ArcGeometry> PathEmitter::polarCircle(const PolarPlane& plane, const PolarArc& arc) const {
  AxisPoint center = machine_, origin = machine_, aside = machine_;
  center[plane.linear] = plane.zero + arc.center.norm();
  center[plane.rotary] = plane.zero_deg + radToDeg(std::atan2(arc.center.y(), arc.center.x()));
  // Two directions of the plane in the part, seen from its origin.
  origin[plane.linear] = plane.zero;
  origin[plane.rotary] = aside[plane.rotary] = plane.zero_deg;
  aside[plane.linear] = plane.zero + 1.0;
  const Vec3 along = toolPoint(aside) - toolPoint(origin);
  aside[plane.rotary] = plane.zero_deg + 90.0;
  const Vec3 normal = along.cross(toolPoint(aside) - toolPoint(origin));
  if (!(normal.norm() > 0.5)) return std::nullopt;
  return ArcGeometry{toolPoint(center), normal.normalized(), arc.sweep_rad};
}

double PathEmitter::polarError(const PolarPlane& plane) const {
  AxisPoint at = machine_, opposite = machine_;
  at[plane.linear] = opposite[plane.linear] = plane.zero;
  opposite[plane.rotary] = at[plane.rotary] + 180.0;
  return 0.5 * (toolPoint(at) - toolPoint(opposite)).norm();
}

void PathEmitter::polarTo(const AxisPoint& to, const PolarPlane& plane, const std::optional<PolarArc>& arc,
                          const FeedStyle* style, const SourceRef& source) {
  const AxisPoint start = machine_;
  const PolarLeg leg{plane.of(start), plane.of(to), arc};
  const MachineCurve at = [&](double t) {
    AxisPoint p = between(start, to, t);
    if (t >= 1.0) return p;
    const Vec2 q = leg.at(t);
    p[plane.linear] = plane.zero + plane.sign * q.norm();
    // The whole turns are those of the way between start and end.
    const double angle = plane.zero_deg + radToDeg(std::atan2(plane.sign * q.y(), plane.sign * q.x()));
    if (q.norm() > 1e-12) p[plane.rotary] += std::remainder(angle - p[plane.rotary], 360.0);
    return p;
  };
  double others2 = 0.0, slowest = leg.length() / axes_.at(plane.linear).rapid;
  for (int k = 0; k < axes_.count(); ++k) {
    const double d = std::abs(to[k] - start[k]);
    if (k != plane.linear) slowest = std::max(slowest, d / axes_.at(k).rapid);
    const bool slave = style != nullptr && style->slaves.test(static_cast<std::size_t>(k));
    if (k != plane.linear && k != plane.rotary && !slave) others2 += d * d;
  }
  if (!(leg.length() + others2 > 1e-9)) return;
  Motion m;
  m.source = source;
  m.kind = style != nullptr ? style->kind : MotionKind::kRapid;
  m.feed = style != nullptr ? style->feed : 0.0;
  if (style != nullptr) m.spindle = style->spindle;
  m.time_s = 60.0 * (style != nullptr ? polarMinutes(plane, leg, *style, std::sqrt(others2)) : slowest);
  const auto guess = arc ? polarCircle(plane, *arc) : std::nullopt;
  sendCurve(m, at, guess ? &*guess : nullptr);
}

}  // namespace proveout::nc
