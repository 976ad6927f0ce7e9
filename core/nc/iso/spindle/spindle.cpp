#include "core/nc/iso/spindle/spindle.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr double kMaxSpeed = 99999999.0;

int spindleCount(const IsoContext& c) { return std::max(1, static_cast<int>(c.settings.spindles.size())); }
/// Number by which programs call a spindle.
int numberOf(const IsoContext& c, int index) {
  const auto& all = c.settings.spindles;
  return all.empty() ? 1 : all[static_cast<std::size_t>(index)].number;
}
int indexOf(const IsoContext& c, std::int64_t number) {
  for (int k = 0; k < spindleCount(c); ++k) {
    if (numberOf(c, k) == number) return k;
  }
  return -1;
}
const SpindleSettings& settingsOf(const IsoContext& c, int index) {
  static const SpindleSettings kPlain;
  const auto& all = c.settings.spindles;
  return all.empty() ? kPlain : all[static_cast<std::size_t>(index)];
}
SpindleRecord& recordOf(IsoContext& c, int index) {
  return c.registers.spindles.record[static_cast<std::size_t>(index)];
}

bool hasCode(const BlockPlan& plan, int m) {
  for (int i = 0; i < plan.m_count; ++i) {
    if (plan.m_value[static_cast<std::size_t>(i)] == m) return true;
  }
  return false;
}

/// Range 1 to 8 that M11 to M18 of the block choose, or 0.
int rangeCode(const BlockPlan& plan) {
  for (int m = mcode::kFirstRange; m <= mcode::kLastRange; ++m) {
    if (hasCode(plan, m)) return m - mcode::kFirstRange + 1;
  }
  return 0;
}

/// Chooses the range of a speed and keeps the speed inside (manual 11.3). False: reported.
bool fitToRange(IsoContext& c, BlockPlan& plan, int index, double& rpm) {
  const auto& ranges = settingsOf(c, index).ranges;
  if (ranges.empty() || rpm == 0.0) return true;
  const auto holds = [&](int gear) {
    const auto& range = ranges[static_cast<std::size_t>(gear - 1)];
    return rpm >= range.min && rpm <= range.max;
  };
  const int count = static_cast<int>(ranges.size());
  int gear = rangeCode(plan);
  if (gear > count)
    return c.alarm(SharedAlarm::kOutOfRange, "M", fmt::format("the spindle has {} ranges", count));
  const int kept = recordOf(c, index).gear;
  if (gear == 0 && kept > 0 && holds(kept)) gear = kept;
  int fitting = 0;
  for (int k = 1; k <= count && gear == 0; ++k) {
    if (!holds(k)) continue;
    if (fitting > 0) {
      return c.fail("spindle-range",
                    fmt::format("S{} lies in the ranges {} and {}: M{} or M{} must choose", rpm, fitting, k,
                                fitting - 1 + mcode::kFirstRange, k - 1 + mcode::kFirstRange));
    }
    fitting = k;
  }
  if (gear == 0) gear = fitting;
  if (gear == 0) {  // between or beyond all: the nearest
    const auto distance = [&](const SpindleRange& r) { return std::max(r.min - rpm, rpm - r.max); };
    const auto nearest = std::min_element(ranges.begin(), ranges.end(), [&](const auto& a, const auto& b) {
      return distance(a) < distance(b);
    });
    gear = static_cast<int>(nearest - ranges.begin()) + 1;
  }
  const SpindleRange& range = ranges[static_cast<std::size_t>(gear - 1)];
  const double kept_inside = std::clamp(rpm, range.min, range.max);
  if (kept_inside != rpm) {
    c.warn("spindle-range",
           fmt::format("S{} lies outside range {}: the spindle turns with {}", rpm, gear, kept_inside));
  }
  rpm = kept_inside;
  plan.spindle.gear = gear;
  return true;
}

/// S with P names a spindle by its number; P then belongs to no other code of the block.
bool takesNumber(const BlockPlan& plan) {
  return plan.by_group[kOneShot] == nullptr && plan.flow == nullptr && !plan.next.inCycle() &&
         plan.by_group[kGroupWorkSystem] == nullptr && plan.by_group[kGroupSurfaceSpeed] == nullptr &&
         plan.by_group[kGroupMacro] == nullptr;
}

bool planSpeed(IsoContext& c, BlockPlan& plan, const Word& s, int index) {
  if (s.incremental)
    return c.alarm(SharedAlarm::kIllegalAddress, wordName(s, c.block), "a speed has no operator I",
                   s.columns);
  if (!(s.value >= 0.0 && s.value <= kMaxSpeed))
    return c.alarm(SharedAlarm::kOutOfRange, s, "from 0 to 99999999");
  double rpm = s.value;
  if (!fitToRange(c, plan, index, rpm)) return false;
  plan.spindle.index = index;
  plan.spindle.rpm = rpm;
  if (index == c.registers.spindles.main) {
    plan.spindle_changed = plan.next.spindle_rpm != rpm;
    plan.next.spindle_rpm = rpm;
  }
  return true;
}

/// An absolute or incremental turn of a spindle as an axis: CS2=30 (manual 11.7.3).
bool planPosition(IsoContext& c, BlockPlan& plan, const Word& w) {
  const int index = w.spindle - kMaxSpindles;
  const SpindleRecord& record = recordOf(c, index);
  if (!c.parameters.flag(MachineParam::kSpindleIndexes, numberOf(c, index))) {
    return c.alarm(SharedAlarm::kIndexing, wordName(w, c.block));
  }
  if (plan.spindle.turns)
    return c.alarm(SharedAlarm::kIllegalAddress, wordName(w, c.block), "one spindle in a block", w.columns);
  const bool step = w.incremental || plan.next.incremental();
  if (record.mode != SpindleMode::kOriented && !(step && record.mode == SpindleMode::kLoop)) {
    return c.failWord("spindle-loop",
                      step ? "a spindle turns by steps only with its position loop closed: program M19 or "
                             "the code of N0823 before"
                           : "a spindle turns to an angle only behind its orientation: program M19 before",
                      w);
  }
  plan.spindle.turns = true;
  plan.spindle.index = index;
  if (step) {
    plan.spindle.turn_deg = w.value;
  } else {
    // Whole turns are cut off, and the shorter way is taken; half a turn goes forward.
    const double wanted = w.value - 360.0 * std::floor(w.value / 360.0);
    double turn = wanted - record.angle_deg;
    if (turn > 180.0) turn -= 360.0;
    if (turn <= -180.0) turn += 360.0;
    plan.spindle.turn_deg = turn;
  }
  return true;
}

int defaultSpindle(const IsoContext& c) {
  return std::max(0, indexOf(c, static_cast<std::int64_t>(c.parameters[SpindleParam::kDefault])));
}

/// The spindle that the block turns, by M3, M4 or a code of its own; -1: none.
int startedBy(const IsoContext& c, const BlockPlan& plan) {
  for (int i = 0; i < plan.m_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (plan.m[k]->started() >= 0) return plan.m[k]->started();
    if (mcode::turns(plan.m_value[k])) return defaultSpindle(c);
  }
  return -1;
}

/// The spindle that S without a number is for. Where some have codes of their own, it is the one that turns.
int spindleOfS(const IsoContext& c, const BlockPlan& plan) {
  const Spindles& all = c.registers.spindles;
  if (!all.has_codes) return defaultSpindle(c);
  const int started = startedBy(c, plan);
  return started >= 0 ? started : all.main;
}

/// What else a code of a spindle of its own does to the block: its speed is that of the motion.
bool takeStarted(IsoContext& c, BlockPlan& plan) {
  const Spindles& all = c.registers.spindles;
  const int started = all.has_codes ? startedBy(c, plan) : -1;
  if (started < 0) return true;
  const Word* const p = c.block.find('P');
  if (settingsOf(c, started).speed_by_p && p != nullptr && !plan.claimed.has('P') &&
      !c.block.present.has('S')) {
    plan.claimed.add('P');
    if (!planSpeed(c, plan, *p, started)) return false;
  }
  if (started == all.main) return true;
  const bool told = plan.spindle.index == started;
  plan.next.spindle_rpm =
      told ? plan.spindle.rpm : c.registers.spindles.record[static_cast<std::size_t>(started)].rpm;
  plan.spindle_changed = false;
  return true;
}

/// Words of an axis that a spindle can be count only while it is that axis.
bool checkSpindleAxes(IsoContext& c) {
  for (int k = 0; k < spindleCount(c); ++k) {
    const int axis = c.axes.find(settingsOf(c, k).axis);
    const Word* w = axis < 0 ? nullptr : c.block.findAxis(axis);
    if (w == nullptr || recordOf(c, k).mode == SpindleMode::kAxis) continue;
    return c.failWord("spindle-axis",
                      fmt::format("axis {} is spindle {} now: program its change to an axis (M{}) before",
                                  settingsOf(c, k).axis, numberOf(c, k), settingsOf(c, k).axis_code),
                      *w);
  }
  return true;
}

}  // namespace

std::string checkSpindles(const ControlSettings& settings, const AxisTable& axes) {
  if (settings.spindles.size() > kMaxSpindles) return "a channel has at most 16 spindles";
  for (const SpindleSettings& s : settings.spindles) {
    if (s.number < 1 || s.number > kMaxSpindles) return "numbers of spindles are 1 to 16";
    for (const SpindleSettings& other : settings.spindles) {
      if (&s != &other && s.number == other.number) return fmt::format("spindle {} is given twice", s.number);
      const bool same = !s.name.empty() && s.name == other.name;
      if (&s != &other && same) return fmt::format("two spindles have the name {}", s.name);
    }
    if (!s.name.empty() && (s.name[0] != 'S' || s.name.size() < 2 || s.name.size() > 3)) {
      return fmt::format("spindle name '{}': S and one or two letters or digits", s.name);
    }
    const bool turns = s.position_name.size() >= 2 && s.position_name.size() <= 3 &&
                       s.position_name[0] >= 'A' && s.position_name[0] <= 'C';
    if (!s.position_name.empty() && !turns) {
      return fmt::format("spindle position name '{}': A, B or C and one or two letters or digits",
                         s.position_name);
    }
    if (!s.axis.empty() && axes.find(s.axis) < 0) return fmt::format("there is no axis {}", s.axis);
    if (s.ranges.size() > 8) return "a spindle has at most 8 ranges";
    for (const SpindleRange& r : s.ranges) {
      if (!(r.min >= 0.0 && r.max >= r.min && r.max <= kMaxSpeed)) return "a range of spindle speeds is bad";
    }
    if (!(s.acceleration >= 0.0 && s.positioning_rpm > 0.0)) return "spindle rates must not be negative";
  }
  return {};
}

void resetSpindles(IsoContext& c) {
  Spindles& all = c.registers.spindles;
  all = Spindles{};
  all.main = all.programmed = defaultSpindle(c);
  for (const SpindleSettings& s : c.settings.spindles) {
    all.has_axes = all.has_axes || !s.axis.empty();
    all.has_codes = all.has_codes || s.cw_code > 0 || s.ccw_code > 0;
  }
  c.emitter.setSpindleAcceleration(settingsOf(c, all.main).acceleration);
}

namespace {

bool planSpeeds(IsoContext& c, BlockPlan& plan) {
  Spindles& all = c.registers.spindles;
  if (all.has_axes && !checkSpindleAxes(c)) return false;
  const Word* s = c.word('S');
  const bool names = c.block.present.has(kNamedWord);
  if (names) {
    bool only_spindles = true;
    for (const Word& w : c.block.words) {
      if (w.address != kNamedWord) continue;
      if (w.spindle < 0) {
        only_spindles = false;
      } else if (w.spindle >= kMaxSpindles) {
        if (!planPosition(c, plan, w)) return false;
      } else if (s != nullptr || plan.spindle.index >= 0) {
        return c.alarm(SharedAlarm::kIllegalAddress, wordName(w, c.block), "one spindle in a block",
                       w.columns);
      } else if (!planSpeed(c, plan, w, w.spindle)) {
        return false;
      }
    }
    if (only_spindles) plan.claimed.add(kNamedWord);
  }
  if (s == nullptr) return planSurfaceSpeed(c, plan);
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot && one_shot->code10 == gcode::kSetPosition) {
    if (!(s->value >= 0.0 && s->value <= kMaxSpeed))
      return c.alarm(SharedAlarm::kOutOfRange, *s, "from 0 to 99999999");
    plan.next.speed_limit = s->value;
    return planSurfaceSpeed(c, plan);
  }
  if (plan.next.active[kGroupSurfaceSpeed] == gcode::kSurfaceSpeed) return planSurfaceSpeed(c, plan);
  int index = spindleOfS(c, plan);
  if (plan.by_group[kGroupSurfaceSpeed] != nullptr) index = all.main;  // G97 S
  const Word* p = c.block.find('P');
  if (p && !plan.claimed.has('P') && takesNumber(plan)) {
    std::int64_t number = 0;
    if (!integerWord(c, *p, 1, kMaxSpindles, number)) return false;
    index = indexOf(c, number);
    if (index < 0) return c.alarm(SharedAlarm::kOutOfRange, *p, "there is no such spindle");
    if (c.anyAxisWord())
      return c.alarm(SharedAlarm::kIllegalAddress, *p, "S with P stands without axis words");
    plan.claimed.add('P');
  }
  return planSpeed(c, plan, *s, index) && planSurfaceSpeed(c, plan);
}

}  // namespace

bool planSpindle(IsoContext& c, BlockPlan& plan) { return planSpeeds(c, plan) && takeStarted(c, plan); }

namespace {

/// Of several spindles the event tells which one it is.
void nameSpindle(const IsoContext& c, PathItem& item) {
  const auto& all = c.settings.spindles;
  if (all.size() < 2) return;
  event::Spindle spindle;
  spindle.spindle = all[static_cast<std::size_t>(c.registers.spindles.main)].number;
  item.event = std::make_unique<EventKind>(std::move(spindle));
}

}  // namespace

bool sendSpindle(IsoContext& c, int direction, double rpm) {
  c.state.spindle_direction = direction;
  PathItem item = functionItem(c, PathItem::Kind::kSpindle, c.state);
  item.value = rpm * direction;
  item.spindle = direction > 0   ? SpindleState::kClockwise
                 : direction < 0 ? SpindleState::kCounterClockwise
                                 : SpindleState::kStopped;
  nameSpindle(c, item);
  return c.pipe.push(item);
}

namespace {

bool sendStanding(IsoContext& c, SpindleState how) {
  c.state.spindle_direction = 0;
  PathItem item = functionItem(c, PathItem::Kind::kSpindle, c.state);
  item.spindle = how;
  nameSpindle(c, item);
  const double code = c.parameters.value(SpindleParam::kLoopCode, mainNumber(c));
  if (how == SpindleState::kPositionLoop && code > 0.0) {  // what the machine is told
    if (!item.event) item.event = std::make_unique<EventKind>(event::Spindle{});
    std::get<event::Spindle>(*item.event).code = fmt::format("M{:.0f}", code);
  }
  return c.pipe.push(item);
}

}  // namespace

bool sendOriented(IsoContext& c) { return sendStanding(c, SpindleState::kOriented); }
bool sendPositionLoop(IsoContext& c) { return sendStanding(c, SpindleState::kPositionLoop); }

namespace {

/// The number is told where there are several.
event::Spindle spindleEvent(const IsoContext& c, int index, double rpm, const char* direction) {
  event::Spindle told;
  told.rpm = rpm;
  told.direction = direction;
  if (spindleCount(c) > 1) told.spindle = numberOf(c, index);
  return told;
}

const char* directionName(int direction) { return direction > 0 ? "cw" : direction < 0 ? "ccw" : "stop"; }

/// M3, M4, M5 for any spindle: it turns by speed from here on.
bool turn(IsoContext& c, int index, int direction, double rpm) {
  SpindleRecord& record = recordOf(c, index);
  record.mode = SpindleMode::kSpeed;
  record.rpm = rpm;
  record.direction = direction;
  if (index == c.registers.spindles.main) return sendSpindle(c, direction, rpm);
  return sendEvent(c, spindleEvent(c, index, direction == 0 ? 0.0 : rpm, directionName(direction)));
}

bool closeLoop(IsoContext& c, int index, bool orient) {
  SpindleRecord& record = recordOf(c, index);
  record.direction = 0;
  if (orient) record.angle_deg = 0.0;
  const bool loop = c.parameters.flag(MachineParam::kSpindleIndexes, numberOf(c, index));
  record.mode = !loop ? SpindleMode::kSpeed : orient ? SpindleMode::kOriented : SpindleMode::kLoop;
  if (index == c.registers.spindles.main) return orient ? sendOriented(c) : sendPositionLoop(c);
  return sendEvent(c, spindleEvent(c, index, 0.0, orient ? "oriented" : "position loop"));
}

bool turnBy(IsoContext& c, int index, double degrees) {
  SpindleRecord& record = recordOf(c, index);
  const double angle = record.angle_deg + degrees;
  record.angle_deg = angle - 360.0 * std::floor(angle / 360.0);
  event::Spindle told = spindleEvent(c, index, 0.0, "positioned");
  told.angle_deg = record.angle_deg;
  told.turn_deg = degrees;
  const double turns = std::abs(degrees) / 360.0;
  return sendEvent(c, std::move(told), 60.0 * turns / settingsOf(c, index).positioning_rpm);
}

/// By the angles of the spindle programmed last: once with its first code, twice with the next one.
bool indexBy(IsoContext& c, int m) {
  const int index = c.registers.spindles.programmed;
  const SpindleMode mode = recordOf(c, index).mode;
  if (mode != SpindleMode::kOriented && mode != SpindleMode::kLoop) {
    return c.fail("spindle-loop",
                  "a spindle is indexed only with its position loop closed: program M19 before");
  }
  const int number = numberOf(c, index);
  const int step = m - static_cast<int>(c.parameters.value(SpindleParam::kIndexFirst, number)) + 1;
  const double sign = c.parameters.flag(SpindleParam::kIndexBackwards, number) ? -1.0 : 1.0;
  return turnBy(c, index, sign * step * c.parameters.value(SpindleParam::kIndexAngle, number));
}

/// The spindle becomes the main one (manual 11.4).
bool makeMain(IsoContext& c, int index) {
  Spindles& all = c.registers.spindles;
  if (index == all.main) return true;
  SpindleRecord& old = recordOf(c, all.main);
  old.rpm = c.state.spindle_rpm;
  old.direction = c.state.spindle_direction;
  all.main = index;
  const SpindleRecord& record = recordOf(c, index);
  c.state.spindle_rpm = record.rpm;
  c.emitter.setSpindleAcceleration(settingsOf(c, index).acceleration);
  return sendEvent(c, event::Function{"", numberOf(c, index)}) &&
         sendSpindle(c, record.direction, record.rpm);
}

/// The spindle programmed last follows the main one, no faster than both can (manual 11.7.4).
bool synchronise(IsoContext& c, bool shifted) {
  Spindles& all = c.registers.spindles;
  const int slave = all.programmed, master = all.main;
  if (slave == master)
    return c.fail("spindle-sync", "the main spindle cannot follow itself: name another one");
  SpindleRecord& record = recordOf(c, slave);
  double rpm = c.state.spindle_rpm;
  for (const int k : {slave, master}) {
    if (settingsOf(c, k).top_rpm > 0.0) rpm = std::min(rpm, settingsOf(c, k).top_rpm);
  }
  if (rpm != c.state.spindle_rpm) {
    c.state.spindle_rpm = rpm;
    if (!sendSpindle(c, c.state.spindle_direction, rpm)) return false;
  }
  record.mode = SpindleMode::kSlave;
  record.rpm = rpm;
  record.direction = c.state.spindle_direction;
  event::Spindle told = spindleEvent(c, slave, rpm, "synchronous");
  told.to = numberOf(c, master);
  if (shifted) told.shift_pulses = c.parameters.value(SpindleParam::kPhaseShift, numberOf(c, slave));
  return sendEvent(c, std::move(told));
}

bool becomeAxis(IsoContext& c, int index) {
  SpindleRecord& record = recordOf(c, index);
  if (index == c.registers.spindles.main && !sendSpindle(c, 0, 0.0)) return false;
  record.mode = SpindleMode::kAxis;
  record.direction = 0;
  event::Spindle told = spindleEvent(c, index, 0.0, "axis");
  told.axis = settingsOf(c, index).axis;
  return sendEvent(c, std::move(told));
}

/// The spindle turns by speed and is the main one from here on.
bool startAsMain(IsoContext& c, int index, int direction, double rpm) {
  if (index == c.registers.spindles.main) return turn(c, index, direction, rpm);
  SpindleRecord& record = recordOf(c, index);
  record.mode = SpindleMode::kSpeed;
  record.direction = direction;
  record.rpm = rpm;
  return makeMain(c, index);
}

/// A spindle with codes of its own stops; S, feeds and M3 are for the usual one again.
bool stopOwn(IsoContext& c, int index) {
  if (!turn(c, index, 0, recordOf(c, index).rpm)) return false;
  return index != c.registers.spindles.main || makeMain(c, defaultSpindle(c));
}

bool leaveAxis(IsoContext& c, int index) {
  SpindleRecord& record = recordOf(c, index);
  if (record.mode == SpindleMode::kAxis) record.mode = SpindleMode::kSpeed;
  return sendEvent(c, spindleEvent(c, index, 0.0, directionName(record.direction)));
}

/// A code that parameters or settings give to the spindles. False: reported.
bool configuredFunction(IsoContext& c, const BlockPlan& plan, const MFunction& found, int m, bool& handled) {
  if (const int started = found.started(); started >= 0)
    return startAsMain(c, started, found.cw >= 0 ? 1 : -1, plan.next.spindle_rpm);
  if (found.stop >= 0) return stopOwn(c, found.stop);
  if (found.speed >= 0) return leaveAxis(c, found.speed);
  const int index = c.registers.spindles.programmed;
  const auto at = static_cast<std::size_t>(index);
  if (found.closes_loop[at]) return closeLoop(c, index, false);
  if (found.indexes[at]) return indexBy(c, m);
  if (found.main >= 0) return makeMain(c, found.main);
  if (found.axis >= 0 && !settingsOf(c, found.axis).axis.empty()) return becomeAxis(c, found.axis);
  if (found.sync >= 0) return synchronise(c, false);
  if (found.shift >= 0) return synchronise(c, true);
  handled = false;
  return true;
}

}  // namespace

bool spindleFunction(IsoContext& c, const BlockPlan& plan, const MFunction& found, int m, bool& handled) {
  Spindles& all = c.registers.spindles;
  const int index = all.has_codes ? defaultSpindle(c) : all.programmed;
  handled = true;
  if (all.has_codes && mcode::turns(m))
    return startAsMain(c, index, m == mcode::kClockwise ? 1 : -1, plan.next.spindle_rpm);
  if (mcode::turns(m) || m == mcode::kSpindleStop) {
    const double rpm = index == all.main ? plan.next.spindle_rpm : recordOf(c, index).rpm;
    return turn(c, index, m == mcode::kClockwise ? 1 : m == mcode::kCounterClockwise ? -1 : 0, rpm);
  }
  const bool configured = found.started() >= 0 || found.stop >= 0 || found.speed >= 0 || found.axis >= 0;
  if (!configured && m >= mcode::kFirstRange && m <= mcode::kLastRange) {
    recordOf(c, index).gear = m - mcode::kFirstRange + 1;
    handled = false;
    return true;
  }
  if (m == mcode::kOrient) {
    if (!c.parameters.flag(MachineParam::kSpindleOrients, numberOf(c, index))) {
      return c.alarm(SharedAlarm::kOrientation, "", "the spindle has no orientation (N0607.ORI = 0)");
    }
    return closeLoop(c, index, true);
  }
  return configuredFunction(c, plan, found, m, handled);
}

bool turnMain(IsoContext& c, int direction, double rpm) {
  return turn(c, c.registers.spindles.main, direction, rpm);
}

bool closeMainLoop(IsoContext& c, bool orient) { return closeLoop(c, c.registers.spindles.main, orient); }

double mainAcceleration(const IsoContext& c) { return settingsOf(c, c.registers.spindles.main).acceleration; }

int mainNumber(const IsoContext& c) { return numberOf(c, c.registers.spindles.main); }

bool performSpindle(IsoContext& c, const BlockPlan& plan) {
  Spindles& all = c.registers.spindles;
  const BlockPlan::Spindle& own = plan.spindle;
  if (own.index < 0) return true;
  all.programmed = own.index;
  if (own.turns) return turnBy(c, own.index, own.turn_deg);
  SpindleRecord& record = recordOf(c, own.index);
  if (own.gear > 0) record.gear = own.gear;
  record.rpm = own.rpm;
  if (record.mode == SpindleMode::kSlave) record.mode = SpindleMode::kSpeed;
  if (own.index == all.main || record.direction == 0) return true;
  for (const int m : {mcode::kClockwise, mcode::kCounterClockwise, mcode::kSpindleStop, mcode::kOrient}) {
    if (hasCode(plan, m)) return true;
  }
  return turn(c, own.index, record.direction, own.rpm);
}

}  // namespace proveout::nc
