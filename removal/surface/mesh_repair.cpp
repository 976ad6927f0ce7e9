#include "removal/surface/mesh_repair.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "removal/surface/mesh_writer.h"
#include "removal/surface/surface_mend.h"

namespace proveout {

namespace {

/// Rounds of taking merged cells apart where they spoil the mesh, before all merging is given up.
constexpr int kRepairRounds = 12;
/// Rounds of taking merged cells apart where triangles meet, before the mesh itself is changed.
constexpr int kPartRounds = 16;

class MeshRepair {
 public:
  MeshRepair(const SurfaceGrid& grid, VertexMerger& merger, const QuadPlanner& planner,
             std::vector<LeafQuads> quads)
      : grid_(grid),
        merger_(merger),
        planner_(planner),
        quads_(std::move(quads)),
        changed_(quads_.size(), 1),
        unchecked_(quads_.size(), 1),
        writer_(grid, merger) {}

  std::optional<RepairedMesh> run(Progress& progress);

 private:
  std::vector<std::int32_t> partMeetings(const LeafMesh& mesh, const TrianglePairs& pairs);
  void planAgain(const std::vector<std::int32_t>& taken_apart, Progress& progress);

  const SurfaceGrid& grid_;
  VertexMerger& merger_;
  const QuadPlanner& planner_;
  std::vector<LeafQuads> quads_;
  std::vector<std::uint8_t> changed_;    ///< leaves whose triangles are to be made anew
  std::vector<std::uint8_t> unchecked_;  ///< leaves not yet looked at for intersections
  MeshWriter writer_;
};

/// Takes merged cells apart whose triangles meet others; returns the leaves that this changed, none if no
/// cell is merged.
std::vector<std::int32_t> MeshRepair::partMeetings(const LeafMesh& mesh, const TrianglePairs& pairs) {
  std::vector<std::uint32_t> merged;
  for (const auto& pair : pairs) {
    for (const std::uint32_t t : pair) {
      const std::vector<std::uint32_t> cells = mergedCellsOf(mesh, grid_, merger_, t);
      merged.insert(merged.end(), cells.begin(), cells.end());
    }
  }
  if (merged.empty()) return {};
  // Triangles that meet and stay as they are must be found again.
  const auto after = [](std::uint32_t t, const LeafPart& part) { return t < part.first_triangle; };
  for (const auto& pair : pairs) {
    for (const std::uint32_t t : pair) {
      const auto next = std::upper_bound(mesh.parts.begin(), mesh.parts.end(), t, after);
      unchecked_[static_cast<std::size_t>(next - mesh.parts.begin()) - 1] = 1;
    }
  }
  return merger_.takeApart(std::move(merged));
}

/// Plans the leaves anew that these and the surface between them and their neighbours belong to.
void MeshRepair::planAgain(const std::vector<std::int32_t>& taken_apart, Progress& progress) {
  std::fill(changed_.begin(), changed_.end(), 0);
  for (const std::int32_t n : taken_apart) {
    for (int i = 0; i < 7; ++i) {
      const std::int32_t reader = grid_.leaves()[static_cast<std::size_t>(n)].upper[i];
      if (reader >= 0)
        changed_[static_cast<std::size_t>(reader)] = unchecked_[static_cast<std::size_t>(reader)] = 1;
    }
  }
  parallelFor(std::size_t{0}, quads_.size(), [&](std::size_t i) {
    if (!progress.cancelled() && changed_[i] != 0) planner_.plan(grid_.leaves()[i], quads_[i]);
  });
}

std::optional<RepairedMesh> MeshRepair::run(Progress& progress) {
  for (int fault_rounds = 0, part_rounds = 0;;) {
    if (progress.cancelled()) return std::nullopt;
    LeafMesh* const written = writer_.write(quads_, changed_, progress);
    if (written == nullptr) return std::nullopt;
    std::vector<std::uint32_t> faults = findFaults(*written, merger_, changed_);
    if (!faults.empty()) {
      const bool again = ++fault_rounds <= kRepairRounds;
      planAgain(again ? merger_.takeApart(std::move(faults)) : merger_.giveUp(), progress);
      continue;
    }
    const TrianglePairs pairs = findMeetings(*written, grid_, unchecked_);
    std::fill(unchecked_.begin(), unchecked_.end(), 0);
    if (!pairs.empty() && ++part_rounds <= kPartRounds) {
      if (const auto taken_apart = partMeetings(*written, pairs); !taken_apart.empty()) {
        planAgain(taken_apart, progress);
        continue;
      }
    }
    RepairedMesh out{std::move(written->mesh), 0};
    if (!pairs.empty()) out.self_intersections = mendIntersections(out.mesh, pairs, grid_.impl().h);
    PROVEOUT_ASSERT_DEAR(analyseTopology(out.mesh).closedManifold());
    return out;
  }
}

}  // namespace

std::optional<RepairedMesh> repairedMesh(const SurfaceGrid& grid, VertexMerger& merger,
                                         const QuadPlanner& planner, std::vector<LeafQuads> quads,
                                         Progress& progress) {
  return MeshRepair(grid, merger, planner, std::move(quads)).run(progress);
}

}  // namespace proveout
