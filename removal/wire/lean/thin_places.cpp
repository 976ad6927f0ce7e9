#include "removal/wire/lean/thin_places.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/plane.h"
#include "removal/wire/section/kerf_outline.h"
#include "removal/wire/section/order_tree.h"

namespace proveout::wire_detail {
namespace {

using ClipperLib::ClipperOffset;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Steps of a mesh that walls keep apart: corners that stand back from each other then pass no other wall.
constexpr double kWidthSteps = 6.0;
/// Edges nearer to each other than this many widths, along their loop, are neighbours.
constexpr double kNeighbours = 4.0;
/// Offsets are made in so many parts of a nanometre.
constexpr double kParts = 64.0;
/// Corners sharper than 2 asin(1 / this) become blunt.
constexpr double kMiter = 6.0;

/// An edge of a section.
struct Edge {
  Vec2 from, to;
  std::size_t loop;
  double start;  ///< along its loop, mm
  double end() const { return start + (to - from).norm(); }
};

double apart(const Edge& a, const Edge& b) {
  return std::min(std::min(distanceToSegment(a.from, b.from, b.to), distanceToSegment(a.to, b.from, b.to)),
                  std::min(distanceToSegment(b.from, a.from, a.to), distanceToSegment(b.to, a.from, a.to)));
}

/// The way from the end of one to the start of the other, the shorter one round the loop.
double between(const Edge& a, const Edge& b, double round) {
  const auto [first, second] = a.start < b.start ? std::pair(&a, &b) : std::pair(&b, &a);
  return std::min(second->start - first->end(), first->start + round - second->end());
}

Paths scaled(const std::vector<PathRegion>& regions) {
  Paths out;
  for (const PathRegion& region : regions) {
    for (const Path& path : region) {
      Path& more = out.emplace_back(path);
      for (ClipperLib::IntPoint& p : more) {
        p.X *= static_cast<ClipperLib::cInt>(kParts);
        p.Y *= static_cast<ClipperLib::cInt>(kParts);
      }
    }
  }
  return out;
}

Paths offset(const Paths& paths, double parts) {
  ClipperOffset offset(kMiter);
  offset.AddPaths(paths, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  Paths out;
  offset.Execute(out, parts);
  return out;
}

}  // namespace

double leastWidth(const std::vector<LevelLoop>& loops) {
  double step = 0.0;
  for (const LevelLoop& loop : loops) {
    for (const Vec2& p : loop.points) step = std::max(step, meshStep(p));
  }
  return kWidthSteps * step;
}

bool hasThinPlaces(const std::vector<LevelLoop>& loops, double width) {
  std::vector<Edge> edges;
  std::vector<double> round(loops.size(), 0.0);
  std::vector<Box3> boxes;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const std::vector<Vec2>& points = loops[k].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Edge& edge = edges.emplace_back(Edge{points[i], points[(i + 1) % points.size()], k, round[k]});
      round[k] = edge.end();
      Box3 box;
      for (const Vec2& p : {edge.from, edge.to}) box.extend(Vec3(p.x(), p.y(), 0.0));
      boxes.push_back(box.inflated(0.5 * width));
    }
  }
  bool found = false;
  OrderTree(std::move(boxes)).eachPair([&](std::size_t i, std::size_t k) {
    if (found || i == k) return;
    const Edge &a = edges[i], &b = edges[k];
    if (a.loop == b.loop && between(a, b, round[a.loop]) < kNeighbours * width) return;
    found = apart(a, b) < width;
  });
  return found;
}

std::vector<PathRegion> withoutThinPlaces(const std::vector<PathRegion>& regions, double width) {
  const double parts = 0.5 * width / kUnit * kParts;
  Paths paths = offset(offset(offset(scaled(regions), -parts), 2.0 * parts), -parts);
  for (Path& path : paths) {
    for (ClipperLib::IntPoint& p : path) {
      p.X = std::llround(static_cast<double>(p.X) / kParts);
      p.Y = std::llround(static_cast<double>(p.Y) / kParts);
    }
  }
  return regionsLeft(paths, {});
}

}  // namespace proveout::wire_detail
