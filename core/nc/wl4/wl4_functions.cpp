#include "core/nc/wl4/wl4_functions.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "core/nc/stages/tool_change.h"
#include "core/nc/wl4/wl4_output.h"
#include "core/nc/wl4/wl4_speeds.h"

namespace proveout::nc {

namespace {

bool hasFunction(const Wl4Block& block, int m) {
  return std::any_of(block.m.begin(), block.m.end(), [m](const auto& code) { return code.number == m; });
}

std::string nameOf(int m) { return fmt::format("M{}", m); }

}  // namespace

bool turnSpindle(Wl4Context& c, const Wl4State& s) {
  c.thread_angle.reset();
  PathItem item = functionItem(c, PathItem::Kind::kSpindle);
  item.plane = WorkPlane(s.frame());
  const double direction = s.spindle == 3 ? 1.0 : s.spindle == 4 ? -1.0 : 0.0;
  const double diameter = 2.0 * (c.machine[0] - s.acting[0]);
  if (direction != 0.0) warnOfUnlimitedSpeed(c, s, diameter, diameter);
  item.value = direction * (direction != 0.0 ? rpmAt(c.setup, s, diameter) : 0.0);
  item.spindle = s.spindle == 3    ? SpindleState::kClockwise
                 : s.spindle == 4  ? SpindleState::kCounterClockwise
                 : s.spindle == 19 ? SpindleState::kOriented
                                   : SpindleState::kStopped;
  if (s.spindle == 19 && c.block.has('P') && hasFunction(c.block, 19)) {
    event::Spindle spindle;
    spindle.angle_deg = c.block.value('P');
    item.event = std::make_unique<EventKind>(std::move(spindle));
  }
  return c.pipe.push(item);
}

bool performFunctions(Wl4Context& c, Wl4BlockPlan& p, Wl4Phase phase) {
  bool turned = false;
  for (const Wl4Block::Code& m : c.block.m) {
    const Wl4MCode& code = wl4MCode(m.number);
    if (code.phase != phase) continue;
    if (code.perform != nullptr && !code.perform(c, p, m.number)) return false;
    turned = turned || m.number == 3 || m.number == 4;
  }
  const bool changed = p.next.speed != c.state.speed || p.next.speed_mode != c.state.speed_mode ||
                       p.next.speed_limit != c.state.speed_limit;
  if (phase == Wl4Phase::kEnd || turned || !changed || !c.state.turns()) return true;
  p.next.spindle = c.state.spindle;
  return turnSpindle(c, p.next);
}

bool performStop(Wl4Context& c, Wl4BlockPlan&, int m) {
  c.thread_angle.reset();
  return sendEvent(c, event::Stop{nameOf(m), ""});
}

bool performOptionalStop(Wl4Context& c, Wl4BlockPlan&, int m) {
  c.thread_angle.reset();
  return sendEvent(c, event::OptionalStop{nameOf(m), c.setup.settings.optional_stop});
}

bool performSpindle(Wl4Context& c, Wl4BlockPlan& p, int m) {
  if (m == 19 && c.block.has('P') && !(c.block.value('P') <= 360.0)) {
    return c.report.fail("wl4-orientation", "M19 P: an angle of 0 to 360 degrees", c.block.at('P'));
  }
  c.state.spindle = p.next.spindle = m;
  return turnSpindle(c, p.next);
}

bool performToolChange(Wl4Context& c, Wl4BlockPlan& p, int) {
  if (p.next.selected_tool == 0) {
    c.report.warnOnce("M6 T0", "wl4-no-tool", "M6 without T: no tool is in the spindle");
  }
  c.state.tool = p.next.tool = p.next.selected_tool;
  c.origins.recordToolChange();
  PathItem item = functionItem(c, PathItem::Kind::kToolChange);
  item.value = p.next.selected_tool;
  return c.pipe.push(item);
}

bool performCoolant(Wl4Context& c, Wl4BlockPlan& p, int m) {
  c.state.coolant = p.next.coolant = m;
  return sendEvent(c, event::Coolant{nameOf(m), m != 9});
}

bool performGear(Wl4Context& c, Wl4BlockPlan& p, int m) {
  c.state.gear = p.next.gear = m;
  if (!p.mirror) p.next.speed_limit = 0.0;  // a limit (G51 S) holds for one gear
  return performOther(c, p, m);
}

bool performOther(Wl4Context& c, Wl4BlockPlan&, int m) {
  return sendEvent(c, event::Function{nameOf(m), {}});
}

bool goToToolChange(Wl4Context& c) {
  if (!hasFunction(c.block, 6)) return true;
  bool moves = false;
  if (!goToToolChange(c.setup.settings, {c.pipe, c.emitter, c.recorder}, WorkPlane(c.state.frame()),
                      c.report.here(), c.machine, moves))
    return false;
  if (moves) c.thread_angle.reset();
  return true;
}

bool performDwell(Wl4Context& c, Wl4BlockPlan&) {
  const double seconds = c.block.find('E').value_or(c.block.find('X').value_or(0.0));
  if (!(seconds >= 0.0 && seconds <= 99999.999)) {
    return c.report.fail("wl4-dwell", "a dwell lasts 0 to 99999.999 seconds");
  }
  c.thread_angle.reset();
  PathItem item = functionItem(c, PathItem::Kind::kDwell);
  item.value = seconds;
  return c.pipe.push(item);
}

}  // namespace proveout::nc
