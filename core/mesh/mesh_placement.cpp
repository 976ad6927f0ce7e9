#include "core/mesh/mesh_placement.h"

#include <cmath>

#include "core/geometry/to_float.h"

namespace proveout {

Vec3 xyzDegOf(const Eigen::Matrix3d& r) {
  constexpr double kUpright = 1e-12;
  const double sine = -r(2, 0), cosine = std::hypot(r(2, 1), r(2, 2));
  Vec3 out(0.0, std::atan2(sine, cosine), 0.0);
  if (cosine > kUpright) {
    out.x() = std::atan2(r(2, 1), r(2, 2));
    out.z() = std::atan2(r(1, 0), r(0, 0));
  } else {  // X and Z turn about one line: the turn is all about Z
    out.z() = std::atan2(-r(0, 1), r(1, 1));
  }
  for (double& angle : out) {
    angle = radToDeg(angle);
    const double quarter = 90.0 * std::round(angle / 90.0);
    if (std::abs(angle - quarter) < 1e-9) angle = quarter + 0.0;  // no -0
  }
  return out;
}

MeshPlacement chained(const MeshPlacement& first, const MeshPlacement& second) {
  if (first.none()) return second;
  const RigidTransform turn = second.motion();
  return {first.scale * second.scale, xyzDegOf(turn.rotation * rotationXyzDeg(first.rotate_deg)),
          turn(second.scale * first.move)};
}

void placeMesh(const MeshPlacement& placement, TriMesh& mesh) {
  if (placement.none()) return;
  const RigidTransform motion = placement.motion();
  for (auto& p : mesh.positions) p = toFloat(motion(placement.scale * p.cast<double>()));
}

namespace {

Eigen::Vector3f movedPoint(const RigidTransform& motion, const Eigen::Vector3f& p) {
  return toFloat(motion(p.cast<double>()));
}

}  // namespace

void moveMesh(const RigidTransform& motion, TriMesh& mesh) {
  for (auto& p : mesh.positions) p = movedPoint(motion, p);
}

Box3 boundsMoved(const RigidTransform& motion, const TriMesh& mesh) {
  Box3 bounds;
  for (const auto& p : mesh.positions) {
    if (const Eigen::Vector3f at = movedPoint(motion, p); at.allFinite()) bounds.extend(at.cast<double>());
  }
  return bounds;
}

}  // namespace proveout
