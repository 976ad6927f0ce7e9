#include "io/job/machine_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "core/base/printable.h"
#include "core/geometry/degrees.h"
#include "core/mesh/tri_mesh.h"
#include "io/job/job_sections.h"
#include "io/mesh_io.h"

namespace proveout {

namespace {

using Type = ConfigValue::Type;

constexpr NumberRange kDirection{-2.0, 2.0, false};  // what is no unit is told as such
constexpr NumberRange kInclination{-360.0, 360.0, false};
constexpr NumberRange kSteps{0.0, 360.0, true};
constexpr std::size_t kMostAxes = 9, kMostBodies = 100;
constexpr int kMostNumber = 32;  // of an axis in the control

int letterAxis(const std::string& name) {
  if (name.size() != 1) return -1;
  const std::size_t k = std::string_view("XYZ").find(name[0]);
  return k == std::string_view::npos ? -1 : static_cast<int>(k);
}

/// The direction that an axis has by the letter of its name: that of X for A and U, and so on.
Vec3 usualDirection(const std::string& name) {
  return Vec3::Unit(static_cast<int>(std::string_view("XYZUVWABC").find(name[0]) % 3));
}

/// A table of an axis while names of others are not known yet.
struct AxisRow {
  ConfigTable table;
  MachineAxis axis;
  std::optional<int> number;
  std::string on;  ///< empty: the bed
  std::optional<double> rapid, acceleration;
};

/// What bodies watch besides each other.
const std::vector<std::string> kWatchedParts{"spindle", "holder", "tool"};

class MachineReader {
 public:
  MachineReader(ConfigTable& machine, Job& job) : machine_(machine), job_(job) {}

  void run() {
    const int errors = machine_.document().diagnostics->errorCount();
    machine_.choice("schema", {kMachineSchema});
    if (const auto name = machine_.text("name")) model_.name = *name;
    for (ConfigTable& table : machine_.must("axis").tables("axis", kMostAxes)) readAxis(std::move(table));
    // X, Y and Z first: the order that points of all axes have.
    const auto rankOf = [](const std::unique_ptr<AxisRow>& row) {
      const int main = letterAxis(row->axis.name);
      return main < 0 ? 3 : main;
    };
    std::ranges::stable_sort(rows_, std::less(), rankOf);
    for (const auto& row : rows_) model_.axes.push_back(row->axis);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      model_.axes[k].on = carrierOf(rows_[k]->table, rows_[k]->on);
    readSpindle();
    std::vector<ConfigTable> bodies = machine_.tables("body", kMostBodies);
    for (ConfigTable& table : bodies) readBody(table);
    for (std::size_t k = 0; k < bodies.size(); ++k) checkWatch(bodies[k], model_.bodies[k]);
    if (machine_.document().diagnostics->errorCount() == errors) checkNumbers();
    if (machine_.document().diagnostics->errorCount() != errors) return;
    for (const MachineFault& fault : machineFaults(model_)) tell(fault);
    if (machine_.document().diagnostics->errorCount() == errors) hand();
  }

 private:
  void readAxis(ConfigTable table) {
    rows_.push_back(std::make_unique<AxisRow>(AxisRow{table, {}, {}, {}, {}, {}}));
    AxisRow& row = *rows_.back();
    MachineAxis& axis = row.axis;
    ConfigTable& t = row.table;
    if (!readName(t, axis)) return;
    const bool main = letterAxis(axis.name) >= 0;
    const bool turns =
        !axis.name.empty() && std::string_view("ABC").find(axis.name[0]) != std::string_view::npos;
    axis.kind = turns ? AxisKind::kRotary : AxisKind::kLinear;
    if (const auto kind = t.choice("kind", {"linear", "rotary"}))
      axis.kind = *kind == "rotary" ? AxisKind::kRotary : AxisKind::kLinear;
    if (const auto number = t.integer("number", 1, kMostNumber)) row.number = static_cast<int>(*number);
    if (const auto on = t.text("on")) row.on = *on == "bed" ? "" : *on;
    if (const auto side = t.choice("carries", {"tool", "part", "nothing"}))
      axis.side = *side == "part" ? AxisSide::kPart : *side == "tool" ? AxisSide::kTool : AxisSide::kNothing;
    if (axis.kind == AxisKind::kRotary && !main && axis.side != AxisSide::kNothing) {
      readTurn(t, axis);
    } else if (axis.kind == AxisKind::kLinear || axis.side == AxisSide::kNothing) {
      refuseTurn(t, axis);
    }
    readDirection(t, axis);
    if (t.find("travel") != nullptr) axis.travel = readLimit(t, "travel");
    row.rapid = t.number("rapid", kRate);
    row.acceleration = t.number("acceleration", kAcceleration);
    axis.rapid = row.rapid.value_or(axis.rapid);
    axis.acceleration = row.acceleration.value_or(axis.acceleration);
    readPlaces(t, axis, main);
    t.refuseOthers();
  }

  /// False, and an error, where other keys would be taken for those of another axis.
  bool readName(ConfigTable& table, MachineAxis& axis) {
    const auto name = table.must("name").text("name");
    if (!name) return false;
    const auto same = [&](const std::unique_ptr<AxisRow>& row) { return row->axis.name == *name; };
    if (!isAxisName(*name)) {
      table.error("name", "job-machine", axisNameFault(shortened(*name)));
    } else if (std::ranges::any_of(rows_, same)) {
      table.error("name", "job-machine", fmt::format("axis {} is given twice", *name));
    } else {
      axis.name = *name;
    }
    return !axis.name.empty();
  }

  static void readTurn(ConfigTable& table, MachineAxis& axis) {
    if (const auto point = table.must("point").point("point")) axis.point = *point;
    if (const auto sense = table.choice("sense", {"right", "left"})) axis.left = *sense == "left";
    if (const auto clamped = table.flag("clamped")) axis.clamped = *clamped;
    if (const auto step = table.number("step", kSteps)) axis.step = *step;
  }

  /// Of an axis that turns nothing: its keys are spelled right, so that the nearest name would mislead.
  static void refuseTurn(ConfigTable& table, const MachineAxis& axis) {
    for (const char* key : {"point", "sense", "clamped", "step"}) {
      if (table.find(key) == nullptr) continue;
      table.error(key, "job-value",
                  fmt::format("axis {} turns neither tool nor part: {} is a key of rotary axes that do",
                              axis.name, key));
    }
  }

  /// Where it stands at power-on and at the reference points. X, Y and Z have keys of the machine for that.
  static void readPlaces(ConfigTable& table, MachineAxis& axis, bool main) {
    const auto start = table.number("start", kAnyLength), reference = table.number("reference", kAnyLength);
    if (main && start)
      table.error("start", "job-value",
                  "X, Y and Z begin where the key 'start' of the machine says, [x, y, z]");
    if (main && reference)
      table.error("reference", "job-value",
                  "of X, Y and Z give 'reference_points' of the machine, [[x, y, z]]");
    if (main) return;
    axis.start = start.value_or(axis.start);
    axis.reference = reference.value_or(axis.reference);
    checkPlace(table, axis, "start", axis.start);
    if (reference) checkPlace(table, axis, "reference", axis.reference);
  }

  static void checkPlace(ConfigTable& table, const MachineAxis& axis, const char* key, double at) {
    if (!axis.travel || (at >= axis.travel->min && at <= axis.travel->max)) return;
    table.error(key, "job-range",
                fmt::format("axis {}: {} {:g} is outside of its travel, {:g} to {:g}", axis.name, key, at,
                            axis.travel->min, axis.travel->max));
  }

  void readDirection(ConfigTable& table, MachineAxis& axis) {
    const bool given = table.find("direction") != nullptr, inclined = table.find("inclination") != nullptr;
    if (given && inclined)
      return table.error("inclination", "job-value", "give direction or inclination, not both");
    if (inclined) {
      auto from = table.table("inclination");
      if (!from) return;
      const std::vector<std::string> names{"X", "Y", "Z"};
      const auto first = from->must("from").choice("from", names),
                 second = from->must("toward").choice("toward", names);
      const auto degrees = from->must("degrees").number("degrees", kInclination);
      from->refuseOthers();
      if (!first || !second || !degrees) return;
      const SinCos turn = sinCosDegrees(*degrees);
      if (*first == *second) return from->error("toward", "job-value", "toward is another axis than from");
      axis.direction = turn.cos * Vec3::Unit(letterAxis(*first)) + turn.sin * Vec3::Unit(letterAxis(*second));
    } else if (given) {
      if (const auto direction = table.point("direction", kDirection)) axis.direction = *direction;
    } else {
      axis.direction = usualDirection(axis.name);
    }
  }

  /// Index of the axis that a table names with its key `on`.
  int carrierOf(ConfigTable& table, const std::string& name) {
    if (name.empty()) return kOnBed;
    const int k = model_.find(name);
    if (k >= 0) return k;
    std::vector<std::string> names{"bed"};
    for (const MachineAxis& axis : model_.axes) names.push_back(axis.name);
    unknownChoice(machine_.document(), table.placeOf("on"), "on", name, names);
    return kOnBed;
  }

  void readSpindle() {
    machine_.require("spindle");
    auto table = machine_.table("spindle");
    if (!table) return;
    spindle_ = std::make_unique<ConfigTable>(*table);
    if (const auto on = spindle_->must("on").text("on"))
      model_.spindle.on = carrierOf(*spindle_, *on == "bed" ? "" : *on);
    if (const auto gauge = spindle_->point("gauge")) model_.spindle.gauge = *gauge;
    if (const auto direction = spindle_->point("direction", kDirection))
      model_.spindle.direction = *direction;
    spindle_->refuseOthers();
  }

  void readBody(ConfigTable& table) {
    MachineBody body;
    if (const auto name = table.must("name").text("name")) body.name = *name;
    if (const auto on = table.text("on")) body.on = carrierOf(table, *on == "bed" ? "" : *on);
    const int shapes = static_cast<int>(table.find("mesh") != nullptr) +
                       static_cast<int>(table.find("box") != nullptr) +
                       static_cast<int>(table.find("cylinder") != nullptr);
    if (shapes != 1) {
      table.error("mesh", "job-value", "a body has one of mesh, box and cylinder");
    } else if (table.find("mesh") != nullptr) {
      readMesh(table, body);
    } else if (table.find("box") != nullptr) {
      readBox(table, body);
    } else {
      readCylinder(table, body);
    }
    if (const auto watch = table.texts("watch")) body.watch = *watch;
    checkBodyName(table, body.name);
    table.refuseOthers();
    model_.bodies.push_back(std::move(body));
  }

  void checkBodyName(ConfigTable& table, const std::string& name) {
    if (std::ranges::find(kWatchedParts, name) != kWatchedParts.end())
      table.error("name", "job-value",
                  fmt::format("'{}' is the machine's own: a body has another name than {}", name,
                              fmt::join(kWatchedParts, ", ")));
    for (const MachineBody& other : model_.bodies) {
      if (!name.empty() && other.name == name)
        table.error("name", "job-value",
                    fmt::format("there are two bodies with the name '{}'", shortened(name)));
    }
  }

  /// Bodies may watch others that stand below them in the file: call with all of them known.
  void checkWatch(ConfigTable& table, const MachineBody& body) {
    std::vector<std::string> names = kWatchedParts;
    for (const MachineBody& other : model_.bodies) {
      if (other.name != body.name) names.push_back(other.name);
    }
    for (const std::string& name : body.watch) {
      if (name == body.name) {
        table.error("watch", "job-value",
                    fmt::format("body '{}' watches itself: name others", shortened(name)));
      } else if (std::ranges::find(names, name) == names.end()) {
        unknownChoice(table.document(), table.placeOf("watch"), "watch", name, names);
      }
    }
  }

  static void readMesh(ConfigTable& table, MachineBody& body) {
    const auto file = table.path("mesh");
    if (!file) return;
    body.shape = *file;
    const Result<TriMesh> mesh = loadMesh(*file);
    if (!mesh) return table.error("mesh", "job-mesh", mesh.error().message);
    if (!analyseTopology(*mesh).closedManifold())
      table.error("mesh", "job-mesh", "the mesh is not closed: a body needs a surface without holes");
  }

  static void readBox(ConfigTable& table, MachineBody& body) {
    const ConfigValue* value = table.find("box");
    if (value->type != Type::kArray || value->items.size() != 2)
      return table.error("box", "job-type", "box is a list of two points, [[x, y, z], [x, y, z]]");
    const auto min = readPoint(table.document(), value->items[0], "box", kAnyLength);
    const auto max = readPoint(table.document(), value->items[1], "box", kAnyLength);
    if (!min || !max) return;
    if ((min->array() >= max->array()).any())
      return table.error("box", "job-range", "the second point must be above the first one in x, y and z");
    body.shape = MachineBody::Box{*min, *max};
  }

  static void readCylinder(ConfigTable& table, MachineBody& body) {
    auto shape = table.table("cylinder");
    if (!shape) return;
    const auto from = shape->must("from").point("from"), to = shape->must("to").point("to");
    const auto radius = shape->must("radius").number("radius", kPositiveLength);
    shape->refuseOthers();
    if (!from || !to || !radius) return;
    if (*from == *to) return shape->error("to", "job-range", "from and to are one point");
    body.shape = MachineBody::Cylinder{*from, *to, *radius};
  }

  /// Numbers of the control: as given, else X 1, Y 2, Z 3 and from 4 on, one above the axis before.
  void checkNumbers() {
    int next = 4;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const int main = letterAxis(rows_[k]->axis.name);
      const int number = rows_[k]->number.value_or(main < 0 ? next : main + 1);
      if (main < 0) next = number + 1;
      numbers_.push_back(number);
      const auto last = numbers_.end() - 1, same = std::find(numbers_.begin(), last, number);
      ConfigTable& table = rows_[k]->table;
      if (number > kMostNumber)
        table.error("number", "job-range",
                    fmt::format("axis {} would have the number {}, {} is the last one: give it a number",
                                rows_[k]->axis.name, number, kMostNumber));
      if (same == last) continue;
      const std::string& other = rows_[static_cast<std::size_t>(same - numbers_.begin())]->axis.name;
      table.error("number", "job-value",
                  fmt::format("axes {} and {} have the same number {}: give each its own", other,
                              rows_[k]->axis.name, number));
    }
  }

  void tell(const MachineFault& fault) {
    ConfigTable& table = fault.axis >= 0 ? rows_[static_cast<std::size_t>(fault.axis)]->table
                         : std::string_view(fault.key) == "axis" || !spindle_ ? machine_
                                                                              : *spindle_;
    table.error(fault.key, "job-machine", fault.text);
  }

  /// Tells the job of a machine without faults. Directions get their full length in digits.
  void hand() {
    ControlSettings& settings = job_.settings;
    for (MachineAxis& axis : model_.axes) axis.direction.normalize();
    model_.spindle.direction.normalize();
    settings.axes.clear();
    settings.rapid_by_default = false;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      MachineAxis& axis = model_.axes[k];
      if (k < 3) {
        handMain(k, axis);
        if (!rows_[k]->number) continue;  // as they are numbered anyway
      }
      AxisSettings& own = settings.axes.emplace_back();
      own.name = axis.name;
      own.number = numbers_[k];
      own.kind = axis.kind;
      own.rapid = axis.rapid;
      own.acceleration = axis.acceleration;
      own.start = axis.start;
      own.reference = axis.reference;
      own.limit = k < 3 ? std::nullopt : axis.travel;
      own.carries = RotaryCarries::kNothing;  // the model knows
      for (int main = 0; k >= 3 && main < 3; ++main) {
        if (axis.kind == AxisKind::kLinear && axis.side != AxisSide::kNothing &&
            axis.direction == Vec3::Unit(main))
          own.parallel = std::string(1, "XYZ"[main]);
      }
    }
    settings.machine = std::move(model_);
  }

  /// X, Y or Z: what its table leaves out is as the keys of the whole machine say. Where they say nothing it
  /// is the default, and not what another machine has left in the settings.
  void handMain(std::size_t k, MachineAxis& axis) {
    ControlSettings& settings = job_.settings;
    double& rapid = settings.rapid_mm_min[static_cast<int>(k)];
    double& acceleration = settings.acceleration_mm_s2[static_cast<int>(k)];
    if (!rows_[k]->rapid && machine_.find("rapid") != nullptr) axis.rapid = rapid;
    if (!rows_[k]->acceleration && machine_.find("acceleration") != nullptr) axis.acceleration = acceleration;
    if (!axis.travel && limitsName(axis.name)) axis.travel = settings.limits[k];
    rapid = axis.rapid;
    acceleration = axis.acceleration;
    settings.limits[k] = axis.travel;
  }

  bool limitsName(const std::string& axis) {
    const ConfigValue* limits = machine_.find("limits");
    return limits != nullptr &&
           std::ranges::find(limits->entries, axis, &ConfigEntry::key) != limits->entries.end();
  }

  ConfigTable& machine_;
  Job& job_;
  std::vector<std::unique_ptr<AxisRow>> rows_;
  std::vector<int> numbers_;  ///< by axis
  std::unique_ptr<ConfigTable> spindle_;
  MachineModel model_;
};

}  // namespace

void readMachineModel(ConfigTable& machine, Job& job) { MachineReader(machine, job).run(); }

}  // namespace proveout
