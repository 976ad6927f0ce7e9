// Cones with a flat tip, and tapers with a ball end.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/tool/types/rows.h"
#include "core/tool/types/shapes.h"

namespace proveout::tool_types {
namespace {

/// Up a flank at half the included angle to the tool's full radius, or to where the flutes end before that.
void closeCone(ConvexProfile& p, double r, double z, const Tool& tool, double flute_end) {
  const double radius = 0.5 * tool.diameter, height = coneHeight(r, radius, tool.cone_angle_deg);
  if (z + height >= flute_end) {
    const double share = height > 0.0 ? (flute_end - z) / height : 1.0;
    return closeAt(p, r + (radius - r) * share, flute_end);
  }
  p.lineTo(radius, z + height);
  closeAt(p, radius, flute_end);
}

bool setCone(Tool& tool, std::span<const double> n) {
  if (n.size() != 3) return false;
  tool.diameter = n[0];
  tool.tip_diameter = n[1];
  tool.cone_angle_deg = n[2];
  return true;
}

void checkCone(const Tool& tool, ToolCheck& check) {
  check.angle(tool.cone_angle_deg, "the cone's included angle");
  check.require(tool.tip_diameter < tool.diameter, "the tip diameter must be smaller than the diameter");
}

std::vector<ConvexProfile> coneCutter(const Tool& tool, double height) {
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.lineTo(0.5 * tool.tip_diameter, 0.0);
  closeCone(p, 0.5 * tool.tip_diameter, 0.0, tool, height);
  return {p};
}

/// Of the flat tip; where that is a point, of a tenth of the diameter.
double coneRadius(const Tool& tool) { return std::max(tool.tip_diameter, 0.1 * tool.diameter) / 2; }

std::string coneDetails(const Tool& tool) {
  return fmt::format(" tip {:g} {:g} deg", tool.tip_diameter, tool.cone_angle_deg);
}

bool setTaper(Tool& tool, std::span<const double> n) {
  if (n.size() != 3) return false;
  tool.tip_diameter = n[0];
  tool.cone_angle_deg = 2.0 * n[1];
  tool.diameter = n[2];
  return true;
}

void checkTaper(const Tool& tool, ToolCheck& check) {
  check.angle(tool.cone_angle_deg, "the taper's included angle");
  check.positive(tool.tip_diameter, "ball_diameter");
  if (!check.good()) return;
  const double side = degToRad(0.5 * tool.cone_angle_deg);
  check.require(tool.tip_diameter * std::cos(side) <= tool.diameter,
                "diameter is smaller than where the ball meets the taper");
  check.flutesCover(0.5 * tool.tip_diameter * (1.0 - std::sin(side)), "the ball end");
}

std::vector<ConvexProfile> taperCutter(const Tool& tool, double height) {
  const double ball = 0.5 * tool.tip_diameter, side = degToRad(0.5 * tool.cone_angle_deg);
  const double r = ball * std::cos(side),
               z = ball * (1.0 - std::sin(side));  // where the flank touches the ball
  ConvexProfile p;
  p.start(0.0, 0.0);
  p.arcTo(0.0, ball, r, z);
  closeCone(p, r, z, tool, height);
  return {p};
}

double taperRadius(const Tool& tool) { return tool.tip_diameter / 2; }

std::string taperDetails(const Tool& tool) {
  return fmt::format(" ball {:g} {:g} deg", tool.tip_diameter, tool.cone_angle_deg);
}

}  // namespace

constinit const ToolTypeRow kCone{
    .type = ToolType::kCone,
    .name = "cone",
    .option = "cone:D:TIPD:ANGLE",
    .set = setCone,
    .check = checkCone,
    .cutter = coneCutter,
    .smallest_radius = coneRadius,
    .details = coneDetails,
};
constinit const ToolTypeRow kTaperBall{
    .type = ToolType::kTaperBall,
    .name = "taper",
    .option = "taper:BALLD:SIDEANGLE:D",
    .set = setTaper,
    .check = checkTaper,
    .cutter = taperCutter,
    .smallest_radius = taperRadius,
    .details = taperDetails,
};

}  // namespace proveout::tool_types
