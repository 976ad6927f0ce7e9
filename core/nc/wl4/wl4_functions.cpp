// Spindle, tools and other functions of the WL4 control.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/nc/services/surface_speed.h"
#include "core/nc/tool_change.h"
#include "core/nc/wl4/wl4_control.h"

namespace proveout::nc {

namespace {

constexpr double kNoCeiling = std::numeric_limits<double>::infinity();

constexpr double kLeastDiameter = 1e-3;  ///< mm; at the axis the speed would be infinite

}  // namespace

PathItem Wl4Control::functionItem(PathItem::Kind kind) const {
  PathItem item;
  item.kind = kind;
  item.plane = WorkPlane(plane(state_));
  item.to = machine_;
  item.comp_on = state_.radius != 40;
  item.source = here();
  return item;
}

bool Wl4Control::sendEvent(EventKind what, double time_s) {
  PathItem item = functionItem(PathItem::Kind::kEvent);
  item.event = std::make_unique<EventKind>(std::move(what));
  item.value = time_s;
  return pipe_.push(item);
}

double Wl4Control::rpm(const Wl4State& s, double diameter) const {
  double n = s.speed;
  if (s.speed_mode == 96) n = 1000.0 * s.speed / (kPi * std::max(std::abs(diameter), kLeastDiameter));
  const double top = topSpeed(s);
  return top > 0.0 ? std::min(n, top) : n;
}

/// The highest speed that the program or the machine allows, 1/min; 0: none is known.
double Wl4Control::topSpeed(const Wl4State& s) const {
  double top = 0.0;
  for (const double limit : {s.speed_limit, parameters_.max_speed}) {
    if (limit > 0.0) top = top > 0.0 ? std::min(top, limit) : limit;
  }
  return top;
}

/// Speed with which feed per revolution takes as long as along a line between two signed diameters, mm.
double Wl4Control::meanRpm(const Wl4State& s, double from, double to) const {
  if (s.speed_mode != 96 || !(s.speed > 0.0)) return rpm(s, to);
  const double product = 1000.0 * s.speed / kPi;  // 1/min times mm of diameter
  return meanSurfaceRpm(product, from, to, {0.0, topSpeed(s) > 0.0 ? topSpeed(s) : product / kLeastDiameter});
}

/// Constant surface speed that comes to the axis, with nothing that limits the spindle.
void Wl4Control::warnOfUnlimitedSpeed(const Wl4State& s, double from, double to) {
  const bool axis = from * to <= 0.0 || std::min(std::abs(from), std::abs(to)) < kLeastDiameter;
  if (s.speed_mode != 96 || !axis || topSpeed(s) > 0.0) return;
  warnOnce(
      "surface speed without limit", "wl4-surface-speed",
      "G96 to the axis without a limit of the spindle's speed: speed and time there are those of no real "
      "machine; give G51 S in the program or MAX_SPEED in [control.wl4-mill] or [control.wl4-lathe]");
}

bool Wl4Control::spindle(const Wl4State& s) {
  thread_angle_.reset();
  PathItem item = functionItem(PathItem::Kind::kSpindle);
  item.plane = WorkPlane(plane(s));
  const double direction = s.spindle == 3 ? 1.0 : s.spindle == 4 ? -1.0 : 0.0;
  const double diameter = 2.0 * (machine_[0] - s.acting[0]);
  if (direction != 0.0) warnOfUnlimitedSpeed(s, diameter, diameter);
  item.value = direction * (direction != 0.0 ? rpm(s, diameter) : 0.0);
  item.spindle = s.spindle == 3    ? SpindleState::kClockwise
                 : s.spindle == 4  ? SpindleState::kCounterClockwise
                 : s.spindle == 19 ? SpindleState::kOriented
                                   : SpindleState::kStopped;
  const auto orients = [](const Wl4Block::Code& m) { return m.number == 19; };
  if (s.spindle == 19 && block_.has('P') && std::any_of(block_.m.begin(), block_.m.end(), orients)) {
    event::Spindle spindle;
    spindle.angle_deg = block_.value('P');
    item.event = std::make_unique<EventKind>(std::move(spindle));
  }
  return pipe_.push(item);
}

bool Wl4Control::functions(Plan& p, Wl4Phase phase) {
  bool turned = false;
  for (const Wl4Block::Code& m : block_.m) {
    if (wl4Phase(m.number) != phase) continue;
    if (!function(p, m.number)) return false;
    turned = turned || m.number == 3 || m.number == 4;
  }
  const bool changed = p.next.speed != state_.speed || p.next.speed_mode != state_.speed_mode ||
                       p.next.speed_limit != state_.speed_limit;
  if (phase == Wl4Phase::kEnd || turned || !changed || !state_.turns()) return true;
  p.next.spindle = state_.spindle;
  return spindle(p.next);
}

bool Wl4Control::function(Plan& p, int m) {
  const std::string code = fmt::format("M{}", m);
  if (m <= 1) thread_angle_.reset();
  switch (m) {
    case 0:
      return sendEvent(event::Stop{code, ""});
    case 1:
      return sendEvent(event::OptionalStop{code, settings_.optional_stop});
    case 2:
    case 30:
    case 99:
      return true;
    case 3:
    case 4:
    case 5:
    case 19:
      if (m == 19 && block_.has('P') && !(block_.value('P') <= 360.0)) {
        return fail("wl4-orientation", "M19 P: an angle of 0 to 360 degrees", block_.at('P'));
      }
      state_.spindle = p.next.spindle = m;
      return spindle(p.next);
    case 6: {
      if (p.next.selected_tool == 0) {
        warnOnce("M6 T0", "wl4-no-tool", "M6 without T: no tool is in the spindle");
      }
      state_.tool = p.next.tool = p.next.selected_tool;
      recordToolChange();
      PathItem item = functionItem(PathItem::Kind::kToolChange);
      item.value = p.next.selected_tool;
      return pipe_.push(item);
    }
    case 7:
    case 8:
    case 9:
      state_.coolant = p.next.coolant = m;
      return sendEvent(event::Coolant{code, m != 9});
    default:
      if (m >= 40 && m <= 48) {
        state_.gear = p.next.gear = m;
        if (!block_.hasCode(51)) p.next.speed_limit = 0.0;  // a limit holds for one gear
      }
      return sendEvent(event::Function{code, {}});
  }
}

bool Wl4Control::goToToolChange() {
  const auto changes = [](const Wl4Block::Code& m) { return m.number == 6; };
  const ToolChangePlace& place = settings_.tool_change;
  if (!place.any() || std::none_of(block_.m.begin(), block_.m.end(), changes)) return true;
  if (!pipe_.flush(FlushReason::kBuffer)) return false;
  const auto way = toolChangeWay(settings_, emitter_.machine(), kNoCeiling);
  if (!way.empty()) origins_.clear(unsaidBehind(place));
  for (const AxisPoint& to : way) {
    PathItem item;
    item.kind = PathItem::Kind::kLine;
    item.space = PathItem::Space::kMachine;
    item.rapid = true;
    item.feed.join.stops = true;
    item.plane = WorkPlane(plane(state_));
    item.to = to;
    item.source = here();
    if (!pipe_.push(item)) return false;
  }
  if (way.empty()) return true;
  thread_angle_.reset();
  // Beside cutter compensation the programmed point is not the machine's: axes that stayed keep it.
  machine_[2] = way.back()[2];
  if (place.x) machine_[0] = *place.x;
  if (place.y) machine_[1] = *place.y;
  pipe_.rebase(machine_, WorkPlane(plane(state_)));
  return true;
}

bool Wl4Control::dwell() {
  const double seconds = block_.find('E').value_or(block_.find('X').value_or(0.0));
  if (!(seconds >= 0.0 && seconds <= 99999.999)) {
    return fail("wl4-dwell", "a dwell lasts 0 to 99999.999 seconds");
  }
  thread_angle_.reset();
  PathItem item = functionItem(PathItem::Kind::kDwell);
  item.value = seconds;
  return pipe_.push(item);
}

}  // namespace proveout::nc
