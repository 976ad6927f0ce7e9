#include "core/tool/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/tool/tool_check.h"
#include "core/tool/tool_type.h"

namespace proveout {
namespace {

void checkLengths(const Tool& tool, ToolCheck& check) {
  check.length(tool.diameter, "diameter");
  check.require(tool.diameter > 0.0, "diameter must be above 0");
  check.require(tool.diameter <= 0.0 || tool.diameter >= kMinToolDiameterMm,
                fmt::format("diameter must be at least {} mm, not {}", kMinToolDiameterMm, tool.diameter));
  check.length(tool.corner_radius, "corner_radius");
  check.require(tool.corner_radius <= 0.5 * tool.diameter, "corner_radius is larger than the tool's radius");
  check.length(tool.tip_diameter, "tip diameter");
  check.length(tool.flute_length, "flute_length");
  check.length(tool.overall_length, "overall_length");
  check.length(tool.shank_diameter, "shank_diameter");
  check.length(tool.neck_diameter, "neck_diameter");
  check.length(tool.neck_length, "neck_length");
  check.require(tool.overall_length == 0.0 || tool.flute_length <= tool.overall_length,
                "flute_length is longer than overall_length");
}

/// Neck and shank above the cutting part. The shape must be good: its height counts.
void checkNeck(const Tool& tool, const ToolTypeRow& type, ToolCheck& check) {
  if (type.neck == ToolNeck::kNone) {
    return check.require(tool.neck_diameter == 0.0 && tool.neck_length == 0.0,
                         "this type has no neck_diameter and no neck_length");
  }
  check.require(tool.flute_length == 0.0, "this type cuts over its own height and has no flute_length");
  const bool optional = type.neck == ToolNeck::kOptional;
  if (!optional) check.positive(tool.neck_diameter, "neck_diameter");
  check.require(optional || tool.neck_diameter < tool.diameter, "neck_diameter must be below the diameter");
  if (!check.good()) return;
  const double top = cutterTop(tool);
  check.require(tool.overall_length == 0.0 || tool.overall_length >= top,
                fmt::format("overall_length is shorter than the cutting part, {:.6g} mm", top));
  if (tool.neck_length > 0.0) {
    check.require(tool.shank_diameter > 0.0 && tool.overall_length > 0.0,
                  "neck_length needs shank_diameter and overall_length: the shank that begins there");
    check.require(tool.neck_length >= top, "neck_length ends inside the cutting part");
    check.require(tool.neck_length <= tool.overall_length, "neck_length is longer than overall_length");
    check.require(tool.type != ToolType::kForm || tool.neck_diameter > 0.0,
                  "neck_length needs neck_diameter");
  } else {
    check.require(tool.shank_diameter == 0.0 || (tool.type == ToolType::kForm && tool.neck_diameter == 0.0),
                  "shank_diameter needs neck_length: where the shank begins");
  }
}

void checkHolder(const Tool& tool, ToolCheck& check) {
  if (tool.holder.empty()) return;
  check.require(tool.holder.size() >= 2, "a holder needs at least two (height, radius) points");
  check.require(tool.overall_length > 0.0, "a holder needs overall_length: it starts there");
  for (std::size_t i = 0; i < tool.holder.size(); ++i) {
    check.length(tool.holder[i].x(), "a holder height");
    check.length(tool.holder[i].y(), "a holder radius");
    if (i > 0) check.require(tool.holder[i].x() >= tool.holder[i - 1].x(), "holder heights must not go down");
  }
}

}  // namespace

std::string_view toolTypeName(ToolType type) { return rowOf(type).name; }

std::optional<ToolType> toolTypeOf(std::string_view name) {
  for (const ToolTypeRow* row : toolTypes()) {
    if (row->name == name) return row->type;
  }
  return std::nullopt;
}

Status validateTool(const Tool& tool) {
  const ToolTypeRow& type = rowOf(tool.type);
  ToolCheck check(tool);
  check.require(tool.number >= 0, "the number must not be negative");
  check.require(std::isfinite(tool.gauge_length) && std::abs(tool.gauge_length) <= kMaxToolDimensionMm,
                "gauge_length is out of range");
  if (!type.rotates) {
    type.check(tool, check);
    return check.status();
  }
  check.require(!tool.insert, "only tools of type insert have an insert");
  checkLengths(tool, check);
  if (check.good() && type.check != nullptr) type.check(tool, check);
  if (check.good()) checkNeck(tool, type, check);
  checkHolder(tool, check);
  return check.status();
}

bool hasNeck(ToolType type) { return rowOf(type).neck != ToolNeck::kNone; }

double cutterTop(const Tool& tool) {
  if (const auto height = rowOf(tool.type).height) return height(tool);
  if (tool.flute_length > 0.0) return tool.flute_length;
  return tool.overall_length > 0.0 ? tool.overall_length : kUnlimitedFluteMm;
}

double smallestRadius(const Tool& tool) {
  // Corners of bull noses, dovetails and T-slot cutters come first.
  if (tool.corner_radius > 0) return std::min(tool.corner_radius, tool.diameter / 2);
  const auto radius = rowOf(tool.type).smallest_radius;
  return radius != nullptr ? radius(tool) : tool.diameter / 2;
}

std::string describe(const Tool& tool) {
  const ToolTypeRow& type = rowOf(tool.type);
  std::string text;
  if (type.rotates) text = fmt::format("{} {:g}", type.name, tool.diameter);
  if (tool.corner_radius > 0 || tool.type == ToolType::kBull)
    text += fmt::format(" r{:g}", tool.corner_radius);
  return type.details != nullptr ? text + type.details(tool) : text;
}

}  // namespace proveout
