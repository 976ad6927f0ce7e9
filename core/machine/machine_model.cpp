#include "core/machine/machine_model.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// How far the length of a direction may be from 1: what a rounded 0.7071 is off.
constexpr double kUnitSlack = 1e-3;
/// How far a travel may be from whole steps, as a part of one.
constexpr double kStepSlack = 1e-6;
/// Volume that the directions of X, Y and Z span; at right angles it is 1.
constexpr double kFlat = 1e-6;

class Checker {
 public:
  explicit Checker(const MachineModel& model) : model_(model) {}

  std::vector<MachineFault> run() {
    for (const char* main : {"X", "Y", "Z"}) {
      const int k = model_.find(main);
      if (k < 0) {
        add(-1, "axis", fmt::format("there is no axis {}: a machine has X, Y and Z", main));
      } else if (axis(k).kind != AxisKind::kLinear) {
        add(k, "kind", fmt::format("axis {} is a linear main axis", main));
      } else if (axis(k).side == AxisSide::kNothing) {
        add(k, "carries", fmt::format("axis {} is a main axis: it moves the tool or the part", main));
      }
    }
    for (std::size_t k = 0; k < model_.axes.size(); ++k) checkAxis(static_cast<int>(k));
    if (faults_.empty()) checkSpace();
    checkSpindle();
    checkPartSide();
    return std::move(faults_);
  }

 private:
  const MachineAxis& axis(int k) const { return model_.axes[static_cast<std::size_t>(k)]; }
  void add(int k, const char* key, std::string text) { faults_.push_back({k, key, std::move(text)}); }
  bool there(int k) const {
    return k == kOnBed || (k >= 0 && static_cast<std::size_t>(k) < model_.axes.size());
  }

  static bool isUnit(const Vec3& d) { return d.allFinite() && std::abs(d.norm() - 1.0) <= kUnitSlack; }

  void checkAxis(int k) {
    const MachineAxis& a = axis(k);
    if (!isAxisName(a.name)) add(k, "name", axisNameFault(a.name));
    for (int i = 0; i < k; ++i) {
      if (axis(i).name == a.name) add(k, "name", fmt::format("axis {} is given twice", a.name));
    }
    if (!isUnit(a.direction)) {
      add(k, "direction",
          fmt::format("axis {}: a direction has length 1; this one has {:.6g}", a.name, a.direction.norm()));
    }
    if (!a.point.allFinite()) add(k, "point", fmt::format("axis {}: its point is not a number", a.name));
    if (a.travel && !(a.travel->min < a.travel->max)) {
      add(k, "travel",
          fmt::format("axis {}: its travel ends at {:g} before it begins at {:g}", a.name, a.travel->max,
                      a.travel->min));
    }
    checkStep(k);
    if (!there(a.on)) return add(k, "on", fmt::format("axis {} stands on an axis that is not there", a.name));
    if (a.on == kOnBed) return;
    if (isInLoop(k)) return add(k, "on", fmt::format("axis {} stands on itself in the end", a.name));
    if (axis(a.on).side != a.side) {
      add(k, "on",
          fmt::format("axis {} moves the {}, and {}, on which it stands, the {}", a.name, sideName(a.side),
                      axis(a.on).name, sideName(axis(a.on).side)));
    }
  }

  /// X, Y and Z do not move in one plane: a tool gets everywhere.
  void checkSpace() {
    Eigen::Matrix3d space;
    for (int k = 0; k < 3; ++k) {
      const int at = model_.find(std::string(1, "XYZ"[k]));
      space.col(k) = axis(at).direction;
    }
    if (std::abs(space.determinant()) >= kFlat) return;
    add(model_.find("Z"), "direction",
        "the directions of X, Y and Z lie in one plane: no motion leads out of it");
  }

  void checkStep(int k) {
    const MachineAxis& a = axis(k);
    if (a.step == 0.0) return;
    const auto divides = [&](double length) {
      const double steps = length / a.step;
      return std::abs(steps - std::round(steps)) <= kStepSlack;
    };
    const bool whole = a.travel ? divides(a.travel->min) && divides(a.travel->max) : divides(360.0);
    if (a.kind != AxisKind::kRotary || !(a.step > 0.0) || !whole) {
      add(k, "step",
          fmt::format(
              "axis {}: a step is above 0 and divides the travel of a rotary axis (or 360) without a rest",
              a.name));
    }
    if (!divides(a.start))
      add(k, "start",
          fmt::format("axis {}: its teeth hold it at whole steps, and start {:g} is none", a.name, a.start));
  }

  static const char* sideName(AxisSide side) {
    return side == AxisSide::kTool ? "tool" : side == AxisSide::kPart ? "part" : "position alone";
  }

  bool isInLoop(int k) const {
    int at = k;
    for (std::size_t step = 0; step <= model_.axes.size(); ++step) {
      at = axis(at).on;
      if (!there(at)) return false;
      if (at == kOnBed) return false;
      if (at == k) return true;
    }
    return true;
  }

  void checkSpindle() {
    const SpindleMount& s = model_.spindle;
    if (!isUnit(s.direction)) add(-1, "direction", "the spindle's direction has length 1");
    if (!s.gauge.allFinite()) add(-1, "gauge", "the spindle's gauge point is not a number");
    if (!there(s.on)) return add(-1, "on", "the spindle stands on an axis that is not there");
    if (s.on != kOnBed && axis(s.on).side != AxisSide::kTool)
      add(-1, "on", fmt::format("the spindle stands on {}, which does not move the tool", axis(s.on).name));
    for (std::size_t k = 0; k < model_.axes.size(); ++k) {
      if (model_.axes[k].side == AxisSide::kTool && !leadsTo(s.on, static_cast<int>(k)))
        add(static_cast<int>(k), "carries",
            fmt::format("axis {} moves the tool, but does not stand between bed and spindle: the keys 'on' "
                        "from the spindle to the bed leave it out",
                        model_.axes[k].name));
    }
  }

  /// Whether the way from axis `from` to the bed goes through axis `through`.
  bool leadsTo(int from, int through) const {
    int at = from;
    for (std::size_t step = 0; step <= model_.axes.size() && there(at) && at != kOnBed;
         ++step, at = axis(at).on) {
      if (at == through) return true;
    }
    return false;
  }

  /// One table carries the part: all axes of its side stand on each other.
  void checkPartSide() {
    for (std::size_t i = 0; i < model_.axes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const int a = static_cast<int>(i), b = static_cast<int>(k);
        if (axis(a).side != AxisSide::kPart || axis(b).side != AxisSide::kPart) continue;
        if (!leadsTo(a, b) && !leadsTo(b, a))
          add(a, "on",
              fmt::format("axes {} and {} both move the part, but neither stands on the other", axis(b).name,
                          axis(a).name));
      }
    }
  }

  const MachineModel& model_;
  std::vector<MachineFault> faults_;
};

}  // namespace

bool isAxisName(std::string_view name) {
  if (name.empty() || name.size() > 3 || name == "AX" || name == "AXN") return false;
  if (std::string_view("XYZUVWABC").find(name[0]) == std::string_view::npos) return false;
  return std::all_of(name.begin() + 1, name.end(),
                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); });
}

std::string axisNameFault(std::string_view name) {
  return fmt::format("axis name '{}': X Y Z U V W A B or C, then up to two letters or digits", name);
}

std::vector<MachineFault> machineFaults(const MachineModel& model) { return Checker(model).run(); }

}  // namespace proveout
