#include "removal/turning/section/section_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/base/assert.h"
#include "core/geometry/plane.h"

namespace proveout {
namespace {

/// Squares looked at before the best is taken: pieces of even depth along a path could be divided without
/// end.
constexpr int kMostSquares = 4000;

/// Distance to the outline, negative outside.
double inside(const std::vector<Vec2>& outline, const Vec2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool within = false;
  for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++) {
    const Vec2 &a = outline[k], &b = outline[i], way = b - a;
    nearest = std::min(nearest, distanceToSegment(p, a, b));
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / way.y() * way.x())
      within = !within;
  }
  return within ? nearest : -nearest;
}

struct Square {
  double bound;  ///< nothing in it lies deeper, mm
  Vec2 middle;
  double half;
  bool operator<(const Square& other) const { return bound < other.bound; }
};

}  // namespace

/// Squares are divided where the piece may lie deeper than the best point so far: the depth changes no faster
/// than the place.
SectionDepth deepestPoint(const SectionArea& area, const std::vector<Vec2>& outline) {
  PROVEOUT_ASSERT(!outline.empty());
  SectionDepth best;
  Vec2 low = outline.front(), high = outline.front();
  const auto take = [&](const Vec2& p, double depth) {
    if (depth > best.depth_mm) best = {depth, p};
  };
  for (const Vec2& p : outline) {
    take(p, area.depthOf(p));
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::priority_queue<Square> squares;
  const auto add = [&](const Vec2& middle, double half) {
    const double reach = std::sqrt(2.0) * half, within = inside(outline, middle);
    if (within <= -reach) return;
    const double depth = area.depthOf(middle);
    if (within >= 0.0) take(middle, depth);
    if (depth + reach > best.depth_mm + kSectionDepthMm) squares.push({depth + reach, middle, half});
  };
  const double half = std::max(0.5 * (high - low).minCoeff(), 0.01 * (high - low).maxCoeff());
  for (double r = low.x() + half; r < high.x() + half; r += 2.0 * half) {
    for (double z = low.y() + half; z < high.y() + half; z += 2.0 * half) add({r, z}, half);
  }
  for (int count = 0; !squares.empty() && count < kMostSquares; ++count) {
    const Square square = squares.top();
    squares.pop();
    if (square.bound <= best.depth_mm + kSectionDepthMm) break;
    for (const double dr : {-0.5, 0.5}) {
      for (const double dz : {-0.5, 0.5}) add(square.middle + square.half * Vec2(dr, dz), 0.5 * square.half);
    }
  }
  return best;
}

namespace {

/// Edges that lie on the surface of the area are nearer to it than this, mm.
constexpr double kOnSurface = 1e-4;
/// Parts of a long edge of the old surface that are looked at.
constexpr int kParts = 8;

}  // namespace

SectionDepth contactDepth(const SectionArea& area, const std::vector<Vec2>& outline) {
  SectionDepth best = deepestPoint(area, outline);
  std::vector<std::size_t> old_edges, new_edges;
  const auto next = [&](std::size_t i) { return outline[(i + 1) % outline.size()]; };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const bool old = area.depthOf(0.5 * (outline[i] + next(i))) < kOnSurface;
    (old ? old_edges : new_edges).push_back(i);
  }
  if (new_edges.empty()) return best;
  for (const std::size_t i : old_edges) {
    for (int k = 0; k < kParts; ++k) {
      const Vec2 p = outline[i] + (next(i) - outline[i]) * k / kParts;
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::size_t j : new_edges)
        nearest = std::min(nearest, distanceToSegment(p, outline[j], next(j)));
      if (nearest > best.depth_mm) best = {nearest, p};
    }
  }
  return best;
}

}  // namespace proveout
