#include "tests/property/accuracy_cases.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "tests/support/feed_motion.h"
#include "tests/support/golden_section.h"

namespace proveout::accuracy {

namespace {

using test::feedMotion;
using test::leastAt;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Neither its faces nor its corner are on the grid's lines in a simple way.
constexpr double kFlat = 1e-3;  ///< closer to a flat face than this is on it
const BoxShape kBlank{{-0.037, 0.061, -9.983}, {30.017, 24.949, 0.0}};

/// Distance of a point to the convex corner region {x <= 0, y <= 0}, signed.
double corner(double x, double y) {
  if (x > 0 && y > 0) return std::hypot(x, y);
  return std::max(x, y);
}

double simpson(const std::function<double(double)>& f, double a, double fa, double m, double fm, double b,
               double fb, double whole, double tolerance, int depth) {
  const double l = 0.5 * (a + m), r = 0.5 * (m + b), fl = f(l), fr = f(r);
  const double left = (m - a) / 6 * (fa + 4 * fl + fm), right = (b - m) / 6 * (fm + 4 * fr + fb);
  if (depth == 0 || std::abs(left + right - whole) < 15 * tolerance)
    return left + right + (left + right - whole) / 15;
  return simpson(f, a, fa, l, fl, m, fm, left, tolerance / 2, depth - 1) +
         simpson(f, m, fm, r, fr, b, fb, right, tolerance / 2, depth - 1);
}

}  // namespace

Toolpath linePath(const std::vector<Vec3>& points) {
  Toolpath path;
  path.files = {"accuracy"};
  for (std::size_t i = 1; i < points.size(); ++i) {
    path.motions.push_back(feedMotion(points[i - 1], points[i]));
  }
  return path;
}

namespace {

Vec3 at(const Vec2& p, double z) { return {p.x(), p.y(), z}; }

/// A full turn, or several with `rise` in all, about a vertical axis.
void addTurns(Toolpath& path, const Vec3& from, const Vec2& center, double turns, double rise) {
  ArcGeometry arc;
  arc.center = at(center, from.z());
  arc.sweep_rad = 2 * kPi * turns;
  const Vec3 end = arc.center + Eigen::AngleAxisd(arc.sweep_rad, Vec3::UnitZ()) * (from - arc.center);
  Motion m = feedMotion(from, end + Vec3(0, 0, rise));
  m.arc = static_cast<std::int32_t>(path.arcs.size());
  path.arcs.push_back(arc);
  path.motions.push_back(m);
}

Vec2 direction(double degrees) { return {std::cos(degToRad(degrees)), std::sin(degToRad(degrees))}; }

}  // namespace

double integrate(const std::function<double(double)>& f, double a, double b,
                 const std::vector<double>& breaks, double scale) {
  std::vector<double> ends = {a, b};
  for (const double x : breaks) {
    if (x > a && x < b) ends.push_back(x);
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double l = ends[i - 1], r = ends[i], m = 0.5 * (l + r), fl = f(l), fm = f(m), fr = f(r);
    sum += simpson(f, l, fl, m, fm, r, fr, (r - l) / 6 * (fl + 4 * fm + fr), 1e-10 * scale, 22);
  }
  return sum;
}

double Outline::radiusAt(double z) const {
  if (lower(radius) <= z) return radius;
  double in = 0.0, out = radius;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (in + out);
    (lower(middle) <= z ? in : out) = middle;
  }
  return in;
}

Outline flatOutline(double diameter) {
  const double R = diameter / 2;
  return {R,
          [](double) { return 0.0; },
          [R](double r, double z) { return corner(r - R, -z); },
          {{R, 0}},
          kInfinity};
}

Outline bullOutline(double diameter, double c) {
  const double R = diameter / 2, flat = R - c;
  return {R,
          [=](double r) {
            const double over = std::max(0.0, r - flat);
            return c - std::sqrt(std::max(0.0, c * c - over * over));
          },
          [=](double r, double z) { return corner(r - flat, c - z) - c; },
          {},
          c};
}

Outline ballOutline(double diameter) { return bullOutline(diameter, diameter / 2); }

Outline coneOutline(double diameter, double tip, double angle_deg) {
  const double R = diameter / 2, t = tip / 2, half = degToRad(angle_deg / 2), top = (R - t) / std::tan(half);
  std::vector<Vec2> edges = {{R, top}};
  if (t > 0) edges.push_back({t, 0});
  return {R, [=](double r) { return std::max(0.0, r - t) / std::tan(half); },
          [=](double r, double z) {
            const double flank = (r - t) * std::cos(half) - z * std::sin(half);
            return std::max({flank, r - R, t > 0 ? -z : -kInfinity});
          },
          edges, kInfinity};
}

Outline drillOutline(double diameter, double angle_deg) { return coneOutline(diameter, 0.0, angle_deg); }

Outline taperOutline(double ball_diameter, double side_deg, double diameter) {
  const double b = ball_diameter / 2, side = degToRad(side_deg), R = diameter / 2;
  const double touch = b * std::cos(side), z = b * (1 - std::sin(side)),
               top = z + (R - touch) / std::tan(side);
  return {
      R,
      [=](double r) { return r < touch ? b - std::sqrt(b * b - r * r) : z + (r - touch) / std::tan(side); },
      [=](double r, double h) {
        const double flank = (r - touch) * std::cos(side) - (h - z) * std::sin(side);
        const bool low = (h - b) * std::cos(side) + r * std::sin(side) < 0;
        return std::max(low ? std::hypot(r, h - b) - b : flank, r - R);
      },
      {{R, top}, {touch, z}},
      b};
}

Curve pointCurve(const Vec2& p) {
  return {[p](const Vec2& x) { return (x - p).norm(); }, [](double q) { return kPi * q * q; },
          [p](double q, int n) {
            std::vector<Vec2> points;
            for (int i = 0; i < n; ++i) points.push_back(p + q * direction(360.0 * i / n));
            return points;
          },
          [p](const Vec2& x) { return (x - p).norm(); }};
}

Curve segmentCurve(const Vec2& a, const Vec2& b) {
  const Vec2 along = (b - a).normalized(), across(-along.y(), along.x());
  const double length = (b - a).norm();
  const auto contour = [=](double q, int n) {
    const double round = kPi * q, all = 2 * (length + round);
    std::vector<Vec2> points;
    for (int i = 0; i < n; ++i) {
      double s = all * i / n;
      const bool back = s >= all / 2;
      if (back) s -= all / 2;
      const double turn = s < length ? 0.0 : (s - length) / q;
      const Vec2 local(std::min(s, length) + q * std::sin(turn), -q * std::cos(turn));
      points.push_back(back ? Vec2(b - local.x() * along - local.y() * across)
                            : Vec2(a + local.x() * along + local.y() * across));
    }
    return points;
  };
  return {[=](const Vec2& x) {
            const double s = std::clamp((x - a).dot(along), 0.0, length);
            return (x - a - s * along).norm();
          },
          [length](double q) { return kPi * q * q + 2 * q * length; }, contour,
          [=](const Vec2& x) {
            const double s = (x - a).dot(along);
            return s > 0 && s < length ? kInfinity : (x - (s > 0 ? b : a)).norm();
          }};
}

Curve circleCurve(const Vec2& center, double radius) {
  return {[=](const Vec2& x) { return std::abs((x - center).norm() - radius); },
          [radius](double q) { return 4 * kPi * radius * q; },
          [=](double q, int n) {
            std::vector<Vec2> points;
            for (int i = 0; i < n; ++i)
              points.push_back(center + (radius + (i % 2 ? q : -q)) * direction(360.0 * i / n));
            return points;
          },
          [center](const Vec2& x) { return (x - center).norm(); }};
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Case levelCase(const std::string& name, const std::string& tool, const Outline& outline, const Curve& curve,
               Toolpath path, double z) {
  Case c;
  c.name = name, c.tool = tool, c.blank = kBlank, c.path = std::move(path);
  std::vector<double> breaks = {0.0};
  for (const Vec2& edge : outline.edges) breaks.push_back(edge.y());
  if (std::isfinite(outline.curvature_radius)) breaks.push_back(outline.curvature_radius);
  // Heights go with the square of a parameter, as round outlines begin with a vertical tangent.
  const auto slice = [&](double u) { return 2 * u * curve.area_within(outline.radiusAt(u * u)); };
  for (double& x : breaks) x = std::sqrt(x);
  c.removed_mm3 = integrate(slice, 0, std::sqrt(-z), breaks, 1.0);
  c.removed = [=](const Vec3& p) { return outline.distance(curve.distance(p.head<2>()), p.z() - z); };
  std::vector<Vec2> edges = {{outline.radiusAt(-z), 0.0}};
  for (const Vec2& edge : outline.edges) {
    if (edge.y() < -z) edges.push_back({edge.x(), z + edge.y()});
  }
  for (const Vec2& edge : edges) {
    for (const Vec2& p : curve.contour(edge.x(), 157)) c.edge_points.push_back(at(p, edge.y()));
  }
  if (outline.lower(1e-9) > 0) edges.push_back({0.0, z});  // a point
  c.edge_distance = [=](const Vec3& p) {
    double least = kInfinity;
    for (const Vec2& e : edges)
      least = std::min(least, std::hypot(curve.distance(p.head<2>()) - e.x(), p.z() - e.y()));
    return least;
  };
  c.curvature_radius = [=](const Vec3& p) {
    const double q = curve.distance(p.head<2>());
    const bool floor = std::abs(p.z() - z) < kFlat && q < outline.radius && outline.lower(q) == 0.0;
    if (floor || std::abs(p.z()) < kFlat) return kInfinity;
    return std::min(outline.curvature_radius, curve.contour_radius(p.head<2>()));
  };
  return c;
}

namespace {

/// The removed solid of a slanted line, in a frame along it: u along the line seen from above, v across.
class SlantedSlot {
 public:
  SlantedSlot(Outline outline, const Vec3& from, const Vec3& to)
      : outline_(std::move(outline)),
        from_(from),
        along_((to - from).head<2>().normalized()),
        length_((to - from).head<2>().norm()),
        slope_((to.z() - from.z()) / length_) {}

  /// The least over the positions of the tool says too little inside the track of a rim, where each position
  /// has it at a corner: the slope there makes up for it. Not needed below what any test asks.
  double distance(const Vec3& p) const {
    constexpr double kStep = 1e-5;
    const double least = nearest(p).distance;
    if (std::abs(least) < 5e-4) return least;
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = kStep * Vec3::Unit(axis);
      slope[axis] = (nearest(p + step).distance - nearest(p - step).distance) / (2 * kStep);
    }
    return least / std::clamp(slope.norm(), 0.5, 1.0);
  }

  /// Points of the edges between the flat end, or the point, of the tool and what it leaves.
  std::vector<Vec3> edgePoints() const {
    constexpr int kPoints = 120;
    std::vector<Vec3> points;
    for (const Vec2& e : outline_.edges) {
      if (e.y() > 0) continue;
      for (int i = 0; i < kPoints; ++i) {
        const Vec2 turn = direction(360.0 * i / kPoints);
        points.push_back(to() + at(e.x() * turn, 0.0));
        if (turn.dot(along_) < -0.5) points.push_back(from_ + at(e.x() * turn, 0.0));
      }
    }
    if (hasPoint()) {
      for (int i = 0; i <= kPoints; ++i) points.push_back(from_ + (to() - from_) * i / kPoints);
    }
    return points;
  }

  /// Sharp are the rims where the tool starts and ends, the track of a point, and what is close to the top.
  double edgeDistance(const Vec3& p) const {
    double least = std::abs(p.z());
    for (const Vec3& end : {from_, to()}) {
      for (const Vec2& e : outline_.edges) {
        const double off = (p - end).head<2>().norm() - e.x();
        least = std::min(least, std::hypot(off, p.z() - end.z() - e.y()));
      }
    }
    if (!hasPoint()) return least;
    const Vec3 track = to() - from_;
    const double s = std::clamp((p - from_).dot(track) / track.squaredNorm(), 0.0, 1.0);
    return std::min(least, (p - from_ - s * track).norm());
  }

  /// A round outline keeps its radius when it is swept, and a rim makes an elliptic cylinder.
  double curvatureRadius(const Vec3& p) const {
    if (std::abs(p.z()) < kFlat) return kInfinity;
    const Nearest at = nearest(p);
    const bool inside = at.t > 1e-6 && at.t < length_ - 1e-6;
    if (!inside) {
      const double z = p.z() - from_.z() - slope_ * at.t;
      const bool floor = std::abs(z) < kFlat && outline_.lower(at.r) == 0.0;
      return floor ? kInfinity : std::min(outline_.curvature_radius, at.r);
    }
    double least = outline_.curvature_radius;
    for (const Vec2& e : outline_.edges) {
      if (std::abs(at.v) >= e.x()) continue;
      const double a = e.x(), b = a * std::sin(std::atan(std::abs(slope_))), c = at.v / a;
      least = std::min(least, std::pow(a * a * (1 - c * c) + b * b * c * c, 1.5) / (a * b));
    }
    return least;
  }

  double volume() const {
    const double R = outline_.radius;
    // v = R sin(angle) takes the vertical tangent out of the ends.
    const auto across = [&](double angle) {
      return R * std::cos(angle) * section(R * std::sin(angle), R * std::cos(angle));
    };
    std::vector<double> breaks;
    for (const double r : breakRadii()) breaks.push_back(std::asin(std::min(1.0, r / R)));
    return 2 * integrate(across, 0, kPi / 2, breaks, 1e3);
  }

 private:
  struct Nearest {
    double distance, t, v, r;  ///< of the tool at t along the line; v across it, r from its axis
  };
  Nearest nearest(const Vec3& p) const {
    const Vec2 d = p.head<2>() - from_.head<2>();
    const double u = d.dot(along_), v = along_.x() * d.y() - along_.y() * d.x(), z = p.z() - from_.z();
    const auto at = [&](double t) { return outline_.distance(std::hypot(u - t, v), z - slope_ * t); };
    const double t = leastAt(at, 0.0, length_);
    return {at(t), t, v, std::hypot(u - t, v)};
  }
  bool hasPoint() const { return !outline_.edges.empty() && outline_.lower(1e-9) > 0.0; }
  Vec3 to() const { return from_ + Vec3(along_.x() * length_, along_.y() * length_, slope_ * length_); }

  /// Radii at which the section changes its kind.
  std::vector<double> breakRadii() const {
    std::vector<double> radii = {outline_.radius - outline_.curvature_radius};
    for (const Vec2& e : outline_.edges) radii.push_back(e.x());
    for (const double z : {from_.z(), from_.z() + slope_ * length_}) radii.push_back(outline_.radiusAt(-z));
    std::erase_if(radii, [&](double r) { return !(r > 0 && r < outline_.radius); });
    return radii;
  }

  /// Area between floor and top in the plane at v; half: half width of the tool there.
  double section(double v, double half) const {
    const auto height = [&](double w) {
      return slope_ * -w + outline_.lower(std::min(outline_.radius, std::hypot(w, v)));
    };
    const double lowest = leastAt(height, -half, half);
    const auto depth = [&](double u) {
      const double least = std::max(-half, u - length_);  // at both ends the stretch is a point, to rounding
      const double w = std::clamp(lowest, least, std::max(least, std::min(half, u)));
      return std::max(0.0, -(from_.z() + slope_ * u + height(w)));
    };
    std::vector<double> breaks = {lowest, lowest + length_};
    for (const Vec2& e : outline_.edges) {
      if (e.x() <= std::abs(v)) continue;
      const double w = std::sqrt(e.x() * e.x() - v * v);
      for (const double x : {-w, w, length_ - w, length_ + w}) breaks.push_back(x);
    }
    addSurfacePoints(depth, -half, length_ + half, breaks);
    return integrate(depth, -half, length_ + half, breaks, 1.0);
  }

  /// Where the floor comes up to the top: between zero and more, on either side of the deepest place.
  static void addSurfacePoints(const std::function<double(double)>& depth, double a, double b,
                               std::vector<double>& breaks) {
    const double middle = std::clamp(breaks[1], a, b);
    for (double end : {a, b}) {
      if (depth(end) > 0 || depth(middle) <= 0) continue;
      double in = middle;
      for (int i = 0; i < 60; ++i) {
        const double half_way = 0.5 * (in + end);
        (depth(half_way) > 0 ? in : end) = half_way;
      }
      breaks.push_back(in);
    }
  }

  Outline outline_;
  Vec3 from_;
  Vec2 along_;
  double length_, slope_;
};

}  // namespace

Case slantedCase(const std::string& name, const std::string& tool, const Outline& outline, const Vec3& from,
                 const Vec3& to) {
  Case c;
  c.name = name, c.tool = tool, c.blank = kBlank, c.path = linePath({from, to});
  const SlantedSlot slot(outline, from, to);
  c.removed_mm3 = slot.volume();
  c.removed = [slot](const Vec3& p) { return slot.distance(p); };
  c.edge_points = slot.edgePoints();
  c.edge_distance = [slot](const Vec3& p) { return slot.edgeDistance(p); };
  c.curvature_radius = [slot](const Vec3& p) { return slot.curvatureRadius(p); };
  return c;
}

namespace {

Case pocketCase() {
  const double turn = 17.3, R = 3.0, z = -3.137, a = 12.4, b = 7.6;  // of the tip's rectangle
  const Vec2 x = direction(turn), y(-x.y(), x.x()), center(15.113, 12.471);
  const auto tip = [&](double u, double v) { return at(center + u * x + v * y, z); };
  std::vector<Vec3> points = {tip(-a / 2, -b / 2), tip(a / 2, -b / 2), tip(a / 2, b / 2), tip(-a / 2, b / 2),
                              tip(-a / 2, -b / 2)};
  for (int i = 1; i <= 3; ++i) {
    const double v = -b / 2 + b * i / 4;
    points.push_back(tip(i % 2 ? -a / 2 : a / 2, v));
    points.push_back(tip(i % 2 ? a / 2 : -a / 2, v));
  }
  Curve area;  // the distance to a filled rectangle: 0 inside
  area.distance = [=](const Vec2& p) {
    const Vec2 d = p - center;
    return std::hypot(std::max(0.0, std::abs(d.dot(x)) - a / 2), std::max(0.0, std::abs(d.dot(y)) - b / 2));
  };
  area.area_within = [=](double q) { return kPi * q * q + 2 * q * (a + b) + a * b; };
  area.contour_radius = [=, distance = area.distance](const Vec2& p) {
    const Vec2 d = p - center;
    const bool beside = std::abs(d.dot(x)) < a / 2 || std::abs(d.dot(y)) < b / 2;
    return beside ? kInfinity : distance(p);
  };
  area.contour = [=](double q, int n) {
    std::vector<Vec2> all;
    for (int i = 0; i < n; ++i) {
      const Vec2 d = direction(360.0 * i / n);
      const Vec2 corner_point(std::copysign(a / 2, d.x()), std::copysign(b / 2, d.y()));
      const Vec2 local = corner_point + q * d;
      all.push_back(center + local.x() * x + local.y() * y);
      all.push_back(center + a * (static_cast<double>(i) / n - 0.5) * x + (b / 2 + q) * y);
    }
    return all;
  };
  return levelCase("PocketTurned", "1=flat:6", flatOutline(2 * R), area, linePath(points), z);
}

Case crossingSlots() {
  const double R = 2.5, z1 = -2.213, z2 = -4.371, angle = 63.7, length = 16.0;
  const Vec2 center(15.071, 12.527), d1 = direction(11.9), d2 = direction(11.9 + angle);
  const auto end = [&](const Vec2& d, double s) { return Vec2(center + s * length / 2 * d); };
  const Curve first = segmentCurve(end(d1, -1), end(d1, 1)), second = segmentCurve(end(d2, -1), end(d2, 1));
  Case a = levelCase("", "1=flat:5", flatOutline(2 * R), first, {}, z1);
  const Case b = levelCase("", "1=flat:5", flatOutline(2 * R), second, {}, z2);
  Case c = a;
  c.name = "CrossingSlots";
  c.path = linePath({at(end(d1, -1), z1), at(end(d1, 1), z1)});
  c.path.motions.push_back(feedMotion(at(end(d2, -1), z2), at(end(d2, 1), z2)));
  c.removed_mm3 = a.removed_mm3 + b.removed_mm3 + 4 * R * R / std::sin(degToRad(angle)) * z1;
  c.removed = [a, b](const Vec3& p) { return std::min(a.removed(p), b.removed(p)); };
  // The walls of one slot end in the other.
  c.edge_distance = [a, b](const Vec3& p) {
    return std::min({a.edge_distance(p), b.edge_distance(p), std::hypot(a.removed(p), b.removed(p))});
  };
  c.curvature_radius = [a, b](const Vec3& p) {
    return a.removed(p) < b.removed(p) ? a.curvature_radius(p) : b.curvature_radius(p);
  };
  std::erase_if(c.edge_points, [&](const Vec3& p) { return b.removed(p) < 1e-3; });
  for (const Vec3& p : b.edge_points) {
    if (a.removed(p) > 1e-3) c.edge_points.push_back(p);
  }
  return c;
}

/// A helix that opens a bore wider than the tool, and a turn at its bottom.
Case helicalBore() {
  const double orbit = 2.317, R = 3.0, z = -6.183;
  const Vec2 center(14.917, 12.633);
  Toolpath path = linePath({at(center + Vec2(orbit, 0), 2.0), at(center + Vec2(orbit, 0), 0.5)});
  addTurns(path, at(center + Vec2(orbit, 0), 0.5), center, 4.0, z - 0.5);
  addTurns(path, at(center + Vec2(orbit, 0), z), center, 1.0, 0.0);
  return levelCase("HelicalBore", "1=flat:6", flatOutline(2 * (orbit + R)), pointCurve(center), path, z);
}

}  // namespace

std::vector<Case> allCases() {
  struct Cutter {
    std::string name, option;
    Outline outline;
  };
  const std::vector<Cutter> cutters = {{"Flat", "1=flat:6", flatOutline(6)},
                                       {"Ball", "1=ball:6", ballOutline(6)},
                                       {"Bull", "1=bull:6:1.5", bullOutline(6, 1.5)},
                                       {"Cone", "1=cone:10:2:60", coneOutline(10, 2, 60)},
                                       {"Drill", "1=drill:6:118", drillOutline(6, 118)}};
  const Vec2 center(14.953, 12.421), along = direction(23.7);
  const double z = -4.117;
  std::vector<Case> cases = {pocketCase(), crossingSlots(), helicalBore()};
  for (const Cutter& c : cutters) {
    cases.push_back(levelCase("Plunge" + c.name, c.option, c.outline, pointCurve(center),
                              linePath({at(center, 3.0), at(center, z)}), z));
    const Vec2 from = center - 7.3 * along, to = center + 7.9 * along;
    cases.push_back(levelCase("Slot" + c.name, c.option, c.outline, segmentCurve(from, to),
                              linePath({at(from, z), at(to, z)}), z));
    Toolpath ring;
    ring.files = {"accuracy"};
    addTurns(ring, at(center + 7.177 * along, z), center, 1.0, 0.0);
    cases.push_back(levelCase("Ring" + c.name, c.option, c.outline, circleCurve(center, 7.177), ring, z));
    cases.push_back(slantedCase("Slanted" + c.name, c.option, c.outline, at(from, -0.713), at(to, -5.871)));
  }
  return cases;
}

}  // namespace proveout::accuracy
