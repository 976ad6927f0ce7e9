// Dovetail cutters: widest at the bottom, the flank leans inwards.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/tool/types/rows.h"
#include "core/tool/types/shapes.h"

namespace proveout::tool_types {
namespace {

bool setDovetail(Tool& tool, std::span<const double> n) {
  if (n.size() != 4) return false;
  tool.diameter = n[0];
  tool.dovetail_angle_deg = n[1];
  tool.cutter_height = n[2];
  tool.neck_diameter = n[3];
  return true;
}

void checkDovetail(const Tool& tool, ToolCheck& check) {
  check.angle(tool.dovetail_angle_deg, "dovetail_angle", 90.0);
  check.positive(tool.cutter_height, "height");
  if (!check.good()) return;
  const double angle = degToRad(tool.dovetail_angle_deg), c = tool.corner_radius;
  check.require(c * (1.0 + std::cos(angle)) <= tool.cutter_height,
                "corner_radius does not fit into the height");
  const double top = 0.5 * tool.diameter - c * (1.0 - std::sin(angle)) -
                     (tool.cutter_height - c * (1.0 + std::cos(angle))) / std::tan(angle);
  check.require(
      tool.neck_diameter <= 2.0 * top,
      fmt::format("neck_diameter must be at most {:.6g} mm: what the flank leaves at the top of the cutter",
                  std::max(0.0, 2.0 * top)));
}

double dovetailHeight(const Tool& tool) { return tool.cutter_height; }

/// The rounded corner lies inside the diameter; the flank touches it.
std::vector<ConvexProfile> dovetailCutter(const Tool& tool, double height) {
  const double c = tool.corner_radius, angle = degToRad(tool.dovetail_angle_deg);
  const double center = 0.5 * tool.diameter - c;
  const double r = center + c * std::sin(angle), z = c * (1.0 + std::cos(angle));
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.lineTo(center, 0.0);
  if (c > 0.0) p.arcTo(center, c, r, z);
  closeAt(p, r - (height - z) / std::tan(angle), height);
  return {p};
}

std::string dovetailDetails(const Tool& tool) { return fmt::format(" {:g} deg", tool.dovetail_angle_deg); }

}  // namespace

constinit const ToolTypeRow kDovetail{
    .type = ToolType::kDovetail,
    .name = "dovetail",
    .option = "dovetail:D:ANGLE:HEIGHT:NECKD",
    .neck = ToolNeck::kNeeded,
    .set = setDovetail,
    .check = checkDovetail,
    .height = dovetailHeight,
    .cutter = dovetailCutter,
    .details = dovetailDetails,
};

}  // namespace proveout::tool_types
