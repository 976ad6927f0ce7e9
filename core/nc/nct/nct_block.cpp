// Planning of a block: codes, words, checks. Nothing here changes the control.
#include <fmt/core.h>

#include <cmath>

#include "core/nc/nct/nct_control.h"

namespace proveout::nc {
namespace {

std::string gName(int code10) {
  return code10 % 10 ? fmt::format("G{}.{}", code10 / 10, code10 % 10) : fmt::format("G{}", code10 / 10);
}

/// G codes as they count for a code table: 54.1 -> 541; -1 if there is more than one decimal.
int code10Of(double value) {
  const double tenfold = std::round(value * 10.0);
  if (tenfold > 9999.0 || std::abs(tenfold - value * 10.0) > 1e-6) return -1;
  return static_cast<int>(tenfold);
}

/// Smallest F: slower than this no machine moves, and times stay finite.
constexpr double kMinFeed = 1e-6;

/// Words that every block may carry.
constexpr AddressSet kCommonWords = "GMFSTHD";

}  // namespace

bool NctControl::planBlock(BlockPlan& plan) {
  plan.next = state_;
  plan.start = position_;
  return collectG(plan) && collectM(plan) && planModal(plan) && planNumbers(plan) && planOffsetsHD(plan) &&
         planWorkSystem(plan) && planLength(plan) && planComp(plan) && govern(plan) && checkWords(plan);
}

bool NctControl::collectG(BlockPlan& plan) {
  if (!block_.present.has('G')) return true;
  for (const Word& w : block_.words) {
    if (w.address == 'G' && !acceptG(plan, w)) return false;
  }
  return true;
}

bool NctControl::acceptG(BlockPlan& plan, const Word& w) {
  const int code10 = code10Of(w.value);
  const GCode* code = code10 < 0 ? nullptr : findGCode(code10);
  if (code == nullptr || !code->built) {
    if (!refuseG(w, code)) return false;
    plan.claimed = plan.claimed | code->words;  // a lenient run leaves the code and its words out
    return true;
  }
  const bool exact_stop = code10 == 90;
  auto& slot = plan.by_group[static_cast<std::size_t>(code->group)];
  if (code->group == kOneShot) {
    if (exact_stop) return true;  // may stand with any motion
    if (slot != nullptr) {
      return failWord("nct-group-clash",
                      fmt::format("{} and {} cannot stand in one block", gName(slot->code10), gName(code10)),
                      w);
    }
  } else if (slot != nullptr) {
    const auto same = slot == code
                          ? fmt::format("{} twice in one block", gName(code10))
                          : fmt::format("{} and {} are of one group", gName(slot->code10), gName(code10));
    return failWord("nct-group-clash", same, w);
  }
  slot = code;
  plan.flush = plan.flush || code->flushes;
  return true;
}

bool NctControl::refuseG(const Word& w, const GCode* code) {
  const std::string name =
      std::string(block_.text.substr(static_cast<std::size_t>(w.columns.begin - 1),
                                     static_cast<std::size_t>(w.columns.end - w.columns.begin)));
  if (code == nullptr)
    return failWord("nct-2123",
                    fmt::format("function not implemented: {} is not a code of this control", name), w);
  if (settings_.lenient && code->skippable) {
    warn("nct-2123", fmt::format("{} ({}) is not supported and left out", name, code->meaning), w.columns);
    return true;
  }
  return failWord("nct-2123",
                  fmt::format("function not implemented: {} ({}) is not supported", name, code->meaning), w);
}

bool NctControl::collectM(BlockPlan& plan) {
  if (!block_.present.has('M')) return true;
  for (const Word& w : block_.words) {
    if (w.address != 'M') continue;
    std::int64_t value = 0;
    if (!integerWord(w, 0, 99999999, value)) return false;
    if (plan.m_count == 8) return failWord("nct-m-count", "more than 8 M functions in one block", w);
    const MCode* code = findMCode(static_cast<int>(value));
    for (int i = 0; i < plan.m_count; ++i) {
      const MCode* other = plan.m[static_cast<std::size_t>(i)];
      const bool both = code && other && code->exclusive > 0 && code->exclusive == other->exclusive;
      if (both || plan.m_value[static_cast<std::size_t>(i)] == value) {
        return failWord("nct-contradictory-m",
                        fmt::format("contradictory M codes: M{} and M{}",
                                    plan.m_value[static_cast<std::size_t>(i)], value),
                        w);
      }
    }
    if (code == nullptr) {
      warnOnce(
          fmt::format("M{}", value), "nct-m-function",
          fmt::format("M{} is a function of the machine builder: it has no effect in the simulation", value),
          w.columns);
    } else {
      if (!(plan.claimed & code->words & block_.present).empty()) {
        return failWord("nct-2017",
                        fmt::format("a word of the block would belong to M{} and to a G code", value), w);
      }
      plan.claimed = plan.claimed | code->words;
      if (code->phase == MPhase::kCall || code->phase == MPhase::kEnd) plan.flow = code;
      plan.flush =
          plan.flush || code->phase == MPhase::kStop || code->phase == MPhase::kEnd || code->code == 6;
      plan.tool_change = plan.tool_change || code->code == 6;
    }
    plan.m[static_cast<std::size_t>(plan.m_count)] = code;
    plan.m_value[static_cast<std::size_t>(plan.m_count++)] = static_cast<int>(value);
  }
  return true;
}

bool NctControl::planModal(BlockPlan& plan) {
  NctState& next = plan.next;
  const GCode* motion = plan.by_group[kGroupMotion];
  const GCode* cycle = plan.by_group[kGroupCycle];
  if (motion && cycle && cycle->code10 != 800) {
    return fail("nct-group-clash", fmt::format("{} and {} cannot stand in one block", gName(motion->code10),
                                               gName(cycle->code10)));
  }
  for (std::size_t g = 1; g < plan.by_group.size(); ++g) {
    const GCode* code = plan.by_group[g];
    if (code == nullptr) continue;
    next.active[g] = code->code10;
    if (g != kGroupMotion && g != kGroupCycle && !claim(plan, *code)) return false;
  }
  if (plan.by_group[kGroupUnits] && next.active[kGroupUnits] != state_.active[kGroupUnits] &&
      state_.feed > 0.0 && !block_.present.has('F')) {
    warn("nct-feed-unit", "the unit changes: the modal feed keeps its number and takes the new unit");
  }
  // A group-1 code ends the cycle mode; ending it restores G98 (manual 18.1.4).
  if (motion) next.active[kGroupCycle] = 800;
  if (!next.inCycle()) {
    if (state_.inCycle() && plan.by_group[kGroupReturn] == nullptr) next.active[kGroupReturn] = 980;
    next.cycle = CycleWords{};
  }
  return true;
}

bool NctControl::claim(BlockPlan& plan, const GCode& code) {
  const int motion = plan.next.active[kGroupMotion];
  // In a circular block I, J, K are the centre, not the vector of a change of side.
  const bool arc = motion == 20 || motion == 30;
  if (code.group == kGroupRadiusComp && (arc || plan.next.inCycle())) return true;
  if (!(plan.claimed & code.words & block_.present).empty()) {
    return fail("nct-2017", fmt::format("a word of the block would belong to {} and to another code",
                                        gName(code.code10)));
  }
  plan.claimed = plan.claimed | code.words;
  return true;
}

bool NctControl::integerWord(const Word& w, std::int64_t min, std::int64_t max, std::int64_t& out) {
  if (!w.is_integer || w.value < static_cast<double>(min) || w.value > static_cast<double>(max)) {
    return failWord("nct-2002",
                    fmt::format("{} data out of range: an integer from {} to {} is expected",
                                addressText(w.address), min, max),
                    w);
  }
  out = static_cast<std::int64_t>(w.value);
  return true;
}

bool NctControl::planNumbers(BlockPlan& plan) {
  std::int64_t number = 0;
  if (const Word* f = word('F')) {
    if (f->value <= 0.0) return failWord("nct-feed", "F must be greater than 0", *f);
    if (f->value < kMinFeed) return failWord("nct-2002", "F data out of range: at least 0.000001", *f);
    plan.next.feed = f->value;
  }
  const GCode* one_shot = plan.by_group[kOneShot];
  if (const Word* s = word('S')) {
    if (s->value < 0.0 || s->value > 1e6)
      return failWord("nct-2002", "S data out of range: 0 to 1000000 rpm", *s);
    if (one_shot && one_shot->code10 == 920) {
      return failWord("nct-2123", "function not implemented: G92 S (speed limit of G96) is not supported",
                      *s);
    }
    plan.spindle_changed = plan.next.spindle_rpm != s->value;
    plan.next.spindle_rpm = s->value;
  }
  if (const Word* t = word('T')) {
    if (!integerWord(*t, 0, 99999999, number)) return false;
    plan.next.next_tool = static_cast<int>(number);
    if (!parameters_.flag(NctParam::kToolChangeOnM6)) {
      plan.tool_change = true;
      plan.flush = true;
    }
  }
  return true;
}

bool NctControl::planOffsetsHD(BlockPlan& plan) {
  const auto rows = static_cast<std::int64_t>(parameters_[NctParam::kToolOffsets]);
  const auto lookUp = [&](const Word& w, const std::map<int, OffsetValue>& table, int& row, double& value) {
    std::int64_t number = 0;
    if (!integerWord(w, 0, rows, number)) return false;
    row = static_cast<int>(number);
    value = 0.0;
    if (row == 0) return true;
    const auto found = table.find(row);
    if (found != table.end()) {
      value = found->second.geometry + found->second.wear;
      return true;
    }
    const auto name = fmt::format("{}{}", addressText(w.address), row);
    warnOnce(name, "nct-offset-missing", fmt::format("{} has no value in the offset table: 0 is taken", name),
             w.columns);
    return true;
  };
  if (const Word* h = word('H'); h && !lookUp(*h, length_table_, plan.next.h, plan.next.h_value))
    return false;
  if (const Word* d = word('D'); d && !lookUp(*d, radius_table_, plan.next.d, plan.next.d_radius))
    return false;
  return true;
}

bool NctControl::planWorkSystem(BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupWorkSystem];
  if (code == nullptr) return true;
  if (code->code10 == 541) {
    const Word* p = word('P');
    std::int64_t number = 0;
    if (p == nullptr) return fail("nct-2004", "missing data P: G54.1 needs P1 to P99");
    if (!integerWord(*p, 1, 99, number)) return false;
    plan.next.work_system = kFirstExtended + static_cast<int>(number) - 1;
  } else {
    plan.next.work_system = code->code10 / 10 - 53;
  }
  plan.frames_changed = true;
  return true;
}

bool NctControl::planLength(BlockPlan& plan) {
  NctState& next = plan.next;
  const GCode* code = plan.by_group[kGroupLengthComp];
  const int mode = next.active[kGroupLengthComp];
  if (code && mode == 490) {
    next.length = Vec3::Zero();
    plan.frames_changed = true;
  } else if (mode != 490 && (code || block_.present.has('H'))) {
    const double value = mode == 430 ? next.h_value : -next.h_value;
    const bool always_z = parameters_.flag(NctParam::kLengthAlwaysZ);
    const bool by_plane = !always_z && parameters_.flag(NctParam::kLengthByPlane);
    const int normal = PlaneFrame(next.plane()).w();
    for (int axis = 0; axis < 3; ++axis) {
      const bool named = block_.present.has("XYZ"[axis]) || block_.present.has("UVW"[axis]);
      if (always_z ? axis == 2 : by_plane ? axis == normal : named) next.length[axis] = value;
    }
    plan.frames_changed = true;
    plan.flush = true;
  }
  if (plan.frames_changed) {
    plan.chain = frames_.chain(next.work_system, next.length);
    plan.start = plan.chain.toProgram(machine_);
  } else {
    plan.chain = chain_;
  }
  return true;
}

bool NctControl::planComp(BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupRadiusComp];
  const bool was_on = state_.compOn();
  if (was_on && plan.next.plane() != state_.plane()) {
    return fail("nct-plane-in-comp", "the plane cannot change while cutter compensation (G41, G42) is on");
  }
  if (plan.next.compOn() && plan.next.inCycle()) {
    return fail("nct-cycle-in-comp",
                "drilling cycles cannot run while cutter compensation (G41, G42) is on: program G40 first");
  }
  if (code == nullptr) return true;
  const int motion = plan.next.active[kGroupMotion];
  if (motion == 20 || motion == 30) {
    if (!plan.next.compOn() && was_on) return fail("nct-2043", "G40 in circular interpolation");
    if (plan.next.compOn() && !was_on)
      return fail("nct-comp-start-arc", "G41, G42 cannot be switched on in a G2 or G3 block");
    return true;
  }
  if (plan.next.compOn() && plan.next.d == 0 && !block_.present.has('D') && state_.d == 0) {
    warn("nct-no-d", "no D is programmed: cutter compensation runs with radius 0");
  }
  const PlaneFrame frame(plan.next.plane());
  Vec3 vector = Vec3::Zero();
  bool given = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = word("IJK"[axis]);
    if (w == nullptr) continue;
    vector[axis] = lengthOf(plan, *w);
    given = given || axis != frame.w();
  }
  const Vec3 in_plane = frame.toPlane(vector);
  if (given) plan.direction = in_plane.head<2>();
  plan.rapid = motion == 0;
  // Without axis words the block may still move the tool onto or off its offset path.
  const bool in_place = !anyAxisWord() && (was_on || plan.next.compOn());
  return !in_place || plan.rapid || feedStyle(plan, plan.feed);
}

bool NctControl::govern(BlockPlan& plan) {
  const GCode* code = plan.by_group[kOneShot];
  if (code == nullptr || code->plan == nullptr) {
    code = plan.next.inCycle() ? findGCode(plan.next.active[kGroupCycle])
                               : findGCode(plan.next.active[kGroupMotion]);
  }
  plan.governor = code;
  // To a modal motion a word that another code owns is no word; a code of this block cannot share one.
  const bool own_code = plan.by_group[static_cast<std::size_t>(code->group)] == code;
  if (own_code && !(plan.claimed & code->words & block_.present).empty()) {
    return fail("nct-2017", fmt::format("a word of the block would belong to {} and to another code",
                                        gName(code->code10)));
  }
  return (this->*code->plan)(plan);
}

bool NctControl::checkWords(const BlockPlan& plan) {
  const AddressSet legal = kCommonWords | plan.claimed | plan.governor->words;
  if (!block_.present.without(legal).empty()) {
    for (const Word& w : block_.words) {
      if (legal.has(w.address)) continue;
      if (AddressSet("ABC").has(w.address)) {
        return failWord("nct-2035",
                        fmt::format("wrong axis data: axis {} is not configured", addressText(w.address)), w);
      }
      if (AddressSet("cra").has(w.address)) {
        return failWord("nct-2123",
                        fmt::format("function not implemented: {} is not supported", addressText(w.address)),
                        w);
      }
      return failWord("nct-2017", fmt::format("illegal address {} in this block", addressText(w.address)), w);
    }
  }
  const bool call = plan.flow && plan.flow->code == 98;
  if (block_.has_file && !call) return fail("nct-2017", "a file name belongs to M98", block_.file_columns);
  return true;
}

bool NctControl::axisTarget(BlockPlan& plan, Vec3& target) {
  target = plan.start;
  const AddressSet present = block_.present & AddressSet("XYZUVW");
  if (present.empty()) return true;
  const double scale = plan.next.unitScale();
  for (const Word& w : block_.words) {
    if (!present.has(w.address)) continue;
    const bool secondary = w.address >= 'U' && w.address <= 'W';
    const int axis = w.address - (secondary ? 'U' : 'X');
    auto& named = plan.named[static_cast<std::size_t>(axis)];
    if (named) {
      return failWord(
          "nct-2017",
          fmt::format("illegal address {}: the axis is given twice in this block", addressText(w.address)),
          w);
    }
    named = true;
    const bool step = secondary || w.incremental || plan.next.incremental();
    target[axis] = step ? plan.start[axis] + w.value * scale : w.value * scale;
  }
  return true;
}

double NctControl::turnsPerMinute(const BlockPlan& plan) {
  const double rpm = plan.next.spindle_rpm;
  bool turning = plan.next.spindle_direction != 0 && rpm > 0.0;
  for (int i = 0; i < plan.m_count; ++i)
    turning = turning || ((plan.m_value[i] == 3 || plan.m_value[i] == 4) && rpm > 0.0);
  if (turning) return rpm;
  warnOnce("spindle-stopped", "nct-spindle-stopped",
           fmt::format("feed or dwell per turn while the spindle stands still: {} rpm is taken for the time",
                       settings_.default_spindle_rpm));
  return settings_.default_spindle_rpm;
}

bool NctControl::feedStyle(BlockPlan& plan, FeedStyle& style) {
  if (plan.next.feed <= 0.0) return fail("nct-feed", "no feed is programmed: a feed motion needs F");
  style.feed = plan.next.feed * plan.next.unitScale();
  if (plan.next.perTurn()) style.feed *= turnsPerMinute(plan);
  return true;
}

}  // namespace proveout::nc
