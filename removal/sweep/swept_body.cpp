#include "removal/sweep/swept_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/sweep/column_curve.h"
#include "removal/sweep/column_way.h"

namespace proveout {

namespace {

/// Least radius of a wall, mm.
constexpr double kLeastRadius = 1e-9;
/// Rounding of bounds of a depth, mm.
constexpr double kDepthSlackMm = 1e-10;
/// A turn that rises by no more than this part of its way is as good as level.
constexpr double kLevel = 1e-4;

}  // namespace

/// Of this line or chord.
SweptField SweptBody::ownField() const {
  const Vec3 from = sweepStart(columns_);
  return SweptField(*profile_, from, from + sweepWay(columns_), nullptr);
}

SweptField SweptBody::field() const { return whole_ != nullptr ? *whole_ : ownField(); }

double SweptBody::distance(const Vec3& p, double cutoff) const {
  return whole_ != nullptr ? whole_->distance(p, cutoff) : ownField().distance(p, cutoff);
}

/// Chords of a helix are many. Flat and ball ends have closed forms on them, which are faster.
bool SweptBody::isAskedWhole() const {
  if (whole_ == nullptr || isLevelArc() || isCurvePart() || solid().flat || solid().ball) return false;
  return whole_->replacesChords();
}

double SweptBody::wholeCut(const Vec3& a, const Vec3& direction, double inside) const {
  return searchCut(field(), a, direction, inside);
}

double SweptBody::coveredTop() const {
  if (solid().round_top) return -std::numeric_limits<double>::infinity();
  return columns_.z + std::min(columns_.rise, 0.0) + solid().z_max;
}

/// The tool's axis at its nearest to the column, level: no nearer than this to any of its places, mm.
double SweptBody::levelGap(double x, double y) const {
  const ColumnSweep& c = columns_;
  const double qx = x - c.x, qy = y - c.y;
  if (isLevelArc() || c.kind == ColumnSweep::Kind::kTurn)
    return std::abs(std::sqrt(qx * qx + qy * qy) - c.arc_radius);
  const double along = qx * c.ux + qy * c.uy, across = qx * c.uy - qy * c.ux;
  if (c.kind == ColumnSweep::Kind::kWay) return wayGap(c, x, y);
  const bool upright = c.kind == ColumnSweep::Kind::kUpright;
  const double beyond = along - std::clamp(along, upright ? c.first_mm : 0.0, upright ? c.last_mm : c.length);
  return std::sqrt(across * across + beyond * beyond);
}

double SweptBody::mostDepth(double x, double y) const {
  const ColumnSolid& tool = solid();
  const double gap = levelGap(x, y), in = std::min(gap, tool.radius);
  // Half of what the solid has above the point's radius and below it.
  const double half = -0.5 * (tool.upper.height(in) + tool.lower.height(in));
  return std::min(tool.radius - gap, half) + kDepthSlackMm;
}

bool SweptBody::holdsEdges(double h, const Vec2& middle, double reach) const {
  if (isConvex()) return true;
  if (columns_.twice) return false;
  if (columns_.kind == ColumnSweep::Kind::kTurn) {
    const double c = std::cos(columns_.cut_rad), s = columns_.turn * std::sin(columns_.cut_rad);
    const Vec2 u(columns_.ux, columns_.uy), cut(c * u.x() - s * u.y(), s * u.x() + c * u.y());
    const Vec2 q = middle - Vec2(columns_.x, columns_.y);
    const Vec2 nearest = std::max(0.0, q.dot(cut)) * cut;
    if ((q - nearest).squaredNorm() < reach * reach) return false;
    if (columns_.way_rad <= kPi) return true;
  } else if (!isLevelArc() || !(columns_.wide || columns_.full)) {
    return true;
  }
  const double pillar = columns_.arc_radius - solid().radius;
  return pillar <= 0.0 || pillar >= h;
}

std::optional<double> SweptBody::simpleBend(int element) const {
  if (element >= ConvexProfile::kEdgeIds) return std::nullopt;
  const int number = element - profile_->firstElementId();
  if (number >= profile_->elementCount()) return std::nullopt;
  const ConvexProfile::Element& e = profile_->element(number);
  if (!isLine() && (e.arc || !isLevelArc())) return std::nullopt;
  if (e.arc) return e.cr == 0.0 ? std::optional(1.0 / e.radius) : std::nullopt;
  if (e.dz == 0.0) return 0.0;
  if (e.dr != 0.0) return std::nullopt;
  const double inner = isLine() ? e.ar : std::abs(columns_.arc_radius - e.ar);
  return 1.0 / std::max(std::min(e.ar, inner), kLeastRadius);
}

Vec3 SweptBody::directionAt(const Vec3& p) const {
  const ColumnSweep& c = columns_;
  // A level arc whose end is off its circle by the rounding of a program's digits is a turn.
  const bool turn = c.kind == ColumnSweep::Kind::kTurn && std::abs(c.slope) < kLevel * c.arc_radius;
  if (turn || isLevelArc()) return c.turn * Vec3(c.y - p.y(), p.x() - c.x, 0.0).stableNormalized();
  return isLine() && c.length > 0.0 ? Vec3(c.ux, c.uy, c.slope).normalized() : Vec3::Zero();
}

double SweptBody::startOf(double place) const {
  const ColumnSweep& c = columns_;
  if (c.kind == ColumnSweep::Kind::kWay) return std::clamp(place / c.way->way_rad, 0.0, 1.0);
  if (c.kind == ColumnSweep::Kind::kTurn) return std::clamp(place / c.way_rad, 0.0, 1.0);
  const double high = std::sqrt(std::max(0.0, (c.arc_radius - place) * (c.arc_radius + place)));
  return whole_->parameterAt(Vec3(c.x + place * c.ux, c.y + place * c.uy, c.start_z + c.side * high));
}

/// Parameter of the whole curve at about which it leaves its surface at a point of this part.
double SweptBody::startAt(const Vec3& p) const {
  const ColumnSweep& c = columns_;
  if (!isCurvePart()) return whole_->parameterAt(sweepStart(c) + 0.5 * sweepWay(c));
  return startOf(curveSide(c, {p.x(), p.y(), p.z()}, 0.0, 0.0).place);
}

SweptSurface SweptBody::surface(const Vec3& p, int axis, bool below, double start) const {
  if (const auto closed = closedSurface(p, axis, below)) return *closed;
  if (whole_ == nullptr) {
    const SweepSample sample = ownField().sample(p);
    return {sample.gradient, sample.element};
  }
  const SweepSample sample = whole_->sampleOnSurface(p, start >= 0.0 ? start : startAt(p));
  return {sample.gradient, sample.element};
}

namespace {

double turnOf(const ColumnSweep& arc) {
  const double turn = std::atan2(arc.sin_sweep, arc.cos_sweep);
  return arc.full ? 2.0 * kPi : turn < 0.0 ? turn + 2.0 * kPi : turn;
}

}  // namespace

std::optional<double> SweptBody::ownLength() const {
  if (isCurvePart()) return std::nullopt;
  return isLevelArc() ? turnOf(columns_) * columns_.arc_radius : sweepWay(columns_).norm();
}

ToolPlace SweptBody::placeAt(double t) const {
  const ColumnSweep& c = columns_;
  if (!isLevelArc()) return {sweepStart(c) + t * sweepWay(c), {c.ux, c.uy}};
  const double a = t * turnOf(c) * c.turn, dx = c.start_x - c.x, dy = c.start_y - c.y;
  const Vec2 out(dx * std::cos(a) - dy * std::sin(a), dx * std::sin(a) + dy * std::cos(a));
  return {Vec3(c.x + out.x(), c.y + out.y(), c.z), Vec2(-out.y(), out.x()) / c.arc_radius};
}

}  // namespace proveout
