#include "removal/sweep/kinds/level_arc_body.h"

#include <cmath>

namespace proveout {

double LevelArcBody::mostDepth(double x, double y) const {
  const double qx = x - way.x, qy = y - way.y;
  return depthBeside(std::abs(std::sqrt(qx * qx + qy * qy) - way.arc_radius));
}

std::optional<double> LevelArcBody::simpleBend(const ConvexProfile::Element& e) const {
  if (e.arc) return std::nullopt;
  if (e.dz == 0.0) return 0.0;
  if (e.dr != 0.0) return std::nullopt;
  return wallBend(e.ar, std::abs(way.arc_radius - e.ar));
}

double LevelArcBody::turnRad() const {
  const double turn = std::atan2(way.sin_sweep, way.cos_sweep);
  return way.full ? 2.0 * kPi : turn < 0.0 ? turn + 2.0 * kPi : turn;
}

ToolPlace LevelArcBody::placeAt(double t) const {
  const double a = t * turnRad() * way.turn, dx = way.start_x - way.x, dy = way.start_y - way.y;
  const Vec2 out(dx * std::cos(a) - dy * std::sin(a), dx * std::sin(a) + dy * std::cos(a));
  return {Vec3(way.x + out.x(), way.y + out.y(), way.z), Vec2(-out.y(), out.x()) / way.arc_radius};
}

}  // namespace proveout
