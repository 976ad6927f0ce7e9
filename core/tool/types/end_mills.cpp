// Flat end mills, ball and bull noses.
#include "core/tool/types/rows.h"
#include "core/tool/types/shapes.h"

namespace proveout::tool_types {
namespace {

bool setDiameter(Tool& tool, std::span<const double> n) {
  if (n.size() != 1) return false;
  tool.diameter = n[0];
  return true;
}

bool setBull(Tool& tool, std::span<const double> n) {
  if (n.size() != 2) return false;
  tool.diameter = n[0];
  tool.corner_radius = n[1];
  return true;
}

void checkBall(const Tool& tool, ToolCheck& check) { check.flutesCover(0.5 * tool.diameter, "the ball end"); }
void checkBull(const Tool& tool, ToolCheck& check) {
  check.flutesCover(tool.corner_radius, "the corner radius");
}

std::vector<ConvexProfile> flatCutter(const Tool& tool, double height) {
  const double radius = 0.5 * tool.diameter;
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.lineTo(radius, 0.0);
  closeAt(p, radius, height);
  return {p};
}

std::vector<ConvexProfile> ballCutter(const Tool& tool, double height) {
  const double radius = 0.5 * tool.diameter;
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.arcTo(0.0, radius, radius, radius);
  closeAt(p, radius, height);
  return {p};
}

std::vector<ConvexProfile> bullCutter(const Tool& tool, double height) {
  const double radius = 0.5 * tool.diameter, corner = tool.corner_radius;
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.lineTo(radius - corner, 0.0);
  if (corner > 0.0) p.arcTo(radius - corner, corner, radius, corner);
  closeAt(p, radius, height);
  return {p};
}

}  // namespace

constinit const ToolTypeRow kFlat{
    .type = ToolType::kFlat,
    .name = "flat",
    .option = "flat:D",
    .set = setDiameter,
    .cutter = flatCutter,
};
constinit const ToolTypeRow kBall{
    .type = ToolType::kBall,
    .name = "ball",
    .option = "ball:D",
    .set = setDiameter,
    .check = checkBall,
    .cutter = ballCutter,
};
constinit const ToolTypeRow kBull{
    .type = ToolType::kBull,
    .name = "bull",
    .option = "bull:D:R",
    .set = setBull,
    .check = checkBull,
    .cutter = bullCutter,
};

}  // namespace proveout::tool_types
