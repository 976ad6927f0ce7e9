// Execution of a planned block: functions, motions, register changes, commit.
#include "core/nc/nct/nct_perform.h"

#include <fmt/core.h>

#include <cmath>

namespace proveout::nc {

namespace {

bool switchCompInPlace(NctContext& c, BlockPlan& plan);

}  // namespace

bool perform(NctContext& c, BlockPlan& plan) {
  if (plan.flush && c.comp.engaged && !flushComp(c)) return false;
  if (!plan.runs_functions && !performFunctions(c, plan, MPhase::kBefore)) return false;
  if (plan.frames_changed) {
    c.chain = *plan.new_chain;
    c.position = plan.start;
    if (c.comp.engaged) rebaseComp(c);
  }
  c.state.active[kGroupPlane] = plan.next.active[kGroupPlane];  // arcs and pieces are turned by it
  const bool done = plan.perform ? plan.perform(c, plan) : switchCompInPlace(c, plan);
  if (!done) return false;
  if (plan.rebases && c.comp.engaged) rebaseComp(c);
  // Functions changed these while the block ran.
  plan.next.spindle_direction = c.state.spindle_direction;
  plan.next.tool = c.state.tool;
  c.state = plan.next;
  return performFunctions(c, plan, MPhase::kAfter) && performFunctions(c, plan, MPhase::kStop);
}

void setSpindleAction(NctContext& c, Action& action, double rpm) {
  action.kind = Action::Kind::kSpindle;
  action.value = rpm * c.state.spindle_direction;
  action.name = c.state.spindle_direction > 0 ? "cw" : c.state.spindle_direction < 0 ? "ccw" : "stop";
}

namespace {

/// Functions that only tell something: stops, coolant, gears, the machine builder's.
Action eventAction(int m, bool optional_stop) {
  Action action;
  action.kind = Action::Kind::kEvent;
  const std::string code = jsonString(fmt::format("M{}", m));
  switch (m) {
    case 0:
      action.name = "stop";
      action.data = {{"code", code}};
      break;
    case 1:
      action.name = "optional_stop";
      action.data = {{"code", code}, {"active", optional_stop ? "true" : "false"}};
      break;
    case 8:
    case 9:
      action.name = "coolant";
      action.data = {{"code", code}, {"on", m == 8 ? "true" : "false"}};
      break;
    case 19:
      action.name = "spindle";
      action.data = {{"rpm", "0"}, {"direction", jsonString("oriented")}};
      break;
    default:
      action.name = "function";
      action.data = {{"code", code}};
      break;
  }
  return action;
}

bool function(NctContext& c, const BlockPlan& plan, int m) {
  Action action;
  if (m == 3 || m == 4 || m == 5) {
    c.state.spindle_direction = m == 3 ? 1 : m == 4 ? -1 : 0;
    setSpindleAction(c, action, plan.next.spindle_rpm);
  } else if (m == 6) {
    const bool named = plan.next.next_tool >= 0;
    if (!named) c.warn("nct-no-t", "M6 without T: the tool stays");
    if (named) c.state.tool = plan.next.next_tool;
    action.kind = Action::Kind::kToolChange;
    action.value = c.state.tool;
  } else {
    action = eventAction(m, c.settings.optional_stop);
    if (m == 19) c.state.spindle_direction = 0;
  }
  action.source = c.here();
  return act(c, std::move(action), c.state);
}

}  // namespace

bool performFunctions(NctContext& c, BlockPlan& plan, MPhase phase) {
  bool spindle_done = false;
  for (int i = 0; i < plan.m_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const MPhase at = plan.m[k] ? plan.m[k]->phase : MPhase::kAfter;
    if (at != phase) continue;
    // In a drilling block M functions run at the first hole, behind the positioning (manual 18.2).
    if (!function(c, plan, plan.m_value[k])) return false;
    spindle_done = spindle_done || plan.m_value[k] == 3 || plan.m_value[k] == 4;
  }
  if (phase == MPhase::kBefore && plan.spindle_changed && !spindle_done && c.state.spindle_direction != 0) {
    Action action;
    action.source = c.here();
    setSpindleAction(c, action, plan.next.spindle_rpm);
    return act(c, std::move(action), c.state);
  }
  if (phase == MPhase::kAfter && plan.tool_change && !c.parameters.flag(MachineParam::kToolChangeOnM6)) {
    c.state.tool = plan.next.next_tool;
    Action action;
    action.kind = Action::Kind::kToolChange;
    action.source = c.here();
    action.value = c.state.tool;
    return act(c, std::move(action), c.state);
  }
  return true;
}

bool act(NctContext& c, Action action, const NctState& state) {
  if (!c.comp.engaged) {
    runAction(c, action);
    return true;
  }
  CompBlock block;
  block.shape = CompBlock::Shape::kNone;
  block.to = workPlanePosition(c);
  block.active = state.compOn();
  block.offset = state.compOffset();
  return pushComp(c, block, std::move(action));
}

void runAction(NctContext& c, Action& action) {
  switch (action.kind) {
    case Action::Kind::kMove:
      break;
    case Action::Kind::kSpindle: {
      c.emitter.setSpindle(action.value);
      c.emitter.event("spindle",
                      {{"rpm", jsonNumber(std::abs(action.value))}, {"direction", jsonString(action.name)}},
                      0.0, action.source);
      break;
    }
    case Action::Kind::kToolChange: {
      const int tool = static_cast<int>(action.value);
      c.emitter.setTool(tool);
      c.emitter.event("tool", {{"tool", fmt::format("{}", tool)}}, c.settings.tool_change_s, action.source);
      break;
    }
    case Action::Kind::kDwell:
      c.emitter.event("dwell", {{"seconds", jsonNumber(action.value)}}, action.value, action.source);
      break;
    case Action::Kind::kEvent:
      if (action.name == "spindle") c.emitter.setSpindle(0.0);
      c.emitter.event(action.name, action.data, 0.0, action.source);
      break;
  }
}

namespace {

bool switchCompInPlace(NctContext& c, BlockPlan& plan) {
  if (plan.next.compOn() && !c.comp.engaged && !engageComp(c, plan)) return false;
  if (!c.comp.engaged || plan.by_group[kGroupRadiusComp] == nullptr) return true;
  CompBlock block;
  block.to = workPlanePosition(c);
  block.active = plan.next.compOn();
  block.offset = plan.next.compOffset();
  block.direction = plan.motion.direction;
  Action action;  // starting and ending in place may move the tool
  action.to = c.machine;
  action.rapid = plan.motion.rapid;
  action.feed = plan.motion.feed;
  action.source = c.here();
  return pushComp(c, block, std::move(action));
}

}  // namespace

bool performMove(NctContext& c, BlockPlan& plan) {
  if (!c.comp.engaged && plan.next.compOn() && !engageComp(c, plan)) return false;
  const PlaneFrame frame(plan.next.plane());
  c.position = plan.motion.target;
  c.machine = c.chain.machineOf(plan.motion.target);
  if (!c.comp.engaged) {
    emitMove(c, plan.motion);
    return true;
  }
  Action action;
  action.rapid = plan.motion.rapid;
  action.feed = plan.motion.feed;
  action.to = c.machine;
  action.source = c.here();
  CompBlock block;
  block.to = frame.toPlane(c.chain.toWork(plan.motion.target.xyz));
  block.active = plan.next.compOn();
  block.offset = plan.next.compOffset();
  block.direction = plan.motion.direction;
  const bool in_plane = plan.motion.named[static_cast<std::size_t>(frame.u())] ||
                        plan.motion.named[static_cast<std::size_t>(frame.v())];
  if (plan.motion.is_arc) {
    const Vec3 center = c.chain.toWork(
        frame.fromPlane({plan.motion.arc.center.x(), plan.motion.arc.center.y(), plan.motion.arc.start.z()}));
    block.shape = CompBlock::Shape::kArc;
    block.center = frame.toPlane(center).head<2>();
    block.sweep_rad = plan.motion.arc.sweep_rad;
  } else if (in_plane) {
    block.shape = CompBlock::Shape::kLine;
  }
  return pushComp(c, block, std::move(action));
}

void emitMove(NctContext& c, const PlannedMotion& motion) {
  const SourceRef source = c.here();
  if (!motion.is_arc) {
    if (motion.rapid) {
      c.emitter.rapidTo(c.machine, source);
    } else {
      c.emitter.lineTo(c.machine, motion.feed, source);
    }
    return;
  }
  const PlaneFrame frame(c.state.plane());
  const PlaneArc& arc = motion.arc;
  MachineArc out;
  out.center = c.chain.toMachine(frame.fromPlane({arc.center.x(), arc.center.y(), arc.start.z()}));
  out.normal = c.chain.directionToMachine(frame.normal());
  out.sweep_rad = arc.sweep_rad;
  c.emitter.arcTo(c.machine, out, motion.feed, source);
}

void settle(NctContext& c, const AxisPoint& machine) {
  c.machine = machine;
  c.position = c.chain.programOf(machine);
}

}  // namespace proveout::nc
