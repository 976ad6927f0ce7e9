// G70 finish, G71 and G72 rough along a contour.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/nc/linuxcnc/cycles/level_cutter.h"
#include "core/nc/linuxcnc/cycles/rough_contour.h"

namespace proveout::nc {
namespace {

constexpr int kLcnMostLevels = 5000;
constexpr double kLcnLeastStep = 2e-6;  ///< of levels, units of the program

/// Makes steps of moves in (Z, X), u and v of G18.
class LcnRougher {
 public:
  LcnRougher(LinuxCncChannel& own, const AxisPoint& start) : own_(own), at_(start) {}
  void rapid(const Vec2& to, bool bare = false) {
    put(to);
    lcnRapid(own_, at_);
    own_.steps.back().bare = bare;
  }
  void feed(const ContourElement& e) {
    put(e.to);
    if (e.arc) {
      own_.steps.push_back(
          {.kind = LinuxCncStep::Kind::kArc, .to = at_, .center = e.center, .sweep = e.sweep});
    } else {
      lcnFeedTo(own_, at_);
    }
  }
  const AxisPoint& at() const { return at_; }

 private:
  void put(const Vec2& to) {
    at_.xyz.z() = to.x();
    at_.xyz.x() = to.y();
  }
  LinuxCncChannel& own_;
  AxisPoint at_;
};

struct LcnRoughWords {
  double distance = 0.0;    ///< D
  LevelRules levels;        ///< I, R
  double last = 0.0;        ///< E
  std::int64_t passes = 1;  ///< P
};

bool lcnRoughWords(IsoContext& c, BlockPlan& plan, LcnRoughWords& out) {
  const double unit = plan.next.unitScale();
  out.levels.step = unit;
  out.levels.retract = 0.5 * unit;
  if (const Word* d = c.ownWord(plan, 'D')) out.distance = lengthOf(plan, *d);
  if (const Word* i = c.ownWord(plan, 'I')) out.levels.step = lengthOf(plan, *i);
  if (const Word* r = c.ownWord(plan, 'R')) out.levels.retract = lengthOf(plan, *r);
  if (const Word* e = c.ownWord(plan, 'E')) out.last = lengthOf(plan, *e);
  if (!(out.levels.step > 0.0))
    return lcnFail(c, "profile", "G7X error: I must be greater than zero.", c.word('I'));
  out.levels.step = std::max(out.levels.step, kLcnLeastStep * unit);
  if (!(out.distance >= 0.0 && out.last >= 0.0))
    return lcnFail(c, "profile", "D and E of G70, G71, G72 must not be negative", c.word('D'));
  if (!(out.levels.retract >= 0.0)) return lcnFail(c, "profile", "R must not be negative", c.word('R'));
  if (const Word* p = c.ownWord(plan, 'P')) {
    if (!lcnInteger(c, *p, out.passes)) return false;
    if (out.passes < 1 || out.passes > kLcnMostLevels)
      return lcnFail(c, "profile", "P of G70 is 1 to 5000", p);
  }
  return true;
}

/// G70: along the contour, pass by pass nearer to it. Compensation begins anew with the way to each pass.
bool lcnFinish(IsoContext& c, const BlockPlan& plan, const LinuxCncProfile& profile,
               const LcnRoughWords& words, LcnRougher& rougher) {
  const bool comp = plan.next.compOn();
  std::optional<LcnRoughContour> contour;
  if (!lcnRoughContour(c, profile, lcnGoesOneWay(profile, 0) ? 1 : 0, contour)) return false;
  const LcnRoughFrame& frame = contour->frame;
  for (std::int64_t p = words.passes; p >= 1; --p) {
    const double part = static_cast<double>(p - 1) / static_cast<double>(words.passes);
    PlaneContour pass = contour->elements;
    if (!lcnKeepOff(c, part * (words.distance - words.last) + words.last, pass)) return false;
    rougher.rapid(frame.out(pass.front().from), comp);
    rougher.rapid(frame.out(pass.front().to));
    for (std::size_t k = 1; k < pass.size(); ++k) rougher.feed(frame.out(pass[k]));
  }
  return true;
}

/// G71, G72: levels across X, across Z.
bool lcnLevels(IsoContext& c, const LinuxCncProfile& profile, int code, const LcnRoughWords& words,
               LcnRougher& rougher) {
  std::optional<LcnRoughContour> contour;
  if (!lcnRoughContour(c, profile, code < 720 ? 1 : 0, contour)) return false;
  PlaneContour& way = contour->elements;
  if (!lcnKeepOff(c, words.distance, way)) return false;
  const double top = way.front().from.y();
  if (const Vec2 end = way.back().to; end.y() < top) way.push_back(lineElement(end, {end.x(), top}));
  double low = top;
  for (const ContourElement& e : way) {
    low = std::min({low, e.from.y(), e.to.y()});
    if (e.arc && e.sweep > 0.0) low = std::min(low, e.center.y() - (e.from - e.center).norm());
  }
  LevelRules rules = words.levels;
  rules.pockets = code % 10 == 1 ? Pockets::kNone : code % 10 == 2 ? Pockets::kOnly : Pockets::kAll;
  const bool few = (top - low) / rules.step <= kLcnMostLevels;
  const std::vector<LevelMove> moves = few ? cutLevels(way, rules) : std::vector<LevelMove>();
  if (moves.empty())
    return c.alarm(SharedAlarm::kOutOfRange, "I", "more than 5000 levels in one line are not simulated");
  rougher.rapid(contour->frame.out(way.front().from));
  for (const LevelMove& m : moves) {
    const ContourElement e = contour->frame.out(m.element);
    m.rapid ? rougher.rapid(e.to) : rougher.feed(e);
  }
  return true;
}

/// What follows the cycle without a G code goes on as its last motion.
std::int32_t lcnMotionBehind(const std::vector<LinuxCncStep>& steps) {
  using Kind = LinuxCncStep::Kind;
  if (steps.empty() || steps.back().kind == Kind::kRapid) return gcode::kRapid;
  if (steps.back().kind == Kind::kFeed) return gcode::kLine;
  return steps.back().sweep > 0.0 ? gcode::kArcCounterClockwise : gcode::kArcClockwise;
}

}  // namespace

bool planLcnRough(IsoContext& c, BlockPlan& plan) {
  LinuxCncChannel& own = linuxCncChannel(c);
  const auto lines = std::exchange(own.contour, std::nullopt);
  const int code = plan.governor->code10;
  const Word* q = c.ownWord(plan, 'Q');
  if (q == nullptr) return lcnFail(c, "profile", "G7x.x  requires a Q word");
  if (code != 700 && lcnCompOn(c, plan))
    return lcnFail(c, "comp", fmt::format("{} cannot be used with cutter compensation enabled", gName(code)));
  if (plan.next.active[kGroupPlane] != gcode::kPlaneZX)
    return lcnFail(c, "profile", fmt::format("{} can only be used in XZ plane (G18)", gName(code)));
  std::int64_t number = 0;
  LcnRoughWords words;
  if (!lcnInteger(c, *q, number) || !lcnRoughWords(c, plan, words)) return false;
  if (!lcnTarget(c, plan, plan.motion.target)) return false;
  if (!lcnFeed(c, plan, 1.0, 0.0, "g7x", plan.motion.feed)) return false;
  if (!lines)
    return lcnFail(
        c, "profile",
        fmt::format("the contour is missing: o{0} sub .. o{0} endsub in this program, or {0}.ngc", number),
        q);
  const Vec2 start(plan.motion.target.xyz.z(), plan.motion.target.xyz.x());
  LinuxCncProfile profile;
  if (!readLinuxCncProfile(c, plan, *lines, start, profile)) return false;
  LcnRougher rougher(own, plan.motion.target);
  rougher.rapid(start, plan.next.compOn());
  const bool good =
      code == 700 ? lcnFinish(c, plan, profile, words, rougher) : lcnLevels(c, profile, code, words, rougher);
  if (!good) return false;
  plan.next.active[kGroupMotion] = lcnMotionBehind(own.steps);
  plan.motion.target = rougher.at();
  plan.perform = performLinuxCncSteps;
  return true;
}

}  // namespace proveout::nc
