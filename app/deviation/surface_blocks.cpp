#include "app/deviation/surface_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "app/session/findings/blame.h"
#include "app/session/findings/provenance.h"
#include "core/base/parallel_for.h"
#include "core/mesh/signed_distance.h"

namespace proveout {
namespace {

/// Looks on the surface of clamping `k` for what made the places in `open`; those that it left as they were
/// stay in it. `places`: all of them, in the frame of that clamping.
void findOn(const SetupRun& setup, std::size_t k, double within_mm, const std::vector<Vec3>& places,
            std::vector<std::uint32_t>& open, std::vector<MadeBy>& made) {
  const TriMesh& mesh = setup.surface.mesh;
  if (mesh.triangles.empty() || mesh.motion.empty() || !setup.topology.closedManifold()) {
    open.clear();
    return;
  }
  const SurfaceMesh surface = toSurface(mesh);
  const SignedDistance distance(surface);
  std::vector<char> older(open.size(), 0);
  parallelFor(std::size_t{0}, open.size(), [&](std::size_t i) {
    const SurfaceDistance at = distance.at(places[open[i]]);
    if (std::abs(at.distance) > within_mm) return;
    const MotionId motion = mesh.motion[at.triangle];
    if (motion == kNoMotion) older[i] = 1;
    if (motion != kNoMotion) made[open[i]] = MadeBy{k, motion};
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (older[i] != 0) open[kept++] = open[i];
  }
  open.resize(kept);
}

/// What clampings before the last one left, of the triangles that it did not cut: by their middles, since a
/// corner may be one of several surfaces.
void findEarlier(const SampleMesh& sample, const RunResult& run, std::vector<MadeBy>& made) {
  if (run.setups.size() < 2) return;
  constexpr double kWithin = 2.0;  // of the grid: a stock that is moved is made anew from its surface
  std::vector<std::uint32_t> open;
  std::vector<Vec3> places(made.size(), Vec3::Zero());
  for (std::uint32_t t = 0; t < made.size(); ++t) {
    if (made[t].motion != kNoMotion) continue;
    open.push_back(t);
    places[t] = sample.surface.middle(t);
  }
  for (std::size_t k = run.setups.size() - 1; k-- > 0 && !open.empty();) {
    const RigidTransform back = run.setups[k + 1].from_previous.inverse();
    for (const std::uint32_t t : open) places[t] = back(places[t]);
    findOn(run.setups[k], k, kWithin * run.meshResolution(), places, open, made);
  }
}

/// By triangle of the sample.
std::vector<MadeBy> makersOf(const SampleMesh& sample, const RunResult& run) {
  const std::vector<MotionId>& motion = run.surface().mesh.motion;
  std::vector<MadeBy> made(sample.surface.triangles.size(), MadeBy{run.setups.size() - 1, kNoMotion});
  for (std::size_t t = 0; t < made.size() && !motion.empty(); ++t) made[t].motion = motion[sample.parent[t]];
  findEarlier(sample, run, made);
  return made;
}

constexpr std::uint32_t kNoTriangle = std::numeric_limits<std::uint32_t>::max();

/// By vertex: its largest triangle that a motion made; kNoTriangle: all are of the blank.
std::vector<std::uint32_t> decidingTriangles(const SampleMesh& sample, const std::vector<MadeBy>& made) {
  std::vector<std::uint32_t> deciding(sample.surface.points.size(), kNoTriangle);
  std::vector<float> largest(deciding.size(), -1.0F);
  for (std::uint32_t t = 0; t < made.size(); ++t) {
    if (made[t].motion == kNoMotion) continue;
    const auto area = static_cast<float>(sample.surface.areaVector(t).norm());
    for (const std::uint32_t corner : sample.surface.triangles[t]) {
      if (!(area > largest[corner])) continue;
      largest[corner] = area;
      deciding[corner] = t;
    }
  }
  return deciding;
}

/// Blocks by clamping and motion, each asked for once.
class BlockTable {
 public:
  BlockTable(const RunResult& run, const RunSources& sources, DeviationMesh& mesh)
      : run_(run), sources_(sources), mesh_(mesh) {
    for (const SetupRun& setup : run.setups) mesh_.setups.push_back(setup.name);
    mesh_.blocks.emplace_back();  // the blank's own surface
  }

  std::uint32_t indexOf(const MadeBy& made) {
    const Toolpath& path = run_.setups[made.setup].interpreted.path;
    if (made.motion >= path.motions.size()) return 0;
    const auto [place, is_new] = index_.try_emplace(std::uint64_t{made.setup} << 32 | made.motion, 0u);
    if (!is_new) return place->second;
    const BlockRef block = writtenBlock(path, made.motion, *sources_[made.setup]).block;
    SurfaceBlock out;
    out.setup = static_cast<std::int32_t>(made.setup);
    out.tool = path.motions[made.motion].tool;
    out.file = fileIndex(block.file);
    out.line = static_cast<std::int32_t>(block.line);
    out.block = block.block;
    place->second = static_cast<std::uint32_t>(mesh_.blocks.size());
    mesh_.blocks.push_back(out);
    return place->second;
  }

 private:
  std::int32_t fileIndex(const std::string& name) {
    const auto [place, is_new] = files_.try_emplace(name, static_cast<std::int32_t>(mesh_.files.size()));
    if (is_new) mesh_.files.push_back(name);
    return place->second;
  }

  const RunResult& run_;
  const RunSources& sources_;
  DeviationMesh& mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;
  std::map<std::string, std::int32_t> files_;
};

}  // namespace

void addBlocks(const SampleMesh& sample, const RunResult& run, const RunSources& sources,
               DeviationMesh& mesh) {
  const std::vector<MadeBy> made = makersOf(sample, run);
  BlockTable table(run, sources, mesh);
  mesh.made_by.reserve(sample.surface.points.size());
  for (const std::uint32_t t : decidingTriangles(sample, made))
    mesh.made_by.push_back(t == kNoTriangle ? 0 : table.indexOf(made[t]));
}

}  // namespace proveout
