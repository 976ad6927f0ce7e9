// One column of a part whose tool the kernels have vectors for (column_way_body.h): what they know of a part,
// without a search by bounds. For cuts of level edges, which ask one column after the other.
#include <cmath>
#include <optional>

#include "removal/sweep/column_way.h"

namespace proveout {

namespace {

#include "removal/sweep/column_way_at.h"

constexpr int kMostRounds = 40;
/// A way is nearest to a column once where it bends less than a circle around the column that holds all of
/// the part, with room for rounding.
constexpr double kSure = 0.99;

/// The place, by the angle from the part's middle, at which what grows from low to high is 0; `look` tells
/// its value and slope.
template <typename Look>
double wayRootOf(double low, double high, double guess, double still, const Look& look) {
  double at = guess > low && guess < high ? guess : 0.5 * (low + high);
  for (int round = 0; round < kMostRounds; ++round) {
    const WayRound f = look(at);
    const WayStep s = wayStep(f.value, f.slope, at, low, high);
    low = s.low, high = s.high, at = s.next;
    if (s.moved <= still) break;
  }
  return at;
}

class PlainColumn {
 public:
  PlainColumn(const WaySweep& part, double x, double y)
      : w_(*part.plain),
        solid_(*part.solid),
        x_(x - w_.x),
        y_(y - w_.y),
        middle_rad_((part.part + 0.5) * CurveWay::kNodesAPart * part.way->node_rad),
        still_(wayStill(w_)) {}

  /// Whether the way has one nearest place.
  bool isSure() const { return w_.curvature * (std::sqrt(x_ * x_ + y_ * y_) + w_.reach) < kSure; }
  double rad(double a) const { return middle_rad_ + a; }
  WayAt at(double a) const { return wayAt(w_, x_, y_, a); }

  double nearest() const {
    const auto toward = [&](int k) {
      return (w_.end_x[k] - x_) * w_.end_vx[k] + (w_.end_y[k] - y_) * w_.end_vy[k];
    };
    if (toward(0) >= 0.0) return -w_.half;
    if (toward(2) <= 0.0) return w_.half;
    const double vx = w_.end_vx[1], vy = w_.end_vy[1];
    return wayRootOf(-w_.half, w_.half, (x_ * vx + y_ * vy) / (vx * vx + vy * vy), still_, [&](double a) {
      const WayAt f = at(a);
      return WayRound{f.toward(), f.sideBend()};
    });
  }

  /// Of the lower end and the height; `near`, `from`: the nearest place.
  Lowest lowest(double near, const WayAt& from) const {
    const ColumnBoundary::Piece& last = solid_.lower.piece[solid_.lower.count - 1];
    const bool disc = last.kind == ColumnBoundary::Kind::kLevel;
    const double a = disc ? lowestOfDisc(near, from) : lowestOfRound(near, from, last);
    const WayAt f = at(a);
    if (disc) return {w_.z + f.z + last.za, rad(a)};
    const double over = std::max(std::sqrt(f.square()) - last.rc, 0.0);
    return {w_.z + f.z + last.zc - wayRoot(last.radius * last.radius - over * over), rad(a)};
  }

 private:
  /// Of the level distance from the end on a side.
  double endSquare(double side) const {
    const int k = side < 0.0 ? 0 : 2;
    const double x = w_.end_x[k] - x_, y = w_.end_y[k] - y_;
    return x * x + y * y;
  }
  /// Down to where the rim leaves the column, or the height grows again.
  double lowestOfDisc(double near, const WayAt& from) const {
    const double radius2 = solid_.radius * solid_.radius;
    if (from.vz == 0.0) return near;
    const double side = from.vz > 0.0 ? -1.0 : 1.0, width = w_.half - side * near;
    double step = width;
    if (endSquare(side) > radius2) {
      const double speed = std::sqrt(from.vx * from.vx + from.vy * from.vy);
      step = wayRootOf(0.0, width, wayRoot(radius2 - from.square()) / speed, still_, [&](double t) {
        const WayAt f = at(near + side * t);
        return WayRound{0.5 * (f.square() - radius2), side * f.toward()};
      });
    }
    const double end = near + side * step;
    if (side * at(end).vz <= 0.0) return end;
    return wayRootOf(std::min(near, end), std::max(near, end), 0.5 * (near + end), still_, [&](double a) {
      const WayAt f = at(a);
      return WayRound{f.vz, f.az};
    });
  }

  double lowestOfRound(double near, const WayAt& from, const ColumnBoundary::Piece& piece) const {
    const double rc = piece.rc, ball2 = piece.radius * piece.radius, radius2 = solid_.radius * solid_.radius;
    const double speed2 = from.vx * from.vx + from.vy * from.vy;
    const double side = from.vz > 0.0 ? -1.0 : 1.0,
                 lean = std::abs(from.vz) / std::hypot(from.vz, std::sqrt(speed2));
    if (side * wayRound(from, rc, ball2).value >= 0.0) return near;
    const double r = rc + piece.radius * lean;
    const double away = rc == 0.0 ? lean * wayRoot(ball2 - from.square()) : wayRoot(r * r - from.square());
    const auto look = [&](double a) {
      const WayAt f = at(a);
      // Beyond the rim it is known to which side the place is.
      if (f.square() >= radius2) return WayRound{side, 0.0};
      return wayRound(f, rc, ball2);
    };
    if (endSquare(side) < radius2 && side * look(side * w_.half).value <= 0.0) return side * w_.half;
    return wayRootOf(std::min(near, side * w_.half), std::max(near, side * w_.half),
                     near + side * away / std::sqrt(speed2), still_, look);
  }

  const WayPart& w_;
  const ColumnSolid& solid_;
  double x_, y_, middle_rad_, still_;
};

/// Whether the lower end and the height have one least value together.
bool isConvex(const WayPart& w, const ColumnSolid& solid) {
  const ColumnBoundary::Piece& last = solid.lower.piece[solid.lower.count - 1];
  if (last.kind == ColumnBoundary::Kind::kLevel) return w.least_bend >= 0.0;
  const double ball = last.rc == 0.0 ? (1.0 - w.curvature * solid.radius) / solid.radius : 0.0;
  return std::max(ball, 0.0) + w.sag >= 0.0;
}

}  // namespace

bool isPlainPart(const WaySweep& part) {
  const WayPart& w = *part.plain;
  return !part.twice && hasPlainEnds(*part.solid) && isConvex(w, *part.solid) &&
         w.curvature * (part.solid->radius + 2.0 * w.reach) < kSure;
}

std::optional<Interval> plainWayColumn(const WaySweep& part, double x, double y, const Asked& asked) {
  const ColumnSolid& solid = *part.solid;
  const WayPart& w = *part.plain;
  if (part.twice || asked.all || !hasPlainEnds(solid) || !isConvex(w, solid)) return std::nullopt;
  const PlainColumn column(part, x, y);
  if (!column.isSure()) return std::nullopt;
  const double near = column.nearest();
  const WayAt at = column.at(near);
  const double beyond = std::sqrt(at.square()) - solid.radius, tip = w.z + at.z;
  if (beyond >= 0.0 && !asked.rim) return Interval{};
  if (beyond >= 0.0) return beside(solid, beyond, tip, 0.0, column.rad(near));
  Interval in{.beyond = beyond, .u = column.rad(near)};
  bool top = false;  // decides, which is searched by bounds
  findEnds(
      solid, asked, 0.0, tip, in, [&] { return column.lowest(near, at); },
      [&] {
        top = true;
        return Lowest{-in.hi, in.u};
      });
  if (top) return std::nullopt;
  return in;
}

}  // namespace proveout
