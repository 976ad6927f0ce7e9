// Round faces through points: a first guess from flat facets, and the least-squares fit.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/cad_faces.h"
#include "core/mesh/faces/flat_facets.h"

namespace proveout {

/// How many numbers place and size of a face are.
std::size_t freedomOf(SurfaceKind kind);

/// A first guess of the round face of the kind that the facets stand for and that the points lie on: axes
/// from the facets' normals, then circles through the points. Not hollow. None: they say nothing of such a
/// face.
std::optional<CadFace> guessRound(SurfaceKind kind, const FlatFacets& facets,
                                  std::span<const std::uint32_t> of, std::span<const Vec3> points);

/// Moves the face to where the sum of the squares of the points' distances is least (Gauss, Newton,
/// Levenberg). `turns`: whether its axis may turn. False: it does not settle, or is no such face.
bool fitRound(std::span<const Vec3> points, bool turns, CadFace& face);

/// The circle near points of a plane: least squares of their powers.
struct FlatCircle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
};
std::optional<FlatCircle> circleNear(std::span<const Eigen::Vector2d> points);

}  // namespace proveout
