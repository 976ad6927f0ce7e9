// Where a model lies: scaled, turned and moved.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// A change of place and size: scaled about the origin, turned about the fixed X axis, then Y, then Z, and
/// moved.
struct MeshPlacement {
  double scale = 1.0;              ///< > 0
  Vec3 rotate_deg = Vec3::Zero();  ///< about X, Y and Z, right-hand rule, degrees
  Vec3 move = Vec3::Zero();        ///< mm, along the axes of the frame that the model is put into

  bool none() const { return scale == 1.0 && rotate_deg.isZero(0.0) && move.isZero(0.0); }
  RigidTransform motion() const { return {rotationXyzDeg(rotate_deg), move}; }
  Vec3 operator()(const Vec3& p) const { return motion()(scale * p); }
};

/// `first`, then `second`. Angles are exact where both turn by multiples of 90 degrees.
MeshPlacement chained(const MeshPlacement& first, const MeshPlacement& second);

/// The angles about the fixed X, Y and Z axes that rotationXyzDeg makes the rotation of, each within
/// -180..180.
Vec3 xyzDegOf(const Eigen::Matrix3d& rotation);

/// Puts every point of the mesh where the placement says; coordinates are rounded to single precision.
void placeMesh(const MeshPlacement& placement, TriMesh& mesh);

/// Turns and moves every point of the mesh; coordinates are rounded to single precision.
void moveMesh(const RigidTransform& motion, TriMesh& mesh);
/// Bounds that the mesh would have behind moveMesh().
Box3 boundsMoved(const RigidTransform& motion, const TriMesh& mesh);

}  // namespace proveout
