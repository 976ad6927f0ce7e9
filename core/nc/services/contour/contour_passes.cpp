#include "core/nc/services/contour/contour_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_profile.h"

namespace proveout {

namespace {

constexpr double kSameHeight = 1e-6;  ///< mm
constexpr double kNoWay = 1e-9;       ///< mm

using Zone = ContourProfile::Zone;
using Speed = ContourMove::Speed;

class Roughing {
 public:
  Roughing(const PlaneContour& contour, const RoughingRules& rules)
      : rules_(rules),
        profile_(contour, rules.depth_axis,
                 rules.from[rules.depth_axis] >= contour.front().from[rules.depth_axis] ? 1.0 : -1.0),
        at_(rules.from) {}

  std::vector<ContourMove> run() {
    const double top = profile_.level(rules_.from);
    for (const Zone& zone : profile_.zonesBelow({0.0, profile_.length()}, top)) process(zone, top, top);
    moveAlong(rules_.depth_axis, rules_.from, Speed::kRapid);
    moveAlong(1 - rules_.depth_axis, rules_.from, Speed::kRapid);
    return std::move(moves_);
  }

 private:
  /// `before`: the level that is cut already; `travel`: one on which nothing is in the way.
  void process(const Zone& zone, double before, double travel) {
    const double bottom = profile_.lowest(zone);
    if (bottom >= before - kSameHeight) return;
    const double height = std::max(before - rules_.depth, bottom);
    const Vec2 start = profile_.at(zone.a), end = profile_.at(zone.b);
    toLevel(travel, Speed::kRapid);
    moveAlong(1 - rules_.depth_axis, start, Speed::kRapid);
    toLevel(before, Speed::kRapid);
    if (zone.a == 0.0 && profile_.level(start) < before - kSameHeight) {
      toLevel(std::max(height, profile_.level(start)), Speed::kInfeed);
    }
    const std::vector<Zone> deeper = profile_.zonesBelow(zone, height);
    double t = zone.a;
    for (const Zone& sub : deeper) {
      follow(t, sub.a);
      Vec2 across = profile_.at(sub.b);
      across[rules_.depth_axis] = profile_.coordinate(height);
      moveTo(across, Speed::kFeed, profile_.sourceAt(sub.b));
      t = sub.b;
    }
    follow(t, zone.b);
    if (zone.b == profile_.length() && profile_.level(end) < before - kSameHeight)
      toLevel(before, Speed::kRapid);
    for (const Zone& sub : deeper) process(sub, height, before);
  }

  /// Along the contour at feed.
  void follow(double a, double b) {
    for (ContourElement& e : profile_.between(a, b)) {
      if (!((e.to - e.from).norm() > kNoWay)) continue;
      if (!e.arc) {
        moveTo(e.to, Speed::kFeed, e.source);
        continue;
      }
      e.from = at_;
      moves_.push_back({Speed::kFeed, e});
      at_ = e.to;
    }
  }

  void toLevel(double height, Speed speed) {
    Vec2 to = at_;
    to[rules_.depth_axis] = profile_.coordinate(height);
    moveTo(to, speed);
  }
  void moveAlong(int axis, const Vec2& to, Speed speed) {
    Vec2 point = at_;
    point[axis] = to[axis];
    moveTo(point, speed);
  }
  /// Lines at feed that go on straight are one.
  void moveTo(const Vec2& to, Speed speed, int source = -1) {
    const Vec2 way = to - at_;
    if (way.norm() > kNoWay) {
      ContourMove* last = moves_.empty() ? nullptr : &moves_.back();
      const bool goes_on = last != nullptr && speed == Speed::kFeed && last->speed == speed &&
                           !last->element.arc &&
                           std::abs(cross2((at_ - last->element.from).normalized(), way)) < 1e-9 &&
                           (at_ - last->element.from).dot(way) > 0.0;
      if (goes_on) {
        last->element.to = to;
      } else {
        moves_.push_back({speed, lineElement(at_, to)});
      }
      moves_.back().element.source = source;
    }
    at_ = to;
  }

  const RoughingRules rules_;
  const ContourProfile profile_;
  Vec2 at_;
  std::vector<ContourMove> moves_;
};

/// A move from `at`, which goes along; none where it is there already.
void addMove(const Vec2& to, Speed speed, Vec2& at, std::vector<ContourMove>& moves) {
  if ((to - at).norm() > kNoWay) moves.push_back({speed, lineElement(at, to)});
  at = to;
}

Vec2 withAxis(Vec2 point, int axis, double value) {
  point[axis] = value;
  return point;
}

/// All of the contour at feed.
void addContour(const PlaneContour& contour, Vec2& at, std::vector<ContourMove>& moves) {
  for (const ContourElement& e : contour) moves.push_back({Speed::kFeed, e});
  at = contour.back().to;
}

}  // namespace

std::vector<ContourMove> roughingPasses(const PlaneContour& contour, const RoughingRules& rules) {
  return Roughing(contour, rules).run();
}

std::vector<ContourMove> finishingPass(const PlaneContour& contour, int depth_axis, const Vec2& from) {
  std::vector<ContourMove> moves;
  const int along = 1 - depth_axis;
  const Vec2 start = contour.front().from;
  Vec2 at = from;
  addMove(withAxis(at, along, start[along]), Speed::kRapid, at, moves);
  addMove(start, Speed::kInfeed, at, moves);
  addContour(contour, at, moves);
  addMove(withAxis(at, depth_axis, from[depth_axis]), Speed::kRapid, at, moves);
  addMove(from, Speed::kRapid, at, moves);
  return moves;
}

void addApproachPass(const PlaneContour& contour, const Vec2& from, std::vector<ContourMove>& moves) {
  const Vec2 start = contour.front().from, back = from - start;
  Vec2 at = from;
  addMove(start, Speed::kInfeed, at, moves);
  addContour(contour, at, moves);
  const int first = std::abs(back.y()) >= std::abs(back.x()) ? 1 : 0;
  addMove(withAxis(at, first, from[first]), Speed::kRapid, at, moves);
  addMove(from, Speed::kRapid, at, moves);
}

}  // namespace proveout
