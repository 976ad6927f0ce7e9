// Dual contouring: one vertex per sheet and cell, one polygon per crossed grid edge. Each step takes what the
// step before it gives.
#include "removal/surface/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/memory.h"
#include "core/base/thread_limit.h"
#include "core/geometry/to_float.h"
#include "core/mesh/crowded_places.h"
#include "core/mesh/intersections.h"
#include "core/mesh/mesh_simplifier.h"
#include "removal/surface/measure/leaf_volume.h"
#include "removal/surface/measure/unseen_volume.h"
#include "removal/surface/repair/mesh_repair.h"
#include "removal/surface/repair/surface_sharpen.h"

namespace proveout {
namespace {

/// Part of the tolerance that the heights of a merged patch may take: a triangle between the middles of
/// patches leaves the surface as much as each patch leaves its plane, and normals turn in between.
constexpr double kFlatnessShare = 0.5;
/// Part of it by which feature edges between the vertices may be cut off.
constexpr double kSharpShare = 0.5;
constexpr double kDefaultTolerance = 0.1;  ///< of the grid spacing
/// Part of the tolerance that merging cells may take. The rest is for the mesh made of them, and all of it
/// where nothing was merged.
constexpr double kMergingShare = 0.5;
/// Where a finished mesh intersects itself, all triangles within kDoubtCells are checked and parted when it
/// is made again, in at most kDoubtRounds; in the last one it is not simplified.
constexpr double kDoubtCells = 2.0;
constexpr int kDoubtRounds = 5;

/// Grid steps.
double flatnessOf(const Stock::Impl& impl, double simplify_mm) {
  return kFlatnessShare * simplify_mm / impl.h;
}

/// The cells with their vertices in place. Errors: cancelled; a hole in the grid.
Result<SurfaceGrid> placedCells(const Stock::Impl& impl, double flatness, Progress& progress) {
  SurfaceGrid grid(impl, flatness);
  if (!grid.build(progress)) return gridHole();
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  repairFolds(grid);
  PROVEOUT_ASSERT_DEAR(verticesInReach(grid));
  return grid;
}

/// `simplify_mm`: what merging may take. `doubts`: see repairedMesh. `merged`: see RepairedMesh.
Result<StockSurface> meshSurface(const Stock::Impl& impl, double simplify_mm, const std::vector<Box3>& doubts,
                                 std::vector<std::uint8_t>& merged, Progress& progress) {
  const Error interrupted{ErrorKind::kInterrupted, "interrupted"};
  const double flatness = flatnessOf(impl, simplify_mm);
  progress.report("meshing", 0.0);
  Result<SurfaceGrid> grid = placedCells(impl, flatness, progress);
  if (!grid.ok()) return grid.error();
  const std::size_t thin_cells = grid->countThin();
  VertexMerger merger(*grid, flatness);
  progress.report("meshing", 0.4);
  const QuadPlanner planner(*grid, merger, std::max(kFanHeight, 0.5 * simplify_mm / impl.h));
  Result<MeasuredLeaves> measured = measureLeaves(*grid, planner, progress);
  if (!measured.ok()) return measured.error();
  progress.report("meshing", 0.7);
  const UnseenVolume unseen = unseenVolume(*grid, progress);
  auto repaired = repairedMesh(*grid, merger, planner, std::move(measured->quads), doubts, progress);
  if (!repaired) return interrupted;
  if (impl.field != nullptr)
    sharpenMesh(repaired->mesh, *impl.field, impl.h, kSharpShare * simplify_mm, progress);
  if (progress.cancelled()) return interrupted;
  PROVEOUT_ASSERT_DEAR(analyseTopology(repaired->mesh).closedManifold());
  StockSurface surface;
  merged = std::move(repaired->merged);
  merged.resize(repaired->mesh.positions.size(), 1);
  surface.mesh = std::move(repaired->mesh);
  surface.volume_mm3 = measured->volume.mm3;
  surface.volume_error_mm3 = measured->volume.error_mm3 + unseen.error_mm3;
  surface.unseen_mm3 = unseen.mm3;
  surface.facets = measured->facets;
  surface.thin_cells = thin_cells + unseen.thin_cells;
  surface.self_intersections = repaired->self_intersections;
  return surface;
}

/// Simplifies the finished mesh and adds the places where it still intersects itself to `doubts`. Error:
/// cancelled.
Status finishMesh(StockSurface& surface, const std::vector<std::uint8_t>& merged, double tolerance_mm,
                  double cell_mm, std::vector<Box3>& doubts, Progress& progress) {
  if (surface.mesh.triangles.empty()) return Done{};
  progress.report("meshing", 0.9);
  // Merged triangles may be off the corners that there were by as much as a patch is high.
  const auto most = toFloat(kFlatnessShare * kMergingShare * tolerance_mm);
  std::vector<float> off(merged.size());
  std::ranges::transform(merged, off.begin(), [&](std::uint8_t is) { return is != 0 ? most : 0.0f; });
  const std::optional<Simplification> done = simplifyMesh(surface.mesh, tolerance_mm, progress, off);
  if (!done) return Error{ErrorKind::kInterrupted, "interrupted"};
  PROVEOUT_ASSERT_DEAR(analyseTopology(surface.mesh).closedManifold());
  // What is left of a mesh that is not simplified is not known yet.
  const bool simplified = tolerance_mm > 0.0;
  if (simplified && surface.self_intersections + done->self_intersections == 0) return Done{};
  const double moved_mm = done->distance_mm;
  const auto pairs = findIntersectionsAmong(surface.mesh, trianglesInCrowdedPlaces(surface.mesh, moved_mm));
  const std::vector<Box3> places = meetingPlaces(surface.mesh, pairs, kDoubtCells * cell_mm + moved_mm);
  doubts.insert(doubts.end(), places.begin(), places.end());
  surface.self_intersections = pairs.size();
  return Done{};
}

/// Meshes again, looking at all around the places where the mesh intersects itself, until there are none; the
/// last round is not simplified.
Result<StockSurface> finishedSurface(const Stock::Impl& impl, double tolerance, Progress& progress) {
  std::vector<Box3> doubts;
  for (int round = 1;; ++round) {
    std::vector<std::uint8_t> merged;
    Result<StockSurface> surface = meshSurface(impl, kMergingShare * tolerance, doubts, merged, progress);
    if (!surface) return surface;
    const bool last = round == kDoubtRounds;
    if (Status done = finishMesh(*surface, merged, last ? 0.0 : tolerance, impl.h, doubts, progress); !done)
      return done.error();
    if (surface->self_intersections == 0 || last) return surface;
  }
}

double toleranceOf(const Stock::Impl& impl, const SurfaceOptions& options) {
  return options.simplify_mm < 0.0 ? kDefaultTolerance * impl.h : options.simplify_mm;
}

}  // namespace

Result<StockSurface> extractSurface(const Stock::Impl& impl, const SurfaceOptions& options,
                                    Progress& progress) {
  // Each crossing makes two triangles at most, and fewer vertices: far from what 31 bits can number.
  std::size_t crossings = 0;
  for (const StockLeaf& leaf : impl.leaves) crossings += leaf.crossings.size();
  if (crossings > 0x60000000u) {
    return Error{ErrorKind::kResourceLimit,
                 "the surface has more vertices than a mesh can number; take a coarser resolution"};
  }
  Result<StockSurface> surface = finishedSurface(impl, toleranceOf(impl, options), progress);
  if (!surface) return surface;
  progress.report("meshing", 1.0);
  return surface;
}

Result<StockSurface> Stock::surface(const SurfaceOptions& options, Progress& progress) const {
  const ThreadLimit limit(options.threads);
  try {
    return extractSurface(*impl_, options, progress);
  } catch (const std::bad_alloc&) {
    return outOfMemory("not enough memory for the surface", "take a coarser resolution");
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("extracting the surface failed: {}", e.what())};
  }
}

Result<StockVolume> Stock::volume(const SurfaceOptions& options, Progress& progress) const {
  const ThreadLimit limit(options.threads);
  try {
    // Without merging: the volume does not depend on it.
    const Result<SurfaceGrid> grid = placedCells(*impl_, 0.0, progress);
    if (!grid.ok()) return grid.error();
    Result<StockVolume> volume = measureVolume(*grid, progress);
    const bool crossings_alone = impl_->cut == nullptr && impl_->field == nullptr && impl_->uncut == nullptr;
    if (volume.ok() && crossings_alone) volume->edges_mm3 = unknownBesideEdges(*grid);
    return volume;
  } catch (const std::bad_alloc&) {
    return outOfMemory("not enough memory for the volume", "take a coarser resolution");
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("measuring the stock failed: {}", e.what())};
  }
}

Result<StockSurface> Stock::surface(int threads, Progress& progress) const {
  SurfaceOptions options;
  options.threads = threads;
  return surface(options, progress);
}

}  // namespace proveout
