// G96, G97, G92 S: constant surface speed (manual 11.5).
#include "core/nc/services/surface_speed.h"

#include <algorithm>
#include <cmath>

#include "core/nc/iso/context/words.h"
#include "core/nc/iso/spindle/spindle.h"

namespace proveout::nc {
namespace {

/// What stands for the top speed of a spindle without ranges and without G92 S, 1/min.
constexpr double kNoTopSpeed = 1e6;
constexpr double kMostAxes = 32.0;  ///< numbers of axes are 1 to this

SpindleBounds boundsOf(const IsoContext& c, const IsoState& state) {
  const Spindles& all = c.registers.spindles;
  SpindleBounds bounds{c.parameters[SpindleParam::kLeastSurfaceRpm], kNoTopSpeed};
  if (!c.settings.spindles.empty()) {
    const auto& ranges = c.settings.spindles[static_cast<std::size_t>(all.main)].ranges;
    const int gear = all.record[static_cast<std::size_t>(all.main)].gear;
    double least = kNoTopSpeed, most = 0.0;
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      if (gear > 0 && static_cast<int>(k) + 1 != gear) continue;
      least = std::min(least, ranges[k].min);
      most = std::max(most, ranges[k].max);
    }
    if (most > 0.0) bounds = {std::max(bounds.low, least), most};
  }
  if (state.speed_limit > 0.0) bounds.high = std::min(bounds.high, state.speed_limit);
  bounds.low = std::min(bounds.low, bounds.high);
  return bounds;
}

/// Turns a minute times the radius in mm.
double speedTimesRadius(const IsoState& state) {
  const double mm_min = state.active[kGroupUnits] == gcode::kInch ? state.surface_speed * 12.0 * 25.4
                                                                  : state.surface_speed * 1000.0;
  return mm_min / (2.0 * kPi);
}

}  // namespace

bool surfaceSpeedRuns(const IsoContext& c, const BlockPlan& plan) {
  if (plan.next.active[kGroupSurfaceSpeed] != gcode::kSurfaceSpeed) return false;
  bool turning = c.state.spindle_direction != 0;
  for (int i = 0; i < plan.m_count; ++i) {
    const int m = plan.m_value[static_cast<std::size_t>(i)];
    turning = turning || mcode::turns(m);
  }
  return turning;
}

double surfaceRpm(const IsoContext& c, const IsoState& state, const AxisPoint& at) {
  return surfaceRpm(speedTimesRadius(state), at[state.surface_axis], boundsOf(c, state));
}

double surfaceMeanRpm(IsoContext& c, const BlockPlan& plan) {
  const SpindleBounds bounds = boundsOf(c, plan.next);
  const double product = speedTimesRadius(plan.next);
  const int axis = plan.next.surface_axis;
  const double from = plan.start[axis], to = plan.motion.target[axis];
  const double nearest = from * to <= 0.0 ? 0.0 : std::min(std::abs(from), std::abs(to));
  if (bounds.high == kNoTopSpeed && nearest * kNoTopSpeed <= product) {
    c.warnOnce(
        "surface speed without limit", "surface-speed",
        "G96 to the axis without a limit of the spindle's speed: speed and time there are those of no real "
        "machine; give G92 S in the program or the ranges of [[machine.spindle]]");
  }
  return meanSurfaceRpm(product, from, to, bounds);
}

bool planSurfaceSpeed(IsoContext& c, BlockPlan& plan) {
  IsoState& next = plan.next;
  if (next.active[kGroupSurfaceSpeed] != gcode::kSurfaceSpeed) return true;
  const GCode* code = plan.by_group[kGroupSurfaceSpeed];
  const Word* p = code != nullptr ? c.word('P') : nullptr;
  if (p != nullptr) {
    const double number = p->from_expression ? std::round(p->value) : p->value;
    const bool whole = (p->is_integer || p->from_expression) && number >= 1.0 && number <= kMostAxes;
    const int axis = whole ? c.axes.byNumber(static_cast<int>(number)) : -1;
    if (axis < 0 || c.axes.at(axis).rotary())
      return c.alarm(SharedAlarm::kSurfaceAxis, *p, "the number of a linear axis");
    next.surface_axis = axis;
  }
  const GCode* one_shot = plan.by_group[kOneShot];
  const bool limit = one_shot != nullptr && one_shot->code10 == gcode::kSetPosition;
  if (const Word* s = c.word('S'); s && !limit) {
    if (!(s->value > 0.0 && s->value <= 1e6))
      return c.alarm(SharedAlarm::kOutOfRange, *s, "surface speed: above 0, up to 1000000");
    next.surface_speed = s->value;
  }
  if (next.surface_speed <= 0.0) return c.alarm(SharedAlarm::kMissingData, "S", "G96 needs a surface speed");
  if (!surfaceSpeedRuns(c, plan)) return true;
  const double rpm = surfaceRpm(c, next, plan.start);
  plan.spindle_changed = rpm != c.state.spindle_rpm;
  next.spindle_rpm = rpm;
  return true;
}

bool performSurfaceSpeed(IsoContext& c, const BlockPlan& plan) {
  if (!surfaceSpeedRuns(c, plan) || c.state.spindle_direction == 0) return true;
  const double rpm = surfaceRpm(c, plan.next, c.position);
  const bool changed = rpm != c.state.spindle_rpm;
  c.state.spindle_rpm = rpm;
  return !changed || !plan.motion.rapid || sendSpindle(c, c.state.spindle_direction, rpm);
}

}  // namespace proveout::nc
