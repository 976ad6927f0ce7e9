#include "removal/sweep/kinds/pose_solid.h"

#include <algorithm>
#include <cmath>

namespace proveout {

double leastRadius(const ConvexProfile& profile) {
  double least = profile.maxRadius();
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.arc) {
      least = std::min(least, e.radius);
    } else if (e.dz != 0.0) {
      least = std::min({least, e.ar, e.br});
    }
  }
  return least;
}

double thinnestPart(const ConvexProfile& profile) {
  double least = profile.maxRadius();
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.arc || e.dz != 0.0) least = std::min({least, e.ar, e.br});
  }
  return least;
}

double posesApart(const ConvexProfile& profile) { return std::sqrt(8.0 * kPosesMm * leastRadius(profile)); }

/// Whether there is no edge between an element and the next.
static bool goesOnSmoothly(const ConvexProfile& profile, int i) {
  constexpr double kSmooth = 1e-9;
  if (i + 1 >= profile.elementCount()) return false;
  const auto normal = [&](const ConvexProfile::Element& e) {
    if (!e.arc) return Vec2(e.dz, -e.dr);
    const ConvexProfile::Element& one = profile.element(i);
    return Vec2(Vec2(one.br - e.cr, one.bz - e.cz) / e.radius);
  };
  return (normal(profile.element(i)) - normal(profile.element(i + 1))).norm() < kSmooth;
}

PoseSolid poseSolid(const ConvexProfile& profile) {
  PoseSolid solid;
  for (int i = 0; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.br > 0.0 && !goesOnSmoothly(profile, i)) solid.rim[solid.rims++] = {e.bz, e.br * e.br};
    if (!e.arc && e.dz == 0.0) continue;
    PoseSolid::Zone& zone = solid.zone[solid.zones++];
    zone.low = std::min(e.az, e.bz), zone.high = std::max(e.az, e.bz);
    zone.widest = std::max(e.ar, e.br);
    if (e.arc && e.cr != 0.0) {
      zone.corner = e.radius, zone.disc = e.cr, zone.height = e.cz;
      solid.corners = true;
    } else if (e.arc) {
      zone.alpha = e.radius * e.radius - e.cz * e.cz, zone.beta = 2.0 * e.cz, zone.gamma = -1.0;
    } else {
      const double k = e.dr / e.dz, at_tip = e.ar - k * e.az;
      zone.alpha = at_tip * at_tip, zone.beta = 2.0 * at_tip * k, zone.gamma = k * k, zone.widens = k > 0.0;
    }
  }
  return solid;
}

AxialView axialView(const PoseAt& a, const Vec3& way) {
  constexpr double kUpright = 1e-9, kStill = 1e-9;  // of the level part; mm
  /// The slack of bounds is more than what less than this does on any height that counts.
  constexpr double kLeast = 1e-9;
  const auto inverse = [](double v) { return 1.0 / (std::abs(v) > kLeast ? v : kLeast); };
  const Vec3 axis(a.ax, a.ay, a.az);
  const double level = axis.head<2>().norm();
  const Vec2 toward = level > kUpright ? Vec2(axis.head<2>() / level) : Vec2(1.0, 0.0);
  const Vec3 p(toward.x() * a.az, toward.y() * a.az, -level), q(-toward.y(), toward.x(), 0.0);
  const double way_p = way.dot(p), way_q = way.dot(q), way_h = way.dot(axis),
               length = std::sqrt(way_p * way_p + way_q * way_q);
  AxialView view;
  view.at = a, view.level = level;
  view.px = p.x(), view.py = p.y(), view.qx = q.x(), view.qy = q.y();
  view.low_p = std::min(0.0, way_p), view.high_p = std::max(0.0, way_p);
  view.low_q = std::min(0.0, way_q), view.high_q = std::max(0.0, way_q);
  view.low_h = std::min(0.0, way_h), view.high_h = std::max(0.0, way_h);
  const bool moves = length > kStill;
  view.up = moves ? way_p / length : 1.0, view.uq = moves ? way_q / length : 0.0;
  view.length = std::max(length, kStill);
  view.nx = q.x() * view.up - p.x() * view.uq, view.ny = q.y() * view.up - p.y() * view.uq;
  view.by_h = inverse(a.az), view.by_p = inverse(level), view.by_n = inverse(level * view.uq);
  return view;
}

}  // namespace proveout
