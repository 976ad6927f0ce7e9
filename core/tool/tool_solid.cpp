#include "core/tool/tool_solid.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

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

/// Up a flank at half the included angle to the tool's full radius, or to where the flutes end before that.
void closeCone(ConvexProfile& p, double r, double z, const Tool& tool, double flute_end) {
  const double radius = 0.5 * tool.diameter, height = coneHeight(r, radius, tool.cone_angle_deg);
  if (z + height >= flute_end) {
    const double share = height > 0.0 ? (flute_end - z) / height : 1.0;
    return closeProfile(p, r + (radius - r) * share, flute_end);
  }
  p.lineTo(radius, z + height);
  closeProfile(p, radius, flute_end);
}

void taperBall(ConvexProfile& p, const Tool& tool, double flute_end) {
  const double ball = 0.5 * tool.tip_diameter, side = degToRad(0.5 * tool.cone_angle_deg);
  const double r = ball * std::cos(side),
               z = ball * (1.0 - std::sin(side));  // where the flank touches the ball
  p.arcTo(0.0, ball, r, z);
  closeCone(p, r, z, tool, flute_end);
}

/// The rounded corner lies inside the diameter; the flank touches it.
void dovetail(ConvexProfile& p, const Tool& tool) {
  const double c = tool.corner_radius, angle = degToRad(tool.dovetail_angle_deg);
  const double center = 0.5 * tool.diameter - c;
  const double r = center + c * std::sin(angle), z = c * (1.0 + std::cos(angle));
  p.lineTo(center, 0.0);
  if (c > 0.0) p.arcTo(center, c, r, z);
  closeProfile(p, r - (tool.cutter_height - z) / std::tan(angle), tool.cutter_height);
}

void tSlot(ConvexProfile& p, const Tool& tool) {
  const double c = tool.corner_radius, radius = 0.5 * tool.diameter, top = tool.cutter_height;
  p.lineTo(radius - c, 0.0);
  if (c > 0.0) p.arcTo(radius - c, c, radius, c);
  p.lineTo(radius, std::max(c, top - c));
  if (c > 0.0) p.arcTo(radius - c, std::max(c, top - c), radius - c, top);
  p.lineTo(0.0, top);
}

ConvexProfile cutterProfile(const Tool& tool, double top) {
  const double radius = 0.5 * tool.diameter, corner = tool.corner_radius;
  ConvexProfile p;
  p.start(0.0, 0.0);
  switch (tool.type) {
    case ToolType::kBall:
      p.arcTo(0.0, radius, radius, radius);
      break;
    case ToolType::kBull:
      p.lineTo(radius - corner, 0.0);
      if (corner > 0.0) p.arcTo(radius - corner, corner, radius, corner);
      break;
    case ToolType::kCone:
      p.lineTo(0.5 * tool.tip_diameter, 0.0);
      closeCone(p, 0.5 * tool.tip_diameter, 0.0, tool, top);
      return p;
    case ToolType::kDrill:
      p.lineTo(radius, coneHeight(0.0, radius, tool.point_angle_deg));
      break;
    case ToolType::kTaperBall:
      taperBall(p, tool, top);
      return p;
    case ToolType::kDovetail:
      dovetail(p, tool);
      return p;
    case ToolType::kTSlot:
      tSlot(p, tool);
      return p;
    case ToolType::kLollipop:
      p.arcTo(0.0, radius, 0.5 * tool.neck_diameter, top);
      p.lineTo(0.0, top);
      return p;
    case ToolType::kFlat:
      p.lineTo(radius, 0.0);
      break;
    case ToolType::kThreadMill:  // outlines of several parts: see cutterParts
    case ToolType::kForm:
    case ToolType::kInsert:  // no solid of revolution: see makeToolSolid
      break;
  }
  closeProfile(p, radius, top);
  return p;
}

std::vector<ConvexProfile> cutterParts(const Tool& tool) {
  const bool threads = tool.type == ToolType::kThreadMill;
  if (!threads && tool.type != ToolType::kForm) return {cutterProfile(tool, cutterTop(tool))};
  const auto edges = outlineEdges(threads ? threadOutline(tool) : tool.outline);
  PROVEOUT_ASSERT(edges.ok());  // validateTool has seen them
  return convexParts(*edges);
}

void addCylinder(std::vector<ConvexProfile>& parts, double low, double high, double radius) {
  if (high > low) parts.push_back(frustum(low, radius, high, radius));
}

/// Neck and shank; without overall_length the neck goes on without limit.
void addShank(const Tool& tool, std::vector<ConvexProfile>& parts) {
  const double top = cutterTop(tool);
  double neck = 0.5 * tool.neck_diameter, shank = 0.5 * tool.shank_diameter;
  if (tool.type == ToolType::kThreadMill && neck == 0.0) neck = 0.5 * rootDiameter(tool);
  if (tool.type == ToolType::kForm && neck == 0.0) neck = shank > 0.0 ? shank : tool.outline.back().r;
  if (neck > 0.0) {
    double end = tool.overall_length > 0.0 ? tool.overall_length : kUnlimitedFluteMm;
    if (tool.neck_length > 0.0) end = tool.neck_length;
    addCylinder(parts, top, end, neck);
    if (tool.neck_length > 0.0) addCylinder(parts, end, tool.overall_length, shank);
    return;
  }
  if (shank == 0.0) shank = 0.5 * tool.diameter;
  addCylinder(parts, top, tool.overall_length, shank);
}

}  // namespace

ToolSolid makeToolSolid(const Tool& tool) {
  PROVEOUT_ASSERT(tool.type != ToolType::kInsert);
  ToolSolid solid;
  solid.cutter = cutterParts(tool);
  addShank(tool, solid.shank);
  for (std::size_t i = 1; i < tool.holder.size(); ++i) {
    const Vec2& a = tool.holder[i - 1];
    const Vec2& b = tool.holder[i];
    if (b.x() > a.x()) {  // a step outwards at one height has no volume of its own
      solid.holder.push_back(frustum(tool.overall_length + a.x(), a.y(), tool.overall_length + b.x(), b.y()));
    }
  }
  return solid;
}

Box3 boundsOf(const ToolSolid& solid) {
  Box3 box;
  for (const auto* parts : {&solid.cutter, &solid.shank, &solid.holder}) {
    for (const ConvexProfile& part : *parts) {
      const double r = part.maxRadius();
      box.extend(Vec3(-r, -r, part.zMin()));
      box.extend(Vec3(r, r, part.zMax()));
    }
  }
  return box;
}

}  // namespace proveout
