// Machine, stock, nominal, simulation and output of a job file.
#include "io/job/job_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>

#include "core/base/printable.h"
#include "io/atomic_file.h"
#include "io/job/machine_events.h"
#include "io/job/machine_file.h"
#include "io/step/step_file.h"

namespace proveout {

using Type = ConfigValue::Type;

namespace {

constexpr std::size_t kMaxMachineBytes = 1u << 20;
constexpr NumberRange kDuration{0.0, 1e6, false};  // s

void readLimits(ConfigTable& machine, Job& job) {
  auto limits = machine.table("limits");
  if (!limits) return;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "XYZ"[axis]);
    if (limits->find(name) == nullptr) continue;
    if (const auto limit = readLimit(*limits, name)) job.settings.limits[axis] = *limit;
  }
  limits->refuseOthers();
}

/// Ends of axes where the control's range B is in force: ["Z+"].
void readRangeB(ConfigTable& machine, Job& job) {
  if (const auto sides = machine.texts("range_b")) job.settings.stroke_range_b = *sides;
}

void readRapid(ConfigTable& machine, Job& job) {
  const ConfigValue* rapid = machine.find("rapid");
  if (rapid == nullptr) return;
  job.settings.rapid_by_default = false;
  if (rapid->type == Type::kArray) {
    if (const auto rates = machine.point("rapid", kRate)) job.settings.rapid_mm_min = *rates;
  } else if (const auto rate = machine.number("rapid", kRate)) {
    job.settings.rapid_mm_min = Vec3::Constant(*rate);
  }
}

/// Accelerations: one for X, Y, Z alike or one each.
void readAcceleration(ConfigTable& machine, Job& job) {
  const ConfigValue* given = machine.find("acceleration");
  if (given == nullptr) return;
  if (given->type == Type::kArray) {
    if (const auto each = machine.point("acceleration", kAcceleration))
      job.settings.acceleration_mm_s2 = *each;
  } else if (const auto all = machine.number("acceleration", kAcceleration)) {
    job.settings.acceleration_mm_s2 = Vec3::Constant(*all);
  }
}

/// `tool_change = [x, y, z]`, or a table that names the axes that move.
void readToolChange(ConfigTable& machine, Job& job) {
  const ConfigValue* given = machine.find("tool_change");
  if (given == nullptr) return;
  ToolChangePlace& place = job.settings.tool_change;
  if (given->type == Type::kArray) {
    const auto point = machine.point("tool_change");
    if (!point) return;
    place.x = point->x();
    place.y = point->y();
    place.z = point->z();
    return;
  }
  if (given->type != Type::kTable) {
    machine.error("tool_change", "job-type",
                  "tool_change must be a list of three numbers, [x, y, z], or a table of axes, { Z = 300 }");
    return;
  }
  auto axes = machine.table("tool_change");
  if (axes->entries().empty())
    machine.error("tool_change", "job-value", "tool_change names no axis: give X, Y or Z, as { Z = 300 }");
  const std::pair<const char*, std::optional<double>*> keys[] = {
      {"X", &place.x}, {"Y", &place.y}, {"Z", &place.z}};
  for (const auto& [key, value] : keys) {
    if (const auto number = axes->number(key, kAnyLength)) *value = *number;
  }
  axes->refuseOthers();
}

void readReferencePoints(ConfigTable& machine, Job& job) {
  const ConfigValue* points = machine.find("reference_points");
  if (points == nullptr || !isList(machine.document(), *points, "reference_points")) return;
  if (points->items.size() > job.settings.reference_points.size()) {
    machine.error("reference_points", "job-range", "there are at most four reference points");
    return;
  }
  for (std::size_t i = 0; i < points->items.size(); ++i) {
    job.settings.reference_points[i] =
        readPoint(machine.document(), points->items[i], fmt::format("reference point {}", i + 1), kAnyLength);
  }
}

void readAxis(ConfigTable& table, Job& job) {
  AxisSettings axis;
  const std::vector<std::string> kinds{"linear", "rotary"};
  if (const auto name = table.must("name").text("name")) axis.name = *name;
  if (const auto number = table.must("number").integer("number", 1, 32))
    axis.number = static_cast<int>(*number);
  if (const auto kind = table.choice("kind", kinds))
    axis.kind = *kind == "linear" ? AxisKind::kLinear : AxisKind::kRotary;
  const bool main = axis.name == "X" || axis.name == "Y" || axis.name == "Z";
  if (main) axis.kind = AxisKind::kLinear;
  if (const auto parallel = table.choice("parallel", {"X", "Y", "Z"})) axis.parallel = *parallel;
  if (const auto rapid = table.number("rapid", kRate)) axis.rapid = *rapid;
  if (const auto a = table.number("acceleration", kAcceleration)) axis.acceleration = *a;
  if (const auto start = table.number("start", kAnyLength)) axis.start = *start;
  if (const auto reference = table.number("reference", kAnyLength)) axis.reference = *reference;
  if (table.find("limits")) axis.limit = readLimit(table, "limits");
  if (const auto carries = table.choice("carries", {"part", "nothing"})) {
    axis.carries = *carries == "part" ? RotaryCarries::kPart : RotaryCarries::kNothing;
  }
  axis.direction = table.point("direction");
  axis.center = table.point("center");
  table.refuseOthers();
  job.settings.axes.push_back(std::move(axis));
}

void readSpindle(ConfigTable& table, Job& job) {
  constexpr NumberRange kSpeed{0.0, 1e8, false};
  SpindleSettings spindle;
  const auto code = [&](const char* key, int& out) {
    if (const auto m = table.integer(key, 1, 99999999)) out = static_cast<int>(*m);
  };
  if (const auto number = table.must("number").integer("number", 1, 16))
    spindle.number = static_cast<int>(*number);
  if (const auto name = table.text("name")) spindle.name = *name;
  if (const auto a = table.number("acceleration", kSpeed)) spindle.acceleration = *a;
  if (const auto top = table.number("top", kSpeed)) spindle.top_rpm = *top;
  if (const auto rpm = table.number("positioning", {0.0, 1e6, true})) spindle.positioning_rpm = *rpm;
  if (const auto name = table.text("position_name")) spindle.position_name = *name;
  if (const auto axis = table.text("axis")) spindle.axis = *axis;
  code("main_code", spindle.main_code);
  code("sync_code", spindle.sync_code);
  code("shift_code", spindle.shift_code);
  code("axis_code", spindle.axis_code);
  for (ConfigTable& range : table.tables("range")) {
    const auto low = range.must("min").number("min", kSpeed);
    const auto high = range.must("max").number("max", kSpeed);
    if (low && high) spindle.ranges.push_back({*low, *high});
    range.refuseOthers();
  }
  table.refuseOthers();
  job.settings.spindles.push_back(std::move(spindle));
}

/// Axes and spindles as lists of what the control sees of them.
void readAxesAndSpindles(ConfigTable& machine, Job& job) {
  const ConfigValue* spindle = machine.find("spindle");
  if (machine.find("body") != nullptr || (spindle != nullptr && spindle->type == Type::kTable)) {
    machine.error(
        spindle != nullptr ? "spindle" : "body", "job-missing",
        fmt::format("a machine with [spindle] and [[body]] begins with schema = \"{}\"", kMachineSchema));
    machine.find("axis");
    return;
  }
  std::vector<ConfigTable> axes = machine.tables("axis");
  if (!axes.empty()) {  // the job's axes stand for those of the machine's file
    job.settings.axes.clear();
    job.settings.machine.reset();
  }
  for (ConfigTable& axis : axes) readAxis(axis, job);
  std::vector<ConfigTable> spindles = machine.tables("spindle");
  if (!spindles.empty()) job.settings.spindles.clear();
  for (ConfigTable& one : spindles) readSpindle(one, job);
}

/// The keys that the job's table and the machine's own file share.
void readMachineKeys(ConfigTable& machine, Job& job) {
  readRapid(machine, job);
  readAcceleration(machine, job);
  if (const auto time = machine.number("acceleration_rise_s", {0.0, 100.0})) job.settings.bell_time_s = *time;
  if (const auto start = machine.point("start")) job.start = *start;
  readReferencePoints(machine, job);
  readToolChange(machine, job);
  if (const auto time = machine.number("tool_change_s", kDuration)) job.settings.tool_change_s = *time;
  if (const auto rpm = machine.number("default_spindle", {0.0, 1e6, true})) {
    job.settings.default_spindle_rpm = *rpm;
  }
  if (const auto feed = machine.number("max_feed", kRate)) job.limits.max_feed = *feed;
  if (const auto rpm = machine.number("max_rpm", kTopSpeed)) job.limits.max_rpm = *rpm;
  readLimits(machine, job);
  readRangeB(machine, job);
  if (machine.find("schema") != nullptr) {
    readMachineModel(machine, job);
  } else {
    readAxesAndSpindles(machine, job);
  }
  readMachineEvents(machine, job.settings);
  machine.refuseOthers();
}

MeshUnit readUnit(ConfigTable& table) {
  const auto name = table.choice("unit", {"mm", "inch", "m"});
  if (!name) return MeshUnit::kMillimetre;
  const Result<MeshUnit> unit = parseMeshUnit(*name);
  return unit ? *unit : MeshUnit::kMillimetre;
}

std::optional<StockSpec> readBox(ConfigTable& stock) {
  const auto min = stock.must("min").point("min");
  const auto max = stock.must("max").point("max");
  if (!min || !max) return std::nullopt;
  if ((min->array() >= max->array()).any()) {
    stock.error("max", "job-range", "max must be above min in x, y and z");
    return std::nullopt;
  }
  return BoxShape{*min, *max};
}

/// `radius` or `diameter` (with `prefix` before it), as a radius.
std::optional<double> readRadius(ConfigTable& stock, const std::string& prefix) {
  const std::string radius_key = prefix + "radius", diameter_key = prefix + "diameter";
  const bool both = stock.find(radius_key) != nullptr && stock.find(diameter_key) != nullptr;
  const auto radius = stock.number(radius_key, kPositiveLength);
  const auto diameter = stock.number(diameter_key, kPositiveLength);
  if (both) {
    stock.error(radius_key, "job-value", fmt::format("give {} or {}, not both", radius_key, diameter_key));
  } else if (stock.find(radius_key) == nullptr) {
    stock.require(diameter_key);
  }
  if (radius) return radius;
  if (diameter) return 0.5 * *diameter;
  return std::nullopt;
}

std::optional<StockSpec> readCylinder(ConfigTable& stock, bool tube) {
  CylinderShape shape;
  if (const auto axis = stock.choice("axis", {"x", "y", "z"})) shape.axis = (*axis)[0] - 'x';
  if (const auto base = stock.must("base").point("base")) shape.base = *base;
  if (const auto length = stock.must("length").number("length", kPositiveLength)) shape.length = *length;
  if (const auto radius = readRadius(stock, "")) shape.radius = *radius;
  if (tube) {
    if (const auto inner = readRadius(stock, "inner_")) shape.inner_radius = *inner;
    if (shape.radius > 0.0 && shape.inner_radius >= shape.radius) {
      stock.error("shape", "job-range", "the tube's inner radius must be below its radius");
    }
  }
  return shape;
}

}  // namespace

std::optional<AxisLimit> readLimit(ConfigTable& table, const std::string& name) {
  const ConfigValue* value = table.find(name);
  if (value->type != Type::kArray || value->items.size() != 2) {
    table.error(name, "job-type", name + " must be a list of two numbers, [low, high]");
    return std::nullopt;
  }
  const auto low = readNumber(table.document(), value->items[0], name + " low", kAnyLength);
  const auto high = readNumber(table.document(), value->items[1], name + " high", kAnyLength);
  if (!low || !high) return std::nullopt;
  if (*low >= *high) {
    table.error(name, "job-range", name + ": the low limit must be below the high one");
    return std::nullopt;
  }
  return AxisLimit{*low, *high};
}

void loadMachine(const std::string& path, Job& job, Diagnostics& diagnostics) {
  const Result<std::string> text = readWholeFile(path, kMaxMachineBytes);
  if (!text) {
    Diagnostic d;
    d.code = "job-file";
    d.message = text.error().message;
    diagnostics.add(std::move(d));
    return;
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const ConfigDocument document{splitConfigText(path, *text), folder, &diagnostics};
  const auto tree = parseToml(*text, document.text, diagnostics);
  if (!tree) return;
  job.machine_file = path;
  if (tree->entries.empty())
    return document.error(
        {}, "job-missing",
        fmt::format("{} says nothing: see docs/reference/job-machine.md for its keys", path));
  // Its keys stand at the top, or all in a table of their own as in a job.
  const bool apart = tree->entries.size() == 1 && tree->entries[0].key == "machine" &&
                     tree->entries[0].value.type == Type::kTable;
  ConfigTable machine(document, apart ? tree->entries[0].value : *tree, "the machine file");
  readMachineKeys(machine, job);
}

void readMachine(ConfigTable& root, Job& job) {
  auto machine = root.table("machine");
  if (!machine) return;
  // Keys of the job come after those of the file, so that a job can change one of them.
  if (const auto file = machine->path("file")) {
    job.machine_file = *file;
    loadMachine(*file, job, *root.document().diagnostics);
  }
  readMachineKeys(*machine, job);
}

namespace {

/// `body` of a STEP file: "name" or a number from 1.
std::string readBody(ConfigTable& table, bool step) {
  const ConfigValue* body = table.find("body");
  if (body == nullptr) return {};
  if (!step) {
    table.error("body", "job-value", "`body` names a body of a STEP file; this is a mesh");
    return {};
  }
  if (body->type == Type::kInteger) return fmt::format("{}", table.integer("body", 1, 100'000).value_or(1));
  return table.text("body").value_or("");
}

/// "3MF" of "part.3mf".
std::string formatOf(const std::string& file) {
  std::string ending = file.substr(file.rfind('.') + 1);
  for (char& c : ending) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return ending == "STP" ? "STEP" : ending;
}

/// The file at `key` with its unit and body.
std::optional<MeshFile> readModel(ConfigTable& table, const std::string& key) {
  const auto file = table.must(key).path(key);
  const bool step = file && isStepFile(*file), has_unit = table.find("unit") != nullptr;
  const bool stated = file && statesUnit(*file);
  const MeshUnit unit = readUnit(table);
  const std::string body = readBody(table, step);
  if (!file) return std::nullopt;
  if (stated && has_unit)
    table.error("unit", "job-value",
                fmt::format("a {} file states its unit itself: leave `unit` out", formatOf(*file)));
  if (const Status reader = step ? checkStepReader() : Status(Done{}); !reader)
    table.error(key, "step-reader", reader.error().message);
  return MeshFile{*file, unit, body};
}

}  // namespace

std::optional<StockSpec> readMeshFile(ConfigTable& table, const std::string& key) {
  const std::optional<MeshFile> file = readModel(table, key);
  if (!file) return std::nullopt;
  return StockSpec(*file);
}

std::optional<StockSpec> readShape(ConfigTable& table, const std::vector<std::string>& shapes) {
  const auto shape = table.must("shape").choice("shape", shapes);
  if (!shape) return std::nullopt;
  if (*shape == "box") return readBox(table);
  if (*shape == "cylinder" || *shape == "tube") return readCylinder(table, *shape == "tube");
  if (*shape == "mesh") return readMeshFile(table, "file");
  const auto file = table.must("file").path("file");
  if (!file) return std::nullopt;
  return SavedStock{*file};
}

void readStock(ConfigTable& root, Job& job) {
  root.require("stock");
  auto stock = root.table("stock");
  if (!stock) return;
  job.stock = readShape(*stock, {"box", "cylinder", "tube", "mesh", "vdb"});
  readStartHoles(*stock, job);
  job.part_point = stock->point("part_point");
  stock->refuseOthers();
}

/// `z = [a, b]`, `radius = [a, b]`: two numbers, the first below the second.
std::optional<Vec2> readRange(ConfigTable& table, const char* key, const NumberRange& range) {
  const ConfigValue* value = table.find(key);
  if (value == nullptr) return std::nullopt;
  if (value->type != Type::kArray || value->items.size() != 2) {
    table.error(key, "job-type", fmt::format("{} is a list of two numbers, the lower one first", key));
    return std::nullopt;
  }
  const auto low = readNumber(table.document(), value->items[0], key, range);
  const auto high = readNumber(table.document(), value->items[1], key, range);
  if (!low || !high) return std::nullopt;
  if (*low >= *high) {
    table.error(key, "job-value", fmt::format("the first number of {} must be below the second", key));
    return std::nullopt;
  }
  return Vec2(*low, *high);
}

std::optional<IgnoredRegion> readRegion(ConfigTable& table, const char* key) {
  IgnoredRegion region;
  const auto min = table.point("min"), max = table.point("max");
  const auto z = readRange(table, "z", {-1e5, 1e5, false}),
             radius = readRange(table, "radius", {0.0, 1e5, false});
  if (min) region.box.min = *min;
  if (max) region.box.max = *max;
  if (z) {
    region.box.min.z() = z->x();
    region.box.max.z() = z->y();
  }
  if (radius) {
    region.inner_radius = radius->x();
    region.outer_radius = radius->y();
  }
  const bool box = table.find("min") != nullptr && table.find("max") != nullptr;
  const bool round = table.find("z") != nullptr;
  if (box == round) table.error(key, "job-missing", "a region is given by min and max or by z (and radius)");
  if (box && min && max && (min->array() >= max->array()).any())
    table.error("max", "job-value", "every max must be above its min");
  return box == round ? std::nullopt : std::optional(region);
}

bool hasRegion(ConfigTable& table) {
  for (const char* key : {"min", "max", "z", "radius"})
    if (table.find(key) != nullptr) return true;
  return false;
}

void readIgnored(ConfigTable& table, NominalSpec& nominal) {
  const auto name = table.must("name").text("name");
  IgnoredRegion region = readRegion(table, "name").value_or(IgnoredRegion{});
  if (name) region.name = *name;
  for (const IgnoredRegion& other : nominal.ignored) {
    if (other.name == region.name)
      table.error("name", "job-value", fmt::format("there are two regions '{}'", region.name));
  }
  table.refuseOthers();
  nominal.ignored.push_back(std::move(region));
}

/// Tolerances of some faces, or of a region.
void readLocalTolerance(ConfigTable& table, NominalSpec& nominal) {
  LocalTolerance local;
  static const std::vector<std::string> kKinds = {"plane", "cylinder", "cone", "sphere", "torus", "other"};
  if (const auto kind = table.choice("kind", kKinds))
    local.kind = static_cast<SurfaceKind>(std::find(kKinds.begin(), kKinds.end(), *kind) - kKinds.begin());
  if (const auto face = table.text("face")) local.face = *face;
  const bool by_face = table.find("kind") != nullptr || table.find("face") != nullptr;
  const bool by_place = hasRegion(table);
  if (by_place) local.region = readRegion(table, "gouge");
  if (!by_face && !by_place)
    table.error("gouge", "job-missing",
                "a tolerance of its own is for a kind of face, a face by its name, or a region");
  local.gouge_mm = table.number("gouge", kPositiveLength).value_or(nominal.gouge_mm);
  local.excess_mm = table.number("excess", kPositiveLength).value_or(nominal.excess_mm);
  if (table.find("gouge") == nullptr && table.find("excess") == nullptr)
    table.error("gouge", "job-missing", "a tolerance of its own has `gouge`, `excess` or both");
  table.refuseOthers();
  nominal.local.push_back(std::move(local));
}

void readNominal(ConfigTable& root, Job& job) {
  constexpr NumberRange kScale{1e-6, 1e6, false}, kDegrees{-360.0, 360.0, false};
  auto table = root.table("nominal");
  if (!table) return;
  NominalSpec nominal;
  if (const auto mesh = readModel(*table, "mesh")) nominal.mesh = *mesh;
  if (const auto scale = table->number("scale", kScale)) nominal.placement.scale = *scale;
  if (const auto turn = table->point("rotate", kDegrees)) nominal.placement.rotate_deg = *turn;
  if (const auto move = table->point("move")) nominal.placement.move = *move;
  if (const auto gouge = table->number("gouge", kPositiveLength)) nominal.gouge_mm = *gouge;
  if (const auto excess = table->number("excess", kPositiveLength)) nominal.excess_mm = *excess;
  for (ConfigTable& region : table->tables("ignore", 1'000)) readIgnored(region, nominal);
  for (ConfigTable& local : table->tables("tolerance", 1'000)) readLocalTolerance(local, nominal);
  readAlignment(*table, nominal);
  readFeatureKeys(*table, nominal);
  table->refuseOthers();
  job.nominal = std::move(nominal);
}

void readInterrupts(ConfigTable& root, ConfigTable& panel, Job& job) {
  const std::vector<ConfigValue>* blocks = panel.list("interrupt_blocks", kMostTables);
  if (blocks == nullptr) return;
  job.settings.interrupt_blocks.clear();
  constexpr std::int64_t kMaxBlock = 99'999'999;
  for (const ConfigValue& item : *blocks) {
    if (item.type == Type::kInteger && item.integer >= 0 && item.integer <= kMaxBlock) {
      job.settings.interrupt_blocks.push_back(item.integer);
    } else {
      root.document().error(item.place, "job-range", "interrupt_blocks lists N numbers, 0 to 99999999");
    }
  }
}

/// Answers to message boxes by their number.
void readAnswers(ConfigTable& panel, Job& job) {
  auto answers = panel.table("answers");
  if (!answers) return;
  constexpr int kFirstBox = 100, kLastBox = 299;
  for (const ConfigEntry& entry : answers->entries()) {
    int number = 0;
    const char* end = entry.key.data() + entry.key.size();
    const auto [last, error] = std::from_chars(entry.key.data(), end, number);
    if (error != std::errc() || last != end || number < kFirstBox || number > kLastBox) {
      answers->document().error(entry.value.place, "job-range", "answers go to message boxes 100 to 299");
      continue;
    }
    if (const auto answer = answers->integer(entry.key, 0, 3)) {
      job.person.message_answers[number] = static_cast<int>(*answer);
    }
  }
}

/// Inputs of the PLC: `plc_bits = [0, 5]` lists those that are on.
void readInputs(ConfigTable& root, ConfigTable& panel, Job& job) {
  const ConfigValue* bits = panel.find("plc_bits");
  if (bits != nullptr && isList(root.document(), *bits, "plc_bits")) {
    job.person.plc_bits = {};
    for (const ConfigValue& item : bits->items) {
      if (item.type == Type::kInteger && item.integer >= 0 && item.integer <= 31) {
        job.person.plc_bits[static_cast<std::size_t>(item.integer)] = true;
      } else {
        root.document().error(item.place, "job-range", "plc_bits lists inputs, whole numbers from 0 to 31");
      }
    }
  }
  if (const auto numbers = panel.point("plc_numbers", {-1e9, 1e9, false})) {
    job.person.plc_numbers = {numbers->x(), numbers->y(), numbers->z()};
  }
}

/// What the person at the machine answers and what clocks show.
void readPerson(ConfigTable& root, ConfigTable& panel, Job& job) {
  readAnswers(panel, job);
  readInputs(root, panel, job);
  constexpr std::int64_t kFirstDate = 19000101, kLastDate = 99991231, kLastTime = 235959;
  if (const auto date = panel.integer("date", kFirstDate, kLastDate))
    job.person.date = static_cast<int>(*date);
  if (const auto time = panel.integer("time", 0, kLastTime)) job.person.time = static_cast<int>(*time);
  if (const auto test = panel.flag("test_mode")) job.person.test_mode = *test;
}

void readPanel(ConfigTable& root, Job& job) {
  auto panel = root.table("panel");
  if (!panel) return;
  if (const auto stop = panel->flag("optional_stop")) job.settings.optional_stop = *stop;
  const ConfigValue* skip = panel->find("block_skip");
  if (skip != nullptr && isList(root.document(), *skip, "block_skip")) {
    job.settings.skip_switches = {};
    for (const ConfigValue& item : skip->items) {
      if (item.type == Type::kInteger && item.integer >= 1 && item.integer <= 9) {
        job.settings.skip_switches[static_cast<std::size_t>(item.integer) - 1] = true;
      } else {
        root.document().error(item.place, "job-range",
                              "block_skip lists switches, whole numbers from 1 to 9");
      }
    }
  }
  readInterrupts(root, *panel, job);
  readPerson(root, *panel, job);
  panel->refuseOthers();
}

const std::vector<std::string>& causeSearchNames() {
  static const std::vector<std::string> names = {"off", "fast", "proven"};  // in the order of CauseSearch
  return names;
}

std::optional<CauseSearch> causeSearchNamed(std::string_view name) {
  const auto& names = causeSearchNames();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) return std::nullopt;
  return static_cast<CauseSearch>(at - names.begin());
}

void readSimulation(ConfigTable& root, Job& job) {
  auto table = root.table("simulation");
  if (!table) return;
  // Below a micron the grid's single-precision distances carry no information.
  if (const auto mm = table->number("resolution", {1e-3, 1e3, false})) job.simulation.resolution_mm = *mm;
  if (const auto mm = table->number("contact", {0.0, 10.0, false})) job.simulation.contact_mm = *mm;
  if (const auto mm = table->number("profile_resolution", {1e-3, 1.0, false}))
    job.simulation.profile_resolution_mm = *mm;
  if (const auto mm = table->number("simplify", {0.0, 10.0, false})) job.simulation.simplify_mm = *mm;
  if (const auto causes = table->choice("causes", causeSearchNames()))
    job.simulation.causes = causeSearchNamed(*causes).value_or(CauseSearch::kProven);
  if (const auto threads = table->integer("threads", 0, 4096)) {
    job.simulation.threads = static_cast<int>(*threads);
  }
  if (const auto memory = table->number("max_memory_gb", {0.0, 1e6, true})) {
    job.simulation.max_memory_gb = *memory;
  }
  if (const auto time = table->number("max_time_s", {0.0, 1e9, true})) job.simulation.max_time_s = *time;
  if (const auto blocks = table->integer("max_blocks", 1, std::numeric_limits<std::int64_t>::max())) {
    job.settings.block_limit = static_cast<std::uint64_t>(*blocks);
  }
  if (const auto lenient = table->flag("lenient")) job.settings.lenient = *lenient;
  table->refuseOthers();
}

namespace {

/// Heights of section drawings: at most 100.
void readSections(ConfigTable& output, Job& job) {
  constexpr std::size_t kMostSections = 100;
  const std::vector<ConfigValue>* heights = output.list("sections", kMostSections);
  if (heights == nullptr) return;
  for (const ConfigValue& height : *heights) {
    const bool number = height.type == Type::kInteger || height.type == Type::kNumber;
    if (number && std::isfinite(height.number)) {
      job.output.sections.push_back(height.number);
      continue;
    }
    output.error("sections", "job-type", "sections must be a list of heights in mm, like [0.5, 10]");
    return;
  }
}

/// What is written of deviations. `compares`: the job has a nominal.
void readDeviation(ConfigTable& output, bool compares, Job& job) {
  const auto names = output.texts("deviation");
  if (!names) return;
  if (!compares && !names->empty())
    output.error("deviation", "job-value", "`deviation` needs a [nominal] to compare the part with");
  for (const std::string& name : *names) {
    const Result<DeviationOutput> item = parseDeviationOutput(name);
    if (!item) {
      output.error("deviation", "job-value", item.error().message);
    } else if (std::count(job.output.deviation.begin(), job.output.deviation.end(), *item) > 0) {
      output.error("deviation", "job-value", fmt::format("'{}' is listed twice", name));
    } else {
      job.output.deviation.push_back(*item);
    }
  }
}

}  // namespace

void readOutput(ConfigTable& root, const JobNames& names, Job& job) {
  auto output = root.table("output");
  if (!output) return;
  const auto reportTwice = [&](const char* key, const std::string& name) {
    output->error(key, "job-value", fmt::format("'{}' is listed twice", name));
  };
  if (const auto formats = output->texts("formats")) {
    job.output.formats.clear();
    for (const std::string& name : *formats) {
      const Result<OutputFormat> format = parseOutputFormat(name);
      if (!format) {
        output->error("formats", "job-value", format.error().message);
      } else if (std::count(job.output.formats.begin(), job.output.formats.end(), *format) > 0) {
        reportTwice("formats", name);
      } else {
        job.output.formats.push_back(*format);
      }
    }
  }
  if (const auto views = output->texts("views")) {
    job.output.views.clear();
    for (const std::string& name : *views) {
      const bool known = names.views.empty() || std::count(names.views.begin(), names.views.end(), name) > 0;
      if (!known) {
        output->error("views", "job-value",
                      fmt::format("there is no view '{}'; there are {}", shortened(name),
                                  fmt::join(names.views, ", ")));
      } else if (std::count(job.output.views.begin(), job.output.views.end(), name) > 0) {
        reportTwice("views", name);
      } else {
        job.output.views.push_back(name);
      }
    }
  }
  if (const auto csv = output->flag("csv")) job.output.csv = *csv;
  readDeviation(*output, root.find("nominal") != nullptr, job);
  readSections(*output, job);
  if (const auto view = output->flag("view3d")) job.output.view3d = *view;
  if (const auto bodies = output->flag("bodies")) job.output.bodies = *bodies;
  const ConfigValue* size = output->find("size");
  if (size != nullptr && isList(root.document(), *size, "size")) {
    const auto side = [](const ConfigValue& v) {
      return v.type == Type::kInteger && v.integer >= 16 && v.integer <= 8192;
    };
    if (size->items.size() == 2 && side(size->items[0]) && side(size->items[1])) {
      job.output.width = static_cast<int>(size->items[0].integer);
      job.output.height = static_cast<int>(size->items[1].integer);
    } else {
      output->error("size", "job-range", "size must be [width, height] in pixels, each from 16 to 8192");
    }
  }
  output->refuseOthers();
}

}  // namespace proveout
