#include "core/tool/tool_solid.h"

#include "core/base/assert.h"
#include "core/tool/tool_type.h"

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

void addCylinder(std::vector<ConvexProfile>& parts, double low, double high, double radius) {
  if (high > low) parts.push_back(frustum(low, radius, high, radius));
}

/// Neck and shank; without overall_length the neck goes on without limit.
void addShank(const Tool& tool, std::vector<ConvexProfile>& parts) {
  const double top = cutterTop(tool);
  double neck = 0.5 * tool.neck_diameter, shank = 0.5 * tool.shank_diameter;
  const auto own_neck = rowOf(tool.type).neck_radius;
  if (own_neck != nullptr && neck == 0.0) neck = own_neck(tool);
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
  const auto cutter = rowOf(tool.type).cutter;
  PROVEOUT_ASSERT(cutter != nullptr);
  ToolSolid solid;
  solid.cutter = cutter(tool, cutterTop(tool));
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
