#include "removal/wire/lean/crossed_walls.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/mesh/intersections.h"
#include "removal/wire/lean/wall_meetings.h"

namespace proveout {
namespace {

/// Slabs are halved until they are lower than this share of the triangle that stood in them, but not where
/// walls meet, mm: there sections without thin places help.
constexpr double kShare = 0.5, kLowest = 1e-3;
/// Walls that run along each other come equally near at other heights.
constexpr double kFarther = 8.0;
/// Rounding error of float heights, as a share of them.
constexpr double kRounding = 1e-7;

double slackAt(double z) { return kRounding * (1.0 + std::abs(z)); }

bool stands(const CrossedTriangle& t, double low, double high) {
  if (t.box.min.z() < low - slackAt(low) || t.box.max.z() > high + slackAt(high)) return false;
  return high - low > std::max(kLowest, kShare * t.box.size().z());
}

/// Whether edges of a loop, as many as the span has, belong to the wall that the triangle is of.
bool hasEdgeOf(const CrossedTriangle& t, const LevelLoop& loop, const LoopSpan& span) {
  const auto n = static_cast<std::uint32_t>(loop.points.size());
  const Vec2 slack = Vec2::Constant(kRounding * (1.0 + t.box.max.cwiseAbs().maxCoeff()));
  const Vec2 low = t.box.min.head<2>() - slack, high = t.box.max.head<2>() + slack;
  for (std::uint32_t k = 0; k < span.edges; ++k) {
    const std::uint32_t i = (span.first + k) % n;
    if (loop.motions[i] != t.motion) continue;
    const Vec2 &p = loop.points[i], &q = loop.points[(i + 1) % n];
    if ((p.cwiseMin(q).array() <= high.array()).all() && (p.cwiseMax(q).array() >= low.array()).all())
      return true;
  }
  return false;
}

LoopSpan allOf(const LevelLoop& loop) { return {0, static_cast<std::uint32_t>(loop.points.size())}; }

}  // namespace

std::vector<CrossedTriangle> crossedTriangles(const TriMesh& mesh) {
  std::vector<std::uint32_t> crossed;
  for (const auto& [a, b] : wallMeetings(mesh)) crossed.insert(crossed.end(), {a, b});
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  PROVEOUT_ASSERT(mesh.motion.size() == mesh.triangles.size());
  std::vector<CrossedTriangle> out;
  for (const std::uint32_t t : crossed) {
    CrossedTriangle& triangle = out.emplace_back();
    triangle.motion = mesh.motion[t];
    for (const Vec3& p : cornersOf(mesh, t)) triangle.box.extend(p);
  }
  return out;
}

void CrossedWalls::add(const std::vector<CrossedTriangle>& more) {
  triangles_.insert(triangles_.end(), more.begin(), more.end());
  beside_ = beside_ == 0.0 ? kLowest : kFarther * beside_;
}

bool CrossedWalls::at(double z) const {
  return std::any_of(triangles_.begin(), triangles_.end(), [&](const CrossedTriangle& t) {
    const double beside = beside_ + t.box.size().z();
    return t.box.min.z() - z <= beside && z - t.box.max.z() <= beside;
  });
}

bool CrossedWalls::within(double low, double high, const LevelLoop& lower, const LevelLoop& upper) const {
  return within(low, high, lower, allOf(lower), upper, allOf(upper));
}

bool CrossedWalls::within(double low, double high, const LevelLoop& lower, const LoopSpan& lower_span,
                          const LevelLoop& upper, const LoopSpan& upper_span) const {
  return std::any_of(triangles_.begin(), triangles_.end(), [&](const CrossedTriangle& t) {
    return !t.isLevel() && stands(t, low, high) &&
           (hasEdgeOf(t, lower, lower_span) || hasEdgeOf(t, upper, upper_span));
  });
}

}  // namespace proveout
