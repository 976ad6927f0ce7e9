// End points of axis words: units, diameters, operator I, turns of rotary axes, polar data.
#include <fmt/core.h>

#include <cmath>

#include "core/geometry/degrees.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/five_axis/tip_control.h"
#include "core/nc/iso/motion/held_way.h"
#include "core/nc/services/rollover.h"

namespace proveout::nc {
namespace {

/// More turns of a table in one block are no machining, and their path would not fit any memory.
constexpr double kMaxTravelDeg = 36000.0;
/// Polar data hold as long as the tool stays at their end point.
constexpr double kSamePointMm = 1e-6;

RolloverRule rolloverRule(const IsoContext& c, int axis) {
  const int number = c.axes.at(axis).number;
  RolloverRule rule;
  rule.on = c.parameters.flag(AxisParam::kRollover, number);
  rule.shortest = c.parameters.flag(AxisParam::kRolloverShortest, number);
  rule.by_sign = c.parameters.flag(AxisParam::kRolloverBySign, number);
  rule.period = c.parameters.value(AxisParam::kRolloverPeriod, number);
  return rule;
}

bool checkRotary(IsoContext& c, const BlockPlan& plan, int axis, const Word& w, double travel) {
  if (plan.next.axes.mode != VirtualMode::kOff && axis == plan.next.axes.rotary) return true;
  const AxisInfo& info = c.axes.at(axis);
  if (!info.turns) {
    const std::string key = "told only " + info.name;
    if (travel != 0.0 && c.firstTime(key)) {
      c.warn(
          "rotary-told",
          fmt::format("axis {} turns nothing that the job describes: its position is told, the path does not "
                      "follow it",
                      info.name),
          w.columns, Severity::kNote);
    }
    return true;
  }
  if (std::abs(travel) <= kMaxTravelDeg) return true;
  return c.alarm(SharedAlarm::kOutOfRange, w,
                 "more than 100 turns of a table in one block are not simulated");
}

PolarData polarBase(const BlockPlan& plan, double u, double v) {
  const PolarData& last = plan.next.axes.polar;
  const bool there =
      last.known && std::abs(last.u - u) <= kSamePointMm && std::abs(last.v - v) <= kSamePointMm;
  if (there) return last;
  return {true, std::hypot(u, v), radToDeg(std::atan2(v, u)), u, v};
}

/// An axis word of a polar block.
struct PolarWord {
  const Word* word = nullptr;
  AxisWord axis;
};

/// G16: `radius` and `angle` are the words of the plane's axes, one of them may be missing.
bool polarTarget(IsoContext& c, BlockPlan& plan, const PolarWord& radius, const PolarWord& angle,
                 AxisPoint& target) {
  const AxisModal& modal = plan.next.axes;
  const int u = modal.plane_u, v = modal.plane_v;
  if (modal.mode == VirtualMode::kOff && (c.axes.at(u).rotary() || c.axes.at(v).rotary())) {
    return c.alarm(SharedAlarm::kPlane, "", "G16 needs a plane of linear axes");
  }
  PolarData next = polarBase(plan, plan.start[u], plan.start[v]);
  const double old_angle = next.angle_deg;
  if (angle.word) next.angle_deg = angle.axis.step ? old_angle + angle.word->value : angle.word->value;
  double pole_u = 0.0, pole_v = 0.0, r = next.radius;
  if (radius.word) {
    r = axisValue(c, plan, radius.axis, *radius.word);
    if (radius.axis.step) {
      pole_u = plan.start[u];
      pole_v = plan.start[v];
    }
    if (modal.diameter[static_cast<std::size_t>(u)] && c.firstTime("polar diameter")) {
      c.warn("polar-diameter", "G16: the radius word is a diameter, as the words of its axis are",
             radius.word->columns);
    }
  }
  next.u = target[u] = pole_u + r * cosDegrees(next.angle_deg);
  next.v = target[v] = pole_v + r * sinDegrees(next.angle_deg);
  next.radius = radius.word && radius.axis.step ? std::hypot(next.u, next.v) : r;
  plan.next.axes.polar = next;
  plan.motion.polar_turn_deg = next.angle_deg - old_angle;
  return true;
}

}  // namespace

bool mayMove(IsoContext& c, const Word& w, int axis) {
  if (!c.axisMap().isSlave(axis)) return true;
  const AxisFollow* follow = c.axisMap().followOf(c.axisMap().axisOf(axis));
  return c.failWord(
      "slave-axis",
      fmt::format("axis {} follows {}: only the master may be programmed{}", c.axes.at(axis).name,
                  c.axes.at(follow->master).name, follow->always ? "" : " until the coupling is released"),
      w);
}

double rotaryTravel(const IsoContext& c, int axis, double from, double value, bool step) {
  const RolloverRule rule = rolloverRule(c, axis);
  return step ? rolloverStep(value, rule) : rolloverTravel(from, value, rule);
}

double shownPosition(const IsoContext& c, int axis, double value) {
  if (axis < kMainAxes || !c.axes.at(axis).rotary()) return value;
  if (c.state.axes.mode != VirtualMode::kOff && axis == c.state.axes.rotary) return value;
  const RolloverRule rule = rolloverRule(c, axis);
  return rule.on ? reduceTurn(value, rule.period) : value;
}

bool axisTarget(IsoContext& c, BlockPlan& plan, AxisPoint& target, WordsAre words) {
  target = plan.start;
  if (!namesMotion(c, plan)) return true;
  const AxisModal& modal = plan.next.axes;
  const bool polar = words == WordsAre::kModal && plan.next.active[kGroupPolarData] == gcode::kPolarData;
  PolarWord radius, angle;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const auto axis = static_cast<std::size_t>(word.axis);
    if (plan.motion.named[axis])
      return c.alarm(SharedAlarm::kIllegalAddress, w, "the axis is given twice in this block");
    if (!mayMove(c, w, word.axis)) return false;
    plan.motion.named.set(axis);
    if (polar && (word.axis == modal.plane_u || word.axis == modal.plane_v)) {
      (word.axis == modal.plane_u ? radius : angle) = {&w, word};
      continue;
    }
    const double value = axisValue(c, plan, word, w);
    double& end = target[word.axis];
    if (word.axis >= kMainAxes && c.axes.at(word.axis).rotary()) {
      const bool linear = modal.mode != VirtualMode::kOff && word.axis == modal.rotary;
      const double from = plan.start[word.axis];
      const double travel = !linear     ? rotaryTravel(c, word.axis, from, value, word.step)
                            : word.step ? value
                                        : value - from;
      if (!checkRotary(c, plan, word.axis, w, travel)) return false;
      end = linear && !word.step ? value : from + travel;
    } else {
      end = word.step ? plan.start[word.axis] + value : value;
    }
  }
  if ((radius.word != nullptr || angle.word != nullptr) && !polarTarget(c, plan, radius, angle, target))
    return false;
  if (plan.next.held.any()) goHeldWay(c, plan, target, words);
  if (words == WordsAre::kReference) return true;
  if (plan.next.five.follows()) {
    if (plan.next.five.tip == TipControl::kVector && !takeToolVector(c, plan, target)) return false;
    if (!followRotaryAxes(c, plan, target)) return false;
  }
  warnOfLengthBesideTool(c, plan, target);
  return true;
}

}  // namespace proveout::nc
