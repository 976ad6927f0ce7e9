// G76: a thread in passes.
#include <fmt/core.h>

#include <algorithm>

#include "core/geometry/degrees.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/linuxcnc/model/block.h"

namespace proveout::nc {
namespace {

constexpr int kLcnMostPasses = 10000;

/// The words of G76, lengths in mm, X as radii.
struct LcnThreadWords {
  double lead = 0.0;                         ///< P
  double peak = 0.0;                         ///< I, signed: from the drive line
  double first = 0.0, full = 0.0;            ///< J, K: depths
  double degression = 1.0;                   ///< R
  double angle_deg = 0.0;                    ///< Q
  double taper = 0.0;                        ///< E
  bool taper_in = false, taper_out = false;  ///< L
  int springs = 0;                           ///< H
};

bool lcnThreadWords(IsoContext& c, BlockPlan& plan, LcnThreadWords& out) {
  const double half = plan.next.active[kGroupLathe] == lcn::kDiameterMode ? 0.5 : 1.0;
  const Word* p = c.ownWord(plan, 'P');
  const Word* i = c.ownWord(plan, 'I');
  const Word* j = c.ownWord(plan, 'J');
  const Word* k = c.ownWord(plan, 'K');
  if (p == nullptr || !(p->value > 0.0)) return lcnFail(c, "thread", "P word missing with G76", p);
  if (i == nullptr || j == nullptr || k == nullptr)
    return lcnFail(c, "thread", "I J or K words missing with G76");
  out.lead = lengthOf(plan, *p);
  out.peak = half * lengthOf(plan, *i);
  out.first = half * lengthOf(plan, *j);
  out.full = half * lengthOf(plan, *k);
  if (out.peak == 0.0) return lcnFail(c, "thread", "In G76, I must not be 0", i);
  if (!(out.first > 0.0)) return lcnFail(c, "thread", "In G76, J must be greater than 0", j);
  if (!(out.full > out.first)) return lcnFail(c, "thread", "In G76, K must be greater than J", k);
  if (const Word* r = c.ownWord(plan, 'R')) out.degression = std::max(1.0, r->value);
  if (const Word* q = c.ownWord(plan, 'Q')) out.angle_deg = q->value;
  if (!(std::abs(out.angle_deg) < 89.0)) return lcnFail(c, "thread", "In G76, Q must be below 90 degrees");
  if (const Word* h = c.ownWord(plan, 'H')) {
    std::int64_t springs = 0;
    if (!lcnInteger(c, *h, springs)) return false;
    if (springs > kLcnMostPasses) return c.alarm(SharedAlarm::kOutOfRange, *h, "at most 10000");
    out.springs = static_cast<int>(springs);
  }
  std::int64_t ends = 0;
  if (const Word* l = c.ownWord(plan, 'L'); l != nullptr && !lcnInteger(c, *l, ends)) return false;
  if (const Word* e = c.ownWord(plan, 'E')) out.taper = std::max(0.0, lengthOf(plan, *e));
  out.taper_in = out.taper > 0.0 && (ends == 1 || ends == 3);
  out.taper_out = out.taper > 0.0 && (ends == 2 || ends == 3);
  return true;
}

/// Makes the steps of the passes in (X, Z).
class LcnThreader {
 public:
  LcnThreader(LinuxCncChannel& own, const LcnThreadWords& words, const AxisPoint& start, double end_z,
              double rpm)
      : own_(own), words_(words), start_(start), at_(start), end_z_(end_z), rpm_(rpm) {
    out_ = words.peak < 0.0 ? 1.0 : -1.0;
    along_ = end_z > start.xyz.z() ? 1.0 : -1.0;
  }
  void pass(double depth) {
    const double share = along_ * std::tan(degToRad(words_.angle_deg));
    const double zero = out_ * (words_.full - depth);
    const double begin_z = start_.xyz.z() + depth * share;
    const double end_z = end_z_ + (depth - words_.full) * share;
    const double crest = start_.xyz.x() + words_.peak + zero - out_ * words_.full;
    const double clear = start_.xyz.x() + zero;
    const double e = along_ * words_.taper;
    const double slant = words_.lead * std::hypot(words_.taper, words_.full) / std::max(words_.taper, 1e-9);
    rapid(clear, begin_z);
    if (words_.taper_in) {
      thread(crest + out_ * words_.full, begin_z, slant);
      thread(crest, begin_z + e, slant);
    } else {
      rapid(crest, begin_z);
    }
    thread(crest, words_.taper_out ? end_z - e : end_z, words_.lead);
    if (words_.taper_out) thread(crest + out_ * words_.full, end_z, slant);
    rapid(clear, end_z);
  }
  const AxisPoint& at() const { return at_; }
  void rapid(double x, double z) {
    at_.xyz.x() = x;
    at_.xyz.z() = z;
    lcnRapid(own_, at_);
  }

 private:
  void thread(double x, double z, double lead) {
    at_.xyz.x() = x;
    at_.xyz.z() = z;
    own_.steps.push_back({.kind = LinuxCncStep::Kind::kThread, .to = at_, .value = lead * rpm_});
  }
  LinuxCncChannel& own_;
  const LcnThreadWords& words_;
  AxisPoint start_, at_;
  double end_z_, rpm_;
  double out_ = 1.0;     ///< direction of X away from the thread
  double along_ = -1.0;  ///< of Z along it
};

}  // namespace

bool planLcnThreadCycle(IsoContext& c, BlockPlan& plan) {
  if (lcnCompOn(c, plan))
    return lcnFail(c, "comp", "Cannot use G76 threading mode with cutter radius compensation on");
  if (plan.next.active[kGroupPlane] != gcode::kPlaneZX)
    return lcnFail(c, "thread", "G76 cuts in X and Z: program G18");
  if (!lcnAnyAxis(c)) return lcnFail(c, "axis-words", "All axes missing with motion code");
  LcnThreadWords words;
  if (!lcnThreadWords(c, plan, words) || !lcnTarget(c, plan, plan.motion.target)) return false;
  if (!lcnSpindleTurns(c, plan) || !(lcnRpm(c, plan) > 0.0))
    return lcnFail(c, "spindle-stopped", "Chosen spindle (0) not turning in G76");
  for (const Word& w : c.block.words) {
    if (w.axis >= 0 && w.axis != 0 && w.axis != 2) return lcnFail(c, "thread", "G76 moves X and Z alone", &w);
  }
  const AxisPoint end = plan.motion.target;
  const double length = std::abs(end.xyz.z() - plan.start.xyz.z());
  const double tapers = words.taper * ((words.taper_in ? 1.0 : 0.0) + (words.taper_out ? 1.0 : 0.0));
  if (tapers > length)
    c.warn("thread",
           "G76: the tapers of E are longer than the thread: the tool goes back and forth, as in LinuxCNC",
           c.word('E')->columns);
  plan.motion.feed.join = joinOf(plan);
  LinuxCncChannel& own = linuxCncChannel(c);
  LcnThreader threader(own, words, plan.start, end.xyz.z(), lcnRpm(c, plan));
  int passes = 1;
  constexpr double kSameDepth = 1e-9;  // mm
  for (double depth = words.first; depth < words.full - kSameDepth;
       depth = words.first * std::pow(++passes, 1.0 / words.degression)) {
    if (passes > kLcnMostPasses)
      return c.alarm(SharedAlarm::kOutOfRange, "J", "more than 10000 passes in one line are not simulated");
    threader.pass(depth);
  }
  for (int k = 0; k <= std::max(words.springs, 0); ++k) {
    if (words.springs < 0) break;
    threader.pass(words.full);
  }
  threader.rapid(end.xyz.x(), end.xyz.z());
  plan.motion.target = threader.at();
  plan.next.axes.thread_lead = words.lead;
  plan.perform = performLinuxCncSteps;
  return true;
}

}  // namespace proveout::nc
