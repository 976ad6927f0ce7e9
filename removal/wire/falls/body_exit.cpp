#include "removal/wire/falls/body_exit.h"

#include <algorithm>
#include <polyclipping/clipper.hpp>
#include <vector>

#include "core/base/assert.h"
#include "removal/wire/falls/wire_holding.h"
#include "removal/wire/section/kerf_union.h"

namespace proveout {
namespace {

using ClipperLib::Paths;

constexpr double kPasses = 1e-3;  ///< mm
constexpr std::size_t kMostHeights = 9;

Paths pathsOf(const PlanePolygons& outline) {
  Paths paths;
  for (const std::vector<Vec2>& loop : outline) paths.push_back(wire_detail::pathOf(loop));
  return paths;
}

bool overlap(const Paths& a, const Paths& b) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(a, ClipperLib::ptSubject, true);
  clipper.AddPaths(b, ClipperLib::ptClip, true);
  Paths both;
  clipper.Execute(ClipperLib::ctIntersection, both, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return std::any_of(both.begin(), both.end(), [](const ClipperLib::Path& path) {
    return ClipperLib::Orientation(path) && wire_detail::meanThickness(path) > kPasses;
  });
}

}  // namespace

BodyExit exitOf(const LeanSolid& solid, std::size_t body, const LeanSolid& past_solid, std::size_t past) {
  PROVEOUT_ASSERT(body < solid.bodies.size() && past < past_solid.bodies.size());
  const std::size_t levels = solid.levels.size(), count = std::min(levels, kMostHeights);
  std::vector<Paths> own, other;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t level = count > 1 ? k * (levels - 1) / (count - 1) : 0;
    own.push_back(pathsOf(outlineOf(solid, body, solid.levels[level].z)));
    other.push_back(pathsOf(outlineOf(past_solid, past, solid.levels[level].z)));
  }
  BodyExit exit;
  for (std::size_t low = 0; low < count; ++low) {
    for (std::size_t high = low + 1; high < count; ++high) {
      exit.down = exit.down && !overlap(own[high], other[low]);
      exit.up = exit.up && !overlap(own[low], other[high]);
    }
  }
  return exit;
}

}  // namespace proveout
