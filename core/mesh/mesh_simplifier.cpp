#include "core/mesh/mesh_simplifier.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/base/stretches.h"
#include "core/mesh/crowded_places.h"
#include "core/mesh/edge_collapser.h"
#include "core/mesh/intersections.h"
#include "core/mesh/mean_edge.h"

namespace proveout {
namespace {

/// Places where triangles run through each other, with their surroundings.
std::vector<Box3> meetingPlaces(const TriMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                double reach) {
  std::vector<Box3> places;
  for (const auto& pair : pairs) {
    std::array<Box3, 2> box;
    for (int i = 0; i < 2; ++i) {
      for (const Vec3& corner : cornersOf(mesh, pair[i])) box[i].extend(corner);
    }
    places.push_back(Box3{box[0].min.cwiseMax(box[1].min), box[0].max.cwiseMin(box[1].max)}.inflated(reach));
  }
  return places;
}

/// Flags the vertices that are there. False: all had a flag.
bool freeze(const TriMesh& mesh, const std::vector<Box3>& places, std::vector<std::uint8_t>& frozen) {
  frozen.resize(mesh.positions.size(), 0);
  const auto before = std::count(frozen.begin(), frozen.end(), 1);
  forEachBelow(mesh.positions.size(), [&](std::size_t v) {
    const Vec3 p = mesh.positions[v].cast<double>();
    if (std::ranges::any_of(places, [&](const Box3& place) { return place.overlaps({p, p}); })) frozen[v] = 1;
  });
  return std::count(frozen.begin(), frozen.end(), 1) > before;
}

}  // namespace

std::optional<Simplification> simplifyMesh(TriMesh& mesh, double tolerance_mm, const Progress& progress,
                                           std::span<const float> off_mm) {
  Simplification out;
  if (!(tolerance_mm > 0.0) || mesh.triangles.empty()) return out;
  constexpr int kMostRuns = 6;
  const double reach = std::max(2.0 * tolerance_mm, meanEdge(mesh));
  std::vector<std::uint8_t> frozen;
  TriMesh simplified;
  for (int run = 0; run < kMostRuns; ++run) {
    EdgeCollapser collapser(mesh, tolerance_mm, frozen, off_mm);
    if (!collapser.run(progress)) return std::nullopt;
    simplified = collapser.result();
    out.distance_mm = collapser.distance();
    const auto pairs =
        findIntersectionsAmong(simplified, trianglesInCrowdedPlaces(simplified, out.distance_mm));
    out.self_intersections = pairs.size();
    // What runs through itself where nothing was simplified did so before.
    if (pairs.empty() || !freeze(mesh, meetingPlaces(simplified, pairs, reach), frozen)) break;
  }
  mesh = std::move(simplified);
  return out;
}

}  // namespace proveout
