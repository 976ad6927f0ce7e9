// G12.1, G13.1 and G7.1: planes with a rotary axis that stands for a linear one (manual 4.5, 4.6).
#include "core/nc/iso/motion/virtual_plane.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr double kZero = 1e-6;  ///< mm or deg: the control's increment

const char* modeName(VirtualMode mode) { return mode == VirtualMode::kPolar ? "G12.1" : "G7.1"; }

/// Functions that turn coordinates, or move them with the rotary axes: a virtual plane counts on neither.
bool isOfFiveAxes(const GCode& code) {
  switch (code.code10) {
    case gcode::kLengthAlongTool:
    case gcode::kTipByAngles:
    case gcode::kTipByVector:
    case gcode::kToolDirection:
    case gcode::kToolDirectionAboutTip:
    case gcode::kSpaceRotation:
    case gcode::kTiltedPlane:
      return true;
    default:
      return false;
  }
}

bool forbidden(const GCode& code, VirtualMode mode) {
  switch (code.code10) {
    case gcode::kLocalShift:
    case gcode::kMachineMove:
    case gcode::kSetPosition:
    case gcode::kReference:  // not in the manual's list of G7.1, but they leave the surface that it counts on
    case gcode::kNumberedReference:
    case gcode::kSkip:
      return true;
    default:
      break;
  }
  if (code.group == kGroupPlane || code.group == kGroupWorkSystem) return true;
  if (isOfFiveAxes(code)) return true;
  return mode == VirtualMode::kCylinder && code.group == kGroupCycle && code.code10 != gcode::kCycleCancel;
}

/// Linear and rotary axis of the plane.
bool virtualAxes(IsoContext& c, const AxisModal& modal, int& linear, int& rotary) {
  const bool first = c.axes.at(modal.plane_u).rotary(), second = c.axes.at(modal.plane_v).rotary();
  if (first == second) {
    return c.alarm(SharedAlarm::kPlane, "",
                   "a block G17, G18 or G19 with a linear and a rotary axis must stand before");
  }
  linear = first ? modal.plane_v : modal.plane_u;
  rotary = first ? modal.plane_u : modal.plane_v;
  return true;
}

bool readyForMode(IsoContext& c, const BlockPlan& plan, const char* name) {
  if (plan.next.compOn()) {
    return c.fail("virtual-comp", fmt::format("{} needs G40: cutter compensation is on", name));
  }
  if (plan.next.five.follows()) {
    return c.fail(
        "virtual-frame",
        fmt::format("{} cannot be switched on while coordinates follow the rotary axes (G43.1, G43.4, "
                    "G43.5, G53.1, G54.2)",
                    name));
  }
  if (plan.next.transforms.any() || plan.chain->turns()) {
    return c.fail("virtual-frame",
                  fmt::format("{} cannot be switched in a rotated coordinate system, nor while mirroring, "
                              "scaling or rotation (G51.1, G51, G68) is on",
                              name));
  }
  return true;
}

bool performMode(IsoContext& c, BlockPlan& plan) {
  if (!c.flushPipe()) return false;
  const AxisModal& next = plan.next.axes;
  const bool off = next.mode == VirtualMode::kOff;
  const VirtualMode named = off ? c.state.axes.mode : next.mode;
  const int linear = off ? c.state.axes.linear : next.linear,
            rotary = off ? c.state.axes.rotary : next.rotary;
  event::VirtualPlane told{
      modeName(named), !off, c.axes.at(linear).name + " " + c.axes.at(rotary).name, {}, {}};
  if (named == VirtualMode::kCylinder && !off) told.radius = next.cylinder_mm;
  const double aside = c.parameters.value(AxisParam::kPolarOffset, c.axes.at(rotary).number);
  if (named == VirtualMode::kPolar && !off && aside != 0.0) told.offset = aside;
  if (!sendEvent(c, std::move(told))) return false;
  if (off) {
    const AxisPoint machine = c.stages.virtual_plane.machine();
    c.stages.virtual_plane.end();
    c.settle(machine);
  } else {
    c.stages.virtual_plane.begin(next, c.position, c.machine);
    c.settle(c.machine);
    const double error = c.emitter.polarError(c.stages.virtual_plane.plane());
    if (named == VirtualMode::kPolar && error > kZero) {
      c.warn("polar-center",
             fmt::format(
                 "G12.1: the tool's way runs {:.6g} mm beside the centre of axis {}: the part gets another "
                 "shape than the program's",
                 error, c.axes.at(rotary).name));
    }
  }
  plan.rebases = true;
  return true;
}

}  // namespace

bool ownBlock(IsoContext& c, std::string_view name) {
  for (const Word& w : c.block.words) {
    if (w.axis < 0 && w.address != 'G') {
      return c.failWord("own-block", fmt::format("{} stands in a block of its own", name), w);
    }
  }
  if (c.block.words.size() <= 1 || c.block.words[1].address != 'G') return true;
  return c.failWord("own-block", fmt::format("{} stands in a block of its own", name), c.block.words[1]);
}

bool ownBlockOf(IsoContext& c, std::string_view name, AddressSet words) {
  int codes = 0;
  for (const Word& w : c.block.words) {
    if (w.address == 'G' && ++codes == 1) continue;
    if (!words.has(w.address) || w.axis >= kMainAxes) {
      return c.failWord("own-block", fmt::format("{} stands in a block of its own", name), w);
    }
  }
  return true;
}

bool checkVirtual(IsoContext& c, const BlockPlan& plan) {
  const VirtualMode mode = c.state.axes.mode;
  for (const GCode* code : plan.by_group) {
    if (code == nullptr || !forbidden(*code, mode)) continue;
    return c.fail("virtual-forbidden",
                  fmt::format("{} is not allowed during {}", gName(code->number10()), modeName(mode)));
  }
  if (mode == VirtualMode::kPolar && plan.by_group[kGroupCycle] && plan.next.inCycle()) {
    c.warn("virtual-cycle", "a drilling cycle during G12.1: the manual does not say what it does");
  }
  return true;
}

bool planPolarOn(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  if (c.block.words.size() != 1) return c.fail("own-block", "G12.1 stands in a block of its own");
  AxisModal& modal = plan.next.axes;
  if (modal.mode == VirtualMode::kCylinder) return c.fail("virtual-forbidden", "G12.1 during G7.1");
  if (modal.mode == VirtualMode::kPolar) {
    c.warn("virtual-on", "G12.1 is on already: no effect");
    return true;
  }
  int linear = 0, rotary = 0;
  if (!virtualAxes(c, modal, linear, rotary)) return false;
  if (linear != modal.plane_u)
    return c.alarm(SharedAlarm::kPlane, "", "the linear axis must be the first of the plane");
  if (!readyForMode(c, plan, "G12.1")) return false;
  const double period = c.parameters.value(AxisParam::kRolloverPeriod, c.axes.at(rotary).number);
  if (std::abs(std::remainder(plan.start[rotary], period)) > kZero) {
    return c.fail("polar-start", fmt::format("G12.1: axis {} must stand at 0", c.axes.at(rotary).name));
  }
  if (std::abs(plan.start[linear]) <= kZero) {
    return c.fail("polar-start", fmt::format("G12.1: axis {} must not stand at 0", c.axes.at(linear).name));
  }
  modal.mode = VirtualMode::kPolar;
  modal.linear = static_cast<std::int8_t>(linear);
  modal.rotary = static_cast<std::int8_t>(rotary);
  plan.perform = performMode;
  return true;
}

bool planPolarOff(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  AxisModal& modal = plan.next.axes;
  if (modal.mode == VirtualMode::kPolar && c.block.words.size() != 1) {
    return c.fail("own-block", "G13.1 stands in a block of its own");
  }
  if (modal.mode != VirtualMode::kPolar) return true;
  if (!readyForMode(c, plan, "G13.1")) return false;
  modal.mode = VirtualMode::kOff;
  plan.perform = performMode;
  return true;
}

bool planCylinder(IsoContext& c, BlockPlan& plan) {
  plan.motion.target = plan.start;
  if (c.block.words.size() != 2 || !c.anyAxisWord()) {
    return c.fail("own-block",
                  "G7.1 takes a rotary axis with the radius of the cylinder, in a block of its own");
  }
  const Word& word = c.block.words[c.block.words[0].address == 'G' ? 1 : 0];
  if (word.axis < 0 || !c.axes.at(word.axis).rotary())
    return c.alarm(SharedAlarm::kAxis, word, "G7.1 takes a rotary axis");
  if (word.incremental) return c.alarm(SharedAlarm::kIncremental, word, "the word of G7.1 is a radius");
  const double radius = lengthOf(plan, word);
  if (!(radius >= 0.0))
    return c.alarm(SharedAlarm::kOutOfRange, word, "the radius of the cylinder is not negative");
  AxisModal& modal = plan.next.axes;
  if (modal.mode == VirtualMode::kPolar) return c.fail("virtual-forbidden", "G7.1 during G12.1");
  const bool on = modal.mode == VirtualMode::kCylinder;
  if (on && word.axis != modal.rotary)
    return c.alarm(SharedAlarm::kAxis, word, "G7.1 is on for another axis");
  if (!on && radius == 0.0) return true;
  if (on && radius > 0.0) {
    return c.fail("virtual-on", fmt::format("G7.1 is on: end it with radius 0 first"), word.columns);
  }
  int linear = modal.linear, rotary = modal.rotary;
  if (!on && !virtualAxes(c, modal, linear, rotary)) return false;
  if (rotary != word.axis)
    return c.alarm(SharedAlarm::kPlane, "", "the rotary axis of G7.1 is not in the plane", word.columns);
  if (!readyForMode(c, plan, "G7.1")) return false;
  modal.mode = on ? VirtualMode::kOff : VirtualMode::kCylinder;
  modal.linear = static_cast<std::int8_t>(linear);
  modal.rotary = static_cast<std::int8_t>(rotary);
  modal.cylinder_mm = radius;
  plan.perform = performMode;
  return true;
}

}  // namespace proveout::nc
