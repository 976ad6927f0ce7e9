// Order of execution of a line, and who owns its axis words.
#include <fmt/core.h>

#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/spindle/spindle.h"
#include "core/nc/iso/tools/tools.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/flavours/grbl.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"
#include "core/nc/linuxcnc/text/lcn_unused.h"

namespace proveout::nc {
namespace {

bool lcnTakeG(IsoContext& c, BlockPlan& plan, const Word& w) {
  const int code10 = code10Of(w);
  const GCode* code = code10 < 0 ? nullptr : c.codes.g(code10);
  const std::string text(c.block.text.substr(static_cast<std::size_t>(w.columns.begin - 1),
                                             static_cast<std::size_t>(w.columns.end - w.columns.begin)));
  if (code10 >= 0 && !flavourTakesG(c, w, code10)) return false;
  if (code == nullptr)
    return c.alarm(SharedAlarm::kNotImplemented, text + " is not a code of this control", {}, w.columns);
  if (!code->built)
    return c.alarm(SharedAlarm::kNotImplemented, fmt::format("{} ({}) is not supported", text, code->meaning),
                   {}, w.columns);
  const GCode*& slot = plan.by_group[static_cast<std::size_t>(code->group)];
  if (slot != nullptr) {
    return c.failWord(
        "group-clash",
        fmt::format("Two g codes used from same modal group: {} and {}", gName(slot->code10), gName(code10)),
        w);
  }
  slot = code;
  plan.any_group = true;
  plan.code_kinds.add(code->kinds);
  plan.flush = plan.flush || code->flushes;
  return true;
}

bool lcnTakeCodes(IsoContext& c, BlockPlan& plan) {
  if (c.block.present.has('M')) {
    for (const Word& w : c.block.words)
      if (w.address == 'M' && !flavourTakesM(c, w)) return false;
  }
  if (!c.block.present.has('G')) return true;
  for (const Word& w : c.block.words) {
    if (w.address == 'G' && !lcnTakeG(c, plan, w)) return false;
  }
  return true;
}

/// Codes outside the group of motions that take axis words for themselves.
bool lcnCovets(const IsoContext& c, const GCode* one_shot) {
  if (one_shot == nullptr) return false;
  switch (one_shot->code10) {
    case lcn::kData:
    case gcode::kReference:
    case gcode::kNumberedReference:
    case gcode::kLocalShift:
    case gcode::kSetPosition:
      return true;
    default:
      return one_shot->words.has('X') && lcnAnyAxis(c) && one_shot->code10 != gcode::kMachineMove;
  }
}

/// Whose the axis words of the block are: plan.governor. False: reported.
bool lcnChooseGovernor(IsoContext& c, BlockPlan& plan) {
  const GCode* motion = plan.by_group[kGroupMotion];
  const GCode* one_shot = plan.by_group[kOneShot];
  const bool covets = lcnCovets(c, one_shot);
  const GCode* length = plan.by_group[kGroupLengthComp];
  const GCode* scaling = plan.by_group[kGroupScaling];
  const GCode* rotation = plan.by_group[kGroupRotation];
  // G51 and G68 of Mach3 have axis words of their own.
  const bool transforms =
      (scaling != nullptr && scaling->code10 == 510) || (rotation != nullptr && rotation->code10 == 680);
  bool by_words = transforms ||
                  (length != nullptr && (length->code10 == lcn::kLengthByWords ||
                                         (length->code10 == lcn::kLengthAdded && !c.block.present.has('H'))));
  const bool axes = lcnAnyAxis(c);
  // In GRBL G49 takes the axis words of its line, and does nothing with them.
  if (isPlainGrbl(c) && length != nullptr && length->code10 == gcode::kLengthOff) {
    if (axes)
      c.warnOnce("grbl g49", "unused-word", "axis words beside G49 have no effect in GRBL: nothing moves");
    by_words = true;
  }
  if (motion != nullptr && motion->code10 != lcn::kNoMotion) {
    if ((covets || (by_words && axes)) && axes)
      return lcnFail(c, "axis-words", "Cannot use two g codes that both use axis values");
    plan.governor = motion;
    return true;
  }
  plan.governor = covets ? one_shot : c.codes.g(lcn::kNoMotion);
  if (covets || by_words || !axes) {
    const int active = c.state.active[kGroupMotion];
    // A spline goes on by its words alone.
    const bool goes_on = motion == nullptr && !covets && !by_words && active == 62 &&
                         linuxCncChannel(c).modal.nurbs == 2 && c.block.present.has('K');
    const bool arc = active == gcode::kArcClockwise || active == gcode::kArcCounterClockwise;
    const bool centre =
        motion == nullptr && !covets && !by_words && arc && !(c.block.present & AddressSet("IJK")).empty();
    if (goes_on || centre) plan.governor = c.codes.g(active);
    return true;
  }
  if (motion != nullptr) return lcnFail(c, "axis-words", "Cannot use axis values with g80");
  if (c.state.active[kGroupMotion] == lcn::kNoMotion)
    return lcnFail(c, "axis-words", "Cannot use axis values without a g code that uses them");
  plan.governor = c.codes.g(c.state.active[kGroupMotion]);
  return true;
}

bool lcnPlanFeedWords(IsoContext& c, BlockPlan& plan) {
  LinuxCncModal& next = linuxCncChannel(c).next;
  if (const GCode* mode = plan.by_group[kGroupFeedMode]) {
    plan.next.active[kGroupFeedMode] = mode->code10;
    // The word alone takes F away, in the same mode too; GRBL keeps it there.
    const bool same = mode->code10 == c.state.active[kGroupFeedMode];
    if (!(same && isGrbl(c))) next.feed = next.feed_number = plan.next.feed = 0.0;
  }
  const Word* f = c.word('F');
  if (f == nullptr) return true;
  if (f->value < 0.0) return lcnFail(c, "feed", "Negative f word used", f);
  next.feed_number = plan.next.feed = f->value;
  // The units of the line before: G20 and G21 come behind F.
  next.feed = f->value * c.state.unitScale();
  return true;
}

/// S alone: no number of a spindle by P, no limit by G92, as other controls have them.
bool lcnPlanSpindle(IsoContext& c, BlockPlan& plan) {
  const AddressSet claimed = plan.claimed;
  const GCode*& one_shot = plan.by_group[kOneShot];
  const GCode* const kept = one_shot;
  plan.claimed.add('P');
  if (one_shot != nullptr && one_shot->code10 == gcode::kSetPosition) one_shot = nullptr;
  const bool good = planSpindle(c, plan);
  one_shot = kept;
  if (!claimed.has('P')) plan.claimed = plan.claimed.without("P");
  return good;
}

bool lcnPlanSpeedWords(IsoContext& c, BlockPlan& plan) {
  IsoState& next = plan.next;
  if (const GCode* mode = plan.by_group[kGroupSurfaceSpeed]) {
    next.active[kGroupSurfaceSpeed] = mode->code10;
    plan.claimed = plan.claimed | mode->words;
    const Word* d = c.word('D');
    if (mode->code10 == gcode::kSurfaceSpeed) {
      if (d != nullptr && d->value <= 0.0)
        return lcnFail(c, "surface-speed", "D word with G96 must be positive", d);
      next.speed_limit = d == nullptr ? 0.0 : d->value;
      if (!c.block.present.has('S')) return lcnFail(c, "surface-speed", "S word missing with G96");
    }
  }
  if (const Word* s = c.word('S'); s != nullptr && s->value < 0.0)
    return lcnFail(c, "spindle", "Negative spindle speed used", s);
  const bool surface = next.active[kGroupSurfaceSpeed] == gcode::kSurfaceSpeed;
  if ((c.block.present.has('S') || surface) && !lcnPlanSpindle(c, plan)) return false;
  const bool left = c.state.active[kGroupSurfaceSpeed] == gcode::kSurfaceSpeed && !surface;
  plan.spindle_changed = plan.spindle_changed || left;
  if (const Word* t = c.word('T')) {
    if (!planTool(c, plan, *t)) return false;
    plan.tool_called = true;
  }
  if (plan.tool_change && c.state.compOn())
    return lcnFail(c, "comp", "Cannot change tools with cutter radius compensation on");
  return true;
}

/// A code of a group that only sets it.
void lcnSet(BlockPlan& plan, IsoGroup group) {
  if (const GCode* code = plan.by_group[static_cast<std::size_t>(group)]) {
    plan.next.active[static_cast<std::size_t>(group)] = code->code10;
    plan.claimed = plan.claimed | code->words;
  }
}

bool lcnPlanPlane(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupPlane];
  if (code == nullptr) return true;
  if (code->code10 != c.state.active[kGroupPlane] && c.state.compOn())
    return lcnFail(c, "comp", "Cannot change planes with cutter radius compensation on");
  lcnSet(plan, kGroupPlane);
  plan.next.takeMainPlane();
  return true;
}

bool lcnPlanModes(IsoContext& c, BlockPlan& plan) {
  if (!plan.any_group) {
    plan.chain = &c.chain;
    return true;
  }
  const GCode* units = plan.by_group[kGroupUnits];
  if (units != nullptr && units->code10 != c.state.active[kGroupUnits] && !(c.state.length == AxisPoint()))
    c.warnOnce(
        "units with length", "units-with-length",
        "the units change while a tool offset is in force: the interpreter of LinuxCNC 2.9 keeps the "
        "offset's number, so that its next G43, G49, G28, G30 or G53 may go elsewhere; here the offset "
        "stays what it is: program the units before G43");
  if (!lcnPlanPlane(c, plan)) return false;
  lcnSet(plan, kGroupUnits);
  lcnSet(plan, static_cast<IsoGroup>(kGroupLathe));
  plan.next.axes.diameter[0] = plan.next.active[kGroupLathe] == lcn::kDiameterMode;
  // What the offsets change is planned with the words as the line before has them, but with these units.
  if (!planLcnComp(c, plan)) return false;
  if (linuxCncFlavour(c) == LinuxCncFlavour::kMach3 && !planMach3Radius(c, plan)) return false;
  if (!planLcnLength(c, plan) || !planLcnFrame(c, plan)) return false;
  if (!planMach3Transforms(c, plan)) return false;
  for (const auto group :
       {kGroupCutting, kGroupDistance, static_cast<IsoGroup>(kGroupArcCentre), kGroupReturn, kGroupPolarData})
    lcnSet(plan, group);
  if (plan.frames_changed) {
    plan.new_chain = c.chainOf(plan.next);
    plan.chain = &*plan.new_chain;
    plan.start = plan.chain->programOf(c.machine);
  } else {
    plan.chain = &c.chain;
  }
  return true;
}

/// The one-shot code that stands beside the motion or alone, then the motion.
bool lcnGovern(IsoContext& c, BlockPlan& plan) {
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot != nullptr && one_shot->plan != nullptr && plan.governor != one_shot) {
    if (!one_shot->plan(c, plan)) return false;
    plan.claimed = plan.claimed | one_shot->words.without(plan.governor->words);
  }
  LinuxCncModal& next = linuxCncChannel(c).next;
  const GCode* motion = plan.by_group[kGroupMotion];
  const int active = c.state.active[kGroupMotion];
  if (motion != nullptr) plan.next.active[kGroupMotion] = motion->code10;
  if (motion != nullptr && motion->code10 != 50) next.cubic.reset();
  const bool open = next.nurbs != 0 && motion != nullptr;
  if (open && next.nurbs == 1 && motion->code10 != 52 && motion->code10 != 53)
    return lcnFail(c, "spline", "Must use g5.3 to close the NURBS block that G5.2 has opened");
  if (next.nurbs == 2 && motion != nullptr && motion->code10 != 62) next.nurbs = 0;
  (void)active;
  return plan.governor->plan(c, plan);
}

/// Words that no code of the line takes.
bool lcnCheckWords(IsoContext& c, const BlockPlan& plan) {
  AddressSet legal = AddressSet("GMFST") | plan.claimed | plan.governor->words;
  if (plan.governor->words.has('X')) {
    legal = legal | c.axes.addresses();
    legal.add('^');
    legal.add(kNamedWord);
  }
  if (c.block.present.without(legal).empty()) return true;
  for (const Word& w : c.block.words) {
    if (legal.has(w.address)) continue;
    return lcnFail(c, "unused-word", std::string(lcnUnusedWord(w.address)), &w);
  }
  return true;
}

}  // namespace

bool lcnFail(IsoContext& c, const char* name, std::string message, const Word* at) {
  if (const int number = isGrbl(c) ? grblError(name) : 0; number != 0) {
    return c.fail(fmt::format("error-{}", number), fmt::format("error:{} {}", number, message),
                  at == nullptr ? Columns{} : at->columns);
  }
  return c.fail(name, std::move(message), at == nullptr ? Columns{} : at->columns);
}

bool planLinuxCncBlock(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  own.begin();
  c.asked = {};
  plan.start = c.position;
  plan.motion.target = plan.start;
  plan.governor = c.codes.g(lcn::kNoMotion);
  plan.next.axes.threading = false;
  if (c.block.number >= 0) plan.next.last.n = c.block.number;
  return lcnTakeCodes(c, plan) && (!isPlainGrbl(c) || grblTakesBlock(c, plan)) && collectM(c, plan) &&
         lcnChooseGovernor(c, plan) && lcnPlanFeedWords(c, plan) && lcnPlanSpeedWords(c, plan) &&
         lcnPlanModes(c, plan) && flavourTakesWords(c, plan) && lcnGovern(c, plan) &&
         (isPlainGrbl(c) ? grblUsesWords(c, plan) : lcnCheckWords(c, plan));
}

void powerOnLinuxCnc(const IsoContext& c, IsoState& s) {
  s.active[kGroupMotion] = lcn::kNoMotion;
  s.active[kGroupReturn] = gcode::kReturnToR;
  s.active[kGroupArcCentre] = lcn::kCentreIncremental;
  s.active[kGroupLathe] = lcn::kRadiusMode;
  s.feed = 0.0;
  if (isGrbl(c)) s.active[kGroupMotion] = gcode::kRapid;
  if (!c.parameters.flag(LinuxCncParam::kLathe)) return;
  s.active[kGroupPlane] = gcode::kPlaneZX;
  s.takeMainPlane();
}

}  // namespace proveout::nc
