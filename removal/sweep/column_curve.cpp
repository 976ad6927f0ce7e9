// The intervals of z that a solid covers on a turn of a helix about z, or on an upright arc.
//
// A column sees the tool's axis at the level distance sqrt(p2 + k2 u^2): on an upright arc u is the way along
// the level direction from the nearest place, k2 = 1 and p2 the square of the distance to the side; on a
// helix of radius r about an axis at distance d, u is the sine of half the angle from the nearest place of
// the turn, k2 = 4 r d and p2 = (r - d)^2. On both the places over a column are one stretch of u, so that
// what covers it is one interval; its lower end is the least of L(level distance) + height. The first term is
// convex in u, the height convex or concave on either side of u = 0. So the slope of either is known between
// two places, and the least value lies between the places where the boundary is as steep as the height is at
// its least and at its most; these have closed forms on cones and spheres, and taken over and over they meet.
// On corners of a torus, and where they do not, Newton's method finds the least value where the sum is
// convex; elsewhere stretches are halved until they are convex, concave, or bounded by the support lines of
// the first term and the chord of the height.
#include "removal/sweep/column_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/assert.h"
#include "core/geometry/types.h"
#include "removal/sweep/column_angle.h"
#include "removal/sweep/column_interval.h"
#include "removal/sweep/column_way.h"

namespace proveout {

namespace {

using Piece = ColumnBoundary::Piece;
using PieceKind = ColumnBoundary::Kind;

/// A stretch is settled where nothing on it is lower than the best by more, mm.
constexpr double kSettledMm = 1e-11;
/// Newton's method stops behind a step this small, mm: what follows is off by its square.
constexpr double kStepMm = 1e-6;
/// Stretches this short in u hold no more than their ends.
constexpr double kShortest = 1e-10;
constexpr int kMostRounds = 80;
/// How often a stretch is narrowed down before it is halved.
constexpr int kMostShrinks = 6;
/// Halves that wait; a stretch of length 1 is below kShortest after 34.
constexpr int kMostStretches = 48;

/// Where a sum stops to fall on a piece, and from where on it falls again.
struct Roots {
  double rises = kNoHeight, again = kNoHeight;
};

/// Height on one side of u = 0, v = |u|.
struct TurnHeight {
  double steep;  ///< twice the rise a radian, away from v = 0
  bool climbs() const { return steep >= 0.0; }
  static constexpr bool bendsUp() { return false; }
  double value(double v) const { return steep == 0.0 ? 0.0 : steep * arcSine(std::min(v, 1.0)); }
  double least(double a, double b) const { return value(steep < 0.0 ? b : a); }
  double slope(double v) const { return steep == 0.0 ? 0.0 : steep / root(1.0 - v * v); }
  double bend(double v) const {
    const double c = root(1.0 - v * v);
    return steep == 0.0 ? 0.0 : steep * v / (c * c * c);
  }
  /// Least |bend| between two places.
  double leastBend(double a, double) const { return std::abs(bend(a)); }
  /// Where the way is as steep as a cone or sphere, of which the sum falls up to the first place, and again
  /// behind the second: see column_curve_body.h.
  bool roots(const Piece& piece, double p2, double k2, Roots& out) const {
    const bool ball = piece.kind == PieceKind::kArc;
    const double rise_k = ball ? 1.0 : piece.slope * piece.slope * k2, steep2 = steep * steep;
    const double middle = ball ? k2 + steep2 : rise_k - steep2;
    const double last = ball ? steep2 * (piece.radius * piece.radius - p2) / k2 : steep2 * p2 / k2;
    const double first = ball ? k2 : rise_k, inner = middle * middle - 4.0 * first * last;
    if (!(middle > 0.0 && inner >= 0.0)) return true;
    const double sum = middle + std::sqrt(inner);
    out = {std::sqrt(2.0 * last / sum), std::sqrt(0.5 * sum / first)};
    return true;
  }
};

struct UprightHeight {
  double at, way;       ///< place from the center at v = 0, mm; +1, -1: how it goes with v
  double radius, side;  ///< of the circle; -1: lower half, +1: upper
  static constexpr bool climbs() { return false; }
  bool bendsUp() const { return side < 0.0; }
  double half(double x) const { return root((radius - x) * (radius + x)); }
  double value(double v) const { return side * half(at + way * v); }
  double least(double a, double b) const { return side < 0.0 ? -radius : std::min(value(a), value(b)); }
  double slope(double v) const {
    const double x = at + way * v, q = half(x);
    return x == 0.0 ? 0.0 : -side * way * x / q;
  }
  double bend(double v) const {
    const double q = half(at + way * v);
    return -side * radius * radius / (q * q * q);
  }
  double leastBend(double a, double b) const {
    const double xa = at + way * a, xb = at + way * b;
    return xa * xb <= 0.0 ? 1.0 / radius : std::min(std::abs(bend(a)), std::abs(bend(b)));
  }
  /// With a disc on the lower half of the circle, and with a sphere, there is one such place or none.
  bool roots(const Piece& piece, double p2, double, Roots& out) const {
    const bool lower = side < 0.0;
    if (piece.kind == PieceKind::kLevel && lower) {
      out.rises = -way * at;
      return true;
    }
    if (piece.kind != PieceKind::kArc) return false;
    const double w = root(piece.radius * piece.radius - p2);
    if (!lower && std::abs(at) >= radius - w) return false;
    out.rises = lower ? -way * at * w / (radius + w) : way * at * w / (radius - w);
    return true;
  }
};

/// The least of boundary + height over a stretch of v >= 0, v = way * u, if it is below `best`.
template <typename Height>
class Least {
 public:
  Least(const ColumnBoundary& boundary, double p2, double k2, double way, const Height& height,
        const Lowest& best)
      : boundary_(boundary), p2_(p2), k2_(k2), way_(way), height_(height), best_(best) {}

  Lowest over(double from, double to) {
    if (height_.climbs()) to = from;
    const double lowest = height_.least(from, to);
    for (int i = 0; i < boundary_.count; ++i) {
      piece_ = &boundary_.piece[i];
      const double ra = piece_->ra, rb = piece_->rb;
      if (i + 1 < boundary_.count && p2_ > rb * rb) continue;
      const double a = i == 0 ? from : std::max(from, root((ra * ra - p2_) / k2_));
      const double b = i + 1 == boundary_.count ? to : std::min(to, root((rb * rb - p2_) / k2_));
      if (a > b) continue;
      // The boundary rises from piece to piece.
      if (foot(radial(a)).value + lowest >= best_.value - kSettledMm) break;
      overPiece(a, b);
    }
    return best_;
  }

 private:
  /// The boundary's part of the sum and the height's.
  struct Place {
    double v, foot, foot_slope, height, height_slope;
    double value() const { return foot + height; }
    double slope() const { return foot_slope + height_slope; }
  };
  /// Derivatives of the level distance and of the boundary by it.
  struct Radial {
    double r, slope, bend;
  };

  double radial(double v) const { return std::sqrt(p2_ + k2_ * v * v); }
  Radial radialBend(double v) const {
    const double r = radial(v);
    if (r == 0.0) return {0.0, std::sqrt(k2_), 0.0};
    return {r, k2_ * v / r, k2_ * p2_ / (r * r * r)};
  }
  BoundaryPlace foot(double r) const { return boundaryAt(*piece_, r); }
  double bendOfFoot(double r) const { return boundaryBend(*piece_, r); }
  void offer(double v, double value) {
    if (value < best_.value) best_ = {value, way_ * v};
  }
  void offer(const Place& p) { offer(p.v, p.value()); }
  double value(double v) const { return foot(radial(v)).value + height_.value(v); }
  Place place(double v) const {
    const double r = radial(v), slope = r == 0.0 ? std::sqrt(k2_) : k2_ * v / r;
    const BoundaryPlace b = foot(r);
    return {v, b.value, slope == 0.0 ? 0.0 : b.slope * slope, height_.value(v), height_.slope(v)};
  }
  double footBend(double v) const {
    const Radial r = radialBend(v);
    return bendOfFoot(r.r) * r.slope * r.slope + foot(r.r).slope * r.bend;
  }

  void overPiece(double from, double to) {
    if (shrink(from, to)) {
      offer(from, value(from));
      return;
    }
    const Place first = place(from), last = place(to);
    offer(first);
    offer(last);
    if (from == to) return;
    stretches_[0] = {first, last};
    for (int size = 1; size > 0;) {
      const auto [a, b] = stretches_[static_cast<std::size_t>(--size)];
      if (isSettled(a, b)) continue;
      if (isConvex(a, b)) {
        if (a.slope() < 0.0 && b.slope() > 0.0) offer(newton(a, b));
        continue;
      }
      if (b.v - a.v < kShortest || size + 2 > kMostStretches) continue;
      const Place middle = place(0.5 * (a.v + b.v));
      offer(middle);
      stretches_[static_cast<std::size_t>(size++)] = {middle, b};
      stretches_[static_cast<std::size_t>(size++)] = {a, middle};
    }
  }

  /// Where the boundary's slope along the stretch becomes `steep` > 0: no place before is steeper, none
  /// behind less steep. On straight pieces and spheres.
  double placeOf(double steep) const {
    const double k = std::sqrt(k2_);
    if (piece_->kind == PieceKind::kArc) {
      const double across = root(piece_->radius * piece_->radius - p2_);
      return steep < kNoHeight ? steep * across / (k * std::sqrt(k2_ + steep * steep)) : across / k;
    }
    const double most = piece_->slope * k, left = (most - steep) * (most + steep);
    return most > steep ? steep / k * std::sqrt(p2_ / left) : kNoHeight;
  }

  /// Narrows the stretch to what may hold the least value; true if that is one place, `from`.
  bool shrink(double& from, double& to) const {
    if (from == to) return true;
    if (piece_->kind == PieceKind::kArc && piece_->rc != 0.0) return false;
    if (Roots roots; height_.roots(*piece_, p2_, k2_, roots) && roots.again >= to) {
      from = to = std::clamp(roots.rises, from, to);
      return true;
    }
    if (height_.bendsUp()) return false;  // convex: Newton's method finds it at once
    double steep_from = -height_.slope(from), steep_to = -height_.slope(to);
    for (int round = 0; round < kMostShrinks; ++round) {
      const double least = std::min(steep_from, steep_to), most = std::max(steep_from, steep_to);
      const double a = least > 0.0 ? std::clamp(placeOf(least), from, to) : from;
      const double b = most > 0.0 ? std::clamp(placeOf(most), a, to) : a;
      const bool helps = b - a < 0.5 * (to - from);
      if (a > from) steep_from = -height_.slope(a);
      if (b < to) steep_to = -height_.slope(b);
      from = a;
      to = b;
      if ((to - from) * std::sqrt(k2_) < kStepMm) return true;
      if (!helps) return false;
    }
    return false;
  }

  /// Nothing between is lower than the best, by bounds or because the sum is concave.
  bool isSettled(const Place& a, const Place& b) const {
    const double width = b.v - a.v, ends = std::min(a.value(), b.value());
    const bool bent_down = b.height_slope < a.height_slope;
    // A chord lies below a height that is concave, a support line below one that is convex.
    const double chord = (b.height - a.height) / width;
    const double sa = a.foot_slope + (bent_down ? chord : a.height_slope),
                 sb = b.foot_slope + (bent_down ? chord : b.height_slope);
    double low = ends;
    if (sa < 0.0 && sb > 0.0) {
      const double t = sb < kNoHeight ? (b.value() - a.value() - sb * width) / (sa - sb) : width;
      low = a.value() + sa * std::clamp(t, 0.0, width);
    }
    if (low >= best_.value - kSettledMm) return true;
    if (!bent_down) return false;
    const Radial ra = radialBend(a.v), rb = radialBend(b.v);
    const double most = bendOfFoot(rb.r) * rb.slope * rb.slope + foot(rb.r).slope * ra.bend;
    return most <= height_.leastBend(a.v, b.v);
  }

  bool isConvex(const Place& a, const Place& b) const {
    if (b.height_slope >= a.height_slope) return true;
    const Radial ra = radialBend(a.v), rb = radialBend(b.v);
    const double least = bendOfFoot(ra.r) * ra.slope * ra.slope + foot(ra.r).slope * rb.bend;
    return least >= std::max(std::abs(height_.bend(a.v)), std::abs(height_.bend(b.v)));
  }

  Place newton(const Place& a, const Place& b) const {
    double low = a.v, high = b.v;
    double t =
        b.slope() < kNoHeight ? low - a.slope() * (high - low) / (b.slope() - a.slope()) : 0.5 * (low + high);
    for (int round = 0; round < kMostRounds; ++round) {
      if (!(t > low && t < high)) t = 0.5 * (low + high);
      const double slope = place(t).slope();
      (slope < 0.0 ? low : high) = t;
      const double step = slope / (footBend(t) + height_.bend(t)), next = t - step;
      const bool in = next > low && next < high;
      const double moved = in ? std::abs(step) : 0.5 * (high - low);
      t = in ? next : 0.5 * (low + high);
      if (moved * std::sqrt(k2_) < kStepMm) break;
    }
    return place(t);
  }

  const ColumnBoundary& boundary_;
  double p2_, k2_, way_;
  Height height_;
  Lowest best_;
  const Piece* piece_ = nullptr;
  std::array<std::array<Place, 2>, kMostStretches> stretches_;
};

/// Of all u in [from, to]; `height` makes the height of one side (-1, +1).
template <typename MakeHeight>
Lowest leastOver(const ColumnBoundary& boundary, double p2, double k2, double from, double to,
                 const MakeHeight& height) {
  // Away from where both begin one side climbs: the other holds the least value, too.
  const bool both = from < 0.0 && to > 0.0;
  const bool right = to > 0.0 && !(both && height(1.0).climbs());
  Lowest best;
  if (right) best = Least(boundary, p2, k2, 1.0, height(1.0), best).over(std::max(from, 0.0), to);
  if (from < 0.0 && !(right && height(-1.0).climbs()))
    best = Least(boundary, p2, k2, -1.0, height(-1.0), best).over(std::max(-to, 0.0), -from);
  return best;
}

/// Angle of a point seen from the axis, in the sense of the motion, from cut_rad on; `d`: its distance. The
/// kernels have the same bits: a column at the cut lies on one side of it for all.
double angleOf(const TurnSweep& s, double qx, double qy, double d) {
  return turnAngle(qx * s.ux + qy * s.uy, s.turn * (s.ux * qy - s.uy * qx), d, s.cut_rad);
}

Interval column(const TurnSweep& s, double x, double y, const Asked& asked) {
  const double qx = x - s.x, qy = y - s.y, radius = s.solid->radius;
  const double d = std::sqrt(qx * qx + qy * qy), gap = std::abs(d - s.arc_radius);
  if (gap >= radius && !asked.rim) return {};
  const double nearest = angleOf(s, qx, qy, d) + s.turn_rad;
  const double first = std::max(-kPi, -nearest), last = std::min(kPi, s.way_rad - nearest);
  if (first >= last) return {};
  const double base = s.start_z + s.slope * nearest;
  if (gap >= radius && first < 0.0 && last > 0.0) return beside(*s.solid, gap - radius, base, nearest, 0.0);
  const double p2 = gap * gap, k2 = std::max(4.0 * s.arc_radius * d, kLeastAcross);
  const double reach = std::min(1.0, root((radius * radius - p2) / k2));
  // The sine of half an angle of the half circle is no less than the angle by pi.
  const double start = -first >= kPi * reach && !asked.rim ? -reach : std::sin(0.5 * first),
               end = last >= kPi * reach && !asked.rim ? reach : std::sin(0.5 * last),
               u = std::clamp(0.0, start, end);
  const double from = std::max(start, -reach), to = std::min(end, reach);
  const double beyond = std::sqrt(p2 + k2 * u * u) - radius;
  const double tip = u == 0.0 ? base : base + 2.0 * s.slope * std::asin(u);
  if (from >= to) return beside(*s.solid, beyond, tip, nearest, u);
  Interval in{.beyond = beyond, .middle = nearest, .u = u};
  const auto find = [&](const ColumnBoundary& boundary, double slope) {
    return leastOver(boundary, p2, k2, from, to, [&](double way) { return TurnHeight{2.0 * way * slope}; });
  };
  findEnds(
      *s.solid, asked, base, tip, in, [&] { return find(s.solid->lower, s.slope); },
      [&] { return find(s.solid->upper, -s.slope); });
  return in;
}

Interval column(const UprightSweep& s, double x, double y, const Asked& asked) {
  const double qx = x - s.x, qy = y - s.y, radius = s.solid->radius;
  const double along = qx * s.ux + qy * s.uy, across = qx * s.uy - qy * s.ux;
  const double p2 = across * across, reach = root(radius * radius - p2);
  const double u = std::clamp(along, s.first_mm, s.last_mm) - along;
  const double from = std::max(s.first_mm - along, -reach), to = std::min(s.last_mm - along, reach);
  const double beyond = std::sqrt(p2 + u * u) - radius;
  const auto height = [&](double way, double side) { return UprightHeight{along, way, s.arc_radius, side}; };
  if (from >= to && !asked.rim) return {};
  const double tip = s.start_z + height(1.0, s.side).value(u);
  if (from >= to) return beside(*s.solid, beyond, tip, along, u);
  Interval in{.beyond = beyond, .middle = along, .u = u};
  const auto find = [&](const ColumnBoundary& boundary, double side) {
    return leastOver(boundary, p2, 1.0, from, to, [&](double way) { return height(way, side); });
  };
  findEnds(
      *s.solid, asked, s.start_z, tip, in, [&] { return find(s.solid->lower, s.side); },
      [&] { return find(s.solid->upper, -s.side); });
  return in;
}

/// A square of the grid as seen by a curve.
struct Square {
  double x, y, corner;  ///< middle; half of the diagonal
};

/// What can be over a square: range of the tip's height, and the level distance from its middle.
struct Over {
  double low = kNoHeight, high = -kNoHeight, gap = kNoHeight;
};

Over over(const TurnSweep& s, const Square& square, double reach) {
  const double qx = square.x - s.x, qy = square.y - s.y, d = std::sqrt(qx * qx + qy * qy);
  const double gap = std::abs(d - s.arc_radius);
  if (gap > reach) return {};
  double from = s.cut_rad + s.turn_rad - kPi, to = from + 4.0 * kPi;
  const double across = (reach * reach - gap * gap) / (4.0 * s.arc_radius * std::max(d, kLeastAcross));
  if (d > square.corner && across < 1.0) {
    const double wide = std::asin(square.corner / d), half = 2.0 * std::asin(std::sqrt(across));
    const double angle = angleOf(s, qx, qy, d), past = angle - s.cut_rad;
    if (past >= wide && past <= 2.0 * kPi - wide && half + wide < kPi) {
      from = angle + s.turn_rad - half;
      to = angle + s.turn_rad + half;
    }
  }
  from = std::max(from, 0.0);
  to = std::min(to, s.way_rad);
  if (from > to) return {};
  const double a = s.start_z + s.slope * from, b = s.start_z + s.slope * to;
  return {std::min(a, b), std::max(a, b), gap};
}

Over over(const UprightSweep& s, const Square& square, double reach) {
  const double qx = square.x - s.x, qy = square.y - s.y;
  const double along = qx * s.ux + qy * s.uy, across = qx * s.uy - qy * s.ux;
  const double beyond = along - std::clamp(along, s.first_mm, s.last_mm);
  const double gap2 = beyond * beyond + across * across;
  if (gap2 > reach * reach) return {};
  const double from = std::max(s.first_mm, along - reach), to = std::min(s.last_mm, along + reach);
  const UprightHeight height{0.0, 1.0, s.arc_radius, s.side};
  const double a = height.value(from), b = height.value(to), m = from < 0.0 && to > 0.0 ? height.value(0) : a;
  return {s.start_z + std::min({a, b, m}), s.start_z + std::max({a, b, m}), std::sqrt(gap2)};
}

Interval column(const WaySweep& s, double x, double y, const Asked& asked) {
  return wayColumn(s, x, y, asked);
}

/// Level, mm.
struct Level {
  double x, y;
  double along(double dx, double dy) const { return x * dx + y * dy; }
};

/// A column from the tool's axis, and how the tool moves with the place, for a place u of the interval.
struct Seen {
  Level off, way;
  double rise;  ///< of the way's height with the place
};

Seen seen(const WaySweep& s, double x, double y, const Interval&, double u) {
  const CurveWay::Node n = s.way->node(u);
  return {{x - n.at.x(), y - n.at.y()}, {n.velocity.x(), n.velocity.y()}, n.velocity.z()};
}
Seen seen(const UprightSweep& s, double x, double y, const Interval& in, double u) {
  const double qx = x - s.x, qy = y - s.y;
  const double at = in.middle + u, rise = UprightHeight{0.0, 1.0, s.arc_radius, s.side}.slope(at);
  return {{qx - at * s.ux, qy - at * s.uy}, {s.ux, s.uy}, rise};
}
/// The tool's direction from the axis is the column's, turned by twice the angle whose sine is u.
Seen seen(const TurnSweep& s, double x, double y, const Interval&, double u) {
  const double qx = x - s.x, qy = y - s.y;
  const double d = std::max(std::sqrt(qx * qx + qy * qy), 1e-12), r = s.arc_radius / d;
  const double c = 1.0 - 2.0 * u * u, w = 2.0 * u * root(1.0 - u * u) * s.turn;
  const double ax = r * (c * qx - w * qy), ay = r * (w * qx + c * qy);
  return {{qx - ax, qy - ay}, {-s.turn * ay, s.turn * ax}, s.slope};
}

/// See CurveSide.
double placeOf(const TurnSweep&, const Interval& in, double u) {
  return in.middle + (u == 0.0 ? 0.0 : 2.0 * std::asin(u));
}
double placeOf(const UprightSweep&, const Interval& in, double u) { return in.middle + u; }
double placeOf(const WaySweep&, const Interval& in, double u) { return in.middle + u; }

/// A place where the rim or another edge of the tool is over the column moves with the column, mm.
constexpr double kAtEdgeMm = 1e-7;

/// Slope of the boundary at r by r; nothing on its edges.
std::optional<double> boundarySlope(const ColumnBoundary& boundary, double r) {
  int i = boundary.count - 1;
  while (i > 0 && r < boundary.piece[i].ra) --i;
  const Piece& piece = boundary.piece[i];
  if (r > piece.rb - kAtEdgeMm || (i > 0 && r < piece.ra + kAtEdgeMm)) return std::nullopt;
  return boundaryAt(piece, r).slope;
}

template <typename Way>
CurveSide sideOf(const Way& sweep, const double (&point)[3], double dx, double dy) {
  const double x = point[0], y = point[1], z = point[2];
  const Interval in = column(sweep, x, y, {.rim = true, .all = false, .z = z});
  const double low = in.lo - z, high = z - in.hi, value = std::max({low, high, in.beyond});
  const bool end = in.over && std::max(low, high) >= in.beyond, lower = low >= high;
  const double u = !end ? in.u : lower ? in.at_lo : in.at_hi;
  CurveSide out{value, placeOf(sweep, in, u), 0.0};
  if (!in.over) return out;
  const Seen at = seen(sweep, x, y, in, u);
  const double r = std::sqrt(at.off.x * at.off.x + at.off.y * at.off.y), across = at.off.along(dx, dy);
  if (r < kAtEdgeMm) return out;
  if (!end) {
    out.slope = across / r;
  } else if (const auto slope = boundarySlope(lower ? sweep.solid->lower : sweep.solid->upper, r)) {
    out.slope = *slope * across / r;
  } else {
    const double leaves = at.way.x * at.off.x + at.way.y * at.off.y;
    out.slope = leaves == 0.0 ? 0.0 : (lower ? at.rise : -at.rise) * across / leaves;
  }
  return out;
}

template <typename Way>
void endsOf(const Way& sweep, double x, double y, double* lo, double* hi) {
  const Interval in = column(sweep, x, y, {});
  *lo = in.over ? in.lo : kNoHeight;
  *hi = in.over ? in.hi : -kNoHeight;
}

template <typename Way>
void reachOf(const Way& sweep, const FourBlocks& blocks, double* low, double* high) {
  const ColumnSolid& tool = *sweep.solid;
  const double corner = std::sqrt(2.0) * blocks.half_width, reach = corner + tool.radius + kCullSlackMm;
  for (int i = 0; i < 4; ++i) {
    const Square square{blocks.x[i], blocks.y[i], corner};
    const Over at = over(sweep, square, reach);
    low[i] = kNoHeight;
    high[i] = -kNoHeight;
    if (at.low > at.high) continue;
    const double radial = std::clamp(at.gap - corner, 0.0, tool.radius);
    const double lowest = at.low + tool.lower.height(radial) - kCullSlackMm;
    const double highest = at.high - tool.upper.height(radial) + kCullSlackMm;
    if (lowest < blocks.z_high[i] && highest > blocks.z_low[i]) low[i] = lowest, high[i] = highest;
  }
}

}  // namespace

void curveColumn(const TurnSweep& sweep, double x, double y, double* lo, double* hi) {
  endsOf(sweep, x, y, lo, hi);
}
void curveColumn(const UprightSweep& sweep, double x, double y, double* lo, double* hi) {
  endsOf(sweep, x, y, lo, hi);
}
void curveColumn(const WaySweep& sweep, double x, double y, double* lo, double* hi) {
  endsOf(sweep, x, y, lo, hi);
}

CurveSide curveSide(const TurnSweep& sweep, const double (&point)[3], double dx, double dy) {
  return sideOf(sweep, point, dx, dy);
}
CurveSide curveSide(const UprightSweep& sweep, const double (&point)[3], double dx, double dy) {
  return sideOf(sweep, point, dx, dy);
}
CurveSide curveSide(const WaySweep& sweep, const double (&point)[3], double dx, double dy) {
  return sideOf(sweep, point, dx, dy);
}

void curveReach(const TurnSweep& sweep, const FourBlocks& blocks, double* low, double* high) {
  reachOf(sweep, blocks, low, high);
}
void curveReach(const UprightSweep& sweep, const FourBlocks& blocks, double* low, double* high) {
  reachOf(sweep, blocks, low, high);
}

}  // namespace proveout
