#include "removal/surface/measure/leaf_volume.h"

#include <atomic>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "removal/surface/measure/exact_quad.h"
#include "removal/surface/measure/quad_volume.h"

namespace proveout {

namespace {

/// A quad whose face bends unevenly: the number of its crossing, and what its corners show.
struct BentQuad {
  std::uint16_t crossing = 0;
  double volume = 0.0, error = 0.0;
};

/// Of the cones from the blank's middle to the quads of a leaf, grid steps^3; see QuadVolume. The farthest
/// facet is off by so many grid steps, at a place in leaf units.
struct LeafVolume {
  double volume = 0.0, error = 0.0;
  double off = 0.0;
  Vec3 farthest = Vec3::Zero();
  std::vector<BentQuad> bent;  ///< quads that are worth another look, see kBent

  void see(double off_here, const Vec3& where) {
    if (off_here <= off) return;
    off = off_here;
    farthest = where;
  }
};

/// Part of the prisms between a ridge that crossings do not show and their surface by which the volume may be
/// off.
constexpr double kOfHidden = 0.2;

/// Quads whose face bends so unevenly that it may cost so much of a cell are measured on their bodies, unless
/// they are more than this: each takes some ten microseconds.
constexpr double kBent = 2e-4;
constexpr std::size_t kMostBent = 30'000;

/// The same, bit for bit, as the sum over the quads one by one.
double levelVolume(const Stock::Impl& impl, const SurfaceLeaf& leaf) {
  const int axis = leaf.level.axis;
  const double height = leaf.level.layer + static_cast<double>(leaf.level.crossing.t);
  const double from = height - (impl.blank.center()[axis] - impl.position(leaf.stock->origin)[axis]) / impl.h;
  double volume = 0.0;
  for (int i = 0; i < 64; ++i) volume += (leaf.level.material_below ? 2.0 : -2.0) * from / 6.0;
  return volume;
}

class LeafMeter {
 public:
  /// `planner`: null where only the volume is wanted.
  LeafMeter(const SurfaceGrid& grid, const QuadPlanner* planner) : grid_(grid), planner_(planner) {}

  /// False at a hole.
  bool measure(const SurfaceLeaf& leaf, LeafVolume& volume, LeafQuads& quads) const {
    const auto corners = levelCorners(grid_, leaf);
    if (corners) {
      volume.volume = levelVolume(grid_.impl(), leaf);
      if (planner_ == nullptr || planner_->planLevel(leaf, *corners, quads)) return true;
    }
    volume.error += kOfHidden * leaf.hidden;
    return readQuads(leaf, corners ? nullptr : &volume, quads);
  }

  /// Measures the quads of a leaf whose faces bend unevenly on their bodies.
  void measureBent(const SurfaceLeaf& leaf, LeafVolume& volume) const {
    const Stock::Impl& impl = grid_.impl();
    const Vec3 center = (impl.blank.center() - impl.position(leaf.stock->origin)) / impl.h;
    QuadReader reader(grid_);
    reader.load(leaf);
    reader.loadFeatureEdges();
    ExactQuad exact(impl, leaf.stock->origin);
    Quad quad;
    auto next = volume.bent.begin();
    forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
      if (next == volume.bent.end() || &c != &leaf.stock->crossings[next->crossing]) return;
      const BentQuad& shown = *next++;
      if (knownMotion(c.motion) == kNoMotion || !reader.read(axis, x, y, z, c, quad)) return;
      const std::optional<QuadVolume> found =
          exact.volume(quad, c, center, reader.featureEdgesOf(quad, axis, x, y, z));
      if (!found) return;
      volume.volume += found->volume - shown.volume;
      volume.error += found->error - shown.error;
    });
  }

 private:
  bool readQuads(const SurfaceLeaf& leaf, LeafVolume* volume, LeafQuads& quads) const {
    const Stock::Impl& impl = grid_.impl();
    const Vec3 center = (impl.blank.center() - impl.position(leaf.stock->origin)) / impl.h;
    QuadReader reader(grid_);
    reader.load(leaf);
    if (volume != nullptr) reader.loadFeatureEdges();
    Quad quad;
    bool whole = true;
    if (planner_ != nullptr) quads.states.reserve(leaf.edges.count);
    const Crossing* const first = leaf.stock->crossings.data();
    forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
      if (!reader.read(axis, x, y, z, c, quad)) {
        whole = false;
        return;
      }
      if (volume != nullptr) {
        const QuadVolume cone = quadVolume(quad.p, quad.middle, quad.normal, center, quad.smooth_corners,
                                           reader.featureEdgesOf(quad, axis, x, y, z));
        volume->volume += cone.volume;
        volume->error += cone.error;
        volume->see(cone.off, quad.middle);
        if (cone.bent > kBent && (quad.traits & CellTraits::kManySheets) == 0)
          volume->bent.push_back({static_cast<std::uint16_t>(&c - first), cone.volume, cone.bent});
      }
      if (planner_ != nullptr) planner_->add(leaf, quad, c, {axis, x, y, z}, quads);
    });
    PROVEOUT_ASSERT(planner_ == nullptr || !whole || quads.states.size() == leaf.edges.count);
    return whole;
  }

  const SurfaceGrid& grid_;
  const QuadPlanner* planner_;
};

/// The farthest facet of all leaves.
FacetError farthestOf(const SurfaceGrid& grid, const std::vector<LeafVolume>& leaves) {
  const Stock::Impl& impl = grid.impl();
  FacetError out;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const SurfaceLeaf& leaf = grid.leaves()[i];
    const Vec3 origin = impl.position(leaf.stock->origin);
    const auto see = [&](double off, const Vec3& at) { out.see({off * impl.h, origin + impl.h * at}); };
    see(leaves[i].off, leaves[i].farthest);
    const int place = leaf.farthest.place;
    see(leaf.farthest.off, Vec3(place >> 3 & 7, place & 7, place >> 6) + Vec3::Constant(0.5));
  }
  return out;
}

/// The order of the sum is that of the leaves, whatever the threads do.
StockVolume sumOf(const std::vector<LeafVolume>& leaves, double h) {
  StockVolume sum;
  for (const LeafVolume& leaf : leaves) {
    sum.mm3 += leaf.volume;
    sum.error_mm3 += leaf.error;
  }
  const double cell = h * h * h;
  return {sum.mm3 * cell, sum.error_mm3 * cell};
}

Result<MeasuredLeaves> measure(const SurfaceGrid& grid, const QuadPlanner* planner, Progress& progress) {
  const auto& leaves = grid.leaves();
  const LeafMeter meter(grid, planner);
  MeasuredLeaves out;
  out.quads.resize(planner != nullptr ? leaves.size() : 0);
  std::vector<LeafVolume> volumes(leaves.size());
  std::atomic<bool> hole = false;
  LeafQuads none;
  parallelFor(std::size_t{0}, leaves.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    if (!meter.measure(leaves[i], volumes[i], planner != nullptr ? out.quads[i] : none))
      hole.store(true, std::memory_order_relaxed);
  });
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  if (hole) return gridHole();
  std::size_t bent = 0;
  for (const LeafVolume& volume : volumes) bent += volume.bent.size();
  if (bent <= kMostBent && grid.impl().cut != nullptr) {
    parallelFor(std::size_t{0}, leaves.size(), [&](std::size_t i) {
      if (!volumes[i].bent.empty() && !progress.cancelled()) meter.measureBent(leaves[i], volumes[i]);
    });
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  }
  out.volume = sumOf(volumes, grid.impl().h);
  out.facets = farthestOf(grid, volumes);
  return out;
}

}  // namespace

Error gridHole() { return {ErrorKind::kInternal, "the stock's grid has a hole; please report this job"}; }

Result<StockVolume> measureVolume(const SurfaceGrid& grid, Progress& progress) {
  const Result<MeasuredLeaves> out = measure(grid, nullptr, progress);
  if (!out.ok()) return out.error();
  return out->volume;
}

Result<MeasuredLeaves> measureLeaves(const SurfaceGrid& grid, const QuadPlanner& planner,
                                     Progress& progress) {
  return measure(grid, &planner, progress);
}

}  // namespace proveout
