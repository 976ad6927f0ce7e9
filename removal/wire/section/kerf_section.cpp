#include "removal/wire/section/kerf_section.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/parallel_for.h"
#include "removal/wire/section/edge_curves.h"
#include "removal/wire/section/kerf_outline.h"
#include "removal/wire/section/kerf_union.h"

namespace proveout {
namespace {

using namespace wire_detail;
using ClipperLib::Clipper;
using ClipperLib::Path;
using ClipperLib::Paths;

/// One task finds the curves of so many edges.
constexpr std::size_t kEdgesATask = 512;

/// Short runs of stretches that follow each other.
std::vector<std::span<const WireStretch>> batchesOf(const std::vector<WireStretch>& stretches) {
  std::vector<std::span<const WireStretch>> batches;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const bool goes_on =
        i > 0 && batches.back().size() < kOutlineStretches && follows(stretches[i - 1], stretches[i]);
    if (goes_on)
      batches.back() = {batches.back().data(), batches.back().size() + 1};
    else
      batches.emplace_back(&stretches[i], 1);
  }
  return batches;
}

Paths kerfOf(const std::vector<WireStretch>& stretches) {
  const std::vector<std::span<const WireStretch>> batches = batchesOf(stretches);
  std::vector<Paths> parts(batches.size());
  parallelFor(std::size_t{0}, batches.size(),
              [&](std::size_t i) { parts[i] = united({kerfOutline(batches[i])}); });
  return unitedInLevels(std::move(parts));
}

Paths commonOf(const std::vector<PlaneLoop>& blank, const Path& path) {
  Clipper meeting;
  meeting.AddPaths(pathsOf(blank, kKerfChordMm), ClipperLib::ptSubject, true);
  meeting.AddPath(path, ClipperLib::ptClip, true);
  Paths met;
  meeting.Execute(ClipperLib::ctIntersection, met, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return met;
}

std::vector<Vec2> pointsOf(const Path& path) {
  std::vector<Vec2> points;
  points.reserve(path.size());
  for (const ClipperLib::IntPoint& p : path) points.push_back(toMm(p));
  return points;
}

PlaneLoop loopOf(const Path& path, const CurveFinder& finder) {
  const std::vector<Vec2> points = pointsOf(path);
  const std::size_t n = points.size(), tasks = (n + kEdgesATask - 1) / kEdgesATask;
  std::vector<EdgeCurve> curves(n);
  parallelFor(std::size_t{0}, tasks, [&](std::size_t task) {
    for (std::size_t i = task * kEdgesATask; i < std::min(n, (task + 1) * kEdgesATask); ++i)
      curves[i] = finder.of(0.5 * (points[i] + points[(i + 1) % n]));
  });
  return curvedLoop(points, curves);
}

/// The largest first; of equal ones the one farther left and lower.
bool comesFirst(const PlaneBody& a, const PlaneBody& b) {
  if (a.area_mm2 != b.area_mm2) return a.area_mm2 > b.area_mm2;
  const Vec2 &p = a.loops.front().edges.front().from, &q = b.loops.front().edges.front().from;
  return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
}

}  // namespace

std::vector<PlaneBody> cutSection(const std::vector<PlaneLoop>& blank,
                                  const std::vector<WireStretch>& stretches) {
  const CurveFinder finder(blank, stretches);
  std::vector<PlaneBody> bodies;
  for (const PathRegion& region : regionsLeft(pathsOf(blank, kKerfChordMm), kerfOf(stretches))) {
    PlaneBody body;
    for (const Path& path : region) body.loops.push_back(loopOf(path, finder));
    body.area_mm2 = areaOf(body.loops);
    bodies.push_back(std::move(body));
  }
  std::sort(bodies.begin(), bodies.end(), comesFirst);
  return bodies;
}

std::vector<std::vector<std::vector<Vec2>>> regionsInside(const Box3& window,
                                                          const std::vector<PlaneLoop>& blank,
                                                          const std::vector<WireStretch>& stretches) {
  const PlaneLoop border = rectangleLoop(window.min.head<2>(), window.max.head<2>());
  std::vector<std::vector<std::vector<Vec2>>> regions;
  for (const PathRegion& region :
       regionsLeft(commonOf(blank, pathsOf({border}, kKerfChordMm).front()), kerfOf(stretches))) {
    std::vector<std::vector<Vec2>>& loops = regions.emplace_back();
    for (const Path& path : region) loops.push_back(pointsOf(path));
  }
  return regions;
}

std::vector<std::vector<Vec2>> metBy(const WireStretch& stretch, const std::vector<PlaneLoop>& blank,
                                     const std::vector<WireStretch>& earlier, double thickness_mm) {
  Paths left;
  Clipper less;
  less.AddPaths(commonOf(blank, kerfOutline({&stretch, 1})), ClipperLib::ptSubject, true);
  less.AddPaths(kerfOf(earlier), ClipperLib::ptClip, true);
  less.Execute(ClipperLib::ctDifference, left, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<std::vector<Vec2>> out;
  for (const Path& path : left) {
    if (!ClipperLib::Orientation(path) || meanThickness(path) < thickness_mm) continue;
    out.push_back(pointsOf(path));
  }
  return out;
}

}  // namespace proveout
