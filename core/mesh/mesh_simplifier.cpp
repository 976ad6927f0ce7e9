#include "core/mesh/mesh_simplifier.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/mesh/crowded_places.h"
#include "core/mesh/edge_collapser.h"
#include "core/mesh/intersections.h"
#include "core/mesh/mean_edge.h"

namespace proveout {
namespace {

/// Flags the vertices that are there. False: all had a flag.
bool freeze(const TriMesh& mesh, const std::vector<Box3>& places, std::vector<std::uint8_t>& frozen) {
  frozen.resize(mesh.positions.size(), 0);
  const auto before = std::count(frozen.begin(), frozen.end(), 1);
  flagInside(mesh, places, frozen);
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
