// The command line's short way to describe a tool.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/tool/tool.h"

namespace proveout {

namespace {

std::optional<double> parseNumber(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

/// Sets the shape's numbers; false if their count is wrong for the type.
bool setShape(Tool& tool, const std::vector<double>& n) {
  if (n.empty()) return false;
  tool.diameter = n[0];
  switch (tool.type) {
    case ToolType::kFlat:
    case ToolType::kBall:
      return n.size() == 1;
    case ToolType::kBull:
      if (n.size() != 2) return false;
      tool.corner_radius = n[1];
      return true;
    case ToolType::kCone:
      if (n.size() != 3) return false;
      tool.tip_diameter = n[1];
      tool.cone_angle_deg = n[2];
      return true;
    case ToolType::kDrill:
      if (n.size() > 2) return false;
      if (n.size() == 2) tool.point_angle_deg = n[1];
      return true;
    case ToolType::kTaperBall:
      if (n.size() != 3) return false;
      tool.diameter = n[2];
      tool.tip_diameter = n[0];
      tool.cone_angle_deg = 2.0 * n[1];
      return true;
    case ToolType::kDovetail:
      if (n.size() != 4) return false;
      tool.dovetail_angle_deg = n[1];
      tool.cutter_height = n[2];
      tool.neck_diameter = n[3];
      return true;
    case ToolType::kTSlot:
      if (n.size() != 3) return false;
      tool.cutter_height = n[1];
      tool.neck_diameter = n[2];
      return true;
    case ToolType::kLollipop:
      if (n.size() != 2) return false;
      tool.neck_diameter = n[1];
      return true;
    case ToolType::kThreadMill:
    case ToolType::kForm:
    case ToolType::kInsert:
      return false;
  }
  return false;
}

}  // namespace

Result<Tool> parseToolOption(const std::string& text) {
  const auto wrong = [&](std::string_view why) {
    return inputError(
        fmt::format("--tool {}: {}; write N=flat:D, N=ball:D, N=bull:D:R, N=cone:D:TIPD:ANGLE, "
                    "N=drill:D:POINTANGLE, N=taper:BALLD:SIDEANGLE:D, N=dovetail:D:ANGLE:HEIGHT:NECKD, "
                    "N=tslot:D:THICKNESS:NECKD or N=lollipop:D:NECKD, in mm and degrees",
                    text, why));
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return wrong("no '='");
  Tool tool;
  const char* end_of_number = text.data() + equals;
  const auto [end, error] = std::from_chars(text.data(), end_of_number, tool.number);
  if (error != std::errc{} || end != end_of_number || tool.number < 0)
    return wrong("the tool number is not a whole number");
  const auto parts = split(std::string_view(text).substr(equals + 1), ':');
  const auto type = toolTypeOf(parts[0]);
  if (!type) return wrong(fmt::format("unknown shape '{}'", parts[0]));
  if (*type == ToolType::kThreadMill || *type == ToolType::kForm || *type == ToolType::kInsert)
    return wrong(fmt::format("'{}' needs a job file ([[tool]])", parts[0]));
  tool.type = *type;
  std::vector<double> numbers;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto number = parseNumber(parts[i]);
    if (!number) return wrong(fmt::format("'{}' is not a number", parts[i]));
    numbers.push_back(*number);
  }
  if (!setShape(tool, numbers)) return wrong(fmt::format("wrong count of numbers for '{}'", parts[0]));
  if (Status status = validateTool(tool); !status) return status.error();
  return tool;
}

}  // namespace proveout
