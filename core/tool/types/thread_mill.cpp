// Thread mills: rings of teeth, without lead.
#include <fmt/format.h>

#include <cmath>

#include "core/base/assert.h"
#include "core/tool/types/rows.h"

namespace proveout {

double rootDiameter(const Tool& tool) {
  if (tool.root_diameter > 0.0) return tool.root_diameter;
  return tool.diameter - (tool.pitch - tool.crest_flat) / std::tan(degToRad(0.5 * tool.thread_angle_deg));
}

std::vector<OutlinePoint> threadOutline(const Tool& tool) {
  const double crest = 0.5 * tool.diameter, root = 0.5 * rootDiameter(tool);
  const double flank = (crest - root) * std::tan(degToRad(0.5 * tool.thread_angle_deg));
  std::vector<OutlinePoint> points;
  const auto add = [&](double r, double z) {
    // Teeth whose feet meet, and crests without a flat, have one point there.
    constexpr double kSameMm = 1e-9;
    if (!points.empty() && points.back().r == r && z - points.back().z < kSameMm) return;
    points.push_back({r, z, 0.0});
  };
  for (int i = 0; i < tool.teeth; ++i) {
    const double z = i * tool.pitch;
    add(root, z);
    add(crest, z + flank);
    add(crest, z + flank + tool.crest_flat);
    add(root, z + 2.0 * flank + tool.crest_flat);
  }
  return points;
}

namespace tool_types {
namespace {

constexpr int kMaxTeeth = 200;  // twice the longest thread mills that are made

void checkThreadMill(const Tool& tool, ToolCheck& check) {
  check.positive(tool.pitch, "pitch");
  check.angle(tool.thread_angle_deg, "thread_angle");
  check.length(tool.crest_flat, "crest_flat");
  check.length(tool.root_diameter, "root_diameter");
  check.require(tool.teeth >= 1 && tool.teeth <= kMaxTeeth,
                fmt::format("teeth must be between 1 and {}, not {}", kMaxTeeth, tool.teeth));
  if (!check.good()) return;
  check.require(tool.crest_flat < tool.pitch, "crest_flat must be below the pitch");
  const double root = rootDiameter(tool);
  check.require(
      root >= kMinToolDiameterMm,
      "the teeth are deeper than the tool: the pitch is too large for the diameter, or root_diameter is "
      "missing");
  check.require(root < tool.diameter, "root_diameter must be below the diameter");
  const double base =
      tool.crest_flat + (tool.diameter - root) * std::tan(degToRad(0.5 * tool.thread_angle_deg));
  check.require(base <= tool.pitch * (1.0 + 1e-9),
                "root_diameter is below where the flanks of teeth a pitch apart meet");
  check.require(tool.neck_diameter <= root, "neck_diameter must be at most the diameter between the teeth");
}

double threadMillHeight(const Tool& tool) { return threadOutline(tool).back().z; }

std::vector<ConvexProfile> threadMillCutter(const Tool& tool, double) {
  const auto edges = outlineEdges(threadOutline(tool));
  PROVEOUT_ASSERT(edges.ok());  // validateTool has seen them
  return convexParts(*edges);
}

double threadMillNeck(const Tool& tool) { return 0.5 * rootDiameter(tool); }

std::string threadMillDetails(const Tool& tool) {
  return fmt::format(" pitch {:g} x{}", tool.pitch, tool.teeth);
}

}  // namespace

constinit const ToolTypeRow kThreadMill{
    .type = ToolType::kThreadMill,
    .name = "thread-mill",
    .neck = ToolNeck::kOptional,
    .check = checkThreadMill,
    .height = threadMillHeight,
    .cutter = threadMillCutter,
    .neck_radius = threadMillNeck,
    .details = threadMillDetails,
};

}  // namespace tool_types
}  // namespace proveout
