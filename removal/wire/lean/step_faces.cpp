#include "removal/wire/lean/step_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/geometry/plane.h"
#include "core/geometry/polygon.h"
#include "removal/wire/section/face_triangles.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {
namespace {

using Ids = std::vector<std::uint32_t>;

LoopEdge reversed(const LoopEdge& e) { return {e[1], e[0]}; }

/// The edges that are left when those that run to and fro cancel out: each one once, in order.
std::vector<LoopEdge> withoutReturns(const std::vector<LoopEdge>& edges) {
  std::map<LoopEdge, int> count;
  for (const LoopEdge& e : edges) {
    if (e[0] != e[1]) count[std::min(e, reversed(e))] += e[0] < e[1] ? 1 : -1;
  }
  std::vector<LoopEdge> out;
  for (const auto& [e, times] : count) {
    if (times != 0) out.push_back(times > 0 ? e : reversed(e));
  }
  return out;
}

/// How often loops go round a point, by the edges left of it. Rows of equal height know theirs.
class Windings {
 public:
  Windings(const std::vector<Vec2>& points, const std::vector<LoopEdge>& edges) : points_(points) {
    for (const LoopEdge& e : edges) {
      for (const std::uint32_t v : e) {
        low_ = std::min(low_, points[v].y());
        high_ = std::max(high_, points[v].y());
      }
    }
    rows_.resize(std::max<std::size_t>(edges.size(), 1));
    for (const LoopEdge& e : edges) {
      const auto [from, to] = std::minmax(points[e[0]].y(), points[e[1]].y());
      for (std::size_t row = rowOf(from); row <= rowOf(to); ++row) rows_[row].push_back(e);
    }
  }

  /// To the left of the middle of an edge, which may be one of theirs, in either direction.
  int leftOf(const LoopEdge& edge) const {
    const Vec2 p = 0.5 * (points_[edge[0]] + points_[edge[1]]);
    if (!(p.y() >= low_ && p.y() <= high_)) return 0;
    int winds = 0;
    for (const LoopEdge& e : rows_[rowOf(p.y())]) {
      const Vec2 &from = points_[e[0]], &to = points_[e[1]];
      if (e == edge || e == reversed(edge)) {
        // What goes down, or back, has the way to the left of it across: edges on one height count as just
        // below it.
        const bool across = isDown(edge);
        if (across) winds += e == edge ? 1 : -1;
        continue;
      }
      if ((from.y() > p.y()) == (to.y() > p.y())) continue;
      const bool up = to.y() > from.y();
      const double side = cross2(to - from, p - from);  // above 0: the point is to the left
      if (up ? side < 0.0 : side > 0.0) winds += up ? -1 : 1;
    }
    return winds;
  }

 private:
  bool isDown(const LoopEdge& e) const {
    const Vec2 &from = points_[e[0]], &to = points_[e[1]];
    return from.y() != to.y() ? to.y() < from.y() : to.x() < from.x();
  }
  std::size_t rowOf(double y) const {
    const double share = high_ > low_ ? (y - low_) / (high_ - low_) : 0.0;
    const auto count = static_cast<double>(rows_.size());
    return static_cast<std::size_t>(std::clamp(share * count, 0.0, count - 1.0));
  }

  const std::vector<Vec2>& points_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
  std::vector<std::vector<LoopEdge>> rows_;
};

/// What bounds both regions.
struct StepBorders {
  std::vector<LoopEdge> below_alone, above_alone;
};

StepBorders stepBorders(const std::vector<Vec2>& points, const std::vector<LoopEdge>& below,
                        const std::vector<LoopEdge>& above) {
  const std::set<LoopEdge> in_below(below.begin(), below.end()), in_above(above.begin(), above.end());
  const Windings round_below(points, below), round_above(points, above);
  StepBorders out;
  for (const LoopEdge& e : below) {
    if (in_above.contains(e)) continue;
    if (round_below.leftOf(e) - round_above.leftOf(e) > 0)
      out.below_alone.push_back(e);
    else
      out.above_alone.push_back(reversed(e));
  }
  for (const LoopEdge& e : above) {
    if (in_below.contains(e)) continue;
    if (round_below.leftOf(e) - round_above.leftOf(e) < 0)
      out.above_alone.push_back(e);
    else
      out.below_alone.push_back(reversed(e));
  }
  return out;
}

/// Closed loops of edges. Where several meet in a point each turns so that the region stays in one piece
/// there.
class LoopWalk {
 public:
  LoopWalk(const std::vector<Vec2>& points, const std::vector<LoopEdge>& edges) : points_(points) {
    for (const LoopEdge& e : edges) out_[e[0]].push_back(e[1]);
  }

  std::vector<Ids> loops() {
    std::vector<Ids> all;
    for (const auto& [start, ends] : out_) {
      while (!ends.empty()) {
        Ids loop{start};
        for (std::uint32_t from = start, at = take(start, out_.at(start).front()); at != start;) {
          loop.push_back(at);
          const auto next = nextOf(from, at);
          if (!next) return {};
          from = at;
          at = take(at, *next);
        }
        if (loop.size() > 2) all.push_back(std::move(loop));
      }
    }
    return all;
  }

 private:
  std::uint32_t take(std::uint32_t from, std::uint32_t to) {
    Ids& ends = out_.at(from);
    ends.erase(std::find(ends.begin(), ends.end(), to));
    return to;
  }
  /// The first edge clockwise from the one that was come by. None: the edges do not close.
  std::optional<std::uint32_t> nextOf(std::uint32_t from, std::uint32_t at) const {
    const auto found = out_.find(at);
    if (found == out_.end() || found->second.empty()) return std::nullopt;
    const Vec2 back = points_[from] - points_[at];
    const auto angle = [&](std::uint32_t to) {
      const Vec2 way = points_[to] - points_[at];
      const double clockwise = -std::atan2(cross2(back, way), back.dot(way));
      return clockwise <= 0.0 ? clockwise + 2.0 * kPi : clockwise;
    };
    return *std::ranges::min_element(found->second, {}, angle);
  }

  const std::vector<Vec2>& points_;
  std::map<std::uint32_t, Ids> out_;
};

std::vector<Vec2> placesOf(const std::vector<Vec2>& points, const Ids& loop) {
  std::vector<Vec2> places;
  for (const std::uint32_t id : loop) places.push_back(points[id]);
  return places;
}

struct Region {
  std::vector<Ids> loops;  ///< the border first
  std::vector<Vec2> border;
  double area = 0.0;
};

std::vector<Region> regionsOf(const std::vector<Vec2>& points, const std::vector<Ids>& loops) {
  std::vector<Region> regions;
  std::vector<const Ids*> hollows;
  for (const Ids& loop : loops) {
    std::vector<Vec2> places = placesOf(points, loop);
    const double area = polygonArea(places);
    if (area > 0.0)
      regions.push_back({{loop}, std::move(places), area});
    else
      hollows.push_back(&loop);
  }
  std::ranges::stable_sort(regions, {}, &Region::area);
  for (const Ids* hollow : hollows) {
    const Vec2 middle = 0.5 * (points[(*hollow)[0]] + points[(*hollow)[1]]);
    const auto around =
        std::ranges::find_if(regions, [&](const Region& region) { return surrounds(region.border, middle); });
    if (around != regions.end()) around->loops.push_back(*hollow);
  }
  return regions;
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles trianglesOf(const std::vector<Vec2>& points, const std::vector<LoopEdge>& border) {
  Triangles out;
  for (const Region& region : regionsOf(points, LoopWalk(points, withoutReturns(border)).loops())) {
    std::vector<std::vector<Vec2>> loops;
    Ids corner;
    for (const Ids& loop : region.loops) {
      loops.push_back(placesOf(points, loop));
      corner.insert(corner.end(), loop.begin(), loop.end());
    }
    for (const auto& [a, b, c] : faceTriangles(loops)) {
      if (corner[a] == corner[b] || corner[b] == corner[c] || corner[c] == corner[a]) continue;
      out.push_back({corner[a], corner[b], corner[c]});
    }
  }
  return out;
}

}  // namespace

StepFaces stepFaces(const std::vector<Vec2>& points, const std::vector<LoopEdge>& below,
                    const std::vector<LoopEdge>& above) {
  const StepBorders borders = stepBorders(points, withoutReturns(below), withoutReturns(above));
  return {trianglesOf(points, borders.below_alone), trianglesOf(points, borders.above_alone)};
}

}  // namespace proveout
