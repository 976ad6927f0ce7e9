// Planning of a block: codes, words, checks. Nothing here changes the control.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/iso/axes/axis_events.h"
#include "core/nc/iso/block/auxiliary.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/five_axis/tip_control.h"
#include "core/nc/iso/frames/transforms.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/motion/held_way.h"
#include "core/nc/iso/motion/planes.h"
#include "core/nc/iso/motion/tool_direction.h"
#include "core/nc/iso/motion/virtual_plane.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/perform/unused_words.h"
#include "core/nc/iso/spindle/spindle.h"
#include "core/nc/iso/spindle/wait.h"
#include "core/nc/iso/tools/tools.h"

namespace proveout::nc {
namespace {

/// Smallest F: slower than this no machine moves, and times stay finite.
constexpr double kMinFeed = 1e-6;

/// Words that every block may carry.
constexpr AddressSet kCommonWords = "GMFSTHD";

bool acceptG(IsoContext& c, BlockPlan& plan, const Word& word);
bool refuseG(IsoContext& c, const Word& word, const GCode* code);
bool takeAxisWords(IsoContext& c, BlockPlan& plan, const GCode& code);
bool claim(IsoContext& c, BlockPlan& plan, const GCode& code);

bool collectG(IsoContext& c, BlockPlan& plan) {
  if (!c.block.present.has('G')) return true;
  for (const Word& w : c.block.words) {
    if (w.address == 'G' && !acceptG(c, plan, w)) return false;
  }
  return true;
}

/// Of a motion code and a cycle in one block the later one holds; the motion code then counts from where the
/// cycle ends.
void dropMotionOrCycle(BlockPlan& plan, const GCode& later) {
  const GCode*& motion = plan.by_group[kGroupMotion];
  const GCode*& cycle = plan.by_group[kGroupCycle];
  if (later.code10 == gcode::kCycleCancel) return;
  if (later.group == kGroupMotion && cycle != nullptr && cycle->code10 != gcode::kCycleCancel)
    cycle = nullptr;
  if (later.group != kGroupCycle || motion == nullptr) return;
  plan.next.active[kGroupMotion] = motion->code10;
  motion = nullptr;
}

bool acceptG(IsoContext& c, BlockPlan& plan, const Word& w) {
  const int code10 = code10Of(w);
  const GCode* code = code10 < 0 ? nullptr : c.codes.g(code10);
  if (code == nullptr || !code->built) {
    if (!refuseG(c, w, code)) return false;
    plan.claimed = plan.claimed | code->words;  // a lenient run leaves the code and its words out
    return true;
  }
  const bool exact_stop = code10 == gcode::kExactStop;
  auto& slot = plan.by_group[static_cast<std::size_t>(code->group)];
  if (code->group == kOneShot) {
    if (exact_stop) {  // may stand with any motion
      plan.exact_stop = true;
      return true;
    }
    if (slot != nullptr) {
      return c.failWord(
          "group-clash",
          fmt::format("{} and {} cannot stand in one block", gName(slot->number10()), gName(code10)), w);
    }
  } else if (slot != nullptr && !c.dialect.rules.last_of_group) {
    const auto same = slot == code
                          ? fmt::format("{} twice in one block", gName(code10))
                          : fmt::format("{} and {} are of one group", gName(slot->number10()), gName(code10));
    return c.failWord("group-clash", same, w);
  }
  if (c.dialect.rules.motion_or_cycle) dropMotionOrCycle(plan, *code);
  slot = code;
  plan.any_group = true;
  plan.code_kinds.add(code->kinds);
  plan.flush = plan.flush || code->flushes;
  return true;
}

bool refuseG(IsoContext& c, const Word& w, const GCode* code) {
  const std::string name =
      std::string(c.block.text.substr(static_cast<std::size_t>(w.columns.begin - 1),
                                      static_cast<std::size_t>(w.columns.end - w.columns.begin)));
  if (code == nullptr)
    return c.alarm(SharedAlarm::kNotImplemented, name + " is not a code of this control", {}, w.columns);
  if (c.settings.lenient && code->skippable) {
    c.warn(SharedAlarm::kNotImplemented,
           fmt::format("{} ({}) is not supported and left out", name, code->meaning), w.columns);
    return true;
  }
  return c.alarm(SharedAlarm::kNotImplemented, fmt::format("{} ({}) is not supported", name, code->meaning),
                 {}, w.columns);
}

/// The words of a code belong to another code of the block already. Always false.
bool sharedWord(IsoContext& c, const BlockPlan& plan, AddressSet words, const std::string& code) {
  const AddressSet shared = plan.claimed & words & c.block.present;
  const auto word = std::find_if(c.block.words.begin(), c.block.words.end(),
                                 [&](const Word& w) { return shared.has(w.address); });
  return c.alarm(SharedAlarm::kIllegalAddress, *word,
                 fmt::format("it would belong to {} and to another code", code));
}

/// Whether the code may stand beside those of the block so far. False: reported.
bool goesTogether(IsoContext& c, const BlockPlan& plan, const Word& w, int number, const MFunction& found) {
  const int programmed = c.registers.spindles.programmed;
  const int exclusive = found.exclusive(programmed);
  for (int i = 0; i < plan.m_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const MFunction& other = *plan.m[k];
    const bool both = (exclusive > 0 && exclusive == other.exclusive(programmed)) ||
                      (found.group > 0 && found.group == other.group);
    if (!both && plan.m_value[k] != number) continue;
    return c.failWord("contradictory-m",
                      fmt::format("contradictory M codes: M{} and M{}", plan.m_value[k], number), w);
  }
  return true;
}

/// What one of the control's own codes does to the plan. False: reported.
bool takeOwnM(IsoContext& c, BlockPlan& plan, const MCode& code) {
  if (!(plan.claimed & code.words & c.block.present).empty())
    return sharedWord(c, plan, code.words, fmt::format("M{}", code.code));
  plan.claimed = plan.claimed | code.words;
  if (code.phase == MPhase::kCall || code.phase == MPhase::kEnd) plan.flow = &code;
  const bool change = code.code == mcode::kToolChange;
  plan.flush = plan.flush || code.phase == MPhase::kStop || code.phase == MPhase::kEnd || change;
  plan.tool_change = plan.tool_change || change;
  return code.plan == nullptr || code.plan(c, plan);
}

bool takeM(IsoContext& c, BlockPlan& plan, const Word& w) {
  std::int64_t value = 0;
  if (!integerWord(c, w, 0, 99999999, value)) return false;
  if (plan.m_count == 8) return c.failWord("m-count", "more than 8 M functions in one block", w);
  const auto number = static_cast<int>(value);
  const MFunction& found = c.m_index.find(number);
  if (found.waits) return planWait(c, plan, w);
  if (!goesTogether(c, plan, w, number, found)) return false;
  plan.flush = plan.flush || found.ends_look_ahead;
  const bool known = found.interrupt != InterruptSwitch::kNone || found.of_place || found.event != nullptr ||
                     found.ofSpindle(c.registers.spindles.programmed);
  if (found.own == nullptr && !known && c.dialect.unknown_m != nullptr) {
    if (!c.dialect.unknown_m(c, w, number)) return false;
  } else if (found.own == nullptr && !known) {
    c.warnOnce(
        fmt::format("M{}", number), "m-function",
        fmt::format("M{} is a function of the machine builder: it has no effect in the simulation", number),
        w.columns);
  }
  if (found.own != nullptr && !takeOwnM(c, plan, *found.own)) return false;
  plan.m[static_cast<std::size_t>(plan.m_count)] = &found;
  plan.m_value[static_cast<std::size_t>(plan.m_count++)] = number;
  if (plan.m_count == c.dialect.rules.m_words + 1 && c.firstTime("several M functions")) {
    c.warn(
        "m-words",
        fmt::format("more than {} M function in a block: not every control takes them, here all are run in "
                    "their order (told once)",
                    c.dialect.rules.m_words),
        w.columns, Severity::kNote);
  }
  plan.next.last.m = number;
  return true;
}

}  // namespace

bool collectM(IsoContext& c, BlockPlan& plan) {
  if (!c.block.present.has('M')) return true;
  c.m_index.update(c.parameters);
  for (const Word& w : c.block.words) {
    if (w.address == 'M' && !takeM(c, plan, w)) return false;
  }
  return true;
}

namespace {

bool planModal(IsoContext& c, BlockPlan& plan) {
  IsoState& next = plan.next;
  const GCode* motion = plan.by_group[kGroupMotion];
  const GCode* cycle = plan.by_group[kGroupCycle];
  if (motion && cycle && cycle->code10 != gcode::kCycleCancel) {
    return c.fail("group-clash", fmt::format("{} and {} cannot stand in one block", gName(motion->number10()),
                                             gName(cycle->number10())));
  }
  for (std::size_t g = 1; plan.any_group && g < plan.by_group.size(); ++g) {
    const GCode* code = plan.by_group[g];
    if (code == nullptr) continue;
    next.active[g] = code->code10;
    if (g == kOneShot || g == kGroupMotion || g == kGroupCycle) continue;
    const bool governs = code->plan != nullptr && (code->code10 != gcode::kMirrorOff || c.anyAxisWord());
    if (governs ? !takeAxisWords(c, plan, *code) : !claim(c, plan, *code)) return false;
  }
  if (plan.by_group[kGroupPlane] && !planPlane(c, plan)) return false;
  next.axes.threading = false;
  if (next.active[kGroupPolarData] == gcode::kPolarData &&
      c.state.active[kGroupPolarData] != gcode::kPolarData)
    next.axes.polar.known = false;
  if (plan.by_group[kGroupUnits] && next.active[kGroupUnits] != c.state.active[kGroupUnits] &&
      c.state.feed > 0.0 && !c.block.present.has('F')) {
    c.warn("feed-unit", "the unit changes: the modal feed keeps its number and takes the new unit");
  }
  // A group-1 code ends the cycle mode; ending it restores G98 (manual 18.1.4).
  if (motion) next.active[kGroupCycle] = gcode::kCycleCancel;
  if (!next.inCycle()) {
    const bool ends = c.state.inCycle() && !c.dialect.rules.keeps_return_level;
    if (ends && plan.by_group[kGroupReturn] == nullptr) next.active[kGroupReturn] = gcode::kReturnToInitial;
    next.cycle = CycleWords{};
  }
  return true;
}

/// A modal code with a plan of its own owns the axis words of its block.
bool takeAxisWords(IsoContext& c, BlockPlan& plan, const GCode& code) {
  const GCode* one_shot = plan.by_group[kOneShot];
  const GCode* other = plan.governor ? plan.governor : one_shot && one_shot->plan ? one_shot : nullptr;
  if (other != nullptr) {
    return c.fail("group-clash", fmt::format("{} and {} cannot stand in one block", gName(other->number10()),
                                             gName(code.number10())));
  }
  plan.governor = &code;
  return true;
}

bool claim(IsoContext& c, BlockPlan& plan, const GCode& code) {
  const int motion = plan.next.active[kGroupMotion];
  // In a circular block I, J, K are the centre, not the vector of a change of side.
  const bool arc = motion == gcode::kArcClockwise || motion == gcode::kArcCounterClockwise;
  if (code.group == kGroupRadiusComp && (arc || plan.next.inCycle())) return true;
  // A one-shot code that reads D offsets its path itself, and I, J, K are its own too.
  const GCode* one_shot = plan.by_group[kOneShot];
  if (code.group == kGroupRadiusComp && one_shot != nullptr && one_shot->words.has('D')) return true;
  if (!(plan.claimed & code.words & c.block.present).empty()) {
    return sharedWord(c, plan, code.words, gName(code.number10()));
  }
  plan.claimed = plan.claimed | code.words;
  return true;
}

bool planNumbers(IsoContext& c, BlockPlan& plan) {
  // The lead of a thread is not the feed of other blocks.
  const bool thread = plan.next.active[kGroupMotion] == gcode::kThread && !plan.next.inCycle();
  if (const Word* f = c.word('F'); f && !thread) {
    if (f->value <= 0.0) return c.failWord("feed", "F must be greater than 0", *f);
    if (f->value < kMinFeed) return c.alarm(SharedAlarm::kOutOfRange, *f, "at least 0.000001");
    plan.next.feed = f->value;
  }
  const bool spindle = c.block.present.has('S') || c.block.present.has(kNamedWord) ||
                       plan.next.active[kGroupSurfaceSpeed] == gcode::kSurfaceSpeed ||
                       c.registers.spindles.has_axes || c.registers.spindles.has_codes;
  if (spindle && !planSpindle(c, plan)) return false;
  if (c.block.present.has('S') && c.parameters.flag(ProgramParam::kBufferS)) plan.flush = true;
  const bool left = c.state.active[kGroupSurfaceSpeed] == gcode::kSurfaceSpeed &&
                    plan.next.active[kGroupSurfaceSpeed] != gcode::kSurfaceSpeed;
  plan.spindle_changed = plan.spindle_changed || left;  // the speed is the last one of G96
  if (const Word* t = c.word('T')) {
    if (!(c.dialect.tool ? c.dialect.tool : planTool)(c, plan, *t)) return false;
    plan.tool_called = true;
    plan.flush = plan.flush || c.parameters.flag(ProgramParam::kBufferT);
    if (!c.parameters.flag(MachineParam::kToolChangeOnM6)) {
      plan.tool_change = true;
      plan.flush = true;
    }
  }
  return true;
}

bool planOffsetsHD(IsoContext& c, BlockPlan& plan) {
  if (c.dialect.rules.offsets_by_tool) return true;
  if (c.dialect.offsets != nullptr) return c.dialect.offsets(c, plan);
  const auto rows = static_cast<std::int64_t>(c.parameters[CompParam::kToolOffsets]);
  const OffsetTables& table = c.registers.offsets;
  const auto rowOf = [&](const Word& w, OffsetColumn column, int& row) {
    std::int64_t number = -1;
    if (!offsetRowOfTool(c, w, number)) return false;
    if (number < 0 && !integerWord(c, w, 0, rows, number)) return false;
    row = static_cast<int>(number);
    if (row == 0 || table.given(column, row)) return true;
    const auto name = fmt::format("{}{}", addressText(w.address), row);
    c.warnOnce(name, "offset-missing",
               fmt::format("{0} has no value in the offset table: 0 is taken (--offset {0}=VALUE)", name),
               w.columns);
    return true;
  };
  IsoState& next = plan.next;
  if (const Word* h = c.word('H')) {
    if (!rowOf(*h, OffsetColumn::kLength, next.h)) return false;
    next.h_value = table.effective(OffsetColumn::kLength, next.h);
    next.h_turning = {table.effective(OffsetColumn::kX, next.h), table.effective(OffsetColumn::kY, next.h)};
  }
  if (const Word* d = c.word('D')) {
    if (!rowOf(*d, OffsetColumn::kRadius, next.d)) return false;
    next.d_radius = table.effective(OffsetColumn::kRadius, next.d);
    next.d_tip = table.tip(next.d);
    plan.tool_shape = next.d > 0 && table.given(OffsetColumn::kCorner, next.d);
  }
  return true;
}

/// A work system that neither the job nor the program has given a value.
void warnOfMissingOffset(IsoContext& c, WorkSystemId id) {
  if (!lacksWorkOffset(c.settings, id)) return;
  const WorkSystem system = c.registers.frames.system(id);
  const auto set = [](std::uint32_t by) { return by != 0; };
  if (std::any_of(system.offset_by.begin(), system.offset_by.end(), set) || system.offset.xyz != Vec3::Zero())
    return;
  const std::string name = workSystemName(id);
  std::string option = name;
  std::erase(option, ' ');  // one word on a command line
  c.warnOnce(name, "offset-missing",
             fmt::format("{} has no value in the job: 0 is taken (--offset {}=X,Y,Z)", name, option));
}

bool isUsualSystem(int code10) {
  return code10 == gcode::kExtendedWorkSystem ||
         (code10 % 10 == 0 && code10 >= gcode::kWorkSystem1 && code10 <= gcode::kWorkSystem1 + 50);
}

bool planWorkSystem(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupWorkSystem];
  if (code == nullptr) return true;
  plan.next.five.dynamic_zero = 0;
  if (code->code10 == gcode::kDynamicZero) {
    if (!planDynamicZero(c, plan)) return false;
  } else if (c.dialect.usual_systems != nullptr && isUsualSystem(code->code10)) {
    if (!c.dialect.usual_systems(c, plan)) return false;
  } else if (code->code10 == gcode::kExtendedWorkSystem) {
    const Word* p = c.word('P');
    std::int64_t number = 0;
    if (p == nullptr) return c.alarm(SharedAlarm::kMissingData, "P", "G54.1 needs P1 to P99");
    if (!integerWord(c, *p, 1, 99, number)) return false;
    plan.next.work_system = kFirstExtended + static_cast<int>(number) - 1;
    plan.next.last.extended_system = static_cast<int>(number);
  } else if (int id = 0; c.dialect.work_system != nullptr) {
    if (!c.dialect.work_system(c, plan, *code, id)) return false;
    plan.next.work_system = id > 0 ? id : (code->code10 - gcode::kWorkSystem1) / 10 + 1;
  } else {
    plan.next.work_system = (code->code10 - gcode::kWorkSystem1) / 10 + 1;
  }
  plan.frames_changed = true;
  if (plan.next.five.dynamic_zero == 0) warnOfMissingOffset(c, plan.next.work_system);
  return true;
}

/// The axes that get the length of G43 and G44.
AxisSet lengthAxes(const IsoContext& c, const BlockPlan& plan) {
  AxisSet axes;
  const bool always_z = c.parameters.flag(CompParam::kLengthAlwaysZ);
  const bool by_plane = !always_z && c.parameters.flag(CompParam::kLengthByPlane);
  if (always_z || by_plane) {
    axes.set(static_cast<std::size_t>(always_z ? 2 : plan.next.workPlane().w));
    return axes;
  }
  for (const Word& w : c.block.words) {
    AxisWord named;
    if (axisWord(plan, w, named)) axes.set(static_cast<std::size_t>(named.axis));
  }
  return axes;
}

bool planLength(IsoContext& c, BlockPlan& plan) {
  IsoState& next = plan.next;
  const GCode* code = plan.by_group[kGroupLengthComp];
  const int mode = next.active[kGroupLengthComp];
  if (code && !holdsTip(mode) && mode != gcode::kLengthOff && next.five.tip != TipControl::kOff)
    return c.fail("tcp-definition", fmt::format("{} cannot follow tool centre point control at once: program "
                                                "G49 first",
                                                gName(mode)));
  if (next.axes.smoothing == 3 && (code || (mode != gcode::kLengthOff && c.block.present.has('H')))) {
    return c.alarm(SharedAlarm::kInSmoothing, code ? gName(code->number10()) : "H");
  }
  if (code && mode == gcode::kLengthOff) {
    next.length = AxisPoint();
    if (next.five.tip != TipControl::kOff && !leavesTipControl(c, plan)) return false;
    next.five.endLength();
    plan.frames_changed = true;
  } else if (holdsTip(mode)) {
    if (!planTipControl(c, plan)) return false;
  } else if (mode == gcode::kLengthAlongTool && (code || c.block.present.has('H'))) {
    if (!planLengthAlongTool(c, plan)) return false;
  } else if (mode == gcode::kLengthTurning && (code || c.block.present.has('H'))) {
    if (!planTurningLength(c, plan)) return false;
  } else if (mode != gcode::kLengthOff && (code || c.block.present.has('H'))) {
    if (c.state.active[kGroupLengthComp] == gcode::kLengthTurning) next.length = AxisPoint();
    const double value = mode == gcode::kLengthPlus ? next.h_value : -next.h_value;
    AxisSet axes = lengthAxes(c, plan);
    if (c.dialect.length_axes != nullptr && !c.dialect.length_axes(c, plan, axes)) return false;
    for (int axis = 0; axis < c.axes.count(); ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      if (axes[k]) next.length[axis] = next.axes.diameter[k] ? 0.5 * value : value;
    }
    next.five.along_tool = next.five.on_table && c.five_axes.hasHead();
    plan.frames_changed = true;
    plan.flush = true;
  }
  if (plan.frames_changed || plan.transforms_changed) {
    plan.new_chain = c.chainOf(next);
    plan.chain = &*plan.new_chain;
    plan.start = holdsPosition(c, plan) ? c.position : plan.chain->programOf(c.machine);
    if (c.dialect.rules.holds_length) holdLength(c, plan);
  } else {
    plan.chain = &c.chain;
  }
  return true;
}

bool planComp(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupRadiusComp];
  const bool was_on = c.state.compOn();
  if (was_on && !(plan.next.workPlane() == c.state.workPlane())) {
    return c.fail(SharedAlarm::kPlaneInComp,
                  "the plane cannot change while cutter compensation (G41, G42) is on");
  }
  if (plan.next.compOn() && plan.next.inCycle() && !c.dialect.rules.cycles_in_comp) {
    return c.fail("cycle-in-comp",
                  "drilling cycles cannot run while cutter compensation (G41, G42) is on: program G40 first");
  }
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot && one_shot->code10 == gcode::kKeepVector && !(was_on && plan.next.compOn())) {
    return c.fail("cutter-comp", "G38 and G39 need G41 or G42");
  }
  if (code == nullptr || code->code10 == gcode::kCompInSpace) return true;
  if (plan.next.compOn() && !planeOfLines(c, plan, SharedAlarm::kPlane, "G41 and G42 need linear axes"))
    return false;
  const int motion = plan.next.active[kGroupMotion];
  if (motion == gcode::kArcClockwise || motion == gcode::kArcCounterClockwise) {
    if (!plan.next.compOn() && was_on) return c.alarm(SharedAlarm::kCompEndInArc, "");
    if (plan.next.compOn() && !was_on)
      return c.fail(SharedAlarm::kCompStartInArc, "G41, G42 cannot be switched on in a G2 or G3 block");
    return true;
  }
  if (plan.next.compOn() && plan.next.d == 0 && !c.block.present.has('D') && c.state.d == 0) {
    c.warn("no-d", c.dialect.rules.offsets_by_tool
                       ? "T has named no offset: compensation runs with radius 0"
                       : "no D is programmed: cutter compensation runs with radius 0");
  }
  const PlaneFrame frame(plan.next.plane());
  Vec3 vector = Vec3::Zero();
  bool given = false;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.word("IJK"[axis]);
    if (w == nullptr) continue;
    vector[axis] = lengthOf(plan, *w);
    given = given || axis != frame.w();
    if (axis == frame.w()) {
      tellUnused(c, *w, gName(code->number10()), "it stands across the plane");
    } else if (was_on == plan.next.compOn()) {
      tellUnused(c, *w, gName(code->number10()), "cutter compensation neither starts nor ends here");
    }
  }
  const Vec3 in_plane = frame.toPlane(vector);
  if (given) plan.motion.direction = in_plane.head<2>();
  plan.motion.rapid = motion == gcode::kRapid;
  // Without axis words the block may still move the tool onto or off its offset path.
  const bool in_place = !c.anyAxisWord() && (was_on || plan.next.compOn());
  return !in_place || plan.motion.rapid || feedStyle(c, plan, plan.motion.feed);
}

/// The modal code that the axis words of a block without another one belong to.
const GCode* modalGovernor(const IsoContext& c, const BlockPlan& plan) {
  if (plan.next.inCycle()) return c.codes.inForce(plan.next.active[kGroupCycle]);
  return c.codes.inForce(callsInRapid(plan) ? gcode::kRapid : plan.next.active[kGroupMotion]);
}

bool govern(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.governor ? plan.governor : plan.by_group[kOneShot];
  if (code == nullptr || code->plan == nullptr) code = modalGovernor(c, plan);
  plan.governor = code;
  // To a modal motion a word that another code owns is no word; a code of this block cannot share one.
  const bool own_code = plan.by_group[static_cast<std::size_t>(code->group)] == code;
  // Under G43.5 I, J and K are never the centre of an arc.
  const AddressSet words =
      plan.next.five.tip == TipControl::kVector ? code->words.without("IJK") : code->words;
  if (own_code && !(plan.claimed & words & c.block.present).empty()) {
    return sharedWord(c, plan, words, gName(code->number10()));
  }
  return code->plan(c, plan);
}

bool checkWords(IsoContext& c, const BlockPlan& plan) {
  AddressSet legal = kCommonWords | plan.claimed | plan.governor->words;
  if (plan.governor->words.has('X')) legal = legal | c.axes.addresses();
  if (!c.block.present.without(legal).empty()) {
    for (const Word& w : c.block.words) {
      if (legal.has(w.address)) continue;
      if (AddressSet("ABC").has(w.address) && w.axis < 0) {
        return c.failWord(SharedAlarm::kAxis,
                          fmt::format("wrong axis data: axis {} is not configured", addressText(w.address)),
                          w);
      }
      return c.failWord(SharedAlarm::kIllegalAddress,
                        fmt::format("illegal address {} in this block", addressText(w.address)), w);
    }
  }
  const bool call = plan.flow && plan.flow->code == mcode::kCall;
  if (c.block.has_file && !call)
    return c.alarm(SharedAlarm::kIllegalAddress, "<>", "a file name belongs to M98", c.block.file_columns);
  tellUnusedWords(c, plan, kCommonWords);
  return true;
}

}  // namespace

bool planBlock(IsoContext& c, BlockPlan& plan) {
  c.asked = {};
  plan.start = c.position;
  if (c.block.number >= 0) plan.next.last.n = c.block.number;
  if (const Word* e = c.block.find('E')) plan.next.last.e = e->value;
  return takeAuxiliary(c, plan) && collectG(c, plan) && collectM(c, plan) && planModal(c, plan) &&
         (c.state.axes.mode == VirtualMode::kOff || checkVirtual(c, plan)) && planNumbers(c, plan) &&
         planOffsetsHD(c, plan) && planTiltState(c, plan) && planWorkSystem(c, plan) &&
         (c.dialect.transforms_off ? c.dialect.transforms_off : planTransformsOff)(c, plan) &&
         planLength(c, plan) && planComp(c, plan) && govern(c, plan) && followZero(c, plan) &&
         checkAxisModes(c, plan) && checkWords(c, plan) &&
         (c.dialect.check_block == nullptr || c.dialect.check_block(c, plan));
}

}  // namespace proveout::nc
