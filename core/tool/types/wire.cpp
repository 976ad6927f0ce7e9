// Wires of wire erosion: no solids of revolution. A wire cuts all around itself, as far out as its sparks
// reach.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/tool/types/rows.h"

namespace proveout::tool_types {
namespace {

void checkWire(const Tool& tool, ToolCheck& check) {
  check.positive(tool.diameter, "diameter");
  check.length(tool.diameter, "diameter");
  check.length(tool.spark_gap, "spark_gap");
  const double rotary[] = {tool.corner_radius, tool.tip_diameter,  tool.flute_length,   tool.overall_length,
                           tool.neck_diameter, tool.neck_length,   tool.shank_diameter, tool.cone_angle_deg,
                           tool.cutter_height, tool.root_diameter, tool.pitch,          tool.gauge_length};
  const bool none = std::all_of(std::begin(rotary), std::end(rotary), [](double v) { return v == 0.0; });
  check.require(none && tool.outline.empty() && tool.holder.empty() && !tool.left_hand && !tool.insert,
                "a wire has a diameter and a spark gap, and no dimensions of a tool that turns");
}

std::string wireDetails(const Tool& tool) {
  std::string text = fmt::format("wire {:g}", tool.diameter);
  if (tool.spark_gap > 0.0) text += fmt::format(" gap {:g}", tool.spark_gap);
  return text;
}

}  // namespace

constinit const ToolTypeRow kWire{
    .type = ToolType::kWire,
    .name = "wire",
    .rotates = false,
    .check = checkWire,
    .details = wireDetails,
};

}  // namespace proveout::tool_types
