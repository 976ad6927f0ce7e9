#include "removal/sweep/sweep.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

/// Moves shorter than this are a point: no direction can be taken from them.
constexpr double kPointMoveMm = 1e-9;
/// How far along the path a kink in the distance is looked for: above the error of the nearest time, far
/// below the smallest radius.
constexpr double kKinkStepMm = 1e-3;
/// A normal this near to being at right angles to the motion needs no look at both sides.
constexpr double kSquareSlope = 1e-6;
/// Elements of the profile that meet at more than 10 degrees have a sharp rim between them.
const double kRimCos = std::cos(degToRad(10.0));
/// Height of normals of a straight element of the profile, within rounding.
constexpr double kFaceSlack = 1e-6;
/// The tool is at a wall that it leaves going upright, mm: rounding.
constexpr double kAtWallMm = 1e-9;
/// A place this near to an end of the way is that end.
constexpr double kAtEnd = 1e-6;
/// A search does not come nearer to a place that it knows than this part of what is left.
constexpr double kMargin = 1e-6;
/// Sine of the angle below a ball's middle from which on its sphere alone is nearest.
constexpr double kBelowMiddle = 1e-6;
/// What Sweep::ballGap says where something else than the sphere is nearest.
constexpr double kNotBall = std::numeric_limits<double>::infinity();
/// Rounds after which a search gives its best value; a bracketed search on doubles needs fewer.
constexpr int kMaxLineRounds = 80;
/// Growth of the radius a radian, by the radius, up to which a level spiral has one nearest point a turn
/// close to the circle's.
constexpr double kNearCircle = 0.05;
/// The same of the whole way, by the radius, up to which a curve's turns count as round.
constexpr double kRounded = 1e-3;

}  // namespace

Sweep::Sweep(const ConvexProfile& profile, const Vec3& from, const Vec3& to, const ArcGeometry* arc)
    : profile_(&profile), from_(from), delta_(to - from) {
  level_length2_ = delta_.head<2>().squaredNorm();
  length2_ = delta_.squaredNorm();
  if (arc == nullptr) {
    if (length2_ < kPointMoveMm * kPointMoveMm) {
      kind_ = Kind::kPoint;
    } else {
      kind_ = delta_.z() == 0.0 ? Kind::kLevelLine : Kind::kLine;
    }
  } else {
    arc_ = *arc;
    frame_ = arcFrame(from, to, arc_);
    const double sweep = std::abs(arc_.sweep_rad);
    const double dr = frame_.radius_end - frame_.radius_start;
    curvature_bound_ =
        std::max(frame_.radius_start, frame_.radius_end) * sweep * sweep + 2.0 * std::abs(dr) * sweep;
    vertical_ = arc_.normal.head<2>().squaredNorm() < 1e-24;
    round_turns_ = vertical_ && std::abs(dr) <= kRounded * std::min(frame_.radius_start, frame_.radius_end);
    const bool level = std::abs(frame_.rise) < kPointMoveMm &&
                       std::abs(dr) <= kNearCircle * sweep * std::min(frame_.radius_start, frame_.radius_end);
    kind_ = vertical_ && level ? Kind::kLevelArc : Kind::kCurve;
    Toolpath one;
    one.arcs.push_back(arc_);
    Motion motion;
    motion.from = from;
    motion.to = to;
    motion.arc = 0;
    curve_bounds_ = one.bounds(motion);
  }
}

Box3 Sweep::bounds() const {
  Box3 way = curve_bounds_;
  if (kind_ != Kind::kCurve && kind_ != Kind::kLevelArc) {
    way.extend(from_);
    way.extend(from_ + delta_);
  }
  const double radius = profile_->maxRadius();
  return {way.min + Vec3(-radius, -radius, profile_->zMin()),
          way.max + Vec3(radius, radius, profile_->zMax())};
}

Vec3 Sweep::position(double t) const {
  return kind_ == Kind::kCurve || kind_ == Kind::kLevelArc ? arcPoint(frame_, arc_, t)
                                                           : Vec3(from_ + t * delta_);
}

namespace {

/// Gradient in space of the profile's distance at offset q from the tool tip.
Vec3 spaceGradient(const ProfileSample& s, const Vec3& q, double r) {
  if (r > 0.0) return {s.gr * q.x() / r, s.gr * q.y() / r, s.gz};
  return {0.0, 0.0, s.gz};
}

/// At::bend of a solid that moves with this velocity, for an offset q whose level length is r > 0.
double bendOf(const ProfileSample& s, const Vec3& q, double r, const Vec3& velocity) {
  // The point's place in the half-plane moves at (dr, dz); r is a hyperbola. The square of a distance from
  // a point is far more like a parabola than the distance.
  const double dr = -(q.x() * velocity.x() + q.y() * velocity.y()) / r, dz = -velocity.z();
  double bend = s.gr * (velocity.head<2>().squaredNorm() - dr * dr) / r;
  if (s.radius > 0.0) bend += (dr * dr + dz * dz) / s.radius;
  return bend;
}

}  // namespace

Sweep::At Sweep::evaluate(const Vec3& p, double t) const {
  return kind_ == Kind::kCurve || kind_ == Kind::kLevelArc ? evaluateCurve(p, t) : evaluateLine(p, t);
}

Sweep::At Sweep::evaluateCurve(const Vec3& p, double t) const {
  const double angle = t * arc_.sweep_rad;
  const double dr = frame_.radius_end - frame_.radius_start;
  const double radius = frame_.radius_start + t * dr;
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec3 at =
      arc_.center + frame_.u * (radius * c) + frame_.v * (radius * s) + frame_.n * (t * frame_.rise);
  const Vec3 velocity = frame_.u * (dr * c - radius * arc_.sweep_rad * s) +
                        frame_.v * (dr * s + radius * arc_.sweep_rad * c) + frame_.n * frame_.rise;
  const Vec3 q = p - at;
  const double r = std::sqrt(q.x() * q.x() + q.y() * q.y());
  const ProfileSample sample = profile_->sample(r, q.z());
  const Vec3 gradient = spaceGradient(sample, q, r);
  At out{sample.value, -gradient.dot(velocity), sample.element, gradient};
  if (r > 0.0) {
    const double w = arc_.sweep_rad;
    const Vec3 acceleration = frame_.u * (-radius * w * w * c - 2.0 * dr * w * s) +
                              frame_.v * (-radius * w * w * s + 2.0 * dr * w * c);
    out.bend = bendOf(sample, q, r, velocity) - gradient.dot(acceleration);
  }
  return out;
}

Sweep::At Sweep::evaluateLine(const Vec3& p, double t) const {
  const Vec3 q = p - from_ - t * delta_;
  const double r = std::sqrt(q.x() * q.x() + q.y() * q.y());
  const ProfileSample s = profile_->sample(r, q.z());
  const Vec3 gradient = spaceGradient(s, q, r);
  At out{s.value, -gradient.dot(delta_), s.element, gradient};
  if (r > 0.0) out.bend = bendOf(s, q, r, delta_);
  return out;
}

double Sweep::levelParameter(double x, double y) const {
  if (kind_ == Kind::kLevelLine) {
    const double t = ((x - from_.x()) * delta_.x() + (y - from_.y()) * delta_.y()) / level_length2_;
    return std::clamp(t, 0.0, 1.0);
  }
  // Level arc: the distance to the tool axis grows with the angle to the point, so the nearest angle is best;
  // a spiral (also a circle whose ends are rounded to the program's digits) has one such place a turn.
  const double px = x - arc_.center.x(), py = y - arc_.center.y();
  double angle = std::atan2(px * frame_.v.x() + py * frame_.v.y(), px * frame_.u.x() + py * frame_.u.y());
  if (arc_.sweep_rad < 0.0) angle = -angle;
  if (angle < 0.0) angle += 2.0 * kPi;
  const double span = std::abs(arc_.sweep_rad);
  if (frame_.radius_end == frame_.radius_start) {
    if (angle <= span) return span > 0.0 ? angle / span : 0.0;
    return angle - span < 2.0 * kPi - angle ? 1.0 : 0.0;
  }
  const auto gap2 = [&](double t) {
    const Vec3 c = arcPoint(frame_, arc_, t);
    return (c.x() - x) * (c.x() - x) + (c.y() - y) * (c.y() - y);
  };
  double best = gap2(0.0) <= gap2(1.0) ? 0.0 : 1.0, least = gap2(best);
  const auto consider = [&](double start) {
    const double t = refineLevel(x, y, start);
    if (const double g = gap2(t); g < least) least = g, best = t;
  };
  // The nearest place may lie just inside an end while the point's own angle lies outside.
  consider(0.0);
  consider(1.0);
  for (; angle <= span; angle += 2.0 * kPi) consider(angle / span);
  return best;
}

/// Newton's method on the squared distance to a level spiral, from a start near its minimum.
double Sweep::refineLevel(double x, double y, double t) const {
  const double dr = frame_.radius_end - frame_.radius_start, w = arc_.sweep_rad;
  for (int i = 0; i < 8; ++i) {
    const double c = std::cos(t * w), s = std::sin(t * w), radius = frame_.radius_start + t * dr;
    const Vec3 to = Vec3(x, y, 0.0) - arc_.center;
    const double pu = to.x() * frame_.u.x() + to.y() * frame_.u.y(),
                 pv = to.x() * frame_.v.x() + to.y() * frame_.v.y();
    const double along = pu * c + pv * s,
                 across = pv * c - pu * s;  // of the point, on the radius at t and square to it
    const double slope = dr * (radius - along) - radius * w * across;
    const double bend = dr * dr - 2.0 * dr * w * across + radius * w * w * along;
    if (bend <= 0.0) break;
    const double next = std::clamp(t - slope / bend, 0.0, 1.0);
    if (std::abs(next - t) < 1e-14) return next;
    t = next;
  }
  return t;
}

/// The ball end's closed form; otherwise where the tool's axis is nearest. There the flank's distance is
/// stationary: where the flank is nearest a search ends at once.
double Sweep::guessOnLine(const Vec3& p) const {
  if (const double lift = profile_->ballCenter(); lift > 0.0)
    return std::clamp((p - from_ - Vec3(0, 0, lift)).dot(delta_) / length2_, 0.0, 1.0);
  if (level_length2_ <= 0.0) return 0.0;
  return std::clamp((p - from_).head<2>().dot(delta_.head<2>()) / level_length2_, 0.0, 1.0);
}

/// How far the parameter goes from a place on a line, down the slope, until another element than this flat
/// end or cylinder is nearest; infinite where that is not known.
double Sweep::stepToEdge(const Vec3& p, const Place& from) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const ConvexProfile::Element& e = profile_->element(from.at.element - profile_->firstElementId());
  const Vec3 q = p - from_ - from.t * delta_;
  const double down = from.at.slope < 0.0 ? 1.0 : -1.0;
  if (e.arc || (e.dr != 0.0 && e.dz != 0.0)) return kNever;
  if (e.dr == 0.0) {
    const double fall = down * delta_.z();
    const double end = (fall > 0.0) == (e.az < e.bz) ? e.az : e.bz;
    return down * std::max(0.0, (q.z() - end) / fall);
  }
  const Vec2 level = q.head<2>(), way = delta_.head<2>();
  const double rim = std::max(e.ar, e.br), along = level.dot(way);
  const double root = along * along - level_length2_ * (level.squaredNorm() - rim * rim);
  return level_length2_ > 0.0 && root > 0.0 ? (along + down * std::sqrt(root)) / level_length2_ : kNever;
}

/// From a place on a line towards the least value; infinite where that is not known.
double Sweep::newtonStep(const Vec3& p, const Place& from) const {
  const auto& [value, slope, element, gradient, bend] = from.at;
  const double step = bend > 0.0 ? -slope / bend : std::numeric_limits<double>::infinity();
  if (gradient.z() != 0.0 && gradient.z() != -1.0 && gradient.z() != 1.0) return step;
  const double edge = stepToEdge(p, from);
  if (std::abs(edge) >= std::abs(step)) return step;
  // On along the rim, a distance from a point.
  const double rim_slope = slope + bend * edge, rim_value = value + (slope + 0.5 * bend * edge) * edge;
  const Vec2 level = (p - from_ - (from.t + edge) * delta_).head<2>(), way = delta_.head<2>();
  const double dr = level.dot(way) / level.norm(), bends = dr * dr + delta_.z() * delta_.z();
  return rim_value > 0.0 && bends > 0.0 ? edge - rim_slope * rim_value / bends : edge;
}

/// Whether Newton's next step ends between the parameters `low` and `high` and promises to gain little.
bool Sweep::isSettled(const Vec3& p, const Place& place, double low, double high, double tolerance) const {
  constexpr double kMostGain = 0.25;  // of the tolerance
  if (!(place.at.bend > 0.0)) return false;
  const double step = newtonStep(p, place), end = place.t + step;
  return end >= low && end <= high && 0.5 * std::abs(step * place.at.slope) < kMostGain * tolerance;
}

/// Newton's method from one side until the least value lies between two places, which the support lines there
/// prove (the value is convex).
Sweep::Place Sweep::minimiseLine(const Vec3& p, double cutoff, double tolerance, double& bound, double start,
                                 Search search) const {
  Place low{0.0, {}}, high{1.0, {}};  // of slopes below and above 0; at the ends before they are known
  bool low_known = false, high_known = false, helps = true;
  const double first = start < 0.0 ? guessOnLine(p) : start;
  Place now{first, evaluateLine(p, first)};
  for (int round = 0; round < kMaxLineRounds; ++round) {
    const double slope = now.at.slope;
    bound = now.at.value;
    if (slope == 0.0 || (now.t == 0.0 && slope > 0.0) || (now.t == 1.0 && slope < 0.0)) return now;
    (slope < 0.0 ? low : high) = now;
    (slope < 0.0 ? low_known : high_known) = true;
    const double width = high.t - low.t;
    double t;
    const bool between = low_known && high_known;
    if (between) {
      const double rise = high.at.slope - low.at.slope;
      t = low.t + (low.at.value - high.at.value + high.at.slope * width) / rise;
      bound = low.at.value + low.at.slope * (t - low.t);
    } else {
      t = slope < 0.0 ? 1.0 : 0.0;
      bound = now.at.value + slope * (t - now.t);
    }
    const Place& best = !high_known || (low_known && low.at.value < high.at.value) ? low : high;
    if (bound > cutoff) return best;
    if (best.at.value - bound < tolerance) {
      // The tool's face at the end of the way, and not its rim shortly before.
      const bool at_end = !between && std::abs(t - best.t) < kAtEnd;
      return at_end ? Place{t, evaluateLine(p, t)} : best;
    }
    if (search == Search::kSettled && isSettled(p, now, low.t, high.t, tolerance)) return now;
    // At kinks Newton's steps lead nowhere: there follows one to where the support lines meet.
    if (helps || !between) {
      double step = std::abs(newtonStep(p, now));
      // Near the least value a little beyond it, so that it is between two places.
      if (step * std::abs(slope) < kNear * tolerance) step *= kOvershoot;
      step = std::max(helps ? step : 2.0 * step, 0.5 * tolerance / std::abs(slope));
      const double next = now.t + (slope < 0.0 ? step : -step);
      if (next > low.t && next < high.t) t = next;
    }
    const double before = std::abs(slope);
    if (between) {
      const double margin = kMargin * width;
      t = std::clamp(t, low.t + margin, high.t - margin);
      if (!(t > low.t && t < high.t)) return best;
    }
    now = {t, evaluateLine(p, t)};
    helps = !helps || std::abs(now.at.slope) < kHelps * before;
  }
  return now;
}

Sweep::Place Sweep::minimise(const Vec3& p, double cutoff, double tolerance, double& bound, double start,
                             Search search) const {
  if (kind_ == Kind::kLine) return minimiseLine(p, cutoff, tolerance, bound, start, search);
  if (kind_ == Kind::kCurve) return minimiseCurve(p, cutoff, tolerance, bound, start);
  const double t = kind_ == Kind::kPoint ? 0.0 : levelParameter(p.x(), p.y());
  const Place place{t, evaluate(p, t)};
  bound = place.at.value;
  return place;
}

/// Distance to what a ball end sweeps along a line, where its sphere is nearest; else kNotBall. `from_center`
/// receives the way from the sphere's nearest centre.
double Sweep::ballGap(const Vec3& p, Vec3& from_center) const {
  const double radius = profile_->ballCenter();
  const Vec3 q = p - from_ - Vec3(0.0, 0.0, radius);
  // The sphere's nearest position is the tool's, as long as the point is level with or below the centre
  // there.
  const Vec3 e = from_center = q - std::clamp(q.dot(delta_) / length2_, 0.0, 1.0) * delta_;
  const double gap = e.norm() - radius;
  // Within a short ball its top may be nearer.
  return e.z() <= 0.0 && (gap >= 0.0 || profile_->zMax() >= 2.0 * radius) ? gap : kNotBall;
}

/// Lower bound of the distance: the solid's axis comes no nearer than the cylinder that it goes along, and
/// nothing lies deeper than the largest radius less that.
double Sweep::helixBound(const Vec3& p) const {
  constexpr double kRounding = 1e-9;  // mm
  const double from_axis = (p - arc_.center).head<2>().norm();
  const auto [least, most] = std::minmax(frame_.radius_start, frame_.radius_end);
  return std::max(least - from_axis, from_axis - most) - profile_->maxRadius() - kRounding;
}

double Sweep::distance(const Vec3& p, double cutoff, double tolerance) const {
  if (kind_ == Kind::kLine && profile_->ballCenter() > 0.0) {
    Vec3 from_center;
    if (const double d = ballGap(p, from_center); d < kNotBall) return d;
  }
  if (replacesChords()) {
    const double bound = helixBound(p);
    if (bound > cutoff) return bound;
  }
  double bound = 0.0;
  const Place place = minimise(p, cutoff, tolerance, bound);
  return bound > cutoff ? bound : place.at.value;
}

bool Sweep::holds(const Vec3& a, const Vec3& b) const {
  for (const Vec3& p : {Vec3(0.5 * (a + b)), a, b}) {
    double bound = 0.0;
    const Place place = minimise(p, 0.0, kLineToleranceMm, bound);
    if (bound >= 0.0 || place.at.value >= 0.0) return false;
    if (evaluate(a, place.t).value < 0.0 && evaluate(b, place.t).value < 0.0) return true;
  }
  return false;
}

SweepSample Sweep::sampleOutside(const Vec3& p, double tolerance, double& start) const {
  if (profile_->ballCenter() > 0.0 && (kind_ == Kind::kLine || kind_ == Kind::kLevelLine)) {
    // Beside its middle the flank is as near, and may be what the place is named after.
    Vec3 out;
    const double gap = ballGap(p, out), distance = gap + profile_->ballCenter();
    if (gap < kNotBall && out.z() < -kBelowMiddle * distance)
      return {gap, out / distance, profile_->firstElementId()};
  }
  double bound = 0.0;
  const auto [t, at] =
      minimise(p, std::numeric_limits<double>::infinity(), tolerance, bound, start, Search::kSettled);
  if (kind_ == Kind::kLine) start = t == guessOnLine(p) ? kAnywhere : t;
  if (kind_ == Kind::kCurve) start = t;
  const int element = elementAt(p, at);
  const ConvexProfile::Element& e = profile_->element(element - profile_->firstElementId());
  const bool at_end = !e.arc && std::abs(at.gradient.z() + e.dr) > kFaceSlack;
  return {at.value, at.gradient, at_end ? ConvexProfile::kEdgeIds + element : element};
}

int Sweep::elementAt(const Vec3& p, const At& at) const {
  const bool upright = kind_ == Kind::kLine && level_length2_ <= 0.0;
  if (!upright || std::abs(at.gradient.z()) > kFaceSlack) return at.element;
  const At lowest = evaluateLine(p, delta_.z() < 0.0 ? 1.0 : 0.0);
  return lowest.value <= at.value + kAtWallMm ? lowest.element : at.element;
}

SweepSample Sweep::sample(const Vec3& p) const {
  double bound = 0.0;
  return withRim(p, minimise(p, std::numeric_limits<double>::infinity(), kLineToleranceMm, bound));
}

SweepSample Sweep::withRim(const Vec3& p, const Place& place) const {
  const auto& [t, at] = place;
  // Where a sharp rim of the tool leaves the surface, the distance has a kink in time: just before and just
  // after, different elements are nearest. The surface's normal is the mix of both that is at right angles to
  // the motion.
  const double length = kind_ == Kind::kLine ? std::sqrt(length2_)
                        : kind_ == Kind::kCurve
                            ? std::max(frame_.radius_start, frame_.radius_end) * std::abs(arc_.sweep_rad) +
                                  std::abs(frame_.rise)
                            : 0.0;
  // At right angles to the motion the normal is right as it is.
  if (kind_ == Kind::kCurve && std::abs(at.slope) <= kSquareSlope * length)
    return {at.value, at.gradient, at.element};
  if (length > 0.0 && t > 0.0 && t < 1.0) {
    const double step = kKinkStepMm / length;
    const At before = evaluate(p, std::max(0.0, t - step)), after = evaluate(p, std::min(1.0, t + step));
    if (before.slope < 0.0 && after.slope > 0.0) {
      const Vec3 mix = before.gradient * after.slope - after.gradient * before.slope;
      const bool rim = before.element != after.element && before.gradient.dot(after.gradient) < kRimCos;
      const int element =
          rim ? ConvexProfile::kEdgeIds + std::min(before.element, after.element) : at.element;
      if (const double norm = mix.norm(); norm > 0.0) return {at.value, mix / norm, element};
    }
  }
  return {at.value, at.gradient, elementAt(p, at)};
}

double Sweep::horizontalGap(double x, double y) const {
  double t = 0.0;
  if (kind_ == Kind::kLine && level_length2_ > 0.0) {
    t = std::clamp(((x - from_.x()) * delta_.x() + (y - from_.y()) * delta_.y()) / level_length2_, 0.0, 1.0);
  }
  const double gx = x - from_.x() - t * delta_.x(), gy = y - from_.y() - t * delta_.y();
  return std::sqrt(gx * gx + gy * gy) - profile_->maxRadius();
}

void Sweep::slantedColumn(double x, double y, double z0, double dz, int count, const double* cutoff,
                          double* out) const {
  const double largest = *std::max_element(cutoff, cutoff + count);
  const double gap = horizontalGap(x, y);
  if (gap > largest) {
    std::fill_n(out, count, gap);
    return;
  }
  const Box3 around = bounds();
  const double radius = profile_->ballCenter();
  const double qx = x - from_.x(), qy = y - from_.y();
  const double level = qx * delta_.x() + qy * delta_.y();
  const double level_t = level_length2_ > 0.0 ? std::clamp(level / level_length2_, 0.0, 1.0) : 0.0;
  for (int k = 0; k < count; ++k) {
    const double z = z0 + k * dz;
    const double outside = std::max({gap, around.min.z() - z, z - around.max.z()});
    if (outside > cutoff[k]) {
      out[k] = outside;
      continue;
    }
    if (radius > 0.0) {
      // The flank, where the axis is nearest, as long as it reaches down to the point there and up over it.
      const double z_there = z - from_.z() - radius - level_t * delta_.z();
      if (z_there >= 0.0 && z_there + radius - profile_->zMax() <= std::min(gap, 0.0)) {
        out[k] = gap;
        continue;
      }
    }
    out[k] = distance({x, y, z}, cutoff[k]);
  }
}

void Sweep::column(double x, double y, double z0, double dz, int count, const double* cutoff,
                   double* out) const {
  if (kind_ == Kind::kLine) return slantedColumn(x, y, z0, dz, count, cutoff, out);
  if (kind_ == Kind::kCurve) {
    const Box3 around = bounds();
    for (int k = 0; k < count; ++k) {
      const Vec3 p(x, y, z0 + k * dz);
      const Vec3 beyond = (around.min - p).cwiseMax(p - around.max);
      out[k] = beyond.maxCoeff() > cutoff[k] ? beyond.maxCoeff() : distance(p, cutoff[k]);
    }
    return;
  }
  const Vec3 at = position(kind_ == Kind::kPoint ? 0.0 : levelParameter(x, y));
  const double r = std::sqrt((x - at.x()) * (x - at.x()) + (y - at.y()) * (y - at.y()));
  if (r - profile_->maxRadius() > *std::max_element(cutoff, cutoff + count)) {
    std::fill_n(out, count, r - profile_->maxRadius());
    return;
  }
  for (int k = 0; k < count; ++k) out[k] = profile_->sample(r, z0 + k * dz - at.z()).value;
}

}  // namespace proveout
