// Questions to the exact part that its characteristics are made of.
#pragma once

#include <optional>

#include "removal/compare/part/part_measure.h"

namespace proveout {

/// A point of the surface with its outward normal.
struct SurfacePoint {
  Vec3 p = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  SurfaceMaker maker;
};

/// The nearest point of the surface within `reach`.
std::optional<SurfacePoint> surfaceNear(const ExactPart& part, const Vec3& p, double reach);

/// Where the way from `outside` (in the air) to `inside` (in the material) meets the surface, as share of it,
/// 0..1; none where the ends lie otherwise.
std::optional<double> crossingBetween(const ExactPart& part, const Vec3& outside, const Vec3& inside);

/// An edge of the mesh with the triangles to its sides.
struct MeshEdge {
  Vec3 middle = Vec3::Zero();
  Vec3 along = Vec3::UnitX();   ///< unit
  Vec3 normal = Vec3::UnitZ();  ///< mean of both sides, unit
  double turn_rad = 0.0;        ///< by which the normals differ; > 0 convex, < 0 concave
  std::uint32_t left_motion = kNoMotion, right_motion = kNoMotion;
};
/// Edges that turn by more than `least_rad`, with their middle in the region; in the order of their vertices.
std::vector<MeshEdge> turningEdges(const TriMesh& mesh, double least_rad, const PartRule& rule);

bool isIn(const PartRule& rule, const Vec3& p);

// One each of the characteristics; `out` has the rule's quantity.
void measureThickness(const MeasuredPart& part, const PartRule& rule, Progress& progress, PartFeature& out);
void measureInnerRadius(const MeasuredPart& part, const PartRule& rule, Progress& progress, PartFeature& out);
void measureSkin(const MeasuredPart& part, const PartRule& rule, PartFeature& out);
/// kScallop and kRoughness.
void measureCrests(const MeasuredPart& part, const PartRule& rule, Progress& progress, PartFeature& out);

}  // namespace proveout
