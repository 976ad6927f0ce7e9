// Machine coordinates and reference points: G27 to G30, G53, G60 (sections 3 and 5).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/motion/held_way.h"
#include "core/nc/iso/motion/machine_moves.h"
#include "core/nc/iso/perform/perform.h"

namespace proveout::nc {
namespace {

/// A code of machine moves without an axis moves nothing. True: the plan is done.
bool namesNoAxis(IsoContext& c, const BlockPlan& plan) {
  if (c.anyAxisWord()) return false;
  c.warn("no-axis", fmt::format("{} names no axis: no motion", gName(plan.governor->code10)), {},
         Severity::kNote);
  return true;
}

bool named(const BlockPlan& plan, int axis) { return plan.motion.named[static_cast<std::size_t>(axis)]; }

/// The mill's length offset of these axes is over when the motion is done.
void endLengths(IsoContext& c, const BlockPlan& plan) {
  if (isLathe(c)) return;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (named(plan, axis) && plan.next.length[axis] != 0.0)
      fanucData(c).no_length.set(static_cast<std::size_t>(axis));
  }
}

/// Without a machine zero in the job: Z goes up to where the machine starts, the other axes stay, or go to
/// the park point at that height. `to`: machine coordinates; only named axes of the plan go.
void goWithoutMachine(IsoContext& c, const BlockPlan& plan, AxisPoint& to) {
  const AxisPoint from = to;
  const double top = homeOf(c).z();
  bool parks = false;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const int number = c.axes.at(axis).number;
    if (!named(plan, axis) || c.axisMap().axisOf(axis) == 2) continue;
    if (!c.parameters.given(FanucParam::kPark, number)) continue;
    to[axis] = c.parameters.value(FanucParam::kPark, number);
    parks = parks || to[axis] != from[axis];
  }
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    const bool up = c.axisMap().axisOf(axis) == 2;
    if (up && (named(plan, axis) || parks)) to[axis] = std::max(from[axis], top);
  }
  if (c.firstTime("machine-zero")) {
    c.warn("machine-zero",
           "nothing in the job says where machine zero lies ([control.fanuc.machine] zero, reference_points "
           "under [machine], or work offsets): Z goes up to the start height, the other axes stay or go to "
           "`park`",
           {}, Severity::kNote);
  }
}

/// Up first, then level: what goes to the park point must not cross the part.
bool performFanucMachineMove(IsoContext& c, BlockPlan& plan) {
  const MachineMove& move = std::get<MachineMove>(plan.payload);
  if (move.has_via && !sendMachineRapid(c, move.via)) return false;
  if (!plan.motion.rapid) {
    PathItem item;
    item.kind = PathItem::Kind::kLine;
    item.space = PathItem::Space::kMachine;
    item.feed = plan.motion.feed;
    item.to = move.to;
    item.source = c.here();
    if (!c.pipe.push(item)) return false;
  } else if (!sendMachineRapid(c, move.to)) {
    return false;
  }
  endHeldWay(c, plan, move.to);
  c.settle(move.to);
  endLengths(c, plan);
  return true;
}

/// With an intermediate height where the way goes up and level.
void liftFirst(const IsoContext& c, MachineMove& move, const AxisPoint& from) {
  move.has_via = true;
  move.via = from;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (c.axisMap().axisOf(axis) == 2) move.via[axis] = move.to[axis];
  }
}

}  // namespace

bool planFanucMachineMove(IsoContext& c, BlockPlan& plan) {
  MachineMove& move = plan.payload.emplace<MachineMove>();
  move.to = c.machine;
  plan.motion.target = plan.start;
  if (namesNoAxis(c, plan)) return true;
  if (plan.next.incremental() && !isHaas(c)) {
    if (c.firstTime("G53 in G91"))
      c.warn("g53-incremental", "G53 needs G90: under G91 its block does not move", {}, Severity::kNote);
    return true;
  }
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (word.own_step) return c.alarm(SharedAlarm::kIncremental, w, "G53 is always absolute");
    if (!mayMove(c, w, word.axis)) return false;
    plan.motion.named.set(static_cast<std::size_t>(word.axis));
    const double value = axisValue(c, plan, word, w);
    double& to = move.to[word.axis];
    const bool rotary = word.axis >= kMainAxes && c.axes.at(word.axis).rotary();
    to = rotary ? to + rotaryTravel(c, word.axis, to, value, false) : value;
  }
  if (!machineZeroKnown(c)) {
    move.to = c.machine;
    goWithoutMachine(c, plan, move.to);
    liftFirst(c, move, c.machine);
  }
  plan.motion.rapid = plan.next.active[kGroupMotion] != gcode::kLine || plan.next.inCycle();
  plan.motion.target = plan.chain->programOf(move.to);
  if (!plan.motion.rapid && !feedStyle(c, plan, plan.motion.feed)) return false;
  plan.perform = performFanucMachineMove;
  plan.rebases = true;
  return true;
}

namespace {

bool performReference(IsoContext& c, BlockPlan& plan) {
  const MachineMove& move = std::get<MachineMove>(plan.payload);
  FanucData& data = fanucData(c);
  if (!data.via_known) data.via = c.machine;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (named(plan, axis)) data.via[axis] = move.via[axis];
  }
  data.via_known = true;
  plan.motion.rapid = true;
  if (!sendMachineRapid(c, move.via)) return false;
  MachineMove rest = move;
  rest.has_via = false;
  const auto& given = c.settings.reference_points[static_cast<std::size_t>(plan.motion.pivot_mm)];
  if (!given) liftFirst(c, rest, move.via);
  plan.payload = rest;
  return performFanucMachineMove(c, plan);
}

/// The reference point of that number, from 1, with the further axes; names as programs know them.
AxisPoint referencePoint(const IsoContext& c, const Vec3& main) {
  AxisPoint reference(main);
  for (const AxisSettings& axis : c.settings.axes) {
    if (const int k = c.axes.find(axis.name); k >= kMainAxes) reference[k] = axis.reference;
  }
  return c.axisMap().namesAt(reference);
}

}  // namespace

bool planFanucReference(IsoContext& c, BlockPlan& plan) {
  std::int64_t point = 1;
  const bool numbered = plan.governor->code10 == gcode::kNumberedReference;
  const Word* p = numbered ? c.ownWord(plan, 'P') : nullptr;
  if (numbered) point = 2;
  if (p != nullptr && !integerWord(c, *p, 2, 4, point)) return false;
  AxisPoint via = plan.start;
  if (!axisTarget(c, plan, via, WordsAre::kReference)) return false;
  plan.motion.target = plan.start;
  if (namesNoAxis(c, plan)) return true;
  const auto index = static_cast<std::size_t>(point - 1);
  MachineMove& move = plan.payload.emplace<MachineMove>();
  move.has_via = true;
  move.via = plan.chain->machineOf(via);
  move.to = move.via;
  if (const auto& given = c.settings.reference_points[index]) {
    const AxisPoint reference = referencePoint(c, *given);
    for (int axis = 0; axis < c.axes.count(); ++axis) {
      if (named(plan, axis)) move.to[axis] = reference[axis];
    }
  } else {
    goWithoutMachine(c, plan, move.to);
  }
  plan.motion.pivot_mm = static_cast<double>(index);
  plan.perform = performReference;
  plan.rebases = true;
  return true;
}

bool planFromReference(IsoContext& c, BlockPlan& plan) {
  const FanucData& data = fanucData(c);
  if (!axisTarget(c, plan, plan.motion.target, WordsAre::kReference)) return false;
  if (namesNoAxis(c, plan)) return true;
  if (!data.via_known) return c.fail("046", "G29 has no intermediate point: no G28 or G30 has gone before");
  MachineMove& move = plan.payload.emplace<MachineMove>();
  move.has_via = true;
  move.via = c.machine;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (named(plan, axis)) move.via[axis] = data.via[axis];
  }
  move.to = plan.chain->machineOf(plan.motion.target);
  plan.motion.rapid = true;
  plan.perform = performMachineMove;
  plan.rebases = true;
  return true;
}

namespace {

bool performReferenceCheck(IsoContext& c, BlockPlan& plan) {
  constexpr double kThereMm = 1e-3;
  if (!performMove(c, plan)) return false;
  const auto& given = c.settings.reference_points[static_cast<std::size_t>(plan.motion.pivot_mm)];
  if (!given) {
    c.warnOnce("G27", "reference", "G27 checks nothing: the job does not give the reference point");
    return true;
  }
  const AxisPoint reference = referencePoint(c, *given);
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (!named(plan, axis) || std::abs(c.machine[axis] - reference[axis]) <= kThereMm) continue;
    return c.fail("092",
                  fmt::format("axis {} is not on the reference point: machine {:.6g}, reference {:.6g}",
                              c.axes.at(axis).name, c.machine[axis], reference[axis]));
  }
  return true;
}

bool performOneDirection(IsoContext& c, BlockPlan& plan) {
  const AxisPoint end = plan.motion.target;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (named(plan, axis))
      plan.motion.target[axis] += c.parameters.value(FanucParam::kOverrun, c.axes.at(axis).number);
  }
  if (plan.motion.target == end) return performMove(c, plan);
  if (!performMove(c, plan)) return false;
  plan.motion.target = end;
  return performMove(c, plan);
}

}  // namespace

bool planReferenceCheck(IsoContext& c, BlockPlan& plan) {
  std::int64_t point = 1;
  if (const Word* p = c.ownWord(plan, 'P'); p != nullptr && !integerWord(c, *p, 1, 4, point)) return false;
  if (!planRapid(c, plan)) return false;
  if (namesNoAxis(c, plan)) return true;
  plan.motion.pivot_mm = static_cast<double>(point - 1);
  plan.perform = performReferenceCheck;
  return true;
}

bool planOneDirection(IsoContext& c, BlockPlan& plan) {
  if (!planRapid(c, plan)) return false;
  if (namesNoAxis(c, plan) || plan.perform != performMove) return true;
  bool overrun = false;
  for (int axis = 0; axis < c.axes.count(); ++axis)
    overrun = overrun || c.parameters.value(FanucParam::kOverrun, c.axes.at(axis).number) != 0.0;
  if (!overrun) {
    noteSetting(
        c, FanucParam::kOverrun,
        "G60 overruns by the length of parameter 5440, which is not given: it goes straight to its end");
  }
  plan.perform = performOneDirection;
  return true;
}

}  // namespace proveout::nc
