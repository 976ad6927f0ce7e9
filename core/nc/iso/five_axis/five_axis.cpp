#include "core/nc/iso/five_axis/five_axis.h"

#include <fmt/core.h>

#include <cmath>
#include <complex>

#include "core/nc/iso/context/words.h"
#include "core/nc/iso/parameters/five_axis.h"

namespace proveout::nc {

namespace {

/// A length whose end is so far beside the tool is not along it, mm.
constexpr double kBeside = 1e-3;

/// Places nearer than this are one, mm.
constexpr double kSamePlaceMm = 1e-9;

/// N3212.FOS: coordinates change, the linear axes stand.
bool byTransformation(const IsoContext& c) { return c.parameters.flag(FiveAxisParam::kByTransformation); }

bool isCalled(const BlockPlan& plan, IsoGroup group, std::int32_t code10) {
  const GCode* code = plan.by_group[group];
  return code != nullptr && code->code10 == code10;
}

}  // namespace

bool turnsRotaryAxes(const IsoContext& c, const AxisPoint& machine) {
  constexpr double kTurnsDeg = 1e-9;  // a thousandth of the increment; zeros leave less behind
  const RotaryAngles from = c.five_axes.at(c.machine), to = c.five_axes.at(machine);
  return std::abs(to.first - from.first) > kTurnsDeg || std::abs(to.second - from.second) > kTurnsDeg;
}

bool hasFiveAxes(IsoContext& c, const char* name) {
  return c.five_axes.kind != FiveAxisKind::kNone ||
         c.fail("machine-data",
                fmt::format("{} needs a head or a table, and the machine of this job has none "
                            "([[machine.axis]])",
                            name));
}

bool planLengthAlongTool(IsoContext& c, BlockPlan& plan) {
  if (!hasFiveAxes(c, "G43.1")) return false;
  plan.next.length = AxisPoint();
  plan.next.five.along_tool = true;
  plan.frames_changed = plan.flush = true;
  return true;
}

namespace {

/// G54 to G59 or G54.1, tenfold.
std::int32_t codeOfWorkSystem(WorkSystemId id) {
  return id >= kFirstExtended ? gcode::kExtendedWorkSystem : gcode::kWorkSystem1 + 10 * (id - 1);
}

}  // namespace

bool planDynamicZero(IsoContext& c, BlockPlan& plan) {
  if (!c.five_axes.hasTable())
    return c.fail("machine-data",
                  c.parameters.name(FiveAxisParam::kMechanicalType).empty()
                      ? "G54.2 needs a rotary table, and the machine of this job has none ([[machine.axis]])"
                      : fmt::format("G54.2 needs a machine with a rotary table ({} = 2 or 3)",
                                    c.parameters.name(FiveAxisParam::kMechanicalType)));
  const Word* p = c.word('P');
  std::int64_t number = 0;
  if (p == nullptr) return c.alarm(SharedAlarm::kMissingData, "P", "G54.2 needs P1 to P8");
  const bool may_end = c.dialect.rules.dynamic_zero_off;
  if (!integerWord(c, *p, may_end ? 0 : 1, static_cast<std::int64_t>(c.registers.dynamic_zeros.size()),
                   number))
    return false;
  if (number == 0) plan.next.active[kGroupWorkSystem] = codeOfWorkSystem(plan.next.work_system);
  plan.next.five.dynamic_zero = static_cast<std::int8_t>(number);
  plan.next.five.on_table = false;
  plan.flush = true;
  return true;
}

bool holdsPosition(const IsoContext& c, const BlockPlan& plan) {
  if (isCalled(plan, kGroupWorkSystem, gcode::kDynamicZero)) return c.anyAxisWord() || !byTransformation(c);
  return isCalled(plan, kGroupLengthComp, gcode::kLengthAlongTool) && c.anyAxisWord() && !byTransformation(c);
}

namespace {

/// Behind G53.1 the tool stands along Z of the tilted plane, until a block turns it away.
void warnOfToolBesidePlane(IsoContext& c, const BlockPlan& plan, const RotaryAngles& to) {
  const FiveAxisState& five = plan.next.five;
  if (!five.tilted || !five.on_table || five.tip != TipControl::kOff) return;
  const Mat3 basic = basicRotation(c.registers.frames.system(plan.next.work_system).angles_deg);
  const Vec3 normal = basic * five.tilt.linear.col(2);
  if (c.five_axes.toolVector(to).cross(normal).norm() <= kAlongToolSine || !c.firstTime("tool-beside-plane"))
    return;
  c.warn("tool-beside-plane",
         "this block turns the tool away from Z of the tilted plane; here the plane stays on the workpiece "
         "(the manual does not say what becomes of it)");
}

}  // namespace

bool followRotaryAxes(IsoContext& c, BlockPlan& plan, AxisPoint& target) {
  const AxisPoint end = plan.chain->machineOf(target);
  if (!turnsRotaryAxes(c, end)) return true;
  if (c.state.compOn() || plan.next.compOn())
    return c.fail(
        "rotary-in-comp",
        "a rotary axis that the coordinates depend on cannot turn while cutter compensation (G41, G42) is "
        "on: program G40 first");
  warnOfToolBesidePlane(c, plan, c.five_axes.at(end));
  plan.new_chain = c.chainOf(plan.next, end);
  plan.chain = &*plan.new_chain;
  plan.frames_changed = plan.flush = true;
  // `target` holds the old coordinates of axes without a word.
  if (!byTransformation(c) || plan.next.five.tip != TipControl::kOff) return true;
  AxisPoint stands = c.machine;
  stands.more = end.more;
  stands = plan.chain->programOf(stands);
  for (int axis = 0; axis < kMainAxes; ++axis) {
    if (plan.motion.named[static_cast<std::size_t>(axis)]) continue;
    plan.start[axis] = target[axis] = stands[axis];
  }
  return true;
}

bool carryArc(IsoContext& c, BlockPlan& plan) {
  if (!plan.next.five.follows() || plan.next.five.tip != TipControl::kOff) return true;
  const WorkPlane plane = plan.next.workPlane();
  const AxisPoint stands = plan.chain->programOf(c.machine);
  const Vec3 moved = plane.of(stands) - plane.of(plan.start);
  if (moved.norm() <= kSamePlaceMm) return true;
  if (plan.next.five.on_table)
    return c.fail(
        "rotary-in-arc",
        "an arc cannot turn a rotary axis behind G53.1 and G53.6: its plane turns; G43.4 holds the tip "
        "on an arc");
  // The similar figure between the ends as they are now: where only the start has moved along with the end,
  // the programmed arc; where the offset has turned by the arc's own angle, one about the same centre.
  using Complex = std::complex<double>;
  PlaneArc& arc = plan.motion.arc;
  const auto at = [](const auto& p) { return Complex(p.x(), p.y()); };
  const Complex from = at(plane.of(stands)), chord = at(arc.end) - at(arc.start);
  const Complex center = from + (at(arc.center) - at(arc.start)) * (at(arc.end) - from) / chord;
  arc.start = plane.of(stands);
  arc.center = {center.real(), center.imag()};
  plan.start = stands;
  constexpr double kFarthestMm = 1e4;  // beyond it the ends of what was nearly a full circle have parted
  return (std::abs(chord) > kSamePlaceMm && farthestFromStart(arc) <= kFarthestMm) ||
         c.fail("rotary-in-arc",
                "a rotary axis moves the start of this full circle away from its end: the control point has "
                "no circle to go; G43.4 holds the tip on one");
}

void warnOfLengthBesideTool(IsoContext& c, const BlockPlan& plan, const AxisPoint& target) {
  const int mode = plan.next.active[kGroupLengthComp];
  if (!c.five_axes.hasHead() || plan.next.five.along_tool ||
      (mode != gcode::kLengthPlus && mode != gcode::kLengthMinus) ||
      plan.next.active[kGroupMotion] == gcode::kRapid)
    return;
  const Vec3& length = plan.next.length.xyz;
  const Vec3 tool = c.five_axes.spindleVector(c.five_axes.at(plan.chain->machineOf(target)));
  if (length.cross(tool).norm() <= kBeside) return;
  if (!c.firstTime("length-beside-tool")) return;
  c.warn(
      "length-beside-tool",
      fmt::format("the head leans the tool towards {:.4f}, {:.4f}, {:.4f}, and {} lays its length of {:g} mm "
                  "along a main axis: the tip is not where the program says; G43.1 lays it along the tool",
                  tool.x(), tool.y(), tool.z(), mode == gcode::kLengthPlus ? "G43" : "G44", length.norm()));
}

}  // namespace proveout::nc
