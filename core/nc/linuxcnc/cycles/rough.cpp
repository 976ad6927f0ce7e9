// G70 finish, G71 and G72 rough along a contour.
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/linuxcnc/cycles/profile.h"
#include "core/nc/services/contour/contour_offset.h"
#include "core/nc/services/contour/contour_profile.h"

namespace proveout::nc {
namespace {

constexpr int kLcnMostLevels = 5000;
constexpr double kLcnSame = 1e-9;  // mm

/// G70 to G72 in (Z, X): u and v of G18.
class LcnRougher {
 public:
  LcnRougher(LinuxCncChannel& own, const AxisPoint& start) : own_(own), at_(start) {}
  void rapid(const Vec2& to) {
    put(to);
    lcnRapid(own_, at_);
  }
  void feed(const ContourElement& e) {
    const Vec2 to = pointOn(e, 1.0);
    put(to);
    if (e.arc) {
      own_.steps.push_back(
          {.kind = LinuxCncStep::Kind::kArc, .to = at_, .center = e.center, .sweep = e.sweep});
    } else {
      lcnFeedTo(own_, at_);
    }
  }
  void along(const PlaneContour& contour) {
    for (const ContourElement& e : contour) feed(e);
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
  double step = 1.0;        ///< I
  double retract = 0.5;     ///< R
  double last = 0.0;        ///< E
  std::int64_t passes = 1;  ///< P
};

bool lcnRoughWords(IsoContext& c, BlockPlan& plan, LcnRoughWords& out) {
  const double unit = plan.next.unitScale();
  out.step = unit;
  out.retract = 0.5 * unit;
  if (const Word* d = c.ownWord(plan, 'D')) out.distance = lengthOf(plan, *d);
  if (const Word* i = c.ownWord(plan, 'I')) out.step = lengthOf(plan, *i);
  if (const Word* r = c.ownWord(plan, 'R')) out.retract = lengthOf(plan, *r);
  if (const Word* e = c.ownWord(plan, 'E')) out.last = lengthOf(plan, *e);
  if (!(out.step > 0.0)) return lcnFail(c, "profile", "G7X error: I must be greater than zero.", c.word('I'));
  if (!(out.distance >= 0.0 && out.last >= 0.0))
    return lcnFail(c, "profile", "D and E of G70, G71, G72 must not be negative", c.word('D'));
  if (!(out.retract >= 0.0)) return lcnFail(c, "profile", "R must not be negative", c.word('R'));
  if (const Word* p = c.ownWord(plan, 'P')) {
    if (!lcnInteger(c, *p, out.passes)) return false;
    if (out.passes < 1 || out.passes > kLcnMostLevels)
      return lcnFail(c, "profile", "P of G70 is 1 to 5000", p);
  }
  return true;
}

/// The contour kept off by a distance towards `start`. False: reported.
bool lcnKeptOff(IsoContext& c, const LinuxCncProfile& profile, const Vec2& start, double distance,
                PlaneContour& out) {
  out = profile.contour;
  if (distance == 0.0) return true;
  const Vec2 end = pointOn(profile.contour.back(), 1.0), way = end - profile.begin,
             to = start - profile.begin;
  const double side = way.x() * to.y() - way.y() * to.x() > 0.0 ? 1.0 : -1.0;
  bool fits = true;
  auto offset = offsetContour(profile.contour, side * distance, fits);
  if (!offset.ok())
    return lcnFail(c, "profile",
                   fmt::format("the distance D does not fit the contour: {}", offset.error().message));
  if (!fits)
    c.warnOnce("g71 d", "profile",
               "the distance D does not fit everywhere in the contour: elements are left out", {});
  out = std::move(*offset);
  return !out.empty() || lcnFail(c, "profile", "the distance D leaves nothing of the contour");
}

/// The levels of G71 (depth across X) and G72 (across Z). False: reported.
bool lcnLevels(IsoContext& c, LcnRougher& rougher, PlaneContour contour, Vec2 start, int depth,
               const LcnRoughWords& words) {
  const int cut = 1 - depth;
  const Vec2 begin = pointOn(contour.front(), 0.0);
  Vec2 end = pointOn(contour.back(), 1.0);
  const double side = start[depth] > begin[depth] ? 1.0 : -1.0;
  const double way = end[cut] < begin[cut] ? -1.0 : 1.0;
  if (side * (start[depth] - end[depth]) > kLcnSame) {
    // The end goes on up to where the tool starts.
    Vec2 out = end;
    out[depth] = start[depth];
    contour.push_back(lineElement(end, out));
    end = out;
  }
  if (!goesOneWay(contour, cut)) return lcnFail(c, "profile", "G7X error: Not monotonic");
  if (way * (start[cut] - begin[cut]) > 0.0) {
    start[cut] = begin[cut];
    rougher.rapid(start);
  }
  const ContourProfile profile(contour, depth, side);
  const double levels = side * (start[depth] - begin[depth]) / words.step;
  if (!(levels <= kLcnMostLevels))
    return c.alarm(SharedAlarm::kOutOfRange, "I", "more than 5000 levels in one line are not simulated");
  for (int k = 0; static_cast<double>(k) < levels - kLcnSame; ++k) {
    Vec2 from = start + (begin - start) * (static_cast<double>(k) / levels);
    from[depth] = start[depth] - side * words.step * k;
    rougher.rapid(from);
    const auto zones = profile.zonesBelow({0.0, profile.length()}, profile.level(from));
    Vec2 to = from;
    to[cut] = (zones.empty() ? end : profile.at(zones.front().b))[cut];
    const double length = way * (to[cut] - from[cut]);
    if (length < kLcnSame) continue;
    rougher.feed(lineElement(from, to));
    const double r = std::min(words.retract, 0.5 * length);
    Vec2 off = to;
    off[depth] += side * r;
    off[cut] -= way * r;
    rougher.rapid(off);
    off[cut] = from[cut] + way * r;
    rougher.rapid(off);
    rougher.rapid(from);
  }
  rougher.rapid(begin);
  rougher.along(contour);
  return true;
}

}  // namespace

bool planLcnRough(IsoContext& c, BlockPlan& plan) {
  const int code = plan.governor->code10;
  if (lcnCompOn(c, plan)) return lcnFail(c, "comp", "G70, G71, G72: program G40 first");
  if (plan.next.active[kGroupPlane] != gcode::kPlaneZX)
    return lcnFail(c, "profile", fmt::format("{} can only be used in XZ plane (G18)", gName(code)));
  const Word* q = c.ownWord(plan, 'Q');
  if (q == nullptr) return lcnFail(c, "profile", "G7x.x  requires a Q word");
  std::int64_t number = 0;
  LcnRoughWords words;
  if (!lcnInteger(c, *q, number) || !lcnRoughWords(c, plan, words)) return false;
  if (!lcnTarget(c, plan, plan.motion.target)) return false;
  if (!lcnFeed(c, plan, 1.0, 0.0, "g7x", plan.motion.feed)) return false;
  LinuxCncChannel& own = linuxCncChannel(c);
  const Vec2 start(plan.motion.target.xyz.z(), plan.motion.target.xyz.x());
  LinuxCncProfile profile;
  if (!readLinuxCncProfile(c, plan, number, start, profile)) return false;
  LcnRougher rougher(own, plan.motion.target);
  rougher.rapid(start);
  if (code == 700) {
    for (std::int64_t p = words.passes; p >= 1; --p) {
      const double off =
          static_cast<double>(p - 1) * (words.distance - words.last) / static_cast<double>(words.passes) +
          words.last;
      PlaneContour contour;
      if (!lcnKeptOff(c, profile, start, off, contour)) return false;
      if (p != words.passes) rougher.rapid(start);
      rougher.rapid(pointOn(contour.front(), 0.0));
      rougher.along(contour);
    }
  } else {
    PlaneContour contour;
    if (!lcnKeptOff(c, profile, start, words.distance, contour)) return false;
    const int depth = code < 720 ? 1 : 0;
    const bool pockets = code % 10 != 0;
    if (pockets && !goesOneWay(contour, depth))
      return lcnFail(c, "profile",
                     fmt::format("{} with pockets in its contour is not simulated: G71 or G72 cut them "
                                 "in the last pass",
                                 gName(code)));
    if (!lcnLevels(c, rougher, std::move(contour), start, depth, words)) return false;
  }
  plan.motion.target = rougher.at();
  plan.perform = performLinuxCncSteps;
  return true;
}

}  // namespace proveout::nc
