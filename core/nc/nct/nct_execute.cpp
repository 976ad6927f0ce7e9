// Execution of a planned block: functions, motions, register changes, commit.
#include <fmt/core.h>

#include <cmath>

#include "core/nc/nct/nct_control.h"

namespace proveout::nc {

bool NctControl::perform(BlockPlan& plan) {
  if (plan.flush && comp_engaged_ && !flushComp()) return false;
  const bool cycle = plan.deed == BlockPlan::Deed::kCycle;  // its functions follow the first positioning
  if (!cycle && !performFunctions(plan, MPhase::kBefore)) return false;
  if (plan.frames_changed) {
    chain_ = plan.chain;
    position_ = plan.start;
    if (comp_engaged_) rebaseComp();
  }
  state_.active[kGroupPlane] = plan.next.active[kGroupPlane];  // arcs and pieces are turned by it
  if (!performDeed(plan)) return false;
  const bool elsewhere = plan.deed == BlockPlan::Deed::kMachineMove ||
                         plan.deed == BlockPlan::Deed::kReference || plan.deed == BlockPlan::Deed::kFrames;
  if (elsewhere && comp_engaged_) rebaseComp();
  // Functions changed these while the block ran.
  plan.next.spindle_direction = state_.spindle_direction;
  plan.next.tool = state_.tool;
  state_ = plan.next;
  return performFunctions(plan, MPhase::kAfter) && performFunctions(plan, MPhase::kStop);
}

void NctControl::setSpindleAction(Action& action, double rpm) const {
  action.kind = Action::Kind::kSpindle;
  action.value = rpm * state_.spindle_direction;
  action.name = state_.spindle_direction > 0 ? "cw" : state_.spindle_direction < 0 ? "ccw" : "stop";
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

}  // namespace

bool NctControl::function(const BlockPlan& plan, int m) {
  Action action;
  if (m == 3 || m == 4 || m == 5) {
    state_.spindle_direction = m == 3 ? 1 : m == 4 ? -1 : 0;
    setSpindleAction(action, plan.next.spindle_rpm);
  } else if (m == 6) {
    const bool named = plan.next.next_tool >= 0;
    if (!named) warn("nct-no-t", "M6 without T: the tool stays");
    if (named) state_.tool = plan.next.next_tool;
    action.kind = Action::Kind::kToolChange;
    action.value = state_.tool;
  } else {
    action = eventAction(m, settings_.optional_stop);
    if (m == 19) state_.spindle_direction = 0;
  }
  action.source = here();
  return act(std::move(action), state_);
}

bool NctControl::performFunctions(BlockPlan& plan, MPhase phase) {
  bool spindle_done = false;
  for (int i = 0; i < plan.m_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const MPhase at = plan.m[k] ? plan.m[k]->phase : MPhase::kAfter;
    if (at != phase) continue;
    // In a drilling block M functions run at the first hole, behind the positioning (manual 18.2).
    if (!function(plan, plan.m_value[k])) return false;
    spindle_done = spindle_done || plan.m_value[k] == 3 || plan.m_value[k] == 4;
  }
  if (phase == MPhase::kBefore && plan.spindle_changed && !spindle_done && state_.spindle_direction != 0) {
    Action action;
    action.source = here();
    setSpindleAction(action, plan.next.spindle_rpm);
    return act(std::move(action), state_);
  }
  if (phase == MPhase::kAfter && plan.tool_change && !parameters_.flag(NctParam::kToolChangeOnM6)) {
    state_.tool = plan.next.next_tool;
    Action action;
    action.kind = Action::Kind::kToolChange;
    action.source = here();
    action.value = state_.tool;
    return act(std::move(action), state_);
  }
  return true;
}

bool NctControl::act(Action action, const NctState& state) {
  if (!comp_engaged_) {
    run(action);
    return true;
  }
  CompBlock block;
  block.shape = CompBlock::Shape::kNone;
  block.to = workPlanePosition();
  block.active = state.compOn();
  block.offset = state.compOffset();
  return pushComp(block, std::move(action));
}

void NctControl::run(Action& action) {
  switch (action.kind) {
    case Action::Kind::kMove:
      break;
    case Action::Kind::kSpindle: {
      emitter_.setSpindle(action.value);
      emitter_.event("spindle",
                     {{"rpm", jsonNumber(std::abs(action.value))}, {"direction", jsonString(action.name)}},
                     0.0, action.source);
      break;
    }
    case Action::Kind::kToolChange: {
      const int tool = static_cast<int>(action.value);
      emitter_.setTool(tool);
      emitter_.event("tool", {{"tool", fmt::format("{}", tool)}}, settings_.tool_change_s, action.source);
      break;
    }
    case Action::Kind::kDwell:
      emitter_.event("dwell", {{"seconds", jsonNumber(action.value)}}, action.value, action.source);
      break;
    case Action::Kind::kEvent:
      if (action.name == "spindle") emitter_.setSpindle(0.0);
      emitter_.event(action.name, action.data, 0.0, action.source);
      break;
  }
}

bool NctControl::switchCompInPlace(BlockPlan& plan) {
  if (plan.next.compOn() && !comp_engaged_ && !engageComp(plan)) return false;
  if (!comp_engaged_ || plan.by_group[kGroupRadiusComp] == nullptr) return true;
  CompBlock block;
  block.to = workPlanePosition();
  block.active = plan.next.compOn();
  block.offset = plan.next.compOffset();
  block.direction = plan.direction;
  Action action;  // starting and ending in place may move the tool
  action.rapid = plan.rapid;
  action.feed = plan.feed;
  action.source = here();
  return pushComp(block, std::move(action));
}

bool NctControl::performDeed(BlockPlan& plan) {
  switch (plan.deed) {
    case BlockPlan::Deed::kNone:
      return switchCompInPlace(plan);
    case BlockPlan::Deed::kMove:
      return moveTo(plan);
    case BlockPlan::Deed::kDwell: {
      Action action;
      action.kind = Action::Kind::kDwell;
      action.value = plan.dwell_s;
      action.source = here();
      return act(std::move(action), plan.next);
    }
    case BlockPlan::Deed::kMachineMove:
      emitter_.rapidTo(plan.target, here());
      settle(plan.target);
      return true;
    case BlockPlan::Deed::kReference:
      return performReference(plan);
    case BlockPlan::Deed::kCycle:
      return performCycle(plan);
    case BlockPlan::Deed::kFrames:
      setFrames(plan);
      return true;
    case BlockPlan::Deed::kOffsets: {
      auto& table = plan.offset_table < 12 ? length_table_ : radius_table_;
      OffsetValue& row = table[plan.offset_row];
      (plan.offset_table % 2 == 0 ? row.geometry : row.wear) = plan.offset_value;
      return true;
    }
  }
  return true;
}

bool NctControl::moveTo(BlockPlan& plan) {
  Action action;
  action.rapid = plan.rapid;
  action.feed = plan.feed;
  action.source = here();
  if (!comp_engaged_ && plan.next.compOn() && !engageComp(plan)) return false;
  const PlaneFrame frame(plan.next.plane());
  position_ = plan.target;
  machine_ = chain_.toMachine(plan.target);
  if (!comp_engaged_) {
    emitMove(action, machine_, plan.is_arc ? &plan.arc : nullptr, chain_);
    return true;
  }
  CompBlock block;
  block.to = frame.toPlane(chain_.toWork(plan.target));
  block.active = plan.next.compOn();
  block.offset = plan.next.compOffset();
  block.direction = plan.direction;
  const bool in_plane =
      plan.named[static_cast<std::size_t>(frame.u())] || plan.named[static_cast<std::size_t>(frame.v())];
  if (plan.is_arc) {
    const Vec3 center =
        chain_.toWork(frame.fromPlane({plan.arc.center.x(), plan.arc.center.y(), plan.arc.start.z()}));
    block.shape = CompBlock::Shape::kArc;
    block.center = frame.toPlane(center).head<2>();
    block.sweep_rad = plan.arc.sweep_rad;
  } else if (in_plane) {
    block.shape = CompBlock::Shape::kLine;
  }
  return pushComp(block, std::move(action));
}

void NctControl::emitMove(const Action& action, const Vec3& to_machine, const PlaneArc* arc,
                          const CoordinateChain& chain) {
  if (action.rapid && arc == nullptr) {
    emitter_.rapidTo(to_machine, action.source);
    return;
  }
  if (arc == nullptr) {
    emitter_.lineTo(to_machine, action.feed, action.source);
    return;
  }
  const PlaneFrame frame(state_.plane());
  MachineArc out;
  const Vec3 center = frame.fromPlane({arc->center.x(), arc->center.y(), arc->start.z()});
  out.center = chain.toMachine(center);
  out.normal = chain.directionToMachine(frame.normal());
  out.sweep_rad = arc->sweep_rad;
  emitter_.arcTo(to_machine, out, action.feed, action.source);
}

bool NctControl::performReference(BlockPlan& plan) {
  emitter_.rapidTo(chain_.toMachine(plan.via), here());
  emitter_.rapidTo(plan.target, here());
  settle(plan.target);
  return true;
}

void NctControl::setFrames(const BlockPlan& plan) {
  frames_ = *plan.frames;
  chain_ = frames_.chain(plan.next.work_system, plan.next.length);
  position_ = chain_.toProgram(machine_);
}

void NctControl::settle(const Vec3& machine) {
  machine_ = machine;
  position_ = chain_.toProgram(machine);
}

}  // namespace proveout::nc
