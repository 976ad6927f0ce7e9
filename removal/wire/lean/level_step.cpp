#include "removal/wire/lean/level_step.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <polyclipping/clipper.hpp>
#include <unordered_map>

#include "core/base/assert.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/plane.h"
#include "removal/wire/lean/step_faces.h"
#include "removal/wire/section/kerf_outline.h"
#include "removal/wire/section/kerf_union.h"
#include "removal/wire/section/plane_region.h"

namespace proveout {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;
using Ids = std::vector<std::uint32_t>;

/// Points by their place, as a mesh holds them: those nearer to each other than `near` mm are one.
class PointTable {
 public:
  explicit PointTable(double near) : near_(near) { PROVEOUT_ASSERT(near > 0.0); }

  std::uint32_t of(const Vec2& place) {
    const Vec2 p = asFloat(place);
    const Cell at = cellOf(p);
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto found = cells_.find(keyOf({at.x + dx, at.y + dy}));
        if (found == cells_.end()) continue;
        for (const std::uint32_t id : found->second) {
          if ((points_[id] - p).norm() <= near_) return id;
        }
      }
    }
    const auto id = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    cells_[keyOf(at)].push_back(id);
    return id;
  }
  const std::vector<Vec2>& points() const { return points_; }

 private:
  struct Cell {
    std::int64_t x, y;
  };
  Cell cellOf(const Vec2& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x() / near_)),
            static_cast<std::int64_t>(std::floor(p.y() / near_))};
  }
  static std::uint64_t keyOf(const Cell& c) {
    return static_cast<std::uint64_t>(c.x) * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(c.y);
  }
  double near_;
  std::vector<Vec2> points_;
  std::unordered_map<std::uint64_t, Ids> cells_;
};

/// Puts into edges the points that lie on them, `near` mm off at most.
class EdgeRefiner {
 public:
  EdgeRefiner(const std::vector<Vec2>& points, double near) : points_(points), near_(near) {
    std::vector<Box3> boxes;
    for (const Vec2& p : points) boxes.push_back({Vec3(p.x(), p.y(), 0.0), Vec3(p.x(), p.y(), 0.0)});
    tree_ = BoxTree(boxes);
  }

  /// From u to v, both counted.
  Ids chain(std::uint32_t u, std::uint32_t v) const {
    Ids out{u};
    if (u != v) refine(u, v, 0, out);
    return out;
  }

 private:
  /// Adds what is behind u. An edge that a point bends may come near to others.
  void refine(std::uint32_t u, std::uint32_t v, int depth, Ids& out) const {
    constexpr int kDeepest = 8;
    const Ids between = depth < kDeepest ? pointsOn(u, v) : Ids{};
    std::uint32_t from = u;
    for (const std::uint32_t id : between) {
      refine(from, id, depth + 1, out);
      from = id;
    }
    if (between.empty())
      out.push_back(v);
    else
      refine(from, v, depth + 1, out);
  }

  Ids pointsOn(std::uint32_t u, std::uint32_t v) const {
    const Vec2 &a = points_[u], &b = points_[v], d = b - a;
    Box3 box;
    for (const Vec2& p : {a, b}) box.extend(Vec3(p.x(), p.y(), 0.0));
    std::vector<std::pair<double, std::uint32_t>> between;
    tree_.forEachPlace(box.inflated(near_), [&](std::uint32_t place) {
      const std::uint32_t id = tree_.order()[place];
      if (id == u || id == v || distanceToSegment(points_[id], a, b) > near_) return;
      const double t = (points_[id] - a).dot(d);
      if (t > 0.0 && t < d.squaredNorm()) between.emplace_back(t, id);
    });
    std::sort(between.begin(), between.end());
    Ids out;
    for (const auto& [t, id] : between) out.push_back(id);
    return out;
  }

  const std::vector<Vec2>& points_;
  double near_;
  BoxTree tree_;
};

double nearOf(const LevelSection& lower, const LevelSection& upper) {
  double near = 0.0;
  for (const LevelSection* section : {&lower, &upper}) {
    for (const LevelLoop& loop : section->loops) {
      for (const Vec2& p : loop.points) near = std::max(near, meshStep(p));
    }
  }
  return near;
}

Paths pathsOf(const LevelSection& section, const std::vector<std::uint32_t>& loops, bool reversed) {
  Paths paths;
  for (const std::uint32_t k : loops) {
    Path path = wire_detail::pathOf(section.loops[k].points);
    if (reversed) ClipperLib::ReversePath(path);
    paths.push_back(std::move(path));
  }
  return paths;
}

class StepMaker {
 public:
  StepMaker(const LevelSection& lower, const std::vector<std::uint32_t>& lower_loops,
            const LevelSection& upper, const std::vector<std::uint32_t>& upper_loops)
      : lower_(lower),
        upper_(upper),
        lower_loops_(lower_loops),
        upper_loops_(upper_loops),
        near_(nearOf(lower, upper)) {}

  std::optional<LevelStep> make() {
    ClipperLib::Clipper clipper(ClipperLib::ioPreserveCollinear);
    clipper.AddPaths(pathsOf(lower_, lower_loops_, false), ClipperLib::ptSubject, true);
    clipper.AddPaths(pathsOf(upper_, upper_loops_, true), ClipperLib::ptSubject, true);
    Paths up, down;
    clipper.Execute(ClipperLib::ctUnion, up, ClipperLib::pftPositive, ClipperLib::pftPositive);
    clipper.Execute(ClipperLib::ctUnion, down, ClipperLib::pftNegative, ClipperLib::pftNegative);
    collect();
    for (const Paths* crossed : {&up, &down}) {
      for (const Path& path : *crossed)
        for (const ClipperLib::IntPoint& p : path) table_.of(wire_detail::toMm(p));
    }
    const std::size_t known = table_.points().size();
    const EdgeRefiner refiner(table_.points(), near_);
    out_.z = 0.5 * (lower_.z + upper_.z);
    std::vector<LoopEdge> below, above;
    for (const std::uint32_t k : lower_loops_) out_.lower.push_back(chains(lower_.loops[k], refiner, below));
    for (const std::uint32_t k : upper_loops_) out_.upper.push_back(chains(upper_.loops[k], refiner, above));
    PROVEOUT_ASSERT(table_.points().size() == known);  // the refiner knows no others
    out_.points = table_.points();
    StepFaces faces = stepFaces(out_.points, below, above);
    out_.triangles = std::move(faces.below_alone);
    for (const auto& [a, b, c] : faces.above_alone) out_.triangles.push_back({a, c, b});
    if (!isClosed(below, above)) return std::nullopt;
    return std::move(out_);
  }

 private:
  /// Each edge is used as often in one direction as in the other: walls below have theirs against their
  /// loops.
  bool isClosed(const std::vector<LoopEdge>& below, const std::vector<LoopEdge>& above) const {
    std::map<LoopEdge, int> used;
    const auto use = [&](std::uint32_t a, std::uint32_t b, int times) {
      used[{std::min(a, b), std::max(a, b)}] += a < b ? times : -times;
    };
    for (const auto& [a, b] : below) use(a, b, -1);
    for (const auto& [a, b] : above) use(a, b, 1);
    for (const auto& t : out_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) use(t[k], t[(k + 1) % 3], 1);
    }
    return std::ranges::all_of(used, [](const auto& edge) { return edge.second == 0; });
  }
  void collect() {
    for (const std::uint32_t k : lower_loops_)
      for (const Vec2& p : lower_.loops[k].points) table_.of(p);
    for (const std::uint32_t k : upper_loops_)
      for (const Vec2& p : upper_.loops[k].points) table_.of(p);
  }

  LevelStep::Chains chains(const LevelLoop& loop, const EdgeRefiner& refiner, std::vector<LoopEdge>& edges) {
    LevelStep::Chains out;
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      out.push_back(
          refiner.chain(table_.of(loop.points[k]), table_.of(loop.points[(k + 1) % loop.points.size()])));
    for (std::size_t k = 0; k < out.size(); ++k) leaveOutTip(out[k], out[(k + 1) % out.size()]);
    for (const Ids& chain : out) {
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges.push_back({chain[i], chain[i + 1]});
    }
    return out;
  }

  /// Where both edges at a sharp corner go through one point the walls beyond it would lie on each other.
  static void leaveOutTip(Ids& to, Ids& from) {
    while (to.size() > 1 && from.size() > 1 && to[to.size() - 2] == from[1]) {
      to.pop_back();
      from.erase(from.begin());
    }
  }

  const LevelSection &lower_, &upper_;
  const std::vector<std::uint32_t>&lower_loops_, &upper_loops_;
  double near_;
  PointTable table_{near_};
  LevelStep out_;
};

}  // namespace

std::optional<LevelStep> levelStep(const LevelSection& lower, const std::vector<std::uint32_t>& lower_loops,
                                   const LevelSection& upper, const std::vector<std::uint32_t>& upper_loops) {
  return StepMaker(lower, lower_loops, upper, upper_loops).make();
}

}  // namespace proveout
