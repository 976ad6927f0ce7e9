#include "core/nc/fanuc/lathe/roughing_passes.h"

#include <algorithm>
#include <cmath>

#include "core/nc/services/contour/contour_profile.h"

namespace proveout::nc {
namespace {

constexpr double kSameLevelMm = 2e-6;
constexpr double kNoMoveMm = 1e-9;

using Zone = ContourProfile::Zone;
using Speed = ContourMove::Speed;

class Levels {
 public:
  Levels(const PlaneContour& contour, const LevelRules& rules)
      : rules_(rules),
        along_(1 - rules.depth_axis),
        profile_(contour, rules.depth_axis, rules.side),
        way_(contour.back().to[along_] >= contour.front().from[along_] ? 1.0 : -1.0),
        at_(rules.from) {}

  std::vector<ContourMove> run() {
    cut({0.0, profile_.length()}, 0, level(rules_.from), true);
    return std::move(moves_);
  }

 private:
  double level(const Vec2& p) const { return profile_.level(p); }
  double heightOf(int k) const { return rules_.side * rules_.first - k * rules_.depth; }

  /// Levels behind the k-th inside a stretch of the contour whose level `before` is cut; `open`: it begins
  /// where the passes do.
  void cut(const Zone& zone, int k, double before, bool open) {
    for (++k; k <= kMostLevels; ++k) {
      const double height = heightOf(k);
      if (height >= before - kSameLevelMm) continue;  // counted from A, beyond C
      const double low = profile_.lowest(zone);
      const bool reaches = height > low + kSameLevelMm || (!open && height > low - kSameLevelMm);
      if (!reaches) return;
      const std::vector<Zone> deeper = profile_.zonesBelow(zone, height + (open ? 0.0 : 2.0 * kSameLevelMm));
      const bool one = deeper.size() == 1 && (deeper.front().a == 0.0) == open;
      for (const Zone& stretch : deeper) {
        const bool outer = open && stretch.a == 0.0;
        if (outer) {
          passFromStart(stretch, height, before);
        } else {
          passInPocket(zone, stretch, height, before);
        }
        if (!one) cut(stretch, k, height, outer);
      }
      if (!one) return;
      before = height;
      // What is below the next level lies in this stretch alone.
      return cut(deeper.front(), k, before, open);
    }
  }

  /// A level from the coordinate of C on to the contour.
  void passFromStart(const Zone& stretch, double height, double before) {
    toStart(before);
    lift(height, Speed::kInfeed);
    cross(stretch.b, height);
    leave(stretch, height, before);
    alongTo(rules_.from[along_], Speed::kRapid);
  }

  /// A level between two flanks: down along the one, across, up along the other.
  void passInPocket(const Zone& zone, const Zone& stretch, double height, double before) {
    const double top = entry(zone, stretch, before);
    const Vec2 start = profile_.at(top);
    const double clear = before + rules_.escape;
    if (level(at_) < clear) lift(clear, Speed::kRapid);  // never down where the flank behind it stands
    alongTo(start[along_], Speed::kRapid);
    lift(clear, Speed::kRapid);
    lift(level(start), Speed::kFeed);
    follow(top, stretch.a);
    cross(stretch.b, height);
    leave(stretch, height, before);
  }

  /// Where the flank in front of a stretch begins to fall, no higher than `before`.
  double entry(const Zone& zone, const Zone& stretch, double before) const {
    double t = stretch.a;
    while (t > zone.a + kNoMoveMm) {
      const double back = std::max(zone.a, std::ceil(t - kNoMoveMm) - 1.0);
      if (!(level(profile_.at(back)) > level(profile_.at(t)) + kNoMoveMm)) break;
      if (level(profile_.at(back)) > before + kSameLevelMm) return highest(back, t, before);
      t = back;
    }
    return t;
  }

  /// The point between two parameters on a falling flank that is at the level.
  double highest(double a, double b, double height) const {
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (a + b);
      (level(profile_.at(middle)) > height ? a : b) = middle;
    }
    return b;
  }

  /// Off the work behind a level. Type I: at 45 degrees by e. Type II: along the contour up to the level
  /// before first, then across by e.
  void leave(const Zone& stretch, double height, double before) {
    if (!rules_.pockets) {
      Vec2 out = at_;
      out[rules_.depth_axis] += rules_.side * rules_.escape;
      out[along_] -= way_ * rules_.escape;
      return moveTo(out, Speed::kRapid);
    }
    (void)height;
    double t = stretch.b;
    while (t < profile_.length() - kNoMoveMm) {
      const double next = std::min(profile_.length(), std::floor(t + kNoMoveMm) + 1.0);
      const double here = level(profile_.at(t));
      if (here >= before - kSameLevelMm || !(level(profile_.at(next)) > here + kNoMoveMm)) break;
      if (level(profile_.at(next)) > before) {
        const double until = risesTo(t, next, before);
        follow(t, until);
        t = until;
        break;
      }
      follow(t, next);
      t = next;
    }
    if (level(at_) < before) lift(before, Speed::kFeed);  // what stands above it is not cut yet
    lift(before + rules_.escape, Speed::kRapid);
  }

  double risesTo(double a, double b, double height) const {
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (a + b);
      (level(profile_.at(middle)) < height ? a : b) = middle;
    }
    return a;
  }

  /// Back to where the outer passes begin.
  void toStart(double before) {
    if (std::abs(at_[along_] - rules_.from[along_]) < kNoMoveMm) return;
    if (level(at_) < before) lift(before + rules_.escape, Speed::kRapid);
    alongTo(rules_.from[along_], Speed::kRapid);
  }

  /// At the level to the contour.
  void cross(double t, double height) {
    Vec2 to = profile_.at(t);
    to[rules_.depth_axis] = profile_.coordinate(height);
    moveTo(to, Speed::kFeed);
  }

  /// Along the contour at feed.
  void follow(double a, double b) {
    for (ContourElement& e : profile_.between(a, b)) {
      if (!((e.to - e.from).norm() > kNoMoveMm)) continue;
      if (e.arc) {
        e.from = at_;
        moves_.push_back({Speed::kFeed, e});
        at_ = e.to;
      } else {
        moveTo(e.to, Speed::kFeed, e.source);
      }
    }
  }

  void lift(double height, Speed speed) {
    Vec2 to = at_;
    to[rules_.depth_axis] = profile_.coordinate(height);
    moveTo(to, speed);
  }
  void alongTo(double value, Speed speed) {
    Vec2 to = at_;
    to[along_] = value;
    moveTo(to, speed);
  }
  void moveTo(const Vec2& to, Speed speed, int source = -1) {
    if ((to - at_).norm() > kNoMoveMm) {
      ContourElement e = lineElement(at_, to);
      e.source = source;
      moves_.push_back({speed, e});
    }
    at_ = to;
  }

  const LevelRules rules_;
  const int along_;
  const ContourProfile profile_;
  const double way_;
  Vec2 at_;
  std::vector<ContourMove> moves_;
};

}  // namespace

std::vector<ContourMove> levelPasses(const PlaneContour& contour, const LevelRules& rules) {
  return Levels(contour, rules).run();
}

}  // namespace proveout::nc
