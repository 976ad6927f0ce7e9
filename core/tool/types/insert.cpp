// Inserts of lathes: no solids of revolution. Their shapes are in core/tool/insert.h.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/tool/types/rows.h"

namespace proveout::tool_types {
namespace {

void checkInsert(const Tool& tool, ToolCheck& check) {
  check.require(tool.insert.has_value(), "an insert without its shape");
  const double rotary[] = {tool.diameter,       tool.corner_radius, tool.tip_diameter,  tool.flute_length,
                           tool.overall_length, tool.neck_diameter, tool.neck_length,   tool.shank_diameter,
                           tool.cone_angle_deg, tool.cutter_height, tool.root_diameter, tool.pitch,
                           tool.gauge_length};
  const bool none = std::all_of(std::begin(rotary), std::end(rotary), [](double v) { return v == 0.0; });
  check.require(none && tool.outline.empty() && tool.holder.empty() && !tool.left_hand,
                "an insert has no dimensions and no hand of a tool that turns");
  if (!check.good()) return;
  if (const Status valid = validateInsert(*tool.insert); !valid) check.require(false, valid.error().message);
}

std::string insertDetails(const Tool& tool) {
  const Insert& insert = *tool.insert;
  std::string text = fmt::format("insert {}", insertShapeName(insert.shape));
  if (insert.insert_angle_deg > 0) text += fmt::format(" {:g} deg", insert.insert_angle_deg);
  if (insert.width > 0) text += fmt::format(" {:g} wide", insert.width);
  return text + fmt::format(" r{:g}", insert.nose_radius);
}

}  // namespace

constinit const ToolTypeRow kInsert{
    .type = ToolType::kInsert,
    .name = "insert",
    .rotates = false,
    .check = checkInsert,
    .details = insertDetails,
};

}  // namespace proveout::tool_types
