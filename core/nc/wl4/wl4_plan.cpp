// What a block is to do: all checks, on a copy of the modal state.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/wl4/wl4_control.h"

namespace proveout::nc {

namespace {

constexpr std::string_view kIncrements = "UVW";
constexpr double kTravel = 9999.999;  ///< mm

}  // namespace

bool Wl4Control::isContourCycle(int deed) const {
  return deed == 76 || ((deed == 77 || deed == 78) && block_.has('P') && block_.has('Q'));
}

bool Wl4Control::plan(Plan& p) {
  p.next = state_;
  p.target = machine_;
  return planCodes(p) && checkFunctions() && planWords(p) && planLengths(p) && planMirror(p) &&
         planOffsets(p) && planAxes(p);
}

bool Wl4Control::planCodes(Plan& p) {
  for (const Wl4Block::Code& word : block_.g) {
    const Wl4GCode* code = wl4GCode(word.number);
    if (code == nullptr) {
      return fail("wl4-code", fmt::format("G{} is no code of this control", word.number), word.columns);
    }
    planCode(p, *code);
  }
  const bool straight = p.next.motion < 2;
  const bool switches = p.next.radius != state_.radius || p.next.length != state_.length ||
                        (p.next.system != state_.system && p.deed != 92);
  if (switches && !straight) {
    return fail("wl4-switch-in-arc",
                "G40 to G44, G49 and G53 to G59 may be switched only while G0 or G1 is active");
  }
  if (p.next.speed_mode != state_.speed_mode && !block_.has('S')) {
    return fail("wl4-speed-mode", "G96 and G97 need a new S in the same block");
  }
  return true;
}

void Wl4Control::planCode(Plan& p, const Wl4GCode& code) {
  switch (code.group) {
    case Wl4Group::kMotion:
      p.next.motion = code.code;
      break;
    case Wl4Group::kDeed:
      p.deed = code.code;
      break;
    case Wl4Group::kPlane:
      p.next.plane = code.code;
      break;
    case Wl4Group::kRadius:
      p.next.radius = code.code;
      break;
    case Wl4Group::kLength:
      p.next.length = code.code;
      break;
    case Wl4Group::kSystem:
      p.next.system = code.code;
      break;
    case Wl4Group::kStop:
      p.next.stop = code.code;
      break;
    case Wl4Group::kCycle:
      p.next.cycle = code.code;
      break;
    case Wl4Group::kDistance:
      p.next.distance = code.code;
      break;
    case Wl4Group::kFeed:
      p.next.feed_mode = code.code;
      break;
    case Wl4Group::kSpeed:
      p.next.speed_mode = code.code;
      break;
    case Wl4Group::kFlag:
      p.exact_stop = p.exact_stop || code.code == 9;
      p.measures = p.measures || code.code == 38;
      break;
  }
}

bool Wl4Control::checkFunctions() {
  std::size_t starts = 0, ends = 0;
  for (const Wl4Block::Code& m : block_.m) ++(wl4Phase(m.number) == Wl4Phase::kStart ? starts : ends);
  if (starts <= 3 && ends <= 3) return true;
  return fail("wl4-functions", "more than three M functions of one kind in a block");
}

/// The tool's data count from here on, even before it is in the spindle (manual, 7.3).
void Wl4Control::selectTool(Wl4State& s, int number) const {
  s.selected_tool = number;
  if (!lathe_) return;
  const Wl4Parameters::Tool& tool = parameters_.tool(number);
  s.tool_offset = {tool.dx, 0.0, tool.dz};
}

bool Wl4Control::planWords(Plan& p) {
  Wl4State& s = p.next;
  const Wl4Block& b = block_;
  const bool contour = isContourCycle(p.deed), thread = p.deed == 31 || b.hasCode(32) || b.hasCode(33);
  if (b.has('F') && !contour) s.feed = b.value('F');
  if (thread) s.pitch = s.feed;
  if (b.has('S') && b.hasCode(51)) {
    s.speed_limit = b.value('S');
  } else if (b.has('S')) {
    s.speed = b.value('S');
  }
  if (b.has('T')) selectTool(s, static_cast<int>(b.value('T')));
  if (b.has('D')) s.d = static_cast<int>(b.value('D'));
  if (contour) return true;
  if (thread) s.i = s.p = 0.0;
  const bool follows = s.motion == 32 && !thread;  // I and P are those of the sequence
  if (!follows) s.i = b.find('I').value_or(s.i);
  s.j = b.find('J').value_or(s.j);
  s.k = b.find('K').value_or(s.k);
  if (!follows) s.p = b.find('P').value_or(s.p);
  const bool arc = p.deed == 0 && (s.motion == 2 || s.motion == 3);
  for (const char letter : std::string_view("EIJKPQR")) {
    if (!b.has(letter)) continue;
    const bool used =
        (letter == 'E' && p.deed == 4) ||
        (arc && std::string_view("IJKR").find(letter) != std::string_view::npos) ||
        ((letter == 'I' || letter == 'P') && thread) ||
        (letter == 'P' && std::any_of(b.m.begin(), b.m.end(), [](auto& m) { return m.number == 19; }));
    if (!used) {
      warnOnce(fmt::format("unused {}", letter), "wl4-word",
               fmt::format("{} has no effect in this block", letter), b.at(letter));
    }
  }
  return true;
}

bool Wl4Control::planLengths(Plan& p) {
  Wl4State& s = p.next;
  if (s.length == 49) {
    if (block_.hasCode(49)) s.length_offset = {};
    if (block_.has('H'))
      warnOnce("unused H", "wl4-word", "H has no effect without G43 or G44", block_.at('H'));
    return true;
  }
  if (!block_.has('H') && state_.length == s.length) return true;
  if (block_.has('H')) s.h = static_cast<int>(block_.value('H'));
  const auto row = settings_.length_offsets.find(s.h);
  double value = 0.0;
  if (row != settings_.length_offsets.end()) value = row->second.geometry + row->second.wear;
  if (row == settings_.length_offsets.end() && s.h != 0) {
    warnOnce(fmt::format("H{}", s.h), "wl4-offset",
             fmt::format("corrector H{} is not in the job: 0 is taken", s.h));
  }
  s.length_offset[static_cast<std::size_t>(plane(s).w())] = s.length == 43 ? value : -value;
  return true;
}

bool Wl4Control::planMirror(Plan& p) {
  if (block_.hasCode(50)) {
    p.next.mirror_changed |= p.next.mirrored;
    p.next.mirrored.reset();
  }
  if (!block_.hasCode(51)) return true;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const std::string& name = axes_.at(axis).name;
    if (name.size() != 1 || !block_.has(name[0])) continue;
    const double value = block_.value(name[0]);
    if (value != 1.0 && value != -1.0) {
      return fail("wl4-mirror", fmt::format("G51 {}: -1 mirrors the axis, 1 ends it", name),
                  block_.at(name[0]));
    }
    const auto k = static_cast<std::size_t>(axis);
    if (p.next.mirrored[k] != (value < 0.0)) p.next.mirror_changed.set(k);
    p.next.mirrored[k] = value < 0.0;
  }
  return true;
}

bool Wl4Control::planOffsets(Plan& p) {
  if (p.next.system == state_.system || p.deed == 92) return true;
  p.next.system_offset = {};
  if (p.next.system == 53) return true;
  p.next.system_offset.xyz =
      settings_.work_offsets[static_cast<std::size_t>(p.next.system - 54)] + settings_.common_offset;
  return true;
}

bool Wl4Control::planAxes(Plan& p) {
  if (p.deed == 92) return planSetSystem(p);
  if (p.deed == 4 || block_.hasCode(51)) return true;
  if (isContourCycle(p.deed)) return true;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const std::string& name = axes_.at(axis).name;
    const char increment = axis < 3 ? kIncrements[static_cast<std::size_t>(axis)] : '\0';
    if (name.size() == 1 && !planAxis(p, axis, name[0], increment)) return false;
  }
  for (const char letter : std::string_view("ABC")) {
    if (!block_.has(letter) || axes_.find(std::string_view(&letter, 1)) >= 0) continue;
    if (letter != 'B') {
      return fail("wl4-axis", fmt::format("there is no axis {} in the job", letter), block_.at(letter));
    }
    p.chamfer = block_.value('B');
    if (!(p.chamfer >= 0.0))
      return fail("wl4-chamfer", "the leg of a chamfer is not negative", block_.at('B'));
  }
  // A full circle names its centre alone.
  const bool arc = p.deed == 0 && (p.next.motion == 2 || p.next.motion == 3);
  p.moves = p.named.any() || (arc && (block_.has('I') || block_.has('J') || block_.has('K')));
  if (p.deed != 36) remember(p);
  return true;
}

bool Wl4Control::planAxis(Plan& p, int axis, char absolute, char incremental) {
  const bool first = block_.has(absolute), second = incremental != '\0' && block_.has(incremental);
  if (!first && !second) return true;
  const auto order = [&](char letter) { return block_.order[static_cast<std::size_t>(letter - 'A')]; };
  const char letter = first && (!second || order(absolute) > order(incremental)) ? absolute : incremental;
  const double value = block_.value(letter) * (wantsDiameter(axis) ? 0.5 : 1.0);
  if (!(std::abs(value) <= kTravel)) {
    return fail("wl4-range", fmt::format("{}: the axis travels {} mm at most", letter, kTravel),
                block_.at(letter));
  }
  const auto k = static_cast<std::size_t>(axis);
  p.named.set(k);
  if (p.deed == 36) {  // the value has no meaning
    p.target[axis] = 0.0;
    return true;
  }
  const bool distance = letter == incremental || p.next.distance == 91;
  const double offset = p.next.offset(axis);
  if (distance && p.next.mirror_changed[k]) {
    return fail("wl4-mirror",
                fmt::format("the first motion of {} behind G50 or G51 has to be absolute", absolute),
                block_.at(letter));
  }
  p.target[axis] = distance ? machine_[axis] + p.next.sign(axis) * value + offset - state_.acting[axis]
                            : offset + p.next.sign(axis) * value;
  p.next.acting[axis] = offset;
  p.next.mirror_changed.reset(k);
  return true;
}

bool Wl4Control::planSetSystem(Plan& p) {
  bool any = false;
  for (int axis = 0; axis < axes_.count(); ++axis) {
    const std::string& name = axes_.at(axis).name;
    if (name.size() != 1 || !block_.has(name[0])) continue;
    any = true;
    const double value = block_.value(name[0]) * (wantsDiameter(axis) ? 0.5 : 1.0);
    const double length = p.next.offset(axis) - p.next.system_offset[axis];
    p.next.system_offset[axis] = machine_[axis] - length - p.next.sign(axis) * value;
    p.next.acting[axis] = p.next.offset(axis);
  }
  p.next.system = 92;
  return any || fail("wl4-g92", "G92 needs the coordinates of the position: G92 X0 Y0 Z100");
}

void Wl4Control::remember(Plan& p) {
  if (!p.moves) return;
  Wl4State& next = p.next;
  for (int axis = 0; axis < 3; ++axis) {
    const double unit = wantsDiameter(axis) ? 2.0 : 1.0;
    const auto k = static_cast<std::size_t>(axis);
    next.target[k] = unit * next.sign(axis) * (p.target[axis] - next.acting[axis]);
    next.increment[k] = unit * next.sign(axis) * (p.target[axis] - machine_[axis]);
  }
}

std::optional<double> Wl4Control::systemVariable(int number) const {
  const Wl4State& s = state_;
  if (number >= 130 && number <= 135) {
    const auto k = static_cast<std::size_t>(number - 130);
    return k % 2 == 0 ? s.target[k / 2] : s.increment[k / 2];
  }
  if (number >= 1000 && number < 1030) {
    const auto k = static_cast<std::size_t>(number % 10);
    if (k > 7) return std::nullopt;
    return number < 1010 ? touch_machine_[k] : number < 1020 ? touch_system_[k] : touch_distance_[k];
  }
  switch (number) {
    case 101:
      return s.motion;
    case 102:
      return s.radius;
    case 103:
      return s.system;
    case 104:
      return s.distance;
    case 105:
      return s.feed_mode;
    case 106:
      return s.speed_mode;
    case 107:
      return s.cycle;
    case 108:
      return s.open_cycle;
    case 112:
      return s.spindle;
    case 114:
      return s.coolant;
    case 117:
      return s.gear;
    case 120:
      return s.speed;
    case 121:
      return s.selected_tool;
    case 136:
      return s.i;
    case 137:
      return s.j;
    case 138:
      return s.k;
    case 139:
      return s.feed;
    case 140:
      return s.p;
    case 141:
      return s.d;
    case 200:
      return s.tool;
    default:
      return std::nullopt;
  }
}

}  // namespace proveout::nc
