#include "removal/compare/local_tolerance.h"

#include <limits>

#include "core/base/parallel_for.h"

namespace proveout {
namespace {

/// Which of the nominal's triangles each tolerance holds on; regions are asked point by point.
class TriangleGroups {
 public:
  explicit TriangleGroups(const CompareOptions& options) : o_(options) {
    if (o_.nominal_faces == nullptr) return;
    for (const CadFace& face : o_.nominal_faces->faces) {
      std::vector<bool>& own = fits_.emplace_back();
      for (const LocalTolerance& local : o_.local)
        own.push_back((!local.kind || face.kind == *local.kind) &&
                      (local.face.empty() || isNamed(face, local.face)));
    }
  }

  std::uint16_t at(std::uint32_t triangle, const Vec3& p) const {
    const std::uint32_t face =
        o_.nominal_faces == nullptr ? kNoFace : o_.nominal_faces->of_triangle[triangle];
    for (std::size_t k = o_.local.size(); k-- > 0;) {
      const LocalTolerance& local = o_.local[k];
      const bool by_face = local.kind || !local.face.empty();
      if (by_face && (face == kNoFace || !fits_[face][k])) continue;
      if (local.region && !local.region->contains(p)) continue;
      return static_cast<std::uint16_t>(k + 1);
    }
    return 0;
  }

 private:
  const CompareOptions& o_;
  std::vector<std::vector<bool>> fits_;  ///< by face and tolerance
};

void leaveOut(const std::vector<std::uint16_t>& groups, std::uint16_t group, SampledSide& side) {
  for (std::size_t i = 0; i < side.deviation.size(); ++i)
    if (groups[i] != group) side.deviation[i] = std::numeric_limits<float>::quiet_NaN();
}

}  // namespace

ToleranceGroups groupSamples(const BothSides& sides, const CompareOptions& options) {
  const TriangleGroups of(options);
  ToleranceGroups out;
  out.machined.resize(sides.machined.deviation.size());
  const std::vector<Vec3>& machined = sides.machined.mesh->surface.points;
  parallelFor(std::size_t{0}, out.machined.size(),
              [&](std::size_t i) { out.machined[i] = of.at(sides.machined.opposite[i], machined[i]); });
  // A sample of the nominal is on several triangles: the first one's face has it, so that an edge is of one.
  const SampleMesh& goal = *sides.nominal.mesh;
  out.nominal.resize(goal.surface.points.size());
  std::vector<bool> known(out.nominal.size(), false);
  for (std::size_t t = 0; t < goal.surface.triangles.size(); ++t) {
    for (const std::uint32_t corner : goal.surface.triangles[t]) {
      if (known[corner]) continue;
      known[corner] = true;
      out.nominal[corner] = of.at(goal.parent[t], goal.surface.points[corner]);
    }
  }
  return out;
}

BothSides onlyGroup(const BothSides& sides, const ToleranceGroups& groups, std::uint16_t group) {
  BothSides out = sides;
  leaveOut(groups.machined, group, out.machined);
  leaveOut(groups.nominal, group, out.nominal);
  return out;
}

}  // namespace proveout
