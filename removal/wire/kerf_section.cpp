#include "removal/wire/kerf_section.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/parallel_for.h"
#include "removal/wire/edge_curves.h"
#include "removal/wire/kerf_outline.h"

namespace proveout {
namespace {

using namespace wire_detail;
using ClipperLib::Clipper;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Stretches whose outline is one polygon: its crossings grow with the square of what overlaps.
constexpr std::size_t kAtOnce = 48;
/// Outlines that are united at once.
constexpr std::size_t kJoinedAtOnce = 12;
/// Edges whose curves are looked for by one task.
constexpr std::size_t kEdgesATask = 512;

Paths united(const Paths& paths) {
  Clipper clipper(ClipperLib::ioPreserveCollinear);
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  Paths out;
  clipper.Execute(ClipperLib::ctUnion, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return out;
}

/// Short runs of stretches that follow each other.
std::vector<std::span<const WireStretch>> batchesOf(const std::vector<WireStretch>& stretches) {
  std::vector<std::span<const WireStretch>> batches;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const bool goes_on = i > 0 && batches.back().size() < kAtOnce && follows(stretches[i - 1], stretches[i]);
    if (goes_on)
      batches.back() = {batches.back().data(), batches.back().size() + 1};
    else
      batches.emplace_back(&stretches[i], 1);
  }
  return batches;
}

/// Neighbours are united in levels: where the library joins two outlines it walks both, so that many small
/// ones with a long one would take the square of their number.
Paths kerfOf(const std::vector<WireStretch>& stretches) {
  const std::vector<std::span<const WireStretch>> batches = batchesOf(stretches);
  std::vector<Paths> parts(batches.size());
  parallelFor(std::size_t{0}, batches.size(),
              [&](std::size_t i) { parts[i] = united({kerfOutline(batches[i])}); });
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

Paths pathsOf(const std::vector<PlaneLoop>& loops) {
  Paths paths;
  for (const PlaneLoop& loop : loops) {
    Path path;
    for (const Vec2& p : chordsOf(loop, kKerfChordMm).points) path.push_back(toUnits(p));
    paths.push_back(std::move(path));
  }
  return paths;
}

double meanThickness(const Path& path) {
  double around = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i)
    around += (toMm(path[(i + 1) % path.size()]) - toMm(path[i])).norm();
  return around > 0.0 ? 2.0 * std::abs(ClipperLib::Area(path)) * kUnit * kUnit / around : 0.0;
}

/// Loops of one region, its border first, as polygons.
using Region = std::vector<Path>;

std::vector<Region> regionsOf(const ClipperLib::PolyTree& tree) {
  std::vector<Region> regions;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole() || meanThickness(node->Contour) < kThinRegionMm) continue;
    Region region{node->Contour};
    for (const ClipperLib::PolyNode* hollow : node->Childs) {
      if (meanThickness(hollow->Contour) >= kThinRegionMm) region.push_back(hollow->Contour);
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

PlaneLoop loopOf(const Path& path, const CurveFinder& finder) {
  std::vector<Vec2> points;
  points.reserve(path.size());
  for (const ClipperLib::IntPoint& p : path) points.push_back(toMm(p));
  const std::size_t n = points.size(), tasks = (n + kEdgesATask - 1) / kEdgesATask;
  std::vector<EdgeCurve> curves(n);
  parallelFor(std::size_t{0}, tasks, [&](std::size_t task) {
    for (std::size_t i = task * kEdgesATask; i < std::min(n, (task + 1) * kEdgesATask); ++i)
      curves[i] = finder.of(0.5 * (points[i] + points[(i + 1) % n]));
  });
  return curvedLoop(points, curves);
}

/// The largest first; of equals that farther left and below.
bool comesFirst(const PlaneBody& a, const PlaneBody& b) {
  if (a.area_mm2 != b.area_mm2) return a.area_mm2 > b.area_mm2;
  const Vec2 &p = a.loops.front().edges.front().from, &q = b.loops.front().edges.front().from;
  return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
}

}  // namespace

std::vector<PlaneBody> cutSection(const std::vector<PlaneLoop>& blank,
                                  const std::vector<WireStretch>& stretches) {
  Clipper clipper(ClipperLib::ioPreserveCollinear);
  clipper.AddPaths(pathsOf(blank), ClipperLib::ptSubject, true);
  clipper.AddPaths(kerfOf(stretches), ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  const CurveFinder finder(blank, stretches);
  std::vector<PlaneBody> bodies;
  for (const Region& region : regionsOf(tree)) {
    PlaneBody body;
    for (const Path& path : region) body.loops.push_back(loopOf(path, finder));
    body.area_mm2 = areaOf(body.loops);
    bodies.push_back(std::move(body));
  }
  std::sort(bodies.begin(), bodies.end(), comesFirst);
  return bodies;
}

std::vector<std::vector<Vec2>> metBy(const WireStretch& stretch, const std::vector<PlaneLoop>& blank,
                                     const std::vector<WireStretch>& earlier, double thickness_mm) {
  Clipper meeting;
  meeting.AddPaths(pathsOf(blank), ClipperLib::ptSubject, true);
  meeting.AddPath(kerfOutline({&stretch, 1}), ClipperLib::ptClip, true);
  Paths met, left;
  meeting.Execute(ClipperLib::ctIntersection, met, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  Clipper less;
  less.AddPaths(met, ClipperLib::ptSubject, true);
  less.AddPaths(kerfOf(earlier), ClipperLib::ptClip, true);
  less.Execute(ClipperLib::ctDifference, left, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<std::vector<Vec2>> out;
  for (const Path& path : left) {
    if (!ClipperLib::Orientation(path) || meanThickness(path) < thickness_mm) continue;
    out.emplace_back();
    for (const ClipperLib::IntPoint& p : path) out.back().push_back(toMm(p));
  }
  return out;
}

}  // namespace proveout
