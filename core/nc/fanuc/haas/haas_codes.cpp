// Motion, frames, mirroring and functions of Haas mills.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/haas/haas.h"
#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/motion/motion_plans.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/frames/transforms.h"
#include "core/nc/iso/motion/feed.h"

namespace proveout::nc {
namespace {

constexpr double kSamePlaceMm = 1e-9;
/// Work system of G52 with Setting 33 at YASNAC: behind all that programs can name.
constexpr WorkSystemId kYasnacFrame = kFirstExtended + 899;

bool performBeside(IsoContext& c, BlockPlan& plan) {
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.plane = planeOf(plan.next);
  item.in_plane = true;
  item.to = plan.motion.target;
  for (int axis = 0; axis < 3; ++axis) item.to[axis] += plan.next.d_radius * plan.next.comp_vector[axis];
  item.rapid = plan.motion.rapid;
  item.feed = plan.motion.feed;
  item.source = c.here();
  c.position = plan.motion.target;
  c.machine = c.chain.machineOf(plan.motion.target);
  return c.pipe.push(item);
}

/// A line under G141.
bool planBeside(IsoContext& c, BlockPlan& plan) {
  const int motion = plan.next.active[kGroupMotion];
  if (motion != gcode::kRapid && motion != gcode::kLine)
    return c.fail("space-comp", "G141 runs lines (G0, G1) only: program G40 before arcs");
  if (plan.next.inCycle()) return c.fail("space-comp", "no drilling cycles under G141");
  if (!axisTarget(c, plan, plan.motion.target)) return false;
  Vec3 vector = Vec3::Zero();
  bool given = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.word("IJK"[axis]);
    if (w == nullptr) continue;
    vector[axis] = w->value;
    given = true;
  }
  if (given) {
    const double length = vector.norm();
    if (!(length > 1e-9) || !std::isfinite(length))
      return c.fail("space-comp", "I, J, K of G141 give no direction");
    for (int axis = 0; axis < 3; ++axis)
      plan.next.comp_vector[static_cast<std::size_t>(axis)] = vector[axis] / length;
  }
  if (!c.anyAxisWord() && !given) return true;
  plan.perform = performBeside;
  plan.motion.rapid = motion == gcode::kRapid;
  return plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

bool performYasnacFrame(IsoContext& c, BlockPlan& plan) {
  const FrameChange& change = std::get<FrameChange>(plan.payload);
  c.registers.frames.system(change.id) = change.system;
  recordFrames(c, plan.next);
  c.chain = c.chainOf(plan.next);
  c.position = c.chain.programOf(c.machine);
  return true;
}

/// Which axes a block names. False: none, reported.
bool namedAxes(IsoContext& c, const BlockPlan& plan, std::string_view code, AxisSet& axes) {
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word)) axes.set(static_cast<std::size_t>(word.axis));
  }
  return axes.any() || c.fail("mirror-axes", fmt::format("{} names the axes that it mirrors: X0, Y0", code));
}

}  // namespace

void noteHaasPath(IsoContext& c, std::string_view code, std::string_view what) {
  if (!c.firstTime(fmt::format("path {}", code))) return;
  c.warn("path-not-proven", fmt::format("{}: {}", code, what), {}, Severity::kNote);
}

bool planHaasMove(IsoContext& c, BlockPlan& plan) {
  if (plan.next.active[kGroupRadiusComp] == gcode::kCompInSpace) return planBeside(c, plan);
  for (const Address a : {'I', 'J', 'K'}) {
    if (const Word* w = c.ownWord(plan, a))
      return c.alarm(SharedAlarm::kIllegalAddress, *w, "a line takes a vector under G141 only");
  }
  return plan.governor->code10 == gcode::kRapid ? planRapid(c, plan) : planLine(c, plan);
}

bool planHaasArc(IsoContext& c, BlockPlan& plan) {
  if (plan.next.active[kGroupRadiusComp] == gcode::kCompInSpace)
    return c.fail("space-comp", "G141 runs lines (G0, G1) only: program G40 before arcs");
  const Word* r = c.ownWord(plan, 'R');
  const bool centre = !(c.block.present & AddressSet("IJK")).empty();
  if (r != nullptr && !centre) {
    bool moves = plan.next.active[kGroupPolarData] == gcode::kPolarData;
    for (const Word& w : c.block.words) {
      AxisWord word;
      if (!axisWord(plan, w, word)) continue;
      const double value = axisValue(c, plan, word, w);
      moves = moves || std::abs(word.step ? value : value - plan.start[word.axis]) > kSamePlaceMm;
    }
    if (!moves) {
      return c.fail("arc-full-r", "a full circle needs its centre by I, J, K: R cannot say where it lies",
                    r->columns);
    }
  }
  return planFanucArc(c, plan);
}

namespace {

bool performHome(IsoContext& c, BlockPlan& plan) {
  const MachineMove& move = std::get<MachineMove>(plan.payload);
  if (!sendMachineRapid(c, move.via) || !sendMachineRapid(c, move.to)) return false;
  c.settle(move.to);
  // As with Fanuc the length offset of these axes is over.
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (plan.next.length[axis] != 0.0) fanucData(c).no_length.set(static_cast<std::size_t>(axis));
  }
  return true;
}

}  // namespace

bool planHaasReference(IsoContext& c, BlockPlan& plan) {
  if (c.anyAxisWord()) return planFanucReference(c, plan);
  const auto& given = c.settings.reference_points[0];
  AxisPoint home(given.value_or(c.emitter.home()));
  for (const AxisSettings& axis : c.settings.axes) {
    if (const int k = c.axes.find(axis.name); k >= kMainAxes) home[k] = axis.reference;
  }
  home = c.axisMap().namesAt(home);
  MachineMove& move = plan.payload.emplace<MachineMove>();
  move.has_via = true;
  move.via = move.to = c.machine;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (c.axisMap().axisOf(axis) == 2)
      move.via[axis] = given ? home[axis] : std::max(home[axis], c.machine[axis]);
  }
  move.to = given ? home : move.via;
  if (!given && c.firstTime("machine-zero")) {
    c.warn("machine-zero",
           "G28: the job gives no reference point (reference_points under [machine]): Z goes up to the start "
           "height, the other axes stay",
           {}, Severity::kNote);
  }
  plan.perform = performHome;
  plan.rebases = true;
  return true;
}

bool planHaasLocalFrame(IsoContext& c, BlockPlan& plan) {
  noteSetting(c, FanucParam::kLocalShift, "G52 shifts every work system (Setting 33 FANUC)");
  if (c.parameters[FanucParam::kLocalShift] == 0.0) return planLocalShift(c, plan);
  FrameChange& change = plan.payload.emplace<FrameChange>();
  change.shift52 = c.registers.frames.shift52;
  change.shift92 = c.registers.frames.shift92;
  change.id = kYasnacFrame;
  change.system = c.registers.frames.system(kYasnacFrame);
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    change.system.offset[word.axis] =
        (word.step ? change.system.offset[word.axis] : 0.0) + axisValue(c, plan, word, w);
  }
  plan.motion.target = plan.start;
  plan.next.work_system = kYasnacFrame;
  plan.perform = performYasnacFrame;
  plan.rebases = true;
  return true;
}

namespace {

/// Row of the dynamic zeros (G54.2 P of the shared rules) that G254 uses.
constexpr int kDynamicRow = 8;

bool performDynamicOffset254(IsoContext& c, BlockPlan& plan) {
  const FrameChange& change = std::get<FrameChange>(plan.payload);
  if (plan.next.five.dynamic_zero > 0) c.registers.dynamic_zeros[kDynamicRow - 1] = change.system.offset;
  c.chain = c.chainOf(plan.next);
  c.position = c.chain.programOf(c.machine);
  return true;
}

}  // namespace

bool planHaasDynamicOffset(IsoContext& c, BlockPlan& plan) {
  constexpr int kOn = 2540;
  const bool on = plan.governor->code10 == kOn;
  if (on && !c.five_axes.hasTable()) {
    return c.fail("machine-data",
                  "G254 needs a rotary table, and the machine of this job has none ([[machine.axis]])");
  }
  plan.motion.target = plan.start;
  plan.next.five.dynamic_zero = on ? kDynamicRow : 0;
  FrameChange& change = plan.payload.emplace<FrameChange>();
  if (on) {
    const WorkSystem common = c.registers.frames.system(0);
    const WorkSystem work = c.registers.frames.system(plan.next.work_system);
    AxisPoint& row = change.system.offset;
    for (std::size_t k = 0; k < row.more.size(); ++k)
      row.more[k] = common.offset.more[k] + work.offset.more[k];
    const RotaryAngles measured = c.five_axes.at(row);
    row.xyz = common.offset.xyz + work.offset.xyz - c.five_axes.dynamicZero(measured, Vec3::Zero(), measured);
  }
  plan.perform = performDynamicOffset254;
  plan.rebases = true;
  return true;
}

bool planHaasMirror(IsoContext& c, BlockPlan& plan) {
  AxisSet axes;
  if (!namedAxes(c, plan, "G101", axes)) return false;
  Transforms& t = plan.next.transforms;
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (axes[static_cast<std::size_t>(axis)]) t.mirror[axis] = 0.0;
  }
  t.mirrored |= axes;
  plan.next.active[kGroupMirror] = gcode::kMirror;
  renewChain(c, plan);
  return true;
}

bool planHaasMirrorOff(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  AxisSet axes;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word)) axes.set(static_cast<std::size_t>(word.axis));
  }
  t.mirrored &= axes.any() ? ~axes : AxisSet();
  plan.next.active[kGroupMirror] = t.mirrored.any() ? gcode::kMirror : gcode::kMirrorOff;
  renewChain(c, plan);
  return true;
}

bool planHaasSpaceComp(IsoContext& c, BlockPlan& plan) {
  if (c.state.compOn()) return c.fail("space-comp", "G141 cannot follow G41 or G42 at once: program G40");
  if (plan.next.d == 0) c.warn("no-d", "no D is programmed: G141 moves by a radius of 0");
  return planBeside(c, plan);
}

bool refuseHaasInput(IsoContext& c, BlockPlan& /*plan*/) {
  for (const Word& w : c.block.words) {
    if (w.address != 'M' || (w.value != 96.0 && w.value != 109.0)) continue;
    return c.failWord("no-input",
                      w.value == 96.0
                          ? "M96 jumps by an input of the machine, which a simulation does not have"
                          : "M109 asks the person at the machine, who is not there",
                      w);
  }
  return true;
}

bool haasWorkSystem(IsoContext& c, BlockPlan& plan, const GCode& code, int& id) {
  constexpr int kByNumber = 1540, kFirst = 1100, kLast = 1290;
  std::int64_t number = 0;
  if (code.code10 == kByNumber) {
    const Word* p = c.word('P');
    if (p == nullptr) return c.alarm(SharedAlarm::kMissingData, "P", "G154 needs P1 to P99");
    if (!integerWord(c, *p, 1, 99, number)) return false;
  } else if (code.code10 >= kFirst && code.code10 <= kLast) {
    number = (code.code10 - kFirst) / 10 + 1;
  } else {
    return true;
  }
  id = kFirstExtended + static_cast<int>(number) - 1;
  plan.next.last.extended_system = static_cast<int>(number);
  return true;
}

}  // namespace proveout::nc
