// Lollipops: a ball on a neck.
#include <cmath>

#include "core/tool/types/rows.h"

namespace proveout::tool_types {
namespace {

bool setLollipop(Tool& tool, std::span<const double> n) {
  if (n.size() != 2) return false;
  tool.diameter = n[0];
  tool.neck_diameter = n[1];
  return true;
}

/// Where the neck comes out of the ball.
double lollipopHeight(const Tool& tool) {
  return 0.5 * (tool.diameter +
                std::sqrt((tool.diameter - tool.neck_diameter) * (tool.diameter + tool.neck_diameter)));
}

std::vector<ConvexProfile> lollipopCutter(const Tool& tool, double height) {
  const double radius = 0.5 * tool.diameter;
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.arcTo(0.0, radius, 0.5 * tool.neck_diameter, height);
  p.lineTo(0.0, height);
  return {p};
}

}  // namespace

constinit const ToolTypeRow kLollipop{
    .type = ToolType::kLollipop,
    .name = "lollipop",
    .option = "lollipop:D:NECKD",
    .neck = ToolNeck::kNeeded,
    .set = setLollipop,
    .height = lollipopHeight,
    .cutter = lollipopCutter,
};

}  // namespace proveout::tool_types
