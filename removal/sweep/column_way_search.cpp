// What a column sees of a part of a way: the stretches on which the tool is over it, and the least of
// boundary
// + height on them.
//
// The square e of the level distance is smooth: with its second derivative at the ends of a span and a bound
// of its fourth, spans are halved until they are convex, concave or too far off; so all stretches with e <=
// radius^2 are found, in runs on which the distance only grows or only falls. On a run the boundary L(d)
// grows away from the near end. Spans of it are halved until L(d) + height is convex there, and Newton's
// method finds the least value, or until support lines, less what it may bend down, prove that they hold
// nothing lower. A sphere and the corner of a torus are convex in e where e is; a cone is followed by d
// itself.
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "removal/sweep/column_way.h"

namespace proveout {

namespace {

using Piece = ColumnBoundary::Piece;
using PieceKind = ColumnBoundary::Kind;

/// A span is settled where nothing on it is lower than the best by more, mm.
constexpr double kSettledMm = 1e-11;
/// Newton's methods stop behind a step this small, mm: what follows is off by its square.
constexpr double kStepMm = 1e-6, kRootMm = 1e-10;
/// Spans this short hold no more than their ends, rad.
constexpr double kShortest = 1e-10;
/// Second derivatives of squares that count as none, mm2.
constexpr double kFlat = 1e-15;
constexpr int kMostRounds = 60, kMostRuns = 64, kMostSpans = 48;

/// A place of the way as a column sees it: square of the level distance and height, and two derivatives.
struct Seen {
  double rad, e, e1, e2, z, z1, z2;
  double distance() const { return std::sqrt(e); }
};

/// Where the distance grows from `near` to `far`.
struct Run {
  Seen near, far;
  int stretch;
  bool cut;  ///< far is where the tool's rim is over the column, or nearer
};

/// Root of a function that grows from `low` to `high`, where it is below and above 0: `at` gives value and
/// slope.
template <typename At>
double growingRoot(double low, double high, double start, double within, const At& at) {
  double t = start >= low && start <= high ? start : 0.5 * (low + high);
  for (int round = 0; round < kMostRounds; ++round) {
    const auto [value, slope] = at(t);
    (value < 0.0 ? low : high) = t;
    const double next = slope > 0.0 ? t - value / slope : low;
    const bool in = next >= low && next <= high;
    const double to = in ? next : 0.5 * (low + high), moved = in ? std::abs(next - t) : high - low;
    t = to;
    if (moved < within) break;
  }
  return t;
}

struct Slope {
  double value, slope;
};

class WayColumn {
 public:
  WayColumn(const WaySweep& part, double x, double y, bool rim)
      : way_(*part.way), x_(x), y_(y), radius2_(part.solid->radius * part.solid->radius), rim_(rim) {
    const CurveWay::Node* node = &way_.nodes[static_cast<std::size_t>(part.part * CurveWay::kNodesAPart)];
    first_rad_ = part.part * CurveWay::kNodesAPart * way_.node_rad;
    const double wide = CurveWay::kNodesAPart * way_.node_rad;
    const Vec2 middle = (way_.center + (first_rad_ + 0.5 * wide) * way_.climb).head<2>() - Vec2(x, y);
    const double off = middle.norm() + 0.5 * wide * way_.climb.head<2>().norm();
    fourth_ = way_.still4 + way_.far4 * off;
    speed_ = std::max(node->velocity.norm(), node[CurveWay::kNodesAPart].velocity.norm());
    const Seen a = see(first_rad_, *node), b = see(first_rad_ + wide, node[CurveWay::kNodesAPart]);
    nearest_ = a.e <= b.e ? a : b;
    visit(a, b);
  }

  const Seen& nearest() const { return nearest_; }
  double fourth() const { return fourth_; }
  double speed() const { return speed_; }
  const CurveWay& way() const { return way_; }
  double radius2() const { return radius2_; }
  std::array<Run, kMostRuns>& runs() { return runs_; }
  int count() const { return count_; }
  int stretches() const { return stretches_; }

  Seen at(double rad) const { return see(rad, way_.node(rad)); }
  /// Where the square of the distance is that, on a run.
  Seen place(const Run& run, double e) const {
    const Seen &n = run.near, &f = run.far;
    const double side = f.rad > n.rad ? 1.0 : -1.0, wide = std::abs(f.rad - n.rad);
    // From the near end as on a parabola.
    const double slope = std::max(0.0, side * n.e1), gain = e - n.e;
    const double guess = 2.0 * gain / (slope + root(slope * slope + 2.0 * n.e2 * gain));
    const double step = growingRoot(0.0, wide, guess, kStepMm / speed_, [&](double t) {
      const Seen s = at(n.rad + side * t);
      return Slope{s.e - e, side * s.e1};
    });
    return at(n.rad + side * step);
  }

 private:
  Seen see(double rad, const CurveWay::Node& n) const {
    const double qx = n.at.x() - x_, qy = n.at.y() - y_, vx = n.velocity.x(), vy = n.velocity.y();
    return {rad,
            qx * qx + qy * qy,
            2.0 * (qx * vx + qy * vy),
            2.0 * (vx * vx + vy * vy + qx * n.bend.x() + qy * n.bend.y()),
            n.at.z(),
            n.velocity.z(),
            n.bend.z()};
  }

  void visit(const Seen& a, const Seen& b) {
    const double wide = b.rad - a.rad, wide2 = wide * wide, slack = fourth_ * wide2 / 8.0;
    const double low = std::min(a.e2, b.e2) - slack, high = std::max(a.e2, b.e2) + slack;
    const double limit = rim_ ? std::max(radius2_, nearest_.e) : radius2_;
    const double bend = std::max(0.0, -low), fall = a.e1 - 0.5 * bend * wide, rise = b.e1 + 0.5 * bend * wide;
    double least = std::min(a.e, b.e);
    if (fall < 0.0 && rise > 0.0)
      least = a.e + fall * std::clamp((b.e - a.e - rise * wide) / (fall - rise), 0.0, wide);
    else if (bend > 0.0)
      least -= bend * wide2 / 8.0;
    if (least > limit) {
      open_ = false;
    } else if (low * wide2 >= -kFlat || wide < kShortest) {
      convex(a, b);
    } else if (high * wide2 <= kFlat) {
      concave(a, b);
    } else {
      const Seen middle = at(0.5 * (a.rad + b.rad));
      visit(a, middle);
      visit(middle, b);
    }
  }

  Seen turn(const Seen& a, const Seen& b, double side) const {
    const double guess = a.rad - a.e1 * (b.rad - a.rad) / (b.e1 - a.e1);
    return at(growingRoot(a.rad, b.rad, guess, kStepMm / speed_, [&](double t) {
      const Seen s = at(t);
      return Slope{side * s.e1, side * s.e2};
    }));
  }

  void convex(const Seen& a, const Seen& b) {
    if (a.e1 >= 0.0) return rising(a, b);
    if (b.e1 <= 0.0) return falling(a, b);
    const Seen least = turn(a, b, 1.0);
    falling(a, least);
    rising(least, b);
  }

  void concave(const Seen& a, const Seen& b) {
    if (a.e1 <= 0.0) return falling(a, b);
    if (b.e1 >= 0.0) return rising(a, b);
    const Seen top = turn(a, b, -1.0);
    rising(a, top);
    falling(top, b);
  }

  void falling(const Seen& far, const Seen& near) {
    if (near.e < nearest_.e) nearest_ = near;
    if (far.e >= radius2_) open_ = false;
    add(near, far);
  }

  void rising(const Seen& near, const Seen& far) {
    if (near.e < nearest_.e) nearest_ = near;
    add(near, far);
    if (far.e >= radius2_) open_ = false;
  }

  void add(const Seen& near, const Seen& far) {
    if (near.e >= radius2_) {
      open_ = false;
      return;
    }
    if (!open_) ++stretches_;
    open_ = true;
    if (count_ > 0 && goOn(runs_[static_cast<std::size_t>(count_ - 1)], near, far)) return;
    PROVEOUT_ASSERT(count_ < kMostRuns);
    runs_[static_cast<std::size_t>(count_++)] = {near, far, stretches_, far.e <= radius2_};
  }

  /// Whether the last run went on to this one, which is now a part of it.
  bool goOn(Run& last, const Seen& near, const Seen& far) const {
    if (last.stretch != stretches_) return false;
    const bool rises = last.far.rad > last.near.rad && far.rad > near.rad && last.far.rad == near.rad;
    const bool falls = last.far.rad < last.near.rad && far.rad < near.rad && last.near.rad == far.rad;
    if (rises) last.far = far, last.cut = far.e <= radius2_;
    if (falls) last.near = near;
    return rises || falls;
  }

  const CurveWay& way_;
  double x_, y_, radius2_, fourth_, speed_, first_rad_;
  bool rim_, open_ = false;
  int count_ = 0, stretches_ = 0;
  Seen nearest_;
  std::array<Run, kMostRuns> runs_;
};

/// The least of boundary + side * height on the runs of one stretch.
class WayLeast {
 public:
  WayLeast(WayColumn& column, int stretch, const ColumnBoundary& boundary, double side)
      : column_(column), stretch_(stretch), boundary_(boundary), side_(side) {}

  Lowest find() {
    for (int i = 0; i < column_.count(); ++i) {
      Run& run = column_.runs()[static_cast<std::size_t>(i)];
      if (run.stretch == stretch_) over(run);
    }
    return best_;
  }

 private:
  /// Both terms and their derivatives along the run, away from its near end.
  struct Place {
    double t, d, d1, e1, e2;        ///< t: from the near end, rad
    double foot, foot1, z, z1, z2;  ///< z: side * height
    double value() const { return foot + z; }
    double slope() const { return foot1 + z1; }
  };
  struct Bounds {
    double foot2, z2;  ///< least second derivatives
  };

  void offer(const Place& p) {
    if (p.value() < best_.value) best_ = {p.value(), near_ + way_ * p.t};
  }

  double slopeOfFoot(double d) const { return boundaryAt(*piece_, d).slope; }
  double bendOfFoot(double d) const { return boundaryBend(*piece_, d); }

  Place place(const Seen& s) const {
    Place p{};
    p.t = way_ * (s.rad - near_);
    p.d = s.distance();
    p.e1 = way_ * s.e1, p.e2 = s.e2;
    // Over the axis the way leaves the column at its speed.
    p.d1 = p.d > kRootMm ? 0.5 * p.e1 / p.d : root(0.5 * s.e2);
    const BoundaryPlace foot = boundaryAt(*piece_, p.d);
    p.foot = foot.value;
    p.foot1 = foot.slope == 0.0 || p.d1 == 0.0 ? 0.0 : foot.slope * p.d1;
    p.z = side_ * s.z, p.z1 = side_ * way_ * s.z1, p.z2 = side_ * s.z2;
    return p;
  }
  Place place(double t) const { return place(column_.at(near_ + way_ * t)); }

  double leastBendOfHeight(const Place& a, const Place& b) const {
    const double wide = b.t - a.t;
    return std::min(a.z2, b.z2) - column_.way().height4 * wide * wide / 8.0;
  }
  double leastHeight(const Place& a, const Place& b) const {
    const double wide = b.t - a.t, most = std::max(a.z2, b.z2) + column_.way().height4 * wide * wide / 8.0;
    return std::min(a.z, b.z) - std::max(0.0, most) * wide * wide / 8.0;
  }
  /// Whether the height does not fall along the span.
  bool climbs(const Place& a, const Place& b) const {
    const double wide = b.t - a.t, sag = column_.way().height4 * wide * wide / 8.0;
    if (std::min(a.z1, b.z1) < 0.0) return false;
    return std::min(a.z2, b.z2) >= sag || std::max(a.z2, b.z2) <= -sag ||
           (column_.way().height4 == 0.0 && a.z2 == 0.0);
  }

  void over(Run& run) {
    near_ = run.near.rad;
    way_ = run.far.rad > near_ ? 1.0 : -1.0;
    piece_ = boundary_.piece;
    for (int i = 1; i < boundary_.count && boundary_.piece[i].ra <= run.near.distance(); ++i)
      piece_ = &boundary_.piece[i];
    Place a = place(run.near);
    offer(a);
    {
      const Place far = place(run.far);
      if (climbs(a, far) || a.foot + leastHeight(a, far) >= best_.value - kSettledMm) return;
    }
    if (!run.cut) {
      run.far = column_.place(run, column_.radius2());
      run.cut = true;
    }
    const Piece* last = boundary_.piece + boundary_.count - 1;
    for (;; ++piece_) {
      a = place(a.t == 0.0 ? run.near : column_.at(near_ + way_ * a.t));
      const double rb2 = piece_->rb * piece_->rb;
      const bool whole = piece_ == last || run.far.e <= rb2;
      const Place b = place(whole ? run.far : column_.place(run, rb2));
      offer(b);
      if (b.t > a.t) overPiece(a, b);
      if (whole || b.foot + leastHeight(b, place(run.far)) >= best_.value - kSettledMm) return;
      a = b;
    }
  }

  void overPiece(const Place& first, const Place& last) {
    spans_[0] = {first, last};
    for (int size = 1; size > 0;) {
      const auto [a, b] = spans_[static_cast<std::size_t>(--size)];
      const Bounds least = bounds(a, b);
      if (isSettled(a, b, least)) continue;
      if (least.foot2 + least.z2 >= 0.0) {
        if (a.slope() < 0.0 && b.slope() > 0.0) offer(newton(a, b));
        continue;
      }
      if (b.t - a.t < kShortest || size + 2 > kMostSpans) continue;
      const Place middle = place(0.5 * (a.t + b.t));
      offer(middle);
      spans_[static_cast<std::size_t>(size++)] = {middle, b};
      spans_[static_cast<std::size_t>(size++)] = {a, middle};
    }
  }

  /// Of the boundary by e: the least there can be on the span.
  double bendBySquare(const Place& a, const Place& b, double least_e2) const {
    const double d = least_e2 >= 0.0 ? a.d : b.d;
    const double by_d = slopeOfFoot(d);
    const double by_e = piece_->rc == 0.0 ? 0.5 / root(piece_->radius * piece_->radius - d * d)
                                          : (by_d == 0.0 ? 0.0 : 0.5 * by_d / d);
    return least_e2 == 0.0 ? 0.0 : by_e * least_e2;
  }

  /// The same by the distance itself: L'' d'^2 + L' d''.
  double bendByDistance(const Place& a, const Place& b, double least_e2) const {
    if (a.d <= kRootMm) return -kNoHeight;
    const double off = std::max(0.0, -least_e2) * (b.t - a.t);
    const double least_e1 = std::max(0.0, std::min(a.e1, b.e1) - off), most_e1 = std::max(a.e1, b.e1) + off;
    const double least_d1 = 0.5 * least_e1 / b.d, most_d1 = 0.5 * most_e1 / a.d;
    const double pull = 0.5 * least_e2 - most_d1 * most_d1;
    const double d2 = pull >= 0.0 ? pull / b.d : pull / a.d;
    const double steep = slopeOfFoot(pull >= 0.0 ? a.d : b.d);
    return bendOfFoot(a.d) * least_d1 * least_d1 + (steep == 0.0 ? 0.0 : steep * d2);
  }

  Bounds bounds(const Place& a, const Place& b) const {
    const double wide = b.t - a.t;
    const double least_e2 = std::min(a.e2, b.e2) - column_.fourth() * wide * wide / 8.0;
    Bounds out{0.0, leastBendOfHeight(a, b)};
    if (piece_->kind == PieceKind::kLevel) return out;
    const bool arc = piece_->kind == PieceKind::kArc;
    // No distance from a way bends down more than the way does.
    out.foot2 = arc ? bendBySquare(a, b, least_e2) : -piece_->slope * column_.way().most_bend;
    if (out.foot2 + out.z2 < 0.0) out.foot2 = std::max(out.foot2, bendByDistance(a, b, least_e2));
    return out;
  }

  bool isSettled(const Place& a, const Place& b, const Bounds& least) const {
    if (a.foot + leastHeight(a, b) >= best_.value - kSettledMm) return true;
    const double wide = b.t - a.t, bend = std::max(0.0, -(least.foot2 + least.z2));
    if (bend == kNoHeight) return false;
    const double fall = a.slope() - 0.5 * bend * wide, rise = b.slope() + 0.5 * bend * wide;
    double low = std::min(a.value(), b.value());
    if (fall < 0.0 && rise > 0.0) {
      const double t = rise < kNoHeight ? (b.value() - a.value() - rise * wide) / (fall - rise) : wide;
      low = a.value() + fall * std::clamp(t, 0.0, wide);
    }
    return low >= best_.value - kSettledMm;
  }

  Place newton(const Place& a, const Place& b) const {
    const double wide = b.t - a.t;
    const double guess =
        b.slope() < kNoHeight ? a.t - a.slope() * wide / (b.slope() - a.slope()) : a.t + 0.5 * wide;
    return place(growingRoot(a.t, b.t, guess, kStepMm / column_.speed(), [&](double t) {
      const Place p = place(t);
      const double d2 = p.d > 0.0 ? (0.5 * p.e2 - p.d1 * p.d1) / p.d : 0.0;
      return Slope{p.slope(), bendOfFoot(p.d) * p.d1 * p.d1 + slopeOfFoot(p.d) * d2 + p.z2};
    }));
  }

  WayColumn& column_;
  int stretch_;
  const ColumnBoundary& boundary_;
  double side_, near_ = 0.0, way_ = 1.0;
  const Piece* piece_ = nullptr;
  Lowest best_;
  std::array<std::array<Place, 2>, kMostSpans> spans_;
};

/// The nearest place of one stretch.
const Seen& nearestOf(WayColumn& column, int stretch) {
  const Seen* best = nullptr;
  for (int i = 0; i < column.count(); ++i) {
    const Run& run = column.runs()[static_cast<std::size_t>(i)];
    if (run.stretch == stretch && (best == nullptr || run.near.e < best->e)) best = &run.near;
  }
  return *best;
}

}  // namespace

Interval wayColumn(const WaySweep& part, double x, double y, const Asked& asked) {
  if (const auto plain = plainWayColumn(part, x, y, asked)) return *plain;
  const ColumnSolid& solid = *part.solid;
  WayColumn column(part, x, y, asked.rim);
  const int stretch = part.again ? 2 : 1;
  if (column.stretches() < stretch) {
    if (!asked.rim) return {};
    const Seen& near = column.nearest();
    // What is seen once is covered by the pass of that.
    const double beyond = part.again ? solid.radius : near.distance() - solid.radius;
    return beside(solid, beyond, near.z, 0.0, near.rad);
  }
  const Seen near = nearestOf(column, stretch);
  Interval in{.beyond = near.distance() - solid.radius, .u = near.rad};
  findEnds(
      solid, asked, 0.0, near.z, in, [&] { return WayLeast(column, stretch, solid.lower, 1.0).find(); },
      [&] { return WayLeast(column, stretch, solid.upper, -1.0).find(); });
  return in;
}

double wayGap(const WaySweep& part, double x, double y) {
  return WayColumn(part, x, y, true).nearest().distance();
}

}  // namespace proveout
