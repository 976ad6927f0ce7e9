// Tools and offset tables of a job file.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/job_sections.h"

namespace proveout {

using Type = ConfigValue::Type;

namespace {

constexpr int kMaxToolNumber = 99'999'999;
constexpr int kMaxOffsetNumber = 9999;
constexpr NumberRange kToolLength{0.0, 1e5, true};
constexpr NumberRange kToolLengthOrZero{0.0, 1e5, false};
constexpr NumberRange kIncludedAngle{0.0, 179.9, true};
constexpr NumberRange kAngle{-360.0, 360.0, false};

/// Types that job files name and that this version does not simulate.
const std::vector<std::string>& unsupportedTypes() {
  static const std::vector<std::string> kTypes = {"dovetail", "tslot",  "thread-mill",
                                                  "form",     "insert", "wire"};
  return kTypes;
}

void assign(double& target, const std::optional<double>& value) {
  if (value) target = *value;
}

/// A taper is a cone that its maker gives by the tip and the angle of one side. Where no diameter is given,
/// the cone goes on to the end of the flutes.
void readTaper(ConfigTable& table, Tool& tool) {
  tool.type = ToolType::kCone;
  assign(tool.tip_diameter, table.must("tip_diameter").number("tip_diameter", kToolLengthOrZero));
  const auto side = table.must("taper_angle").number("taper_angle", {0.0, 89.9, true});
  if (!side) return;
  tool.cone_angle_deg = 2.0 * *side;
  if (table.find("diameter") != nullptr) return;
  if (tool.flute_length <= 0.0) {
    table.error("type", "job-missing", "a taper needs diameter or flute_length");
    return;
  }
  tool.diameter = tool.tip_diameter + 2.0 * tool.flute_length * std::tan(degToRad(*side));
}

void readShape(ConfigTable& table, const std::string& type, Tool& tool) {
  assign(tool.flute_length, table.number("flute_length", kToolLength));
  assign(tool.diameter, table.number("diameter", kToolLength));
  if (type != "taper") table.require("diameter");
  if (type == "flat") tool.type = ToolType::kFlat;
  if (type == "ball") tool.type = ToolType::kBall;
  if (type == "bull") {
    tool.type = ToolType::kBull;
    assign(tool.corner_radius, table.must("corner_radius").number("corner_radius", kToolLengthOrZero));
  }
  if (type == "cone") {
    tool.type = ToolType::kCone;
    assign(tool.tip_diameter, table.number("tip_diameter", kToolLengthOrZero));
    assign(tool.cone_angle_deg, table.must("cone_angle").number("cone_angle", kIncludedAngle));
  }
  if (type == "drill") {
    tool.type = ToolType::kDrill;
    assign(tool.point_angle_deg, table.number("point_angle", kIncludedAngle));
  }
  if (type == "taper") readTaper(table, tool);
}

void readHolder(ConfigTable& table, Tool& tool) {
  const ConfigValue* holder = table.find("holder");
  if (holder == nullptr || !isList(table.document(), *holder, "holder")) return;
  for (const ConfigValue& item : holder->items) {
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

std::optional<std::string> readType(ConfigTable& table) {
  const std::vector<std::string> types = {"flat", "ball", "bull", "cone", "drill", "taper"};
  const auto text = table.must("type").text("type");
  if (!text) return std::nullopt;
  const auto& refused = unsupportedTypes();
  if (std::find(refused.begin(), refused.end(), *text) != refused.end()) {
    table.error("type", "job-unsupported",
                fmt::format("tools of type '{}' cannot be simulated by this version; there are {}", *text,
                            fmt::join(types, ", ")));
    return std::nullopt;
  }
  return table.choice("type", types);
}

void readTool(ConfigTable& table, Job& job) {
  Tool tool;
  const auto number = table.must("number").integer("number", 1, kMaxToolNumber);
  const auto type = readType(table);
  if (!type) return;
  const int errors_before = table.document().diagnostics->errorCount();
  readShape(table, *type, tool);
  if (const auto name = table.text("name")) tool.name = *name;
  assign(tool.overall_length, table.number("overall_length", kToolLength));
  assign(tool.shank_diameter, table.number("shank_diameter", kToolLength));
  assign(tool.gauge_length, table.number("gauge_length", {-1e5, 1e5, false}));
  readHolder(table, tool);
  table.refuseOthers();
  if (!number || table.document().diagnostics->errorCount() != errors_before) return;

  tool.number = static_cast<int>(*number);
  if (const Status valid = validateTool(tool); !valid) {
    table.document().error(table.place(), "job-tool", valid.error().message);
    return;
  }
  for (const Tool& other : job.tools) {
    if (other.number == tool.number) {
      table.error("number", "job-value", fmt::format("there are two tools with number {}", tool.number));
      return;
    }
  }
  if (tool.gauge_length != 0.0) job.settings.gauge_lengths[tool.number] = tool.gauge_length;
  job.tools.push_back(std::move(tool));
}

/// A key that is a number from 1 to `max`, without sign or leading zeros.
std::optional<int> keyNumber(const std::string& key, int max) {
  int number = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  const bool plain = error == std::errc{} && end == key.data() + key.size() && key.front() != '0';
  if (!plain || number < 1 || number > max) return std::nullopt;
  return number;
}

/// Index of G54..G59, or P of "G54.1 P7" as a negative number.
std::optional<int> workOffsetIndex(const std::string& key) {
  if (key.size() == 3 && key.starts_with("G5") && key[2] >= '4' && key[2] <= '9') return key[2] - '4';
  if (key.starts_with("G54.1 P")) {
    if (const auto p = keyNumber(key.substr(7), 99)) return -*p;
  }
  return std::nullopt;
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
              entry.key));
      continue;
    }
    const auto point = readPoint(offsets.document(), entry.value, entry.key, kAnyLength);
    if (!point) continue;
    if (*index >= 0) {
      job.settings.work_offsets[static_cast<std::size_t>(*index)] = *point;
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
    const auto number = keyNumber(entry.key, kMaxOffsetNumber);
    if (!number) {
      document.error(entry.place, "job-unknown-key",
                     fmt::format("'{}' is no row of the offset table; rows are numbers from 1 to {}",
                                 entry.key, kMaxOffsetNumber));
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
  root.require("tool");
  for (ConfigTable& table : root.tables("tool")) readTool(table, job);
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
