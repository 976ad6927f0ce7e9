#include "core/nc/services/arc_corner_comp.h"

#include <algorithm>
#include <cmath>

#include "core/nc/services/plane_curves.h"

namespace proveout {
namespace arc_corner_detail {

constexpr double kSmallTurn = 0.05;  ///< rad; corners that turn by less are left as they are
constexpr double kTiny = 1e-9;       ///< mm

Vec2 left(const Vec2& v) { return {-v.y(), v.x()}; }
Vec2 flat(const Vec3& v) { return v.head<2>(); }
double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
/// From a to b, in (-pi, pi].
double angle(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

/// Sweep from a to b about c, the way of `sign`, in (0, 2 pi].
double sweepTo(const Vec2& c, const Vec2& a, const Vec2& b, double sign) {
  double part = sign * angle(a - c, b - c);
  if (part <= 1e-12) part += 2.0 * kPi;
  return sign * part;
}

/// Is the tool on the outside of that arc?
bool outside(const ArcCornerPiece& p, double offset) { return p.arc && p.sweep * offset < 0.0; }

bool finite(const ArcCornerMove& m) {
  return m.to.allFinite() && m.center.allFinite() && std::isfinite(m.sweep) && std::isfinite(m.offset);
}

}  // namespace arc_corner_detail

using namespace arc_corner_detail;

void ArcCornerComp::reset(const Vec3& start) {
  first_ = true;
  programmed_ = center_ = start;
  held_ = Held{};
}

void ArcCornerComp::release(std::vector<ArcCornerPiece>& out) {
  if (!held_.any) return;
  out.push_back(held_.piece);
  out.insert(out.end(), held_.followers.begin(), held_.followers.end());
  held_ = Held{};
}

void ArcCornerComp::hold(const ArcCornerPiece& piece, const Vec2& direction) {
  held_.any = true;
  held_.piece = piece;
  held_.direction = direction;
  held_.full_sweep = std::abs(piece.sweep);
  center_ = piece.to;
}

void ArcCornerComp::follow(std::uint64_t tag, double w, std::vector<ArcCornerPiece>& out) {
  ArcCornerPiece piece;
  piece.kind = ArcCornerPiece::Kind::kFollower;
  piece.from = center_;
  center_.z() = programmed_.z() = w;
  piece.to = center_;
  piece.tag = tag;
  if (held_.any) {
    held_.followers.push_back(piece);
  } else {
    out.push_back(piece);
  }
}

/// The last motion ends at `to` and leaves with what follows it.
ArcCornerFault ArcCornerComp::moveEnd(const Vec2& to, std::vector<ArcCornerPiece>& out) {
  if (!held_.any) return ArcCornerFault::kNone;
  ArcCornerPiece& piece = held_.piece;
  if (!piece.arc) {
    if (held_.direction.dot(to - flat(piece.from)) < -kTiny) return ArcCornerFault::kLineGouges;
  } else {
    const double sign = piece.sweep < 0.0 ? -1.0 : 1.0;
    const double change = angle(flat(piece.to) - piece.center, to - piece.center);
    const double sweep = std::abs(piece.sweep) + sign * change;
    if (sweep < -kTiny || sweep > held_.full_sweep + 1e-9) return ArcCornerFault::kArcGouges;
    piece.sweep = sign * std::max(sweep, 0.0);
  }
  piece.to.head<2>() = to;
  for (ArcCornerPiece& follower : held_.followers) {
    follower.from.head<2>() = to;
    follower.to.head<2>() = to;
  }
  center_.head<2>() = to;
  release(out);
  return ArcCornerFault::kNone;
}

ArcCornerFault ArcCornerComp::flush(std::vector<ArcCornerPiece>& out) {
  return held_.any ? moveEnd(flat(held_.piece.to), out) : ArcCornerFault::kNone;
}

/// The first motion: an arc comes with the centre that lets it end square to the offset.
ArcCornerFault ArcCornerComp::enter(const ArcCornerMove& move) {
  const Vec2 start = flat(center_), end = flat(move.to);
  if (!((end - start).norm() > std::abs(move.offset))) return ArcCornerFault::kEntryTooShort;
  ArcCornerPiece piece;
  piece.from = center_;
  piece.tag = move.tag;
  first_ = false;
  programmed_ = move.to;
  if (!move.arc) {
    const Vec2 direction = (end - start).normalized();
    const Vec2 to = end + move.offset * left(direction);
    piece.to = {to.x(), to.y(), move.to.z()};
    hold(piece, direction);
    return ArcCornerFault::kNone;
  }
  const double sign = move.sweep < 0.0 ? -1.0 : 1.0;
  const Vec2 outwards = (end - move.center).normalized();
  if (sign * move.offset > 0.0 && (end - move.center).norm() <= std::abs(move.offset))
    return ArcCornerFault::kArcTooSmall;
  // The offset to the left of a counter-clockwise arc leads to its centre.
  const Vec2 to = end - sign * move.offset * outwards;
  // On the line through centre and end, as far from the start as from the new end.
  const Vec2 chord = to - start;
  const double across = 2.0 * outwards.dot(chord);
  if (std::abs(across) < kTiny) return ArcCornerFault::kNoMeeting;
  const double radius = chord.squaredNorm() / across;
  piece.arc = true;
  piece.center = to - radius * outwards;
  piece.to = {to.x(), to.y(), move.to.z()};
  piece.sweep = sweepTo(piece.center, start, to, sign);
  hold(piece, sign * left(outwards));
  return ArcCornerFault::kNone;
}

/// Where the held motion and the next one, offset, meet. Of two points the one where the path leaves a circle
/// that the tool is outside of, or comes to one that it is inside of; two circles cross there on the side
/// that the next one turns to.
bool ArcCornerComp::meeting(const ArcCornerPiece& next, const Vec2& direction, double offset,
                            Vec2& at) const {
  const ArcCornerPiece& last = held_.piece;
  const auto curve = [](const ArcCornerPiece& p, const Vec2& d, const Vec2& end) {
    if (p.arc) return PlaneCurve{true, p.center, Vec2::UnitX(), (end - p.center).norm()};
    return PlaneCurve{false, end, d, 0.0};
  };
  const Meeting found =
      meet(curve(last, held_.direction, flat(last.to)), curve(next, direction, flat(next.to)));
  const auto far = [&](const Vec2& p) {
    if (last.arc && next.arc) {
      const double side = cross(next.center - last.center, p - last.center);
      return (next.sweep > 0.0) == outside(last, offset) ? -side : side;
    }
    if (last.arc) return (outside(last, offset) ? 1.0 : -1.0) * direction.dot(p);
    return (outside(next, offset) ? -1.0 : 1.0) * held_.direction.dot(p);
  };
  for (std::size_t k = 0; k < found.count; ++k)
    if (k == 0 || far(found.points[k]) > far(at)) at = found.points[k];
  return found.count > 0;
}

/// What stands between the last motion and the next one. `next.to` is its end beside the programmed one.
ArcCornerFault ArcCornerComp::corner(const Vec2& tangent, const ArcCornerPiece& next, double offset,
                                     std::vector<ArcCornerPiece>& out) {
  const Vec2 here = flat(center_), pivot = flat(programmed_);
  const Vec2 start = pivot + offset * left(tangent);
  if (std::abs(offset) < kTiny) {
    release(out);
    return ArcCornerFault::kNone;
  }
  // The turn towards the tool's side is inside.
  double turn = angle(here - pivot, start - pivot) * (offset > 0.0 ? -1.0 : 1.0);
  if (turn < -(kPi - kSmallTurn)) turn += 2.0 * kPi;
  // A way that turns back beside an arc stays on its side instead of going round the corner.
  const bool back = turn > kPi - kSmallTurn && outside(next.arc ? next : held_.piece, offset);
  if (turn < -kSmallTurn || back) {
    Vec2 at;
    if (!held_.any) return ArcCornerFault::kNone;
    if (!meeting(next, next.arc ? Vec2::UnitX() : tangent, offset, at)) return ArcCornerFault::kNoMeeting;
    return moveEnd(at, out);
  }
  if (next.arc || turn <= kSmallTurn) {
    release(out);
  } else if (const auto fault = flush(out); fault != ArcCornerFault::kNone) {
    return fault;
  }
  if (turn <= kSmallTurn) return ArcCornerFault::kNone;
  ArcCornerPiece piece;
  piece.kind = ArcCornerPiece::Kind::kCorner;
  piece.arc = true;
  piece.from = center_;
  piece.to = {start.x(), start.y(), center_.z()};
  piece.center = pivot;
  piece.sweep = offset > 0.0 ? -turn : turn;
  piece.tag = next.tag;
  out.push_back(piece);
  center_ = piece.to;
  return ArcCornerFault::kNone;
}

ArcCornerFault ArcCornerComp::push(const ArcCornerMove& move, std::vector<ArcCornerPiece>& out) {
  if (!finite(move)) return ArcCornerFault::kNotFinite;
  if (first_) return enter(move);
  const Vec2 from = flat(programmed_), end = flat(move.to);
  if (!move.arc && (end - from).norm() == 0.0) {
    follow(move.tag, move.to.z(), out);
    return ArcCornerFault::kNone;
  }
  ArcCornerPiece piece;
  piece.tag = move.tag;
  piece.arc = move.arc;
  Vec2 tangent, direction;
  if (!move.arc) {
    tangent = direction = (end - from).normalized();
    const Vec2 to = end + move.offset * left(direction);
    piece.to = {to.x(), to.y(), move.to.z()};
  } else {
    const double sign = move.sweep < 0.0 ? -1.0 : 1.0;
    const Vec2 arm = from - move.center, last = end - move.center;
    if (sign * move.offset > 0.0 && last.norm() <= std::abs(move.offset)) return ArcCornerFault::kArcTooSmall;
    if (arm.norm() < kTiny || last.norm() < kTiny) return ArcCornerFault::kArcTooSmall;
    tangent = sign * left(arm.normalized());
    direction = sign * left(last.normalized());
    const Vec2 to = end + move.offset * left(direction);
    piece.center = move.center;
    piece.sweep = move.sweep;
    piece.to = {to.x(), to.y(), move.to.z()};
  }
  const Vec2 square = from + move.offset * left(tangent);
  if (const auto fault = corner(tangent, piece, move.offset, out); fault != ArcCornerFault::kNone)
    return fault;
  piece.from = center_;
  if (move.arc) {
    // Longer or shorter by what the corner has moved its start.
    const double sign = move.sweep < 0.0 ? -1.0 : 1.0;
    const double moved = sign * angle(square - move.center, flat(center_) - move.center);
    const double sweep = std::abs(move.sweep) - moved;
    if (sweep < -1e-9) return ArcCornerFault::kArcGouges;
    piece.sweep = sign * std::max(sweep, 0.0);
  }
  programmed_ = move.to;
  hold(piece, direction);
  return ArcCornerFault::kNone;
}

}  // namespace proveout
