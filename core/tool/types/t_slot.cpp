// T-slot cutters: a disc on a neck.
#include <algorithm>

#include "core/tool/types/rows.h"

namespace proveout::tool_types {
namespace {

bool setTSlot(Tool& tool, std::span<const double> n) {
  if (n.size() != 3) return false;
  tool.diameter = n[0];
  tool.cutter_height = n[1];
  tool.neck_diameter = n[2];
  return true;
}

void checkTSlot(const Tool& tool, ToolCheck& check) {
  check.positive(tool.cutter_height, "thickness");
  check.require(2.0 * tool.corner_radius <= tool.cutter_height,
                "corner_radius is larger than half the thickness");
}

double tSlotHeight(const Tool& tool) { return tool.cutter_height; }

std::vector<ConvexProfile> tSlotCutter(const Tool& tool, double height) {
  const double c = tool.corner_radius, radius = 0.5 * tool.diameter;
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.lineTo(radius - c, 0.0);
  if (c > 0.0) p.arcTo(radius - c, c, radius, c);
  p.lineTo(radius, std::max(c, height - c));
  if (c > 0.0) p.arcTo(radius - c, std::max(c, height - c), radius - c, height);
  p.lineTo(0.0, height);
  return {p};
}

}  // namespace

constinit const ToolTypeRow kTSlot{
    .type = ToolType::kTSlot,
    .name = "tslot",
    .option = "tslot:D:THICKNESS:NECKD",
    .neck = ToolNeck::kNeeded,
    .set = setTSlot,
    .check = checkTSlot,
    .height = tSlotHeight,
    .cutter = tSlotCutter,
};

}  // namespace proveout::tool_types
