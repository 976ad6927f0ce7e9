#include "core/nc/flexnc/flexnc_functions.h"

#include <fmt/core.h>

#include "core/nc/flexnc/flexnc_motion.h"
#include "core/nc/flexnc/flexnc_origins.h"
#include "core/nc/stages/tool_change.h"

namespace proveout::nc {

namespace {

std::string nameOf(const FlexWord& word) { return fmt::format("M{:02}", word.tenths / 10); }

SpindleState spindleState(int m) {
  switch (m) {
    case 3:
      return SpindleState::kClockwise;
    case 4:
      return SpindleState::kCounterClockwise;
    case 19:
      return SpindleState::kOriented;
    default:
      return SpindleState::kStopped;
  }
}

}  // namespace

bool turnFlexSpindle(FlexContext& c) {
  PathItem item = flexFunction(c, PathItem::Kind::kSpindle);
  item.spindle = spindleState(c.state.spindle);
  const double zero = c.origin().x() + c.state.corrector.x();
  const double n = flexRpm(c, c.machine[0] - zero);
  item.value = c.state.spindle == 4 ? -n : n;
  return c.pipe.push(item);
}

bool performFlexOptionalStop(FlexContext& c, FlexCursor& /*cursor*/, const FlexWord& word) {
  return sendFlexEvent(c, event::OptionalStop{nameOf(word), c.settings.optional_stop});
}

bool performFlexEnd(FlexContext& c, FlexCursor& cursor, const FlexWord& /*word*/) {
  cursor.ends = true;
  if (!c.state.turns()) return true;
  c.state.spindle = 5;
  return turnFlexSpindle(c);
}

bool performFlexSpindle(FlexContext& c, FlexCursor& /*cursor*/, const FlexWord& word) {
  const int m = word.tenths / 10;
  const double speed = c.state.css == 86 ? c.state.surface : c.state.rpm;
  if ((m == 3 || m == 4) && !(speed > 0.0)) {
    return c.report.fail(
        "fnc-spindle",
        fmt::format("{} without a speed: S stands before it, S300{}", nameOf(word), nameOf(word)),
        word.columns);
  }
  c.state.spindle = m;
  c.recorder.word(OriginKind::kSpindleDirection, word.columns, word.value, word.reads, {});
  return turnFlexSpindle(c);
}

bool performFlexToolChange(FlexContext& c, FlexCursor& /*cursor*/, const FlexWord& word) {
  if (c.state.selected_tool == 0)
    return c.report.fail("fnc-tool", "M06 without a tool: T stands before it, T3M06D3", word.columns);
  bool moves = false;
  if (!goToToolChange(c.settings, {c.pipe, c.emitter, c.recorder}, WorkPlane(PlaneFrame(Plane::kZX)),
                      c.report.here(), c.machine, moves))
    return false;
  c.state.tool = c.state.selected_tool;
  recordFlexToolChange(c);
  PathItem item = flexFunction(c, PathItem::Kind::kToolChange);
  item.value = c.state.tool;
  return c.pipe.push(item);
}

bool performFlexCoolant(FlexContext& c, FlexCursor& /*cursor*/, const FlexWord& word) {
  c.state.coolant = word.tenths / 10;
  return sendFlexEvent(c, event::Coolant{nameOf(word), c.state.coolant != 9});
}

}  // namespace proveout::nc
