// Codes of Mach3.
#include <fmt/core.h>

#include "core/geometry/degrees.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/frames/frames.h"

namespace proveout::nc {
namespace {

constexpr int kMach3Systems = 254;

bool mach3Rotation(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  const Word* a = c.block.find('A');
  const Word* b = c.block.find('B');
  const Word* r = c.block.find('R');
  if (r == nullptr) r = c.block.find('I');
  if (r == nullptr) return lcnFail(c, "rotation", "G68 needs the angle R");
  const WorkPlane plane = plan.next.workPlane();
  t.rotates = true;
  t.rotation_u = static_cast<std::int8_t>(plane.u);
  t.rotation_v = static_cast<std::int8_t>(plane.v);
  t.pivot = {a == nullptr ? 0.0 : lengthOf(plan, *a), b == nullptr ? 0.0 : lengthOf(plan, *b)};
  t.angle_deg = r->value;
  return true;
}

bool mach3Scaling(IsoContext& c, BlockPlan& plan) {
  Transforms& t = plan.next.transforms;
  if (!c.anyAxisWord()) return lcnFail(c, "scaling", "G51 needs factors: X, Y, Z");
  if (!t.scales) t.factors = Vec3::Ones();
  t.scales = true;
  t.scale_center = AxisPoint();
  for (const Word& w : c.block.words) {
    if (w.axis < 0 || w.axis >= kMainAxes) continue;
    if (!(std::abs(w.value) > 1e-6 && std::abs(w.value) < 1e6))
      return lcnFail(c, "scaling", "a factor of G51 must not be 0", &w);
    t.factors[w.axis] = w.value;
  }
  return true;
}

}  // namespace

bool planMach3Transforms(IsoContext& c, BlockPlan& plan) {
  const GCode* rotation = plan.by_group[kGroupRotation];
  const GCode* scaling = plan.by_group[kGroupScaling];
  if (rotation == nullptr && scaling == nullptr) return true;
  if (lcnCompOn(c, plan))
    return lcnFail(c, "comp", "Cannot change rotation or scaling with cutter radius compensation on");
  if (rotation != nullptr) {
    plan.next.active[kGroupRotation] = rotation->code10;
    plan.claimed = plan.claimed | rotation->words;
    if (rotation->code10 == gcode::kRotationOff) {
      plan.next.transforms.rotates = false;
    } else if (!mach3Rotation(c, plan)) {
      return false;
    }
  }
  if (scaling != nullptr) {
    plan.next.active[kGroupScaling] = scaling->code10;
    plan.claimed = plan.claimed | scaling->words;
    if (scaling->code10 == gcode::kScalingOff) {
      plan.next.transforms.scales = false;
    } else if (!mach3Scaling(c, plan)) {
      return false;
    }
  }
  plan.next.transforms.rotation_inside = false;
  plan.transforms_changed = plan.frames_changed = plan.flush = true;
  return true;
}

void takeMach3Codes(Block& block) {
  bool motion = false;
  for (Word& w : block.words) {
    if (w.address != 'G') continue;
    if (w.value == 70.0 || w.value == 71.0) w.value -= 50.0;
    motion = motion || w.value <= 3.0 || (w.value > 72.0 && w.value < 90.0 && w.value != 80.0);
  }
  std::erase_if(block.words, [&](const Word& w) { return w.address == 'G' && w.value == 80.0 && motion; });
}

bool planMach3Radius(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupRadiusComp];
  const bool on = code != nullptr && (code->code10 == gcode::kCompLeft || code->code10 == gcode::kCompRight);
  const Word* p = on ? c.block.find('P') : nullptr;
  if (p == nullptr) return true;
  if (c.block.present.has('D'))
    return lcnFail(c, "comp", "G41, G42: D is a tool and P a radius, not both", p);
  if (!(p->value >= 0.0)) return lcnFail(c, "comp", "P of G41 and G42, a radius, must not be negative", p);
  plan.claimed.add('P');
  plan.next.d_radius = lengthOf(plan, *p);
  plan.next.d_tip = 0;
  return true;
}

bool planMach3Frame(IsoContext& c, BlockPlan& plan) {
  const Word* p = c.ownWord(plan, 'P');
  if (p == nullptr) return true;
  std::int64_t number = 0;
  if (!lcnInteger(c, *p, number)) return false;
  if (number < 1 || number > kMach3Systems) return lcnFail(c, "data", "P of G54 and G59 is 1 to 254", p);
  plan.claimed.add('P');
  plan.next.work_system = linuxCncSystem(static_cast<int>(number));
  return true;
}

bool planMach3Circle(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const Word* i = c.ownWord(plan, 'I');
  if (i == nullptr || !(i->value > 0.0))
    return lcnFail(c, "circle", "G12 and G13 need the radius I, above 0", i);
  const double radius = lengthOf(plan, *i);
  const WorkPlane plane = plan.next.workPlane();
  if (!lcnFeed(c, plan, 2.0 * kPi * radius, 0.0, "g12", plan.motion.feed)) return false;
  AxisPoint out = plan.start;
  out[plane.u] += radius;
  lcnFeedTo(own, out);
  own.steps.push_back({.kind = LinuxCncStep::Kind::kArc,
                       .to = out,
                       .center = plane.of(plan.start).head<2>(),
                       .sweep = plan.by_group[kOneShot]->code10 == 120 ? -2.0 * kPi : 2.0 * kPi});
  lcnFeedTo(own, plan.start);
  plan.motion.target = plan.start;
  plan.perform = performLinuxCncSteps;
  return true;
}

bool mach3Polar(IsoContext& c, BlockPlan& plan, AxisPoint& target) {
  const WorkPlane plane = plan.next.workPlane();
  const Word* radius = c.block.findAxis(plane.u);
  const Word* angle = c.block.findAxis(plane.v);
  if (radius == nullptr && angle == nullptr) return true;
  lcnPolarPoint(plan, radius, angle, plan.start, target);
  return true;
}

}  // namespace proveout::nc
