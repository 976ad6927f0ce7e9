// G54 to G59.3, G10 L2 L20, G52 G92 G92.1 G92.2 G92.3.
#include "core/nc/linuxcnc/frames/frames.h"

#include <fmt/core.h>

#include "core/geometry/degrees.h"
#include "core/nc/iso/context/origins.h"
#include "core/nc/linuxcnc/flavours/flavours.h"

namespace proveout::nc {
namespace {

constexpr int kLcnSystems = 9;

/// Of G54 .. G59, G59.1 .. G59.3 by the code.
int lcnSystemOf(int code10) { return code10 <= 590 ? (code10 - 540) / 10 + 1 : code10 - 591 + 7; }

/// The frames as the block leaves them.
LinuxCncFrames& lcnPending(const IsoContext& c, LinuxCncChannel& own) {
  if (!own.pending) {
    own.pending = LinuxCncFrames{};
    own.pending->shift = own.shift;
    own.pending->shift_on = own.shift_on;
    own.pending->in_force = c.registers.frames.shift92;
  }
  return *own.pending;
}

/// From here on the block's places are those of the pending frames.
bool lcnTakeFrames(IsoContext& c, BlockPlan& plan) {
  const LinuxCncFrames& change = *linuxCncChannel(c).pending;
  WorkFrames frames = c.registers.frames;
  frames.shift92 = change.in_force;
  if (change.id > 0) frames.system(change.id) = change.system;
  plan.new_chain =
      frames.chain(programMap(plan.next.transforms, c.axes), plan.next.work_system, plan.next.length);
  plan.chain = &*plan.new_chain;
  plan.start = plan.motion.target = plan.chain->programOf(c.machine);
  plan.frames_changed = plan.flush = true;
  return true;
}

/// The system of P; 0 is the active one. False: reported.
bool lcnSystemWord(IsoContext& c, const BlockPlan& plan, const char* code, WorkSystemId& id) {
  const Word* p = c.ownWord(plan, 'P');
  // GRBL takes the frame in force where P is missing.
  const double none = isPlainGrbl(c) ? 0.0 : -1.0;
  const double number = p == nullptr ? none : std::floor(p->value + 1e-4);
  if (!(number >= 0.0 && number <= kLcnSystems))
    return lcnFail(c, "data", fmt::format("P value out of range (0-9) with {}", code), p);
  id = number == 0.0 ? plan.next.work_system : linuxCncSystem(static_cast<int>(number));
  return true;
}

bool lcnNoComp(IsoContext& c, const BlockPlan& plan, const char* what) {
  return !lcnCompOn(c, plan) ||
         lcnFail(c, "comp", fmt::format("Cannot change {} with cutter radius compensation on", what));
}

Vec2 lcnTurned(const Vec2& v, double angle_deg) { return Eigen::Rotation2Dd(degToRad(angle_deg)) * v; }

}  // namespace

WorkSystemId linuxCncSystem(int number) { return number <= 6 ? number : kFirstExtended + number - 7; }

void applyLinuxCncFrames(IsoContext& c, const BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  if (own.stores_home != 0) {
    (own.stores_home == 281 ? own.home28 : own.home30) = c.machine;
    own.homes_known = true;
  }
  if (!own.pending) return;
  WorkFrames& frames = c.registers.frames;
  const LinuxCncFrames change = *own.pending;
  own.pending.reset();
  frames.shift92 = change.in_force;
  own.shift = change.shift;
  own.shift_on = change.shift_on;
  if (change.id > 0) {
    const auto offset_by = frames.system(change.id).offset_by;
    frames.system(change.id) = change.system;
    frames.system(change.id).offset_by = offset_by;
  }
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word) || word.axis >= kMainAxes || plan.governor->group == kGroupMotion) continue;
    auto& by = change.id > 0 ? frames.system(change.id).offset_by : frames.shift_by;
    by[static_cast<std::size_t>(word.axis)] = numberOf(c, w, OriginKind::kData);
  }
  recordFrames(c, plan.next);
}

bool planLcnFrame(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupWorkSystem];
  if (code == nullptr) return true;
  if (!lcnNoComp(c, plan, "coordinate systems")) return false;
  plan.next.active[kGroupWorkSystem] = code->code10;
  plan.next.work_system = linuxCncSystem(lcnSystemOf(code->code10));
  plan.frames_changed = true;
  if (linuxCncFlavour(c) == LinuxCncFlavour::kMach3 && (code->code10 == 540 || code->code10 == 590) &&
      !planMach3Frame(c, plan))
    return false;
  if (lacksWorkOffset(c.settings, plan.next.work_system) &&
      c.registers.frames.system(plan.next.work_system).offset == AxisPoint()) {
    const std::string name = gName(code->code10);
    c.warnOnce(name, "offset-missing",
               fmt::format("{0} has no value in the job or the .var file: 0 is taken", name));
  }
  return true;
}

namespace {

/// A fault of the interpreter: it turns the place that it remembers without the shift.
void lcnWarnOfTurn(IsoContext& c, const BlockPlan& plan, const LinuxCncFrames& change) {
  if (change.id != plan.next.work_system || change.in_force.xyz.head<2>().isZero(0.0)) return;
  const double before = c.registers.frames.system(change.id).angles_deg.z();
  if (change.system.angles_deg.z() == before) return;
  c.warnOnce("turn with shift", "turn-with-shift",
             "the turn R of the work system in use changes while a shift of G92 or G52 is in force: the "
             "interpreter of LinuxCNC 2.9 loses the place, so that axes which the next motion does not name "
             "may move, too; here they stay: program G92.1 before it, or name X and Y behind it");
}

}  // namespace

bool planLcnWorkOffset(IsoContext& c, BlockPlan& plan, bool by_place) {
  const char* const code = by_place ? "G10 L20" : "G10 L2";
  WorkSystemId id = 0;
  if (!lcnNoComp(c, plan, "coordinate systems") || !lcnSystemWord(c, plan, code, id)) return false;
  LinuxCncFrames& change = lcnPending(c, linuxCncChannel(c));
  change.id = id;
  change.system = c.registers.frames.system(id);
  WorkSystem& system = change.system;
  if (const Word* r = c.ownWord(plan, 'R')) {
    if (by_place) return lcnFail(c, "data", "R not allowed in G10 L20", r);
    system.angles_deg.z() = r->value;
    lcnWarnOfTurn(c, plan, change);
  }
  // Where the tool stands in the system, without G92 and with the system's zero at 0.
  AxisPoint place = c.machine;
  for (int axis = 0; axis < c.axes.count(); ++axis)
    place[axis] -= plan.next.length[axis] + c.registers.frames.common.offset[axis];
  const double angle = system.angles_deg.z();
  Vec2 turned = lcnTurned(place.xyz.head<2>() - system.offset.xyz.head<2>(), -angle);
  bool plane_named = false;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const double value = axisValue(c, plan, word, w);
    if (!by_place) {
      system.offset[word.axis] = value;
    } else if (word.axis < 2) {
      turned[word.axis] = value + change.in_force[word.axis];
      plane_named = true;
    } else {
      system.offset[word.axis] = place[word.axis] - value - change.in_force[word.axis];
    }
  }
  if (plane_named) system.offset.xyz.head<2>() = place.xyz.head<2>() - lcnTurned(turned, angle);
  plan.perform = performLinuxCncSteps;
  return lcnTakeFrames(c, plan);
}

bool planLcnSetPosition(IsoContext& c, BlockPlan& plan) {
  const bool local = plan.governor->code10 == gcode::kLocalShift;
  if (!lcnAnyAxis(c)) return lcnFail(c, "axis-words", "All axes missing with g52 or g92");
  if (!lcnNoComp(c, plan, "axis offsets")) return false;
  LinuxCncFrames& change = lcnPending(c, linuxCncChannel(c));
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const double value = axisValue(c, plan, word, w);
    double& shift = change.in_force[word.axis];
    shift = local ? value : plan.start[word.axis] + shift - value;
  }
  change.shift = change.in_force;
  change.shift_on = true;
  plan.perform = performLinuxCncSteps;
  return lcnTakeFrames(c, plan);
}

bool planLcnShiftOff(IsoContext& c, BlockPlan& plan) {
  if (!lcnNoComp(c, plan, "axis offsets")) return false;
  LinuxCncFrames& change = lcnPending(c, linuxCncChannel(c));
  switch (plan.by_group[kOneShot]->code10) {
    case 921:
      change.shift = AxisPoint();
      [[fallthrough]];
    case 922:
      change.in_force = AxisPoint();
      change.shift_on = false;
      break;
    default:
      change.in_force = change.shift;
      change.shift_on = true;
  }
  return lcnTakeFrames(c, plan);
}

bool planLcnHome(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  if (lcnCompOn(c, plan))
    return lcnFail(c, "comp", "Cannot use g28 or g30 with cutter radius compensation on");
  if (!lcnTarget(c, plan, plan.motion.target)) return false;
  const AxisPoint& home = plan.governor->code10 == gcode::kReference ? own.home28 : own.home30;
  const AxisPoint stored = plan.chain->programOf(home);
  AxisPoint to = plan.motion.target;
  using Kind = LinuxCncStep::Kind;
  // Without words too: what compensation has left over is made good first.
  own.steps.push_back({.kind = Kind::kRapid, .to = plan.motion.target});
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (!lcnAnyAxis(c) || plan.motion.named[static_cast<std::size_t>(axis)]) to[axis] = stored[axis];
  }
  own.steps.push_back({.kind = Kind::kMachineRapid, .to = plan.chain->machineOf(to)});
  if (!own.homes_known)
    c.warnOnce(
        "home", "machine-zero",
        "G28, G30: neither the program (G28.1, G30.1) nor the job ([machine] reference_points, the .var "
        "file) says where this place is: machine zero is taken",
        {});
  plan.perform = performLinuxCncSteps;
  plan.rebases = true;
  plan.motion.rapid = true;
  return true;
}

bool planLcnStoreHome(IsoContext& c, BlockPlan& plan) {
  if (plan.governor->plan == planLcnProbe || plan.governor->plan == planLcnNurbs ||
      plan.governor->plan == planLcnKnots)
    return lcnFail(c, "home", "G28.1 and G30.1 stand in a line without a probing move or a spline here");
  linuxCncChannel(c).stores_home = plan.by_group[kOneShot]->code10;
  return true;
}

}  // namespace proveout::nc
