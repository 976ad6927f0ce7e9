// The nearest place of a solid on a helix about z.
//
// The level distance of a point from the tool's axis on a circle of radius r about a centre at d is convex up
// to acos(min(r / d, d / r)) to both sides of its least value, and grows beyond; the distance from a convex
// solid of revolution does not fall with it. So the distance is convex around the nearest place of each turn,
// has a bound for its bend beyond, and for all of a turn a bound from the least level distance.
#include "core/base/assert.h"
#include "removal/sweep/column_angle.h"
#include "removal/sweep/curve_search.h"

namespace proveout {

namespace {

/// Newton's method is tried on this span about the nearest place of a turn at least, and on spans of this
/// size beyond.
const double kNearSpan = degToRad(20.0), kFarSpan = degToRad(30.0);
const double kNearCos = std::cos(kNearSpan);
/// Rounds of Newton's method; how near (share of what is left) it comes to known places.
constexpr int kMostRounds = 60;
constexpr double kKnownMargin = 1e-6;
/// Steps after which what is left of a span is halved instead.
constexpr int kMostSteps = 24;

}  // namespace

void Sweep::CurveSearch::Bracket::add(const Place& place) {
  if (place.at.slope <= 0.0) low = place, low_known = true;
  if (place.at.slope >= 0.0) high = place, high_known = true;
  PROVEOUT_ASSERT_DEAR(low.t <= high.t);
}

/// Sets `between` from the support lines at the places that are known; where they meet.
double Sweep::CurveSearch::Bracket::support() {
  const double w = width();
  if (both()) {
    // With bend / 2 (t - low) (t - high), which is 0 at both and below 0 between them, the values are convex.
    const double fall = low.at.slope - 0.5 * bend * w, rise = high.at.slope + 0.5 * bend * w;
    const double step = rise > fall ? (low.at.value - high.at.value + rise * w) / (rise - fall) : 0.0;
    between = low.at.value + fall * step;
    return low.t + step;
  }
  const Place& from = low_known ? low : high;
  between = from.at.value - std::abs(from.at.slope) * w - 0.5 * bend * w * w;
  return low_known ? high.t : low.t;
}

void Sweep::CurveSearch::settle(const Bracket& bracket) {
  leave(bracket.low.t, bracket.high.t, bracket.between);
  if (bracket.low_known) walk(bracket.low, bracket.a, bracket.bend);
  if (bracket.high_known) walk(bracket.high, bracket.b, bracket.bend);
}

/// From a place on to `end`, in steps within which its value, slope and bend prove that none is better than
/// the best: where the values rise they get longer and longer.
void Sweep::CurveSearch::walk(Place from, double end, double bend) {
  const double side = end < from.t ? -1.0 : 1.0;
  double left = std::abs(end - from.t), low = from.at.value;
  for (int step = 0; step < kMostSteps; ++step) {
    const double rise = side * from.at.slope;
    low = from.at.value + std::min(0.0, (rise - 0.5 * bend * left) * left);
    if (low >= goal()) break;
    if (rise < 0.0) break;  // down again: not settled
    const double reach = (rise + std::sqrt(rise * rise + 2.0 * bend * (from.at.value - goal()))) / bend;
    bound = std::min(bound, goal());
    const double t = from.t + side * std::min(reach, left);
    from = {t, consider(t)};
    left = std::abs(end - t);
    low = from.at.value - (std::abs(from.at.slope) + 0.5 * bend * left) * left;
  }
  leave(std::min(from.t, end), std::max(from.t, end), low);
}

/// Newton's method on a span whose values have a second derivative of at least -bend, until two places prove
/// that no value between them is better than the best. What they do not prove is left.
void Sweep::CurveSearch::newton(double a, double b, double start, double bend) {
  PROVEOUT_ASSERT_DEAR(a <= b && bend >= 0.0);
  Bracket bracket{a, b, bend, {a, {}}, {b, {}}};
  double t = std::clamp(start, a, b), before = std::numeric_limits<double>::infinity();
  bool helps = true;
  for (int round = 0; round < kMostRounds; ++round) {
    const Place now{t, consider(t)};
    bracket.add(now);
    const double slope = now.at.slope, steep = std::abs(slope);
    helps = round == 0 || !helps || steep < kHelps * before;
    before = steep;
    t = bracket.support();
    const bool at_end = slope == 0.0 || (now.t == a && slope > 0.0) || (now.t == b && slope < 0.0);
    if (at_end || bracket.between >= goal()) break;
    if (helps || !bracket.both()) {
      double step = now.at.bend > 0.0 ? steep / now.at.bend : std::numeric_limits<double>::infinity();
      // Near the least value a little beyond it, so that it is between two places.
      if (step * steep < kNear * tolerance) step *= kOvershoot;
      step = std::max(helps ? step : 2.0 * step, 0.5 * tolerance / steep);
      const double next = now.t + (slope < 0.0 ? step : -step);
      if (next > bracket.low.t && next < bracket.high.t) t = next;
    }
    if (!bracket.both()) continue;
    const double margin = kKnownMargin * bracket.width();
    t = std::clamp(t, bracket.low.t + margin, bracket.high.t - margin);
    if (!(t > bracket.low.t && t < bracket.high.t)) break;
  }
  settle(bracket);
}

/// The level distance of the point from the tool's axis is nowhere less.
double Sweep::CurveSearch::levelGap() const {
  const auto [least, most] = std::minmax(sweep.frame_.radius_start, sweep.frame_.radius_end);
  return std::max({off_axis - most, least - off_axis, 0.0});
}

/// No value between two parameters is less where the level distance is at least `gap`. `slope`: of the bound
/// by the height of the tool.
double Sweep::CurveSearch::heightBound(double gap, double a, double b, double& slope) const {
  const double rise = sweep.frame_.n.z() * sweep.frame_.rise;
  const ProfileSample s = sweep.profile_->sample(gap, p.z() - sweep.arc_.center.z() - 0.5 * (a + b) * rise);
  slope = -s.gz;
  return s.value - std::abs(s.gz * 0.5 * (b - a) * rise) - kBoundSlackMm;
}

/// The second derivative of the distance is nowhere below minus this up to an angle off the nearest place.
double Sweep::CurveSearch::bendBound(const Turn& turn, double off_rad) const {
  double bend = turn.slack_bend;
  if (off_rad > turn.convex_rad) {
    // Of the level distance: -rd (r cos - d) (d cos - r) / gap^3, which falls with the angle.
    const double c = std::cos(off_rad), r = turn.radius, d = off_axis, gap2 = r * r + d * d - 2.0 * r * d * c;
    bend += std::max(0.0, r * d * (d - r * c) * (r - d * c) * angle * angle / (gap2 * std::sqrt(gap2)));
  }
  return std::min(bend, sweep.curvature_bound_);
}

Sweep::CurveSearch::Turn Sweep::CurveSearch::turnAt(double middle) const {
  const ArcFrame& f = sweep.frame_;
  const double growth = std::abs(f.radius_end - f.radius_start), turn = 2.0 * kPi / angle;
  Turn out{middle, f.radius_start + std::clamp(middle, 0.0, 1.0) * (f.radius_end - f.radius_start), 0.0, 0.0,
           growth * std::min(1.0, turn)};
  const double r = out.radius, d = off_axis;
  // Below the near span it bears on nothing.
  const double convex = d > 0.0 ? std::min(r / d, d / r) : 0.0;
  out.convex_rad = convex < kNearCos ? std::acos(convex) : 0.0;
  if (growth > 0.0) {
    const double gap = std::max(std::abs(d - r) - out.slack_mm, 1e-9);
    out.slack_bend = angle * growth * (r / gap + 2.0) +
                     4.0 * angle * angle * out.slack_mm * (1.0 + r / gap) * (1.0 + r / gap);
  }
  return out;
}

/// The part of a turn to one side of where the distance is convex, as far as half a turn.
void Sweep::CurveSearch::searchSide(const Turn& turn, int side) {
  const double inner = std::max(turn.convex_rad, kNearSpan);
  const auto at = [&](double off) { return std::clamp(turn.middle + side * off / angle, 0.0, 1.0); };
  const auto gap = [&](double off) {
    const double r = turn.radius, d = off_axis;
    return std::max(0.0,
                    std::sqrt(std::max(0.0, r * r + d * d - 2.0 * r * d * std::cos(off))) - turn.slack_mm);
  };
  // The way may begin farther off.
  double from = std::max(inner, side * ((side > 0 ? 0.0 : 1.0) - turn.middle) * angle);
  while (from < kPi) {
    const double a = at(from), end = at(kPi);
    if (a == end) return;
    double slope;
    const double rest = heightBound(gap(from), std::min(a, end), std::max(a, end), slope);
    if (rest >= goal()) {
      bound = std::min(bound, rest);
      return;
    }
    const double to = std::min(kPi, from + kFarSpan), b = at(to);
    newton(std::min(a, b), std::max(a, b), a, bendBound(turn, to));
    from = to;
  }
}

void Sweep::CurveSearch::searchTurn(double middle, double start) {
  const Turn turn = turnAt(middle);
  const double near = std::max(turn.convex_rad, kNearSpan);
  const double a = std::clamp(middle - near / angle, 0.0, 1.0),
               b = std::clamp(middle + near / angle, 0.0, 1.0);
  if (a < b) newton(a, b, start >= a && start <= b ? start : middle, bendBound(turn, near));
  searchSide(turn, -1);
  searchSide(turn, 1);
  divide();
}

/// Of the turns with their nearest places at near, near + 1 turn, ... last: the one to begin with. That is
/// the one of the start, or the better of the lowest and the highest whose tip is not above the point.
double Sweep::CurveSearch::firstTurn(double near, double last, double start) {
  const double turn = 2.0 * kPi / angle, rise = sweep.frame_.n.z() * sweep.frame_.rise;
  const auto nearest = [&](double t) {
    return near + std::clamp(std::round((t - near) / turn) * turn, 0.0, last - near);
  };
  if (start >= 0.0) return nearest(start);
  if (last - near < 0.5 * turn) return near;
  const auto value = [&](double t) { return consider(std::clamp(t, 0.0, 1.0)).value; };
  const double level = rise != 0.0 ? (p.z() - sweep.from_.z()) / rise : 0.0;
  const double lowest = rise < 0.0 ? last : near, beside = nearest(level + (rise < 0.0 ? 0.5 : -0.5) * turn);
  return value(beside) < value(lowest) ? beside : lowest;
}

void Sweep::CurveSearch::turns(double start) {
  const ArcFrame& f = sweep.frame_;
  const Vec3 from = p - sweep.arc_.center;
  off_axis = from.head<2>().norm();
  double slope;
  if (cutoff < std::numeric_limits<double>::infinity()) {
    bound = heightBound(levelGap(), 0.0, 1.0, slope);
    if (bound > cutoff) return;
    bound = std::numeric_limits<double>::infinity();
  }
  double around = turnAngle(from.dot(f.u), from.dot(f.v), off_axis, -kPi);
  if (sweep.arc_.sweep_rad < 0.0) around = -around;
  // Turns reach half a turn to both sides of their nearest places.
  const double turn = 2.0 * kPi / angle, any = around / angle;
  const double near = any + std::ceil(-any / turn - 0.5) * turn;
  const double last = near + std::max(0.0, std::floor((1.0 - near) / turn + 0.5)) * turn;
  const double first = firstTurn(near, last, start);
  searchTurn(first, start);
  const double gap = levelGap(), rise = f.n.z() * f.rise;
  for (const int way : {1, -1}) {
    for (double middle = first + way * turn; middle > near - 0.5 * turn && middle < last + 0.5 * turn;
         middle += way * turn) {
      const double a = std::clamp(middle - 0.5 * turn, 0.0, 1.0),
                   b = std::clamp(middle + 0.5 * turn, 0.0, 1.0);
      const double low = heightBound(gap, a, b, slope);
      if (low < goal()) {
        searchTurn(middle, kAnywhere);
        continue;
      }
      bound = std::min(bound, low);
      if (slope * rise * way >= 0.0) break;  // the bounds of turns farther on are no less
    }
  }
}

}  // namespace proveout
