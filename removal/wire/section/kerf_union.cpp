#include "removal/wire/section/kerf_union.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/parallel_for.h"
#include "removal/wire/section/kerf_outline.h"
#include "removal/wire/section/kerf_section.h"

namespace proveout::wire_detail {
namespace {

using ClipperLib::Clipper;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Outlines that are united at once.
constexpr std::size_t kJoinedAtOnce = 12;

std::vector<PathRegion> regionsOf(const ClipperLib::PolyTree& tree) {
  std::vector<PathRegion> regions;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole() || meanThickness(node->Contour) < kThinRegionMm) continue;
    PathRegion region{node->Contour};
    for (const ClipperLib::PolyNode* hollow : node->Childs) {
      if (meanThickness(hollow->Contour) >= kThinRegionMm) region.push_back(hollow->Contour);
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace

Paths united(const Paths& paths) {
  Clipper clipper(ClipperLib::ioPreserveCollinear);
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  Paths out;
  clipper.Execute(ClipperLib::ctUnion, out, ClipperLib::pftPositive, ClipperLib::pftPositive);
  return out;
}

Paths unitedInLevels(std::vector<Paths> parts) {
  while (parts.size() > kJoinedAtOnce) {
    std::vector<Paths> joined((parts.size() + kJoinedAtOnce - 1) / kJoinedAtOnce);
    parallelFor(std::size_t{0}, joined.size(), [&](std::size_t i) {
      Paths some;
      for (std::size_t k = i * kJoinedAtOnce; k < std::min(parts.size(), (i + 1) * kJoinedAtOnce); ++k)
        std::move(parts[k].begin(), parts[k].end(), std::back_inserter(some));
      joined[i] = united(some);
    });
    parts = std::move(joined);
  }
  Paths all;
  for (Paths& part : parts) std::move(part.begin(), part.end(), std::back_inserter(all));
  return all;
}

Path pathOf(const std::vector<Vec2>& points) {
  Path path;
  path.reserve(points.size());
  for (const Vec2& p : points) path.push_back(toUnits(p));
  return path;
}

Paths pathsOf(const std::vector<PlaneLoop>& loops, double tolerance) {
  Paths paths;
  for (const PlaneLoop& loop : loops) paths.push_back(pathOf(chordsOf(loop, tolerance).points));
  return paths;
}

double meanThickness(const Path& path) {
  double around = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i)
    around += (toMm(path[(i + 1) % path.size()]) - toMm(path[i])).norm();
  return around > 0.0 ? 2.0 * std::abs(ClipperLib::Area(path)) * kUnit * kUnit / around : 0.0;
}

std::vector<PathRegion> regionsLeft(const Paths& blank, const Paths& kerf) {
  Clipper clipper(ClipperLib::ioPreserveCollinear);
  clipper.AddPaths(blank, ClipperLib::ptSubject, true);
  clipper.AddPaths(kerf, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return regionsOf(tree);
}

}  // namespace proveout::wire_detail
