#include "removal/surface/repair/mesh_repair.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/base/stretches.h"
#include "core/geometry/to_float.h"
#include "removal/surface/mesh/merge_judge.h"
#include "removal/surface/mesh/mesh_writer.h"
#include "removal/surface/repair/intersection_repair.h"
#include "removal/surface/repair/open_steps.h"
#include "removal/surface/repair/repair_regions.h"

namespace proveout {

namespace {

/// Rounds of taking merged cells apart where they spoil the mesh, before all merging is given up.
constexpr int kRepairRounds = 24;
/// Rounds of parting cells where triangles intersect, before the mesh itself is changed.
constexpr int kPartRounds = 32;

std::vector<std::uint8_t> mergedVertices(const LeafMesh& mesh, const VertexMerger& merger) {
  std::vector<std::uint8_t> merged(mesh.mesh.positions.size(), 0);
  if (!merger.active()) return merged;
  forEachBelow(mesh.kept, [&](std::size_t v) {
    merged[v] = merger.merged(mesh.cellAt(static_cast<std::uint32_t>(v))) ? 1 : 0;
  });
  return merged;
}

/// The step vertices that are left in a mesh whose vertices were renumbered, moved or removed, with their
/// new numbers.
std::vector<StepVertex> foundAgain(const TriMesh& mesh, const std::vector<StepVertex>& steps) {
  std::map<std::array<float, 3>, std::size_t> by_place;
  for (std::size_t i = 0; i < steps.size(); ++i)
    by_place.try_emplace({steps[i].at.x(), steps[i].at.y(), steps[i].at.z()}, i);
  std::vector<StepVertex> out;
  for (std::uint32_t v = 0; v < mesh.positions.size() && !by_place.empty(); ++v) {
    const Eigen::Vector3f& p = mesh.positions[v];
    const auto found = by_place.find({p.x(), p.y(), p.z()});
    if (found == by_place.end()) continue;
    out.push_back(steps[found->second]);
    out.back().vertex = v;
    by_place.erase(found);
  }
  return out;
}

class MeshRepair {
 public:
  MeshRepair(SurfaceGrid& grid, VertexMerger& merger, const QuadPlanner& planner,
             std::vector<LeafQuads> quads, const std::vector<Box3>& doubts)
      : grid_(grid),
        merger_(merger),
        planner_(planner),
        quads_(std::move(quads)),
        doubts_(doubts),
        changed_(quads_.size(), 1),
        unwatched_(quads_.size(), 1),
        unchecked_(quads_.size(), 1),
        unwritten_(quads_.size(), 1),
        judge_(grid, merger),
        writer_(grid, merger) {}

  std::optional<RepairedMesh> run(Progress& progress);

 private:
  std::vector<std::int32_t> refineAround(const LeafMesh& mesh, const TrianglePairs& pairs);
  std::vector<std::int32_t> wallIn(const LeafMesh& mesh, const TrianglePairs& pairs);
  void markUnchecked(const LeafMesh& mesh, const TrianglePairs& pairs);
  bool anyWalled(const LeafMesh& mesh, const std::array<std::uint32_t, 2>& pair) const;
  TrianglePairs pairsForWalls(LeafMesh& mesh, const TrianglePairs& pairs) const;
  void planAgain(const std::vector<std::int32_t>& taken_apart, Progress& progress);
  std::vector<StepVertex> stepVertices(const LeafMesh& mesh) const;

  SurfaceGrid& grid_;
  VertexMerger& merger_;
  const QuadPlanner& planner_;
  std::vector<LeafQuads> quads_;
  const std::vector<Box3>& doubts_;
  std::vector<std::uint8_t> changed_;    ///< leaves whose quads are not judged yet
  std::vector<std::uint8_t> unwatched_;  ///< leaves whose fans are not checked yet
  std::vector<std::uint8_t> unchecked_;  ///< leaves that are not checked for intersections yet
  std::vector<std::uint8_t> unwritten_;  ///< leaves that changed since the mesh was written
  MergeJudge judge_;
  MeshWriter writer_;
};

/// Makes the mesh around pairs, as far as their repair regions reach, what it is without a tolerance: takes
/// merged cells apart and makes fans where quads bulge. So neither the repair nor the walls there depend on
/// the tolerance. Returns the leaves that this changed.
std::vector<std::int32_t> MeshRepair::refineAround(const LeafMesh& mesh, const TrianglePairs& pairs) {
  if (!merger_.active() || pairs.empty()) return {};
  std::vector<std::uint32_t> merged;
  std::vector<std::int32_t> changed;
  const RepairRegions around(mesh.mesh, grid_.impl().h, pairs);
  for (const RepairRegions::Group& group : around.groups()) {
    for (const std::uint32_t t : group.triangles) {
      for (const std::uint32_t cell : cornerCellsOf(mesh, grid_, t)) {
        if (grid_.markClose(cell)) changed.push_back(static_cast<std::int32_t>(grid_.leafOf(cell)));
      }
      const std::vector<std::uint32_t> cells = mergedCellsOf(mesh, grid_, merger_, t);
      merged.insert(merged.end(), cells.begin(), cells.end());
    }
  }
  const std::vector<std::int32_t> apart = merger_.takeApart(std::move(merged));
  changed.insert(changed.end(), apart.begin(), apart.end());
  return changed;
}

/// Walls in the cells of triangles that intersect. Returns the leaves that this changed: none if all cells
/// were walled before.
std::vector<std::int32_t> MeshRepair::wallIn(const LeafMesh& mesh, const TrianglePairs& pairs) {
  std::vector<std::int32_t> changed;
  for (const auto& pair : pairs) {
    for (const std::uint32_t t : pair) {
      for (const std::uint32_t cell : cornerCellsOf(mesh, grid_, t)) {
        if (grid_.wall(cell)) changed.push_back(static_cast<std::int32_t>(grid_.leafOf(cell)));
      }
    }
  }
  return changed;
}

/// Triangles that intersect and stay as they are must be found again.
void MeshRepair::markUnchecked(const LeafMesh& mesh, const TrianglePairs& pairs) {
  for (const auto& pair : pairs) {
    for (const std::uint32_t t : pair) unchecked_[mesh.leafOf(t)] = 1;
  }
}

bool MeshRepair::anyWalled(const LeafMesh& mesh, const std::array<std::uint32_t, 2>& pair) const {
  for (const std::uint32_t t : pair) {
    for (const std::uint32_t cell : cornerCellsOf(mesh, grid_, t)) {
      if ((grid_.traits(cell) & CellTraits::kWalled) != 0) return true;
    }
  }
  return false;
}

/// The pairs that only walls can part: beside walls all of them; elsewhere those left by
/// repairIntersections, whose changes are kept only if none are left.
TrianglePairs MeshRepair::pairsForWalls(LeafMesh& mesh, const TrianglePairs& pairs) const {
  TrianglePairs out;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(out),
               [&](const auto& pair) { return anyWalled(mesh, pair); });
  if (!out.empty()) return out;
  return repairIntersections(mesh.mesh, pairs, grid_.impl().h, RepairAim::kAll);
}

/// Plans anew the quads of these leaves and of those that read them as neighbours.
void MeshRepair::planAgain(const std::vector<std::int32_t>& taken_apart, Progress& progress) {
  std::fill(changed_.begin(), changed_.end(), 0);
  for (const std::int32_t n : taken_apart) {
    for (int i = 0; i < 7; ++i) {
      const std::int32_t reader = grid_.leaves()[static_cast<std::size_t>(n)].upper[i];
      if (reader >= 0)
        changed_[static_cast<std::size_t>(reader)] = unwritten_[static_cast<std::size_t>(reader)] =
            unwatched_[static_cast<std::size_t>(reader)] = unchecked_[static_cast<std::size_t>(reader)] = 1;
    }
  }
  parallelFor(std::size_t{0}, quads_.size(), [&](std::size_t i) {
    if (!progress.cancelled() && changed_[i] != 0) planner_.plan(grid_.leaves()[i], quads_[i]);
  });
}

/// The step vertices, of cells with a single vertex; as nothing is merged beside steps, it is their own.
std::vector<StepVertex> MeshRepair::stepVertices(const LeafMesh& mesh) const {
  constexpr std::uint16_t kElsewhere = CellTraits::kWalled | CellTraits::kManySheets;
  std::vector<StepVertex> out;
  for (const SurfaceLeaf& leaf : grid_.leaves()) {
    if (leaf.steps.empty()) continue;
    const Vec3 origin = grid_.impl().position(leaf.stock->origin);
    const auto placed = [&](const Eigen::Vector3f& p) {
      return toFloat(origin + grid_.impl().h * p.cast<double>());
    };
    for (const StepCell& step : leaf.steps) {
      const std::uint32_t cell = leaf.base + step.cell;
      if ((grid_.traits(cell) & kElsewhere) != 0) continue;
      PROVEOUT_ASSERT(!merger_.active() || (!merger_.merged(cell) && merger_.standIn(cell) == cell));
      const std::uint32_t v = mesh.numberOf(cell);
      out.push_back({v, mesh.mesh.positions[v], placed(step.low), placed(step.high), step.motion});
    }
  }
  return out;
}

std::optional<RepairedMesh> MeshRepair::run(Progress& progress) {
  for (int fault_rounds = 0, part_rounds = 0;;) {
    if (progress.cancelled()) return std::nullopt;
    std::vector<std::uint32_t> faults = judge_.faults(quads_, changed_, progress);
    LeafMesh* written = nullptr;
    if (faults.empty()) {
      written = writer_.write(quads_, unwritten_, progress);
      if (written == nullptr) return std::nullopt;
      std::fill(unwritten_.begin(), unwritten_.end(), 0);
      faults = findBrokenFans(*written, merger_, unwatched_);
    }
    if (!faults.empty()) {
      const bool again = ++fault_rounds <= kRepairRounds;
      planAgain(again ? merger_.takeApart(std::move(faults)) : merger_.giveUp(), progress);
      continue;
    }
    const TrianglePairs pairs = findSelfIntersections(*written, grid_, unchecked_, doubts_);
    std::fill(unchecked_.begin(), unchecked_.end(), 0);
    const auto partAgain = [&](const std::vector<std::int32_t>& changed) {
      if (changed.empty()) return false;
      ++part_rounds;
      markUnchecked(*written, pairs);
      planAgain(changed, progress);
      return true;
    };
    if (part_rounds < kPartRounds && partAgain(refineAround(*written, pairs))) continue;
    RepairedMesh out;
    std::vector<StepVertex> steps = stepVertices(*written);
    if (const TrianglePairs left = pairs.empty() ? pairs : pairsForWalls(*written, pairs); !left.empty()) {
      if (part_rounds < kPartRounds && partAgain(wallIn(*written, left))) continue;
      out.self_intersections = repairIntersections(written->mesh, pairs, grid_.impl().h).size();
    }
    // The repair may renumber vertices: any of them may be merged then.
    if (pairs.empty()) out.merged = mergedVertices(*written, merger_);
    out.mesh = std::move(written->mesh);
    if (!pairs.empty()) steps = foundAgain(out.mesh, steps);
    openSteps(out.mesh, steps, out.merged);
    PROVEOUT_ASSERT_DEAR(analyseTopology(out.mesh).closedManifold());
    return out;
  }
}

}  // namespace

std::optional<RepairedMesh> repairedMesh(SurfaceGrid& grid, VertexMerger& merger, const QuadPlanner& planner,
                                         std::vector<LeafQuads> quads, const std::vector<Box3>& doubts,
                                         Progress& progress) {
  return MeshRepair(grid, merger, planner, std::move(quads), doubts).run(progress);
}

}  // namespace proveout
