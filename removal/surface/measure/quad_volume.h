// The volume under the smooth surface piece around a crossing.
#pragma once

#include <array>

#include "core/geometry/types.h"

namespace proveout {

struct QuadVolume {
  double volume = 0.0;  ///< signed, of the cone from the apex to the piece of surface
  double error = 0.0;   ///< about how much it may be off; at least 0
  /// How far triangles between the corners may be off the piece, at most: both lie between the lowest and the
  /// highest of corners and crossing over the tangent plane, as a face bends to one side along each way from
  /// the crossing.
  double off = 0.0;
  double bent = 0.0;  ///< part of the error that a face which bends evenly does not have
};

/// The sagitta of a feature edge, from the middle of its chord: that of the cubic with the directions of the
/// edge (unit, either way) at both ends. 0 where these are not the ends of one edge.
Vec3 featureEdgeSagitta(const Vec3& chord, const Vec3& from, const Vec3& to);

inline const std::array<Vec3, 4> kNoFeatureEdges = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

/// The cone from `apex` to the piece of surface around a crossing: the four triangles from the crossing to
/// the corners (CCW from outside, all on the surface), and what the surface bulges out of them, up to its
/// own normals along the chords between smooth corners (as far as the corners show how these bend): so quads
/// that share a chord share their border. The curvature follows from the corners' heights over the tangent
/// plane at the crossing; it is quadratic, with the next term of spheres and cylinders where it turns much:
/// what is left of those goes with the sixth power of the quad's size, of others with the fourth. Flat:
/// exact. The error is what lies between the corners and that plane, by the square of the slope to them:
/// whole where the surface breaks between the crossing and a corner. `normal` is the surface's at the
/// crossing, unit to 1e-4. Any unit of length. `smooth_corners`: bits of the corners that lie on one smooth
/// face; the others may lie on feature edges. Where a feature edge joins opposite corners, the one beyond it
/// says nothing of how the crossing's face bends: the piece is two triangles then, with the bulge of the one
/// on this side. `feature_edges`: directions of the feature edges that the corners are on, unit, either way;
/// 0 where that is not known. Between two such corners the piece ends at the feature edge and not at its
/// chord.
QuadVolume quadVolume(const std::array<Vec3, 4>& corners, const Vec3& crossing, const Vec3& normal,
                      const Vec3& apex, unsigned smooth_corners = 0xF,
                      const std::array<Vec3, 4>& feature_edges = kNoFeatureEdges);

}  // namespace proveout
