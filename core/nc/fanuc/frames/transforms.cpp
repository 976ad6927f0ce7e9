// G68, G69, G51, G50, G51.1, G50.1 (iso-fanuc, section 9).
//
// A point goes through mirror, scaling, rotation. The shared map (Transforms) has mirroring outermost, which
// is the same picture: the centre of the rotation is scaled, and the mirror takes both along.
#include "core/nc/iso/frames/transforms.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/motion/held_way.h"
#include "core/nc/iso/perform/unused_words.h"

namespace proveout::nc {
namespace {

using Kind = Transforms::Kind;

const char* nameOf(Kind kind) {
  switch (kind) {
    case Kind::kMirror:
      return "G51.1";
    case Kind::kScaling:
      return "G51";
    case Kind::kRotation:
      return "G68";
    case Kind::kNone:
      break;
  }
  return "";
}

void begins(Transforms& t, Kind kind) {
  if (std::find(t.nested.begin(), t.nested.end(), kind) != t.nested.end()) return;
  *std::find(t.nested.begin(), t.nested.end(), Kind::kNone) = kind;
}

/// Takes a transform off the list, with a note where one that came later is still on.
void ends(IsoContext& c, Transforms& t, Kind kind) {
  auto* const at = std::find(t.nested.begin(), t.nested.end(), kind);
  if (at == t.nested.end()) return;
  const Kind inner = at + 1 == t.nested.end() ? Kind::kNone : *(at + 1);
  std::copy(at + 1, t.nested.end(), at);
  t.nested.back() = Kind::kNone;
  if (inner == Kind::kNone) return;
  c.warnOnce("transform nesting", "transform-order",
             fmt::format("{} ends while {}, which came later, is still on: the one that came last should end "
                         "first",
                         nameOf(kind), nameOf(inner)),
             {}, Severity::kNote);
}

/// Where the machine is, in the program's coordinates with these transforms.
AxisPoint standsIn(const IsoContext& c, const IsoState& state, const Transforms& transforms) {
  IsoState copy = state;
  copy.transforms = transforms;
  return c.chainOf(copy).programOf(c.machine);
}

/// Where the program counts the tool.
AxisPoint countedAt(const IsoContext& c) {
  AxisPoint at = c.position;
  for (int axis = 0; axis < kMainAxes; ++axis) {
    if (c.state.held.axes[static_cast<std::size_t>(axis)]) at[axis] += c.state.held.way[axis];
  }
  return at;
}

/// The axis words of a centre: always absolute.
bool fanucCentre(IsoContext& c, const BlockPlan& plan, AxisPoint& centre, AxisSet& named) {
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    if (word.own_step)
      return c.alarm(SharedAlarm::kIllegalAddress, w, "the words of a centre are absolute: X, Y, Z");
    const auto axis = static_cast<std::size_t>(word.axis);
    if (named[axis]) return c.alarm(SharedAlarm::kIllegalAddress, w, "the axis is given twice in this block");
    named.set(axis);
    centre[word.axis] = axisValue(c, plan, word, w);
  }
  return true;
}

/// A factor of G51: with a point, or computed, it is the factor, else it counts in `scale_unit`.
double factorOfWord(const IsoContext& c, const Word& w) {
  return w.point || w.from_expression ? w.value : w.value * c.parameters[FanucParam::kScaleUnit];
}

bool usable(IsoContext& c, const Word& w, double factor, bool may_mirror) {
  const double size = may_mirror ? std::abs(factor) : factor;
  return (size >= 1e-5 && size <= 999999.0) ||
         c.failWord(
             "142",
             fmt::format("illegal scale rate: {} gives the factor {:g}; a number without a point counts "
                         "in {:g}",
                         addressText(w.address), factor, c.parameters[FanucParam::kScaleUnit]),
             w);
}

bool refuseInComp(IsoContext& c, const BlockPlan& plan) {
  return (!c.state.compOn() && !plan.next.compOn()) ||
         c.fail("141", "G51 cannot be commanded in cutter compensation (G41, G42): program G40 first");
}

/// A plane that can be rotated: lengths on both axes.
bool lengthsTurn(IsoContext& c, const BlockPlan& plan) {
  const AxisModal& modal = plan.next.axes;
  const bool rotary = c.axes.at(modal.plane_u).rotary() || c.axes.at(modal.plane_v).rotary();
  return !rotary || modal.mode != VirtualMode::kOff ||
         c.alarm(SharedAlarm::kPlane, "", "G68 rotates planes of linear axes");
}

bool planePlan(IsoContext& c, const BlockPlan& plan) {
  const Transforms& t = c.state.transforms;
  const bool rotates = t.rotates && plan.next.active[kGroupRotation] != gcode::kRotationOff &&
                       plan.by_group[kGroupRotation] == nullptr;
  const AxisModal &was = c.state.axes, &is = plan.next.axes;
  const bool changes = was.plane_u != is.plane_u || was.plane_v != is.plane_v;
  if (!changes) return true;
  if (rotates)
    return c.fail(SharedAlarm::kPlaneInRotation,
                  "illegal plane selected: the plane cannot change while a rotation (G68) is on");
  const bool scales = t.scales && plan.next.active[kGroupScaling] != gcode::kScalingOff;
  if (scales) return c.fail("049", "the plane cannot change while scaling (G51) is on: program G50 first");
  return true;
}

/// Under G16 the words of the plane are radius and angle: arcs have R.
bool polarArcByRadius(IsoContext& c, const BlockPlan& plan) {
  const int motion = plan.next.active[kGroupMotion];
  if (plan.next.inCycle() || plan.governor != nullptr || plan.by_group[kOneShot] != nullptr) return true;
  if (motion != gcode::kArcClockwise && motion != gcode::kArcCounterClockwise) return true;
  for (const Word& w : c.block.words) {
    if (w.address >= 'I' && w.address <= 'K')
      return c.failWord("polar-arc", "arcs under G16 (polar data) are given by R, not by I, J, K", w);
  }
  return true;
}

/// G41.1, G42.1: C along the path is the machine's business.
void tellNormalDirection(IsoContext& c, const BlockPlan& plan) {
  const GCode* code = plan.by_group[kOneShot];
  if (code == nullptr || (code->code10 != 411 && code->code10 != 421)) return;
  c.warnOnce("normal direction", "normal-direction",
             fmt::format("{} (normal direction control) is noted: C is not turned along the path here",
                         gName(code->code10)),
             {}, Severity::kNote);
}

void tellMachineMoves(IsoContext& c, const BlockPlan& plan) {
  const GCode* code = plan.by_group[kOneShot];
  if (code == nullptr) return;
  const int code10 = code->code10;
  const bool moves = code10 == gcode::kMachineMove || code10 == gcode::kReference ||
                     code10 == gcode::kNumberedReference || code10 == 270 || code10 == 290;
  if (moves && plan.next.transforms.rotates) {
    c.warnOnce("reference in rotation", "frame-in-rotation",
               fmt::format("{} while the rotation (G68) is on: some controls refuse it (049)", gName(code10)),
               {}, Severity::kNote);
  }
}

}  // namespace

bool fanucTransformsOff(IsoContext& c, BlockPlan& plan) {
  const bool polar = plan.next.active[kGroupPolarData] == gcode::kPolarData;
  if (!plan.any_group && !polar && !plan.next.transforms.any()) return true;
  tellNormalDirection(c, plan);
  if (!fanucTiltOff(c, plan)) return false;
  if (polar && !polarArcByRadius(c, plan)) return false;
  if (plan.by_group[kGroupPlane] && c.state.transforms.any() && !planePlan(c, plan)) return false;
  Transforms& t = plan.next.transforms;
  if (!t.any()) return true;
  tellMachineMoves(c, plan);
  const bool rotation = t.rotates && plan.next.active[kGroupRotation] == gcode::kRotationOff;
  const bool scaling = t.scales && plan.next.active[kGroupScaling] == gcode::kScalingOff;
  const GCode* mirror = plan.by_group[kGroupMirror];
  const bool mirrors = mirror && mirror->code10 == gcode::kMirrorOff && !c.anyAxisWord() && t.mirrored.any();
  if (!rotation && !scaling && !mirrors) return true;
  const AxisPoint counted = countedAt(c);
  if (rotation) ends(c, t, Kind::kRotation);
  if (scaling) ends(c, t, Kind::kScaling);
  if (mirrors) ends(c, t, Kind::kMirror);
  t.rotates = t.rotates && !rotation;
  t.scales = t.scales && !scaling;
  if (mirrors) t.mirrored.reset();
  plan.transforms_changed = true;
  if (rotation) {
    takeNewChain(c, plan);
    holdPlane(plan, counted, true);
  }
  return true;
}

bool planFanucRotation(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  if (!lengthsTurn(c, plan)) return false;
  const bool again = t.rotates;
  const double old_angle = again ? t.angle_deg : 0.0;
  t.rotates = false;
  AxisPoint centre = standsIn(c, plan.next, t);
  const AxisPoint counted = again ? countedAt(c) : centre;
  AxisSet named;
  if (!fanucCentre(c, plan, centre, named)) return false;
  const int u = plan.next.axes.plane_u, v = plan.next.axes.plane_v;
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word) && word.axis != u && word.axis != v)
      tellUnused(c, w, "G68", "it stands across the plane");
  }
  const Word* r = c.word('R');
  if (r == nullptr) {
    c.warnOnce("G68 without R", "rotation-angle", "G68 without R: the angle is 0 (parameter 5410)", {},
               Severity::kNote);
  }
  const bool in_steps = plan.next.incremental() && r != nullptr;
  const bool adds = in_steps && c.parameters[FanucParam::kRotationAdds] != 0.0;
  if (in_steps && again) {
    c.warnOnce("g68_r_incremental", "setting",
               fmt::format("the angle of G68 under G91 {}, by g68_r_incremental (5400#0)",
                           adds ? "adds to the one before" : "is absolute"),
               r->columns, Severity::kNote);
  }
  t.rotates = true;
  t.rotation_inside = false;
  t.pivot_is_scaled = true;
  t.rotation_u = static_cast<std::int8_t>(u);
  t.rotation_v = static_cast<std::int8_t>(v);
  t.pivot = {centre[u], centre[v]};
  t.angle_deg = (adds ? old_angle : 0.0) + (r == nullptr ? 0.0 : r->value);
  begins(t, Kind::kRotation);
  renewChain(c, plan);
  holdPlane(plan, counted, false);
  return true;
}

bool planFanucScaling(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  if (!refuseInComp(c, plan)) return false;
  const Word* p = c.word('P');
  const bool single = !(c.block.present & AddressSet("IJK")).empty();
  if (p && single) return c.alarm(SharedAlarm::kIllegalAddress, *p, "G51 takes P or I, J, K");
  if (single && plan.next.axes.mode != VirtualMode::kOff)
    return c.fail("virtual-forbidden", "G51 takes P during G12.1 and G07.1: I, J, K are factors of X, Y, Z");
  if (!p && !single) {
    c.warnOnce("G51 without P", "scale-factor", "G51 without P, I, J, K: the factor is 1 (parameter 5411)",
               {}, Severity::kNote);
  }
  t.scales = false;
  AxisPoint centre = standsIn(c, plan.next, t);
  AxisSet named;
  if (!fanucCentre(c, plan, centre, named)) return false;
  const double all = p ? factorOfWord(c, *p) : 1.0;
  if (p && !usable(c, *p, all, false)) return false;
  t.factors = Vec3::Constant(all);
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.word("IJK"[axis]);
    if (w == nullptr) continue;
    t.factors[axis] = factorOfWord(c, *w);
    if (!usable(c, *w, t.factors[axis], true)) return false;
  }
  if ((t.factors.array() < 0.0).any() && t.rotates) {
    c.warnOnce("negative factor in rotation", "negative-factor",
               "a negative factor of G51 beside G68: the rotation turns the other way, as it does by G51.1",
               {}, Severity::kNote);
  }
  t.scales = t.mirrors_last = true;
  t.scales_further = p != nullptr;
  t.virtual_axis = plan.next.axes.mode == VirtualMode::kOff ? std::int8_t{-1} : plan.next.axes.rotary;
  t.rotation_inside = false;
  t.scale_center = centre;
  begins(t, Kind::kScaling);
  renewChain(c, plan);
  return true;
}

bool planFanucMirror(IsoContext& c, BlockPlan& plan) {
  if (!c.anyAxisWord())
    return c.alarm(SharedAlarm::kMissingData, "", "G51.1 needs the axes to mirror, as in G51.1 X0");
  Transforms& t = plan.next.transforms;
  AxisSet named;
  if (!fanucCentre(c, plan, t.mirror, named)) return false;
  t.mirrored |= named;
  begins(t, Kind::kMirror);
  renewChain(c, plan);
  return true;
}

bool planFanucMirrorOff(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  AxisPoint values;
  AxisSet named;
  if (!fanucCentre(c, plan, values, named)) return false;
  t.mirrored &= ~named;
  if (t.mirrored.any()) plan.next.active[kGroupMirror] = gcode::kMirror;
  if (t.mirrored.none()) ends(c, t, Kind::kMirror);
  renewChain(c, plan);
  return true;
}

}  // namespace proveout::nc
