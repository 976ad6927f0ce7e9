#include "removal/wire/level_step.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <polyclipping/clipper.hpp>
#include <unordered_map>

#include "core/geometry/box_tree.h"
#include "core/geometry/plane.h"
#include "removal/wire/face_triangles.h"
#include "removal/wire/kerf_outline.h"
#include "removal/wire/kerf_union.h"

namespace proveout {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;
using Ids = std::vector<std::uint32_t>;

/// Points nearer to each other, or to an edge, are one, or on it: mm. The clipper rounds crossings to
/// nanometres.
constexpr double kNear = 3e-6;

/// Points by their place: near ones are one.
class PointTable {
 public:
  std::uint32_t of(const Vec2& p) {
    const Cell at = cellOf(p);
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto found = cells_.find(keyOf({at.x + dx, at.y + dy}));
        if (found == cells_.end()) continue;
        for (const std::uint32_t id : found->second) {
          if ((points_[id] - p).norm() <= kNear) return id;
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
  static Cell cellOf(const Vec2& p) {
    return {static_cast<std::int64_t>(std::floor(p.x() / kNear)),
            static_cast<std::int64_t>(std::floor(p.y() / kNear))};
  }
  static std::uint64_t keyOf(const Cell& c) {
    return static_cast<std::uint64_t>(c.x) * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(c.y);
  }
  std::vector<Vec2> points_;
  std::unordered_map<std::uint64_t, Ids> cells_;
};

/// Puts into edges the points that lie on them.
class EdgeRefiner {
 public:
  explicit EdgeRefiner(const std::vector<Vec2>& points) : points_(points) {
    std::vector<Box3> boxes;
    for (const Vec2& p : points) boxes.push_back({Vec3(p.x(), p.y(), 0.0), Vec3(p.x(), p.y(), 0.0)});
    tree_ = BoxTree(boxes);
  }

  /// From u to v, both counted.
  Ids chain(std::uint32_t u, std::uint32_t v) const {
    const Vec2 &a = points_[u], &b = points_[v], d = b - a;
    Box3 box;
    for (const Vec2& p : {a, b}) box.extend(Vec3(p.x(), p.y(), 0.0));
    std::vector<std::pair<double, std::uint32_t>> between;
    tree_.forEachPlace(box.inflated(kNear), [&](std::uint32_t place) {
      const std::uint32_t id = tree_.order()[place];
      if (id == u || id == v || distanceToSegment(points_[id], a, b) > kNear) return;
      const double t = (points_[id] - a).dot(d);
      if (t > 0.0 && t < d.squaredNorm()) between.emplace_back(t, id);
    });
    std::sort(between.begin(), between.end());
    Ids out{u};
    for (const auto& [t, id] : between) out.push_back(id);
    out.push_back(v);
    return out;
  }

 private:
  const std::vector<Vec2>& points_;
  BoxTree tree_;
};

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
      : lower_(lower), upper_(upper), lower_loops_(lower_loops), upper_loops_(upper_loops) {}

  std::optional<LevelStep> make() {
    ClipperLib::Clipper clipper(ClipperLib::ioPreserveCollinear);
    clipper.AddPaths(pathsOf(lower_, lower_loops_, false), ClipperLib::ptSubject, true);
    clipper.AddPaths(pathsOf(upper_, upper_loops_, true), ClipperLib::ptSubject, true);
    ClipperLib::PolyTree up, down;
    clipper.Execute(ClipperLib::ctUnion, up, ClipperLib::pftPositive, ClipperLib::pftPositive);
    clipper.Execute(ClipperLib::ctUnion, down, ClipperLib::pftNegative, ClipperLib::pftNegative);
    collect();
    collect(up);
    collect(down);
    const EdgeRefiner refiner(table_.points());
    out_.z = 0.5 * (lower_.z + upper_.z);
    for (const std::uint32_t k : lower_loops_) out_.lower.push_back(chains(lower_.loops[k], refiner, -1));
    for (const std::uint32_t k : upper_loops_) out_.upper.push_back(chains(upper_.loops[k], refiner, 1));
    out_.points = table_.points();
    faces(up, refiner, true);
    faces(down, refiner, false);
    const bool closed = std::all_of(used_.begin(), used_.end(), [](const auto& e) { return e.second == 0; });
    if (!closed) return std::nullopt;
    return std::move(out_);
  }

 private:
  void collect() {
    for (const std::uint32_t k : lower_loops_)
      for (const Vec2& p : lower_.loops[k].points) table_.of(p);
    for (const std::uint32_t k : upper_loops_)
      for (const Vec2& p : upper_.loops[k].points) table_.of(p);
  }
  void collect(const ClipperLib::PolyTree& tree) {
    for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext())
      for (const ClipperLib::IntPoint& p : node->Contour) table_.of(wire_detail::toMm(p));
  }

  /// Each edge is used as often in one direction as in the other when the surface is closed.
  void use(std::uint32_t a, std::uint32_t b, int times) {
    if (a == b) return;
    used_[{std::min(a, b), std::max(a, b)}] += a < b ? times : -times;
  }

  LevelStep::Chains chains(const LevelLoop& loop, const EdgeRefiner& refiner, int times) {
    LevelStep::Chains out;
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      const std::uint32_t u = table_.of(loop.points[k]),
                          v = table_.of(loop.points[(k + 1) % loop.points.size()]);
      out.push_back(u == v ? Ids{u} : refiner.chain(u, v));
      for (std::size_t i = 0; i + 1 < out.back().size(); ++i) use(out.back()[i], out.back()[i + 1], times);
    }
    return out;
  }

  Ids ring(const Path& path, const EdgeRefiner& refiner) {
    Ids ids;
    for (std::size_t k = 0; k < path.size(); ++k) {
      const std::uint32_t u = table_.of(wire_detail::toMm(path[k])),
                          v = table_.of(wire_detail::toMm(path[(k + 1) % path.size()]));
      if (u == v) continue;
      const Ids chain = refiner.chain(u, v);
      ids.insert(ids.end(), chain.begin(), chain.end() - 1);
    }
    return ids;
  }

  void faces(const ClipperLib::PolyTree& tree, const EdgeRefiner& refiner, bool looks_up) {
    for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
      if (node->IsHole()) continue;
      std::vector<std::vector<Vec2>> loops;
      Ids corner;
      const auto add = [&](const Path& path) {
        const Ids ids = ring(path, refiner);
        if (ids.size() < 3) return;
        std::vector<Vec2>& points = loops.emplace_back();
        for (const std::uint32_t id : ids) points.push_back(out_.points[id]);
        corner.insert(corner.end(), ids.begin(), ids.end());
        for (std::size_t i = 0; i < ids.size(); ++i)
          use(ids[i], ids[(i + 1) % ids.size()], looks_up ? 1 : -1);
      };
      add(node->Contour);
      if (loops.empty()) continue;
      for (const ClipperLib::PolyNode* hollow : node->Childs) add(hollow->Contour);
      for (const auto& [a, b, c] : faceTriangles(loops)) {
        if (corner[a] == corner[b] || corner[b] == corner[c] || corner[c] == corner[a]) continue;
        out_.triangles.push_back({corner[a], corner[looks_up ? b : c], corner[looks_up ? c : b]});
      }
    }
  }

  const LevelSection &lower_, &upper_;
  const std::vector<std::uint32_t>&lower_loops_, &upper_loops_;
  PointTable table_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> used_;
  LevelStep out_;
};

}  // namespace

std::optional<LevelStep> levelStep(const LevelSection& lower, const std::vector<std::uint32_t>& lower_loops,
                                   const LevelSection& upper, const std::vector<std::uint32_t>& upper_loops) {
  return StepMaker(lower, lower_loops, upper, upper_loops).make();
}

}  // namespace proveout
