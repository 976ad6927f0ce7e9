#include "removal/compare/local_tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel_for.h"

namespace proveout {
namespace {

/// The tolerances that hold on each face; regions are asked point by point.
class FaceGroups {
 public:
  explicit FaceGroups(const CompareOptions& options) : o_(options) {
    if (o_.nominal_faces == nullptr) return;
    for (const CadFace& face : o_.nominal_faces->faces) {
      std::vector<bool>& own = fits_.emplace_back();
      for (const LocalTolerance& local : o_.local)
        own.push_back((!local.kind || face.kind == *local.kind) &&
                      (local.face.empty() || isNamed(face, local.face)));
    }
  }

  std::uint32_t faceOf(std::uint32_t triangle) const {
    return o_.nominal_faces == nullptr ? kNoFace : o_.nominal_faces->of_triangle[triangle];
  }

  /// Of several faces that meet at an edge the one that the deviation is across.
  std::uint32_t across(const std::vector<std::uint32_t>& faces, const Vec3& p, const Vec3& direction) const {
    std::uint32_t best = faces.empty() ? kNoFace : faces.front();
    double most = -1.0;
    for (const std::uint32_t f : faces) {
      const CadFace& face = o_.nominal_faces->faces[f];
      if (face.kind == SurfaceKind::kOther) continue;
      const double along = std::abs(face.normalAt(p).dot(direction));
      if (along <= most + kTie) continue;
      most = along;
      best = f;
    }
    return best;
  }

  std::uint16_t at(std::uint32_t face, const Vec3& p) const {
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
  static constexpr double kTie = 1e-6;
  const CompareOptions& o_;
  std::vector<std::vector<bool>> fits_;  ///< by face and tolerance
};

void addOnce(std::vector<std::uint32_t>& list, std::uint32_t face) {
  if (face != kNoFace && std::find(list.begin(), list.end(), face) == list.end()) list.push_back(face);
}

/// The faces at each sample of the nominal: several on edges.
std::vector<std::vector<std::uint32_t>> facesAt(const SampleMesh& goal, const FaceGroups& of) {
  std::vector<std::vector<std::uint32_t>> out(goal.surface.points.size());
  for (std::size_t t = 0; t < goal.surface.triangles.size(); ++t)
    for (const std::uint32_t corner : goal.surface.triangles[t])
      addOnce(out[corner], of.faceOf(goal.parent[t]));
  return out;
}

/// The faces at the corners of each of the nominal's triangles: where a point is nearest to an edge of one,
/// the face on its other side is among them.
std::vector<std::vector<std::uint32_t>> facesBeside(const SampleMesh& goal, std::size_t triangles,
                                                    const std::vector<std::vector<std::uint32_t>>& at,
                                                    const FaceGroups& of) {
  std::vector<std::vector<std::uint32_t>> out(triangles);
  for (std::uint32_t t = 0; t < triangles; ++t) addOnce(out[t], of.faceOf(t));
  for (std::size_t t = 0; t < goal.surface.triangles.size(); ++t)
    for (const std::uint32_t corner : goal.surface.triangles[t])
      for (const std::uint32_t face : at[corner]) addOnce(out[goal.parent[t]], face);
  return out;
}

void leaveOut(const std::vector<std::uint16_t>& groups, std::uint16_t group, SampledSide& side) {
  for (std::size_t i = 0; i < side.deviation.size(); ++i)
    if (groups[i] != group) side.deviation[i] = std::numeric_limits<float>::quiet_NaN();
}

}  // namespace

ToleranceGroups groupSamples(const BothSides& sides, const CompareOptions& options) {
  const FaceGroups of(options);
  const SampleMesh& goal = *sides.nominal.mesh;
  ToleranceGroups out;
  out.nominal.resize(goal.surface.points.size());
  const std::vector<std::vector<std::uint32_t>> at = facesAt(goal, of);
  parallelFor(std::size_t{0}, out.nominal.size(), [&](std::size_t i) {
    const Vec3& p = goal.surface.points[i];
    out.nominal[i] = of.at(of.across(at[i], p, sides.nominal.gradient[i].cast<double>()), p);
  });
  std::uint32_t triangles = 0;
  for (const std::uint32_t parent : goal.parent) triangles = std::max(triangles, parent + 1);
  const std::vector<std::vector<std::uint32_t>> beside = facesBeside(goal, triangles, at, of);
  const std::vector<Vec3>& machined = sides.machined.mesh->surface.points;
  out.machined.resize(machined.size());
  parallelFor(std::size_t{0}, out.machined.size(), [&](std::size_t i) {
    const Vec3& p = machined[i];
    const std::uint32_t nearest = sides.machined.opposite[i];
    // Off an edge the direction to it is none of a face's; off a face it is that of its normal.
    const std::uint32_t face = of.across(beside[nearest], p, sides.machined.gradient[i].cast<double>());
    out.machined[i] = of.at(face, p);
  });
  return out;
}

BothSides onlyGroup(const BothSides& sides, const ToleranceGroups& groups, std::uint16_t group) {
  BothSides out = sides;
  leaveOut(groups.machined, group, out.machined);
  leaveOut(groups.nominal, group, out.nominal);
  return out;
}

}  // namespace proveout
