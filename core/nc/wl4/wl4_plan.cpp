#include "core/nc/wl4/wl4_plan.h"

#include <fmt/core.h>

#include <string_view>

namespace proveout::nc {

namespace {

/// A deed and what its row says; with a contour's blocks an open cycle is one over the contour.
void settleDeed(const Wl4Block& b, Wl4BlockPlan& p) {
  if (p.deed == nullptr) return;
  if (p.deed->flag != nullptr) p.*p.deed->flag = true;
  if (!p.deed->program.empty()) p.contour = p.contour && b.has('P') && b.has('Q');
}

bool planCodes(Wl4Context& c, Wl4BlockPlan& p) {
  for (const Wl4Block::Code& word : c.block.g) {
    const Wl4GCode* code = wl4GCode(word.number);
    if (code == nullptr) {
      return c.report.fail("wl4-code", fmt::format("G{} is no code of this control", word.number),
                           word.columns);
    }
    selectCode(p, *code);
  }
  settleDeed(c.block, p);
  const bool straight = p.next.motion < 2;
  const bool switches = p.next.radius != c.state.radius || p.next.length != c.state.length ||
                        (p.next.system != c.state.system && !p.sets_system);
  if (switches && !straight) {
    return c.report.fail("wl4-switch-in-arc",
                         "G40 to G44, G49 and G53 to G59 may be switched only while G0 or G1 is active");
  }
  if (p.next.speed_mode != c.state.speed_mode && !c.block.has('S')) {
    return c.report.fail("wl4-speed-mode", "G96 and G97 need a new S in the same block");
  }
  return true;
}

bool checkFunctions(Wl4Context& c) {
  std::size_t starts = 0, ends = 0;
  for (const Wl4Block::Code& m : c.block.m) ++(wl4MCode(m.number).phase == Wl4Phase::kStart ? starts : ends);
  if (starts <= 3 && ends <= 3) return true;
  return c.report.fail("wl4-functions", "more than three M functions of one kind in a block");
}

/// What plans the words of the axes and is done: the deed, or the motion in force.
const Wl4GCode& ownerOf(const Wl4BlockPlan& p) {
  return p.deed != nullptr ? *p.deed : *wl4GCode(p.next.motion);
}

/// The tool's data count from here on, even before it is in the spindle (manual, 7.3).
void selectTool(const Wl4Setup& setup, Wl4State& s, int number) {
  s.selected_tool = number;
  if (!setup.lathe) return;
  const Wl4Parameters::Tool& tool = setup.parameters.tool(number);
  s.tool_offset = {tool.dx, 0.0, tool.dz};
}

void warnOfUnusedWords(Wl4Context& c, const Wl4BlockPlan& p) {
  constexpr AddressSet kWatched = "EIJKPQR";
  const Wl4Block& b = c.block;
  if ((b.present & kWatched).empty()) return;
  AddressSet taken = ownerOf(p).words;
  if (p.thread) taken = taken | "IP";
  for (const Wl4Block::Code& m : b.m) taken = taken | wl4MCode(m.number).words;
  for (const char letter : std::string_view("EIJKPQR")) {
    if (!b.has(letter) || taken.has(letter)) continue;
    c.report.warnOnce(fmt::format("unused {}", letter), "wl4-word",
                      fmt::format("{} has no effect in this block", letter), b.at(letter));
  }
}

void planWords(Wl4Context& c, Wl4BlockPlan& p) {
  Wl4State& s = p.next;
  const Wl4Block& b = c.block;
  if (b.has('F') && !p.contour) s.feed = b.value('F');
  if (p.thread) s.pitch = s.feed;
  if (b.has('S')) (p.mirror ? s.speed_limit : s.speed) = b.value('S');  // G51 S is a limit
  if (b.has('T')) selectTool(c.setup, s, static_cast<int>(b.value('T')));
  if (b.has('D')) s.d = static_cast<int>(b.value('D'));
  if (p.contour) return;
  if (p.thread) s.i = s.p = 0.0;
  const bool follows = s.motion == 32 && !p.thread;  // I and P are those of the sequence
  if (!follows) s.i = b.find('I').value_or(s.i);
  s.j = b.find('J').value_or(s.j);
  s.k = b.find('K').value_or(s.k);
  if (!follows) s.p = b.find('P').value_or(s.p);
  warnOfUnusedWords(c, p);
}

void planLengths(Wl4Context& c, Wl4BlockPlan& p) {
  Wl4State& s = p.next;
  const Wl4Block& b = c.block;
  if (s.length == 49) {
    if (b.hasCode(49)) s.length_offset = {};
    if (b.has('H'))
      c.report.warnOnce("unused H", "wl4-word", "H has no effect without G43 or G44", b.at('H'));
    return;
  }
  if (!b.has('H') && c.state.length == s.length) return;
  if (b.has('H')) s.h = static_cast<int>(b.value('H'));
  const auto& table = c.setup.settings.length_offsets;
  const auto row = table.find(s.h);
  double value = 0.0;
  if (row != table.end()) value = row->second.geometry + row->second.wear;
  if (row == table.end() && s.h != 0) {
    c.report.warnOnce(fmt::format("H{}", s.h), "wl4-offset",
                      fmt::format("corrector H{0} is not in the job: 0 is taken (--offset H{0}=VALUE)", s.h));
  }
  s.length_offset[static_cast<std::size_t>(s.frame().w())] = s.length == 43 ? value : -value;
}

bool planMirror(Wl4Context& c, Wl4BlockPlan& p) {
  if (p.mirror_off) {
    p.next.mirror_changed |= p.next.mirrored;
    p.next.mirrored.reset();
  }
  if (!p.mirror) return true;
  for (int axis = 0; axis < c.setup.axes.count(); ++axis) {
    const std::string& name = c.setup.axes.at(axis).name;
    if (name.size() != 1 || !c.block.has(name[0])) continue;
    const double value = c.block.value(name[0]);
    if (value != 1.0 && value != -1.0) {
      return c.report.fail("wl4-mirror", fmt::format("G51 {}: -1 mirrors the axis, 1 ends it", name),
                           c.block.at(name[0]));
    }
    const auto k = static_cast<std::size_t>(axis);
    if (p.next.mirrored[k] != (value < 0.0)) p.next.mirror_changed.set(k);
    p.next.mirrored[k] = value < 0.0;
  }
  return true;
}

void planOffsets(Wl4Context& c, Wl4BlockPlan& p) {
  if (p.next.system == c.state.system || p.sets_system) return;
  p.next.system_offset = {};
  if (p.next.system == 53) return;
  const ControlSettings& settings = c.setup.settings;
  if (lacksWorkOffset(settings, p.next.system - 53)) {
    const std::string name = fmt::format("G{}", p.next.system);
    c.report.warnOnce(name, "wl4-offset",
                      fmt::format("{0} has no value in the job: 0 is taken (--offset {0}=X,Y,Z)", name));
  }
  p.next.system_offset.xyz =
      settings.work_offsets[static_cast<std::size_t>(p.next.system - 54)] + settings.common_offset;
}

}  // namespace

void selectCode(Wl4BlockPlan& p, const Wl4GCode& code) {
  if (code.mode != nullptr) p.next.*code.mode = code.code;
  if (code.group == Wl4Group::kDeed) {
    p.deed = &code;  // of several the last one counts, and its flag
  } else if (code.flag != nullptr) {
    p.*code.flag = true;
  }
}

bool planBlock(Wl4Context& c, Wl4BlockPlan& p) {
  p.next = c.state;
  p.target = c.machine;
  if (!planCodes(c, p) || !checkFunctions(c)) return false;
  planWords(c, p);
  planLengths(c, p);
  if (!planMirror(c, p)) return false;
  planOffsets(c, p);
  return ownerOf(p).plan(c, p);
}

}  // namespace proveout::nc
