// Measuring moves: G31, G31 P98, G37 (manual chapter 21).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/parameters/safety.h"
#include "core/nc/iso/system_variables/position_bank.h"

namespace proveout::nc {
namespace {

/// P of G31 that means the torque of an axis in place of a probe.
constexpr double kTorque = 98.0;
constexpr double kProbeInputs = 8.0;

/// The code in force that measuring is not allowed with (2055); 0: none.
int codeInTheWay(const IsoContext& c, const IsoState& s, bool any_compensation) {
  struct Needed {
    IsoGroup group;
    int code10;
  };
  for (const Needed& need :
       {Needed{kGroupPolarData, gcode::kPolarDataOff}, Needed{kGroupScaling, gcode::kScalingOff},
        Needed{kGroupMirror, gcode::kMirrorOff}, Needed{kGroupRotation, gcode::kRotationOff},
        Needed{kGroupFeedMode, gcode::kFeedPerMinute}}) {
    const bool turning = s.perTurn() && c.state.spindle_direction != 0;
    if (c.dialect.rules.probe_in_transforms && (need.group != kGroupFeedMode || turning)) continue;
    if (s.active[need.group] != need.code10) return s.active[need.group];
  }
  return !any_compensation && s.compOn() ? s.active[kGroupRadiusComp] : 0;
}

bool checkState(IsoContext& c, const BlockPlan& plan, bool any_compensation) {
  int code = codeInTheWay(c, plan.next, any_compensation);
  if (code == 0 && !any_compensation && c.state.compOn()) code = c.state.active[kGroupRadiusComp];
  const bool comp = code == gcode::kCompLeft || code == gcode::kCompRight;
  return code == 0 || c.alarm(comp ? SharedAlarm::kProbeInComp : SharedAlarm::kProbeState, gName(code));
}

/// The second of several named axes by their numbers (2035); without one, what there is alone.
bool checkOneAxis(IsoContext& c, const BlockPlan& plan, std::string_view code) {
  if (plan.motion.named.count() == 1) return true;
  std::vector<int> axes;
  for (int k = 0; k < c.axes.count(); ++k) {
    if (plan.motion.named[static_cast<std::size_t>(k)]) axes.push_back(k);
  }
  if (axes.empty()) return c.alarm(SharedAlarm::kAxis, "", fmt::format("{} needs the word of an axis", code));
  std::sort(axes.begin(), axes.end(),
            [&](int a, int b) { return c.axes.at(a).number < c.axes.at(b).number; });
  return c.alarm(SharedAlarm::kAxis, c.axes.at(axes[1]).name,
                 fmt::format("{} measures along one axis", code));
}

/// F, or with the bit `fixed` the parameter.
bool measuringFeed(IsoContext& c, BlockPlan& plan, SafetyParam fixed, SafetyParam value, FeedStyle& style) {
  style.kind = MotionKind::kProbe;
  if (!c.parameters.flag(fixed)) return feedStyle(c, plan, style);
  style.join = joinOf(plan);
  style.feed = c.parameters[value];
  return style.feed > 0.0 || c.fail("feed", fmt::format("the parameter of the measuring feed ({}, {}) is 0",
                                                        c.parameters.name(SafetyParam::kSkipFeed),
                                                        c.parameters.name(SafetyParam::kLengthFeed)));
}

bool noAxis(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  c.warn(SharedAlarm::kMissingData, "no axis is named: no motion");
  return true;
}

bool send(IsoContext& c, const AxisPoint& to, const FeedStyle* feed) {
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.space = PathItem::Space::kMachine;
  item.rapid = feed == nullptr;
  if (feed != nullptr) item.feed = *feed;
  item.to = to;
  item.source = c.here();
  if (!c.pipe.push(item)) return false;
  c.settle(to);
  return true;
}

/// Asks the probe about the line to `to`, machine. `stop`: where the contact is, or nothing. False: reported.
bool ask(IsoContext& c, const AxisPoint& to, std::optional<AxisPoint>& stop) {
  if (c.host.probe == nullptr) {
    c.warnOnce("no probe", "no-probe",
               "there is no stock here that a measuring move could touch: it goes to its end");
    return true;
  }
  if (!c.stages.rapid.flush(FlushReason::kBuffer)) return false;  // the tool stands where it measures from
  c.emitter.time().flush();  // everything before is part of the stock that answers
  const auto line = c.emitter.lineOf(c.axisMap().axesAt(to), c.here());
  if (!line) return c.fail("probe-turn", "a measuring move that turns a table is not simulated");
  const auto contact =
      c.host.probe->firstContact(line->motion, nullptr, line->has_axis ? &line->axis : nullptr);
  if (!contact) return c.fail("probe", contact.error().message);
  if (*contact) stop = between(c.standing(), to, std::clamp(**contact, 0.0, 1.0));
  return true;
}

bool tellProbe(IsoContext& c, bool touched) { return sendEvent(c, event::Probe{touched}); }

/// What the skip position is counted by, as the block leaves it.
void takeFrames(IsoContext& c, const BlockPlan& plan) {
  c.state.length = plan.next.length;
  c.state.work_system = plan.next.work_system;
  c.state.five = plan.next.five;
  c.state.h_value = plan.next.h_value;
  c.state.active[kGroupLengthComp] = plan.next.active[kGroupLengthComp];
}

/// The probe goes along a line of the axes: it cannot hold the tip while these turn.
bool refuseTurn(IsoContext& c, const BlockPlan& plan) {
  return plan.next.five.tip == TipControl::kOff ||
         !turnsRotaryAxes(c, plan.chain->machineOf(plan.motion.target)) ||
         c.fail(
             "probe-turn",
             "G31 cannot turn a rotary axis while the tip is held (G43.4, G43.5): turn it in a block before");
}

bool performSkip(IsoContext& c, BlockPlan& plan) {
  takeFrames(c, plan);
  std::optional<AxisPoint> stop;
  const AxisPoint to = std::get<SkipMove>(plan.payload).to;
  if (!ask(c, to, stop) || !send(c, stop.value_or(to), &plan.motion.feed)) return false;
  recordSkip(c, c.machine);
  return tellProbe(c, stop.has_value());
}

/// P and Q of G31.
bool skipWords(IsoContext& c, const BlockPlan& plan, bool& torque) {
  const Word* p = c.ownWord(plan, 'P');
  const Word* q = c.ownWord(plan, 'Q');
  torque = p != nullptr && p->value == kTorque;
  const bool input =
      p == nullptr || (p->value >= 1.0 && p->value <= kProbeInputs && p->value == std::floor(p->value));
  if (!torque && !input) {
    return c.failWord("probe-input", "P specification error: G31 takes P1 to P8 or P98", *p);
  }
  if (!torque) return q == nullptr || c.alarm(SharedAlarm::kIllegalAddress, *q, "G31 takes Q with P98 only");
  if (q == nullptr) return c.alarm(SharedAlarm::kMissingData, "Q", "G31 P98 needs the torque Q1 to Q254");
  if (q->value >= 1.0 && q->value <= 254.0 && q->value == std::floor(q->value)) return true;
  return c.alarm(SharedAlarm::kTorque, *q, "the torque is Q1 to Q254");
}

}  // namespace

bool planSkip(IsoContext& c, BlockPlan& plan) {
  bool torque = false;
  if (!skipWords(c, plan, torque) || !checkState(c, plan, false)) return false;
  if (!axisTarget(c, plan, plan.motion.target, WordsAre::kRectangular)) return false;
  if (!refuseTurn(c, plan) || (torque && !checkOneAxis(c, plan, "G31 P98"))) return false;
  if (!c.anyAxisWord()) return noAxis(c, plan);
  if (!measuringFeed(c, plan, SafetyParam::kSkipFeedFixed, SafetyParam::kSkipFeed, plan.motion.feed))
    return false;
  plan.payload.emplace<SkipMove>().to = plan.chain->machineOf(plan.motion.target);
  plan.perform = performSkip;
  plan.rebases = true;
  return true;
}

namespace {

/// Where the tool touches; without an answer at the gauge itself. False: reported.
bool measureLength(IsoContext& c, BlockPlan& plan, const LengthMove& move) {
  std::optional<AxisPoint> stop;
  if (!send(c, c.chain.machineOf(move.approach), nullptr)) return false;
  if (!ask(c, c.chain.machineOf(move.furthest), stop)) return false;
  std::optional<AxisPoint> late;
  if (!stop && !ask(c, c.chain.machineOf(move.beyond), late)) return false;
  if (late) {  // the move ends where the control gives up
    const double off = std::abs(c.chain.programOf(*late)[move.axis] - move.gauge[move.axis]);
    return send(c, c.chain.machineOf(move.furthest), &plan.motion.feed) && tellProbe(c, false) &&
           c.alarm(SharedAlarm::kProbeLimits, "",
                   fmt::format("the contact lies {:.6g} mm behind where it should be, {:.6g} allowed", off,
                               c.parameters[SafetyParam::kAlarmDistance]));
  }
  if (!stop) {
    c.warnOnce("no gauge", "no-gauge",
               "nothing answers where G37 measures: the tool is taken to be as long as its offset says", {});
  }
  return send(c, stop.value_or(c.chain.machineOf(move.gauge)), &plan.motion.feed) &&
         tellProbe(c, stop.has_value());
}

bool performLength(IsoContext& c, BlockPlan& plan) {
  takeFrames(c, plan);
  const LengthMove& move = std::get<LengthMove>(plan.payload);
  if (!measureLength(c, plan, move)) return false;
  recordSkip(c, c.machine);
  const double difference = move.gauge[move.axis] - c.position[move.axis];
  const double allowed = c.parameters[SafetyParam::kAlarmDistance];
  if (std::abs(difference) > allowed) {
    return c.alarm(SharedAlarm::kProbeLimits, "",
                   fmt::format("{:.6g} mm from where it should be, {:.6g} allowed", -difference, allowed));
  }
  constexpr double kNone = 1e-9;
  if (std::abs(difference) <= kNone) return true;
  const bool by_turning = plan.next.active[kGroupLengthComp] == gcode::kLengthTurning;
  const OffsetColumn column = by_turning && move.axis == 0   ? OffsetColumn::kX
                              : by_turning && move.axis == 1 ? OffsetColumn::kY
                                                             : OffsetColumn::kLength;
  const bool wear = c.parameters.flag(SafetyParam::kLengthWear);
  const OffsetValue& old = c.registers.offsets.value(column, plan.next.h);
  const double change = c.parameters.flag(SafetyParam::kLengthAdd) ? difference : -difference;
  const std::uint32_t by = numberOfAxisWord(c, plan, move.axis);
  c.registers.offsets.set(column, plan.next.h, wear, (wear ? old.wear : old.geometry) + change, by);
  return true;
}

/// G37 corrects a length: it needs an axis along which one lies. Where coordinates are turned or the length
/// follows the heads that is the tool's own direction.
bool checkLengthAxis(IsoContext& c, const BlockPlan& plan, int axis) {
  if (axis >= kMainAxes && c.axes.at(axis).rotary())
    return c.alarm(SharedAlarm::kAxis, c.axes.at(axis).name, "G37 measures along a linear axis");
  if (!plan.next.five.any()) return true;
  AxisPoint step;
  step[axis] = 1.0;
  const Vec3 along = plan.chain->machineOf(step).xyz - plan.chain->machineOf(AxisPoint()).xyz;
  const Vec3 tool = c.five_axes.spindleVector(c.five_axes.at(c.machine));
  const bool moves = along.norm() > 0.0;  // X, Y or Z, and not an axis parallel to one
  return (moves && along.normalized().cross(tool).norm() <= kAlongToolSine) ||
         c.fail("length-beside-tool",
                fmt::format("G37 measures along {}, and the tool stands along {:.4f}, {:.4f}, {:.4f} of the "
                            "machine: the contact tells nothing about the length of H",
                            c.axes.at(axis).name, tool.x(), tool.y(), tool.z()));
}

bool checkLengthMode(IsoContext& c, const BlockPlan& plan) {
  const double rapid = c.parameters[SafetyParam::kRapidDistance];
  const double allowed = c.parameters[SafetyParam::kAlarmDistance];
  if (!(allowed > 0.0 && rapid > allowed)) {
    return c.fail("parameter", fmt::format("G37: {0} must be above {1}, and {1} above 0",
                                           c.parameters.name(SafetyParam::kRapidDistance),
                                           c.parameters.name(SafetyParam::kAlarmDistance)));
  }
  if (plan.next.active[kGroupLengthComp] == gcode::kLengthOff)
    return c.alarm(SharedAlarm::kProbeState, "G49", "G37 corrects the offset in force");
  return plan.next.h > 0 || c.alarm(SharedAlarm::kMissingData, "H", "G37 corrects the row of the H in force");
}

}  // namespace

bool planToolLength(IsoContext& c, BlockPlan& plan) {
  if (!checkState(c, plan, true)) return false;
  if (!c.anyAxisWord()) return noAxis(c, plan);
  LengthMove& move = plan.payload.emplace<LengthMove>();
  move.gauge = plan.start;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (word.own_step) return c.alarm(SharedAlarm::kIncremental, w, "the gauge of G37 is always absolute");
    if (!mayMove(c, w, word.axis)) return false;
    plan.motion.named.set(static_cast<std::size_t>(word.axis));
    move.axis = word.axis;
    move.gauge[word.axis] = axisValue(c, plan, word, w);
  }
  if (!checkOneAxis(c, plan, "G37") || !checkLengthAxis(c, plan, move.axis) || !checkLengthMode(c, plan))
    return false;
  if (!measuringFeed(c, plan, SafetyParam::kLengthFeedFixed, SafetyParam::kLengthFeed, plan.motion.feed))
    return false;
  const double side = plan.start[move.axis] < move.gauge[move.axis] ? -1.0 : 1.0;  // that the tool comes from
  move.approach = move.furthest = move.gauge;
  move.approach[move.axis] += side * c.parameters[SafetyParam::kRapidDistance];
  move.furthest[move.axis] -= side * c.parameters[SafetyParam::kAlarmDistance];
  // Farther than any machine with one gauge goes: what is found there is a gauge that was missed.
  constexpr double kBeyondMm = 1000.0;
  move.beyond = move.furthest;
  move.beyond[move.axis] -= side * kBeyondMm;
  plan.perform = performLength;
  plan.rebases = true;
  return true;
}

}  // namespace proveout::nc
