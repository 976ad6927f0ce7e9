#include "core/nc/iso/frames/transforms.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

/// Rotation and scaling go off in the reverse order: the outer one stays while the inner one is on.
bool overlaps(IsoContext& c, const char* what) {
  return c.fail("transform-order",
                fmt::format("{}: of G68 and G51 the one that came last has to be ended first", what));
}

/// G68 and G51 may be given anew while they are on, unless the other one lies inside.
bool outer(const Transforms& t, bool rotation) {
  return t.rotates && t.scales && (rotation ? !t.rotation_inside : t.rotation_inside);
}

/// Where the machine is, in the coordinates in which the centre of a transform is given: those outside it.
AxisPoint outside(const IsoContext& c, const IsoState& state, const Transforms& without) {
  IsoState copy = state;
  copy.transforms = without;
  return c.chainOf(copy).programOf(c.machine);
}

/// The axis words of a centre; axes without a word keep what `center` holds.
bool centerWords(IsoContext& c, const BlockPlan& plan, AxisPoint& center, AxisSet& named) {
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (!axisWord(plan, w, word)) continue;
    const auto axis = static_cast<std::size_t>(word.axis);
    if (named[axis]) return c.alarm(SharedAlarm::kIllegalAddress, w, "the axis is given twice in this block");
    named.set(axis);
    const double value = axisValue(c, plan, word, w);
    center[word.axis] = word.step ? plan.start[word.axis] + value : value;
  }
  return true;
}

/// Factors that keep positions finite and the transform invertible.
bool usableFactor(double value) { return value >= 1e-6 && value <= 1e6; }

/// A plane that can be rotated: lengths on both axes.
bool lengthsInPlane(IsoContext& c, const BlockPlan& plan) {
  const AxisModal& modal = plan.next.axes;
  const bool rotary = c.axes.at(modal.plane_u).rotary() || c.axes.at(modal.plane_v).rotary();
  return !rotary || modal.mode != VirtualMode::kOff ||
         c.alarm(SharedAlarm::kPlane, "", "G68 rotates planes of linear axes");
}

bool noMirrorHere(IsoContext& c, const BlockPlan& plan) {
  const Transforms& t = plan.next.transforms;
  return (!t.rotates && !t.scales) || c.alarm(SharedAlarm::kMirrorInTransform, "");
}

/// G50.1 without axis words: no axis is mirrored any more.
bool endMirrors(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupMirror];
  Transforms& t = plan.next.transforms;
  if (code == nullptr || code->code10 != gcode::kMirrorOff || c.anyAxisWord() || t.mirrored.none())
    return true;
  if (!noMirrorHere(c, plan)) return false;
  t.mirrored.reset();
  plan.transforms_changed = true;
  return true;
}

}  // namespace

void takeNewChain(const IsoContext& c, BlockPlan& plan) {
  plan.new_chain = c.chainOf(plan.next);
  plan.chain = &*plan.new_chain;
  plan.start = plan.chain->programOf(c.machine);
}

void renewChain(const IsoContext& c, BlockPlan& plan) {
  plan.transforms_changed = true;
  takeNewChain(c, plan);
}

bool planTransformsOff(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  const AxisModal& modal = plan.next.axes;
  const bool same_plane = modal.plane_u == t.rotation_u && modal.plane_v == t.rotation_v;
  if (t.rotates && plan.next.active[kGroupRotation] != gcode::kRotationOff && !same_plane) {
    return c.fail(SharedAlarm::kPlaneInRotation, "the plane cannot change while a rotation (G68) is on");
  }
  const bool rotation = t.rotates && plan.next.active[kGroupRotation] == gcode::kRotationOff;
  const bool scaling = t.scales && plan.next.active[kGroupScaling] == gcode::kScalingOff;
  if (rotation != scaling && outer(t, rotation)) return overlaps(c, rotation ? "G69" : "G50");
  if (rotation) t.rotates = false;
  if (scaling) t.scales = false;
  plan.transforms_changed = rotation || scaling;
  return endMirrors(c, plan);
}

bool planRotation(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  if (!lengthsInPlane(c, plan)) return false;
  if (outer(t, true)) return overlaps(c, "G68");
  const Word* r = c.word('R');
  if (r == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "G68 needs an angle");
  const double old_angle = t.rotates ? t.angle_deg : 0.0;
  t.rotates = false;
  AxisPoint center = outside(c, plan.next, t);
  AxisSet named;
  if (!centerWords(c, plan, center, named)) return false;
  t.rotates = true;
  t.rotation_inside = t.scales;
  t.rotation_u = plan.next.axes.plane_u;
  t.rotation_v = plan.next.axes.plane_v;
  t.pivot = {center[t.rotation_u], center[t.rotation_v]};
  const bool add = r->incremental || plan.next.incremental();
  t.angle_deg = add ? old_angle + r->value : r->value;
  renewChain(c, plan);
  return true;
}

bool planScaling(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  if (outer(t, false)) return overlaps(c, "G51");
  const Word* p = c.word('P');
  const bool single = !(c.block.present & AddressSet("IJK")).empty();
  const bool real = plan.next.axes.mode == VirtualMode::kOff;
  if (single && !real) {
    return c.fail("virtual-forbidden", "G51 takes P during G12.1 and G7.1: I, J, K are factors of X, Y, Z");
  }
  if (p && single) return c.alarm(SharedAlarm::kIllegalAddress, *p, "G51 takes P or I, J, K");
  if (!p && !single) return c.alarm(SharedAlarm::kMissingData, "P", "G51 needs a factor: P, or I, J, K");
  t.scales = false;
  AxisPoint center = outside(c, plan.next, t);
  AxisSet named;
  if (!centerWords(c, plan, center, named)) return false;
  t.factors = Vec3::Constant(p ? p->value : 1.0);
  if (p && !usableFactor(p->value)) {
    return c.alarm(SharedAlarm::kOutOfRange, *p, "a factor from 0.000001 to 1000000");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.word("IJK"[axis]);
    if (w == nullptr) continue;
    if (!usableFactor(std::abs(w->value))) {
      return c.alarm(SharedAlarm::kOutOfRange, *w, "a factor from 0.000001 to 1000000, or its opposite");
    }
    t.factors[axis] = w->value;
  }
  t.scales = true;
  t.scales_further = p != nullptr;
  t.virtual_axis = real ? std::int8_t{-1} : plan.next.axes.rotary;
  t.rotation_inside = false;
  t.scale_center = center;
  renewChain(c, plan);
  return true;
}

bool planMirror(IsoContext& c, BlockPlan& plan) {
  if (!noMirrorHere(c, plan)) return false;
  if (!c.anyAxisWord()) return c.alarm(SharedAlarm::kMissingData, "", "G51.1 needs axis words");
  Transforms& t = plan.next.transforms;
  AxisSet named;
  if (!centerWords(c, plan, t.mirror, named)) return false;
  t.mirrored |= named;
  renewChain(c, plan);
  return true;
}

bool planMirrorOff(IsoContext& c, BlockPlan& plan) {
  if (!noMirrorHere(c, plan)) return false;
  Transforms& t = plan.next.transforms;
  AxisPoint values;
  AxisSet named;
  if (!centerWords(c, plan, values, named)) return false;
  t.mirrored &= ~named;
  if (t.mirrored.any()) plan.next.active[kGroupMirror] = gcode::kMirror;
  renewChain(c, plan);
  return true;
}

}  // namespace proveout::nc
