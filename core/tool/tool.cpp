#include "core/tool/tool.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace proveout {

namespace {

/// Largest tool dimension that makes sense; also keeps squares far from overflow.
constexpr double kMinDiameterMm = 1e-3;  // a tenth of the thinnest end mill that is made
constexpr double kMaxDimensionMm = 1e5;

struct TypeName {
  ToolType type;
  std::string_view name;
};
constexpr TypeName kTypeNames[] = {{ToolType::kFlat, "flat"},
                                   {ToolType::kBall, "ball"},
                                   {ToolType::kBull, "bull"},
                                   {ToolType::kCone, "cone"},
                                   {ToolType::kDrill, "drill"}};

class Checker {
 public:
  explicit Checker(const Tool& tool) : tool_(tool) {}
  void require(bool good, std::string_view what) {
    if (!good && message_.empty()) message_ = fmt::format("tool {}: {}", tool_.number, what);
  }
  void length(double value, std::string_view field) {
    require(std::isfinite(value) && value >= 0.0 && value <= kMaxDimensionMm,
            fmt::format("{} must be between 0 and {} mm, not {}", field, kMaxDimensionMm, value));
  }
  void angle(double value, std::string_view field) {
    require(std::isfinite(value) && value > 0.0 && value < 180.0,
            fmt::format("{} must be above 0 and below 180 degrees, not {}", field, value));
  }
  const std::string& message() const { return message_; }

 private:
  const Tool& tool_;
  std::string message_;
};

void checkShape(const Tool& tool, Checker& check) {
  switch (tool.type) {
    case ToolType::kBall:
      check.require(tool.flute_length == 0.0 || tool.flute_length >= 0.5 * tool.diameter,
                    "flute_length is shorter than the ball end");
      break;
    case ToolType::kBull:
      check.require(tool.corner_radius <= 0.5 * tool.diameter,
                    "corner_radius is larger than the tool's radius");
      check.require(tool.flute_length == 0.0 || tool.flute_length >= tool.corner_radius,
                    "flute_length is shorter than the corner radius");
      break;
    case ToolType::kCone:
      check.angle(tool.cone_angle_deg, "the cone's included angle");
      check.require(tool.tip_diameter < tool.diameter, "the tip diameter must be smaller than the diameter");
      break;
    case ToolType::kDrill:
      check.angle(tool.point_angle_deg, "the point angle");
      if (tool.point_angle_deg > 0.0 && tool.point_angle_deg < 180.0 && tool.flute_length > 0.0) {
        check.require(
            tool.flute_length >= 0.5 * tool.diameter / std::tan(degToRad(0.5 * tool.point_angle_deg)),
            "flute_length is shorter than the drill's point");
      }
      break;
    case ToolType::kFlat:
      break;
  }
}

void checkHolder(const Tool& tool, Checker& check) {
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

std::string_view toolTypeName(ToolType type) {
  for (const TypeName& entry : kTypeNames) {
    if (entry.type == type) return entry.name;
  }
  return "flat";
}

Status validateTool(const Tool& tool) {
  Checker check(tool);
  check.require(tool.number >= 0, "the number must not be negative");
  check.length(tool.diameter, "diameter");
  check.require(tool.diameter > 0.0, "diameter must be above 0");
  check.require(tool.diameter <= 0.0 || tool.diameter >= kMinDiameterMm,
                fmt::format("diameter must be at least {} mm, not {}", kMinDiameterMm, tool.diameter));
  check.length(tool.corner_radius, "corner_radius");
  check.length(tool.tip_diameter, "tip diameter");
  check.length(tool.flute_length, "flute_length");
  check.length(tool.overall_length, "overall_length");
  check.length(tool.shank_diameter, "shank_diameter");
  check.require(std::isfinite(tool.gauge_length) && std::abs(tool.gauge_length) <= kMaxDimensionMm,
                "gauge_length is out of range");
  check.require(tool.overall_length == 0.0 || tool.flute_length <= tool.overall_length,
                "flute_length is longer than overall_length");
  checkShape(tool, check);
  checkHolder(tool, check);
  if (!check.message().empty()) return inputError(check.message());
  return Done{};
}

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
  }
  return false;
}

}  // namespace

Result<Tool> parseToolOption(const std::string& text) {
  const auto wrong = [&](std::string_view why) {
    return inputError(
        fmt::format("--tool {}: {}; write N=flat:D, N=ball:D, N=bull:D:R, N=cone:D:TIPD:ANGLE or "
                    "N=drill:D:POINTANGLE, in mm and degrees",
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
  bool known = false;
  for (const TypeName& entry : kTypeNames) {
    if (entry.name == parts[0]) {
      tool.type = entry.type;
      known = true;
    }
  }
  if (!known) return wrong(fmt::format("unknown shape '{}'", parts[0]));
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
