#include "core/nc/linuxcnc/cycles/level_cutter.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace proveout::nc {
namespace {

constexpr double kLevelSame = 1e-6;  ///< mm
constexpr double kNoWay = 1e-6;      ///< mm; shorter moves are none

/// Stretches on which the height goes one way.
PlaneContour monotoneStretches(const PlaneContour& contour) {
  PlaneContour out;
  for (const ContourElement& e : contour) {
    std::vector<double> cuts;
    if (e.arc) {
      const Vec2 arm = e.from - e.center;
      const double from = std::atan2(arm.y(), arm.x());
      const double least = kLevelSame / std::max(kLevelSame, std::abs(e.sweep) * arm.norm());
      for (int turn = -3; turn <= 3; ++turn) {
        const double t = ((turn + 0.5) * kPi - from) / e.sweep;
        if (t > least && t < 1.0 - least) cuts.push_back(t);
      }
      std::sort(cuts.begin(), cuts.end());
    }
    double last = 0.0;
    for (const double t : cuts) {
      out.push_back(partOf(e, last, t));
      last = t;
    }
    out.push_back(last > 0.0 ? partOf(e, last, 1.0) : e);
  }
  return out;
}

bool falls(const ContourElement& e) { return e.from.y() > e.to.y() + kLevelSame; }

/// Where a stretch has the height; nothing: nowhere. On a flat one its begin.
std::optional<Vec2> atHeight(const ContourElement& e, double height) {
  if (height < std::min(e.from.y(), e.to.y()) - kLevelSame ||
      height > std::max(e.from.y(), e.to.y()) + kLevelSame)
    return std::nullopt;
  if (std::abs(e.to.y() - e.from.y()) < kLevelSame) return e.from;
  if (!e.arc) {
    const double t = std::clamp((height - e.from.y()) / (e.to.y() - e.from.y()), 0.0, 1.0);
    return Vec2(e.from.x() + t * (e.to.x() - e.from.x()), height);
  }
  const double dv = height - e.center.y(), radius = (e.from - e.center).norm();
  const double du = std::sqrt(std::max(0.0, radius * radius - dv * dv));
  const bool behind = pointOn(e, 0.5).x() > e.center.x();
  return Vec2(e.center.x() + (behind ? du : -du), height);
}

class LevelCutter {
 public:
  LevelCutter(const PlaneContour& contour, const LevelRules& rules)
      : way_(monotoneStretches(contour)), rules_(rules), origin_(contour.front().from.y()) {
    at_ = way_.front().from;
  }

  std::vector<LevelMove> run() {
    if (rules_.pockets == Pockets::kOnly) {
      while (next_ < way_.size() && falls(way_[next_])) toEnd(next_ == 0);
      climb();
    }
    while (next_ < way_.size() && fits()) {
      rough();
      if (rules_.pockets == Pockets::kNone) {
        pass();
      } else {
        climb();
      }
    }
    if (!fits()) moves_.clear();
    return std::move(moves_);
  }

 private:
  bool fits() const { return moves_.size() <= kMostLevelMoves; }

  void go(bool rapid, const Vec2& to) {
    if ((to - at_).norm() < kNoWay) {
      at_ = to;
      return;
    }
    moves_.push_back({rapid, lineElement(at_, to)});
    at_ = to;
  }

  /// Along a stretch from where the tool is, which is on it, to `to`.
  void along(const ContourElement& e, const Vec2& to, bool rapid) {
    if (!e.arc || (to - at_).norm() < kNoWay) return go(rapid, to);
    const Vec2 a = at_ - e.center, b = to - e.center;
    const double sweep = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    const ContourElement part = arcElement(e.center, at_, to, sweep);
    LevelMove* last = moves_.empty() ? nullptr : &moves_.back();
    const bool same = last != nullptr && last->element.arc && last->element.center == e.center;
    if (same) {
      last->element.to = to;
      last->element.sweep += sweep;
    } else {
      moves_.push_back({false, part});
    }
    at_ = to;
  }
  void toEnd(bool rapid) {
    along(way_[next_], way_[next_].to, rapid);
    ++next_;
  }

  /// Down the stretches that fall, level by level, with a cut across on each of them.
  void rough() {
    double level = origin_;
    while (next_ < way_.size() && falls(way_[next_]) && fits()) {
      while (level - kLevelSame > at_.y()) level -= rules_.step;
      const ContourElement& e = way_[next_];
      if (level < e.to.y() + kLevelSame) {
        toEnd(next_ == 0);
        continue;
      }
      if (const auto down = atHeight(e, level)) along(e, *down, next_ == 0);
      across();
      level -= rules_.step;
    }
  }

  /// One level: to where the contour rises through it, off, back, and down again.
  void across() {
    const auto wall = ahead();
    if (!wall || wall->x() - at_.x() < kLevelSame) return;
    const Vec2 from = at_;
    const double off = std::min(rules_.retract, 0.5 * (wall->x() - from.x()));
    go(false, {wall->x(), from.y()});
    go(true, at_ + Vec2(-off, off));
    go(true, from + Vec2(off, off));
    go(next_ == 0, from);
  }

  /// The next stretch behind the one in hand that has the height of the tool.
  std::optional<Vec2> ahead() const {
    for (std::size_t k = next_ + 1; k < way_.size(); ++k)
      if (const auto p = atHeight(way_[k], at_.y()); p && p->x() - at_.x() > -kLevelSame) return p;
    return std::nullopt;
  }

  void climb() {
    while (next_ < way_.size() && !falls(way_[next_])) toEnd(false);
    edge();
  }

  /// The highest edge of a pocket so far is where levels count from, if the first fall was not roughed.
  void edge() {
    if (rules_.pockets != Pockets::kOnly || next_ >= way_.size() || next_ == 0 || !falls(way_[next_])) return;
    if (!edge_ || at_.y() > *edge_) edge_ = at_.y();
    origin_ = *edge_;
  }

  /// Along what rises, and straight across what lies below.
  void pass() {
    for (; next_ < way_.size(); ++next_) {
      const ContourElement& e = way_[next_];
      if (falls(e)) continue;
      const auto p = atHeight(e, at_.y());
      if (!p) continue;
      go(false, {p->x(), at_.y()});
      along(e, e.to, false);
    }
  }

  const PlaneContour way_;
  const LevelRules rules_;
  double origin_;
  std::optional<double> edge_;
  Vec2 at_;
  std::size_t next_ = 0;  ///< the stretch in hand
  std::vector<LevelMove> moves_;
};

}  // namespace

std::vector<LevelMove> cutLevels(const PlaneContour& contour, const LevelRules& rules) {
  return LevelCutter(contour, rules).run();
}

}  // namespace proveout::nc
