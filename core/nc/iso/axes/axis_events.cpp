#include "core/nc/iso/axes/axis_events.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace proveout::nc {
namespace {

/// Cosine of the angle between axes that are taken to be at right angles: 0.006 degrees off.
constexpr double kRightAngle = 1e-4;

/// Programs are written in a rectangular frame: the manual for mills has no inclined axes (20.8).
bool checkRightAngles(IsoContext& c) {
  if (!c.settings.machine) return true;
  const std::vector<MachineAxis>& axes = c.settings.machine->axes;
  for (std::size_t a = 0; a < kMainAxes; ++a) {
    for (std::size_t b = a + 1; b < kMainAxes; ++b) {
      const double cosine = axes[a].direction.dot(axes[b].direction);
      if (std::abs(cosine) <= kRightAngle) continue;
      return c.fail(
          "inclined-axis",
          fmt::format("axes {} and {} stand at {:.6g} degrees to each other: this control moves X, Y "
                      "and Z at right angles only, inclined axes are those of its lathes (manual "
                      "20.8)",
                      axes[a].name, axes[b].name, radToDeg(std::acos(std::clamp(cosine, -1.0, 1.0)))));
    }
  }
  return true;
}

/// A code of the control itself, or one that parameters make so.
bool isTakenCode(const MFunction& row) {
  return row.own != nullptr || row.waits || row.of_place || row.interrupt != InterruptSwitch::kNone ||
         row.of_spindles || row.closes_loop.any() || row.indexes.any();
}

bool checkCodes(IsoContext& c) {
  c.m_index.update(c.parameters);
  for (const MachineEvent& event : c.settings.events) {
    if (isTakenCode(c.m_index.find(event.code)))
      return c.fail("settings", fmt::format("[[machine.event]]: M{} means something to the control already: "
                                            "give the event another code",
                                            event.code));
  }
  return true;
}

std::string placeOfFault(const EventFault& fault) {
  if (fault.where == EventFault::Where::kEvent) return fmt::format("[[machine.event]] {}", fault.index + 1);
  return "[machine]";
}

/// An event on its way: what the axes are to be, and what is against it.
class AxisSwitch {
 public:
  AxisSwitch(IsoContext& c, const MachineEvent& event)
      : c_(c), event_(event), map_(c.axisMap()), name_(fmt::format("M{}", event.code)) {
    at_ = c.emitter.machine();
    const AxisPoint programmed = map_.byAxis(c.machine);
    for (int axis = 0; axis < c.axes.count(); ++axis) {
      if (c.state.compOn() || map_.parked().test(static_cast<std::size_t>(axis)))
        at_[axis] = programmed[axis];
    }
  }

  bool run() {
    if (!mayRun()) return false;
    for (const AxisMode mode : event_.release) release(mode);
    if (!exchange() || !turnHead()) return false;
    for (const std::string& name : event_.reverse) map_.reverse(c_.axes.find(name));
    for (const AxisPair& pair : event_.couple) {
      if (!couple(pair)) return false;
    }
    for (const std::string& name : event_.park) map_.park(c_.axes.find(name), c_.emitter.machine());
    commit();
    return true;
  }

 private:
  bool fail(const std::string& why) { return c_.fail("axis-mode", fmt::format("{}: {}", name_, why)); }

  bool releases(AxisMode mode) const {
    return std::find(event_.release.begin(), event_.release.end(), mode) != event_.release.end();
  }
  /// Does it change by which name and in which direction an axis moves?
  bool renames() const {
    return event_.exchange || event_.head || !event_.reverse.empty() || releases(AxisMode::kExchange) ||
           releases(AxisMode::kReverse) || releases(AxisMode::kHead);
  }

  bool mayRun() {
    const bool parks = !event_.park.empty() || releases(AxisMode::kPark);
    if (c_.state.axes.mode != VirtualMode::kOff)
      return fail("axes cannot change during G12.1 and G7.1: end the mode first");
    if (c_.state.compOn() && (renames() || parks))
      return fail("axes cannot change under G41 and G42: program G40 first");
    if (!renames()) return true;
    if (map_.parked().any() && !releases(AxisMode::kPark))
      return fail("names and directions cannot change while an axis is parked: release that first");
    if (c_.state.five.any())
      return fail("axes cannot change under functions of five axes: program G49, G69.1 or G54 first");
    return !c_.state.inCycle() || fail("axes cannot change in a drilling cycle: program G80 first");
  }

  void release(AxisMode mode) {
    switch (mode) {
      case AxisMode::kCouple:
        return map_.uncouple();
      case AxisMode::kPark:
        at_ = c_.emitter.machine();  // where they have stood
        return map_.unpark(at_);
      case AxisMode::kExchange:
        if (!horizontal()) map_.unexchange();
        return;
      case AxisMode::kReverse:
        map_.unreverse();
        if (horizontal()) map_.reverse(0);
        return;
      case AxisMode::kHead:
        return standUpright();
    }
  }

  bool horizontal() const { return c_.registers.head == HeadPosition::kHorizontal; }

  bool swaps(int first, int second) {
    if (map_.axisOf(first) == second && map_.axisOf(second) == first) return true;  // they are
    for (const int axis : {first, second}) {
      if (map_.axisOf(axis) != axis)
        return fail(fmt::format("axis {} is exchanged already: release that first", c_.axes.at(axis).name));
    }
    map_.exchange(first, second);
    return true;
  }

  bool exchange() {
    if (!event_.exchange) return true;
    if (horizontal()) return fail("the horizontal head has exchanged axes already: release it first");
    return swaps(c_.axes.find(event_.exchange->first), c_.axes.find(event_.exchange->second));
  }

  void standUpright() {
    if (!horizontal()) return;
    map_.unexchange();
    map_.unreverse(0);
    c_.registers.head = HeadPosition::kVertical;
    const SpindleMount mount = c_.settings.machine ? c_.settings.machine->spindle : SpindleMount();
    c_.emitter.turnHead(mount.direction, mount.gauge);
  }

  /// Manual 20.5: with the tool along Y, what was Z before; X goes the other way, so that the frame is
  /// right-handed.
  bool turnHead() {
    if (!event_.head) return true;
    if (*event_.head == HeadPosition::kVertical) {
      standUpright();
      return true;
    }
    if (horizontal()) return true;
    if (map_.exchanged() || map_.reversed().any())
      return fail("axes are exchanged or reversed already: release that before the head turns");
    map_.reverse(0);
    c_.registers.head = HeadPosition::kHorizontal;
    c_.emitter.turnHead(Vec3::UnitY(), event_.gauge.value_or(Vec3::Zero()));
    return swaps(1, 2);
  }

  bool couple(const AxisPair& pair) {
    const int master = c_.axes.find(pair.first), slave = c_.axes.find(pair.second);
    const bool opposite =
        std::find(event_.opposite.begin(), event_.opposite.end(), pair.second) != event_.opposite.end();
    if (const AxisFollow* there = map_.followOf(slave)) {
      if (there->master == master && (there->sign < 0.0) == opposite) return true;
      return fail(fmt::format("axis {} follows {} already: release that first", pair.second,
                              c_.axes.at(there->master).name));
    }
    if (!map_.canFollow(master, slave))
      return fail(fmt::format("axis {} would follow itself in the end", pair.second));
    map_.couple(master, slave, opposite, at_);
    return true;
  }

  /// Lengths stay with their axis; they are told by name.
  void moveLengths() {
    const AxisPoint by_axis = c_.axisMap().byAxis(c_.state.length);
    const AxisPoint by_name = map_.namesAt(by_axis);
    if (by_name == c_.state.length) return;
    c_.state.length = by_name;
    c_.warnOnce("axis length " + name_, "axis-length",
                fmt::format("{}: a length offset is in force and goes with its axis to another name: program "
                            "G49 before, and the new offset behind (manual 20.3)",
                            name_));
  }

  void commit() {
    moveLengths();
    c_.registers.frames.axes = map_;
    if (map_.plain()) {
      c_.pipe.unlink(c_.stages.axes);
    } else {
      c_.pipe.link(c_.stages.axes);
    }
    // Else the stage goes on from where the program has taken parked axes.
    if (renames() || releases(AxisMode::kPark) || map_.plain()) c_.stages.axes.clear();
    c_.chain = c_.chainOf(c_.state);
    c_.machine = map_.namesAt(at_);
    c_.position = c_.chain.programOf(c_.machine);
    if (renames()) c_.rebasePipe();
  }

  IsoContext& c_;
  const MachineEvent& event_;
  AxisMap map_;
  const std::string name_;
  AxisPoint at_;  ///< where the axes are as far as the control knows: parked ones as if they had moved
};

}  // namespace

bool checkMachineAxes(IsoContext& c) {
  if (const auto faults = eventFaults(c.settings); !faults.empty())
    return c.fail("settings", fmt::format("{}: {}", placeOfFault(faults.front()), faults.front().text));
  return checkCodes(c) && checkRightAngles(c);
}

void levelDrives(IsoContext& c) {
  AxisMap& map = c.registers.frames.axes;
  for (const auto* pairs : {&c.settings.gantry, &c.settings.tandem}) {
    for (const AxisPair& pair : *pairs) {
      const int master = c.axes.find(pair.first), slave = c.axes.find(pair.second);
      c.emitter.placeIdle(slave, c.emitter.machine()[master]);
      if (map.followOf(slave) == nullptr) map.couple(master, slave, false, c.emitter.machine(), true);
    }
  }
  if (!map.plain()) c.pipe.link(c.stages.axes);
}

bool performAxisEvent(IsoContext& c, const MachineEvent& event) {
  return c.pipe.flush(FlushReason::kBuffer) && AxisSwitch(c, event).run();
}

void followMasters(IsoContext& c) {
  const AxisMap& map = c.axisMap();
  if (map.slaves().none()) return;
  c.machine = map.followed(c.machine);
  const AxisPoint position = c.chain.programOf(c.machine);
  for (int name = 0; name < c.axes.count(); ++name) {
    if (map.isSlave(name)) c.position[name] = position[name];
  }
}

bool checkAxisModes(IsoContext& c, const BlockPlan& plan) {
  if (!c.stages.axes.linked() || c.axisMap().onlyDrives()) return true;  // nearly always the first
  if (plan.next.axes.mode != VirtualMode::kOff)
    return c.fail("axis-mode",
                  "G12.1 and G7.1 are not simulated while axes are exchanged, reversed, coupled or "
                  "parked: release them first");
  return c.axisMap().named() || !plan.next.five.any() ||
         c.fail("axis-mode",
                "functions of five axes are not simulated while axes are exchanged or reversed: "
                "release them first");
}

}  // namespace proveout::nc
