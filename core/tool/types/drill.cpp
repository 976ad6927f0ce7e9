// Drills: a cylinder with a point.
#include <fmt/format.h>

#include <cmath>

#include "core/tool/types/rows.h"
#include "core/tool/types/shapes.h"

namespace proveout::tool_types {
namespace {

bool setDrill(Tool& tool, std::span<const double> n) {
  if (n.empty() || n.size() > 2) return false;
  tool.diameter = n[0];
  if (n.size() == 2) tool.point_angle_deg = n[1];
  return true;
}

void checkDrill(const Tool& tool, ToolCheck& check) {
  check.angle(tool.point_angle_deg, "the point angle");
  if (!check.good()) return;
  check.flutesCover(0.5 * tool.diameter / std::tan(degToRad(0.5 * tool.point_angle_deg)),
                    "the drill's point");
}

std::vector<ConvexProfile> drillCutter(const Tool& tool, double height) {
  const double radius = 0.5 * tool.diameter;
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.lineTo(radius, coneHeight(0.0, radius, tool.point_angle_deg));
  closeAt(p, radius, height);
  return {p};
}

std::string drillDetails(const Tool& tool) { return fmt::format(" {:g} deg", tool.point_angle_deg); }

}  // namespace

constinit const ToolTypeRow kDrill{
    .type = ToolType::kDrill,
    .name = "drill",
    .option = "drill:D:POINTANGLE",
    .set = setDrill,
    .check = checkDrill,
    .cutter = drillCutter,
    .details = drillDetails,
};

}  // namespace proveout::tool_types
