#include "core/tool/tool_solid.h"

#include <cmath>

namespace proveout {

namespace {

ConvexProfile frustum(double z0, double r0, double z1, double r1) {
  ConvexProfile p;
  p.start(0.0, z0);
  p.lineTo(r0, z0);
  p.lineTo(r1, z1);
  p.lineTo(0.0, z1);
  return p;
}

/// Ends a profile that has reached (radius, z): up the flank to the end of the flutes and back to the axis.
void closeProfile(ConvexProfile& p, double radius, double flute_end) {
  p.lineTo(radius, flute_end);
  p.lineTo(0.0, flute_end);
}

/// Height at which a point of the given included angle reaches `radius` from `tip_radius`.
double coneHeight(double tip_radius, double radius, double included_deg) {
  return (radius - tip_radius) / std::tan(degToRad(0.5 * included_deg));
}

ConvexProfile cutterProfile(const Tool& tool, double flute_end) {
  const double radius = 0.5 * tool.diameter;
  ConvexProfile p;
  p.start(0.0, 0.0);
  switch (tool.type) {
    case ToolType::kFlat:
      p.lineTo(radius, 0.0);
      break;
    case ToolType::kBall:
      p.arcTo(0.0, radius, radius, radius);
      break;
    case ToolType::kBull:
      p.lineTo(radius - tool.corner_radius, 0.0);
      if (tool.corner_radius > 0.0) {
        p.arcTo(radius - tool.corner_radius, tool.corner_radius, radius, tool.corner_radius);
      }
      break;
    case ToolType::kCone: {
      const double tip = 0.5 * tool.tip_diameter;
      p.lineTo(tip, 0.0);
      const double height = coneHeight(tip, radius, tool.cone_angle_deg);
      if (height >= flute_end) {  // the flutes end on the cone
        const double reached = tip + (radius - tip) * flute_end / height;
        closeProfile(p, reached, flute_end);
        return p;
      }
      p.lineTo(radius, height);
      break;
    }
    case ToolType::kDrill:
      p.lineTo(radius, coneHeight(0.0, radius, tool.point_angle_deg));
      break;
  }
  closeProfile(p, radius, flute_end);
  return p;
}

}  // namespace

ToolSolid makeToolSolid(const Tool& tool) {
  ToolSolid solid;
  double flute_end = tool.flute_length;
  if (flute_end <= 0.0) flute_end = tool.overall_length > 0.0 ? tool.overall_length : kUnlimitedFluteMm;
  solid.cutter.push_back(cutterProfile(tool, flute_end));
  if (tool.overall_length > flute_end) {
    const double radius = 0.5 * (tool.shank_diameter > 0.0 ? tool.shank_diameter : tool.diameter);
    solid.shank.push_back(frustum(flute_end, radius, tool.overall_length, radius));
  }
  for (std::size_t i = 1; i < tool.holder.size(); ++i) {
    const Vec2& a = tool.holder[i - 1];
    const Vec2& b = tool.holder[i];
    if (b.x() > a.x()) {  // a step outwards at one height has no volume of its own
      solid.holder.push_back(frustum(tool.overall_length + a.x(), a.y(), tool.overall_length + b.x(), b.y()));
    }
  }
  return solid;
}

}  // namespace proveout
