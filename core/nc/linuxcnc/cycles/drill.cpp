// G73 G74 G81 to G89.
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/origins.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"

namespace proveout::nc {
namespace {

constexpr double kLcnPeckRise = 0.254;  ///< mm, 0.010 inch: back above the last depth
constexpr double kLcnMostSteps = 200000.0;

/// Levels of a hole, on the drill axis in program coordinates.
struct LcnHole {
  int code = 0;
  double r = 0.0, z = 0.0, clear = 0.0;
  double q = 0.0, p = 0.0, k = 0.0;
  Vec2 shift = Vec2::Zero();
};

/// Makes the steps of one hole; `at` is where the tool stands.
class LcnDriller {
 public:
  LcnDriller(LinuxCncChannel& own, const WorkPlane& plane, int direction, AxisPoint at)
      : own_(own), plane_(plane), direction_(direction), at_(at) {}

  void rapid(double level) { move(LinuxCncStep::Kind::kRapid, level); }
  void feed(double level) { move(LinuxCncStep::Kind::kFeed, level); }
  void thread(double level) { move(LinuxCncStep::Kind::kThread, level); }
  void dwell(double seconds) {
    if (seconds > 0.0) own_.steps.push_back({.kind = LinuxCncStep::Kind::kDwell, .to = {}, .value = seconds});
  }
  void spindle(int direction) {
    own_.steps.push_back(
        {.kind = LinuxCncStep::Kind::kSpindle, .to = {}, .value = static_cast<double>(direction)});
  }
  void other(LinuxCncStep::Kind kind) { own_.steps.push_back({.kind = kind, .to = {}}); }
  void shift(const Vec2& by) {
    at_[plane_.u] += by.x();
    at_[plane_.v] += by.y();
    lcnRapid(own_, at_);
  }
  void over(const AxisPoint& to) {
    at_ = to;
    lcnRapid(own_, at_);
  }
  double level() const { return at_[plane_.w]; }
  const AxisPoint& at() const { return at_; }
  int direction() const { return direction_; }

 private:
  void move(LinuxCncStep::Kind kind, double level) {
    if (at_[plane_.w] == level) return;
    at_[plane_.w] = level;
    own_.steps.push_back({.kind = kind, .to = at_});
  }
  LinuxCncChannel& own_;
  WorkPlane plane_;
  int direction_;
  AxisPoint at_;
};

void lcnPecks(LcnDriller& d, const LcnHole& hole, bool to_r) {
  double depth = hole.r;
  for (depth -= hole.q; depth > hole.z; depth -= hole.q) {
    d.feed(depth);
    if (to_r) {
      d.rapid(hole.r);
      d.rapid(depth + kLcnPeckRise);
    } else {
      d.rapid(depth + kLcnPeckRise);
    }
  }
  d.feed(hole.z);
  d.rapid(hole.clear);
}

void lcnBackBore(LcnDriller& d, const LcnHole& hole) {
  using Kind = LinuxCncStep::Kind;
  d.shift(hole.shift);
  d.spindle(0);
  d.other(Kind::kOrient);
  d.rapid(hole.z);
  d.shift(-hole.shift);
  d.spindle(d.direction());
  d.feed(hole.k);
  d.feed(hole.z);
  d.spindle(0);
  d.other(Kind::kOrient);
  d.shift(hole.shift);
  d.rapid(hole.clear);
  d.shift(-hole.shift);
  d.spindle(d.direction());
}

void lcnBore(LcnDriller& d, const LcnHole& hole) {
  using Kind = LinuxCncStep::Kind;
  switch (hole.code) {
    case 730:
    case 830:
      return lcnPecks(d, hole, hole.code == 830);
    case 740:
    case 840:
      d.thread(hole.z);
      d.spindle(0);
      d.spindle(-d.direction());
      d.dwell(hole.p);
      d.thread(hole.clear);
      d.spindle(0);
      return d.spindle(d.direction());
    case 850:
    case 890:
      d.feed(hole.z);
      if (hole.code == 890) {
        d.dwell(hole.p);
        return d.feed(hole.clear);
      }
      d.feed(hole.r);
      return d.rapid(hole.clear);
    case 860:
    case 880:
      d.feed(hole.z);
      d.dwell(hole.p);
      d.spindle(0);
      if (hole.code == 880) d.other(Kind::kStop);
      d.rapid(hole.clear);
      return d.spindle(d.direction());
    case 870:
      return lcnBackBore(d, hole);
    default:
      d.feed(hole.z);
      d.dwell(hole.code == 820 ? hole.p : 0.0);
      d.rapid(hole.clear);
  }
}

std::string lcnName(int code10) {
  std::string name = gName(code10);
  name[0] = 'g';
  return name;
}

bool lcnCycleState(IsoContext& c, BlockPlan& plan) {
  const GCode* one_shot = plan.by_group[kOneShot];
  if (one_shot != nullptr && one_shot->code10 == gcode::kMachineMove)
    return lcnFail(c, "machine-move", "Must use g0 or g1 with g53");
  if (lcnCompOn(c, plan)) return lcnFail(c, "comp", "Cannot use canned cycles with cutter compensation on");
  if (plan.next.active[kGroupFeedMode] == lcn::kInverseTime)
    return lcnFail(c, "feed", "Cannot use inverse time feed with canned cycles");
  for (const Word& w : c.block.words) {
    if (w.axis >= kMainAxes)
      return lcnFail(c, "cycle", fmt::format("Cannot put an {} in canned cycle", addressText(w.address)), &w);
  }
  return true;
}

/// Z, R, Q, P: of the block, or where the same code repeats those in force. False: reported.
bool lcnCycleWords(IsoContext& c, BlockPlan& plan, int code, bool again, const WorkPlane& plane) {
  LinuxCncCycle& cycle = linuxCncChannel(c).next.cycle;
  const std::string name = lcnName(code);
  const char* const planes[] = {"xy", "xz", "yz"};
  const char* const in_plane = planes[static_cast<int>(plan.next.plane())];
  const Word* z = c.block.findAxis(plane.w);
  if (z != nullptr) cycle.z = axisValue(c, plan, AxisWord{.axis = plane.w}, *z);
  if (z == nullptr && !again)
    return lcnFail(c, "cycle",
                   fmt::format("{} value unspecified in {} plane canned cycle", "XYZ"[plane.w], in_plane));
  const Word* r = c.ownWord(plan, 'R');
  if (r != nullptr) cycle.r = lengthOf(plan, *r);
  if (r == nullptr && !again) return lcnFail(c, "cycle", "R clearance plane unspecified in cycle");
  if (!again) cycle.q = cycle.p = -1.0;
  if (code == 730 || code == 830) {
    const Word* q = c.ownWord(plan, 'Q');
    if (q != nullptr && q->value > 0.0) cycle.q = lengthOf(plan, *q);
    if (q != nullptr && q->value <= 0.0 && cycle.q <= 0.0)
      return lcnFail(c, "cycle", "Negative or zero q value used", q);
    if (cycle.q <= 0.0) return lcnFail(c, "cycle", fmt::format("Q word missing with {}", name));
  }
  const bool dwells = code == 820 || code == 860 || code == 880 || code == 890;
  const Word* p = dwells || code == 840 || code == 740 ? c.ownWord(plan, 'P') : nullptr;
  if (p != nullptr && p->value >= 0.0) cycle.p = p->value;
  if (dwells && cycle.p < 0.0)
    return lcnFail(c, "cycle", fmt::format("Dwell time p word missing with {}", name), p);
  return true;
}

bool lcnCycleSpindle(IsoContext& c, const BlockPlan& plan, int code, int& direction) {
  direction = c.state.spindle_direction;
  for (int i = 0; i < plan.m_count; ++i) {
    const int m = plan.m_value[static_cast<std::size_t>(i)];
    if (mcode::turns(m)) direction = m == mcode::kClockwise ? 1 : -1;
    if (m == mcode::kSpindleStop) direction = 0;
  }
  const bool needs = code == 740 || code == 840 || (code >= 860 && code <= 880);
  std::string name = gName(code);
  if (code == 860 || code == 880) name[0] = 'g';
  if (needs && direction == 0) return lcnFail(c, "spindle-stopped", "Spindle not turning in " + name);
  if (code == 840 && direction < 0)
    return lcnFail(c, "spindle-stopped", "Spindle turning counterclockwise in G84");
  if (code == 740 && direction > 0) return lcnFail(c, "spindle-stopped", "Spindle turning clockwise in G74");
  return true;
}

/// I, J, K of G87. False: reported.
bool lcnBackBoreWords(IsoContext& c, BlockPlan& plan, bool again, LcnHole& hole) {
  if (hole.code != 870) return true;
  const PlaneFrame frame(plan.next.plane());
  LinuxCncCycle& cycle = linuxCncChannel(c).next.cycle;
  c.warnOnce("g87", "version",
             "G87: the documentation calls it not implemented, the interpreter runs it, as here");
  if (!again) cycle.back_bore.reset();
  Vec3 ijk = cycle.back_bore.value_or(Vec3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    const Word* w = c.ownWord(plan, "IJK"[axis]);
    if (w != nullptr) ijk[axis] = lengthOf(plan, *w);
    if (w == nullptr && !cycle.back_bore)
      return lcnFail(c, "cycle", fmt::format("{} word missing with g87", "IJK"[axis]));
  }
  cycle.back_bore = ijk;
  hole.shift = {ijk[frame.u()], ijk[frame.v()]};
  hole.k = ijk[frame.w()];
  return true;
}

/// Words that hold keep their numbers where the units change, as the interpreter has it.
void lcnCycleUnits(IsoContext& c, const BlockPlan& plan, LinuxCncCycle& cycle) {
  if (plan.next.unitScale() == cycle.unit) return;
  const double factor = plan.next.unitScale() / cycle.unit;
  c.warnOnce(
      "cycle units", "cycle-units",
      "the units change inside a series of cycles: Z, R, Q and the old level keep their numbers and take "
      "the new unit");
  for (double* value : {&cycle.z, &cycle.r, &cycle.q, &cycle.old_level}) *value *= factor;
  if (cycle.back_bore) *cycle.back_bore *= factor;
  cycle.unit = plan.next.unitScale();
}

}  // namespace

bool planLcnCycle(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const int code = plan.governor->code10;
  const bool again = c.state.active[kGroupMotion] == code;
  const int was = c.state.active[kGroupMotion];
  const bool series = was == 730 || was == 740 || (was >= 810 && was <= 890);
  const WorkPlane plane = plan.next.workPlane();
  LinuxCncCycle& cycle = own.next.cycle;
  if (!lcnAnyAxis(c)) {
    if (plan.by_group[kGroupMotion] != nullptr)
      return lcnFail(c, "axis-words", "All axes missing with motion code");
    return planLcnNothing(c, plan);
  }
  if (!lcnCycleState(c, plan)) return false;
  if (series) {
    lcnCycleUnits(c, plan, cycle);
  } else {
    cycle.old_level = plan.start[plane.w];
    cycle.unit = plan.next.unitScale();
  }
  if ((code == 740 || code == 840) && plan.next.active[kGroupPlane] != gcode::kPlaneXY)
    return lcnFail(
        c, "cycle-plane",
        fmt::format("{} outside of G17: LinuxCNC 2.9 taps along swapped axes there and leads the tool "
                    "astray; tap in G17",
                    gName(code)));
  std::int64_t repeats = 1;
  const Word* l = c.ownWord(plan, 'L');
  if (l != nullptr && !lcnInteger(c, *l, repeats)) return false;
  if (repeats < 1)
    return lcnFail(c, "cycle", repeats == 0 ? "Cannot do zero repeats of cycle" : "Negative l word used", l);
  LcnHole hole;
  hole.code = code;
  int direction = 0;
  if (!lcnTarget(c, plan, plan.motion.target) || !lcnCycleWords(c, plan, code, again, plane) ||
      !lcnBackBoreWords(c, plan, again, hole) || !lcnCycleSpindle(c, plan, code, direction))
    return false;
  const bool step = plan.next.incremental();
  hole.r = step ? cycle.old_level + cycle.r : cycle.r;
  hole.z = step ? hole.r + cycle.z : cycle.z;
  if (code == 870 && step) hole.k += hole.z;
  hole.q = cycle.q;
  hole.p = cycle.p;
  const double old_level = std::max(cycle.old_level, hole.r);
  hole.clear = plan.next.active[kGroupReturn] == gcode::kReturnToR ? hole.r : old_level;
  if (hole.r < hole.z) return lcnFail(c, "cycle", fmt::format("R less than {} in cycle", "xyz"[plane.w]));
  const double pecks = hole.q > 0.0 ? (hole.r - hole.z) / hole.q : 1.0;
  if (!(pecks * static_cast<double>(repeats) <= kLcnMostSteps))
    return c.alarm(SharedAlarm::kOutOfRange, l != nullptr ? "L" : "Q",
                   "more than 200000 strokes in one line are not simulated");
  if (!lcnFeed(c, plan, hole.r - hole.z, 0.0, lcnName(code).c_str(), plan.motion.feed)) return false;
  LcnDriller driller(own, plane, direction, plan.start);
  if (cycle.old_level < hole.r) driller.rapid(hole.r);
  AxisPoint at = plan.start;
  const bool polar = c.block.present.has(kNamedWord) || c.block.present.has('^');
  for (std::int64_t k = 0; k < repeats; ++k) {
    if (polar && step) lcnPolarFrom(c, plan, at, at);
    for (const int axis : {plane.u, plane.v}) {
      if (!plan.motion.named[static_cast<std::size_t>(axis)] || (polar && step)) continue;
      at[axis] = step ? at[axis] + plan.motion.target[axis] - plan.start[axis] : plan.motion.target[axis];
    }
    // From R or below it the way to the hole leads to the level of return, from above it stays.
    at[plane.w] = driller.level() <= hole.r ? hole.clear : driller.level();
    driller.over(at);
    driller.rapid(hole.r);
    lcnBore(driller, hole);
  }
  plan.motion.target = driller.at();
  plan.perform = performLinuxCncSteps;
  return true;
}

}  // namespace proveout::nc
