#include "core/tool/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace proveout {

namespace {

/// Largest tool dimension that makes sense; also keeps squares far from overflow.
constexpr double kMinDiameterMm = 1e-3;  // a tenth of the thinnest end mill that is made
constexpr double kMaxDimensionMm = 1e5;
constexpr int kMaxTeeth = 200;  // twice the longest thread mills that are made

struct TypeName {
  ToolType type;
  std::string_view name;
};
constexpr TypeName kTypeNames[] = {{ToolType::kFlat, "flat"},         {ToolType::kBall, "ball"},
                                   {ToolType::kBull, "bull"},         {ToolType::kCone, "cone"},
                                   {ToolType::kDrill, "drill"},       {ToolType::kTaperBall, "taper"},
                                   {ToolType::kDovetail, "dovetail"}, {ToolType::kTSlot, "tslot"},
                                   {ToolType::kLollipop, "lollipop"}, {ToolType::kThreadMill, "thread-mill"},
                                   {ToolType::kForm, "form"},         {ToolType::kInsert, "insert"}};

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
  void angle(double value, std::string_view field, double limit = 180.0) {
    require(std::isfinite(value) && value > 0.0 && value < limit,
            fmt::format("{} must be above 0 and below {} degrees, not {}", field, limit, value));
  }
  /// A length that the type cannot do without.
  void positive(double value, std::string_view field) {
    length(value, field);
    require(value >= kMinDiameterMm,
            fmt::format("{} must be at least {} mm, not {}", field, kMinDiameterMm, value));
  }
  bool good() const { return message_.empty(); }
  Status status() const {
    if (!good()) return inputError(message_);
    return Done{};
  }

 private:
  const Tool& tool_;
  std::string message_;
};

/// The cutting part reaches `height`, which its shape takes, with the flutes or the tool as long as they are.
void checkFluteCovers(const Tool& tool, double height, std::string_view what, Checker& check) {
  std::string why = fmt::format("flute_length is needed: {} is longer than {} mm", what, kUnlimitedFluteMm);
  if (tool.overall_length > 0.0) why = fmt::format("overall_length is shorter than {}", what);
  if (tool.flute_length > 0.0) why = fmt::format("flute_length is shorter than {}", what);
  check.require(cutterTop(tool) >= height, why);
}

void checkTaperBall(const Tool& tool, Checker& check) {
  check.angle(tool.cone_angle_deg, "the taper's included angle");
  check.positive(tool.tip_diameter, "ball_diameter");
  if (!check.good()) return;
  const double side = degToRad(0.5 * tool.cone_angle_deg);
  check.require(tool.tip_diameter * std::cos(side) <= tool.diameter,
                "diameter is smaller than where the ball meets the taper");
  checkFluteCovers(tool, 0.5 * tool.tip_diameter * (1.0 - std::sin(side)), "the ball end", check);
}

void checkDovetail(const Tool& tool, Checker& check) {
  check.angle(tool.dovetail_angle_deg, "dovetail_angle", 90.0);
  check.positive(tool.cutter_height, "height");
  if (!check.good()) return;
  const double angle = degToRad(tool.dovetail_angle_deg), c = tool.corner_radius;
  check.require(c * (1.0 + std::cos(angle)) <= tool.cutter_height,
                "corner_radius does not fit into the height");
  const double top = 0.5 * tool.diameter - c * (1.0 - std::sin(angle)) -
                     (tool.cutter_height - c * (1.0 + std::cos(angle))) / std::tan(angle);
  check.require(
      tool.neck_diameter <= 2.0 * top,
      fmt::format("neck_diameter must be at most {:.6g} mm: what the flank leaves at the top of the cutter",
                  std::max(0.0, 2.0 * top)));
}

void checkTSlot(const Tool& tool, Checker& check) {
  check.positive(tool.cutter_height, "thickness");
  check.require(2.0 * tool.corner_radius <= tool.cutter_height,
                "corner_radius is larger than half the thickness");
}

void checkThreadMill(const Tool& tool, Checker& check) {
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
      root >= kMinDiameterMm,
      "the teeth are deeper than the tool: the pitch is too large for the diameter, or root_diameter is "
      "missing");
  check.require(root < tool.diameter, "root_diameter must be below the diameter");
  const double base =
      tool.crest_flat + (tool.diameter - root) * std::tan(degToRad(0.5 * tool.thread_angle_deg));
  check.require(base <= tool.pitch * (1.0 + 1e-9),
                "root_diameter is below where the flanks of teeth a pitch apart meet");
  check.require(tool.neck_diameter <= root, "neck_diameter must be at most the diameter between the teeth");
}

void checkForm(const Tool& tool, Checker& check) {
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

void checkShape(const Tool& tool, Checker& check) {
  switch (tool.type) {
    case ToolType::kBall:
      return checkFluteCovers(tool, 0.5 * tool.diameter, "the ball end", check);
    case ToolType::kBull:
      return checkFluteCovers(tool, tool.corner_radius, "the corner radius", check);
    case ToolType::kCone:
      check.angle(tool.cone_angle_deg, "the cone's included angle");
      return check.require(tool.tip_diameter < tool.diameter,
                           "the tip diameter must be smaller than the diameter");
    case ToolType::kDrill:
      check.angle(tool.point_angle_deg, "the point angle");
      if (!check.good()) return;
      return checkFluteCovers(tool, 0.5 * tool.diameter / std::tan(degToRad(0.5 * tool.point_angle_deg)),
                              "the drill's point", check);
    case ToolType::kTaperBall:
      return checkTaperBall(tool, check);
    case ToolType::kDovetail:
      return checkDovetail(tool, check);
    case ToolType::kTSlot:
      return checkTSlot(tool, check);
    case ToolType::kThreadMill:
      return checkThreadMill(tool, check);
    case ToolType::kForm:
      return checkForm(tool, check);
    case ToolType::kFlat:
    case ToolType::kLollipop:
    case ToolType::kInsert:  // see checkInsert
      return;
  }
}

void checkInsert(const Tool& tool, Checker& check) {
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

/// Neck and shank above the cutting part. The shape must be good: its height counts.
void checkNeck(const Tool& tool, Checker& check) {
  if (!hasNeck(tool.type)) {
    return check.require(tool.neck_diameter == 0.0 && tool.neck_length == 0.0,
                         "this type has no neck_diameter and no neck_length");
  }
  check.require(tool.flute_length == 0.0, "this type cuts over its own height and has no flute_length");
  const bool optional = tool.type == ToolType::kThreadMill || tool.type == ToolType::kForm;
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

std::optional<ToolType> toolTypeOf(std::string_view name) {
  for (const TypeName& entry : kTypeNames) {
    if (entry.name == name) return entry.type;
  }
  return std::nullopt;
}

Status validateTool(const Tool& tool) {
  Checker check(tool);
  check.require(tool.number >= 0, "the number must not be negative");
  check.require(std::isfinite(tool.gauge_length) && std::abs(tool.gauge_length) <= kMaxDimensionMm,
                "gauge_length is out of range");
  if (tool.type == ToolType::kInsert) {
    checkInsert(tool, check);
    return check.status();
  }
  check.require(!tool.insert, "only tools of type insert have an insert");
  check.length(tool.diameter, "diameter");
  check.require(tool.diameter > 0.0, "diameter must be above 0");
  check.require(tool.diameter <= 0.0 || tool.diameter >= kMinDiameterMm,
                fmt::format("diameter must be at least {} mm, not {}", kMinDiameterMm, tool.diameter));
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
  if (check.good()) checkShape(tool, check);
  if (check.good()) checkNeck(tool, check);
  checkHolder(tool, check);
  return check.status();
}

bool hasNeck(ToolType type) {
  switch (type) {
    case ToolType::kDovetail:
    case ToolType::kTSlot:
    case ToolType::kLollipop:
    case ToolType::kThreadMill:
    case ToolType::kForm:
      return true;
    default:
      return false;
  }
}

double rootDiameter(const Tool& tool) {
  if (tool.root_diameter > 0.0) return tool.root_diameter;
  return tool.diameter - (tool.pitch - tool.crest_flat) / std::tan(degToRad(0.5 * tool.thread_angle_deg));
}

double cutterTop(const Tool& tool) {
  switch (tool.type) {
    case ToolType::kDovetail:
    case ToolType::kTSlot:
      return tool.cutter_height;
    case ToolType::kLollipop:  // where the neck comes out of the ball
      return 0.5 * (tool.diameter +
                    std::sqrt((tool.diameter - tool.neck_diameter) * (tool.diameter + tool.neck_diameter)));
    case ToolType::kThreadMill:
      return threadOutline(tool).back().z;
    case ToolType::kForm:
      return tool.outline.back().z;
    default:
      break;
  }
  if (tool.flute_length > 0.0) return tool.flute_length;
  return tool.overall_length > 0.0 ? tool.overall_length : kUnlimitedFluteMm;
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

}  // namespace proveout
