// Form cutters: a free outline.
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/tool/types/rows.h"

namespace proveout::tool_types {
namespace {

void checkForm(const Tool& tool, ToolCheck& check) {
  for (const OutlinePoint& p : tool.outline) {
    check.length(p.r, "a radius of the profile");
    check.length(p.z, "a height of the profile");
    check.length(std::abs(p.arc_radius), "an arc's radius in the profile");
  }
  if (!check.good()) return;
  const auto edges = outlineEdges(tool.outline);
  if (!edges) return check.require(false, edges.error().message);
  check.require(std::abs(outlineDiameter(*edges) - tool.diameter) <= 1e-9 * tool.diameter,
                "diameter is not twice the largest radius of the profile");
}

double formHeight(const Tool& tool) { return tool.outline.back().z; }

std::vector<ConvexProfile> formCutter(const Tool& tool, double) {
  const auto edges = outlineEdges(tool.outline);
  PROVEOUT_ASSERT(edges.ok());  // validateTool has seen them
  return convexParts(*edges);
}

double formNeck(const Tool& tool) {
  return tool.shank_diameter > 0.0 ? 0.5 * tool.shank_diameter : tool.outline.back().r;
}

double formRadius(const Tool& tool) {
  double radius = tool.diameter / 2;
  for (const OutlinePoint& p : tool.outline) {
    if (p.arc_radius != 0) radius = std::min(radius, std::abs(p.arc_radius));
    if (p.r > 0) radius = std::min(radius, p.r);
  }
  return radius;
}

}  // namespace

constinit const ToolTypeRow kForm{
    .type = ToolType::kForm,
    .name = "form",
    .neck = ToolNeck::kOptional,
    .check = checkForm,
    .height = formHeight,
    .cutter = formCutter,
    .neck_radius = formNeck,
    .smallest_radius = formRadius,
};

}  // namespace proveout::tool_types
