// Tools and offset tables of a job file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "core/base/printable.h"
#include "core/tool/tool_type.h"
#include "io/job/job_offsets.h"
#include "io/job/job_sections.h"

namespace proveout {

using Type = ConfigValue::Type;

namespace {

constexpr int kMaxToolNumber = 99'999'999;
constexpr int kMaxOffsetNumber = 9999;
constexpr NumberRange kToolLength{0.0, 1e5, true};
constexpr NumberRange kToolLengthOrZero{0.0, 1e5, false};
constexpr NumberRange kIncludedAngle{0.0, 179.9, true};
constexpr NumberRange kAngle{-360.0, 360.0, false};

void assign(double& target, const std::optional<double>& value) {
  if (value) target = *value;
}

/// A key that may be missing.
void optional(ConfigTable& table, const char* key, const NumberRange& range, double& target) {
  assign(target, table.number(key, range));
}

void needed(ConfigTable& table, const char* key, const NumberRange& range, double& target) {
  assign(target, table.must(key).number(key, range));
}

/// A taper is given by its tip, flat or round, and the angle of one side, as makers of tapered end mills do.
/// Where no diameter is given, the cone goes on to the end of the flutes.
void readTaper(ConfigTable& table, Tool& tool) {
  const bool ball = table.find("ball_diameter") != nullptr, flat = table.find("tip_diameter") != nullptr;
  if (ball == flat) {
    table.error("type", "job-missing",
                "a taper needs tip_diameter (a flat tip) or ball_diameter (a ball end), not both");
  }
  tool.type = ball ? ToolType::kTaperBall : ToolType::kCone;
  optional(table, "tip_diameter", kToolLengthOrZero, tool.tip_diameter);
  optional(table, "ball_diameter", kToolLength, tool.tip_diameter);
  const auto side = table.must("taper_angle").number("taper_angle", {0.0, 89.9, true});
  optional(table, "diameter", kToolLength, tool.diameter);
  optional(table, "flute_length", kToolLength, tool.flute_length);
  if (!side) return;
  tool.cone_angle_deg = 2.0 * *side;
  if (table.find("diameter") != nullptr) return;
  if (tool.flute_length <= 0.0) {
    table.error("type", "job-missing", "a taper needs diameter or flute_length");
    return;
  }
  const double angle = degToRad(*side), tip = tool.tip_diameter;
  tool.diameter = ball ? tip * std::cos(angle) +
                             2.0 * (tool.flute_length - 0.5 * tip * (1.0 - std::sin(angle))) * std::tan(angle)
                       : tip + 2.0 * tool.flute_length * std::tan(angle);
}

void readBull(ConfigTable& table, Tool& tool) {
  needed(table, "corner_radius", kToolLengthOrZero, tool.corner_radius);
}

void readCone(ConfigTable& table, Tool& tool) {
  optional(table, "tip_diameter", kToolLengthOrZero, tool.tip_diameter);
  needed(table, "cone_angle", kIncludedAngle, tool.cone_angle_deg);
}

void readDrill(ConfigTable& table, Tool& tool) {
  optional(table, "point_angle", kIncludedAngle, tool.point_angle_deg);
}

void readDovetail(ConfigTable& table, Tool& tool) {
  needed(table, "dovetail_angle", {0.0, 89.9, true}, tool.dovetail_angle_deg);
  needed(table, "height", kToolLength, tool.cutter_height);
  optional(table, "corner_radius", kToolLengthOrZero, tool.corner_radius);
  table.require("neck_diameter");
}

void readTSlot(ConfigTable& table, Tool& tool) {
  needed(table, "thickness", kToolLength, tool.cutter_height);
  optional(table, "corner_radius", kToolLengthOrZero, tool.corner_radius);
  table.require("neck_diameter");
}

void readLollipop(ConfigTable& table, Tool&) { table.require("neck_diameter"); }

void readThreadMill(ConfigTable& table, Tool& tool) {
  needed(table, "pitch", kToolLength, tool.pitch);
  if (const auto teeth = table.integer("teeth", 1, 200)) tool.teeth = static_cast<int>(*teeth);
  optional(table, "thread_angle", kIncludedAngle, tool.thread_angle_deg);
  optional(table, "crest_flat", kToolLengthOrZero, tool.crest_flat);
  optional(table, "root_diameter", kToolLength, tool.root_diameter);
}

/// One point: [radius, height], or [radius, height, radius of the arc that leads to it].
std::optional<OutlinePoint> readOutlinePoint(const ConfigDocument& document, const ConfigValue& item) {
  const bool line = item.items.size() == 2, arc = item.items.size() == 3;
  if (item.type != Type::kArray || (!line && !arc)) {
    document.error(item.place, "job-type",
                   "a point of a profile is [radius, height] or, at the end of an arc, [radius, height, arc "
                   "radius]");
    return std::nullopt;
  }
  const auto r = readNumber(document, item.items[0], "a radius of the profile", kToolLengthOrZero);
  const auto z = readNumber(document, item.items[1], "a height of the profile", kToolLengthOrZero);
  if (!r || !z) return std::nullopt;
  OutlinePoint point{*r, *z, 0.0};
  if (arc) {
    const auto radius = readNumber(document, item.items[2], "an arc's radius", {-1e5, 1e5, false});
    if (!radius) return std::nullopt;
    if (*radius == 0.0) {
      document.error(item.items[2].place, "job-value",
                     "an arc's radius must not be 0; leave it out for a line");
      return std::nullopt;
    }
    point.arc_radius = *radius;
  }
  return point;
}

void readForm(ConfigTable& table, Tool& tool) {
  const std::vector<ConfigValue>* profile = table.must("profile").list("profile", kMostPoints);
  if (profile == nullptr) return;
  for (const ConfigValue& item : *profile) {
    const auto point = readOutlinePoint(table.document(), item);
    if (!point) return;
    tool.outline.push_back(*point);
  }
  const auto edges = outlineEdges(tool.outline);
  if (!edges) return table.error("profile", "job-tool", edges.error().message);
  tool.diameter = outlineDiameter(*edges);
}

/// Points [x, z] of the holder of an insert.
void readInsertHolder(ConfigTable& table, Insert& insert) {
  const std::vector<ConfigValue>* holder = table.list("holder", kMostPoints);
  if (holder == nullptr) return;
  for (const ConfigValue& item : *holder) {
    if (item.type != Type::kArray || item.items.size() != 2) {
      table.document().error(item.place, "job-type",
                             "a point of an insert's holder is [x, z], seen from the control point");
      return;
    }
    const auto x = readNumber(table.document(), item.items[0], "an x of the holder", {-1e5, 1e5, false});
    const auto z = readNumber(table.document(), item.items[1], "a z of the holder", {-1e5, 1e5, false});
    if (!x || !z) return;
    insert.holder.emplace_back(*x, *z);
  }
  if (insert.holder.empty()) table.error("holder", "job-value", "a holder needs at least three points");
}

/// Orientation 9 says where the control point lies; where the insert points to stands beside it.
void readOrientation(ConfigTable& table, Insert& insert) {
  const auto orientation = table.must("orientation").integer("orientation", 1, 9);
  insert.at_center = orientation == 9;
  const char* const key = insert.at_center ? "points_to" : "orientation";
  if (const auto points = table.integer(key, 1, 8)) insert.orientation = static_cast<int>(*points);
}

void readGauge(ConfigTable& table, Insert& insert) {
  const ConfigValue* gauge = table.find("gauge");
  if (gauge == nullptr || !isList(table.document(), *gauge, "gauge")) return;
  if (gauge->items.size() != 2) {
    table.error("gauge", "job-type", "the gauge of an insert is [x, z], X as a radius");
    return;
  }
  const auto x = readNumber(table.document(), gauge->items[0], "x of the gauge", kAnyLength);
  const auto z = readNumber(table.document(), gauge->items[1], "z of the gauge", kAnyLength);
  if (x && z) insert.gauge = Vec2(*x, *z);
}

void readInsert(ConfigTable& table, Tool& tool) {
  constexpr InsertShape kShapes[] = {InsertShape::kCorner, InsertShape::kGroove, InsertShape::kThread,
                                     InsertShape::kRound};
  std::vector<std::string> names;
  for (const InsertShape shape : kShapes) names.emplace_back(insertShapeName(shape));
  Insert& insert = tool.insert.emplace();
  if (table.find("shape") != nullptr) {
    const auto name = table.choice("shape", names);
    if (!name) {  // nothing can be said of the other keys
      for (const ConfigEntry& entry : table.entries()) table.find(entry.key);
      return;
    }
    insert.shape = kShapes[std::find(names.begin(), names.end(), *name) - names.begin()];
  }
  readOrientation(table, insert);
  const bool round = insert.shape == InsertShape::kRound;
  if (round || insert.shape == InsertShape::kCorner) {
    needed(table, "nose_radius", round ? kToolLength : kToolLengthOrZero, insert.nose_radius);
  } else {
    optional(table, "nose_radius", kToolLengthOrZero, insert.nose_radius);
  }
  if (!round) needed(table, "edge_length", kToolLength, insert.edge_length);
  switch (insert.shape) {
    case InsertShape::kCorner:
      needed(table, "insert_angle", kIncludedAngle, insert.insert_angle_deg);
      if (insert.orientation <= 4) needed(table, "lead_angle", kIncludedAngle, insert.lead_angle_deg);
      break;
    case InsertShape::kGroove:
      needed(table, "width", kToolLength, insert.width);
      optional(table, "side_relief", {0.0, 45.0, false}, insert.side_relief_deg);
      break;
    case InsertShape::kThread:
      needed(table, "insert_angle", kIncludedAngle, insert.insert_angle_deg);
      optional(table, "tip_flat", kToolLengthOrZero, insert.tip_flat);
      break;
    case InsertShape::kRound:
      break;
  }
  readGauge(table, insert);
  readInsertHolder(table, insert);
}

void readWire(ConfigTable& table, Tool& tool) {
  needed(table, "diameter", kToolLength, tool.diameter);
  optional(table, "spark_gap", kToolLengthOrZero, tool.spark_gap);
}

struct TypeReader {
  const char* name;
  ToolType type;
  void (*read)(ConfigTable&, Tool&);  ///< keys of this type alone; null: none
  bool own_diameter;                  ///< asks for the diameter itself, or has none
};

constexpr TypeReader kTypes[] = {
    {"flat", ToolType::kFlat, nullptr, false},
    {"ball", ToolType::kBall, nullptr, false},
    {"bull", ToolType::kBull, readBull, false},
    {"cone", ToolType::kCone, readCone, false},
    {"drill", ToolType::kDrill, readDrill, false},
    {"taper", ToolType::kCone, readTaper, true},
    {"dovetail", ToolType::kDovetail, readDovetail, false},
    {"tslot", ToolType::kTSlot, readTSlot, false},
    {"lollipop", ToolType::kLollipop, readLollipop, false},
    {"thread-mill", ToolType::kThreadMill, readThreadMill, false},
    {"form", ToolType::kForm, readForm, true},
    {"insert", ToolType::kInsert, readInsert, true},
    {"wire", ToolType::kWire, readWire, true},
};

void readShape(ConfigTable& table, const TypeReader& type, Tool& tool) {
  tool.type = type.type;
  if (!type.own_diameter) needed(table, "diameter", kToolLength, tool.diameter);
  if (type.read != nullptr) type.read(table, tool);
  if (hasNeck(tool.type)) {
    optional(table, "neck_diameter", kToolLength, tool.neck_diameter);
    optional(table, "neck_length", kToolLength, tool.neck_length);
  } else if (!type.own_diameter) {
    optional(table, "flute_length", kToolLength, tool.flute_length);
  }
}

void readHolder(ConfigTable& table, Tool& tool) {
  const std::vector<ConfigValue>* holder = table.list("holder", kMostPoints);
  if (holder == nullptr) return;
  for (const ConfigValue& item : *holder) {
    if (item.type != Type::kArray || item.items.size() != 2) {
      table.document().error(item.place, "job-type",
                             "a point of a holder is [height above gauge line, radius]");
      return;
    }
    const auto height = readNumber(table.document(), item.items[0], "a holder height", kToolLengthOrZero);
    const auto radius = readNumber(table.document(), item.items[1], "a holder radius", kToolLengthOrZero);
    if (!height || !radius) return;
    tool.holder.emplace_back(*height, *radius);
  }
}

const TypeReader* readType(ConfigTable& table) {
  std::vector<std::string> types;
  for (const TypeReader& type : kTypes) types.emplace_back(type.name);
  const auto name = table.must("type").choice("type", types);
  if (!name) return nullptr;
  const auto at = std::find(types.begin(), types.end(), *name);
  return &kTypes[at - types.begin()];
}

/// What the tool can take. A thread mill's `teeth` are the rings above each other, so it has no feed per
/// tooth here.
ToolLimits readToolLimits(ConfigTable& table, ToolType type) {
  ToolLimits limits;
  assign(limits.max_rpm, table.number("max_rpm", kTopSpeed));
  if (type == ToolType::kThreadMill) return limits;
  const bool feed = table.find("max_feed_per_tooth") != nullptr;
  if (feed) table.require("teeth");
  assign(limits.max_feed_per_tooth, table.number("max_feed_per_tooth", {0.0, 100.0, true}));
  if (const auto teeth = table.integer("teeth", 1, 200)) limits.teeth = static_cast<int>(*teeth);
  return limits;
}

/// `numbers`: of the tools before this one.
void readTool(ConfigTable& table, std::unordered_set<int>& numbers, Job& job) {
  Tool tool;
  const auto number = table.must("number").integer("number", 1, kMaxToolNumber);
  const TypeReader* const type = readType(table);
  if (type == nullptr) return;
  const int errors_before = table.document().diagnostics->errorCount();
  ToolLimits limits;
  readShape(table, *type, tool);
  if (const auto name = table.text("name")) tool.name = *name;
  if (rowOf(tool.type).rotates) {
    assign(tool.overall_length, table.number("overall_length", kToolLength));
    assign(tool.shank_diameter, table.number("shank_diameter", kToolLength));
    assign(tool.gauge_length, table.number("gauge_length", {-1e5, 1e5, false}));
    if (const auto hand = table.choice("hand", {"right", "left"})) tool.left_hand = *hand == "left";
    readHolder(table, tool);
    limits = readToolLimits(table, tool.type);
  }
  table.refuseOthers();
  if (!number || table.document().diagnostics->errorCount() != errors_before) return;

  tool.number = static_cast<int>(*number);
  if (const Status valid = validateTool(tool); !valid) {
    table.document().error(table.place(), "job-tool", valid.error().message);
    return;
  }
  if (!numbers.insert(tool.number).second) {
    table.error("number", "job-value", fmt::format("there are two tools with number {}", tool.number));
    return;
  }
  if (limits.max_rpm > 0.0 || limits.max_feed_per_tooth > 0.0) job.limits.tools[tool.number] = limits;
  if (tool.gauge_length != 0.0) job.settings.gauge_lengths[tool.number] = tool.gauge_length;
  job.tools.push_back(std::move(tool));
}

void readWork(ConfigTable& offsets, Job& job) {
  auto work = offsets.table("work");
  if (!work) return;
  for (const ConfigEntry& entry : work->entries()) {
    if (entry.key == "common") {
      if (const auto p = work->point("common")) job.settings.common_offset = *p;
      continue;
    }
    const auto index = workOffsetIndex(entry.key);
    if (!index) {
      offsets.document().error(
          entry.place, "job-unknown-key",
          fmt::format(
              "'{}' is no work offset; there are G54 to G59, \"G54.1 P1\" to \"G54.1 P99\" and common",
              shortened(entry.key)));
      continue;
    }
    const auto point = readPoint(offsets.document(), entry.value, entry.key, kAnyLength);
    if (!point) continue;
    if (*index >= 0) {
      job.settings.work_offsets[static_cast<std::size_t>(*index)] = *point;
      job.settings.work_given[static_cast<std::size_t>(*index)] = true;
    } else {
      job.settings.extended_offsets[-*index] = *point;
    }
  }
}

void readRotations(ConfigTable& offsets, Job& job) {
  auto rotation = offsets.table("rotation");
  if (!rotation) return;
  for (std::size_t i = 0; i < job.settings.work_rotations_deg.size(); ++i) {
    const auto angles = rotation->point(fmt::format("G{}", 54 + i), kAngle);
    if (angles) job.settings.work_rotations_deg[i] = *angles;
  }
  rotation->refuseOthers();
}

/// Rows `1 = 0.5` or `1 = { geometry = 0.5, wear = -0.01 }`.
void readRows(ConfigTable& offsets, const std::string& key, std::map<int, OffsetValue>& rows) {
  auto table = offsets.table(key);
  if (!table) return;
  const ConfigDocument& document = offsets.document();
  for (const ConfigEntry& entry : table->entries()) {
    const auto number = plainNumber(entry.key, kMaxOffsetNumber);
    if (!number) {
      document.error(entry.place, "job-unknown-key",
                     fmt::format("'{}' is no row of the offset table; rows are numbers from 1 to {}",
                                 shortened(entry.key), kMaxOffsetNumber));
      continue;
    }
    OffsetValue row;
    if (entry.value.type == Type::kTable) {
      ConfigTable parts(document, entry.value, fmt::format("[offsets.{}] {}", key, *number));
      assign(row.geometry, parts.number("geometry", kAnyLength));
      assign(row.wear, parts.number("wear", kAnyLength));
      parts.refuseOthers();
    } else {
      assign(row.geometry, readNumber(document, entry.value, entry.key, kAnyLength));
    }
    rows[*number] = row;
  }
}

}  // namespace

void readTools(ConfigTable& root, Job& job) {
  std::unordered_set<int> numbers;
  for (const Tool& tool : job.tools) numbers.insert(tool.number);
  for (ConfigTable& table : root.tables("tool")) readTool(table, numbers, job);
}

void readPlacement(ConfigTable& root, Job& job) {
  auto placement = root.table("placement");
  if (!placement) return;
  constexpr NumberRange kTurn{-360.0, 360.0, false};
  WorkpiecePlacement& place = job.settings.placement;
  if (const auto origin = placement->point("origin")) place.origin = *origin;
  if (const auto turn = placement->number("rotation", kTurn)) place.rotation_deg = *turn;
  placement->refuseOthers();
}

void readOffsets(ConfigTable& root, Job& job) {
  auto offsets = root.table("offsets");
  if (!offsets) return;
  readWork(*offsets, job);
  readRotations(*offsets, job);
  readRows(*offsets, "length", job.settings.length_offsets);
  readRows(*offsets, "radius", job.settings.radius_offsets);
  offsets->refuseOthers();
}

}  // namespace proveout
