// G2 G3: centre and radius form, full turns, tolerances.
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"

namespace proveout::nc {
namespace {

constexpr double kLcnRadiusShare = 1e-3;  ///< of the larger radius that both may differ by
constexpr double kLcnTinyShare = 1e-7;    ///< nearer than this a chord is a diameter
constexpr double kLcnMostTurns = 10000.0, kLcnMostOfSpirals = 1000.0;

struct LcnArc {
  Vec2 start, end, center;
  bool ccw = false;
};

/// The centre by I, J, K. False: reported.
bool lcnCentre(IsoContext& c, BlockPlan& plan, LcnArc& arc) {
  const PlaneFrame frame(plan.next.plane());
  const char* const planes[] = {"xy", "xz", "yz"};
  const char* const name = planes[static_cast<int>(plan.next.plane())];
  const bool by_setting = linuxCncFlavour(c) == LinuxCncFlavour::kMach3 &&
                          !linuxCncChannel(c).arc_mode_said && plan.by_group[kGroupArcCentre] == nullptr;
  if (by_setting)
    c.warnOnce("arc mode", "setting",
               "whether I, J, K count from the start is a setting of Mach3 (arc_centre of the job): " +
                   std::string(c.parameters.flag(LinuxCncParam::kArcCentre) ? "absolute" : "incremental") +
                   " is taken");
  const bool absolute = by_setting ? c.parameters.flag(LinuxCncParam::kArcCentre)
                                   : plan.next.active[kGroupArcCentre] == lcn::kCentreAbsolute;
  arc.center = arc.start;
  int given = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.ownWord(plan, "IJK"[axis]);
    if (w == nullptr) continue;
    if (axis == frame.w() && isPlainGrbl(c)) {
      c.warnOnce("grbl arc word", "unused-word",
                 fmt::format("{} across the plane of an arc has no effect in GRBL", "IJK"[axis]), w->columns);
      continue;
    }
    if (axis == frame.w())
      return lcnFail(c, "arc-plane", fmt::format("{} word given for arc in {} plane", "IJK"[axis], name), w);
    double& at = axis == frame.u() ? arc.center.x() : arc.center.y();
    at = (absolute ? 0.0 : at) + lengthOf(plan, *w);
    ++given;
  }
  if (absolute && given < 2)
    return lcnFail(c, "arc-center",
                   "Both offsets must be specified in absolute ijk mode (G90.1): one of I, J, K is missing");
  const double r1 = (arc.start - arc.center).norm(), r2 = (arc.end - arc.center).norm();
  if (std::min(r1, r2) < (isGrbl(c) ? 1e-9 : kLcnReachMm))
    return lcnFail(c, "arc-zero",
                   fmt::format("Zero-radius arc: {:.6g} mm at its start, {:.6g} at its end", r1, r2));
  if (isGrbl(c)) return grblRadii(c, r1, r2);
  if (!lcnRadiiAgree(c, plan, r1, r2)) {
    const double difference = std::abs(r1 - r2), larger = std::max(r1, r2);
    return lcnFail(c, "arc-radius",
                   fmt::format("Radius to end of arc differs from radius to start: {:.6g} and {:.6g} mm, by "
                               "{:.4g} mm or {:.3g} %",
                               r1, r2, difference, 100.0 * difference / larger));
  }
  return true;
}

bool lcnRadius(IsoContext& c, const BlockPlan& plan, const Word& r, LcnArc& arc) {
  double radius = std::abs(lengthOf(plan, r));
  const Vec2 chord = arc.end - arc.start;
  const double half = 0.5 * chord.norm();
  if (!(half > 0.0)) return lcnFail(c, "arc-end", "Current point same as end point of arc", &r);
  if (half - radius > (isGrbl(c) ? 0.0 : kLcnReachMm))
    return lcnFail(
        c, "arc-reach",
        fmt::format("Arc radius too small to reach end point: R is {:.6g} mm, half of the chord {:.6g}",
                    radius, half),
        &r);
  const double height =
      half / radius > 1.0 - kLcnTinyShare ? 0.0 : std::sqrt(std::max(0.0, radius * radius - half * half));
  const double side = arc.ccw == (r.value > 0.0) ? 1.0 : -1.0;
  arc.center = 0.5 * (arc.start + arc.end) + Vec2(-chord.y(), chord.x()) * (side * height / (2.0 * half));
  return true;
}

/// Angle of the motion, signed, with the turns of P.
double lcnSweep(const LcnArc& arc, double turns) {
  const Vec2 a = arc.start - arc.center, b = arc.end - arc.center;
  double part = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (!arc.ccw) part = -part;
  constexpr double kSameRad = 1e-12;
  if (part <= kSameRad) part += 2.0 * kPi;
  part += 2.0 * kPi * (turns - 1.0);
  return arc.ccw ? part : -part;
}

}  // namespace

bool lcnRadiiAgree(const IsoContext& c, const BlockPlan& plan, double r1, double r2) {
  const bool inch = plan.next.active[kGroupUnits] == gcode::kInch;
  const double given_mm = inch ? 25.4 * c.parameters[LinuxCncParam::kArcToleranceInch]
                               : c.parameters[LinuxCncParam::kArcTolerance];
  const double tolerance = given_mm * std::sqrt(2.0);
  const double difference = std::abs(r1 - r2), larger = std::max(r1, r2);
  return difference <= 100.0 * tolerance &&
         (difference <= tolerance || difference <= kLcnRadiusShare * larger);
}

bool planLcnArc(IsoContext& c, BlockPlan& plan) {
  plan.perform = performLinuxCncSteps;
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot != nullptr && one_shot->code10 == gcode::kMachineMove)
    return lcnFail(c, "machine-move", "Must use g0 or g1 with g53");
  const bool ijk = !(c.block.present & AddressSet("IJK")).empty();
  const Word* r = c.ownWord(plan, 'R');
  LinuxCncChannel& own = linuxCncChannel(c);
  if (!lcnTarget(c, plan, plan.motion.target)) return false;
  if (r != nullptr && ijk && !isPlainGrbl(c))
    return lcnFail(c, "arc-form", "Mixed radius ijk format for arc", r);
  if (r == nullptr && !ijk) return lcnFail(c, "arc-form", "R i j k words all missing for arc");
  if (!plan.next.compOn() && !own.next.arc_after_comp)
    return lcnFail(c, "comp",
                   "The move just after exiting cutter compensation mode must be straight, not an arc");
  const WorkPlane plane = plan.next.workPlane();
  LcnArc arc;
  arc.start = plane.of(plan.start).head<2>();
  arc.end = plane.of(plan.motion.target).head<2>();
  arc.ccw = plan.next.active[kGroupMotion] == gcode::kArcCounterClockwise;
  if (r != nullptr ? !lcnRadius(c, plan, *r, arc) : !lcnCentre(c, plan, arc)) return false;
  std::int64_t turns = 1;
  if (const Word* p = isPlainGrbl(c) ? nullptr : c.ownWord(plan, 'P')) {
    if (!lcnInteger(c, *p, turns)) return false;
    if (turns < 1) return lcnFail(c, "arc-turns", "P value not an integer above 0 with an arc", p);
  }
  const double r1 = (arc.start - arc.center).norm(), r2 = (arc.end - arc.center).norm();
  const double most = std::abs(r1 - r2) > 1e-6 ? kLcnMostOfSpirals : kLcnMostTurns;
  if (static_cast<double>(turns) > most)
    return c.alarm(SharedAlarm::kOutOfRange, "P",
                   fmt::format("more than {:g} turns in one line are not simulated", most));
  const double sweep = lcnSweep(arc, static_cast<double>(turns));
  const double along = std::abs(sweep) * 0.5 * (r1 + r2);
  const double height = plan.motion.target[plane.w] - plan.start[plane.w];
  if (!lcnFeed(c, plan, std::hypot(along, height), lcnTurnOf(c, plan.start, plan.motion.target),
               arc.ccw ? "g3" : "g2", plan.motion.feed))
    return false;
  own.steps.push_back(
      {.kind = LinuxCncStep::Kind::kArc, .to = plan.motion.target, .center = arc.center, .sweep = sweep});
  return true;
}

}  // namespace proveout::nc
