// Execution of a planned block: functions, motions, register changes, commit.
#include "core/nc/iso/perform/perform.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/axes/axis_events.h"
#include "core/nc/iso/block/auxiliary.h"
#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/tip_control.h"
#include "core/nc/iso/spindle/spindle.h"
#include "core/nc/iso/system_variables/status_bank.h"
#include "core/nc/iso/tools/tools.h"

namespace proveout::nc {

namespace {

bool switchCompInPlace(IsoContext& c, BlockPlan& plan);

/// The tool that T names is there before the block moves. Where the machine went elsewhere for it, axes
/// without a word stay there.
bool changeToolFirst(IsoContext& c, BlockPlan& plan) {
  if (!sendToolChange(c, plan.next.next_tool, plan.next.next_row)) return false;
  const AxisPoint at = plan.chain->programOf(c.machine);
  for (int axis = 0; axis < c.axes.count(); ++axis) {
    if (!plan.motion.named[static_cast<std::size_t>(axis)]) plan.motion.target[axis] = at[axis];
  }
  plan.start = at;
  return true;
}

bool tellIdle(IsoContext& c, const BlockPlan& plan);

/// A block that cutter compensation cannot look for a corner in; calls and returns are none.
bool staysInPlane(const BlockPlan& plan) {
  if (plan.flow != nullptr && plan.flow->phase == MPhase::kCall) return false;
  if (plan.governor->code10 == gcode::kCornerArc || plan.motion.is_arc) return false;
  if (plan.perform != performMove && !std::holds_alternative<Holes>(plan.payload)) return true;
  const WorkPlane plane = plan.next.workPlane();
  return plan.start[plane.u] == plan.motion.target[plane.u] &&
         plan.start[plane.v] == plan.motion.target[plane.v];
}

}  // namespace

bool perform(IsoContext& c, BlockPlan& plan) {
  recordWords(c, plan);
  if (plan.flush && !c.pipe.flush(FlushReason::kBuffer)) return false;
  if (!plan.runs_functions && !performFunctions(c, plan, MPhase::kBefore)) return false;
  if (plan.tool_change && c.dialect.rules.offsets_by_tool && !changeToolFirst(c, plan)) return false;
  if (plan.transforms_changed) {
    if (!c.pipe.flush(FlushReason::kTransform)) return false;
    c.map = programMap(plan.next.transforms, c.axes);
  }
  if (plan.frames_changed || plan.transforms_changed) {
    c.chain = *plan.new_chain;
    c.position = plan.start;
  }
  if (plan.frames_changed) c.rebasePipe();
  c.state.takePlane(plan.next);  // arcs and pieces are turned by it
  // What a block of G68.2 has told is for the next one alone.
  const TiltInput* tilt = std::get_if<TiltInput>(&plan.payload);
  if (tilt != nullptr || c.registers.tilt_input.form != 0)
    c.registers.tilt_input = tilt != nullptr ? *tilt : TiltInput();
  const bool done = plan.perform ? plan.perform(c, plan) : switchCompInPlace(c, plan);
  if (!done) return false;
  if (c.dialect.compensation != nullptr && c.stages.comp.linked() && !tellIdle(c, plan)) return false;
  if (plan.rebases) c.rebasePipe();
  // Functions changed these while the block ran.
  plan.next.spindle_direction = c.state.spindle_direction;
  plan.next.tool = c.state.tool;
  plan.next.tool_row = c.state.tool_row;
  c.state = plan.next;
  followMasters(c);
  return performFunctions(c, plan, MPhase::kAfter) &&
         (!plan.tool_shape || c.state.tool == 0 || sendToolShape(c)) &&
         performFunctions(c, plan, MPhase::kStop);
}

namespace {

bool function(IsoContext& c, const BlockPlan& plan, const MFunction& found, int m) {
  bool handled = false;
  if (!spindleFunction(c, plan, found, m, handled)) return false;
  if (handled) return true;
  if (found.event != nullptr && !performAxisEvent(c, *found.event)) return false;
  switch (m) {
    case mcode::kToolChange:
      if (plan.next.next_tool >= 0) return sendToolChange(c, plan.next.next_tool, plan.next.next_row);
      c.warn("no-t", "M6 without T: the tool stays");
      return sendToolChange(c, c.state.tool, c.state.tool_row);
    default:
      break;
  }
  // Functions that only tell something: stops, coolant, gears, the machine builder's.
  const std::string code = fmt::format("M{}", m);
  switch (m) {
    case mcode::kStop:
      return sendEvent(c, event::Stop{code, ""});
    case mcode::kOptionalStop:
      return sendEvent(c, event::OptionalStop{code, c.settings.optional_stop});
    case mcode::kSecondCoolantOn:
      if (found.own == nullptr) break;
      return sendEvent(c, event::Coolant{code, true});
    case mcode::kCoolantOn:
    case mcode::kCoolantOff:
      return sendEvent(c, event::Coolant{code, m == mcode::kCoolantOn});
    default:
      break;
  }
  return sendEvent(c, event::Function{code, {}});
}

}  // namespace

bool performFunctions(IsoContext& c, BlockPlan& plan, MPhase phase) {
  if (phase == MPhase::kBefore && plan.tool_called) countToolCall(c, plan);
  if (phase == MPhase::kBefore && !performSpindle(c, plan)) return false;
  bool spindle_done = false;
  for (int i = 0; i < plan.m_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (plan.m[k]->phase() != phase) continue;
    // In a drilling block M functions run at the first hole, behind the positioning (manual 18.2).
    if (!function(c, plan, *plan.m[k], plan.m_value[k])) return false;
    countPart(c, plan.m_value[k]);
    spindle_done = spindle_done || mcode::turns(plan.m_value[k]);
  }
  if (phase == MPhase::kBefore && plan.spindle_changed && !spindle_done && c.state.spindle_direction != 0) {
    return sendSpindle(c, c.state.spindle_direction, plan.next.spindle_rpm);
  }
  if (phase == MPhase::kAfter && plan.auxiliary.any() && !performAuxiliary(c, plan)) return false;
  if (phase == MPhase::kAfter && !performSurfaceSpeed(c, plan)) return false;
  if (phase == MPhase::kAfter && plan.tool_change && !c.parameters.flag(MachineParam::kToolChangeOnM6)) {
    return sendToolChange(c, plan.next.next_tool, plan.next.next_row);
  }
  return true;
}

namespace {

/// The coarsest decimal that all coordinates of the block are multiples of, mm; 0: none from two decimals of
/// a millimetre or three of an inch on, as those of formulas.
double decimalOf(const IsoContext& c, const BlockPlan& plan) {
  constexpr int kMostDecimals = 4;
  constexpr double kSame = 1e-6;  // of a decimal
  int decimals = plan.next.active[kGroupUnits] == gcode::kInch ? 3 : 2;
  for (const Word& w : c.block.words) {
    if (w.axis < 0 && !AddressSet("IJKR").has(w.address)) continue;
    const auto fits = [&] {
      const double steps = w.value * std::pow(10.0, decimals);
      return std::abs(steps - std::round(steps)) < kSame;
    };
    while (decimals <= kMostDecimals && !fits()) ++decimals;
  }
  return decimals <= kMostDecimals ? plan.next.unitScale() * std::pow(10.0, -decimals) : 0.0;
}

/// What all motions of the plan share.
void fillMotion(IsoContext& c, const BlockPlan& plan, PathItem& item) {
  const PlannedMotion& motion = plan.motion;
  item.plane = planeOf(plan.next);
  item.to = motion.target;
  item.rapid = motion.rapid;
  item.feed = motion.feed;
  item.direction = motion.direction;
  item.comp_on = plan.next.compOn();
  item.offset = plan.next.compOffset();
  if (item.comp_on) {
    item.tip = static_cast<std::uint8_t>(plan.next.d_tip);
    item.decimal = decimalOf(c, plan);
  }
  item.source = c.here();
}

/// What calculated corners need to know.
void fillContour(IsoContext& c, const BlockPlan& plan, PathItem& item) {
  const PlannedMotion& motion = plan.motion;
  item.start = item.plane.of(c.position).head<2>();
  if (motion.meet == PathItem::Meet::kOpen) c.pipe.link(c.stages.crossing);
  item.join = motion.join;
  item.join_size = motion.join_size;
  item.join_turn = static_cast<std::int8_t>(motion.join_turn);
  item.meet = motion.meet;
  item.angle = motion.angle;
  item.radius = motion.radius;
  if (item.join != PathItem::Join::kSharp) c.stages.corner.announce();
  if (!c.stages.corner.linked()) return;
  AxisPoint level = c.position;
  level[item.plane.u] = item.to[item.plane.u];
  level[item.plane.v] = item.to[item.plane.v];
  item.level = level == item.to;
}

/// Tells cutter compensation, in its turn, of a block without motion in the plane.
bool tellIdle(IsoContext& c, const BlockPlan& plan) {
  const bool counts = c.state.compOn() && plan.next.compOn() && staysInPlane(plan);
  if (!counts || c.stages.corner.linked()) return true;
  PathItem item;
  item.kind = PathItem::Kind::kStay;
  item.plane = planeOf(plan.next);
  item.to = c.position;
  item.comp_on = item.idle = true;
  item.source = c.here();
  return c.pipe.push(item);
}

/// A block without motion may still start or end cutter compensation on the spot, and so move the tool.
bool switchCompInPlace(IsoContext& c, BlockPlan& plan) {
  engageComp(c, plan);
  if (!c.stages.comp.linked() || plan.by_group[kGroupRadiusComp] == nullptr) return true;
  plan.motion.target = c.position;
  return pushMotion(c, plan, PathItem::Kind::kStay);
}

}  // namespace

void engageComp(IsoContext& c, const BlockPlan& plan) {
  if (c.stages.comp.linked() || !plan.next.compOn()) return;
  c.stages.comp.engage(c.stages.corner.sentUntil(planeOf(plan.next).of(c.chain.workOf(c.position))),
                       c.dialect.compensation);
  c.pipe.link(c.stages.crossing);
}

bool pushMotion(IsoContext& c, BlockPlan& plan, PathItem::Kind kind) {
  PathItem item;
  item.kind = kind;
  fillMotion(c, plan, item);
  if (c.stages.comp.linked()) item.record = c.alarms.remember();
  return c.pipe.push(item);
}

bool performMove(IsoContext& c, BlockPlan& plan) {
  if (turnsAboutTip(c, plan)) return performTipMove(c, plan);
  engageComp(c, plan);
  const PlannedMotion& motion = plan.motion;
  PathItem item;
  item.kind = motion.is_arc ? PathItem::Kind::kArc : PathItem::Kind::kLine;
  fillMotion(c, plan, item);
  item.in_plane = motion.named[static_cast<std::size_t>(item.plane.u)] ||
                  motion.named[static_cast<std::size_t>(item.plane.v)];
  const GCode* one_shot = plan.by_group[kOneShot];
  item.keep_vector = one_shot != nullptr && one_shot->code10 == gcode::kKeepVector;
  if (motion.is_arc) {
    item.center = {motion.arc.center.x(), motion.arc.center.y(), motion.arc.start.z()};
    item.start = motion.arc.start.head<2>();
    item.sweep = motion.arc.sweep_rad;
    item.by_radius = motion.by_radius;
  }
  const bool contour =
      item.comp_on || motion.join != PathItem::Join::kSharp || motion.meet != PathItem::Meet::kNo;
  if (contour || c.stages.corner.linked()) {
    fillContour(c, plan, item);
    item.record = c.alarms.remember();
  }
  c.position = motion.target;
  c.machine = c.chain.machineOf(motion.target);
  return c.pipe.push(item);
}

}  // namespace proveout::nc
