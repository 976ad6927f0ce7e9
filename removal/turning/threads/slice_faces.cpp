#include "removal/turning/threads/slice_faces.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "core/base/assert.h"
#include "core/geometry/ears.h"

namespace proveout::thread_detail {

namespace {

bool onePoint(const Vec2& a, const Vec2& b) { return (a - b).cwiseAbs().maxCoeff() <= kOnePointMm; }

struct Split {
  std::size_t loop, edge;
  double along;  ///< mm from where the edge begins
  Vec2 at;
};

/// The edge that the point lies inside of; nothing where it is at an end of one, or on none.
std::optional<Split> edgeUnder(const Slice& slice, const Vec2& p) {
  std::optional<Split> found;
  for (std::size_t l = 0; l < slice.loops.size(); ++l) {
    const CornerLoop& loop = slice.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i].at, &b = loop[(i + 1) % loop.size()].at;
      if (p.y() < std::min(a.y(), b.y()) - kOnePointMm || p.y() > std::max(a.y(), b.y()) + kOnePointMm)
        continue;
      if (onePoint(a, p)) return std::nullopt;
      if (distanceToSegment(p, a, b) <= kOnePointMm && !onePoint(b, p)) found = {l, i, (p - a).norm(), p};
    }
  }
  return found;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Polygon = std::vector<std::uint32_t>;

/// What is left of directed edges when those that go both ways are taken out.
class OpenEdges {
 public:
  void add(std::uint32_t from, std::uint32_t to) {
    if (const auto back = edges_.find({to, from}); back != edges_.end()) {
      if (--back->second == 0) edges_.erase(back);
    } else {
      ++edges_[{from, to}];
    }
  }

  /// Closed ways along all edges, none of which passes a vertex twice. Nothing: an edge leads nowhere.
  std::optional<std::vector<Polygon>> polygons() {
    std::vector<Polygon> out;
    while (!edges_.empty()) {
      Polygon way{edges_.begin()->first.first};
      while (true) {
        const auto next = edges_.lower_bound({way.back(), 0});
        if (next == edges_.end() || next->first.first != way.back()) {
          if (way.size() == 1) break;  // all of it has been taken out
          return std::nullopt;
        }
        const std::uint32_t to = next->first.second;
        if (--next->second == 0) edges_.erase(next);
        const auto again = std::find(way.begin(), way.end(), to);
        if (again == way.end()) {
          way.push_back(to);
          continue;
        }
        out.emplace_back(again, way.end());
        way.erase(again + 1, way.end());
      }
    }
    return out;
  }

 private:
  std::map<Edge, int> edges_;
};

/// In the order of the polygon's corners. False: it crosses itself.
bool cutIntoTriangles(Polygon corners, std::vector<Vec2> points,
                      std::vector<std::array<std::uint32_t, 3>>& out) {
  PROVEOUT_ASSERT(corners.size() == points.size());
  const bool clockwise = signedArea2(points) < 0.0;
  if (clockwise) {
    std::reverse(corners.begin(), corners.end());
    std::reverse(points.begin(), points.end());
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (clockwise)
      out.push_back({a, c, b});
    else
      out.push_back({a, b, c});
  };
  while (corners.size() > 3) {
    std::size_t ear = 0;
    while (ear < corners.size() && !isEar(points, ear)) ++ear;
    if (ear == corners.size()) return false;
    const std::size_t n = corners.size();
    add(corners[(ear + n - 1) % n], corners[ear], corners[(ear + 1) % n]);
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(ear));
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (corners.size() == 3) add(corners[0], corners[1], corners[2]);
  return corners.size() == 3;
}

}  // namespace

bool splitEdges(Slice& a, const Slice& b) {
  std::vector<Split> splits;
  for (const CornerLoop& loop : b.loops) {
    for (const Corner& corner : loop) {
      if (const auto split = edgeUnder(a, corner.at)) splits.push_back(*split);
    }
  }
  // From the back, so that the numbers in front stay.
  std::sort(splits.begin(), splits.end(), [](const Split& x, const Split& y) {
    return std::tie(x.loop, x.edge, x.along) > std::tie(y.loop, y.edge, y.along);
  });
  for (const Split& split : splits) {
    CornerLoop& loop = a.loops[split.loop];
    const EdgeName name = loop[split.edge].out;
    const auto behind = loop.begin() + static_cast<std::ptrdiff_t>(split.edge) + 1;
    if (behind != loop.end() && onePoint(behind->at, split.at)) continue;  // two corners of b at one place
    loop.insert(behind, Corner{split.at, name, name});
  }
  return !splits.empty();
}

std::optional<std::vector<std::array<std::uint32_t, 3>>> facesBetween(const Slice& a, const Slice& b) {
  OpenEdges edges;
  std::unordered_map<std::uint32_t, Vec2> place;
  for (const auto& [slice, forward] : {std::pair{&a, false}, std::pair{&b, true}}) {
    for (const CornerLoop& loop : slice->loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t from = loop[i].vertex, to = loop[(i + 1) % loop.size()].vertex;
        place[from] = loop[i].at;
        if (from == to) continue;
        if (forward)
          edges.add(from, to);
        else
          edges.add(to, from);
      }
    }
  }
  const auto polygons = edges.polygons();
  if (!polygons) return std::nullopt;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Polygon& polygon : *polygons) {
    std::vector<Vec2> points;
    for (const std::uint32_t v : polygon) points.push_back(place[v]);
    if (polygon.size() < 3 || !cutIntoTriangles(polygon, std::move(points), triangles)) return std::nullopt;
  }
  return triangles;
}

}  // namespace proveout::thread_detail
