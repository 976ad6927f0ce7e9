#include "core/nc/kinematics/axes.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/path/toolpath.h"

namespace proveout::nc {
namespace {

constexpr std::array<std::string_view, kMainAxes> kMainNames{"X", "Y", "Z"};

int mainAxis(std::string_view name) {
  const auto found = std::find(kMainNames.begin(), kMainNames.end(), name);
  return found == kMainNames.end() ? -1 : static_cast<int>(found - kMainNames.begin());
}

std::optional<RotaryMount> mountOf(const AxisSettings& given) {
  const int letter =
      std::string_view("ABC").find(given.name[0]) == std::string_view::npos ? -1 : given.name[0] - 'A';
  const bool table = given.carries == RotaryCarries::kPart ||
                     (given.carries == RotaryCarries::kDefault && (letter >= 0 || given.direction));
  if (given.kind != AxisKind::kRotary || !table) return std::nullopt;
  RotaryMount mount;
  mount.direction = given.direction.value_or(letter >= 0 ? Vec3(Vec3::Unit(letter)) : Vec3(Vec3::UnitZ()));
  mount.center = given.center;
  return mount;
}

bool turnsOn(const MachineModel& machine, const std::string& name) {
  const int k = machine.find(name);
  if (k < 0) return false;
  const MachineAxis& axis = machine.axes[static_cast<std::size_t>(k)];
  return axis.kind == AxisKind::kRotary && axis.side != AxisSide::kNothing;
}

std::vector<AxisInfo> axesOf(const ControlSettings& settings) {
  std::vector<AxisInfo> axes(kMainAxes);
  for (int k = 0; k < kMainAxes; ++k) {
    AxisInfo& axis = axes[static_cast<std::size_t>(k)];
    axis.name = kMainNames[static_cast<std::size_t>(k)];
    axis.number = k + 1;
    axis.rapid = settings.rapid_mm_min[k];
    axis.acceleration = settings.acceleration_mm_s2[k];
    axis.limit = settings.limits[static_cast<std::size_t>(k)];
  }
  for (const AxisSettings& given : settings.axes) {
    const int main = mainAxis(given.name);
    if (main < 0) axes.emplace_back();
    AxisInfo& axis = main < 0 ? axes.back() : axes[static_cast<std::size_t>(main)];
    axis.number = given.number;
    if (main >= 0) continue;
    axis.name = given.name;
    axis.kind = given.kind;
    axis.parallel_to = given.parallel.empty() ? -1 : mainAxis(given.parallel);
    axis.rapid = given.rapid;
    axis.acceleration = given.acceleration;
    axis.limit = given.limit;
    axis.mount = mountOf(given);
    axis.turns = settings.machine ? turnsOn(*settings.machine, given.name) : axis.mount.has_value();
  }
  return axes;
}

}  // namespace

AxisTable::AxisTable(const ControlSettings& settings)
    : axes_(axesOf(checkAxes(settings).empty() ? settings : ControlSettings{})) {
  for (int k = 0; k < count(); ++k) {
    names_.addAxis(at(k).name, k, at(k).number);
    addresses_.add(names_.addressOf(k));
  }
  for (std::size_t k = 0; k < std::min<std::size_t>(settings.spindles.size(), kSpindleNames); ++k) {
    const SpindleSettings& spindle = settings.spindles[k];
    const auto index = static_cast<int>(k);
    if (spindle.name.size() >= 2) names_.addSpindle(spindle.name, index);
    if (spindle.position_name.size() >= 2) names_.addSpindle(spindle.position_name, kSpindleNames + index);
  }
}

int AxisTable::find(std::string_view name) const {
  const auto found =
      std::find_if(axes_.begin(), axes_.end(), [&](const AxisInfo& axis) { return axis.name == name; });
  return found == axes_.end() ? -1 : static_cast<int>(found - axes_.begin());
}

int AxisTable::byNumber(int number) const {
  const auto found =
      std::find_if(axes_.begin(), axes_.end(), [&](const AxisInfo& axis) { return axis.number == number; });
  return found == axes_.end() ? -1 : static_cast<int>(found - axes_.begin());
}

std::string checkAxes(const ControlSettings& settings) {
  for (const AxisSettings& axis : settings.axes) {
    if (!isAxisName(axis.name)) {
      return fmt::format("axis name '{}': X Y Z U V W A B or C, then up to two letters or digits", axis.name);
    }
    const bool parallel = !axis.parallel.empty();
    if (parallel && (mainAxis(axis.parallel) < 0 || axis.kind == AxisKind::kRotary)) {
      return fmt::format("axis {}: only a linear axis is parallel to X, Y or Z", axis.name);
    }
    const bool turns = axis.direction || axis.center || axis.carries == RotaryCarries::kPart;
    if (axis.kind != AxisKind::kRotary && turns) {
      return fmt::format("axis {}: only a rotary axis turns the part", axis.name);
    }
    if (axis.direction && !(axis.direction->allFinite() && axis.direction->norm() > 1e-9)) {
      return fmt::format("axis {}: the direction must not be zero", axis.name);
    }
    if (axis.center && !axis.center->allFinite()) return fmt::format("axis {}: bad centre", axis.name);
    if (!(axis.rapid > 0.0)) return fmt::format("axis {}: the rapid rate must be above 0", axis.name);
    if (mainAxis(axis.name) >= 0 && (axis.kind == AxisKind::kRotary || parallel)) {
      return fmt::format("axis {} is a linear main axis", axis.name);
    }
  }
  const std::vector<AxisInfo> axes = axesOf(settings);
  const auto rotary = std::count_if(axes.begin(), axes.end(), [](const AxisInfo& a) { return a.rotary(); });
  if (rotary > kMaxRotaryAxes) return fmt::format("a channel has at most {} rotary axes", kMaxRotaryAxes);
  if (axes.size() > kMaxAxes) return fmt::format("a channel has at most {} axes", kMaxAxes);
  for (const AxisInfo& a : axes) {
    if (!(a.acceleration >= 0.0 && a.acceleration <= 1e9)) {
      return fmt::format("axis {}: the acceleration must be 0 (none) or above, at most 1e9", a.name);
    }
    if (a.number < 1 || a.number > 32) return fmt::format("axis {}: numbers are 1 to 32", a.name);
    for (const AxisInfo& b : axes) {
      if (&a == &b) continue;
      if (a.name == b.name) return fmt::format("axis {} is given twice", a.name);
      if (a.number == b.number) return fmt::format("axes {} and {} have one number", a.name, b.name);
    }
  }
  return {};
}

MotionLimits accelerationLimits(const AxisTable& axes, double bell_time_s) {
  MotionLimits limits;
  for (int k = 0; k < axes.count(); ++k) {
    limits.axes[static_cast<std::size_t>(k)].acceleration = axes.at(k).acceleration;
    limits.accelerations = limits.accelerations || axes.at(k).acceleration > 0.0;
  }
  limits.bell_time_s = bell_time_s;
  return limits;
}

}  // namespace proveout::nc
