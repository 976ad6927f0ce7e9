#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/grid/edge_root.h"
#include "removal/sweep/column_curve.h"
#include "removal/sweep/swept_body.h"

namespace proveout {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

struct Ray {
  double x, y, dx, dy;
};

double enterDisc(const Ray& ray, double cx, double cy, double radius2) {
  const double qx = ray.x - cx, qy = ray.y - cy;
  const double b = qx * ray.dx + qy * ray.dy, c = qx * qx + qy * qy - radius2;
  const double d = b * b - c;
  if (c <= 0.0) return 0.0;
  if (d <= 0.0 || b >= 0.0) return kNever;
  return c / (-b + std::sqrt(d));  // the nearer root, without cancellation
}

/// Narrows [enter, leave] to where low <= p + s * d <= high.
void slab(double p, double d, double low, double high, double& enter, double& leave) {
  if (d == 0.0) {
    if (p < low || p > high) leave = -kNever;
    return;
  }
  const double s0 = (low - p) / d, s1 = (high - p) / d;
  enter = std::max(enter, std::min(s0, s1));
  leave = std::min(leave, std::max(s0, s1));
}

/// All points within `radius` of the stretch first..last of the line's level projection.
double enterStadium(const ColumnSweep& line, const Ray& ray, double first, double last, double radius) {
  if (first > last) return kNever;
  const auto disc = [&](double s) {
    return enterDisc(ray, line.x + s * line.ux, line.y + s * line.uy, radius * radius);
  };
  double best = std::min(disc(first), disc(last));
  const double qx = ray.x - line.x, qy = ray.y - line.y;
  double enter = 0.0, leave = best;
  slab(qx * line.ux + qy * line.uy, ray.dx * line.ux + ray.dy * line.uy, first, last, enter, leave);
  slab(qx * line.uy - qy * line.ux, ray.dx * line.uy - ray.dy * line.ux, -radius, radius, enter, leave);
  if (enter <= leave) best = enter;
  return best;
}

/// The stretch of the way on which a level disc between heights `low` and `high` above the tip holds height
/// z.
void discStretch(const ColumnSweep& line, double z, double low, double high, double& first, double& last) {
  first = 0.0;
  last = line.length;
  const double below = z - line.z - low, above = z - line.z - high;
  if (line.slope == 0.0) {
    if (below < 0.0 || above > 0.0) last = -1.0;
    return;
  }
  const double s0 = above / line.slope, s1 = below / line.slope;
  first = std::max(first, std::min(s0, s1));
  last = std::min(last, std::max(s0, s1));
}

/// Radius up to which the solid reaches at height z, mm; below 0: it does not reach there.
double radiusAt(const ConvexProfile& profile, double z) {
  double radius = -1.0;
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (z < e.az || z > e.bz) continue;
    double r = std::max(e.ar, e.br);
    if (e.arc) {
      r = e.cr + std::sqrt(std::max(0.0, (e.radius - (z - e.cz)) * (e.radius + (z - e.cz))));
    } else if (e.bz > e.az) {
      r = e.ar + (z - e.az) * (e.dr / e.dz);
    }
    radius = std::max(radius, r);
  }
  return radius;
}

/// The same for the widest place between two heights: the radius is concave.
double radiusBetween(const ConvexProfile& profile, double low, double high) {
  double widest = profile.zMin(), most = -1.0;
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.ar > most) most = e.ar, widest = e.az;
    if (e.br > most) most = e.br, widest = e.bz;
  }
  return radiusAt(profile, std::clamp(widest, low, high));
}

/// Capsule of the ball's centre; the ray is level.
double enterCapsule(const ColumnSweep& line, const Ray& ray, double z, double radius) {
  const Vec3 way = sweepWay(line);
  const double length = way.norm();
  const Vec3 center = sweepStart(line) + Vec3(0, 0, radius);
  const auto ball = [&](const Vec3& c) {
    const double dz = z - c.z(), radius2 = radius * radius - dz * dz;
    return radius2 > 0.0 ? enterDisc(ray, c.x(), c.y(), radius2) : kNever;
  };
  double best = std::min(ball(center), ball(center + way));
  const Vec3 e = way / length, d(ray.dx, ray.dy, 0.0), q = Vec3(ray.x, ray.y, z) - center;
  const double along = q.dot(e), step = d.dot(e);
  const Vec3 q_across = q - along * e, d_across = d - step * e;
  const double a = d_across.squaredNorm(), b = q_across.dot(d_across),
               c = q_across.squaredNorm() - radius * radius;
  const double root2 = b * b - a * c;
  if (c > 0.0 && b < 0.0 && root2 > 0.0) {
    const double s = c / (-b + std::sqrt(root2));
    const double at = along + s * step;
    if (at >= 0.0 && at <= length) best = std::min(best, s);
  }
  if (c <= 0.0 && along >= 0.0 && along <= length) best = 0.0;
  return best;
}

}  // namespace

double searchCut(const SweptField& field, const Vec3& a, const Vec3& direction, double inside) {
  const auto f = [&](double s) { return field.distance(a + s * direction, kNever); };
  const double at_a = f(0.0), at_inside = f(inside);
  if (at_a <= 0.0) return 0.0;
  if (at_inside >= 0.0) return inside;  // touched within rounding
  return edgeRoot(f, 0.0, at_a, inside, at_inside, 1e-9);
}

namespace {

/// A step that leaves less than this share of the value was worth it. Behind one this short from a value this
/// small, mm, what is left is its square.
constexpr double kWorth = 0.5, kLastStepMm = 1e-7, kNearMm = 1e-6;
/// Values that count as 0, and edges as short as a point, mm.
constexpr double kZeroMm = 1e-10, kPointMm = 1e-9;

/// Newton's method from the end inside, where the slopes lead, and else the Illinois rule as edgeRoot.
class CurveRoot {
 public:
  CurveRoot(const ColumnSweep& part, const Vec3& a, double dx, double dy, double inside)
      : part_(part), a_(a), dx_(dx), dy_(dy), in_(inside) {}

  struct Found {
    double at, place;
  };
  Found find() {
    CurveSide side = look(in_);
    if (side.value >= 0.0) return {in_, side.place};
    f_in_ = side.value;
    double t = in_;
    for (int round = 0; round < kMostRounds; ++round) {
      const double before = std::abs(side.value);
      double next = side.slope != 0.0 ? t - side.value / side.slope : kNever;
      if (std::abs(next - t) < kLastStepMm && before < kNearMm)
        return {std::clamp(next, 0.0, in_), side.place};
      if (!worth_ || !(next > out_ && next < in_)) {
        if (!out_known_ && !lookAtStart()) return {0.0, start_place_};
        next = (f_out_ * in_ - f_in_ * out_) / (f_out_ - f_in_);
        if (round > kMostIllinois || !(next > out_ && next < in_)) next = 0.5 * (out_ + in_);
      }
      t = next;
      side = look(t);
      if (std::abs(side.value) < kZeroMm) break;
      worth_ = std::abs(side.value) < kWorth * before;
      narrow(t, side.value);
      if (out_known_ && in_ - out_ < kPointMm) break;
    }
    return {t, side.place};
  }

 private:
  static constexpr int kMostRounds = 100, kMostIllinois = 20;

  CurveSide look(double t) const {
    return curveSide(part_, {a_.x() + t * dx_, a_.y() + t * dy_, a_.z()}, dx_, dy_);
  }
  /// False where the start is inside within rounding.
  bool lookAtStart() {
    const CurveSide start = look(0.0);
    out_known_ = true;
    f_out_ = start.value;
    start_place_ = start.place;
    return start.value > 0.0;
  }
  void narrow(double t, double value) {
    if (value >= 0.0) {
      out_ = t, f_out_ = value, out_known_ = true;
      if (side_ == 1) f_in_ *= 0.5;
      side_ = 1;
    } else {
      in_ = t, f_in_ = value;
      if (side_ == -1) f_out_ *= 0.5;
      side_ = -1;
    }
  }

  const ColumnSweep& part_;
  const Vec3& a_;
  double dx_, dy_, in_, out_ = 0.0, f_in_ = 0.0, f_out_ = 0.0, start_place_ = 0.0;
  bool out_known_ = false, worth_ = true;
  int side_ = 0;
};

}  // namespace

EdgeCut SweptBody::curveCut(const Vec3& a, double dx, double dy, double inside) const {
  const auto cut = CurveRoot(columns_, a, dx, dy, inside).find();
  return {cut.at, startOf(cut.place)};
}

void SweptBody::cutEdges(EdgeCuts& cuts) const {
  columnKernels().cuts(columns_, cuts);
  for (int i = 0; i < cuts.count; ++i) {
    const bool found = cuts.found[i] > 0.0;
    cuts.start[i] = found ? startOf(cuts.place[i]) : -1.0;
    if (found || cuts.end[i] != 0.0) continue;
    const EdgeCut cut = curveCut({cuts.x[i], cuts.y[i], cuts.z[i]}, cuts.dx[i], cuts.dy[i], cuts.inside[i]);
    cuts.at[i] = cut.at, cuts.start[i] = cut.start;
  }
}

EdgeCut SweptBody::levelCut(const Vec3& a, double dx, double dy, double inside) const {
  const ColumnSweep& c = columns_;
  const ColumnSolid& tool = solid();
  if (isCurvePart()) return curveCut(a, dx, dy, inside);
  const Ray ray{a.x(), a.y(), dx, dy};
  if (c.kind == ColumnSweep::Kind::kLine && tool.flat) {
    double first, last;
    discStretch(c, a.z(), tool.z_min, tool.z_max, first, last);
    return {std::min(inside, enterStadium(c, ray, first, last, tool.radius))};
  }
  // The whole ball stands for its lower half where the flank above covers the rest.
  if (c.kind == ColumnSweep::Kind::kLine && tool.ball && !tool.round_top && tool.z_max >= 2.0 * tool.radius) {
    double first, last;
    discStretch(c, a.z(), tool.radius, tool.z_max, first, last);
    const double flank = enterStadium(c, ray, first, last, tool.radius);
    return {std::min({inside, flank, enterCapsule(c, ray, a.z(), tool.radius)})};
  }
  // What a level move sweeps is at each height what a disc sweeps there.
  if (c.kind == ColumnSweep::Kind::kLine && c.rise == 0.0) {
    const double radius = radiusAt(*profile_, a.z() - c.z);
    if (radius >= 0.0) return {std::min(inside, enterStadium(c, ray, 0.0, c.length, radius))};
  }
  if (c.kind == ColumnSweep::Kind::kVertical) {
    const double radius =
        radiusBetween(*profile_, a.z() - c.z - std::max(c.rise, 0.0), a.z() - c.z - std::min(c.rise, 0.0));
    if (radius >= 0.0) return {std::min(inside, enterDisc(ray, c.x, c.y, radius * radius))};
  }
  const Vec3 direction(dx, dy, 0.0);
  if (isLevelArc()) return {searchCut(*whole_, a, direction, inside)};
  return {searchCut(ownField(), a, direction, inside)};
}

}  // namespace proveout
