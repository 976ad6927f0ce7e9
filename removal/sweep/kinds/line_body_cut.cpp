#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/sweep/kinds/line_body.h"

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
double enterStadium(const LineSweep& line, const Ray& ray, double first, double last, double radius) {
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
void discStretch(const LineSweep& line, double z, double low, double high, double& first, double& last) {
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
double enterCapsule(const LineSweep& line, const Ray& ray, double z, double radius) {
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

EdgeCut LineBody::levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const {
  const ColumnSolid& tool = solid();
  const ConvexProfile& profile = *of.profile;
  const Ray ray{a.x(), a.y(), dx, dy};
  if (way.length > 0.0 && tool.flat) {
    double first, last;
    discStretch(way, a.z(), tool.z_min, tool.z_max, first, last);
    return {std::min(inside, enterStadium(way, ray, first, last, tool.radius))};
  }
  if (tool.sphere && sweepWay(way).squaredNorm() > 0.0)
    return {std::min(inside, enterCapsule(way, ray, a.z(), tool.radius))};
  // The whole ball stands for its lower half where the flank above covers the rest.
  if (way.length > 0.0 && tool.ball && !tool.round_top && tool.z_max >= 2.0 * tool.radius) {
    double first, last;
    discStretch(way, a.z(), tool.radius, tool.z_max, first, last);
    const double flank = enterStadium(way, ray, first, last, tool.radius);
    return {std::min({inside, flank, enterCapsule(way, ray, a.z(), tool.radius)})};
  }
  // What a level move sweeps is at each height what a disc sweeps there.
  if (way.length > 0.0 && way.rise == 0.0) {
    const double radius = radiusAt(profile, a.z() - way.z);
    if (radius >= 0.0) return {std::min(inside, enterStadium(way, ray, 0.0, way.length, radius))};
  }
  if (way.length == 0.0) {
    const double radius = radiusBetween(profile, a.z() - way.z - std::max(way.rise, 0.0),
                                        a.z() - way.z - std::min(way.rise, 0.0));
    if (radius >= 0.0) return {std::min(inside, enterDisc(ray, way.x, way.y, radius * radius))};
  }
  return {searchCut(LineBody::field(of), a, Vec3(dx, dy, 0.0), inside)};
}

}  // namespace proveout
